// The attributes of the element as properties, each with its usual value and its bounds.
import { defaultThreads } from "./pool.js";

// Where pages are rendered on a server there are no elements; the import does no harm there.
const Base = (globalThis.HTMLElement ?? class {}) as typeof HTMLElement;

/** What an attribute's text says, `null` where there is none. */
type Reader = (text: string | null) => unknown;

/** The text itself, or the usual one. */
const plain = (usual: string): Reader => (text) => text ?? usual;
/** One of these words, else the first. */
const word = (...words: string[]): Reader => (text) => words.find((word) => word === text) ?? words[0];
const auto = plain("auto");
/** Whether there is one. */
const isThere: Reader = (text) => text !== null;
/** A number within bounds; the usual one where the text is none. */
const number = (usual: number, least: number, most: number): Reader => (text) => {
  const value = text?.trim() ? Number(text) : NaN;
  return Number.isFinite(value) ? Math.max(least, Math.min(most, value)) : usual;
};
/** The nearest whole number. */
const whole = (usual: number, least: number, most: number): Reader => (text) => Math.round(number(usual, least, most)(text) as number);

/** What each of them says as a property. */
const READERS: Record<string, Reader> = {
  src: plain(""),
  alt: plain(""),
  poster: plain(""),
  loading: auto,
  reveal: auto,
  "camera-orbit": auto,
  "camera-target": auto,
  "field-of-view": auto,
  "clip-box": auto,
  "tone-mapping": plain("agx"),
  "camera-controls": isThere,
  "auto-rotate": isThere,
  "no-drop": isThere,
  "real-time": word("auto", "off"),
  tracer: word("auto", "gpu", "cpu"),
  exposure: number(0, -30, 30),
  "max-memory": number(1024, 4, 65_536),
  "max-pixels": number(1280 * 720, 1, 2 ** 26),
  samples: whole(64, 1, 65_536),
  seed: whole(0, 0, 2 ** 32 - 1),
  "max-bounces": whole(8, 0, 255),
  threads: (text) => whole(defaultThreads(), 1, 64)(text),
};

export abstract class Attributes extends Base {
  static readonly observedAttributes = Object.keys(READERS);

  /** What is shown: the address of a file, or `scene:NAME?voxels=COUNT`. */
  declare src: string;
  /** What it is, for people who do not see it. */
  declare alt: string;
  /** Address of a picture that is shown until there is one. */
  declare poster: string;
  /** When the scene is loaded: `auto` and `eager` at once, `lazy` when the element is in view. */
  declare loading: "auto" | "lazy" | "eager";
  /** When the poster goes: `auto` with the first picture, `interaction` when a person presses it, `manual` by `dismissPoster()`. */
  declare reveal: "auto" | "interaction" | "manual";
  /** Whether mouse, touch and keys move the camera. */
  declare cameraControls: boolean;
  /** Where the camera is around its target: `THETA PHI RADIUS`, for example `30deg 75deg 120%`; `auto` for the scene's own. */
  declare cameraOrbit: string;
  /** What the camera looks at: `X Y Z` in world units; `auto` for the scene's own. */
  declare cameraTarget: string;
  /** Vertical field of view, for example `45deg`; `auto` for the scene's own. */
  declare fieldOfView: string;
  /** The box within which the scene is shown: `X Y Z X Y Z` in world units, its lowest corner and its highest one; `auto` for all of it. */
  declare clipBox: string;
  /** Whether the camera goes around by itself; never where a person prefers less motion. */
  declare autoRotate: boolean;
  /** Whether files that are dropped are the page's. */
  declare noDrop: boolean;
  /** What is shown while the view moves: `auto`, where the GPU traces, real-time light; `off`, coarse pictures. */
  declare realTime: "auto" | "off";
  /** Exposure in stops. */
  declare exposure: number;
  /** The curve from radiance to the screen: `agx`, `neutral`, `reinhard`, `linear`. */
  declare toneMapping: string;
  /** Samples of each pixel of a picture that stands still. */
  declare samples: number;
  /** Seed of the random numbers: the same one gives the same picture, to the bit. */
  declare seed: number;
  /** Most surfaces that scatter one path. */
  declare maxBounces: number;
  /** Who traces: `auto`, the GPU where the browser has WebGPU for one, else workers on the processor; `gpu`, also where WebGPU is software; `cpu`. */
  declare tracer: "auto" | "gpu" | "cpu";
  /** Workers, each with its own copy of the scene. */
  declare threads: number;
  /** Megabytes that a file for streaming may take, all workers together. */
  declare maxMemory: number;
  /** Most pixels of a picture; larger elements show it scaled. */
  declare maxPixels: number;
}

for (const [name, read] of Object.entries(READERS)) {
  const property = name.replace(/-./g, ([, letter]) => letter!.toUpperCase());
  Object.defineProperty(Attributes.prototype, property, {
    get(this: Attributes) {
      return read(this.getAttribute(name));
    },
    set(this: Attributes, value: unknown) {
      if (read === isThere) this.toggleAttribute(name, !!value);
      else this.setAttribute(name, String(value));
    },
    configurable: true,
    enumerable: true,
  });
}
