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

for name in ["scene.glb", "scene.obj", "scene.ply"]:
    mesh = trimesh.load(folder / name, process=False)
    parts = mesh.dump() if isinstance(mesh, trimesh.Scene) else [mesh]
    low = np.min([part.bounds[0] for part in parts], axis=0)
    high = np.max([part.bounds[1] for part in parts], axis=0)
    areas = np.concatenate([part.area_faces for part in parts])
    colors = []
    for part in parts:
        visual = part.visual
        if isinstance(visual, trimesh.visual.TextureVisuals):
            color = visual.material.main_color
            colors.append(np.tile(color[:3], (len(part.faces), 1)))
        else:
            colors.append(visual.face_colors[:, :3])
    colors = np.concatenate(colors).astype(float)
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
