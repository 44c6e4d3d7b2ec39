"""A process that was forked from one that has worked: whatever it calls answers, or says that the threads stayed behind. Nothing waits for them."""

import copy
import inspect
import os
import pickle
import signal
import subprocess
import sys
import traceback
from collections.abc import Callable
from pathlib import Path

import numpy
import pytest

import voxtrace
from voxtrace import _voxtrace

#: Seconds after which a call waits for ever.
PATIENCE = 120
#: Edge of a grid of more bricks than one thread sorts alone, and instances that one does not place alone.
EDGE, INSTANCES = 136, 3000


def test_nothing_waits_for_threads_that_a_fork_left_behind(tmp_path):
    if not hasattr(os, "fork"):
        pytest.skip("this system does not fork")
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    done = subprocess.run([sys.executable, __file__, tmp_path], env=environment, capture_output=True, text=True, timeout=1800)
    assert done.returncode == 0, done.stdout + done.stderr


def calls_of(folder: Path) -> dict[str, Callable[[], object]]:
    """Something to do with all that is public, with things that this process has made by many threads."""
    labels = numpy.ones((EDGE, EDGE, EDGE), "uint8")
    small = numpy.ones((20, 20, 20), "uint8")
    made = voxtrace.VoxelGrid.from_numpy(labels)
    scene = voxtrace.Scene(made)
    for _ in range(INSTANCES - 1):
        scene.add_copy(0, numpy.eye(4))
    placeable = voxtrace.Renderer(scene, device="cpu", placeable=True)
    places = numpy.stack([numpy.array(instance.transform) for instance in scene.instances])
    packed = voxtrace.Scene.from_bytes(voxtrace.Scene(made).to_bytes())
    changed = voxtrace.Scene(made)
    grid = packed.grid(0)
    volume = voxtrace.Volume.from_array(numpy.mgrid[0:40, 0:40, 0:40].sum(0), name="a")
    camera, material, sky = voxtrace.Camera((300, 200, 150), (0, 0, 0)), voxtrace.Material(), voxtrace.Sky.uniform((1, 1, 1))
    transfer = voxtrace.TransferFunction([(1, "#ff0000")])
    renderer = voxtrace.Renderer(packed, device="cpu")
    options = {"samples": 1, "size": (16, 9)}
    image, other = (renderer.render(camera, first_sample=first, aovs=True, denoise=False, **options) for first in (0, 1))
    film = image.to_bytes()
    editor = voxtrace.Editor(packed)
    follower = voxtrace.Renderer(editor, device="cpu")
    editor.set([[0, 0, EDGE]], 0)
    file = folder / "a.vxt"
    packed.save(file)
    calls: dict[str, Callable[[], object]] = {
        "builtin": lambda: voxtrace.builtin("city", voxels=20_000),
        "open": lambda: voxtrace.open(file),
        "open_volume": lambda: voxtrace.open_volume(folder / "none.nii"),
        "save_clip": lambda: voxtrace.save_clip(folder / "a.gif", [image]),
        "render": lambda: voxtrace.render(packed, camera, device="cpu", progress=False, **options),
        "Camera": lambda: voxtrace.Camera((1, 2, 3), (0, 0, 0)),
        "Camera.ray": lambda: camera.ray((1, 2), (16, 9)),
        "Editor": lambda: voxtrace.Editor(packed),
        "Editor.add_material": lambda: editor.add_material(material),
        "Editor.fill": lambda: editor.fill((0, 0, 0), (9, 9, 9), None),
        "Editor.get": lambda: editor.get((0, 0, 0)),
        "Editor.paint": lambda: editor.paint((0, 0, 0), 3, 0),
        "Editor.redo": lambda: editor.redo(),
        "Editor.replace": lambda: editor.replace(0, None),
        "Editor.scene": lambda: editor.scene(),
        "Editor.set": lambda: editor.set([[0, 0, 0]], None),
        "Editor.sphere": lambda: editor.sphere((0, 0, 0), 3, 0),
        "Editor.stroke": lambda: editor.stroke((0, 0, 0), (9, 9, 9), 3, 0),
        "Editor.undo": lambda: editor.undo(),
        "Image.aov": lambda: image.aov("normal"),
        "Image.denoise": lambda: image.denoise(packed),
        "Image.from_bytes": lambda: voxtrace.Image.from_bytes(film),
        "Image.merge": lambda: voxtrace.Image.merge([image, other]),
        "Image.save": lambda: image.save(folder / "a.png"),
        "Image.to_bytes": lambda: image.to_bytes(),
        "Image.to_srgb": lambda: image.to_srgb(),
        "Image._repr_png_": lambda: image._repr_png_(),
        "Material": lambda: voxtrace.Material("#ff8800"),
        "Renderer": lambda: voxtrace.Renderer(packed, device="cpu"),
        "Renderer of an editor": lambda: voxtrace.Renderer(editor, device="cpu"),
        "Renderer.cast": lambda: renderer.cast(numpy.zeros((9000, 3)), numpy.ones((9000, 3))),
        "Renderer.default_camera": lambda: renderer.default_camera(),
        "Renderer.follow": lambda: follower.follow(editor),
        "Renderer.place": lambda: placeable.place(places),
        "Renderer.render": lambda: renderer.render(camera, **options),
        "Renderer.render_like": lambda: renderer.render_like(image, samples=1),
        "Renderer.show": lambda: renderer.show(packed),
        "Scene": lambda: voxtrace.Scene(grid),
        "Scene.add": lambda: changed.add(made),
        "Scene.add to a packed one": lambda: packed.add(grid),
        "Scene.add_copy": lambda: packed.add_copy(0, numpy.eye(4)),
        "Scene.at": lambda: changed.at(1.0),
        "Scene.from_bytes": lambda: voxtrace.Scene.from_bytes(file.read_bytes()),
        "Scene.grid": lambda: packed.grid(0),
        "Scene.info": lambda: packed.info(),
        "Scene.place": lambda: packed.place(0, numpy.eye(4)),
        "Scene.save": lambda: changed.save(folder / "b.vox"),
        "Scene.set_material": lambda: packed.set_material(0, material),
        "Scene.to_bytes": lambda: packed.to_bytes(),
        "Scene.cameras = ": lambda: setattr(packed, "cameras", [camera]),
        "Scene.clip = ": lambda: setattr(packed, "clip", ((0, 0, 0), (9, 9, 9))),
        "Scene.light_intensity = ": lambda: setattr(packed, "light_intensity", 2.0),
        "Scene.sky = ": lambda: setattr(packed, "sky", sky),
        "Sky.black": lambda: voxtrace.Sky.black(),
        "Sky.environment": lambda: voxtrace.Sky.environment(folder / "none.hdr"),
        "Sky.gradient": lambda: voxtrace.Sky.gradient("#000000", "#ffffff"),
        "Sky.uniform": lambda: voxtrace.Sky.uniform("#ffffff"),
        "Sky.with_brightness": lambda: sky.with_brightness(2),
        "Sky.with_sun": lambda: sky.with_sun(),
        "TransferFunction": lambda: voxtrace.TransferFunction([(1, "#ff0000")]),
        "TransferFunction.labels": lambda: voxtrace.TransferFunction.labels({1: "#ff0000"}),
        "TransferFunction.preset": lambda: voxtrace.TransferFunction.preset("mri"),
        "Volume.from_array": lambda: voxtrace.Volume.from_array(small),
        "Volume.histogram": lambda: volume.histogram(),
        "Volume.to_numpy": lambda: volume.to_numpy(),
        "Volume.voxelize": lambda: volume.voxelize(),
        "Volume[…]": lambda: volume[0, 0, 0],
        "VoxelGrid.from_numpy": lambda: voxtrace.VoxelGrid.from_numpy(labels),
        "VoxelGrid.to_numpy": lambda: grid.to_numpy(),
        "VoxelGrid[…]": lambda: (grid[0, 0, 0], len(grid)),
        "join_mesh_surveys": lambda: _voxtrace.join_mesh_surveys([b""]),
        "join_surveys": lambda: _voxtrace.join_surveys([b""]),
    }
    things = {"grid": grid, "scene": changed, "packed scene": packed, "volume": volume, "camera": camera, "material": material}
    things |= {"sky": sky, "transfer": transfer, "renderer": renderer, "image": image, "editor": editor, "instance": changed.instances[0]}
    for name, thing in things.items():
        calls[f"repr of {name}"] = lambda thing=thing: repr(thing)
        if name not in ["renderer", "editor"]:
            calls[f"copy of {name}"] = lambda thing=thing: copy.deepcopy(thing)
            calls[f"pickle of {name}"] = lambda thing=thing: pickle.dumps(thing)
            calls[f"{name} of a pickle"] = lambda pickled=pickle.dumps(thing): pickle.loads(pickled)
        for member, value in vars(type(thing)).items():
            if inspect.isdatadescriptor(value) and not member.startswith("__"):
                calls[f"{name}: {member}"] = lambda thing=thing, member=member: getattr(thing, member)
    # Whatever is new is called here too.
    kinds = [kind for name in voxtrace.__all__ if inspect.isclass(kind := getattr(voxtrace, name)) and not issubclass(kind, Exception)]
    assert {type(thing) for thing in things.values()} == set(kinds)
    for kind in kinds:
        for member, value in vars(kind).items():
            if not member.startswith("_") and not inspect.isdatadescriptor(value):
                assert f"{kind.__name__}.{member}" in calls, f"{kind.__name__}.{member} is not called in a process that was forked"
    return calls


def ends(call: Callable[[], object]) -> int:
    """How a process that was forked ends with a call: 0 where it answers, or says why it does not."""
    process = os.fork()
    if process == 0:
        # Also where all its threads wait.
        signal.signal(signal.SIGALRM, signal.SIG_DFL)
        signal.alarm(PATIENCE)
        try:
            call()
        except RuntimeError as error:
            os._exit(0 if "spawn" in str(error) else 1)
        except (voxtrace.VoxtraceError, OSError):
            # Of files and surveys that there are not.
            os._exit(0)
        except BaseException:
            traceback.print_exc()
            os._exit(1)
        os._exit(0)
    return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])


def main() -> None:
    failed = []
    for name, call in calls_of(Path(sys.argv[1])).items():
        code = ends(call)
        if code != 0:
            failed.append(f"{name}: {'waits for ever' if code == -signal.SIGALRM else f'ends with {code}'}")
        if len(failed) == 3:
            break
    if failed:
        sys.exit("\n".join(failed))


if __name__ == "__main__":
    main()
