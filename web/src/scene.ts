// What workers of all modules do with scenes.
import type { SceneInfo, Source } from "./protocol.js";

/** The class of scenes of any of the modules. */
interface Scenes<S> {
  built_in(name: string, voxels?: number): S;
  read(bytes: Uint8Array, name: string): S;
}

interface Scene {
  readonly name: string;
  readonly voxels: number;
  readonly notes: string[];
  readonly camera_names: string[];
  bounds(): Float32Array;
  content_hash(): string;
}

export function read<S>(scenes: Scenes<S>, source: Source): S {
  return source.kind === "built-in" ? scenes.built_in(source.name, source.voxels) : scenes.read(source.bytes, source.name);
}

export function infoOf(scene: Scene): SceneInfo {
  const { name, voxels, notes, camera_names: cameras } = scene;
  return { name, voxels, notes, cameras, bounds: [...scene.bounds()], hash: scene.content_hash() };
}
