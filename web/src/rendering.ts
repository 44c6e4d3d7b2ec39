// One picture in the making: bands of rows that any worker takes in any order, pass by pass. Bands keep the words of their film, so that the picture
// is the same whoever traced what: sums of integers.
import type { PartRequest } from "./protocol.js";
import type { Caller } from "./tracer.js";

/** Most pixels along an edge of a picture: canvases of browsers have so many. */
const LONGEST = 16_384;

/** The size of the picture for a place on the screen: its pixels, or where those are more than `most`, or than there can be along an edge, fewer of the same shape. */
export function sizeOf(width: number, height: number, most: number) {
  const whole = (length: number) => Math.max(1, length);
  const [across, down] = [whole(width), whole(height)];
  const scale = Math.min(1, Math.sqrt(most / (across * down)), LONGEST / Math.max(across, down));
  return { width: Math.round(whole(across * scale)), height: Math.round(whole(down * scale)) };
}

/** What a picture depends on. */
export interface Picture {
  camera: Float32Array;
  lensOf: number;
  width: number;
  height: number;
  samples: number;
  seed: number;
  bounces: number;
  /** The box within which something is shown, as six numbers. */
  clip?: Float32Array;
}

/** How a film is shown. */
export interface Look {
  toneMapping: string;
  exposure: number;
  /** Whether real-time light is shown where there is such. */
  hasRealTime: boolean;
}

/** Rows y0 to y1 of the picture. */
export interface Band {
  y0: number;
  y1: number;
  samples: number;
  words?: Uint8Array;
  shown?: Uint8ClampedArray<ArrayBuffer>;
  isBusy: boolean;
}

/** Those that there are without one that failed. */
export type Without = (failed: Caller, error: unknown) => Promise<Caller[]>;

/** What a worker is asked for at a time, milliseconds: it cannot be interrupted. */
const PATIENCE = 40;

export class Rendering {
  readonly bands: Band[] = [];
  isStopped = false;
  /** Whether a GPU traced some of the samples, whoever traces now. */
  isOfGpu = false;
  #workers = new Set<Caller>();
  /** Those that failed take no further part. */
  #failed = new Set<Caller>();
  #tell: { done: () => void; failed: (error: unknown) => void } | undefined;
  /** Settled when every band has all samples; never where it was stopped before. */
  readonly finished: Promise<void>;

  /** `onBand` is told of each band that has more samples than before; `without` gives those that go on where one failed. */
  constructor(
    readonly picture: Picture,
    public look: Look,
    { rate, workers }: { rate: number; workers: number },
    private readonly onBand: (band: Band, rendering: Rendering) => void,
    private readonly without: Without,
  ) {
    // So many bands that no worker waits for another.
    const most = Math.ceil(picture.height / (4 * workers));
    const rows = Math.max(1, Math.min(most, Math.round((PATIENCE * rate) / picture.width)));
    for (let y0 = 0; y0 < picture.height; y0 += rows) {
      this.bands.push({ y0, y1: Math.min(y0 + rows, picture.height), samples: 0, isBusy: false });
    }
    this.finished = new Promise<void>((done, failed) => (this.#tell = { done, failed }));
    this.finished.catch(() => {});
  }

  /** The samples that every pixel has. */
  get samples(): number {
    return Math.min(...this.bands.map((band) => band.samples));
  }

  /** Lets a worker take part until all is done, or it fails. */
  async work(tracer: Caller) {
    if (this.#workers.has(tracer) || this.#failed.has(tracer)) return;
    this.#workers.add(tracer);
    try {
      for (let band = this.#next(); band; band = this.#next()) await this.#render(tracer, band);
    } catch (error) {
      this.#failed.add(tracer);
      return this.#handOn(tracer, error);
    } finally {
      this.#workers.delete(tracer);
    }
    if (!this.isStopped && this.samples >= this.picture.samples) this.#tell?.done();
  }

  stop() {
    this.isStopped = true;
  }

  /** Where one failed, others take its band, also those that had nothing left to do; where none is left, all fails. */
  async #handOn(tracer: Caller, error: unknown) {
    const others = (await this.without(tracer, error)).filter((other) => !this.#failed.has(other));
    if (this.isStopped) return;
    for (const other of others) void this.work(other);
    if (others.length === 0) this.#tell?.failed(error);
  }

  /** The words of the whole film, row by row; none before every pixel has a sample. */
  words(): Uint8Array | undefined {
    if (this.bands.some((band) => !band.words)) return undefined;
    const words = new Uint8Array(this.picture.width * this.picture.height * 32);
    for (const band of this.bands) words.set(band.words!, band.y0 * this.picture.width * 32);
    return words;
  }

  /** The band that lags behind most, from the middle of the picture outwards. */
  #next(): Band | undefined {
    if (this.isStopped) return undefined;
    const middle = this.picture.height / 2;
    const rank = (band: Band) => band.samples * 1e6 + Math.abs((band.y0 + band.y1) / 2 - middle);
    const free = this.bands.filter((band) => !band.isBusy && band.samples < this.picture.samples);
    return free.sort((a, b) => rank(a) - rank(b))[0];
  }

  async #render(tracer: Caller, band: Band) {
    const { samples, ...view } = this.picture;
    const { width } = view;
    const pixels = width * (band.y1 - band.y0);
    const more = Math.max(1, Math.min(band.samples, Math.floor((PATIENCE * tracer.rate) / pixels)));
    const target = Math.min(samples, band.samples === 0 ? 1 : band.samples + more);
    const { y0, y1, words } = band;
    let { look } = this;
    const part: PartRequest = { ...view, y0, y1, samples: target, toneMapping: look.toneMapping, exposure: look.exposure };
    band.isBusy = true;
    try {
      // Copied, not given away: where the worker fails, another goes on from here.
      const answer = await tracer.call("render", [words ? { ...part, words } : part]);
      const rate = (pixels * (target - band.samples)) / Math.max(answer.milliseconds, 0.1);
      tracer.rate += 0.3 * (rate - tracer.rate);
      // Another look that was asked for meanwhile: it may be the band's last pass.
      while (look !== this.look) {
        look = this.look;
        answer.shown = await tracer.call("show", [answer.words, look.toneMapping, look.exposure]);
      }
      this.isOfGpu ||= answer.isOfGpu ?? false;
      Object.assign(band, { samples: target, words: answer.words, shown: answer.shown });
    } finally {
      band.isBusy = false;
    }
    if (!this.isStopped) this.onBand(band, this);
  }
}
