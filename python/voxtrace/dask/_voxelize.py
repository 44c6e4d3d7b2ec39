"""Scans and meshes of many files by many machines: each worker voxelizes some of them, and the scene is that of one process, byte for byte."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from .._voxtrace import TiledCloud, TiledMesh, VoxtraceError, join_mesh_surveys, join_surveys
from ._sharing import address_of_worker, check_counts, depth_of, made_by_one, made_by_workers, memory_of_part, own_threads, removed, usual_parts, write_whole

#: Memory of a worker that points or triangles and their sorting take, in bytes.
MEMORY = 512 << 20

#: Endings of the names of files with points, and of those with meshes.
POINTS = frozenset({".las", ".laz"})
MESHES = frozenset({".glb", ".gltf", ".obj", ".ply", ".stl"})


def voxelize(
    client: Any,
    paths: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    output: str | os.PathLike[str],
    *,
    resolution: int | None = None,
    voxel_size: float | None = None,
    color_by: str = "auto",
    min_points: int = 1,
    classes: str | None = None,
    bounds: tuple[float, ...] | None = None,
    palette: int | None = None,
    surface: str = "conservative",
    dither: bool = False,
    unit: str | None = None,
    trusted: bool = False,
    levels: int | str | None = None,
    parts: int | None = None,
    memory: int = MEMORY,
    folder: str | os.PathLike[str] | None = None,
    retries: int = 5,
    progress: Callable[[float], object] | None = None,
) -> Path:
    """Voxelize the LAS and LAZ files (COPC too) of a scan, or the meshes (glTF, OBJ, PLY, STL) of one that was cut into tiles, by the workers of `client` into the `.vxt`
    file `output`. `paths`: files, or a folder of one of the two kinds, whose files are taken in the order of their names.

    Files of points are read once where their headers are right, and the voxels' size and what colours them are known beforehand; else once more. Each part of the
    meshes' space is a part of the work, for which the files are read that reach into it, after all were looked through once.
    The file is the one that `voxtrace voxelize` makes of the same files with the same options, byte for byte, whatever the workers and whichever of them are lost on the way: one
    that is lost costs the part that it had. Workers read the files themselves, and write what they make into `folder`, by default `output` with `.tiles`: both are
    where all of them and the client see them. The same call goes on after an interruption; what they wrote is removed in the end.

    `resolution`: voxels along the longest side; `voxel_size`: their edge in units of the files; by default the density of the points decides, and a mesh has 512. `palette`: most
    colours. `unit`: of the files' coordinates, such as `"m"` or `"ft"`, in place of what they say. `trusted`: lifts the limits that protect from hostile files. `levels`: levels of
    detail, a number or `"all"`. `parts`: how many parts there are, by default four a worker, no more than files of points. `memory`: bytes that a worker sorts points or triangles in, of all parts that it makes at once;
    it takes about as much again to read files, and as much as the textures of a part's meshes.

    Of points: `color_by`: `"auto"`, `"rgb"`, `"intensity"`, `"classification"` or `"height"`. `min_points`: least points of a voxel. `classes`: `"2,building"`; `bounds`:
    `(x0, y0, x1, y1)` or with z, on the map. Of meshes: `surface`: `"conservative"`, every voxel that it touches, or `"thin"`.

    Returns `output`. Raises `ReadError` with the path of a file that cannot be read, `OSError`, `ValueError` for options that cannot be, `VoxtraceError` for what a limit or a
    damaged part forbids, and what Dask does where no worker is left.
    """
    named = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    files = [os.path.abspath(file) for file in named]
    out = Path(os.path.abspath(output))
    if out.suffix.lower() != ".vxt":
        raise ValueError(f"{out}: a scan becomes a .vxt file")
    depth = depth_of(levels)
    check_counts(parts=parts, memory=memory)
    place = Path(os.path.abspath(folder)) if folder else out.with_name(f"{out.name}.tiles")
    tiles = _tiles(files)
    memory = memory_of_part(client, memory)
    if tiles and all(tile.suffix.lower() in MESHES for tile in tiles):
        of_points = {"color_by": (color_by, "auto"), "min_points": (min_points, 1), "classes": (classes, None), "bounds": (bounds, None)}
        for name, (value, usual) in of_points.items():
            if value != usual:
                raise ValueError(f"{name} is about points, and {tiles[0]} is a mesh")
        about_mesh: dict[str, Any] = {
            "resolution": resolution,
            "voxel_size": voxel_size,
            "surface": surface,
            "palette": palette,
            "dither": dither,
            "unit": unit,
            "memory": memory,
            "trusted": trusted,
        }
        common = ([str(tile) for tile in tiles], about_mesh)
        return _voxelize_meshes(client, common, out, place, parts or usual_parts(client), depth, retries, progress)
    if surface != "conservative":
        raise ValueError(f"surface is about meshes, and {files[0]} is points")
    options: dict[str, Any] = {
        "resolution": resolution,
        "voxel_size": voxel_size,
        "color_by": color_by,
        "min_points": min_points,
        "classes": classes,
        "bounds": bounds,
        "palette": palette,
        "dither": dither,
        "unit": unit,
        "memory": memory,
        "trusted": trusted,
    }
    cloud = TiledCloud(files, **options)
    shares = cloud.shares(min(512, parts or usual_parts(client)))

    def by_workers(work: Callable[..., Any], arguments: list[tuple[Any, ...]], survey: bytes | None, span: tuple[float, float]) -> list[Any]:
        """What `work` makes of each of the arguments on the workers; `span`: the share of all work that it is."""
        tell = progress and (lambda share: progress(span[0] + share * (span[1] - span[0])))
        return made_by_workers(client, work, (files, options), arguments, survey, retries, tell)

    # Files that have changed are other work, even where they look the same.
    stamp = _stamp(tiles)
    temporary: list[Path] = []

    def make_parts(survey: bytes, kinds: list[str], span: tuple[float, float]) -> list[Path]:
        """Has the parts made that are not there; each has a file of each of the kinds, the last of which is written last."""
        key = hashlib.sha256(stamp.encode() + survey).hexdigest()[:16]
        place.mkdir(parents=True, exist_ok=True)
        parts = [place / f"{key}-{first}-{end}.part" for first, end in shares]
        temporary.extend(part.with_suffix(kind) for part in parts for kind in kinds)
        missing = [(*share, str(part)) for share, part in zip(shares, parts, strict=True) if not all(part.with_suffix(kind).exists() for kind in kinds)]
        by_workers(_voxelize, missing, survey, span)
        return parts

    kept = place / f"{stamp}.survey"
    temporary.append(kept)
    survey, made = _kept(cloud, kept), None
    expected = cloud.expected() if survey is None else None
    if expected is not None:
        # Files are read once, if their headers are right.
        made = make_parts(expected, [".part", ".found"], (0.0, 0.9))
        found = join_surveys([part.with_suffix(".found").read_bytes() for part in made])
        survey, is_so = cloud.bear_out(found, expected)
        if not is_so:
            made = None
    elif survey is None:
        survey = join_surveys(by_workers(_survey, shares, None, (0.0, 0.4)))
        if cloud.check(survey):
            survey = join_surveys([survey, *by_workers(_measure, shares, survey, (0.4, 0.5))])
    assert survey is not None
    if made is None:
        place.mkdir(parents=True, exist_ok=True)
        write_whole(kept, survey)
        made = make_parts(survey, [".part"], (0.5, 0.95))
    made_by_one(client, _merge, (files, options), survey, ([str(part) for part in made], str(out), depth), retries)
    if progress:
        progress(1.0)
    removed(place, temporary)
    return out


def _voxelize_meshes(
    client: Any,
    common: tuple[list[str], dict[str, Any]],
    out: Path,
    place: Path,
    parts: int,
    levels: int,
    retries: int,
    progress: Callable[[float], object] | None,
) -> Path:
    """As `voxelize`, of meshes."""
    files, options = common
    mesh = TiledMesh(files, **options)

    def by_workers(work: Callable[..., Any], arguments: list[tuple[Any, ...]], survey: bytes | None, span: tuple[float, float]) -> list[Any]:
        tell = progress and (lambda share: progress(span[0] + share * (span[1] - span[0])))
        return made_by_workers(client, work, common, arguments, survey, retries, tell)

    stamp = _stamp([Path(file) for file in files])
    kept = place / f"{stamp}.survey"
    parts = min(512, parts)
    try:
        survey = kept.read_bytes()
        mesh.check(survey)
    except (OSError, VoxtraceError):
        survey = join_mesh_surveys(by_workers(_survey_meshes, mesh.shares(parts), None, (0.0, 0.3)))
    mesh.check(survey)
    place.mkdir(parents=True, exist_ok=True)
    write_whole(kept, survey)
    key = hashlib.sha256(repr((stamp, options, parts)).encode() + survey).hexdigest()[:16]
    made = [place / f"{key}-{part}-{parts}.part" for part in range(parts)]
    missing = [(part, parts, str(path)) for part, path in enumerate(made) if not path.exists()]
    by_workers(_voxelize_mesh, missing, survey, (0.3, 0.95))
    made_by_one(client, _merge_meshes, common, survey, (parts, [str(path) for path in made], str(out), levels), retries)
    if progress:
        progress(1.0)
    removed(place, [kept, *made])
    return out


def _tiles(files: list[str]) -> list[Path]:
    """The files, and those of folders: the meshes of one that has no points."""
    tiles: list[Path] = []
    for file in map(Path, files):
        if not file.is_dir():
            tiles.append(file)
            continue
        inside = sorted(file.iterdir())
        of_kind = [[tile for tile in inside if tile.suffix.lower() in kind] for kind in (POINTS, MESHES)]
        tiles += of_kind[0] or of_kind[1]
    return tiles


def _stamp(tiles: list[Path]) -> str:
    """What changes with the files."""
    states = [(str(tile), tile.stat().st_size, tile.stat().st_mtime_ns) for tile in tiles]
    return hashlib.sha256(repr(states).encode()).hexdigest()[:16]


def _kept(cloud: TiledCloud, path: Path) -> bytes | None:
    """The survey that an earlier call has left, if it is of the same files and options."""
    try:
        survey = path.read_bytes()
        return None if cloud.check(survey) else survey
    except (OSError, VoxtraceError):
        return None


def _answer(kind: Callable[..., Any], work: Callable[[Any], Any], common: tuple[list[str], dict[str, Any]]) -> tuple[str, Any]:
    """The worker, and what `work` makes of the files as a `TiledCloud` or a `TiledMesh`, or the exception that would come again if somebody tried anew."""
    files, options = common
    try:
        return address_of_worker(), work(kind(files, **options))
    except (VoxtraceError, ValueError) as error:
        return address_of_worker(), error


def _survey(common: tuple[list[str], dict[str, Any]], _: None, first: int, end: int) -> tuple[str, Any]:
    return _answer(TiledCloud, lambda cloud: cloud.survey(first, end), common)


def _measure(common: tuple[list[str], dict[str, Any]], survey: bytes, first: int, end: int) -> tuple[str, Any]:
    return _answer(TiledCloud, lambda cloud: cloud.measure(survey, first, end), common)


def _voxelize(common: tuple[list[str], dict[str, Any]], survey: bytes, first: int, end: int, part: str) -> tuple[str, Any]:
    def make(cloud: TiledCloud) -> int:
        points, found = cloud.voxelize(survey, first, end, part)
        if found is not None:
            write_whole(Path(part).with_suffix(".found"), found)
        return points

    return _answer(TiledCloud, make, common)


def _merge(common: tuple[list[str], dict[str, Any]], survey: bytes, threads: dict[str, int], parts: list[str], output: str, levels: int) -> tuple[str, Any]:
    return _answer(TiledCloud, lambda cloud: cloud.merge(survey, parts, output, levels, own_threads(threads)), common)


def _survey_meshes(common: tuple[list[str], dict[str, Any]], _: None, first: int, end: int) -> tuple[str, Any]:
    return _answer(TiledMesh, lambda mesh: mesh.survey(first, end), common)


def _voxelize_mesh(common: tuple[list[str], dict[str, Any]], survey: bytes, part: int, parts: int, path: str) -> tuple[str, Any]:
    return _answer(TiledMesh, lambda mesh: mesh.voxelize(survey, part, parts, path), common)


def _merge_meshes(
    common: tuple[list[str], dict[str, Any]], survey: bytes, threads: dict[str, int], parts: int, made: list[str], output: str, levels: int
) -> tuple[str, Any]:
    return _answer(TiledMesh, lambda mesh: mesh.merge(survey, parts, made, output, levels, own_threads(threads)), common)
