// Files of two drops, in Node: the page's own script with the few things of a browser that it needs for them. The argument is the page's folder.
import assert from "node:assert/strict";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

/** What the page does with elements. */
class Element extends EventTarget {
  children = [];
  dataset = {};
  returnValue = "";
  open = false;
  classList = { add() {}, remove() {} };
  append(...parts) { this.children.push(...parts); }
  replaceChildren(...parts) { this.children = parts; }
  setAttribute() {}
  removeAttribute() {}
  querySelectorAll() { return []; }
  get text() { return this.textContent ?? this.children.map((part) => part.text ?? part).join(""); }
  // Of a dialog that is open already, browsers say nothing.
  showModal() { this.open = true; }
  close(value) {
    this.returnValue = value;
    this.open = false;
    this.dispatchEvent(new Event("close"));
  }
}

const elements = new Map();
const element = (id) => elements.get(id) ?? elements.set(id, new Element()).get(id);
const page = new EventTarget();
Object.assign(globalThis, {
  document: { getElementById: element, createElement: () => new Element(), body: new Element() },
  location: { hash: "" },
  addEventListener: page.addEventListener.bind(page),
  IntersectionObserver: class { observe() {} },
  fetch: async (address) => Response.json(address === "/api/server" ? { folder: "scans", largest_upload: 1000 } : { folders: [], scenes: [] }),
});

/** Requests, in their order; in the folder there is already what each file would become. */
const sent = [];
let underWay = 0;
globalThis.XMLHttpRequest = class {
  upload = {};
  open(method, address) { this.address = address; }
  send() {
    sent.push(this.address.replace("/api/upload/", ""));
    assert.equal(++underWay, 1, "one file at a time");
    setTimeout(() => {
      underWay--;
      const name = this.address.match(/([^/]*)\.vox/)[1];
      // Browsers say the same of a server that is away and of a folder, whose bytes cannot be read.
      if (["away", "folder"].includes(name)) return this.onerror();
      const isThere = !this.address.endsWith("?replace=true") && name !== "new";
      this.status = isThere ? 409 : 201;
      this.response = isThere ? { error: `${name}.vxt is there already` } : { name: `${name}.vxt` };
      // An answer that is not understood.
      if (name === "odd") [this.status, this.response] = [201, {}];
      this.onload();
    }, 5);
  }
};

const asks = element("asks");
const question = () => element("question").text;
async function until(what, isSo) {
  for (const end = Date.now() + 120_000; !isSo(); ) {
    assert.ok(Date.now() < end, what);
    await new Promise((done) => setTimeout(done, 1));
  }
}
function drop(...names) {
  const event = Object.assign(new Event("drop"), { dataTransfer: { types: ["Files"], files: names.map((name) => ({ name })) } });
  page.dispatchEvent(event);
}

await import(pathToFileURL(join(process.argv[2], "page.js")));
drop("a.vox");
location.hash = "#/folder/inner";
drop("b.vox", "odd.vox", "new.vox");
await until("a question", () => asks.open);
// Time for what should not be: another question over this one.
await new Promise((done) => setTimeout(done, 50));
assert.match(question(), /^a\.vxt is there/);
asks.close("skip");
await until("a question of its own for the other", () => asks.open);
assert.match(question(), /^b\.vxt is there/);
asks.close("replace");
await until("all are sent", () => sent.length === 5 && underWay === 0);
assert.deepEqual(sent, ["a.vox", "inner/b.vox", "inner/b.vox?replace=true", "inner/odd.vox", "inner/new.vox"]);
const lines = () => element("uploads").children.map((line) => line.text);
await until("the last is told of", () => lines()[3] === "new.vox is here as new.vxt");
assert.equal(lines()[0], "a.vox: a.vxt is there already, and was left.");
assert.equal(lines()[1], "b.vox is here as b.vxt");
assert.match(lines()[2], /^odd\.vox: /);
// What the server would not take is not sent.
page.dispatchEvent(Object.assign(new Event("drop"), { dataTransfer: { types: ["Files"], files: [{ name: "huge.vox", size: 1001 }] } }));
await until("it is told why", () => /^huge\.vox: it is larger than the 1\.00 kB/.test(lines()[4] ?? ""));
assert.equal(sent.length, 5);
// Nor is what cannot be read the server's fault.
const given = (name, arrayBuffer) => ({ name, slice: () => ({ arrayBuffer }) });
const files = [given("folder.vox", () => Promise.reject(new Error("no file"))), given("away.vox", async () => new ArrayBuffer(1))];
page.dispatchEvent(Object.assign(new Event("drop"), { dataTransfer: { types: ["Files"], files } }));
await until("it is told which", () => lines()[6]?.startsWith("away.vox: "));
assert.match(lines()[5], /^folder\.vox: it cannot be read here; of a folder, /);
assert.equal(lines()[6], "away.vox: the server cannot be reached");
// An address that somebody has typed, with a sign that means nothing there: what goes wrong here ends the test.
location.hash = "#/folder/100%";
page.dispatchEvent(new Event("hashchange"));
await until("the folder's name is shown", () => element("trail").text.endsWith("100%"));
