"""Volumes of arrays of several libraries: the same samples in the same places."""

import numpy
import pytest

import voxtrace


def test_samples_stay_where_they_are(random):
    values = random.random((5, 6, 7), dtype="float32")
    for array in [values, numpy.asfortranarray(values), values.astype("float64"), values[::-1][::-1]]:
        volume = voxtrace.Volume.from_array(array, spacing=(1, 2, 3), unit="mm")
        assert (volume.to_numpy() == values).all() and volume.shape == (5, 6, 7)
        assert volume.spacing == [1, 2, 3] and volume.unit == "mm"
    assert (voxtrace.Volume.from_array(values[::-1]).to_numpy() != values).any(), "a fault is seen"


def test_affines_say_the_spacing_and_are_checked(random):
    values = random.random((5, 6, 7))
    affine = [[0, 2, 0, 9], [1, 0, 0, 8], [0, 0, 4, 7], [0, 0, 0, 1]]
    volume = voxtrace.Volume.from_array(values, affine=affine)
    assert volume.spacing == [1, 2, 4] and volume.affine == affine
    for wrong in [numpy.zeros((4, 4)), numpy.eye(2), [[1, 0, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0]]]:
        with pytest.raises((ValueError, TypeError)):
            voxtrace.Volume.from_array(values, affine=wrong)
    with pytest.raises(ValueError, match="not both"):
        voxtrace.Volume.from_array(values, affine=affine, spacing=1)
    with pytest.raises(ValueError, match=r"3 axes .* \(3, 4\)"):
        voxtrace.Volume.from_array(numpy.zeros((3, 4)))


def test_what_is_masked_is_no_sample(random):
    values = random.random((5, 6, 7))
    mask = values > 0.7
    volume = voxtrace.Volume.from_array(numpy.ma.masked_array(numpy.where(mask, 9.96921e36, values), mask))
    assert (numpy.isnan(volume.to_numpy()) == mask).all() and (volume.to_numpy()[~mask] == values[~mask].astype("float32")).all()
    assert volume.histogram()[0][-1] < 1
    whole = numpy.ma.masked_greater(random.integers(0, 9, (5, 6, 7)), 5)
    assert (numpy.isnan(voxtrace.Volume.from_array(whole).to_numpy()) == whole.mask).all()
    labels = voxtrace.Volume.from_array(whole, labels=True)
    assert (labels.to_numpy() == whole.filled(0)).all()


def test_what_is_no_volume_is_told_in_its_own_terms():
    with pytest.raises(ValueError, match="real numbers are wanted, not complex64"):
        voxtrace.Volume.from_array(numpy.ones((3, 3, 3), "complex64"))
    with pytest.raises(ValueError, match="without samples"):
        voxtrace.Volume.from_array(numpy.ones((0, 3, 3)))
    simple = pytest.importorskip("SimpleITK")
    with pytest.raises(ValueError, match="3 dimensions is wanted, not of 2"):
        voxtrace.Volume.from_array(simple.GetImageFromArray(numpy.ones((3, 4))))


def test_labels_that_would_become_others_are_refused():
    labels = numpy.zeros((3, 4, 5), "uint32")
    # Identifiers of structures, as atlases of brains have them.
    labels[0], labels[1] = 614_454_277, 614_454_278
    with pytest.raises(ValueError, match="numpy.unique"):
        voxtrace.Volume.from_array(labels, labels=True)
    assert voxtrace.Volume.from_array(labels).to_numpy()[0, 0, 0] == numpy.float32(614_454_277)
    labels[1] = 614_454_272
    labels[0] = 2**24
    volume = voxtrace.Volume.from_array(labels, labels=True)
    assert volume[0, 0, 0] == 2**24 and volume[1, 0, 0] == 614_454_272
    names, numbered = numpy.unique(labels, return_inverse=True)
    assert voxtrace.Volume.from_array(numbered.reshape(labels.shape), labels=True)[1, 0, 0] == len(names) - 1


def test_steps_of_a_microscope_are_even_or_not():
    xarray = pytest.importorskip("xarray")
    metres = 1e-9 * numpy.array([0.0, 200, 400, 600])
    data = lambda z: xarray.DataArray(numpy.ones((4, 4, 4)), {"x": metres, "y": metres, "z": z}, dims=["x", "y", "z"])
    assert voxtrace.Volume.from_array(data(metres)).spacing == pytest.approx([2e-7] * 3)
    with pytest.raises(ValueError, match="along z are not even"):
        voxtrace.Volume.from_array(data(1e-9 * numpy.array([0.0, 9, 16, 20])))


def test_numbers_that_cannot_be_are_refused(random, tmp_path):
    volume = voxtrace.Volume.from_array(random.random((5, 6, 7)))
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    for size in [0.0, -1.0, float("nan"), float("inf")]:
        with pytest.raises(ValueError, match="voxel_size is above 0"):
            volume.voxelize(voxel_size=size)
        with pytest.raises(ValueError, match="voxel_size is above 0"):
            voxtrace.open(tmp_path / "a.obj", voxel_size=size)
    for bounds in [(0, float("inf")), (float("nan"), 1)]:
        with pytest.raises(ValueError, match="finite"):
            volume.histogram(*bounds)
    for wrong in [{"threshold": 5, "upper": 1}, {"threshold": float("nan")}, {"upper": -1}]:
        with pytest.raises(ValueError, match="at most upper"):
            voxtrace.TransferFunction([(0, "#ffffff")], **wrong)
    shown = voxtrace.TransferFunction([(3, "#ffffff"), (1, "#000000")], upper=3)
    assert repr(shown) == repr(voxtrace.TransferFunction([(1, "#000000"), (3, "#ffffff")], upper=3))


def test_other_libraries_know_where_their_samples_are(random, tmp_path):
    values = random.random((5, 6, 7), dtype="float32")

    xarray = pytest.importorskip("xarray")
    coordinates = {"x": 10 + 0.5 * numpy.arange(5), "y": -2.0 * numpy.arange(6), "z": 3.0 * numpy.arange(7)}
    data = xarray.DataArray(values, coordinates, name="temperature")
    volume = voxtrace.Volume.from_array(data)
    assert volume.spacing == [0.5, 2, 3] and volume.name == "temperature"
    assert volume.affine[0] == [0.5, 0, 0, 10] and volume.affine[1] == [0, -2, 0, 0]
    assert (volume.to_numpy() == values).all()
    with pytest.raises(ValueError, match="not even"):
        voxtrace.Volume.from_array(data.assign_coords(x=[0, 1, 2, 4, 8]))

    nibabel = pytest.importorskip("nibabel")
    affine = numpy.diag([2.0, 3.0, 4.0, 1.0])
    affine[:3, 3] = 5, 6, 7
    image = nibabel.Nifti1Image(values, affine)
    nibabel.save(image, tmp_path / "a.nii.gz")
    volume = voxtrace.Volume.from_array(nibabel.load(tmp_path / "a.nii.gz"))
    of_file = voxtrace.open_volume(tmp_path / "a.nii.gz")
    assert volume.affine == of_file.affine and volume.unit == of_file.unit == "mm"
    assert (volume.to_numpy() == of_file.to_numpy()).all()

    simple = pytest.importorskip("SimpleITK")
    image = simple.GetImageFromArray(values.T)
    image.SetSpacing((2, 3, 4))
    image.SetOrigin((-5, -6, 7))
    image.SetDirection((-1, 0, 0, 0, -1, 0, 0, 0, 1))
    simple.WriteImage(image, str(tmp_path / "b.nii.gz"))
    volume = voxtrace.Volume.from_array(image)
    of_file = voxtrace.open_volume(tmp_path / "b.nii.gz")
    assert numpy.allclose(volume.affine, of_file.affine) and (volume.to_numpy() == of_file.to_numpy()).all()

    dask = pytest.importorskip("dask.array")
    assert (voxtrace.Volume.from_array(dask.from_array(values, chunks=3)).to_numpy() == values).all()

    zarr = pytest.importorskip("zarr")
    stored = zarr.create_array(zarr.storage.MemoryStore(), data=values)
    assert (voxtrace.Volume.from_array(stored).to_numpy() == values).all()


def test_a_ball_is_voxelized_where_its_values_are():
    x, y, z = numpy.mgrid[-1:1:41j, -1:1:41j, -1:1:41j]
    volume = voxtrace.Volume.from_array(1 - numpy.sqrt(x * x + y * y + z * z))
    scene = volume.voxelize([(0.5, "#ff0000")] and voxtrace.TransferFunction([(0.5, "#ff0000")]), shell=False)
    expected = numpy.count_nonzero(volume.to_numpy() >= numpy.float32(0.5))
    assert scene.voxels == expected
    assert volume.voxelize("mri", threshold=0.7, shell=False).voxels < expected
    assert volume.voxelize(voxtrace.TransferFunction([(0.5, "#ff0000")])).voxels < expected, "a shell"
    with pytest.raises(voxtrace.VoxtraceError, match="no sample is to be seen"):
        volume.voxelize(voxtrace.TransferFunction([(2, "#ffffff")]))
    with pytest.raises(ValueError, match="ct-bone"):
        volume.voxelize("bone")


def test_labels_are_not_interpolated(random):
    labels = random.integers(0, 3, (10, 10, 10))
    volume = voxtrace.Volume.from_array(labels, labels=True)
    scene = volume.voxelize(voxtrace.TransferFunction.labels({2: "#00ff00"}), shell=False)
    assert scene.voxels == numpy.count_nonzero(labels == 2)


def test_ctrl_c_ends_the_making_of_voxels(ctrl_c_ends):
    x, y, z = numpy.mgrid[-1:1:64j, -1:1:64j, -1:1:64j]
    volume = voxtrace.Volume.from_array(1 - numpy.sqrt(x * x + y * y + z * z))
    # Of a ball little is kept, and what is within is looked at all the same.
    ctrl_c_ends((lambda resolution=resolution: volume.voxelize(threshold=0.5, resolution=resolution)) for resolution in [256, 512, 768, 1024])


def test_ctrl_c_ends_the_making_of_voxels_of_a_mesh(ctrl_c_ends, tmp_path):
    corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    (tmp_path / "a.obj").write_text("".join(f"v {x} {y} {z + x + y}\n" for x, y, z in corners) + "f 1 3 7 5\nf 2 4 8 6\n")
    ctrl_c_ends((lambda resolution=resolution: voxtrace.open(tmp_path / "a.obj", resolution=resolution)) for resolution in [2048, 4096, 8192])
