"""Pictures of the window for the documentation, of built-in scenes and a volume that is made here: each is what a hand does in the real window.

    python3 crates/voxtrace-tests/python/window_pictures.py target/release/voxtrace docs/pictures [NAME…]

NAME is one of clipping, values, timeline, parts, comparing, building, clip; without one, all are made. It takes Linux with Xvfb and xdotool, a
Vulkan device (Mesa's in software will do), and a Python with mss, numpy and pillow. What is shown depends on how quick the machine is: a picture that
is not yet clean says so in its panel.
"""

import contextlib
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import mss
import numpy as np
from PIL import Image

# Pixels of the window, and of that of the clip.
SIZE, CLIP = (1280, 800), (480, 300)
DISPLAY = ":97"
# Seconds until a picture is clean, and frames a second of the clip.
CLEAN, RATE = 30, 12
# The stroke of the brush in the clip.
STROKE = ((150, 185), (250, 200))
# Seconds between pictures of the window that stands, and how many of them are kept.
STEP, STANDS = 6, 14


def tool(*words):
    return subprocess.run(["xdotool", *map(str, words)], capture_output=True, text=True).stdout


class Window:
    """The program's window with the hand on it."""

    def __init__(self, program, *scene, size=SIZE):
        self.size = size
        self.settings = tempfile.TemporaryDirectory()
        settings = os.path.join(self.settings.name, "settings.toml")
        words = [program, "view", *scene]
        self.process = subprocess.Popen(words, env={**os.environ, "DISPLAY": DISPLAY, "VOXTRACE_SETTINGS": settings})
        self.frames = []
        for _ in range(150):
            time.sleep(0.2)
            found = tool("search", "--onlyvisible", "--name", "voxtrace").split()
            if found:
                break
        self.window = found[-1]
        tool("windowmove", self.window, 0, 0)
        tool("windowsize", self.window, *size)
        # The title names the scene once it is there.
        while scene and "–" not in tool("getwindowname", self.window):
            time.sleep(0.2)
        time.sleep(2)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.settings.cleanup()

    def keys(self, *keys):
        for key in keys:
            tool("windowfocus", self.window)
            tool("key", key)
            time.sleep(0.4)

    def move(self, x, y):
        tool("mousemove", x, y)
        time.sleep(0.15)

    def click(self, x, y):
        self.move(x, y)
        tool("click", 1)
        time.sleep(0.5)

    def wheel(self, x, y, notches):
        self.move(x, y)
        for _ in range(abs(notches)):
            tool("click", 4 if notches > 0 else 5)
            time.sleep(0.05)

    def drag(self, points, button=1, steps=12):
        self.move(*points[0])
        tool("mousedown", button)
        for (x, y), (to_x, to_y) in zip(points, points[1:]):
            for step in range(1, steps + 1):
                tool("mousemove", round(x + (to_x - x) * step / steps), round(y + (to_y - y) * step / steps))
                time.sleep(0.03)
        tool("mouseup", button)
        time.sleep(0.3)

    def seen(self):
        with mss.MSS() as screen:
            shot = screen.grab({"left": 0, "top": 0, "width": self.size[0], "height": self.size[1]})
        return Image.frombytes("RGB", shot.size, shot.rgb)

    def picture(self):
        """What is seen without the lower edge, where messages come and go."""
        seen = self.seen()
        return seen.crop((0, 0, seen.width, seen.height - 120)).tobytes()


def gyroid(path, size=96):
    """A volume: a gyroid in a ball, its values falling off from the walls."""
    axis = np.linspace(-1, 1, size, dtype=np.float32)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    w = 9.0
    field = np.sin(w * x) * np.cos(w * y) + np.sin(w * y) * np.cos(w * z) + np.sin(w * z) * np.cos(w * x)
    inside = np.clip((0.95 - np.sqrt(x * x + y * y + z * z)) * 8, 0, 1)
    values = (np.clip(1.2 - np.abs(field), 0, 1.2) * inside * 800).astype("<i2")
    header = f"NRRD0004\ntype: int16\ndimension: 3\nsizes: {size} {size} {size}\nendian: little\nencoding: raw\n\n"
    path.write_bytes(header.encode() + values.tobytes())


def clipping(program):
    with Window(program, "city") as window:
        window.keys("o", "Home", "shift+b")
        window.wheel(490, 400, -2)
        time.sleep(2)
        window.drag([PLACES["knob"], PLACES["middle of the box"]])
        window.wheel(450, 400, 6)
        window.move(900, 60)
        time.sleep(CLEAN)
        return window.seen()


def values(program):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "gyroid.nrrd"
        gyroid(path)
        with Window(program, str(path)) as window:
            window.click(*PLACES["values"])
            time.sleep(1)
            window.keys("F9")
            window.drag([(480, 400), (530, 360)])
            window.keys("F9")
            time.sleep(CLEAN)
            return window.seen()


def timeline(program):
    with Window(program, "church") as window:
        window.keys("F8", "k")
        window.drag([(300, 300), (420, 330)])
        window.click(*PLACES["middle of the timeline"])
        window.drag([(300, 300), (520, 280)])
        window.keys("k")
        window.click(*PLACES["end of the timeline"])
        window.drag([(500, 300), (420, 360)])
        window.keys("k")
        time.sleep(CLEAN)
        return window.seen()


def parts(program):
    with Window(program, "forest") as window:
        window.click(*PLACES["parts"])
        window.click(480, 470)
        window.wheel(1130, 300, -6)
        window.move(700, 60)
        time.sleep(CLEAN)
        return window.seen()


def comparing(program):
    with Window(program, "city") as window:
        window.keys("b")
        time.sleep(CLEAN)
        return window.seen()


def building(program):
    with Window(program) as window:
        window.keys("ctrl+n", "Return")
        time.sleep(1)
        window.keys("6")
        window.drag([(430, 500), (590, 520)])
        window.keys("7")
        window.drag([(500, 505), (500, 400)])
        window.keys("4")
        window.drag([(640, 300), (720, 340)])
        window.keys("plus", "plus", "plus", "plus")
        window.click(480, 470)
        window.move(540, 440)
        time.sleep(CLEAN)
        return window.seen()


def step(window, do, most=20.0):
    """Does something and waits until another picture is there, which is kept: so the clip shows what a device shows that draws each frame in time."""
    before = window.picture()
    do()
    end = time.monotonic() + most
    while window.picture() == before and time.monotonic() < end:
        time.sleep(0.02)
    window.frames.append(window.seen())


def clip(program):
    """Going around in real-time light, an edit, and standing still until the film alone is seen. A small city, which a device in software traces soon."""
    # Frames as fine as on a device that has the time for them.
    os.environ["VOXTRACE_VIEW_FRAME_MS"] = "60000"
    with (
        tempfile.TemporaryDirectory() as folder,
        contextlib.chdir(folder),
        Window(program, "city", "--voxels", "300000", "--traversal", "walk", size=CLIP) as window,
    ):
        window.keys("o", "Tab", "r")
        time.sleep(6)
        window.move(300, 180)
        tool("mousedown", 1)
        for number in range(1, 25):
            step(window, lambda: tool("mousemove", 300 - 4 * number, 180 - number))
        tool("mouseup", 1)
        window.keys("ctrl+e", "Tab", *["plus"] * 3)
        time.sleep(2)
        window.move(*STROKE[0])
        tool("mousedown", 1)
        (x, y), (to_x, to_y) = STROKE
        for number in range(1, 13):
            step(window, lambda: tool("mousemove", round(x + (to_x - x) * number / 12), round(y + (to_y - y) * number / 12)))
        tool("mouseup", 1)
        window.keys("Escape")
        window.move(5, 5)
        # The picture is written when the film alone is seen.
        window.keys("F12")
        stands, end = [window.seen()], time.monotonic() + 600
        while not list(pathlib.Path(folder).glob("*.png")) and time.monotonic() < end:
            time.sleep(STEP)
            stands.append(window.seen())
        kept = [stands[round(number * (len(stands) - 1) / (STANDS - 1))] for number in range(STANDS)]
        return window.frames + kept


def durations(count):
    """Milliseconds of each picture of the clip: where the window stands, longer; the last one stays."""
    return [1000 // RATE] * (count - STANDS) + [250] * (STANDS - 1) + [2500]


PLACES = {
    "knob": (643, 369),
    "middle of the box": (530, 392),
    "values": (1024, 543),
    "parts": (1024, 584),
    "middle of the timeline": (500, 740),
    "end of the timeline": (960, 740),
}
PICTURES = [clipping, values, timeline, parts, comparing, building]


def main():
    program, folder, *names = sys.argv[1:]
    program, folder = os.path.abspath(program), pathlib.Path(folder).absolute()
    screen = subprocess.Popen(["Xvfb", DISPLAY, "-screen", "0", "1280x800x24"], stderr=subprocess.DEVNULL)
    os.environ["DISPLAY"] = DISPLAY
    time.sleep(1)
    try:
        for make in PICTURES:
            if not names or make.__name__ in names:
                make(program).save(folder / f"window-{make.__name__}.webp", quality=82, method=6)
        if not names or "clip" in names:
            first, *rest = clip(program)
            options = {"duration": durations(len(rest) + 1), "loop": 0, "quality": 60, "method": 4}
            first.save(folder / "window.webp", save_all=True, append_images=rest, **options)
    finally:
        screen.terminate()


if __name__ == "__main__":
    main()
