// What is on the canvas: coarse pictures while the view moves, the exact film while it stands still.
import type { Pool } from "./pool.js";
import { type Band, type Look, type Picture, Rendering } from "./rendering.js";
import type { Caller } from "./tracer.js";

/** What a picture of a view that moves may take, milliseconds. */
const FRAME = 70;
/** How long a view stands still before its film begins, milliseconds. */
const SETTLED = 180;

export interface Events {
  /** A picture is on the canvas. */
  shown(isCoarse: boolean): void;
  /** The film has all its samples. */
  still(picture: Picture): void;
  failed(error: unknown): void;
}

export class Stage {
  readonly #context: CanvasRenderingContext2D;
  #coarse: Rendering | undefined;
  #still: Rendering | undefined;
  /** What is shown next while the view moves. */
  #next: Picture | undefined;
  /** What is shown in the end. */
  #wanted: Picture | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #repaints = 0;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly pool: Pool,
    private readonly events: Events,
    private look: Look,
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
    if (!this.#coarse) this.#renderCoarse();
  }

  /** Another exposure or curve: of films that are there already. */
  async setLook(look: Look) {
    this.look = look;
    const still = this.#still;
    if (!still) return;
    still.look = look;
    const repaint = ++this.#repaints;
    for (const band of still.bands.filter((band) => band.words)) {
      const tracer = this.pool.ready[band.y0 % this.pool.ready.length];
      if (!tracer || repaint !== this.#repaints || this.#still !== still) return;
      const words = band.words!;
      band.shown = await tracer.call("show", [words, look.toneMapping, look.exposure]).catch(() => band.shown!);
      if (this.#still === still) this.#draw(band, still);
    }
  }

  /** Another one that has the scene joins. */
  join(tracer: Caller) {
    void this.#coarse?.work(tracer);
    void this.#still?.work(tracer);
  }

  /** The film of the view that stands still. */
  get film(): Rendering | undefined {
    return this.#still;
  }

  stop() {
    clearTimeout(this.#timer);
    this.#coarse?.stop();
    this.#still?.stop();
    this.#coarse = this.#still = this.#next = this.#wanted = undefined;
  }

  /** What a worker does in a millisecond, in the mean, and how many there are. */
  get #power() {
    const { ready } = this.pool;
    const workers = Math.max(1, ready.length);
    return { workers, rate: ready.reduce((sum, tracer) => sum + tracer.rate, 0) / workers };
  }

  /** The latest view at as many pixels as the workers trace in a moment. */
  #renderCoarse() {
    const picture = this.#next;
    this.#next = undefined;
    if (!picture || this.pool.ready.length === 0) return;
    const pixels = picture.width * picture.height;
    const { rate, workers } = this.#power;
    const scale = Math.max(1, Math.min(12, Math.sqrt(pixels / (FRAME * rate * workers))));
    const [width, height] = [picture.width, picture.height].map((length) => Math.max(1, Math.round(length / scale)));
    const rendering = new Rendering({ ...picture, width: width!, height: height!, samples: 1 }, this.look, this.#power, () => {});
    this.#coarse = rendering;
    const end = () => {
      if (this.#coarse === rendering) this.#coarse = undefined;
      if (this.#next) this.#renderCoarse();
    };
    rendering.finished.then(
      () => {
        this.#drawScaled(rendering, picture);
        end();
      },
      (error) => {
        end();
        this.events.failed(error);
      },
    );
    this.#start(rendering);
  }

  #settle(picture: Picture) {
    if (this.#coarse) {
      // Bands of a film beside nothing are no picture: the coarse one comes first, however long it takes.
      this.#coarse.finished.then(() => this.#wanted === picture && this.#settle(picture), () => {});
      return;
    }
    this.#next = undefined;
    const rendering = new Rendering(picture, this.look, this.#power, (band) => this.#draw(band, rendering));
    this.#still = rendering;
    rendering.finished.then(
      () => this.#still === rendering && this.events.still(picture),
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
    this.#context.putImageData(new ImageData(band.shown, picture.width, band.y1 - band.y0), 0, band.y0);
    this.events.shown(false);
  }

  #drawScaled({ bands, picture }: Rendering, whole: Picture) {
    const small = document.createElement("canvas");
    [small.width, small.height] = [picture.width, picture.height];
    const context = small.getContext("2d")!;
    for (const { shown, y0, y1 } of bands) {
      if (shown) context.putImageData(new ImageData(shown, picture.width, y1 - y0), 0, y0);
    }
    this.#resize(whole);
    this.#context.imageSmoothingQuality = "high";
    this.#context.drawImage(small, 0, 0, whole.width, whole.height);
    this.events.shown(true);
  }
}

function copyOf(canvas: HTMLCanvasElement): HTMLCanvasElement {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  copy.getContext("2d")!.drawImage(canvas, 0, 0);
  return copy;
}
