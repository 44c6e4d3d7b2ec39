// What is on the canvas: real-time light or coarse pictures while the view moves, the exact film while it stands still.
import type { Pool } from "./pool.js";
import { type Band, type Look, type Picture, Rendering, type Without } from "./rendering.js";
import { windowOf } from "./template.js";
import type { Caller } from "./tracer.js";

/** What a picture of a view that moves may take, milliseconds: of few samples, and in real-time light. */
const FRAME = 70;
const LIGHT = 30;
/** Pixels of a picture in real-time light are so many times as wide as the canvas's; which of them it is at first. */
const SCALES = [1, 1.5, 2, 3, 4, 6, 8, 12];
const FIRST_SCALE = 3;
/** Samples from which on nothing is seen through a film, at most. */
const OPAQUE = 256;
/** How long a view stands still before its film begins, milliseconds. */
const SETTLED = 180;

export interface Events {
  /** A picture is on the canvas. */
  shown(isCoarse: boolean): void;
  /** The film has all its samples. */
  still(rendering: Rendering): void;
  failed(error: unknown): void;
}

/** One view in motion, until it is on the canvas; in real-time light until another is wanted. */
class Turn {
  /** Whether the film waits for it. */
  isLast = false;
  isStopped = false;
  /** Where it is traced by few samples. */
  rendering: Rendering | undefined;
  done!: () => void;
  readonly finished = new Promise<void>((done) => (this.done = done));

  stop() {
    this.isStopped = true;
    this.rendering?.stop();
    this.done();
  }
}

export class Stage {
  readonly #context: CanvasRenderingContext2D;
  private look!: Look;
  #moving: Turn | undefined;
  #still: Rendering | undefined;
  /** Which of `SCALES`, and the milliseconds of the pictures since it is. */
  #scale = FIRST_SCALE;
  #times: number[] = [];
  #isLit = false;
  /** What is seen through a film of few samples. */
  #under: HTMLCanvasElement | undefined;
  /** What is shown next while the view moves. */
  #next: Picture | undefined;
  /** What is shown in the end. */
  #wanted: Picture | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #repaints = 0;
  readonly #without: Without = (failed, error) => this.pool.without(failed, error);

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly pool: Pool,
    private readonly events: Events,
  ) {
    this.#context = canvas.getContext("2d", { alpha: false })!;
  }

  /** Shows another picture: soon a coarse one, and when nothing changes for a moment, all of it. */
  show(picture: Picture) {
    this.#still?.stop();
    this.#still = undefined;
    this.#next = this.#wanted = picture;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#settle(picture), SETTLED);
    if (!this.#moving) this.#renderMoving();
  }

  /** Another exposure or curve, also of films that are there already; the first one is given before anything is shown. */
  async setLook(look: Look) {
    this.look = look;
    const still = this.#still;
    if (!still) return;
    // It has the exposure and the curve of before.
    this.#under = undefined;
    still.look = look;
    const repaint = ++this.#repaints;
    for (const band of still.bands.filter((band) => band.words)) {
      const tracer = this.pool.ready[band.y0 % this.pool.ready.length];
      if (!tracer || repaint !== this.#repaints || this.#still !== still) return;
      const words = band.words!;
      const shown = await tracer.call("show", [words, look.toneMapping, look.exposure]).catch(() => band.shown!);
      // A band that got more samples meanwhile has its own.
      if (band.words === words) band.shown = shown;
      if (this.#still === still) this.#draw(band, still);
    }
  }

  /** Another one that has the scene joins. */
  join(tracer: Caller) {
    void this.#moving?.rendering?.work(tracer);
    void this.#still?.work(tracer);
  }

  /** Whether what is on the canvas is in real-time light. */
  get isLit(): boolean {
    return this.#isLit;
  }

  /** The film of the view that stands still. */
  get film(): Rendering | undefined {
    return this.#still;
  }

  stop() {
    clearTimeout(this.#timer);
    this.#moving?.stop();
    this.#still?.stop();
    this.#moving = this.#still = this.#next = this.#wanted = this.#under = undefined;
    this.#isLit = false;
  }

  /** What a worker does in a millisecond, in the mean, and how many there are. */
  get #power() {
    const { ready } = this.pool;
    const workers = Math.max(1, ready.length);
    return { workers, rate: ready.reduce((sum, tracer) => sum + tracer.rate, 0) / workers };
  }

  /** The latest view. */
  #renderMoving() {
    const picture = this.#next;
    this.#next = undefined;
    if (!picture || this.pool.ready.length === 0) return;
    const turn = (this.#moving = new Turn());
    const end = () => {
      turn.done();
      if (this.#moving !== turn) return;
      this.#moving = undefined;
      if (this.#next) this.#renderMoving();
    };
    const failed = (error: unknown) => {
      end();
      if (!turn.isStopped) this.events.failed(error);
    };
    this.#renderTurn(picture, turn).then(end, failed);
  }

  /** Shows a view in real-time light, which gets better until another one or the film is wanted; or else at as many pixels as the workers trace in a moment. */
  async #renderTurn(picture: Picture, turn: Turn) {
    let isLit = await this.#light(picture, turn);
    if (!isLit) return this.#sample(picture, turn);
    while (isLit && !turn.isStopped && !turn.isLast && !this.#next) {
      await new Promise((done) => windowOf(this.canvas).requestAnimationFrame(done));
      if (turn.isStopped) return;
      isLit = await this.#light(picture, turn);
    }
  }

  /** Shows a view in real-time light; false where there is none. */
  async #light(picture: Picture, turn: Turn): Promise<boolean> {
    const { gpu } = this.pool;
    const pixels = picture.width * picture.height;
    const most = gpu?.mostRealTimePixels ?? 0;
    if (!gpu || most === 0 || !this.look.hasRealTime) return false;
    while (pixels / SCALES[this.#scale]! ** 2 > most && this.#scale + 1 < SCALES.length) this.#scale += 1;
    const scale = SCALES[this.#scale]!;
    const [width, height] = [picture.width, picture.height].map((length) => Math.max(1, Math.round(length / scale)));
    const part = { ...picture, width: width!, height: height!, y0: 0, y1: height!, samples: 1, toneMapping: this.look.toneMapping, exposure: this.look.exposure };
    const made = await gpu.showRealTime(part);
    if (!made) return false;
    this.#pace(made.milliseconds, pixels, most);
    if (turn.isStopped) return true;
    this.#drawScaled([{ shown: made.shown, y0: 0, y1: height! }], { width: width!, height: height! }, picture);
    this.#isLit = true;
    return true;
  }

  /** Chooses how fine the next picture in real-time light is, by what this one took. Another size knows nothing of pixels, so it stays as long as it is about right. */
  #pace(milliseconds: number, pixels: number, most: number) {
    this.#times.push(milliseconds);
    // The first one of a size looks at everything.
    if (this.#times.length < 3 && milliseconds < 4 * LIGHT) return;
    const time = [...this.#times.slice(-3)].sort((a, b) => a - b)[Math.min(1, this.#times.length - 1)]!;
    // As if all of it were for pixels: a finer one takes less than that.
    const wanted = SCALES[this.#scale]! * Math.sqrt(time / LIGHT);
    const isRight = time <= 1.5 * LIGHT && !(this.#scale > 0 && wanted <= SCALES[this.#scale - 1]! && pixels / SCALES[this.#scale - 1]! ** 2 <= most);
    if (isRight) return;
    const finest = SCALES.findIndex((scale) => scale >= wanted && pixels / scale ** 2 <= most);
    const next = finest < 0 ? SCALES.length - 1 : finest;
    if (next !== this.#scale) [this.#scale, this.#times] = [next, []];
  }

  async #sample(picture: Picture, turn: Turn) {
    const pixels = picture.width * picture.height;
    const { rate, workers } = this.#power;
    const scale = Math.max(1, Math.min(12, Math.sqrt(pixels / (FRAME * rate * workers))));
    const [width, height] = [picture.width, picture.height].map((length) => Math.max(1, Math.round(length / scale)));
    if (turn.isStopped) return;
    const rendering = new Rendering({ ...picture, width: width!, height: height!, samples: 1 }, this.look, this.#power, () => {}, this.#without);
    turn.rendering = rendering;
    this.#start(rendering);
    await rendering.finished;
    if (turn.isStopped) return;
    this.#drawScaled(rendering.bands, rendering.picture, picture);
    this.#isLit = false;
  }

  #settle(picture: Picture) {
    if (this.#moving) {
      // Bands of a film beside nothing are no picture: the coarse one comes first, however long it takes.
      this.#moving.isLast = true;
      void this.#moving.finished.then(() => this.#wanted === picture && this.#settle(picture));
      return;
    }
    this.#next = undefined;
    this.#under = this.#isLit ? copyOf(this.canvas) : undefined;
    this.#isLit = false;
    const rendering = new Rendering(picture, this.look, this.#power, (band) => this.#draw(band, rendering), this.#without);
    this.#still = rendering;
    rendering.finished.then(
      () => this.#still === rendering && this.events.still(rendering),
      (error) => this.events.failed(error),
    );
    this.#start(rendering);
  }

  #start(rendering: Rendering) {
    for (const tracer of this.pool.ready) void rendering.work(tracer);
  }

  #resize({ width, height }: Picture) {
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
  }

  #draw(band: Band, { picture }: Rendering) {
    if (!band.shown) return;
    const { width, height } = this.canvas;
    if (width !== picture.width || height !== picture.height) {
      // What was there before stays until all bands are there.
      const last = copyOf(this.canvas);
      this.#resize(picture);
      this.#context.drawImage(last, 0, 0, picture.width, picture.height);
    }
    const rows = new ImageData(band.shown, picture.width, band.y1 - band.y0);
    const weight = this.#under ? weightOf(band.samples, picture.samples) : 1;
    if (weight < 1) {
      // Light goes over to the film.
      this.#context.drawImage(this.#under!, 0, band.y0, rows.width, rows.height, 0, band.y0, rows.width, rows.height);
      this.#context.globalAlpha = weight;
      this.#context.drawImage(canvasOf(rows.width, rows.height, (context) => context.putImageData(rows, 0, 0)), 0, band.y0);
      this.#context.globalAlpha = 1;
    } else {
      this.#context.putImageData(rows, 0, band.y0);
    }
    this.events.shown(false);
  }

  #drawScaled(bands: Pick<Band, "shown" | "y0" | "y1">[], { width, height }: { width: number; height: number }, whole: Picture) {
    const small = canvasOf(width, height, (context) => {
      for (const { shown, y0, y1 } of bands) if (shown) context.putImageData(new ImageData(shown, width, y1 - y0), 0, y0);
    });
    this.#resize(whole);
    this.#context.imageSmoothingQuality = "high";
    this.#context.drawImage(small, 0, 0, whole.width, whole.height);
    this.events.shown(true);
  }
}

/** How much of a film of so many samples, of those that are wanted, is seen over real-time light: all of it at its end. */
function weightOf(samples: number, wanted: number): number {
  const weight = 1 + Math.log2(samples / Math.min(OPAQUE, wanted)) / 4;
  return samples >= wanted ? 1 : Math.max(0, Math.min(1, weight));
}

function canvasOf(width: number, height: number, draw: (context: CanvasRenderingContext2D) => void): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [width, height];
  draw(canvas.getContext("2d")!);
  return canvas;
}

function copyOf(canvas: HTMLCanvasElement): HTMLCanvasElement {
  return canvasOf(canvas.width, canvas.height, (context) => context.drawImage(canvas, 0, 0));
}
