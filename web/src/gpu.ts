// A tracer on the GPU: parts of pictures by WebGPU, for whoever asks as for those of a worker. Beside it are a worker that traces, which shows films and does what the
// GPU cannot, and one that has the scene as the GPU reads it. Sums are the same wherever they are made (`docs/web.md` says where that was seen).
import { Device, FILM, ShaderError } from "./gpu-device.js";
import { RealTimeOnDevice } from "./gpu-real-time.js";
import { SceneOnDevice } from "./gpu-scene.js";
import type { PartAnswer, PartRequest } from "./protocol.js";
import { type Caller, ClosedError, type Tracer } from "./tracer.js";

/** Losses of the device within so many milliseconds after which it is left alone. */
const TWICE = 60_000;

/** What the tracer on the GPU has from the viewer. */
export interface Around {
  /** A worker that has the scene, and traces. */
  beside: Tracer;
  /** A worker with the module for the GPU, and its end. */
  startTeller(): Promise<Tracer>;
  endTeller(teller: Tracer): void;
  /** The scene, packed. */
  pack(): Promise<Uint8Array>;
  /** More workers are needed: the GPU traces no more, or not all. */
  startWorkers(): void;
  /** Whether WebGPU may be software. */
  takesSoftware: boolean;
}

export class GpuTracer implements Caller {
  rate = 60;
  #teller: Tracer | undefined;
  #scene: SceneOnDevice | undefined;
  #realTime: RealTimeOnDevice | undefined;
  #device: Device | undefined;
  #lastLoss = -Infinity;
  /** Calls come one after the other: buffers are shared. */
  #last: Promise<unknown> = Promise.resolve();
  #isOver = false;
  /** Whether shaders of real-time light are being compiled. */
  #isCompiling = false;
  /** Whether the last part was traced by the worker. */
  #isResting = false;

  private constructor(readonly around: Around) {}

  /** A tracer on the GPU for the scene of a worker; `undefined` where there is no WebGPU for it. */
  static async of(around: Around): Promise<GpuTracer | undefined> {
    if (!globalThis.navigator?.gpu) return undefined;
    const tracer = new GpuTracer(around);
    try {
      if (await tracer.#start()) return tracer;
    } catch (error) {
      if (!(error instanceof ClosedError)) say(`the processor traces, as WebGPU is of no use here: ${(error as Error).message}`);
    }
    tracer.end();
    return undefined;
  }

  /** Whether the GPU traces. */
  get isActive() {
    return !this.#isOver && !this.#isResting;
  }

  /** Takes the scene to a device; false where there is none, or none for this scene. */
  async #start(): Promise<boolean> {
    this.#forget();
    this.#device = await Device.ofPage(this.around.takesSoftware);
    if (!this.#device) return false;
    this.#teller ??= await this.around.startTeller();
    const packed = await this.around.pack();
    const arrays = await this.#teller.call("gpuScene", [packed], [packed.buffer as ArrayBuffer]);
    if (!arrays || this.#isOver) return false;
    this.#scene = await SceneOnDevice.of(this.#device, arrays);
    if (this.#isOver) this.#forget();
    if (this.#scene) this.#realTime = new RealTimeOnDevice(this.#device, this.#scene);
    return !!this.#scene;
  }

  /** The most pixels of a picture in real-time light; 0 where there is none. */
  get mostRealTimePixels(): number {
    return this.isActive ? (this.#realTime?.mostPixels ?? 0) : 0;
  }

  /** A picture in real-time light, as a screen shows it, and what a frame of it took; `undefined` where there is none, or not yet: its shaders are compiled after those of films, beside what
   * the page does. */
  showRealTime(part: PartRequest): Promise<{ shown: Uint8ClampedArray<ArrayBuffer>; milliseconds: number } | undefined> {
    const made = this.#last.then(() => this.#showRealTime(part));
    this.#last = made.catch(() => {});
    return made;
  }

  async #showRealTime(part: PartRequest) {
    const [realTime, device, scene] = [this.#realTime, this.#device, this.#scene];
    if (!realTime || !device || !scene || !this.isActive || part.clip || this.#isCompiling) return undefined;
    try {
      const frame = await this.#teller!.call("gpuFrame", [part]);
      if (!this.around.takesSoftware && !device.settled(FILM, scene.shadersFor(frame))) return undefined;
      const shaders = realTime.shaders(frame);
      if (!shaders) this.#compile(realTime, frame);
      if (shaders instanceof Error) throw shaders;
      if (!shaders) return undefined;
      const frames = await this.#teller!.call("gpuRealTime", [part]);
      const start = performance.now();
      const shown = await realTime.show(frames, shaders);
      return { shown, milliseconds: (performance.now() - start) / frames.reprojects.length };
    } catch (error) {
      if (this.#isOver) return undefined;
      // What real-time light lacks, films need not lack.
      if (device.isLost) await this.#recover(error as Error);
      else this.#endRealTime(error as Error);
      return undefined;
    }
  }

  #compile(realTime: RealTimeOnDevice, frame: Uint32Array) {
    this.#isCompiling = true;
    const end = () => (this.#isCompiling = false);
    realTime.compile(frame).then(end, end);
  }

  #endRealTime(error: Error) {
    say(`what moves is shown coarsely, as real-time light is of no use here: ${error.message}`);
    this.#realTime?.end();
    this.#realTime = undefined;
  }

  #forget() {
    this.#realTime?.end();
    this.#scene?.end();
    this.#realTime = this.#scene = undefined;
  }

  call: Caller["call"] = (name, given, transfer) => {
    if (name !== "render" || this.#isOver) return this.around.beside.call(name, given, transfer);
    const made = this.#last.then(() => this.#render(given[0] as PartRequest));
    this.#last = made.catch(() => {});
    return made as never;
  };

  async #render(part: PartRequest): Promise<PartAnswer> {
    // What a box clips, the shaders of pages do not know.
    if (part.clip) this.around.startWorkers();
    // A device that is lost is made again, once in a while.
    for (let attempt = 0; attempt < 2 && !this.#isOver && !part.clip; attempt++) {
      try {
        const answer = await this.#renderOnDevice(part);
        if (!answer) break;
        this.#isResting = false;
        return answer;
      } catch (error) {
        if (!this.#isOver) await this.#recover(error as Error);
      }
    }
    this.#isResting = true;
    return this.around.beside.call("render", [part]);
  }

  /** The answer of the GPU; none as long as its shaders are being compiled: until then there is a picture, too. */
  async #renderOnDevice(part: PartRequest): Promise<PartAnswer | undefined> {
    const [scene, device] = [this.#scene!, this.#device!];
    const frame = await this.#teller!.call("gpuFrame", [part]);
    const shaders = scene.shadersFor(frame);
    const compiling = device.pipelines(FILM, shaders);
    const pipelines = this.around.takesSoftware ? await compiling : device.settled(FILM, shaders);
    if (pipelines instanceof Error) throw pipelines;
    if (!pipelines) return undefined;
    const start = performance.now();
    const words = await scene.render(part, frame, pipelines);
    const milliseconds = performance.now() - start;
    const shown = await this.around.beside.call("show", [words, part.toneMapping, part.exposure]);
    return { words, shown, milliseconds, isOfGpu: true };
  }

  /** Starts again after an error, or leaves it to the workers. */
  async #recover(error: Error) {
    const now = performance.now();
    const isLast = error instanceof ShaderError || now - this.#lastLoss < TWICE;
    this.#lastLoss = now;
    say(`${isLast ? "the processor goes on in place of the GPU" : "the GPU is started again"}: ${error.message}`);
    if (!isLast && (await this.#start().catch(() => false))) return;
    if (this.#isOver) return;
    this.end();
    this.rate = 60;
    this.around.startWorkers();
  }

  /** Frees what it takes on the GPU, and its worker. */
  end() {
    this.#isOver = true;
    this.#forget();
    if (this.#teller) this.around.endTeller(this.#teller);
  }
}

function say(text: string) {
  console.info(`voxtrace-viewer: ${text}`);
}
