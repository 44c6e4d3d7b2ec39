"""Seconds on the wall and of processors that laspy (with lazrs, in parallel) or nibabel takes to read a file's points or samples
into memory, on stdout; used by the benchmark beside this file."""

import sys
import time

import numpy as np

path = sys.argv[1]
try:
    if ".nii" in path:
        import nibabel
    else:
        import laspy
except ImportError:
    sys.exit(0)
wall, processor = time.perf_counter(), time.process_time()
if ".nii" in path:
    # A copy: an array in the file is read when it is touched.
    np.array(nibabel.load(path).dataobj)
elif path.endswith("z"):
    laspy.read(path, laz_backend=laspy.LazBackend.LazrsParallel)
else:
    laspy.read(path)
print(f"{time.perf_counter() - wall:.3f} {time.process_time() - processor:.3f}")
