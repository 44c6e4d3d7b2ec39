// A plain static server for tests: files of several folders, by ranges too, with what servers get wrong on demand (slow, damaged, cut off, without a length, without
// ranges, strange types, files that change).
import { createReadStream, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm", ".png": "image/png", ".css": "text/css" };

/**
 * Serves `mounts` (a path below which each folder lies); gives the address, the paths asked for, all answers (path, range, bytes sent, whether the client went away), and
 * how to end it. `faults` is a function that tests set: it is given each request (path, start, end) and may give `{ status }`, `{ etag }`, `{ cut: BYTES }`, `{ flip: BYTE }`,
 * `{ hold: { at: BYTE, until: PROMISE } }`, which sends what follows that byte when the promise is kept, and `{ breaks: BYTE }`, where the connection ends behind that byte.
 */
export async function serve(mounts) {
  const asked = [];
  const answers = [];
  const served = { asked, answers, faults: undefined };
  const server = createServer((request, response) => {
    const url = new URL(request.url, "http://localhost");
    const path = decodeURIComponent(url.pathname);
    asked.push(path);
    const mount = Object.keys(mounts).sort((a, b) => b.length - a.length).find((mount) => path.startsWith(mount));
    const file = mount && join(mounts[mount], normalize(`/${path.slice(mount.length)}`));
    let status;
    try {
      status = statSync(file);
      if (!status.isFile()) throw new Error("no file");
    } catch {
      response.writeHead(404, { "content-type": "text/html" }).end("<!doctype html><title>404</title>Nothing is here.");
      return;
    }
    const range = url.searchParams.has("whole") ? null : /^bytes=(\d+)-(\d*)$/.exec(request.headers.range ?? "");
    const start = range ? Number(range[1]) : 0;
    const end = range?.[2] ? Math.min(Number(range[2]) + 1, status.size) : status.size;
    const fault = served.faults?.({ path, start, end }) ?? {};
    const answer = { path, start, end, sent: 0, isCut: false };
    answers.push(answer);
    if (fault.status) return void response.writeHead(fault.status).end();
    if (range && start >= status.size) return void response.writeHead(416, { "content-range": `bytes */${status.size}` }).end();
    // `?rate=BYTES` a second: a slow network.
    const rate = Number(url.searchParams.get("rate"));
    const headers = { "content-type": url.searchParams.get("type") ?? TYPES[extname(file)] ?? "application/octet-stream" };
    headers.etag = fault.etag ?? `"${status.size}-${status.mtimeMs}"`;
    if (range) headers["content-range"] = `bytes ${start}-${end - 1}/${status.size}`;
    if (!url.searchParams.has("chunked")) headers["content-length"] = fault.cut ?? end - start;
    response.writeHead(range ? 206 : 200, headers);
    if (end === start) return void response.end();
    const stream = createReadStream(file, { start, end: start + (fault.cut ?? end - start) - 1, ...(rate ? { highWaterMark: Math.max(1, Math.round(rate / 10)) } : {}) });
    response.on("close", () => {
      answer.isCut = !response.writableFinished;
      stream.destroy();
    });
    let at = start;
    stream.on("data", (chunk) => {
      if (fault.flip >= at && fault.flip < at + chunk.length) chunk[fault.flip - at] ^= 0x41;
      at += chunk.length;
      answer.sent += chunk.length;
      const isFull = !response.write(chunk);
      if (at > fault.breaks) {
        stream.pause();
        setTimeout(() => response.destroy(), 50);
      } else if (fault.hold && at >= fault.hold.at) {
        stream.pause();
        void fault.hold.until.then(() => stream.resume());
      } else if (rate) {
        stream.pause();
        setTimeout(() => stream.resume(), 100);
      } else if (isFull) {
        stream.pause();
        response.once("drain", () => stream.resume());
      }
    });
    stream.on("end", () => response.end());
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  return Object.assign(served, { address: `http://127.0.0.1:${server.address().port}`, end: () => server.close() });
}
