// The attributes as properties: what they are where there is no text or a wrong one, and that both say the same. Node has all that it needs but elements.
import assert from "node:assert/strict";
import { test } from "node:test";

/** As much of an element as its attributes need. */
globalThis.HTMLElement = class {
  texts = new Map();
  getAttribute(name) {
    return this.texts.get(name) ?? null;
  }
  setAttribute(name, value) {
    this.texts.set(name, String(value));
  }
  toggleAttribute(name, isThere) {
    if (isThere) this.texts.set(name, "");
    else this.texts.delete(name);
  }
};
Object.defineProperty(globalThis, "navigator", { value: { hardwareConcurrency: 6 }, configurable: true });
const { bundled } = await import("./bundled.mjs");
const { Attributes } = await bundled("web/src/attributes.ts");
const made = () => new (class extends Attributes {})();

/** Of each property its attribute, its usual value, and what texts mean. */
const KNOWN = {
  src: ["src", "", { "a.vox": "a.vox" }],
  alt: ["alt", "", { "A city": "A city" }],
  poster: ["poster", "", { "a.png": "a.png" }],
  loading: ["loading", "auto", { lazy: "lazy" }],
  reveal: ["reveal", "auto", { manual: "manual" }],
  cameraOrbit: ["camera-orbit", "auto", { "30deg 75deg 120%": "30deg 75deg 120%" }],
  cameraTarget: ["camera-target", "auto", { "1 2 3": "1 2 3" }],
  fieldOfView: ["field-of-view", "auto", { "45deg": "45deg" }],
  clipBox: ["clip-box", "auto", { "0 0 0 1 1 1": "0 0 0 1 1 1" }],
  toneMapping: ["tone-mapping", "agx", { linear: "linear" }],
  realTime: ["real-time", "auto", { off: "off", on: "auto", "": "auto" }],
  tracer: ["tracer", "auto", { gpu: "gpu", cpu: "cpu", GPU: "auto", "": "auto" }],
  exposure: ["exposure", 0, { "1.5": 1.5, "-99": -30, 99: 30, bright: 0, " ": 0, Infinity: 0 }],
  maxMemory: ["max-memory", 1024, { 64.5: 64.5, 1: 4, 1e9: 65_536 }],
  maxPixels: ["max-pixels", 921_600, { 0: 1, 5e9: 2 ** 26 }],
  samples: ["samples", 64, { 3.6: 4, 0: 1, 1e9: 65_536, many: 64, "": 64 }],
  seed: ["seed", 0, { 7: 7, "-1": 0, 5e9: 2 ** 32 - 1 }],
  maxBounces: ["max-bounces", 8, { 0: 0, 300: 255 }],
  threads: ["threads", 5, { 3: 3, 0: 1, 100: 64 }],
};

/** What a property says that is not known of it. */
function faults(known) {
  const found = [];
  const expect = (what, said, wanted) => said === wanted || found.push(`${what}: ${said}, not ${wanted}`);
  for (const [property, [attribute, usual, texts]] of Object.entries(known)) {
    expect(property, made()[property], usual);
    for (const [text, value] of Object.entries(texts)) {
      const element = made();
      element.setAttribute(attribute, text);
      expect(`${attribute}="${text}"`, element[property], value);
      const other = made();
      other[property] = value;
      expect(`${property} = ${value}`, other.getAttribute(attribute), String(value));
    }
  }
  return found;
}

test("each property is what its attribute says, within its bounds", () => {
  assert.deepEqual(faults(KNOWN), []);
  assert.deepEqual(faults({ seed: ["seed", 1, { 7: 8 }] }), ["seed: 0, not 1", 'seed="7": 7, not 8'], "a planted fault is found");
});

test("those that are there or not are so by being set", () => {
  for (const [property, attribute] of [["cameraControls", "camera-controls"], ["autoRotate", "auto-rotate"], ["noDrop", "no-drop"]]) {
    const element = made();
    assert.equal(element[property], false);
    element[property] = true;
    assert.deepEqual([element[property], element.getAttribute(attribute)], [true, ""]);
    element[property] = false;
    assert.deepEqual([element[property], element.getAttribute(attribute)], [false, null]);
  }
});

test("a browser tells of every attribute that is known, and frameworks find its property", () => {
  const attributes = [...Object.values(KNOWN).map(([attribute]) => attribute), "camera-controls", "auto-rotate", "no-drop"];
  assert.deepEqual([...Attributes.observedAttributes].sort(), attributes.sort());
  for (const property of [...Object.keys(KNOWN), "cameraControls", "autoRotate", "noDrop"]) assert.ok(property in made(), property);
});
