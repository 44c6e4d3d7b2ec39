"""What travels between processes and is copied: the same again, and what cannot says what to do."""

import copy
import pickle
import struct
import subprocess
import sys
from pathlib import Path

import numpy
import pytest

import voxtrace

#: Ways to another one.
WAYS = {
    "copy": copy.copy,
    "deepcopy": copy.deepcopy,
    **{f"protocol {protocol}": lambda thing, protocol=protocol: pickle.loads(pickle.dumps(thing, protocol)) for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1)},
}

again = pytest.mark.parametrize("again", WAYS.values(), ids=WAYS)


@again
def test_values_are_equal_again(again):
    glow = voxtrace.Material("#ff8800", emission=(4, 2, 0.1), roughness=0.3, metallic=0.2, transmission=0.1, ior=1.33, specular=0.5)
    medium = voxtrace.Material(transmission=1, anisotropy=-0.7, absorption=(0.1, 0, 2), scattering=3)
    for material in [glow, medium, voxtrace.Material()]:
        assert again(material) == material
    assert again(glow) != medium
    camera = voxtrace.Camera((1, 2, 3), (0.1, 0.2, 0.3), up=(0, 1, 0), fov=33, name="ü", lens="thin-lens", aperture=0.5, focus=3.0)
    assert again(camera) == camera
    sky = voxtrace.Sky.gradient((0.1, 0.2, 0.3), "#d8c7a0").with_brightness(1.5)
    for light in [sky, sky.with_sun(bearing=77, height=12, strength=2), voxtrace.Sky.black()]:
        assert again(light) == light
    assert again(sky) != sky.with_sun()


@again
def test_a_panorama_is_the_same_again(again, tmp_path):
    # The simplest of .hdr: rows of pixels as they are.
    picture = numpy.random.default_rng(3).integers(10, 255, (4, 8, 4)).astype("uint8")
    picture[..., 3] = 128
    (tmp_path / "a.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + picture.tobytes())
    sky = voxtrace.Sky.environment(tmp_path / "a.hdr", rotation=30)
    assert again(sky) == sky != voxtrace.Sky.environment(tmp_path / "a.hdr", rotation=31)


@again
def test_grids_are_the_same_again(again, random):
    labels = random.integers(0, 4, (20, 21, 22)).astype("uint8")
    labels[:16, :16, :8] = 2
    labels[0] = 0
    palette = ["#000000", "#ff0000", voxtrace.Material(emission=(1, 2, 3)), "#0000ff"]
    # Also beyond what files hold, and empty ones.
    for array, origin in [(labels, (-3, 5, 7)), (labels, (2**31 - 64, 0, 0)), (0 * labels, (1, 2, 3))]:
        grid = voxtrace.VoxelGrid.from_numpy(array, palette, origin=origin)
        other = again(grid)
        assert (other.to_numpy() == array).all() and other.origin == grid.origin and other.bounds == grid.bounds
        assert other.materials == grid.materials and len(other) == len(grid)
    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(labels, palette))
    found = again(scene.grid(0))
    assert found.bounds == scene.grid(0).bounds and (found.to_numpy() == scene.grid(0).to_numpy()).all()


def test_grids_of_one_label_are_small_when_they_travel():
    grid = voxtrace.VoxelGrid.from_numpy(numpy.ones((64, 64, 64), "uint8"))
    assert len(pickle.dumps(grid)) < 64**3 // 4


@again
def test_volumes_are_the_same_again(again, random):
    values = random.random((5, 6, 7), dtype="float32")
    values[1, 2, 3] = numpy.nan
    affine = [[0, 2, 0, 9], [1, 0, 0, 8], [0, 0, 4, 7], [0, 0, 0, 1]]
    volume = voxtrace.Volume.from_array(values, affine=affine, unit="mm", name="a")
    other = again(volume)
    assert numpy.array_equal(other.to_numpy(), values, equal_nan=True) and other.affine == affine
    assert (other.unit, other.name, repr(other)) == ("mm", "a", repr(volume))
    labels = voxtrace.Volume.from_array(random.integers(0, 3, (9, 9, 9)), labels=True)
    assert again(labels).voxelize(resolution=20).to_bytes() == labels.voxelize(resolution=20).to_bytes()


@again
def test_transfer_functions_are_the_same_again(again):
    for transfer in [voxtrace.TransferFunction([(1, "#ff0000"), (3, "#00ff00")], opacity=0.5), voxtrace.TransferFunction.labels({-7: "#abcdef"})]:
        # The same bytes: they are taken apart in the same parts.
        assert repr(again(transfer)) == repr(transfer) and pickle.dumps(again(transfer)) == pickle.dumps(transfer)


def made(random, place: float) -> voxtrace.Scene:
    """A scene with something of everything, one of whose instances is at this place."""
    labels = random.integers(0, 3, (9, 10, 11)).astype("uint8")
    grid = voxtrace.VoxelGrid.from_numpy(labels, ["#000000", "#ff0000", voxtrace.Material(emission=(1, 2, 3))])
    scene = voxtrace.Scene(grid, name="made")
    move = numpy.eye(4)
    move[:3, 3] = 30, 0, 0
    scene.add_copy(0, move, name="second")
    move[0, 3] = place
    scene.add(voxtrace.VoxelGrid.from_numpy(numpy.ones((3, 4, 5), bool), ["#00ff00"]), move, name="third")
    scene.add(voxtrace.VoxelGrid.from_numpy(numpy.zeros((3, 4, 5), bool)), name="empty")
    scene.sky = voxtrace.Sky.uniform((1, 2, 3)).with_sun()
    scene.light_intensity = 2.5
    scene.cameras = [voxtrace.Camera((1, 2, 3), (0, 0, 0), name="a"), voxtrace.Camera((4, 5, 6), (0, 0, 0), lens="fisheye")]
    return scene


def told(scene: voxtrace.Scene) -> list[object]:
    """All that a scene says of itself."""
    parts = [(part.name, part.grid, part.transform, part.hidden, part.layer) for part in scene.instances]
    values = [scene.name, scene.materials, scene.sky, scene.light_intensity, scene.cameras, scene.clip, scene.affine, scene.notes, scene.voxels]
    return [*values, parts, scene.bounds, scene.info(), scene.to_bytes()]


@again
def test_scenes_are_the_same_again(again, random, tmp_path, church):
    # Between the voxels of the lattice on which the others stand.
    own = made(random, 60.25)
    made(random, 60).save(tmp_path / "a.vox")
    own.clip = ((1, 2, 3), (20, 20, 9))
    of_volume = voxtrace.Volume.from_array(random.random((9, 9, 9)), spacing=0.5, unit="mm").voxelize()
    packed = voxtrace.Scene.from_bytes(own.to_bytes())
    packed.clip = own.clip
    of_file = voxtrace.open(tmp_path / "a.vox")
    for scene in [own, of_volume, packed, of_file, church, voxtrace.Scene()]:
        other = again(scene)
        assert told(other) == told(scene), scene.name
        if scene.materials:
            other.set_material(0, voxtrace.Material("#123456"))
        else:
            other.add(own.grid(0))
        assert told(other) != told(scene), "each is of its own"
    # What only the format knows that it came from is kept too.
    for scene, name in [(of_file, "b.vox"), (again(of_file), "c.vox")]:
        scene.save(tmp_path / name)
    assert (tmp_path / "b.vox").read_bytes() == (tmp_path / "c.vox").read_bytes()


def write_moving(path: Path) -> None:
    """A MagicaVoxel file of two models: one instance moves and shows the one after the other, another one is hidden, as its layer is."""

    def number(value: int) -> bytes:
        return struct.pack("<i", value)

    def text(words: str) -> bytes:
        return number(len(words)) + words.encode()

    def attributes(**values: str) -> bytes:
        return number(len(values)) + b"".join(text(name) + text(value) for name, value in values.items())

    def chunk(name: bytes, content: bytes, children: bytes = b"") -> bytes:
        return name + number(len(content)) + number(len(children)) + content + children

    def transform(node: int, child: int, layer: int, frames: list[bytes], **values: str) -> bytes:
        ends = number(child) + number(-1) + number(layer) + number(len(frames)) + b"".join(frames)
        return chunk(b"nTRN", number(node) + attributes(**values) + ends)

    def shape(node: int, *models: int) -> bytes:
        shown = b"".join(number(model) + attributes(_f=str(5 * model)) for model in models)
        return chunk(b"nSHP", number(node) + attributes() + number(len(models)) + shown)

    chunks = []
    for model in (0, 1):
        chunks += [chunk(b"SIZE", struct.pack("<3i", 2 + model, 3, 4)), chunk(b"XYZI", number(2) + bytes([0, 0, 0, 1, 1, 2, 3, 2 + model]))]
    chunks += [transform(0, 1, -1, [attributes()]), chunk(b"nGRP", number(1) + attributes() + number(2) + number(2) + number(4))]
    chunks += [transform(2, 3, 0, [attributes(_f="0", _t="0 0 0"), attributes(_f="5", _t="9 0 0")], _name="moves"), shape(3, 0, 1)]
    chunks += [transform(4, 5, 1, [attributes(_t="0 20 0")], _name="away", _hidden="1"), shape(5, 0)]
    chunks += [chunk(b"LAYR", number(1) + attributes(_name="back", _hidden="1") + number(-1))]
    path.write_bytes(b"VOX " + number(200) + chunk(b"MAIN", b"", b"".join(chunks)))


@again
def test_what_a_file_moves_and_hides_is_kept(again, tmp_path):
    write_moving(tmp_path / "a.vox")
    scene = voxtrace.open(tmp_path / "a.vox")
    other = again(scene)
    assert told(other) == told(scene)
    # One grid of two instances.
    assert [(part.name, part.grid, part.hidden, part.layer) for part in other.instances] == [("moves", 0, False, None), ("away", 0, True, "back")]
    other.save(tmp_path / "b.vox")
    assert (tmp_path / "b.vox").read_bytes() == (tmp_path / "a.vox").read_bytes()
    # Also that which nothing shows.
    assert (other.grid(1).to_numpy() == scene.grid(1).to_numpy()).all()


@again
def test_pictures_stay_without_their_noise(again, church):
    image = voxtrace.render(church, samples=3, size=(24, 16), device="cpu", aovs=True)
    other = again(image)
    assert (other.radiance == image.radiance).all() and (other.noisy == image.noisy).all() and (other.radiance != other.noisy).any()
    assert other.to_bytes() == image.to_bytes() and other.device == image.device and (other.to_srgb() == image.to_srgb()).all()
    noisy = voxtrace.render(church, samples=3, size=(24, 16), device="cpu", denoise=False)
    assert (again(noisy).radiance == noisy.radiance).all() and (noisy.radiance == image.noisy).all()
    # Of the scene that went along with it.
    assert (again(noisy).denoise(again(church)).radiance == noisy.denoise(church).radiance).all()


@again
def test_instances_and_errors_are_the_same_again(again, church, tmp_path):
    instance = church.instances[0]
    assert repr(again(instance)) == repr(instance) and again(instance).transform == instance.transform
    (tmp_path / "a.docx").write_bytes(b"hello")
    with pytest.raises(voxtrace.ReadError) as info:
        voxtrace.open(tmp_path / "a.docx")
    error = again(info.value)
    assert (type(error), str(error), error.path, error.hint) == (voxtrace.ReadError, str(info.value), info.value.path, info.value.hint)


@again
def test_what_holds_a_device_says_what_travels(again, church):
    with pytest.raises(TypeError, match="make one where it is needed, of a Scene"):
        again(voxtrace.Renderer(church, device="cpu"))
    with pytest.raises(TypeError, match=r"Editor\.scene\(\)"):
        again(voxtrace.Editor(church))


def test_another_process_makes_the_same_of_it(church, tmp_path):
    (tmp_path / "scene").write_bytes(pickle.dumps(church))
    script = """if True:
        import pickle, sys, voxtrace
        with open(sys.argv[1], "rb") as file:
            scene = pickle.load(file)
        image = voxtrace.render(scene, samples=2, size=(16, 9), device="cpu", progress=False)
        with open(sys.argv[2], "wb") as file:
            pickle.dump(image, file)
    """
    subprocess.run([sys.executable, "-c", script, tmp_path / "scene", tmp_path / "image"], check=True, timeout=600)
    image = pickle.loads((tmp_path / "image").read_bytes())
    here = voxtrace.render(church, samples=2, size=(16, 9), device="cpu", progress=False)
    assert (image.radiance == here.radiance).all() and image.to_bytes() == here.to_bytes()


def test_what_is_no_pickle_of_ours_is_refused():
    make, parts = voxtrace.VoxelGrid.from_numpy(numpy.ones((9, 9, 9), "uint8")).__reduce__()
    for broken in [b"", b"\x02" + parts[0][1:], parts[0][:-1], parts[0][:50]]:
        with pytest.raises(ValueError, match="no voxels"):
            make(broken, *parts[1:])
    make, (film, device, (name, radiance)) = voxtrace.render(
        voxtrace.builtin("church", voxels=20_000), samples=1, size=(8, 4), device="cpu"
    ).__reduce__()
    with pytest.raises(ValueError, match="other pixels"):
        make(film, device, (name, radiance[:-1]))
    with pytest.raises(voxtrace.ReadError):
        make(b"no film", device, None)
