"""Writes a build of all blocks of the game, and the boxes that they collide with, for the tests of shapes: python block_list.py FOLDER

Names, states and boxes are those of PrismarineJS' minecraft-data, which takes them from the running game."""

import gzip
import json
import struct
import sys
from itertools import product
from pathlib import Path

import minecraft_data

folder = Path(sys.argv[1])
data = Path(minecraft_data.__file__).parent / "data" / "pc" / "1.21.4"
blocks = json.loads((data / "blocks.json").read_text())
shapes = json.loads((data / "blockCollisionShapes.json").read_text())


def states(block):
    """The states of a block in the order of their numbers: texts, and numbers."""
    values = []
    for state in block["states"]:
        if state["type"] == "bool":
            options = ["true", "false"]
        else:
            options = state.get("values") or [str(n) for n in range(state["num_values"])]
        values.append([(state["name"], value) for value in options])
    return list(product(*values))


found = []
for block in blocks:
    name, kinds = block["name"], shapes["blocks"][block["name"]]
    seen = set()
    for number, state in enumerate(states(block)):
        shape = kinds if isinstance(kinds, int) else kinds[number]
        # One state for each shape, without water around it; what is turned or opened has them all.
        if ("waterlogged", "true") in state or ("powered", "true") in state or ("lit", "true") in state:
            continue
        is_default = number == block["defaultState"] - block["minStateId"]
        if shape in seen and not is_default:
            continue
        seen.add(shape)
        text = ",".join(f"{key}={value}" for key, value in state)
        boxes = shapes["shapes"][str(shape)]
        found.append({"state": f"{name}[{text}]" if text else name, "boxes": boxes})

# Three apart, so that nothing touches.
row = 64
width, length = 3 * row, 3 * ((len(found) + row - 1) // row)
cells = [0] * (width * length)
for index, block in enumerate(found):
    block["at"] = [3 * (index % row), 0, 3 * (index // row)]
    cells[block["at"][2] * width + block["at"][0]] = index + 1


def varint(value):
    out = bytearray()
    while value > 127:
        out.append(value & 127 | 128)
        value >>= 7
    return bytes(out + bytes([value]))


def named(kind, name, payload):
    return bytes([kind]) + struct.pack(">H", len(name)) + name.encode() + payload


palette = b"".join(
    named(3, f"minecraft:{block['state']}", struct.pack(">i", index + 1)) for index, block in enumerate(found)
)
palette = named(10, "Palette", named(3, "minecraft:air", struct.pack(">i", 0)) + palette + b"\0")
bytes_of = b"".join(varint(cell) for cell in cells)
sizes = b"".join(named(2, name, struct.pack(">H", edge)) for name, edge in [("Width", width), ("Height", 1), ("Length", length)])
tags = sizes + palette + named(7, "BlockData", struct.pack(">i", len(bytes_of)) + bytes_of)
(folder / "all.schem").write_bytes(gzip.compress(named(10, "Schematic", tags + b"\0")))
(folder / "all.json").write_text(json.dumps({"length": length, "blocks": found}))
print(f"{len(blocks)} blocks, {len(found)} states")
