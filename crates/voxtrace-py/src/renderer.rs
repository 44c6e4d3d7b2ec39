//! `Renderer`: a tracer with a scene, for many pictures and rays.

use crate::arguments::{Number, Numbers, Pixels, Size, number_of, transform_of};
use crate::camera::PyCamera;
use crate::editor::{Follower, PyEditor};
use crate::errors::{argument, of_tracing, other};
use crate::forks::detach;
use crate::found::Found;
use crate::image::PyImage;
use crate::interrupt::run;
use crate::scene::PyScene;
use numpy::ndarray::{Ix2, Ix3, IxDyn};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use voxtrace::glam::Vec3;
use voxtrace::output::SceneStamp;
use voxtrace::packed::{PackedInstance, Placement, PlacementError};
use voxtrace::{Camera, Frame, Integrator, PackedScene, Picture, Progress, Ray, Tracer};
use voxtrace_vulkan::{Choice, Request, Traversal, choose_for};

/// Renders pictures of one scene, again and again: the scene is packed and sent to the device once.
///
/// >>> import voxtrace
/// >>> renderer = voxtrace.Renderer(voxtrace.builtin("church", voxels=20_000), device="cpu")
/// >>> renderer.render(samples=2, size=(64, 36)).shape
/// (36, 64)
#[pyclass(name = "Renderer", module = "voxtrace")]
pub struct PyRenderer {
    /// Never locked: what uses it has the renderer for itself.
    tracer: Mutex<Box<dyn Tracer + Send>>,
    scene: Arc<PackedScene>,
    /// Whether the tracer may have another scene, as it does where it failed to follow.
    is_stale: bool,
    /// By which an editor knows it.
    follower: Arc<Follower>,
    is_placeable: bool,
    /// What traces, and why that.
    #[pyo3(get)]
    device: String,
}

#[pymethods]
impl PyRenderer {
    /// A renderer of a `Scene`, or of what an `Editor` edits. Of several of an editor the last one follows its edits.
    ///
    /// `device`: `"auto"` (a GPU, or the processor where there is none), `"cpu"`, the number or a part of the name of a device as `voxtrace devices`
    /// lists them, `"all"` (every GPU; they share the work, and the picture is the same), or numbers of several (`"0,1"`). `traversal`: `"walk"`, `"query"` or `"pipeline"`. `fast`: GPUs may round as they like; pictures are no longer the processor's bit for bit.
    /// `memory`: limit on GPU memory, bytes. `placeable`: instances are kept apart, so that `place` can move them; else those that stand on the lattice of voxels
    /// become one grid, which is faster. `film`: sky, sun and cuts are those of this picture, not the scene's.
    ///
    /// Raises `DeviceError` where the machine lacks what was asked for or the scene does not fit it.
    #[new]
    #[pyo3(signature = (scene, *, device="auto", traversal=None, fast=false, memory=None, placeable=false, film=None))]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn new(
        py: Python<'_>,
        scene: &Bound<'_, PyAny>,
        device: &str,
        traversal: Option<&str>,
        fast: bool,
        memory: Option<Number<u64>>,
        placeable: bool,
        film: Option<PyRef<'_, PyImage>>,
    ) -> PyResult<Self> {
        let request = request_of(device, traversal, fast, number_of(memory, "memory", 0)?)?;
        let lit = |packed: Arc<PackedScene>| match &film {
            Some(image) => lit_as(&packed, &image.picture.film_file().scene),
            None => packed,
        };
        let editor = scene.cast::<PyEditor>().ok().map(Bound::get);
        let (packed, taken) = match editor {
            Some(editor) => editor.begin(py)?,
            None => (scene.cast::<PyScene>()?.try_borrow()?.packed(py, placeable)?, 0),
        };
        let packed = lit(packed);
        let opened = run(py, || (), |_| Ok(()), || choose_for(&request, &packed))?;
        let Choice { tracer, reason, .. } = opened.map_err(|error| of_tracing(py, &error))?;
        let follower = Arc::new(Follower);
        let changed = editor.map(|editor| editor.lead(py, &follower, taken)).transpose()?.flatten().map(lit);
        Ok(Self {
            tracer: Mutex::new(tracer),
            is_stale: changed.is_some(),
            scene: changed.unwrap_or(packed),
            follower,
            is_placeable: placeable,
            device: reason,
        })
    }

    /// Renders a picture.
    ///
    /// `camera`: a `Camera`, the name of one of the scene's, or `None` for its first, or one that sees everything. `samples`: of each pixel. `size`: width and
    /// height, pixels; at most 2²⁸ pixels are rendered at once, and `region` renders a part of what has more. The same `seed` gives the same picture, bit for
    /// bit, on every device. `first_sample`: to be added to films with the samples before. `region`: `(x0, y0, x1, y1)`, pixels, the part that is rendered.
    /// `denoise`: noise is removed. `transparent`: the sky stays away. `aovs`: see `Image.aov`.
    /// `progress`: called with the share that is done, again and again.
    ///
    /// Raises `ValueError` for what cannot be rendered, `DeviceError` where the device fails; Ctrl-C ends it.
    #[pyo3(signature = (camera=None, *, samples=Number::Fits(64), size=Size(1280, 720), seed=Number::Fits(0), max_bounces=Number::Fits(8), integrator="path", denoise=true, transparent=false, aovs=false, first_sample=Number::Fits(0), region=None, progress=None),
        text_signature = "($self, camera=None, *, samples=64, size=(1280, 720), seed=0, max_bounces=8, integrator='path', denoise=True, transparent=False, aovs=False, first_sample=0, region=None, progress=None)")]
    #[expect(clippy::too_many_arguments, reason = "keywords of Python")]
    fn render(
        &mut self,
        py: Python<'_>,
        camera: Option<&Bound<'_, PyAny>>,
        samples: Number<u32>,
        size: Size,
        seed: Number<u32>,
        max_bounces: Number<u16>,
        integrator: &str,
        denoise: bool,
        transparent: bool,
        aovs: bool,
        first_sample: Number<u32>,
        region: Option<Pixels>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<PyImage> {
        let camera = self.camera(py, camera, size)?;
        let (samples, first_sample) = (samples.of("samples", 1)?, first_sample.of("first_sample", 0)?);
        let (seed, max_bounces) = (seed.of("seed", 0)?, max_bounces.of("max_bounces", 0)?);
        let integrator = match integrator {
            "path" => Integrator::Path,
            "essay" => Integrator::Essay,
            other => return Err(argument(format!("{other:?} is neither \"path\" nor \"essay\""))),
        };
        let mut frame = Frame::new(camera, size.0, size.1)
            .samples(samples)
            .first_sample(first_sample)
            .seed(seed)
            .max_bounces(max_bounces.into())
            .integrator(integrator)
            .transparent(transparent)
            .aovs(aovs);
        if let Some(Pixels([x0, y0, x1, y1])) = region {
            let is_inside = x0 < x1 && x1 <= size.0 && y0 < y1 && y1 <= size.1;
            if !is_inside {
                return Err(argument("region is (x0, y0, x1, y1), pixels of the picture, the end not included"));
            }
            frame = frame.region(voxtrace::Region { x0, y0, x1, y1 });
        }
        self.traced(py, frame, denoise, progress)
    }

    /// Renders samples of the picture that a film shows, with everything that the film was rendered with: `samples` of each pixel from `first_sample` on, of all of its pixels
    /// or those of `region`, `(x0, y0, x1, y1)`. They can be merged with films of other samples.
    ///
    /// Raises as `render` does.
    #[pyo3(signature = (film, *, samples, first_sample=Number::Fits(0), region=None, progress=None),
        text_signature = "($self, film, *, samples, first_sample=0, region=None, progress=None)")]
    fn render_like(
        &mut self,
        py: Python<'_>,
        film: PyRef<'_, PyImage>,
        samples: Number<u32>,
        first_sample: Number<u32>,
        region: Option<Pixels>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<PyImage> {
        let (samples, first_sample) = (samples.of("samples", 0)?, first_sample.of("first_sample", 0)?);
        let mut frame = film.picture.film_file().frame.clone().samples(samples).first_sample(first_sample);
        if let Some(Pixels([x0, y0, x1, y1])) = region {
            frame = frame.region(voxtrace::Region { x0, y0, x1, y1 });
        }
        drop(film);
        self.traced(py, frame, false, progress)
    }

    /// Finds for each ray the first voxel that it meets.
    ///
    /// `origins` and `directions`: shape `(N, 3)`, world units; `t_max`: one number or `(N,)`, in multiples of the direction's length. Returns a dict of arrays of length N: `hit`
    /// (bool), `t` (float32, as `t_max`, infinite for a miss), `position` (float32, `(N, 3)`, world units), `normal` (float32, `(N, 3)`), `voxel` (int32, `(N, 3)`, in the instance's grid),
    /// `instance` (uint32), `material` (uint32). Numbers of misses are 0, their instance and material 4294967295.
    ///
    /// Raises `ValueError` for other shapes and rays that are not finite.
    #[pyo3(signature = (origins, directions, t_max=None))]
    fn cast<'py>(
        &mut self,
        py: Python<'py>,
        origins: Numbers<'py, f32, Ix2>,
        directions: Numbers<'py, f32, Ix2>,
        t_max: Option<Numbers<'py, f32, IxDyn>>,
    ) -> PyResult<Bound<'py, PyDict>> {
        let (origins, directions) = (origins.as_array(), directions.as_array());
        let t_max: Option<Vec<f32>> = t_max.as_ref().map(|t_max| t_max.as_array().iter().copied().collect());
        let count = origins.nrows();
        let is_sound = origins.ncols() == 3 && directions.dim() == (count, 3);
        if !is_sound || t_max.as_ref().is_some_and(|t_max| t_max.len() != count && t_max.len() != 1) {
            return Err(argument("origins and directions have shape (N, 3), t_max has length N or 1"));
        }
        // Row by row, copied where they lie otherwise.
        let (origins, directions) = (origins.as_standard_layout(), directions.as_standard_layout());
        let (Some(origins), Some(directions)) = (origins.as_slice(), directions.as_slice()) else {
            return Err(argument("arrays are of rows"));
        };
        let rows = (origins.as_chunks::<3>().0, directions.as_chunks::<3>().0);
        let ray = |index: usize| {
            let mut ray = Ray::new(Vec3::from_array(rows.0[index]), Vec3::from_array(rows.1[index]));
            if let Some(t_max) = &t_max {
                ray.t_max = t_max[if t_max.len() == 1 { 0 } else { index }];
            }
            ray
        };
        self.give_scene(py)?;
        let (tracer, scene) = (exclusive(&mut self.tracer), &self.scene);
        let wanted = AtomicBool::new(true);
        let stop = || wanted.store(false, Ordering::Relaxed);
        let found = run(py, stop, |_| Ok(()), || Found::by(tracer, scene, count, &ray, &wanted))?;
        found?.map_err(|error| of_tracing(py, &error))?.into_dict(py)
    }

    /// Puts instances elsewhere: `transforms` of shape `(N, 4, 4)`, in the order of the visible instances of the scene. The geometry stays on the device.
    ///
    /// Raises `ValueError` for another number of them, for those that shear, and where the renderer was not made with `placeable=True`.
    fn place(&mut self, py: Python<'_>, transforms: Numbers<'_, f64, Ix3>) -> PyResult<()> {
        let transforms = transforms.as_array();
        let instances = self.scene.instances();
        if !self.is_placeable {
            return Err(argument("make the renderer with placeable=True, so that instances are kept apart"));
        }
        if transforms.dim() != (instances.len(), 4, 4) {
            return Err(argument(format!("shape ({}, 4, 4) is wanted", instances.len())));
        }
        let placed = |(index, instance): (usize, &PackedInstance)| {
            let rows = [0, 1, 2, 3].map(|row| [0, 1, 2, 3].map(|column| transforms[[index, row, column]]));
            transform_of(&rows).map(|transform| PackedInstance::new(instance.grid, transform, instance.scene_instance))
        };
        let placed = instances.iter().enumerate().map(placed).collect::<PyResult<Vec<_>>>()?;
        let scene = &self.scene;
        let moved = detach(py, || {
            let placement = scene.placement().moved(scene.geometry(), placed)?;
            let moved = scene.with_placement(&placement)?;
            Ok::<(Placement, Arc<PackedScene>), PlacementError>((placement, Arc::new(moved)))
        })?;
        let (placement, moved) = moved.map_err(argument)?;
        self.give_scene(py)?;
        let tracer = exclusive(&mut self.tracer);
        self.is_stale = true;
        detach(py, || tracer.set_placement(&placement))?.map_err(|error| of_tracing(py, &error))?;
        (self.scene, self.is_stale) = (moved, false);
        Ok(())
    }

    /// Renders another scene from now on: a frame of an animation after the other, without a device opened anew. It no longer follows an editor.
    ///
    /// Raises `DeviceError` where the scene does not fit the device; make another renderer then.
    fn show(&mut self, py: Python<'_>, scene: PyRef<'_, PyScene>) -> PyResult<()> {
        let packed = scene.packed(py, self.is_placeable)?;
        drop(scene);
        (self.scene, self.is_stale) = (packed, true);
        self.follower = Arc::new(Follower);
        self.give_scene(py)
    }

    /// Follows the edits of the `Editor` that this renderer was made of, since the last time.
    ///
    /// Raises `ValueError` where it was made of something else, or another one was made of the editor since; nothing has changed then. Raises `DeviceError` where
    /// the device fails; the edits are followed all the same, and the device gets the whole scene when it is next needed.
    fn follow(&mut self, py: Python<'_>, editor: &PyEditor) -> PyResult<()> {
        let patches = editor.follow(py, &self.follower, &mut self.scene)?.ok_or_else(|| {
            argument("the renderer was not made of this editor, or another one follows it: make it anew")
        })?;
        if !std::mem::replace(&mut self.is_stale, true) {
            let tracer = exclusive(&mut self.tracer);
            let followed = detach(py, || patches.iter().try_for_each(|patch| tracer.patch(patch)))?;
            followed.map_err(|error| of_tracing(py, &error))?;
            self.is_stale = false;
        }
        self.give_scene(py)
    }

    /// The camera that looks when none is given.
    #[pyo3(signature = (size=Size(1280, 720)), text_signature = "($self, size=(1280, 720))")]
    fn default_camera(&self, py: Python<'_>, size: Size) -> PyResult<PyCamera> {
        let aspect = size.0 as f32 / size.1.max(1) as f32;
        match self.scene.cameras.first() {
            Some(camera) => Ok(PyCamera(camera.clone())),
            None => detach(py, || PyCamera(self.scene.portrait(aspect))),
        }
    }

    fn __reduce__(&self) -> PyResult<()> {
        let text = "a Renderer is not pickled or copied, as it holds a device: make one where it is needed, of a Scene, which can be";
        Err(PyTypeError::new_err(text))
    }

    fn __repr__(&self) -> String {
        format!("<Renderer of {:?}: {}>", self.scene.name, self.device)
    }
}

/// What nobody else can hold.
fn exclusive<T>(mutex: &mut Mutex<Box<T>>) -> &mut T
where
    T: ?Sized,
{
    mutex.get_mut().unwrap_or_else(PoisonError::into_inner)
}

impl PyRenderer {
    /// Gives the tracer the scene where it may have another one.
    fn give_scene(&mut self, py: Python<'_>) -> PyResult<()> {
        if self.is_stale {
            let (tracer, scene) = (exclusive(&mut self.tracer), &self.scene);
            let given = run(py, || (), |_| Ok(()), || tracer.set_scene(scene))?;
            given.map_err(|error| of_tracing(py, &error))?;
            self.is_stale = false;
        }
        Ok(())
    }

    fn traced(
        &mut self,
        py: Python<'_>,
        frame: Frame,
        denoise: bool,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<PyImage> {
        // Before the film is made.
        frame.check().map_err(|error| of_tracing(py, &error))?;
        self.give_scene(py)?;
        let all = frame.region.pixels() as u64 * u64::from(frame.samples);
        let (done, scene, tracer) = (Progress::default(), &self.scene, exclusive(&mut self.tracer));
        let tell = |py: Python<'_>| match &progress {
            Some(progress) => progress.call1(py, (done.samples_done() as f64 / all.max(1) as f64,)).map(drop),
            None => Ok(()),
        };
        let work = || Picture::trace(tracer, scene, frame, denoise, &done);
        let picture = run(py, || done.cancel(), tell, work)?.map_err(|error| of_tracing(py, &error))?;
        if let Some(progress) = &progress {
            progress.call1(py, (1.0,))?;
        }
        let picture = picture.ok_or_else(|| other(py, "stopped"))?;
        let remarks = exclusive(&mut self.tracer).take_notes().into_iter().map(|note| format!("; {note}"));
        Ok(PyImage::new(picture, self.device.clone() + &remarks.collect::<String>()))
    }

    fn camera(&self, py: Python<'_>, camera: Option<&Bound<'_, PyAny>>, size: Size) -> PyResult<Camera> {
        let Some(camera) = camera else { return Ok(self.default_camera(py, size)?.0) };
        if let Ok(camera) = camera.extract::<PyCamera>() {
            return Ok(camera.0);
        }
        let name: String = camera.extract().map_err(|_| argument("camera is a Camera, a name or None"))?;
        let found = self.scene.cameras.iter().find(|camera| camera.name == name);
        let there_are = || self.scene.cameras.iter().map(|camera| camera.name.as_str()).collect::<Vec<_>>().join(", ");
        found.cloned().ok_or_else(|| argument(format!("the scene has no camera {name:?}; there are: {}", there_are())))
    }
}

/// The scene in the light of a film, and cut as it is there.
fn lit_as(scene: &PackedScene, film: &SceneStamp) -> Arc<PackedScene> {
    let mut scene = scene.clone();
    (scene.sky, scene.light_intensity, scene.cuts) = (film.sky.clone(), film.light_intensity, film.cuts.clone());
    Arc::new(scene)
}

fn request_of(device: &str, traversal: Option<&str>, is_fast: bool, memory_budget: Option<u64>) -> PyResult<Request> {
    let traversal = match (traversal, device) {
        (None, "cpu") => Some(Traversal::Cpu),
        (Some(_), "cpu") => return Err(argument("the processor has one traversal")),
        (None, _) => None,
        (Some("walk"), _) => Some(Traversal::Walk),
        (Some("query"), _) => Some(Traversal::Query),
        (Some("pipeline"), _) => Some(Traversal::Pipeline),
        (Some(other), _) => return Err(argument(format!("{other:?} is none of \"walk\", \"query\" and \"pipeline\""))),
    };
    let device = Some(device).filter(|device| !["auto", "cpu"].contains(device)).map(str::to_owned);
    Ok(Request { traversal, device, memory_budget, is_fast, ..Request::default() })
}
