"""Pictures by many machines: parts of the samples go to the workers of a Dask cluster, and their films add up to the bytes that one run gives."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from typing import Any

from .._voxtrace import Camera, Image, Renderer, Scene
from ._sharing import Packed, address_of_worker, check_counts, elsewhere, gathered, packed_scene, number_of_workers, renderer_of, sent_bytes, usual_parts


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
    check_counts(parts=parts)
    count = min(samples, parts or usual_parts(client))
    # The filter compares what there is after half of the samples.
    bounds = sorted({samples * part // count for part in range(count + 1)} | ({samples // 2} if denoise else set()))
    # The camera is chosen once, for all.
    where = camera if isinstance(camera, Camera) else _camera_of(scene, camera, size)
    half = bounds.index(samples // 2) if denoise else None
    films = _shared(client, packed_scene(scene), device, where, {"size": size, **options}, bounds, half, retries, progress)
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
    check_counts(parts=parts, first_sample=first_sample)
    count = min(samples, parts or usual_parts(client))
    bounds = [first_sample + samples * part // count for part in range(count + 1)]
    films = _shared(client, packed_scene(scene), device, film.to_bytes(), {"region": region}, bounds, None, retries, progress)
    return Image.merge(films)


def _shared(
    client: Any,
    scene: tuple[bytes, Packed],
    device: str,
    what: Camera | bytes,
    frame: dict[str, Any],
    bounds: list[int],
    half: int | None,
    retries: int,
    progress: Callable[[float], object] | None,
) -> list[Image]:
    """The film of the samples between bounds, of a camera or like a film; two of them, which join at the bound of that number, where there is one."""
    data, packed = scene
    units = branches(len(bounds) - 1, half)

    def submit(missing: list[int], workers: list[str]) -> dict[Any, int]:
        # The scene goes along anew, as whoever had it may be gone or stand still; workers that know it do not unpack it again.
        sent = sent_bytes(client, data, retries, workers)

        def begin(parts: range) -> Any:
            if len(parts) > 1:
                limbs = [begin(limb) for limb in split(parts)]
                return client.submit(_add, limbs, pure=False, retries=retries, **elsewhere(workers))
            first, end = bounds[parts.start], bounds[parts.stop]
            arguments = sent, packed, device, what, first, end - first, frame
            return client.submit(_render_part, *arguments, pure=False, retries=retries, **elsewhere(workers))

        return {begin(units[unit]): unit for unit in missing}

    # By the numbers of units: the two on both sides of the half are not added up.
    runs = Runs(next((number for number, parts in enumerate(units) if parts.start == half), None))
    largest = max(len(parts) for parts in units)
    rounds = 1 + largest // number_of_workers(client)
    gathered(client, submit, list(range(len(units))), lambda unit, film: runs.add(unit, Image.from_bytes(film)), progress, rounds=rounds)
    return runs.films()


#: Films that a worker adds up at a time, and that the client gets at least where workers add them up.
FAN_IN = 8


def branches(count: int, half: int | None) -> list[range]:
    """Parts whose films workers add up before the client gets them, none of them on both sides of the part `half`: each alone where they are few, else so many together, a power
    of `FAN_IN`, that the client gets about as many films however many workers there are."""
    together = 1
    while count > 2 * FAN_IN * together:
        together *= FAN_IN
    sides = [range(count)] if half is None else [range(half), range(half, count)]
    return [side[start : start + together] for side in sides for start in range(0, len(side), together)]


def split(parts: range) -> list[range]:
    """The limbs of a branch: at most `FAN_IN`, of powers of it."""
    limb = 1
    while limb * FAN_IN < len(parts):
        limb *= FAN_IN
    return [parts[start : start + limb] for start in range(0, len(parts), limb)]


class Runs:
    """Films of parts, which come in any order and are added up with those beside them at once: few are kept at a time, however many come. Those on both
    sides of the bound `half` stay apart."""

    def __init__(self, half: int | None):
        self._half = half
        #: By the number of its first part: that after its last one, and the film.
        self._runs: dict[int, tuple[int, Image]] = {}

    def add(self, part: int, film: Image) -> None:
        first, end = part, part + 1
        before = next((start for start, (stop, _) in self._runs.items() if stop == first), None)
        if before is not None and first != self._half:
            film = Image.merge([self._runs.pop(before)[1], film])
            first = before
        if end in self._runs and end != self._half:
            after = self._runs.pop(end)
            film, end = Image.merge([film, after[1]]), after[0]
        self._runs[first] = (end, film)

    def __len__(self) -> int:
        return len(self._runs)

    def films(self) -> list[Image]:
        return [self._runs[first][1] for first in sorted(self._runs)]


def _camera_of(scene: Scene, camera: str | None, size: tuple[int, int]) -> Camera:
    if camera is None:
        return Renderer(scene, device="cpu").default_camera(size)
    for known in scene.cameras:
        if known.name == camera:
            return known
    names = ", ".join(known.name for known in scene.cameras)
    raise ValueError(f"the scene has no camera {camera!r}; there are: {names}")


def _render_part(
    data: bytes, packed: Packed, device: str, what: Camera | bytes, first_sample: int, samples: int, frame: dict[str, Any]
) -> tuple[str, bytes]:
    """The worker, and the film of a range of samples."""
    film = Image.from_bytes(what) if isinstance(what, bytes) else None
    light = hashlib.sha256(what).hexdigest() if isinstance(what, bytes) else ""
    with renderer_of(data, packed, device, light, film=film) as renderer:
        if isinstance(what, Camera):
            image = renderer.render(what, samples=samples, first_sample=first_sample, denoise=False, **frame)
        else:
            assert film is not None
            image = renderer.render_like(film, samples=samples, first_sample=first_sample, **frame)
    return address_of_worker(), image.to_bytes()


def _add(films: list[tuple[str, bytes]]) -> tuple[str, bytes]:
    """The worker, and the film of ranges of samples that join, in order."""
    runs = Runs(None)
    for part, (_, film) in enumerate(films):
        runs.add(part, Image.from_bytes(film))
    (image,) = runs.films()
    return address_of_worker(), image.to_bytes()
