// A file whose parts are asked for: from a server by range requests, from one that knows none as far as it has arrived, or of this machine.
import { joined } from "./bytes.js";
import type { Cache } from "./cache.js";

/** Bytes of the first request: the head of a file for streaming, and most of what its first picture needs. */
export const FIRST = 65_536;
/** What a request that fails for once is tried again after, milliseconds. */
const AGAIN = 400;

/** The file is another one than before. */
export class Changed extends Error {}

export interface Parts {
  /** Its first bytes: as many as `FIRST`, fewer where it is shorter. */
  readonly head: Uint8Array;
  read(start: number, end: number, signal: AbortSignal): Promise<Uint8Array>;
  /** What is kept of it from one visit to the next. */
  readonly cache: Cache | undefined;
  /** All of it, and what share of it is there. */
  all(signal: AbortSignal, onShare: (share: number | undefined) => void): Promise<Uint8Array>;
}

/** A file of this machine. */
export class LocalParts implements Parts {
  readonly cache = undefined;
  private constructor(private readonly blob: Blob, readonly head: Uint8Array) {}

  static async of(blob: Blob): Promise<LocalParts> {
    return new LocalParts(blob, new Uint8Array(await blob.slice(0, FIRST).arrayBuffer()));
  }

  async read(start: number, end: number): Promise<Uint8Array> {
    const bytes = new Uint8Array(await this.blob.slice(start, end).arrayBuffer());
    if (bytes.length !== end - start) throw new Error(`the file is cut off (at byte ${this.blob.size})`);
    return bytes;
  }

  all(): Promise<Uint8Array> {
    return this.read(0, this.blob.size);
  }
}

/** A file on a server. */
export async function partsOf(url: URL, cache: (etag: string) => Promise<Cache | undefined>, signal: AbortSignal): Promise<Parts> {
  const response = await ask(url, { range: `bytes=0-${FIRST - 1}` }, signal);
  if (response.status === 200) return ArrivingParts.of(response, signal);
  // What is empty has no first byte.
  if (response.status !== 206) throw new Error(response.status === 416 ? "the file is empty" : answered(response));
  const etag = validatorOf(response);
  const head = await bodyOf(response, signal);
  return new RemoteParts(url, head, etag, totalOf(response), etag ? await cache(etag) : undefined);
}

const answered = (response: Response) => `the server answers ${response.status} ${response.statusText}`.trim();
const validatorOf = ({ headers }: Response) => headers.get("etag") ?? headers.get("last-modified") ?? undefined;

/** How long the whole file is, where the server lets the page know it. */
function totalOf(response: Response): number | undefined {
  const total = Number(/\/(\d+)$/.exec(response.headers.get("content-range") ?? "")?.[1]);
  return Number.isFinite(total) ? total : undefined;
}

async function ask(url: URL, headers: Record<string, string>, signal: AbortSignal): Promise<Response> {
  for (let attempt = 0; ; attempt++) {
    try {
      return await fetch(url, { headers, signal, cache: "no-store" });
    } catch (error) {
      if (signal.aborted) throw error;
      if (attempt > 0) {
        const hint = url.origin !== location.origin ? "; a server elsewhere must allow this page by Access-Control-Allow-Origin" : "";
        throw new Error(`the server cannot be reached${hint}`);
      }
      await new Promise((done) => setTimeout(done, AGAIN));
    }
  }
}

/** Of an answer that may end before it should. */
function unbroken<T>(read: Promise<T>, signal: AbortSignal): Promise<T> {
  return read.catch((error) => {
    throw signal.aborted ? error : new Error("the connection to the server broke off");
  });
}

async function bodyOf(response: Response, signal: AbortSignal): Promise<Uint8Array> {
  return new Uint8Array(await unbroken(response.arrayBuffer(), signal));
}

class RemoteParts implements Parts {

  constructor(
    private readonly url: URL,
    readonly head: Uint8Array,
    private readonly etag: string | undefined,
    private readonly total: number | undefined,
    readonly cache: Cache | undefined,
  ) {}

  async read(start: number, end: number, signal: AbortSignal): Promise<Uint8Array> {
    if (end <= this.head.length) return this.head.slice(start, end);
    const response = await ask(this.url, { range: `bytes=${start}-${end - 1}` }, signal);
    const etag = validatorOf(response);
    if (this.etag && etag && etag !== this.etag) throw new Changed("the file on the server changed while it was read");
    if (response.status === 416) throw new Error(`the file is cut off before byte ${start}`);
    if (response.status !== 206) throw new Error(response.status === 200 ? "the server stopped answering with parts of the file" : answered(response));
    const bytes = await bodyOf(response, signal);
    if (bytes.length !== end - start) throw new Error(`the server sent ${bytes.length} of ${end - start} bytes (at byte ${start})`);
    return bytes;
  }

  async all(signal: AbortSignal, onShare: (share: number | undefined) => void): Promise<Uint8Array> {
    if (this.head.length < FIRST || this.total === this.head.length) return this.head;
    const response = await ask(this.url, { range: `bytes=${FIRST}-` }, signal);
    const etag = validatorOf(response);
    if (this.etag && etag && etag !== this.etag) throw new Changed("the file on the server changed while it was read");
    if (response.status === 416) return this.head;
    if (response.status !== 206) throw new Error(answered(response));
    const chunks = [this.head];
    let length = this.head.length;
    for (const reader = response.body!.getReader(); ; ) {
      const { done, value } = await unbroken(reader.read(), signal);
      if (done) break;
      chunks.push(value);
      length += value.length;
      onShare(this.total && Math.min(1, length / this.total));
    }
    return joined(chunks, length);
  }
}

/** A file of a server that sends it whole: its parts are there as far as it has arrived. */
class ArrivingParts implements Parts {
  #chunks: Uint8Array[] = [];
  #length = 0;
  #isDone = false;
  #error: unknown;
  #waiting: (() => void)[] = [];
  head: Uint8Array = new Uint8Array();
  readonly cache = undefined;

  static async of(response: Response, signal: AbortSignal): Promise<ArrivingParts> {
    const parts = new ArrivingParts(response);
    void parts.#pump(response, signal);
    await parts.#until(FIRST);
    parts.head = parts.#slice(0, Math.min(FIRST, parts.#length));
    return parts;
  }

  private constructor(private readonly response: Response) {}

  async #pump(response: Response, signal: AbortSignal) {
    try {
      for (const reader = response.body!.getReader(); ; ) {
        const { done, value } = await unbroken(reader.read(), signal);
        if (done) break;
        this.#chunks.push(value);
        this.#length += value.length;
        this.#tell();
      }
    } catch (error) {
      this.#error = error;
    }
    this.#isDone = true;
    this.#tell();
  }

  #tell() {
    for (const told of this.#waiting.splice(0)) told();
  }

  async #until(end: number) {
    while (this.#length < end && !this.#isDone) await new Promise<void>((done) => this.#waiting.push(done));
    if (this.#error && this.#length < end) throw this.#error;
  }

  #slice(start: number, end: number): Uint8Array {
    // One piece from now on: what is read next is not far.
    if (this.#chunks.length > 64) this.#chunks = [joined(this.#chunks, this.#length)];
    const found: Uint8Array[] = [];
    let at = 0;
    for (const chunk of this.#chunks) {
      const [from, to] = [Math.max(start - at, 0), Math.min(end - at, chunk.length)];
      if (from < to) found.push(chunk.subarray(from, to));
      at += chunk.length;
    }
    return joined(found, end - start);
  }

  async read(start: number, end: number): Promise<Uint8Array> {
    await this.#until(end);
    if (this.#length < end) throw new Error(`the file is cut off (at byte ${this.#length})`);
    return this.#slice(start, end);
  }

  async all(_signal: AbortSignal, onShare: (share: number | undefined) => void): Promise<Uint8Array> {
    const isPlain = !this.response.headers.get("content-encoding");
    const total = isPlain ? Number(this.response.headers.get("content-length")) : 0;
    while (!this.#isDone) {
      await this.#until(this.#length + 1);
      onShare(total > 0 ? Math.min(1, this.#length / total) : undefined);
    }
    if (this.#error) throw this.#error;
    return this.#slice(0, this.#length);
  }
}
