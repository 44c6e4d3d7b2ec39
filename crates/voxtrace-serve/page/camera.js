// A camera that turns around a point, as in `<voxtrace-viewer>`: angles in degrees, z up, the front is -y.

const RADIANS = Math.PI / 180;

/** The view of a camera's numbers: eye, target, up, vertical field of view. */
export function viewOf(camera) {
  const target = camera.slice(3, 6);
  const offset = target.map((value, axis) => camera[axis] - value);
  const radius = Math.hypot(...offset) || 1;
  return {
    theta: Math.atan2(offset[0], -offset[1]) / RADIANS,
    phi: Math.acos(Math.max(-1, Math.min(1, offset[2] / radius))) / RADIANS,
    radius,
    target,
    fieldOfView: camera[9],
  };
}

function towardsEye({ theta, phi }) {
  const sin = Math.sin(phi * RADIANS);
  return [sin * Math.sin(theta * RADIANS), -sin * Math.cos(theta * RADIANS), Math.cos(phi * RADIANS)];
}

/** The numbers of a view's camera. */
export function cameraOf(view) {
  const towards = towardsEye(view);
  return [...view.target.map((value, axis) => value + view.radius * towards[axis]), ...view.target, 0, 0, 1, view.fieldOfView];
}

/** A view that turned by so many degrees, to the right and down. */
export function turned(view, right, down) {
  return { ...view, theta: view.theta - right, phi: Math.max(1, Math.min(179, view.phi - down)) };
}

/** A view moved across the picture, by shares of its height: what is at the target goes with the pointer. */
export function panned(view, right, down) {
  const height = 2 * Math.tan((view.fieldOfView * RADIANS) / 2) * view.radius;
  const across = [Math.cos(view.theta * RADIANS), Math.sin(view.theta * RADIANS), 0];
  const [x, y, z] = towardsEye(view);
  const up = [y * across[2] - z * across[1], z * across[0] - x * across[2], x * across[1] - y * across[0]];
  return { ...view, target: view.target.map((value, axis) => value + height * (down * up[axis] - right * across[axis])) };
}

/** A view from so many times as far; `size` is the diagonal of the scene. */
export function zoomed(view, factor, size) {
  return { ...view, radius: Math.max(size * 1e-3, Math.min(size * 10, view.radius * factor)) };
}
