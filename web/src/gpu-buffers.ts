// The buffers of a scene or of what shows it, by the numbers of their bindings.
import type { Device } from "./gpu-device.js";

declare const GPUMapMode: { readonly READ: number };
declare const GPUBufferUsage: Record<"STORAGE" | "UNIFORM" | "COPY_SRC" | "COPY_DST" | "MAP_READ" | "INDIRECT", number>;

/** Bytes of the largest record: arrays that are empty have room for one. */
const RECORD = 256;

export class Buffers {
  readonly #buffers = new Map<number, GPUBuffer>();
  readonly #groups = new Map<GPUBindGroupLayout, GPUBindGroup>();
  #copy: GPUBuffer | undefined;

  /** `beside` has what others own. */
  constructor(
    private readonly gpu: Device,
    private readonly beside?: Buffers,
  ) {}

  get #device() {
    return this.gpu.device;
  }

  at(binding: number): GPUBuffer {
    return (this.#buffers.get(binding) ?? this.beside?.at(binding))!;
  }

  /** Storage for a binding, of at least so many bytes. */
  storage(binding: number, size: number): GPUBuffer {
    return this.#reserve(binding, size, GPUBufferUsage.STORAGE);
  }

  /** The uniforms of a binding. */
  uniform(binding: number): GPUBuffer {
    return this.#reserve(binding, 4 * RECORD, GPUBufferUsage.UNIFORM);
  }

  /** Where dispatches find their workgroups. */
  indirect(binding: number): GPUBuffer {
    return this.#reserve(binding, RECORD, GPUBufferUsage.INDIRECT);
  }

  write(binding: number, words: Uint32Array | Uint8Array) {
    this.#device.queue.writeBuffer(this.at(binding), 0, words.buffer as ArrayBuffer, words.byteOffset, words.byteLength);
  }

  /** The group of all bindings of a layout. */
  group(layout: GPUBindGroupLayout, bindings: number[]): GPUBindGroup {
    const made = this.#groups.get(layout);
    if (made) return made;
    const group = this.#device.createBindGroup({ layout, entries: bindings.map((binding) => ({ binding, resource: { buffer: this.at(binding) } })) });
    this.#groups.set(layout, group);
    return group;
  }

  /** The first bytes of a buffer, once what was submitted before is done. */
  async read(binding: number, size: number): Promise<ArrayBuffer> {
    if (!this.#copy || this.#copy.size < size) {
      this.#copy?.destroy();
      this.#copy = this.#device.createBuffer({ size, usage: GPUBufferUsage.MAP_READ | GPUBufferUsage.COPY_DST });
    }
    const copy = this.#copy;
    const encoder = this.#device.createCommandEncoder();
    encoder.copyBufferToBuffer(this.at(binding), 0, copy, 0, size);
    this.#device.queue.submit([encoder.finish()]);
    await copy.mapAsync(GPUMapMode.READ, 0, size);
    const bytes = copy.getMappedRange(0, size).slice(0);
    copy.unmap();
    return bytes;
  }

  end() {
    for (const buffer of this.#buffers.values()) buffer.destroy();
    this.#copy?.destroy();
  }

  #reserve(binding: number, size: number, usage: number): GPUBuffer {
    const there = this.#buffers.get(binding);
    if (there && there.size >= size) return there;
    there?.destroy();
    const buffer = this.#device.createBuffer({ size: Math.max(size, RECORD), usage: usage | GPUBufferUsage.COPY_DST | GPUBufferUsage.COPY_SRC });
    this.#buffers.set(binding, buffer);
    this.#groups.clear();
    return buffer;
  }
}

/** All numbers of the bindings of a module. */
export function bindingsOf({ read, written, uniform }: Record<"read" | "written" | "uniform", Record<string, number>>): number[] {
  return [read, written, uniform].flatMap((kind) => Object.values(kind));
}
