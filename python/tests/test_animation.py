"""Scenes that move: keyframes of `.vox` files, nodes, cameras and shapes of glTF files, and a renderer that shows one frame after the other."""

import base64
import copy
import json
import pickle
import struct

import numpy
import pytest

import voxtrace

CUBE = numpy.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], "<f4")
FACES = numpy.array(
    [[0, 2, 1], [1, 2, 3], [4, 5, 6], [5, 7, 6], [0, 1, 4], [1, 5, 4], [2, 6, 3], [3, 6, 7], [0, 4, 2], [2, 4, 6], [1, 3, 5], [3, 7, 5]], "<u2"
)


class Document:
    """A glTF file of one buffer, written accessor by accessor."""

    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, array, kind):
        array = numpy.ascontiguousarray(array)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": array.nbytes})
        rows = array.reshape(len(array), -1)
        self.accessors.append(
            {
                "bufferView": len(self.views) - 1,
                "componentType": {"<f4": 5126, "<u2": 5123}[array.dtype.str],
                "count": len(array),
                "type": kind,
                "min": rows.min(axis=0).tolist(),
                "max": rows.max(axis=0).tolist(),
            }
        )
        self.bytes += array.tobytes() + b"\0" * (-array.nbytes % 4)
        return len(self.accessors) - 1

    def write(self, path, **rest):
        uri = "data:application/octet-stream;base64," + base64.b64encode(self.bytes).decode()
        buffers = [{"byteLength": len(self.bytes), "uri": uri}]
        whole = {"asset": {"version": "2.0"}, "buffers": buffers, "bufferViews": self.views, "accessors": self.accessors}
        path.write_text(json.dumps(whole | rest))
        return path


@pytest.fixture
def moving(tmp_path):
    """A cube that goes 8 units along x in two seconds with a camera on it, one beside it that stands, and an animation in which that one grows by a morph target."""
    document = Document()
    positions, indices = document.add(CUBE, "VEC3"), document.add(FACES, "SCALAR")
    taller = document.add(numpy.where(CUBE[:, 1:2] > 0, [[0, 3, 0]], 0).astype("<f4"), "VEC3")
    times = document.add(numpy.array([0, 2], "<f4"), "SCALAR")
    way = document.add(numpy.array([[0, 0, 0], [8, 0, 0]], "<f4"), "VEC3")
    weights = document.add(numpy.array([0, 1], "<f4"), "SCALAR")
    primitive = {"attributes": {"POSITION": positions}, "indices": indices}
    sampler = {"input": times, "interpolation": "LINEAR"}
    document.accessors[indices]["count"] = FACES.size
    return document.write(
        tmp_path / "moving.gltf",
        scenes=[{"nodes": [0, 1]}],
        nodes=[
            {"mesh": 0, "name": "goes", "children": [2]},
            {"mesh": 1, "name": "grows", "translation": [0, 0, 4]},
            {"camera": 0, "name": "rider", "translation": [0, 0, 9]},
        ],
        cameras=[{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
        meshes=[{"primitives": [primitive]}, {"primitives": [primitive | {"targets": [{"POSITION": taller}]}], "weights": [0]}],
        animations=[
            {"name": "go", "samplers": [sampler | {"output": way}], "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}]},
            {"name": "grow", "samplers": [sampler | {"output": weights}], "channels": [{"sampler": 0, "target": {"node": 1, "path": "weights"}}]},
        ],
    )


def chunk(name, content, children=b""):
    return struct.pack("<4sii", name, len(content), len(children)) + content + children


def text(words):
    return struct.pack("<i", len(words)) + words.encode()


def words(pairs):
    return struct.pack("<i", len(pairs)) + b"".join(text(key) + text(value) for key, value in pairs.items())


@pytest.fixture
def stepping(tmp_path):
    """A `.vox` file of one voxel that is at x = 0 in frame 0 and at x = 20 in frame 4."""
    frames = [{"_f": "0", "_t": "0 0 0"}, {"_f": "4", "_t": "20 0 0"}]
    root = struct.pack("<i", 0) + words({}) + struct.pack("<iiii", 1, -1, -1, 1) + words({})
    moved = struct.pack("<i", 2) + words({}) + struct.pack("<iiii", 3, -1, -1, 2) + b"".join(map(words, frames))
    group = struct.pack("<i", 1) + words({}) + struct.pack("<ii", 1, 2)
    shape = struct.pack("<i", 3) + words({}) + struct.pack("<ii", 1, 0) + words({})
    model = chunk(b"SIZE", struct.pack("<iii", 1, 1, 1)) + chunk(b"XYZI", struct.pack("<i4B", 1, 0, 0, 0, 1))
    nodes = chunk(b"nTRN", root) + chunk(b"nGRP", group) + chunk(b"nTRN", moved) + chunk(b"nSHP", shape)
    path = tmp_path / "stepping.vox"
    path.write_bytes(b"VOX " + struct.pack("<i", 200) + chunk(b"MAIN", b"", model + nodes))
    return path


def middle(scene):
    low, high = scene.bounds
    return (numpy.array(low) + high) / 2


def test_keyframes_of_a_vox_file_play(stepping):
    scene = voxtrace.open(stepping, animation=True)
    assert (scene.keyframes, scene.animations, scene.notes) == (5, [], [])
    first = middle(scene)
    assert [float((middle(scene.at(seconds)) - first)[0]) for seconds in (0, 0.2, 0.4, 9)] == [0, 10, 20, 20]
    assert (middle(scene.at(0.2, key_fps=20)) - first).tolist() == [20, 0, 0]
    assert (middle(scene.at(0.2, key_fps=0)) - first).tolist() == [0, 0, 0], "no keyframe ever comes"
    assert (middle(scene) - first).tolist() == [0, 0, 0], "the scene itself stays as it is"
    then = scene.at(0.2)
    assert then.keyframes == 0 and middle(then.at(5)).tolist() == middle(then).tolist(), "it stands still from then on"
    assert middle(pickle.loads(pickle.dumps(then))).tolist() == middle(then).tolist()


def test_nodes_and_cameras_of_a_gltf_file_play(moving):
    assert voxtrace.open(moving, voxel_size=0.5).animations == [("go", 2.0), ("grow", 2.0)]
    scene = voxtrace.open(moving, voxel_size=0.5, animation=True)
    place = lambda scene: {instance.name: instance.transform[0][3] for instance in scene.instances}
    eye = lambda scene: scene.cameras[0].eye[0]
    rest, names = place(scene), {instance.name for instance in scene.instances}
    assert "goes" in names
    for seconds, way in [(0, 0), (0.5, 4), (1, 8), (2, 16), (7, 16)]:
        then = scene.at(seconds)
        gone = {name: place(then)[name] - rest[name] for name in names}
        assert gone == pytest.approx({name: way if name == "goes" else 0 for name in names}), seconds
        assert eye(then) - eye(scene) == pytest.approx(way), "the camera rides on it"
    assert eye(scene.at(2.5, repeat=True)) - eye(scene) == pytest.approx(4)
    assert eye(voxtrace.open(moving, voxel_size=0.5).at(1)) == eye(scene), "nobody asked for an animation"


def test_shapes_of_a_gltf_file_play(moving):
    # Its morph target grows along y of the file, which is up here.
    height = lambda scene: scene.bounds[1][2] - scene.bounds[0][2]
    for chosen in ("grow", 2):
        scene = voxtrace.open(moving, voxel_size=0.125, animation=chosen, key_fps=4)
        heights = [height(scene.at(seconds)) for seconds in (0, 0.25, 0.49, 1, 1.99)]
        assert heights[0] == height(scene) and heights[1] == heights[2], "a shape is seen until the next one"
        assert heights == sorted(heights) and heights[3] == pytest.approx(heights[0] * 2.5, abs=1.1)
    still = voxtrace.open(moving, voxel_size=0.125, animation="grow", key_fps=0)
    assert height(still.at(1)) == height(still), "no shapes were made"


def test_a_renderer_shows_one_frame_after_the_other(moving):
    scene = voxtrace.open(moving, voxel_size=0.25, animation="go")
    options = dict(samples=2, size=(32, 18), denoise=False)
    renderer = voxtrace.Renderer(scene, device="cpu")
    at_rest = renderer.render(**options).sums
    for seconds in (0.5, 2):
        then = scene.at(seconds)
        renderer.show(then)
        camera = renderer.default_camera((32, 18))
        assert camera.eye == then.cameras[0].eye
        shown = renderer.render(**options).sums
        assert (shown == voxtrace.Renderer(then, device="cpu").render(**options).sums).all()
    assert (shown != at_rest).any()
    renderer.show(scene)
    assert (renderer.render(**options).sums == at_rest).all()
    editor = voxtrace.Editor(copy.copy(scene))
    follower = voxtrace.Renderer(editor, device="cpu")
    follower.show(scene)
    with pytest.raises(ValueError, match="not made of this editor"):
        follower.follow(editor)


def test_what_cannot_be_played_is_told(moving, stepping, tmp_path):
    with pytest.raises(ValueError, match='there is no animation "run".*"go", "grow"'):
        voxtrace.open(moving, animation="run")
    with pytest.raises(ValueError, match='"3"'):
        voxtrace.open(moving, animation=3)
    with pytest.raises(ValueError, match="no animation"):
        voxtrace.open(stepping, animation="go")
    with pytest.raises(ValueError, match="a name, a number"):
        voxtrace.open(moving, animation=[1])
    with pytest.raises(ValueError, match="key_fps"):
        voxtrace.open(moving, animation=True, key_fps=-1)
    scene = voxtrace.open(stepping)
    for wrong in [dict(seconds=-1), dict(seconds=float("nan")), dict(seconds=1, key_fps=float("inf"))]:
        with pytest.raises(ValueError, match="≥ 0"):
            scene.at(**wrong)
    scene.save(tmp_path / "still.vxt")
    kept = voxtrace.open(tmp_path / "still.vxt")
    assert (kept.keyframes, kept.animations) == (0, []) and middle(kept.at(3)).tolist() == middle(scene).tolist()
