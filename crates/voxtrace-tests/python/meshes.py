"""Writes meshes with trimesh, and compressed ones with DracoPy and meshopt, other programs' libraries, for the tests of the
importers: python meshes.py FOLDER"""

import json
import struct
import sys
from pathlib import Path

import DracoPy
import meshopt
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

# A colour of each face: of the box others than of the torus.
painted = mesh.copy()
paints = np.where(np.arange(len(mesh.faces))[:, None] < len(torus.faces), [[200, 100, 50, 255]], [[40, 90, 220, 255]])
painted.visual = trimesh.visual.ColorVisuals(painted, face_colors=paints.astype(np.uint8))
painted.export(folder / "painted_binary.ply")
painted.export(folder / "painted_text.ply", encoding="ascii")

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


# The torus and the box once more, in glTF files that are compressed.
BYTE, FLOAT, SHORT, WORD = 5121, 5126, 5123, 5125
vertices, faces = mesh.vertices.astype(np.float32), mesh.faces.astype(np.uint32)
colors = np.tile(np.array([200, 100, 50, 255], np.uint8), (len(vertices), 1))


def glb(name, document, binary):
    document = {"asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], **document}
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary))
    parts = [struct.pack("<I4s", len(text), b"JSON"), text, struct.pack("<I4s", len(binary), b"BIN\0"), binary]
    (folder / name).write_bytes(head + b"".join(parts))


def accessor(view, kind, component, count, **more):
    view = {} if view is None else {"bufferView": view}
    return {**view, "type": kind, "componentType": component, "count": count, **more}


extents = {"min": vertices.min(0).tolist(), "max": vertices.max(0).tolist()}
# Below level 5, edges are coded by valences; at 10 one after the other.
for level in [1, 7, 10]:
    packed = DracoPy.encode(vertices, faces, quantization_bits=22, compression_level=level, colors=colors)
    ids = {attribute["attribute_type"]: attribute["unique_id"] for attribute in DracoPy.decode(packed).attributes}
    draco = {"bufferView": 0, "attributes": {"POSITION": ids[0], "COLOR_0": ids[2]}}
    primitive = {"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2}
    primitive["extensions"] = {"KHR_draco_mesh_compression": draco}
    glb(
        f"draco_{level}.glb",
        {
            "extensionsRequired": ["KHR_draco_mesh_compression"],
            "meshes": [{"primitives": [primitive]}],
            "buffers": [{"byteLength": len(packed)}],
            "bufferViews": [{"buffer": 0, "byteLength": len(packed)}],
            "accessors": [
                accessor(None, "VEC3", FLOAT, len(vertices), **extents),
                accessor(None, "VEC4", BYTE, len(vertices), normalized=True),
                accessor(None, "SCALAR", WORD, faces.size),
            ],
        },
        packed,
    )


def packed_views(name, parts, component):
    views, binary = [], b""
    for data, stride, count, mode, kind in parts:
        extension = {"buffer": 0, "byteOffset": len(binary), "byteLength": len(data), "byteStride": stride}
        extension |= {"count": count, "mode": mode, "filter": kind}
        view = {"buffer": 1, "byteLength": stride * count, "extensions": {"EXT_meshopt_compression": extension}}
        views.append(view | ({"byteStride": stride} if mode == "ATTRIBUTES" else {}))
        binary += data + b"\0" * (-len(data) % 4)
    fallback = {"byteLength": sum(view["byteLength"] for view in views)}
    fallback["extensions"] = {"EXT_meshopt_compression": {"fallback": True}}
    glb(
        name,
        {
            "extensionsRequired": ["EXT_meshopt_compression"],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "COLOR_0": 1}, "indices": 2}]}],
            "buffers": [{"byteLength": len(binary)}, fallback],
            "bufferViews": views,
            "accessors": [
                accessor(0, "VEC3", FLOAT, len(vertices), **extents),
                accessor(1, "VEC4", BYTE, len(vertices), normalized=True),
                accessor(2, "SCALAR", component, faces.size),
            ],
        },
        binary,
    )


def attributes(data):
    return meshopt.encode_vertex_buffer_level(data, 2, 0), data.itemsize * data.shape[1], len(data), "ATTRIBUTES", "NONE"


triangles = meshopt.encode_gltf_buffer(faces.reshape(-1), "TRIANGLES")
shorts = faces.reshape(-1).astype(np.uint16)
sequence = meshopt.encode_gltf_buffer(shorts, "INDICES")
packed_views(
    "meshopt.glb", [attributes(vertices), attributes(colors), (triangles, 4, faces.size, "TRIANGLES", "NONE")], WORD
)
floats = meshopt.encode_filter_exp(vertices, 24, "Separate")
floats = attributes(np.frombuffer(np.ascontiguousarray(floats).tobytes(), np.uint8).reshape(len(vertices), 12))
packed_views(
    "meshopt_filtered.glb",
    [(*floats[:4], "EXPONENTIAL"), attributes(colors), (sequence, 2, faces.size, "INDICES", "NONE")],
    SHORT,
)

print("written by trimesh", trimesh.__version__)
