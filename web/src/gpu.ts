// A tracer on the GPU: parts of pictures by WebGPU, for whoever asks as for those of a worker. It keeps a worker beside it, which makes what the device
// is told, shows films, and traces in its place where the device is lost. Sums are the same wherever they are made (`docs/web.md` says where that was seen).
import type { PartAnswer, PartRequest } from "./protocol.js";
import type { Caller, Tracer } from "./tracer.js";

// The library of TypeScript has WebGPU's types, but not yet these constants of it.
declare const GPUShaderStage: { readonly COMPUTE: number };
declare const GPUMapMode: { readonly READ: number };
declare const GPUBufferUsage: Record<"STORAGE" | "UNIFORM" | "COPY_SRC" | "COPY_DST" | "MAP_READ", number>;

/** What a submit may take at most, milliseconds: the page's own pictures wait behind it. */
const PATIENCE = 50;
/** Paths that are under way together, and rows of 16 bytes that each takes: among matte things, and among all. */
const MOST_PATHS = 1 << 18;
const ROWS = [12, 18];
/** Losses of the device within so many milliseconds after which it is left alone. */
const TWICE = 60_000;
const WORKGROUP = 64;

/** Numbers of the bindings of `pass/page.slang`: storage that is read, storage that is written, uniforms. */
const READ = { cells: 0, bricks: 1, brickMaterials: 2, records: 3, environment: 19 };
const WRITTEN = { pixels: 10, missing: 15, paths: 22 };
const UNIFORM = { frame: 9, dispatch: 16, step: 23 };
const ENTRIES = ["begin_paths", "walk_paths", "shade_paths", "choose_lights"] as const;

/** The arrays of a scene, and what its shaders are specialized with: number, value, number, value. */
export interface GpuScene {
  cells: Uint32Array;
  bricks: Uint32Array;
  brickMaterials: Uint32Array;
  records: Uint32Array;
  environment: Uint32Array;
  constants: Uint32Array;
  /** Whether everything is matte, so that the shorter shaders will do. */
  isMatte: boolean;
}

type Arrays = keyof typeof READ;
type Pipelines = Record<(typeof ENTRIES)[number], GPUComputePipeline>;

const texts = new Map<string, Promise<string>>();

/** The shaders, loaded once for all viewers of a page. */
function shaders(name: string): Promise<string> {
  let text = texts.get(name);
  if (!text) {
    text = fetch(new URL(`./${name}.wgsl`, import.meta.url)).then((response) => {
      if (!response.ok) throw new Error(`${name}.wgsl: the server answers ${response.status}`);
      return response.text();
    });
    texts.set(name, text);
    text.catch(() => texts.delete(name));
  }
  return text;
}

/** A device, and what is compiled for it: one for all viewers of a page. */
class Device {
  readonly layout: GPUBindGroupLayout;
  readonly #modules = new Map<string, Promise<{ module: GPUShaderModule; ids: Set<number> }>>();
  readonly #pipelines = new Map<string, Promise<Pipelines>>();
  readonly compiled = new Set<string>();
  isLost = false;

  constructor(readonly device: GPUDevice) {
    const entry = (binding: number, type: GPUBufferBindingType) => ({ binding, visibility: GPUShaderStage.COMPUTE, buffer: { type } });
    this.layout = device.createBindGroupLayout({
      entries: [
        ...Object.values(READ).map((binding) => entry(binding, "read-only-storage")),
        ...Object.values(WRITTEN).map((binding) => entry(binding, "storage")),
        ...Object.values(UNIFORM).map((binding) => entry(binding, "uniform")),
      ],
    });
    void device.lost.then(() => (this.isLost = true));
  }

  /** The pipelines with these constants (number, value, number, value), compiled beside what the page does. */
  pipelines(name: string, pairs: number[]): Promise<Pipelines> {
    const key = keyOf(name, pairs);
    let made = this.#pipelines.get(key);
    if (!made) {
      made = this.#compile(name, pairs);
      this.#pipelines.set(key, made);
      made.then(() => this.compiled.add(key), () => this.#pipelines.delete(key));
    }
    return made;
  }

  async #compile(name: string, pairs: number[]): Promise<Pipelines> {
    const { module, ids } = await this.#module(name);
    const constants: Record<string, number> = {};
    // A module without a constant of that number refuses it.
    for (let at = 0; at < pairs.length; at += 2) if (ids.has(pairs[at]!)) constants[pairs[at]!] = pairs[at + 1]!;
    const layout = this.device.createPipelineLayout({ bindGroupLayouts: [this.layout] });
    const pipeline = (entryPoint: string) => this.device.createComputePipelineAsync({ layout, compute: { module, entryPoint, constants } });
    const made = await Promise.all(ENTRIES.map(async (entry) => [entry, await pipeline(entry)] as const));
    return Object.fromEntries(made) as Pipelines;
  }

  #module(name: string) {
    let module = this.#modules.get(name);
    if (!module) {
      module = shaders(name).then((code) => {
        const ids = new Set([...code.matchAll(/@id\((\d+)\)/g)].map(([, id]) => Number(id)));
        return { module: this.device.createShaderModule({ code }), ids };
      });
      this.#modules.set(name, module);
      module.catch(() => this.#modules.delete(name));
    }
    return module;
  }
}

const keyOf = (name: string, pairs: number[]) => `${name} ${pairs.join()}`;

let device: Promise<Device | undefined> | undefined;

/** The device of the page; `undefined` where there is none, and where it is software that nobody asked for. */
async function deviceOfPage(takesSoftware: boolean): Promise<Device | undefined> {
  const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
  // What runs on the processor anyway is slower than the workers.
  if (!adapter || (adapter.info.isFallbackAdapter && !takesSoftware)) return undefined;
  const last = await device?.catch(() => undefined);
  if (last && !last.isLost) return last;
  // A default device binds 128 MiB; where there is more, larger scenes fit.
  const { maxStorageBufferBindingSize, maxBufferSize } = adapter.limits;
  device = adapter.requestDevice({ requiredLimits: { maxStorageBufferBindingSize, maxBufferSize } }).then((made) => new Device(made));
  return device;
}

/** A scene on a device. */
class SceneOnDevice {
  readonly #buffers = new Map<number, GPUBuffer>();
  /** Rounds that fit a submit. */
  #rounds = 1;

  private constructor(
    private readonly gpu: Device,
    private readonly constants: number[],
    private readonly isMatte: boolean,
  ) {}

  get #device() {
    return this.gpu.device;
  }

  /** Takes a scene to the device of the page; `undefined` where there is none, or none for a scene of that size. */
  static async of(scene: () => Promise<GpuScene>, takesSoftware: boolean): Promise<SceneOnDevice | undefined> {
    const gpu = await deviceOfPage(takesSoftware);
    if (!gpu) return undefined;
    const arrays = await scene();
    const { limits } = gpu.device;
    const largest = Math.max(...(Object.keys(READ) as Arrays[]).map((name) => arrays[name].byteLength));
    if (largest > Math.min(limits.maxStorageBufferBindingSize, limits.maxBufferSize)) return undefined;
    return scoped(gpu.device, () => {
      const made = new SceneOnDevice(gpu, [...arrays.constants], arrays.isMatte);
      for (const [name, binding] of Object.entries(READ)) made.#upload(binding, arrays[name as Arrays]);
      for (const binding of Object.values(UNIFORM)) made.#upload(binding, new Uint32Array(binding === UNIFORM.frame ? 256 : 8), GPUBufferUsage.UNIFORM);
      made.#upload(WRITTEN.missing, new Uint32Array(4));
      return made;
    });
  }

  /** Frees what the scene takes there. */
  end() {
    for (const buffer of this.#buffers.values()) buffer.destroy();
  }

  #shadersFor(frame: Uint32Array) {
    return { name: this.isMatte ? "matte" : "materials", pairs: [...this.constants, ...frame.subarray(frame.length - 4)] };
  }

  /** Whether the shaders for a frame are compiled; begins it where they are not. */
  isCompiledFor(frame: Uint32Array): boolean {
    const { name, pairs } = this.#shadersFor(frame);
    this.gpu.pipelines(name, pairs).catch(() => {});
    return this.gpu.compiled.has(keyOf(name, pairs));
  }

  /** Adds the samples that are asked for to the words of a part of a film. */
  async render(part: PartRequest, frame: Uint32Array<ArrayBuffer>): Promise<Uint8Array> {
    const params = frame.subarray(0, frame.length - 4);
    const { name, pairs } = this.#shadersFor(frame);
    const pipelines = await this.gpu.pipelines(name, pairs);
    const { queue } = this.#device;
    const pixels = part.width * (part.y1 - part.y0);
    return scoped(this.#device, async () => {
      const capacity = Math.min(pixels, MOST_PATHS);
      this.#reserve(WRITTEN.paths, capacity * ROWS[this.isMatte ? 0 : 1]! * 16);
      const film = this.#reserve(WRITTEN.pixels, pixels * 32);
      const words = part.words ?? new Uint8Array(pixels * 32);
      queue.writeBuffer(film, 0, words.buffer as ArrayBuffer, words.byteOffset, pixels * 32);
      queue.writeBuffer(this.#buffers.get(UNIFORM.frame)!, 0, params.slice());
      for (let first = 0; first < pixels; first += capacity) {
        await this.#trace(pipelines, { first, count: Math.min(capacity, pixels - first), capacity, samples: part.samples });
      }
      return new Uint8Array(await this.#read(film, pixels * 32));
    });
  }

  /** Traces until each of these pixels has its samples. */
  async #trace(pipelines: Pipelines, { first, count, capacity, samples }: { first: number; count: number; capacity: number; samples: number }) {
    const device = this.#device;
    const { queue } = device;
    const missing = this.#buffers.get(WRITTEN.missing)!;
    const group = this.#group();
    queue.writeBuffer(this.#buffers.get(UNIFORM.dispatch)!, 0, new Uint32Array([first, count, samples, samples, 0, 0, 0, 0]));
    let left = count;
    for (let round = 0; left > 0; round++) {
      const start = performance.now();
      queue.writeBuffer(this.#buffers.get(UNIFORM.step)!, 0, new Uint32Array([Math.min(round, 1), 0, capacity, 0, 0, 0, 0, 0]));
      const encoder = device.createCommandEncoder();
      const rounds = round === 0 ? 0 : this.#rounds;
      const run = (...entries: (keyof Pipelines)[]) => {
        const pass = encoder.beginComputePass();
        pass.setBindGroup(0, group);
        for (const entry of entries) {
          pass.setPipeline(pipelines[entry]);
          pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
        }
        pass.end();
      };
      for (let at = 0; at < rounds; at++) {
        run("walk_paths", "shade_paths", "choose_lights", "shade_paths");
        if (at + 1 < rounds) run("begin_paths");
      }
      encoder.clearBuffer(missing);
      run("begin_paths");
      queue.submit([encoder.finish()]);
      left = new Uint32Array(await this.#read(missing, 4))[0]!;
      if (rounds > 0) {
        const took = performance.now() - start;
        this.#rounds = Math.max(1, Math.min(64, Math.round(this.#rounds * Math.max(0.25, Math.min(2, PATIENCE / 2 / Math.max(took, 1))))));
      }
    }
  }

  #group(): GPUBindGroup {
    const entries = [...this.#buffers].map(([binding, buffer]) => ({ binding, resource: { buffer } }));
    return this.#device.createBindGroup({ layout: this.gpu.layout, entries });
  }

  #upload(binding: number, words: Uint32Array, usage = GPUBufferUsage.STORAGE) {
    const buffer = this.#device.createBuffer({ size: words.byteLength, usage: usage | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC });
    this.#device.queue.writeBuffer(buffer, 0, words.buffer as ArrayBuffer, words.byteOffset, words.byteLength);
    this.#buffers.set(binding, buffer);
  }

  /** A buffer of at least so many bytes. */
  #reserve(binding: number, size: number): GPUBuffer {
    const there = this.#buffers.get(binding);
    if (there && there.size >= size) return there;
    there?.destroy();
    const buffer = this.#device.createBuffer({ size, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC });
    this.#buffers.set(binding, buffer);
    return buffer;
  }

  async #read(buffer: GPUBuffer, size: number): Promise<ArrayBuffer> {
    const device = this.#device;
    const copy = device.createBuffer({ size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    const encoder = device.createCommandEncoder();
    encoder.copyBufferToBuffer(buffer, 0, copy, 0, size);
    device.queue.submit([encoder.finish()]);
    await copy.mapAsync(GPUMapMode.READ);
    const bytes = copy.getMappedRange().slice(0);
    copy.destroy();
    return bytes;
  }
}

/** What `work` makes on a device; where the device finds fault with it, that is the error. */
async function scoped<T>(device: GPUDevice, work: () => T | Promise<T>): Promise<T> {
  for (const filter of ["validation", "out-of-memory", "internal"] as const) device.pushErrorScope(filter);
  try {
    return await work();
  } finally {
    const errors = await Promise.all([0, 1, 2].map(() => device.popErrorScope()));
    const error = errors.find((error) => error);
    if (error) throw new Error(error.message);
  }
}

/** Traces on the GPU as long as there is one, and by the worker `beside` it otherwise. */
export class GpuTracer implements Caller {
  rate = 60;
  #scene: SceneOnDevice | undefined;
  #lastLoss = -Infinity;
  /** Calls come one after the other: buffers are shared. */
  #last: Promise<unknown> = Promise.resolve();
  #isOver = false;

  private constructor(
    private readonly beside: Tracer,
    private readonly takesSoftware: boolean,
    private readonly onOver: () => void,
  ) {}

  /** A tracer on the GPU for the scene of a worker; `undefined` where there is no WebGPU for it. `onOver` is told when there is none any more. */
  static async of(beside: Tracer, takesSoftware: boolean, onOver: () => void): Promise<GpuTracer | undefined> {
    if (!globalThis.navigator?.gpu) return undefined;
    const tracer = new GpuTracer(beside, takesSoftware, onOver);
    await tracer.#start();
    return tracer.#scene ? tracer : undefined;
  }

  /** Whether the GPU traces. */
  get isActive() {
    return !this.#isOver;
  }

  async #start() {
    try {
      this.#scene = await SceneOnDevice.of(() => this.beside.call("gpuScene", []), this.takesSoftware);
    } catch (error) {
      console.info(`voxtrace-viewer: the processor traces, as WebGPU is of no use here: ${(error as Error).message}`);
      this.#scene = undefined;
    }
  }

  call: Caller["call"] = (name, given, transfer) => {
    if (name !== "render" || !this.isActive) return this.beside.call(name, given, transfer);
    const made = this.#last.then(() => this.#render(given[0] as PartRequest));
    this.#last = made.catch(() => {});
    return made as never;
  };

  async #render(part: PartRequest): Promise<PartAnswer> {
    // A device that is lost is made again, once in a while.
    for (let attempt = 0; attempt < 2 && this.isActive && this.#scene; attempt++) {
      try {
        const frame = await this.beside.call("gpuFrame", [part]);
        // Until the shaders are compiled there is a picture, too.
        if (!this.takesSoftware && !this.#scene.isCompiledFor(frame)) break;
        const start = performance.now();
        const words = await this.#scene.render(part, frame as Uint32Array<ArrayBuffer>);
        const milliseconds = performance.now() - start;
        const shown = await this.beside.call("show", [words, part.toneMapping, part.exposure]);
        return { words, shown, milliseconds };
      } catch (error) {
        const now = performance.now();
        const isAgain = now - this.#lastLoss < TWICE;
        this.#lastLoss = now;
        console.info(`voxtrace-viewer: ${isAgain ? "the processor goes on in place of the GPU" : "the GPU is started again"}: ${(error as Error).message}`);
        if (isAgain) this.#scene = undefined;
        else {
          this.#scene?.end();
          await this.#start();
        }
      }
    }
    if (this.isActive && !this.#scene) this.#leave();
    return this.beside.call("render", [part]);
  }

  #leave() {
    this.#isOver = true;
    this.rate = 60;
    this.onOver();
  }

  /** Frees what it takes on the GPU. */
  end() {
    this.#isOver = true;
    this.#scene?.end();
    this.#scene = undefined;
  }
}
