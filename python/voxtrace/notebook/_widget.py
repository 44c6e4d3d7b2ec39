"""The widget: what Python and the page share, and what the kernel answers when the page asks."""

from __future__ import annotations

import base64
from typing import Any, Literal

import numpy
import traitlets

from .._voxtrace import Camera, Image, Instance, Renderer, Scene, TransferFunction, Volume, VoxtraceError
from . import _files, _remote

try:
    import anywidget
except ImportError as error:
    raise ImportError("voxtrace.view needs anywidget, which the extra `notebook` of this package brings") from error

#: Presets of transfer functions that the page offers; without a name the one that suits the values.
_PRESETS = ["", "ct-bone", "ct-skin", "mri", "hot", "fog"]
#: Width of the picture that stands for the widget where it does not run, pixels, and its samples.
_POSTER_WIDTH = 640
_POSTER_SAMPLES = 16

_Corners = tuple[tuple[float, float, float], tuple[float, float, float]]


class View(anywidget.AnyWidget):  # type: ignore[misc, unused-ignore]
    """A scene in a notebook. `voxtrace.view` makes it.

    These can be set, and observed by `view.observe(function, "camera")`, whoever changes them:

    * `camera`: a `Camera`, from where one looks; `None` before the page has shown the scene.
    * `clip`: the lowest and the highest corner of the box that is shown, world units, or `None`.
    * `samples`, `seed`, `max_bounces`: of the picture that stands still. `exposure` (stops), `tone_map`: how it is shown.
    * `threshold`, `preset`: of a volume, from which value on something is shown and in which colours; voxels are made anew.
    * `picked`: what was pressed last, `None` for the sky: a dict of `voxel`, `instance`, `name` (of the instance), `material`, `color`
      (`"#rrggbb"`), `position` and `normal` (world units), `distance`, and where they are known `coordinates` (of the map, patient or volume) and `value` (of the volume there).
    * `renderer`: `"browser"`, `"kernel"`, or `"auto"`; `tracer` says which of both it is.
    * `samples_shown`: how many samples the picture in the page has; `problem`: why what was asked for cannot be shown.
    """

    _esm = _files.script()
    _css = _files.style()

    renderer = traitlets.Enum(["auto", "browser", "kernel"], "auto").tag(sync=True)
    height = traitlets.Int(420, min=40).tag(sync=True)
    samples = traitlets.Int(64, min=1, max=65_536).tag(sync=True)
    seed = traitlets.Int(0, min=0, max=2**32 - 1).tag(sync=True)
    max_bounces = traitlets.Int(8, min=0, max=255).tag(sync=True)
    exposure = traitlets.Float(0.0, min=-30, max=30).tag(sync=True)
    tone_map = traitlets.Enum(["agx", "neutral", "reinhard", "linear"], "agx").tag(sync=True)
    clip = traitlets.Any(None).tag(sync=True)
    threshold = traitlets.Float(None, allow_none=True).tag(sync=True)
    preset = traitlets.Unicode("").tag(sync=True)
    picked = traitlets.Any(None).tag(sync=True)
    tracer = traitlets.Unicode("").tag(sync=True)
    problem = traitlets.Unicode("").tag(sync=True)
    samples_shown = traitlets.Int(0).tag(sync=True)
    camera = traitlets.Instance(Camera, None, allow_none=True)

    _camera = traitlets.List(traitlets.Float()).tag(sync=True)
    _version = traitlets.Int(0).tag(sync=True)
    _about = traitlets.Dict().tag(sync=True)
    _poster = traitlets.Bytes().tag(sync=True)

    def __init__(
        self,
        shown: Scene | Volume,
        *,
        camera: Camera | None = None,
        transfer: TransferFunction | str | None = None,
        device: str = "auto",
        **traits: Any,
    ) -> None:
        self._device = device
        self._transfer: TransferFunction | str | None = transfer
        self._volume: Volume | None = None
        self._scene: Scene | None = None
        self._bytes: bytes | None = None
        self._remote: _remote.Remote | None = None
        self._parts: tuple[list[Instance], list[str]] | None = None
        if traits.get("clip") is None and isinstance(shown, Scene):
            traits["clip"] = shown.clip
        if isinstance(transfer, TransferFunction):
            traits["preset"] = "own"
        elif transfer:
            traits["preset"] = transfer
        super().__init__(camera=camera, **traits)
        self.scene = shown
        self.on_msg(View._asked)

    @property
    def scene(self) -> Scene:
        """The scene that is shown. Another one, or a volume, can be set; it is seen from where the last one was."""
        assert self._scene is not None
        return self._scene

    @scene.setter
    def scene(self, shown: Scene | Volume) -> None:
        self._volume = shown if isinstance(shown, Volume) else None
        scene = self._voxelized(shown) if isinstance(shown, Volume) else shown
        self._put(scene, self._values(shown) if isinstance(shown, Volume) else None)

    @property
    def volume(self) -> Volume | None:
        """The volume that the scene was made of, if it was."""
        return self._volume

    def update(self) -> None:
        """Shows the scene as it is now, after it was changed in place."""
        self._put(self.scene, self._about.get("values"))

    def render(
        self,
        *,
        size: tuple[int, int] = (1280, 720),
        samples: int | None = None,
        denoise: bool = True,
        **options: Any,
    ) -> Image:
        """The picture of the view as it is now, rendered by the kernel; options are those of `Renderer.render`."""
        wanted = {"seed": self.seed, "max_bounces": self.max_bounces} | options
        return self._renderer().render(self.camera, size=size, samples=samples or self.samples, denoise=denoise, **wanted)

    def _voxelized(self, volume: Volume) -> Scene:
        transfer = self._transfer if self.preset == "own" else self.preset or None
        return volume.voxelize(transfer, threshold=self.threshold)

    def _values(self, volume: Volume) -> dict[str, Any]:
        edges, counts = volume.histogram()
        # As many bars as a panel has room for.
        bars = numpy.add.reduceat(counts, numpy.arange(0, len(counts), 8)) if len(counts) else counts
        own = ["own"] if isinstance(self._transfer, TransferFunction) else []
        return {
            "presets": _PRESETS + own + [self.preset] * (self.preset not in _PRESETS + own),
            "low": float(edges[0]),
            "high": float(edges[-1]),
            "threshold": volume.threshold,
            "counts": [int(count) for count in bars],
        }

    def _put(self, scene: Scene, values: dict[str, Any] | None) -> None:
        scene.clip = self.clip
        self._scene, self._bytes, self._remote, self._parts = scene, None, None, None
        about = {"name": scene.name, "bounds": scene.bounds, "bytes": int(scene.info()["total_bytes"])}
        with self.hold_sync():
            self._about = about | ({"values": values} if values else {})
            self._version += 1

    def _renderer(self) -> Renderer:
        if self._remote is None:
            self._remote = _remote.Remote(Renderer(self.scene, device=self._device))
        return self._remote.renderer

    @traitlets.validate("clip")
    def _box(self, proposal: Any) -> _Corners | None:
        box = proposal["value"]
        if box is None:
            return None
        low, high = (tuple(float(value) for value in corner) for corner in box)
        if len(low) != 3 or len(high) != 3 or not all(a < b for a, b in zip(low, high, strict=True)):
            raise traitlets.TraitError("clip is the lowest and the highest corner of a box, the one below the other along every axis")
        return low, high

    @traitlets.observe("clip")
    def _clipped(self, _change: Any) -> None:
        if self._scene is not None:
            self._scene.clip = self.clip
            # What it traced was cut otherwise.
            self._remote = None

    @traitlets.observe("threshold", "preset")
    def _shown_otherwise(self, _change: Any) -> None:
        if self._volume is None or self._scene is None:
            return
        try:
            scene = self._voxelized(self._volume)
        except (VoxtraceError, ValueError) as error:
            # What was shown before stays; the page says why, and so does whoever set it here.
            self.problem = str(error)
            raise
        self.problem = ""
        self._put(scene, self._about.get("values"))

    @traitlets.observe("camera")
    def _looked(self, change: Any) -> None:
        camera = change["new"]
        if camera is not None:
            self._camera = [*camera.eye, *camera.target, *camera.up, camera.fov]

    @traitlets.observe("_camera")
    def _looked_there(self, change: Any) -> None:
        if numbers := change["new"]:
            self.camera = self._camera_of(numbers)

    def _camera_of(self, numbers: list[float]) -> Camera:
        """The camera of ten numbers, with the lens of the scene's first one."""
        before = self.camera or next(iter(self._scene.cameras if self._scene else []), None)
        _, keywords = before.__getnewargs_ex__() if before else ((), {})
        return Camera(numbers[0:3], numbers[3:6], **(keywords | {"up": numbers[6:9], "fov": numbers[9]}))

    def _asked(self, content: dict[str, Any], _buffers: Any) -> None:
        """Answers the page."""
        answers = {"file": self._file, "scene": self._part, "frame": self._frame, "pick": self._pick, "picked": self._is_picked}
        answer = answers.get(content.get("ask", ""))
        if answer is None:
            return
        try:
            said, data = answer(content)
        # Whatever went wrong is told where people look: an exception here would be seen by nobody.
        except Exception as error:  # noqa: BLE001
            said, data = {"error": str(error) or type(error).__name__}, b""
        if "id" in content:
            self.send({**said, "id": content["id"]}, [data])

    def _file(self, content: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        return {}, _files.read(content["name"])

    def _part(self, content: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        if self._bytes is None:
            self._bytes = self.scene.to_bytes()
        part = self._bytes[content["from"] : content["from"] + content["length"]]
        total = len(self._bytes)
        if content["from"] + len(part) >= total:
            # It is there; who asks again waits a moment.
            self._bytes = None
        return {"total": total, "version": self._version}, part

    def _frame(self, content: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        size = (int(content["width"]), int(content["height"]))
        renderer = self._renderer()
        assert self._remote is not None
        numbers = content["camera"]
        camera = self._camera_of(numbers) if numbers else self.camera or renderer.default_camera(size)
        image, samples = self._remote.next(camera, size, self.samples, self.seed, self.max_bounces)
        numbers = [*camera.eye, *camera.target, *camera.up, camera.fov]
        return {"samples": samples, "camera": numbers}, _remote.encoded(image, self.exposure, self.tone_map)

    def _pick(self, content: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        size = (int(content["width"]), int(content["height"]))
        origin, direction = self._camera_of(content["camera"]).ray((content["x"], content["y"]), size)
        found = self._renderer().cast([origin], [direction])
        if not found["hit"][0]:
            return {"picked": None}, b""
        names: list[Literal["voxel", "position", "normal"]] = ["voxel", "position", "normal"]
        picked: dict[str, Any] = {name: found[name][0].tolist() for name in names}
        picked |= {"instance": int(found["instance"][0]), "material": int(found["material"][0]), "distance": float(found["t"][0])}
        return {"picked": picked}, b""

    def _is_picked(self, content: dict[str, Any]) -> tuple[dict[str, Any], bytes]:
        picked = content["picked"]
        self.picked = self._told(picked) if picked else None
        return {}, b""

    def _told(self, picked: dict[str, Any]) -> dict[str, Any]:
        """A picked voxel with what only the kernel knows of it."""
        if self._parts is None:
            colors = [_hexadecimal(material.base_color) for material in self.scene.materials]
            self._parts = self.scene.instances, colors
        (instances, colors), instance, material = self._parts, picked["instance"], picked["material"]
        told = {
            **picked,
            "name": instances[instance].name if instance < len(instances) else "",
            "color": colors[material] if material < len(colors) else "",
        }
        if affine := self.scene.affine:
            # The middle of the voxel, half an edge below its face.
            middle = numpy.asarray(picked["position"]) - 0.5 * numpy.asarray(picked["normal"])
            place = numpy.asarray(affine) @ [*middle, 1]
            told["coordinates"] = place[:3].tolist()
            if self._volume is not None:
                index = numpy.linalg.inv(self._volume.affine) @ place
                nearest = numpy.clip(numpy.rint(index[:3]), 0, numpy.asarray(self._volume.shape) - 1)
                told["value"] = float(self._volume[tuple(int(at) for at in nearest)])  # type: ignore[index, unused-ignore]
        return told

    def _repr_mimebundle_(self, **given: Any) -> Any:
        """The widget, and a picture for where widgets do not run: pages of nbconvert, GitHub, mail."""
        size = (_POSTER_WIDTH, max(1, round(_POSTER_WIDTH * self.height / 960)))
        samples = min(self.samples, _POSTER_SAMPLES)
        image = self.render(size=size, samples=samples)
        picture = _remote.encoded(image, self.exposure, self.tone_map)
        self._poster = picture
        bundle = super()._repr_mimebundle_(**given)
        data, metadata = bundle if bundle else ({"text/plain": repr(self)}, {})
        return {**data, "image/jpeg": base64.b64encode(picture).decode()}, metadata

    def __repr__(self) -> str:
        return f"<voxtrace.notebook.View of {self.scene.name!r}>"


def _hexadecimal(color: list[float]) -> str:
    """A linear colour as pickers show it."""
    linear = numpy.clip(numpy.asarray(color), 0, 1)
    encoded = numpy.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return "#" + "".join(f"{round(255 * float(channel)):02x}" for channel in encoded)
