// What is inside of the element.

import STYLE from "./element.css";

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
