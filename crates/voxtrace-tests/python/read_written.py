"""Says what other programs' libraries read in files that voxtrace wrote: python read_written.py FOLDER

Answers in JSON: of meshes the extent, the volume, the area and the mean colour by area, of a schematic the blocks by their names and places.
"""

import json
import sys
from pathlib import Path

import nbtlib
import numpy as np
import trimesh

folder = Path(sys.argv[1])
answer = {}



def colors_of(mesh):
    """The colour of each face, 0 to 255: of vertices, also beside a material, or of the material."""
    visual = mesh.visual
    beside = getattr(visual, "vertex_attributes", {}).get("color") if hasattr(visual, "vertex_attributes") else None
    if beside is not None:
        most = np.iinfo(beside.dtype).max if beside.dtype.kind == "u" else 1
        return (np.asarray(beside, float)[:, :3] * 255 / most)[mesh.faces].mean(axis=1)
    if isinstance(visual, trimesh.visual.TextureVisuals):
        return np.tile(np.asarray(visual.material.main_color, float)[:3], (len(mesh.faces), 1))
    return np.asarray(visual.face_colors, float)[:, :3]


for name in ["scene.glb", "scene.obj", "scene.ply"]:
    loaded = trimesh.load(folder / name, process=False)
    parts, colors = [loaded], None
    if isinstance(loaded, trimesh.Scene):
        placed = [loaded.graph[node] for node in loaded.graph.nodes_geometry]
        colors = np.concatenate([colors_of(loaded.geometry[geometry]) for _, geometry in placed])
        parts = [loaded.geometry[geometry].copy().apply_transform(place) for place, geometry in placed]
    else:
        colors = colors_of(loaded)
    low = np.min([part.bounds[0] for part in parts], axis=0)
    high = np.max([part.bounds[1] for part in parts], axis=0)
    areas = np.concatenate([part.area_faces for part in parts])
    answer[name] = {
        "low": low.tolist(),
        "high": high.tolist(),
        "volume": float(sum(part.volume for part in parts)),
        "area": float(areas.sum()),
        "color": (colors * areas[:, None]).sum(axis=0).tolist(),
    }

tags = nbtlib.load(folder / "scene.schem")
width, height, length = (int(tags[name]) for name in ["Width", "Height", "Length"])
names = {int(number): name for name, number in tags["Palette"].items()}
data, blocks, at, place = bytes(np.array(tags["BlockData"]).astype(np.uint8)), {}, 0, 0
while at < len(data):
    number, shift = 0, 0
    while True:
        byte = data[at]
        number |= (byte & 0x7F) << shift
        shift += 7
        at += 1
        if byte < 0x80:
            break
    if names[number] != "minecraft:air":
        x, z, y = place % width, place // width % length, place // (width * length)
        blocks[f"{x} {y} {z}"] = names[number]
    place += 1
assert place == width * height * length, (place, width, height, length)
answer["scene.schem"] = {"version": int(tags["Version"]), "blocks": blocks}

json.dump(answer, sys.stdout)
