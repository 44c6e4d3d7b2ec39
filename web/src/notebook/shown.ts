// What shows a scene in a notebook: the element, which traces in the browser, or pictures of the kernel.
import type { Picked } from "../protocol.js";

/** What a view tells. */
export interface Events {
  /** Somebody looks from elsewhere: the ten numbers of a camera. */
  camera(numbers: number[]): void;
  /** Somebody pressed a voxel, or the sky. */
  picked(voxel: Picked | null): void;
  samples(count: number): void;
  failed(message: string): void;
}

export interface Shown {
  readonly element: HTMLElement;
  /** Shows the scene that the kernel has now. */
  load(): Promise<void>;
  /** Looks by the ten numbers of a camera. */
  look(numbers: number[]): void;
  /** Takes samples, exposure and the like from the model. */
  refresh(): void;
  end(): void;
}

/** Whether two cameras are the same to the eye. */
export function isSameCamera(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  const size = 1e-5 * Math.max(1, ...[0, 1, 2].map((axis) => Math.abs((a[axis] ?? 0) - (a[axis + 3] ?? 0))));
  return a.length === b.length && Array.from(a).every((value, index) => Math.abs(value - b[index]!) <= size);
}
