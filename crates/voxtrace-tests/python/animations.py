"""Writes a glTF file whose nodes move, and where scipy says that its vertices and its camera are at many times, for the tests of the importer:
python animations.py FOLDER. Besides what is right, the answers hold what evaluators with a fault would say."""

import base64
import json
import sys
from pathlib import Path

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation, Slerp

folder = Path(sys.argv[1])
random = np.random.default_rng(7)
FLOAT, SHORT = 5126, 5122
binary, views, accessors, samplers, channels = b"", [], [], [], []


def accessor(values, kind, component=FLOAT, **more):
    global binary
    values = np.asarray(values)
    dtype = np.float32 if component == FLOAT else np.int16
    data = values.astype(dtype).tobytes()
    data += b"\0" * (-len(data) % 4)
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
    binary += data
    accessors.append({"bufferView": len(views) - 1, "componentType": component, "count": len(values), "type": kind, **more})
    return len(accessors) - 1


# Three pointed shapes without any symmetry.
SHAPES = [
    [[0, 0, 0], [1, 0, 0], [0, 0.7, 0], [0, 0, 0.4]],
    [[-0.2, 0, 0], [0.6, 0.1, 0], [0, 0.9, 0.2], [0.1, 0, -0.5]],
    [[-4, -0.5, -3], [4, -0.5, -3], [4, -0.4, 3], [-4, -0.5, 3]],
]
meshes = []
for corners in SHAPES:
    corners = np.array(corners, np.float32)
    bounds = {"min": corners.min(0).tolist(), "max": corners.max(0).tolist()}
    faces = np.array([0, 1, 2, 0, 1, 3, 0, 2, 3, 1, 2, 3], np.uint16)
    position, indices = accessor(corners, "VEC3", **bounds), accessor(faces.view(np.int16), "SCALAR", SHORT)
    accessors[-1]["componentType"] = 5123
    meshes.append({"primitives": [{"attributes": {"POSITION": position}, "indices": indices}]})


def quaternion(axis, degrees):
    return Rotation.from_rotvec(np.array(axis) / np.linalg.norm(axis) * np.radians(degrees)).as_quat()


nodes = [
    {"name": "ground", "mesh": 2},
    {"name": "arm", "mesh": 0, "translation": [1, 1, 0], "children": [2, 4]},
    {"name": "offset", "translation": [0.5, 0.2, 0], "rotation": quaternion([1, 2, 0], 40).tolist(), "scale": [0.5, 0.5, 0.5], "children": [3]},
    {"name": "hand", "mesh": 1},
    {"name": "wheel", "mesh": 1, "translation": [1, 0, 0.3], "rotation": quaternion([0, 0, 1], 20).tolist()},
    {"name": "jumper", "mesh": 1, "translation": [-2, 0, 1], "scale": [1, 2, 0.5]},
    {"name": "twin 1", "mesh": 0, "translation": [-3, 0, -2], "scale": [0.8, 0.8, 0.8]},
    {"name": "twin 2", "mesh": 0, "translation": [3, 0, -2], "scale": [0.8, 0.8, 0.8], "rotation": quaternion([1, 1, 0], 80).tolist()},
    {"name": "mirrored", "mesh": 1, "translation": [2, 0, 2], "scale": [-1, 1, 1]},
    {"name": "still", "mesh": 0, "translation": [0, 0, -2.5], "rotation": quaternion([0, 1, 0], 33).tolist()},
    {"name": "crane", "children": [11], "matrix": Rotation.from_euler("y", 30, degrees=True).as_matrix().T.tolist()},
    {"name": "cabin", "translation": [0, 2, 5], "camera": 0, "rotation": quaternion([1, 0, 0], -15).tolist()},
]
turn = np.eye(4)
turn[:3, :3] = np.array(nodes[10]["matrix"]).T
nodes[10]["matrix"] = turn.T.flatten().tolist()

# What moves: node, path, kind, times, values (with tangents for cubic keys).
moves = []


def move(node, path, kind, times, values, component=FLOAT):
    times, values = np.array(times, np.float32), np.array(values)
    if component == SHORT:
        values = np.round(values * 32767)
        output = accessor(values, "VEC4", SHORT, normalized=True)
        values = np.maximum(values / 32767, -1)
    else:
        values = values.astype(np.float32)
        output = accessor(values, f"VEC{values.shape[1]}")
    bounds = {"min": [float(times[0])], "max": [float(times[-1])]}
    sampler = {"input": accessor(times, "SCALAR", **bounds), "output": output}
    samplers.append(sampler if kind == "LINEAR" else {**sampler, "interpolation": kind})
    channels.append({"sampler": len(samplers) - 1, "target": {"node": node, "path": path}})
    moves.append((node, path, kind, times.astype(np.float64), values.astype(np.float64)))


def cubic(values, width):
    """Keys with tangents: in, value, out."""
    return np.stack([random.normal(0, 1.5, (len(values), width)), values, random.normal(0, 1.5, (len(values), width))], 1).reshape(-1, width)


# Turns of 170 degrees, and one key that is the same rotation with the other sign.
far = [quaternion([0, 0, 1], 0), -quaternion([0, 0, 1], 170), quaternion([0, 1, 1], 300), quaternion([1, 0, 0], 90)]
move(1, "rotation", "LINEAR", [0.25, 1, 1.5, 2.5], far)
move(1, "translation", "CUBICSPLINE", [0, 1, 2.25], cubic(np.array([[1, 1, 0], [0, 2, 1], [1, 1.5, -1]]), 3))
move(4, "scale", "LINEAR", [0, 2], [[1, 1, 1], [0.4, 0.4, 0.4]])
move(4, "rotation", "STEP", [0, 0.5, 1.25], [quaternion([0, 0, 1], 20), quaternion([0, 1, 0], 120), quaternion([1, 0, 0], 77)])
move(5, "translation", "STEP", [0.5, 1.5], [[-2, 0, 1], [-2, 1, 0]])
move(5, "rotation", "CUBICSPLINE", [0, 1.2, 2.4], cubic(np.array([quaternion([0, 1, 0], a) for a in [0, 80, 150]]), 4))
move(6, "rotation", "LINEAR", [0, 2], [quaternion([0, 1, 0], 0), quaternion([0, 1, 0], 175)])
move(7, "translation", "LINEAR", [0, 1, 2], [[3, 0, -2], [3, 1, -1], [2, 0, -2]])
move(8, "rotation", "LINEAR", [0, 1, 2], [quaternion([1, 0, 1], a) for a in [0, 90, 200]], SHORT)
move(9, "rotation", "LINEAR", [0, 2], [quaternion([0, 1, 0], 33)] * 2)
move(11, "rotation", "LINEAR", [0, 2], [quaternion([1, 0, 0], -15), quaternion([1, 1, 0], 25)])
move(11, "translation", "LINEAR", [0, 2], [[0, 2, 5], [1, 3, 4]])


def evaluate(kind, path, times, values, t, fault):
    t = min(max(t, times[0]), times[-1])
    key = min(int(np.searchsorted(times, t, side="right")) - 1, len(times) - 1)
    if kind == "STEP" and fault == "steps are straight":
        kind = "LINEAR"
    if kind == "STEP":
        return values[key]
    if kind == "CUBICSPLINE":
        before, value, after = values[0::3], values[1::3], values[2::3]
        if fault == "cubic keys are straight":
            kind, values = "LINEAR", value
        else:
            key = min(key, len(times) - 2)
            out, into = after[key], before[key + 1]
            spline = CubicHermiteSpline(times[key : key + 2], value[key : key + 2], [out, into])
            result = spline(t)
            return result / np.linalg.norm(result) if path == "rotation" else result
    if path == "rotation" and fault != "rotations are mixed evenly":
        return Slerp(times, Rotation.from_quat(values))(t).as_quat()
    result = np.array([np.interp(t, times, values[:, n]) for n in range(values.shape[1])])
    return result / np.linalg.norm(result) if path == "rotation" else result


def worlds(t, fault=None):
    """From the space of each node to the world, at rest where there is no time."""
    maps = [None] * len(nodes)

    def enter(index, outer):
        node = nodes[index]
        pose = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1], **node}
        for own, path, kind, times, values in moves if t is not None else []:
            if own == index:
                pose[path] = evaluate(kind, path, times, values, t, fault)
        local = np.eye(4)
        if "matrix" in node:
            local = np.array(node["matrix"]).reshape(4, 4).T
        else:
            local[:3, :3] = Rotation.from_quat(pose["rotation"]).as_matrix() @ np.diag(pose["scale"])
            local[:3, 3] = pose["translation"]
        maps[index] = outer @ local
        for child in node.get("children", []):
            enter(child, maps[index])

    for root in roots:
        enter(root, np.eye(4))
    return maps


children = {child for node in nodes for child in node.get("children", [])}
roots = [index for index in range(len(nodes)) if index not in children]
# The parts: a node that moves with what it carries; all that stands still is one.
parts = {"arm": [1, 3], "wheel": [4], "jumper": [5], "twin 1": [6], "twin 2": [7], "mirrored": [8], "": [0, 9]}


def places(t, fault=None):
    maps = worlds(t, fault)
    at = {}
    for name, members in parts.items():
        corners = [(maps[index] @ np.append(corner, 1))[:3] for index in members for corner in np.array(SHAPES[nodes[index]["mesh"]], np.float32)]
        at[name] = [[float(x), float(y), float(z)] for x, y, z in corners]
    eye = maps[11] @ [0, 0, 0, 1]
    ahead, up = maps[11] @ [0, 0, -1, 0], maps[11] @ [0, 1, 0, 0]
    return {"parts": at, "eye": eye[:3].tolist(), "ahead": ahead[:3].tolist(), "up": up[:3].tolist()}


times = [0.0, 0.1, 0.25, 0.4, 0.5, 0.62, 0.9, 1.0, 1.1, 1.25, 1.33, 1.5, 1.7, 1.9, 2.0, 2.1, 2.25, 2.3, 2.5, 3.0]
faults = ["rotations are mixed evenly", "cubic keys are straight", "steps are straight"]
rest = np.array([corner for corners in places(None)["parts"].values() for corner in corners])
answers = {
    "min": rest.min(0).tolist(),
    "max": rest.max(0).tolist(),
    "times": times,
    "right": [places(t) for t in times],
    "late": [places(t + 0.04) for t in times],
    "wrong": {fault: [places(t, fault) for t in times] for fault in faults},
}
(folder / "moving.json").write_text(json.dumps(answers))

other = {"name": "other", "samplers": samplers[:1], "channels": [{"sampler": 0, "target": {"node": 9, "path": "rotation"}}]}
document = {
    "asset": {"version": "2.0"},
    "scene": 0,
    "scenes": [{"nodes": roots}],
    "nodes": nodes,
    "meshes": meshes,
    "cameras": [{"type": "perspective", "name": "cabin", "perspective": {"yfov": 0.8, "znear": 0.1}}],
    "animations": [{"name": "work", "samplers": samplers, "channels": channels}, other],
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [{"uri": "data:application/octet-stream;base64," + base64.b64encode(binary).decode(), "byteLength": len(binary)}],
}
(folder / "moving.gltf").write_text(json.dumps(document))
