// What is inside of the element.

import STYLE from "./element.css";

export interface Parts {
  canvas: HTMLCanvasElement;
  poster: HTMLElement;
  bar: HTMLElement;
  message: HTMLElement;
  pause: HTMLButtonElement;
  status: HTMLElement;
}

/** Fills the element's own tree, node by node: pages that require Trusted Types take no markup. */
export function build(root: ShadowRoot): Parts {
  const add = <N extends keyof HTMLElementTagNameMap>(name: N, attributes: Record<string, string>, content: string | Node = "") => {
    const made = document.createElement(name);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    made.append(content);
    root.append(made);
    return made;
  };
  dress(root);
  const canvas = add("canvas", { part: "canvas", class: "blank", role: "img", "aria-label": "Voxels", width: "1", height: "1" });
  const poster = add("div", { part: "poster", class: "poster" }, add("slot", { name: "poster" }));
  add("div", { class: "ring" });
  const bar = add(
    "div",
    { part: "progress-bar", class: "bar", role: "progressbar", "aria-label": "Loading", "aria-valuemin": "0", "aria-valuemax": "100", hidden: "" },
    add("div", {}),
  );
  const message = add("div", { part: "message", class: "message", role: "alert", hidden: "" });
  const pause = add("button", { part: "pause-button", class: "turn", type: "button", hidden: "" }, "Pause");
  const status = add("div", { class: "spoken", role: "status" });
  add("div", { class: "spoken", id: "keys", hidden: "" }, "Arrow keys turn, with Shift they move; plus and minus zoom; Home shows the first view.");
  return { canvas, poster, bar, message, pause, status };
}

/** The window that shows an element: another one than the page's where that moved it there. */
export const windowOf = ({ ownerDocument }: Element) => ownerDocument.defaultView ?? window;

/** Gives the element's own tree its style, which belongs to the document that it is in. */
export function dress(root: ShadowRoot) {
  const view = root.ownerDocument.defaultView;
  // Documents that nobody sees have none.
  if (!view) return;
  // Not an element of its own: strict content security policies refuse those.
  const style = new view.CSSStyleSheet();
  style.replaceSync(STYLE);
  root.adoptedStyleSheets = [style];
}

/** Shows a share that is loaded: 0 to 1, `undefined` for an unknown one, `null` for nothing that loads. */
export function showProgress({ bar }: Parts, share: number | undefined | null) {
  bar.hidden = share === null;
  bar.classList.toggle("endless", share === undefined);
  if (share === undefined || share === null) bar.removeAttribute("aria-valuenow");
  else bar.setAttribute("aria-valuenow", String(Math.round(share * 100)));
  (bar.firstElementChild as HTMLElement).style.transform = share === undefined ? "" : `scaleX(${share ?? 0})`;
}
