// The widget in JupyterLab, as a person meets it: cells are run in the page, the picture is dragged and pressed, and other cells say what came back to the kernel.
// JUPYTER names the program `jupyter` of an environment that has voxtrace; `.ci/notebooks` runs this.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const pictures = join(root, "target/web/pictures");
mkdirSync(pictures, { recursive: true });
/** Of one wait, milliseconds: kernels start slowly on busy machines. */
const TIMEOUT = 120_000;
const TOKEN = "a-token-for-tests";

const CELLS = [
  'import voxtrace\nscene = voxtrace.builtin("church", voxels=20_000)\nview = voxtrace.view(scene, samples=4, height=300, device="cpu")\nview',
  'print("EYE", *(round(value, 3) for value in view.camera.eye), view.tracer)',
  // What is picked in the page against the rays of the kernel, from the camera that the page told it.
  `picked = view.picked
toward = [b - a for a, b in zip(view.camera.eye, picked["position"])]
hit = voxtrace.Renderer(scene, device="cpu").cast([view.camera.eye], [toward])
same = hit["voxel"][0].tolist() == picked["voxel"] and hit["instance"][0] == picked["instance"] and hit["material"][0] == picked["material"]
print("PICKED", same, *picked["voxel"], picked["color"])`,
  "view.camera = voxtrace.Camera((47, 17, 45), (17, 42, 5), fov=50)\nprint('LOOKED')",
  "low, high = scene.bounds\nview.clip = (low, (high[0], high[1], 0.5 * high[2]))\nprint('CLIPPED')",
  'view.renderer = "kernel"\nprint("KERNEL")',
  'volume = voxtrace.Volume.from_array([[[float(x + y + z) for z in range(24)] for y in range(24)] for x in range(24)])\nvalues = voxtrace.view(volume, height=240, samples=2, threshold=20.0)\nvalues',
  'print("THRESHOLD", values.threshold, values.scene.voxels)',
];

let browser, server, files, address;

before(async () => {
  files = mkdtempSync(join(tmpdir(), "voxtrace-lab-"));
  const cell = (source, index) => ({ cell_type: "code", id: `cell-${index}`, source, metadata: {}, outputs: [], execution_count: null });
  const kernelspec = { name: "python3", display_name: "Python 3", language: "python" };
  writeFileSync(join(files, "view.ipynb"), JSON.stringify({ cells: CELLS.map(cell), metadata: { kernelspec }, nbformat: 4, nbformat_minor: 5 }));
  const port = await freePort();
  address = `http://127.0.0.1:${port}`;
  const jupyter = process.env.JUPYTER;
  assert.ok(jupyter, "JUPYTER names the program");
  const options = ["--no-browser", "--allow-root", `--port=${port}`, "--port-retries=0", `--IdentityProvider.token=${TOKEN}`, `--ServerApp.root_dir=${files}`];
  // Nothing of whoever runs it: settings, and news from the network.
  const folders = Object.fromEntries(["JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "JUPYTERLAB_SETTINGS_DIR", "JUPYTERLAB_WORKSPACES_DIR", "IPYTHONDIR"].map((name) => [name, join(files, ".jupyter", name)]));
  const notification = join(folders.JUPYTERLAB_SETTINGS_DIR, "@jupyterlab/apputils-extension/notification.jupyterlab-settings");
  mkdirSync(dirname(notification), { recursive: true });
  writeFileSync(notification, '{ "checkForUpdates": false, "fetchNews": "false" }');
  server = spawn(jupyter, ["lab", ...options], { stdio: ["ignore", "pipe", "pipe"], env: { ...process.env, ...folders } });
  let said = "";
  for (const stream of [server.stdout, server.stderr]) stream.on("data", (data) => (said += data));
  for (let tries = 0; ; tries++) {
    const answer = await fetch(`${address}/api/status?token=${TOKEN}`).catch(() => undefined);
    if (answer?.ok) break;
    assert.ok(tries < 600 && server.exitCode === null, `JupyterLab does not start: ${said}`);
    await new Promise((done) => setTimeout(done, 250));
  }
  const executablePath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
  assert.ok(executablePath, "no Chromium: install it, or name it by CHROMIUM");
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-dev-shm-usage"] });
});

after(async () => {
  await browser?.close();
  if (server && server.exitCode === null) {
    const ended = new Promise((done) => server.once("exit", done));
    server.kill("SIGTERM");
    await ended;
  }
  if (files) rmSync(files, { recursive: true, force: true });
});

function freePort() {
  return new Promise((done) => {
    const probe = createServer().listen(0, "127.0.0.1", () => {
      const { port } = probe.address();
      probe.close(() => done(port));
    });
  });
}

/** The notebook in a page that gets nothing from elsewhere. `init` is a script that runs in it before all others. */
async function openNotebook(init) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 900 } });
  const page = await context.newPage();
  page.foreign = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && console.log(message.text().slice(0, 600)));
  page.on("pageerror", (error) => console.log(error.stack));
  await context.route((url) => url.protocol.startsWith("http") && url.hostname !== "127.0.0.1", (route) => {
    page.foreign.push(route.request().url());
    return route.abort();
  });
  if (init) await page.addInitScript(init);
  page.setDefaultTimeout(TIMEOUT);
  // The page says that a kernel is idle before it has one, and cells that are run until then are lost.
  const isThere = new Promise((done) => page.on("websocket", (socket) => socket.on("framereceived", ({ payload }) => String(payload).includes("kernel_info_reply") && done())));
  // A fresh workspace each time: tabs of the last page are not opened again.
  await page.goto(`${address}/lab/workspaces/w${Math.random().toString(36).slice(2)}/tree/view.ipynb?token=${TOKEN}`);
  await page.waitForSelector(".jp-NotebookPanel .jp-Cell");
  await isThere;
  await page.waitForSelector('.jp-Notebook-ExecutionIndicator[data-status="idle"]');
  await page.waitForTimeout(1000);
  return page;
}

/** A test with a page, whose last sight is kept where it fails. */
function testPage(name, init, body) {
  test(name, async () => {
    const page = await openNotebook(init);
    try {
      await body(page);
    } catch (error) {
      await page.screenshot({ path: join(pictures, "jupyterlab-failed.png") }).catch(() => {});
      throw error;
    } finally {
      await page.context().close();
    }
  });
}

const cellOf = (page, index) => page.locator(".jp-Notebook .jp-Cell").nth(index);

/** Runs a cell as one does, and gives the text that it prints, from the word on that it begins with. */
async function runCell(page, index, word) {
  const cell = cellOf(page, index);
  const prompt = cell.locator(".jp-InputPrompt");
  const before = await prompt.innerText();
  await cell.locator(".cm-content").click();
  await page.keyboard.press("Shift+Enter");
  await page.waitForFunction(([element, before]) => element.innerText !== before && /\[\d+\]/.test(element.innerText), [await prompt.elementHandle(), before]);
  if (!word) return undefined;
  const output = cell.locator(".jp-OutputArea-output", { hasText: word });
  await output.waitFor();
  return (await output.innerText()).trim();
}

const stage = (page, index) => cellOf(page, index).locator(".voxtrace-stage");

async function shownBy(page, index, text) {
  await cellOf(page, index).locator(".voxtrace-tracer", { hasText: text }).waitFor();
}

/** Scrolls to the element, which traces nothing while nobody sees it, and waits until its picture has all samples. */
async function isStill(page) {
  await stage(page, 0).scrollIntoViewIfNeeded();
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer")?.film()?.samples === 4);
}

/** How much the middle of a view differs from one colour: nothing is shown where it is 0. */
async function spread(page, locator) {
  const png = (await locator.screenshot()).toString("base64");
  return page.evaluate(async (png) => {
    const image = new Image();
    image.src = `data:image/png;base64,${png}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const values = Array.from({ length: data.length / 4 }, (_, at) => data[4 * at] + data[4 * at + 1] + data[4 * at + 2]);
    const mean = values.reduce((a, b) => a + b) / values.length;
    return Math.sqrt(values.reduce((a, b) => a + (b - mean) ** 2, 0) / values.length);
  }, png);
}

async function drag(page, locator, x, y) {
  await locator.scrollIntoViewIfNeeded();
  const box = await locator.boundingBox();
  const [left, top] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(left, top);
  await page.mouse.down();
  await page.mouse.move(left + x, top + y, { steps: 6 });
  await page.mouse.up();
}

/** What a ray down through the middle of the scene meets, in the page. */
async function castDown() {
  const viewer = document.querySelector("voxtrace-viewer");
  const [x0, y0, , x1, y1, z1] = viewer.scene.bounds;
  return [...(await viewer.cast(new Float32Array([(x0 + x1) / 2, (y0 + y1) / 2, z1 + 10, 0, 0, 0, -1, 1e9])))];
}

const eyeOf = (text) => text.split(" ").slice(1, 4).map(Number);
const apart = (a, b) => Math.hypot(...a.map((value, axis) => value - b[axis]));

/** Runs a cell until what it prints is right: a kernel that renders hears of what the page says when it has done that. */
async function runUntil(page, index, word, isRight) {
  for (let tries = 0; tries < 20; tries++) {
    const text = await runCell(page, index, word);
    if (isRight(text)) return text;
    await page.waitForTimeout(500);
  }
  assert.fail(`still ${await runCell(page, index, word)}`);
}

/** From where one looks, when that is elsewhere than `before` says. */
const eyeElsewhere = (page, before) => runUntil(page, 1, "EYE", (text) => apart(eyeOf(before), eyeOf(text)) > 5);

/** Presses a place of a view until the kernel names a voxel. */
async function pick(page, index, share) {
  const picked = cellOf(page, index).locator(".voxtrace-picked");
  const before = await picked.innerText();
  await stage(page, index).scrollIntoViewIfNeeded();
  const box = await stage(page, index).boundingBox();
  await page.mouse.click(box.x + box.width * share[0], box.y + box.height * share[1]);
  await page.waitForFunction(([element, before]) => element.innerText !== before, [await picked.elementHandle(), before]);
  return picked.innerText();
}

testPage("a scene is traced in the page, dragged, looked at from Python, cut, and its voxels come back to the kernel", undefined, async (page) => {
  await runCell(page, 0);
  await page.waitForSelector("voxtrace-viewer");
  await shownBy(page, 0, "this browser");
  await isStill(page);
  assert.ok((await spread(page, stage(page, 0))) > 20, "a picture");
  await page.screenshot({ path: join(pictures, "jupyterlab.png") });

  const first = await runCell(page, 1, "EYE");
  assert.match(first, / browser$/);
  await drag(page, stage(page, 0), 90, -30);
  const seen = await page.evaluate(() => document.querySelector("voxtrace-viewer").getCameraOrbit());
  const second = await eyeElsewhere(page, first);
  // Keys are the view's, not the notebook's.
  await page.locator("voxtrace-viewer canvas").first().focus();
  for (let presses = 0; presses < 4; presses++) await page.keyboard.press("ArrowLeft");
  await eyeElsewhere(page, second);

  const told = await pick(page, 0, [0.5, 0.6]);
  const voxel = (await runCell(page, 2, "PICKED")).split(" ");
  assert.equal(voxel[1], "True", "the kernel's ray meets what was picked");
  assert.ok(told.includes(`voxel ${voxel.slice(2, 5).join(", ")}`), `${told}: ${voxel.join(" ")}`);
  // A place beside it is another voxel: what stands there is not what stood there before.
  const other = await pick(page, 0, [0.4, 0.55]);
  assert.notEqual(other, told);

  await runCell(page, 3, "LOOKED");
  await page.waitForFunction((theta) => Math.abs(document.querySelector("voxtrace-viewer").getCameraOrbit().theta - theta) > 1, seen.theta);
  const target = await page.evaluate(() => document.querySelector("voxtrace-viewer").getCameraTarget());
  assert.deepEqual(target.map(Math.round), [17, 42, 5]);
  await isStill(page);
  const whole = await page.evaluate(castDown);
  await runCell(page, 4, "CLIPPED");
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer").clipBox !== "auto");
  const cut = await page.evaluate(castDown);
  assert.notDeepEqual(cut, whole);
  await isStill(page);
  await page.screenshot({ path: join(pictures, "jupyterlab-clipped.png") });

  // The same by the kernel's pictures.
  await runCell(page, 5, "KERNEL");
  await shownBy(page, 0, "kernel");
  await page.waitForSelector(".voxtrace-remote img");
  assert.equal(await page.locator("voxtrace-viewer").count(), 0, "workers have ended");
  const third = await runCell(page, 1, "EYE");
  assert.match(third, / kernel$/);
  await drag(page, stage(page, 0), -60, 20);
  const fourth = await eyeElsewhere(page, third);
  await page.locator(".voxtrace-remote").focus();
  for (let presses = 0; presses < 4; presses++) await page.keyboard.press("ArrowLeft");
  await eyeElsewhere(page, fourth);
  await pick(page, 0, [0.5, 0.6]);
  const remote = (await runCell(page, 2, "PICKED")).split(" ");
  assert.equal(remote[1], "True", "the kernel's ray meets what was picked");
  assert.ok((await spread(page, stage(page, 0))) > 20, "a picture");
  await page.screenshot({ path: join(pictures, "jupyterlab-kernel.png") });
  assert.deepEqual(page.foreign, [], "nothing comes from elsewhere");

  // A volume, whose threshold is moved in the panel.
  await runCell(page, 6);
  await shownBy(page, 6, "this browser");
  const panel = cellOf(page, 6).locator(".voxtrace-panel");
  await panel.locator("summary").click();
  const before = (await runCell(page, 7, "THRESHOLD")).split(" ");
  const slider = panel.locator(".voxtrace-histogram input");
  await slider.focus();
  for (let presses = 0; presses < 40; presses++) await page.keyboard.press("ArrowRight");
  const later = await runUntil(page, 7, "THRESHOLD", (text) => Number(text.split(" ")[1]) > Number(before[1]) + 4);
  assert.notEqual(later.split(" ")[2], before[2], "other voxels");
  await stage(page, 6).scrollIntoViewIfNeeded();
  await page.waitForTimeout(1000);
  await page.screenshot({ path: join(pictures, "jupyterlab-values.png") });
});

testPage("a browser without WebAssembly gets pictures of the kernel", "delete globalThis.WebAssembly", async (page) => {
  await runCell(page, 0);
  await shownBy(page, 0, "kernel");
  await page.waitForSelector(".voxtrace-remote img");
  await page.waitForTimeout(1500);
  assert.ok((await spread(page, stage(page, 0))) > 20, "a picture");
  await pick(page, 0, [0.5, 0.6]);
  const picked = (await runCell(page, 2, "PICKED")).split(" ");
  assert.equal(picked[1], "True");
});
