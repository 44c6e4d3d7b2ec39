"""Writes the volumes of docs/gallery.md that nobody else made, gyroid.zarr and torus.tif: python gallery.py FOLDER"""

import sys
from pathlib import Path

import numpy as np
import tifffile
import zarr

folder = Path(sys.argv[1])
size = 96
z, y, x = np.mgrid[0:size, 0:size, 0:size].astype(np.float32) - (size - 1) / 2

# A ball of a gyroid: values fall off with the distance from the surface, and towards the rim.
k = 2 * np.pi / 40
gyroid = np.sin(k * x) * np.cos(k * y) + np.sin(k * y) * np.cos(k * z) + np.sin(k * z) * np.cos(k * x)
rim = (46 - np.sqrt(x * x + y * y + z * z)) / 4
ball = np.clip(np.minimum(1.2 - 1.6 * np.abs(gyroid), rim), 0, 1)
array = zarr.open_array(str(folder / "gyroid.zarr"), mode="w", shape=ball.shape, chunks=(32, 32, 32), dtype="u1")
array[:] = (200 * ball).astype(np.uint8)

# A torus that is twisted like a rope.
ring = np.sqrt(x * x + y * y) - 28
rope = 13 + 2.5 * np.sin(9 * np.arctan2(y, x) + 6 * np.arctan2(z, ring))
torus = np.clip((rope - np.sqrt(ring * ring + z * z)) / 3, 0, 1)
tifffile.imwrite(folder / "torus.tif", (220 * torus).astype(np.uint8)[28:68], photometric="minisblack")
