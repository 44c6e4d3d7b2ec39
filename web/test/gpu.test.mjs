// The GPU tier in Chromium's software WebGPU: films are those of this machine, word by word; and what happens where WebGPU goes away or never was.
import assert from "node:assert/strict";
import { copyFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { context, differences, event, filmOf, native, open, pictures, real, run, setUp, WEBGPU } from "./browser.mjs";

setUp(WEBGPU);
const size = { width: 96, height: 54, samples: 4 };
const asked = { tracer: "gpu", samples: "4", seed: "7", "max-pixels": String(96 * 54) };
let has;
let page;

/** A page whose console and whose devices the test sees. */
async function watched(attributes, options) {
  const page = await open({}, { ...size, ...options });
  page.said = [];
  page.on("console", (message) => page.said.push(message.text()));
  // Compiling takes a while on the processor.
  page.setDefaultTimeout(240_000);
  await page.evaluate(() => {
    window.devices = [];
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (...given) {
      const device = await request.apply(this, given);
      window.devices.push(device);
      return device;
    };
  });
  await page.evaluate((attributes) => {
    for (const [name, value] of Object.entries(attributes)) window.viewer.setAttribute(name, value);
  }, attributes);
  return page;
}

/** Another scene on the page, and its film. */
async function filmOfScene(src) {
  await page.evaluate((src) => {
    window.events.length = 0;
    window.viewer.setAttribute("src", src);
  }, src);
  await event(page, "still");
  assert.equal(await page.evaluate(() => window.viewer.activeTracer), "gpu");
  assert.deepEqual(page.said, []);
  return filmOf(page);
}

before(async () => {
  const probe = await context.browser.newPage();
  await probe.goto(`${context.server.address}/test/page.html`);
  has = await probe.evaluate(async () => !!(await navigator.gpu?.requestAdapter()));
  await probe.close();
  if (!has && process.env.VOXTRACE_REQUIRE_WEBGPU) throw new Error("this Chromium has no WebGPU adapter, and VOXTRACE_REQUIRE_WEBGPU asks for one");
  if (has) page = await watched(asked);
});
after(() => page?.close());

const skips = (t) => !has && (t.skip("this Chromium has no WebGPU adapter"), true);

for (const [name, number, options] of [
  ["city", "20k", ["--voxels", "20k"]],
  ["operating-room", "50k", ["--voxels", "50k"]],
  ["church", "200k", ["--voxels", "200k"]],
  ["forest", "100", ["--instances", "100"]],
]) {
  test(`the film of ${name} on the GPU is that of this machine`, async (t) => {
    if (skips(t)) return;
    const film = await filmOfScene(`scene:${name}?voxels=${number}`);
    const expected = native([name, ...options], { ...size, seed: 7 });
    assert.equal(differences(film.words, expected), 0, "pixels that differ");
    // Planted faults: one bit, and the samples of another seed.
    const wrong = Buffer.from(film.words);
    wrong[32 * 777] ^= 1;
    assert.equal(differences(wrong, expected), 1);
    assert.ok(differences(film.words, native([name, ...options], { ...size, seed: 8 })) > 1000);
  });
}

for (const path of ["vox/ephtracy/monument_monu9.vox", "vox/ephtracy/character_chr_knight.vox", "vox/arlorean/Test_cars.vox", "vox/ephtracy/anim_T-Rex.vox"]) {
  test(`the film of ${path} on the GPU is that of this machine`, async (t) => {
    if (skips(t)) return;
    if (!real(path)) return t.skip("the file is not here");
    const name = path.split("/").pop();
    copyFileSync(real(path), join(context.files, name));
    const film = await filmOfScene(`/files/${name}`);
    assert.equal(differences(film.words, native([join(context.files, name)], { ...size, seed: 7 })), 0, "pixels that differ");
  });
}

test("a device that is lost is made again, and after a second loss the processor goes on with the same film", async (t) => {
  if (skips(t)) return;
  run("convert", "city", join(context.files, "lost.vox"), "--voxels", "20k");
  await page.evaluate(() => (window.viewer.samples = 64));
  await page.evaluate(() => {
    window.events.length = 0;
    window.viewer.setAttribute("src", "/files/lost.vox");
  });
  const lose = async (count) => {
    await page.waitForFunction((count) => window.viewer.film() && window.devices.length >= count, count);
    await page.evaluate(() => window.devices.at(-1).destroy());
  };
  const before = await page.evaluate(() => window.devices.length);
  await lose(before);
  await page.waitForFunction((count) => window.devices.length > count, before);
  await lose(before + 1);
  await page.waitForFunction(() => window.viewer.activeTracer === "cpu");
  await event(page, "still");
  const film = await filmOf(page);
  assert.equal(differences(film.words, native([join(context.files, "lost.vox")], { ...size, samples: 64, seed: 7 })), 0, "pixels that differ");
  assert.equal(await page.evaluate(() => window.events.filter(({ name }) => name === "error").length), 0, "nobody is frightened");
  assert.match(page.said.join("\n"), /the GPU is started again[^]*the processor goes on/);
});

test("without an adapter, with software that nobody asked for, and with shaders that do not compile, the processor traces", async (t) => {
  if (skips(t)) return;
  run("convert", "city", join(context.files, "small.vox"), "--voxels", "20k");
  const cases = {
    none: () => (GPU.prototype.requestAdapter = async () => null),
    software: () => {},
    faulty: () => {
      const create = GPUDevice.prototype.createShaderModule;
      GPUDevice.prototype.createShaderModule = function ({ code }) {
        return create.call(this, { code: `${code}\nfn broken() -> f32 { return; }` });
      };
    },
  };
  for (const [name, prepare] of Object.entries(cases)) {
    const page = await watched({}, {});
    await page.evaluate(prepare);
    await page.evaluate((tracer) => {
      window.viewer.setAttribute("tracer", tracer);
      window.viewer.setAttribute("samples", "1");
      window.viewer.setAttribute("src", "/files/small.vox");
    }, name === "software" ? "auto" : "gpu");
    await event(page, "still");
    assert.equal(await page.evaluate(() => window.viewer.activeTracer), "cpu", name);
    assert.deepEqual(page.errors, []);
    await page.screenshot({ path: join(pictures, `without-webgpu-${name}.png`) });
    await page.close();
  }
});
