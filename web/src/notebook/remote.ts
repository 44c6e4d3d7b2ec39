// Pictures that the kernel renders, for browsers without WebAssembly and for scenes that are not to be sent. The page asks for each picture when the last one
// is there, and for none while nobody looks: a kernel is never busy for a view that is not seen.
import { listen, listenToPresses } from "../gestures.js";
import { cameraOf, panned, type View, viewOf, within } from "../orbit.js";
import type { Picked } from "../protocol.js";
import { bytesOf, Ended, type Kernel } from "./model.js";
import { type Events, isSameCamera, type Shown } from "./shown.js";

const DEGREES_PER_PIXEL = 0.35;
const MAX_PIXELS = 1280 * 720;

interface Frame {
  samples: number;
  camera: number[];
}

export class RemoteView implements Shown {
  readonly element = document.createElement("div");
  readonly #image = document.createElement("img");
  readonly #life = new AbortController();
  #view: View | undefined;
  #home: number[] | undefined;
  /** The camera to the bit, until somebody moves it. */
  #exact: number[] | undefined;
  /** Goes up with each change that wants another picture. */
  #change = 0;
  #isAsking = false;
  #isVisible = true;
  #samples = 0;

  constructor(
    private readonly kernel: Kernel,
    private readonly events: Events,
  ) {
    this.element.className = "voxtrace-remote";
    this.element.tabIndex = 0;
    this.element.setAttribute("role", "img");
    this.#image.draggable = false;
    this.#image.alt = kernel.model.get("_about").name;
    this.element.append(this.#image);
    const poster = bytesOf(kernel.model.get("_poster"));
    if (poster.length > 0) this.#put(poster);
    const move = (change: (view: View) => View) => this.#move(change);
    const moves = {
      turn: (x: number, y: number) => move((view) => ({ ...view, theta: view.theta - x * DEGREES_PER_PIXEL, phi: view.phi - y * DEGREES_PER_PIXEL })),
      pan: (x: number, y: number) => move((view) => panned(view, x / this.element.clientHeight, y / this.element.clientHeight)),
      zoom: (factor: number) => move((view) => ({ ...view, radius: view.radius * factor })),
      home: () => this.#home && move(() => viewOf(this.#home!)),
    };
    const { signal } = this.#life;
    listen(this.element, moves, () => !!this.#view, signal);
    listenToPresses(this.element, (x, y) => void this.#press(x, y), signal);
    const seen = new IntersectionObserver((entries) => {
      this.#isVisible = entries.at(-1)!.isIntersecting;
      void this.#work();
    });
    const sized = new ResizeObserver(() => this.refresh());
    seen.observe(this.element);
    sized.observe(this.element);
    document.addEventListener("visibilitychange", () => void this.#work(), { signal });
    signal.addEventListener("abort", () => {
      seen.disconnect();
      sized.disconnect();
    });
  }

  async load() {
    this.refresh();
  }

  look(numbers: number[]) {
    if (this.#exact && isSameCamera(this.#exact, numbers)) return;
    [this.#exact, this.#view] = [numbers, viewOf(numbers)];
    // Where it has a camera from the start, that is the first view.
    this.#home ??= numbers;
    this.refresh();
  }

  refresh() {
    this.#change++;
    this.#samples = 0;
    void this.#work();
  }

  end() {
    this.#life.abort();
    this.element.remove();
    URL.revokeObjectURL(this.#image.src);
  }

  #move(change: (view: View) => View) {
    if (!this.#view) return;
    const bounds = this.kernel.model.get("_about").bounds ?? [[0, 0, 0], [1, 1, 1]];
    this.#view = within(change(this.#view), Math.hypot(...[0, 1, 2].map((axis) => bounds[1][axis]! - bounds[0][axis]!)) || 1);
    this.#exact = [...cameraOf(this.#view)];
    this.events.camera(this.#exact);
    this.refresh();
  }

  /** The picture's size: as many pixels as the screen has there. */
  #size() {
    const ratio = globalThis.devicePixelRatio || 1;
    const [width, height] = [this.element.clientWidth * ratio, this.element.clientHeight * ratio];
    const scale = Math.min(1, Math.sqrt(MAX_PIXELS / Math.max(1, width * height)));
    return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
  }

  /** Asks for pictures until that of the view has all its samples, or nobody looks. */
  async #work() {
    if (this.#isAsking) return;
    this.#isAsking = true;
    try {
      while (this.#isWanted()) {
        const [change, size] = [this.#change, this.#size()];
        const { content, bytes } = await this.kernel.ask<Frame>({ ask: "frame", ...size, camera: this.#exact ?? null, change });
        if (this.#life.signal.aborted) return;
        this.#put(bytes);
        this.#arrived(content.camera);
        if (change !== this.#change) continue;
        this.#samples = content.samples;
        this.events.samples(content.samples);
      }
    } catch (error) {
      this.#fail(error);
    } finally {
      this.#isAsking = false;
    }
  }

  #fail(error: unknown) {
    if (!(error instanceof Ended)) this.events.failed(error instanceof Error ? error.message : String(error));
  }

  #isWanted() {
    const isSeen = this.#isVisible && document.visibilityState === "visible" && this.element.clientWidth > 0;
    return isSeen && !this.#life.signal.aborted && this.#samples < this.kernel.model.get("samples");
  }

  /** The first picture says from where the scene is seen. */
  #arrived(camera: number[]) {
    if (this.#exact) return;
    [this.#home, this.#exact, this.#view] = [camera, camera, viewOf(camera)];
    this.events.camera(camera);
  }

  #put(picture: Uint8Array<ArrayBuffer>) {
    URL.revokeObjectURL(this.#image.src);
    this.#image.src = URL.createObjectURL(new Blob([picture]));
  }

  async #press(x: number, y: number) {
    if (!this.#exact) return;
    const place = { x, y, width: this.element.clientWidth, height: this.element.clientHeight };
    try {
      const { content } = await this.kernel.ask<{ picked: Picked | null }>({ ask: "pick", camera: this.#exact, ...place });
      this.events.picked(content.picked);
    } catch (error) {
      this.#fail(error);
    }
  }
}
