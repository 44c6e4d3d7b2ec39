"""Writes one Minecraft build with other programs' libraries, for the tests of the importers: python builds.py FOLDER"""

import sys
from pathlib import Path

import anvil
import litemapy
import mcschematic
import nbtlib
import numpy as np

folder = Path(sys.argv[1])

# x east, y up, z south; a corner of three arms that tells the directions apart, and a lamp.
blocks = {(x, 0, z): "stone" for x in range(6) for z in range(4)}
blocks |= {(5, 1, 0): "red_wool", (0, 1, 3): "gold_block", (2, 1, 1): "glowstone"}
blocks |= {(0, y, 0): "oak_planks" for y in range(1, 5)}
old = {"stone": (1, 0), "red_wool": (35, 14), "gold_block": (41, 0), "glowstone": (89, 0), "oak_planks": (5, 0)}
width, height, length = 6, 5, 4

build = mcschematic.MCSchematic()
for place, name in blocks.items():
    build.setBlock(place, "minecraft:" + name)
build.save(str(folder), "build", mcschematic.Version.JE_1_20_1)

for name, size in [("build", (width, height, length)), ("negative", (-width, height, -length))]:
    low = [min(0, edge + 1) for edge in size]
    region = litemapy.Region(3, 4, 5, *size)
    for (x, y, z), block in blocks.items():
        region[x + low[0], y + low[1], z + low[2]] = litemapy.BlockState("minecraft:" + block)
    region.as_schematic(name=name, author="test").save(str(folder / f"{name}.litematic"))

numbers = np.zeros((height, length, width), np.int8)
data = np.zeros_like(numbers)
for (x, y, z), block in blocks.items():
    numbers[y, z, x], data[y, z, x] = old[block]
tags = {
    "Width": nbtlib.Short(width),
    "Height": nbtlib.Short(height),
    "Length": nbtlib.Short(length),
    "Materials": nbtlib.String("Alpha"),
    "Blocks": nbtlib.ByteArray(numbers.ravel()),
    "Data": nbtlib.ByteArray(data.ravel()),
    "Entities": nbtlib.List[nbtlib.Compound]([]),
    "TileEntities": nbtlib.List[nbtlib.Compound]([nbtlib.Compound({"id": nbtlib.String("chest")})]),
}
nbtlib.File(tags, gzipped=True, root_name="Schematic").save(folder / "build.schematic")

world = anvil.EmptyRegion(0, 0)
for (x, y, z), block in blocks.items():
    # Across the border of four chunks and of two sections.
    world.set_block(anvil.Block("minecraft", block), 13 + x, 14 + y, 14 + z)
world.save(str(folder / "r.0.0.mca"))

print("written by mcschematic, litemapy, nbtlib and anvil-parser")
