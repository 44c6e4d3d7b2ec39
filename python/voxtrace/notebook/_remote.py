"""Pictures for a page, rendered here: coarse while the view moves, then sample after sample of the view that stands. The page asks for each of them."""

from __future__ import annotations

import io
import math
import time
from typing import Any

import numpy

from .._voxtrace import Camera, Image, Renderer

#: What a picture of a view that moves, and a step of one that stands, may take, seconds.
_FRAME = 0.07
_STEP = 0.25
#: Coarser than so is no picture.
_COARSEST = 6.0


class Remote:
    """The pictures of one view."""

    def __init__(self, renderer: Renderer) -> None:
        self.renderer = renderer
        self.film: Image | None = None
        self.key: tuple[Any, ...] = ()
        self.samples = 0
        # Pixels times samples in a second, as measured.
        self.rate = 1e6

    def next(self, camera: Camera, size: tuple[int, int], samples: int, seed: int, max_bounces: int) -> tuple[Image, int]:
        """The next picture of a view, and how many samples it has: 0 for a coarse one, which is the first of each view."""
        key = (camera, size, seed, max_bounces)
        if key != self.key:
            self.key, self.film, self.samples = key, None, 0
            scale = min(_COARSEST, max(1.0, math.sqrt(size[0] * size[1] / (_FRAME * self.rate))))
            coarse = (max(1, round(size[0] / scale)), max(1, round(size[1] / scale)))
            if scale > 1:
                return self._traced(camera, coarse, 0, 1, seed, max_bounces), 0
        left = samples - self.samples
        if self.film is not None and left <= 0:
            return self.film, self.samples
        most = int(_STEP * self.rate / (size[0] * size[1]))
        step = max(1, min(left, most, max(1, self.samples)))
        more = self._traced(camera, size, self.samples, step, seed, max_bounces)
        self.film = more if self.film is None else Image.merge([self.film, more])
        self.samples += step
        return self.film, self.samples

    def _traced(
        self, camera: Camera, size: tuple[int, int], first: int, samples: int, seed: int, max_bounces: int
    ) -> Image:
        start = time.perf_counter()
        image = self.renderer.render(
            camera,
            size=size,
            samples=samples,
            first_sample=first,
            seed=seed,
            max_bounces=max_bounces,
            denoise=False,
        )
        seconds = max(1e-3, time.perf_counter() - start)
        self.rate += 0.5 * (size[0] * size[1] * samples / seconds - self.rate)
        return image


def encoded(image: Image, exposure: float, tone_map: Any) -> bytes:
    """A picture as a JPEG."""
    from PIL import Image as Pillow

    file = io.BytesIO()
    Pillow.fromarray(numpy.asarray(image.to_srgb(exposure=exposure, tone_map=tone_map))).save(file, "JPEG", quality=88)
    return file.getvalue()
