"""Scans and meshes of many files by many workers: the bytes of one process, whatever happens to the workers."""

import contextlib
import os
import signal
import struct
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import numpy
import pytest

import voxtrace

distributed = pytest.importorskip("dask.distributed")

#: A point of LAS format 2.
RECORD = numpy.dtype(
    [("place", "<i4", 3), ("intensity", "<u2"), ("flags", "u1"), ("class", "u1"), ("rest", "u1", 4), ("color", "<u2", 3)]
)


def las(path: Path, place: numpy.ndarray, color: numpy.ndarray, classes: numpy.ndarray) -> None:
    """A LAS 1.2 file of points in centimetres."""
    records = numpy.zeros(len(place), RECORD)
    records["place"], records["color"], records["class"] = place, color, classes
    records["intensity"] = place.sum(axis=1) % 4000
    head = bytearray(227)
    head[:4] = b"LASF"
    head[24:26] = bytes([1, 2])
    struct.pack_into("<HI", head, 94, 227, 227)
    struct.pack_into("<BHI", head, 104, 2, RECORD.itemsize, len(place))
    struct.pack_into("<6d", head, 131, 0.01, 0.01, 0.01, 690_000, 5_330_000, 400)
    ends = numpy.stack([place.max(axis=0), place.min(axis=0)], axis=1) * 0.01 + [[690_000], [5_330_000], [400]]
    struct.pack_into("<6d", head, 179, *ends.ravel())
    path.write_bytes(bytes(head) + records.tobytes())


@pytest.fixture(scope="module")
def scan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Hills in nine tiles that reach over each other by a metre."""
    folder = tmp_path_factory.mktemp("scan")
    random = numpy.random.default_rng(5)
    for number in range(9):
        corner = numpy.array([number % 3, number // 3]) * 2000
        ground = corner + random.integers(-100, 2100, (30_000, 2))
        height = 300 + 200 * numpy.sin(ground[:, 0] / 700) * numpy.cos(ground[:, 1] / 900)
        place = numpy.column_stack([ground, height.astype(int) + random.integers(0, 30, len(ground))])
        color = (numpy.column_stack([height / 2, height / 3, ground[:, 0] % 200]).astype(int) % 256) * 257
        las(folder / f"tile_{number}.las", place, color, random.integers(1, 7, len(ground)))
    return folder


@pytest.fixture
def client():
    with distributed.LocalCluster(n_workers=4, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


@contextlib.contextmanager
def one_lost(client) -> Iterator[None]:
    """A worker is killed after 0.6 s of what is done meanwhile."""
    lost = next(iter(client.run(os.getpid).values()))

    def strike() -> None:
        time.sleep(0.6)
        os.kill(lost, signal.SIGKILL)

    thread = threading.Thread(target=strike)
    thread.start()
    yield
    thread.join()


def test_a_cluster_voxelizes_a_scan_to_the_bytes_of_one_process(client, scan, tmp_path, run):
    from voxtrace import dask

    shares: list[float] = []
    for number, (words, options) in enumerate(
        [
            (["--voxel-size", 0.25, "--levels", "all"], {"voxel_size": 0.25, "levels": "all"}),
            (["--voxel-size", 0.5, "--unit", "m"], {"voxel_size": 0.5, "unit": "m"}),
            (["--color-by", "height", "--levels", 2], {"color_by": "height", "levels": 2}),
            (
                ["--resolution", 150, "--min-points", 2, "--classes", "2,building", "--palette", 50, "--dither"],
                {"resolution": 150, "min_points": 2, "classes": "2,building", "palette": 50, "dither": True},
            ),
            (
                ["--voxel-size", 0.5, "--bounds", "690003,5330000,690031.5,5330055", "--color-by", "intensity"],
                {"voxel_size": 0.5, "bounds": (690003, 5330000, 690031.5, 5330055), "color_by": "intensity"},
            ),
        ]
    ):
        alone = tmp_path / f"{number}.vxt"
        run("voxelize", scan, "-o", alone, *words)
        made = dask.voxelize(client, scan, tmp_path / f"cluster-{number}.vxt", progress=shares.append, **options)
        assert made.read_bytes() == alone.read_bytes(), options
        assert max(shares) == 1 and not list(tmp_path.glob("*.tiles"))
    # A header that is wrong costs a second reading.
    for tile in scan.iterdir():
        content = bytearray(tile.read_bytes())
        if tile.name == "tile_0.las":
            struct.pack_into("<d", content, 187, 689_000)
        (tmp_path / "wrong").mkdir(exist_ok=True)
        (tmp_path / "wrong" / tile.name).write_bytes(content)
    for options in [{"voxel_size": 0.25}, {"voxel_size": 0.5, "color_by": "classification"}]:
        words = [f"--{name.replace('_', '-')}={value}" for name, value in options.items()]
        run("voxelize", tmp_path / "wrong", "-o", tmp_path / "wrong.vxt", *words)
        made = dask.voxelize(client, tmp_path / "wrong", tmp_path / "made.vxt", parts=4, **options)
        assert made.read_bytes() == (tmp_path / "wrong.vxt").read_bytes() and not list(tmp_path.glob("*.tiles"))
    files = sorted(scan.iterdir())
    made = dask.voxelize(client, files, tmp_path / "files.vxt", voxel_size=0.25, levels="all", parts=2)
    # Named after its first file, where one of a folder has the folder's name.
    run("voxelize", *files, "-o", tmp_path / "alone.vxt", "--voxel-size", 0.25, "--levels", "all")
    assert made.read_bytes() == (tmp_path / "alone.vxt").read_bytes()


def test_a_worker_that_is_lost_costs_its_part_alone_and_work_goes_on_where_it_was(client, scan, tmp_path, monkeypatch):
    from voxtrace import dask

    alone = dask.voxelize(client, scan, tmp_path / "alone.vxt", voxel_size=0.05).read_bytes()
    with one_lost(client):
        made = dask.voxelize(client, scan, tmp_path / "a.vxt", voxel_size=0.05, parts=9)
    assert made.read_bytes() == alone

    # What is there is not made again: a part that is damaged is told, and once it is gone the others do.
    kept = tmp_path / "kept"
    with monkeypatch.context() as context:
        context.setattr("voxtrace.dask._voxelize.removed", lambda *_: None)
        dask.voxelize(client, scan, tmp_path / "b.vxt", voxel_size=0.05, parts=3, folder=kept)
    parts = sorted(kept.glob("*.part"))
    times = [part.stat().st_mtime_ns for part in parts]
    assert len(parts) == 3
    good = parts[0].read_bytes()
    parts[0].write_bytes(good[:-100] + bytes(100))
    with pytest.raises(voxtrace.VoxtraceError, match=parts[0].name):
        dask.voxelize(client, scan, tmp_path / "c.vxt", voxel_size=0.05, parts=3, folder=kept)
    assert not (tmp_path / "c.vxt").exists()
    assert [part.stat().st_mtime_ns for part in parts[1:]] == times[1:]
    parts[0].unlink()
    made = dask.voxelize(client, scan, tmp_path / "c.vxt", voxel_size=0.05, parts=3, folder=kept)
    assert made.read_bytes() == alone and not kept.exists()
    # Nobody else's files are removed.
    kept.mkdir()
    (kept / "mine").write_text("mine")
    dask.voxelize(client, scan, tmp_path / "d.vxt", voxel_size=0.5, folder=kept)
    assert [file.name for file in kept.iterdir()] == ["mine"]


def test_a_tile_that_cannot_be_read_is_named(client, scan, tmp_path):
    from voxtrace import dask

    for tile in scan.iterdir():
        (tmp_path / tile.name).write_bytes(tile.read_bytes())
    damaged = tmp_path / "tile_4.las"
    damaged.write_bytes(damaged.read_bytes()[:-5000])
    with pytest.raises(voxtrace.ReadError, match="tile_4.las") as caught:
        dask.voxelize(client, tmp_path, tmp_path / "a.vxt", voxel_size=0.5)
    assert caught.value.path == str(damaged)
    with pytest.raises(ValueError, match=".vxt"):
        dask.voxelize(client, scan, tmp_path / "a.vox")
    with pytest.raises(ValueError, match="unit is one of"):
        dask.voxelize(client, scan, tmp_path / "a.vxt", unit="elbow")
    with pytest.raises(ValueError, match="color_by"):
        dask.voxelize(client, scan, tmp_path / "a.vxt", color_by="mood")
    text = tmp_path / "points.xyz"
    text.write_text("1 2 3\n4 5 6\n")
    with pytest.raises(voxtrace.ReadError, match="LAS and LAZ"):
        dask.voxelize(client, text, tmp_path / "a.vxt")
    assert not list(tmp_path.glob("*.vxt*"))


@pytest.fixture(scope="module")
def ground(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Hills as nine meshes with colours, each of which ends where the next ones begin."""
    folder = tmp_path_factory.mktemp("ground")
    for number in range(9):
        side = numpy.arange(81)
        x, y = numpy.meshgrid(number % 3 * 80 + side, number // 3 * 80 + side, indexing="ij")
        z = 9 * numpy.sin(x / 17) * numpy.cos(y / 23)
        vertices = numpy.zeros(81 * 81, [("place", "<f4", 3), ("color", "u1", 3)])
        vertices["place"] = numpy.stack([x, y, z], axis=-1).reshape(-1, 3)
        vertices["color"] = numpy.stack([x % 256, y % 256, numpy.full_like(x, number * 25)], axis=-1).reshape(-1, 3)
        first = (numpy.arange(80)[:, None] * 81 + numpy.arange(80)).ravel()
        faces = numpy.zeros(2 * len(first), [("count", "u1"), ("corners", "<i4", 3)])
        faces["count"] = 3
        faces["corners"][::2] = numpy.stack([first, first + 81, first + 1], axis=1)
        faces["corners"][1::2] = numpy.stack([first + 1, first + 81, first + 82], axis=1)
        head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(vertices)}"]
        head += [f"property float {axis}" for axis in "xyz"] + [f"property uchar {name}" for name in ("red", "green", "blue")]
        head += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", ""]
        (folder / f"tile_{number}.ply").write_bytes("\n".join(head).encode() + vertices.tobytes() + faces.tobytes())
    return folder


def test_a_cluster_voxelizes_meshes_to_the_bytes_of_one_process(client, ground, scan, tmp_path, run, monkeypatch):
    from voxtrace import dask

    shares: list[float] = []
    files = sorted(ground.iterdir())
    for number, (words, options) in enumerate(
        [
            (["--voxel-size", 0.5, "--levels", "all"], {"voxel_size": 0.5, "levels": "all"}),
            (["--resolution", 700, "--surface", "thin", "--palette", 100, "--unit", "ft"], {"resolution": 700, "surface": "thin", "palette": 100, "unit": "ft"}),
        ]
    ):
        alone = tmp_path / f"{number}.vxt"
        run("voxelize", *files, "-o", alone, *words)
        made = dask.voxelize(client, ground, tmp_path / f"cluster-{number}.vxt", progress=shares.append, **options)
        assert made.read_bytes() == alone.read_bytes(), options
        assert max(shares) == 1 and not list(tmp_path.glob("*.tiles"))
    # Parts that are there are not made again, and a survey neither.
    kept = tmp_path / "kept"
    with monkeypatch.context() as context:
        context.setattr("voxtrace.dask._voxelize.removed", lambda *_: None)
        dask.voxelize(client, files, tmp_path / "a.vxt", voxel_size=0.5, parts=5, folder=kept)
    parts = sorted(kept.iterdir())
    assert [part.suffix for part in parts].count(".part") == 5 and [part.suffix for part in parts].count(".survey") == 1
    times = [part.stat().st_mtime_ns for part in parts]
    lost = next(part for part in parts if part.suffix == ".part")
    lost.unlink()
    with monkeypatch.context() as context:
        context.setattr("voxtrace.dask._voxelize.removed", lambda *_: None)
        made = dask.voxelize(client, files, tmp_path / "b.vxt", voxel_size=0.5, parts=5, folder=kept)
    assert made.read_bytes() == (tmp_path / "a.vxt").read_bytes()
    assert [part.stat().st_mtime_ns for part in parts if part not in (lost,) and part.suffix == ".part"] == [
        time for part, time in zip(parts, times, strict=True) if part not in (lost,) and part.suffix == ".part"
    ]
    with pytest.raises(ValueError, match="color_by is about points"):
        dask.voxelize(client, ground, tmp_path / "c.vxt", color_by="height")
    with pytest.raises(ValueError, match="surface is about meshes"):
        dask.voxelize(client, scan, tmp_path / "c.vxt", surface="thin")
    with pytest.raises(ValueError, match="thin"):
        dask.voxelize(client, ground, tmp_path / "c.vxt", surface="thick")
    broken = tmp_path / "broken"
    broken.mkdir()
    for file in files:
        content = file.read_bytes()
        (broken / file.name).write_bytes(content[:-40] if file.name == "tile_4.ply" else content)
    with pytest.raises(voxtrace.VoxtraceError, match="tile_4.ply"):
        dask.voxelize(client, broken, tmp_path / "c.vxt", voxel_size=0.5)
    assert not (tmp_path / "c.vxt").exists()


def test_a_worker_that_is_lost_while_it_voxelizes_meshes_costs_its_part_alone(client, ground, tmp_path):
    from voxtrace import dask

    alone = dask.voxelize(client, ground, tmp_path / "alone.vxt", voxel_size=0.12).read_bytes()
    with one_lost(client):
        made = dask.voxelize(client, ground, tmp_path / "a.vxt", voxel_size=0.12, parts=9)
    assert made.read_bytes() == alone
