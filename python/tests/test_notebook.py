"""The widget of notebooks as a page meets it: what it is sent, what it asks, and what it tells."""

import base64
import io

import numpy
import pytest

import voxtrace

pytest.importorskip("anywidget")


class Page:
    """Asks a view as its page does."""

    def __init__(self, view):
        self.view, self.answers = view, []
        view.send = lambda content, buffers=None: self.answers.append((content, buffers))

    def ask(self, **question):
        self.view._asked({**question, "id": str(len(self.answers))}, [])
        content, buffers = self.answers[-1]
        assert content["id"] == str(len(self.answers) - 1)
        return content, buffers[0]

    def scene(self, chunk):
        data = b""
        while True:
            content, part = self.ask(ask="scene", **{"from": len(data)}, length=chunk)
            data += part
            if len(data) >= content["total"]:
                return data


def box(size=(8, 8, 8), palette=None):
    return voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(numpy.ones(size, numpy.uint8), palette=palette))


def test_the_scene_comes_to_the_page_whole_and_traces_to_the_same_film(church):
    page = Page(voxtrace.view(church))
    data = page.scene(chunk=10_000)
    assert data == church.to_bytes() and len(data) > 30_000
    there, here = (voxtrace.render(scene, samples=2, size=(32, 18), denoise=False) for scene in (voxtrace.Scene.from_bytes(data), church))
    assert (there.sums == here.sums).all()
    with pytest.raises(voxtrace.ReadError):
        voxtrace.Scene.from_bytes(data[:-9])


def test_frames_of_the_kernel_become_the_film_of_the_view(church):
    from voxtrace.notebook import _remote

    renderer = voxtrace.Renderer(church, device="cpu")
    camera = renderer.default_camera((48, 27))
    remote = _remote.Remote(renderer)
    remote.rate = 1e4  # a slow machine: the first picture is coarse
    counts, image = [], None
    while not counts or counts[-1] < 7:
        image, samples = remote.next(camera, (96, 54), 7, 3, 8)
        counts.append(samples)
    assert counts[0] == 0 and counts == sorted(set(counts))
    whole = renderer.render(camera, size=(96, 54), samples=7, seed=3, denoise=False)
    assert (image.sums == whole.sums).all()
    # Another view begins anew, and another seed is another film.
    again, samples = remote.next(camera, (96, 54), 7, 4, 8)
    assert samples <= 1
    other = renderer.render(camera, size=(96, 54), samples=7, seed=4, denoise=False)
    assert (other.sums != whole.sums).any()


def test_a_page_that_asks_for_frames_gets_pictures_and_the_camera(church):
    from PIL import Image

    view = voxtrace.view(church, samples=2, renderer="kernel", device="cpu")
    page = Page(view)
    content, picture = page.ask(ask="frame", width=64, height=36, camera=None)
    shown = Image.open(io.BytesIO(picture))
    assert shown.format == "JPEG" and numpy.asarray(shown).std() > 5
    start = voxtrace.Renderer(church).default_camera((64, 36))
    assert content["camera"][:3] == pytest.approx(start.eye)
    for _ in range(4):
        content, picture = page.ask(ask="frame", width=64, height=36, camera=content["camera"])
    assert content["samples"] == 2
    assert Image.open(io.BytesIO(picture)).size == (64, 36)


def test_what_is_picked_in_a_picture_is_what_a_ray_meets(church):
    view = voxtrace.view(church, device="cpu")
    assert view.picked is None
    page = Page(view)
    renderer = voxtrace.Renderer(church, device="cpu")
    camera = renderer.default_camera((160, 90))
    numbers = [*camera.eye, *camera.target, *camera.up, camera.fov]
    depths = renderer.render(camera, size=(160, 90), samples=1, aovs=True, denoise=False)
    for x, y in ((80, 45), (40, 60), (120, 30)):
        content, _ = page.ask(ask="pick", camera=numbers, width=160, height=90, x=x + 0.5, y=y + 0.5)
        voxel = depths.aov("voxel")[y, x]
        assert content["picked"]["voxel"] == voxel.tolist()
        page.ask(ask="picked", picked=content["picked"])
        material = church.materials[view.picked["material"]]
        assert view.picked["instance"] == depths.aov("instance")[y, x, 0]
        expected = voxtrace.VoxelGrid.from_numpy(numpy.ones((1, 1, 1), numpy.uint8), palette=["#000000", material]).to_numpy("rgba")[0, 0, 0, :3]
        assert view.picked["color"] == "#" + "".join(f"{channel:02x}" for channel in expected)
    # The sky beside a box.
    content, _ = Page(voxtrace.view(box())).ask(ask="pick", camera=[40, 4, 4, 4, 4, 4, 0, 0, 1, 45], width=100, height=100, x=2, y=2)
    assert content["picked"] is None
    page.ask(ask="picked", picked=None)
    assert view.picked is None


def test_a_voxel_of_a_volume_has_its_value_and_place():
    x, y, z = numpy.mgrid[0:20, 0:20, 0:20]
    values = (x + 20 * y + 400 * z).astype(numpy.float32)
    affine = [[2, 0, 0, 100], [0, 2, 0, -50], [0, 0, 2, 7], [0, 0, 0, 1]]
    volume = voxtrace.Volume.from_array(values, affine=affine, unit="mm")
    view = voxtrace.view(volume, transfer=voxtrace.TransferFunction([(0, "#ff0000"), (8000, "#00ff00")]))
    page = Page(view)
    # From above onto sample (5, 9, 19), which is the place (110, -32, 45).
    down = numpy.linalg.inv(view.scene.affine) @ [110, -32, 45, 1]
    camera = voxtrace.Camera(down[:3] + [0, 0, 60], down[:3], up=(0, 1, 0))
    content, _ = page.ask(ask="pick", camera=[*camera.eye, *camera.target, *camera.up, 45], width=64, height=64, x=32, y=32)
    page.ask(ask="picked", picked=content["picked"])
    assert view.picked["value"] == values[5, 9, 19] == volume[5, 9, 19]
    assert view.picked["coordinates"] == pytest.approx([110, -32, 45], abs=1.01)
    with pytest.raises(IndexError):
        volume[20, 0, 0]


def test_cameras_go_both_ways():
    view = voxtrace.view(box())
    seen = []
    view.observe(lambda change: seen.append(change["new"]), "camera")
    view.set_state({"_camera": [1, 2, 3, 4, 5, 6, 0, 0, 1, 33]})
    assert view.camera == seen[-1] == voxtrace.Camera((1, 2, 3), (4, 5, 6), fov=33, name=view.camera.name)
    view.camera = voxtrace.Camera((9, 8, 7), (0, 0, 0), fov=50)
    assert view._camera == [9, 8, 7, 0, 0, 0, 0, 0, 1, 50]
    assert len(seen) == 2
    # The lens of the scene stays.
    scene = box()
    scene.cameras = [voxtrace.Camera((50, 50, 50), (0, 0, 0), lens="orthographic", view_height=40)]
    other = voxtrace.view(scene)
    other.set_state({"_camera": [1, 2, 3, 4, 5, 6, 0, 0, 1, 33]})
    assert other.camera.lens == "orthographic"


def test_a_clip_box_cuts_pictures_rays_and_what_is_picked():
    scene = box((16, 16, 16), palette=["#000000", "#ff0000"])
    view = voxtrace.view(scene, device="cpu")
    above = voxtrace.Camera((8, 8, 60), (8, 8, 0), up=(0, 1, 0))
    look = {"camera": [*above.eye, *above.target, *above.up, 45], "width": 9, "height": 9, "x": 4.5, "y": 4.5}
    top = Page(view).ask(ask="pick", **look)[0]["picked"]
    view.clip = ((0, 0, 0), (16, 16, 5))
    cut = Page(view).ask(ask="pick", **look)[0]["picked"]
    assert top["voxel"][2] == 15 and cut["voxel"][2] == 4 and cut["position"][2] == pytest.approx(5, abs=0.01)
    assert scene.clip == ([0, 0, 0], [16, 16, 5])
    view.camera = above
    clipped = view.render(size=(16, 16), samples=1, denoise=False)
    view.clip = None
    assert (clipped.sums != view.render(size=(16, 16), samples=1, denoise=False).sums).any()
    for wrong in (((0, 0, 0), (1, 0, 1)), ((0, 0), (1, 1)), 5):
        with pytest.raises(Exception, match="clip|unpack|iter"):
            view.clip = wrong
    with pytest.raises(ValueError, match="below"):
        scene.clip = ((0, 0, 0), (0, 1, 1))


def test_values_of_a_volume_are_shown_otherwise_and_the_page_gets_another_scene():
    x, y, z = numpy.mgrid[-1:1:32j, -1:1:32j, -1:1:32j]
    volume = voxtrace.Volume.from_array((1 - numpy.sqrt(x * x + y * y + z * z)).astype(numpy.float32))
    view = voxtrace.view(volume)
    about, version, before = view._about, view._version, view.scene.voxels
    edges, counts = volume.histogram()
    assert sum(about["values"]["counts"]) == counts.sum() == volume.shape[0] ** 3 and len(edges) == len(counts) + 1
    assert about["values"]["low"] < volume.threshold < about["values"]["high"]
    view.set_state({"threshold": 0.6})
    assert view._version == version + 1 and view.scene.voxels < before
    view.preset = "hot"
    assert view._version == version + 2
    with pytest.raises(voxtrace.VoxtraceError):
        view.threshold = 5.0
    assert view.problem and view._version == version + 2
    view.threshold = 0.2
    assert view.problem == "" and view.scene.voxels > before / 2


def test_where_widgets_do_not_run_there_is_a_picture(church):
    from PIL import Image

    view = voxtrace.view(church, samples=2)
    data, _ = view._repr_mimebundle_()
    picture = Image.open(io.BytesIO(base64.b64decode(data["image/jpeg"])))
    assert picture.width == 640 and numpy.asarray(picture).std() > 10
    assert "application/vnd.jupyter.widget-view+json" in data
    assert view._poster == base64.b64decode(data["image/jpeg"])


def test_a_page_gets_only_the_files_of_the_package_and_is_told_what_fails():
    page = Page(voxtrace.view(box()))
    for name in ("../_files.py", "/etc/passwd", "nothing.js", ""):
        content, data = page.ask(ask="file", name=name)
        assert "no file" in content["error"] and data == b""
    content, _ = page.ask(ask="frame", width=0, height=0, camera=None)
    assert content["error"]


def test_a_package_without_its_files_for_pages_says_so(monkeypatch, tmp_path):
    from voxtrace.notebook import _files

    monkeypatch.setattr(_files, "FOLDER", tmp_path)
    assert not _files.are_there()
    assert "built without its viewer" in _files.script() and "_poster" in _files.script() and _files.style() == ""
    (tmp_path / "widget.js").write_text("export default {}")
    assert _files.script() == "export default {}" and _files.read("widget.js") == b"export default {}"
