// The package `voxtrace`: importing it defines `<voxtrace-viewer>`.
import { VoxtraceViewer } from "./element.js";

if (globalThis.customElements && !customElements.get("voxtrace-viewer")) customElements.define("voxtrace-viewer", VoxtraceViewer);

export { VoxtraceViewer };
export type { FilmWords } from "./element.js";
export type { Orbit, Vector } from "./orbit.js";
export type { Files } from "./pool.js";
export type { Picked, SceneInfo } from "./protocol.js";
export type { Detail } from "./streaming.js";
