// What is inside of the element, and how it looks.

const STYLE = `
:host {
  display: block; position: relative; width: 300px; height: 200px; overflow: hidden; contain: content;
  --back: var(--voxtrace-background, #f2f3f5); --ink: var(--voxtrace-color, #1c1f24); --panel: #ffffffee; --accent: var(--voxtrace-accent, #1659c7); --alarm: #8c1d18;
  color: var(--ink); background: var(--back); font: 14px/1.45 system-ui, sans-serif; color-scheme: light dark;
}
@media (prefers-color-scheme: dark) {
  :host { --back: var(--voxtrace-background, #16181c); --ink: var(--voxtrace-color, #eceef2); --panel: #24272dee; --accent: var(--voxtrace-accent, #8ab4ff); --alarm: #ffb4ab; }
}
:host([hidden]) { display: none; }
canvas, .poster { position: absolute; inset: 0; width: 100%; height: 100%; }
canvas { outline: none; }
canvas.blank { opacity: 0; }
:host([camera-controls]) canvas { touch-action: none; cursor: grab; }
:host([camera-controls]) canvas:active { cursor: grabbing; }
.ring { position: absolute; inset: 0; pointer-events: none; border: 3px solid transparent; }
canvas:focus-visible ~ .ring, .poster:focus-visible ~ .ring, :host([dropping]) .ring { border-color: var(--accent); }
.poster { background: center / contain no-repeat; outline: none; transition: opacity .3s; }
.poster[role] { cursor: pointer; }
.poster.gone { opacity: 0; visibility: hidden; transition: opacity .3s, visibility 0s .3s; pointer-events: none; }
.bar { position: absolute; inset: 0 0 auto; height: 4px; }
.bar > div { height: 100%; transform-origin: left; transform: scaleX(0); background: var(--accent); }
.bar.endless > div { width: 30%; transform: none; animation: wait 1.2s infinite alternate ease-in-out; }
@keyframes wait { to { margin-left: 70%; } }
.bar[hidden], .message[hidden], button[hidden] { display: none; }
.message { position: absolute; inset: auto 12px 12px 12px; max-height: calc(100% - 24px); overflow: auto; box-sizing: border-box; padding: 10px 12px; border-radius: 8px; background: var(--panel); border-left: 4px solid var(--alarm); overflow-wrap: anywhere; }
.turn { position: absolute; right: 8px; bottom: 8px; min-width: 44px; min-height: 44px; border: 0; border-radius: 8px; background: var(--panel); color: var(--ink); font: inherit; cursor: pointer; }
.turn:focus-visible { outline: 3px solid var(--accent); }
.spoken { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media (prefers-reduced-motion: reduce) { .poster, .poster.gone { transition: none; } .bar.endless > div { animation: none; width: 100%; opacity: .5; } }
`;

const MARKUP = `
<canvas part="canvas" class="blank" role="img" aria-label="Voxels" width="1" height="1"></canvas>
<div class="poster" part="poster"><slot name="poster"></slot></div>
<div class="ring"></div>
<div class="bar" part="progress-bar" role="progressbar" aria-label="Loading" aria-valuemin="0" aria-valuemax="100" hidden><div></div></div>
<div class="message" part="message" role="alert" hidden></div>
<button class="turn" part="pause-button" type="button" hidden>Pause</button>
<div class="spoken" role="status"></div>
<div class="spoken" id="keys" hidden>Arrow keys turn, with Shift they move; plus and minus zoom; Home shows the first view.</div>
`;

export interface Parts {
  canvas: HTMLCanvasElement;
  poster: HTMLElement;
  bar: HTMLElement;
  message: HTMLElement;
  pause: HTMLButtonElement;
  status: HTMLElement;
}

/** Fills the element's own tree. */
export function build(root: ShadowRoot): Parts {
  // Not an element of its own: strict content security policies refuse those.
  const style = new CSSStyleSheet();
  style.replaceSync(STYLE);
  root.adoptedStyleSheets = [style];
  root.innerHTML = MARKUP;
  const find = <E extends HTMLElement>(query: string) => root.querySelector<E>(query)!;
  return {
    canvas: find("canvas"),
    poster: find(".poster"),
    bar: find(".bar"),
    message: find(".message"),
    pause: find(".turn"),
    status: find("[role=status]"),
  };
}

/** Shows a share that is loaded: 0 to 1, `undefined` for an unknown one, `null` for nothing that loads. */
export function showProgress({ bar }: Parts, share: number | undefined | null) {
  bar.hidden = share === null;
  bar.classList.toggle("endless", share === undefined);
  if (share === undefined || share === null) bar.removeAttribute("aria-valuenow");
  else bar.setAttribute("aria-valuenow", String(Math.round(share * 100)));
  (bar.firstElementChild as HTMLElement).style.transform = share === undefined ? "" : `scaleX(${share ?? 0})`;
}
