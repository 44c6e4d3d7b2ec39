// A scene that the server traces: says what is looked at over a web socket, shows the pictures that come back, and says when it has. `docs/serve.md` has
// the protocol.
import { cameraOf, panned, turned, viewOf, zoomed } from "./camera.js";

/** Numbers before each picture: its own, its view's, samples, of how many, and whether it is a PNG. */
const HEAD_BYTES = 20;
/** As much as the server renders. */
const MOST_PIXELS = 1920 * 1200;
const DEGREES_PER_PIXEL = 0.35;
const KEY_DEGREES = 10;

export class RemoteView {
  #canvas = document.createElement("canvas");
  #state = document.createElement("p");
  #notice = document.createElement("p");
  #socket;
  #path;
  #home;
  /** The camera of the first view, as the scene has it. */
  #homeCamera;
  #view;
  #size = 1;
  #id = 0;
  #last = "";
  /** Number of the picture that is shown. */
  #frame = 0;
  #isAsked = false;
  #pointers = new Map();
  #life = new AbortController();

  /** Shows the scene at `path`, as it stands in addresses, in `stage`. */
  constructor(stage, path, name) {
    this.#path = path;
    this.#canvas.tabIndex = 0;
    this.#canvas.setAttribute("role", "img");
    this.#canvas.setAttribute("aria-label", `Voxels: ${name}. Arrow keys turn, with Shift they move; plus and minus zoom; Home shows the first view.`);
    this.#state.className = "state";
    this.#state.setAttribute("role", "status");
    this.#notice.className = "notice";
    this.#notice.setAttribute("role", "alert");
    this.#notice.hidden = true;
    stage.append(this.#canvas, this.#state, this.#notice);
    const size = new ResizeObserver(() => this.#ask());
    size.observe(this.#canvas);
    this.#life.signal.addEventListener("abort", () => size.disconnect());
    this.#listen();
    this.#connect();
  }

  /** Ends it: the server traces nothing for it any more. */
  end() {
    this.#life.abort();
    this.#socket?.close();
  }

  #connect() {
    this.#notice.hidden = true;
    this.#state.textContent = "Opening …";
    const socket = new WebSocket(`${location.protocol === "https:" ? "wss" : "ws"}://${location.host}/api/remote/${this.#path}`);
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    this.#frame = 0;
    let failure = "";
    socket.onmessage = ({ data }) => {
      if (typeof data !== "string") return void this.#show(socket, data);
      const said = JSON.parse(data);
      if (said.type === "error") failure = said.message;
      else this.#begin(said);
    };
    socket.onclose = ({ reason }) => {
      if (this.#life.signal.aborted || socket !== this.#socket) return;
      void this.#explain(failure || reason);
    };
  }

  /** Says why there are no pictures. Of a refused web socket browsers do not tell the reason; the scene's facts do. */
  async #explain(reason) {
    if (!reason) {
      const answer = await fetch(`/api/info/${this.#path}`).catch(() => undefined);
      const said = answer && !answer.ok ? await answer.json().catch(() => ({})) : {};
      reason = said.error ?? (answer ? "the server traces for as many clients as it may already" : "the server cannot be reached");
    }
    const again = document.createElement("button");
    again.textContent = "Try again";
    again.onclick = () => this.#connect();
    this.#state.textContent = "";
    this.#notice.replaceChildren(`No pictures: ${reason}. `, again);
    this.#notice.hidden = false;
  }

  #begin({ camera, bounds: [least, most], tracer }) {
    this.#size = Math.hypot(...least.map((value, axis) => most[axis] - value)) || 1;
    const isHome = this.#view === this.#home;
    [this.#home, this.#homeCamera] = [viewOf(camera), camera];
    if (isHome) this.#view = this.#home;
    this.#canvas.title = tracer;
    this.#last = "";
    this.#ask();
  }

  async #show(socket, data) {
    const head = new Uint32Array(data.slice(0, HEAD_BYTES));
    const [frame, view, samples, of, isWhole] = head;
    try {
      const picture = await createImageBitmap(new Blob([new Uint8Array(data, HEAD_BYTES)], { type: isWhole ? "image/png" : "image/jpeg" }));
      // A large one may be read later than the small one that came after it.
      if (socket !== this.#socket || frame < this.#frame) return picture.close();
      this.#frame = frame;
      const context = this.#canvas.getContext("2d", { alpha: false });
      // A coarse picture is shown in the size of the fine one.
      const [width, height] = this.#pixels();
      if (this.#canvas.width !== width || this.#canvas.height !== height) [this.#canvas.width, this.#canvas.height] = [width, height];
      context.imageSmoothingQuality = "high";
      context.imageSmoothingEnabled = picture.width !== width;
      context.drawImage(picture, 0, 0, width, height);
      const state = isWhole ? `Finished: ${of} samples` : `${samples} of ${of} samples`;
      // What is said all the time nobody wants to hear.
      this.#state.setAttribute("aria-live", isWhole ? "polite" : "off");
      this.#state.textContent = state;
      Object.assign(this.#canvas.dataset, { frame, view, samples, kind: isWhole ? "png" : "jpeg", pixels: `${picture.width}x${picture.height}` });
      // From now on it has no size.
      picture.close();
    } finally {
      if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify({ type: "ack", frame }));
    }
  }

  /** Pixels to ask for: those of the screen, as far as the server renders so many. */
  #pixels() {
    const ratio = devicePixelRatio || 1;
    const [width, height] = [Math.max(1, this.#canvas.clientWidth * ratio), Math.max(1, this.#canvas.clientHeight * ratio)];
    const scale = Math.min(1, Math.sqrt(MOST_PIXELS / (width * height)));
    return [Math.max(1, Math.floor(width * scale)), Math.max(1, Math.floor(height * scale))];
  }

  /** Asks for pictures of the view, once a frame of the screen. */
  #ask() {
    if (this.#isAsked) return;
    this.#isAsked = true;
    requestAnimationFrame(() => {
      this.#isAsked = false;
      if (!this.#view || this.#socket?.readyState !== WebSocket.OPEN) return;
      const [width, height] = this.#pixels();
      const camera = this.#view === this.#home ? this.#homeCamera : cameraOf(this.#view);
      const wanted = JSON.stringify({ camera, width, height });
      if (wanted === this.#last) return;
      this.#last = wanted;
      this.#socket.send(JSON.stringify({ type: "view", id: ++this.#id, ...JSON.parse(wanted) }));
    });
  }

  #move(change) {
    if (!this.#view) return;
    this.#view = change(this.#view);
    this.#ask();
  }

  #listen() {
    const { signal } = this.#life;
    const on = (name, does, options = {}) => this.#canvas.addEventListener(name, does, { signal, ...options });
    on("contextmenu", (event) => event.preventDefault());
    on("pointerdown", (event) => {
      this.#canvas.setPointerCapture(event.pointerId);
      this.#pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    for (const name of ["pointerup", "pointercancel"]) on(name, (event) => this.#pointers.delete(event.pointerId));
    on("pointermove", (event) => {
      const before = this.#pointers.get(event.pointerId);
      if (!before) return;
      const now = [event.clientX, event.clientY];
      const others = [...this.#pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
      this.#pointers.set(event.pointerId, now);
      const [x, y] = [now[0] - before[0], now[1] - before[1]];
      if (others.length > 0) {
        // Two fingers: each moves by its half, and their distance zooms.
        const distance = (at) => Math.hypot(at[0] - others[0][0], at[1] - others[0][1]) || 1;
        const factor = distance(before) / distance(now);
        this.#move((view) => zoomed(panned(view, x / 2 / this.#canvas.clientHeight, y / 2 / this.#canvas.clientHeight), factor, this.#size));
      } else if (event.shiftKey || event.buttons & 6) {
        this.#move((view) => panned(view, x / this.#canvas.clientHeight, y / this.#canvas.clientHeight));
      } else {
        this.#move((view) => turned(view, x * DEGREES_PER_PIXEL, y * DEGREES_PER_PIXEL));
      }
    });
    on("wheel", (event) => {
      event.preventDefault();
      const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? event.deltaY * 16 : event.deltaY;
      this.#move((view) => zoomed(view, Math.exp(Math.max(-100, Math.min(100, pixels)) * 0.002), this.#size));
    }, { passive: false });
    on("keydown", (event) => {
      const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      const arrow = arrows[event.key];
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (arrow && event.shiftKey) this.#move((view) => panned(view, -arrow[0] * 0.05, -arrow[1] * 0.05));
      else if (arrow) this.#move((view) => turned(view, -arrow[0] * KEY_DEGREES, -arrow[1] * KEY_DEGREES));
      else if (event.key === "+" || event.key === "=") this.#move((view) => zoomed(view, 0.9, this.#size));
      else if (event.key === "-") this.#move((view) => zoomed(view, 1 / 0.9, this.#size));
      else if (event.key === "Home") this.#move(() => this.#home);
      else return;
      event.preventDefault();
    });
  }
}
