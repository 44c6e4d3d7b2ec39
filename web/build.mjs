// The package in `dist/` of the module in `wasm/`, which `cargo xtask web` builds: the element, its workers, the modules made smaller, the shaders, and types.
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { brotliCompressSync, constants } from "node:zlib";
import { build, transform } from "esbuild";

const MODULES = ["voxtrace", "gpu", "stream", "scenes", "readers"];
const SHADERS = "shaders.wgsl";
const here = (path) => fileURLToPath(new URL(path, import.meta.url));
process.chdir(here("."));
rmSync("dist", { recursive: true, force: true });
mkdirSync("dist");

// The element's style is a text in its module, without its blanks.
const smaller = async ({ path }) => ({ loader: "text", contents: (await transform(readFileSync(path, "utf8"), { loader: "css", minifyWhitespace: true })).code.trim() });
const style = { name: "style", setup: (build) => build.onLoad({ filter: /element\.css$/ }, smaller) };
const shared = { bundle: true, format: "esm", target: "es2022", minify: true, outdir: "dist", logLevel: "warning", plugins: [style] };
await build({ ...shared, entryPoints: { voxtrace: "src/index.ts" } });
await build({ ...shared, entryPoints: { "voxtrace-worker": "src/worker.ts", "gpu-worker": "src/gpu-worker.ts", "stream-worker": "src/streamer.ts", "scenes-worker": "src/maker.ts" } });
const readers = { name: "readers", setup: (build) => build.onResolve({ filter: /wasm\/scenes\.js$/ }, () => ({ path: here("wasm/readers.js") })) };
await build({ ...shared, entryPoints: { "readers-worker": "src/maker.ts" }, plugins: [readers] });
execFileSync("node", ["node_modules/typescript/bin/tsc", "--emitDeclarationOnly", "--declaration"], { stdio: "inherit" });
const features = ["--enable-simd", "--enable-bulk-memory", "--enable-nontrapping-float-to-int", "--enable-sign-ext", "--enable-mutable-globals", "--enable-reference-types", "--enable-multivalue"];
for (const module of MODULES) {
  // Offsets are put into loads, which do not wrap around: what lies below 1,024 is the end of the stack, and nobody reaches it from above 2³².
  const given = [`wasm/${module}_bg.wasm`, "-o", `dist/${module}.wasm`];
  execFileSync("node", ["node_modules/binaryen/bin/wasm-opt", ...features, "-Os", "--low-memory-unused", "--strip-debug", "--strip-producers", "--strip-target-features", ...given], { stdio: "inherit" });
}
copyFileSync(`wasm/${SHADERS}`, `dist/${SHADERS}`);
for (const name of ["LICENSE-MIT", "LICENSE-APACHE"]) copyFileSync(`../${name}`, name);

// What notebooks show scenes with: packed into the Python package, whose kernel sends it to the page.
const notebook = here("../python/voxtrace/notebook/static");
rmSync(notebook, { recursive: true, force: true });
await build({ ...shared, outdir: notebook, entryPoints: { widget: "src/notebook/index.ts" } });
copyFileSync("src/notebook/style.css", `${notebook}/widget.css`);
for (const file of ["voxtrace-worker.js", "voxtrace.wasm"]) copyFileSync(`dist/${file}`, `${notebook}/${file}`);

// What servers send.
const quality = { params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 22 } };
const sizes = {};
for (const file of ["voxtrace.js", SHADERS, ...MODULES.flatMap((module) => [`${module}-worker.js`, `${module}.wasm`])]) {
  const bytes = readFileSync(`dist/${file}`);
  sizes[file] = { bytes: bytes.length, brotli: brotliCompressSync(bytes, quality).length };
  console.log(`${file}: ${sizes[file].bytes} bytes, ${sizes[file].brotli} by Brotli`);
}
writeFileSync("sizes.json", JSON.stringify(sizes));
