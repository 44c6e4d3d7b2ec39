// The list of a folder, the way from folder to folder and to scenes, and files that are dropped. `#/inner/castle.vox` in the address is where one is.
import { bytesText, SceneView } from "./view.js";

const find = (id) => document.getElementById(id);
const [main, trail, uploads] = ["main", "trail", "uploads"].map(find);
const make = (name, given = {}) => Object.assign(document.createElement(name), given);
/** A name below the folder, as it stands in addresses. */
const encoded = (name) => name.split("/").map(encodeURIComponent).join("/");
/** A part of such a name; one that somebody has typed may be none. */
const decoded = (part) => {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
};
const joined = (folder, name) => (folder ? `${folder}/${name}` : name);
/** Thumbnails that are asked for at the same time: others of the browser's connections stay free. */
const MOST_THUMBNAILS = 2;

let server;
let shown;
let visit = 0;

async function ask(address, options) {
  const answer = await fetch(address, options);
  const said = await answer.json().catch(() => ({}));
  if (!answer.ok) throw new Error(said.error ?? `the server answers ${answer.status}`);
  return said;
}

/** Where one is: the folder, and the scene in it, if one is open. */
function where() {
  const [kind, ...rest] = location.hash.replace(/^#\/?/, "").split("/");
  const name = rest.map(decoded).join("/");
  return kind === "scene" ? { scene: name, folder: name.split("/").slice(0, -1).join("/") } : { folder: kind === "folder" ? name : "" };
}

async function go() {
  const number = ++visit;
  shown?.end();
  shown = undefined;
  const { scene, folder } = where();
  showTrail(scene ?? folder, scene !== undefined);
  try {
    server ??= await ask("/api/server");
    find("add").hidden = server.largest_upload === 0;
    showTrail(scene ?? folder, scene !== undefined);
    if (number !== visit) return;
    if (scene === undefined) await showFolder(folder, number);
    else shown = new SceneView(main, encoded(scene), scene.split("/").at(-1), server);
  } catch (error) {
    if (number === visit) main.replaceChildren(make("p", { className: "alarm", role: "alert", textContent: `${error.message}` }));
  }
}

function showTrail(name, isScene) {
  const parts = name ? name.split("/") : [];
  const root = make("li");
  const title = server?.folder ?? "voxtrace";
  root.append(parts.length ? make("a", { href: "#/", textContent: title }) : title);
  const items = parts.map((part, index) => {
    const item = make("li");
    const isLast = index === parts.length - 1;
    item.append(isLast ? part : make("a", { href: `#/folder/${encoded(parts.slice(0, index + 1).join("/"))}`, textContent: part }));
    if (isLast) item.setAttribute("aria-current", isScene ? "true" : "page");
    return item;
  });
  trail.replaceChildren(root, ...items);
  document.title = parts.length ? `${parts.at(-1)} – voxtrace` : `${title} – voxtrace`;
}

async function showFolder(folder, number) {
  const listing = await ask(folder ? `/api/list/${encoded(folder)}` : "/api/list");
  if (number !== visit) return;
  const { compare } = new Intl.Collator(undefined, { numeric: true });
  const byName = (a, b) => compare(a.name, b.name);
  const parts = [];
  if (listing.folders.length) {
    const folders = make("ul", { className: "folders" });
    folders.setAttribute("aria-label", "Folders");
    folders.append(...listing.folders.sort(byName).map((entry) => folderItem(folder, entry)));
    parts.push(folders);
  }
  if (listing.scenes.length) {
    const scenes = make("ul", { className: "scenes" });
    scenes.setAttribute("aria-label", "Scenes");
    scenes.append(...listing.scenes.sort(byName).map((entry) => sceneItem(folder, entry)));
    parts.push(scenes);
  }
  if (!parts.length) {
    const how = server.largest_upload ? "Drop files here: voxels, meshes, clouds of points, scans." : "There are no scenes in it.";
    parts.push(make("p", { className: "quiet", textContent: `The folder is empty. ${how}` }));
  }
  if (listing.is_cut) parts.push(make("p", { className: "quiet", textContent: "There is more in this folder than is shown." }));
  const title = make("h1", { className: "spoken", textContent: `Scenes in ${folder || server.folder || "the folder"}` });
  main.replaceChildren(title, ...parts);
  showThumbnails(number);
}

function folderItem(folder, { name, format }) {
  const item = make("li");
  const path = encoded(joined(folder, name));
  item.append(make("a", { href: `#/folder/${path}`, textContent: `${name}/` }));
  if (format) item.append(make("a", { href: `#/scene/${path}`, textContent: `as one scene: ${format}` }));
  return item;
}

function sceneItem(folder, { name, format, bytes }) {
  const item = make("li");
  const path = encoded(joined(folder, name));
  const card = make("a", { className: "card", href: `#/scene/${path}` });
  const thumbnail = make("span", { className: "thumbnail" });
  thumbnail.dataset.path = path;
  card.append(thumbnail, make("span", { className: "name", textContent: name }), make("span", { className: "facts", textContent: `${format}, ${bytesText(bytes)}` }));
  item.append(card);
  return item;
}

/** Asks for the thumbnails that are in view, a few at a time. */
function showThumbnails(number) {
  const waiting = new Set();
  let asked = 0;
  const next = async () => {
    if (asked >= MOST_THUMBNAILS || number !== visit) return;
    const [place] = waiting;
    if (!place) return;
    waiting.delete(place);
    asked++;
    await showThumbnail(place, number);
    asked--;
    void next();
  };
  const seen = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (target.dataset.done) seen.unobserve(target);
      else if (isIntersecting) waiting.add(target);
      else waiting.delete(target);
    }
    for (let count = 0; count < MOST_THUMBNAILS; count++) void next();
  }, { rootMargin: "200px" });
  for (const place of main.querySelectorAll(".thumbnail")) seen.observe(place);
}

async function showThumbnail(place, number) {
  for (;;) {
    const answer = await fetch(`/api/thumbnail/${place.dataset.path}`).catch(() => undefined);
    if (number !== visit) return;
    if (answer?.status === 503) {
      await new Promise((done) => setTimeout(done, 1000 * Number(answer.headers.get("retry-after") ?? 2)));
      continue;
    }
    place.dataset.done = "true";
    // An answer may end before it should.
    const jpeg = answer?.ok ? await answer.blob().catch(() => undefined) : undefined;
    if (jpeg) {
      const address = URL.createObjectURL(jpeg);
      const picture = make("img", { alt: "", src: address });
      picture.onload = () => URL.revokeObjectURL(address);
      place.replaceChildren(picture);
    } else {
      const said = await answer?.json().catch(() => undefined);
      place.replaceChildren(make("p", { className: "alarm", textContent: said?.error ?? "the server cannot be reached" }));
    }
    return;
  }
}

/** The end of all files so far: those of several drops are sent one after the other, too, and there is one question at a time. */
let added = Promise.resolve();

/** Sends files to the folder that is shown now, once those before are there. */
function add(files) {
  const { folder } = where();
  uploads.hidden = false;
  for (const file of files) {
    const line = make("p");
    const bar = make("progress", { max: 1, value: 0 });
    bar.setAttribute("aria-label", file.name);
    line.append(file.name, bar);
    uploads.append(line);
    added = added.then(() => addOne(file, folder, line, bar)).catch(({ message }) => say(line, `${file.name}: ${message}`, "alarm"));
  }
  added = added.then(() => where().scene === undefined && go());
}

/** Sends a file, and asks before it takes another's place. */
async function addOne(file, folder, line, bar) {
  // A server that has had enough hangs up, and browsers do not tell why.
  if (file.size > server?.largest_upload) return say(line, `${file.name}: it is larger than the ${bytesText(server.largest_upload)} that this server takes`, "alarm");
  let answer = await send(file, folder, false, bar);
  if (answer.status === 409 && (await wantsToReplace(answer.said.error))) answer = await send(file, folder, true, bar);
  if (answer.status === 201) {
    const link = make("a", { href: `#/scene/${encoded(answer.said.name)}`, textContent: answer.said.name.split("/").at(-1) });
    line.replaceChildren(`${file.name} is here as `, link);
  } else if (answer.status === 409) say(line, `${file.name}: ${answer.said.error}, and was left.`);
  else say(line, answer.said.error ?? `${file.name}: ${await whyNotSent(file)}`, "alarm");
}

/** Why a file got no answer. Of one that it cannot read, as of a folder, a browser tells no more than of a server that is away. */
async function whyNotSent(file) {
  const isRead = await file.slice(0, 1).arrayBuffer().then(() => true, () => false);
  return isRead ? "the server cannot be reached" : "it cannot be read here; of a folder, add the files that are in it";
}

function say(line, text, className = "") {
  line.className = className;
  line.replaceChildren(text);
}

function send(file, folder, replaces, bar) {
  return new Promise((done) => {
    const request = new XMLHttpRequest();
    request.open("PUT", `/api/upload/${encoded(joined(folder, file.name))}${replaces ? "?replace=true" : ""}`);
    request.responseType = "json";
    request.upload.onprogress = ({ loaded, total }) => {
      // Sent; now it is read and written.
      if (loaded === total) bar.removeAttribute("value");
      else bar.value = loaded / total;
    };
    request.onload = () => done({ status: request.status, said: request.response ?? {} });
    request.onerror = () => done({ status: 0, said: {} });
    request.send(file);
  });
}

function wantsToReplace(what) {
  const asks = find("asks");
  find("question").textContent = `${what}. Shall the new file take its place?`;
  asks.returnValue = "skip";
  asks.showModal();
  return new Promise((done) => asks.addEventListener("close", () => done(asks.returnValue === "replace"), { once: true }));
}

const carriesFiles = (event) => server?.largest_upload > 0 && event.dataTransfer?.types.includes("Files");
addEventListener("dragover", (event) => {
  if (!carriesFiles(event)) return;
  event.preventDefault();
  document.body.classList.add("dropping");
});
addEventListener("dragleave", (event) => event.relatedTarget || document.body.classList.remove("dropping"));
addEventListener("drop", (event) => {
  document.body.classList.remove("dropping");
  if (!carriesFiles(event)) return;
  event.preventDefault();
  add([...event.dataTransfer.files]);
});
find("files").addEventListener("change", ({ target }) => {
  const files = [...target.files];
  target.value = "";
  add(files);
});
addEventListener("hashchange", go);
await go();
