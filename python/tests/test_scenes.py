"""Rays, moving and editing, files that cannot be read."""

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
    assert editor.undo() and editor.undo()
    renderer.follow(editor)
    assert editor.get((0, 0, 20)) is None
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
