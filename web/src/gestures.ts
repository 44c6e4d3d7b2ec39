// Mouse, touch and keys to movements of a view.

export interface Moves {
  /** Turned by pixels. */
  turn(x: number, y: number): void;
  /** Moved across the picture by pixels. */
  pan(x: number, y: number): void;
  /** Distance times this. */
  zoom(factor: number): void;
  /** The first view again. */
  home(): void;
}

/** What an arrow key turns by, pixels of a drag. */
const STEP = 24;
const ZOOM = 1.15;

/** Listens to an element until `signal` ends it. `isOn` says whether it may be moved. */
export function listen(element: HTMLElement, moves: Moves, isOn: () => boolean, signal: AbortSignal) {
  const pointers = new Map<number, { x: number; y: number }>();
  const middle = () => {
    const all = [...pointers.values()];
    const sum = all.reduce((a, b) => ({ x: a.x + b.x, y: a.y + b.y }));
    return { x: sum.x / all.length, y: sum.y / all.length };
  };
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };

  element.addEventListener(
    "pointerdown",
    (event) => {
      if (!isOn() || pointers.size >= 2 || event.button > 2) return;
      pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      // A pointer that was lifted meanwhile cannot be captured.
      try {
        element.setPointerCapture(event.pointerId);
      } catch {}
    },
    { signal },
  );
  element.addEventListener(
    "pointermove",
    (event) => {
      const last = pointers.get(event.pointerId);
      if (!last || !isOn()) return;
      const [before, apart] = [middle(), spread()];
      [last.x, last.y] = [event.clientX, event.clientY];
      const after = middle();
      const [x, y] = [after.x - before.x, after.y - before.y];
      const isPan = pointers.size === 2 || event.shiftKey || event.ctrlKey || (event.buttons & 6) !== 0;
      if (apart > 0 && spread() > 0) moves.zoom(apart / spread());
      if (isPan) moves.pan(x, y);
      else moves.turn(x, y);
    },
    { signal },
  );
  for (const name of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
    element.addEventListener(name, (event) => pointers.delete(event.pointerId), { signal });
  }
  element.addEventListener("contextmenu", (event) => isOn() && event.preventDefault(), { signal });
  element.addEventListener(
    "wheel",
    (event) => {
      if (!isOn()) return;
      event.preventDefault();
      // Lines and pages of some mice, in pixels.
      const pixels = event.deltaY * [1, 16, 400][event.deltaMode]!;
      moves.zoom(Math.exp(Math.max(-1, Math.min(1, pixels / 500))));
    },
    { signal, passive: false },
  );
  element.addEventListener(
    "keydown",
    (event) => {
      if (!isOn() || event.altKey || event.metaKey || event.ctrlKey) return;
      if (!press(event, moves)) return;
      event.preventDefault();
      event.stopPropagation();
    },
    { signal },
  );
}

/** How far a press may go and still be no drag, pixels. */
const STILL = 4;

/** Tells where an element is pressed without dragging, from its upper left corner, until `signal` ends it; Enter is a press in the middle. */
export function listenToPresses(element: HTMLElement, pressed: (x: number, y: number) => void, signal: AbortSignal) {
  let start = { x: 0, y: 0 };
  element.addEventListener("pointerdown", ({ clientX: x, clientY: y }) => (start = { x, y }), { signal });
  element.addEventListener("click", (event) => {
    if (Math.hypot(event.clientX - start.x, event.clientY - start.y) > STILL) return;
    const box = element.getBoundingClientRect();
    // A page may show it scaled, by a transform.
    const scale = element.clientWidth / box.width;
    pressed((event.clientX - box.x) * scale, (event.clientY - box.y) * scale);
  }, { signal });
  element.addEventListener("keydown", (event) => {
    if (event.key === "Enter") pressed(element.clientWidth / 2, element.clientHeight / 2);
  }, { signal });
}

/** What a key does; false for other keys. */
function press({ key, shiftKey }: KeyboardEvent, moves: Moves): boolean {
  const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[key];
  if (arrow) {
    const [x, y] = [arrow[0]! * STEP, arrow[1]! * STEP];
    if (shiftKey) moves.pan(x, y);
    else moves.turn(x, y);
  } else if (key === "+" || key === "=" || key === "PageUp") moves.zoom(1 / ZOOM);
  else if (key === "-" || key === "_" || key === "PageDown") moves.zoom(ZOOM);
  else if (key === "Home") moves.home();
  else return false;
  return true;
}
