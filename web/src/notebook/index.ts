// The widget `voxtrace.view` in a notebook's page, by anywidget: `render` is called for each place where it is shown, and gives how to end it.
import "../index.js";
import { BrowserView } from "./browser.js";
import { Ended, Kernel, type Model, type Traits } from "./model.js";
import { Panel } from "./panel.js";
import { RemoteView } from "./remote.js";
import { type Events, isSameCamera, type Shown } from "./shown.js";

/** Larger scenes are not sent to a browser that nobody asked to trace them. */
const MOST_BYTES = 1 << 26;
/** Between two cameras that the kernel is told, milliseconds. */
const PERIOD = 60;

function canTrace(): boolean {
  return typeof WebAssembly === "object" && typeof Worker === "function" && typeof customElements === "object";
}

class WidgetView {
  readonly #kernel: Kernel;
  readonly #stage = document.createElement("div");
  readonly #tracer = document.createElement("span");
  readonly #panel: Panel;
  readonly #heard: [string, () => void][] = [];
  #shown: Shown | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** What the page said last. */
  #camera: number[] = [];

  constructor(
    private readonly model: Model,
    place: HTMLElement,
  ) {
    this.#kernel = new Kernel(model);
    place.classList.add("voxtrace");
    // Else JupyterLab takes keys of sliders and of the picture for its cells; it asks the element that has the focus alone.
    place.addEventListener("focusin", ({ target }) => (target as HTMLElement).setAttribute("data-lm-suppress-shortcuts", "true"));
    this.#stage.className = "voxtrace-stage";
    this.#stage.style.height = `${model.get("height")}px`;
    const line = document.createElement("div");
    line.className = "voxtrace-line";
    this.#panel = new Panel(model, line);
    this.#tracer.className = "voxtrace-tracer";
    line.append(this.#tracer);
    place.replaceChildren(this.#stage, line, this.#panel.element);
    this.#on("_camera", () => this.#turn());
    this.#on("_version", () => void this.#load());
    this.#on("renderer", () => this.#begin());
    this.#on("height", () => (this.#stage.style.height = `${model.get("height")}px`));
    for (const name of ["samples", "seed", "max_bounces", "exposure", "tone_map", "clip"] as const) this.#on(name, () => this.#shown?.refresh());
    this.#begin();
  }

  end() {
    clearTimeout(this.#timer);
    for (const [name, heard] of this.#heard) this.model.off(name, heard);
    this.#panel.end();
    this.#shown?.end();
    this.#kernel.end();
  }

  #on(trait: keyof Traits, heard: () => void) {
    this.model.on(`change:${trait}`, heard);
    this.#heard.push([`change:${trait}`, heard]);
  }

  /** Chooses what traces. */
  #begin(isRefused = false) {
    const wanted = this.model.get("renderer");
    const inBrowser = wanted === "browser" || (wanted === "auto" && !isRefused && canTrace() && this.model.get("_about").bytes <= MOST_BYTES);
    this.#shown?.end();
    const tracer = inBrowser ? "traced in this browser" : "traced by the kernel";
    const events: Events = {
      camera: (numbers) => this.#moved(numbers),
      picked: (voxel) => this.model.send({ ask: "picked", picked: voxel }),
      samples: (count) => {
        // What went wrong before is over.
        this.#tracer.textContent = tracer;
        this.#tell({ samples_shown: count });
      },
      failed: (message) => {
        // A page that lets nobody start workers, a worker without memory: the kernel can.
        if (inBrowser && wanted === "auto") this.#begin(true);
        else this.#fail(message);
      },
    };
    this.#shown = inBrowser ? new BrowserView(this.#kernel, events) : new RemoteView(this.#kernel, events);
    this.#tracer.textContent = tracer;
    this.#tell({ tracer: inBrowser ? "browser" : "kernel", samples_shown: 0 });
    this.#stage.replaceChildren(this.#shown.element);
    const camera = this.model.get("_camera");
    if (camera.length > 0) this.#shown.look(camera);
    void this.#load();
  }

  async #load() {
    try {
      await this.#shown?.load();
    } catch (error) {
      if (!(error instanceof Ended)) this.#fail(error instanceof Error ? error.message : String(error));
    }
  }

  #fail(message: string) {
    const said = document.createElement("div");
    said.className = "voxtrace-message";
    said.setAttribute("role", "alert");
    said.textContent = message;
    this.#tracer.replaceChildren(said);
  }

  #tell(traits: Partial<Traits>) {
    for (const [name, value] of Object.entries(traits)) this.model.set(name as "tracer", value as string);
    this.model.save_changes();
  }

  /** Tells the kernel from where one looks, not more often than it can hear. */
  #moved(numbers: number[]) {
    this.#camera = numbers;
    this.#timer ??= setTimeout(() => {
      this.#timer = undefined;
      this.#tell({ _camera: this.#camera });
    }, PERIOD);
  }

  /** Python looks from elsewhere; what this page said itself comes back, too. */
  #turn() {
    const camera = this.model.get("_camera");
    if (camera.length === 0 || this.#timer !== undefined || isSameCamera(camera, this.#camera)) return;
    this.#camera = camera;
    this.#shown?.look(camera);
  }
}

export default {
  render({ model, el }: { model: Model; el: HTMLElement }) {
    const view = new WidgetView(model, el);
    return () => view.end();
  },
};
