// Real-time light on the GPU: one path a pixel and frame, a cache of light, what is known of pixels, and a filter (`docs/realtime.md`).
// `shaders/pass/page_realtime.slang` and `realtime_pixels.slang` have the other half, `voxtrace-realtime` a twin on the processor.
import { Buffers, bindingsOf } from "./gpu-buffers.js";
import { type Device, LOOKS, PIXELS, type Pipelines, REAL_TIME, type Specialized } from "./gpu-device.js";
import { LENS_AND_SKY, MOST_PATHS, type SceneOnDevice, WORKGROUP } from "./gpu-scene.js";
import type { GpuRealTimeFrames } from "./protocol.js";

const { written: PATHS, uniform: UNIFORM } = REAL_TIME.bindings;
const { written: KNOWN, read: READ } = PIXELS.bindings;
/** Rows of 16 bytes of a path: among matte things, and among all. */
const ROWS = { matte: 16, all: 23 };
/** Rounds after which paths are cut off: among matte things, where each bounce takes one, and among all, where boundaries that they pass take more. */
const ROUNDS = { matte: 12, all: 20 };
/** Rounds of those that only look: mirrors and clear glass that they come through. */
const LOOK_ROUNDS = { matte: 1, all: 6 };
/** Bytes of a cell of the light cache in its rows, and of its keys; words before these, and the first of those that say how many workgroups trace cells. */
const CELL_ROWS = 64;
const CELL_KEYS = 12;
const CELL_COUNTS = 16;
const CELL_GROUPS = 5;
/** Bytes of a pixel: what is known of it, and what a frame works with. */
const MEMORY = 64;
const SCRATCH = 80;
/** The number by which the buffer of workgroups is kept: no binding. */
const GROUPS = -1;
/** Pixels at most: a tile of 8 × 8 is a workgroup, of which a dispatch has 65,535 in one direction, and those at borders are not full. */
const MOST_PIXELS = 1 << 21;

/** The steps that filter a picture and show it. */
const SHOW = PIXELS.entries.slice(PIXELS.entries.indexOf("filter_begin"));

/** The shaders of all modules. */
interface Shaders {
  paths: Pipelines<typeof REAL_TIME>;
  looks: Pipelines<typeof LOOKS>;
  pixels: Pipelines<typeof PIXELS>;
}

export class RealTimeOnDevice {
  readonly #buffers: Buffers;
  /** The buffer that the rows of the light cache lie in. */
  #cells: GPUBuffer | undefined;

  constructor(
    private readonly gpu: Device,
    private readonly scene: SceneOnDevice,
  ) {
    this.#buffers = new Buffers(gpu, scene.buffers);
  }

  /** The most pixels of a picture there. */
  get mostPixels(): number {
    return Math.min(Math.floor(this.gpu.largest / SCRATCH), MOST_PIXELS);
  }

  /** The shaders for a frame where they are compiled, or what is wrong with them; `undefined` as long as that is not known. */
  shaders(frame: Uint32Array): Shaders | Error | undefined {
    const [paths, pixels] = this.#specialized(frame);
    const settled = { paths: this.gpu.settled(REAL_TIME, paths), looks: this.gpu.settled(LOOKS, paths), pixels: this.gpu.settled(PIXELS, pixels) };
    const all = Object.values(settled);
    return all.find((shaders) => shaders instanceof Error) ?? (all.every((shaders) => shaders) ? (settled as Shaders) : undefined);
  }

  /** Has the shaders for a frame compiled. */
  async compile(frame: Uint32Array): Promise<void> {
    const [paths, pixels] = this.#specialized(frame);
    await Promise.all([this.gpu.pipelines(REAL_TIME, paths), this.gpu.pipelines(LOOKS, paths), this.gpu.pipelines(PIXELS, pixels)]);
  }

  #specialized(frame: Uint32Array): [Specialized, Specialized] {
    const paths = this.scene.shadersFor(frame);
    // Steps that trace no rays are the same in all scenes.
    return [paths, { isMatte: true, constants: [...frame.subarray(frame.length - LENS_AND_SKY)] }];
  }

  /** Traces a picture and shows it: eight bits of red, green, blue and opacity a pixel. */
  async show({ width, height, frame, frames, words, reprojects, looks, cells, tracingCells }: GpuRealTimeFrames, shaders: Shaders): Promise<Uint8ClampedArray<ArrayBuffer>> {
    const [buffers, rows] = [this.#buffers, this.scene.isMatte ? ROWS.matte : ROWS.all];
    const groups = Math.ceil(width / 8) * Math.ceil(height / 8);
    const capacity = Math.max(Math.min(groups * WORKGROUP, MOST_PATHS), tracingCells);
    await this.gpu.checked(() => {
      const made = buffers.storage(PATHS.paths, CELL_ROWS * cells + 16 * rows * capacity);
      const keys = buffers.storage(PATHS.cellKeys, 4 * CELL_COUNTS + CELL_KEYS * cells);
      // Where it is a new one, nothing is known of any cell.
      if (made !== this.#cells) this.#submit((encoder) => encoder.clearBuffer(keys));
      this.#cells = made;
      buffers.storage(PATHS.scratch, SCRATCH * width * height);
      buffers.storage(KNOWN.memory, MEMORY * width * height);
      buffers.storage(KNOWN.picture, 4 * width * height);
      buffers.storage(READ.motions, 16);
      for (const binding of Object.values(UNIFORM)) buffers.uniform(binding);
      buffers.indirect(GROUPS);
      buffers.write(UNIFORM.frame, frame.subarray(0, frame.length - LENS_AND_SKY));
      buffers.write(UNIFORM.step, new Uint32Array([0, 0, capacity, 0, 0, 0, 0, 0]));
      for (let number = 0; number < reprojects.length; number++) {
        buffers.write(UNIFORM.realTime, frames.subarray(number * words, (number + 1) * words));
        this.#trace(shaders, { groups, cells, tracingCells, capacity });
        this.#remember(shaders.pixels, { groups, finds: !!reprojects[number] });
        for (let look = 1; look <= looks[2 * number]!; look++) {
          this.#look(shaders, { groups, capacity, turn: look - 1, number: looks[2 * number + 1]! + look });
        }
        this.#end(shaders.pixels, { groups, cells, shows: number + 1 === reprojects.length });
      }
    });
    return new Uint8ClampedArray(await buffers.read(KNOWN.picture, 4 * width * height));
  }

  /** Cells are chosen that trace, and all paths of a frame are followed. */
  #trace({ paths, pixels }: Shaders, { groups, cells, tracingCells, capacity }: { groups: number; cells: number; tracingCells: number; capacity: number }) {
    const buffers = this.#buffers;
    const [keys, indirect] = [buffers.at(PATHS.cellKeys), buffers.at(GROUPS)];
    this.#submit((encoder) => {
      // None yet, and no workgroups for them.
      encoder.clearBuffer(keys, 8, 4);
      encoder.clearBuffer(keys, 4 * CELL_GROUPS, 4);
      const pass = this.#pass(encoder, PIXELS);
      pass.setPipeline(pixels.choose_cells);
      pass.dispatchWorkgroups(cells / WORKGROUP);
      pass.end();
      encoder.copyBufferToBuffer(keys, 4 * CELL_GROUPS, indirect, 0, 4);
    });
    // In one direction.
    this.gpu.device.queue.writeBuffer(indirect, 4, new Uint32Array([1, 1]));
    this.#follow(paths, 0, tracingCells, (pass) => pass.dispatchWorkgroupsIndirect(indirect, 0));
    for (let first = 0; first < groups * WORKGROUP; first += capacity) {
      const count = Math.min(capacity, groups * WORKGROUP - first);
      this.#follow(paths, tracingCells + first, count, (pass) => pass.dispatchWorkgroups(count / WORKGROUP));
    }
  }

  /** Follows the paths of some items to their ends. */
  #follow(paths: Shaders["paths"], first: number, count: number, dispatch: (pass: GPUComputePassEncoder) => void) {
    this.#buffers.write(UNIFORM.dispatch, new Uint32Array([first, count, 0, 0, 0, 0, 0, 0]));
    this.#submit((encoder) => {
      const pass = this.#pass(encoder, REAL_TIME);
      const run = (entry: keyof typeof paths) => {
        pass.setPipeline(paths[entry]);
        dispatch(pass);
      };
      run("begin_paths");
      // Cells begin with a light.
      run("choose_lights");
      for (let round = 0; round < (this.scene.isMatte ? ROUNDS.matte : ROUNDS.all); round++) {
        run("walk_paths");
        run("shade_paths");
        run("choose_lights");
        run("scatter_paths");
      }
      run("end_paths");
      pass.end();
    });
  }

  /** What paths found is added to what is known of pixels, found again where the camera moved. */
  #remember(pixels: Shaders["pixels"], { groups, finds }: { groups: number; finds: boolean }) {
    this.#submit((encoder) => {
      const pass = this.#pass(encoder, PIXELS);
      for (const step of finds ? (["reproject", "remember"] as const) : (["remember"] as const)) {
        pass.setPipeline(pixels[step]);
        pass.dispatchWorkgroups(groups);
      }
      pass.end();
    });
  }

  /** A ray of each pixel looks at what it shows, where that was seen too seldom. */
  #look({ paths, looks }: Shaders, { groups, capacity, turn, number }: { groups: number; capacity: number; turn: number; number: number }) {
    for (let first = 0; first < groups * WORKGROUP; first += capacity) {
      const count = Math.min(capacity, groups * WORKGROUP - first);
      this.#buffers.write(UNIFORM.dispatch, new Uint32Array([first, count, number, turn, 0, 0, 0, 0]));
      this.#submit((encoder) => {
        const run = (module: typeof REAL_TIME | typeof LOOKS, pipelines: GPUComputePipeline[]) => {
          const pass = this.#pass(encoder, module);
          for (const pipeline of pipelines) {
            pass.setPipeline(pipeline);
            pass.dispatchWorkgroups(count / WORKGROUP);
          }
          pass.end();
        };
        run(LOOKS, [looks.begin_looks]);
        const round = this.scene.isMatte ? [paths.walk_paths, paths.shade_paths] : [paths.walk_paths, paths.shade_paths, paths.scatter_paths];
        run(REAL_TIME, Array<typeof round>(this.scene.isMatte ? LOOK_ROUNDS.matte : LOOK_ROUNDS.all).fill(round).flat());
        run(LOOKS, [looks.end_looks]);
      });
    }
  }

  /** Cells end the frame, and the picture is filtered where it is shown. */
  #end(pixels: Shaders["pixels"], { groups, cells, shows }: { groups: number; cells: number; shows: boolean }) {
    this.#submit((encoder) => {
      // Those that are asked for are counted anew.
      encoder.clearBuffer(this.#buffers.at(PATHS.cellKeys), 0, 8);
      const pass = this.#pass(encoder, PIXELS);
      const run = (entry: keyof typeof pixels, count: number) => {
        pass.setPipeline(pixels[entry]);
        pass.dispatchWorkgroups(count);
      };
      run("end_cells", cells / WORKGROUP);
      if (shows) for (const step of SHOW) run(step, groups);
      pass.end();
    });
  }

  #pass(encoder: GPUCommandEncoder, module: typeof REAL_TIME | typeof LOOKS | typeof PIXELS): GPUComputePassEncoder {
    const pass = encoder.beginComputePass();
    pass.setBindGroup(0, this.#buffers.group(this.gpu.layoutOf(module), bindingsOf(module.bindings)));
    return pass;
  }

  #submit(record: (encoder: GPUCommandEncoder) => void) {
    const encoder = this.gpu.device.createCommandEncoder();
    record(encoder);
    this.gpu.device.queue.submit([encoder.finish()]);
  }

  end() {
    this.#buffers.end();
  }
}
