// The element `<voxtrace-viewer>` in a notebook: its files and the scene come from the kernel, by messages, so that no server is asked for them.
import type { VoxtraceViewer } from "../element.js";
import { cameraOf, orbitText, type View, viewOf } from "../orbit.js";
import type { Picked } from "../protocol.js";
import { type Kernel, bytesOf } from "./model.js";
import type { Events, Shown } from "./shown.js";

export class BrowserView implements Shown {
  readonly element: VoxtraceViewer;
  #loads = 0;

  constructor(
    private readonly kernel: Kernel,
    events: Events,
  ) {
    const viewer = (this.element = document.createElement("voxtrace-viewer"));
    viewer.cameraControls = true;
    viewer.setAttribute("no-drop", "");
    viewer.files = (name) => kernel.file(name);
    const poster = bytesOf(kernel.model.get("_poster"));
    if (poster.length > 0) viewer.poster = URL.createObjectURL(new Blob([poster]));
    this.refresh();
    viewer.addEventListener("camera-change", () => {
      const view = this.#view();
      if (view) events.camera([...cameraOf(view)]);
    });
    viewer.addEventListener("voxel-pick", (event) => events.picked((event as CustomEvent<Picked | null>).detail));
    viewer.addEventListener("still", (event) => events.samples((event as CustomEvent<{ samples: number }>).detail.samples));
    viewer.addEventListener("error", (event) => events.failed((event as unknown as CustomEvent<{ message: string }>).detail.message));
  }

  async load() {
    const { name } = this.kernel.model.get("_about");
    const load = ++this.#loads;
    const bytes = await this.kernel.scene();
    if (load !== this.#loads) return;
    const view = this.#view();
    // Another scene is seen from where the last one was.
    if (view) this.#lookAs(view);
    await this.element.show(new File([bytes], `${name || "scene"}.vxt`));
  }

  look(numbers: number[]) {
    this.#lookAs(viewOf(numbers));
  }

  refresh() {
    const { model } = this.kernel;
    const clip = model.get("clip");
    const wanted = {
      alt: model.get("_about").name,
      samples: String(model.get("samples")),
      seed: String(model.get("seed")),
      "max-bounces": String(model.get("max_bounces")),
      exposure: String(model.get("exposure")),
      "tone-mapping": model.get("tone_map"),
      "clip-box": clip ? clip.flat().join(" ") : "auto",
    };
    for (const [name, value] of Object.entries(wanted)) {
      if (this.element.getAttribute(name) !== value) this.element.setAttribute(name, value);
    }
  }

  end() {
    // A scene that is still on its way is for nobody.
    this.#loads++;
    if (this.element.poster) URL.revokeObjectURL(this.element.poster);
    this.element.remove();
  }

  #view(): View | undefined {
    const [orbit, target, fieldOfView] = [this.element.getCameraOrbit(), this.element.getCameraTarget(), this.element.getFieldOfView()];
    return orbit && target && fieldOfView !== undefined ? { ...orbit, target, fieldOfView } : undefined;
  }

  #lookAs(view: View) {
    this.element.cameraTarget = view.target.join(" ");
    this.element.fieldOfView = `${view.fieldOfView}deg`;
    this.element.cameraOrbit = orbitText(view);
  }
}
