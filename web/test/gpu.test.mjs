// The GPU tier in Chromium's software WebGPU: films are those of this machine, word by word; and what happens where WebGPU goes away or never was.
import assert from "node:assert/strict";
import { copyFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { context, differences, event, filmOf, native, openWebGpu, real, run, setAttributes, setUpWebGpu, skipsWebGpu } from "./browser.mjs";
import { fileOfMaterials } from "./materials.mjs";

const size = { width: 64, height: 36, samples: 4 };
// Without real-time light, whose shaders take as long to compile: `real-time.test.mjs` has it.
const asked = { tracer: "gpu", samples: "4", seed: "7", "max-pixels": String(64 * 36), "real-time": "off" };
let page;

/** A page with an element of these attributes whose console and whose devices the test sees. */
async function watched(attributes, options) {
  const page = await openWebGpu({ ...size, ...options });
  await setAttributes(page, attributes);
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

setUpWebGpu(async () => (page = await watched(asked)));

for (const [name, number, options] of [
  ["city", "20k", ["--voxels", "20k"]],
  ["operating-room", "50k", ["--voxels", "50k"]],
  ["church", "200k", ["--voxels", "200k"]],
  ["forest", "100", ["--instances", "100"]],
]) {
  test(`the film of ${name} on the GPU is that of this machine`, async (t) => {
    if (skipsWebGpu(t)) return;
    const film = await filmOfScene(`scene:${name}?voxels=${number}`);
    const expected = native([name, ...options], { ...size, seed: 7 });
    assert.equal(differences(film.words, expected), 0, "pixels that differ");
    // Planted faults: one bit, and the samples of another seed.
    const wrong = Buffer.from(film.words);
    wrong[32 * 777] ^= 1;
    assert.equal(differences(wrong, expected), 1);
    assert.ok(differences(film.words, native([name, ...options], { ...size, seed: 8 })) > 500);
  });
}

for (const path of ["vox/ephtracy/monument_monu9.vox", "vox/ephtracy/character_chr_knight.vox", "vox/arlorean/Test_cars.vox", "vox/ephtracy/anim_T-Rex.vox"]) {
  test(`the film of ${path} on the GPU is that of this machine`, async (t) => {
    if (skipsWebGpu(t)) return;
    if (!real(path)) return t.skip("the file is not here");
    const name = path.split("/").pop();
    copyFileSync(real(path), join(context.files, name));
    const film = await filmOfScene(`/files/${name}`);
    assert.equal(differences(film.words, native([join(context.files, name)], { ...size, seed: 7 })), 0, "pixels that differ");
  });
}

test("the film of every kind of material on the GPU is that of this machine", async (t) => {
  if (skipsWebGpu(t)) return;
  const file = join(context.files, "materials.vox");
  writeFileSync(file, fileOfMaterials());
  const film = await filmOfScene("/files/materials.vox");
  assert.equal(differences(film.words, native([file], { ...size, seed: 7 })), 0, "pixels that differ");
});

test("a part of the scene is shown by the workers, the whole by the GPU again", async (t) => {
  if (skipsWebGpu(t)) return;
  const whole = await filmOfScene("scene:city?voxels=20k");
  const still = async (box) => {
    await page.evaluate((box) => {
      window.events.length = 0;
      window.viewer.clipBox = box;
    }, box);
    const { isExact } = await event(page, "still");
    return { isExact, tracer: await page.evaluate(() => window.viewer.activeTracer), film: await filmOf(page) };
  };
  const { isExact, tracer, film } = await still("-1000 -1000 -1000 1000 1000 6");
  assert.deepEqual([tracer, isExact], ["cpu", true]);
  const box = ["--clip-box", "-1000,-1000,-1000,1000,1000,6"];
  assert.equal(differences(film.words, native(["city", "--voxels", "20k"], { ...size, seed: 7 }, box)), 0, "pixels that differ");
  assert.ok(differences(film.words, whole.words) > 100);
  const again = await still("auto");
  assert.deepEqual([again.tracer, again.isExact], ["gpu", false], "it is not promised there");
  assert.equal(differences(again.film.words, whole.words), 0);
});

test("a device that is lost is made again, and after a second loss the processor goes on with the same film", async (t) => {
  if (skipsWebGpu(t)) return;
  run("convert", "city", join(context.files, "lost.vox"), "--voxels", "20k");
  // So that there is a device before.
  await filmOfScene("scene:city?voxels=10k");
  await page.evaluate(() => {
    window.events.length = 0;
    window.viewer.samples = 64;
    window.viewer.setAttribute("src", "/files/lost.vox");
  });
  // By the page itself, as the picture may be finished before this process is heard again.
  const lose = (count) =>
    page.evaluate(([count, most]) => new Promise((done, fail) => {
      const end = Date.now() + most;
      const look = () => {
        if (Date.now() > end) return void fail(new Error(`device ${count} was never there`));
        if (!window.viewer.film() || window.devices.length < count) return void setTimeout(look, 30);
        window.devices.at(-1).destroy();
        done();
      };
      look();
    }), [count, 240_000]);
  const before = await page.evaluate(() => window.devices.length);
  await lose(before);
  await lose(before + 1);
  await page.waitForFunction(() => window.viewer.activeTracer === "cpu");
  await event(page, "still");
  const film = await filmOf(page);
  assert.equal(differences(film.words, native([join(context.files, "lost.vox")], { ...size, samples: 64, seed: 7 })), 0, "pixels that differ");
  assert.equal(await page.evaluate(() => window.events.filter(({ name }) => name === "error").length), 0, "nobody is frightened");
  assert.match(page.said.join("\n"), /the GPU is started again[^]*the processor goes on/);
});

// Each with what the element is asked for, and whether its console says why.
const WITHOUT = {
  "no WebGPU": { tracer: "gpu", prepare: () => void Object.defineProperty(Navigator.prototype, "gpu", { value: undefined }) },
  "no adapter": { tracer: "gpu", prepare: () => void (GPU.prototype.requestAdapter = async () => null) },
  "software that nobody asked for": { tracer: "auto", prepare: () => {} },
  "workers asked for": { tracer: "cpu", prepare: () => {} },
  "a scene larger than a binding": {
    tracer: "gpu",
    prepare: () => void Object.defineProperty(GPUDevice.prototype, "limits", { value: { maxStorageBufferBindingSize: 1000, maxBufferSize: 1 << 28 } }),
  },
  "shaders that do not compile": {
    tracer: "gpu",
    says: /the processor goes on in place of the GPU: the shaders do not compile/,
    prepare: () => {
      const create = GPUDevice.prototype.createShaderModule;
      GPUDevice.prototype.createShaderModule = function ({ code }) {
        return create.call(this, { code: `${code}\nfn broken() -> f32 { return; }` });
      };
    },
  },
  "no shaders on the server": {
    tracer: "gpu",
    says: /the processor goes on in place of the GPU: shaders.wgsl/,
    prepare: () => {
      const load = window.fetch;
      window.fetch = (url, ...more) => load(String(url).replace("shaders.wgsl", "nothing.wgsl"), ...more);
    },
  },
};
test("shaders that come when they are asked for again are used", async (t) => {
  if (skipsWebGpu(t)) return;
  run("convert", "city", join(context.files, "small.vox"), "--voxels", "20k");
  const page = await watched({}, {});
  await page.evaluate(() => {
    const load = window.fetch;
    let asked = 0;
    window.fetch = (url, ...more) => load(String(url).endsWith("shaders.wgsl") && asked++ === 0 ? "/test/nothing.wgsl" : url, ...more);
  });
  await setAttributes(page, { ...asked, src: "/files/small.vox" });
  await event(page, "still");
  assert.equal(await page.evaluate(() => window.viewer.activeTracer), "gpu");
  assert.match(page.said.join("\n"), /the GPU is started again: shaders\.wgsl/);
  assert.equal(differences((await filmOf(page)).words, native([join(context.files, "small.vox")], { ...size, seed: 7 })), 0, "pixels that differ");
  await page.close();
});

for (const [name, { tracer, prepare, says }] of Object.entries(WITHOUT)) {
  test(`with ${name} the processor traces, and the film is the same`, async (t) => {
    if (skipsWebGpu(t)) return;
    run("convert", "city", join(context.files, "small.vox"), "--voxels", "20k");
    const page = await watched({}, {});
    await page.evaluate(prepare);
    await setAttributes(page, { ...asked, tracer, src: "/files/small.vox" });
    await event(page, "still");
    assert.equal(await page.evaluate(() => window.viewer.activeTracer), "cpu");
    const film = await filmOf(page);
    assert.equal(differences(film.words, native([join(context.files, "small.vox")], { ...size, seed: 7 })), 0, "pixels that differ");
    assert.deepEqual(page.errors, []);
    const said = page.said.filter((text) => text.startsWith("voxtrace-viewer")).join("\n");
    if (says) assert.match(said, says);
    else assert.equal(said, "");
    await page.close();
  });
}
