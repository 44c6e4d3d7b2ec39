"""Writes one volume and one cloud of points with other programs' libraries, for the tests of the importers:
python scans.py FOLDER. Needs laspy with lazrs and pyproj, nibabel, pynrrd, pydicom with pyjpegls, pillow, zarr and
tifffile."""

import io
import json
import sys
from pathlib import Path

import laspy
import nibabel
import nrrd
import numpy as np
import pydicom
import pyproj
import tifffile
import zarr
from laspy.vlrs.vlrlist import VLRList
from PIL import Image
from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.encaps import encapsulate
from pydicom.uid import (
    CTImageStorage,
    ExplicitVRLittleEndian,
    JPEG2000Lossless,
    JPEGLSLossless,
    JPEGLSNearLossless,
    RLELossless,
    generate_uid,
)

folder = Path(sys.argv[1])

# Points on sixteenths of a metre in UTM zone 32 north, in 16 bits of colour.
random = np.random.default_rng(7)
count = 2000
steps = random.integers(0, [640, 480, 160], size=(count, 3))
color = random.integers(0, 256, size=(count, 3)).astype(np.uint16)
for version, point_format in [("1.2", 3), ("1.4", 7)]:
    header = laspy.LasHeader(version=version, point_format=point_format)
    header.offsets = [691000.0, 5335000.0, 500.0]
    header.scales = [0.0625] * 3
    header.add_crs(pyproj.CRS.from_epsg(32632))
    las = laspy.LasData(header)
    las.X, las.Y, las.Z = steps.T
    las.red, las.green, las.blue = (color * 257).T
    las.classification = random.integers(1, 10, count)
    name = version.replace(".", "_")
    las.write(folder / f"points_{name}.las")
    las.write(folder / f"points_{name}.laz")
# Once more with the reference system behind the points.
las.evlrs = VLRList(header.vlrs.extract("WktCoordinateSystemVlr"))
las.write(folder / "points_behind.las")
las.write(folder / "points_behind.laz")

# A lump in air: 15 columns, 12 rows, 9 slices, in the axes of DICOM (left, posterior, superior).
size = (15, 12, 9)
spacing = (0.5, 0.75, 1.25)
origin = (-10.0, 20.0, 30.0)
x, y, z = np.meshgrid(*(np.arange(n) for n in size), indexing="ij")
lump = (x >= 2) & (y >= 1) & (y < 9) & (z < 7) & (x + y + z < 22)
volume = np.where(lump, 400 + 100 * z + 10 * x + y, -1000).astype(np.int16)

# NIfTI points to the right and to the front.
affine = np.diag([-spacing[0], -spacing[1], spacing[2], 1.0])
affine[:3, 3] = [-origin[0], -origin[1], origin[2]]
nibabel.save(nibabel.Nifti1Image(volume, affine), folder / "volume.nii.gz")
nibabel.save(nibabel.Nifti2Image(volume, affine), folder / "second.nii")
nrrd.write(
    str(folder / "volume.nrrd"),
    volume,
    {"space": "left-posterior-superior", "space directions": np.diag(spacing), "space origin": np.array(origin)},
)


def slice_of(k, series, syntax, is_signed):
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = CTImageStorage
    meta.MediaStorageSOPInstanceUID = generate_uid()
    meta.TransferSyntaxUID = ExplicitVRLittleEndian
    ds = FileDataset(None, {}, file_meta=meta, preamble=b"\0" * 128)
    ds.SOPClassUID, ds.SOPInstanceUID = CTImageStorage, meta.MediaStorageSOPInstanceUID
    ds.Modality, ds.SeriesInstanceUID, ds.SeriesNumber = "CT", series, 3
    # Numbers say nothing about places.
    ds.InstanceNumber = (k * 5) % size[2] + 1
    ds.ImagePositionPatient = [origin[0], origin[1], origin[2] + k * spacing[2]]
    ds.ImageOrientationPatient = [1, 0, 0, 0, 1, 0]
    ds.PixelSpacing = [spacing[1], spacing[0]]
    ds.SliceThickness = spacing[2]
    ds.Columns, ds.Rows, ds.SamplesPerPixel = size[0], size[1], 1
    ds.PhotometricInterpretation = "MONOCHROME2"
    ds.BitsAllocated, ds.BitsStored, ds.HighBit, ds.PixelRepresentation = 16, 16, 15, int(is_signed)
    shift = 0 if is_signed else 1024
    ds.RescaleIntercept, ds.RescaleSlope = -shift, 1
    pixels = (volume[:, :, k].T.astype(np.int32) + shift).astype("<i2" if is_signed else "<u2")
    ds.PixelData = pixels.tobytes()
    if syntax == JPEG2000Lossless:
        # Pictures as small as these have room for few levels.
        packed = io.BytesIO()
        image = Image.frombytes("I;16", size[:2], pixels.tobytes())
        image.save(packed, "JPEG2000", no_jp2=True, irreversible=False, num_resolutions=3, signed=is_signed)
        ds.PixelData = encapsulate([packed.getvalue()])
        ds["PixelData"].VR = "OB"
        meta.TransferSyntaxUID = syntax
    elif syntax != ExplicitVRLittleEndian:
        near = {"jls_error": 2} if syntax == JPEGLSNearLossless else {}
        ds.compress(syntax, generate_instance_uid=False, **near)
    return ds


for name, syntax, is_signed in [
    ("dicom", ExplicitVRLittleEndian, False),
    ("dicom_rle", RLELossless, False),
    ("dicom_j2k", JPEG2000Lossless, False),
    ("dicom_j2k_signed", JPEG2000Lossless, True),
    ("dicom_jls", JPEGLSLossless, False),
    ("dicom_jls_signed", JPEGLSLossless, True),
    ("dicom_jls_near", JPEGLSNearLossless, False),
]:
    (folder / name).mkdir()
    series = generate_uid()
    for k in range(size[2]):
        slice_of(k, series, syntax, is_signed).save_as(folder / name / f"{(k * 7) % size[2]}.dcm", enforce_file_format=True)

# Arrays: the last axis is the fastest, so z, y, x.
array = np.ascontiguousarray(volume.transpose(2, 1, 0))
tifffile.imwrite(folder / "volume.tif", array, photometric="minisblack")
tifffile.imwrite(folder / "packed.tif", array, photometric="minisblack", compression="zlib", predictor=True)


# Heights on a map: 2 m apart in UTM zone 32 north, with a hole.
heights = np.array([[300, 310, 320, 330], [300, -9999, 320, 330], [300, 310, 320, 350]], np.float32)
keys = [1, 1, 0, 4, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 25832, 3076, 0, 1, 9001]
tags = [(33550, "d", 3, (2.0, 2.0, 0.0)), (33922, "d", 6, (0.0, 0.0, 0.0, 691000.0, 5335000.0, 0.0))]
tags += [(34735, "H", len(keys), keys), (42113, "s", 0, "-9999")]
tifffile.imwrite(folder / "map.tiff", heights, photometric="minisblack", extratags=tags)


def write_zarr(name, version, **options):
    store = zarr.create_array(
        str(folder / name), shape=array.shape, chunks=(4, 5, 6), dtype=array.dtype, zarr_format=version, **options
    )
    store[:] = array


write_zarr("default_2.zarr", 2)
write_zarr("default_3.zarr", 3)
write_zarr("plain.zarr", 3, compressors=None)
write_zarr("shards.zarr", 3, shards=(8, 10, 12))
from numcodecs import Blosc, LZ4, Zlib  # noqa: E402

for codec in ["lz4", "zlib", "zstd"]:
    for shuffle in [Blosc.NOSHUFFLE, Blosc.SHUFFLE, Blosc.BITSHUFFLE]:
        write_zarr(f"{codec}_{shuffle}.zarr", 2, compressors=Blosc(cname=codec, clevel=5, shuffle=shuffle))
write_zarr("fortran.zarr", 2, compressors=Zlib(5), order="F")
write_zarr("block.zarr", 2, compressors=LZ4())
write_zarr("blosc.zarr", 3, compressors=zarr.codecs.BloscCodec(cname="zstd", shuffle="bitshuffle"))

# A picture in two levels: channel, z, y, x.
picture = zarr.open_group(str(folder / "picture.zarr"), mode="w", zarr_format=2)
datasets = []
for level, step in enumerate([1, 2]):
    data = np.stack([array, array])[:, ::step, ::step, ::step]
    part = picture.create_array(str(level), shape=data.shape, chunks=(1, 4, 5, 6), dtype=data.dtype)
    part[:] = data
    scale = [1.0, spacing[2] * step, spacing[1] * step, spacing[0] * step]
    datasets.append({"path": str(level), "coordinateTransformations": [{"type": "scale", "scale": scale}]})
axes = [{"name": "c", "type": "channel"}]
axes += [{"name": name, "type": "space", "unit": "millimeter"} for name in "zyx"]
picture.attrs["multiscales"] = [{"version": "0.4", "axes": axes, "datasets": datasets}]
(folder / "done.json").write_text(json.dumps({"points": count}))
