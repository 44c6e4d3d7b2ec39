// The widget of notebooks in Chromium, with a kernel that the page plays. In JupyterLab itself it is tested by `notebook/jupyterlab.mjs`.
import assert from "node:assert/strict";
import { cpSync } from "node:fs";
import { join } from "node:path";
import { before, test } from "node:test";
import { comes, context, root, run, setUp, TIMEOUT } from "./browser.mjs";

setUp();
before(() => {
  run("convert", "city", join(context.files, "city.vxt"), "--voxels", "20k");
  cpSync(join(root, "python/voxtrace/notebook/static"), join(context.files, "widget"), { recursive: true });
});

/** A page with the widget, whose kernel holds the scene back until `window.release()`. */
async function show(renderer) {
  const page = await context.browser.newPage();
  page.errors = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  page.setDefaultTimeout(TIMEOUT);
  await page.goto(`${context.server.address}/test/page.html`);
  await page.evaluate(async (renderer) => {
    const bytesOf = async (address) => new Uint8Array(await (await fetch(address)).arrayBuffer());
    const [{ default: widget }, scene, picture] = await Promise.all([import("/files/widget/widget.js"), bytesOf("/files/city.vxt"), bytesOf("/test/poster.png")]);
    const released = new Promise((done) => (window.release = done));
    const about = { name: "city", bounds: [[0, 0, 0], [60, 60, 30]], bytes: scene.length };
    const look = { samples: 1, seed: 0, max_bounces: 4, exposure: 0, tone_map: "agx", clip: null, threshold: null, preset: "" };
    const traits = { ...look, renderer, height: 200, picked: null, _camera: [], _version: 1, _about: about, _poster: new DataView(new ArrayBuffer(0)), tracer: "", problem: "", samples_shown: 0 };
    const heard = new Map();
    const of = (name) => heard.get(name) ?? heard.set(name, new Set()).get(name);
    window.model = {
      get: (name) => traits[name],
      set(name, value) {
        traits[name] = value;
        for (const hear of of(`change:${name}`)) hear();
      },
      save_changes() {},
      on: (name, hear) => of(name).add(hear),
      off: (name, hear) => of(name).delete(hear),
      async send({ ask, id, name, from, length }) {
        const answer = (content, bytes) => of("msg:custom").forEach((hear) => hear({ id, ...content }, [new DataView(bytes.slice().buffer)]));
        if (ask === "file") answer({}, await bytesOf(`/files/widget/${name}`));
        else if (ask === "frame") answer({ samples: 1, camera: [1, -90, 30, 1, 2, 3, 0, 0, 1, 40] }, picture);
        else if (ask === "scene") {
          window.isAsked = true;
          await released;
          answer({ total: scene.length, version: 1 }, scene.subarray(from, from + length));
        }
      },
    };
    const place = document.createElement("div");
    document.body.append(place);
    window.end = widget.render({ model: window.model, el: place });
  }, renderer);
  return page;
}

const get = (page, ...names) => page.evaluate((names) => names.map((name) => window.model.get(name)), names);

test("the widget shows the kernel's scene, and tells the kernel from where", async () => {
  const page = await show("browser");
  await page.evaluate(() => window.release());
  await page.waitForFunction(() => window.model.get("samples_shown") === 1 && window.model.get("_camera").length === 10);
  assert.deepEqual(await get(page, "tracer"), ["browser"]);
  await page.evaluate(() => window.end());
  assert.ok(await comes(() => page.workers().length === 0), "its workers end with it");
  assert.deepEqual(page.errors, []);
  await page.close();
});

test("a scene that comes when the kernel traces already is for nobody", async () => {
  const page = await show("browser");
  await page.waitForFunction(() => window.isAsked);
  await page.evaluate(() => window.model.set("renderer", "kernel"));
  await page.waitForFunction(() => window.model.get("samples_shown") === 1 && window.model.get("_camera").length === 10);
  const before = await get(page, "tracer", "_camera");
  let workers = 0;
  page.on("worker", () => workers++);
  await page.evaluate(() => window.release());
  await page.waitForTimeout(2000);
  assert.deepEqual([await get(page, "tracer", "_camera"), workers, page.errors], [before, 0, []]);
  await page.close();
});
