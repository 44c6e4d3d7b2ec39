// The attributes of the element as properties, each with its usual value and its bounds.
import { defaultThreads } from "./pool.js";

// Where pages are rendered on a server there are no elements; the import does no harm there.
const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

export abstract class Attributes extends Base {
  static readonly observedAttributes = [
    "src", "alt", "poster", "loading", "reveal", "tracer", "camera-controls", "camera-orbit", "camera-target", "field-of-view", "clip-box",
    "auto-rotate", "exposure", "tone-mapping", "samples", "seed", "max-bounces", "max-pixels", "real-time",
  ];

  /** What is shown: the address of a file, or `scene:NAME?voxels=COUNT`. */
  get src() { return this.getAttribute("src") ?? ""; }
  set src(value: string) { this.setAttribute("src", value); }
  /** What it is, for people who do not see it. */
  get alt() { return this.getAttribute("alt") ?? ""; }
  set alt(value: string) { this.setAttribute("alt", value); }
  /** Address of a picture that is shown until there is one. */
  get poster() { return this.getAttribute("poster") ?? ""; }
  set poster(value: string) { this.setAttribute("poster", value); }
  /** When the scene is loaded: `auto` and `eager` at once, `lazy` when the element is in view. */
  get loading() { return (this.getAttribute("loading") ?? "auto") as "auto" | "lazy" | "eager"; }
  set loading(value: "auto" | "lazy" | "eager") { this.setAttribute("loading", value); }
  /** When the poster goes: `auto` with the first picture, `interaction` when a person presses it, `manual` by `dismissPoster()`. */
  get reveal() { return (this.getAttribute("reveal") ?? "auto") as "auto" | "interaction" | "manual"; }
  set reveal(value: "auto" | "interaction" | "manual") { this.setAttribute("reveal", value); }
  /** Whether mouse, touch and keys move the camera. */
  get cameraControls() { return this.hasAttribute("camera-controls"); }
  set cameraControls(value: boolean) { this.toggleAttribute("camera-controls", value); }
  /** Where the camera is around its target: `THETA PHI RADIUS`, for example `30deg 75deg 120%`; `auto` for the scene's own. */
  get cameraOrbit() { return this.getAttribute("camera-orbit") ?? "auto"; }
  set cameraOrbit(value: string) { this.setAttribute("camera-orbit", value); }
  /** What the camera looks at: `X Y Z` in world units; `auto` for the scene's own. */
  get cameraTarget() { return this.getAttribute("camera-target") ?? "auto"; }
  set cameraTarget(value: string) { this.setAttribute("camera-target", value); }
  /** Vertical field of view, for example `45deg`; `auto` for the scene's own. */
  get fieldOfView() { return this.getAttribute("field-of-view") ?? "auto"; }
  set fieldOfView(value: string) { this.setAttribute("field-of-view", value); }
  /** The box within which the scene is shown: `X Y Z X Y Z` in world units, its lowest corner and its highest one; `auto` for all of it. */
  get clipBox() { return this.getAttribute("clip-box") ?? "auto"; }
  set clipBox(value: string) { this.setAttribute("clip-box", value); }
  /** Whether the camera goes around by itself; never where a person prefers less motion. */
  get autoRotate() { return this.hasAttribute("auto-rotate"); }
  set autoRotate(value: boolean) { this.toggleAttribute("auto-rotate", value); }
  /** Whether files that are dropped are the page's. */
  get noDrop() { return this.hasAttribute("no-drop"); }
  set noDrop(value: boolean) { this.toggleAttribute("no-drop", value); }
  /** What is shown while the view moves: `auto`, where the GPU traces, real-time light; `off`, coarse pictures. */
  get realTime() { return (this.getAttribute("real-time") === "off" ? "off" : "auto") as "auto" | "off"; }
  set realTime(value: "auto" | "off") { this.setAttribute("real-time", value); }
  /** Exposure in stops. */
  get exposure() { return this.number("exposure", 0, -30, 30); }
  set exposure(value: number) { this.setAttribute("exposure", String(value)); }
  /** The curve from radiance to the screen: `agx`, `neutral`, `reinhard`, `linear`. */
  get toneMapping() { return this.getAttribute("tone-mapping") ?? "agx"; }
  set toneMapping(value: string) { this.setAttribute("tone-mapping", value); }
  /** Samples of each pixel of a picture that stands still. */
  get samples() { return Math.round(this.number("samples", 64, 1, 65_536)); }
  set samples(value: number) { this.setAttribute("samples", String(value)); }
  /** Seed of the random numbers: the same one gives the same picture, to the bit. */
  get seed() { return Math.round(this.number("seed", 0, 0, 2 ** 32 - 1)); }
  set seed(value: number) { this.setAttribute("seed", String(value)); }
  /** Most surfaces that scatter one path. */
  get maxBounces() { return Math.round(this.number("max-bounces", 8, 0, 255)); }
  set maxBounces(value: number) { this.setAttribute("max-bounces", String(value)); }
  /** Who traces: `auto`, the GPU where the browser has WebGPU for one, else workers on the processor; `gpu`, also where WebGPU is software; `cpu`. */
  get tracer() {
    const text = this.getAttribute("tracer");
    return text === "gpu" || text === "cpu" ? text : "auto";
  }
  set tracer(value: "auto" | "gpu" | "cpu") { this.setAttribute("tracer", value); }
  /** Workers, each with its own copy of the scene. */
  get threads() { return Math.round(this.number("threads", defaultThreads(), 1, 64)); }
  set threads(value: number) { this.setAttribute("threads", String(value)); }
  /** Megabytes that a file for streaming may take, all workers together. */
  get maxMemory() { return this.number("max-memory", 1024, 4, 65_536); }
  set maxMemory(value: number) { this.setAttribute("max-memory", String(value)); }
  /** Most pixels of a picture; larger elements show it scaled. */
  get maxPixels() { return this.number("max-pixels", 1280 * 720, 1, 2 ** 26); }
  set maxPixels(value: number) { this.setAttribute("max-pixels", String(value)); }

  /** The number of an attribute within bounds; the usual one where it has none. */
  protected number(name: string, usual: number, least: number, most: number): number {
    const text = this.getAttribute(name);
    const value = text === null || text.trim() === "" ? NaN : Number(text);
    return Number.isFinite(value) ? Math.max(least, Math.min(most, value)) : usual;
  }
}
