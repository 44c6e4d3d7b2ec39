// Chromium for tests: one browser, a page for each test, and what tests ask of the element.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { after, before } from "node:test";
import { chromium } from "playwright-core";
import { serve } from "./server.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
export const web = join(here, "..");
export const root = join(web, "..");
export const program = process.env.VOXTRACE_PROGRAM ?? join(root, "target/release/voxtrace");
export const words = process.env.VOXTRACE_WORDS ?? join(root, "target/release/examples/words");
/** Real files, where they are. */
const data = process.env.VOXTRACE_DATA ?? join(root, "../shared/data");
/** Where tests leave what people look at. */
export const pictures = join(root, "target/web/pictures");
mkdirSync(pictures, { recursive: true });

/** How long a page may take for one thing on a machine on which others have the processors, milliseconds. */
export const TIMEOUT = 240_000;

/** Waits until something is so; whether it came to be. */
export async function comes(isSo) {
  for (const end = Date.now() + TIMEOUT; ; ) {
    if (await isSo()) return true;
    if (Date.now() > end) return false;
    await new Promise((done) => setTimeout(done, 50));
  }
}

export const context = { browser: undefined, server: undefined, files: undefined };

/** What lets Chromium have WebGPU without a GPU. */
export const WEBGPU = ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-unsafe-swiftshader"];

/** Starts a server of the package, of pages and of files for the tests of a file, and ends it. */
export function setUpServer() {
  before(async () => {
    context.files = mkdtempSync(join(tmpdir(), "voxtrace-web-"));
    context.server = await serve({ "/package/": join(web, "dist"), "/test/": here, "/files/": context.files, "/examples/": join(web, "examples") });
  });
  after(() => {
    context.server?.end();
    if (context.files) rmSync(context.files, { recursive: true, force: true });
  });
}

/** Starts what the tests of a file need, with `more` arguments of Chromium, then does what is to follow; and ends it. */
export function setUp(more = [], follow = async () => {}) {
  setUpServer();
  before(async () => {
    const executablePath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
    assert.ok(executablePath, "no Chromium: install it, or name it by CHROMIUM");
    context.browser = await chromium.launch({ executablePath, args: ["--no-sandbox", "--disable-dev-shm-usage", ...more], timeout: TIMEOUT });
    await follow();
  });
  after(async () => context.browser?.close());
}

/** Whether Chromium has WebGPU, once `setUpWebGpu` has looked. */
const webGpu = { has: false };

/** Starts Chromium with WebGPU, which is a failure to be without where VOXTRACE_REQUIRE_WEBGPU says so, then does what is to follow. */
export function setUpWebGpu(follow = async () => {}) {
  setUp(WEBGPU, async () => {
    const probe = await context.browser.newPage();
    probe.setDefaultTimeout(TIMEOUT);
    await probe.goto(`${context.server.address}/test/page.html`);
    webGpu.has = await probe.evaluate(async () => !!(await navigator.gpu?.requestAdapter()));
    await probe.close();
    if (!webGpu.has && process.env.VOXTRACE_REQUIRE_WEBGPU) throw new Error("this Chromium has no WebGPU adapter, and VOXTRACE_REQUIRE_WEBGPU asks for one");
    if (webGpu.has) await follow();
  });
}

/** Skips a test where there is no WebGPU. */
export const skipsWebGpu = (t) => !webGpu.has && (t.skip("this Chromium has no WebGPU adapter"), true);

/** A page with an element, `said` with what its console says, and its devices in `window.devices`. Compiling takes a while on the processor. */
export async function openWebGpu(options, timeout = TIMEOUT) {
  const page = await open({}, options);
  page.said = [];
  page.on("console", (message) => page.said.push(message.text()));
  page.setDefaultTimeout(timeout);
  await page.evaluate(() => {
    window.devices = [];
    const request = GPUAdapter.prototype.requestDevice;
    GPUAdapter.prototype.requestDevice = async function (...given) {
      const device = await request.apply(this, given);
      window.devices.push(device);
      return device;
    };
  });
  return page;
}

/** Sets attributes of a page's element. */
export const setAttributes = (page, attributes) =>
  page.evaluate((attributes) => {
    for (const [name, value] of Object.entries(attributes)) window.viewer.setAttribute(name, value);
  }, attributes);

/** A page with an element of these attributes, and what it wrote to its console. */
export async function open(attributes = {}, options = {}) {
  const { width = 320, height = 180, browser = context.browser, ...rest } = options;
  const page = browser === context.browser ? await browser.newPage({ viewport: { width: 640, height: 480 }, ...rest }) : await browser.newPage();
  page.errors = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  page.setDefaultTimeout(TIMEOUT);
  await page.goto(`${context.server.address}/test/page.html`);
  await page.evaluate(([attributes, width, height]) => {
    const viewer = document.createElement("voxtrace-viewer");
    Object.assign(viewer.style, { width: `${width}px`, height: `${height}px` });
    window.events = [];
    for (const name of ["load", "progress", "error", "camera-change", "detail-change", "still", "voxel-pick"]) {
      viewer.addEventListener(name, ({ detail }) => window.events.push({ name, at: performance.now(), detail: name === "error" ? { ...detail, sourceError: null } : detail }));
    }
    for (const [name, value] of Object.entries(attributes)) viewer.setAttribute(name, value);
    document.querySelector("main").append(viewer);
    window.viewer = viewer;
  }, [attributes, width, height]);
  return page;
}

/** Waits for an event, from the one of that number on, and gives its detail. */
export async function event(page, name, number = 0) {
  const handle = await page.waitForFunction(([name, number]) => {
    const failure = window.events.find((event) => event.name === "error");
    if (failure && name !== "error") return { failure: failure.detail.message };
    return window.events.filter((event) => event.name === name)[number];
  }, [name, number]);
  const found = await handle.jsonValue();
  assert.equal(found.failure, undefined, `waiting for ${name}`);
  return found.detail;
}

/** How many events there were. */
export const count = (page, name) => page.evaluate((name) => window.events.filter((event) => event.name === name).length, name);

/** The words of the film of the view that stands still. */
export async function filmOf(page) {
  const film = await page.evaluate(() => {
    const film = window.viewer.film();
    let text = "";
    for (let at = 0; at < film.words.length; at += 8192) text += String.fromCharCode(...film.words.subarray(at, at + 8192));
    return { ...film, words: btoa(text) };
  });
  return { ...film, words: Buffer.from(film.words, "base64") };
}

/** Number of pixels whose words differ. */
export function differences(a, b) {
  if (a.length !== b.length) return Infinity;
  let count = 0;
  for (let at = 0; at < a.length; at += 32) count += a.compare(b, at, at + 32, at, at + 32) === 0 ? 0 : 1;
  return count;
}

/** The words of the film that the program renders of a scene: those before the checksum, where nothing follows the pixels. */
export function native(scene, { width, height, samples, seed = 0 }, more = []) {
  const film = join(context.files, "native.vxf");
  rmSync(film, { force: true });
  const size = ["--size", `${width}x${height}`, "--samples", samples, "--seed", seed].map(String);
  run("render", ...scene, ...size, "--traversal", "cpu", "--checkpoint", film, "-o", join(context.files, "native.png"), "--quiet", ...more);
  const bytes = readFileSync(film);
  return bytes.subarray(bytes.length - 8 - width * height * 32, bytes.length - 8);
}

export function run(...given) {
  return execFileSync(program, given, { encoding: "utf8", maxBuffer: 1 << 28, stdio: ["ignore", "pipe", "pipe"] });
}

/** What axe finds on a page, also on one that lets no further scripts in. */
export async function violations(page) {
  await page.evaluate(readFileSync(join(web, "node_modules/axe-core/axe.min.js"), "utf8"));
  return page.evaluate(async () => (await window.axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html).join(" ")}`));
}

/** The path of a real file, or undefined where it is not. */
export function real(path) {
  const file = join(data, path);
  return existsSync(file) ? file : undefined;
}
