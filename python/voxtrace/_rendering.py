"""One picture of one scene, with a bar of progress where there is somebody to see it."""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import Any, Callable

from ._voxtrace import Camera, Image, Renderer, Scene


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
    is installed and the work takes longer than a second. Everything else is as in `Renderer` and `Renderer.render`. For many pictures
    of one scene keep a `Renderer`.
    """
    renderer = Renderer(scene, device=device)
    with _bar(progress) as told:
        return renderer.render(
            camera, samples=samples, size=size, seed=seed, denoise=denoise, progress=told, **options
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
