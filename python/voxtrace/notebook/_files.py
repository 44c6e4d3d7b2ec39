"""The files of the page: the script of the widget, and the worker and module that trace in a browser. `cargo xtask web` and `npm run build` in `web/` put them here."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parent / "static"

#: What a package that was built without them shows: the picture, and why nothing can be turned.
_WITHOUT = """
export default {
  render({ model, el }) {
    const picture = document.createElement("img");
    picture.src = URL.createObjectURL(new Blob([model.get("_poster")]));
    picture.style.maxWidth = "100%";
    const said = document.createElement("p");
    said.textContent = "This voxtrace was built without its viewer for pages: `cargo xtask web`, then `npm ci && npm run build` in web/, then the package anew.";
    el.replaceChildren(picture, said);
  },
};
"""


def are_there() -> bool:
    """Whether the package has them."""
    return (FOLDER / "widget.js").is_file()


def script() -> str:
    """The script of the widget."""
    return (FOLDER / "widget.js").read_text("utf-8") if are_there() else _WITHOUT


def style() -> str:
    """Its style sheet."""
    return (FOLDER / "widget.css").read_text("utf-8") if are_there() else ""


def read(name: str) -> bytes:
    """The bytes of a file that a page asks for by its name."""
    path = FOLDER / name
    if path.parent != FOLDER or not path.is_file():
        raise FileNotFoundError(f"the package has no file {name!r}")
    return path.read_bytes()
