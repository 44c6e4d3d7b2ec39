// Pictures, rays and functions of the browser are those of this machine, to the bit.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { context, differences, event, filmOf, native, open, real, run, setUp, words } from "./browser.mjs";

setUp();

const size = { width: 96, height: 54, samples: 4 };

/** Compares the film of `src` with that of the program, and with what a wrong one would be. */
async function compare(src, scene, more = []) {
  const page = await open({ src, samples: "4", seed: "7" }, size);
  await event(page, "still");
  const film = await filmOf(page);
  assert.deepEqual([film.width, film.height, film.samples], [96, 54, 4]);
  const expected = native(scene, { ...size, seed: 7 }, more);
  assert.equal(differences(film.words, expected), 0, `${src}: pixels that differ`);
  // Planted faults: one bit of one pixel, and the samples of another seed.
  const wrong = Buffer.from(film.words);
  wrong[32 * 777] ^= 1;
  assert.equal(differences(wrong, expected), 1);
  assert.deepEqual(page.errors, []);
  await page.close();
  return film;
}

for (const [name, number, options] of [
  ["city", "200k", ["--voxels", "200k"]],
  ["operating-room", "200k", ["--voxels", "200k"]],
  ["church", "1M", ["--voxels", "1M"]],
  ["forest", "300", ["--instances", "300"]],
]) {
  test(`the film of ${name} in the browser is that of this machine`, async () => {
    const film = await compare(`scene:${name}?voxels=${number}`, [name, ...options]);
    const other = native([name, ...options], { ...size, seed: 8 });
    assert.ok(differences(film.words, other) > 1000, "another seed gives another film");
  });
}

for (const format of ["vox", "vxt"]) {
  test(`the film of a .${format} file is that of this machine`, async () => {
    const file = join(context.files, `city.${format}`);
    run("convert", "city", file, "--voxels", "50k");
    await compare(`/files/city.${format}`, [file]);
  });
}

const REAL = [
  "vox/ephtracy/monument_monu9.vox", "vox/ephtracy/character_chr_knight.vox", "vox/ephtracy/scan_dragon.vox", "vox/ephtracy/procedure_maze.vox",
  "vox/ephtracy/procedure_nature.vox", "vox/ephtracy/anim_T-Rex.vox", "vox/arlorean/Test_cars.vox", "fastvoxels_1.vox",
];
for (const path of REAL) {
  test(`the film of ${path} is that of this machine`, { skip: !real(path) && "the file is not here" }, async () => {
    copyFileSync(real(path), join(context.files, "real.vox"));
    await compare("/files/real.vox", [join(context.files, "real.vox")]);
  });
}

test("rays meet what they meet on this machine", async () => {
  const file = join(context.files, "rays.vxt");
  run("convert", "city", file, "--voxels", "50k");
  const page = await open({ src: "/files/rays.vxt", samples: "1" }, size);
  await event(page, "load");
  const { bounds } = await page.evaluate(() => window.viewer.scene);
  // From all around and from within, towards places in the scene.
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  const place = (margin) => [0, 1, 2].map((axis) => bounds[axis] + (bounds[axis + 3] - bounds[axis]) * (random() * (1 + 2 * margin) - margin));
  const rays = new Float32Array(8 * 5000);
  for (let ray = 0; ray < 5000; ray++) {
    const [from, to] = [place(ray % 2), place(0)];
    rays.set([...from, 0, ...to.map((value, axis) => value - from[axis]), ray % 3 ? Infinity : 0.5], 8 * ray);
  }
  const hits = await page.evaluate(async (rays) => [...(await window.viewer.cast(new Float32Array(rays)))], [...rays]);
  writeFileSync(join(context.files, "rays"), Buffer.from(rays.buffer));
  const lines = execFileSync(words, ["rays", file, join(context.files, "rays")], { encoding: "utf8", maxBuffer: 1 << 26 }).trim();
  const expected = lines.split(/\s+/).map((word) => parseInt(word, 16));
  assert.deepEqual(hits, expected);
  const found = hits.filter((word, at) => at % 6 === 1 && word !== 0xffffffff).length;
  assert.ok(found > 1500 && found < 4900, `${found} of 5000 rays meet something`);
  hits[6 * 100] ^= 1;
  assert.notDeepEqual(hits, expected);
  await page.close();
});

test("every function of the tracer gives the bits of this machine", async () => {
  const file = join(context.files, "small.vox");
  run("convert", "city", file, "--voxels", "5k");
  const page = await open({ src: "/files/small.vox", samples: "1" }, size);
  await event(page, "load");
  const here = (edge) => execFileSync(words, ["selftest", String(edge)], { encoding: "utf8" }).trim().split("\n");
  const lines = await page.evaluate(() => window.viewer.selftest(64));
  assert.deepEqual(lines, here(64));
  assert.ok(lines.length >= 11);
  // The scene of another edge: the groups that read it differ, the others not.
  const other = here(48);
  assert.deepEqual(lines.filter((line, at) => line !== other[at]).map((line) => line.replace(/ \w+$/, "")), ["cameras", "scene", "walk", "lights"]);
  await page.close();
});
