// A worker as the page sees it: its calls as promises.
import type { Answer, Calls, Name } from "./protocol.js";

type Made<N extends Name> = ReturnType<Calls[N]>;
type Waiting = { done: (made: never) => void; failed: (error: Error) => void };

/** An error of the library: its message is for people. */
export class TracerError extends Error {
  constructor(
    message: string,
    /** Whether the worker that said so is of no use any more. */
    readonly isFatal: boolean,
  ) {
    super(message);
    this.name = "TracerError";
  }
}

/** What becomes of calls to a worker that was ended. */
export class ClosedError extends TracerError {
  constructor() {
    super("the viewer was closed", true);
  }
}

/** Whoever answers calls as a worker does. */
export interface Caller {
  /** Pixels times samples in a millisecond, as measured so far. */
  rate: number;
  /** Calls it; `transfer` goes over to it instead of being copied. */
  call<N extends Name>(name: N, given: Parameters<Calls[N]>, transfer?: Transferable[]): Promise<Made<N>>;
}

export class Tracer implements Caller {
  readonly #worker: Worker;
  readonly #waiting = new Map<number, Waiting>();
  #last = 0;
  /** Why it answers no more. */
  #over: TracerError | undefined;
  rate = 60;

  constructor(worker: Worker) {
    this.#worker = worker;
    worker.onmessage = ({ data }: MessageEvent<Answer>) => {
      const waiting = this.#waiting.get(data.id);
      this.#waiting.delete(data.id);
      if ("error" in data) waiting?.failed(new TracerError(data.error, data.isFatal));
      else waiting?.done(data.made as never);
    };
    worker.onerror = (event) => this.end(new TracerError(event.message || "the script of the worker cannot be loaded", true));
  }

  call<N extends Name>(name: N, given: Parameters<Calls[N]>, transfer: Transferable[] = []): Promise<Made<N>> {
    if (this.#over) return Promise.reject(this.#over);
    const id = ++this.#last;
    return new Promise<Made<N>>((done, failed) => {
      this.#waiting.set(id, { done: done as Waiting["done"], failed });
      this.#worker.postMessage({ id, name, given }, transfer);
    });
  }

  /** Ends the worker, whatever it does, and frees its memory; calls that wait for it, and all to come, fail with `error`. */
  end(error: TracerError = new ClosedError()) {
    this.#worker.terminate();
    this.#over ??= error;
    for (const waiting of this.#waiting.values()) waiting.failed(error);
    this.#waiting.clear();
  }
}

/** Names scripts of workers where a page requires Trusted Types. */
interface Policy {
  createScriptURL(url: string): string;
}
let policy: Policy | undefined;

/** A worker with the script at `url`, also where a page may not start those of other origins by their address. */
export function startWorker({ href, origin, protocol }: URL): Worker {
  const isNear = origin === location.origin || protocol === "blob:";
  const script = isNear ? href : URL.createObjectURL(new Blob([`import ${JSON.stringify(href)};`], { type: "text/javascript" }));
  const plain: Policy = { createScriptURL: (url) => url };
  policy ??= (globalThis as { trustedTypes?: { createPolicy(name: string, rules: Policy): Policy } }).trustedTypes?.createPolicy("voxtrace", plain) ?? plain;
  const worker = new Worker(policy.createScriptURL(script), { type: "module" });
  if (!isNear) setTimeout(() => URL.revokeObjectURL(script), 60_000);
  return worker;
}
