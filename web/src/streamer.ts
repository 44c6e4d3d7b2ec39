// The worker that follows a file for streaming: a picture of its first bytes, then the parts that the view needs, and where all of it fits, the scene itself.
import { checksum, initSync, Stream } from "../wasm/stream.js";
import { openCache } from "./cache.js";
import { Chunks, type Chunk, type Cut, cutOf, type Look } from "./detail.js";
import { isStreamed, type Layout, layoutOf, type Place } from "./layout.js";
import { Changed, FIRST, LocalParts, type Parts, partsOf } from "./ranges.js";
import type { Detail, FromStreamer, ToStreamer } from "./streaming.js";

/** Most bytes until the first picture: the finest level that these hold is the first one that is shown. */
const START = 224 * 1024;
/** Bytes that are asked for at a time, requests at once, and what lies between two parts that are asked for together. */
const BATCH = 1 << 20;
const REQUESTS = 6;
const GAP = 8 * 1024;
/** How much more there has to be before the picture is made anew, and how long the last one is shown, milliseconds. */
const GROWTH = 0.8;
const SHOWN = 700;
/** How often requests are held against where one looks, milliseconds. */
const COMPARED = 150;
/** How much more than is shown is kept of what was seen before. */
const KEPT = 1.5;

const send = (message: FromStreamer, transfer: Transferable[] = []) => postMessage(message, { transfer });

async function inflated(bytes: Uint8Array, what: string): Promise<Uint8Array> {
  try {
    const stream = new Blob([bytes as Uint8Array<ArrayBuffer>]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  } catch {
    throw new Damaged(`${what} is damaged: what is compressed cannot be inflated`);
  }
}

const nameOf = ({ level, number }: Chunk) => `chunk ${number} of level ${level}`;

/** The bytes are not those that were written. */
class Damaged extends Error {}

function checked<T>(work: () => T): T {
  try {
    return work();
  } catch (error) {
    throw new Damaged(error instanceof Error ? error.message : String(error));
  }
}

/** Parts of the file that are fetched in one request. */
interface Batch {
  chunks: Chunk[];
  abort: AbortController;
}

class Streamer {
  #stream: Stream | undefined;
  #chunks!: Chunks;
  #layout!: Layout;
  #parts!: Parts;
  /** The coarsest level that is shown; all of it stays. */
  #top = 0;
  /** What is there, and when each was shown last. */
  readonly #there = new Map<Chunk, number>();
  /** Compressed chunks of level 0, of a scene that is to be had whole. */
  readonly #whole = new Map<number, Uint8Array>();
  readonly #added = new Set<number>();
  #isFinishing = false;
  #shown = { key: "", bytes: 0, at: 0 };
  #look: Look | undefined;
  /** The number of the last look, and when requests were last held against one. */
  #id = 0;
  #compared = 0;
  #share = 0;
  #batches: Batch[] = [];
  #isPaused = false;
  #wake: (() => void) | undefined;
  #hasNews = false;
  #taken: (() => void) | undefined;
  readonly #life = new AbortController();

  constructor(private readonly from: Extract<ToStreamer, { kind: "open" }>) {}

  /** Follows the file; once more from its start where another one took its place, or what was kept of it is damaged. */
  async run() {
    for (let isFirst = true; ; isFirst = false) {
      try {
        return await ((await this.#open(!isFirst)) ? this.#follow() : this.#plain());
      } catch (error) {
        const isLost = error instanceof Changed || (error instanceof Damaged && !!this.from.url);
        if (!isFirst || !isLost) throw error;
        this.#reset();
      }
    }
  }

  look(look: Look, id: number) {
    this.#look = look;
    this.#id = id;
    this.#share = 0;
    // What no view needs any more is not waited for.
    if (this.#batches.length > 0 && !this.#isFinishing && performance.now() - this.#compared > COMPARED) {
      this.#compared = performance.now();
      const wanted = new Set(this.#missing(this.#cut()));
      for (const { chunks, abort } of this.#batches) if (chunks.length > 0 && !chunks.some((chunk) => wanted.has(chunk))) abort.abort();
    }
    this.#tell();
  }

  pause(isPaused: boolean) {
    this.#isPaused = isPaused;
    if (isPaused) for (const { abort } of this.#batches) abort.abort();
    this.#tell();
  }

  taken() {
    this.#taken?.();
  }

  /** Levels whose fronts came meanwhile do not set it back. */
  #progress(share: number) {
    this.#share = Math.max(this.#share, share);
    send({ kind: "progress", share: this.#share });
  }

  #tell() {
    this.#hasNews = true;
    this.#wake?.();
  }

  async #news() {
    if (!this.#hasNews) await new Promise<void>((done) => (this.#wake = done));
    this.#hasNews = false;
  }

  #reset() {
    this.#stream?.free();
    this.#stream = undefined;
    this.#there.clear();
    this.#whole.clear();
    this.#added.clear();
    this.#isFinishing = false;
    this.#shown = { key: "", bytes: 0, at: 0 };
  }

  /** Up to the first picture; false where the file is none for streaming. `isAnew` lets nothing of before count. */
  async #open(isAnew: boolean): Promise<boolean> {
    const { url, blob } = this.from;
    const { signal } = this.#life;
    this.#parts = blob ? await LocalParts.of(blob) : await partsOf(new URL(url!), (etag) => openCache(new URL(url!), etag, isAnew), signal);
    if (!isStreamed(this.#parts.head)) return false;
    this.#layout = layoutOf(this.#parts.head, checksum);
    const { levels, head } = this.#layout;
    const start = levels.findIndex(({ chunks }) => chunks.end <= START);
    this.#top = start < 0 ? levels.length - 1 : start;
    const end = levels[this.#top]!.chunks.end;
    // One request for all that is missing.
    if (end > FIRST) this.#parts = new Beginning(this.#parts, await this.#read(FIRST, end, signal));
    const bytes = await this.#section(head);
    this.#stream = checked(() => new Stream(bytes));
    this.#chunks = new Chunks(this.#stream.instances());
    await this.#addFront(this.#top);
    for (const chunk of this.#chunks.of(this.#top)) await this.#add(chunk, await this.#parts.read(chunk.start, chunk.end, signal));
    return true;
  }

  /** Bytes that are kept or fetched, and then kept. */
  async #read(start: number, end: number, signal: AbortSignal): Promise<Uint8Array> {
    const { cache } = this.#parts;
    const kept = await cache?.get(start, end);
    if (kept) return kept;
    const bytes = await this.#parts.read(start, end, signal);
    await cache?.put(start, end, bytes);
    return bytes;
  }

  /** As `#read`, but given up where nobody looks, and begun again when somebody does. */
  async #readWhileSeen(start: number, end: number): Promise<Uint8Array> {
    for (;;) {
      while (this.#isPaused) await this.#news();
      const abort = new AbortController();
      this.#batches = [{ chunks: [], abort }];
      try {
        return await this.#read(start, end, abort.signal);
      } catch (error) {
        if (!abort.signal.aborted) throw error;
      } finally {
        this.#batches = [];
      }
    }
  }

  /** A section, checked and inflated. Once there is a picture it is fetched while somebody looks. */
  async #section({ start, end, checksum: sum }: Place): Promise<Uint8Array> {
    const fetch = () => (this.#shown.key === "" ? this.#read(start, end, this.#life.signal) : this.#readWhileSeen(start, end));
    const bytes = end <= this.#parts.head.length ? this.#parts.head.slice(start, end) : await fetch();
    if (checksum(bytes) !== sum) throw new Damaged(`truncated or damaged: the section at byte ${start} has a wrong checksum`);
    return inflated(bytes, `the section at byte ${start}`);
  }

  async #addFront(level: number) {
    const { front, chunks } = this.#layout.levels[level]!;
    const bytes = await this.#section(front);
    this.#chunks.add(level, checked(() => this.#stream!.add_front(level, bytes)), chunks.start);
  }

  async #add(chunk: Chunk, bytes: Uint8Array) {
    const whole = await inflated(bytes, nameOf(chunk));
    checked(() => this.#stream!.add_chunk(chunk.level, chunk.number, whole));
    this.#there.set(chunk, performance.now());
    if (chunk.level === 0 && this.#fits) this.#whole.set(chunk.number, bytes);
  }

  /** Whether all of the scene fits, once here and once for each worker that traces. */
  get #fits(): boolean {
    return this.#stream!.bytes * 3 <= this.from.memory;
  }

  /** Bytes of what is shown. */
  get #most(): number {
    return this.from.memory / (this.from.threads + 3);
  }

  /** Refines what is shown until nothing is missing, again and again. */
  async #follow() {
    if (this.#top === 0 && this.#fits) return this.#finish();
    await this.#show({ leaves: this.#chunks.of(this.#top), refined: [], fronts: [] });
    for (;;) {
      if (this.#isPaused || !this.#look) {
        await this.#news();
        continue;
      }
      const [id, wanted] = [this.#id, this.#cut()];
      const [level] = wanted.fronts;
      if (level !== undefined) {
        await this.#addFront(level);
        continue;
      }
      const missing = this.#missing(wanted);
      if (missing.length === 0) {
        await this.#show(wanted);
        if (this.#fits) return this.#finish();
        send({ kind: "settled", id });
        await this.#news();
        continue;
      }
      await this.#fetch(missing, (chunk, bytes) => this.#add(chunk, bytes));
      const stored = (chunks: Chunk[]) => chunks.reduce((sum, chunk) => sum + chunk.end - chunk.start, 0);
      const done = 1 - stored(this.#missing(wanted)) / stored(wanted.refined.flatMap((chunk) => this.#chunks.childrenOf(chunk)));
      this.#progress(this.#fits ? done / 2 : done);
      const there = this.#cut((chunk) => this.#there.has(chunk));
      const bytes = there.leaves.reduce((sum, chunk) => sum + chunk.size, 0);
      if (bytes > this.#shown.bytes * (1 + GROWTH) && performance.now() - this.#shown.at > SHOWN) await this.#show(there);
      this.#forget(wanted);
    }
  }

  #cut(isThere?: (chunk: Chunk) => boolean): Cut {
    return cutOf(this.#chunks, this.#top, this.#look!, this.#most, isThere);
  }

  #missing(cut: Cut): Chunk[] {
    return cut.refined.flatMap((chunk) => this.#chunks.childrenOf(chunk)).filter((chunk) => !this.#there.has(chunk));
  }

  /** Hands the scene of a cut to the page, and waits until it has it. */
  async #show({ leaves }: Cut) {
    const key = leaves.map(({ level, number }) => `${level}.${number}`).sort().join();
    const now = performance.now();
    for (const chunk of leaves) this.#there.set(chunk, now);
    if (key === this.#shown.key) return;
    const bytes = checked(() => this.#stream!.scene(new Uint32Array(leaves.flatMap(({ level, number }) => [level, number]))));
    const levels = leaves.map(({ level }) => level);
    await this.#hand(bytes, { finest: Math.min(...levels), coarsest: Math.max(...levels), isExact: false });
    this.#shown = { key, bytes: leaves.reduce((sum, chunk) => sum + chunk.size, 0), at: performance.now() };
  }

  async #hand(bytes: Uint8Array, detail: Detail) {
    const { voxels, hash } = this.#stream!;
    const taken = new Promise<void>((done) => (this.#taken = done));
    send({ kind: "scene", bytes, voxels, hash, detail }, [bytes.buffer as ArrayBuffer]);
    await taken;
  }

  /** Lets go of what was not shown for longest, where there is more than is to be kept; never of what finer parts stand in the place of. */
  #forget(wanted: Cut) {
    let bytes = [...this.#there.keys()].reduce((sum, chunk) => sum + chunk.size, 0);
    const most = this.#most * KEPT;
    if (bytes <= most) return;
    const needed = new Set([...wanted.leaves, ...wanted.refined, ...this.#chunks.of(this.#top)]);
    const hasChildren = (chunk: Chunk) => this.#chunks.childrenOf(chunk).some((child) => this.#there.has(child));
    const old = [...this.#there].filter(([chunk]) => !needed.has(chunk)).sort((a, b) => a[0].level - b[0].level || a[1] - b[1]);
    for (const [chunk] of old) {
      if (bytes <= most) return;
      if (hasChildren(chunk)) continue;
      this.#stream!.remove_chunk(chunk.level, chunk.number);
      this.#there.delete(chunk);
      bytes -= chunk.size;
    }
  }

  /** Fetches the first of these chunks, some requests at once, and gives each to `take`. */
  async #fetch(chunks: Chunk[], take: (chunk: Chunk, bytes: Uint8Array) => Promise<void>) {
    let bytes = 0;
    const first = chunks.filter((chunk) => bytes < BATCH && (bytes += chunk.end - chunk.start) > 0);
    const { cache } = this.#parts;
    const next: Chunk[] = [];
    for (const chunk of first) {
      const kept = await cache?.get(chunk.start, chunk.end);
      if (kept) await take(chunk, kept);
      else next.push(chunk);
    }
    next.sort((a, b) => a.start - b.start);
    if (this.#isPaused) return;
    const groups: Chunk[][] = [];
    for (const chunk of next) {
      const last = groups.at(-1);
      const [first, before] = [last?.[0], last?.at(-1)];
      if (first && chunk.start - before!.end <= GAP && chunk.end - first.start <= BATCH / REQUESTS) last!.push(chunk);
      else groups.push([chunk]);
    }
    const waiting = groups.map((chunks) => ({ chunks, abort: new AbortController() }));
    this.#batches = [...waiting];
    const one = async () => {
      for (let batch = waiting.shift(); batch; batch = waiting.shift()) await this.#get(batch, take);
    };
    try {
      await Promise.all(Array.from({ length: REQUESTS }, one));
    } finally {
      // Where one failed the others are of no use.
      for (const { abort } of this.#batches) abort.abort();
      this.#batches = [];
    }
  }

  async #get({ chunks, abort }: Batch, take: (chunk: Chunk, bytes: Uint8Array) => Promise<void>) {
    if (abort.signal.aborted) return;
    const start = chunks[0]!.start;
    let bytes: Uint8Array;
    try {
      bytes = await this.#parts.read(start, chunks.at(-1)!.end, abort.signal);
    } catch (error) {
      if (abort.signal.aborted) return;
      throw error;
    }
    for (const chunk of chunks) {
      const own = bytes.slice(chunk.start - start, chunk.end - start);
      await take(chunk, own);
      await this.#parts.cache?.put(chunk.start, chunk.end, own);
    }
  }

  /** All of level 0: the scene itself. */
  async #finish() {
    this.#isFinishing = true;
    const { levels, tail } = this.#layout;
    const stream = this.#stream!;
    if (!this.#chunks.has(0)) await this.#addFront(0);
    const front = await this.#section(levels[0]!.front);
    const rest = tail && (await this.#section(tail));
    checked(() => stream.begin_whole(front, rest));
    const take = async (chunk: Chunk, bytes: Uint8Array) => {
      const whole = await inflated(bytes, nameOf(chunk));
      checked(() => stream.add_whole(chunk.number, whole));
      this.#added.add(chunk.number);
    };
    const chunks = this.#chunks.of(0);
    for (const chunk of chunks) {
      const bytes = this.#whole.get(chunk.number);
      if (bytes) await take(chunk, bytes);
    }
    this.#whole.clear();
    const look = this.#look;
    const errors = new Map(chunks.map((chunk) => [chunk, look ? this.#chunks.error(chunk, look) : 0]));
    const left = chunks.filter(({ number }) => !this.#added.has(number)).sort((a, b) => errors.get(b)! - errors.get(a)!);
    while (left.length > 0) {
      if (this.#isPaused) {
        await this.#news();
        continue;
      }
      await this.#fetch(left, take);
      left.splice(0, left.length, ...left.filter(({ number }) => !this.#added.has(number)));
      this.#progress((1 + this.#added.size / chunks.length) / 2);
    }
    // Two scenes may be more than there is memory.
    for (const chunk of this.#there.keys()) stream.remove_chunk(chunk.level, chunk.number);
    await this.#hand(checked(() => stream.finish_whole()), { finest: 0, coarsest: 0, isExact: true });
    // The memory of all this goes with the worker.
    await this.#parts.cache?.flush();
    close();
  }

  /** All bytes of a file that is none for streaming. */
  async #plain() {
    const bytes = await this.#parts.all(this.#life.signal, (share) => send({ kind: "progress", share }));
    send({ kind: "plain", bytes }, [bytes.buffer as ArrayBuffer]);
  }
}

/** A file of which more than its head is there. */
class Beginning implements Parts {
  readonly head: Uint8Array;
  readonly cache: Parts["cache"];
  constructor(private readonly parts: Parts, more: Uint8Array) {
    this.cache = parts.cache;
    this.head = new Uint8Array(parts.head.length + more.length);
    this.head.set(parts.head);
    this.head.set(more, parts.head.length);
  }

  async read(start: number, end: number, signal: AbortSignal) {
    return end <= this.head.length ? this.head.slice(start, end) : this.parts.read(start, end, signal);
  }

  all(signal: AbortSignal, onShare: (share: number | undefined) => void) {
    return this.parts.all(signal, onShare);
  }
}

let streamer: Streamer | undefined;

addEventListener("message", ({ data }: MessageEvent<ToStreamer>) => {
  if (data.kind === "look") return streamer?.look(data.look, data.id);
  if (data.kind === "pause") return streamer?.pause(data.isPaused);
  if (data.kind === "taken") return streamer?.taken();
  initSync({ module: data.module });
  const opened = (streamer = new Streamer(data));
  void (async () => {
    try {
      await opened.run();
    } catch (error) {
      send({ kind: "error", message: `${data.name}: ${error instanceof Error ? error.message : String(error)}` });
    }
  })();
});
