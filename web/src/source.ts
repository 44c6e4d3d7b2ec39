// What `src` names: a built-in scene, `scene:church?voxels=1M`, or the address of a file.
import { joined } from "./bytes.js";
import type { Source } from "./protocol.js";

/** A number as the command line takes it: `1M`, `200k`, `5000`. */
export function parseCount(text: string): number {
  const match = /^(\d+(?:\.\d+)?)([kMG])?$/.exec(text.trim());
  if (!match) throw new Error(`voxels=${text}: a number is expected, such as 200k or 1M`);
  const scale = { k: 1e3, M: 1e6, G: 1e9 }[match[2] ?? ""] ?? 1;
  return Math.round(Number(match[1]) * scale);
}

/** The built-in scene that `src` names; `undefined` for an address. */
export function builtIn(src: string): Source | undefined {
  if (!src.startsWith("scene:")) return undefined;
  const [name, query] = src.slice("scene:".length).split("?", 2);
  const voxels = new URLSearchParams(query ?? "").get("voxels");
  return { kind: "built-in", name: name!, ...(voxels ? { voxels: parseCount(voxels) } : {}) };
}

/** The last part of an address: the name of its file. */
export function fileName(url: URL): string {
  const name = url.pathname.split("/").pop() || url.hostname;
  try {
    return decodeURIComponent(name);
  } catch {
    // Not every % begins an escape, and not every escape is of UTF-8.
    return name;
  }
}

/** The bytes of a file from its server; of what fails once `signal` has ended it nobody is to be told. `onProgress` is told the share that has arrived, or
 * nothing where the server does not say how much there is. */
export async function download(url: URL, signal: AbortSignal, onProgress: (share: number | undefined) => void): Promise<Uint8Array> {
  const failed = (what: string): never => {
    throw new Error(`${fileName(url)}: ${what}`.trim());
  };
  const response = await fetch(url, { signal }).catch(() => {
    const isForeign = url.origin !== location.origin;
    return failed(`the server cannot be reached${isForeign ? "; a server elsewhere must allow this page by Access-Control-Allow-Origin" : ""}`);
  });
  if (!response.ok) failed(`the server answers ${response.status} ${response.statusText}`);
  // Of packed transfers the header has another length than the file.
  const isPlain = !response.headers.get("content-encoding");
  const total = isPlain ? Number(response.headers.get("content-length")) : 0;
  const chunks: Uint8Array[] = [];
  let length = 0;
  for (const reader = response.body!.getReader(); ; ) {
    const { done, value } = await reader.read().catch(() => failed("the connection to the server broke off"));
    if (done) break;
    chunks.push(value);
    length += value.length;
    onProgress(total > 0 ? Math.min(1, length / total) : undefined);
  }
  return joined(chunks, length);
}
