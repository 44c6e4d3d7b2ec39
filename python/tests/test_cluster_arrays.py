"""Arrays by many workers: the scene of one process, whatever happens to the workers, and no worker with more of the array than it needs."""

import os
import pickle
import signal
import threading
import time

import numpy
import pytest

import voxtrace

distributed = pytest.importorskip("dask.distributed")
dask_array = pytest.importorskip("dask.array")
zarr = pytest.importorskip("zarr")


@pytest.fixture
def client():
    with distributed.LocalCluster(n_workers=4, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def lump(shape=(50, 40, 90)) -> numpy.ndarray:
    """A body with a rough surface, in real numbers up to about 1,000."""
    axes = numpy.meshgrid(*[numpy.linspace(-1, 1, count) for count in shape], indexing="ij")
    noise = numpy.random.default_rng(4).random(shape)
    return ((1.2 - numpy.sqrt(axes[0] ** 2 + 1.4 * axes[1] ** 2 + 0.8 * axes[2] ** 2)) * 800 + 60 * noise).astype(numpy.float32)


def same(path, volume, **options) -> bool:
    """Whether the file is that of the volume in memory."""
    return voxtrace.open(path).to_bytes() == volume.voxelize(**options).to_bytes()


def test_an_array_becomes_the_scene_of_one_process(client, tmp_path):
    from voxtrace import dask

    real = lump()
    whole = real.round()
    ct = (whole - 300).astype(numpy.int16)
    labels = (whole / 200).clip(0, 5).astype(numpy.uint8)
    store = zarr.create_array(tmp_path / "ct.zarr", data=ct, chunks=(16, 16, 16))
    affine = [[0, 0, 0.5, 3], [-0.7, 0, 0, -9], [0, 0.6, 0, 1], [0, 0, 0, 1]]
    cases = [
        (dask_array.from_array(real, chunks=(20, 40, 13)), real, {"spacing": (0.5, 0.6, 0.7)}, {}),
        (dask_array.from_array(real.T, chunks=11).T, real, {"affine": affine, "unit": "mm"}, {"threshold": 500}),
        (store, ct, {"unit": "mm"}, {"transfer": "ct-bone"}),
        (store, ct, {}, {"resolution": 33, "shell": False}),
        (labels, labels, {"labels": True}, {"transfer": voxtrace.TransferFunction.labels({2: "#ff0000", 3: "#00ff00"})}),
        (labels, labels, {"labels": True}, {}),
        (whole.clip(0).astype(">u2"), whole.clip(0), {}, {"voxel_size": 1.7}),
        (real > 300, real > 300, {}, {"transfer": voxtrace.TransferFunction([(1, "#c9a67c")])}),
    ]
    shares: list[float] = []
    for number, (array, values, place, look) in enumerate(cases):
        out = dask.voxelize_array(client, array, tmp_path / f"{number}.vxt", name="a", parts=5, memory=1 << 20, progress=shares.append, **place, **look)
        volume = voxtrace.Volume.from_array(values, name="a", **place)
        assert same(out, volume, **look), number
        assert max(shares) == 1 and not list(tmp_path.glob("*.parts"))
    # Another value somewhere is another scene.
    changed = ct.copy()
    changed[25, 20, 45:60] = -900
    changed[25, 0:20, 45] = -900
    assert not same(tmp_path / "2.vxt", voxtrace.Volume.from_array(changed, name="a", unit="mm"), transfer="ct-bone", shell=False)
    out = dask.voxelize_array(client, store, tmp_path / "levels.vxt", threshold=200, levels="all")
    assert out.stat().st_size > dask.voxelize_array(client, store, tmp_path / "plain.vxt", threshold=200).stat().st_size


def test_workers_that_are_lost_cost_their_parts_and_work_goes_on_where_it_was(client, tmp_path, monkeypatch):
    from voxtrace import dask

    real = lump((120, 100, 160))
    array = dask_array.from_array(real, chunks=(120, 100, 16))
    volume = voxtrace.Volume.from_array(real, name="a")
    lost = next(iter(client.run(os.getpid).values()))

    def strike() -> None:
        time.sleep(0.3)
        os.kill(lost, signal.SIGKILL)

    thread = threading.Thread(target=strike)
    thread.start()
    out = dask.voxelize_array(client, array, tmp_path / "a.vxt", name="a", parts=10)
    thread.join()
    assert same(out, volume)
    kept = tmp_path / "kept"
    with monkeypatch.context() as context:
        context.setattr("voxtrace.dask._volume.removed", lambda *_: None)
        dask.voxelize_array(client, array, tmp_path / "b.vxt", name="a", parts=4, folder=kept)
    parts = sorted(kept.glob("*.part"))
    # Long ago: the clock of files may stand for a while.
    for part in parts:
        os.utime(part, (1e9, 1e9))
    times = [part.stat().st_mtime_ns for part in parts]
    assert len(parts) == 4
    good = parts[2].read_bytes()
    parts[2].write_bytes(good[:-80] + bytes(80))
    with pytest.raises(voxtrace.VoxtraceError, match=parts[2].name):
        dask.voxelize_array(client, array, tmp_path / "c.vxt", name="a", parts=4, folder=kept)
    assert not (tmp_path / "c.vxt").exists()
    parts[2].unlink()
    with monkeypatch.context() as context:
        context.setattr("voxtrace.dask._volume.removed", lambda *_: None)
        dask.voxelize_array(client, array, tmp_path / "c.vxt", name="a", parts=4, folder=kept)
    again = [part.stat().st_mtime_ns for part in parts]
    assert [again[number] == times[number] for number in range(4)] == [True, True, False, True]
    assert dask.voxelize_array(client, array, tmp_path / "d.vxt", name="a", parts=4, folder=kept).read_bytes() == out.read_bytes()
    assert not kept.exists()


class Sparse:
    """An array that nobody has: samples are made when they are asked for, never more than a budget at a time."""

    shape = (600, 700, 900)
    dtype = numpy.dtype(numpy.uint8)
    chunks = (600, 700, 8)

    def __getitem__(self, index):
        x, y, z = [numpy.arange(count)[part] for count, part in zip(self.shape, index, strict=True)]
        assert len(x) * len(y) * len(z) <= 8 << 20, "more than a slab of the budget"
        far = ((x[:, None, None] - 300) ** 2 + (y[None, :, None] - 350) ** 2 + (z[None, None, :] - 450) ** 2) ** 0.5
        return (255 - far).clip(0, 255).astype(numpy.uint8)


def test_no_worker_has_more_of_the_array_than_its_budget(client, tmp_path):
    from voxtrace import dask

    out = dask.voxelize_array(client, Sparse(), tmp_path / "ball.vxt", threshold=100, transfer="fog", memory=48 << 20)
    scene = voxtrace.open(out)
    # The shell of a ball.
    assert 9 * 155**2 < scene.voxels < 12 * 155**2


def test_what_cannot_be_is_told(client, tmp_path):
    from voxtrace import dask

    real = lump((16, 16, 16))
    for wrong, options, match in [
        (real, {"output": tmp_path / "a.vox"}, ".vxt"),
        (real[0], {}, "shape"),
        (real, {"spacing": 1, "affine": numpy.eye(4)}, "not both"),
        (real, {"transfer": "mood"}, "mood"),
    ]:
        with pytest.raises(ValueError, match=match):
            dask.voxelize_array(client, wrong, **{"output": tmp_path / "a.vxt", **options})
    with pytest.raises(voxtrace.VoxtraceError, match="no sample is to be seen"):
        dask.voxelize_array(client, real, tmp_path / "a.vxt", threshold=9e6, transfer="ct-bone")

    class Broken(Sparse):
        def __getitem__(self, index):
            raise OSError("the disk is gone")

    with pytest.raises(OSError, match="the disk is gone"):
        dask.voxelize_array(client, Broken(), tmp_path / "a.vxt", transfer="ct-bone", retries=0)
    assert not list(tmp_path.glob("a.vxt"))


def test_other_colours_are_other_work():
    from voxtrace.dask import _volume

    def stamp(transfer) -> str:
        return _volume._stamp(lump((8, 8, 8)), {"transfer": transfer, "memory": 1})

    red, green = (voxtrace.TransferFunction([(1, color)]) for color in ["#ff0000", "#00ff00"])
    assert repr(red) == repr(green) and stamp(red) != stamp(green)
    assert stamp(red) == stamp(pickle.loads(pickle.dumps(red))) and stamp("mri") != stamp("hot") != stamp(None)


def test_masked_samples_are_none():
    from voxtrace.dask import _volume

    masked = numpy.ma.masked_greater(lump((8, 9, 10)), 500)
    part = dask_array.from_array(masked, chunks=5)
    found = _volume._read(part, "f32", False, 2, 7, 1, 4)
    expected = masked[:, 1:4, 2:7].filled(numpy.nan).transpose(2, 1, 0)
    assert numpy.array_equal(found, expected, equal_nan=True) and numpy.isnan(found).any()
    bytes_of = numpy.ma.masked_greater((masked.data / 10).clip(0, 200).astype("uint8"), 50)
    assert (_volume._read(bytes_of, "u8", True, 0, 10, 0, 9) == bytes_of.filled(0).transpose(2, 1, 0)).all()
    with pytest.raises(ValueError, match="float32"):
        _volume._read(bytes_of, "u8", False, 0, 10, 0, 9)


def test_transfer_functions_travel():
    for transfer in [
        voxtrace.TransferFunction([(1, "#ff0000"), (3, "#00ff00")], threshold=2, upper=9, opacity=0.5),
        voxtrace.TransferFunction([(0, "#ff0000"), (1, "#00ff00")], relative=True),
        voxtrace.TransferFunction.labels({1: "#123456", 7: "#abcdef"}, opacity=0.25),
        *[voxtrace.TransferFunction.preset(name) for name in ["ct-bone", "mri", "labels", "fog"]],
    ]:
        again = pickle.loads(pickle.dumps(transfer))
        assert repr(again) == repr(transfer)
        values = lump((20, 20, 20)) / 80
        volume = voxtrace.Volume.from_array(values.round(), labels="label" in repr(transfer))
        try:
            expected = volume.voxelize(transfer)
        except voxtrace.VoxtraceError:
            continue
        assert volume.voxelize(again).to_bytes() == expected.to_bytes()


@pytest.mark.parametrize("name", ["parts", "memory", "levels"])
def test_counts_below_0_are_refused_before_any_work(church, tmp_path, name):
    import voxtrace.dask

    for call in [
        lambda: voxtrace.dask.voxelize_array(None, lump((8, 8, 8)), tmp_path / "a.vxt", **{name: -1}),
        lambda: voxtrace.dask.voxelize(None, [tmp_path / "a.las"], tmp_path / "a.vxt", **{name: -1}),
    ]:
        with pytest.raises(ValueError, match=f"{name} is a whole number from 0 on, not -1"):
            call()
    with pytest.raises(ValueError, match="parts is a whole number from 0 on, not -1"):
        voxtrace.dask.render(None, church, parts=-1)
