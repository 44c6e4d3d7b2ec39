// The device of WebGPU that all viewers of a page share, and the shaders that are compiled for it.

// The library of TypeScript has WebGPU's types, but not yet these constants of it.
declare const GPUShaderStage: { readonly COMPUTE: number };

/** Numbers of the bindings of `pass/page.slang`: storage that is read, storage that is written, uniforms. */
export const READ = { cells: 0, bricks: 1, brickMaterials: 2, records: 3, environment: 19 } as const;
export const WRITTEN = { pixels: 10, missing: 15, paths: 22 } as const;
export const UNIFORM = { frame: 9, dispatch: 16, step: 23 } as const;

const ENTRIES = ["begin_paths", "walk_paths", "shade_paths", "choose_lights", "scatter_paths"] as const;
/** A compiled shader for each entry point. */
export type Pipelines = Record<(typeof ENTRIES)[number], GPUComputePipeline>;

/** Which shaders: the module where everything is matte or that for all materials, and its constants (number, value, number, value). */
export interface Specialized {
  isMatte: boolean;
  constants: number[];
}

/** Shaders that do not compile: nothing can be done about it. */
export class ShaderError extends Error {}

let texts: Promise<string[]> | undefined;

/** The modules, loaded once: that for matte things, and that for all materials. */
function modules(): Promise<string[]> {
  texts ??= fetch(new URL("./shaders.wgsl", import.meta.url)).then(async (response) => {
    if (!response.ok) throw new Error(`shaders.wgsl: the server answers ${response.status}`);
    return (await response.text()).split("\n");
  });
  // The next viewer tries again.
  texts.catch(() => (texts = undefined));
  return texts;
}

export class Device {
  readonly layout: GPUBindGroupLayout;
  readonly #pipelines = new Map<string, Promise<Pipelines>>();
  readonly #settled = new Map<string, Pipelines | Error>();
  isLost = false;

  private constructor(readonly device: GPUDevice) {
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

  static #ofPage: Promise<Device> | undefined;

  /** The device of the page; `undefined` where there is none, and where it is software that nobody asked for. */
  static async ofPage(takesSoftware: boolean): Promise<Device | undefined> {
    const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
    // What runs on the processor anyway is slower than the workers.
    if (!adapter || (adapter.info.isFallbackAdapter && !takesSoftware)) return undefined;
    const last = await Device.#ofPage?.catch(() => undefined);
    if (last && !last.isLost) return last;
    // A default device binds 128 MiB; where there is more, larger scenes fit.
    const { maxStorageBufferBindingSize, maxBufferSize } = adapter.limits;
    const made = adapter.requestDevice({ requiredLimits: { maxStorageBufferBindingSize, maxBufferSize } }).then((device) => new Device(device));
    Device.#ofPage = made;
    return made;
  }

  /** The most bytes of an array. */
  get largest(): number {
    const { maxStorageBufferBindingSize, maxBufferSize } = this.device.limits;
    return Math.min(maxStorageBufferBindingSize, maxBufferSize);
  }

  /** These shaders where they are compiled, or what is wrong with them; `undefined` as long as that is not known. */
  settled(shaders: Specialized): Pipelines | Error | undefined {
    return this.#settled.get(JSON.stringify(shaders));
  }

  /** These shaders, compiled beside what the page does, once. */
  pipelines(shaders: Specialized): Promise<Pipelines> {
    const key = JSON.stringify(shaders);
    const made = this.#pipelines.get(key) ?? this.#compile(shaders);
    this.#pipelines.set(key, made);
    const settle = (outcome: Pipelines | Error) => void this.#settled.set(key, outcome);
    made.then(settle, settle);
    return made;
  }

  async #compile({ isMatte, constants: pairs }: Specialized): Promise<Pipelines> {
    const code = (await modules())[isMatte ? 0 : 1]!;
    const module = this.device.createShaderModule({ code });
    const layout = this.device.createPipelineLayout({ bindGroupLayouts: [this.layout] });
    const constants: Record<string, number> = {};
    // A module without a constant of that number refuses it.
    const ids = new Set([...code.matchAll(/@id\((\d+)\)/g)].map(([, id]) => Number(id)));
    for (let at = 0; at < pairs.length; at += 2) if (ids.has(pairs[at]!)) constants[pairs[at]!] = pairs[at + 1]!;
    const pipeline = (entryPoint: string) => this.device.createComputePipelineAsync({ layout, compute: { module, entryPoint, constants } });
    try {
      return Object.fromEntries(await Promise.all(ENTRIES.map(async (entry) => [entry, await pipeline(entry)] as const))) as Pipelines;
    } catch (error) {
      throw this.isLost ? error : new ShaderError(`the shaders do not compile: ${(error as Error).message}`);
    }
  }

  /** What `work` makes; where the device finds fault with it, that is the error. */
  async checked<T>(work: () => T | Promise<T>): Promise<T> {
    const filters = ["validation", "out-of-memory", "internal"] as const;
    for (const filter of filters) this.device.pushErrorScope(filter);
    const made = (async () => work())();
    // What it does up to its first wait is what is checked.
    const errors = await Promise.all(filters.map(() => this.device.popErrorScope()));
    const error = errors.find((error) => error);
    if (error) {
      made.catch(() => {});
      throw new Error(error.message);
    }
    return made;
  }
}
