// Real-time light in Chromium's software WebGPU: its pictures are those of this machine's processor, and what follows it is the film.
import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { execFileSync } from "node:child_process";
import { build } from "esbuild";
import { comes, context, differences, event, filmOf, native, openWebGpu, pictures, run, setAttributes, setUpWebGpu, skipsWebGpu, web, words } from "./browser.mjs";
import { fileOfMaterials } from "./materials.mjs";
import { serve } from "./server.mjs";

const size = { width: 64, height: 36 };
/** What the viewer said in the console. */
const said = (page) => page.said.filter((text) => text.startsWith("voxtrace-viewer")).join("\n");
let folder;
let parts;

setUpWebGpu();
before(async () => {
  // The package with the parts of the element in a bundle of their own, so that a test says which pictures are made, and how many.
  folder = mkdtempSync(join(tmpdir(), "voxtrace-real-time-"));
  for (const file of readdirSync(join(web, "dist"))) if (/\.(js|wasm|wgsl)$/.test(file)) copyFileSync(join(web, "dist", file), join(folder, file));
  await build({ entryPoints: { parts: join(web, "src/pool.ts") }, bundle: true, format: "esm", target: "es2022", outdir: folder, logLevel: "warning" });
  parts = await serve({ "/parts/": folder, "/files/": context.files, "/test/": join(web, "test") });
});
after(() => {
  parts?.end();
  if (folder) rmSync(folder, { recursive: true, force: true });
});

/** A page that shows views of a native file by `pool.gpu`, and pictures of them. */
async function picturesOf(file, cameras, seed) {
  const page = await context.browser.newPage();
  page.setDefaultTimeout(400_000);
  await page.goto(`${parts.address}/test/page.html`);
  const shown = await page.evaluate(async ([name, cameras, seed, size]) => {
    const { Pool } = await import("/parts/parts.js");
    const pool = new Pool(() => {});
    const bytes = new Uint8Array(await (await fetch(`/files/${name}`)).arrayBuffer());
    await pool.load({ kind: "file", name, bytes }, 1, "gpu");
    if (!pool.gpu) throw new Error("the GPU does not trace");
    const made = [];
    for (const camera of cameras) {
      const part = { camera: new Float32Array(camera), lensOf: -1, ...size, y0: 0, y1: size.height, samples: 1, seed, bounces: 8, toneMapping: "agx", exposure: 0 };
      let picture;
      while (!picture) {
        picture = await pool.gpu.showRealTime(part);
        if (!picture) await new Promise((done) => setTimeout(done, 100));
        if (pool.gpu.mostRealTimePixels === 0 || performance.now() > 400_000) throw new Error("there is no real-time light");
      }
      made.push([...picture.shown]);
    }
    pool.end();
    return made;
  }, [file, cameras, seed, size]);
  await page.close();
  return shown.map((bytes) => bytes.filter((_, at) => at % 4 !== 3));
}

/** The same by the processor. */
function expectedOf(file, cameras, seed) {
  const out = join(context.files, "expected");
  const given = ["real-time", join(context.files, file), `${size.width}x${size.height}`, String(seed), out, ...cameras.map((camera) => camera.join(","))];
  execFileSync(words, given);
  const bytes = readFileSync(out);
  const each = size.width * size.height * 3;
  return cameras.map((_, number) => [...bytes.subarray(number * each, (number + 1) * each)]);
}

/** PSNR of two pictures, dB. */
function psnr(a, b) {
  assert.equal(a.length, b.length);
  const square = a.reduce((sum, value, at) => sum + (value - b[at]) ** 2, 0) / a.length;
  return -10 * Math.log10(Math.max(square, 1e-6) / 255 ** 2);
}

/** Writes a picture that people look at. */
function write(name, bytes) {
  const header = Buffer.from(`P6 ${size.width} ${size.height} 255\n`);
  writeFileSync(join(pictures, `${name}.ppm`), Buffer.concat([header, Buffer.from(bytes)]));
}

/** Eye, target, up and field of view of the scene's first camera, and the same from aside, again and again. */
const aside = ([x, y, z, ...rest], by) => [x + by, y - by / 2, z + by / 3, ...rest];

const SCENES = {
  "the city": { prepare: (file) => run("convert", "city", file, "--voxels", "20k"), camera: [60, -70, 40, 20, 20, 8, 0, 0, 1, 45], step: 1 },
  "instances in a forest": { prepare: (file) => run("convert", "forest", file, "--instances", "100"), camera: [0, -60, 40, 0, 0, 10, 0, 0, 1, 50], step: 1 },
  "all materials": {
    prepare: (file) => {
      const vox = join(context.files, "materials.vox");
      writeFileSync(vox, fileOfMaterials());
      run("convert", vox, file);
    },
    camera: [10, -28, 24, 12, 12, 2, 0, 0, 1, 50],
    step: 0.5,
  },
};
for (const [name, { prepare, camera, step }] of Object.entries(SCENES)) {
  test(`pictures of ${name} in real-time light are those of the processor`, async (t) => {
    if (skipsWebGpu(t)) return;
    const file = "scene.vxt";
    prepare(join(context.files, file));
    // Three that stand still, two that move, one that jumps.
    const cameras = [0, 0, 0, 1, 2, 40].map((number) => aside(camera, step * number));
    const [made, expected] = [await picturesOf(file, cameras, 7), expectedOf(file, cameras, 7)];
    made.forEach((bytes, number) => write(`real-time-${name.replaceAll(" ", "-")}-${number}`, bytes));
    expected.forEach((bytes, number) => write(`real-time-${name.replaceAll(" ", "-")}-${number}-expected`, bytes));
    const found = made.map((bytes, number) => psnr(bytes, expected[number]));
    t.diagnostic(`dB: ${found.map((db) => db.toFixed(1)).join(" ")}`);
    assert.ok(Math.min(...found) >= 60, `dB: ${found.map((db) => db.toFixed(1)).join(" ")}`);
    // Planted faults: pictures of another seed, and of the frame before.
    const other = expectedOf(file, cameras, 8).map((bytes, number) => psnr(made[number], bytes));
    assert.ok(other.every((db, number) => db < found[number] - 6), `another seed: ${other.map((db) => db.toFixed(1)).join(" ")}`);
    for (let number = 1; number < made.length; number++) assert.ok(psnr(made[number - 1], expected[number]) < found[number] - 6, `the picture before ${number}`);
  });
}

/** A page with an element whose devices and console the test sees, and what was compiled. */
async function watched(attributes, prepare = () => {}) {
  const page = await openWebGpu(size, 400_000);
  await page.evaluate(() => {
    window.compiled = [];
    const create = GPUDevice.prototype.createComputePipelineAsync;
    GPUDevice.prototype.createComputePipelineAsync = function (given) {
      window.compiled.push(given.compute.entryPoint);
      return create.call(this, given);
    };
    // The view turns until it is told to stop, and each picture of it is looked at when it is drawn.
    window.turn = (degrees) => (window.viewer.cameraOrbit = `${degrees}deg 60deg 110%`);
    window.pixels = () => {
      const canvas = window.viewer.shadowRoot.querySelector("canvas");
      return [...canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data].filter((_, at) => at % 4 !== 3);
    };
    /** Turns to and fro until real-time light is shown; then stays, and gives what is on the canvas. */
    window.lit = async (degrees) => {
      for (let step = 1; performance.now() < 600_000; step++) {
        window.turn(degrees + (step % 2));
        await new Promise((done) => setTimeout(done, 50));
        if (window.viewer.showsRealTime && step % 2 === 0) return window.pixels();
      }
      throw new Error("no real-time light is shown");
    };
  });
  await page.evaluate(prepare);
  await setAttributes(page, attributes);
  return page;
}

const asked = { tracer: "gpu", samples: "4", seed: "7", "max-pixels": String(64 * 36), "camera-controls": "" };
const pixels = (page) => page.evaluate(() => window.pixels());

/** The film of a view by an element with other attributes, and what is on the canvas then. */
async function still(page, degrees, attributes = {}) {
  await page.evaluate(([degrees, attributes]) => {
    window.events.length = 0;
    for (const [name, value] of Object.entries(attributes)) window.viewer.setAttribute(name, value);
    window.turn(degrees + 1);
    window.turn(degrees);
  }, [degrees, attributes]);
  await event(page, "still");
  return { film: await filmOf(page), pixels: await pixels(page) };
}

test("a view that moves is in real-time light; where it stands the film follows, which knows nothing of it", async (t) => {
  if (skipsWebGpu(t)) return;
  run("convert", "city", join(context.files, "moving.vxt"), "--voxels", "20k");
  const page = await watched({ ...asked, src: "/files/moving.vxt" });
  await event(page, "still");
  const lit = await page.evaluate(() => window.lit(30));
  assert.equal(await page.evaluate(() => window.viewer.activeTracer), "gpu");
  const after = await still(page, 30);
  const coarse = await still(page, 30, { "real-time": "off" });
  assert.equal(await page.evaluate(() => window.viewer.showsRealTime), false);
  // With what was seen through it before, a film has the words and, at its end, the pixels that it has without.
  assert.equal(differences(after.film.words, coarse.film.words), 0);
  assert.deepEqual(after.pixels, coarse.pixels);
  // It is a picture of this view, though one of fewer pixels on a slow device, and not of the view from behind.
  const [here, behind] = [psnr(lit, after.pixels), psnr(lit, (await still(page, 210)).pixels)];
  t.diagnostic(`${here.toFixed(1)} dB from the film of this view, ${behind.toFixed(1)} from that of another`);
  assert.ok(here > behind + 2);
  assert.equal(said(page), "");
  assert.deepEqual(page.errors, []);

  // A device that is lost while it moves is made again, and so is real-time light.
  await page.evaluate(() => void (window.devices.at(-1).destroy(), window.viewer.setAttribute("real-time", "auto")));
  await page.evaluate(() => window.lit(40));
  assert.equal(await page.evaluate(() => window.devices.length), 2);
  assert.match(said(page), /^voxtrace-viewer: the GPU is started again: [^\n]*$/);
  assert.equal(await page.evaluate(() => window.events.filter(({ name }) => name === "error").length), 0);
  const again = await still(page, 30, { samples: "4" });
  assert.equal(differences(again.film.words, after.film.words), 0);
  await page.close();
});

test("where its shaders do not compile, and where it is not wanted, views that move are coarse and films the same", async (t) => {
  if (skipsWebGpu(t)) return;
  run("convert", "city", join(context.files, "coarse.vxt"), "--voxels", "20k");
  const broken = () => {
    const create = GPUDevice.prototype.createShaderModule;
    GPUDevice.prototype.createShaderModule = function ({ code }) {
      return create.call(this, { code: code.includes("fn begin_looks") ? `${code}\nfn broken() -> f32 { return; }` : code });
    };
  };
  const expected = native([join(context.files, "coarse.vxt")], { ...size, samples: 4, seed: 7 });
  for (const [attributes, prepare, says] of [
    [{}, broken, /what moves is shown coarsely, as real-time light is of no use here: the shaders do not compile/],
    [{ "real-time": "off" }, () => {}, /^$/],
  ]) {
    const page = await watched({ ...asked, ...attributes, src: "/files/coarse.vxt" }, prepare);
    await event(page, "still");
    assert.equal(differences((await filmOf(page)).words, expected), 0);
    for (let turn = 0; turn < 20; turn++) {
      await page.evaluate((turn) => window.turn(3 * turn), turn);
      await page.waitForTimeout(50);
      assert.equal(await page.evaluate(() => window.viewer.showsRealTime), false);
      if (!attributes["real-time"] && said(page)) break;
    }
    await page.waitForFunction((wanted) => !wanted || window.compiled.includes("begin_looks"), !attributes["real-time"]);
    if (!attributes["real-time"]) await comes(() => said(page));
    assert.match(said(page), says);
    // Nobody compiles what is not wanted.
    assert.equal(await page.evaluate(() => window.compiled.includes("begin_looks")), !attributes["real-time"]);
    assert.equal(await page.evaluate(() => window.viewer.activeTracer), "gpu");
    await page.close();
  }
});
