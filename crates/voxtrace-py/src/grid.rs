//! `VoxelGrid`: voxels from arrays and back, exactly.

use crate::arguments::{Color, Three, readable, whole};
use crate::errors::argument;
use crate::forks::detach;
use crate::interrupt::run_while;
use crate::material::PyMaterial;
use crate::pickle::{bytes_of_grid, grid_of, no_grid};
use numpy::ndarray::{ArrayD, ArrayViewD, Axis, Ix3, Ix4, IxDyn};
use numpy::{
    Element, IntoPyArray, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArray,
    PyUntypedArrayMethods, dtype,
};
use pyo3::prelude::*;
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};
use voxtrace::brick::voxel_of;
use voxtrace::glam::IVec3;
use voxtrace::grid::{VoxelBox, brick_of};
use voxtrace::material::{MAX_MATERIALS, linear_color, srgb_from_linear};
use voxtrace::volume::{Ramp, Transfer};
use voxtrace::{Brick, Material, VoxelGrid};

/// Voxels along an edge of a brick.
const EDGE: i32 = 8;
/// Voxels of a brick.
pub const BRICK_VOXELS: usize = 512;
/// Bricks that are made at a time: enough for many threads, 70 MB at most.
const BRICKS_AT_A_TIME: i64 = 1 << 16;

/// A grid taken apart: its voxels, its materials, and the lowest voxel and the one beyond the highest of the array that it was made of.
type Pickled = (Vec<u8>, Vec<PyMaterial>, Option<([i32; 3], [i32; 3])>);

/// A sparse grid of voxels with materials. Voxel `(x, y, z)` is element `[x, y, z]` of an array; z points up.
///
/// >>> import numpy, voxtrace
/// >>> labels = numpy.zeros((4, 4, 4), numpy.uint8)
/// >>> labels[1:3, 1:3, 0] = 7
/// >>> grid = voxtrace.VoxelGrid.from_numpy(labels)
/// >>> len(grid), bool((grid.to_numpy() == labels).all())
/// (4, True)
#[pyclass(name = "VoxelGrid", module = "voxtrace", frozen)]
pub struct PyVoxelGrid {
    pub grid: Arc<VoxelGrid>,
    /// Voxels refer to them by index.
    pub materials: Vec<Material>,
    /// Of the array that it was made of.
    extent: Option<VoxelBox>,
}

impl PyVoxelGrid {
    pub fn new(grid: Arc<VoxelGrid>, materials: Vec<Material>) -> Self {
        Self { grid, materials, extent: None }
    }

    /// What an array of it shows: that of the array that it was made of, else the box around its voxels.
    fn extent(&self, py: Python<'_>) -> PyResult<VoxelBox> {
        match self.extent {
            Some(extent) => Ok(extent),
            None => Ok(self.box_of_voxels(py)?.unwrap_or(VoxelBox { min: IVec3::ZERO, max: IVec3::ZERO })),
        }
    }

    /// The box around its voxels, which many threads look for.
    fn box_of_voxels(&self, py: Python<'_>) -> PyResult<Option<VoxelBox>> {
        detach(py, || self.grid.bounds())
    }
}

#[pymethods]
impl PyVoxelGrid {
    /// A grid of an array.
    ///
    /// * bool, shape `(X, Y, Z)`: where it is true there is a voxel, of the first material of `palette`.
    /// * whole numbers, shape `(X, Y, Z)`: labels from 0, empty, to 65535; label `k` has `palette[k]`, else a colour of its own.
    /// * uint8, shape `(X, Y, Z, 3)` or `(X, Y, Z, 4)`: sRGB colours; alpha 0 is empty. More than 65,535 distinct colours are
    ///   rounded to 7, 6 or 5 bits a channel.
    ///
    /// `palette`: a list of `Material`, or an array of colours, shape `(N, 3)`: uint8 is sRGB, floats are linear. `origin`: the voxel of element
    /// `[0, 0, 0]`. The array is read where it lies, whatever its strides; one of another byte order, or a field of packed records, is copied.
    /// What a masked array masks is empty.
    ///
    /// Raises `ValueError` for other shapes, types and labels, for masked colours, for a palette that lacks a label, and for an origin from which voxels
    /// would lie beyond 32 bits.
    #[staticmethod]
    #[pyo3(signature = (array, palette=None, *, origin=None))]
    fn from_numpy(
        py: Python<'_>,
        array: &Bound<'_, PyAny>,
        palette: Option<&Bound<'_, PyAny>>,
        origin: Option<Three>,
    ) -> PyResult<Self> {
        let fits = |origin: &Three| origin.0.abs().max_element() < f64::from(i32::MAX);
        let origin = match origin {
            Some(origin) if !fits(&origin) => return Err(too_far()),
            Some(origin) => whole(origin.0).ok_or_else(|| argument("an origin is of whole numbers"))?,
            None => IVec3::ZERO,
        };
        let palette = palette.map(materials_of).transpose()?;
        let untyped = array.cast::<PyUntypedArray>().map_err(|_| argument("an array of numpy is wanted"))?;
        let shape = untyped.shape().to_vec();
        let (size, channels) = match shape[..] {
            [x, y, z] => ([x, y, z], 0),
            [x, y, z, channels @ 3..=4] => ([x, y, z], channels),
            _ => {
                return Err(argument(format!(
                    "shape (X, Y, Z), (X, Y, Z, 3) or (X, Y, Z, 4) is wanted, not {shape:?}"
                )));
            }
        };
        let extent = extent_of(origin, size)?;
        let array = &unmasked(array, channels > 0)?;
        let kind = untyped.dtype().call_method1("newbyteorder", ("=",))?;
        let array = &readable(array, &kind)?;
        let made = if channels > 0 {
            let colors = readonly::<u8>(array).ok_or_else(|| argument("colours are of type uint8"))?;
            if palette.is_some() {
                return Err(argument("colours need no palette"));
            }
            let view = colors.as_array();
            run_while(py, |wanted| of_colors(&view, extent, wanted))?
        } else {
            labels(py, array, extent, palette)
        };
        let (grid, materials) = made?;
        Ok(Self { grid: Arc::new(grid), materials, extent: Some(extent) })
    }

    /// The grid as an array, element `[0, 0, 0]` at `origin`: of the array that it was made of, else the box around its voxels.
    ///
    /// `kind`: `"labels"` (uint8, or uint16 where there are more than 255 materials; 0 is empty, `k` is `materials[k - 1]`), `"rgba"` (uint8, sRGB,
    /// shape `(X, Y, Z, 4)`; alpha is 255 or 0) or `"occupancy"` (bool).
    ///
    /// Raises `ValueError` for another kind, `MemoryError` where there is no room.
    #[pyo3(signature = (kind="labels"))]
    fn to_numpy<'py>(&self, py: Python<'py>, kind: &str) -> PyResult<Bound<'py, PyAny>> {
        let extent = self.extent(py)?;
        let colors: Vec<[u8; 4]> = self
            .materials
            .iter()
            .map(|material| {
                let [r, g, b] = material.base_color.to_array().map(srgb_from_linear);
                [r, g, b, 255]
            })
            .collect();
        match kind {
            "labels" if self.materials.len() <= 255 => self.dense(py, extent, &[], |material| [material as u8 + 1]),
            "labels" => self.dense(py, extent, &[], |material| [material + 1]),
            "occupancy" => self.dense(py, extent, &[], |_| [true]),
            "rgba" => self.dense(py, extent, &[4], |material| {
                colors.get(usize::from(material)).copied().unwrap_or([0, 0, 0, 255])
            }),
            other => Err(argument(format!("{other:?} is none of \"labels\", \"rgba\" and \"occupancy\""))),
        }
    }

    /// The voxel of element `[0, 0, 0]` of `to_numpy`.
    #[getter]
    fn origin(&self, py: Python<'_>) -> PyResult<[i32; 3]> {
        Ok(self.extent(py)?.min.to_array())
    }

    /// Shape of `to_numpy` of labels.
    #[getter]
    fn shape(&self, py: Python<'_>) -> PyResult<(i32, i32, i32)> {
        Ok(self.extent(py)?.size().into())
    }

    /// The lowest voxel and the one beyond the highest, `None` of an empty grid.
    #[getter]
    fn bounds(&self, py: Python<'_>) -> PyResult<Option<([i32; 3], [i32; 3])>> {
        Ok(self.box_of_voxels(py)?.map(|bounds| (bounds.min.to_array(), bounds.max.to_array())))
    }

    /// Materials; voxels refer to them by index.
    #[getter]
    fn materials(&self) -> Vec<PyMaterial> {
        self.materials.iter().map(|material| PyMaterial(*material)).collect()
    }

    fn __len__(&self) -> usize {
        self.grid.count() as usize
    }

    /// What `__reduce__` has taken apart.
    #[staticmethod]
    fn _of_parts(
        py: Python<'_>,
        grid: Vec<u8>,
        materials: Vec<PyMaterial>,
        extent: Option<([i32; 3], [i32; 3])>,
    ) -> PyResult<Self> {
        let grid = py.detach(|| grid_of(&grid)).ok_or_else(no_grid)?;
        let extent = extent.map(|(min, max)| VoxelBox { min: min.into(), max: max.into() });
        Ok(Self { grid: Arc::new(grid), materials: materials.into_iter().map(|material| material.0).collect(), extent })
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled)> {
        let extent = self.extent.map(|extent| (extent.min.to_array(), extent.max.to_array()));
        let parts = (detach(py, || bytes_of_grid(&self.grid))?, self.materials(), extent);
        Ok((py.get_type::<Self>().getattr("_of_parts")?, parts))
    }

    /// The same one: it is never changed.
    fn __copy__<'py>(slf: &Bound<'py, Self>) -> Bound<'py, Self> {
        slf.clone()
    }

    fn __deepcopy__<'py>(slf: &Bound<'py, Self>, _memo: &Bound<'py, PyAny>) -> Bound<'py, Self> {
        slf.clone()
    }

    /// Index of the material of a voxel, `None` where it is empty.
    fn __getitem__(&self, voxel: Three) -> Option<u16> {
        self.grid.get(voxel.0.floor().as_ivec3())
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let ((x, y, z), materials) = (self.shape(py)?, self.materials.len());
        Ok(format!("<VoxelGrid: {} voxels in {x} × {y} × {z}, {materials} materials>", self.grid.count()))
    }
}

impl PyVoxelGrid {
    /// An array of the grid; `value` says what stands for a material, zeros stand for nothing.
    fn dense<'py, T: Element + Copy + Default + Send + Sync, const N: usize>(
        &self,
        py: Python<'py>,
        extent: VoxelBox,
        channels: &[usize],
        value: impl Fn(u16) -> [T; N] + Sync,
    ) -> PyResult<Bound<'py, PyAny>> {
        let size = extent.size().to_array().map(|length| length as usize);
        let length = size.iter().product::<usize>() * N;
        let mut values = Vec::new();
        values.try_reserve_exact(length).map_err(|_| pyo3::exceptions::PyMemoryError::new_err(()))?;
        values.resize(length, T::default());
        let plane = size[1] * size[2] * N;
        detach(py, || {
            let mut bricks = self.grid.sorted_bricks();
            bricks.par_sort_unstable_by_key(|(coordinates, _)| coordinates.x);
            // Slabs of an array with x first: those that a layer of bricks along x has share no element with those of another.
            let mut slabs = Vec::new();
            let (mut left, mut x) = (&mut values[..], extent.min.x);
            while !left.is_empty() {
                let row = x.div_euclid(EDGE);
                let end = ((row + 1) * EDGE).min(extent.max.x);
                let (slab, rest) = left.split_at_mut((end - x) as usize * plane);
                slabs.push((row, x, slab));
                (left, x) = (rest, end);
            }
            slabs.into_par_iter().for_each(|(row, start, slab)| {
                let first = bricks.partition_point(|(coordinates, _)| coordinates.x < row);
                let in_row = bricks[first..].iter().take_while(|(coordinates, _)| coordinates.x == row);
                for (coordinates, brick) in in_row {
                    for (local, material) in brick.voxels() {
                        let voxel = *coordinates * EDGE + local;
                        if extent.contains(voxel) {
                            let place = voxel - IVec3::new(start, extent.min.y, extent.min.z);
                            let at = (place.x as usize * size[1] + place.y as usize) * size[2] + place.z as usize;
                            slab[at * N..(at + 1) * N].copy_from_slice(&value(material));
                        }
                    }
                }
            });
        })?;
        let shape: Vec<usize> = size.iter().chain(channels).copied().collect();
        let array = ArrayD::from_shape_vec(IxDyn(&shape), values).map_err(argument)?;
        Ok(array.into_pyarray(py).into_any())
    }
}

/// The voxels of an array of this size.
fn extent_of(origin: IVec3, size: [usize; 3]) -> PyResult<VoxelBox> {
    let max = size.map(|length| i32::try_from(length).ok());
    let [Some(x), Some(y), Some(z)] = max else { return Err(too_far()) };
    // The bricks around them are within 32 bits too.
    let max = origin.checked_add(IVec3::new(x, y, z)).filter(|max| max.max_element() <= i32::MAX - EDGE);
    Ok(VoxelBox { min: origin, max: max.ok_or_else(too_far)? })
}

fn too_far() -> PyErr {
    argument("the array reaches farther than coordinates of voxels do, which have 32 bits")
}

/// The array with nothing where it is masked.
fn unmasked<'py>(array: &Bound<'py, PyAny>, has_colors: bool) -> PyResult<Bound<'py, PyAny>> {
    if !array.py().import("numpy.ma")?.call_method1("is_masked", (array,))?.is_truthy()? {
        return Ok(array.clone());
    }
    match has_colors {
        true => Err(argument("colours are not masked: alpha 0 is empty")),
        false => array.call_method1("filled", (0,)),
    }
}

/// An array of this type, as it lies.
fn readonly<'py, T: Element>(array: &Bound<'py, PyAny>) -> Option<PyReadonlyArrayDyn<'py, T>> {
    let array = array.cast::<PyArrayDyn<T>>().ok()?;
    array.try_readonly().ok()
}

/// The bytes of an array of bools, as they lie; `None` where it is another array. Any byte but 0 is true: `view(bool)` leaves what was there.
fn bytes_of_bools<'py>(array: &Bound<'py, PyAny>) -> PyResult<Option<PyReadonlyArrayDyn<'py, u8>>> {
    if array.cast::<PyArrayDyn<bool>>().is_err() {
        return Ok(None);
    }
    Ok(readonly(&array.call_method1("view", (dtype::<u8>(array.py()),))?))
}

/// Materials of a list of `Material` or of an array of colours.
pub fn materials_of(palette: &Bound<'_, PyAny>) -> PyResult<Vec<Material>> {
    let is_bytes =
        palette.cast::<PyUntypedArray>().is_ok_and(|array| array.dtype().is_equiv_to(&dtype::<u8>(palette.py())));
    let material = |item: PyResult<Bound<'_, PyAny>>| {
        let item = item?;
        if let Ok(material) = item.extract::<PyMaterial>() {
            return Ok(material.0);
        }
        let color = item.extract::<Color>()?.0;
        Ok(match is_bytes {
            true => Material::diffuse(linear_color(color.to_array().map(|channel| channel as u8))),
            false => Material::diffuse(Color(color).reflectance()?),
        })
    };
    let materials: Vec<Material> = palette.try_iter()?.map(material).collect::<PyResult<_>>()?;
    match materials.len() {
        0..=MAX_MATERIALS => Ok(materials),
        count => Err(argument(format!("{count} materials are more than {MAX_MATERIALS}"))),
    }
}

/// A grid of labels or of places that are occupied.
fn labels(
    py: Python<'_>,
    array: &Bound<'_, PyAny>,
    extent: VoxelBox,
    palette: Option<Vec<Material>>,
) -> PyResult<(VoxelGrid, Vec<Material>)> {
    if let Some(occupied) = bytes_of_bools(array)? {
        let view = occupied.as_array();
        let label = |&byte: &u8| Some(u16::from(byte != 0));
        let grid = run_while(py, |wanted| of_labels(&view, extent, label, wanted))?;
        let material = palette.and_then(|palette| palette.first().copied()).unwrap_or_default();
        return Ok((grid?.0, vec![material]));
    }
    macro_rules! try_types {
        ($($type:ty),*) => {
            $(if let Some(values) = readonly::<$type>(array) {
                let view = values.as_array();
                let label = |&label: &$type| u16::try_from(label).ok();
                let (grid, highest) = run_while(py, |wanted| of_labels(&view, extent, label, wanted))??;
                return Ok((grid, label_materials(highest, palette)?));
            })*
        };
    }
    try_types!(u8, u16, i16, i32, u32, i64, u64, i8);
    Err(argument("an array of bool, of whole numbers, or of uint8 colours is wanted"))
}

/// Materials of the labels from 1 on.
fn label_materials(highest: u16, palette: Option<Vec<Material>>) -> PyResult<Vec<Material>> {
    match palette {
        Some(palette) if palette.len() > usize::from(highest) => Ok(palette[1..].to_vec()),
        Some(palette) => {
            Err(argument(format!("the palette has {} materials, and the highest label is {highest}", palette.len())))
        }
        None => {
            let labels: Vec<i32> = (1..=i32::from(highest)).collect();
            let Ramp::Labels(colors) = Transfer::of_labels(&labels).ramp else { return Ok(Vec::new()) };
            Ok(colors.values().map(|look| Material::diffuse(look.color)).collect())
        }
    }
}

/// A grid of labels, which have the material before them, and the highest of them; anything where they are not `wanted` any more.
fn of_labels<T: Sync>(
    view: &ArrayViewD<T>,
    extent: VoxelBox,
    label: impl Fn(&T) -> Option<u16> + Sync,
    wanted: &(dyn Fn() -> bool + Sync),
) -> PyResult<(VoxelGrid, u16)> {
    let view = view.view().into_dimensionality::<Ix3>().map_err(argument)?;
    let highest = (0..view.len_of(Axis(0))).into_par_iter().map(|x| {
        if !wanted() {
            return Some(0);
        }
        view.index_axis(Axis(0), x)
            .iter()
            .try_fold(0, |highest: u16, value| label(value).map(|label| highest.max(label)))
    });
    let highest = highest.collect::<Option<Vec<u16>>>().and_then(|planes| planes.into_iter().max().or(Some(0)));
    let highest = highest.ok_or_else(|| {
        argument("labels are from 0 to 65535; numpy.unique(array, return_inverse=True) numbers others")
    })?;
    let grid = build(extent, |[x, y, z]| label(&view[[x, y, z]]).and_then(|label| label.checked_sub(1)), wanted);
    Ok((grid, highest))
}

/// A grid of colours; anything where it is not `wanted` any more.
fn of_colors(
    view: &ArrayViewD<u8>,
    extent: VoxelBox,
    wanted: &(dyn Fn() -> bool + Sync),
) -> PyResult<(VoxelGrid, Vec<Material>)> {
    let view = view.view().into_dimensionality::<Ix4>().map_err(argument)?;
    let has_alpha = view.shape()[3] == 4;
    let color = |[x, y, z]: [usize; 3], lost: u32| -> Option<u32> {
        let channel = |channel: usize| u32::from(view[[x, y, z, channel]]) >> lost;
        let is_there = !has_alpha || view[[x, y, z, 3]] > 0;
        is_there.then(|| channel(0) << 16 | channel(1) << 8 | channel(2))
    };
    let size = view.shape();
    let distinct = |lost: u32| {
        let of_plane = |x: usize| {
            if !wanted() {
                return Vec::new();
            }
            let places = (0..size[1]).flat_map(|y| (0..size[2]).map(move |z| [x, y, z]));
            let mut colors: Vec<u32> = places.filter_map(|place| color(place, lost)).collect();
            colors.sort_unstable();
            colors.dedup();
            colors
        };
        let all = (0..size[0]).into_par_iter().map(of_plane).reduce(Vec::new, |mut a, b| {
            a.extend(b);
            a.sort_unstable();
            a.dedup();
            a
        });
        (lost, all)
    };
    let chosen = (0..=3).map(distinct).find(|(_, colors)| colors.len() <= MAX_MATERIALS);
    let (lost, colors) = chosen.ok_or_else(|| argument("too many colours"))?;
    // The middle of what was rounded to one colour.
    let byte = |value: u32| ((value << lost) as u8) + if lost > 0 { 1 << (lost - 1) } else { 0 };
    let material = |&color: &u32| Material::from_srgb([color >> 16, color >> 8 & 0xff, color & 0xff].map(byte));
    let at = |place| color(place, lost).and_then(|color| colors.binary_search(&color).ok()).map(|index| index as u16);
    let grid = build(extent, at, wanted);
    Ok((grid, colors.iter().map(material).collect()))
}

/// A grid whose voxels have the materials that `at` says, by their places in the extent. Bricks of one material share it; some bricks at a time, so that they are
/// in memory once. Those are left out that are not `wanted` any more.
fn build(
    extent: VoxelBox,
    at: impl Fn([usize; 3]) -> Option<u16> + Sync,
    wanted: &(dyn Fn() -> bool + Sync),
) -> VoxelGrid {
    if extent.size().min_element() <= 0 {
        return VoxelGrid::new();
    }
    let (low, high) = (brick_of(extent.min), brick_of(extent.max - 1));
    let count = high - low + 1;
    let uniform: Vec<OnceLock<Arc<[u16]>>> = (0..MAX_MATERIALS).map(|_| OnceLock::new()).collect();
    let (width, depth, height) = (i64::from(count.x), i64::from(count.y), i64::from(count.z));
    let brick = |index: i64| {
        if !wanted() {
            return None;
        }
        let place = IVec3::new((index % width) as i32, (index / width % depth) as i32, (index / width / depth) as i32);
        let coordinates = low + place;
        let mut occupancy = [0u64; 8];
        let (mut materials, mut length) = ([0; BRICK_VOXELS], 0);
        for (block, mask) in occupancy.iter_mut().enumerate() {
            for bit in 0..64 {
                let voxel = coordinates * EDGE + voxel_of(block, bit);
                if !extent.contains(voxel) {
                    continue;
                }
                let place = (voxel - extent.min).to_array().map(|part| part as usize);
                if let Some(material) = at(place) {
                    *mask |= 1 << bit;
                    materials[length] = material;
                    length += 1;
                }
            }
        }
        let materials = &materials[..length];
        let &first = materials.first()?;
        let of_one = materials.iter().all(|&material| material == first);
        let made = match uniform.get(usize::from(first)).filter(|_| of_one) {
            Some(shared) => {
                let shared = shared.get_or_init(|| Arc::from([first; BRICK_VOXELS]));
                Brick::sharing(occupancy, shared.clone())
            }
            None => Brick::new(occupancy, materials.to_vec()),
        };
        Some((coordinates, made))
    };
    let total = width * depth * height;
    let some = |part: i64| {
        let end = total.min((part + 1) * BRICKS_AT_A_TIME);
        (part * BRICKS_AT_A_TIME..end).into_par_iter().filter_map(brick).collect::<Vec<_>>()
    };
    VoxelGrid::from_bricks((0..(total + BRICKS_AT_A_TIME - 1) / BRICKS_AT_A_TIME).flat_map(some))
}
