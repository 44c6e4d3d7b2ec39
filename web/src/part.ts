// Parts of pictures as modules take them.
import type { PartRequest } from "./protocol.js";

/** The class of parts of any of the modules. */
interface Parts<P> {
  new (camera: Float32Array, width: number, height: number): P;
}

interface Part {
  y0: number;
  y1: number;
  samples: number;
  seed: number;
  max_bounces: number;
  lens_of: number;
  set_clip(corners: Float32Array): void;
  free(): void;
}

/** The part that is asked for; who calls frees it. */
export function partOf<P extends Part>(parts: Parts<P>, request: PartRequest): P {
  const part = new parts(request.camera, request.width, request.height);
  for (const key of ["y0", "y1", "samples", "seed"] as const) part[key] = request[key];
  part.max_bounces = request.bounces;
  part.lens_of = request.lensOf;
  if (request.clip) part.set_clip(request.clip);
  return part;
}
