"""Grids from arrays and back."""

import numpy
import pytest

import voxtrace


@pytest.mark.parametrize("dtype", ["uint8", "int8", "uint16", "int16", "int32", "uint32", "int64", "uint64"])
@pytest.mark.parametrize("shape", [(1, 1, 1), (37, 20, 51), (8, 16, 24), (0, 3, 4)])
def test_labels_come_back_exactly(random, dtype, shape):
    labels = random.integers(0, 100, shape).astype(dtype)
    labels[labels > 60] = 0
    for origin in [(0, 0, 0), (-5, 3, 1001)]:
        grid = voxtrace.VoxelGrid.from_numpy(labels, origin=origin)
        assert (grid.to_numpy() == labels).all() and grid.to_numpy().shape == shape
        assert tuple(grid.origin) == origin and len(grid) == numpy.count_nonzero(labels)
        assert (grid.to_numpy("occupancy") == (labels != 0)).all()


def test_bricks_of_one_material_come_back_exactly_and_change_alone():
    labels = numpy.zeros((40, 30, 33), "uint16")
    labels[3:35, 2:28, 1:30] = 4
    labels[16:24, 8:20, 8:24] = 900
    labels[17, 9, 9] = 0
    grid = voxtrace.VoxelGrid.from_numpy(labels, origin=(-3, 4, 5))
    assert (grid.to_numpy() == labels).all() and len(grid) == numpy.count_nonzero(labels)
    editor = voxtrace.Editor(voxtrace.Scene(grid))
    editor.set([[-3 + 20, 4 + 12, 5 + 12]], None)
    changed = labels.copy()
    changed[20, 12, 12] = 0
    assert (editor.scene().grid(0).to_numpy("occupancy") == (changed[3:35, 2:28, 1:30] != 0)).all()
    assert (grid.to_numpy() == labels).all()


def test_arrays_are_read_where_they_lie(random):
    labels = random.integers(0, 1000, (20, 30, 40)).astype("uint16")
    for view in [labels.T, labels[::-1, ::2, 3:], numpy.asfortranarray(labels), labels[5:6]]:
        back = voxtrace.VoxelGrid.from_numpy(view).to_numpy()
        assert back.dtype == "uint16" and (back == view).all()
        if view.shape[2] > 1:
            assert (voxtrace.VoxelGrid.from_numpy(view[:, :, ::-1]).to_numpy() != view).any(), "a fault is seen"


def test_arrays_of_other_machines_and_fields_of_records_are_read_as_they_are(random):
    labels = random.integers(0, 1000, (6, 7, 8))
    for dtype in [">u2", ">i4", ">i8", "<i4"]:
        assert (voxtrace.VoxelGrid.from_numpy(labels.astype(dtype)).to_numpy() == labels).all(), dtype
        # Behind a byte: neither aligned nor at strides of whole numbers.
        records = numpy.zeros(labels.shape, [("flag", "u1"), ("label", dtype)])
        records["label"] = labels
        for view in [records["label"], records["label"][::-1, :, ::2]]:
            assert (voxtrace.VoxelGrid.from_numpy(view).to_numpy() == view).all(), dtype
    records = numpy.zeros(labels.shape, [("flag", "u1"), ("value", "<f4")])
    records["value"] = labels
    assert (voxtrace.Volume.from_array(records["value"]).to_numpy() == labels).all()


def test_a_label_has_its_place_and_its_material():
    labels = numpy.zeros((5, 6, 7), "uint8")
    labels[1, 2, 3] = 2
    palette = [voxtrace.Material(), voxtrace.Material("#ff0000"), voxtrace.Material("#00ff00", emission=(1, 2, 3))]
    grid = voxtrace.VoxelGrid.from_numpy(labels, palette, origin=(10, 20, 30))
    assert grid[11, 22, 33] == 1 and grid[12, 22, 33] is None
    assert grid.materials == palette[1:]
    assert grid.bounds == ([11, 22, 33], [12, 23, 34])
    bytes_of_colors = numpy.array([[0, 0, 0], [255, 0, 0], [0, 255, 0]], "uint8")
    assert voxtrace.VoxelGrid.from_numpy(labels, bytes_of_colors).materials[1].base_color == [0, 1, 0]
    linear = bytes_of_colors / 510
    assert voxtrace.VoxelGrid.from_numpy(labels, linear).materials[1].base_color == [0, 0.5, 0]


def test_colours_come_back_exactly_up_to_65535_of_them(random):
    rgba = random.integers(0, 256, (30, 40, 50, 4)).astype("uint8")
    rgba[..., 3] = numpy.where(rgba[..., 3] > 100, 255, 0)
    rgba[rgba[..., 3] == 0] = 0
    assert len(numpy.unique(rgba.reshape(-1, 4), axis=0)) < 65_536
    back = voxtrace.VoxelGrid.from_numpy(rgba).to_numpy("rgba")
    assert (back == rgba).all()
    many = random.integers(0, 80, (60, 60, 60, 3)).astype("uint8")
    back = voxtrace.VoxelGrid.from_numpy(many).to_numpy("rgba")
    assert numpy.abs(back[..., :3].astype(int) - many).max() <= 1, "more are rounded to seven bits"
    assert (back[..., :3] != many).any()


def test_bool_arrays_are_occupancy(random):
    occupied = random.random((17, 9, 33)) > 0.5
    grid = voxtrace.VoxelGrid.from_numpy(occupied, ["#336699"])
    assert (grid.to_numpy("occupancy") == occupied).all() and len(grid.materials) == 1


def test_bools_of_any_bytes_are_occupancy(random):
    mask = random.choice(numpy.array([0, 1, 2, 127, 128, 255], "uint8"), (17, 9, 33))
    for bytes_of_bools in [mask, mask.T, mask[::-1, ::2, 3:]]:
        grid = voxtrace.VoxelGrid.from_numpy(bytes_of_bools.view(bool))
        assert (grid.to_numpy() == (bytes_of_bools != 0)).all() and len(grid) == numpy.count_nonzero(bytes_of_bools)


@pytest.mark.parametrize(
    ("array", "palette", "says"),
    [
        (numpy.zeros((3, 4)), None, r"shape \(X, Y, Z\)"),
        (numpy.zeros((3, 4, 5)), None, "bool, of whole numbers"),
        (numpy.full((3, 4, 5), 70_000), None, "numpy.unique"),
        (numpy.full((3, 4, 5), -1), None, "0 to 65535"),
        (numpy.zeros((3, 4, 5, 3)), None, "uint8"),
        (numpy.zeros((3, 4, 5, 2), "uint8"), None, "shape"),
        (numpy.full((3, 4, 5), 3), ["#000000", "#ffffff"], "the highest label is 3"),
        ([[[1]]], None, "array of numpy"),
        (numpy.ones((1, 1, 1), int), ["#00000", "#fff000"], "no colour like"),
        (numpy.ones((1, 1, 1), int), ["#+00000", "#fff000"], "no colour like"),
    ],
)
def test_what_cannot_be_is_refused_in_one_sentence(array, palette, says):
    with pytest.raises(ValueError, match=says):
        voxtrace.VoxelGrid.from_numpy(array, palette)


def test_bytes_are_no_linear_colours():
    labels = numpy.ones((1, 1, 1), "uint8")
    for palette in [numpy.array([[0, 0, 0], [255, 128, 0]]), [(0, 0, 0), (255, 128, 0)], [(0, 0, 0), (0, 0, -0.5)]]:
        with pytest.raises(ValueError, match="uint8"):
            voxtrace.VoxelGrid.from_numpy(labels, palette)
    for make in [lambda: voxtrace.TransferFunction([(1, (255, 0, 0))]), lambda: voxtrace.TransferFunction.labels({1: (255, 0, 0)})]:
        with pytest.raises(ValueError, match=r"in \[0, 1\]"):
            make()


def test_origins_are_whole_numbers():
    labels = numpy.ones((1, 1, 1), "uint8")
    assert voxtrace.VoxelGrid.from_numpy(labels, origin=numpy.array([-3.0, 4.0, 5.0])).origin == [-3, 4, 5]
    with pytest.raises(ValueError, match="whole"):
        voxtrace.VoxelGrid.from_numpy(labels, origin=(-0.5, 0, 0))


def test_what_is_masked_is_empty(random):
    labels, mask = random.integers(1, 9, (6, 7, 8)), random.random((6, 7, 8)) > 0.5
    # What stands below a mask may be anything.
    for hidden in [3, 70_000, -1]:
        masked = numpy.ma.masked_array(numpy.where(mask, hidden, labels), mask)
        assert (voxtrace.VoxelGrid.from_numpy(masked).to_numpy() == numpy.where(mask, 0, labels)).all(), hidden
    occupied = numpy.ma.masked_array(numpy.ones((6, 7, 8), bool), mask)
    assert (voxtrace.VoxelGrid.from_numpy(occupied).to_numpy("occupancy") == ~mask).all()
    assert (voxtrace.VoxelGrid.from_numpy(numpy.ma.masked_array(labels)).to_numpy() == labels).all()
    colors = numpy.ma.masked_equal(random.integers(0, 3, (6, 7, 8, 3)).astype("uint8"), 1)
    with pytest.raises(ValueError, match="alpha 0 is empty"):
        voxtrace.VoxelGrid.from_numpy(colors)


def test_origins_are_within_32_bits():
    labels = numpy.ones((4, 4, 4), "uint8")
    for origin in [(-1e12, 0, 0), (0, 1e12, 0), (2**31 - 6, 0, 0), (0, 0, 2**31 - 3)]:
        with pytest.raises(ValueError, match="farther"):
            voxtrace.VoxelGrid.from_numpy(labels, origin=origin)
    for origin in [(2**31 - 64, 0, 0), (0, -(2**31) + 2, 0)]:
        grid = voxtrace.VoxelGrid.from_numpy(labels, origin=origin)
        assert grid.to_numpy().all() and tuple(grid.origin) == origin and tuple(grid.bounds[0]) == origin


def test_files_keep_grids(tmp_path, random):
    labels = random.integers(0, 4, (20, 21, 22)).astype("uint8")
    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels))
    for name in ["a.vxt", "a.vox"]:
        assert isinstance(scene.save(tmp_path / name), list)
        again = voxtrace.open(tmp_path / name)
        assert again.voxels == numpy.count_nonzero(labels)
        occupancy = again.grid(0).to_numpy("occupancy")
        low = [int(places.min()) for places in labels.nonzero()]
        high = [int(places.max()) + 1 for places in labels.nonzero()]
        assert (occupancy == (labels != 0)[low[0] : high[0], low[1] : high[1], low[2] : high[2]]).all()
    with pytest.raises(ValueError, match="no format"):
        scene.save(tmp_path / "a.docx")
    with pytest.raises(OSError):
        scene.save(tmp_path / "nowhere" / "a.vxt")


def test_ctrl_c_ends_the_making_of_a_grid(ctrl_c_ends):
    nothing = numpy.zeros(1, "uint8")
    arrays = [numpy.broadcast_to(nothing, (edge, edge, edge)) for edge in [512, 768, 1024]]
    ctrl_c_ends((lambda array=array: voxtrace.VoxelGrid.from_numpy(array)) for array in arrays)
