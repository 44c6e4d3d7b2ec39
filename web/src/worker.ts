// A worker that traces: one scene, one call at a time.
import { format_of, initSync, Part, render_part, selftest, shown, WebScene } from "../wasm/voxtrace.js";
import type { Vector } from "./orbit.js";
import { partOf } from "./part.js";
import type { PartRequest, Picked } from "./protocol.js";
import { infoOf, read } from "./scene.js";
import { serveCalls } from "./serve.js";

let scene: WebScene | undefined;

function loaded(): WebScene {
  if (!scene) throw new Error("no scene was loaded");
  return scene;
}

/** The same bytes, as what pictures are made of. */
function clamped(bytes: Uint8Array): Uint8ClampedArray<ArrayBuffer> {
  return new Uint8ClampedArray(bytes.buffer as ArrayBuffer, bytes.byteOffset, bytes.length);
}

/** What `work` makes of a part of a picture. */
function withPart<T>(request: PartRequest, work: (part: Part) => T): T {
  const part = partOf(Part, request);
  try {
    return work(part);
  } finally {
    part.free();
  }
}

function render(request: PartRequest) {
  const start = performance.now();
  const words = withPart(request, (part) => render_part(loaded(), part, request.words ?? new Uint8Array()));
  const milliseconds = performance.now() - start;
  return { words, shown: clamped(shown(words, request.toneMapping, request.exposure)), milliseconds };
}

function pick(request: PartRequest, x: number, y: number): Picked | undefined {
  const picked = withPart(request, (part) => loaded().pick(part, x, y));
  const [instance, material] = picked;
  if (instance === undefined) return undefined;
  const [voxel, floats] = [new Int32Array(picked.buffer, picked.byteOffset + 8, 3), new Float32Array(picked.buffer, picked.byteOffset + 20, 7)];
  const three = (first: number) => [...floats.slice(first, first + 3)] as Vector;
  return { instance, material: material!, distance: floats[0]!, voxel: [...voxel] as Vector, position: three(1), normal: three(4) };
}

serveCalls({
  start(module) {
    initSync({ module });
  },
  formatOf: format_of,
  load(source) {
    // The last one first: two may be more than there is memory.
    scene?.free();
    scene = undefined;
    scene = read(WebScene, source);
    return infoOf(scene);
  },
  pack: () => loaded().to_bytes(),
  camera: (index, aspect) => loaded().camera(index, aspect),
  render,
  show: (words, toneMapping, exposure) => clamped(shown(words, toneMapping, exposure)),
  cast: (rays, clip) => loaded().cast(rays, clip ?? new Float32Array()),
  pick,
  selftest,
});
