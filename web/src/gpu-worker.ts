// A worker that tells the GPU what to trace: the arrays of one scene, and the input of its pictures.
import { GpuScene, initSync, Part } from "../wasm/gpu.js";
import { partOf } from "./part.js";
import type { GpuArrays } from "./protocol.js";
import { serveCalls } from "./serve.js";

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
});
