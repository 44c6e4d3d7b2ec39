"""Work for many machines, by the workers of a Dask cluster: pictures whose films add up to the bytes of one run, animations, thumbnails, scans of many files, arrays.

>>> from dask.distributed import Client            # doctest: +SKIP
>>> client = Client("tcp://scheduler:8786")        # doctest: +SKIP
>>> voxtrace.dask.render(client, scene, samples=4096).save("church.png")  # doctest: +SKIP
"""

from ._animation import animate
from ._picture import render, render_like
from ._thumbnails import Thumbnail, thumbnails
from ._volume import voxelize_array
from ._voxelize import voxelize

__all__ = ["Thumbnail", "animate", "render", "render_like", "thumbnails", "voxelize", "voxelize_array"]
