"""Seconds that trimesh takes to read a mesh and voxelize it, on stdout; used by the benchmark beside this file."""

import resource
import sys
import time

# A grid of 1,024^3 asks for more memory than most machines have: better an error than a machine that stands still.
resource.setrlimit(resource.RLIMIT_AS, (12 << 30, 12 << 30))
try:
    import trimesh
except ImportError:
    sys.exit(0)
try:
    start = time.perf_counter()
    mesh = trimesh.load(sys.argv[1], process=False)
    grid = mesh.voxelized(mesh.extents.max() / int(sys.argv[2]))
    grid.filled_count
    print(f"{time.perf_counter() - start:.3f}")
except MemoryError:
    print("out of 12 GB of memory")
