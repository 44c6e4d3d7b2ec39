"""Writes a map of Ace of Spades with the game server piqueserver, for the test of its importer: python voxlap.py FOLDER.
Needs piqueserver, of which no other library is needed for that."""

import json
import random
import sys
from pathlib import Path

from pyspades.vxl import VXLData

folder = Path(sys.argv[1])
random.seed(3)
game_map = VXLData()


def fill(x, y, heights, color):
    for z in heights:
        game_map.set_point(x, y, z, (*color(z), 255))


# z points down. Hills, a bridge over them, a roof on a post, and a block that nothing holds.
for x in range(100, 140):
    for y in range(200, 230):
        fill(x, y, range(50 - random.randrange(9), 64), lambda z: (x, y, 3 * z))
for x in range(95, 145):
    fill(x, 210, range(20, 25), lambda z: (200, x, z))
for x in range(300, 309):
    for y in range(400, 405):
        fill(x, y, range(10, 11), lambda z: (x - 200, y - 300, 7))
fill(304, 402, range(11, 64), lambda z: (9, 9, z))
fill(511, 0, range(0, 1), lambda z: (1, 2, 3))

(folder / "map.vxl").write_bytes(game_map.generate())


def is_solid(x, y, z):
    """Whether a block is there; nobody sees the map from outside or from below."""
    return not (0 <= x < 512 and 0 <= y < 512 and z < 64) or z >= 0 and game_map.get_solid(x, y, z)


sides = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
voxels = []
for x, y, z in [(x, y, z) for x in range(512) for y in range(512) for z in range(64)]:
    if game_map.get_solid(x, y, z) and not all(is_solid(x + i, y + j, z + k) for i, j, k in sides):
        voxels.append([x, y, z, *game_map.get_color(x, y, z)])
(folder / "expected.json").write_text(json.dumps(voxels))
