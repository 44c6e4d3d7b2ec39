// The camera of the element and that of the page of `voxtrace serve` turn and move alike.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bundled } from "./bundled.mjs";

const own = await bundled("web/src/orbit.ts");
const served = await bundled("crates/voxtrace-serve/page/camera.js");

const VIEWS = [
  { theta: 0, phi: 90, radius: 1, target: [0, 0, 0], fieldOfView: 45 },
  { theta: 35, phi: 60, radius: 120, target: [10, -20, 5], fieldOfView: 50 },
  { theta: -170, phi: 120, radius: 0.25, target: [-3, 4, 1000], fieldOfView: 12 },
  { theta: 91, phi: 1, radius: 4000, target: [512, 512, 64], fieldOfView: 100 },
];
/** Numbers of one are those of the other, but for what is lost of them in 32 bits. */
function assertNear(a, b, of) {
  const numbers = (given) => (typeof given === "number" ? [given] : [...given]);
  const [left, right] = [numbers(a), numbers(b)];
  assert.equal(left.length, right.length);
  const size = Math.max(1, ...left.map(Math.abs));
  left.forEach((value, at) => assert.ok(Math.abs(value - right[at]) <= 1e-6 * size, `${of}: ${left} and ${right}`));
}
function assertSame(a, b) {
  assert.deepEqual(Object.keys(a).sort(), Object.keys(b).sort());
  for (const key of Object.keys(a)) assertNear(a[key], b[key], key);
}

for (const view of VIEWS) {
  test(`a view from ${view.theta}, ${view.phi} degrees is the same in the element and in the served page`, () => {
    const camera = [...own.cameraOf(view)];
    assertNear(camera, served.cameraOf(view), "camera");
    assertSame(own.viewOf(camera), served.viewOf(camera));
    for (const [right, down] of [[0.25, 0], [0, 0.5], [-0.1, 0.3]]) {
      assertSame(own.panned(view, right, down), served.panned(view, right, down));
      assert.throws(() => assertSame(own.panned(view, right, down), served.panned(view, down, right)), "another movement");
    }
  });
}
