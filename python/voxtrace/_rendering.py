"""One picture of one scene, with a bar of progress where there is somebody to see it, and the same in a notebook, to be turned."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING, Any, Callable, Literal

from ._voxtrace import Camera, Image, Renderer, Scene, TransferFunction, Volume

if TYPE_CHECKING:
    from .notebook import View


def render(
    scene: Scene,
    camera: Camera | str | None = None,
    *,
    samples: int = 64,
    size: tuple[int, int] = (1280, 720),
    device: str = "auto",
    seed: int = 0,
    denoise: bool = True,
    progress: bool | Callable[[float], object] | None = None,
    **options: Any,
) -> Image:
    """Render a picture of a scene.

    `progress`: a function that is called with the share that is done, or whether a bar is shown (by tqdm); by default it is where tqdm
    is installed and the work takes longer than a second. `device` is as in `Renderer`, everything else as in `Renderer.render`. For many
    pictures of one scene, and for what else a `Renderer` is told, keep one.
    """
    renderer = Renderer(scene, device=device)
    with _bar(progress) as told:
        return renderer.render(
            camera, samples=samples, size=size, seed=seed, denoise=denoise, progress=told, **options
        )


def view(
    scene: Scene | Volume,
    *,
    camera: Camera | None = None,
    clip: tuple[tuple[float, float, float], tuple[float, float, float]] | None = None,
    transfer: TransferFunction | str | None = None,
    threshold: float | None = None,
    samples: int = 64,
    exposure: float = 0.0,
    tone_map: Literal["agx", "neutral", "reinhard", "linear"] = "agx",
    seed: int = 0,
    max_bounces: int = 8,
    height: int = 420,
    renderer: Literal["auto", "browser", "kernel"] = "auto",
    device: str = "auto",
) -> View:
    """Show a scene in a notebook, to be turned, cut open and picked in; `voxtrace.notebook.View` says what can be set and observed.

    `samples`: of each pixel of a view that stands still. `exposure`: stops. `tone_map`: the curve to the screen. `max_bounces`: surfaces that scatter one path.
    `clip`: the lowest and the highest corner of the box that is shown, world units. `transfer`, `threshold`: of a `Volume`, as in `Volume.voxelize`.
    `height`: of the picture in the page, CSS pixels. `renderer`: `"browser"` traces in the page (WebAssembly; the scene is sent there), `"kernel"` sends pictures;
    `"auto"` chooses the browser where it can and the scene has at most 64 MiB. `device`: what the kernel traces with, as in `Renderer`.

    Raises `ImportError` without the extra `notebook` of this package.
    """
    from .notebook import View

    return View(
        scene,
        camera=camera,
        clip=clip,
        transfer=transfer,
        threshold=threshold,
        samples=samples,
        exposure=exposure,
        tone_map=tone_map,
        seed=seed,
        max_bounces=max_bounces,
        height=height,
        renderer=renderer,
        device=device,
    )


def _bar(progress: bool | Callable[[float], object] | None) -> AbstractContextManager[Callable[[float], object] | None]:
    if callable(progress):
        return nullcontext(progress)
    if progress is False:
        return nullcontext(None)
    try:
        from tqdm.auto import tqdm  # type: ignore[import-untyped, unused-ignore]
    except ImportError:
        if progress:
            raise
        return nullcontext(None)
    return _Bar(tqdm(total=100, unit="%", desc="rendering", delay=0 if progress else 1, leave=False))


class _Bar(AbstractContextManager[Callable[[float], object]]):
    """A bar of tqdm that takes shares."""

    def __init__(self, bar: Any) -> None:
        self.bar = bar

    def __enter__(self) -> Callable[[float], object]:
        def told(share: float) -> None:
            self.bar.update(round(100 * share) - self.bar.n)

        return told

    def __exit__(self, *_: object) -> None:
        self.bar.close()
