// Parts of files as they are kept from one visit to the next, in the origin's private file system: a folder for each address, in it a file for each part whose
// name says which. A file that the server changed (another ETag) and those that were not used for longest make room.

/** Most bytes that are kept, of all files together. */
export const MOST_KEPT = 512 * 2 ** 20;
const FOLDER = "voxtrace";

export interface Cache {
  get(start: number, end: number): Promise<Uint8Array | undefined>;
  put(start: number, end: number, bytes: Uint8Array): Promise<void>;
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
export async function openCache(url: URL, etag: string, isAnew: boolean, most = MOST_KEPT): Promise<Cache | undefined> {
  try {
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
  } catch {
    // Private windows, pages without a secure address, a full disk: then nothing is kept.
    return undefined;
  }
}

class Folder implements Cache {
  constructor(private readonly folder: FileSystemDirectoryHandle, private room: number) {}

  async get(start: number, end: number): Promise<Uint8Array | undefined> {
    try {
      const file = await (await this.folder.getFileHandle(`${start}-${end}`)).getFile();
      // A page that was closed while it wrote leaves a part of one.
      return file.size === end - start ? new Uint8Array(await file.arrayBuffer()) : undefined;
    } catch {
      return undefined;
    }
  }

  async put(start: number, end: number, bytes: Uint8Array): Promise<void> {
    if (this.room < bytes.length) return;
    try {
      const handle = await this.folder.getFileHandle(`${start}-${end}`, { create: true });
      const access = await (handle as unknown as { createSyncAccessHandle(): Promise<SyncAccess> }).createSyncAccessHandle();
      try {
        access.write(bytes, { at: 0 });
        access.truncate(bytes.length);
      } finally {
        access.close();
      }
      this.room -= bytes.length;
    } catch {
      // Another viewer writes it, or there is no room.
      this.room = Math.min(this.room, 2 ** 20);
    }
  }
}

interface SyncAccess {
  write(bytes: Uint8Array, options: { at: number }): number;
  truncate(length: number): void;
  close(): void;
}
