// Parts of files as they are kept from one visit to the next, in the origin's private file system: a folder for each address, in it a file for each part whose
// name says which. A file that the server changed (another ETag) and those that were not used for longest make room.

/** Most bytes that are kept, of all files together. */
export const MOST_KEPT = 512 * 2 ** 20;
/** Bytes that wait to be written before whoever fetches more waits as well. */
const MOST_WAITING = 16 * 2 ** 20;
/** How long the file system may take for one part, milliseconds, and how often it may take longer: in Chromium 156 one of a few thousand writes never ends. */
const PATIENCE = 3000;
const MOST_LATE = 3;
const FOLDER = "voxtrace";

export interface Cache {
  get(start: number, end: number): Promise<Uint8Array | undefined>;
  /** Writes a part behind those that were given before; resolves when there is room for more, which is at once most of the time. */
  put(start: number, end: number, bytes: Uint8Array): Promise<void>;
  /** Waits until all is written. */
  flush(): Promise<void>;
}

interface Kept {
  name: string;
  bytes: number;
  used: number;
}

async function digest(text: string): Promise<string> {
  const bytes = new Uint8Array(await crypto.subtle.digest("SHA-256", new TextEncoder().encode(text)));
  return Array.from(bytes.slice(0, 12), (byte) => byte.toString(16).padStart(2, "0")).join("");
}

/** Bytes of a part by the name of its file, `START-END`. */
function lengthOf(name: string): number {
  const [start, end] = name.split("-").map(Number);
  return Number.isFinite(end! - start!) ? end! - start! : 0;
}

async function measure(root: FileSystemDirectoryHandle): Promise<Kept[]> {
  const found: Kept[] = [];
  for await (const [name, handle] of (root as unknown as { entries(): AsyncIterable<[string, FileSystemHandle]> }).entries()) {
    if (handle.kind !== "directory") continue;
    const kept = { name, bytes: 0, used: 0 };
    for await (const file of (handle as unknown as { keys(): AsyncIterable<string> }).keys()) {
      if (file.startsWith("used-")) kept.used = Math.max(kept.used, Number(file.slice(5)));
      else kept.bytes += lengthOf(file);
    }
    found.push(kept);
  }
  return found;
}

/** What is kept of the file at an address with an ETag; `undefined` where the browser lets nothing be kept. `isAnew` forgets it first. */
export function openCache(url: URL, etag: string, isAnew: boolean, most = MOST_KEPT): Promise<Cache | undefined> {
  // Private windows, pages without a secure address, a full disk: then nothing is kept.
  return inTime(openFolder(url, etag, isAnew, most)).catch(() => undefined);
}

async function openFolder(url: URL, etag: string, isAnew: boolean, most: number): Promise<Cache> {
  const root = await (await navigator.storage.getDirectory()).getDirectoryHandle(FOLDER, { create: true });
  const [address, name] = [await digest(url.href), await digest(etag)];
  const own = `${address}-${name}`;
  const all = (await measure(root)).sort((a, b) => a.used - b.used);
  let total = all.reduce((sum, kept) => sum + kept.bytes, 0);
  for (const kept of all) {
    const isOld = kept.name.startsWith(address) && (isAnew || kept.name !== own);
    if (!isOld && (kept.name === own || total <= most / 2)) continue;
    // Half of the room is for the file that is opened.
    await root.removeEntry(kept.name, { recursive: true });
    total -= kept.bytes;
  }
  const folder = await root.getDirectoryHandle(own, { create: true });
  for await (const file of (folder as unknown as { keys(): AsyncIterable<string> }).keys()) {
    if (file.startsWith("used-")) await folder.removeEntry(file);
  }
  await folder.getFileHandle(`used-${Date.now()}`, { create: true });
  return new Folder(folder, most - total);
}

/** The file system does not answer. */
class Late extends Error {}

/** What it gives, if it comes in time. */
function inTime<T>(work: Promise<T>): Promise<T> {
  let timer: ReturnType<typeof setTimeout>;
  const late = new Promise<never>((_, failed) => (timer = setTimeout(() => failed(new Late()), PATIENCE)));
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

class Folder implements Cache {
  #written: Promise<void> = Promise.resolve();
  #waiting = 0;
  #late = 0;

  constructor(private readonly folder: FileSystemDirectoryHandle, private room: number) {}

  async get(start: number, end: number): Promise<Uint8Array | undefined> {
    const read = async () => {
      const file = await (await this.folder.getFileHandle(`${start}-${end}`)).getFile();
      // A page that was closed while it wrote leaves a part of one.
      return file.size === end - start ? new Uint8Array(await file.arrayBuffer()) : undefined;
    };
    return inTime(read()).catch(() => undefined);
  }

  async put(start: number, end: number, bytes: Uint8Array): Promise<void> {
    if (this.room < bytes.length) return;
    this.room -= bytes.length;
    this.#waiting += bytes.length;
    this.#written = this.#written.then(async () => {
      const write = () => this.#write(`${start}-${end}`, bytes);
      // Where another viewer writes it, or there is no room after all, the next one may fare better.
      if (this.#late < MOST_LATE) await inTime(write()).catch((error) => error instanceof Late && this.#late++);
      this.#waiting -= bytes.length;
    });
    if (this.#waiting > MOST_WAITING) await this.#written;
  }

  flush(): Promise<void> {
    return this.#written;
  }

  async #write(name: string, bytes: Uint8Array) {
    const handle = await this.folder.getFileHandle(name, { create: true });
    const access = await (handle as unknown as { createSyncAccessHandle(): Promise<SyncAccess> }).createSyncAccessHandle();
    try {
      access.write(bytes, { at: 0 });
      access.truncate(bytes.length);
    } finally {
      access.close();
    }
  }
}

interface SyncAccess {
  write(bytes: Uint8Array, options: { at: number }): number;
  truncate(length: number): void;
  close(): void;
}
