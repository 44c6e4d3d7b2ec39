// The page's end of a file for streaming: what its worker is told, and what becomes of what it sends.
import type { Look } from "./detail.js";
import type { Pool } from "./pool.js";

/** How fine what is shown is: levels of detail, 0 the finest. */
export interface Detail {
  finest: number;
  coarsest: number;
  /** Whether it is the scene itself, so that its films are exact. */
  isExact: boolean;
}

export type ToStreamer =
  | { kind: "open"; module: WebAssembly.Module; name: string; url?: string; blob?: Blob; memory: number; threads: number }
  | { kind: "look"; look: Look; id: number }
  | { kind: "pause"; isPaused: boolean }
  | { kind: "taken" };

export type FromStreamer =
  | { kind: "plain"; bytes: Uint8Array }
  | { kind: "scene"; bytes: Uint8Array; voxels: number; hash: string; detail: Detail }
  | { kind: "progress"; share: number | undefined }
  /** Nothing finer is on its way for the look of this number. */
  | { kind: "settled"; id: number }
  | { kind: "error"; message: string };

export interface Given {
  name: string;
  url?: string;
  blob?: Blob;
  /** Bytes that scenes may take, all workers together, and how many workers trace. */
  memory: number;
  threads: number;
}

export interface Events {
  /** It is no file for streaming: all its bytes. */
  plain(bytes: Uint8Array): Promise<void>;
  /** A scene to show in the place of the last one. */
  scene(scene: Extract<FromStreamer, { kind: "scene" }>): Promise<void>;
  progress(share: number | undefined): void;
  settled(): void;
  failed(error: unknown): void;
}

export class Streaming {
  #worker: Worker | undefined;
  #isEnded = false;
  #isPaused = false;
  #look: Look | undefined;
  #id = 0;

  /** `pool` has the module and the script. */
  constructor(pool: Pool, given: Given, events: Events) {
    void this.#start(pool, given, events).catch((error) => this.#isEnded || events.failed(error));
  }

  async #start(pool: Pool, given: Given, events: Events) {
    // Both at once; the worker is there to be ended before the module is, which may not come.
    const module = pool.module("stream");
    const worker = await pool.worker("stream");
    if (this.#isEnded) return worker.terminate();
    this.#worker = worker;
    worker.onerror = (event) => events.failed(new Error(event.message || "the script of the worker cannot be loaded"));
    worker.onmessage = async ({ data }: MessageEvent<FromStreamer>) => {
      try {
        if (data.kind === "plain") {
          this.end();
          await events.plain(data.bytes);
        } else if (data.kind === "scene") {
          await events.scene(data);
          this.#send({ kind: "taken" });
          if (data.detail.isExact) events.settled();
        } else if (data.kind === "progress") events.progress(data.share);
        else if (data.kind === "settled") data.id === this.#id && events.settled();
        else events.failed(new Error(data.message));
      } catch (error) {
        events.failed(error);
      }
    };
    this.#send({ kind: "open", module: await module, ...given });
    if (this.#look) this.look(this.#look);
    if (this.#isPaused) this.pause(true);
  }

  #send(message: ToStreamer) {
    this.#worker?.postMessage(message);
  }

  /** Tells where the camera looks. */
  look(look: Look) {
    this.#look = look;
    this.#send({ kind: "look", look, id: ++this.#id });
  }

  /** Lets go of what is on its way, until it goes on. */
  pause(isPaused: boolean) {
    this.#isPaused = isPaused;
    this.#send({ kind: "pause", isPaused });
  }

  end() {
    this.#isEnded = true;
    this.#worker?.terminate();
    this.#worker = undefined;
  }
}
