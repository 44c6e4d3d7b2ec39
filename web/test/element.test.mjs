// What people do with the element: mouse, touch, keys, files; and what goes wrong.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { comes, context, count, event, open, run, setAttributes, setUp } from "./browser.mjs";

setUp();
before(() => {
  run("convert", "city", join(context.files, "city.vox"), "--voxels", "20k");
  const bytes = readFileSync(join(context.files, "city.vox"));
  const damaged = Buffer.from(bytes);
  writeFileSync(join(context.files, "cut.vox"), damaged.subarray(0, bytes.length / 2));
  writeFileSync(join(context.files, "notes.txt"), "These are no voxels, but a shopping list: milk, bread, and a kilogram of apples.\n");
});

const SCENE = { src: "/files/city.vox", samples: "2", "camera-controls": "", alt: "A small city" };
const orbit = (page) => page.evaluate(() => window.viewer.getCameraOrbit());
const near = (a, b, within = 1e-3) => Math.abs(a - b) < within;

/** The middle of the element on the page. */
async function middle(page) {
  const box = await page.locator("voxtrace-viewer").boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

/** Whether the canvas shows a picture: its pixels differ from each other. */
const variance = (page) =>
  page.evaluate(() => {
    const canvas = window.viewer.shadowRoot.querySelector("canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let [sum, squares] = [0, 0];
    for (let at = 0; at < data.length; at += 4) [sum, squares] = [sum + data[at], squares + data[at] ** 2];
    const count = data.length / 4;
    return squares / count - (sum / count) ** 2;
  });

test("a scene loads with progress, and the picture that stands still is told", async () => {
  const page = await open({ ...SCENE, src: "" });
  let release;
  const released = new Promise((done) => (release = done));
  await page.route(/city\.vox\?rate/, async (route) => {
    await released;
    await route.continue();
  });
  await setAttributes(page, { src: "/files/city.vox?rate=40000" });
  assert.ok((await variance(page)) < 1, "nothing is shown before");
  release();
  await event(page, "load");
  const still = await event(page, "still");
  assert.deepEqual([still.samples, still.width, still.height], [2, 320, 180]);
  const shares = await page.evaluate(() => window.events.filter(({ name }) => name === "progress").map(({ detail }) => detail.totalProgress));
  assert.ok(shares.length >= 4 && shares.every((share, at) => at === 0 || share >= shares[at - 1]), shares.join(" "));
  assert.ok(shares.some((share) => share > 0 && share < 0.6), "shares of the download");
  assert.equal(shares.at(-1), 1);
  assert.ok((await variance(page)) > 100, "a picture is shown");
  const blob = await page.evaluate(async () => {
    const blob = await window.viewer.toBlob();
    const picture = await createImageBitmap(blob);
    return [blob.type, blob.size > 1000, picture.width, picture.height];
  });
  assert.deepEqual(blob, ["image/png", true, 320, 180]);
  assert.deepEqual(page.errors, []);
  await page.close();
});

test("a drag turns, with the right button it moves, and the wheel zooms", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  const [start, at] = [await orbit(page), await middle(page)];
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 40, at.y + 20, { steps: 4 });
  await page.mouse.up();
  const turned = await orbit(page);
  assert.ok(near(turned.theta, start.theta - 14) && near(turned.phi, start.phi - 7) && near(turned.radius, start.radius, 1e-3 * start.radius));
  await page.mouse.move(at.x, at.y);
  assert.deepEqual(await orbit(page), turned, "without a button nothing moves");

  const target = await page.evaluate(() => window.viewer.getCameraTarget());
  await page.mouse.down({ button: "right" });
  await page.mouse.move(at.x + 30, at.y, { steps: 3 });
  await page.mouse.up({ button: "right" });
  const moved = await page.evaluate(() => window.viewer.getCameraTarget());
  assert.ok(Math.hypot(...moved.map((value, axis) => value - target[axis])) > 1e-3 * start.radius);
  assert.deepEqual(await orbit(page), turned);

  await page.mouse.wheel(0, -250);
  await page.waitForFunction((radius) => window.viewer.getCameraOrbit().radius < radius, turned.radius);
  assert.ok(near((await orbit(page)).radius, turned.radius * Math.exp(-0.5), 1e-3 * start.radius));
  const sources = await page.evaluate(() => window.events.filter(({ name }) => name === "camera-change").map(({ detail }) => detail.source));
  assert.deepEqual([sources[0], sources.at(-1)], ["none", "user-interaction"]);
  await event(page, "still", 1);
  await page.close();
});

test("keys turn, move and zoom, and Home shows the first view", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  const start = await orbit(page);
  await page.evaluate(() => {
    const status = window.viewer.shadowRoot.querySelector("[role=status]");
    window.said = [];
    new MutationObserver(() => window.said.push(status.textContent)).observe(status, { childList: true });
  });
  await page.keyboard.press("Tab");
  const focused = await page.evaluate(() => window.viewer.shadowRoot.activeElement?.tagName);
  assert.equal(focused, "CANVAS");
  await page.keyboard.press("ArrowRight");
  const right = await orbit(page);
  assert.ok(near(right.theta, start.theta - 8.4) && near(right.phi, start.phi));
  await page.keyboard.press("ArrowUp");
  assert.ok(near((await orbit(page)).phi, start.phi + 8.4));
  await page.keyboard.press("Shift+ArrowLeft");
  assert.ok(near((await orbit(page)).theta, right.theta), "with Shift it moves");
  await page.keyboard.press("+");
  assert.ok(near((await orbit(page)).radius, start.radius / 1.15, 1e-3 * start.radius));
  await page.keyboard.press("-");
  assert.ok(near((await orbit(page)).radius, start.radius, 1e-3 * start.radius));
  // People who do not see it are told where they look from, and then, or just before, that the picture is finished.
  const said = await page.waitForFunction(() => window.said.find((text) => text.startsWith("View from")));
  assert.match(await said.jsonValue(), /^View from .*, (level|\d+ degrees (above|below))$/);
  await page.keyboard.press("Home");
  assert.deepEqual(await orbit(page), start);
  await page.evaluate(() => (window.viewer.cameraControls = false));
  await page.keyboard.press("ArrowRight");
  assert.deepEqual(await orbit(page), start, "without camera-controls keys are the page's");
  await page.close();
});

test("one finger turns, two pinch and move", async () => {
  const page = await open(SCENE, { hasTouch: true });
  await event(page, "still");
  const [start, at] = [await orbit(page), await middle(page)];
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x: at.x + x, y: at.y + y, id })) });
  await touch("touchStart", [0, 0]);
  for (const x of [10, 20, 30]) await touch("touchMove", [x, 0]);
  await touch("touchEnd");
  const turned = await orbit(page);
  assert.ok(Math.abs(turned.theta - start.theta) > 5 && near(turned.radius, start.radius, 1e-3 * start.radius), JSON.stringify(turned));
  await touch("touchStart", [-20, 0], [20, 0]);
  for (const x of [25, 30, 40]) await touch("touchMove", [-x, 0], [x, 0]);
  await touch("touchEnd");
  const pinched = await orbit(page);
  assert.ok(pinched.radius < 0.6 * start.radius && pinched.radius > 0.4 * start.radius, `${pinched.radius} of ${start.radius}`);
  assert.ok(near(pinched.theta, turned.theta), "two fingers do not turn");
  await page.close();
});

test("a file that is dropped is shown and goes to no server", async () => {
  const page = await open({ ...SCENE, src: "" });
  const drop = (name, bytes) =>
    page.evaluate(([name, text]) => {
      const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const transfer = new DataTransfer();
      transfer.items.add(new File([bytes], name));
      for (const type of ["dragenter", "dragover", "drop"]) window.viewer.dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }, [name, bytes.toString("base64")]);
  const sent = [];
  page.on("request", (request) => sent.push(request));
  await drop("mine.vox", readFileSync(join(context.files, "city.vox")));
  const { info } = await event(page, "load");
  assert.ok(Math.abs(info.voxels - 20_000) < 4_000, `${info.voxels} voxels`);
  await event(page, "still");
  // What is not of the small module is read by the one with all readers: a mesh.
  run("convert", join(context.files, "city.vox"), join(context.files, "city.glb"));
  await drop("mine.glb", readFileSync(join(context.files, "city.glb")));
  const mesh = await event(page, "load", 1);
  assert.ok(mesh.info.voxels > 10_000);
  // Another tracer takes the same file, and a page may keep files for itself.
  await page.evaluate(() => (window.viewer.tracer = "cpu"));
  assert.equal((await event(page, "load", 2)).url, "mine.glb");
  await page.evaluate(() => (window.viewer.noDrop = true));
  assert.equal(await page.evaluate(() => window.viewer.hasAttribute("no-drop")), true);
  await drop("mine.vox", readFileSync(join(context.files, "city.vox")));
  await page.waitForTimeout(500);
  assert.deepEqual([await count(page, "load"), await page.evaluate(() => window.viewer.loaded)], [3, true]);
  assert.ok(sent.every((request) => request.method() === "GET" && !request.url().includes("mine")));
  await page.close();
});

test("what goes wrong is told in the library's own words", async () => {
  const cases = [
    ["/files/nothing.vox", /^nothing\.vox: the server answers 404 Not Found$/],
    ["/files/cut.vox", /^cut\.vox: /],
    ["/files/notes.txt", /^notes\.txt: .*\.vox/],
    ["scene:castle", /there is no built-in scene `castle`; there are city/],
    ["scene:city?voxels=many", /a number is expected, such as 200k or 1M/],
    ["scene:city?voxels=5", /from 1000 to/],
  ];
  for (const [src, expected] of cases) {
    const page = await open({ ...SCENE, src });
    const { type, message } = await event(page, "error");
    assert.equal(type, "loadfailure");
    assert.match(message, expected);
    const shown = page.locator("voxtrace-viewer").getByRole("alert");
    assert.equal(await shown.textContent(), message);
    assert.equal(await page.evaluate(() => window.viewer.loaded), false);
    assert.ok(await comes(() => page.workers().length === 0), "nobody keeps memory for what is not shown");
    // The next scene is shown as if nothing had been.
    await page.evaluate(() => {
      window.events = [];
      window.viewer.src = "/files/city.vox";
    });
    await event(page, "load");
    assert.equal(await shown.count(), 0);
    assert.deepEqual(page.errors, []);
    await page.close();
  }
});

test("the picture of the scene before does not stay behind an error", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  const opacity = () => page.evaluate(() => getComputedStyle(window.viewer.shadowRoot.querySelector("canvas")).opacity);
  assert.deepEqual([await opacity(), (await variance(page)) > 100], ["1", true]);
  await page.evaluate(() => window.viewer.removeAttribute("alt"));
  const label = () => page.evaluate(() => window.viewer.shadowRoot.querySelector("canvas").ariaLabel);
  assert.equal(await label(), "Voxels: city");
  await page.evaluate(() => (window.viewer.src = "/files/nothing.vox"));
  await event(page, "error");
  assert.deepEqual([await opacity(), await variance(page), await label()], ["0", 0, "Voxels"]);
  await page.close();
});

test("a picture has the pixels of the screen where that changes alone, and is drawn again on a canvas that the browser emptied", async () => {
  const page = await open(SCENE);
  assert.equal((await event(page, "still")).width, 320);
  await page.evaluate(() => {
    const canvas = window.viewer.shadowRoot.querySelector("canvas");
    canvas.width = canvas.width;
  });
  assert.equal(await variance(page), 0);
  await page.evaluate(() => window.viewer.shadowRoot.querySelector("canvas").dispatchEvent(new Event("contextrestored")));
  assert.ok(await comes(async () => (await variance(page)) > 100));
  assert.equal(await count(page, "still"), 1, "nothing is traced for that");
  const session = await page.context().newCDPSession(page);
  await session.send("Emulation.setDeviceMetricsOverride", { width: 640, height: 480, deviceScaleFactor: 2, mobile: false });
  const { width, height } = await event(page, "still", 1);
  assert.deepEqual([width, height], [640, 360]);
  await page.close();
});

test("an element that is wider than canvases can be has a picture of its shape", async () => {
  const page = await open(SCENE, { width: 200_000, height: 100 });
  const { width, height } = await event(page, "still");
  assert.deepEqual([width, height], [16_384, 8]);
  assert.ok((await variance(page)) > 0);
  await page.close();
});

test("in another document, as a window for picture-in-picture has one, it has its style and goes on", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  const position = () =>
    page.evaluate(() => {
      const canvas = window.viewer.shadowRoot.querySelector("canvas");
      return canvas.ownerDocument.defaultView.getComputedStyle(canvas).position;
    });
  assert.equal(await position(), "absolute");
  await page.evaluate(() => {
    const frame = document.createElement("iframe");
    document.body.append(frame);
    frame.contentDocument.body.append(window.viewer);
    window.viewer.cameraOrbit = "30deg 60deg 100%";
  });
  assert.equal(await position(), "absolute");
  await event(page, "still", 1);
  // Its size is heard of there.
  await page.evaluate(() => Object.assign(window.viewer.style, { width: "200px", height: "100px" }));
  await page.waitForFunction(() => window.events.some(({ name, detail }) => name === "still" && detail.width === 200));
  await page.evaluate(() => {
    document.querySelector("main").append(window.viewer);
    document.querySelector("iframe").remove();
    window.viewer.autoRotate = true;
  });
  assert.equal(await position(), "absolute");
  // It turns with frames of the page again: that window shows none any more.
  const moves = await count(page, "camera-change");
  await page.waitForFunction((moves) => window.events.filter(({ name }) => name === "camera-change").length > moves, moves);
  assert.deepEqual([await count(page, "load"), await count(page, "error"), page.errors], [1, 0, []]);
  // Planted: without it the canvas lies where it is written.
  await page.evaluate(() => (window.viewer.shadowRoot.adoptedStyleSheets = []));
  assert.equal(await position(), "static");
  await page.close();
});

test("a page that requires Trusted Types shows the scene where it allows the policy, and else why not", async () => {
  const write = (name, policies) => {
    const policy = `<meta http-equiv="Content-Security-Policy" content="require-trusted-types-for 'script'; trusted-types ${policies}">`;
    const viewer = '<script type="module" src="/package/voxtrace.js"></script><voxtrace-viewer src="city.vox" samples="1"></voxtrace-viewer>';
    writeFileSync(join(context.files, name), `<!doctype html>${policy}${viewer}`);
  };
  write("trusted.html", "voxtrace");
  write("refused.html", "another");
  const page = await open();
  await page.goto(`${context.server.address}/files/trusted.html`);
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer").film?.()?.samples === 1);
  // It is required, indeed.
  const markup = () => page.evaluate(() => ((document.createElement("p").innerHTML = "text"), "taken")).catch((error) => error.message);
  assert.match(await markup(), /TrustedHTML/);
  await page.goto(`${context.server.address}/files/refused.html`);
  const message = await page.waitForFunction(() => document.querySelector("voxtrace-viewer").shadowRoot?.querySelector("[role=alert]").textContent);
  assert.match(await message.jsonValue(), /policy.*voxtrace/i);
  assert.deepEqual(page.errors, []);
  await page.close();
});

test("a poster whose address is none hinders nothing, and one beside the page is found", async () => {
  const page = await open({ ...SCENE, reveal: "manual", poster: "http://[" });
  await event(page, "load");
  const picture = () => page.evaluate(() => getComputedStyle(window.viewer.shadowRoot.querySelector(".poster")).backgroundImage);
  assert.deepEqual([page.errors, await count(page, "error")], [[], 0]);
  await page.evaluate(() => (window.viewer.poster = 'poster "1".png?(2)'));
  assert.equal(await picture(), `url("${context.server.address}/test/poster%20%221%22.png?(2)")`);
  await page.evaluate(() => (window.viewer.poster = ""));
  assert.equal(await picture(), "none");
  await page.close();
});

test("a source that is taken away takes its scene along, also on its way", async () => {
  const { alt, ...scene } = SCENE;
  const page = await open(scene);
  await event(page, "still");
  const state = () =>
    page.evaluate(() => {
      const { loaded, scene, shadowRoot } = window.viewer;
      const [canvas, bar, message] = ["canvas", ".bar", ".message"].map((query) => shadowRoot.querySelector(query));
      return [loaded, scene, canvas.width, canvas.ariaLabel, bar.hidden, message.hidden];
    });
  const nothing = [false, undefined, 1, "Voxels", true, true];
  await page.evaluate(() => window.viewer.removeAttribute("src"));
  assert.deepEqual(await state(), nothing);
  assert.ok(await comes(() => page.workers().length === 0), "nobody keeps memory for what is not shown");
  // One that arrives, and one that could not be shown.
  await setAttributes(page, { src: "/files/city.vox?rate=1000" });
  await page.waitForFunction(() => window.events.at(-1).detail.totalProgress > 0);
  await setAttributes(page, { src: "" });
  assert.deepEqual(await state(), nothing);
  await setAttributes(page, { src: "/files/nothing.vox" });
  await event(page, "error");
  await setAttributes(page, { src: "" });
  assert.deepEqual(await state(), nothing);
  await page.waitForTimeout(300);
  assert.deepEqual([await count(page, "load"), await count(page, "error"), page.errors], [1, 1, []]);
  await page.close();
});

test("another scene that is asked for while one arrives takes its place", async () => {
  const page = await open({ ...SCENE, src: "/files/city.vox?rate=1000" });
  await event(page, "progress", 2);
  await page.evaluate(() => (window.viewer.src = "/files/city.vox"));
  const { url } = await event(page, "load");
  assert.equal(url, "/files/city.vox");
  await event(page, "still");
  assert.deepEqual([await count(page, "load"), await count(page, "error")], [1, 0]);
  await page.close();
});

test("a viewer that is removed gives its workers back, and one that is moved goes on", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  const workers = () => page.workers().length;
  assert.ok(workers() >= 1, `${workers()} workers`);
  await page.evaluate(() => document.querySelector("main").append(window.viewer));
  await page.waitForTimeout(100);
  assert.ok(workers() >= 1 && (await page.evaluate(() => window.viewer.loaded)));
  await page.evaluate(() => window.viewer.remove());
  assert.ok(await comes(() => workers() === 0), `${workers()} workers`);
  assert.deepEqual(await page.evaluate(() => [window.viewer.loaded, window.viewer.shadowRoot.querySelector("canvas").width]), [false, 1]);
  await page.evaluate(() => document.body.append(window.viewer));
  await event(page, "load", 1);
  await page.close();
});

test("exposure changes what is shown and not the film, and attributes place the camera", async () => {
  const page = await open(SCENE);
  await event(page, "still");
  const look = () => page.evaluate(() => [...window.viewer.shadowRoot.querySelector("canvas").getContext("2d").getImageData(0, 100, 320, 1).data].reduce((a, b) => a + b));
  const film = () => page.evaluate(() => window.viewer.film().words.reduce((a, b) => (a * 31 + b) >>> 0, 0));
  const [dark, before] = [await look(), await film()];
  await page.evaluate(() => (window.viewer.exposure = 2));
  await page.waitForFunction((dark) => [...window.viewer.shadowRoot.querySelector("canvas").getContext("2d").getImageData(0, 100, 320, 1).data].reduce((a, b) => a + b) > dark, dark);
  assert.equal(await film(), before);
  await page.evaluate(() => window.viewer.setAttribute("camera-orbit", "30deg 1rad 50%"));
  const { theta, phi } = await orbit(page);
  assert.ok(near(theta, 30) && near(phi, 180 / Math.PI));
  await event(page, "still", 1);
  assert.notEqual(await film(), before);
  await page.close();
});

test("what was set before the element was in a page holds, also before there was its class", async () => {
  const sum = (page) => page.evaluate(() => [...window.viewer.shadowRoot.querySelector("canvas").getContext("2d").getImageData(0, 100, 320, 1).data].reduce((a, b) => a + b));
  const [page, early] = [await open(SCENE), await open({ ...SCENE, exposure: "3" })];
  for (const each of [page, early]) await event(each, "still");
  const [dark, bright] = [await sum(page), await sum(early)];
  assert.ok(bright > dark, `${bright} and ${dark}`);
  await page.evaluate(() => (window.viewer.exposure = 3));
  assert.ok(await comes(async () => (await sum(page)) === bright), `${await sum(page)} and ${bright}`);
  await early.close();

  const set = 'Object.assign(document.querySelector("voxtrace-viewer"), { src: "city.vox", samples: 1, cameraControls: true });';
  writeFileSync(join(context.files, "early.html"), `<!doctype html><voxtrace-viewer></voxtrace-viewer><script>${set}</script><script type="module" src="/package/voxtrace.js"></script>`);
  await page.goto(`${context.server.address}/files/early.html`);
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer").film?.()?.samples === 1);
  assert.deepEqual(await page.evaluate(() => document.querySelector("voxtrace-viewer").getAttributeNames().sort()), ["camera-controls", "samples", "src"]);
  await page.close();
});

test("it turns by itself unless a person prefers less motion, and can be stopped", async () => {
  const page = await open({ ...SCENE, "auto-rotate": "" });
  await event(page, "load");
  const { theta } = await orbit(page);
  await page.waitForFunction((theta) => window.viewer.getCameraOrbit().theta !== theta, theta);
  const button = page.locator("voxtrace-viewer").getByRole("button", { name: "Pause" });
  await button.click();
  const stopped = (await orbit(page)).theta;
  await page.waitForTimeout(300);
  assert.equal((await orbit(page)).theta, stopped);
  await page.close();

  const calm = await open({ ...SCENE, "auto-rotate": "" }, { reducedMotion: "reduce" });
  await event(calm, "still");
  const first = await orbit(calm);
  await calm.waitForTimeout(500);
  assert.deepEqual(await orbit(calm), first);
  assert.equal(await calm.locator("voxtrace-viewer").getByRole("button").count(), 0);
  await calm.close();
});

test("a lazy viewer loads when it comes into view, and a poster waits for a press", async () => {
  const page = await open({ ...SCENE, loading: "lazy", reveal: "interaction", poster: "/test/poster.png" }, { height: 200 });
  const load = await event(page, "load");
  assert.ok(load);
  const poster = page.locator("voxtrace-viewer").getByRole("button", { name: "Show" });
  const isGone = () => page.evaluate(() => window.viewer.shadowRoot.querySelector(".poster").classList.contains("gone"));
  const film = () => page.evaluate(() => window.viewer.film()?.samples);
  await page.waitForTimeout(500);
  assert.deepEqual([await isGone(), await film(), await count(page, "still")], [false, undefined, 0], "what a poster covers is not traced");
  assert.equal(await page.locator("voxtrace-viewer").getByRole("progressbar").count(), 0, "and nothing seems to load");
  assert.equal(await page.evaluate(() => window.viewer.toBlob().catch((error) => error.message)), "there is no picture");
  const at = await middle(page);
  await page.mouse.click(at.x, at.y);
  assert.equal(await isGone(), true);
  await event(page, "still");
  assert.equal(await poster.count(), 0);
  // By keys as well, and put back it holds tracing up again.
  await page.evaluate(() => window.viewer.showPoster());
  assert.deepEqual([await isGone(), await film()], [false, undefined]);
  await page.evaluate(() => window.viewer.shadowRoot.activeElement?.blur());
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => window.viewer.shadowRoot.activeElement?.className), "poster", "the first that keys reach");
  await page.keyboard.press("Enter");
  assert.equal(await isGone(), true);
  await page.waitForFunction(() => window.viewer.film());
  assert.equal(await page.evaluate(() => window.viewer.shadowRoot.activeElement?.tagName), "CANVAS");
  await page.evaluate(() => {
    const other = document.createElement("voxtrace-viewer");
    other.setAttribute("loading", "lazy");
    other.style.marginTop = "3000px";
    document.body.append(other);
    other.src = "/files/city.vox?other";
    window.other = other;
  });
  const asked = () => context.server.asked.length;
  const before = asked();
  await page.waitForTimeout(300);
  assert.equal(asked(), before, "what nobody sees is not asked for");
  await page.evaluate(() => (window.other.src = "/files/city.vox?another"));
  await page.waitForTimeout(300);
  assert.equal(asked(), before, "nor is another one");
  await page.evaluate(() => window.other.scrollIntoView());
  await page.waitForFunction(() => window.other.loaded);
  // Nor does it wait where it is no longer to.
  await page.evaluate(() => {
    const last = document.createElement("voxtrace-viewer");
    Object.assign(last, { loading: "lazy", src: "/files/city.vox" });
    last.style.marginTop = "3000px";
    document.body.append(last);
    window.last = last;
  });
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => window.last.loaded), false);
  await page.evaluate(() => (window.last.loading = "eager"));
  await page.waitForFunction(() => window.last.loaded);
  await page.close();
});
