"""Writes grids with OpenVDB's own library, for the tests of the importer: python openvdb.py FOLDER. Needs pyopenvdb (Debian:
python3-openvdb)."""

import sys
from pathlib import Path

import numpy as np
import pyopenvdb as vdb

folder = Path(sys.argv[1])

# A lump and tiles far from it; values go on in z, less in y.
x, y, z = np.meshgrid(np.arange(40), np.arange(33), np.arange(21), indexing="ij")
lump = np.where((x - 20) ** 2 + (y - 16) ** 2 + (z - 9) ** 2 < 60, 1 + z / 4 + y / 64, 0)


def grid_of(kind, name):
    grid = kind()
    grid.name = name
    grid.copyFromArray(lump.astype(np.float32), ijk=(-7, 3, 5))
    grid.fill((16, -24, 8), (39, -9, 15), 2.5)
    grid.gridClass = vdb.GridClass.FOG_VOLUME
    return grid


density = grid_of(vdb.FloatGrid, "density")
density.transform = vdb.createLinearTransform(0.25)
half = grid_of(vdb.FloatGrid, "density")
half.saveFloatAsHalf = True
turned = vdb.createLinearTransform([[0, 0, 2, 0], [0.5, 0, 0, 0], [0, 1, 0, 0], [10, 20, 30, 1]])
half.transform = turned
sphere = vdb.createLevelSetSphere(radius=12.0, center=(1.0, 2.0, 3.0), voxelSize=0.5, halfWidth=3.0)
sphere.name = "ball"
velocity = vdb.Vec3SGrid()
velocity.name = "velocity"
velocity.fill((0, 0, 0), (3, 3, 3), (1.0, 2.0, 3.0))
whole = vdb.FloatGrid()
whole.name = "whole"
whole.copyFromArray(np.arange(8 * 8 * 8, dtype=np.float32).reshape(8, 8, 8))
vdb.write(str(folder / "density.vdb"), [density])
vdb.write(str(folder / "half.vdb"), [half])
vdb.write(str(folder / "ball.vdb"), [velocity, density, sphere])
vdb.write(str(folder / "leaf.vdb"), [whole])
inside = vdb.BoolGrid()
inside.name = "inside"
inside.copyFromArray(lump > 0, ijk=(-7, 3, 5))
inside.fill((16, -24, 8), (39, -9, 15), True)
vdb.write(str(folder / "bool.vdb"), [inside])
try:
    double = grid_of(vdb.DoubleGrid, "density")
    vdb.write(str(folder / "double.vdb"), [double])
except AttributeError:
    pass
