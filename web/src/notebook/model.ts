// The widget's model as anywidget gives it, and calls to the kernel over its messages: each has a number, and its answer the same.

/** What Python and the page share; its names are those of `python/voxtrace/notebook/_widget.py`. */
export interface Traits {
  renderer: "auto" | "browser" | "kernel";
  height: number;
  samples: number;
  seed: number;
  max_bounces: number;
  exposure: number;
  tone_map: string;
  clip: [number[], number[]] | null;
  threshold: number | null;
  preset: string;
  picked: Record<string, unknown> | null;
  /** Eye, target, up and the vertical field of view in degrees; nothing before the first view. */
  _camera: number[];
  /** Goes up with each other scene. */
  _version: number;
  _about: About;
  _poster: DataView;
  /** What traces here, and how many samples its picture has. */
  tracer: string;
  problem: string;
  samples_shown: number;
}

/** What is known of the scene before it is here. */
export interface About {
  name: string;
  bounds: [number[], number[]] | null;
  bytes: number;
  /** Of volumes: names of presets, and how often values occur between `low` and `high`. */
  values?: { presets: string[]; low: number; high: number; threshold: number; counts: number[] };
}

export interface Model {
  get<N extends keyof Traits>(name: N): Traits[N];
  set<N extends keyof Traits>(name: N, value: Traits[N]): void;
  save_changes(): void;
  on(name: string, heard: (...given: never[]) => void): void;
  off(name: string, heard: (...given: never[]) => void): void;
  send(content: unknown): void;
}

interface Answer {
  id: string;
  error?: string;
}

/** Bytes that a scene is sent in at a time: the kernel is free between them, and progress is seen. */
const CHUNK = 1 << 22;

export class Kernel {
  readonly #waiting = new Map<string, { done: (answer: { content: never; bytes: Uint8Array<ArrayBuffer> }) => void; failed: (error: Error) => void }>();
  /** Of this view: others of the same model hear its answers, too. */
  readonly #name = Math.random().toString(36).slice(2);
  #last = 0;

  constructor(readonly model: Model) {
    model.on("msg:custom", this.#heard);
  }

  /** Asks the kernel; it answers when it runs no cell. */
  ask<C>(question: Record<string, unknown>): Promise<{ content: C; bytes: Uint8Array<ArrayBuffer> }> {
    const id = `${this.#name}-${++this.#last}`;
    return new Promise((done, failed) => {
      this.#waiting.set(id, { done: done as never, failed });
      this.model.send({ ...question, id });
    });
  }

  /** One of the files of the Python package. */
  async file(name: string): Promise<Uint8Array<ArrayBuffer>> {
    return (await this.ask({ ask: "file", name })).bytes;
  }

  /** The scene as a native file. */
  async scene(): Promise<Uint8Array<ArrayBuffer>> {
    let whole = new Uint8Array();
    let version: number | undefined;
    for (let at = 0; ; ) {
      const { content, bytes } = await this.ask<{ total: number; version: number }>({ ask: "scene", from: at, length: CHUNK });
      if (version !== content.version) {
        [version, whole] = [content.version, new Uint8Array(content.total)];
        // Another scene came between the pieces.
        if (at > 0) {
          at = 0;
          continue;
        }
      }
      whole.set(bytes, at);
      at += bytes.length;
      if (at >= content.total) return whole;
    }
  }

  end() {
    this.model.off("msg:custom", this.#heard);
    for (const { failed } of this.#waiting.values()) failed(new Ended());
    this.#waiting.clear();
  }

  readonly #heard = (content: Answer, buffers: DataView[] = []) => {
    const waiting = this.#waiting.get(content?.id);
    if (!waiting) return;
    this.#waiting.delete(content.id);
    if (content.error !== undefined) waiting.failed(new Error(content.error));
    else waiting.done({ content: content as never, bytes: bytesOf(buffers[0]) });
  };
}

/** The view was closed: nobody is to be told. */
export class Ended extends Error {}

/** A copy of what came over. */
export function bytesOf(view: DataView | ArrayBuffer | undefined): Uint8Array<ArrayBuffer> {
  if (!view) return new Uint8Array();
  return view instanceof ArrayBuffer ? new Uint8Array(view) : new Uint8Array(view.buffer as ArrayBuffer, view.byteOffset, view.byteLength).slice();
}
