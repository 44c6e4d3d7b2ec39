"""Clips: pictures, of a renderer or of other programs, as one file that plays."""

import os
import shutil
import sys

import imageio_ffmpeg
import numpy
import pytest
from PIL import Image

import voxtrace

SIZE = (32, 18)


def frames_of(path):
    """The frames of a GIF or an animated PNG, RGBA, and for how many milliseconds each is shown."""
    with Image.open(path) as clip:
        shown = []
        for number in range(clip.n_frames):
            clip.seek(number)
            shown.append((numpy.asarray(clip.convert("RGBA")), clip.info["duration"]))
    return [pixels for pixels, _ in shown], [time for _, time in shown]


@pytest.fixture
def renderer():
    return voxtrace.Renderer(voxtrace.builtin("city", voxels=20_000), device="cpu")


def test_pictures_become_an_animated_png_bit_for_bit(tmp_path, renderer):
    pictures = [renderer.render(size=SIZE, samples=1, seed=seed) for seed in range(3)]
    assert not numpy.array_equal(pictures[0], pictures[1])
    voxtrace.save_clip(tmp_path / "a.png", (picture for picture in pictures), fps=20)
    shown, times = frames_of(tmp_path / "a.png")
    assert times == [50.0] * 3
    for picture, pixels in zip(pictures, shown, strict=True):
        assert (pixels[..., :3] == picture.to_srgb()).all() and (pixels[..., 3] == 255).all()


def test_what_is_transparent_stays_so(tmp_path, renderer):
    picture = renderer.render(size=SIZE, samples=4, transparent=True)
    assert 0 < picture.alpha.mean() < 1
    picture.save(tmp_path / "one.png")
    voxtrace.save_clip(tmp_path / "a.png", [picture, picture])
    for pixels in frames_of(tmp_path / "a.png")[0]:
        assert (pixels == numpy.asarray(Image.open(tmp_path / "one.png"))).all()


def test_frames_of_other_programs_are_clips_too(tmp_path, renderer):
    picture = renderer.render(size=SIZE, samples=1)
    marked = Image.fromarray(picture.to_srgb())
    marked.paste("#ff0000", (0, 0, 4, 4))
    turned = numpy.asarray(picture)[:, ::-1]
    clear = numpy.dstack([turned, numpy.zeros(SIZE[::-1], "uint8")])
    voxtrace.save_clip(tmp_path / "a.gif", [picture, marked, turned, clear], fps=10)
    shown, times = frames_of(tmp_path / "a.gif")
    assert times == [100] * 4
    assert (numpy.abs(shown[1][:4, :4, :3].astype(int) - [255, 0, 0]) < 16).all()
    apart = [numpy.abs(shown[at][..., :3].astype(int) - wanted).mean() for at, wanted in ((0, picture.to_srgb()), (2, turned))]
    assert max(apart) < 4 < numpy.abs(shown[0][..., :3].astype(int) - turned).mean(), apart
    assert shown[3][..., :3].max() < 4, "a GIF has what is transparent before black"


def test_mp4_has_all_frames_in_time(tmp_path):
    frames = [numpy.full((64, 96, 3), 40 + 10 * number, "uint8") for number in range(12)]
    told = []
    voxtrace.save_clip(tmp_path / "a.mp4", iter(frames), fps=12.5, encoder="builtin", progress=told.append)
    film = (tmp_path / "a.mp4").read_bytes()
    assert film[4:8] == b"ftyp" and b"av01" in film
    assert told[-1] == 1.0 and told == sorted(told)
    # The boxes of the container say how many frames there are, and how long they take: ISO/IEC 14496-12, 8.6.1.2 and 8.4.2.
    at = film.index(b"stts")
    runs = numpy.frombuffer(film, ">u4", count=1 + 2 * int.from_bytes(film[at + 8 : at + 12]), offset=at + 8)[1:].reshape(-1, 2)
    scale = int.from_bytes(film[film.index(b"mdhd") + 16 :][:4])
    assert runs[:, 0].sum() == 12
    assert (runs[:, 0] * runs[:, 1]).sum() / scale == pytest.approx(12 / 12.5, abs=0.1)


def test_ffmpeg_is_asked_where_it_is(tmp_path, monkeypatch):
    if sys.platform == "win32":
        pytest.skip("a script with a shell's first line is no program there; test_ffmpeg_makes_h264 asks a real one everywhere")
    frames = [numpy.zeros((20, 30, 3), "uint8")] * 3
    # One of ours that notes what it is given: three frames of three bytes a pixel, and writes to its last argument.
    program = tmp_path / "ffmpeg"
    code = "import sys; got = sys.stdin.buffer.read() if '-i' in sys.argv else b''; '-i' in sys.argv and open(sys.argv[-1], 'w').write(str(len(got)))"
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -c "{code}" "$@"\n')
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    voxtrace.save_clip(tmp_path / "a.mp4", frames)
    assert (tmp_path / "a.mp4").read_text() == str(3 * 3 * 20 * 30)
    # And one that fails says why; what was there stays.
    program.write_text("#!/bin/sh\ncat > /dev/null\necho 'Unknown encoder libx264' >&2\nexit 1\n")
    with pytest.raises(voxtrace.VoxtraceError, match="a.mp4: ffmpeg: Unknown encoder libx264"):
        voxtrace.save_clip(tmp_path / "a.mp4", frames, encoder="ffmpeg")
    assert (tmp_path / "a.mp4").read_text() == str(3 * 3 * 20 * 30)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.mp4", "ffmpeg"]


def test_ffmpeg_makes_h264(tmp_path, monkeypatch):
    # That of the package, whatever the system has.
    folder = tmp_path / "bin"
    folder.mkdir()
    shutil.copy(imageio_ffmpeg.get_ffmpeg_exe(), folder / ("ffmpeg.exe" if sys.platform == "win32" else "ffmpeg"))
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    frames = [numpy.zeros((20, 30, 3), "uint8")] * 3
    voxtrace.save_clip(tmp_path / "a.mp4", frames)
    voxtrace.save_clip(tmp_path / "b.mp4", frames, encoder="builtin")
    made = [(tmp_path / name).read_bytes() for name in ("a.mp4", "b.mp4")]
    assert [b"avc1" in film for film in made] == [True, False]


def test_what_fails_leaves_what_was_there(tmp_path):
    path = tmp_path / "a.png"
    path.write_bytes(b"mine")
    black = numpy.zeros((4, 6, 3), "uint8")

    def broken():
        yield black
        raise ArithmeticError("no more")

    with pytest.raises(ArithmeticError, match="no more"):
        voxtrace.save_clip(path, broken())
    with pytest.raises(ValueError, match=r"frame 1 has 5 × 4 pixels, and the first has 6 × 4"):
        voxtrace.save_clip(path, [black, black[:, :5]])
    with pytest.raises(ValueError, match=r"frame 1: a picture.* not float64 of shape \(4, 6, 3\)"):
        voxtrace.save_clip(path, [black, black * 1.0])
    with pytest.raises(ValueError, match=r"frame 0: shape.*, not \(4, 6, 2\)"):
        voxtrace.save_clip(path, [black[..., :2]])
    with pytest.raises(ValueError, match="at least one frame"):
        voxtrace.save_clip(path, [])
    with pytest.raises(TypeError):
        voxtrace.save_clip(path, 5)
    assert path.read_bytes() == b"mine"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.png"]


def test_what_cannot_be_is_refused_before_a_frame_is_made(tmp_path):
    def never():
        raise AssertionError("a frame was asked for")
        yield

    for name, options, match in [
        ("a.webm", {}, r"a.webm: a clip is .mp4, .gif or .png"),
        ("a.mp4", {"fps": 0}, "fps is a number"),
        ("a.mp4", {"fps": float("nan")}, "fps is a number"),
        ("a.mp4", {"quality": 101}, "quality is a whole number from 0 to 100"),
        ("a.mp4", {"quality": -1}, "quality"),
        ("a.mp4", {"encoder": "x264"}, "neither"),
        ("a.gif", {"encoder": "ffmpeg"}, "ffmpeg is for .mp4"),
    ]:
        with pytest.raises(ValueError, match=match):
            voxtrace.save_clip(tmp_path / name, never(), **options)
    with pytest.raises(OSError, match="none"):
        voxtrace.save_clip(tmp_path / "none" / "a.mp4", never())
    assert not any(tmp_path.iterdir())


def test_ctrl_c_ends_encoding(tmp_path, ctrl_c_ends):
    noise = numpy.random.default_rng(1).integers(0, 255, (360, 640, 3), "uint8")
    path = tmp_path / "a.mp4"
    ctrl_c_ends(lambda frames=frames: voxtrace.save_clip(path, [noise] * frames, encoder="builtin") for frames in (20, 80, 320))
