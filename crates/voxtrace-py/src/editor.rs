//! `Editor`: voxels of a scene are changed while it is traced.

use crate::arguments::{Numbers, Three, whole};
use crate::errors::{argument, other};
use crate::forks::{self, detach};
use crate::material::PyMaterial;
use crate::scene::PyScene;
use numpy::ndarray::Ix2;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use std::sync::{Arc, Mutex, PoisonError, Weak};
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::grid::{MAX_COORDINATE, VoxelBox};
use voxtrace::{DynamicScene, Edit, EditError, PackedScene, Patch, Shape};

/// Bytes that undo and redo keep.
const UNDO_BYTES: u64 = 256 << 20;

/// Changes voxels of a scene, with undo. A `Renderer` made of it follows by `Renderer.follow`, in a fraction of a millisecond for small edits. Threads may share
/// it: they edit one after the other, and other threads of Python run meanwhile. Places and lengths are in voxels of a grid; `grid` is its number, as `Instance.grid` says
/// it of the instances of `Editor.scene()`.
///
/// Edits raise `VoxtraceError`, with nothing changed, for a grid or a material that is not there and for voxels beyond ±524,288 that would be filled, and
/// `ValueError` for numbers that cannot be.
///
/// >>> import numpy, voxtrace
/// >>> scene = voxtrace.Scene(voxtrace.VoxelGrid.from_numpy(numpy.ones((8, 8, 8), numpy.uint8)))
/// >>> editor = voxtrace.Editor(scene)
/// >>> editor.sphere((4, 4, 8), 3, None) < 0, editor.undo(), editor.voxels
/// (True, True, 512)
#[pyclass(name = "Editor", module = "voxtrace", frozen)]
pub struct PyEditor {
    edited: Mutex<Edited>,
}

/// The scene of an editor, and how far it was followed.
struct Edited {
    scene: DynamicScene,
    /// What the renderer that follows lacks, as far as it was taken from the scene.
    patches: Vec<Patch>,
    /// How many patches were taken.
    taken: u64,
    /// Of the renderer that follows.
    follower: Weak<Follower>,
}

/// Tells the renderer that follows an editor from others: the one that was made last.
pub struct Follower;

impl Edited {
    /// Takes what changed.
    fn take(&mut self) {
        let patch = self.scene.take_patch();
        if !patch.is_empty() {
            self.taken += 1;
            if self.follower.strong_count() > 0 {
                self.patches.push(patch);
            }
        }
    }

    /// The scene as it was when a patch was taken last.
    fn packed(&self) -> Arc<PackedScene> {
        Arc::new(self.scene.scene().clone())
    }

    /// All voxels become a material, in one step of undo, or none does.
    fn set(&mut self, grid: u32, voxels: &[IVec3], material: Option<u16>) -> Result<i64, EditError> {
        let (mut change, mut is_begun) = (0, false);
        for &min in voxels {
            let max = min.saturating_add(IVec3::ONE);
            let edit = Edit::Fill { shape: Shape::Box(VoxelBox { min, max }), material };
            let edited = if is_begun { self.scene.edit_on(grid, &edit) } else { self.scene.edit(grid, &edit) };
            match edited {
                Ok(edited) => {
                    change += edited.voxels;
                    is_begun |= edited.bricks > 0;
                }
                Err(error) => {
                    if is_begun {
                        self.scene.undo()?;
                    }
                    return Err(error);
                }
            }
        }
        Ok(change)
    }
}

impl PyEditor {
    /// Works with the scene once no other thread does, without the interpreter's lock.
    fn with<T: Send>(&self, py: Python<'_>, work: impl FnOnce(&mut Edited) -> T + Send) -> PyResult<T> {
        detach(py, || work(&mut self.edited.lock().unwrap_or_else(PoisonError::into_inner)))
    }

    fn edit(&self, py: Python<'_>, grid: i128, edit: &Edit) -> PyResult<i64> {
        let grid = number_of(py, "grid", grid)?;
        let edited = self.with(py, |edited| edited.scene.edit(grid, edit))?;
        edited.map(|edited| edited.voxels).map_err(|error| other(py, error))
    }

    /// The scene for a renderer that is to follow, and how many patches were taken by then. Who follows now still does.
    pub fn begin(&self, py: Python<'_>) -> PyResult<(Arc<PackedScene>, u64)> {
        self.with(py, |edited| {
            edited.take();
            (edited.packed(), edited.taken)
        })
    }

    /// From now on the renderer follows that began when so many patches were taken. Returns the scene where it was changed since.
    pub fn lead(&self, py: Python<'_>, follower: &Arc<Follower>, taken: u64) -> PyResult<Option<Arc<PackedScene>>> {
        self.with(py, |edited| {
            edited.take();
            edited.patches.clear();
            edited.follower = Arc::downgrade(follower);
            (edited.taken != taken).then(|| edited.packed())
        })
    }

    /// Brings the scene of a renderer up to date. Returns the patches that it lacked, `None`, with nothing changed, where it is not the one that follows.
    pub fn follow(
        &self,
        py: Python<'_>,
        follower: &Arc<Follower>,
        scene: &mut Arc<PackedScene>,
    ) -> PyResult<Option<Vec<Patch>>> {
        self.with(py, |edited| {
            if !edited.follower.ptr_eq(&Arc::downgrade(follower)) {
                return None;
            }
            edited.take();
            let scene = Arc::make_mut(scene);
            edited.patches.iter().try_for_each(|patch| scene.apply_patch(patch)).ok()?;
            Some(std::mem::take(&mut edited.patches))
        })
    }
}

#[pymethods]
impl PyEditor {
    /// An editor of a copy of the scene, whose instances are kept apart.
    ///
    /// Raises `VoxtraceError` where the scene has smooth normals.
    #[new]
    fn new(py: Python<'_>, scene: &PyScene) -> PyResult<Self> {
        let packed = scene.packed(py, true)?;
        let scene = detach(py, || DynamicScene::new((*packed).clone()))?;
        let mut scene = scene.map_err(|error| other(py, error))?;
        scene.set_undo_limit(UNDO_BYTES);
        Ok(Self { edited: Mutex::new(Edited { scene, patches: Vec::new(), taken: 0, follower: Weak::new() }) })
    }

    /// All voxels from corner `low` up to, but not including, `high` become a material, `None` for empty. Returns how many voxels there are more.
    #[pyo3(signature = (low, high, material, *, grid=0))]
    fn fill(&self, py: Python<'_>, low: Three, high: Three, material: Option<i128>, grid: i128) -> PyResult<i64> {
        let (shape, material) = (Shape::Box(box_of(low, high)?), material_of(py, material)?);
        self.edit(py, grid, &Edit::Fill { shape, material })
    }

    /// All voxels whose middle is at most `radius` from `center` become a material, `None` for empty. Returns how many voxels there are more.
    #[pyo3(signature = (center, radius, material, *, grid=0))]
    fn sphere(&self, py: Python<'_>, center: Three, radius: f64, material: Option<i128>, grid: i128) -> PyResult<i64> {
        let (shape, material) = (ball_of(center, radius)?, material_of(py, material)?);
        self.edit(py, grid, &Edit::Fill { shape, material })
    }

    /// As `sphere`, along the line between two points.
    #[pyo3(signature = (start, end, radius, material, *, grid=0))]
    fn stroke(
        &self,
        py: Python<'_>,
        start: Three,
        end: Three,
        radius: f64,
        material: Option<i128>,
        grid: i128,
    ) -> PyResult<i64> {
        let shape = Shape::Capsule { from: start.0, to: end.0, radius: positive(radius)? };
        let material = material_of(py, material)?;
        self.edit(py, grid, &Edit::Fill { shape, material })
    }

    /// The voxels of a ball that are there become another material. Returns 0.
    #[pyo3(signature = (center, radius, material, *, grid=0))]
    fn paint(&self, py: Python<'_>, center: Three, radius: f64, material: i128, grid: i128) -> PyResult<i64> {
        let (shape, material) = (ball_of(center, radius)?, number_of(py, "material", material)?);
        self.edit(py, grid, &Edit::Paint { shape, material })
    }

    /// The voxels of one material become another, or empty. Returns how many voxels there are more.
    #[pyo3(signature = (old, new, *, grid=0))]
    fn replace(&self, py: Python<'_>, old: i128, new: Option<i128>, grid: i128) -> PyResult<i64> {
        let (from, to) = (number_of(py, "material", old)?, material_of(py, new)?);
        self.edit(py, grid, &Edit::Replace { within: None, from, to })
    }

    /// Voxels, shape `(N, 3)`, become a material, `None` for empty: all of them, in one step of undo, or none where it raises. Returns how many voxels there
    /// are more.
    #[pyo3(signature = (voxels, material, *, grid=0))]
    fn set(&self, py: Python<'_>, voxels: Numbers<'_, f64, Ix2>, material: Option<i128>, grid: i128) -> PyResult<i64> {
        let (voxels, material, grid) = (voxels.as_array(), material_of(py, material)?, number_of(py, "grid", grid)?);
        if voxels.ncols() != 3 {
            return Err(argument("voxels have shape (N, 3)"));
        }
        let voxels = voxels.outer_iter().map(|voxel| whole(DVec3::new(voxel[0], voxel[1], voxel[2])));
        let voxels: Option<Vec<IVec3>> = voxels.collect();
        let voxels = voxels.ok_or_else(|| argument("voxels are whole numbers"))?;
        let limit = IVec3::splat(MAX_COORDINATE);
        let is_outside = |voxel: &&IVec3| voxel.cmplt(-limit).any() || voxel.cmpgt(limit).any();
        if let Some(&voxel) = voxels.iter().find(is_outside).filter(|_| material.is_some()) {
            return Err(other(py, EditError::OutOfRange(voxel)));
        }
        self.with(py, |edited| {
            // What is joined piece by piece is forgotten as a whole or not at all.
            edited.scene.set_undo_limit(u64::MAX);
            let change = edited.set(grid, &voxels, material);
            edited.scene.set_undo_limit(UNDO_BYTES);
            change
        })?
        .map_err(|error| other(py, error))
    }

    /// Adds a material. Returns its index.
    fn add_material(&self, py: Python<'_>, material: PyMaterial) -> PyResult<u16> {
        self.with(py, |edited| edited.scene.add_material(&material.0))?.map_err(|error| other(py, error))
    }

    /// Index of the material of a voxel, `None` where it is empty.
    #[pyo3(signature = (voxel, *, grid=0))]
    fn get(&self, py: Python<'_>, voxel: Three, grid: i128) -> PyResult<Option<u16>> {
        let Ok(grid) = u32::try_from(grid) else { return Ok(None) };
        // A thread that edited when this process was forked holds the lock for ever.
        forks::check()?;
        let edited = self.edited.lock_py_attached(py).unwrap_or_else(PoisonError::into_inner);
        Ok(edited.scene.voxel(grid, voxel.0.floor().as_ivec3()))
    }

    /// Takes the last edit back. Returns whether there was one.
    fn undo(&self, py: Python<'_>) -> PyResult<bool> {
        let undone = self.with(py, |edited| edited.scene.undo())?;
        undone.map(|edited| edited.is_some()).map_err(|error| other(py, error))
    }

    /// Does again what was undone last. Returns whether there was something.
    fn redo(&self, py: Python<'_>) -> PyResult<bool> {
        let redone = self.with(py, |edited| edited.scene.redo())?;
        redone.map(|edited| edited.is_some()).map_err(|error| other(py, error))
    }

    /// Voxels stored, each grid once.
    #[getter]
    fn voxels(&self, py: Python<'_>) -> PyResult<u64> {
        self.with(py, |edited| edited.scene.scene().statistics().voxels)
    }

    /// The scene as it is now.
    fn scene(&self, py: Python<'_>) -> PyResult<PyScene> {
        Ok(PyScene::of_packed(Arc::new(self.with(py, |edited| edited.scene.compact())?)))
    }

    fn __reduce__(&self) -> PyResult<()> {
        let text = "an Editor is not pickled or copied, as renderers follow it: Editor.scene() is what it has made, and can be";
        Err(PyTypeError::new_err(text))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let name = self.with(py, |edited| edited.scene.scene().name.clone())?;
        Ok(format!("<Editor of {name:?}: {} voxels>", self.voxels(py)?))
    }
}

/// A number that something of the scene may have.
fn number_of<T: TryFrom<i128>>(py: Python<'_>, what: &str, number: i128) -> PyResult<T> {
    T::try_from(number).map_err(|_| other(py, format!("there is no {what} {number}")))
}

fn material_of(py: Python<'_>, material: Option<i128>) -> PyResult<Option<u16>> {
    material.map(|material| number_of(py, "material", material)).transpose()
}

fn ball_of(center: Three, radius: f64) -> PyResult<Shape> {
    Ok(Shape::Sphere { center: center.0, radius: positive(radius)? })
}

fn positive(radius: f64) -> PyResult<f64> {
    if radius >= 0.0 && radius.is_finite() { Ok(radius) } else { Err(argument("a radius is ≥ 0")) }
}

fn box_of(low: Three, high: Three) -> PyResult<VoxelBox> {
    let corner = |three: Three| {
        let fits = three.0.abs().max_element() < f64::from(i32::MAX);
        whole(three.0).filter(|_| fits).ok_or_else(|| argument("corners are whole numbers"))
    };
    Ok(VoxelBox { min: corner(low)?, max: corner(high)? })
}
