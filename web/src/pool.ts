// The workers of one viewer: one for each core, each with the scene. The first reads or makes it, and can trace at once; the others get it packed.
import { GpuTracer } from "./gpu.js";
import type { SceneInfo, Source } from "./protocol.js";
import { type Caller, ClosedError, startWorker, Tracer, TracerError } from "./tracer.js";

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
  // Servers that do not know the type of these files, or add a charset to it, are no hindrance.
  if (response.headers.get("content-type") === "application/wasm") return WebAssembly.compileStreaming(response);
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
  /** Those that left since they failed. */
  #failed = new Set<Caller>();
  /** Raised by each end: whoever waits for something meanwhile goes on only where it is the same. */
  #generation = 0;
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
    const generation = this.#generation;
    const first = await this.#start("voxtrace", generation);
    const maker = await this.#makerOf(source, first, generation);
    // What is read stays with who reads it.
    const info = await maker.call("load", [source], source.kind === "file" ? [source.bytes.buffer as ArrayBuffer] : []);
    let packed: Uint8Array | undefined;
    if (maker !== first) {
      packed = await maker.call("pack", []);
      this.#leave(maker);
      await hand(packed.slice(), first);
    }
    this.#check(generation);
    let hasOthers = false;
    const startOthers = () => {
      if (threads > 1 && !hasOthers) this.#others = this.#startOthers(first, packed, threads - 1, generation);
      hasOthers = true;
    };
    // Where the package's files come from the page, as in notebooks, the shaders are not among them.
    if (tier !== "cpu" && !this.files) {
      const gpu = await GpuTracer.of({
        beside: first,
        startTeller: () => this.#start("gpu", generation),
        endTeller: (teller) => this.#leave(teller),
        pack: async () => packed?.slice() ?? (await first.call("pack", [])),
        startWorkers: startOthers,
        takesSoftware: tier === "gpu",
      });
      if (gpu && generation === this.#generation) {
        // One worker beside it is enough, as long as it lasts.
        packed = undefined;
        this.#gpu = gpu;
        this.ready.push(gpu);
        this.#onReady(gpu);
        return info;
      }
      gpu?.end();
      this.#check(generation);
    }
    this.#join(first);
    startOthers();
    return info;
  }

  /** Settled when those that are getting the scene have it. */
  get joined(): Promise<void> {
    return this.#others;
  }

  /** Gives all workers another scene, packed, in the place of theirs, which all of them have: ready as soon as the first one has it. */
  async replace(packed: Uint8Array): Promise<SceneInfo> {
    const generation = this.#generation;
    this.ready = [];
    const [first, ...others] = this.#all;
    if (!first) throw new ClosedError();
    const info = await hand(others.length > 0 ? packed.slice() : packed, first);
    this.#check(generation);
    this.#join(first);
    this.#others = (async () => {
      for (const [index, tracer] of others.entries()) {
        if (generation !== this.#generation) return;
        // As where they start.
        await this.#give(index === others.length - 1 ? packed : packed.slice(), tracer).catch(() => {});
      }
    })();
    return info;
  }

  /** Those that go on with the scene of one that failed, which leaves if it is of no use any more. Where none has the scene, those that are getting it are waited for. */
  async without(failed: Caller, error: unknown): Promise<Caller[]> {
    const generation = this.#generation;
    const known: (Caller | undefined)[] = [...this.#all, this.#gpu, ...this.#failed];
    if (!known.includes(failed)) return [];
    if (error instanceof TracerError && error.isFatal) {
      this.#failed.add(failed);
      this.ready = this.ready.filter((other) => other !== failed);
      if (failed instanceof Tracer) this.#leave(failed, error);
      else if (this.#gpu) {
        // Where the GPU fails, so did the worker beside it.
        this.#leave(this.#gpu.around.beside, error);
        this.#gpu.end();
        this.#gpu = undefined;
      }
    }
    if (this.ready.length === 0) await this.#others;
    return generation === this.#generation ? this.ready : [];
  }

  /** How many workers there are. */
  get size(): number {
    return this.#all.length;
  }

  /** Who makes the scene: the first worker itself, or one with the module that can. */
  async #makerOf(source: Source, first: Tracer, generation: number): Promise<Tracer> {
    if (source.kind === "built-in") return this.#start("scenes", generation);
    const head = source.bytes.slice(0, 132);
    const format = await first.call("formatOf", [head, source.bytes.length, source.name]);
    return format ? first : this.#start("readers", generation);
  }

  end() {
    this.#generation++;
    for (const tracer of this.#all) tracer.end();
    this.#gpu?.end();
    this.#gpu = undefined;
    this.#all = [];
    this.#failed.clear();
    this.ready = [];
    this.#others = Promise.resolve();
  }

  /** Goes on only where the pool was not ended since. */
  #check(generation: number) {
    if (generation !== this.#generation) throw new ClosedError();
  }

  async #start(name: ModuleName, generation: number): Promise<Tracer> {
    const module = await this.module(name);
    this.#check(generation);
    const tracer = new Tracer(await this.worker(name));
    if (generation !== this.#generation) tracer.end();
    this.#check(generation);
    this.#all.push(tracer);
    await this.#orLeave(tracer, tracer.call("start", [module]));
    this.#check(generation);
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

  async #startOthers(first: Tracer, given: Uint8Array | undefined, count: number, generation: number) {
    try {
      const packed = given ?? (await first.call("pack", []));
      for (let left = count; left > 0; left--) {
        const tracer = await this.#start("voxtrace", generation);
        await this.#give(left === 1 ? packed : packed.slice(), tracer);
      }
    } catch {
      // Fewer workers, most likely for want of memory, give the same picture later; and a viewer that was closed needs none.
    }
  }

  /** Gives a packed scene to one that joins. */
  async #give(bytes: Uint8Array, tracer: Tracer) {
    await this.#orLeave(tracer, hand(bytes, tracer));
    this.#join(tracer);
  }

  /** Where a worker that is to join cannot do what it is asked for, it leaves. */
  #orLeave(tracer: Tracer, asked: Promise<unknown>) {
    return asked.catch((error) => {
      this.#leave(tracer);
      throw error;
    });
  }

  #leave(tracer: Tracer, error?: TracerError) {
    tracer.end(error);
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
