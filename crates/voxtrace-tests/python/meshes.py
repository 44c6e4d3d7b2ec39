"""Writes meshes with trimesh, another program's library, for the tests of the importers: python meshes.py FOLDER"""

import sys
from pathlib import Path

import numpy as np
import trimesh
from PIL import Image

folder = Path(sys.argv[1])

# A torus on its side with a box, in one mesh: bounds that tell the axes apart. The formats keep singles.
torus = trimesh.creation.torus(major_radius=2.0, minor_radius=0.5, major_sections=48, minor_sections=24)
box = trimesh.creation.box(extents=[1.0, 0.5, 3.0])
box.apply_translation([0.25, 3.0, 1.0])
mesh = trimesh.util.concatenate([torus, box])
mesh.vertices = mesh.vertices.astype(np.float32)
mesh.export(folder / "shape.glb")
mesh.export(folder / "shape.obj")
mesh.export(folder / "shape_text.ply", encoding="ascii")
mesh.export(folder / "shape_binary.ply")
mesh.export(folder / "shape_text.stl", file_type="stl_ascii")
mesh.export(folder / "shape_binary.stl")

# The same colour at each vertex, in the formats that have colours.
colored = mesh.copy()
colored.visual = trimesh.visual.ColorVisuals(colored, vertex_colors=np.tile([200, 100, 50, 255], (len(mesh.vertices), 1)))
colored.export(folder / "colored.ply")

# A textured square of 4 x 4 texels, in every format that has textures.
texels = np.zeros((4, 4, 3), np.uint8)
texels[..., 0] = np.arange(4) * 60
texels[..., 1] = (np.arange(4) * 60)[:, None]
texels[..., 2] = 200
image = Image.fromarray(texels)
square = trimesh.Trimesh([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], [[0, 1, 2], [0, 2, 3]], process=False)
material = trimesh.visual.material.PBRMaterial(baseColorTexture=image, metallicFactor=0.0, roughnessFactor=1.0)
square.visual = trimesh.visual.TextureVisuals(uv=[[0, 0], [1, 0], [1, 1], [0, 1]], material=material)
square.export(folder / "square.glb")
simple = square.copy()
simple.visual = trimesh.visual.TextureVisuals(uv=square.visual.uv, image=image)
simple.export(folder / "square.obj")

print("written by trimesh", trimesh.__version__)
