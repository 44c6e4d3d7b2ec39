// The package as pages get it: its size, its types, two lines in an empty page, React; and whether everybody can use it.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { build } from "esbuild";
import { context, event, open, pictures, run, setUp, TIMEOUT, violations, web } from "./browser.mjs";
import { serve } from "./server.mjs";

setUp();
let folder;
before(() => (folder = mkdtempSync(join(tmpdir(), "voxtrace-page-"))));
after(() => rmSync(folder, { recursive: true, force: true }));

/** Most bytes that a server sends compressed by Brotli; `docs/decisions/0210-viewer-for-pages.md` says what fills them. */
const MOST = {
  "voxtrace.js": 16_000,
  "shaders.wgsl": 40_000,
  "gpu-worker.js": 4_000,
  "gpu.wasm": 92_000,
  "voxtrace-worker.js": 4_000,
  "voxtrace.wasm": 300_000,
  "stream-worker.js": 8_000,
  "stream.wasm": 110_000,
  "scenes-worker.js": 4_000,
  "scenes.wasm": 330_000,
  "readers-worker.js": 4_000,
  "readers.wasm": 1_100_000,
};
const tooLarge = (sizes, most) => Object.entries(sizes).filter(([file, { brotli }]) => brotli > most[file]).map(([file]) => file);

test("the files are no larger than is promised", () => {
  const sizes = JSON.parse(readFileSync(join(web, "sizes.json"), "utf8"));
  assert.deepEqual(Object.keys(sizes).sort(), Object.keys(MOST).sort());
  assert.deepEqual(tooLarge(sizes, MOST), []);
  assert.deepEqual(tooLarge(sizes, { ...MOST, "voxtrace.wasm": 100_000 }), ["voxtrace.wasm"]);
});

/** The package, packed and installed into an empty folder. */
function install() {
  const project = join(folder, "project");
  mkdirSync(project, { recursive: true });
  const packed = execFileSync("npm", ["pack", "--silent", "--pack-destination", folder], { cwd: web, encoding: "utf8" }).trim().split("\n").at(-1);
  writeFileSync(join(project, "package.json"), '{ "private": true, "type": "module" }');
  execFileSync("npm", ["install", "--silent", "--no-audit", "--no-fund", "--offline", join(folder, packed)], { cwd: project, stdio: "inherit" });
  return project;
}

test("the packed package needs two lines in an empty page, and its types hold", async () => {
  const project = install();
  run("convert", "city", join(project, "city.vox"), "--voxels", "20k");
  writeFileSync(
    join(project, "index.html"),
    '<script type="module" src="node_modules/voxtrace/dist/voxtrace.js"></script>\n<voxtrace-viewer src="city.vox" samples="1"></voxtrace-viewer>\n',
  );
  const server = await serve({ "/": project });
  const page = await context.browser.newPage();
  page.setDefaultTimeout(TIMEOUT);
  await page.goto(`${server.address}/index.html`);
  await page.waitForFunction(() => document.querySelector("voxtrace-viewer").film?.()?.samples === 1);
  await page.close();
  server.end();
  // What a page of files that this module reads asks for, where there is no WebGPU, is the small module alone.
  assert.ok(!server.asked.some((path) => /scenes|readers|gpu|shaders/.test(path)), server.asked.join(" "));

  const check = (name, text) => {
    writeFileSync(join(project, name), text);
    const options = ["--noEmit", "--strict", "--target", "es2022", "--module", "esnext", "--moduleResolution", "bundler", "--jsx", "react-jsx", "--skipLibCheck", "false"];
    try {
      execFileSync("node", [join(web, "node_modules/typescript/bin/tsc"), ...options, "--lib", "es2022,dom,dom.iterable", name], { cwd: project, encoding: "utf8" });
      return "";
    } catch (error) {
      return error.stdout;
    }
  };
  const use = 'import { VoxtraceViewer } from "voxtrace";\nconst viewer: VoxtraceViewer = document.querySelector("voxtrace-viewer")!;\n';
  assert.equal(check("right.ts", `${use}viewer.samples = 3;\n`), "");
  assert.match(check("wrong.ts", `${use}viewer.samples = "three";\n`), /not assignable/);
  for (const name of ["react", "react-dom", "csstype", "@types"]) symlinkSync(join(web, "node_modules", name), join(project, "node_modules", name));
  const example = readFileSync(join(web, "examples/react.tsx"), "utf8");
  assert.equal(check("react.tsx", example), "");
  assert.match(check("wrong.tsx", example.replace("samples={4}", 'loading="soon"')), /soon/);
  assert.match(check("box.tsx", example.replace("samples={4}", "clip-box={4}")), /not assignable/);
  assert.equal(check("pick.tsx", example.replace("samples={4}", 'onvoxel-pick={({ detail }) => setText(String(detail?.voxel))}')), "");
});

test("the example of React shows a picture and hears of it", async () => {
  mkdirSync(join(folder, "react"), { recursive: true });
  const bundle = join(folder, "react/app.js");
  await build({ entryPoints: [join(web, "examples/react.tsx")], outfile: bundle, bundle: true, format: "esm", jsx: "automatic", external: ["voxtrace"], logLevel: "error", define: { "process.env.NODE_ENV": '"production"' } });
  const imports = JSON.stringify({ imports: { voxtrace: "/package/voxtrace.js" } });
  writeFileSync(join(folder, "react/index.html"), `<!doctype html><script type="importmap">${imports}</script><body><script type="module" src="app.js"></script>`);
  const server = await serve({ "/": join(folder, "react"), "/package/": join(web, "dist") });
  const page = await context.browser.newPage();
  page.setDefaultTimeout(TIMEOUT);
  await page.goto(`${server.address}/index.html`);
  await page.getByRole("paragraph").filter({ hasText: "The picture is finished." }).waitFor();
  const film = () => page.evaluate(() => window.document.querySelector("voxtrace-viewer").film()?.samples);
  assert.equal(await film(), 4);
  await page.getByRole("slider").fill("2");
  assert.equal(await page.evaluate(() => document.querySelector("voxtrace-viewer").exposure), 2);
  await page.close();
  server.end();
});

for (const colorScheme of ["light", "dark"]) {
  test(`everybody can use it, by axe, on a ${colorScheme} page`, async () => {
    run("convert", "city", join(context.files, "city.vox"), "--voxels", "20k");
    const page = await open({ src: "/files/city.vox", samples: "1", alt: "A small city", "camera-controls": "", "auto-rotate": "" }, { colorScheme });
    await event(page, "load");
    await page.waitForFunction(() => !window.viewer.shadowRoot.querySelector("button").hidden);
    assert.deepEqual(await violations(page), []);
    await page.evaluate(() => (window.viewer.src = "/files/nothing.vox"));
    await event(page, "error");
    assert.deepEqual(await violations(page), []);
    await page.screenshot({ path: join(pictures, `error-${colorScheme}.png`) });
    await page.evaluate(() => window.viewer.shadowRoot.querySelector("canvas").removeAttribute("aria-label"));
    assert.match((await violations(page)).join(), /role-img-alt/);
    await page.close();
  });
}

for (const [name, width, height] of [["phone", 390, 844], ["desktop", 1280, 800]]) {
  test(`the example fits the width of a ${name}`, async () => {
    const page = await context.browser.newPage({ viewport: { width, height }, colorScheme: name === "phone" ? "dark" : "light" });
    page.setDefaultTimeout(TIMEOUT);
    await page.route("**/examples/plain.html", async (route) => {
      const html = readFileSync(join(web, "examples/plain.html"), "utf8");
      await route.fulfill({ contentType: "text/html", body: html.replaceAll("../dist/", "/package/").replaceAll("church?voxels=1M", "church?voxels=200k").replace('samples="256"', 'samples="2"') });
    });
    await page.goto(`${context.server.address}/examples/plain.html`);
    await page.waitForFunction(() => document.querySelector("voxtrace-viewer").film?.()?.samples === 2);
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width, "nothing sticks out");
    const box = await page.locator("voxtrace-viewer").boundingBox();
    assert.ok(box.width > 0.85 * Math.min(width, 1152) && box.height > 200, JSON.stringify(box));
    assert.deepEqual(await violations(page), []);
    await page.screenshot({ path: join(pictures, `${name}.png`) });
    await page.close();
  });
}
