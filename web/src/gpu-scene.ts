// A scene on the GPU, and the rounds in which samples of its pictures are traced: `shaders/pass/page.slang` has the other half.
import { Buffers, bindingsOf } from "./gpu-buffers.js";
import { Device, FILM, type Pipelines, SCENE, type Specialized } from "./gpu-device.js";
import type { GpuArrays, PartRequest } from "./protocol.js";

/** What a submit may take at most, milliseconds: the page's own pictures wait behind it. */
const PATIENCE = 50;
/** Rounds in a submit, at most. */
const MOST_ROUNDS = 64;
/** Paths that are under way together, and rows of 16 bytes that each takes: among matte things, and among all. */
export const MOST_PATHS = 1 << 18;
const ROWS = { matte: 15, all: 22 };
export const WORKGROUP = 64;
/** Words of a frame behind its record: the constants of its lens and its sky. */
export const LENS_AND_SKY = 4;

const { written: WRITTEN, uniform: UNIFORM } = FILM.bindings;

export class SceneOnDevice {
  readonly buffers: Buffers;
  /** Rounds that fit a submit. */
  #rounds = 1;

  private constructor(
    private readonly gpu: Device,
    private readonly arrays: Pick<GpuArrays, "constants" | "isMatte">,
  ) {
    this.buffers = new Buffers(gpu);
  }

  /** Whether everything is matte. */
  get isMatte(): boolean {
    return this.arrays.isMatte;
  }

  get #device() {
    return this.gpu.device;
  }

  /** Takes a scene to a device; `undefined` where it is larger than what it binds. */
  static async of(gpu: Device, arrays: GpuArrays): Promise<SceneOnDevice | undefined> {
    const names = Object.keys(SCENE) as (keyof typeof SCENE)[];
    if (names.some((name) => arrays[name].byteLength > gpu.largest)) return undefined;
    const { constants, isMatte } = arrays;
    const made = new SceneOnDevice(gpu, { constants, isMatte });
    await gpu.checked(() => {
      for (const name of names) {
        made.buffers.storage(SCENE[name], arrays[name].byteLength);
        made.buffers.write(SCENE[name], arrays[name]);
      }
      for (const binding of Object.values(UNIFORM)) made.buffers.uniform(binding);
      made.buffers.storage(WRITTEN.missing, 4);
    });
    return made;
  }

  /** Frees what the scene takes there. */
  end() {
    this.buffers.end();
  }

  /** The shaders for a frame. */
  shadersFor(frame: Uint32Array): Specialized {
    const constants = [...this.arrays.constants, ...frame.subarray(frame.length - LENS_AND_SKY)];
    return { isMatte: this.arrays.isMatte, constants };
  }

  /** Adds the samples that are asked for to the words of a part of a film. */
  async render(part: PartRequest, frame: Uint32Array, pipelines: Pipelines<typeof FILM>): Promise<Uint8Array> {
    const pixels = part.width * (part.y1 - part.y0);
    const capacity = Math.min(pixels, MOST_PATHS);
    const words = part.words ?? new Uint8Array(pixels * 32);
    await this.gpu.checked(() => {
      this.buffers.storage(WRITTEN.paths, capacity * (this.arrays.isMatte ? ROWS.matte : ROWS.all) * 16);
      this.buffers.write(UNIFORM.frame, frame.subarray(0, frame.length - LENS_AND_SKY));
      this.buffers.storage(WRITTEN.pixels, pixels * 32);
      this.buffers.write(WRITTEN.pixels, words);
    });
    for (let first = 0; first < pixels; first += capacity) {
      await this.#trace(pipelines, { first, count: Math.min(capacity, pixels - first), capacity, samples: part.samples });
    }
    return new Uint8Array(await this.buffers.read(WRITTEN.pixels, pixels * 32));
  }

  /** Traces until each of these pixels has its samples. */
  async #trace(pipelines: Pipelines<typeof FILM>, { first, count, capacity, samples }: { first: number; count: number; capacity: number; samples: number }) {
    const missing = this.buffers.at(WRITTEN.missing);
    const group = this.buffers.group(this.gpu.layoutOf(FILM), bindingsOf(FILM.bindings));
    this.buffers.write(UNIFORM.dispatch, new Uint32Array([first, count, samples, samples, 0, 0, 0, 0]));
    let left = count;
    for (let turn = 0; left > 0; turn++) {
      const start = performance.now();
      // The first turn begins paths, and traces nothing.
      const rounds = turn === 0 ? 0 : this.#rounds;
      left = await this.gpu.checked(async () => {
        this.buffers.write(UNIFORM.step, new Uint32Array([Math.min(turn, 1), 0, capacity, 0, 0, 0, 0, 0]));
        const encoder = this.#device.createCommandEncoder();
        for (let round = 0; round < rounds; round++) {
          const pass = encoder.beginComputePass();
          pass.setBindGroup(0, group);
          const entries = ["walk_paths", "shade_paths", "choose_lights", "scatter_paths", "begin_paths"] as const;
          // How many lack samples is counted after the last round.
          for (const entry of round + 1 < rounds ? entries : entries.slice(0, -1)) {
            pass.setPipeline(pipelines[entry]);
            pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
          }
          pass.end();
        }
        encoder.clearBuffer(missing);
        const pass = encoder.beginComputePass();
        pass.setBindGroup(0, group);
        pass.setPipeline(pipelines.begin_paths);
        pass.dispatchWorkgroups(Math.ceil(count / WORKGROUP));
        pass.end();
        this.#device.queue.submit([encoder.finish()]);
        return new Uint32Array(await this.buffers.read(WRITTEN.missing, 4))[0]!;
      });
      if (rounds === 0) continue;
      const factor = PATIENCE / 2 / Math.max(performance.now() - start, 1);
      this.#rounds = Math.max(1, Math.min(MOST_ROUNDS, Math.round(this.#rounds * Math.max(0.25, Math.min(2, factor)))));
    }
  }
}
