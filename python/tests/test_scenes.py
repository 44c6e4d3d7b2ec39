"""Rays, moving and editing, threads that share scenes, files that cannot be read."""

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable

import numpy
import pytest

import voxtrace


def test_rays_find_what_the_array_says(random):
    labels = (random.random((30, 31, 32)) > 0.97).astype("uint8") * random.integers(1, 9, (30, 31, 32)).astype("uint8")
    renderer = voxtrace.Renderer(voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels)), device="cpu")
    y, z = (places.ravel() for places in numpy.mgrid[0:31, 0:32])
    origins = numpy.stack([numpy.full(y.shape, -5.0), y + 0.5, z + 0.25], axis=1)
    directions = numpy.tile([2.0, 0, 0], (len(y), 1))
    hits = renderer.cast(origins, directions)
    columns = labels[:, y, z] != 0
    first = columns.argmax(axis=0)
    met = columns.any(axis=0)
    assert (hits["hit"] == met).all() and 0 < met.sum() < len(met)
    assert (hits["voxel"][met] == numpy.stack([first, y, z], axis=1)[met]).all()
    assert hits["t"][met] == pytest.approx((first[met] + 5) / 2) and numpy.isinf(hits["t"][~met]).all()
    assert hits["position"][met][:, 0] == pytest.approx(first[met])
    assert (hits["normal"][met] == [-1, 0, 0]).all()
    assert (hits["material"][met] == labels[first, y, z][met] - 1).all()
    assert (hits["material"][~met] == 2**32 - 1).all() and (hits["instance"][met] == 0).all()
    near = renderer.cast(origins, directions, t_max=2.49)
    assert not near["hit"].any(), "nothing is before the grid"
    for wrong in [(origins[:, :2], directions), (origins, directions[:3]), (origins * numpy.nan, directions)]:
        with pytest.raises(ValueError):
            renderer.cast(*wrong)
    with pytest.raises(ValueError):
        renderer.cast(origins, directions, t_max=[1, 2, 3])


def test_placed_instances_are_met_where_they_stand():
    cube = voxtrace.VoxelGrid.from_numpy(numpy.ones((2, 2, 2), bool))
    scene = voxtrace.Scene(cube)
    move = numpy.eye(4)
    move[:3, 3] = 10, 0, 0
    assert scene.add_copy(0, move, name="second") == 1
    scene.add(voxtrace.VoxelGrid.from_numpy(numpy.ones((1, 1, 1), int), ["#000000", "#ff0000"]), numpy.diag([3, 3, 3, 1]) + 0)
    assert [instance.name for instance in scene.instances] == ["", "second", ""] and len(scene.materials) == 2
    renderer = voxtrace.Renderer(scene, device="cpu", placeable=True)
    down = [[11, 1, 50]], [[0, 0, -1]]
    assert renderer.cast(*down)["instance"][0] == 1
    places = numpy.stack([numpy.array(instance.transform) for instance in scene.instances])
    places[1, :3, 3] = 30, 0, 5
    renderer.place(places)
    assert not renderer.cast(*down)["hit"][0]
    moved = renderer.cast([[31, 1, 50]], [[0, 0, -1]])
    assert moved["instance"][0] == 1 and moved["t"][0] == 43
    with pytest.raises(ValueError, match="3, 4, 4"):
        renderer.place(places[:2])
    places[0, 0, 1] = 1
    with pytest.raises(ValueError, match="shears"):
        renderer.place(places)
    with pytest.raises(IndexError, match="the scene has 3"):
        scene.place(7, numpy.eye(4))
    with pytest.raises(ValueError, match="placeable"):
        voxtrace.Renderer(scene, device="cpu").place(places)


def test_edits_are_followed_and_undone(random):
    labels = random.integers(0, 3, (16, 16, 16)).astype("uint8")
    editor = voxtrace.Editor(voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels)))
    renderer = voxtrace.Renderer(editor, device="cpu")
    assert editor.fill((2, 3, 4), (5, 6, 7), None) == -numpy.count_nonzero(labels[2:5, 3:6, 4:7])
    edited = labels.copy()
    edited[2:5, 3:6, 4:7] = 0
    assert (editor.scene().grid(0).to_numpy("occupancy") == (edited != 0)).all()
    glow = editor.add_material(voxtrace.Material(emission=(1, 1, 1)))
    assert editor.set([[0, 0, 20], [1, 0, 20]], glow) == 2 and editor.get((1, 0, 20)) == glow
    renderer.follow(editor)
    assert renderer.cast([[0.5, 0.5, 40]], [[0, 0, -1]])["material"][0] == glow
    assert editor.undo() and editor.get((0, 0, 20)) is editor.get((1, 0, 20)) is None
    renderer.follow(editor)
    assert renderer.cast([[0.5, 0.5, 40]], [[0, 0, -1]])["t"][0] > 20
    assert editor.redo() and editor.get((0, 0, 20)) == glow
    assert editor.sphere((8, 8, 8), 2, 1) >= 0 and editor.get((8, 8, 8)) == 1
    assert editor.paint((8, 8, 8), 1.5, 0) == 0 and editor.get((8, 8, 8)) == 0
    assert editor.stroke((0.5, 0.5, 30.5), (9.5, 0.5, 30.5), 0.6, 1) > 8
    with pytest.raises(voxtrace.VoxtraceError, match="no material 77"):
        editor.fill((0, 0, 0), (1, 1, 1), 77)
    with pytest.raises(ValueError, match="whole"):
        editor.fill((0, 0, 0.5), (1, 1, 1), 0)
    other = voxtrace.Editor(voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels)))
    other.fill((0, 0, 0), (2, 2, 2), 0)
    with pytest.raises(ValueError, match="anew"):
        renderer.follow(other)


def labelled(labels: numpy.ndarray) -> voxtrace.Editor:
    return voxtrace.Editor(voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels)))


def test_voxels_of_one_call_are_one_step(random):
    labels = random.integers(0, 3, (16, 16, 16)).astype("uint8")
    editor = labelled(labels)
    occupancy = lambda: editor.scene().grid(0).to_numpy("occupancy")
    voxels = random.integers(0, 16, (300, 3))
    assert editor.fill((0, 0, 0), (4, 4, 4), 1) == numpy.count_nonzero(labels[:4, :4, :4] == 0)
    filled = occupancy()
    cut = filled.copy()
    cut[tuple(voxels.T)] = False
    assert editor.set(voxels, None) == numpy.count_nonzero(cut) - numpy.count_nonzero(filled)
    assert (occupancy() == cut).all()
    assert editor.undo() and (occupancy() == filled).all()
    assert editor.redo() and (occupancy() == cut).all()
    assert editor.undo() and editor.undo() and not editor.undo()
    assert (occupancy() == (labels != 0)).all()
    # Voxels that are so already begin no step, and join none.
    editor.fill((0, 0, 0), (2, 2, 2), 1)
    assert editor.set([[0, 0, 0], [1, 1, 1], [0, 0, 17], [0, 0, 18]], 1) == 2
    assert editor.undo() and editor.get((0, 0, 17)) is editor.get((0, 0, 18)) is None and editor.get((0, 0, 0)) == 1
    assert editor.set(numpy.empty((0, 3), int), 1) == editor.set([[2**31 - 1, 0, 0], [-(2**31), 0, 0]], None) == 0


@pytest.mark.parametrize(
    ("last", "material", "grid", "says"),
    [
        ((524_289, 0, 0), 0, 0, "524289"),
        ((0, -524_289, 0), 0, 0, "524289"),
        ((2**31 - 1, 0, 0), 0, 0, "2147483647"),
        ((3, 3, 3), 5, 0, "no material 5"),
        ((3, 3, 3), 0, 1, "no grid 1"),
    ],
)
def test_voxels_that_cannot_be_set_leave_the_others(last, material, grid, says):
    editor = labelled(numpy.ones((4, 4, 4), "uint8"))
    editor.fill((0, 0, 4), (4, 4, 5), 0)
    with pytest.raises(voxtrace.VoxtraceError, match=says):
        editor.set([[0, 0, 9], [0, 0, 10], last], material, grid=grid)
    assert editor.get((0, 0, 9)) is editor.get((0, 0, 10)) is None and editor.voxels == 80
    assert editor.undo() and editor.voxels == 64 and not editor.undo(), "no step was begun"
    assert editor.redo() and editor.voxels == 80


def test_voxels_are_whole_numbers_and_none_is_taken_for_another():
    editor = labelled(numpy.ones((4, 4, 4), "uint8"))
    for wrong in [[[0.5, 0, 0]], [[-0.25, 0, 0]], [[float("nan"), 0, 0]], [[float("inf"), 0, 0]]]:
        with pytest.raises(ValueError, match="whole"):
            editor.set(wrong, None)
    # What is beyond 32 bits is no voxel, least of all the one that its lowest bits name.
    assert editor.set(numpy.array([[2**32 + 1, 0, 0], [-(2**40), 1, 1]]), None) == 0 and editor.voxels == 64
    with pytest.raises(voxtrace.VoxtraceError, match="out of range"):
        editor.set(numpy.array([[2**32 + 1, 0, 9]]), 0)
    assert editor.get((1, 0, 9)) is None and not editor.undo()
    assert editor.set(numpy.array([[1.0, 2.0, 3.0]]), None) == -1


def test_there_is_nothing_with_a_number_below_0():
    scene = labelled(numpy.ones((4, 4, 4), "uint8")).scene()
    volume = voxtrace.Volume.from_array(numpy.ones((2, 3, 4)))
    for ask in [
        lambda: scene.place(-1, numpy.eye(4)),
        lambda: scene.add_copy(-1, numpy.eye(4)),
        lambda: scene.grid(-1),
        lambda: scene.set_material(-1, voxtrace.Material()),
        lambda: volume[0, 0, -1],
        lambda: volume[2, 0, 0],
    ]:
        with pytest.raises(IndexError):
            ask()


def test_there_is_nothing_with_a_number_beyond_all_numbers():
    scene = labelled(numpy.ones((4, 4, 4), "uint8")).scene()
    for ask in [lambda: scene.grid(2**64), lambda: scene.place(2**70, numpy.eye(4)), lambda: voxtrace.Volume.from_array(numpy.ones((2, 3, 4)))[0, 0, 2**64]]:
        with pytest.raises(IndexError, match="there cannot be so many"):
            ask()
    with pytest.raises(IndexError, match="they begin at 0"):
        scene.grid(-(2**70))


def test_edits_of_what_cannot_be_there_say_that_it_is_not():
    editor = labelled(numpy.ones((4, 4, 4), "uint8"))
    for material in [-1, 70_000]:
        for edit in [
            lambda: editor.fill((0, 0, 0), (2, 2, 2), material),
            lambda: editor.sphere((0, 0, 0), 2, material),
            lambda: editor.stroke((0, 0, 0), (2, 2, 2), 2, material),
            lambda: editor.paint((0, 0, 0), 2, material),
            lambda: editor.replace(material, None),
            lambda: editor.replace(0, material),
            lambda: editor.set([[0, 0, 0]], material),
        ]:
            with pytest.raises(voxtrace.VoxtraceError, match=f"there is no material {material}"):
                edit()
    for edit in [lambda: editor.fill((0, 0, 0), (2, 2, 2), None, grid=-1), lambda: editor.set([[0, 0, 0]], None, grid=-1)]:
        with pytest.raises(voxtrace.VoxtraceError, match="there is no grid -1"):
            edit()
    assert editor.get((0, 0, 0), grid=-1) is None and editor.voxels == 64 and not editor.undo()


def test_light_that_cannot_be_is_refused():
    for make in [lambda: voxtrace.Sky.uniform((-1, 0, 0)), lambda: voxtrace.Sky.gradient("#000000", (0, 0, -0.5))]:
        with pytest.raises(ValueError, match="≥ 0"):
            make()
    for make in [lambda: voxtrace.Sky.uniform((1e39, 0, 0)), lambda: voxtrace.Material(emission=(0, 1e39, 0))]:
        with pytest.raises(ValueError, match="single precision"):
            make()


def test_arrays_of_other_shapes_are_refused():
    renderer = voxtrace.Renderer(voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(numpy.ones((4, 4, 4), "uint8"))), device="cpu")
    for wrong in [lambda: renderer.cast([0, 0, 9], [0, 0, -1]), lambda: labelled(numpy.ones((1, 1, 1), "uint8")).set([0, 0, 0], None)]:
        with pytest.raises(ValueError, match="2 axes"):
            wrong()
    with pytest.raises(ValueError, match="3 axes"):
        voxtrace.Renderer(voxtrace.builtin("city", voxels=20_000), device="cpu", placeable=True).place(numpy.eye(4))
    # Fields of packed records: their strides are no multiples of their numbers.
    rays = numpy.zeros(9, [("flag", "u1"), ("origin", "<f4", 3), ("direction", "<f4", 3)])
    rays["origin"], rays["direction"] = [1.5, 2.5, 9], [0, 0, -1]
    rays["origin"][:, 2] += numpy.arange(9)
    assert renderer.cast(rays["origin"], rays["direction"])["t"].tolist() == [5 + number for number in range(9)]


def test_a_process_that_was_forked_says_so_and_does_not_hang():
    if not hasattr(os, "fork"):
        pytest.skip("this system does not fork")
    script = """if True:
        import numpy, os, voxtrace
        def work():
            grid = voxtrace.VoxelGrid.from_numpy(numpy.ones((40, 40, 40), "uint8"))
            return voxtrace.render(voxtrace.Scene(grid), samples=1, size=(16, 9), device="cpu", progress=False)
        def child():
            for attempt in [work, lambda: voxtrace.builtin("city", voxels=20_000)]:
                try:
                    attempt()
                except RuntimeError as error:
                    assert "spawn" in str(error)
                else:
                    return 1
            return 0
        # A child of one that has only been loaded works.
        for first in [True, False]:
            process = os.fork()
            if process == 0:
                os._exit((work() is None) if first else child())
            assert os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]) == 0, first
            work()
    """
    subprocess.run([sys.executable, "-c", script], check=True, timeout=600)


def down(renderer: voxtrace.Renderer) -> float:
    """How far the first voxel is below a place above voxel (0, 0)."""
    return renderer.cast([[0.5, 0.5, 40]], [[0, 0, -1]])["t"][0]


def test_renderers_that_cannot_follow_lose_no_edits():
    labels = numpy.ones((4, 4, 4), "uint8")
    editor, other = labelled(labels), labelled(labels)
    renderer = voxtrace.Renderer(editor, device="cpu")
    wrong = [voxtrace.Renderer(other, device="cpu"), voxtrace.Renderer(editor.scene(), device="cpu")]
    editor.set([[0, 0, 9]], 0)
    for stranger in wrong:
        with pytest.raises(ValueError, match="anew"):
            stranger.follow(editor)
        assert down(stranger) == 36
    for arguments in [{"device": "no such card"}, {"device": "cpu", "traversal": "walk"}, {"traversal": "rays"}]:
        with pytest.raises((ValueError, voxtrace.DeviceError)):
            voxtrace.Renderer(editor, **arguments)
        editor.set([[0, 0, editor.voxels - 55]], 0)
    assert down(renderer) == 36
    renderer.follow(editor)
    assert down(renderer) == 40 - 13
    other.set([[0, 0, 20]], 0)
    wrong[0].follow(other)
    assert down(wrong[0]) == 19
    # The last renderer of an editor is the one that follows.
    last = voxtrace.Renderer(editor, device="cpu")
    editor.set([[0, 0, 30]], 0)
    with pytest.raises(ValueError, match="another one follows"):
        renderer.follow(editor)
    last.follow(editor)
    assert (down(renderer), down(last)) == (27, 9)


def test_a_device_that_cannot_follow_catches_up(random):
    editor = labelled(numpy.ones((40, 40, 40), "uint8"))
    try:
        renderer = voxtrace.Renderer(editor, device="0", memory=1 << 20)
    except voxtrace.DeviceError:
        if os.environ.get("VOXTRACE_REQUIRE_VULKAN"):
            raise
        pytest.skip("no Vulkan device")
    options = {"samples": 1, "size": (24, 16), "denoise": False, "camera": voxtrace.Camera((700, 500, 600), (0, 0, 0))}
    for _ in range(2):
        editor.set(random.integers(-300, 300, (8_000, 3)), 0)
        with pytest.raises(voxtrace.DeviceError, match="out of memory"):
            renderer.follow(editor)
        fresh = voxtrace.Renderer(editor.scene(), device="cpu").render(**options)
        assert (renderer.render(**options).sums == fresh.sums).all() and fresh.alpha.max() > 0
    assert down(renderer) == 0
    editor.set([[0, 0, 39]], None)
    with pytest.raises(voxtrace.DeviceError, match="out of memory"):
        renderer.follow(editor)
    assert down(renderer) == 1


def at_once(*tasks: Callable[[], object]) -> list[object]:
    """What tasks return that threads begin at the same time; what one raises is raised."""
    begin, results = threading.Barrier(len(tasks)), [None] * len(tasks)

    def work(index: int) -> None:
        begin.wait()
        try:
            results[index] = tasks[index]()
        except BaseException as error:
            results[index] = error

    threads = [threading.Thread(target=work, args=[index]) for index in range(len(tasks))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for result in results:
        if isinstance(result, BaseException):
            raise result
    return results


def test_threads_share_a_scene(random):
    labels = (random.random((160, 160, 160)) > 0.5).astype("uint8")
    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels))
    image = voxtrace.render(scene, samples=2, size=(16, 9), device="cpu", denoise=False)
    scene.sky = scene.sky
    picture = lambda: voxtrace.Renderer(scene, device="cpu").render(samples=2, size=(16, 9), denoise=False).to_bytes()
    results = at_once(
        picture,
        picture,
        lambda: voxtrace.Editor(scene).voxels,
        lambda: voxtrace.Renderer(scene, device="cpu", placeable=True).cast([[0, 0, 500]], [[0, 0, -1]])["hit"].shape,
        lambda: scene.info()["voxels"],
        lambda: scene.bounds,
        lambda: image.denoise(scene).shape,
    )
    voxels = numpy.count_nonzero(labels)
    assert results == [image.to_bytes()] * 2 + [voxels, (1,), voxels, ([0] * 3, [160] * 3), (9, 16)]


def test_threads_add_to_a_scene():
    colors = [(share / 8, 0, 0) for share in range(1, 7)]
    grids = [voxtrace.VoxelGrid.from_numpy(numpy.ones((80, 80, 80), "uint8"), ["#000000", color]) for color in colors]
    scene = voxtrace.Scene()
    numbers = at_once(*[lambda grid=grid: scene.add(grid) for grid in grids])
    assert sorted(numbers) == list(range(len(grids))) and len(scene.materials) == len(grids)
    for number, grid in zip(numbers, grids):
        added = scene.grid(scene.instances[number].grid)
        assert added.materials[added[79, 0, 79]] == grid.materials[0]


def test_other_threads_run_and_read_while_a_file_is_unpacked(random):
    count, ended, failed = 0, threading.Event(), []
    scenes: list[voxtrace.Scene] = []

    def counts() -> None:
        nonlocal count
        while not ended.wait(0.001):
            count += 1
            try:
                assert all(scene.name == "scene" and scene.sky and scene.light_intensity > 0 for scene in scenes)
            except Exception as error:
                failed.append(error)

    thread = threading.Thread(target=counts)
    thread.start()
    meanwhile = 0
    # A quick machine and a busy one need more voxels.
    for edge in [160, 320, 480]:
        labels = random.integers(1, 250, (edge, edge, edge), "uint8")
        scene = voxtrace.Scene.from_bytes(voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels)).to_bytes())
        scenes[:] = [scene]
        before = count
        scene.light_intensity = 2.5
        meanwhile = count - before
        assert scene.light_intensity == 2.5 and (scene.grid(0).to_numpy() == labels).all()
        if meanwhile > 20:
            break
    ended.set()
    thread.join()
    assert meanwhile > 20 and not failed, failed


def test_changes_wait_for_threads_that_work_with_a_scene(random):
    labels = (random.random((200, 200, 200)) > 0.5).astype("uint8")
    cube = voxtrace.VoxelGrid.from_numpy(numpy.ones((2, 2, 2), bool))
    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels))
    changes = [
        lambda: scene.add(cube),
        lambda: scene.add_copy(0, numpy.eye(4)),
        lambda: scene.place(1, numpy.eye(4)),
        lambda: scene.set_material(0, voxtrace.Material("#ff0000")),
        lambda: setattr(scene, "sky", voxtrace.Sky.black()),
        lambda: setattr(scene, "light_intensity", 2.0),
        lambda: setattr(scene, "cameras", []),
        lambda: setattr(scene, "clip", ((0, 0, 0), (9, 9, 9))),
    ]
    for change in changes:
        # What was packed is forgotten, so that it takes a while again.
        scene.light_intensity = 1.0
        packing = threading.Thread(target=lambda: scene.bounds)
        packing.start()
        time.sleep(0.02)
        change()
        packing.join()
    assert [len(scene.instances), scene.light_intensity, scene.clip] == [3, 1.0, ([0, 0, 0], [9, 9, 9])]
    assert scene.sky == voxtrace.Sky.black() and scene.materials[0] == voxtrace.Material("#ff0000")


def test_a_change_in_a_handler_of_a_signal_does_not_wait_for_what_it_interrupts(random):
    if not hasattr(signal, "setitimer"):
        pytest.skip("this system has no timers that send signals")
    labels = (random.random((256, 256, 256)) > 0.5).astype("uint8")
    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels))
    told = []

    def handler(*_: object) -> None:
        try:
            scene.light_intensity = 2.0
        except RuntimeError as error:
            told.append(error)

    before = signal.signal(signal.SIGALRM, handler)
    try:
        # Where it comes before or after the scene is packed it changes it.
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        assert scene.bounds == ([0] * 3, [256] * 3)
        while not told and scene.light_intensity == 1:
            time.sleep(0.01)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert len(told) == (scene.light_intensity == 1)


def test_threads_share_an_editor():
    editor = labelled(numpy.ones((1, 1, 1), "uint8"))
    renderer = voxtrace.Renderer(editor, device="cpu")
    x, y = (places.ravel() for places in numpy.mgrid[0:30, 0:30])
    layer = lambda z: numpy.stack([x, y, numpy.full(x.shape, z)], axis=1)
    going = threading.Event()

    def draw(first: int) -> int:
        try:
            return sum(editor.set(layer(z), 0) for z in range(first, first + 5))
        finally:
            going.set()

    def follow() -> float:
        while not going.is_set():
            renderer.follow(editor)
            assert editor.voxels > 0 and editor.get((0, 0, 0)) == 0 and "Editor" in repr(editor)
        return editor.scene().info()["voxels"]

    results = at_once(lambda: draw(10), lambda: draw(20), lambda: draw(30), follow)
    assert results[:3] == [4500] * 3 and editor.voxels == 13_501
    renderer.follow(editor)
    assert down(renderer) == 5
    assert sum(editor.undo() for _ in range(16)) == 15 and editor.voxels == 1


def test_other_threads_run_while_voxels_are_set(random):
    editor = labelled(numpy.ones((4, 4, 4), "uint8"))
    count, ended = 0, threading.Event()

    def counts() -> None:
        nonlocal count
        while not ended.wait(0.001):
            count += 1

    thread = threading.Thread(target=counts)
    thread.start()
    meanwhile = 0
    # A quick machine and a busy one need more voxels.
    for number in [200_000, 800_000, 3_200_000]:
        voxels = random.integers(0, 64 if number == 200_000 else 256, (number, 3))
        before = count
        editor.set(voxels, 0)
        meanwhile = count - before
        if meanwhile > 20:
            break
    ended.set()
    thread.join()
    assert meanwhile > 20


def test_files_that_cannot_be_read_say_where(tmp_path):
    with pytest.raises(FileNotFoundError) as info:
        voxtrace.open(tmp_path / "nothing.vox")
    assert info.value.filename.endswith("nothing.vox")
    broken = tmp_path / "broken.vox"
    broken.write_bytes(b"VOX \x96\x00\x00\x00MAIN")
    with pytest.raises(voxtrace.ReadError) as info:
        voxtrace.open(broken)
    assert info.value.path == str(broken) and info.value.offset is not None and "broken.vox" in str(info.value)
    unknown = tmp_path / "letter.docx"
    unknown.write_bytes(b"hello")
    with pytest.raises(voxtrace.ReadError) as info:
        voxtrace.open(unknown)
    assert "voxtrace formats" in info.value.hint and isinstance(info.value, voxtrace.VoxtraceError)
    with pytest.raises(voxtrace.ReadError):
        voxtrace.open_volume(broken)


@pytest.mark.parametrize("is_packed", [False, True])
def test_ctrl_c_ends_the_writing_of_a_scene_and_leaves_the_old_file(ctrl_c_ends, random, tmp_path, is_packed):
    path = tmp_path / "scene.obj"

    def saves():
        for edge in [64, 128, 192]:
            scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy((random.random((edge, edge, edge)) > 0.5).astype("uint8")))
            saved = voxtrace.Scene.from_bytes(scene.to_bytes()) if is_packed else scene

            def save():
                path.write_bytes(b"old")
                saved.save(path)

            yield save

    ctrl_c_ends(saves())
    assert path.read_bytes() == b"old"
    assert {file.suffix for file in tmp_path.iterdir()} <= {".obj", ".mtl"}, "nothing is left behind"


def test_ctrl_c_ends_the_unpacking_of_a_scene(ctrl_c_ends, random):
    def looks():
        # Models that were merged come apart voxel by voxel.
        edge = 64
        model = voxtrace.VoxelGrid.from_numpy((random.random((edge, edge, edge)) > 0.5).astype("uint8"))
        for count in [4, 6, 8, 10, 12]:
            scene = voxtrace.Scene()
            for place in numpy.ndindex(count, count, count):
                transform = numpy.eye(4)
                transform[:3, 3] = edge * numpy.array(place)
                scene.add(model, transform)
            packed = voxtrace.Scene.from_bytes(scene.to_bytes())
            yield lambda packed=packed: packed.instances

    ctrl_c_ends(looks())


def test_built_in_scenes_have_names_and_sizes():
    assert {"church", "operating-room", "city", "forest"} <= set(voxtrace.BUILTIN_SCENES)
    forest = voxtrace.builtin("forest", instances=50)
    assert len(forest.instances) > 50
    for name, options in [("castle", {}), ("church", {"instances": 5}), ("church", {"voxels": 1})]:
        with pytest.raises(ValueError):
            voxtrace.builtin(name, **options)


def test_info_counts(church):
    info = church.info()
    assert info["voxels"] == church.voxels and abs(info["voxels"] - 20_000) < 500
    assert info["total_bytes"] == sum(info["bytes"].values()) and info["unit"] == "m"
    low, high = church.bounds
    assert tuple(numpy.subtract(high, low).astype(int)) == info["size"]
