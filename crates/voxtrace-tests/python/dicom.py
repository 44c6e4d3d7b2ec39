"""Writes what pydicom says about the pixels of all its samples, and of some files that are made here: python dicom.py FOLDER. Needs
pydicom, pydicom-data, pylibjpeg with libjpeg and openjpeg, pyjpegls, and nibabel with its mosaics of Siemens. Colours become brightness
(ITU-R BT.601), values are rescaled."""

import gzip
import io
import json
import logging
import sys
import warnings
from pathlib import Path

import data_store
import nibabel
import numpy as np
import pydicom
from pydicom.dataset import Dataset, FileDataset, FileMetaDataset
from pydicom.encaps import encapsulate
from pydicom.pixels import apply_color_lut, pixel_array
from pydicom.uid import CTImageStorage, ExplicitVRBigEndian, ExplicitVRLittleEndian, RLELossless, generate_uid

warnings.simplefilter("ignore")
from nibabel.nicom import dicomwrappers  # noqa: E402, it warns

logging.disable(logging.CRITICAL)
folder = Path(sys.argv[1])
# Frames of a file that are compared.
MOST_FRAMES = 10


def brightness(rgb):
    rgb = rgb.astype(np.float64)
    return 0.299 * rgb[..., 0] + 0.587 * rgb[..., 1] + 0.114 * rgb[..., 2]


# How far a step of stored values is, rescaled, of each file.
steps = []


def rescaled(ds, frame, values):
    """By the frame's groups, by the file, or as a dose."""
    groups = [g for g in (ds.get("PerFrameFunctionalGroupsSequence"), ds.get("SharedFunctionalGroupsSequence")) if g]
    items = [g[frame] if len(g) > frame and i == 0 and len(groups) == 2 else g[0] for i, g in enumerate(groups)]
    found = [item.PixelValueTransformationSequence[0] for item in items if "PixelValueTransformationSequence" in item] + [ds]
    for place in found:
        if "RescaleSlope" in place:
            steps.append(abs(float(place.RescaleSlope)))
            return values * float(place.RescaleSlope) + float(place.get("RescaleIntercept", 0))
    return values * float(ds.get("DoseGridScaling") or 1)


def values_of(ds):
    """Frames, rows and columns of numbers."""
    values = pixel_array(ds, raw=True)
    kind = ds.PhotometricInterpretation
    frames = int(ds.get("NumberOfFrames") or 1)
    if kind == "PALETTE COLOR":
        if not ds.original_encoding[1] and "RedPaletteColorLookupTableData" in ds:
            # pydicom takes the words of a table for little endian always.
            for name in ["Red", "Green", "Blue"]:
                table = ds[f"{name}PaletteColorLookupTableData"]
                table.value = np.frombuffer(table.value, ">u2").astype("<u2").tobytes()
        values = brightness(apply_color_lut(values, ds))
    elif ds.SamplesPerPixel == 3:
        values = values[..., 0] if kind.startswith("YBR_FULL") else brightness(values)
    elif kind == "MONOCHROME1" and not ds.PixelRepresentation:
        values = (1 << ds.BitsStored) - 1 - values.astype(np.int64)
    values = np.asarray(values, dtype=np.float64).reshape(frames, ds.Rows, ds.Columns)
    return np.array([rescaled(ds, n, frame) for n, frame in enumerate(values[:MOST_FRAMES])], dtype="<f4"), frames


def dataset(syntax, values, stored=8, **elements):
    """A file of frames, rows and columns of bytes or words; their number is that of the array."""
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID = CTImageStorage, generate_uid()
    meta.TransferSyntaxUID = syntax
    ds = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128, is_implicit_VR=False, is_little_endian=syntax != ExplicitVRBigEndian)
    ds.SOPClassUID, ds.SOPInstanceUID = CTImageStorage, meta.MediaStorageSOPInstanceUID
    ds.SeriesInstanceUID, ds.Modality, ds.PixelSpacing = generate_uid(), "OT", [0.5, 0.25]
    frames, ds.Rows, ds.Columns = values.shape[:3]
    ds.NumberOfFrames, ds.SamplesPerPixel, ds.PixelRepresentation = frames, 1, 0
    ds.BitsAllocated, ds.BitsStored, ds.HighBit = values.dtype.itemsize * 8, stored, stored - 1
    ds.PhotometricInterpretation = "MONOCHROME2"
    for name, value in elements.items():
        setattr(ds, name, value)
    return ds


own = folder / "own"
own.mkdir()
random = np.random.default_rng(3)


def save(ds, name):
    ds.save_as(own / f"{name}.dcm", enforce_file_format=True)


# Bytes that were written as words of big endian, an odd number of them; and bits.
for name, shape in [("words_of_bytes", (2, 7, 9)), ("words_of_an_odd_frame", (1, 5, 5))]:
    values = random.integers(0, 256, shape).astype(np.uint8)
    ds = dataset(ExplicitVRBigEndian, values)
    data = values.tobytes() + b"\0" * (values.size % 2)
    ds.add_new(0x7FE00010, "OW", np.frombuffer(data, "<u2").astype(">u2").tobytes())
    save(ds, name)
# Pairs of pixels that share their colour, in two frames.
brightnesses = random.integers(0, 256, (2, 4, 6)).astype(np.uint8)
pairs = np.stack([brightnesses[..., 0::2], brightnesses[..., 1::2]] + [random.integers(0, 256, (2, 4, 3)).astype(np.uint8) for _ in range(2)], axis=-1)
ds = dataset(ExplicitVRLittleEndian, brightnesses, SamplesPerPixel=3, PhotometricInterpretation="YBR_FULL_422", PlanarConfiguration=0)
ds.PixelData = pairs.tobytes()
save(ds, "thinned")
# An icon with compressed pixels before the picture, whose pieces hold what looks like the end of a sequence.
values = random.integers(0, 4096, (1, 6, 8)).astype(np.uint16)
ds = dataset(RLELossless, values, stored=12)
ds.PixelData = values.tobytes()
ds.file_meta.TransferSyntaxUID = ExplicitVRLittleEndian
ds.compress(RLELossless, encoding_plugin="pydicom")
icon = Dataset()
icon.Rows, icon.Columns, icon.SamplesPerPixel, icon.PhotometricInterpretation = 4, 4, 1, "MONOCHROME2"
icon.BitsAllocated, icon.BitsStored, icon.HighBit, icon.PixelRepresentation = 8, 8, 7, 0
icon.add_new(0x7FE00010, "OB", encapsulate([b"\xfe\xff\xdd\xe0\0\0\0\0" * 2, b"\xfe\xff\x0d\xe0\0\0\0\0"]))
icon["PixelData"].is_undefined_length = True
ds.IconImageSequence = [icon]
save(ds, "icon")
# A localizer: three frames lie across, five upright, two upright in another direction.
values = random.integers(0, 4096, (10, 6, 8)).astype(np.uint16)
ds = dataset(ExplicitVRLittleEndian, values, stored=12)
ds.PixelData = values.tobytes()
groups = []
for n in range(10):
    directions = [1, 0, 0, 0, 1, 0] if n < 3 else [0, 1, 0, 0, 0, -1] if n < 8 else [1, 0, 0, 0, 0, -1]
    group, plane, place = Dataset(), Dataset(), Dataset()
    plane.ImageOrientationPatient, place.ImagePositionPatient = directions, [n * float(axis == (2 if n < 3 else 0 if n < 8 else 1)) for axis in range(3)]
    group.PlaneOrientationSequence, group.PlanePositionSequence = [plane], [place]
    groups.append(group)
ds.PerFrameFunctionalGroupsSequence = groups
save(ds, "localizer")
# Mosaics: nibabel's, whose pixels are all 0, with others; the second without the element that says how many there are.
mosaics = []
data = Path(nibabel.__file__).parent / "nicom" / "tests" / "data"
for name in ["siemens_dwi_0", "siemens_dwi_1000"]:
    ds = pydicom.dcmread(io.BytesIO(gzip.decompress((data / f"{name}.dcm.gz").read_bytes())))
    ds.PixelData = random.integers(0, 4096, (ds.Rows, ds.Columns)).astype("<u2").tobytes()
    ds.SeriesInstanceUID = generate_uid()
    if name.endswith("1000"):
        del ds[0x0019, 0x100A]
    save(ds, name)
    wrapper = dicomwrappers.wrapper_from_file(own / f"{name}.dcm")
    # Rows, columns and slices.
    values = np.ascontiguousarray(np.transpose(wrapper.get_data(), (2, 0, 1)), dtype="<f4")
    (own / f"{name}.f32").write_bytes(values.tobytes())
    mosaics.append({"name": name, "size": list(values.shape[::-1]), "affine": wrapper.affine.tolist()})
(folder / "mosaics.json").write_text(json.dumps(mosaics))
# Segmentations by shares of 200: of one segment, and of two, whose frames lie at the same places.
shares = random.integers(0, 201, (2, 3, 6, 8)).astype(np.uint8)
for count in [1, 2]:
    ds = dataset(ExplicitVRLittleEndian, shares[:count].reshape(-1, 6, 8), Modality="SEG", SegmentationType="FRACTIONAL", MaximumFractionalValue=200)
    ds.PixelData = shares[:count].tobytes()
    groups = []
    for segment, z in [(segment, z) for segment in range(count) for z in range(3)]:
        group, plane, place, identification = Dataset(), Dataset(), Dataset(), Dataset()
        plane.ImageOrientationPatient, place.ImagePositionPatient = [1, 0, 0, 0, 1, 0], [0, 0, z]
        identification.ReferencedSegmentNumber = segment + 1
        group.PlaneOrientationSequence, group.PlanePositionSequence = [plane], [place]
        group.SegmentIdentificationSequence = [identification]
        groups.append(group)
    ds.PerFrameFunctionalGroupsSequence = groups
    ds.save_as(folder / f"shares_{count}.dcm", enforce_file_format=True)
# A series whose tilt is written with digits that differ in the last place.
(folder / "tilted").mkdir()
series = generate_uid()
for n, sine in enumerate([0.1234999, 0.1235001, 0.1234998, 0.1235002]):
    cosine = (1 - sine * sine) ** 0.5
    values = np.full((1, 6, 8), n, np.uint8)
    ds = dataset(ExplicitVRLittleEndian, values, SeriesInstanceUID=series, InstanceNumber=n + 1)
    ds.ImageOrientationPatient = [1, 0, 0, 0, round(cosine, 7), sine]
    ds.ImagePositionPatient = [0, round(-n * sine, 7), round(n * cosine, 7)]
    ds.PixelData = values.tobytes()
    ds.save_as(folder / "tilted" / f"{n}.dcm", enforce_file_format=True)
(folder / "shares.f32").write_bytes(shares.astype("<f4").tobytes())

samples = []
roots = [Path(data_store.__file__).parent, Path(pydicom.__file__).parent / "data", own]
names = set()
for path in sorted(path for root in roots for path in root.rglob("*") if path.suffix in (".dcm", "") and path.is_file() and "siemens_dwi" not in path.name):
    try:
        ds = pydicom.dcmread(path, force=True)
        if "Rows" not in ds or "PixelData" not in ds:
            continue
        steps.clear()
        values, frames = values_of(ds)
    except Exception as error:
        samples.append({"name": path.name, "path": str(path), "error": str(error).splitlines()[0]})
        continue
    name = path.name if path.name not in names else f"{path.parent.name}_{path.name}"
    names.add(name)
    (folder / f"{name}.f32").write_bytes(values.tobytes())
    syntax = ds.file_meta.TransferSyntaxUID
    samples.append({"name": name, "path": str(path), "size": [ds.Columns, ds.Rows, frames], "syntax": syntax.name, "kind": ds.PhotometricInterpretation, "step": max(steps, default=1.0)})
(folder / "samples.json").write_text(json.dumps(samples, indent=1))
