// Which chunks a view needs: a cut through the tree of chunks that is refined where voxels are largest on the screen, the middle of the picture before its edges, until
// they are as small as a pixel or the memory is used up.

/** A chunk of a level. Each has up to eight children in the level below. */
export interface Chunk {
  level: number;
  number: number;
  grid: number;
  at: [number, number, number];
  /** Bytes in memory, and where its compressed ones lie in the file. */
  size: number;
  start: number;
  end: number;
}

export interface Look {
  eye: [number, number, number];
  target: [number, number, number];
  /** Radians up and down, width over height, and rows of the picture. */
  field: number;
  aspect: number;
  height: number;
}

/** Bricks along a chunk are 16, of 8 voxels. */
const EDGE = 128;
/** What an instance of a chunk takes beside its voxels, bytes. */
const PLACED = 200;
/** How much less what is outside of the picture counts: it is seen in shadows and reflections. */
const OUTSIDE = 0.2;

/** The chunks of the levels whose fronts are there. */
export class Chunks {
  readonly #levels = new Map<number, Map<string, Chunk>>();
  /** Of each grid its instances: matrix (columns) and translation, twelve numbers. */
  readonly #instances = new Map<number, number[][]>();

  constructor(instances: Float64Array) {
    for (let at = 0; at < instances.length; at += 13) {
      const grid = instances[at]!;
      const all = this.#instances.get(grid) ?? [];
      all.push(Array.from(instances.subarray(at + 1, at + 13)));
      this.#instances.set(grid, all);
    }
  }

  /** Takes the index of a level, six numbers for each chunk; its chunks begin at `start` in the file. */
  add(level: number, index: Float64Array, start: number) {
    const chunks = new Map<string, Chunk>();
    for (let at = 0, number = 0; at < index.length; at += 6, number++) {
      const [grid, x, y, z, size, stored] = index.subarray(at, at + 6) as unknown as [number, number, number, number, number, number];
      chunks.set(`${grid},${x},${y},${z}`, { level, number, grid, at: [x, y, z], size, start, end: start + stored });
      start += stored;
    }
    this.#levels.set(level, chunks);
  }

  has(level: number): boolean {
    return this.#levels.has(level);
  }

  of(level: number): Chunk[] {
    return [...(this.#levels.get(level)?.values() ?? [])];
  }

  childrenOf({ level, grid, at: [x, y, z] }: Chunk): Chunk[] {
    const below = this.#levels.get(level - 1);
    const found: Chunk[] = [];
    for (let corner = 0; corner < 8; corner++) {
      const child = below?.get(`${grid},${2 * x + (corner & 1)},${2 * y + ((corner >> 1) & 1)},${2 * z + (corner >> 2)}`);
      if (child) found.push(child);
    }
    return found;
  }

  cost({ grid, size }: Chunk): number {
    return size + PLACED * (this.#instances.get(grid)?.length ?? 0);
  }

  /** How large its voxels are on the screen, pixels, less towards the edges of the picture; the largest of its instances. */
  error(chunk: Chunk, look: Look): number {
    const voxel = 2 ** chunk.level;
    const center = chunk.at.map((place) => (place + 0.5) * EDGE * voxel) as [number, number, number];
    const forward = unit(look.target.map((value, axis) => value - look.eye[axis]!));
    const perRadian = look.height / (2 * Math.tan(look.field / 2));
    const edge = Math.atan(Math.tan(look.field / 2) * Math.hypot(1, look.aspect));
    let most = 0;
    for (const m of this.#instances.get(chunk.grid) ?? []) {
      const offset = [0, 1, 2].map((axis) => m[axis]! * center[0] + m[3 + axis]! * center[1] + m[6 + axis]! * center[2] + m[9 + axis]! - look.eye[axis]!);
      const scale = Math.hypot(m[0]!, m[1]!, m[2]!);
      const [length, radius] = [Math.hypot(...offset), 0.87 * EDGE * voxel * scale];
      const nearest = Math.max(length - radius, 0.05 * radius);
      const angle = length > radius ? Math.max(0, Math.acos(Math.max(-1, Math.min(1, dot(offset, forward) / length))) - Math.asin(Math.min(1, radius / length))) : 0;
      const weight = angle > edge ? OUTSIDE : 1 - 0.4 * (angle / edge);
      most = Math.max(most, ((voxel * scale) / nearest) * perRadian * weight);
    }
    return most;
  }
}

const dot = (a: number[], b: number[]) => a[0]! * b[0]! + a[1]! * b[1]! + a[2]! * b[2]!;
const unit = (a: number[]) => a.map((value) => value / (Math.hypot(...a) || 1));

export interface Cut {
  /** What is to be shown. */
  leaves: Chunk[];
  /** Chunks in whose place there are finer ones, the one that matters most first. */
  refined: Chunk[];
  /** Levels whose fronts are needed to go on. */
  fronts: number[];
}

/** The cut for a view, from all chunks of `top` down, of at most so many bytes; `isThere` says which chunks may be shown. */
export function cutOf(chunks: Chunks, top: number, look: Look, most: number, isThere: (chunk: Chunk) => boolean = () => true): Cut {
  const cut: Cut = { leaves: [], refined: [], fronts: [] };
  const waiting = chunks.of(top).map((chunk) => ({ chunk, error: chunks.error(chunk, look) }));
  let bytes = waiting.reduce((sum, { chunk }) => sum + chunks.cost(chunk), 0);
  const heap = new Heap(waiting);
  for (let next = heap.pop(); next; next = heap.pop()) {
    const { chunk, error } = next;
    const children = error > 1 && chunk.level > 0 ? chunks.childrenOf(chunk) : [];
    if (error > 1 && chunk.level > 0 && !chunks.has(chunk.level - 1)) cut.fronts.push(chunk.level - 1);
    const more = children.reduce((sum, child) => sum + chunks.cost(child), -chunks.cost(chunk));
    if (children.length === 0 || bytes + more > most || !children.every(isThere)) {
      cut.leaves.push(chunk);
      continue;
    }
    bytes += more;
    cut.refined.push(chunk);
    for (const child of children) heap.push({ chunk: child, error: chunks.error(child, look) });
  }
  cut.fronts = [...new Set(cut.fronts)].sort((a, b) => b - a);
  return cut;
}

/** The largest error first. */
class Heap {
  readonly #items: { chunk: Chunk; error: number }[] = [];

  constructor(items: { chunk: Chunk; error: number }[]) {
    for (const item of items) this.push(item);
  }

  push(item: { chunk: Chunk; error: number }) {
    const items = this.#items;
    let at = items.push(item) - 1;
    for (let above = (at - 1) >> 1; at > 0 && items[above]!.error < item.error; at = above, above = (at - 1) >> 1) items[at] = items[above]!;
    items[at] = item;
  }

  pop() {
    const items = this.#items;
    const [first, last] = [items[0], items.pop()];
    if (!last || items.length === 0) return first;
    let at = 0;
    for (let child = 1; child < items.length; child = 2 * at + 1) {
      if (child + 1 < items.length && items[child + 1]!.error > items[child]!.error) child++;
      if (items[child]!.error <= last.error) break;
      items[at] = items[child]!;
      at = child;
    }
    items[at] = last;
    return first;
  }
}
