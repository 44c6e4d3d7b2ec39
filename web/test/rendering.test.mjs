// One picture dealt out to workers, some of which fail: each band has each of its samples once, whoever traced it. Node has all that it needs.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bundled } from "./bundled.mjs";

const { Rendering, sizeOf } = await bundled("web/src/rendering.ts");

const SAMPLES = 12;
const picture = { camera: new Float32Array(10), lensOf: -1, width: 4, height: 23, samples: SAMPLES, seed: 1, bounces: 8 };
const look = { toneMapping: "agx", exposure: 0, hasRealTime: false };
const soon = (milliseconds = 0) => new Promise((done) => setTimeout(done, milliseconds));

/** A worker that writes down each sample of each row in the words of its film; it fails at parts for which `fails` says so. */
class Fake {
  rate = 0.1;
  parts = 0;
  constructor(fails = () => false, wait = () => soon()) {
    Object.assign(this, { fails, wait });
  }

  async call(name, [part]) {
    assert.equal(name, "render");
    this.parts += 1;
    await this.wait(this.parts);
    if (this.fails(this.parts)) throw new Error(`failed at part ${this.parts}`);
    const rows = part.y1 - part.y0;
    const words = new Uint8Array(part.width * rows * 32);
    words.set(part.words ?? []);
    const from = Math.max(...words.slice(0, 1));
    for (let pixel = 0; pixel < part.width * rows; pixel++) {
      const at = pixel * 32;
      for (let sample = from; sample < part.samples; sample++) words[at + 1 + sample] += 1;
      words[at] = part.samples;
    }
    return { words, shown: new Uint8ClampedArray(part.width * rows * 4), milliseconds: 1 };
  }
}

/** A picture of these workers; those that are left are the ones that did not fail. */
function renderingOf(workers) {
  const without = async () => workers.filter((worker) => !worker.isLost);
  for (const worker of workers) {
    const { call } = worker;
    worker.call = (...given) => call.apply(worker, given).catch((error) => {
      worker.isLost = true;
      throw error;
    });
  }
  const rendering = new Rendering(picture, look, { rate: 0.1, workers: workers.length }, () => {}, without);
  for (const worker of workers) void rendering.work(worker);
  return rendering;
}

function check(rendering) {
  assert.equal(rendering.samples, SAMPLES);
  const words = rendering.words();
  const pixel = [SAMPLES, ...Array(SAMPLES).fill(1), ...Array(31 - SAMPLES).fill(0)];
  for (let at = 0; at < words.length; at += 32) assert.deepEqual([...words.subarray(at, at + 32)], pixel, `pixel ${at / 32}`);
}

test("the others go on where workers fail, and no sample is missing or there twice", async () => {
  let [state, lost] = [7, 0];
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  for (let round = 0; round < 20; round++) {
    const wait = () => soon(3 * random());
    const fails = () => random() < 0.2;
    const workers = [new Fake(fails, wait), new Fake(undefined, wait), new Fake(fails, wait), new Fake(fails, wait)];
    const rendering = renderingOf(workers);
    await rendering.finished;
    check(rendering);
    lost += workers.filter(({ isLost }) => isLost).length;
  }
  assert.ok(lost > 20, `${lost} failed`);
});

test("one that had nothing left to do takes the last band of one that fails", async () => {
  let begun = 0;
  let rendering;
  // Whoever has the last band fails, long after the other went away.
  const isLast = () => rendering?.bands.filter(({ samples }) => samples < SAMPLES).length === 1;
  const workers = [0, 1].map(() => new Fake(() => isLast() && begun++ === 0, () => soon(isLast() ? 30 : 0)));
  rendering = renderingOf(workers);
  await rendering.finished;
  assert.equal(workers.filter(({ isLost }) => isLost).length, 1);
  check(rendering);
});

test("what is shown of a band has the look of now, also where that changed while its last samples were traced", async () => {
  const brighter = (exposure) => ({ ...look, exposure });
  const worker = {
    rate: 1e6,
    async call(name, given) {
      await soon();
      if (name === "show") {
        // And once more while that is shown.
        if (given[2] === 1) rendering.look = brighter(2);
        return new Uint8ClampedArray([given[2]]);
      }
      const [part] = given;
      if (part.samples === SAMPLES) rendering.look = brighter(1);
      return { words: new Uint8Array(part.width * (part.y1 - part.y0) * 32), shown: new Uint8ClampedArray([part.exposure]), milliseconds: 1 };
    },
  };
  const rendering = new Rendering(picture, look, { rate: 0.1, workers: 2 }, () => {}, async () => []);
  void rendering.work(worker);
  await rendering.finished;
  assert.ok(rendering.bands.length > 1);
  assert.deepEqual(rendering.bands.map(({ shown }) => shown[0]), rendering.bands.map(() => 2));
});

test("it fails with the last one of them, and not where it was stopped", async () => {
  const workers = [3, 1, 2].map((most) => new Fake((parts) => parts >= most));
  await assert.rejects(renderingOf(workers).finished, /failed at part 3/);
  const stopped = renderingOf([new Fake(() => true)]);
  stopped.stop();
  assert.equal(await Promise.race([stopped.finished.catch(() => "failed"), soon(50).then(() => "nothing")]), "nothing");
});

test("it says that a GPU traced of it, also where the workers ended it", async () => {
  const ofGpu = new Fake((parts) => parts > 2);
  const { call } = ofGpu;
  ofGpu.call = async (...given) => ({ ...(await call.apply(ofGpu, given)), isOfGpu: true });
  const both = renderingOf([ofGpu, new Fake(undefined, () => soon(5))]);
  await both.finished;
  check(both);
  assert.ok(ofGpu.isLost && both.isOfGpu);
  const alone = renderingOf([new Fake()]);
  await alone.finished;
  assert.equal(alone.isOfGpu, false);
});

test("a picture has the pixels of its place up to what is allowed and a canvas can have, in its shape", () => {
  const most = 1280 * 720;
  assert.deepEqual(sizeOf(320, 180, most), { width: 320, height: 180 });
  assert.deepEqual(sizeOf(3840, 2160, most), { width: 1280, height: 720 });
  assert.deepEqual(sizeOf(200_000, 100, most), { width: 16_384, height: 8 });
  assert.deepEqual(sizeOf(100, 200_000, 2 ** 26), { width: 8, height: 16_384 });
  assert.deepEqual(sizeOf(0, 0, most), { width: 1, height: 1 });
  // Planted: by its number of pixels alone it would be wider than any canvas.
  assert.ok(200_000 * Math.sqrt(most / (200_000 * 100)) > 2 * 16_384);
});
