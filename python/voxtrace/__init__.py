"""Path tracing of voxel scenes: arrays, scans, point clouds, meshes, `.vox` and Minecraft, on any Vulkan GPU or the processor.

>>> import voxtrace
>>> image = voxtrace.render(voxtrace.builtin("city", voxels=20_000), samples=4, size=(96, 54))
>>> image.radiance.shape
(54, 96, 3)
"""

from ._rendering import render, view
from ._volumes import _add_from_array
from ._voxtrace import (
    BUILTIN_SCENES,
    Camera,
    DeviceError,
    Editor,
    Image,
    Instance,
    Material,
    ReadError,
    Renderer,
    Scene,
    Sky,
    TransferFunction,
    Volume,
    VoxelGrid,
    VoxtraceError,
    __version__,
    builtin,
    open,
    open_volume,
    save_clip,
)

_add_from_array(Volume)

__all__ = [
    "BUILTIN_SCENES",
    "Camera",
    "DeviceError",
    "Editor",
    "Image",
    "Instance",
    "Material",
    "ReadError",
    "Renderer",
    "Scene",
    "Sky",
    "TransferFunction",
    "Volume",
    "VoxelGrid",
    "VoxtraceError",
    "__version__",
    "builtin",
    "open",
    "open_volume",
    "render",
    "save_clip",
    "view",
]
