// A worker that tells the GPU what to trace: the arrays of one scene, and the input of its pictures.
import { GpuScene, initSync, Part } from "../wasm/gpu.js";
import { partOf } from "./part.js";
import type { GpuArrays, GpuRealTimeFrames } from "./protocol.js";
import { serveCalls } from "./serve.js";

/** The curves of the shaders by their numbers. */
const CURVES = ["agx", "neutral", "reinhard", "linear"];

let scene: GpuScene | undefined;

function loaded(): GpuScene {
  if (!scene) throw new Error("no scene was loaded");
  return scene;
}

serveCalls({
  start(module) {
    initSync({ module });
  },
  gpuScene(bytes): GpuArrays | undefined {
    scene?.free();
    scene = undefined;
    scene = GpuScene.read(bytes);
    const arrays = scene.arrays();
    if (!arrays) return undefined;
    const { cells, bricks, brick_materials: brickMaterials, records, environment, constants, is_matte: isMatte } = arrays;
    arrays.free();
    return { cells, bricks, brickMaterials, records, environment, constants, isMatte };
  },
  gpuFrame(request) {
    const part = partOf(Part, request);
    try {
      return loaded().frame(part);
    } finally {
      part.free();
    }
  },
  gpuRealTime(request): GpuRealTimeFrames {
    const part = partOf(Part, request);
    try {
      const made = loaded().real_time(part, 2 ** request.exposure, Math.max(CURVES.indexOf(request.toneMapping), 0));
      const { frame, frames, words, reprojects, looks, cells, tracing_cells: tracingCells } = made;
      made.free();
      return { width: request.width, height: request.height, frame, frames, words, reprojects, looks, cells, tracingCells };
    } finally {
      part.free();
    }
  },
});
