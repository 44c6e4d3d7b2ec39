"""What Pillow and PyAV (ffmpeg's libraries) find in clips. Arguments: the pattern of the frames, their number, and clips.

Prints for each clip its name, frames, width, height, seconds, and the smallest PSNR of a frame against the picture it was made of."""

import math
import sys

import av
import numpy
from PIL import Image, ImageSequence


def pictures(clip):
    if clip.endswith(".mp4"):
        with av.open(clip) as container:
            stream = container.streams.video[0]
            seconds = float(stream.duration * stream.time_base)
            return [frame.to_ndarray(format="rgb24") for frame in container.decode(video=0)], seconds
    with Image.open(clip) as image:
        frames = [(numpy.asarray(frame.convert("RGB")), frame.info["duration"]) for frame in ImageSequence.Iterator(image)]
    return [frame for frame, _ in frames], sum(duration for _, duration in frames) / 1000


pattern, count, *clips = sys.argv[1:]
expected = [numpy.asarray(Image.open(pattern % number).convert("RGB")) for number in range(1, int(count) + 1)]
for clip in clips:
    frames, seconds = pictures(clip)
    # MP4 has even sizes.
    cut = [frame[: picture.shape[0], : picture.shape[1]] for frame, picture in zip(frames, expected)]
    errors = [numpy.mean((frame.astype(float) - picture) ** 2) for frame, picture in zip(cut, expected)]
    psnr = 10 * math.log10(255**2 / max(max(errors), 1e-9))
    height, width = frames[0].shape[:2]
    print(clip.rsplit("/", 1)[-1], len(frames), width, height, round(seconds, 3), round(psnr, 1))
