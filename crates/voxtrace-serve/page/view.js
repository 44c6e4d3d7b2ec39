// One scene: its picture, traced by this page or by the server, and what is known about it.
import { RemoteView } from "./remote.js";

const number = (value) => value.toLocaleString("en");

export function bytesText(bytes) {
  const units = ["bytes", "kB", "MB", "GB", "TB"];
  let unit = 0;
  for (; bytes >= 1000 && unit < units.length - 1; unit++) bytes /= 1000;
  return `${unit === 0 ? bytes : bytes.toPrecision(3)} ${units[unit]}`;
}

/** Formats that the element's own small module reads; of others it gets the packed scene. */
const READ_BY_PAGE = /\.(vox|vxt)$/i;

export class SceneView {
  #remote;
  #stage = document.createElement("div");
  #life = new AbortController();

  /** Shows the scene at `path`, as it stands in addresses, in `main`. */
  constructor(main, path, name, server) {
    const view = document.createElement("div");
    view.className = "view";
    this.#stage.className = "stage";
    const facts = document.createElement("aside");
    facts.className = "facts-of-scene";
    facts.setAttribute("aria-label", "About the scene");
    const title = document.createElement("h1");
    title.textContent = name;
    const waits = document.createElement("p");
    waits.textContent = "Reading …";
    facts.append(title, waits);
    view.append(this.#stage, facts);
    main.replaceChildren(view);
    void this.#fill(facts, waits, path, name, server);
  }

  end() {
    this.#life.abort();
    this.#remote?.end();
    this.#stage.replaceChildren();
  }

  async #fill(facts, waits, path, name, server) {
    let info;
    try {
      const answer = await fetch(`/api/info/${path}`, { signal: this.#life.signal });
      info = await answer.json();
      if (!answer.ok) throw new Error(info.error);
    } catch (error) {
      if (this.#life.signal.aborted) return;
      waits.className = "alarm";
      waits.setAttribute("role", "alert");
      waits.textContent = error.message;
      return;
    }
    if (this.#life.signal.aborted) return;
    waits.remove();
    facts.append(this.#choice(info, path, name, server), listOf(info), ...notesOf(info), ...fileOf(info, path));
  }

  /** Who traces, and a way to change it where there is a choice. */
  #choice(info, path, name, server) {
    const canTraceHere = server.has_element && info.fits_pages;
    const show = (isHere) => {
      this.#remote?.end();
      this.#remote = undefined;
      this.#stage.replaceChildren();
      // A folder has no bytes of its own, whatever it is called.
      const isRead = READ_BY_PAGE.test(name) && info.file_bytes !== null;
      if (isHere) void this.#showHere(isRead ? `/files/${path}` : `/api/packed/${path}`, name);
      else this.#remote = new RemoteView(this.#stage, path, name);
    };
    show(canTraceHere);
    if (!canTraceHere) {
      const why = document.createElement("p");
      why.className = "quiet";
      why.textContent = server.has_element ? "The server traces: the scene is large for a page." : "The server traces.";
      return why;
    }
    const choice = document.createElement("fieldset");
    const legend = document.createElement("legend");
    legend.textContent = "Who traces";
    const option = (value, text, isChosen) => {
      const label = document.createElement("label");
      const input = Object.assign(document.createElement("input"), { type: "radio", name: "who", value, checked: isChosen });
      input.addEventListener("change", () => show(value === "page"));
      label.append(input, text);
      return label;
    };
    choice.append(legend, option("page", "This page", true), option("server", "The server", false));
    return choice;
  }

  async #showHere(src, name) {
    const failure = await import("/element/voxtrace.js").then(() => undefined, (error) => error);
    if (this.#life.signal.aborted || this.#remote) return;
    if (failure) {
      const notice = Object.assign(document.createElement("p"), { className: "notice", textContent: `This page cannot trace: ${failure.message}. The server can.` });
      notice.setAttribute("role", "alert");
      return void this.#stage.replaceChildren(notice);
    }
    const viewer = document.createElement("voxtrace-viewer");
    for (const [key, value] of Object.entries({ src, alt: `Voxels: ${name}`, "camera-controls": "", "no-drop": "" })) viewer.setAttribute(key, value);
    this.#stage.replaceChildren(viewer);
  }
}

function listOf(info) {
  const unit = info.unit ? ` of ${info.voxel_size.toPrecision(3)} ${info.unit}` : "";
  const facts = [
    ["Format", info.format],
    ["Size", `${info.size.map(number).join(" × ")} voxels${unit}`],
    ["Voxels", number(info.voxels)],
    ["Models", number(info.models)],
    ["Instances", number(info.instances)],
    ["Materials", number(info.materials)],
    ["Glowing", `${number(info.emissive_voxels)} voxels`],
    ["Cameras", info.cameras.join(", ") || "none"],
    ["In memory", bytesText(info.bytes)],
    ["File", info.file_bytes === null ? "a folder" : bytesText(info.file_bytes)],
    ["Hash", info.content_hash],
  ];
  const list = document.createElement("dl");
  for (const [name, value] of facts) {
    const [term, description] = [document.createElement("dt"), document.createElement("dd")];
    [term.textContent, description.textContent] = [name, value];
    list.append(term, description);
  }
  return list;
}

function notesOf({ notes }) {
  if (notes.length === 0) return [];
  const list = document.createElement("ul");
  list.className = "notes quiet";
  list.append(...notes.map((note) => Object.assign(document.createElement("li"), { textContent: note })));
  return [list];
}

function fileOf(info, path) {
  if (info.file_bytes === null) return [];
  const link = Object.assign(document.createElement("a"), { href: `/files/${path}`, textContent: "Download the file", download: "" });
  return [link];
}
