"""Pictures by many workers: the same bytes as one process gives, whatever happens to the workers."""

import contextlib
import os
import pickle
import signal
import subprocess
import sys
import tempfile
import threading
import time

import numpy
import pytest

import voxtrace

distributed = pytest.importorskip("dask.distributed")


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(n_workers=4, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            yield client


def processes_of(client) -> dict[str, int]:
    """The process of each worker, by its address, once all four are there and answer: one that was lost before is replaced."""
    limit = time.monotonic() + 300
    while True:
        client.wait_for_workers(4, timeout=300)
        found = client.run(os.getpid, on_error="ignore")
        if len(found) == 4:
            return found
        assert time.monotonic() < limit, found
        time.sleep(0.1)


def test_cameras_and_pictures_travel(church):
    camera = voxtrace.Camera((1, 2, 3), (0.1, 0.2, 0.3), fov=33, name="a", lens="thin-lens", aperture=0.5, focus=3.0)
    assert pickle.loads(pickle.dumps(camera)) == camera
    image = voxtrace.render(church, samples=2, size=(20, 10), device="cpu")
    again = pickle.loads(pickle.dumps(image))
    assert again.to_bytes() == image.to_bytes() and (again.sums == image.sums).all()
    assert (again.denoise(church).radiance == image.denoise(church).radiance).all()
    with pytest.raises(voxtrace.ReadError):
        voxtrace.Image.from_bytes(b"no film")
    other = voxtrace.builtin("city", voxels=20_000)
    with pytest.raises(ValueError, match="another scene"):
        image.denoise(other)


def test_pictures_merge_where_their_samples_join(church):
    renderer = voxtrace.Renderer(church, device="cpu")
    part = lambda first, count: renderer.render(
        samples=count, first_sample=first, size=(20, 10), denoise=False
    )
    whole = part(0, 6).to_bytes()
    assert voxtrace.Image.merge([part(3, 1), part(0, 3), part(4, 2)]).to_bytes() == whole
    for wrong in [[part(0, 3), part(4, 2)], [part(0, 3), part(2, 4)], []]:
        with pytest.raises(ValueError):
            voxtrace.Image.merge(wrong)
    with pytest.raises(ValueError, match="different frames"):
        voxtrace.Image.merge([part(0, 3), renderer.render(samples=1, first_sample=3, size=(20, 10), seed=1)])


@pytest.mark.parametrize("half", [None, 5])
def test_films_that_come_in_any_order_are_added_up_at_once(church, half):
    from voxtrace.dask._picture import Runs

    renderer = voxtrace.Renderer(church, device="cpu")
    films = [renderer.render(samples=1, first_sample=part, size=(20, 10), denoise=False) for part in range(10)]
    whole = voxtrace.Image.merge(films).to_bytes()
    for order in [list(range(10)), list(range(10))[::-1], [4, 2, 0, 1, 3, 9, 7, 8, 6, 5], [1, 3, 5, 7, 9, 0, 2, 4, 6, 8]]:
        runs, most = Runs(half), 0
        for part in order:
            runs.add(part, films[part])
            most = max(most, len(runs))
        kept = runs.films()
        assert len(kept) == (1 if half is None else 2) and voxtrace.Image.merge(kept).to_bytes() == whole
        assert most <= (5 if order[0] == 1 else 3), order
        if half:
            assert kept[0].to_bytes() == voxtrace.Image.merge(films[:half]).to_bytes()


@pytest.mark.parametrize("half", [None, 0, 1, 50, 137])
def test_branches_hold_each_part_once_and_never_both_halves(half):
    from voxtrace.dask import _picture

    for count in [138, 200, 1000, 4001]:
        units = _picture.branches(count, half)
        assert [part for unit in units for part in unit] == list(range(count))
        assert not any(half in unit and unit.start < half for unit in units if half is not None)
        assert len(units) <= 2 * _picture.FAN_IN + 2

        def check(parts):
            if len(parts) == 1:
                return 0
            limbs = _picture.split(parts)
            assert len(limbs) <= _picture.FAN_IN and [part for limb in limbs for part in limb] == list(parts)
            return 1 + max(check(limb) for limb in limbs)

        assert max(check(unit) for unit in units) <= 3
    assert _picture.branches(16, None) == [range(part, part + 1) for part in range(16)]


def test_films_that_workers_add_up_are_those_of_one_process(client, church, monkeypatch):
    from voxtrace import dask
    from voxtrace.dask import _picture

    options = {"samples": 41, "size": (48, 27), "seed": 4, "device": "cpu"}
    for fan_in, parts in [(2, 41), (3, 20)]:
        monkeypatch.setattr(_picture, "FAN_IN", fan_in)
        for denoise in [False, True]:
            shares, here = [], voxtrace.render(church, denoise=denoise, **options)
            image = dask.render(client, church, parts=parts, denoise=denoise, progress=shares.append, **options)
            assert image.to_bytes() == here.to_bytes() and (image.radiance == here.radiance).all()
            assert 0 < len(set(shares)) <= 2 * fan_in + 3 < parts


def test_a_cluster_gives_the_bytes_of_one_process(client, church):
    from voxtrace import dask

    options = {"samples": 13, "size": (48, 27), "seed": 4, "device": "cpu", "denoise": False}
    alone = voxtrace.render(church, **options)
    shares = []
    for parts in [None, 1, 13, 50]:
        image = dask.render(client, church, parts=parts, progress=shares.append, **options)
        assert image.to_bytes() == alone.to_bytes()
    assert max(shares) == 1
    by_name = dask.render(client, church, church.cameras[1].name, **options)
    assert by_name.to_bytes() == voxtrace.render(church, church.cameras[1], **options).to_bytes() != alone.to_bytes()
    denoised = dask.render(client, church, **{**options, "denoise": True})
    here = voxtrace.render(church, **{**options, "denoise": True})
    assert denoised.to_bytes() == here.to_bytes() and (denoised.radiance == here.radiance).all()
    with pytest.raises(ValueError, match="there are"):
        dask.render(client, church, "nobody", **options)


def test_what_of_a_scene_is_shown_goes_along(client, tmp_path):
    from voxtrace import dask

    scene = voxtrace.builtin("church", voxels=20_000)
    low, high = scene.bounds
    options = {"samples": 4, "size": (48, 27), "device": "cpu"}
    whole = voxtrace.render(scene, **options)
    scene.clip = low, [(a + b) / 2 for a, b in zip(low, high)]
    alone = voxtrace.render(scene, **options)
    assert (alone.sums != whole.sums).any()
    image = dask.render(client, scene, **options)
    assert image.to_bytes() == alone.to_bytes() and (image.radiance == alone.radiance).all()
    (frame,) = dask.animate(client, scene, [scene.cameras[0]], tmp_path / "a_#.png", **options)
    voxtrace.render(scene, scene.cameras[0], **options).save(tmp_path / "alone.png")
    assert frame.read_bytes() == (tmp_path / "alone.png").read_bytes()
    scene.clip = None
    assert dask.render(client, scene, **options).to_bytes() == whole.to_bytes()


def test_workers_of_several_threads_make_one_part_after_the_other(church, tmp_path):
    from voxtrace import dask

    options = {"samples": 32, "size": (160, 90), "device": "cpu", "denoise": False}
    alone = voxtrace.render(church, **options)
    with distributed.LocalCluster(n_workers=1, threads_per_worker=4, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            assert dask.render(client, church, parts=16, retries=0, **options).to_bytes() == alone.to_bytes()
            files = dask.animate(client, church, [church.cameras[0]] * 8, tmp_path / "a_#.vxf", retries=0, **options)
    assert voxtrace.Image.from_bytes(files[0].read_bytes()).to_bytes() == voxtrace.render(church, church.cameras[0], **options).to_bytes()


def test_workers_of_another_version_make_nothing(client, church, monkeypatch):
    from voxtrace import dask
    from voxtrace.dask import _sharing

    monkeypatch.setattr(_sharing, "__version__", "0.0.1")
    with pytest.raises(RuntimeError, match="who asks has 0.0.1"):
        dask.render(client, church, samples=1, size=(8, 8), device="cpu", retries=0)


def test_scenes_stay_a_day_on_the_disk_of_a_worker(church, tmp_path, monkeypatch):
    from voxtrace.dask import _sharing

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    data, other = church.to_bytes(), voxtrace.builtin("city", voxels=20_000).to_bytes()
    for key, bytes_of_scene in [("old", data), ("kept", data)]:
        assert _sharing._unpacked(bytes_of_scene, key).voxels == church.voxels
    (folder,) = tmp_path.iterdir()
    yesterday = time.time() - 1.5 * _sharing.KEPT
    for name in ["old.vxt", "kept.vxt"]:
        os.utime(folder / name, (yesterday, yesterday))
    # It is wanted again, and not sent anew.
    assert _sharing._unpacked(b"", "kept").voxels == church.voxels
    _sharing._unpacked(other, "new")
    assert sorted(file.name for file in folder.iterdir()) == ["kept.vxt", "new.vxt"]


def test_a_scene_that_another_process_has_just_removed_is_kept_anew(church, tmp_path, monkeypatch):
    from voxtrace.dask import _sharing

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    data, utime = church.to_bytes(), os.utime
    _sharing._unpacked(data, "raced")

    def loses(path) -> None:
        utime(path)
        os.unlink(path)

    with monkeypatch.context() as context:
        context.setattr(os, "utime", loses)
        assert _sharing._unpacked(data, "raced").voxels == church.voxels
    (folder,) = tmp_path.iterdir()
    assert [file.name for file in folder.iterdir()] == ["raced.vxt"]


def test_scenes_are_kept_in_no_folder_that_others_write_to(church, tmp_path, monkeypatch):
    from voxtrace.dask import _sharing

    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    data, elsewhere = church.to_bytes(), tmp_path / "elsewhere"
    # Windows gives each user a folder for temporary files of its own, and its files have no owner or mode that could be compared.
    has_owners = hasattr(os, "getuid")
    folder = tmp_path / f"voxtrace-{os.getuid() if has_owners else 0}"
    wanted = voxtrace.builtin("city", voxels=20_000)

    def open_to_all() -> None:
        folder.mkdir()
        folder.chmod(0o777)

    def of_another_user() -> None:
        folder.mkdir(mode=0o700)
        os.chown(folder, os.getuid() + 1, -1)

    def link() -> None:
        elsewhere.mkdir(mode=0o700)
        folder.symlink_to(elsewhere)

    # Only the superuser gives folders away.
    of_owners = [open_to_all, link] + [of_another_user] * (has_owners and os.getuid() == 0)
    for make in [folder.touch] + of_owners * has_owners:
        monkeypatch.setattr(_sharing, "_own_folder", None)
        make()
        if folder.is_dir():
            # Somebody else's scene under the name of ours.
            (folder / "named.vxt").write_bytes(data)
        assert _sharing._unpacked(wanted.to_bytes(), "named").voxels == wanted.voxels != church.voxels
        assert not folder.is_dir() or [file.name for file in folder.iterdir()] == ["named.vxt"]
        own = _sharing._folder()
        assert own != folder and (own / "named.vxt").is_file()
        assert not has_owners or own.stat().st_mode & 0o777 == 0o700
        if folder.is_dir() and not folder.is_symlink():
            (folder / "named.vxt").unlink()
            folder.rmdir()
        else:
            folder.unlink()
        _sharing._own_folder.cleanup()
    # One that is ours stays that of all processes.
    folder.mkdir(mode=0o700)
    assert _sharing._folder() == folder


def test_a_file_that_several_write_at_once_is_whole(tmp_path, monkeypatch):
    from voxtrace.dask import _sharing

    path, failures = tmp_path / "a.found", []
    contents = [bytes([writer]) * 300_000 for writer in range(6)]

    def write(content: bytes) -> None:
        try:
            for _ in range(20):
                _sharing.write_whole(path, content)
                assert path.read_bytes() in contents
        except BaseException as error:
            failures.append(error)

    threads = [threading.Thread(target=write, args=[content]) for content in contents]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failures and list(tmp_path.iterdir()) == [path]
    whole = path.read_bytes()
    # What cannot be written leaves what was there, and nothing else.
    with monkeypatch.context() as context:
        context.setattr(type(path), "replace", lambda *_: (_ for _ in ()).throw(OSError("the disk is gone")))
        with pytest.raises(OSError, match="the disk is gone"):
            _sharing.write_whole(path, b"new")
    assert path.read_bytes() == whole and list(tmp_path.iterdir()) == [path]


def test_the_command_line_renders_by_a_cluster(client, tmp_path, command_line, monkeypatch):
    monkeypatch.setenv("VOXTRACE_PYTHON", sys.executable)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(sys.path))
    address = client.scheduler.address

    def run(*words: object) -> subprocess.CompletedProcess[str]:
        words = (command_line, "render", "church", "--voxels", 20_000, "--size", "48x27", "--traversal", "cpu", *words)
        return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300)

    # What only the command line can say goes along: bounces by kind, light, cuts, lines and a crop.
    options = ["--spp", 6, "--seed", 2, "--sun", "40,30,2", "--clip-plane=0,0,1,20", "--edges=0.1", "--crop", "3,40,2,20"]
    options += ["--diffuse-bounces", 3, "--aovs", "--denoise", "-o"]
    for number, more in enumerate([[], ["--cluster", address]]):
        outputs = [tmp_path / f"{number}.vxf", "-o", tmp_path / f"{number}.exr"]
        ended = run(*more, *options, *outputs)
        assert ended.returncode == 0, ended.stderr
    for kind in ["vxf", "exr"]:
        assert (tmp_path / f"0.{kind}").read_bytes() == (tmp_path / f"1.{kind}").read_bytes(), kind
    assert f"tracing on the workers of {address}" in ended.stderr
    # What is missing is said in one line.
    ended = run("--cluster", address, "--spp", 2, "--noise", 0.1, "-o", tmp_path / "a.png")
    assert ended.returncode == 2 and "--noise" in ended.stderr
    monkeypatch.setenv("PYTHONPATH", "")
    monkeypatch.setenv("VOXTRACE_PYTHON", "/usr/bin/python3")
    ended = run("--cluster", address, "--spp", 2, "-o", tmp_path / "a.png")
    assert ended.returncode == 1 and "the extra `cluster`" in ended.stderr.splitlines()[-1], ended.stderr
    monkeypatch.setenv("VOXTRACE_PYTHON", str(tmp_path / "nothing"))
    ended = run("--cluster", address, "--spp", 2, "-o", tmp_path / "a.png")
    assert ended.returncode == 1 and "VOXTRACE_PYTHON" in ended.stderr.splitlines()[-1], ended.stderr
    assert not list(tmp_path.glob("*.png"))


@pytest.mark.parametrize("fan_in", [2, 100])
def test_workers_may_be_lost_and_may_stand_still(client, church, monkeypatch, fan_in):
    from voxtrace import dask
    from voxtrace.dask import _picture

    monkeypatch.setattr(_picture, "FAN_IN", fan_in)
    assert (len(_picture.branches(20, None)) < 20) == (fan_in == 2)
    lost, paused = list(processes_of(client).values())[:2]
    options = {"samples": 160, "size": (160, 90), "device": "cpu", "denoise": False}
    alone = voxtrace.render(church, **options)

    def strike() -> None:
        time.sleep(0.7)
        os.kill(lost, signal.SIGKILL)
        os.kill(paused, signal.SIGSTOP)

    thread = threading.Thread(target=strike)
    thread.start()
    try:
        image = dask.render(client, church, parts=20, **options)
    finally:
        thread.join()
        # It may have been given up for lost, and ended, meanwhile.
        with contextlib.suppress(ProcessLookupError):
            os.kill(paused, signal.SIGCONT)
    assert image.to_bytes() == alone.to_bytes()


def test_a_worker_that_stands_still_with_what_it_made_holds_nobody_up(client):
    from voxtrace.dask import _sharing

    processes = processes_of(client)
    paused = None

    def submit(parts, workers):
        nonlocal paused
        begun = {
            client.submit(lambda part: (_sharing.address_of_worker(), part), part, pure=False, **_sharing.elsewhere(workers)): part
            for part in parts
        }
        if paused is None:
            distributed.wait(list(begun))
            (holder, *_) = client.who_has(list(begun))[next(iter(begun)).key]
            paused = processes[holder]
            os.kill(paused, signal.SIGSTOP)
        return begun

    made = {}
    try:
        _sharing.gathered(client, submit, list(range(8)), made.__setitem__, None)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.kill(paused, signal.SIGCONT)
    assert made == {part: part for part in range(8)}


def test_parts_that_take_long_are_not_begun_again_and_again(client, tmp_path, monkeypatch):
    from voxtrace.dask import _sharing

    monkeypatch.setattr(_sharing, "FIRST_PATIENCE", 0.3)
    begun, enough = [], tmp_path / "enough"

    def slow(part: int, enough: str) -> tuple[str, int]:
        for _ in range(6000):
            if os.path.exists(enough):
                return _sharing.address_of_worker(), part
            time.sleep(0.05)
        raise TimeoutError("it was not begun often enough")

    def submit(parts, workers):
        begun.append(time.monotonic())
        if len(begun) == 4:
            enough.touch()
        return {client.submit(slow, part, str(enough), pure=False): part for part in parts}

    made = {}
    _sharing.gathered(client, submit, [0], made.__setitem__, None, least_patience=0.1)
    assert made == {0: 0} and len(begun) >= 4
    # After 0.3, 0.6, 1.2 s and so on, on a busy machine later.
    pauses = [after - before for before, after in zip(begun, begun[1:])]
    assert all(pause > 0.3 * 2**number for number, pause in enumerate(pauses)), pauses


def test_what_a_part_raises_is_raised(client):
    from voxtrace.dask import _sharing

    def fail(part: int) -> None:
        raise KeyError(f"part {part}")

    def submit(parts, workers):
        return {client.submit(fail, part, pure=False): part for part in parts}

    with pytest.raises(KeyError, match="part"):
        _sharing.gathered(client, submit, [0, 1, 2], lambda *_: None, None)


def test_frames_of_an_animation_are_those_of_one_process(client, tmp_path, church):
    from voxtrace import dask

    first = church.cameras[0]
    cameras = [voxtrace.Camera((x, 40, 20), first.target, fov=50) for x in [10, 14, 18, 22, 26]]
    options = {"samples": 2, "size": (32, 18), "device": "cpu"}
    files = dask.animate(client, church, cameras, tmp_path / "a_###.png", seed=5, **options)
    assert [file.name for file in files] == [f"a_00{number}.png" for number in range(1, 6)]
    renderer = voxtrace.Renderer(church, device="cpu")
    for number, file in enumerate(files):
        image = renderer.render(cameras[number], samples=2, size=(32, 18), seed=5 + number)
        image.save(tmp_path / "alone.png")
        assert file.read_bytes() == (tmp_path / "alone.png").read_bytes()
    assert files[0].read_bytes() != files[1].read_bytes()
    # What is there stays, and what is missing comes back.
    lost = files[2].read_bytes()
    files[2].unlink()
    files[3].write_bytes(b"mine")
    dask.animate(client, church, cameras, tmp_path / "a_###.png", seed=5, **options)
    assert files[2].read_bytes() == lost and files[3].read_bytes() == b"mine"
    dask.animate(client, church, cameras, tmp_path / "a_###.png", seed=5, overwrite=True, **options)
    assert files[3].read_bytes() != b"mine"
    with pytest.raises(ValueError, match="####"):
        dask.animate(client, church, cameras, tmp_path / "a.png", **options)


def test_things_move_in_an_animation(client, tmp_path):
    from voxtrace import dask

    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(numpy.ones((4, 4, 4), bool)))
    camera = voxtrace.Camera((2, -30, 10), (2, 2, 2), fov=30)
    places = numpy.tile(numpy.eye(4), (3, 1, 1, 1))
    places[:, 0, 0, 3] = [0, 2, 4]
    options = {"samples": 2, "size": (24, 24), "device": "cpu"}
    files = dask.animate(client, scene, [camera] * 3, tmp_path / "m_##.vxf", transforms=places, **options)
    renderer = voxtrace.Renderer(scene, device="cpu", placeable=True)
    for number, file in enumerate(files):
        renderer.place(places[number])
        image = renderer.render(camera, samples=2, size=(24, 24), seed=number)
        assert (voxtrace.Image.from_bytes(file.read_bytes()).sums == image.sums).all()
    with pytest.raises(ValueError, match="2 cameras"):
        dask.animate(client, scene, [camera] * 2, tmp_path / "n_##.vxf", transforms=places, **options)


def test_thumbnails_of_many_files_and_one_that_is_none(client, tmp_path, church):
    from voxtrace import dask

    (tmp_path / "in" / "deep").mkdir(parents=True)
    files = [tmp_path / "in" / f"{number}.vxt" for number in range(6)] + [tmp_path / "in" / "deep" / "0.vxt"]
    for file in files:
        church.save(file)
    broken = tmp_path / "in" / "broken.vox"
    broken.write_bytes(b"nothing")
    options = {"size": (24, 24), "samples": 2, "device": "cpu"}
    made = dask.thumbnails(client, [*files, broken], tmp_path / "out", **options)
    assert [thumbnail.path for thumbnail in made] == [*files, broken]
    assert made[-1].picture is None and "broken.vox" in made[-1].error
    assert made[-2].picture == tmp_path / "out" / "deep" / "0.vxt.png"
    alone = voxtrace.render(voxtrace.open(files[0]), samples=2, size=(24, 24), device="cpu")
    alone.save(tmp_path / "alone.png")
    for thumbnail in made[:-1]:
        assert thumbnail.error is None and thumbnail.picture.read_bytes() == (tmp_path / "alone.png").read_bytes()
    assert dask.thumbnails(client, [], tmp_path / "out") == []
