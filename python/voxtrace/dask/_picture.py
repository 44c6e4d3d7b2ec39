"""Pictures by many machines: parts of the samples go to the workers of a Dask cluster, and their films add up to the bytes that one run gives."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from typing import Any

from .._voxtrace import Camera, Image, Renderer, Scene
from ._sharing import address_of_worker, elsewhere, gathered, packed_scene, renderer_of, sent_bytes, usual_parts


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
    count = min(samples, parts or usual_parts(client))
    # The filter compares what there is after half of the samples.
    bounds = sorted({samples * part // count for part in range(count + 1)} | ({samples // 2} if denoise else set()))
    # The camera is chosen once, for all.
    where = camera if isinstance(camera, Camera) else _camera_of(scene, camera, size)
    films = _shared(client, packed_scene(scene), device, where, {"size": size, **options}, bounds, retries, progress)
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
    count = min(samples, parts or usual_parts(client))
    bounds = [first_sample + samples * part // count for part in range(count + 1)]
    films = _shared(client, packed_scene(scene), device, film.to_bytes(), {"region": region}, bounds, retries, progress)
    return Image.merge(films)


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

    def submit(missing: list[int], workers: list[str]) -> dict[Any, int]:
        # The scene goes along anew, as whoever had it may be gone or stand still; workers that know it do not unpack it again.
        sent = sent_bytes(client, data, retries, workers)
        begun: dict[Any, int] = {}
        for part in missing:
            first, end = bounds[part], bounds[part + 1]
            arguments = sent, key, device, what, first, end - first, frame
            begun[client.submit(_render_part, *arguments, pure=False, retries=retries, **elsewhere(workers))] = part
        return begun

    films: dict[int, bytes] = {}
    gathered(client, submit, list(range(len(bounds) - 1)), films.__setitem__, progress)
    return [Image.from_bytes(films[part]) for part in range(len(bounds) - 1)]


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
    film = Image.from_bytes(what) if isinstance(what, bytes) else None
    light = hashlib.sha256(what).hexdigest() if isinstance(what, bytes) else ""
    renderer = renderer_of(data, key, device, light, film=film)
    if isinstance(what, Camera):
        image = renderer.render(what, samples=samples, first_sample=first_sample, denoise=False, **frame)
    else:
        assert film is not None
        image = renderer.render_like(film, samples=samples, first_sample=first_sample, **frame)
    return address_of_worker(), image.to_bytes()
