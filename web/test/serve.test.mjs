// The page of `voxtrace serve` in Chromium: the list, thumbnails, a scene traced by the page and by the server, files that are dropped.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { context, differences, native, pictures, program, run, setUp, TIMEOUT, violations, web } from "./browser.mjs";

setUp();
let server;
let folder;

/** Starts the program with a folder; gives its address, and how to end it and see how it ended. */
async function start(...options) {
  const child = spawn(program, ["serve", folder, "--listen", "127.0.0.1:0", "--traversal", "cpu", "--samples", "4", ...options], {
    env: { ...process.env, VOXTRACE_CACHE: join(context.files, "cache") },
    stdio: ["ignore", "pipe", "inherit"],
  });
  const ended = new Promise((done) => child.on("exit", done));
  const address = await new Promise((done) => child.stdout.once("data", (line) => done(String(line).trim().replace(/\/$/, ""))));
  return { address, end: () => (child.kill("SIGINT"), ended) };
}

before(async () => {
  folder = join(context.files, "scans");
  mkdirSync(join(folder, "older"), { recursive: true });
  for (const scene of ["city", "church", "operating-room"]) run("convert", scene, join(folder, `${scene}.vxt`), "--voxels", "200k");
  run("convert", "city", join(folder, "older/town.vox"), "--voxels", "20k");
  run("convert", join(folder, "older/town.vox"), join(folder, "older/town.glb"));
  // Slices of a scan, in a folder that is called like a file.
  mkdirSync(join(folder, "older/slices.vox"));
  for (const number of [1, 2, 3]) copyFileSync(join(web, "test/poster.png"), join(folder, `older/slices.vox/${number}.png`));
  writeFileSync(join(folder, "damaged.vox"), readFileSync(join(folder, "older/town.vox")).subarray(0, 300));
  server = await start("--web", join(web, "dist"));
});
after(async () => assert.equal(await server?.end(), 0, "it ends well when it is asked to"));

/** A page at a place, which fails by whatever the console says is wrong. */
async function visit(place, { address = server.address, ...options } = {}) {
  const page = await context.browser.newPage({ viewport: { width: 1280, height: 800 }, ...options });
  page.errors = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  page.on("console", (message) => message.type() === "error" && !/status of (409|422)/.test(message.text()) && page.errors.push(message.text()));
  page.setDefaultTimeout(TIMEOUT);
  // Which view was asked for last, and all pictures that were shown.
  await page.addInitScript(() => {
    const { send } = WebSocket.prototype;
    WebSocket.prototype.send = function (text) {
      const said = JSON.parse(text);
      if (said.type === "view") window.asked = said.id;
      return send.call(this, text);
    };
    window.seen = [];
    new MutationObserver(() => window.seen.push({ ...document.querySelector(".stage canvas")?.dataset })).observe(document, { subtree: true, attributes: true, attributeFilter: ["data-frame"] });
  });
  await page.goto(`${address}/${place}`);
  return page;
}

async function close(page) {
  assert.deepEqual(page.errors, []);
  await page.close();
}

for (const [name, viewport, colorScheme] of [["desktop", { width: 1280, height: 800 }, "light"], ["phone", { width: 390, height: 844 }, "dark"]]) {
  test(`a folder is listed with thumbnails, on a ${name}`, async () => {
    const page = await visit("", { viewport, colorScheme });
    await page.waitForFunction(() => document.querySelectorAll(".thumbnail").length === 4);
    for (const place of await page.locator(".thumbnail").all()) {
      await place.scrollIntoViewIfNeeded();
      await place.locator("img, .alarm").waitFor();
    }
    assert.equal(await page.locator(".thumbnail img").count(), 3);
    assert.match(await page.locator(".thumbnail .alarm").innerText(), /^damaged\.vox: /);
    await page.waitForFunction(() => [...document.images].every((image) => image.complete && image.naturalWidth === 480));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width, "nothing sticks out");
    assert.deepEqual(await violations(page), []);
    await page.evaluate(() => scrollTo(0, 0));
    await page.screenshot({ path: join(pictures, `serve-list-${name}.png`) });
    await page.getByRole("link", { name: "older/" }).click();
    await page.getByText("town.vox").waitFor();
    await page.getByRole("link", { name: "scans" }).click();
    await page.getByText("church.vxt").waitFor();
    await close(page);
  });
}

test("a scene is shown by the page, and its film is that of render", async () => {
  const page = await visit("#/scene/older/town.vox");
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer")?.loaded);
  await page.evaluate(() => {
    const viewer = document.querySelector("voxtrace-viewer");
    [viewer.samples, viewer.maxPixels] = [2, 40_000];
  });
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer").film()?.samples === 2);
  const film = await page.evaluate(() => {
    const { words, ...rest } = document.querySelector("voxtrace-viewer").film();
    return { ...rest, words: [...words] };
  });
  const expected = native([join(folder, "older/town.vox")], film);
  assert.equal(differences(Buffer.from(film.words), expected), 0);
  await page.getByText("MagicaVoxel").first().waitFor();
  assert.deepEqual(await violations(page), []);
  await page.screenshot({ path: join(pictures, "serve-scene.png") });
  await close(page);
});

test("a mesh comes to the page as voxels", async () => {
  const page = await visit("#/scene/older/town.glb");
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer")?.loaded);
  assert.ok((await page.evaluate(() => document.querySelector("voxtrace-viewer").scene.voxels)) > 10_000);
  await close(page);
});

/** Waits for the whole picture of the view that was asked for last, which comes after another one, and gives its numbers. */
const picture = (page, after = 0) =>
  page.waitForFunction((after) => {
    const { dataset } = document.querySelector(".stage canvas") ?? {};
    return dataset?.kind === "png" && Number(dataset.view) === window.asked && Number(dataset.frame) > after && { ...dataset };
  }, after).then((found) => found.jsonValue());

/** The last picture of a view that moved, once there was one after another picture: it may be gone by now. */
const moved = (page, after) =>
  page.waitForFunction((after) => window.seen.findLast(({ kind, frame }) => kind === "jpeg" && Number(frame) > after), after).then((found) => found.jsonValue());

test("a folder that is called like a file comes to the page as voxels, too", async () => {
  const page = await visit("#/scene/older/slices.vox");
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer")?.film()?.samples >= 1);
  await page.getByText("a folder", { exact: true }).waitFor();
  await close(page);
});

test("where the viewer does not come, or a thumbnail is cut off, that is told", async () => {
  const page = await visit("");
  await page.route("**/element/voxtrace.js", (route) => route.abort());
  // The first ones end before they should; the others come all the same.
  await page.addInitScript(() => {
    const { blob } = Response.prototype;
    window.cut = 2;
    Response.prototype.blob = function () {
      return window.cut-- > 0 ? Promise.reject(new TypeError("cut off")) : blob.call(this);
    };
  });
  await page.reload();
  await page.waitForFunction(() => document.querySelectorAll(".thumbnail :is(img, .alarm)").length === 4);
  assert.equal(await page.locator(".thumbnail .alarm").filter({ hasText: "the server cannot be reached" }).count(), 2);
  await page.evaluate(() => (location.hash = "#/scene/older/town.vox"));
  await page.getByRole("alert").filter({ hasText: "This page cannot trace: " }).waitFor();
  await page.getByLabel("The server").check();
  await page.waitForFunction(() => document.querySelector(".stage canvas")?.dataset.frame);
  assert.deepEqual([await page.getByRole("alert").count(), page.errors.filter((error) => !/ERR_FAILED/.test(error))], [0, []]);
  await page.close();
});

test("the server traces: soon while the view moves, and the pixels of render when it stands", async () => {
  const page = await visit("#/scene/city.vxt", { viewport: { width: 800, height: 480 } });
  await page.getByLabel("The server").check();
  const first = await picture(page);
  assert.equal(first.samples, "4");
  const shown = await page.evaluate(() => {
    const canvas = document.querySelector(".stage canvas");
    return { width: canvas.width, height: canvas.height, png: canvas.toDataURL("image/png").split(",")[1] };
  });
  await page.screenshot({ path: join(pictures, "serve-remote-still.png") });
  const size = `${shown.width}x${shown.height}`;
  run("render", join(folder, "city.vxt"), "--size", size, "--spp", "4", "--traversal", "cpu", "-o", join(context.files, "still.png"), "--quiet");
  const bytes = readFileSync(join(context.files, "still.png")).toString("base64");
  // Both as pixels, by the same browser.
  const worst = (a, b) => page.evaluate(async ([a, b]) => {
    const pixels = async (png) => {
      const picture = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (letter) => letter.charCodeAt(0))]));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext("2d");
      context.drawImage(picture, 0, 0);
      return context.getImageData(0, 0, picture.width, picture.height).data;
    };
    const [left, right] = [await pixels(a), await pixels(b)];
    return left.length === right.length ? left.reduce((most, value, at) => Math.max(most, Math.abs(value - right[at])), 0) : 256;
  }, [a, b]);
  assert.equal(await worst(shown.png, bytes), 0);

  const stage = await page.locator(".stage canvas").boundingBox();
  const [x, y] = [stage.x + stage.width / 2, stage.y + stage.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 20; step++) {
    await page.mouse.move(x + 6 * step, y + step);
    await page.waitForTimeout(30);
  }
  const moving = await moved(page, Number(first.frame));
  await page.screenshot({ path: join(pictures, "serve-remote-moving.png") });
  await page.mouse.up();
  const last = await picture(page, Number(moving.frame));
  assert.ok(Number(last.view) > Number(first.view));
  const turned = await page.evaluate(() => document.querySelector(".stage canvas").toDataURL("image/png").split(",")[1]);
  assert.ok((await worst(turned, bytes)) > 50, "it shows something else");
  await page.locator(".stage canvas").focus();
  await page.keyboard.press("Home");
  await picture(page, Number(last.frame));
  const back = await page.evaluate(() => document.querySelector(".stage canvas").toDataURL("image/png").split(",")[1]);
  assert.equal(await worst(back, bytes), 0);
  assert.deepEqual(await violations(page), []);
  await close(page);
});

test("without the viewer and on a phone the server traces everything, and touch turns it", async () => {
  const plain = await start();
  const page = await visit("#/scene/city.vxt", { address: plain.address, viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2, colorScheme: "dark" });
  const first = await picture(page);
  const touch = (type, x, y) => page.evaluate(([type, x, y]) => {
    const canvas = document.querySelector(".stage canvas");
    canvas.setPointerCapture = () => {};
    canvas.dispatchEvent(new PointerEvent(type, { pointerId: 7, pointerType: "touch", clientX: x, clientY: y, buttons: 1, bubbles: true }));
  }, [type, x, y]);
  await touch("pointerdown", 200, 300);
  await touch("pointermove", 120, 320);
  await touch("pointerup", 120, 320);
  await picture(page, Number(first.frame));
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await page.screenshot({ path: join(pictures, "serve-phone.png") });
  // The server ends, and the page says so.
  assert.equal(await plain.end(), 0);
  await page.getByRole("alert").filter({ hasText: "the server" }).waitFor();
  await page.close();
});

test("a file that is dropped is converted, and takes another's place only when asked", async () => {
  const page = await visit("#/folder/older");
  await page.getByText("town.vox").waitFor();
  const drop = (name, path) =>
    page.evaluate(([name, text]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
      for (const type of ["dragover", "drop"]) dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }, [name, readFileSync(path).toString("base64")]);
  const written = join(folder, "older/new town.vxt");
  await drop("new town.vox", join(folder, "older/town.vox"));
  await page.getByText("new town.vox is here as").waitFor();
  await page.locator(".card", { hasText: "new town.vxt" }).locator("img").waitFor();
  await page.screenshot({ path: join(pictures, "serve-dropped.png") });
  const before = readFileSync(written);

  copyFileSync(join(folder, "older/town.glb"), join(context.files, "mesh.glb"));
  await drop("new town.glb", join(context.files, "mesh.glb"));
  await page.getByRole("dialog").waitFor();
  assert.match(await page.getByRole("dialog").innerText(), /new town\.vxt is there already/);
  assert.deepEqual(await violations(page), []);
  await page.screenshot({ path: join(pictures, "serve-asks.png") });
  await page.getByRole("button", { name: "Leave it" }).click();
  await page.getByText("and was left").waitFor();
  assert.ok(readFileSync(written).equals(before));
  await drop("new town.glb", join(context.files, "mesh.glb"));
  await page.getByRole("button", { name: "Replace it" }).click();
  await page.getByText("new town.glb is here as").waitFor();
  assert.ok(!readFileSync(written).equals(before));

  await drop("bad.vox", join(folder, "damaged.vox"));
  await page.locator("#uploads .alarm").filter({ hasText: "bad.vox: " }).waitFor();
  assert.ok(!existsSync(join(folder, "older/bad.vxt")));
  await close(page);
});
