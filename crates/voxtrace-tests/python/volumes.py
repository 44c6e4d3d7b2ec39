"""Writes volumes in the formats of other programs, and beside each what their own libraries read from it: python volumes.py FOLDER. Needs
nibabel, numpy, pynrrd, zarr, tensorstore, tifffile (with imagecodecs) and pydicom. `volumes.json` names each file with its size and, where it has one, its affine
matrix in the axes left, posterior, superior; `NAME.f32` has its values, x fastest."""

import bz2
import json
import shutil
import sys
from pathlib import Path

import imagecodecs
import nibabel
import nrrd
import numpy as np
import pydicom
import tensorstore
import tifffile
import zarr
from pydicom.fileset import FileSet

folder = Path(sys.argv[1])
manifest = []
random = np.random.default_rng(11)
TO_LPS = np.diag([-1.0, -1.0, 1.0, 1.0])


def add(path, values, affine=None, **options):
    """Notes a file whose values, indexed by x, y and z, its own library has read."""
    name = path.replace("/", "_")
    np.asarray(values).astype("<f4").ravel(order="F").tofile(folder / f"{name}.f32")
    affine = None if affine is None else np.asarray(affine).tolist()
    manifest.append({"path": path, "name": name, "size": list(values.shape), "affine": affine, **options})


def add_nibabel(path, **options):
    image = nibabel.load(folder / path)
    add(path, image.get_fdata(), TO_LPS @ image.affine, **options)


volume = random.integers(0, 1000, (13, 11, 7)).astype(np.int16)
oblique = nibabel.affines.from_matvec(
    nibabel.eulerangles.euler2mat(0.3, 0.2, 0.1) @ np.diag([0.5, 0.75, 1.25]), [10, -20, 30]
)
flipped = np.array([[0, 0, -1.25, 5], [0.5, 0, 0, -3], [0, 0.75, 0, 9], [0, 0, 0, 1.0]])

# FreeSurfer, of every kind of number.
for kind in ["uint8", "int32", "float32", "int16"]:
    data = (volume % 200).astype(kind)
    nibabel.save(nibabel.MGHImage(data, oblique.astype("f4")), folder / f"{kind}.mgh")
    add_nibabel(f"{kind}.mgh")
nibabel.save(nibabel.MGHImage(volume, flipped.astype("f4")), folder / "flipped.mgz")
add_nibabel("flipped.mgz")
frames = np.stack([volume, volume + 1], axis=3)
nibabel.save(nibabel.MGHImage(frames, oblique.astype("f4")), folder / "frames.mgz")
image = nibabel.load(folder / "frames.mgz")
add("frames.mgz", image.get_fdata()[..., 1], TO_LPS @ image.affine, time=2)
# Without a place of its own, which then is that of FreeSurfer's coronal slices (nibabel has two axes the other way round).
head = bytearray((folder / "int16.mgh").read_bytes())
head[28:30] = b"\0\0"
(folder / "placeless.mgh").write_bytes(head)
coronal = np.array([[-1.0, 0, 0], [0, 0, 1], [0, -1, 0]])
coronal = nibabel.affines.from_matvec(coronal, -coronal @ np.array(volume.shape) / 2)
add("placeless.mgh", nibabel.load(folder / "placeless.mgh").get_fdata(), TO_LPS @ coronal)

# Pairs: NIfTI, also packed, and Analyze with the scale and origin of SPM and without.
nibabel.save(nibabel.Nifti1Pair(volume, oblique), folder / "pair.img")
add_nibabel("pair.img")
shutil.copy(folder / "pair.img", folder / "by_header.img")
shutil.copy(folder / "pair.hdr", folder / "by_header.hdr")
image = nibabel.load(folder / "by_header.img")
add("by_header.hdr", image.get_fdata(), TO_LPS @ image.affine)
nibabel.save(nibabel.Nifti2Pair(volume.astype("f8"), flipped), folder / "second.img.gz")
image = nibabel.load(folder / "second.img.gz")
(folder / "second.hdr").unlink(missing_ok=True)
add("second.img.gz", image.get_fdata(), TO_LPS @ image.affine)
for name, kind, data in [
    ("plain", nibabel.AnalyzeImage, volume),
    ("spm99", nibabel.Spm99AnalyzeImage, volume.astype("f4") * 0.37),
    ("spm2", nibabel.Spm2AnalyzeImage, volume),
]:
    image = kind(data, np.diag([-2.0, 2.5, 3.0, 1.0]) if name == "plain" else None)
    image.header.set_zooms((2.0, 2.5, 3.0))
    if name == "spm99":
        image.header.set_data_dtype(np.int16)
        image.header["origin"][:3] = [4, 5, 2]
    nibabel.save(image, folder / f"{name}.img")
    (folder / f"{name}.mat").unlink(missing_ok=True)
    add_nibabel(f"{name}.img", tolerance=1e-3)

# Philips: headers of scanners, each with pictures of random numbers, which need not be in the order of the slices.
headers = Path(nibabel.__file__).parent / "tests/data"
for path in sorted(headers.glob("*.PAR")):
    try:
        with path.open() as file:
            head = nibabel.parrec.PARRECHeader.from_fileobj(file)
    except nibabel.parrec.PARRECError:
        continue
    count = len(head.image_defs)
    size = int(head.image_defs["recon resolution"][0].prod())
    if count * size > 1_500_000:
        continue
    name = f"par_{path.stem}".replace("-", "_").replace("+", "_")
    shutil.copy(path, folder / f"{name}.PAR")
    random.integers(0, 2000, count * size).astype("<i2").tofile(folder / f"{name}.REC")
    try:
        image = nibabel.load(folder / f"{name}.PAR")
        data = image.get_fdata()
    except nibabel.parrec.PARRECError:
        continue
    add(f"{name}.PAR", data if data.ndim == 3 else data[..., 0], TO_LPS @ image.affine, tolerance=1e-2)
    if data.ndim == 4:
        add(f"{name}.REC", data[..., -1], TO_LPS @ image.affine, tolerance=1e-2, time=data.shape[3])

# NRRD: bzip2, and samples in several files.
header = {"spacings": [0.5, 0.75, 1.25]}
spaced = np.diag([0.5, 0.75, 1.25, 1.0])
nrrd.write(str(folder / "bzip2.nrrd"), volume, {**header, "encoding": "bzip2"})
add("bzip2.nrrd", nrrd.read(str(folder / "bzip2.nrrd"))[0], spaced)
text = "NRRD0004\ntype: short\ndimension: 3\nsizes: 13 11 7\nspacings: 0.5 0.75 1.25\nendian: little\nencoding: {}\n"
for n in range(7):
    layer = volume[:, :, n].ravel(order="F").astype("<i2").tobytes()
    (folder / f"layer{n + 1:02}.raw").write_bytes(layer)
    (folder / f"layer{n + 1}.bz2").write_bytes(b"a line\n" + bz2.compress(b"abc" + layer))
names = "".join(f"layer{n + 1:02}.raw\n" for n in range(7))
(folder / "list.nhdr").write_text(text.format("raw") + "data file: LIST 2\n" + names)
(folder / "numbered.nhdr").write_text(text.format("raw") + "data file: layer%02d.raw 1 7 1 2\n")
(folder / "packed.nhdr").write_text(
    text.format("bzip2") + "line skip: 1\nbyte skip: 3\ndata file: layer%d.bz2 1 7 1\n"
)
# pynrrd does not read those: the values are what was cut up above.
for name in ["list.nhdr", "numbered.nhdr", "packed.nhdr"]:
    add(name, volume, spaced)
# Time as the first axis, as 3D Slicer writes sequences.
times = np.stack([volume, volume + 1, volume[::-1]])
directions = np.vstack([[np.nan] * 3, np.diag([0.5, 0.75, 1.25])])
header = {"space": "left-posterior-superior", "space directions": directions, "space origin": [0.0] * 3}
for name, options in [("times.nrrd", {}), ("later.nrrd", {"time": 3})]:
    nrrd.write(str(folder / name), times, {**header, "kinds": ["list", "domain", "domain", "domain"]})
    found = nrrd.read(str(folder / name))[0]
    add(name, found[options.get("time", 1) - 1], spaced, whole=True, **options)

# NumPy: halves, and archives of arrays.
half = random.normal(size=(5, 6, 7)).astype(np.float16)
half[0, 0, 0], half[0, 0, 1] = 6e-8, 65504
np.save(folder / "half.npy", half)
add("half.npy", np.load(folder / "half.npy").T)
np.savez(folder / "arrays.npz", small=np.arange(8).reshape(2, 2, 2), large=volume)
add("arrays.npz", np.load(folder / "arrays.npz")["large"].T)
np.savez_compressed(folder / "packed.npz", first=half, second=volume[:2])
add("packed.npz", np.load(folder / "packed.npz")["first"].T, series=1)

# Zarr: halves, bzip2, and in archives, of which one holds the folder.
zarr.save_array(folder / "half.zarr", half, zarr_format=2)
add("half.zarr", zarr.open_array(folder / "half.zarr")[:].T)
zarr.create_array(folder / "half3.zarr", data=half, chunks=(2, 3, 4), zarr_format=3, overwrite=True)
add("half3.zarr", zarr.open_array(folder / "half3.zarr")[:].T)
for number in [2, 3]:
    with zarr.storage.ZipStore(folder / f"store{number}.zarr.zip", mode="w") as store:
        zarr.create_array(store, shape=volume.T.shape, chunks=(3, 4, 5), dtype="i2", zarr_format=number)[:] = volume.T
    with zarr.storage.ZipStore(folder / f"store{number}.zarr.zip", mode="r") as store:
        add(f"store{number}.zarr.zip", zarr.open_array(store)[:].T)
# Packed numbers and names of axes, as xarray writes them after the conventions of netCDF.
scale, offset = 0.25, 273.15
attributes = {"scale_factor": scale, "add_offset": offset, "valid_max": float("nan")}
names = ["time", "height", "lat", "lon"]
both = np.stack([volume.T, volume.T + 1])
for number, more in [(2, {"attributes": {**attributes, "_ARRAY_DIMENSIONS": names}}), (3, {"attributes": attributes, "dimension_names": names})]:
    array = zarr.create_array(folder / f"scaled{number}.zarr", data=both, chunks=(1, 3, 4, 5), zarr_format=number, **more)
    add(f"scaled{number}.zarr", array[1].T * scale + offset, tolerance=1e-4, time=2)
# Of pictures in time each is one.
pictures = zarr.create_array(folder / "pictures.zarr", data=volume.T, chunks=(2, 3, 4), zarr_format=3, dimension_names=["time", "lat", "lon"])
add("pictures.zarr", pictures[2].T[:, :, None], time=3, whole=True)
shutil.make_archive(str(folder / "outer"), "zip", folder, "half3.zarr")
add("outer.zip", half.T)

# N5 of every compression, with blocks cut at the ends.
for name in ["raw", "gzip", "bzip2", "zstd", "blosc"]:
    compression = {"type": name}
    if name == "blosc":
        compression = {"type": "blosc", "cname": "lz4", "clevel": 5, "shuffle": 1}
    array = tensorstore.open(
        {"driver": "n5", "kvstore": {"driver": "file", "path": str(folder / f"{name}.n5")},
         "metadata": {"compression": compression, "dataType": "int16", "dimensions": [13, 11, 7], "blockSize": [5, 4, 3]},
         "create": True, "delete_existing": True}
    ).result()
    array[:, :, :] = volume
    add(f"{name}.n5", array.read().result())
array = tensorstore.open(
    {"driver": "n5", "kvstore": {"driver": "file", "path": str(folder / "pyramid.n5/s0")},
     "metadata": {"compression": {"type": "gzip"}, "dataType": "float32", "dimensions": [13, 11, 7], "blockSize": [13, 4, 7]},
     "create": True, "delete_existing": True}
).result()
array[:, :, :] = volume.astype("f4") / 8
(folder / "pyramid.n5/attributes.json").write_text(
    json.dumps({"n5": "2.5.0", "pixelResolution": {"unit": "um", "dimensions": [500, 750, 1250]}})
)
add("pyramid.n5", array.read().result(), spaced)

# TIFF: pages of colours, and a stack of ImageJ whose one page is followed by all others, as beyond 4 GiB.
colors = random.integers(0, 256, (4, 9, 8, 3)).astype(np.uint8)
tifffile.imwrite(folder / "colors.tif", colors, photometric="rgb")
read = tifffile.imread(folder / "colors.tif").astype("f4")
add("colors.tif", (read @ np.array([0.299, 0.587, 0.114], "f4")).T, tolerance=1e-3)
(folder / "colors.tif.colors").write_bytes(read.astype("u1").tobytes())
stack = np.ascontiguousarray(volume.T)
tifffile.imwrite(folder / "imagej.tif", stack, imagej=True, metadata={"axes": "ZYX", "spacing": 2.5, "unit": "mm"},
                 resolution=(2.0, 2.0))
data = bytearray((folder / "imagej.tif").read_bytes())
with tifffile.TiffFile(folder / "imagej.tif") as tiff:
    assert len(tiff.pages) == 7 or tiff.pages[0].is_contiguous
    end = tiff.pages[0].offset + 2 + 12 * len(tiff.pages[0].tags)
    order = ">" if tiff.byteorder == ">" else "<"
    data[end:end + 4] = bytes(4)
(folder / "contiguous.tif").write_bytes(data)
with tifffile.TiffFile(folder / "contiguous.tif") as tiff:
    assert len(tiff.pages) == 1 and tiff.series[0].shape == (7, 11, 13), tiff.series[0]
    add("contiguous.tif", tiff.asarray().T, np.diag([0.5, 0.5, 2.5, 1.0]))

# TIFF in Zstandard and JPEG 2000: strips and tiles, of every kind of number, with predictors, in both orders of bytes.
def add_tiff(name, pages, **options):
    tifffile.imwrite(folder / name, pages, metadata=None, **options)
    read = tifffile.imread(folder / name)
    # Layer by layer what differs is where pages come from, not their numbers.
    add(name, read.T, np.eye(4), whole=pages.dtype.str[1:] not in ["u2", "f4"])


pages = np.cumsum(random.integers(-3, 4, (5, 37, 45)), axis=2) + 90
for kind in ["u1", "i1", "u2", "i2", "u4", "i4", "f2", "f4", "f8"]:
    data = (pages / 8 if kind[0] == "f" else pages).astype(kind)
    add_tiff(f"zstd_strips_{kind}.tif", data, compression="zstd", rowsperstrip=10)
    add_tiff(f"zstd_tiles_{kind}.tif", data, compression="zstd", predictor=True, tile=(16, 32), byteorder=">")
    add_tiff(f"zstd_big_{kind}.tif", data, compression="zstd", predictor=True, bigtiff=True, rowsperstrip=16)
add_tiff("zstd_big_endian.tif", pages.astype("u2"), compression="zstd", bigtiff=True, byteorder=">", tile=(32, 16))
for kind, most in [("u1", 255), ("u2", 4095), ("u2", 65535)]:
    data = (pages.clip(0, 200) * (most / 200)).astype(kind)
    for order in "<>":
        name = f"jpeg_2000_{most}_{'big' if order == '>' else 'little'}"
        add_tiff(f"{name}.tif", data, compression="jpeg2000", rowsperstrip=20, byteorder=order)
        add_tiff(f"{name}_tiles.tif", data, compression="jpeg2000", tile=(32, 16), byteorder=order)
add_tiff("jpeg_2000_lossy.tif", pages.clip(0, 255).astype("u1"), compression="jpeg2000", compressionargs={"level": 40})
manifest[-1]["tolerance"] = 1
# Colours: plain, in planes of their own, in JPEG 2000, and as Aperio's scanners write them, luma and chroma among them.
colors = np.stack([pages, 200 - pages, pages * 2], axis=-1).clip(0, 255).astype("u1")
BRIGHTNESS = np.array([0.299, 0.587, 0.114], "f4")


def add_colors(name, pixels, tolerance=1e-3):
    add(name, (pixels.astype("f4") @ BRIGHTNESS).T, tolerance=tolerance)
    pixels.astype("u1").tofile(folder / f"{name}.colors")


for name, options in {
    "colors_zstd.tif": {"compression": "zstd", "predictor": True, "tile": (16, 16)},
    "colors_apart.tif": {"compression": "zstd", "planarconfig": "separate"},
    "colors_plain_apart.tif": {"planarconfig": "separate"},
    "colors_tiles_apart.tif": {"planarconfig": "separate", "tile": (32, 16), "compression": "zstd", "predictor": True},
    "colors_jpeg_2000.tif": {"compression": "jpeg2000", "tile": (32, 32)},
}.items():
    own = np.moveaxis(colors, -1, 1) if "planarconfig" in options else colors
    tifffile.imwrite(folder / name, own, photometric="rgb", metadata=None, **options)
    read = tifffile.imread(folder / name)
    add_colors(name, np.moveaxis(read, 1, -1) if "planarconfig" in options else read)
for compression, photometric in [(33005, "rgb"), (33003, "ycbcr")]:
    pixels = colors.astype("f8")
    if photometric == "ycbcr":
        luma = pixels @ BRIGHTNESS.astype("f8")
        blue, red = (pixels[..., 2] - luma) / 1.772 + 128, (pixels[..., 0] - luma) / 1.402 + 128
        pixels = np.stack([luma, blue, red], axis=-1).round().clip(0, 255)
    tiles = []
    for page in np.pad(pixels, ((0, 0), (0, 27), (0, 19), (0, 0)), "edge").astype("u1"):
        for y in range(0, 64, 32):
            for x in range(0, 64, 32):
                tile = np.ascontiguousarray(page[y:y + 32, x:x + 32])
                tiles.append(imagecodecs.jpeg2k_encode(tile, level=0, mct=photometric == "rgb", codecformat="j2k"))
    name = f"aperio_{photometric}.tif"
    tifffile.imwrite(folder / name, iter(tiles), shape=colors.shape, dtype="u1", compression=compression, photometric="rgb",
                     tile=(32, 32), metadata=None)
    read = tifffile.imread(folder / name)
    # tifffile leaves luma and chroma as they are.
    assert (read == (colors if photometric == "rgb" else pixels)).all(), name
    add_colors(name, colors, 2)

# DICOM: series in folders below, named by a directory, and one in big endian without any head.
source = Path(pydicom.__file__).parent / "data/test_files/dicomdirtests"
medium = folder / "medium"
shutil.copytree(source, medium, dirs_exist_ok=True)
slices = {}
for path in sorted(medium.rglob("*")):
    if path.is_file() and not path.name.startswith(("DICOMDIR", "README")):
        dataset = pydicom.dcmread(path)
        if "PixelData" in dataset:
            own = (dataset.SeriesInstanceUID, dataset.Rows, dataset.Columns, str(dataset.get("ImageOrientationPatient")))
            slices.setdefault(own, []).append(dataset)
largest = max(slices.values(), key=len)
assert sum(len(own) == len(largest) for own in slices.values()) == 1
largest.sort(key=lambda dataset: dataset.ImagePositionPatient[2])
values = np.stack([d.pixel_array * float(d.RescaleSlope) + float(d.RescaleIntercept) for d in largest]).T
add("medium", values, unordered=True)
add("medium/DICOMDIR", values, unordered=True)
assert len(FileSet(pydicom.dcmread(medium / "DICOMDIR"))) >= len(largest)
dataset = pydicom.dcmread(source.parent / "MR_small_bigendian.dcm")
dataset.save_as(folder / "headless.dcm", implicit_vr=False, little_endian=False, enforce_file_format=False)
data = (folder / "headless.dcm").read_bytes()
(folder / "headless.dcm").write_bytes(data[data.index(b"\0\x08\0\x05" if b"\0\x08\0\x05" in data[:600] else b"\0\x08\0\x08"):])
add("headless.dcm", dataset.pixel_array.T[:, :, None])

(folder / "volumes.json").write_text(json.dumps(manifest))
