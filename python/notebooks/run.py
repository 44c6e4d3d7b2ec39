"""Runs the notebooks of this folder, each in a kernel of its own, and fails with the first one that does.

python run.py [NAME …]         runs all of them, or those named, two at a time; nothing is written
python run.py --save [NAME …]  one at a time, keeps what they put out but for measurements, pictures made small, so that the repository stays small and GitHub shows them
"""

from __future__ import annotations

import argparse
import asyncio
import base64
import io
import sys
import time
from pathlib import Path
from typing import Any

import nbformat
from nbclient import NotebookClient
from PIL import Image

FOLDER = Path(__file__).parent
#: Of pictures that are kept, pixels.
WIDTH = 640
#: Numbers of one machine say nothing about another.
KEPT_WITHOUT_RESULTS = {"benchmark"}


def small(picture: bytes) -> tuple[str, bytes]:
    """A picture as a JPEG, or as a PNG of few colours where that is smaller, as plots are."""
    image = Image.open(io.BytesIO(picture)).convert("RGBA")
    image = Image.alpha_composite(Image.new("RGBA", image.size, "white"), image).convert("RGB")
    if image.width > WIDTH:
        image = image.resize((WIDTH, round(image.height * WIDTH / image.width)), Image.Resampling.LANCZOS)
    written = {}
    for kind, shown, options in (
        ("image/jpeg", image, {"quality": 82, "optimize": True}),
        ("image/png", image.quantize(48, dither=Image.Dither.NONE), {"optimize": True}),
    ):
        file = io.BytesIO()
        shown.save(file, kind.removeprefix("image/"), **options)
        written[kind] = file.getvalue()
    # Few colours are only right for plots, which are much smaller so.
    is_plot = len(written["image/png"]) < 0.7 * len(written["image/jpeg"])
    return ("image/png", written["image/png"]) if is_plot else ("image/jpeg", written["image/jpeg"])


def kept(output: Any) -> Any:
    """What of an output stays in the file: text and small pictures, no state of widgets."""
    data = output.get("data")
    if data is None:
        return output
    data.pop("application/vnd.jupyter.widget-view+json", None)
    for kind in ("image/png", "image/jpeg"):
        if kind in data:
            name, picture = small(base64.b64decode(data.pop(kind)))
            data.clear()
            data[name] = base64.b64encode(picture).decode()
    return output


async def run(path: Path, saves: bool, turns: asyncio.Semaphore) -> None:
    notebook = nbformat.read(path, as_version=4)
    async with turns:
        start = time.perf_counter()
        client = NotebookClient(notebook, timeout=300, kernel_name="python3", store_widget_state=False, resources={"metadata": {"path": str(FOLDER)}})
        await client.async_execute()
        print(f"{path.stem}: {time.perf_counter() - start:.1f} s", flush=True)
    if not saves or path.stem in KEPT_WITHOUT_RESULTS:
        return
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if cell.cell_type == "code":
            cell.outputs = [kept(output) for output in cell.outputs if output.get("name") != "stderr"]
    notebook.metadata.pop("widgets", None)
    # The version of Python that ran it last is of no interest.
    notebook.metadata.language_info = {"name": "python"}
    nbformat.write(notebook, path)


async def run_all(paths: list[Path], saves: bool, at_a_time: int) -> None:
    turns = asyncio.Semaphore(at_a_time)
    await asyncio.gather(*(run(path, saves, turns) for path in paths))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--save", action="store_true")
    given = parser.parse_args()
    paths = [FOLDER / f"{name.removesuffix('.ipynb')}.ipynb" for name in given.names] or sorted(FOLDER.glob("*.ipynb"))
    if not paths:
        sys.exit("there are no notebooks")
    # What is measured while something else runs is wrong.
    asyncio.run(run_all(paths, given.save, 1 if given.save else 2))


if __name__ == "__main__":
    main()
