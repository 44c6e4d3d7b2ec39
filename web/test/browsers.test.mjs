// The element in Firefox and in WebKit: the film is that of this machine, and people can do with it what they can in Chromium.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { context, count, differences, event, filmOf, native, open, pictures, run, setUpServer } from "./browser.mjs";
import { firefox, startFirefox, startWebkit, webkit } from "./others.mjs";

setUpServer();

const SIZE = { width: 96, height: 54, samples: 4 };

for (const [name, path, start] of [["Firefox", firefox, startFirefox], ["WebKit", webkit, startWebkit]]) {
  const isRequired = process.env.VOXTRACE_REQUIRE_BROWSERS === "1";
  const options = { skip: !path && !isRequired && `${name} is not here` };
  let browser;
  before(async () => {
    if (path || isRequired) browser = await start();
  });
  after(async () => browser?.close());

  for (const scene of [["city", "--voxels", "100k"], ["forest", "--instances", "100"]]) {
    test(`${name}: the film of ${scene[0]} is that of this machine`, options, async (t) => {
      const src = `scene:${scene[0]}?voxels=${scene[2]}`;
      const page = await open({ src, samples: "4", seed: "7" }, { ...SIZE, browser });
      await event(page, "still");
      const film = await filmOf(page);
      const expected = native(scene, { ...SIZE, seed: 7 });
      assert.equal(differences(film.words, expected), 0, "pixels that differ");
      assert.ok(differences(film.words, native(scene, { ...SIZE, seed: 8 })) > 1000, "another seed gives another film");
      t.diagnostic(`${await browser.version()}, WebGPU: ${await page.evaluate(async () => (navigator.gpu ? ((await navigator.gpu.requestAdapter().catch(() => null)) ? "yes" : "no adapter") : "no"))}`);
      assert.deepEqual(page.errors, []);
      await page.close();
    });
  }

  test(`${name}: a streamed scene comes by ranges, and its last film is that of this machine`, options, async () => {
    const file = join(context.files, `${name}.vxt`);
    run("convert", "city", file, "--voxels", "300k", "--stream");
    const page = await open({ src: `/files/${name}.vxt`, samples: "4", seed: "7" }, { ...SIZE, browser });
    await event(page, "still");
    const film = await filmOf(page);
    assert.equal(differences(film.words, native([file], { ...SIZE, seed: 7 })), 0);
    assert.ok(context.server.answers.filter(({ path }) => path === `/files/${name}.vxt`).length > 1, "several requests");
    await page.close();
  });

  test(`${name}: a drag and keys turn the camera, and the picture is looked at`, options, async () => {
    run("convert", "city", join(context.files, "small.vox"), "--voxels", "20k");
    const page = await open({ src: "/files/small.vox", samples: "8", "camera-controls": "", alt: "A small city" }, { width: 480, height: 270, browser });
    await event(page, "still");
    const orbit = () => page.evaluate(() => ({ ...window.viewer.getCameraOrbit() }));
    const first = await orbit();
    const box = await page.evaluate(() => window.viewer.getBoundingClientRect().toJSON());
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    await page.drag(middle, [middle[0] + 80, middle[1] + 20]);
    await page.waitForFunction((theta) => Math.abs(window.viewer.getCameraOrbit().theta - theta) > 0.1, first.theta);
    const turned = await orbit();
    assert.ok(Math.abs(turned.theta - first.theta) > 0.1, `${JSON.stringify(first)} ${JSON.stringify(turned)}`);
    await page.evaluate(() => window.viewer.focus());
    const before = await count(page, "camera-change");
    await page.press("ArrowLeft");
    await page.waitForFunction((before) => window.events.filter(({ name }) => name === "camera-change").length > before, before);
    // A picture that is finished after that.
    await page.waitForFunction(() => {
      const [changed] = window.events.filter(({ name }) => name === "camera-change").slice(-1);
      return window.events.some(({ name, at }) => name === "still" && at >= changed.at);
    });
    const colors = await page.evaluate(() => {
      const canvas = window.viewer.shadowRoot.querySelector("canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
    assert.ok(colors > 1000, `${colors} colours`);
    await page.screenshot({ path: join(pictures, `${name.toLowerCase()}.png`) });
    await page.close();
  });

  test(`${name}: a file that a person gives is shown, and what is wrong is told in one line`, options, async () => {
    const bytes = readFileSync(join(context.files, "small.vox"));
    writeFileSync(join(context.files, "cut.vox"), bytes.subarray(0, bytes.length / 2));
    for (const [src, problem] of [["/files/none.vox", /404/], ["/files/cut.vox", /damaged|ends|cut/]]) {
      const page = await open({ src }, { ...SIZE, browser });
      const { message } = await event(page, "error");
      assert.match(message, problem);
      assert.ok(!message.includes("\n"), message);
      await page.close();
    }
    const page = await open({ samples: "2" }, { ...SIZE, browser });
    await page.evaluate((text) => {
      const file = new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], "mine.vox");
      const data = new DataTransfer();
      data.items.add(file);
      window.viewer.dispatchEvent(new DragEvent("drop", { bubbles: true, cancelable: true, dataTransfer: data }));
    }, bytes.toString("base64"));
    await event(page, "still");
    assert.equal(differences((await filmOf(page)).words, native([join(context.files, "small.vox")], { ...SIZE, samples: 2 })), 0);
    await page.close();
  });
}
