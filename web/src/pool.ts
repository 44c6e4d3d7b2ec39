// The workers of one viewer: one for each core, each with the scene. The first reads or makes it, and can trace at once; the others get it packed.
import { GpuTracer } from "./gpu.js";
import type { SceneInfo, Source } from "./protocol.js";
import { type Caller, startWorker, Tracer } from "./tracer.js";

/** The modules: one traces, and reads the simplest formats; the others make scenes for it, and are loaded where they are needed. */
type ModuleName = "voxtrace" | "scenes" | "readers";

const addressOf = (file: string) => new URL(`./${file}`, import.meta.url);
const compiled = new Map<ModuleName, Promise<WebAssembly.Module>>();

/** A module, compiled once for all viewers of a page. */
function moduleOf(name: ModuleName): Promise<WebAssembly.Module> {
  let module = compiled.get(name);
  if (!module) {
    module = compile(addressOf(`${name}.wasm`));
    compiled.set(name, module);
    // The next viewer tries again.
    module.catch(() => compiled.delete(name));
  }
  return module;
}

async function compile(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname}: the server answers ${response.status} ${response.statusText}`.trim());
  // Servers that do not know the type of these files are no hindrance.
  if (response.headers.get("content-type")?.startsWith("application/wasm")) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

/** Cores to use: one is left to the page where there are several. */
export function defaultThreads(): number {
  const cores = navigator.hardwareConcurrency || 2;
  return Math.max(1, Math.min(cores > 4 ? cores - 1 : cores, 16));
}

/** Who is to trace: the GPU where there is one that is not software, the GPU whatever it is, or workers alone. */
export type Tier = "auto" | "gpu" | "cpu";

export class Pool {
  /** Those that have the scene. */
  ready: Caller[] = [];
  #all: Tracer[] = [];
  #gpu: GpuTracer | undefined;
  readonly #onReady: (tracer: Caller) => void;

  /** `onReady` is told of each that has the scene. */
  constructor(onReady: (tracer: Caller) => void) {
    this.#onReady = onReady;
  }

  /** Who traces now. */
  get tier(): "gpu" | "cpu" | undefined {
    if (this.ready.length === 0) return undefined;
    return this.#gpu?.isActive ? "gpu" : "cpu";
  }

  /** Loads a scene: ready as soon as the first worker has it, and the GPU where it traces. */
  async load(source: Source, threads: number, tier: Tier): Promise<SceneInfo> {
    this.end();
    const first = await this.#start("voxtrace");
    const maker = await this.#makerOf(source, first);
    // What is read stays with who reads it.
    const info = await maker.call("load", [source], source.kind === "file" ? [source.bytes.buffer as ArrayBuffer] : []);
    let packed: Uint8Array | undefined;
    if (maker !== first) {
      packed = await maker.call("pack", []);
      this.#leave(maker);
      await hand(packed.slice(), first);
    }
    const others = () => void (threads > 1 && this.#startOthers(first, packed, threads - 1));
    const gpu = tier === "cpu" ? undefined : await GpuTracer.of(first, tier === "gpu", others);
    if (!this.#all.includes(first)) gpu?.end();
    else if (gpu) {
      // One worker beside it is enough, as long as it lasts.
      packed = undefined;
      this.#gpu = gpu;
      this.ready.push(gpu);
      this.#onReady(gpu);
      return info;
    }
    this.#join(first);
    others();
    return info;
  }

  /** Who makes the scene: the first worker itself, or one with the module that can. */
  async #makerOf(source: Source, first: Tracer): Promise<Tracer> {
    if (source.kind === "built-in") return this.#start("scenes");
    const head = source.bytes.slice(0, 132);
    const format = await first.call("formatOf", [head, source.bytes.length, source.name]);
    return format ? first : this.#start("readers");
  }

  end() {
    for (const tracer of this.#all) tracer.end();
    this.#gpu?.end();
    this.#gpu = undefined;
    this.#all = [];
    this.ready = [];
  }

  async #start(name: ModuleName): Promise<Tracer> {
    const module = await moduleOf(name);
    const tracer = new Tracer(startWorker(addressOf(`${name}-worker.js`)));
    this.#all.push(tracer);
    await tracer.call("start", [module]);
    return tracer;
  }

  async #startOthers(first: Tracer, given: Uint8Array | undefined, count: number) {
    try {
      const packed = given ?? (await first.call("pack", []));
      for (let left = count; left > 0 && this.#all.includes(first); left--) {
        const tracer = await this.#start("voxtrace");
        await hand(left === 1 ? packed : packed.slice(), tracer);
        this.#join(tracer);
      }
    } catch {
      // Fewer workers, most likely for want of memory, give the same picture later; and a viewer that was closed needs none.
    }
  }

  #leave(tracer: Tracer) {
    tracer.end();
    this.#all = this.#all.filter((other) => other !== tracer);
  }

  #join(tracer: Tracer) {
    if (!this.#all.includes(tracer)) return;
    this.ready.push(tracer);
    this.#onReady(tracer);
  }
}

/** Gives a packed scene to a worker; its bytes go over. */
function hand(bytes: Uint8Array, tracer: Tracer): Promise<SceneInfo> {
  return tracer.call("load", [{ kind: "file", name: "scene.vxt", bytes }], [bytes.buffer as ArrayBuffer]);
}
