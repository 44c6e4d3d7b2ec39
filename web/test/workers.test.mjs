// The workers of one viewer: who asks for another scene, or removes the element, while they start, and what becomes of a picture when some of them fail.
import assert from "node:assert/strict";
import { join } from "node:path";
import { before, test } from "node:test";
import { comes, context, count, differences, event, filmOf, native, open, run, setAttributes, setUp } from "./browser.mjs";

setUp();
const path = (name) => join(context.files, name);
before(() => {
  run("convert", "city", path("city.vox"), "--voxels", "20k");
  run("convert", "church", path("church.vox"), "--voxels", "20k");
  run("convert", "city", path("streamed.vxt"), "--voxels", "300k", "--stream");
});

const size = { width: 96, height: 54, samples: 8 };
const SCENE = { samples: "8", seed: "7", threads: "4" };
const expected = (name) => native([path(name)], { ...size, seed: 7 });
const pause = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

/** Holds what the page asks for at addresses that end so; gives when it is first asked for, and a function that lets it go. */
async function hold(page, end) {
  let release, asked;
  const released = new Promise((done) => (release = done));
  const isAsked = new Promise((done) => (asked = done));
  await page.route(`**/${end}`, async (route) => {
    asked();
    await released;
    await route.continue().catch(() => {});
  });
  return { isAsked, release };
}

/** Waits until the page has so many workers. */
async function workers(page, number) {
  await comes(() => page.workers().length === number);
  return page.workers().length;
}

/** Before the element asks for workers: what each of the page's is told goes through `window.tell(worker, number, message, pass)`. */
const between = (page, tell, ...given) =>
  page.evaluate(([tell, given]) => {
    const told = new Function("...given", `return (${tell})(...given)`);
    let number = 0;
    window.Worker = class extends Worker {
      number = ++number;
      postMessage(message, transfer = []) {
        told(this, message, () => super.postMessage(message, transfer), ...given);
      }
    };
  }, [String(tell), given]);

/**
 * Workers of these numbers fail at their part of that number, as for want of memory. The others wait with their first part until they have, or they might do all of it.
 * First passes do not count: those of the coarse picture before the film are too few for all.
 */
const failing = (worker, message, pass, parts) => {
  worker.parts ??= 0;
  const counts = message.name === "render" && message.given[0].samples > 1;
  if (counts) worker.parts += 1;
  window.failed ??= new Set();
  window.waiting ??= [];
  if (!(worker.parts >= parts[worker.number])) {
    const waits = !(worker.number in parts) && counts && window.failed.size < Object.keys(parts).length;
    return waits ? void window.waiting.push(pass) : pass();
  }
  window.failed.add(worker.number);
  if (window.failed.size === Object.keys(parts).length) for (const go of window.waiting.splice(0)) go();
  const data = { id: message.id, error: "the tracer stopped, most likely for want of memory (planted)", isFatal: true };
  setTimeout(() => worker.onmessage(new MessageEvent("message", { data })), 20);
};

test("another scene that is asked for while the module arrives has all workers, and its film is its own", async () => {
  const page = await open({}, size);
  const held = await hold(page, "voxtrace.wasm");
  await setAttributes(page, { ...SCENE, src: "/files/city.vox" });
  await held.isAsked;
  await setAttributes(page, { src: "/files/church.vox" });
  assert.ok(await comes(() => context.server.answers.some(({ path, sent }) => path === "/files/church.vox" && sent > 0)));
  await pause(500);
  held.release();
  const { url } = await event(page, "load");
  assert.equal(url, "/files/church.vox");
  await event(page, "still");
  const film = await filmOf(page);
  assert.equal(differences(film.words, expected("church.vox")), 0, "pixels that differ");
  assert.ok(differences(film.words, expected("city.vox")) > 1000);
  assert.equal(await workers(page, 4), 4);
  assert.deepEqual([await count(page, "load"), await count(page, "error"), page.errors], [1, 0, []]);
  await page.close();
});

for (const [when, end] of [["the module", "voxtrace.wasm"], ["the script of its worker", "voxtrace-worker.js"], ["the module that makes the scene", "scenes.wasm"]]) {
  test(`an element that is removed while ${when} arrives has no workers afterwards`, async () => {
    const page = await open({}, size);
    const held = await hold(page, end);
    await setAttributes(page, { ...SCENE, src: end.startsWith("scenes") ? "scene:city?voxels=20k" : "/files/city.vox" });
    await held.isAsked;
    await page.evaluate(() => window.viewer.remove());
    await pause(100);
    held.release();
    await pause(1500);
    assert.equal(await workers(page, 0), 0);
    assert.deepEqual([await page.evaluate(() => window.viewer.loaded), await count(page, "error"), page.errors], [false, 0, []]);
    // Put back, it is as if nothing had been.
    await page.evaluate(() => document.querySelector("main").append(window.viewer));
    await event(page, "still");
    assert.equal(await workers(page, 4), 4);
    await page.close();
  });
}

test("a scene whose view is not known yet when another one is asked for is not shown", async () => {
  const page = await open({}, size);
  await between(page, (worker, message, pass) => {
    if (message.name !== "camera" || window.release) return pass();
    window.release = pass;
  });
  await setAttributes(page, { ...SCENE, src: "/files/city.vox" });
  await page.waitForFunction(() => window.release);
  let arrive;
  const hold = { at: 1000, until: new Promise((done) => (arrive = done)) };
  context.server.faults = ({ path }) => (path === "/files/church.vox" ? { hold } : undefined);
  await setAttributes(page, { src: "/files/church.vox?rate=1000" });
  await page.evaluate(() => window.release());
  await pause(500);
  assert.deepEqual([await count(page, "camera-change"), await page.evaluate(() => window.viewer.getCameraOrbit())], [0, undefined]);
  arrive();
  await event(page, "still");
  context.server.faults = undefined;
  assert.deepEqual([await count(page, "load"), await count(page, "error"), page.errors], [1, 0, []]);
  assert.equal(differences((await filmOf(page)).words, expected("church.vox")), 0, "pixels that differ");
  await page.close();
});

test("a module whose type has a charset is compiled as well", async () => {
  const page = await open({}, size);
  await page.route("**/voxtrace.wasm", async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, headers: { ...response.headers(), "content-type": "application/wasm; charset=utf-8" } });
  });
  await setAttributes(page, { ...SCENE, src: "/files/city.vox" });
  await event(page, "still");
  assert.deepEqual([await count(page, "error"), page.errors], [0, []]);
  await page.close();
});

test("while another scene arrives nothing is told of the last one, and its workers are gone", async () => {
  const page = await open({ ...SCENE, src: "/files/city.vox" }, size);
  await event(page, "still");
  const ray = [0, 0, 1000, 0, 0, 0, -1, 1e9];
  assert.equal(await page.evaluate(async (ray) => (await window.viewer.cast(new Float32Array(ray))).length, ray), 6);
  await setAttributes(page, { src: "/files/church.vox?rate=1000" });
  const told = await page.evaluate((ray) => window.viewer.cast(new Float32Array(ray)).catch((error) => error.message), ray);
  assert.deepEqual([told, await page.evaluate(() => window.viewer.activeTracer)], ["no scene was loaded", undefined]);
  assert.equal(await workers(page, 0), 0);
  assert.deepEqual([await count(page, "error"), page.errors], [0, []]);
  await page.close();
});

for (const [which, parts] of [["one of four workers fails", { 2: 2 }], ["the first worker fails", { 1: 3 }], ["all workers but the last fail", { 1: 5, 2: 2, 3: 1 }]]) {
  test(`where ${which}, the others go on with the same film`, async () => {
    const page = await open({}, size);
    await between(page, failing, parts);
    // So many samples that all of them take part.
    await setAttributes(page, { ...SCENE, samples: "200", src: "/files/city.vox" });
    await event(page, "still");
    const film = await filmOf(page);
    assert.equal(film.samples, 200);
    assert.equal(differences(film.words, native([path("city.vox")], { ...size, samples: 200, seed: 7 })), 0, "pixels that differ");
    const left = 4 - Object.keys(parts).length;
    assert.equal(await workers(page, left), left, "those that failed are ended");
    // They do what else is asked.
    await setAttributes(page, { seed: "8" });
    await event(page, "still", 1);
    assert.equal((await page.evaluate(() => window.viewer.selftest(8))).length > 5, true);
    assert.deepEqual([await count(page, "error"), page.errors], [0, []]);
    await page.close();
  });
}

test("where the last worker fails, that is told", async () => {
  const page = await open({}, size);
  await between(page, failing, { 1: 3, 2: 3, 3: 3, 4: 3 });
  await setAttributes(page, { ...SCENE, samples: "200", src: "/files/city.vox" });
  const { type, message } = await event(page, "error");
  assert.deepEqual([type, message], ["renderfailure", "the tracer stopped, most likely for want of memory (planted)"]);
  assert.equal(await workers(page, 0), 0);
  assert.deepEqual([await count(page, "error"), page.errors], [1, []]);
  await page.close();
});

test("where the first worker fails before others have the scene, they go on once they have", async () => {
  const page = await open({}, size);
  await between(page, (worker, message, pass) => {
    if (message.name === "load" && worker.number > 1) return void setTimeout(pass, 1000);
    if (message.name !== "render" || worker.number > 1) return pass();
    const data = { id: message.id, error: "panicked: planted", isFatal: true };
    setTimeout(() => worker.onmessage(new MessageEvent("message", { data })), 20);
  });
  await setAttributes(page, { ...SCENE, threads: "2", src: "/files/city.vox" });
  await event(page, "still");
  assert.equal(differences((await filmOf(page)).words, expected("city.vox")), 0, "pixels that differ");
  assert.deepEqual([await workers(page, 1), await count(page, "error"), page.errors], [1, 0, []]);
  await page.close();
});

test("who gets a finer scene has no part in a film of the coarser one", async () => {
  const page = await open({}, size);
  // The first worker is the one that follows the file. The last one gets the first scene when it is let go: a finer one waits for it.
  await between(page, (worker, message, pass) => {
    window.scenes ??= new WeakMap();
    window.mixed ??= 0;
    if (worker.number === 1) {
      if (message.kind === "open") worker.addEventListener("message", ({ data }) => (window.arrived = (window.arrived ?? 0) + (data.kind === "scene")));
      return pass();
    }
    if (message.name === "start") worker.addEventListener("message", ({ data }) => data.made?.words && window.scenes.set(data.made.words, worker.scene));
    const words = message.name === "render" && message.given[0].words;
    if (words && window.scenes.get(words) !== worker.scene) window.mixed += 1;
    if (message.name === "load") worker.scene = (worker.scene ?? 0) + 1;
    if (message.name !== "load" || worker.number !== 3 || window.release) return pass();
    window.release = pass;
  });
  await setAttributes(page, { ...SCENE, samples: "60000", threads: "2", src: "/files/streamed.vxt" });
  await page.waitForFunction(() => window.release && window.arrived > 1);
  await setAttributes(page, { "camera-orbit": "30deg 60deg 100%" });
  await page.waitForFunction(() => window.viewer.film()?.samples > 1);
  await page.evaluate(() => window.release());
  await page.waitForFunction(() => window.viewer.scene?.detail?.isExact && window.viewer.film()?.samples > 1);
  assert.equal(await page.evaluate(() => window.mixed), 0, "rows of one scene that go on with another");
  assert.deepEqual([await count(page, "error"), page.errors], [0, []]);
  await page.close();
});
