// What `src` names. Node has all that it needs.
import assert from "node:assert/strict";
import { createServer } from "node:http";
import { test } from "node:test";
import { bundled } from "./bundled.mjs";

const { builtIn, download, fileName } = await bundled("web/src/source.ts");

test("a file has the last part of its address for a name, also where that is no text that was escaped", () => {
  const names = {
    "castle.vox": "castle.vox",
    "a%20b.vox?x=1": "a b.vox",
    "%E5%9F%8E.vox": "城.vox",
    "50%.vox": "50%.vox",
    "caf%E9.vox": "caf%E9.vox",
    "": "example.org",
  };
  for (const [path, name] of Object.entries(names)) assert.equal(fileName(new URL(`https://example.org/${path}`)), name);
});

test("a built-in scene has a name and a number of voxels", () => {
  assert.deepEqual(builtIn("scene:church?voxels=1.5M"), { kind: "built-in", name: "church", voxels: 1_500_000 });
  assert.deepEqual(builtIn("scene:city"), { kind: "built-in", name: "city" });
  assert.equal(builtIn("castle.vox"), undefined);
  assert.throws(() => builtIn("scene:city?voxels=many"), /a number is expected/);
});

test("a download that breaks off is told with the name of its file", async () => {
  const server = createServer((request, response) => {
    response.writeHead(200, { "content-length": "1000" });
    if (request.url !== "/broken.vox") return void response.end("v".repeat(1000));
    response.write("v".repeat(500));
    setTimeout(() => response.destroy(), 100);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const address = (name) => new URL(`http://127.0.0.1:${server.address().port}/${name}`);
  const get = (name, shares = []) => download(address(name), new AbortController().signal, (share) => shares.push(share));
  const shares = [];
  assert.equal((await get("whole.vox", shares)).length, 1000);
  assert.equal(shares.at(-1), 1);
  await assert.rejects(get("broken.vox"), { message: "broken.vox: the connection to the server broke off" });
  server.closeAllConnections();
  server.close();
});
