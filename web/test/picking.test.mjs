// The voxel that is pressed, the box that is shown, and files that come from the page.
import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";
import { context, count, differences, event, filmOf, native, open, run, setUp } from "./browser.mjs";

setUp();
before(() => run("convert", "city", join(context.files, "city.vox"), "--voxels", "20k"));

const SCENE = { src: "/files/city.vox", samples: "2", seed: "3" };

async function press(page, x, y) {
  const box = await page.locator("voxtrace-viewer").boundingBox();
  await page.mouse.click(box.x + x, box.y + y);
}

test("a press tells the voxel that the picture shows there, and a drag tells none", async () => {
  const page = await open({ ...SCENE, "camera-controls": "" });
  await event(page, "still");
  await press(page, 160, 100);
  const picked = await event(page, "voxel-pick");
  // The same by a ray through that place.
  const [x, y, z] = picked.position;
  const hit = await page.evaluate(async ([x, y, z]) => {
    const viewer = window.viewer;
    const { theta, phi, radius } = viewer.getCameraOrbit();
    const [a, b] = [(theta * Math.PI) / 180, (phi * Math.PI) / 180];
    const offset = [Math.sin(b) * Math.sin(a), -Math.sin(b) * Math.cos(a), Math.cos(b)];
    const eye = viewer.getCameraTarget().map((value, axis) => value + radius * offset[axis]);
    const toward = [x, y, z].map((value, axis) => value - eye[axis]);
    return [...(await viewer.cast(new Float32Array([...eye, 0, ...toward, 2])))];
  }, [x, y, z]);
  assert.deepEqual([hit[1], ...hit.slice(2, 5)], [picked.instance, ...picked.voxel]);
  assert.ok(Math.abs(Math.hypot(...picked.normal) - 1) < 1e-6 && picked.distance > 1 && picked.material >= 0);

  await press(page, 2, 2);
  assert.equal(await event(page, "voxel-pick", 1), null, "the sky");
  await press(page, 180, 130);
  assert.notDeepEqual((await event(page, "voxel-pick", 2)).voxel, picked.voxel);
  const box = await page.locator("voxtrace-viewer").boundingBox();
  await page.mouse.move(box.x + 160, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 190, box.y + 100, { steps: 3 });
  await page.mouse.up();
  await page.keyboard.press("Enter");
  assert.notEqual(await event(page, "voxel-pick", 3), null, "the middle, by a key");
  assert.equal(await count(page, "voxel-pick"), 4);
  await page.close();
});

test("a press on an element that its page shows scaled tells the voxel that is seen there", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  await press(page, 160, 100);
  const { voxel } = await event(page, "voxel-pick");
  await page.evaluate(() => Object.assign(window.viewer.style, { transform: "scale(.5)", transformOrigin: "0 0" }));
  await press(page, 80, 50);
  assert.deepEqual((await event(page, "voxel-pick", 1)).voxel, voxel);
  await page.close();
});

test("a clip box shows what render shows of it, and other text is said to be none", async () => {
  const size = { width: 96, height: 54, samples: 2, seed: 3 };
  const page = await open(SCENE, { width: 96, height: 54 });
  await event(page, "still");
  const whole = (await filmOf(page)).words;
  const [x0, y0, z0, x1, y1, z1] = await page.evaluate(() => window.viewer.scene.bounds);
  const box = [x0, y0, z0, (x0 + x1) / 2, y1, z0 + 6];
  await page.evaluate((box) => (window.viewer.clipBox = box.join(" ")), box);
  await event(page, "still", 1);
  const { words } = await filmOf(page);
  const film = native([join(context.files, "city.vox")], size, ["--clip-box", box.join(",")]);
  assert.equal(differences(words, film), 0);
  assert.ok(differences(words, whole) > 500, "and that is another picture");
  const picked = await page.evaluate(() => window.viewer.pick(10, 40));
  assert.ok(!picked || (picked.position[2] <= z0 + 6.001 && picked.position[0] <= (x0 + x1) / 2 + 0.001));
  const said = [];
  page.on("console", (message) => said.push(message.text()));
  await page.evaluate(() => (window.viewer.clipBox = "1 2 3"));
  await event(page, "still", 2);
  assert.ok(said.some((text) => text.includes('clip-box="1 2 3"')), said.join());
  assert.equal(differences((await filmOf(page)).words, whole), 0);
  await page.close();
});

test("the package's files may come from the page, which then needs no addresses for them", async () => {
  const page = await open({ samples: "1" });
  const asked = context.server.asked.length;
  await page.evaluate(async () => {
    window.names = [];
    window.viewer.files = async (name) => {
      window.names.push(name);
      return new Uint8Array(await (await fetch(`/package/${name}?by=page`)).arrayBuffer());
    };
    window.viewer.src = "/files/city.vox";
  });
  await event(page, "still");
  const names = await page.evaluate(() => window.names.sort());
  assert.deepEqual(names, ["voxtrace-worker.js", "voxtrace.wasm"]);
  assert.equal(context.server.asked.slice(asked).filter((path) => path.startsWith("/package/")).length, 2, "each once, and by nobody else");
  await page.close();
});
