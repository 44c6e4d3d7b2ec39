// Pictures of the server, in Node: what comes is shown in its order, however long a browser reads it. The argument is the page's folder.
import assert from "node:assert/strict";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const drawn = [];
const made = {};
class Element extends EventTarget {
  dataset = {};
  clientWidth = 30;
  clientHeight = 20;
  append() {}
  setAttribute() {}
  replaceChildren() {}
  getContext() {
    return { drawImage: (picture) => drawn.push(picture.name) };
  }
}
let socket;
Object.assign(globalThis, {
  document: { createElement: (name) => (made[name] = new Element()) },
  location: { protocol: "http:", host: "localhost" },
  devicePixelRatio: 1,
  requestAnimationFrame: (does) => setTimeout(does, 0),
  ResizeObserver: class { observe() {} disconnect() {} },
  // A PNG takes longer to read.
  createImageBitmap: async (blob) => {
    await new Promise((done) => setTimeout(done, blob.type === "image/png" ? 60 : 5));
    return { name: await blob.text(), width: 3, height: 2, close() { this.width = this.height = 0; } };
  },
  WebSocket: class {
    static OPEN = 1;
    readyState = 1;
    said = [];
    constructor() { socket = this; }
    send(text) { this.said.push(JSON.parse(text)); }
    close() {}
  },
});

/** A picture as the server sends it, named for where it is. */
function show(frame, isWhole, name) {
  const head = new Uint8Array(new Uint32Array([frame, 1, 4, 4, isWhole ? 1 : 0]).buffer);
  socket.onmessage({ data: Uint8Array.from([...head, ...new TextEncoder().encode(name)]).buffer });
}
async function until(what, isSo) {
  for (const end = Date.now() + 120_000; !isSo(); ) {
    assert.ok(Date.now() < end, what);
    await new Promise((done) => setTimeout(done, 1));
  }
}

const { RemoteView } = await import(pathToFileURL(join(process.argv[2], "remote.js")));
new RemoteView(new Element(), "city.vxt", "city.vxt");
show(1, false, "coarse");
show(2, true, "whole, of the view before");
show(3, false, "coarse, of the next view");
const shown = () => socket.said.filter(({ type }) => type === "ack").map(({ frame }) => frame).sort();
await until("each is acknowledged, shown or not", () => shown().length === 3);
assert.deepEqual(shown(), [1, 2, 3]);
assert.deepEqual(drawn, ["coarse", "coarse, of the next view"]);
assert.deepEqual([made.canvas.dataset.frame, made.canvas.dataset.pixels], [3, "3x2"]);
