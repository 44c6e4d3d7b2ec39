// A worker that makes scenes for those that trace, and is then ended: its module has the built-in scenes, or the readers of all families of files. It
// is bundled once for each.
import { initSync, WebScene } from "../wasm/scenes.js";
import { serveCalls } from "./serve.js";
import { infoOf, read } from "./scene.js";

let scene: WebScene | undefined;

serveCalls({
  start(module) {
    initSync({ module });
  },
  load(source) {
    scene = read(WebScene, source);
    return infoOf(scene);
  },
  pack() {
    if (!scene) throw new Error("no scene was made");
    return scene.to_bytes();
  },
});
