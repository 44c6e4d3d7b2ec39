"""What people write, for type checkers; it is never run."""

import numpy

import voxtrace

scene: voxtrace.Scene = voxtrace.open("model.vox", resolution=256)
image: voxtrace.Image = voxtrace.render(scene, samples=16, size=(640, 360))
radiance: "numpy.ndarray[tuple[int, ...], numpy.dtype[numpy.float32]]" = image.radiance
grid = voxtrace.VoxelGrid.from_numpy(numpy.zeros((3, 3, 3), numpy.uint8), palette=["#ffffff"], origin=(1, 2, 3))
scene.sky = voxtrace.Sky.uniform("#ffffff").with_sun(height=30)
scene.add(grid, numpy.eye(4), name="box")
hits = voxtrace.Renderer(scene, placeable=True).cast([[0, 0, 0]], [[0, 0, 1]], t_max=5)
moving = voxtrace.open("crane.glb", animation=True, key_fps=12)
voxtrace.Renderer(moving).show(moving.at(moving.animations[0][1] / 2, repeat=True))
voxtrace.save_clip("crane.mp4", (voxtrace.render(moving.at(frame / 24)) for frame in range(48)), quality=90, encoder="builtin")
first: float = float(hits["t"][0])
volume = voxtrace.Volume.from_array(numpy.zeros((3, 3, 3)), spacing=0.5)
scene = volume.voxelize("ct-bone", threshold=300)
editor = voxtrace.Editor(scene)
change: int = editor.sphere((1, 2, 3), 4, None)
camera = voxtrace.Camera((1, 2, 3), (0, 0, 0), lens="thin-lens", aperture=0.5, focus=3.0)
view = voxtrace.view(scene, clip=((0, 0, 0), (1, 1, 1)), renderer="kernel")
scene.clip = ((0, 0, 0), numpy.ones(3))
figure: voxtrace.Image = view.render(size=(640, 360), samples=16)
place: tuple[list[float], list[float]] = camera.ray((10, 20), (640, 360))
value: float = volume[0, 1, 2]
