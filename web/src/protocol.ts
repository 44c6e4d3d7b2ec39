// What pages ask workers for, and what they answer.
import type { Vector } from "./orbit.js";
import type { Detail } from "./streaming.js";

/** Where a scene comes from. */
export type Source = { kind: "built-in"; name: string; voxels?: number } | { kind: "file"; name: string; bytes: Uint8Array };

/** What is known of a scene. Places are in world units, which are voxels of most scenes; z is up. */
export interface SceneInfo {
  name: string;
  voxels: number;
  /** What the reader left out or put up with. */
  notes: string[];
  cameras: string[];
  /** The least corner of the box around all voxels, then the largest. */
  bounds: number[];
  /** A hash of everything that a picture of the scene depends on. */
  hash: string;
  /** Of a file for streaming: how fine what is shown is. */
  detail?: Detail;
}

/** Some rows of a picture, and the samples that each of their pixels has afterwards. */
export interface PartRequest {
  /** Eye, target, up (three numbers each) and the vertical field of view in degrees. */
  camera: Float32Array;
  /** Number of the scene's camera whose lens it has. */
  lensOf: number;
  width: number;
  height: number;
  y0: number;
  y1: number;
  samples: number;
  seed: number;
  bounces: number;
  /** Only what is within this box is shown, world units: its lowest corner, then its highest one. */
  clip?: Float32Array;
  /** Words of the film of these rows so far, 32 bytes a pixel; none for a black film. */
  words?: Uint8Array;
  toneMapping: string;
  exposure: number;
}

/** Rows with their samples: words of the film, and what a screen shows of them. */
export interface PartAnswer {
  words: Uint8Array;
  shown: Uint8ClampedArray<ArrayBuffer>;
  /** What the samples took. */
  milliseconds: number;
  /** Whether a GPU traced them. */
  isOfGpu?: boolean;
}

/** A voxel that a picture shows at some place. */
export interface Picked {
  /** Number of the instance in the scene. */
  instance: number;
  /** Number of its material in the scene. */
  material: number;
  /** Where it is in the grid of the instance. */
  voxel: Vector;
  /** The place on its face, and the normal there: world units. */
  position: Vector;
  normal: Vector;
  /** From the camera, world units. */
  distance: number;
}

/** The arrays of a scene for the GPU, and what its shaders are specialized with: number, value, number, value. */
export interface GpuArrays {
  cells: Uint32Array;
  bricks: Uint32Array;
  brickMaterials: Uint32Array;
  records: Uint32Array;
  environment: Uint32Array;
  constants: Uint32Array;
  /** Whether everything is matte, so that the shorter shaders will do. */
  isMatte: boolean;
}

/** A picture in real-time light as the GPU is told of it: one frame, or several where it is the first one of a view. */
export interface GpuRealTimeFrames {
  width: number;
  height: number;
  /** The record of the frame, and behind it the numbers of its lens and its sky. */
  frame: Uint32Array;
  /** The records of real-time light, of so many words, one after the other. */
  frames: Uint32Array;
  words: number;
  /** For each of them, whether light is found again where the camera moved. */
  reprojects: Uint8Array;
  /** For each of them, how many rays of a pixel only look, at most, and the number before that of the first one. */
  looks: Uint32Array;
  /** Cells of the light cache, and how many of them may trace. */
  cells: number;
  tracingCells: number;
}

/** The calls of a worker by their names. */
export interface Calls {
  start(module: WebAssembly.Module): void;
  /** The name of a file's format by its first bytes, length and name, if this module reads it. */
  formatOf(head: Uint8Array, length: number, name: string): string | undefined;
  load(source: Source): SceneInfo;
  /** The scene as bytes of a native file, for other workers. */
  pack(): Uint8Array;
  camera(index: number, aspect: number): Float32Array;
  render(part: PartRequest): PartAnswer;
  show(words: Uint8Array, toneMapping: string, exposure: number): Uint8ClampedArray<ArrayBuffer>;
  cast(rays: Float32Array, clip?: Float32Array): Uint32Array;
  /** What a picture shows at a place, in its pixels from the upper left corner. */
  pick(part: PartRequest, x: number, y: number): Picked | undefined;
  /** A scene, packed, as the GPU reads it; `undefined` where its shaders do not know all of it. */
  gpuScene(bytes: Uint8Array): GpuArrays | undefined;
  /** What the GPU is told of a part of a picture, and behind it the numbers of its lens and its sky. */
  gpuFrame(part: PartRequest): Uint32Array;
  /** What the GPU is told of the next picture in real-time light. Who asks has it traced: the one after it goes on from there. */
  gpuRealTime(part: PartRequest): GpuRealTimeFrames;
  selftest(edge: number): string[];
}

export type Name = keyof Calls;
export type Request = { id: number; name: Name; given: unknown[] };
export type Answer = { id: number; made: unknown } | { id: number; error: string; isFatal: boolean };
