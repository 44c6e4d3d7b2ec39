// Where the parts of a file for streaming lie, by its header and table; `docs/format.md`, "Files for streaming".
const MAGIC = "VOXTRACE";
const VERSION = 3;
const HEADER = 64;
const ENTRY = 32;

export interface Place {
  start: number;
  end: number;
  checksum: bigint;
}

export interface Layout {
  head: Place;
  /** The environment map, and what a grid was merged of, where there are any. */
  tail: Place | undefined;
  /** Front and chunks of each level, the finest one first. */
  levels: { front: Place; chunks: Place }[];
}

const text = (bytes: Uint8Array) => String.fromCharCode(...bytes);

/** Whether a file begins as one for streaming. */
export function isStreamed(head: Uint8Array): boolean {
  return head.length >= HEADER && text(head.subarray(0, 8)) === MAGIC && new DataView(head.buffer, head.byteOffset).getUint32(8, true) === VERSION;
}

/** The layout in the first bytes of a file. */
export function layoutOf(head: Uint8Array, checksum: (bytes: Uint8Array) => bigint): Layout {
  const view = new DataView(head.buffer, head.byteOffset, head.length);
  const count = view.getUint32(12, true);
  const end = HEADER + count * ENTRY;
  if (end > head.length) throw new Error("truncated or damaged: the section table is cut off");
  if (checksum(head.subarray(HEADER, end)) !== view.getBigUint64(16, true)) throw new Error("truncated or damaged: the checksum of the section table does not match");
  const places = new Map<string, Place>();
  for (let at = HEADER; at < end; at += ENTRY) {
    const [start, size] = [Number(view.getBigUint64(at + 8, true)), Number(view.getBigUint64(at + 16, true))];
    places.set(text(head.subarray(at, at + 4)), { start, end: start + size, checksum: view.getBigUint64(at + 24, true) });
  }
  const place = (tag: string) => {
    const found = places.get(tag);
    if (!found) throw new Error(`truncated or damaged: section ${tag} is missing`);
    return found;
  };
  const levels: Layout["levels"] = [];
  for (let level = 0; level === 0 || places.has(`FR${String(level).padStart(2, "0")}`); level++) {
    const number = String(level).padStart(2, "0");
    levels.push({ front: place(`FR${number}`), chunks: place(`CH${number}`) });
  }
  return { head: place("HEAD"), tail: places.get("TAIL"), levels };
}
