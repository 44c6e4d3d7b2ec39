//! `Scene` and `Instance`.

use crate::arguments::{Index, Matrix, Three, rows_of};
use crate::camera::PyCamera;
use crate::errors::{argument, of_packed, of_writing, other};
use crate::forks::detach;
use crate::grid::PyVoxelGrid;
use crate::interrupt::{is_in_handler, pause, run_while};
use crate::material::PyMaterial;
use crate::pickle::{SceneParts, of_packing, parts_of, scene_of};
use crate::sky::PySky;
use crate::volume::unit_name;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;
use std::time::Duration;
use voxtrace::animation::{Animation, Playback, keyframe_count};
use voxtrace::cuts::Cuts;
use voxtrace::export::{ExportError, writer_of};
use voxtrace::glam::{DAffine3, IVec3};
use voxtrace::material::MAX_MATERIALS;
use voxtrace::packed::{FileErrorKind, PackError};
use voxtrace::{Brick, Instance, Material, PackedScene, Scene, Transform, VoxelGrid};

/// Time between two looks at whether another thread has packed the scene.
const PERIOD: Duration = Duration::from_millis(5);

/// Voxels in their places, with materials, sky and cameras. Threads may share it: while it is packed for one of them, others that need it packed or change it wait.
/// It can be pickled and copied; animations of glTF files are in no pickle and no file: what `at` gives of them is.
///
/// >>> import voxtrace
/// >>> scene = voxtrace.builtin("city", voxels=20_000)
/// >>> scene.name, len(scene.materials) > 3
/// ('city', True)
#[pyclass(name = "Scene", module = "voxtrace")]
pub struct PyScene {
    content: Held,
    /// As it is traced: with instances merged, and with instances kept apart. Who packs it holds the lock.
    packed: [Mutex<Option<Arc<PackedScene>>>; 2],
    /// What of it is shown, the lowest and the highest corner; all of it where there is none.
    clip: Option<Corners>,
    /// What the reader left out or put up with.
    #[pyo3(get)]
    pub notes: Vec<String>,
}

/// A scene taken apart: a file's as that file, or one that is not packed; its clip, and its notes.
type Pickled = (Option<Vec<u8>>, Option<SceneParts>, Option<Corners>, Vec<String>);

/// An instance taken apart.
type PickledInstance = (String, usize, [[f64; 4]; 4], bool, Option<String>);

/// Two corners of a box, world units.
type Corners = ([f32; 3], [f32; 3]);

/// What a scene is made of.
enum Held {
    Scene(Box<Scene>),
    /// As a file had it.
    Packed(Arc<PackedScene>),
}

/// A placed grid: a copy of what the scene says of it.
#[pyclass(name = "Instance", module = "voxtrace", frozen, get_all)]
pub struct PyInstance {
    /// Name, empty where there is none.
    name: String,
    /// Index of the grid.
    grid: usize,
    /// From grid to world, 4 × 4.
    transform: [[f64; 4]; 4],
    /// Whether it is hidden.
    hidden: bool,
    /// Name of its layer, or `None`.
    layer: Option<String>,
}

#[pymethods]
impl PyInstance {
    /// What `__reduce__` has taken apart.
    #[staticmethod]
    fn _of_parts(name: String, grid: usize, transform: [[f64; 4]; 4], hidden: bool, layer: Option<String>) -> Self {
        Self { name, grid, transform, hidden, layer }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, PickledInstance)> {
        let parts = (self.name.clone(), self.grid, self.transform, self.hidden, self.layer.clone());
        Ok((py.get_type::<Self>().getattr("_of_parts")?, parts))
    }

    fn __repr__(&self) -> String {
        let [x, y, z] = [0, 1, 2].map(|row| self.transform[row][3]);
        format!("<Instance {:?}: grid {} at ({x}, {y}, {z})>", self.name, self.grid)
    }
}

impl PyScene {
    pub fn of(scene: Scene) -> Self {
        Self { content: Held::Scene(Box::new(scene)), packed: Default::default(), clip: None, notes: Vec::new() }
    }

    pub fn of_packed(packed: Arc<PackedScene>) -> Self {
        Self { content: Held::Packed(packed), packed: Default::default(), clip: None, notes: Vec::new() }
    }

    /// Changes the scene; what was packed is packed anew when it is next needed. Nobody lets other threads run while having the scene alone, so that none of them
    /// ever finds it so.
    fn change<T>(slf: &Bound<'_, Self>, change: impl FnOnce(&mut Scene) -> PyResult<T>) -> PyResult<T> {
        Self::unpack(slf)?;
        let mut held = Self::alone(slf)?;
        held.packed = Default::default();
        match &mut held.content {
            Held::Scene(scene) => change(scene),
            Held::Packed(_) => unreachable!("it was unpacked"),
        }
    }

    /// Makes what a file had a scene that can be changed. Other threads may use it meanwhile.
    fn unpack(slf: &Bound<'_, Self>) -> PyResult<()> {
        let packed = match &slf.try_borrow()?.content {
            Held::Packed(packed) => Arc::clone(packed),
            Held::Scene(_) => return Ok(()),
        };
        let scene = Box::new(unpacked(slf.py(), &packed)?);
        let mut held = Self::alone(slf)?;
        // Another thread may have done the same, and changed it.
        if matches!(held.content, Held::Packed(_)) {
            held.content = Held::Scene(scene);
        }
        Ok(())
    }

    /// The scene, once no other thread works with it, as one that packs it does. They run meanwhile.
    fn alone<'py>(slf: &Bound<'py, Self>) -> PyResult<PyRefMut<'py, Self>> {
        loop {
            match slf.try_borrow_mut() {
                Ok(held) => return Ok(held),
                // It may be this thread that does, which would wait for itself.
                Err(error) if is_in_handler() => return Err(error.into()),
                Err(_) => pause(slf.py(), PERIOD)?,
            }
        }
    }

    /// The scene as it can be read.
    fn looked_at<T>(&self, py: Python<'_>, of_scene: impl FnOnce(&Scene) -> T) -> PyResult<T> {
        match &self.content {
            Held::Scene(scene) => Ok(of_scene(scene)),
            Held::Packed(packed) => unpacked(py, packed).map(|scene| of_scene(&scene)),
        }
    }

    /// Puts a grid into a scene, whose voxels count materials from the first of `materials` in it. Returns the index of the instance.
    fn put(
        scene: &mut Scene,
        voxels: Arc<VoxelGrid>,
        materials: &[Material],
        transform: Transform,
        name: &str,
    ) -> usize {
        scene.materials.extend_from_slice(materials);
        scene.grids.push(voxels);
        scene.instances.push(Instance { name: name.into(), ..Instance::new(scene.grids.len() - 1, transform) });
        scene.instances.len() - 1
    }

    /// The scene as it is traced; `keeps_instances` where they are to be moved or edited. Where another thread packs it, this one waits.
    pub fn packed(&self, py: Python<'_>, keeps_instances: bool) -> PyResult<Arc<PackedScene>> {
        let place = &self.packed[usize::from(keeps_instances)];
        if let Some(packed) = try_lock(place).and_then(|packed| packed.clone()) {
            return Ok(packed);
        }
        let cuts = cuts_of(self.clip)?;
        let content = &self.content;
        let work = |wanted: &(dyn Fn() -> bool + Sync)| {
            let mut place = lock_while(place, wanted).ok_or(PackError::Stopped)?;
            if let Some(packed) = &*place {
                return Ok(Arc::clone(packed));
            }
            let mut packed = match content {
                Held::Packed(packed) if keeps_instances && packed.is_merged() => {
                    Arc::new(packed.split_while(wanted).ok_or(PackError::Stopped)?)
                }
                Held::Packed(packed) => Arc::clone(packed),
                Held::Scene(scene) if keeps_instances => Arc::new(PackedScene::pack_while(scene, wanted)?),
                Held::Scene(scene) => Arc::new(PackedScene::pack_merged_while(scene, wanted)?),
            };
            if packed.cuts != cuts {
                Arc::make_mut(&mut packed).cuts = cuts;
            }
            *place = Some(Arc::clone(&packed));
            Ok(packed)
        };
        let packed: Result<_, PackError> = run_while(py, work)?;
        packed.map_err(|error| other(py, error))
    }
}

#[pymethods]
impl PyScene {
    /// A scene without anything in it, or of one grid at the origin.
    #[new]
    #[pyo3(signature = (grid=None, *, name="scene"))]
    fn new(grid: Option<PyRef<'_, PyVoxelGrid>>, name: &str) -> Self {
        let mut scene = Scene::new(name);
        if let Some(grid) = grid {
            Self::put(&mut scene, Arc::clone(&grid.grid), &grid.materials, Transform::IDENTITY, "");
        }
        Self::of(scene)
    }

    /// Adds a grid with its materials, placed by `transform` (4 × 4, voxels of the grid to the world). Returns the index of the instance.
    ///
    /// Raises `ValueError` for a transform that shears and for more than 65,535 materials.
    #[pyo3(signature = (grid, transform=None, *, name=""))]
    fn add(
        slf: &Bound<'_, Self>,
        grid: PyRef<'_, PyVoxelGrid>,
        transform: Option<Matrix>,
        name: &str,
    ) -> PyResult<usize> {
        let transform = transform.map_or(Transform::IDENTITY, |transform| transform.0);
        let (voxels, materials) = (&grid.grid, &grid.materials);
        loop {
            let first = Self::change(slf, |scene| Ok(scene.materials.len()))?;
            if first + materials.len() > MAX_MATERIALS {
                return Err(argument(format!("more than {MAX_MATERIALS} materials")));
            }
            // Meanwhile other threads may use the scene.
            let counted = match first {
                0 => Arc::clone(voxels),
                _ => Arc::new(detach(slf.py(), || counted_from(first as u16, voxels))?),
            };
            // Unless one of them has added materials.
            let put = |scene: &mut Scene| {
                let is_first = scene.materials.len() == first;
                Ok(is_first.then(|| Self::put(scene, counted, materials, transform, name)))
            };
            if let Some(instance) = Self::change(slf, put)? {
                return Ok(instance);
            }
        }
    }

    /// Adds another instance of the grid of an instance. Returns its index.
    ///
    /// Raises `IndexError` where there is no such instance, `ValueError` for a transform that shears.
    #[pyo3(signature = (instance, transform, *, name=""))]
    fn add_copy(slf: &Bound<'_, Self>, instance: Index, transform: Matrix, name: &str) -> PyResult<usize> {
        let Index(instance) = instance;
        Self::change(slf, |scene| {
            let of = scene.instances.get(instance).ok_or_else(|| no_instance(instance, scene.instances.len()))?;
            let copy = Instance { name: name.into(), ..Instance::new(of.grid, transform.0) };
            scene.instances.push(copy);
            Ok(scene.instances.len() - 1)
        })
    }

    /// Puts an instance elsewhere. For a frame after another, `Renderer.place` is quicker.
    ///
    /// Raises `IndexError` where there is no such instance, `ValueError` for a transform that shears.
    fn place(slf: &Bound<'_, Self>, instance: Index, transform: Matrix) -> PyResult<()> {
        let Index(instance) = instance;
        Self::change(slf, |scene| {
            let count = scene.instances.len();
            let instance = scene.instances.get_mut(instance).ok_or_else(|| no_instance(instance, count))?;
            instance.world_from_grid = transform.0;
            Ok(())
        })
    }

    /// The placed grids.
    #[getter]
    fn instances(&self, py: Python<'_>) -> PyResult<Vec<PyInstance>> {
        self.looked_at(py, |scene| {
            let layer = |instance: &Instance| Some(scene.layers.get(instance.layer?)?.name.clone());
            let instance = |instance: &Instance| PyInstance {
                name: instance.name.clone(),
                grid: instance.grid,
                transform: rows_of(&instance.world_from_grid),
                hidden: !scene.is_visible(instance),
                layer: layer(instance),
            };
            scene.instances.iter().map(instance).collect()
        })
    }

    /// The voxels of a grid, with the materials of the scene.
    ///
    /// Raises `IndexError` where there is no such grid.
    fn grid(&self, py: Python<'_>, index: Index) -> PyResult<PyVoxelGrid> {
        let Index(index) = index;
        self.looked_at(py, |scene| {
            let grid = scene.grids.get(index).cloned();
            let grid = grid.map(|grid| PyVoxelGrid::new(grid, scene.materials.clone()));
            grid.ok_or_else(|| {
                PyIndexError::new_err(format!("there is no grid {index}: the scene has {}", scene.grids.len()))
            })
        })?
    }

    /// Materials; voxels refer to them by index.
    #[getter]
    fn materials(&self, py: Python<'_>) -> PyResult<Vec<PyMaterial>> {
        self.looked_at(py, |scene| scene.materials.iter().map(|material| PyMaterial(*material)).collect())
    }

    /// Replaces a material.
    ///
    /// Raises `IndexError` where there is no such material.
    fn set_material(slf: &Bound<'_, Self>, index: Index, material: PyMaterial) -> PyResult<()> {
        let Index(index) = index;
        Self::change(slf, |scene| {
            let count = scene.materials.len();
            let no_material = || PyIndexError::new_err(format!("there is no material {index}: the scene has {count}"));
            *scene.materials.get_mut(index).ok_or_else(no_material)? = material.0;
            Ok(())
        })
    }

    /// Light from outside.
    #[getter]
    fn sky(&self) -> PySky {
        match &self.content {
            Held::Scene(scene) => PySky(scene.sky.clone()),
            Held::Packed(packed) => PySky(packed.sky.clone()),
        }
    }

    #[setter]
    fn set_sky(slf: &Bound<'_, Self>, sky: PySky) -> PyResult<()> {
        Self::change(slf, |scene| {
            scene.sky = sky.0;
            Ok(())
        })
    }

    /// Factor on every material's emission.
    #[getter]
    fn light_intensity(&self) -> f32 {
        match &self.content {
            Held::Scene(scene) => scene.light_intensity,
            Held::Packed(packed) => packed.light_intensity,
        }
    }

    #[setter]
    fn set_light_intensity(slf: &Bound<'_, Self>, intensity: f32) -> PyResult<()> {
        if !(intensity >= 0.0 && intensity.is_finite()) {
            return Err(argument("light_intensity is ≥ 0"));
        }
        Self::change(slf, |scene| {
            scene.light_intensity = intensity;
            Ok(())
        })
    }

    /// Named cameras; the first one is the default.
    #[getter]
    fn cameras(&self) -> Vec<PyCamera> {
        let cameras = match &self.content {
            Held::Scene(scene) => &scene.cameras,
            Held::Packed(packed) => &packed.cameras,
        };
        cameras.iter().map(|camera| PyCamera(camera.clone())).collect()
    }

    #[setter]
    fn set_cameras(slf: &Bound<'_, Self>, cameras: Vec<PyCamera>) -> PyResult<()> {
        Self::change(slf, |scene| {
            scene.cameras = cameras.into_iter().map(|camera| camera.0).collect();
            Ok(())
        })
    }

    /// What of it is shown: the lowest and the highest corner of a box, world units; `None` where it is all. What the box cuts open is shown filled, and what is
    /// outside of it neither shines nor casts shadows. Files do not hold it.
    #[getter]
    fn clip(&self) -> Option<Corners> {
        self.clip
    }

    #[setter]
    fn set_clip(slf: &Bound<'_, Self>, clip: Option<(Three, Three)>) -> PyResult<()> {
        let clip = clip.map(|(low, high)| (low.single().to_array(), high.single().to_array()));
        let cuts = cuts_of(clip)?;
        let mut held = Self::alone(slf)?;
        for place in &mut held.packed {
            if let Some(packed) = place.get_mut().unwrap_or_else(PoisonError::into_inner) {
                Arc::make_mut(packed).cuts = cuts.clone();
            }
        }
        held.clip = clip;
        Ok(())
    }

    /// From the scene's world units to the coordinates of what it was made of, 4 × 4: those of a map, a patient, or a volume's own; `None` where it has none.
    #[getter]
    fn affine(&self) -> Option<[[f64; 4]; 4]> {
        let georeference = match &self.content {
            Held::Scene(scene) => scene.georeference.as_ref(),
            Held::Packed(packed) => packed.georeference.as_ref(),
        };
        let DAffine3 { matrix3, translation } = georeference?.coordinates_from_world;
        let row = |at: usize| [matrix3.x_axis[at], matrix3.y_axis[at], matrix3.z_axis[at], translation[at]];
        Some([row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]])
    }

    /// The animations of the file that it was read from: name, empty where it has none, and seconds that it lasts. `at` plays the one that `open` was asked for.
    #[getter]
    fn animations(&self) -> Vec<(String, f64)> {
        match &self.content {
            Held::Scene(scene) => scene.clips.iter().map(|clip| (clip.name.clone(), clip.seconds)).collect(),
            Held::Packed(_) => Vec::new(),
        }
    }

    /// Frames that the keyframes of a `.vox` file last; 0 where it has none.
    #[getter]
    fn keyframes(&self) -> u32 {
        match &self.content {
            Held::Scene(scene) => keyframe_count(scene),
            Held::Packed(_) => 0,
        }
    }

    /// The scene as it is at a time, in seconds, of its keyframes or of the animation that `open` was asked for: a scene of its own, which stands still. Cameras
    /// are where it has them then, and grids keep their numbers.
    ///
    /// `key_fps`: keyframes a second. `repeat`: an animation begins again when it is over; else its last pose holds.
    ///
    /// Raises `ValueError` for a time or a rate below 0.
    #[pyo3(signature = (seconds, *, key_fps=10.0, repeat=false))]
    fn at(&self, py: Python<'_>, seconds: f64, key_fps: f64, repeat: bool) -> PyResult<Self> {
        for (name, value) in [("seconds", seconds), ("key_fps", key_fps)] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(argument(format!("{name} is ≥ 0")));
            }
        }
        let Held::Scene(scene) = &self.content else { return Ok(self.__copy__()) };
        let clip = if repeat { Playback::Repeated } else { Playback::Once };
        let animation = Animation { keyframe_rate: key_fps, clip, ..Animation::default() };
        let now = detach(py, || animation.still_at(scene, seconds))?;
        Ok(Self { clip: self.clip, notes: self.notes.clone(), ..Self::of(now) })
    }

    /// Name for people.
    #[getter]
    fn name(&self) -> String {
        match &self.content {
            Held::Scene(scene) => scene.name.clone(),
            Held::Packed(packed) => packed.name.clone(),
        }
    }

    /// Voxels stored, each grid once.
    #[getter]
    fn voxels(&self, py: Python<'_>) -> PyResult<u64> {
        match &self.content {
            Held::Scene(scene) => Ok(py.detach(|| scene.grids.iter().map(|grid| grid.count()).sum())),
            Held::Packed(packed) => Ok(py.detach(|| packed.statistics().voxels)),
        }
    }

    /// The lowest and the highest corner of everything visible, world units; `None` where there is nothing.
    #[getter]
    fn bounds(&self, py: Python<'_>) -> PyResult<Option<([f32; 3], [f32; 3])>> {
        let packed = self.packed(py, false)?;
        Ok(packed.bounds().map(|(low, high)| (low.to_array(), high.to_array())))
    }

    /// What the scene holds and what it costs: `name`, `voxels` (each grid once), `voxels_placed` (each instance's), `models` (grids), `instances`, `materials`,
    /// `emissive_voxels`, `size` (of the box around everything visible, voxels), `bytes` by kind, `total_bytes`, `bytes_per_voxel`, `unit` (`"m"`, `"mm"` or `None`), `voxel_size` (edge of a
    /// voxel, in `unit`), `content_hash` (16 hexadecimal digits).
    fn info<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let packed = self.packed(py, false)?;
        let (statistics, hash) = detach(py, || (packed.statistics(), packed.content_hash()))?;
        let bytes = PyDict::new(py);
        for (kind, count) in statistics.bytes {
            bytes.set_item(kind, count)?;
        }
        let info = PyDict::new(py);
        info.set_item("name", &packed.name)?;
        info.set_item("voxels", statistics.voxels)?;
        info.set_item("voxels_placed", statistics.voxels_placed)?;
        info.set_item("models", statistics.models)?;
        info.set_item("instances", statistics.instances)?;
        info.set_item("materials", statistics.materials)?;
        info.set_item("emissive_voxels", statistics.emissive_voxels)?;
        let [x, y, z] = statistics.size;
        info.set_item("size", (x, y, z))?;
        info.set_item("bytes", bytes)?;
        info.set_item("total_bytes", statistics.total_bytes())?;
        info.set_item("bytes_per_voxel", statistics.bytes_per_voxel)?;
        info.set_item("unit", unit_name(packed.unit))?;
        info.set_item("voxel_size", packed.voxel_size)?;
        info.set_item("content_hash", format!("{hash:016x}"))?;
        Ok(info)
    }

    /// Writes the scene: `.vxt`, `.vox`, `.ply`, `.obj`, `.glb` and the other formats of `voxtrace convert`. Returns what the file does not hold, one
    /// phrase each. The file is whole or what it was before, also where Ctrl-C ends it.
    ///
    /// Raises `ValueError` for another name or a scene that the format has no place for, `OSError` where the file cannot be written.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<Vec<String>> {
        if path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("vxt")) {
            let packed = self.packed(py, false)?;
            let saved = run_while(py, |wanted| packed.save_while(&path, wanted))?;
            return saved.map(|()| Vec::new()).map_err(|error| match error.kind {
                FileErrorKind::Io(cause) => of_writing(&path, &cause),
                kind => argument(format!("{}: {kind}", path.display())),
            });
        }
        let writer = writer_of(&path)
            .ok_or_else(|| argument(format!("{}: no format that scenes are written in", path.display())))?;
        let content = &self.content;
        let written = run_while(py, |wanted| match content {
            Held::Scene(scene) => writer.write_while(&path, scene, wanted),
            Held::Packed(packed) => {
                let scene = packed.to_scene_while(wanted).ok_or(ExportError::Stopped)?;
                writer.write_while(&path, &scene, wanted)
            }
        })?;
        written.map_err(|error| match error {
            ExportError::Io { path, error } => of_writing(&path, &error),
            ExportError::Stopped => other(py, "stopped"),
            error => argument(error),
        })
    }

    /// The scene as the bytes of a `.vxt` file: to send it, and to keep it elsewhere than in a file.
    #[pyo3(name = "to_bytes")]
    fn packed_bytes<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let packed = self.packed(py, false)?;
        Ok(PyBytes::new(py, &detach(py, || packed.to_bytes())?))
    }

    /// What `__reduce__` has taken apart.
    #[staticmethod]
    fn _of_parts(
        py: Python<'_>,
        packed: Option<Vec<u8>>,
        parts: Option<SceneParts>,
        clip: Option<Corners>,
        notes: Vec<String>,
    ) -> PyResult<Self> {
        let scene = match (packed, parts) {
            (Some(packed), _) => Self::from_bytes(py, &packed)?,
            (None, Some(parts)) => Self::of(scene_of(py, parts)?),
            (None, None) => return Err(argument("nothing was pickled")),
        };
        cuts_of(clip)?;
        Ok(Self { clip, notes, ..scene })
    }

    /// For pickle: what makes the same scene, its clip and notes too.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Pickled)> {
        let (packed, parts) = match &self.content {
            Held::Packed(packed) => (Some(detach(py, || packed.to_bytes())?), None),
            Held::Scene(scene) => (None, Some(detach(py, || parts_of(scene))?.map_err(|error| of_packing(py, error))?)),
        };
        Ok((py.get_type::<Self>().getattr("_of_parts")?, (packed, parts, self.clip, self.notes.clone())))
    }

    /// A scene of its own. Voxels that none of the two changes are there once.
    fn __copy__(&self) -> Self {
        let content = match &self.content {
            Held::Scene(scene) => Held::Scene(scene.clone()),
            Held::Packed(packed) => Held::Packed(Arc::clone(packed)),
        };
        let packed = self.packed.each_ref().map(|place| Mutex::new(try_lock(place).and_then(|packed| packed.clone())));
        Self { content, packed, clip: self.clip, notes: self.notes.clone() }
    }

    /// As `copy.copy`: what is shared is never changed.
    fn __deepcopy__(&self, _memo: &Bound<'_, PyAny>) -> Self {
        self.__copy__()
    }

    /// The scene of the bytes of a `.vxt` file.
    ///
    /// Raises `ReadError` where they are none.
    #[staticmethod]
    fn from_bytes(py: Python<'_>, scene: &[u8]) -> PyResult<Self> {
        let packed = detach(py, || PackedScene::from_bytes(scene))?.map_err(|error| of_packed(py, error))?;
        Ok(Self::of_packed(Arc::new(packed)))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let voxels = self.voxels(py)?;
        Ok(format!("<Scene {:?}: {voxels} voxels>", self.name()))
    }
}

/// What a file had as a scene that can be changed.
fn unpacked(py: Python<'_>, packed: &PackedScene) -> PyResult<Scene> {
    run_while(py, |wanted| packed.to_scene_while(wanted))?.ok_or_else(|| other(py, "stopped"))
}

/// A grid with materials that are counted from `first` on.
fn counted_from(first: u16, grid: &VoxelGrid) -> VoxelGrid {
    let counted = |(place, brick): (IVec3, &Brick)| {
        let materials = brick.materials().iter().map(|material| material + first).collect();
        (place, Brick::new(*brick.occupancy(), materials))
    };
    VoxelGrid::from_bricks(grid.sorted_bricks().into_iter().map(counted))
}

/// What nobody else has now; `None` where somebody does.
fn try_lock<T>(mutex: &Mutex<T>) -> Option<MutexGuard<'_, T>> {
    match mutex.try_lock() {
        Ok(guard) => Some(guard),
        Err(TryLockError::Poisoned(poisoned)) => Some(poisoned.into_inner()),
        Err(TryLockError::WouldBlock) => None,
    }
}

/// Waits for a lock; `None` once `goes_on` says no.
fn lock_while<'a, T>(mutex: &'a Mutex<T>, goes_on: &dyn Fn() -> bool) -> Option<MutexGuard<'a, T>> {
    loop {
        match try_lock(mutex) {
            Some(guard) => return Some(guard),
            None if goes_on() => thread::sleep(PERIOD),
            None => return None,
        }
    }
}

fn no_instance(instance: usize, count: usize) -> PyErr {
    PyIndexError::new_err(format!("there is no instance {instance}: the scene has {count}"))
}

/// The cuts of a box.
fn cuts_of(clip: Option<Corners>) -> PyResult<Cuts> {
    let Some((low, high)) = clip else { return Ok(Cuts::default()) };
    Cuts::default().clip_box(low.into(), high.into()).map_err(argument)
}
