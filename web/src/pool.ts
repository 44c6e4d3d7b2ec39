// The workers of one viewer: one for each core, each with the scene. The first reads or makes it, and can trace at once; the others get it packed.
import { GpuTracer } from "./gpu.js";
import type { SceneInfo, Source } from "./protocol.js";
import { type Caller, startWorker, Tracer, TracerError } from "./tracer.js";

/** The modules: one traces, and reads the simplest formats; `gpu` tells WebGPU what to trace; the others make scenes for it, `stream` of the parts of a file, and are loaded where they are needed. */
type ModuleName = "voxtrace" | "gpu" | "scenes" | "readers" | "stream";

const addressOf = (file: string) => new URL(`./${file}`, import.meta.url);
const compiled = new Map<ModuleName, Promise<WebAssembly.Module>>();

/** Gives the bytes of the package's own files, by their names, where a page has no addresses for them. */
export type Files = (name: string) => Promise<Uint8Array<ArrayBuffer>>;

/** A module, compiled once for all viewers of a page. */
function moduleOf(name: ModuleName, files: Files | undefined): Promise<WebAssembly.Module> {
  let module = compiled.get(name);
  if (!module) {
    const file = `${name}.wasm`;
    module = files ? files(file).then((bytes) => WebAssembly.compile(bytes)) : compile(addressOf(file));
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
  readonly #scripts = new Map<ModuleName, Promise<URL>>();
  readonly #onReady: (tracer: Caller) => void;
  /** The workers after the first get the scene. */
  #others: Promise<void> = Promise.resolve();
  /** Where the package's files come from, if not from beside it. */
  files: Files | undefined;

  /** `onReady` is told of each that has the scene. */
  constructor(onReady: (tracer: Caller) => void) {
    this.#onReady = onReady;
  }

  /** The tracer on the GPU, where there is one. */
  get gpu(): GpuTracer | undefined {
    return this.#gpu;
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
    let hasOthers = false;
    const startOthers = () => {
      if (threads > 1 && !hasOthers) this.#others = this.#startOthers(first, packed, threads - 1);
      hasOthers = true;
    };
    // Where the package's files come from the page, as in notebooks, the shaders are not among them.
    if (tier !== "cpu" && !this.files) {
      const gpu = await GpuTracer.of({
        beside: first,
        startTeller: () => this.#start("gpu"),
        endTeller: (teller) => this.#leave(teller),
        pack: async () => packed?.slice() ?? (await first.call("pack", [])),
        startWorkers: startOthers,
        takesSoftware: tier === "gpu",
      });
      if (gpu && this.#all.includes(first)) {
        // One worker beside it is enough, as long as it lasts.
        packed = undefined;
        this.#gpu = gpu;
        this.ready.push(gpu);
        this.#onReady(gpu);
        return info;
      }
      gpu?.end();
    }
    this.#join(first);
    startOthers();
    return info;
  }

  /** Gives all workers another scene, packed, in the place of theirs: ready as soon as the first one has it. */
  async replace(packed: Uint8Array): Promise<SceneInfo> {
    // Those that get the scene of before join until then.
    await this.#others;
    this.ready = [];
    const [first, ...others] = this.#all;
    if (!first) throw new TracerError("the viewer was closed", true);
    const info = await hand(others.length > 0 ? packed.slice() : packed, first);
    this.#join(first);
    this.#others = (async () => {
      for (const [index, tracer] of others.entries()) {
        await hand(index === others.length - 1 ? packed : packed.slice(), tracer);
        this.#join(tracer);
      }
    })().catch(() => {
      // As where they start.
    });
    return info;
  }

  /** How many workers there are. */
  get size(): number {
    return this.#all.length;
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
    const module = await this.module(name);
    const tracer = new Tracer(await this.worker(name));
    this.#all.push(tracer);
    await tracer.call("start", [module]);
    return tracer;
  }

  /** One of the package's modules. */
  module(name: ModuleName): Promise<WebAssembly.Module> {
    return moduleOf(name, this.files);
  }

  /** A worker that runs the script of a module. */
  async worker(name: ModuleName): Promise<Worker> {
    return startWorker(await this.#scriptOf(name));
  }

  /** The address of a worker's script; of bytes it is made once. */
  #scriptOf(name: ModuleName): URL | Promise<URL> {
    const file = `${name}-worker.js`;
    if (!this.files) return addressOf(file);
    const made = this.#scripts.get(name) ?? this.files(file).then((bytes) => new URL(URL.createObjectURL(new Blob([bytes], { type: "text/javascript" }))));
    this.#scripts.set(name, made);
    return made;
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
