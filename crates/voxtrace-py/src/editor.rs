//! `Editor`: voxels of a scene are changed while it is traced.

use crate::arguments::Three;
use crate::errors::{argument, other};
use crate::material::PyMaterial;
use crate::scene::PyScene;
use numpy::{AllowTypeChange, PyArrayLike2};
use pyo3::prelude::*;
use std::sync::Arc;
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::grid::VoxelBox;
use voxtrace::{DynamicScene, Edit, Patch, Shape};

/// Changes voxels of a scene, with undo. A `Renderer` made of it follows by `Renderer.follow`, in a fraction of a millisecond for small edits.
///
/// >>> import numpy, voxtrace
/// >>> scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(numpy.ones((8, 8, 8), numpy.uint8)))
/// >>> editor = voxtrace.Editor(scene)
/// >>> editor.sphere((4, 4, 8), 3, None) < 0, editor.undo(), editor.voxels
/// (True, True, 512)
#[pyclass(name = "Editor", module = "voxtrace")]
pub struct PyEditor {
    scene: DynamicScene,
}

impl PyEditor {
    pub fn take_patch(&mut self) -> Patch {
        self.scene.take_patch()
    }

    /// The scene for a tracer that follows from now on.
    pub fn begin_anew(&mut self) -> Arc<voxtrace::PackedScene> {
        self.scene.take_patch();
        Arc::new(self.scene.scene().clone())
    }

    fn edit(&mut self, py: Python<'_>, grid: u32, edit: &Edit) -> PyResult<i64> {
        self.scene.edit(grid, edit).map(|edited| edited.voxels).map_err(|error| other(py, error))
    }
}

#[pymethods]
impl PyEditor {
    /// An editor of a copy of the scene, whose instances are kept apart.
    ///
    /// Raises `VoxtraceError` where the scene has smooth normals.
    #[new]
    fn new(py: Python<'_>, scene: &mut PyScene) -> PyResult<Self> {
        let packed = scene.packed(py, true)?;
        let scene = py.detach(|| DynamicScene::new((*packed).clone())).map_err(|error| other(py, error))?;
        Ok(Self { scene })
    }

    /// All voxels from corner `low` up to, but not including, `high` become a material, `None` for empty. Returns how many voxels there are more.
    #[pyo3(signature = (low, high, material, *, grid=0))]
    fn fill(&mut self, py: Python<'_>, low: Three, high: Three, material: Option<u16>, grid: u32) -> PyResult<i64> {
        let shape = Shape::Box(box_of(low, high)?);
        self.edit(py, grid, &Edit::Fill { shape, material })
    }

    /// All voxels whose middle is at most `radius` from `center` become a material, `None` for empty. Returns how many voxels there are more.
    #[pyo3(signature = (center, radius, material, *, grid=0))]
    fn sphere(
        &mut self,
        py: Python<'_>,
        center: Three,
        radius: f64,
        material: Option<u16>,
        grid: u32,
    ) -> PyResult<i64> {
        let shape = Shape::Sphere { center: center.0, radius: positive(radius)? };
        self.edit(py, grid, &Edit::Fill { shape, material })
    }

    /// As `sphere`, along the line between two points.
    #[pyo3(signature = (start, end, radius, material, *, grid=0))]
    fn stroke(
        &mut self,
        py: Python<'_>,
        start: Three,
        end: Three,
        radius: f64,
        material: Option<u16>,
        grid: u32,
    ) -> PyResult<i64> {
        let shape = Shape::Capsule { from: start.0, to: end.0, radius: positive(radius)? };
        self.edit(py, grid, &Edit::Fill { shape, material })
    }

    /// The voxels of a ball that are there become another material. Returns 0.
    #[pyo3(signature = (center, radius, material, *, grid=0))]
    fn paint(&mut self, py: Python<'_>, center: Three, radius: f64, material: u16, grid: u32) -> PyResult<i64> {
        let shape = Shape::Sphere { center: center.0, radius: positive(radius)? };
        self.edit(py, grid, &Edit::Paint { shape, material })
    }

    /// The voxels of one material become another, or empty. Returns how many voxels there are more.
    #[pyo3(signature = (old, new, *, grid=0))]
    fn replace(&mut self, py: Python<'_>, old: u16, new: Option<u16>, grid: u32) -> PyResult<i64> {
        self.edit(py, grid, &Edit::Replace { within: None, from: old, to: new })
    }

    /// Voxels, shape `(N, 3)`, become a material, `None` for empty. Returns how many voxels there are more.
    #[pyo3(signature = (voxels, material, *, grid=0))]
    fn set(
        &mut self,
        py: Python<'_>,
        voxels: PyArrayLike2<'_, i32, AllowTypeChange>,
        material: Option<u16>,
        grid: u32,
    ) -> PyResult<i64> {
        let voxels = voxels.as_array();
        if voxels.ncols() != 3 {
            return Err(argument("voxels have shape (N, 3)"));
        }
        let mut change = 0;
        for voxel in voxels.outer_iter() {
            let min = IVec3::new(voxel[0], voxel[1], voxel[2]);
            let max = min.checked_add(IVec3::ONE).ok_or_else(|| argument("a voxel out of range"))?;
            change += self.edit(py, grid, &Edit::Fill { shape: Shape::Box(VoxelBox { min, max }), material })?;
        }
        Ok(change)
    }

    /// Adds a material. Returns its index.
    fn add_material(&mut self, py: Python<'_>, material: PyMaterial) -> PyResult<u16> {
        self.scene.add_material(&material.0).map_err(|error| other(py, error))
    }

    /// Index of the material of a voxel, `None` where it is empty.
    #[pyo3(signature = (voxel, *, grid=0))]
    fn get(&self, voxel: Three, grid: u32) -> Option<u16> {
        self.scene.voxel(grid, voxel.0.floor().as_ivec3())
    }

    /// Takes the last edit back. Returns whether there was one.
    fn undo(&mut self, py: Python<'_>) -> PyResult<bool> {
        self.scene.undo().map(|edited| edited.is_some()).map_err(|error| other(py, error))
    }

    /// Does again what was undone last. Returns whether there was something.
    fn redo(&mut self, py: Python<'_>) -> PyResult<bool> {
        self.scene.redo().map(|edited| edited.is_some()).map_err(|error| other(py, error))
    }

    /// Voxels stored, each grid once.
    #[getter]
    fn voxels(&self) -> u64 {
        self.scene.scene().statistics().voxels
    }

    /// The scene as it is now.
    fn scene(&self, py: Python<'_>) -> PyScene {
        PyScene::of_packed(Arc::new(py.detach(|| self.scene.compact())))
    }

    fn __repr__(&self) -> String {
        format!("<Editor of {:?}: {} voxels>", self.scene.scene().name, self.voxels())
    }
}

fn positive(radius: f64) -> PyResult<f64> {
    if radius >= 0.0 && radius.is_finite() { Ok(radius) } else { Err(argument("a radius is ≥ 0")) }
}

fn box_of(low: Three, high: Three) -> PyResult<VoxelBox> {
    let whole = |three: Three| {
        let rounded = three.0.round();
        let fits = rounded.abs().max_element() < f64::from(i32::MAX)
            && (rounded - three.0).abs().cmple(DVec3::splat(1e-9)).all();
        if fits { Ok(rounded.as_ivec3()) } else { Err(argument("corners are whole numbers")) }
    };
    Ok(VoxelBox { min: whole(low)?, max: whole(high)? })
}
