"""Writes volumes with channels and time points, and what each of them holds: python hyperstacks.py FOLDER. Needs tifffile, zarr,
nibabel, pynrrd and pillow."""

import json
import sys
from pathlib import Path

import nibabel
import nrrd
import numpy as np
import tifffile
import zarr
from PIL import Image

folder = Path(sys.argv[1])
random = np.random.default_rng(5)
# Time points, slices, channels, rows, columns.
T, Z, C, Y, X = 2, 5, 3, 6, 7
data = random.integers(0, 4096, (T, Z, C, Y, X)).astype(np.uint16)
data[:, :, 1] //= 4
data.astype("<f4").tofile(folder / "data.f32")
USUAL = [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
files = {}


def composite(name, colors, windows=None, time=0):
    """The hue of the colours that the channels of a time point add up to, as bright as the brightest channel."""
    sums, most = np.zeros((Z, Y, X, 3)), np.zeros((Z, Y, X, 1))
    for channel, color in enumerate(colors):
        values = data[time, :, channel].astype(np.float32)
        every = np.sort(values.ravel())
        low, high = windows[channel] if windows else (every[0], every[int((every.size - 1) * 0.999)])
        share = np.clip((values - low) / (high - low), 0, 1)[..., None]
        sums, most = sums + share * np.array(color, float), np.maximum(most, share)
    hue = sums / np.maximum(sums.max(axis=-1, keepdims=True), 1e-9)
    np.round(hue * (0.5 + 0.5 * most) * 255).astype(np.uint8).tofile(folder / f"{name}.rgb")


def add(name, spacing, **about):
    files[name] = {"spacing": spacing, **about}


# ImageJ: without colours, and with tables and ranges of their own.
tifffile.imwrite(folder / "imagej.tif", data, imagej=True, resolution=(1 / 0.2, 1 / 0.4), metadata={"axes": "TZCYX", "spacing": 1.5, "unit": "um"})
add("imagej.tif", [0.0002, 0.0004, 0.0015])
composite("imagej.tif", USUAL)
colors, windows = [(255, 128, 0), (0, 255, 255), (200, 0, 200)], [(100.0, 3000.0), (0.0, 900.0), (500.0, 4000.0)]
ramp = np.arange(256)
luts = [np.stack([ramp * part // 255 for part in color]).astype(np.uint8) for color in colors]
tifffile.imwrite(
    folder / "looks.tif", data, imagej=True, metadata={"axes": "TZCYX", "mode": "composite", "LUTs": luts, "Ranges": tuple(n for window in windows for n in window)},
)
add("looks.tif", None)
composite("looks.tif", colors, windows)
# OME-TIFF in two orders of its axes.
for name, axes, turn in [("a.ome.tif", "TZCYX", (0, 1, 2, 3, 4)), ("b.ome.tif", "CTZYX", (2, 0, 1, 3, 4))]:
    metadata = {
        "axes": axes, "PhysicalSizeX": 0.2, "PhysicalSizeXUnit": "µm", "PhysicalSizeY": 400.0, "PhysicalSizeYUnit": "nm", "PhysicalSizeZ": 1.5,
        "Channel": {"Name": ["one", "two", "three"], "Color": [0xFF8000FF - (1 << 32), 0x00FFFFFF, 0xC800C8FF - (1 << 32)]},
    }
    tifffile.imwrite(folder / name, data.transpose(turn), ome=True, metadata=metadata)
    add(name, [0.0002, 0.0004, 0.0015])
    composite(name, colors)
# OME-Zarr 0.4, 0.5, and the axes and systems of 0.6; and an array that names its axes.
axes = [{"name": n, "type": k, **({"unit": "micrometer"} if k == "space" else {})} for n, k in zip("tczyx", ["time", "channel"] + ["space"] * 3)]
scale = [1.0, 1.0, 1.5, 0.4, 0.2]
omero = {"channels": [{"color": "%02X%02X%02X" % color, "window": {"start": low, "end": high, "min": 0, "max": 65535}} for color, (low, high) in zip(colors, windows)]}
turned = data.transpose(0, 2, 1, 3, 4)
for name, version in [("four.zarr", 2), ("five.zarr", 3), ("six.zarr", 3)]:
    group = zarr.open_group(folder / name, mode="w", zarr_format=version)
    array = group.create_array("0", shape=turned.shape, chunks=(1, 2, 2, 4, 4), dtype="u2")
    array[:] = turned
    step = {"type": "scale", "scale": scale}
    picture = {"axes": axes, "datasets": [{"path": "0", "coordinateTransformations": [step]}]}
    if name == "six.zarr":
        sequence = {"type": "sequence", "transformations": [step, {"type": "translation", "translation": [0, 0, 3.0, 2.0, 1.0]}], "input": "0", "output": "physical"}
        other = {"name": "other", "axes": [{"name": n, "type": "space"} for n in "abcde"]}
        picture = {
            "coordinateSystems": [other, {"name": "physical", "axes": axes}],
            "datasets": [{"path": "0", "coordinateTransformations": [sequence]}],
            "coordinateTransformations": [{"type": "scale", "scale": [9.0] * 5, "input": "physical", "output": "other"}],
        }
    attributes = {"multiscales": [picture], "omero": omero}
    group.attrs.update(attributes if version == 2 else {"ome": {"version": "0.6" if name == "six.zarr" else "0.5", **attributes}})
    origin = [0.001, 0.002, 0.003] if name == "six.zarr" else [0.0, 0.0, 0.0]
    add(name, [0.0002, 0.0004, 0.0015], origin=origin)
    composite(name, colors, windows)
array = zarr.create_array(folder / "named.zarr", shape=turned.shape, chunks=(2, 1, 3, 6, 7), dtype="u2", dimension_names=["t", "c", "z", "y", "x"])
array[:] = turned
add("named.zarr", [1.0, 1.0, 1.0])
composite("named.zarr", USUAL)

# Time as a fourth axis: NIfTI (x fastest), NumPy, NRRD, MetaImage.
series = np.ascontiguousarray(data[:, :, 0])
nibabel.save(nibabel.Nifti1Image(series.transpose(3, 2, 1, 0), np.eye(4)), folder / "series.nii.gz")
np.save(folder / "series.npy", series)
directions = np.array([[np.nan] * 3, [0, 0, 1.5], [0, 0.4, 0], [0.2, 0, 0]])[::-1]
nrrd.write(str(folder / "series.nrrd"), series.transpose(3, 2, 1, 0), {"space": "left-posterior-superior", "space directions": directions, "kinds": ["domain", "domain", "domain", "list"]})
head = f"ObjectType = Image\nNDims = 4\nDimSize = {X} {Y} {Z} {T}\nElementType = MET_USHORT\nElementDataFile = LOCAL\n"
(folder / "series.mha").write_bytes(head.encode() + series.astype("<u2").tobytes())

# Pages of few bits, and pages in which white is 0 (which Pillow turns round, and tifffile does not).
bits = random.integers(0, 2, (Z, Y, 11)).astype(bool)
bits.astype("<f4").tofile(folder / "bits.f32")
tifffile.imwrite(folder / "bits.tif", bits, photometric="minisblack")
tifffile.imwrite(folder / "bits_turned.tif", ~bits, photometric="miniswhite")
grey = random.integers(0, 256, (Z, Y, 11)).astype(np.uint8)
grey.astype("<f4").tofile(folder / "grey.f32")
tifffile.imwrite(folder / "grey_turned.tif", 255 - grey, photometric="miniswhite")
tifffile.imwrite(folder / "deep_turned.tif", (65535 - grey.astype(np.uint16) * 257), photometric="miniswhite")
# Slices alone, and of those fewer than the description announces.
tifffile.imwrite(folder / "plain.tif", grey, imagej=True, resolution=(1 / 0.2, 1 / 0.4), metadata={"axes": "ZYX", "spacing": 1.5, "unit": "um"})
tifffile.imwrite(folder / "short.tif", grey, resolution=(1 / 0.2, 1 / 0.4), metadata=None, description="ImageJ=1.54f\nimages=9\nslices=9\nunit=um\nspacing=1.5\n")
with Image.open(folder / "bits_turned.tif") as page:
    assert (np.array(page) == bits[0]).all()
with Image.open(folder / "grey_turned.tif") as page:
    assert (np.array(page) == grey[0]).all()

# Colours: red, green, blue, and opacity.
rgb = random.integers(0, 256, (Z, Y, X, 4)).astype(np.uint8)
rgb.tofile(folder / "colors.rgba")
for count, kind, name in [(3, [("R", "u1"), ("G", "u1"), ("B", "u1")], "rgb"), (4, [("R", "u1"), ("G", "u1"), ("B", "u1"), ("A", "u1")], "rgba")]:
    some = np.ascontiguousarray(rgb[..., :count])
    structured = some.view(np.dtype(kind))[..., 0]
    nibabel.save(nibabel.Nifti1Image(structured.transpose(2, 1, 0), np.eye(4)), folder / f"{name}.nii")
    np.save(folder / f"{name}.npy", some)
    kinds = [f"{name.upper()}-color", "domain", "domain", "domain"]
    nrrd.write(str(folder / f"{name}.nrrd"), some.transpose(3, 2, 1, 0), {"kinds": kinds})
    head = f"ObjectType = Image\nNDims = 3\nDimSize = {X} {Y} {Z}\nElementType = MET_UCHAR\nElementNumberOfChannels = {count}\nElementDataFile = LOCAL\n"
    (folder / f"{name}.mha").write_bytes(head.encode() + some.tobytes())
# Vectors of floats: of a field, in MetaImage, NRRD and along NIfTI's fifth axis.
field = random.normal(size=(Z, Y, X, 3)).astype("<f4")
field.tofile(folder / "field.f32")
head = f"ObjectType = Image\nNDims = 3\nDimSize = {X} {Y} {Z}\nElementType = MET_FLOAT\nElementNumberOfChannels = 3\nElementDataFile = LOCAL\n"
(folder / "field.mha").write_bytes(head.encode() + field.tobytes())
nrrd.write(str(folder / "field.nrrd"), field.transpose(3, 2, 1, 0), {"kinds": ["vector", "domain", "domain", "domain"]})
nibabel.save(nibabel.Nifti1Image(field.transpose(2, 1, 0, 3)[:, :, :, None, :], np.eye(4)), folder / "field.nii")

(folder / "files.json").write_text(json.dumps({"size": [X, Y, Z], "times": T, "channels": C, "files": files}))
