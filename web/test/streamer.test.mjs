// The worker that follows a file for streaming, alone: what it asks the server for, and that the scene at the end is the one of the file, by its hash. Node has all that it needs.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Worker } from "node:worker_threads";
import { run, web } from "./browser.mjs";
import { serve } from "./server.mjs";

const LOOK = { eye: [300, -400, 200], target: [100, 100, 30], field: 0.8, aspect: 16 / 9, height: 180 };
let folder;
let server;
let hash;
let module;
const path = (name) => join(folder, name);

before(async () => {
  folder = mkdtempSync(join(tmpdir(), "voxtrace-streamer-"));
  run("convert", "city", path("city.vxt"), "--voxels", "1M", "--stream");
  run("convert", "city", path("plain.vxt"), "--voxels", "200k");
  hash = JSON.parse(run("info", path("city.vxt"), "--json")).content_hash;
  module = new WebAssembly.Module(readFileSync(join(web, "dist/stream.wasm")));
  server = await serve({ "/": folder });
});
after(() => {
  server.end();
  rmSync(folder, { recursive: true, force: true });
});

/** A worker of pages in Node: what it says, until it is settled, has the scene itself, or fails. */
async function follow(name, { memory = 1024, faults } = {}) {
  const from = server.answers.length;
  server.faults = faults;
  const shim = `
    import { parentPort } from "node:worker_threads";
    globalThis.location = new URL(${JSON.stringify(server.address)});
    globalThis.addEventListener = (_, heard) => parentPort.on("message", (data) => heard({ data }));
    globalThis.postMessage = (message) => parentPort.postMessage(message);
    await import(${JSON.stringify(`file://${join(web, "dist/stream-worker.js")}`)});
    parentPort.postMessage({ kind: "ready" });`;
  const worker = new Worker(new URL(`data:text/javascript,${encodeURIComponent(shim)}`));
  const said = [];
  let looks = 0;
  try {
    await new Promise((done, failed) => {
      worker.on("error", failed);
      worker.on("message", (message) => {
        said.push({ ...message, sent: server.answers.slice(from).reduce((sum, { sent }) => sum + sent, 0) });
        if (message.kind === "ready") worker.postMessage({ kind: "open", module, name, url: `${server.address}/${name}`, memory: memory * 2 ** 20, threads: 1 });
        else if (message.kind === "scene" && !message.detail.isExact) {
          worker.postMessage({ kind: "look", look: LOOK, id: ++looks });
          worker.postMessage({ kind: "taken" });
        } else if (message.kind === "settled" ? message.id === looks : message.kind !== "progress") done();
      });
    });
  } finally {
    server.faults = undefined;
    await worker.terminate();
  }
  return { said, answers: server.answers.slice(from), scenes: said.filter(({ kind }) => kind === "scene"), last: said.at(-1) };
}

test("the first scene takes a quarter of a megabyte, the last one is that of the file, and nothing is fetched twice", async () => {
  const { scenes, answers, last } = await follow("city.vxt");
  assert.ok(scenes[0].sent <= 256 * 1024 && answers.length > 2, `${scenes[0].sent} bytes`);
  assert.ok(scenes.length >= 3 && scenes[0].detail.finest > 1 && !scenes[0].detail.isExact);
  assert.ok(last.detail.isExact && last.hash === hash, last.hash);
  assert.ok(last.sent < 1.02 * statSync(path("city.vxt")).size, `${last.sent} bytes`);
});

test("without ranges one answer does for all of it, and a plain file is handed on", async () => {
  const whole = await follow("city.vxt?whole");
  assert.equal(whole.answers.length, 1);
  assert.ok(whole.scenes.length >= 2 && whole.last.detail.isExact);
  for (const query of ["", "?whole"]) {
    const { last } = await follow(`plain.vxt${query}`);
    assert.equal(last.kind, "plain");
    assert.ok(readFileSync(path("plain.vxt")).equals(Buffer.from(last.bytes)));
  }
});

test("of a scene that does not fit there is a cut through its levels", async () => {
  const { scenes, last } = await follow("city.vxt", { memory: 4 });
  assert.equal(last.kind, "settled");
  assert.ok(scenes.length >= 2 && scenes.every(({ detail }) => !detail.isExact));
  assert.ok(last.sent < statSync(path("city.vxt")).size);
});

test("what is wrong with servers and files is one line", async () => {
  const after = (what, from = 100_000) => ({ start }) => (start > from ? what : undefined);
  const cases = [
    ["city.vxt", after({ status: 500 }), /^city\.vxt: the server answers 500/],
    ["city.vxt", after({ cut: 100 }), /^city\.vxt: the server sent 100 of \d+ bytes \(at byte \d+\)$/],
    ["city.vxt", after({ flip: statSync(path("city.vxt")).size - 9000 }), /^city\.vxt: .*chunk \d+ of level 0 is damaged: /],
    ["city.vxt", ({ start }) => ({ etag: `"${start}"` }), /^city\.vxt: the file on the server changed while it was read$/],
    // Of a plain file all that follows its head comes in one answer.
    ["plain.vxt", after({ breaks: 70_000 }, 0), /^plain\.vxt: the connection to the server broke off$/],
    ["plain.vxt?whole", () => ({ breaks: 70_000 }), /^plain\.vxt\?whole: the connection to the server broke off$/],
    ["plain.vxt", ({ start }) => ({ etag: `"${start}"` }), /^plain\.vxt: the file on the server changed while it was read$/],
    ["none.vxt", undefined, /^none\.vxt: the server answers 404 Not Found$/],
    ["empty.vxt", undefined, /^empty\.vxt: the file is empty$/],
    ["table.vxt", undefined, /^table\.vxt: truncated or damaged: the checksum of the section table does not match$/],
    ["cut.vxt", undefined, /^cut\.vxt: /],
  ];
  const bytes = readFileSync(path("city.vxt"));
  writeFileSync(path("empty.vxt"), "");
  writeFileSync(path("cut.vxt"), bytes.subarray(0, bytes.length / 2));
  bytes[70] ^= 1;
  writeFileSync(path("table.vxt"), bytes);
  for (const [name, faults, expected] of cases) {
    const { last } = await follow(name, { faults });
    assert.equal(last.kind, "error", name);
    assert.match(last.message, expected);
  }
  // A file that changed once is read from its start.
  let changed = false;
  const { last } = await follow("city.vxt", { faults: ({ start }) => ({ etag: (changed ||= start > 100_000) ? '"new"' : '"old"' }) });
  assert.ok(last.detail.isExact && last.hash === hash);
  // So is a plain one.
  changed = false;
  const plain = await follow("plain.vxt", { faults: ({ start }) => ({ etag: (changed ||= start > 0) ? '"new"' : '"old"' }) });
  assert.ok(readFileSync(path("plain.vxt")).equals(Buffer.from(plain.last.bytes ?? [])), plain.last.message);
});
