"""Arrays larger than any machine by many of them: each worker voxelizes some layers, and the scene is that of one process, byte for byte."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy
from distributed.protocol import pickle as _pickle

from .._volumes import place_of, samples_of
from .._voxtrace import TiledVolume, TransferFunction, VoxtraceError
from ._sharing import address_of_worker, check_counts, depth_of, made_by_one, made_by_workers, memory_of_part, own_threads, removed, usual_parts, write_whole

#: It has no types.
pickle: Any = _pickle

#: Memory of a worker that samples and voxels in the making take, in bytes.
MEMORY = 512 << 20
#: Layers along z that are read at a time where the array says nothing of chunks.
USUAL_DEPTH = 16

#: What samples stay: codes of 8 and 16 bits, by the type of the array; all others become float32, as in `Volume.from_array`.
_KINDS = {"bool": "u8", "uint8": "u8", "int8": "i8", "uint16": "u16", "int16": "i16"}


def voxelize_array(
    client: Any,
    array: Any,
    output: str | os.PathLike[str],
    *,
    spacing: float | tuple[float, float, float] | None = None,
    affine: Any = None,
    unit: str | None = None,
    labels: bool = False,
    name: str | None = None,
    transfer: TransferFunction | str | None = None,
    threshold: float | None = None,
    resolution: int | None = None,
    voxel_size: float | None = None,
    shell: bool = True,
    trusted: bool = False,
    levels: int | str | None = None,
    parts: int | None = None,
    memory: int = MEMORY,
    folder: str | os.PathLike[str] | None = None,
    retries: int = 5,
    progress: Callable[[float], object] | None = None,
) -> Path:
    """Voxelize an array of shape `(X, Y, Z)` by the workers of `client` into the `.vxt` file `output`.

    `array`: of dask or zarr, or anything that can be pickled, has `shape` and `dtype`, and gives numpy arrays for slices; a `DataArray` of xarray over one. No process
    holds more of it than `memory` and a chunk: workers read layers along z, whole chunks of them at a time, where all of them see what it is made of. Arrays whose first axis is z
    are turned first: `dask.array.from_zarr(…).T`.

    `spacing`, `affine`, `unit`, `labels`, `name`: as in `Volume.from_array`; `transfer`, `threshold`, `resolution`, `voxel_size`, `shell`: as in `Volume.voxelize`, and the scene is
    that of both. Without a transfer function that knows which values it shows, workers look at all samples first. `trusted`: lifts the limit on voxels. `levels`: levels of detail,
    a number or `"all"`. `parts`: how many parts there are, by default four a worker. `folder`: where workers leave their parts, by default `output` with `.parts`; all of them and the
    client see it. The same call goes on after an interruption; what they wrote is removed in the end.

    Returns `output`. Raises `ValueError` for another shape or options that cannot be, `VoxtraceError` where nothing is seen (no threshold is lowered, as `Volume.voxelize` may) or a limit forbids
    it, what the array raises where it is read, and what Dask does where no worker is left.
    """
    out = Path(os.path.abspath(output))
    if out.suffix.lower() != ".vxt":
        raise ValueError(f"{out}: an array becomes a .vxt file")
    if len(array.shape) != 3 or min(array.shape) < 1:
        raise ValueError(f"an array of shape (X, Y, Z) is wanted, not {tuple(array.shape)}")
    depth = depth_of(levels)
    check_counts(parts=parts, memory=memory)
    known_name = getattr(array, "name", None)
    if spacing is None and affine is None:
        affine, known_unit = place_of(array)
        unit = unit if unit is not None else known_unit
    if hasattr(array, "dims") and hasattr(array, "data"):
        array = array.data
    options: dict[str, Any] = {
        "spacing": spacing,
        "affine": None if affine is None else numpy.asarray(affine, dtype=float).tolist(),
        "unit": unit,
        "labels": labels,
        "name": name or (known_name if isinstance(known_name, str) and known_name else "array"),
        "transfer": transfer,
        "threshold": threshold,
        "resolution": resolution,
        "voxel_size": voxel_size,
        "shell": shell,
        "trusted": trusted,
        "memory": memory_of_part(client, memory),
    }
    stamp = _stamp(array, options)
    volume = _tiled(array, stamp, options)
    place = Path(os.path.abspath(folder)) if folder else out.with_name(f"{out.name}.parts")
    share_count = parts or usual_parts(client)
    # Dask would take an array of its own for work that is to be done first.
    common = pickle.dumps((array, stamp, options))

    def by_workers(work: Callable[..., Any], arguments: list[tuple[Any, ...]], survey: bytes | None, span: tuple[float, float]) -> list[Any]:
        tell = progress and (lambda share: progress(span[0] + share * (span[1] - span[0])))
        return made_by_workers(client, work, common, arguments, survey, retries, tell)

    kept = place / f"{stamp}.survey"
    survey = kept.read_bytes() if kept.exists() else None
    if survey is None:
        looks: list[bytes] = []
        layers = _shares(array.shape[2], share_count)
        if volume.wants_looks():
            looks = by_workers(_look, layers, None, (0.0, 0.3))

        def count(low: float, high: float) -> list[int]:
            counts = by_workers(_count, [(*share, low, high) for share in layers], None, (0.3, 0.4))
            return [int(sum(bins)) for bins in zip(*counts, strict=True)]

        survey = volume.survey(looks, count)
        place.mkdir(parents=True, exist_ok=True)
        write_whole(kept, survey)
    shares = _shares(volume.layers(survey), min(512, share_count))
    made = [place / f"{stamp}-{first}-{end}.part" for first, end in shares]
    missing = [(first, end, str(part)) for (first, end), part in zip(shares, made, strict=True) if not part.exists()]
    by_workers(_voxelize, missing, survey, (0.4, 0.95))
    made_by_one(client, _merge, common, survey, ([str(part) for part in made], str(out), depth), retries)
    if progress:
        progress(1.0)
    removed(place, [kept, *made])
    return out


def _shares(count: int, parts: int) -> list[tuple[int, int]]:
    """Numbers up to `count` in at most so many runs of about the same length."""
    bounds = sorted({count * part // parts for part in range(parts + 1)})
    return list(zip(bounds, bounds[1:], strict=False))


def _stamp(array: Any, options: dict[str, Any]) -> str:
    """What changes with the array and with what is made of it."""
    from dask.base import tokenize

    token: Any = tokenize
    transfer = options["transfer"]
    # With its colours, which its name and range do not tell.
    look = transfer.__reduce__()[1:] if isinstance(transfer, TransferFunction) else transfer
    said = {**options, "transfer": look, "memory": None}
    return hashlib.sha256(repr((token(array), tuple(array.shape), str(array.dtype), said)).encode()).hexdigest()[:16]


def _tiled(array: Any, stamp: str, options: dict[str, Any]) -> TiledVolume:
    kind = _KINDS.get(numpy.dtype(array.dtype).name, "f32")
    return TiledVolume(partial(_read, array, kind, options["labels"]), tuple(array.shape), kind, _depth(array), stamp, **options)


def _depth(array: Any) -> int:
    """Layers of a chunk along z."""
    chunks = getattr(array, "chunks", None)
    if not chunks:
        return USUAL_DEPTH
    along = chunks[2]
    return int(along if isinstance(along, int) else max(along))


def _read(array: Any, kind: str, labels: bool, first: int, end: int, low: int, high: int) -> Any:
    """The samples of some layers of some rows, as the voxelizer has them: C-contiguous, of shape (layers, rows, X)."""
    part = array[:, low:high, first:end]
    if hasattr(part, "compute"):
        # Here, not by other workers: they wait for this one's part.
        part = part.compute(scheduler="threads")
    if kind != "f32" and not labels and numpy.ma.is_masked(part):
        raise ValueError("whole numbers that are masked have no number for what is not there: pass the array as float32")
    values: Any = samples_of(part, labels)
    if kind == "u8":
        values = values.astype(numpy.uint8, copy=False)
    elif kind in {"i8", "i16"}:
        # Codes count from the least number on.
        bits: Any = numpy.uint8 if kind == "i8" else numpy.uint16
        values = values.astype(values.dtype.newbyteorder("="), copy=False).view(bits) ^ bits(1 << (8 * bits().itemsize - 1))
    else:
        values = values.astype(numpy.uint16 if kind == "u16" else numpy.float32, copy=False)
    # What a file that is mapped has behind a header of odd length is not aligned.
    return numpy.require(values.transpose(2, 1, 0), requirements=["C", "A"])


def _answer(work: Callable[[TiledVolume], Any], common: bytes) -> tuple[str, Any]:
    """The worker, and what `work` makes of the array, or the exception that would come again if somebody tried anew."""
    try:
        return address_of_worker(), work(_tiled(*pickle.loads(common)))
    except (VoxtraceError, ValueError) as error:
        return address_of_worker(), error


def _look(common: bytes, _: None, first: int, end: int) -> tuple[str, Any]:
    return _answer(lambda volume: volume.look(first, end), common)


def _count(common: bytes, _: None, first: int, end: int, low: float, high: float) -> tuple[str, Any]:
    return _answer(lambda volume: volume.count(first, end, low, high), common)


def _voxelize(common: bytes, survey: bytes, first: int, end: int, part: str) -> tuple[str, Any]:
    return _answer(lambda volume: volume.voxelize(survey, first, end, part), common)


def _merge(common: bytes, survey: bytes, threads: dict[str, int], parts: list[str], output: str, levels: int) -> tuple[str, Any]:
    return _answer(lambda volume: volume.merge(survey, parts, output, levels, own_threads(threads)), common)
