"""Pictures by many machines: parts of the samples go to the workers of a Dask cluster, and their films add up to the bytes that one run gives.

>>> from dask.distributed import Client            # doctest: +SKIP
>>> client = Client("tcp://scheduler:8786")        # doctest: +SKIP
>>> voxtrace.dask.render(client, scene, samples=4096).save("church.png")  # doctest: +SKIP
"""

from __future__ import annotations

import hashlib
import os
import statistics
import tempfile
import time
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import Any

from . import _voxtrace
from ._voxtrace import Camera, Image, Renderer, Scene

#: A part that takes so many times as long as others is given to another worker as well.
PATIENCE = 3.0
#: The same, in seconds, before the first part is there.
FIRST_PATIENCE = 30.0
#: Parts for each worker, so that quick ones take more of them.
PARTS_A_WORKER = 4

#: Renderers of a worker's process, by the scene and the device: scenes are sent, unpacked and put on the device once.
_renderers: dict[tuple[str, str], Renderer] = {}


def render(
    client: Any,
    scene: Scene,
    camera: Camera | str | None = None,
    *,
    samples: int = 64,
    size: tuple[int, int] = (1280, 720),
    device: str = "auto",
    denoise: bool = True,
    parts: int | None = None,
    retries: int = 5,
    progress: Callable[[float], object] | None = None,
    **options: Any,
) -> Image:
    """Render a picture of a scene by the workers of `client`, a `dask.distributed.Client`.

    Everything but these is as in `voxtrace.render`, and so is the picture, byte for byte: whatever the number of workers and parts, and
    whichever of them are lost, or slow, on the way. `parts`: how many ranges of samples there are, by default four a worker. `retries`:
    how often a part is tried anew when a worker fails. Workers need this package; the scene is sent to each of them once.

    Raises what `voxtrace.render` raises, and what Dask does where no worker is left.
    """
    if samples < 1:
        raise ValueError("a picture has at least one sample")
    count = min(samples, parts or _usual_parts(client))
    # The filter compares what there is after half of the samples.
    bounds = sorted({samples * part // count for part in range(count + 1)} | ({samples // 2} if denoise else set()))
    # The camera is chosen once, for all.
    where = camera if isinstance(camera, Camera) else _camera_of(scene, camera, size)
    films = _shared(client, _packed(scene), device, where, {"size": size, **options}, bounds, retries, progress)
    image = Image.merge(films, halfway=denoise)
    return image.denoise(scene) if denoise else image


def render_like(
    client: Any,
    scene: Scene,
    film: Image,
    *,
    samples: int,
    first_sample: int = 0,
    region: tuple[int, int, int, int] | None = None,
    device: str = "auto",
    parts: int | None = None,
    retries: int = 5,
    progress: Callable[[float], object] | None = None,
) -> Image:
    """Samples of the picture that a film shows, as `Renderer.render_like` makes them, by the workers of `client`: see `render`."""
    if samples < 1:
        raise ValueError("a picture has at least one sample")
    count = min(samples, parts or _usual_parts(client))
    bounds = [first_sample + samples * part // count for part in range(count + 1)]
    films = _shared(client, _packed(scene), device, film.to_bytes(), {"region": region}, bounds, retries, progress)
    return Image.merge(films)


def _usual_parts(client: Any) -> int:
    return PARTS_A_WORKER * max(1, len(client.scheduler_info(n_workers=-1)["workers"]))


def _shared(
    client: Any,
    packed: tuple[bytes, str],
    device: str,
    what: Camera | bytes,
    frame: dict[str, Any],
    bounds: list[int],
    retries: int,
    progress: Callable[[float], object] | None,
) -> list[Image]:
    """The films of the ranges of samples between bounds, of a camera or like a film."""
    data, key = packed

    # Preferred, not demanded: the others may be all that is left.
    def elsewhere(workers: list[str]) -> dict[str, Any]:
        return {"workers": workers, "allow_other_workers": True} if workers else {}

    def submit(missing: list[int], workers: list[str]) -> dict[Any, int]:
        # The scene goes along anew, as whoever had it may be gone or stand still; workers that know it do not unpack it again.
        sent = client.submit(bytes, data, pure=False, retries=retries, **elsewhere(workers))
        begun: dict[Any, int] = {}
        for part in missing:
            first, end = bounds[part], bounds[part + 1]
            arguments = sent, key, device, what, first, end - first, frame
            begun[client.submit(_render_part, *arguments, pure=False, retries=retries, **elsewhere(workers))] = part
        return begun

    films = _gathered(client, submit, len(bounds) - 1, progress)
    return [Image.from_bytes(film) for film in films]


def _gathered(
    client: Any, submit: Callable[..., Any], count: int, progress: Callable[[float], object] | None
) -> list[bytes]:
    """The films of all parts. Those that keep everybody waiting are begun a second time elsewhere, and whichever is there first counts."""
    from dask import distributed

    # It has no types.
    wait: Any = distributed.wait
    waiting: dict[Any, int] = submit(list(range(count)), [])
    films: dict[int, bytes] = {}
    alive: set[str] = set()
    took: deque[float] = deque(maxlen=64)
    last = time.monotonic()
    while len(films) < count:
        try:
            done = wait(list(waiting), timeout=1.0, return_when="FIRST_COMPLETED").done
        except TimeoutError:
            done = set()
        for future in done:
            part = waiting.pop(future)
            if part not in films:
                worker, films[part] = future.result()
                alive.add(worker)
                now = time.monotonic()
                took.append(now - last)
                last = now
        if progress:
            progress(len(films) / count)
        rest = [part for part in range(count) if part not in films]
        patience = max(2.0, PATIENCE * statistics.median(took)) if took else FIRST_PATIENCE
        is_late = time.monotonic() - last > patience
        # Once for each silence: nobody is asked for the same again and again.
        if rest and is_late:
            waiting |= submit(rest, sorted(alive))
            alive.clear()
            last = time.monotonic()
    client.cancel(list(waiting), force=True)
    return [films[part] for part in range(count)]


def _packed(scene: Scene) -> tuple[bytes, str]:
    """The scene as the bytes of a file, and their hash."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.vxt"
        scene.save(path)
        data = path.read_bytes()
    return data, hashlib.sha256(data).hexdigest()


def _camera_of(scene: Scene, camera: str | None, size: tuple[int, int]) -> Camera:
    if camera is None:
        return Renderer(scene, device="cpu").default_camera(size)
    for known in scene.cameras:
        if known.name == camera:
            return known
    names = ", ".join(known.name for known in scene.cameras)
    raise ValueError(f"the scene has no camera {camera!r}; there are: {names}")


def _render_part(
    data: bytes, key: str, device: str, what: Camera | bytes, first_sample: int, samples: int, frame: dict[str, Any]
) -> tuple[str, bytes]:
    """The worker, and the film of a range of samples."""
    from dask import distributed

    worker: Any = distributed.get_worker()  # type: ignore[no-untyped-call, unused-ignore]
    film = Image.from_bytes(what) if isinstance(what, bytes) else None
    light = hashlib.sha256(what).hexdigest() if isinstance(what, bytes) else ""
    renderer = _renderers.get((key + light, device))
    if renderer is None:
        # One scene at a time lies on a device.
        _renderers.clear()
        renderer = Renderer(_unpacked(data, key), device=device, film=film)
        _renderers[key + light, device] = renderer
    if isinstance(what, Camera):
        image = renderer.render(what, samples=samples, first_sample=first_sample, denoise=False, **frame)
    else:
        assert film is not None
        image = renderer.render_like(film, samples=samples, first_sample=first_sample, **frame)
    return worker.address, image.to_bytes()


def _unpacked(data: bytes, key: str) -> Scene:
    """The scene of a file's bytes, which stays on the worker's disk for the next process that wants it."""
    folder = Path(tempfile.gettempdir()) / f"voxtrace-{os.getuid() if hasattr(os, 'getuid') else 0}"
    folder.mkdir(mode=0o700, exist_ok=True)
    path = folder / f"{key}.vxt"
    if not path.exists():
        part = path.with_suffix(f".{os.getpid()}")
        part.write_bytes(data)
        part.replace(path)
    return _voxtrace.open(path)
