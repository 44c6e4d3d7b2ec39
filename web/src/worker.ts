// A worker that traces: one scene, one call at a time.
import { format_of, initSync, Part, render_part, selftest, shown, WebScene } from "../wasm/voxtrace.js";
import type { GpuScene } from "./gpu.js";
import type { PartRequest } from "./protocol.js";
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
  const part = new Part(request.camera, request.width, request.height);
  try {
    for (const key of ["y0", "y1", "samples", "seed"] as const) part[key] = request[key];
    part.max_bounces = request.bounces;
    part.lens_of = request.lensOf;
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

function gpuScene(): GpuScene {
  const scene = loaded().gpu_scene();
  try {
    const { cells, bricks, brick_materials: brickMaterials, records, environment, constants, is_matte: isMatte } = scene;
    return { cells, bricks, brickMaterials, records, environment, constants, isMatte };
  } finally {
    scene.free();
  }
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
  cast: (rays) => loaded().cast(rays),
  gpuScene,
  gpuFrame: (request) => withPart(request, (part) => loaded().gpu_frame(part)),
  selftest,
});
