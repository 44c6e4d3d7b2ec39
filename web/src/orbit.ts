// A camera that turns around a point: angles as in model-viewer, in a world whose z is up and whose front is -y. Attributes are read here.

import type { Look } from "./detail.js";

export type Vector = [number, number, number];

const RADIANS = Math.PI / 180;
/** How near to straight up and down views come, degrees. */
const POLE = 1;

/** Azimuth from the front to the right and angle from straight up, degrees; distance from the target, world units. */
export interface Orbit {
  theta: number;
  phi: number;
  radius: number;
}

export interface View extends Orbit {
  target: Vector;
  fieldOfView: number;
}

const minus = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** The view of a camera's numbers: eye, target, up, field of view. */
export function viewOf(camera: ArrayLike<number>): View {
  const at = (index: number): Vector => [camera[index]!, camera[index + 1]!, camera[index + 2]!];
  const offset = minus(at(0), at(3));
  const radius = Math.hypot(...offset) || 1;
  const phi = Math.acos(Math.max(-1, Math.min(1, offset[2] / radius))) / RADIANS;
  return { theta: Math.atan2(offset[0], -offset[1]) / RADIANS, phi, radius, target: at(3), fieldOfView: camera[9]! };
}

/** Unit vector from the target to the eye. */
export function towardsEye({ theta, phi }: Orbit): Vector {
  const [sin, cos] = [Math.sin(phi * RADIANS), Math.cos(phi * RADIANS)];
  return [sin * Math.sin(theta * RADIANS), -sin * Math.cos(theta * RADIANS), cos];
}

/** The numbers of a view's camera. */
export function cameraOf(view: View): Float32Array {
  const towards = towardsEye(view);
  const eye = view.target.map((value, axis) => value + view.radius * towards[axis]!);
  return new Float32Array([...eye, ...view.target, 0, 0, 1, view.fieldOfView]);
}

/** What a camera's numbers mean for what it needs of a scene. */
export function lookOf(camera: ArrayLike<number>, { width, height }: { width: number; height: number }): Look {
  const at = (index: number): Vector => [camera[index]!, camera[index + 1]!, camera[index + 2]!];
  return { eye: at(0), target: at(3), field: camera[9]! * RADIANS, aspect: width / height, height };
}

/** A view within what can be looked at; `size` is the diagonal of the scene. */
export function within(view: View, size: number): View {
  return {
    ...view,
    theta: ((((view.theta + 180) % 360) + 360) % 360) - 180,
    phi: Math.max(POLE, Math.min(180 - POLE, view.phi)),
    radius: Math.max(size * 1e-3, Math.min(size * 10, view.radius)),
    fieldOfView: Math.max(1, Math.min(170, view.fieldOfView)),
  };
}

/** A view moved across the picture, by shares of its height: what is at the target goes with the pointer. */
export function panned(view: View, right: number, down: number): View {
  const height = 2 * Math.tan((view.fieldOfView * RADIANS) / 2) * view.radius;
  const [sin, cos] = [Math.sin(view.theta * RADIANS), Math.cos(view.theta * RADIANS)];
  const across: Vector = [cos, sin, 0];
  const towards = towardsEye(view);
  // Up is at right angles to both: the picture's.
  const up: Vector = [
    towards[1] * across[2] - towards[2] * across[1],
    towards[2] * across[0] - towards[0] * across[2],
    towards[0] * across[1] - towards[1] * across[0],
  ];
  const target = view.target.map((value, axis) => value + height * (down * up[axis]! - right * across[axis]!));
  return { ...view, target: target as Vector };
}

function angle(text: string): number | undefined {
  const match = /^([-+]?[\d.]+(?:e[-+]?\d+)?)(deg|rad)?$/i.exec(text);
  if (!match) return undefined;
  const value = Number(match[1]) / (match[2]?.toLowerCase() === "rad" ? RADIANS : 1);
  return Number.isFinite(value) ? value : undefined;
}

function length(text: string, whole: number): number | undefined {
  const match = /^([\d.]+(?:e[-+]?\d+)?)(%|m)?$/i.exec(text);
  if (!match) return undefined;
  const value = Number(match[1]) * (match[2] === "%" ? whole / 100 : 1);
  return value > 0 && Number.isFinite(value) ? value : undefined;
}

/** An orbit as text, `THETA PHI RADIUS`; what is `auto` or missing is that of `start`. Radii in percent are shares of its radius. `undefined` for other text. */
export function parseOrbit(text: string, start: Orbit): Orbit | undefined {
  const [theta, phi, radius, ...rest] = text.trim().split(/\s+/);
  const part = (given: string | undefined, own: number, parsed: (given: string) => number | undefined) =>
    given === undefined || given === "" || given === "auto" ? own : parsed(given);
  const orbit = {
    theta: part(theta, start.theta, angle),
    phi: part(phi, start.phi, angle),
    radius: part(radius, start.radius, (given) => length(given, start.radius)),
  };
  const isWhole = rest.length === 0 && Object.values(orbit).every((value) => value !== undefined);
  return isWhole ? (orbit as Orbit) : undefined;
}

/** Whether text leaves it to the scene. */
const isAuto = (text: string) => ["auto", ""].includes(text.trim());

/** A place as text, `X Y Z` in world units, `auto` for that of `start`. */
export function parseTarget(text: string, start: Vector): Vector | undefined {
  if (isAuto(text)) return start;
  const target = text.trim().split(/\s+/).map((part, axis) => (part === "auto" ? start[axis]! : Number(part.replace(/m$/, ""))));
  return target.length === 3 && target.every(Number.isFinite) ? (target as Vector) : undefined;
}

/** A box as text, `X Y Z X Y Z`: its lowest corner, and its highest one, which is above it along every axis; no numbers for `auto`. `undefined` for other text. */
export function parseBox(text: string): Float32Array | undefined {
  if (isAuto(text)) return new Float32Array();
  const box = new Float32Array(text.trim().split(/[\s,]+/).map(Number));
  const isSound = box.length === 6 && box.every(Number.isFinite) && [0, 1, 2].every((axis) => box[axis]! < box[axis + 3]!);
  return isSound ? box : undefined;
}

/** A field of view as text, degrees up and down. */
export function parseFieldOfView(text: string, start: number): number | undefined {
  return isAuto(text) ? start : angle(text.trim());
}

/** An orbit as text. */
export function orbitText({ theta, phi, radius }: Orbit): string {
  const short = (value: number) => String(Number(value.toPrecision(7)));
  return `${short(theta)}deg ${short(phi)}deg ${short(radius)}m`;
}

/** Where one looks from, in words, for people who do not see it. */
export function orbitWords({ theta, phi }: Orbit): string {
  const sides = ["the front", "the front right", "the right", "the back right", "the back", "the back left", "the left", "the front left"];
  const side = sides[((Math.round(theta / 45) % 8) + 8) % 8]!;
  const height = Math.round(90 - phi);
  return `View from ${side}, ${height === 0 ? "level" : `${Math.abs(height)} degrees ${height > 0 ? "above" : "below"}`}`;
}
