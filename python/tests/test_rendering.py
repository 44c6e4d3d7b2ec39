"""Pictures: the same bytes as the command line's, and how one waits for them."""

import os
import signal
import threading
import time

import numpy
import pytest

import voxtrace


def test_films_are_those_of_the_command_line_byte_for_byte(tmp_path, run, church):
    run("convert", "church", "--voxels", 20_000, tmp_path / "church.vxt")
    options = ["--traversal", "cpu", "--size", "48x27", "--spp", 3, "--seed", 5]
    run("render", tmp_path / "church.vxt", "-o", tmp_path / "a.vxf", *options)
    scene = voxtrace.open(tmp_path / "church.vxt")
    image = voxtrace.render(scene, samples=3, size=(48, 27), seed=5, device="cpu", denoise=False)
    image.save(tmp_path / "b.vxf")
    assert (tmp_path / "a.vxf").read_bytes() == (tmp_path / "b.vxf").read_bytes()
    image = voxtrace.render(scene, samples=3, size=(48, 27), seed=6, device="cpu", denoise=False)
    image.save(tmp_path / "c.vxf")
    assert (tmp_path / "a.vxf").read_bytes() != (tmp_path / "c.vxf").read_bytes(), "another seed is another film"


def test_devices_give_the_same_sums(church):
    options = {"samples": 2, "size": (48, 27), "denoise": False}
    try:
        device = voxtrace.Renderer(church, device="0")
    except voxtrace.DeviceError:
        if os.environ.get("VOXTRACE_REQUIRE_VULKAN"):
            raise
        pytest.skip("no Vulkan device")
    of_device = device.render(**options)
    of_processor = voxtrace.Renderer(church, device="cpu").render(**options)
    assert (of_device.sums == of_processor.sums).all()
    assert "tracing on" in of_device.device


def test_films_of_parts_add_up(church):
    renderer = voxtrace.Renderer(church, device="cpu")
    size = (40, 30)
    whole = renderer.render(samples=5, size=size, denoise=False).sums
    first = renderer.render(samples=2, size=size, denoise=False).sums
    second = renderer.render(samples=3, first_sample=2, size=size, denoise=False).sums
    assert (first + second == whole).all() and (first != second).any()
    denoised = [renderer.render(samples=5, size=size).to_bytes() for _ in range(2)]
    assert denoised[0] == denoised[1] == voxtrace.render(church, samples=5, size=size, device="cpu").to_bytes()
    part = renderer.render(samples=5, size=size, region=(10, 5, 30, 25), denoise=False).sums
    assert (part == whole[5:25, 10:30]).all()


def test_a_picture_is_arrays_and_files(tmp_path, church):
    image = voxtrace.render(church, samples=4, size=(64, 36), aovs=True, device="cpu")
    assert image.shape == (36, 64) and image.radiance.shape == image.noisy.shape == (36, 64, 3)
    assert image.alpha.min() >= 0 and image.alpha.max() == 1
    assert (image.radiance != image.noisy).any(), "noise was removed"
    assert image.noisy == pytest.approx(image.sums / 2**32 / 4, rel=1e-5)
    shown = image.to_srgb()
    assert shown.dtype == "uint8" and (numpy.asarray(image) == shown).all()
    brighter = image.to_srgb(exposure=1)
    assert brighter.mean() > shown.mean()
    for name in ["a.png", "a.exr", "a.vxf"]:
        image.save(tmp_path / name)
    from PIL import Image

    assert numpy.abs(numpy.asarray(Image.open(tmp_path / "a.png")).astype(int)[..., :3] - shown).max() == 0
    png = image._repr_png_()
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    normals, depth = image.aov("normal"), image.aov("depth")
    met = depth[..., 0] > 0
    assert numpy.linalg.norm(normals[met], axis=1) == pytest.approx(1)
    assert ((image.aov("instance")[..., 0] != 2**32 - 1) == met).all()
    with pytest.raises(ValueError, match="png"):
        image.save(tmp_path / "a.jpeg")
    with pytest.raises(OSError):
        image.save(tmp_path / "nowhere" / "a.png")
    assert repr(image) == "<Image: 64 × 36, 4 samples>"


def test_a_sun_and_a_camera_change_the_picture():
    scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(numpy.ones((8, 8, 2), bool)))
    camera = voxtrace.Camera((4, 4, 40), (4, 4, 0), up=(0, 1, 0), fov=20)
    options = {"samples": 16, "size": (16, 16), "device": "cpu", "denoise": False}
    scene.sky = voxtrace.Sky.black()
    assert voxtrace.render(scene, camera, **options).radiance.max() == 0
    scene.sky = voxtrace.Sky.uniform((0.5, 0.5, 0.5))
    # A matte surface of reflectance 0.8 under an even sky.
    middle = voxtrace.render(scene, camera, **options).radiance[8, 8]
    assert middle == pytest.approx(0.4, rel=0.02)
    scene.sky = scene.sky.with_sun(bearing=0, height=90, strength=2)
    assert voxtrace.render(scene, camera, **options).radiance[8, 8, 0] > 0.8
    assert voxtrace.render(scene, voxtrace.Camera((4, 4, 40), (4, 4, 80)), **options).alpha.max() == 0


def test_who_waits_is_told(church):
    shares = []
    voxtrace.render(church, samples=24, size=(320, 180), device="cpu", denoise=False, progress=shares.append)
    assert shares[-1] == 1 and shares == sorted(shares) and len(shares) > 1

    def refuses(share: float) -> None:
        raise KeyError("enough")

    with pytest.raises(KeyError, match="enough"):
        voxtrace.render(church, samples=10**6, size=(320, 180), device="cpu", progress=refuses)


def test_ctrl_c_ends_a_long_render(church):
    def interrupt() -> None:
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGINT)

    # Whoever starts tests in the background may have turned it off.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    start = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            threading.Thread(target=interrupt).start()
            voxtrace.render(church, samples=10**7, size=(640, 360), device="cpu", progress=False)
    finally:
        signal.signal(signal.SIGINT, before)
    # All samples would take days.
    assert time.monotonic() - start < 300


def test_ctrl_c_ends_the_writing_of_a_picture_and_leaves_the_old_file(church, ctrl_c_ends, tmp_path):
    renderer, path = voxtrace.Renderer(church, device="cpu"), tmp_path / "church.exr"

    def saves():
        for width in [2000, 4000]:
            image = renderer.render(samples=1, size=(width, width // 2), max_bounces=0, denoise=False, aovs=True)

            def save():
                path.write_bytes(b"old")
                image.save(path)

            yield save

    ctrl_c_ends(saves())
    assert path.read_bytes() == b"old" and list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("filter", ["voxtrace", "oidn"])
def test_ctrl_c_ends_the_removal_of_noise(church, ctrl_c_ends, filter):
    if filter == "oidn":
        pytest.importorskip("pyoidn")
    renderer = voxtrace.Renderer(church, device="cpu")

    def noisy():
        # What takes long is to cast the camera rays of all samples once more.
        for samples in [64, 256, 1024, 4096]:
            image = renderer.render(samples=samples, size=(320, 180), max_bounces=0, denoise=False)
            yield lambda: image.denoise(church, filter)

    ctrl_c_ends(noisy())


def test_other_threads_run_meanwhile(church):
    count = 0
    ended = threading.Event()

    def counts() -> None:
        nonlocal count
        while not ended.is_set():
            count += 1
            time.sleep(0.001)

    thread = threading.Thread(target=counts)
    thread.start()
    meanwhile = 0
    # A quick machine and a busy one need more samples.
    for samples in [48, 192, 768, 3072]:
        before = count
        voxtrace.render(church, samples=samples, size=(320, 180), device="cpu", progress=False)
        meanwhile = count - before
        if meanwhile > 20:
            break
    ended.set()
    thread.join()
    assert meanwhile > 20


@pytest.mark.parametrize(
    ("options", "says"),
    [
        ({"size": (0, 5)}, "frame cannot be rendered|region"),
        ({"size": (60_000, 60_000)}, "render regions"),
        ({"size": (70_000, 70_000), "region": (0, 0, 8, 8)}, "2³²"),
        ({"samples": 0}, "samples is a whole number from 1 to 4294967295, not 0"),
        ({"camera": "nobody"}, "there are: nave"),
        ({"max_bounces": 65_536}, "max_bounces is a whole number from 0 to 65535, not 65536"),
        ({"region": (5, 5, 5, 9)}, "region is"),
        ({"integrator": "rays"}, "neither"),
    ],
)
def test_what_cannot_be_rendered_is_said(church, options, says):
    with pytest.raises(ValueError, match=says):
        voxtrace.render(church, device="cpu", **{"size": (16, 9), "samples": 1, **options})


#: Beyond all numbers that there is room for.
BEYOND = 2**70


@pytest.mark.parametrize("number", [-1, numpy.int64(-7), BEYOND, -BEYOND], ids=str)
def test_numbers_that_there_is_no_room_for_are_told_by_their_names(church, tmp_path, number):
    renderer = voxtrace.Renderer(church, device="cpu")
    film = renderer.render(samples=1, size=(8, 4), denoise=False)
    volume = voxtrace.Volume.from_array(numpy.mgrid[0:4, 0:4, 0:4].sum(0))
    (tmp_path / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    render = lambda **options: renderer.render(**{"samples": 1, "size": (8, 4), **options})
    calls = {
        "samples": [lambda: render(samples=number), lambda: renderer.render_like(film, samples=number)],
        "seed": [lambda: render(seed=number)],
        "max_bounces": [lambda: render(max_bounces=number)],
        "first_sample": [lambda: render(first_sample=number), lambda: renderer.render_like(film, samples=1, first_sample=number)],
        "the width of size": [lambda: render(size=(number, 4)), lambda: renderer.default_camera((number, 4))],
        "the height of size": [lambda: render(size=(8, number)), lambda: renderer.default_camera().ray((1, 2), (8, number))],
        "x0 of region": [lambda: render(region=(number, 0, 4, 4))],
        "y1 of region": [lambda: renderer.render_like(film, samples=1, region=(0, 0, 4, number))],
        "memory": [lambda: voxtrace.Renderer(church, device="cpu", memory=number)],
        "resolution": [lambda: voxtrace.open(tmp_path / "a.obj", resolution=number), lambda: volume.voxelize(resolution=number)],
        "channel": [lambda: voxtrace.open(tmp_path / "a.nii", channel=number), lambda: voxtrace.open_volume(tmp_path / "a.nii", channel=number)],
        "time": [lambda: voxtrace.open(tmp_path / "a.nii", time=number), lambda: voxtrace.open_volume(tmp_path / "a.nii", time=number)],
        "voxels": [lambda: voxtrace.builtin("city", voxels=number)],
        "instances": [lambda: voxtrace.builtin("forest", instances=number)],
    }
    for name, made in calls.items():
        for call in made:
            with pytest.raises(ValueError, match=f"^{name} is a whole number from [01] to [0-9]+, not {number}(\n|$)"):
                call()
    if abs(number) == BEYOND:
        with pytest.raises(ValueError, match=f"^series is a whole number from -[0-9]+ to [0-9]+, not {number}"):
            voxtrace.open_volume(tmp_path / "a.nii", series=number)
        with pytest.raises(ValueError, match=f"a label is a whole number from -[0-9]+ to [0-9]+, not {number}"):
            voxtrace.TransferFunction.labels({number: "#ffffff"})
        editor = voxtrace.Editor(church)
        for edit in [lambda: editor.fill((0, 0, 0), (1, 1, 1), number), lambda: editor.replace(0, number), lambda: editor.set([[0, 0, 0]], number)]:
            with pytest.raises(voxtrace.VoxtraceError, match=f"there is no material {number}"):
                edit()
        assert editor.get((0, 0, 0), grid=number) is None
    # What is no number at all is another fault.
    with pytest.raises(TypeError):
        render(samples="many")


def test_parts_of_a_picture_that_is_too_large_are_rendered(church):
    renderer = voxtrace.Renderer(church, device="cpu")
    part = renderer.render(samples=1, size=(60_000, 60_000), region=(30_000, 20_000, 30_008, 20_004))
    assert part.shape == (4, 8)
    film = voxtrace.Image.from_bytes(part.to_bytes())
    with pytest.raises(ValueError, match="render regions"):
        renderer.render_like(film, samples=1, region=(0, 0, 60_000, 60_000))
    assert renderer.render_like(film, samples=1, first_sample=1).shape == (4, 8)


def test_devices_that_are_not_there_are_said(church):
    with pytest.raises(voxtrace.DeviceError, match="no such card"):
        voxtrace.Renderer(church, device="no such card")


def test_open_image_denoise_of_the_extra_takes_noise_away(church):
    pytest.importorskip("pyoidn")
    options = {"size": (96, 54), "device": "cpu", "denoise": False}
    noisy = voxtrace.render(church, samples=4, **options)
    truth = voxtrace.render(church, samples=256, seed=1, **options).to_srgb().astype(float)
    clean = noisy.denoise(church, "oidn")
    error = lambda image: numpy.sqrt(numpy.mean((image.to_srgb() - truth) ** 2))
    assert error(clean) < 0.7 * error(noisy)
    assert (clean.sums == noisy.sums).all() and (clean.radiance != noisy.denoise(church).radiance).any()
    with pytest.raises(ValueError, match="neither"):
        noisy.denoise(church, "median")


def test_without_open_image_denoise_one_is_told_how_to_get_it(church, monkeypatch, tmp_path):
    monkeypatch.setenv("VOXTRACE_OIDN", str(tmp_path))
    with pytest.raises(voxtrace.VoxtraceError, match="the extra `denoise`"):
        voxtrace.render(church, samples=1, size=(8, 8), device="cpu").denoise(church, "oidn")
