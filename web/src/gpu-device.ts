// The device of WebGPU that all viewers of a page share, and the shaders that are compiled for it.

// The library of TypeScript has WebGPU's types, but not yet these constants of it.
declare const GPUShaderStage: { readonly COMPUTE: number };

/** Numbers of the bindings of a scene, which all shaders that trace read. */
export const SCENE = { cells: 0, bricks: 1, brickMaterials: 2, records: 3, environment: 19 } as const;

/** What a module of shaders binds, by number: storage that is read, storage that is written, uniforms. */
interface Bindings {
  read: Record<string, number>;
  written: Record<string, number>;
  uniform: Record<string, number>;
}

/** The modules of shaders of pages: their bindings, their entry points, and their lines of `shaders.wgsl`, two where there is one for matte things alone and one for all materials. */
export const FILM = {
  bindings: { read: SCENE, written: { pixels: 10, missing: 15, paths: 22 }, uniform: { frame: 9, dispatch: 16, step: 23 } },
  entries: ["begin_paths", "walk_paths", "shade_paths", "choose_lights", "scatter_paths"],
  lines: [4, 0],
} as const;
/** The paths of real-time light (`pass/page_realtime.slang`). */
export const REAL_TIME = {
  bindings: { read: SCENE, written: { paths: 22, scratch: 26, cellKeys: 27 }, uniform: { frame: 9, dispatch: 16, step: 23, realTime: 24 } },
  entries: ["begin_paths", "walk_paths", "shade_paths", "choose_lights", "scatter_paths", "end_paths"],
  lines: [3, 1],
} as const;
/** Paths that only look, in the same modules: where they begin and end, which needs what is known of pixels. */
export const LOOKS = {
  bindings: { read: {}, written: { paths: 22, scratch: 26, memory: 25 }, uniform: { frame: 9, dispatch: 16, step: 23, realTime: 24 } },
  entries: ["begin_looks", "end_looks"],
  lines: [3, 1],
} as const;
/** Its steps that trace no rays (`pass/realtime_pixels.slang`). */
export const PIXELS = {
  bindings: { read: { motions: 29 }, written: { paths: 22, scratch: 26, cellKeys: 27, memory: 25, picture: 12 }, uniform: { frame: 9, realTime: 24 } },
  entries: [
    "choose_cells", "end_cells", "reproject", "remember", "filter_begin", "filter_compare", "filter_noise", "filter_tolerance", "filter_level_0", "filter_level_1",
    "filter_level_2", "filter_level_3", "filter_level_4", "filter_end", "filter_across", "filter_picture", "show_picture",
  ],
  lines: [2, 2],
} as const;

interface Module {
  bindings: Bindings;
  entries: readonly string[];
  lines: readonly [number, number];
}

/** A compiled shader for each entry point of a module. */
export type Pipelines<M extends Module> = Record<M["entries"][number], GPUComputePipeline>;

/** Which shaders: those where everything is matte or those for all materials, and their constants (number, value, number, value). */
export interface Specialized {
  isMatte: boolean;
  constants: number[];
}

/** Shaders that do not compile: nothing can be done about it. */
export class ShaderError extends Error {}

let texts: Promise<string[]> | undefined;

/** The modules, loaded once. */
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
  readonly #layouts = new Map<Module, GPUBindGroupLayout>();
  readonly #pipelines = new Map<string, Promise<object>>();
  readonly #settled = new Map<string, object>();
  isLost = false;

  private constructor(readonly device: GPUDevice) {
    void device.lost.then(() => (this.isLost = true));
  }

  /** The layout of the bindings of a module. */
  layoutOf(module: Module): GPUBindGroupLayout {
    const made = this.#layouts.get(module);
    if (made) return made;
    const entry = (binding: number, type: GPUBufferBindingType) => ({ binding, visibility: GPUShaderStage.COMPUTE, buffer: { type } });
    const { read, written, uniform } = module.bindings;
    const layout = this.device.createBindGroupLayout({
      entries: [
        ...Object.values(read).map((binding) => entry(binding, "read-only-storage")),
        ...Object.values(written).map((binding) => entry(binding, "storage")),
        ...Object.values(uniform).map((binding) => entry(binding, "uniform")),
      ],
    });
    this.#layouts.set(module, layout);
    return layout;
  }

  static #ofPage: Promise<Device> | undefined;

  /** The device of the page; `undefined` where there is none, and where it is software that nobody asked for. */
  static async ofPage(takesSoftware: boolean): Promise<Device | undefined> {
    const adapter = await navigator.gpu.requestAdapter({ powerPreference: "high-performance" });
    // What runs on the processor anyway is slower than the workers.
    if (!adapter || (adapter.info.isFallbackAdapter && !takesSoftware)) return undefined;
    let asked;
    do {
      asked = Device.#ofPage;
      const last = await asked?.catch(() => undefined);
      if (last && !last.isLost) return last;
      // Where it was lost, all viewers ask at once: the first of them makes another one.
    } while (asked !== Device.#ofPage);
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

  /** The shaders of a module where they are compiled, or what is wrong with them; `undefined` as long as that is not known. */
  settled<M extends Module>(module: M, shaders: Specialized): Pipelines<M> | Error | undefined {
    return this.#settled.get(keyOf(module, shaders)) as Pipelines<M> | Error | undefined;
  }

  /** These shaders, compiled beside what the page does, once. */
  pipelines<M extends Module>(module: M, shaders: Specialized): Promise<Pipelines<M>> {
    const key = keyOf(module, shaders);
    const made = this.#pipelines.get(key) ?? this.#compile(module, shaders);
    this.#pipelines.set(key, made);
    const settle = (outcome: object) => void this.#settled.set(key, outcome);
    made.then(settle, settle);
    return made as Promise<Pipelines<M>>;
  }

  async #compile(module: Module, { isMatte, constants: pairs }: Specialized): Promise<object> {
    const texts = await modules().catch((error) => {
      // Who tries again has a device that does not know of this.
      Device.#ofPage = undefined;
      throw error;
    });
    const code = texts[module.lines[isMatte ? 0 : 1]]!;
    const compiled = this.device.createShaderModule({ code });
    const layout = this.device.createPipelineLayout({ bindGroupLayouts: [this.layoutOf(module)] });
    const constants: Record<string, number> = {};
    // A module without a constant of that number refuses it.
    const ids = new Set([...code.matchAll(/@id\((\d+)\)/g)].map(([, id]) => Number(id)));
    for (let at = 0; at < pairs.length; at += 2) if (ids.has(pairs[at]!)) constants[pairs[at]!] = pairs[at + 1]!;
    const pipeline = (entryPoint: string) => this.device.createComputePipelineAsync({ layout, compute: { module: compiled, entryPoint, constants } });
    try {
      return Object.fromEntries(await Promise.all(module.entries.map(async (entry) => [entry, await pipeline(entry)] as const)));
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

function keyOf({ entries }: Module, shaders: Specialized): string {
  return `${entries.join()} ${JSON.stringify(shaders)}`;
}
