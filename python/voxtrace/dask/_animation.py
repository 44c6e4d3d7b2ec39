"""Animations by many machines: each worker renders whole frames."""

from __future__ import annotations

import os
import re
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy

from .._voxtrace import Camera, Scene
from ._sharing import Packed, address_of_worker, elsewhere, gathered, packed_scene, renderer_of, sent_bytes, write_whole


def animate(
    client: Any,
    scene: Scene,
    cameras: Sequence[Camera],
    output: str | os.PathLike[str],
    *,
    transforms: Any = None,
    samples: int = 64,
    size: tuple[int, int] = (1280, 720),
    seed: int = 0,
    device: str = "auto",
    denoise: bool = True,
    exposure: float = 0.0,
    tone_map: str = "agx",
    overwrite: bool = False,
    retries: int = 5,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> list[Path]:
    """Render a frame for each camera by the workers of `client`, and write them as they come.

    `output`: where frames go, with `####` for their number, from 1 on: `.png`, `.exr` or `.vxf`. `transforms`: where the visible instances are, of shape
    `(frames, N, 4, 4)`, as `Renderer.place` takes them. The frame with the number *n* has the seed `seed + n - 1`. Files are those that `Renderer.render` and
    `Image.save` give, byte for byte, whatever the workers. Frames that are there already are left alone, unless `overwrite`: the same call goes on after an
    interruption. Everything else is as in `voxtrace.render`.

    Returns the files. Raises what `voxtrace.render` raises, and `ValueError` for other numbers of cameras and transforms.
    """
    paths = [_numbered(Path(output), number) for number in range(1, len(cameras) + 1)]
    places = None if transforms is None else numpy.asarray(transforms, dtype=float)
    if places is not None and len(places) != len(cameras):
        raise ValueError(f"{len(cameras)} cameras and transforms of {len(places)} frames")
    missing = [number for number, path in enumerate(paths) if overwrite or not path.exists()]
    if not missing:
        return paths
    data, packed = packed_scene(scene)
    frame = {"samples": samples, "size": size, "denoise": denoise, **options}
    look = {"exposure": exposure, "tone_map": tone_map}

    def submit(numbers: list[int], workers: list[str]) -> dict[Any, int]:
        sent = sent_bytes(client, data, retries, workers)
        begun: dict[Any, int] = {}
        for number in numbers:
            place = None if places is None else places[number]
            arguments = sent, packed, device, cameras[number], place, {**frame, "seed": seed + number}, look, paths[number].suffix
            begun[client.submit(_render_frame, *arguments, pure=False, retries=retries, **elsewhere(workers))] = number
        return begun

    gathered(client, submit, missing, lambda number, file: write_whole(paths[number], file), progress)
    return paths


def _numbered(output: Path, number: int) -> Path:
    name, count = re.subn("#+", lambda marks: str(number).zfill(len(marks[0])), output.name)
    if count != 1:
        raise ValueError(f"{output}: write #### where the number of the frame goes")
    return output.with_name(name)


def picture_file(image: Any, suffix: str, look: dict[str, Any]) -> bytes:
    """The bytes of the file of a picture."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"picture{suffix}"
        image.save(path, **look)
        return path.read_bytes()


def _render_frame(
    data: bytes,
    packed: Packed,
    device: str,
    camera: Camera,
    place: Any,
    frame: dict[str, Any],
    look: dict[str, Any],
    suffix: str,
) -> tuple[str, bytes]:
    """The worker, and the file of a frame."""
    kind = "still" if place is None else "placeable"
    with renderer_of(data, packed, device, kind, placeable=place is not None) as renderer:
        if place is not None:
            renderer.place(place)
        image = renderer.render(camera, **frame)
    return address_of_worker(), picture_file(image, suffix, look)
