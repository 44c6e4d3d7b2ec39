// Modules of the repository as Node imports them, whatever they are written in and wherever they lie.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { build } from "esbuild";
import { root } from "./browser.mjs";

export async function bundled(path) {
  const folder = mkdtempSync(join(tmpdir(), "voxtrace-module-"));
  const outfile = join(folder, "module.mjs");
  try {
    await build({ entryPoints: [join(root, path)], bundle: true, format: "esm", target: "es2022", outfile, logLevel: "error" });
    return await import(pathToFileURL(outfile).href);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
