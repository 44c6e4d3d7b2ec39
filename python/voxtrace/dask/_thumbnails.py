"""Small pictures of many files by many machines."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .. import _voxtrace
from .._voxtrace import Renderer
from ._animation import picture_file
from ._sharing import address_of_worker, elsewhere, gathered, write_whole


@dataclass(frozen=True)
class Thumbnail:
    """What became of a file."""

    #: The file that is shown.
    path: Path
    #: Its picture, `None` where there is none.
    picture: Path | None
    #: Why there is none.
    error: str | None


def thumbnails(
    client: Any,
    paths: Iterable[str | os.PathLike[str]],
    folder: str | os.PathLike[str],
    *,
    size: tuple[int, int] = (256, 256),
    samples: int = 32,
    device: str = "auto",
    resolution: int | None = None,
    overwrite: bool = False,
    retries: int = 2,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> list[Thumbnail]:
    """Render a small picture of each file by the workers of `client`, which read the files themselves: they are where workers see them.

    `paths`: files, or folders that are scenes, as `voxtrace.open` takes them; `resolution` and `options` are passed on to it. Pictures are written to `folder` as
    they come, named by the paths below the folder that all files have in common, with `.png` after the whole name. Pictures that are there already are left
    alone, unless `overwrite`. A file that cannot be read has no picture and says why; the others go on.

    Returns a `Thumbnail` for each path, in the order of the paths.
    """
    files = [Path(path) for path in paths]
    pictures = [Path(folder) / name for name in _names(files)]
    missing = [number for number, picture in enumerate(pictures) if overwrite or not picture.exists()]
    errors: dict[int, str] = {}
    # A mesh or a scan is made of no more voxels than such a picture shows.
    scale = {"resolution": resolution} if resolution else {}

    def submit(numbers: list[int], workers: list[str]) -> dict[Any, int]:
        begun: dict[Any, int] = {}
        for number in numbers:
            arguments = str(files[number]), device, size, samples, {**scale, **options}
            begun[client.submit(_render_thumbnail, *arguments, pure=False, retries=retries, **elsewhere(workers))] = number
        return begun

    def take(number: int, made: bytes | str) -> None:
        if isinstance(made, str):
            errors[number] = made
            return
        pictures[number].parent.mkdir(parents=True, exist_ok=True)
        write_whole(pictures[number], made)

    gathered(client, submit, missing, take, progress)
    return [
        Thumbnail(file, None if number in errors else pictures[number], errors.get(number))
        for number, file in enumerate(files)
    ]


def _names(files: list[Path]) -> list[Path]:
    whole = [Path(os.path.abspath(file)) for file in files]
    if not whole:
        return []
    common = Path(os.path.commonpath([file.parent for file in whole]))
    return [file.relative_to(common).with_name(f"{file.name}.png") for file in whole]


def _render_thumbnail(
    path: str, device: str, size: tuple[int, int], samples: int, options: dict[str, Any]
) -> tuple[str, bytes | str]:
    """The worker, and the picture of a file, or why there is none."""
    try:
        renderer = Renderer(_voxtrace.open(path, **options), device=device)
        image = renderer.render(samples=samples, size=size)
    except (_voxtrace.VoxtraceError, OSError, ValueError) as error:
        return address_of_worker(), str(error)
    return address_of_worker(), picture_file(image, ".png", {})
