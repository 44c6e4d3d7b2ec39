// A plain static server for tests: files of several folders, with what servers get wrong on demand (slow, damaged, without a length, strange types).
import { createReadStream, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".png": "image/png", ".css": "text/css" };

/** Serves `mounts` (a path below which each folder lies); gives the address, the paths asked for, and how to end it. */
export async function serve(mounts) {
  const asked = [];
  const server = createServer((request, response) => {
    const url = new URL(request.url, "http://localhost");
    const path = decodeURIComponent(url.pathname);
    asked.push(path);
    const mount = Object.keys(mounts).sort((a, b) => b.length - a.length).find((mount) => path.startsWith(mount));
    const file = mount && join(mounts[mount], normalize(`/${path.slice(mount.length)}`));
    let size;
    try {
      const status = statSync(file);
      if (!status.isFile()) throw new Error("no file");
      size = status.size;
    } catch {
      response.writeHead(404, { "content-type": "text/html" }).end("<!doctype html><title>404</title>Nothing is here.");
      return;
    }
    // `?rate=BYTES` a second: a slow network.
    const rate = Number(url.searchParams.get("rate"));
    const headers = { "content-type": url.searchParams.get("type") ?? TYPES[extname(file)] ?? "application/octet-stream" };
    if (!url.searchParams.has("chunked")) headers["content-length"] = size;
    response.writeHead(200, headers);
    const stream = createReadStream(file, rate ? { highWaterMark: Math.max(1, Math.round(rate / 10)) } : {});
    response.on("close", () => stream.destroy());
    if (!rate) return void stream.pipe(response);
    stream.on("data", (chunk) => {
      stream.pause();
      response.write(chunk);
      setTimeout(() => stream.resume(), 100);
    });
    stream.on("end", () => response.end());
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return { address: `http://127.0.0.1:${server.address().port}`, asked, end: () => server.close() };
}
