// The element `<voxtrace-viewer>`: attributes and events in model-viewer's words where both have the thing.
import { Attributes } from "./attributes.js";
import { listen, listenToPresses } from "./gestures.js";
import { cameraOf, lookOf, type Orbit, orbitText, orbitWords, panned, parseBox, parseFieldOfView, parseOrbit, parseTarget, type Vector, type View, viewOf, within } from "./orbit.js";
import { type Files, Pool } from "./pool.js";
import type { Picked, SceneInfo, Source } from "./protocol.js";
import { type Look, type Picture, type Rendering, sizeOf } from "./rendering.js";
import { isStreamed } from "./layout.js";
import { builtIn, download, fileName } from "./source.js";
import { Stage } from "./stage.js";
import { type FromStreamer, Streaming } from "./streaming.js";
import { build, dress, type Parts, showProgress, windowOf } from "./template.js";
import { ClosedError, TracerError } from "./tracer.js";

/** What a pixel of a drag turns by, degrees. */
const DEGREES_PER_PIXEL = 0.35;
/** Of `auto-rotate`, degrees in a second, and how long a person's own movement holds it up, milliseconds. */
const TURNS = 12;
const REST = 3000;
/** Share of the progress that the download is; reading and packing, and the first picture, are the rest. */
const DOWNLOADED = 0.6;
const LOADED = 0.9;

export interface FilmWords {
  width: number;
  height: number;
  samples: number;
  seed: number;
  /** 32 bytes a pixel, row by row: the sums of red, green and blue (64-bit integers, units of 2⁻³²), samples, and those that met a voxel. */
  words: Uint8Array;
}

/** A file that may be one for streaming: on a server, or of this machine. */
interface Followed {
  name: string;
  url?: string;
  blob?: Blob;
}

export class VoxtraceViewer extends Attributes {
  #parts!: Parts;
  #stage!: Stage;
  readonly #pool = new Pool((tracer) => this.#stage.join(tracer));
  #info: SceneInfo | undefined;
  /** The view of the scene's first camera, or one that shows all of it, as the numbers that the scene has. */
  #start: Float32Array | undefined;
  /** Width over height of the pictures that it was made for. */
  #aspect = 1;
  #view: View | undefined;
  /** Whether the view is still the scene's own, to the bit. */
  #isOwnView = true;
  /** Whether the view is the one that the attributes ask for. */
  #isHome = true;
  /** The last load that was asked for; a later one makes it void. */
  #load: AbortController | undefined;
  /** Loads the same once more, an address or a file of this machine. */
  #again: (() => void) | undefined;
  /** The file for streaming that is followed, and whether finer parts of it are on their way. */
  #streaming: Streaming | undefined;
  #isArriving = false;
  #life: AbortController | undefined;
  #observers: (ResizeObserver | IntersectionObserver)[] = [];
  #isVisible = true;
  #isPosterGone = false;
  #isTurning = true;
  #lastMove = 0;
  #speak: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    this.#parts = build(this.attachShadow({ mode: "open" }));
    const failed = (error: unknown) => this.#fail(error, "renderfailure");
    const shown = () => this.#shown();
    const still = (film: Rendering) => this.#still(film);
    this.#stage = new Stage(this.#parts.canvas, this.#pool, { shown, still, failed });
    // What a page set before there was this class would hide its properties for good.
    const own = this as Record<string, unknown>;
    for (const [name, value] of Object.entries(own)) {
      delete own[name];
      own[name] = value;
    }
    // Browsers empty canvases whose context they lost: the film is drawn again.
    this.#parts.canvas.addEventListener("contextrestored", () => void this.#stage.setLook(this.#look()));
    this.#parts.poster.addEventListener("click", () => this.#reveal());
    this.#parts.poster.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      this.#reveal();
    });
    this.#parts.pause.addEventListener("click", () => {
      this.#isTurning = !this.#isTurning;
      this.#parts.pause.textContent = this.#isTurning ? "Pause" : "Turn";
    });
  }

  connectedCallback() {
    // Removed and put back at once, as when it is moved, it goes on.
    if (this.#life && !this.#life.signal.aborted) return;
    this.#life = new AbortController();
    const { signal } = this.#life;
    const moves = {
      turn: (x: number, y: number) => this.#move((view) => ({ ...view, theta: view.theta - x * DEGREES_PER_PIXEL, phi: view.phi - y * DEGREES_PER_PIXEL })),
      pan: (x: number, y: number) => this.#move((view) => panned(view, x / this.clientHeight, y / this.clientHeight)),
      zoom: (factor: number) => this.#move((view) => ({ ...view, radius: view.radius * factor })),
      home: () => this.#goHome("user-interaction"),
    };
    listen(this.#parts.canvas, moves, () => this.cameraControls && !!this.#view, signal);
    listenToPresses(this.#parts.canvas, (x, y) => void this.#press(x, y), signal);
    this.#listenToDrops(signal);
    // A lazy one is not seen until that is known.
    this.#isVisible = this.loading !== "lazy";
    this.#observe();
    signal.addEventListener("abort", () => this.#unobserve());
    // Attributes that it had before, or got while it was no part of a page.
    void this.#stage.setLook(this.#look());
    this.#describe();
    if (this.loading !== "lazy") this.#reload();
  }

  disconnectedCallback() {
    // An element that is moved is out of the page for a moment.
    queueMicrotask(() => this.isConnected || this.#free());
  }

  /** Another document, as that of a window for picture-in-picture, takes no style of this one, and is seen when this one is not. */
  adoptedCallback() {
    dress(this.shadowRoot!);
    // A window that was closed shows no frame that is waited for.
    this.#stage.stop();
    if (this.isConnected) this.#observe();
  }

  /** Hears of its size, of whether it is seen and of frames, from the window that shows it. */
  #observe() {
    this.#unobserve();
    const view = windowOf(this);
    // Of several changes the last one holds.
    const visible = new view.IntersectionObserver((entries) => this.#seen(entries.at(-1)!.isIntersecting), { rootMargin: "100px" });
    this.#observers = [new view.ResizeObserver(() => this.#refresh()), visible];
    for (const observer of this.#observers) observer.observe(this);
    this.#turnOn(view, this.#observers);
  }

  #unobserve() {
    for (const observer of this.#observers.splice(0)) observer.disconnect();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null) {
    if (before === after || !this.#life || this.#life.signal.aborted) return;
    if (name === "src" && !after) this.#clear();
    else if (name === "src" || (name === "loading" && !this.#load)) {
      if (this.#load || this.#isVisible || this.loading !== "lazy") this.#reload();
    } else if (name === "tracer") this.#again?.();
    else if (name === "exposure" || name === "tone-mapping" || name === "real-time") void this.#stage.setLook(this.#look());
    else if (name.startsWith("camera-o") || name === "camera-target" || name === "field-of-view") this.#goHome("none");
    else if (["samples", "seed", "max-bounces", "max-pixels", "clip-box"].includes(name)) this.#refresh();
    else {
      this.#describe();
      if (name === "reveal") this.#cover();
    }
  }

  /** Whether a scene is there. */
  get loaded(): boolean { return this.#info !== undefined; }
  /** Who traces now: `gpu` or `cpu`; `undefined` before a scene is there. */
  get activeTracer(): "gpu" | "cpu" | undefined { return this.#pool.tier; }
  /** Whether what is on the canvas is in real-time light, as while the view moves where the GPU traces. */
  get showsRealTime(): boolean { return this.#stage.isLit; }
  /** What is known of the scene. */
  get scene(): SceneInfo | undefined { return this.#info; }

  /** The view: angles in degrees, distance and target in world units. */
  getCameraOrbit(): Orbit | undefined {
    return this.#view && { theta: this.#view.theta, phi: this.#view.phi, radius: this.#view.radius };
  }
  getCameraTarget(): Vector | undefined { return this.#view && [...this.#view.target]; }
  getFieldOfView(): number | undefined { return this.#view?.fieldOfView; }

  /** Takes the poster away. */
  dismissPoster() {
    this.#isPosterGone = true;
    this.#describe();
    this.#cover();
  }
  /** Puts the poster back; with `reveal="auto"` until the next picture. */
  showPoster() {
    this.#isPosterGone = false;
    this.#describe();
    this.#cover();
  }

  /** Whether the poster covers the scene until somebody takes it away. */
  get #isCovered(): boolean { return !this.#isPosterGone && this.reveal !== "auto"; }

  /** Traces what can be seen. */
  #cover() {
    this.#streaming?.pause(!this.#isVisible || this.#isCovered);
    if (this.#isCovered) this.#stage.stop();
    this.#refresh();
  }

  /** Somebody presses the poster. */
  #reveal() {
    const hadFocus = this.shadowRoot?.activeElement === this.#parts.poster;
    this.dismissPoster();
    if (hadFocus) this.#parts.canvas.focus();
  }

  /** The picture as it is on the canvas. */
  toBlob({ mimeType = "image/png", quality }: { mimeType?: string; quality?: number } = {}): Promise<Blob> {
    return new Promise((done, failed) => {
      const made = (blob: Blob | null) => (blob ? done(blob) : failed(new Error("there is no picture")));
      if (!this.loaded || this.#parts.canvas.className) made(null);
      else this.#parts.canvas.toBlob(made, mimeType, quality);
    });
  }

  /** The film of the view that stands still: the exact sums of each pixel, the same on every machine. `undefined` until each pixel has a sample. */
  film(): FilmWords | undefined {
    const rendering = this.#stage.film;
    const words = rendering?.words();
    if (!rendering || !words) return undefined;
    const { width, height, seed } = rendering.picture;
    return { width, height, seed, samples: rendering.samples, words };
  }

  /** What rays meet first, within the clip box: eight numbers each (origin, t_min, direction, t_max) to six words each (distance as the bits of a float, instance, voxel, face). */
  async cast(rays: Float32Array): Promise<Uint32Array> {
    const [tracer] = this.#pool.ready;
    if (!tracer) throw new Error("no scene was loaded");
    return tracer.call("cast", [rays, parseBox(this.clipBox)]);
  }

  /** The voxel that the view shows at a place, in CSS pixels from the element's upper left corner; `undefined` for the sky. */
  async pick(x: number, y: number): Promise<Picked | undefined> {
    const [tracer] = this.#pool.ready;
    const picture = this.#picture();
    if (!tracer || !picture) throw new Error("no scene was loaded");
    const { width, height } = picture;
    const look = { toneMapping: this.toneMapping, exposure: this.exposure };
    return tracer.call("pick", [{ ...picture, ...look, y0: 0, y1: height }, (x / this.clientWidth) * width, (y / this.clientHeight) * height]);
  }

  /** Checksums of what the functions of the tracer give here, by their names, on a scene of this edge; the example `words` of the crate `voxtrace-web` prints those of a machine. */
  async selftest(edge = 64): Promise<string[]> {
    const [tracer] = this.#pool.ready;
    if (!tracer) throw new Error("no scene was loaded");
    return tracer.call("selftest", [edge]);
  }

  /** Gives the bytes of the package's own files by their names, where a page has no addresses for them; undefined where they lie beside its script. */
  get files(): Files | undefined { return this.#pool.files; }
  set files(files: Files | undefined) { this.#pool.files = files; }

  /** Shows a file of this machine; its bytes stay here. */
  async show(file: File): Promise<void> {
    if (this.reveal === "interaction") this.dismissPoster();
    await this.#begin(file.name, async () => {
      if (isStreamed(new Uint8Array(await file.slice(0, 64).arrayBuffer()))) return { name: file.name, blob: file };
      return { kind: "file", name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) };
    });
  }

  #look(): Look {
    const known = ["agx", "neutral", "reinhard", "linear"];
    return { toneMapping: known.includes(this.toneMapping) ? this.toneMapping : "agx", exposure: this.exposure, hasRealTime: this.realTime !== "off" };
  }

  #emit(name: string, detail: unknown) {
    this.dispatchEvent(new CustomEvent(name, { detail }));
  }

  #reload() {
    const { src } = this;
    if (!src) return;
    void this.#begin(src, async (signal) => {
      const scene = builtIn(src);
      if (scene) return scene;
      const url = new URL(src, this.ownerDocument.baseURI);
      if (/\.vxt$/i.test(url.pathname)) return { name: fileName(url), url: url.href };
      const onProgress = (share: number | undefined) => this.#progress(share === undefined ? undefined : share * DOWNLOADED);
      const bytes = await download(url, signal, onProgress);
      if (isStreamed(bytes)) return { name: fileName(url), blob: new Blob([bytes as Uint8Array<ArrayBuffer>]) };
      return { kind: "file", name: fileName(url), bytes };
    });
  }

  /** Loads what `source` gives, unless something else is asked for meanwhile; what has no kind may be a file for streaming. */
  async #begin(name: string, source: (signal: AbortSignal) => Promise<Source | Followed>) {
    this.#forget();
    const load = (this.#load = new AbortController());
    this.#again = () => void this.#begin(name, source);
    this.#isArriving = false;
    this.#parts.message.hidden = true;
    this.#progress(0);
    this.#say(`Loading ${name}`);
    try {
      const given = await source(load.signal);
      if (load.signal.aborted) return;
      if ("kind" in given) await this.#take(given, name, load.signal);
      else this.#follow(given, name, load.signal);
    } catch (error) {
      if (!load.signal.aborted) this.#fail(error, "loadfailure");
    }
  }

  /** Shows a scene that is there whole. */
  async #take(given: Source, name: string, signal: AbortSignal) {
    this.#progress(given.kind === "file" ? DOWNLOADED : undefined);
    const info = await this.#pool.load(given, this.threads, this.tracer);
    if (signal.aborted) return;
    this.#progress(LOADED);
    await this.#arrived(info);
    if (signal.aborted) return;
    this.#emit("load", { url: name, info });
  }

  /** Shows a file for streaming as its parts arrive. */
  #follow(given: Followed, name: string, signal: AbortSignal) {
    const memory = this.maxMemory * 2 ** 20;
    const failed = (error: unknown) => {
      if (signal.aborted) return;
      end();
      this.#fail(error, "loadfailure");
    };
    const end = () => {
      streaming.end();
      if (this.#streaming !== streaming) return;
      this.#streaming = undefined;
      this.#isArriving = false;
    };
    const streaming = new Streaming(this.#pool, { ...given, memory, threads: this.threads }, {
      plain: async (bytes) => {
        if (signal.aborted) return;
        end();
        await this.#take({ kind: "file", name: given.name, bytes }, name, signal);
      },
      scene: async (scene) => {
        if (!signal.aborted) await this.#refine(scene, name, signal);
      },
      progress: (share) => {
        if (!signal.aborted) this.#progress(this.#info || share === undefined ? share : share * DOWNLOADED);
      },
      settled: () => {
        if (signal.aborted) return;
        this.#isArriving = false;
        this.#endProgress();
        const film = this.#stage.film;
        if (film && film.samples >= film.picture.samples) this.#still(film);
      },
      failed,
    });
    this.#streaming = streaming;
    streaming.pause(!this.#isVisible || this.#isCovered);
    signal.addEventListener("abort", end);
  }

  /** Shows a finer scene of the file that is followed, from where one looks. */
  async #refine({ bytes, voxels, hash, detail }: Extract<FromStreamer, { kind: "scene" }>, name: string, signal: AbortSignal) {
    this.#isArriving = true;
    const isFirst = !this.#info;
    // Those that get the scene of before join until then.
    if (!isFirst) await this.#pool.joined;
    if (signal.aborted) return;
    // Who gets another scene has no part in pictures of the last one.
    this.#stage.stop();
    // Each worker has a copy: of what is large there are fewer.
    const threads = Math.max(1, Math.min(this.threads, Math.floor((this.maxMemory * 2 ** 20) / bytes.length) - 2));
    const isSame = !isFirst && threads >= this.#pool.size;
    const made = isSame ? await this.#pool.replace(bytes) : await this.#pool.load({ kind: "file", name: "scene.vxt", bytes }, threads, "cpu");
    if (signal.aborted) return;
    const info = { ...made, voxels, hash, detail };
    if (isFirst) {
      await this.#arrived(info);
      if (signal.aborted) return;
      this.#emit("load", { url: name, info });
    } else {
      this.#info = info;
      if (!(await this.#findStart())) return;
      // Coarse voxels reach farther, and a view of all of the scene with them.
      if (this.#isHome) this.#goHome("none");
      else this.#refresh();
    }
    this.#emit("detail-change", detail);
  }

  async #arrived(info: SceneInfo) {
    this.#info = info;
    if (!(await this.#findStart())) return;
    this.#goHome("none");
    this.#describe();
  }

  /** The scene's own view, for the size that the element has; false where something else is asked for meanwhile. */
  async #findStart(): Promise<boolean> {
    const load = this.#load;
    const [tracer] = this.#pool.ready;
    const { width, height } = this.#size();
    this.#aspect = width / height;
    const start = await tracer?.call("camera", [0, this.#aspect]);
    if (this.#load !== load) return false;
    this.#start = start;
    return true;
  }

  #size() {
    const ratio = windowOf(this).devicePixelRatio || 1;
    return sizeOf(this.clientWidth * ratio, this.clientHeight * ratio, this.maxPixels);
  }

  /** The view that the attributes ask for. */
  #goHome(source: "none" | "user-interaction") {
    if (!this.#start) return;
    const own = viewOf(this.#start);
    const orbit = parseOrbit(this.cameraOrbit, own);
    const target = parseTarget(this.cameraTarget, own.target);
    const fieldOfView = parseFieldOfView(this.fieldOfView, own.fieldOfView);
    if (!orbit || !target || fieldOfView === undefined) {
      const which = !orbit ? `camera-orbit="${this.cameraOrbit}"` : !target ? `camera-target="${this.cameraTarget}"` : `field-of-view="${this.fieldOfView}"`;
      console.warn(`voxtrace-viewer: ${which} is not understood; examples are camera-orbit="30deg 75deg 120%", camera-target="1 2 3", field-of-view="45deg"`);
    }
    const view: View = { ...(orbit ?? own), target: target ?? own.target, fieldOfView: fieldOfView ?? own.fieldOfView };
    this.#isHome = true;
    this.#isOwnView = JSON.stringify(view) === JSON.stringify(own);
    this.#view = this.#isOwnView ? own : within(view, this.#diagonal());
    this.#refresh();
    this.#changed(source);
  }

  #diagonal(): number {
    const bounds = this.#info?.bounds ?? [0, 0, 0, 1, 1, 1];
    return Math.hypot(...[0, 1, 2].map((axis) => bounds[axis + 3]! - bounds[axis]!)) || 1;
  }

  #move(change: (view: View) => View, source: "none" | "user-interaction" = "user-interaction") {
    if (!this.#view) return;
    if (source === "user-interaction") this.#lastMove = performance.now();
    this.#view = within(change(this.#view), this.#diagonal());
    this.#isOwnView = this.#isHome = false;
    this.#refresh();
    this.#changed(source);
  }

  #changed(source: "none" | "user-interaction") {
    this.#emit("camera-change", { source, orbit: this.#view && orbitText(this.#view) });
    clearTimeout(this.#speak);
    if (source === "user-interaction") this.#speak = setTimeout(() => this.#view && this.#say(orbitWords(this.#view)), 500);
  }

  /** Shows the view as it is now. */
  #refresh() {
    if (!this.#view || !this.#start || !this.#isVisible || this.clientWidth === 0) return;
    if (this.#isCovered) {
      // No picture comes that would end it.
      if (!this.#isArriving || this.#streaming) this.#endProgress();
      return;
    }
    const picture = this.#picture()!;
    if (this.#isOwnView && picture.lensOf < 0 && picture.width / picture.height !== this.#aspect) void this.#fit();
    this.#stage.show(picture);
    if (!this.#streaming) return;
    // Until it is known that nothing finer comes for it.
    if (!this.#info?.detail?.isExact) this.#isArriving = true;
    this.#streaming.look(lookOf(picture.camera, picture));
  }

  /** The picture of the view, where there is one. */
  #picture(): Picture | undefined {
    if (!this.#view || !this.#start) return undefined;
    const camera = this.#isOwnView ? this.#start : cameraOf(this.#view);
    const lensOf = (this.#info?.cameras.length ?? 0) > 0 ? 0 : -1;
    const clip = parseBox(this.clipBox);
    if (!clip) console.warn(`voxtrace-viewer: clip-box="${this.clipBox}" is not understood; an example is clip-box="0 0 0 64 64 32"`);
    const box = clip?.length ? { clip } : {};
    return { camera, lensOf, ...this.#size(), samples: this.samples, seed: this.seed, bounces: this.maxBounces, ...box };
  }

  /** Tells what is where somebody pressed. */
  async #press(x: number, y: number) {
    if (!this.#view) return;
    try {
      this.#emit("voxel-pick", (await this.pick(x, y)) ?? null);
    } catch (error) {
      if (this.#view) this.#fail(error, "renderfailure");
    }
  }

  /** A view that shows the whole scene is another in an element of another shape. */
  async #fit() {
    const before = this.#start;
    const isFound = await this.#findStart().catch(() => false);
    if (!isFound || !this.#start || !before || this.#start.every((value, index) => value === before[index])) return;
    if (this.#isOwnView) this.#goHome("none");
  }

  #seen(isVisible: boolean) {
    const wasVisible = this.#isVisible;
    this.#isVisible = isVisible;
    if (isVisible !== wasVisible) this.#streaming?.pause(!isVisible || this.#isCovered);
    if (isVisible && this.loading === "lazy" && !this.#load) this.#reload();
    // Nobody looks: other pages get the processor.
    else if (!isVisible) this.#stage.stop();
    else if (!wasVisible) this.#refresh();
  }

  /** Turns the view by itself, and looks for another zoom of the page, with each frame of a window until these observers are gone. */
  #turnOn(view: Window, observers: unknown[]) {
    const calm = matchMedia("(prefers-reduced-motion: reduce)");
    let [last, ratio] = [performance.now(), view.devicePixelRatio];
    const frame = () => {
      if (!observers[0]) return;
      const now = performance.now();
      const seconds = Math.min(0.25, (now - last) / 1000);
      last = now;
      // Zooming leaves the size of an element in its own pixels as it is.
      if (ratio !== (ratio = view.devicePixelRatio)) this.#refresh();
      const turns = this.autoRotate && !calm.matches && this.#isVisible && !this.#isCovered && !!this.#view;
      this.#parts.pause.hidden = !turns;
      if (turns && this.#isTurning && now - this.#lastMove > REST) {
        this.#move((view) => ({ ...view, theta: view.theta + TURNS * seconds }), "none");
      }
      view.requestAnimationFrame(frame);
    };
    view.requestAnimationFrame(frame);
  }

  #listenToDrops(signal: AbortSignal) {
    const root = this.#parts.canvas.parentNode as ShadowRoot;
    const hover = (isOver: boolean) => (root.host as HTMLElement).toggleAttribute("dropping", isOver);
    const takes = (event: DragEvent) => !this.noDrop && !!event.dataTransfer?.types.includes("Files");
    this.addEventListener("dragover", (event) => {
      if (!takes(event)) return;
      event.preventDefault();
      hover(true);
    }, { signal });
    this.addEventListener("dragleave", () => hover(false), { signal });
    this.addEventListener("drop", (event) => {
      hover(false);
      if (!takes(event)) return;
      event.preventDefault();
      const [file] = event.dataTransfer!.files;
      if (file) void this.show(file);
    }, { signal });
  }

  /** The label, the poster and what may be pressed, by the attributes. */
  #describe() {
    const { canvas, poster } = this.#parts;
    canvas.setAttribute("aria-label", this.alt || (this.#info ? `Voxels: ${this.#info.name}` : "Voxels"));
    // What lies under a poster is no stop on the way to it.
    if (this.cameraControls && !this.#isCovered) {
      canvas.tabIndex = 0;
      canvas.setAttribute("aria-describedby", "keys");
    } else {
      canvas.removeAttribute("tabindex");
      canvas.removeAttribute("aria-describedby");
    }
    // The browser makes of it an address, or nothing where it is none.
    poster.style.backgroundImage = this.poster && `url(${JSON.stringify(this.poster)})`;
    poster.classList.toggle("gone", this.#isPosterGone);
    if (this.reveal === "interaction" && !this.#isPosterGone) {
      poster.tabIndex = 0;
      poster.setAttribute("role", "button");
      poster.setAttribute("aria-label", `Show ${this.alt || this.#info?.name || "voxels"}`);
    } else {
      for (const name of ["tabindex", "role", "aria-label"]) poster.removeAttribute(name);
    }
  }

  #shown() {
    this.#parts.canvas.classList.remove("blank");
    if (this.reveal === "auto" && !this.#isPosterGone) this.dismissPoster();
    if (!this.#isArriving) this.#endProgress();
  }

  #endProgress() {
    if (this.#parts.bar.hidden) return;
    this.#emit("progress", { totalProgress: 1 });
    showProgress(this.#parts, null);
  }

  /** The film has all its samples. Where finer parts are on their way, another one follows. */
  #still({ picture: { samples, width, height }, isOfGpu }: Rendering) {
    if (this.#isArriving) return;
    this.#say("The picture is finished.");
    // Floats of GPUs may differ from the processor's: none was compared but a software one.
    this.#emit("still", { samples, width, height, isExact: !isOfGpu && (this.#info?.detail?.isExact ?? true) });
  }

  #progress(share: number | undefined) {
    showProgress(this.#parts, share);
    this.#emit("progress", { totalProgress: share });
  }

  #say(text: string) {
    this.#parts.status.textContent = text;
  }

  #fail(error: unknown, type: "loadfailure" | "renderfailure") {
    // Who was ended on purpose did not fail.
    if (error instanceof ClosedError) return;
    const message = error instanceof Error ? error.message : String(error);
    if (!this.#info || (error instanceof TracerError && error.isFatal)) this.#pool.end();
    // What is shown of a file whose further parts do not come stays.
    if (type === "renderfailure" || !this.#info) this.#stage.stop();
    // The picture of another scene would be taken for this one's.
    if (!this.#info) this.#blank();
    showProgress(this.#parts, null);
    this.#parts.message.textContent = message;
    this.#parts.message.hidden = false;
    this.#say("");
    this.#emit("error", { type, message, sourceError: error });
  }

  /** Gives all memory back. */
  #free() {
    this.#life?.abort();
    this.#clear();
  }

  /** Shows nothing. */
  #clear() {
    this.#forget();
    this.#load = this.#again = undefined;
    clearTimeout(this.#speak);
    this.#parts.message.hidden = true;
    showProgress(this.#parts, null);
    this.#say("");
    this.#blank();
  }

  /** Lets go of the scene: nobody is told of it any more, and there is room for another one. */
  #forget() {
    this.#load?.abort();
    this.#stage.stop();
    this.#pool.end();
    this.#info = this.#view = this.#start = undefined;
  }

  /** Nothing is on the canvas. */
  #blank() {
    const { canvas } = this.#parts;
    [canvas.width, canvas.height] = [1, 1];
    this.#describe();
    canvas.classList.add("blank");
  }
}

declare global {
  interface HTMLElementTagNameMap {
    "voxtrace-viewer": VoxtraceViewer;
  }
}
