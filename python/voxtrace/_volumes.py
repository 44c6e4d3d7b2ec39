"""Volumes of what other libraries hold: arrays, and where they know it the place of their samples in the world."""

from __future__ import annotations

from typing import Any

import numpy

from ._voxtrace import Volume

#: nibabel counts to the right, to the front and to the head; DICOM, and so we, to the left, to the back and to the head.
_LEFT_BACK_HEAD = numpy.diag([-1.0, -1.0, 1.0, 1.0])


def from_array(
    array: Any,
    *,
    spacing: float | tuple[float, float, float] | None = None,
    affine: Any = None,
    unit: str | None = None,
    labels: bool = False,
    name: str | None = None,
) -> Volume:
    """A volume of an array of shape `(X, Y, Z)`, of any type of real numbers; it is kept as float32.

    `array`: of numpy, dask, zarr or torch (also on a GPU), or anything that numpy takes; what is masked is NaN, which is never shown, or label 0; a `DataArray` of xarray, whose even
    coordinates say the spacing; an image of nibabel or SimpleITK, which know their place and have millimetres. `spacing`: distance between samples, in `unit`,
    one number or three. `affine`: 4 × 4 or 3 × 4, from indices to the world, z up; patients as in DICOM (left, back, head). `unit`:
    `"mm"`, `"m"` or `None`. `labels`: values are labels, which are not interpolated.

    Raises `ValueError` for another shape, an affine that flattens, both of `spacing` and `affine`, and labels that float32 does not tell apart.
    """
    known_name = getattr(array, "name", None)
    if spacing is None and affine is None:
        affine, known_unit = place_of(array)
        unit = unit if unit is not None else known_unit
    values = samples_of(_values_of(array), labels)
    rows = None if affine is None else numpy.asarray(affine, dtype=float).tolist()
    known_name = known_name if isinstance(known_name, str) and known_name else "array"
    return Volume._from_numpy(values, spacing=spacing, affine=rows, unit=unit, labels=labels, name=name or known_name)


def _values_of(array: Any) -> numpy.ndarray[Any, Any]:
    if hasattr(array, "GetDirection"):  # SimpleITK, whose arrays have z first
        import SimpleITK

        return numpy.transpose(SimpleITK.GetArrayViewFromImage(array))
    if hasattr(array, "dataobj"):  # nibabel, which scales as it reads
        return numpy.asanyarray(array.dataobj)
    if hasattr(array, "detach"):  # torch
        array = array.detach().cpu()
    if hasattr(array, "compute"):  # dask, and xarray over it
        array = array.compute()
    if hasattr(array, "__array__"):
        return numpy.asanyarray(array)
    return numpy.asanyarray(array[...] if hasattr(array, "chunks") else array)


def samples_of(values: Any, labels: bool) -> numpy.ndarray[Any, Any]:
    """An array without its mask, and with nothing where that hides something: what stands below it, as netCDF's fill values do, is no sample. Labels are checked."""
    if numpy.ma.is_masked(values):
        values = values.filled(0) if labels else values.astype(numpy.float32).filled(numpy.nan)
    samples: numpy.ndarray[Any, Any] = numpy.asarray(values)
    if labels and samples.dtype.kind in "iu" and samples.dtype.itemsize > 2 and samples.size > 0:
        most = max(int(samples.max()), -int(samples.min()))
        if most > 1 << 24 and (samples.astype(numpy.float32).astype(numpy.float64) != samples).any():
            raise ValueError(f"labels up to {most} are not told apart as float32: numpy.unique(array, return_inverse=True) numbers them anew")
    return samples


def place_of(array: Any) -> tuple[Any, str | None]:
    """From indices to the world, and the unit, where the array knows them."""
    if hasattr(array, "GetDirection"):
        if array.GetDimension() != 3:
            raise ValueError(f"an image of 3 dimensions is wanted, not of {array.GetDimension()}")
        matrix = numpy.eye(4)
        direction = numpy.reshape(array.GetDirection(), (3, 3))
        matrix[:3, :3] = direction * numpy.asarray(array.GetSpacing())
        matrix[:3, 3] = array.GetOrigin()
        return matrix, "mm"
    if hasattr(array, "dataobj") and hasattr(array, "affine"):
        return _LEFT_BACK_HEAD @ numpy.asarray(array.affine), "mm"
    if hasattr(array, "coords") and hasattr(array, "dims"):
        return _of_coordinates(array), None
    return None, None


def _of_coordinates(array: Any) -> Any:
    """Of a `DataArray` whose coordinates ascend or descend evenly."""
    matrix = numpy.eye(4)
    for axis, dimension in enumerate(array.dims):
        coordinates = array.coords.get(dimension)
        if coordinates is None or len(coordinates) < 2:
            continue
        places = numpy.asarray(coordinates)
        if not numpy.issubdtype(places.dtype, numpy.number):
            continue
        steps = numpy.diff(places.astype(float))
        # In metres the steps of a microscope are less than what is usually taken for nothing.
        if not numpy.allclose(steps, steps[0], rtol=1e-3, atol=0) or steps[0] == 0:
            raise ValueError(f"coordinates along {dimension} are not even: pass spacing or affine")
        matrix[axis, axis], matrix[axis, 3] = steps[0], float(places[0])
    return matrix


def _add_from_array(volume: Any) -> None:
    """The class comes from the extension module, which cannot say this."""
    volume.from_array = staticmethod(from_array)
