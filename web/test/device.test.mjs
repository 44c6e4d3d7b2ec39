// The device that viewers of a page share, of a WebGPU that the test plays: one for all of them, also where all of them lose it.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { bundled } from "./bundled.mjs";

/** Devices that were made, and how to lose them. */
let made;
let batch;
/** What is asked for at the same time is answered at the same time, as browsers hand on what the process of the GPU says. */
const later = () => (batch ??= new Promise((done) => setTimeout(() => done((batch = undefined)), 1)));

/** A WebGPU whose answers take a while. */
const gpu = {
  async requestAdapter() {
    await later();
    return {
      info: { isFallbackAdapter: false },
      limits: { maxStorageBufferBindingSize: 1, maxBufferSize: 1 },
      async requestDevice() {
        await later();
        let lose;
        const device = { lost: new Promise((done) => (lose = done)), compiled: 0, createBindGroupLayout: () => ({}), createPipelineLayout: () => ({}) };
        device.createShaderModule = () => ({});
        device.createComputePipelineAsync = async () => (device.compiled += 1);
        made.push({ device, lose });
        return device;
      },
    };
  },
};

Object.defineProperty(globalThis, "navigator", { value: { gpu }, configurable: true });
globalThis.GPUShaderStage = { COMPUTE: 4 };
globalThis.fetch = async () => ({ ok: true, text: async () => "\n\n\n\n" });

/** Of a page of its own: what is shared is shared within it. */
let Device, FILM;
beforeEach(async () => {
  made = [];
  ({ Device, FILM } = await bundled("web/src/gpu-device.ts"));
});

/** The devices that so many viewers get at the same time. */
const atOnce = (count) => Promise.all(Array.from({ length: count }, () => Device.ofPage(false)));

test("viewers that ask at the same time have one device", async () => {
  assert.equal(new Set(await atOnce(3)).size, 1);
  assert.equal(made.length, 1);
});

test("viewers that lose it at the same time have one again, whose shaders are compiled once", async () => {
  const [lost] = await atOnce(1);
  made[0].lose();
  await later();
  assert.ok(lost.isLost);
  const devices = await atOnce(2);
  assert.deepEqual([new Set(devices).size, made.length], [1, 2]);
  const shaders = { isMatte: true, constants: [] };
  await Promise.all(devices.map((device) => device.pipelines(FILM, shaders)));
  assert.equal(made[1].device.compiled, FILM.entries.length);
  // Each of these has shaders of its own.
  await devices[0].pipelines(FILM, { ...shaders, isMatte: false });
  assert.equal(made[1].device.compiled, 2 * FILM.entries.length, "a planted second compilation is counted");
});
