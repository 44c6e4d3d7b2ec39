"""The engine. `voxtrace` has what is to be used."""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any, Literal, TypeAlias, TypedDict, final

import numpy
import numpy.typing

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
    "TiledCloud",
    "TransferFunction",
    "Volume",
    "VoxelGrid",
    "VoxtraceError",
    "__version__",
    "builtin",
    "join_surveys",
    "open",
    "open_volume",
]

__version__: str
BUILTIN_SCENES: list[str]

_Three: TypeAlias = Sequence[float] | numpy.ndarray[Any, Any]
_Color: TypeAlias = str | Sequence[float] | numpy.ndarray[Any, Any]
_Matrix: TypeAlias = Sequence[Sequence[float]] | numpy.ndarray[Any, Any]
_Path: TypeAlias = str | os.PathLike[str]
_Transfer: TypeAlias = TransferFunction | str

class _Hits(TypedDict):
    hit: numpy.typing.NDArray[numpy.bool_]
    t: numpy.typing.NDArray[numpy.float32]
    position: numpy.typing.NDArray[numpy.float32]
    normal: numpy.typing.NDArray[numpy.float32]
    voxel: numpy.typing.NDArray[numpy.int32]
    instance: numpy.typing.NDArray[numpy.uint32]
    material: numpy.typing.NDArray[numpy.uint32]

class VoxtraceError(Exception):
    path: str | None
    offset: int | None
    hint: str | None

class ReadError(VoxtraceError): ...
class DeviceError(VoxtraceError): ...

@final
class Material:
    def __new__(
        cls,
        base_color: _Color = (0.8, 0.8, 0.8),
        *,
        emission: _Color = (0, 0, 0),
        roughness: float = 1.0,
        metallic: float = 0.0,
        transmission: float = 0.0,
        ior: float = 1.5,
        specular: float = 0.0,
        anisotropy: float = 0.0,
        absorption: _Color = (0, 0, 0),
        scattering: float = 0.0,
    ) -> Material: ...
    @property
    def base_color(self) -> list[float]: ...
    @property
    def emission(self) -> list[float]: ...
    @property
    def roughness(self) -> float: ...
    @property
    def metallic(self) -> float: ...
    @property
    def transmission(self) -> float: ...
    @property
    def ior(self) -> float: ...
    @property
    def specular(self) -> float: ...
    @property
    def anisotropy(self) -> float: ...
    @property
    def absorption(self) -> list[float]: ...
    @property
    def scattering(self) -> float: ...
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...

@final
class VoxelGrid:
    @staticmethod
    def from_numpy(
        array: numpy.ndarray[Any, Any],
        palette: Iterable[Material | _Color] | numpy.ndarray[Any, Any] | None = None,
        *,
        origin: _Three | None = None,
    ) -> VoxelGrid: ...
    def to_numpy(self, kind: Literal["labels", "rgba", "occupancy"] = "labels") -> numpy.ndarray[Any, Any]: ...
    @property
    def origin(self) -> list[int]: ...
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def bounds(self) -> tuple[list[int], list[int]] | None: ...
    @property
    def materials(self) -> list[Material]: ...
    def __len__(self) -> int: ...
    def __getitem__(self, voxel: _Three, /) -> int | None: ...

@final
class TransferFunction:
    def __new__(
        cls,
        stops: Sequence[tuple[float, _Color]],
        *,
        threshold: float | None = None,
        upper: float | None = None,
        opacity: float = 1.0,
        relative: bool = False,
    ) -> TransferFunction: ...
    @staticmethod
    def preset(name: str) -> TransferFunction: ...
    @staticmethod
    def labels(colors: Mapping[int, _Color], *, opacity: float = 1.0) -> TransferFunction: ...

@final
class Volume:
    @staticmethod
    def from_array(
        array: Any,
        *,
        spacing: float | tuple[float, float, float] | None = None,
        affine: Any = None,
        unit: str | None = None,
        labels: bool = False,
        name: str | None = None,
    ) -> Volume: ...
    @staticmethod
    def _from_numpy(
        array: Any,
        *,
        spacing: Any = None,
        affine: Any = None,
        unit: str | None = None,
        labels: bool = False,
        name: str = "array",
    ) -> Volume: ...
    def to_numpy(self) -> numpy.typing.NDArray[numpy.float32]: ...
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def spacing(self) -> list[float]: ...
    @property
    def affine(self) -> list[list[float]]: ...
    @property
    def unit(self) -> str | None: ...
    @property
    def name(self) -> str: ...
    def voxelize(
        self,
        transfer: _Transfer | None = None,
        *,
        threshold: float | None = None,
        resolution: int | None = None,
        voxel_size: float | None = None,
        shell: bool = True,
    ) -> Scene: ...

@final
class Camera:
    def __new__(
        cls,
        eye: _Three,
        target: _Three,
        *,
        up: _Three | None = None,
        fov: float | None = None,
        name: str = "",
        lens: str = "pinhole",
        **settings: float,
    ) -> Camera: ...
    @property
    def eye(self) -> list[float]: ...
    @property
    def target(self) -> list[float]: ...
    @property
    def up(self) -> list[float]: ...
    @property
    def fov(self) -> float: ...
    @property
    def name(self) -> str: ...
    @property
    def lens(self) -> str: ...
    def __getnewargs_ex__(self) -> tuple[tuple[list[float], list[float]], dict[str, Any]]: ...
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...

@final
class Sky:
    @staticmethod
    def gradient(nadir: _Color, zenith: _Color) -> Sky: ...
    @staticmethod
    def uniform(color: _Color) -> Sky: ...
    @staticmethod
    def black() -> Sky: ...
    @staticmethod
    def environment(path: _Path, *, rotation: float = 0.0) -> Sky: ...
    def with_sun(self, *, bearing: float = 150.0, height: float = 45.0, strength: float = 3.0) -> Sky: ...
    def with_brightness(self, brightness: float) -> Sky: ...
    @property
    def brightness(self) -> float: ...
    def __eq__(self, value: object, /) -> bool: ...
    def __ne__(self, value: object, /) -> bool: ...

@final
class Instance:
    @property
    def name(self) -> str: ...
    @property
    def grid(self) -> int: ...
    @property
    def transform(self) -> list[list[float]]: ...
    @property
    def hidden(self) -> bool: ...
    @property
    def layer(self) -> str | None: ...

@final
class Scene:
    light_intensity: float
    def __new__(cls, grid: VoxelGrid | None = None, *, name: str = "scene") -> Scene: ...
    def add(self, grid: VoxelGrid, transform: _Matrix | None = None, *, name: str = "") -> int: ...
    def add_copy(self, instance: int, transform: _Matrix, *, name: str = "") -> int: ...
    def place(self, instance: int, transform: _Matrix) -> None: ...
    @property
    def instances(self) -> list[Instance]: ...
    def grid(self, index: int) -> VoxelGrid: ...
    @property
    def materials(self) -> list[Material]: ...
    def set_material(self, index: int, material: Material) -> None: ...
    @property
    def sky(self) -> Sky: ...
    @sky.setter
    def sky(self, value: Sky, /) -> None: ...
    @property
    def cameras(self) -> list[Camera]: ...
    @cameras.setter
    def cameras(self, value: Sequence[Camera], /) -> None: ...
    @property
    def name(self) -> str: ...
    @property
    def notes(self) -> list[str]: ...
    @property
    def voxels(self) -> int: ...
    @property
    def bounds(self) -> tuple[list[float], list[float]] | None: ...
    def info(self) -> dict[str, Any]: ...
    def save(self, path: _Path) -> list[str]: ...

@final
class Image:
    @property
    def shape(self) -> tuple[int, int]: ...
    @property
    def device(self) -> str: ...
    @property
    def radiance(self) -> numpy.typing.NDArray[numpy.float32]: ...
    @property
    def noisy(self) -> numpy.typing.NDArray[numpy.float32]: ...
    @property
    def alpha(self) -> numpy.typing.NDArray[numpy.float32]: ...
    @property
    def sums(self) -> numpy.typing.NDArray[numpy.uint64]: ...
    def aov(
        self, name: Literal["albedo", "normal", "depth", "instance", "voxel"]
    ) -> numpy.ndarray[Any, Any]: ...
    def to_srgb(
        self, *, exposure: float = 0.0, tone_map: Literal["agx", "neutral", "reinhard", "linear"] = "agx"
    ) -> numpy.typing.NDArray[numpy.uint8]: ...
    def __array__(self, dtype: Any = None, copy: Any = None) -> numpy.ndarray[Any, Any]: ...
    def save(
        self,
        path: _Path,
        *,
        exposure: float = 0.0,
        tone_map: Literal["agx", "neutral", "reinhard", "linear"] = "agx",
    ) -> None: ...
    def to_bytes(self) -> bytes: ...
    @staticmethod
    def from_bytes(film: bytes) -> Image: ...
    def __reduce__(self) -> tuple[Any, tuple[bytes]]: ...
    @staticmethod
    def merge(images: Sequence[Image], *, halfway: bool = False) -> Image: ...
    def denoise(self, scene: Scene) -> Image: ...
    def _repr_png_(self) -> bytes: ...

@final
class Renderer:
    def __new__(
        cls,
        scene: Scene | Editor,
        *,
        device: str = "auto",
        traversal: Literal["walk", "query", "pipeline"] | None = None,
        fast: bool = False,
        memory: int | None = None,
        placeable: bool = False,
        film: Image | None = None,
    ) -> Renderer: ...
    @property
    def device(self) -> str: ...
    def render(
        self,
        camera: Camera | str | None = None,
        *,
        samples: int = 64,
        size: tuple[int, int] = (1280, 720),
        seed: int = 0,
        max_bounces: int = 8,
        integrator: Literal["path", "essay"] = "path",
        denoise: bool = True,
        transparent: bool = False,
        aovs: bool = False,
        first_sample: int = 0,
        region: tuple[int, int, int, int] | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> Image: ...
    def render_like(
        self,
        film: Image,
        *,
        samples: int,
        first_sample: int = 0,
        region: tuple[int, int, int, int] | None = None,
        progress: Callable[[float], object] | None = None,
    ) -> Image: ...
    def cast(
        self,
        origins: numpy.typing.ArrayLike,
        directions: numpy.typing.ArrayLike,
        t_max: numpy.typing.ArrayLike | None = None,
    ) -> _Hits: ...
    def place(self, transforms: numpy.typing.ArrayLike) -> None: ...
    def follow(self, editor: Editor) -> None: ...
    def default_camera(self, size: tuple[int, int] = (1280, 720)) -> Camera: ...

@final
class Editor:
    def __new__(cls, scene: Scene) -> Editor: ...
    def fill(self, low: _Three, high: _Three, material: int | None, *, grid: int = 0) -> int: ...
    def sphere(self, center: _Three, radius: float, material: int | None, *, grid: int = 0) -> int: ...
    def stroke(
        self, start: _Three, end: _Three, radius: float, material: int | None, *, grid: int = 0
    ) -> int: ...
    def paint(self, center: _Three, radius: float, material: int, *, grid: int = 0) -> int: ...
    def replace(self, old: int, new: int | None, *, grid: int = 0) -> int: ...
    def set(self, voxels: numpy.typing.ArrayLike, material: int | None, *, grid: int = 0) -> int: ...
    def add_material(self, material: Material) -> int: ...
    def get(self, voxel: _Three, *, grid: int = 0) -> int | None: ...
    def undo(self) -> bool: ...
    def redo(self) -> bool: ...
    @property
    def voxels(self) -> int: ...
    def scene(self) -> Scene: ...

@final
class TiledCloud:
    def __new__(
        cls,
        paths: Sequence[_Path],
        *,
        resolution: int | None = None,
        voxel_size: float | None = None,
        color_by: str = "auto",
        min_points: int = 1,
        classes: str | None = None,
        bounds: Sequence[float] | None = None,
        palette: int | None = None,
        dither: bool = False,
        memory: int | None = None,
        trusted: bool = False,
    ) -> TiledCloud: ...
    def shares(self, parts: int) -> list[tuple[int, int]]: ...
    def survey(self, first: int, end: int) -> bytes: ...
    def check(self, survey: bytes) -> bool: ...
    def measure(self, survey: bytes, first: int, end: int) -> bytes: ...
    def voxelize(self, survey: bytes, first: int, end: int, path: _Path) -> int: ...
    def merge(self, survey: bytes, parts: Sequence[_Path], path: _Path, levels: int = 0) -> int: ...
    @property
    def notes(self) -> list[str]: ...

def join_surveys(found: Sequence[bytes]) -> bytes: ...
def open(
    path: _Path,
    *,
    resolution: int | None = None,
    voxel_size: float | None = None,
    fill: bool = False,
    transfer: _Transfer | None = None,
    threshold: float | None = None,
    shell: bool = True,
    channel: int | None = None,
    time: int | None = None,
    series: int | None = None,
    animation: str | None = None,
    strict: bool = False,
) -> Scene: ...
def open_volume(
    path: _Path,
    *,
    channel: int | None = None,
    time: int | None = None,
    series: int | None = None,
    strict: bool = False,
) -> Volume: ...
def builtin(name: str, *, voxels: int | None = None, instances: int | None = None) -> Scene: ...
