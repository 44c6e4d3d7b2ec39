//! Scenes and volumes from files, and built-in scenes.

use crate::arguments::{Number, number_of};
use crate::errors::{argument, of_reading, other};
use crate::interrupt::run;
use crate::scene::PyScene;
use crate::transfer::AnyTransfer;
use crate::volume::{PyVolume, scale_of};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use voxtrace::animation::{keyframe_count, playing};
use voxtrace::import::{self, ClipChoice, Content, ImportError, ImportOptions};
use voxtrace::scenes::{self, SceneError};
use voxtrace::volume::VolumeOptions;
use voxtrace::voxelize::VoxelizeOptions;

/// Which animation of a file is read: a name, a number, or `True` for the first.
pub struct AnimationChoice(ClipChoice);

impl FromPyObject<'_, '_> for AnimationChoice {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        if let Ok(is_first) = object.extract::<bool>() {
            return Ok(Self(if is_first { ClipChoice::First } else { ClipChoice::None }));
        }
        let number = object.extract::<u32>().map(|number| number.to_string());
        let chosen = number.or_else(|_| object.extract::<String>());
        let chosen =
            chosen.map_err(|_| argument("animation is a name, a number from 1 on, or whether there is one"))?;
        Ok(Self(ClipChoice::Named(chosen)))
    }
}

/// Runs a reader until it ends or Ctrl-C does it.
fn read<T: Send>(py: Python<'_>, reader: impl FnOnce() -> Result<T, ImportError> + Send) -> PyResult<T> {
    let wanted = Arc::new(AtomicBool::new(true));
    let goes_on = Arc::clone(&wanted);
    let stop = || wanted.store(false, Ordering::Relaxed);
    let result = run(py, stop, |_| Ok(()), || import::read_while(move || goes_on.load(Ordering::Relaxed), reader))?;
    result.map_err(|error| of_reading(py, &error))
}

/// What of a file is read.
fn import_options(
    channel: Option<Number<u32>>,
    time: Option<Number<u32>>,
    series: Option<Number<i64>>,
    strict: bool,
) -> PyResult<ImportOptions> {
    let (channel, time) = (number_of(channel, "channel", 1)?, number_of(time, "time", 1)?);
    Ok(ImportOptions {
        channel,
        time,
        series: number_of(series, "series", i64::MIN)?,
        strict,
        ..ImportOptions::default()
    })
}

/// A scene from a file or a folder of any format that `voxtrace formats` lists; meshes, points and scans are voxelized.
///
/// `resolution`: voxels along the longest side; `voxel_size`: their edge in units of the file. `fill`: the inside of closed meshes too. `transfer` and
/// `threshold`: what of a volume is shown. `channel` and `time`: of a volume, from 1 on. `series`: of a folder of DICOM files. `animation`: which of the animations of a
/// glTF file `Scene.at` plays, by name or number from 1 on, or `True` for the first; `key_fps`: shapes a second that are made of what bends in it. `shell`: of volumes only what a ray from outside can reach. `strict`: a damaged part is an error; else it is left out and `Scene.notes` says so.
///
/// Raises `ReadError`, `OSError` where the file cannot be opened, and `ValueError` where it has no such animation.
#[pyfunction]
#[pyo3(signature = (path, *, resolution=None, voxel_size=None, fill=false, transfer=None, threshold=None, shell=true, channel=None, time=None, series=None, animation=None, key_fps=24.0, strict=false))]
#[expect(clippy::too_many_arguments, reason = "keywords of Python")]
pub fn open(
    py: Python<'_>,
    path: PathBuf,
    resolution: Option<Number<u32>>,
    voxel_size: Option<f64>,
    fill: bool,
    transfer: Option<AnyTransfer>,
    threshold: Option<f32>,
    shell: bool,
    channel: Option<Number<u32>>,
    time: Option<Number<u32>>,
    series: Option<Number<i64>>,
    animation: Option<AnimationChoice>,
    key_fps: f64,
    strict: bool,
) -> PyResult<PyScene> {
    let scale = scale_of(resolution, voxel_size)?;
    let mut voxelize = VoxelizeOptions { fill, ..VoxelizeOptions::default() };
    voxelize.scale = scale.unwrap_or(voxelize.scale);
    let volume =
        VolumeOptions { scale, transfer: transfer.map(|transfer| transfer.0), threshold, shell, overlays: Vec::new() };
    let animation = animation.map_or(ClipChoice::None, |chosen| chosen.0);
    if !(key_fps >= 0.0 && key_fps.is_finite()) {
        return Err(argument("key_fps is ≥ 0"));
    }
    let import = import_options(channel, time, series, strict)?;
    let options = ImportOptions { voxelize, volume, animation, shape_rate: Some(key_fps), ..import };
    let loaded = read(py, || import::load(&path, &options))?;
    check_animation(&options.animation, &loaded.content)?;
    let mut scene = match loaded.content {
        Content::Scene(scene) => PyScene::of(*scene),
        Content::Packed(packed) => PyScene::of_packed(Arc::new(*packed)),
    };
    scene.notes = loaded.notes;
    Ok(scene)
}

/// That the animation that was asked for is there, and moves something.
fn check_animation(chosen: &ClipChoice, content: &Content) -> PyResult<()> {
    let clips = match content {
        Content::Scene(scene) if playing(scene).is_some() => return Ok(()),
        // What has keyframes plays them.
        Content::Scene(scene) if *chosen == ClipChoice::First && keyframe_count(scene) > 0 => return Ok(()),
        Content::Scene(scene) => &scene.clips[..],
        Content::Packed(_) => &[],
    };
    let there_are = || clips.iter().map(|clip| format!("{:?}", clip.name)).collect::<Vec<_>>().join(", ");
    match chosen {
        ClipChoice::None | ClipChoice::Later => Ok(()),
        _ if clips.is_empty() => Err(argument("the file has no animation")),
        ClipChoice::First => Err(argument("nothing moves in the first animation")),
        ClipChoice::Named(name) => {
            Err(argument(format!("there is no animation {name:?}, or nothing moves in it; there are: {}", there_are())))
        }
    }
}

/// The volume of a file or a folder: NIfTI, DICOM, NRRD, MetaImage, OME-TIFF, Zarr, OpenVDB and more.
///
/// `channel` and `time` count from 1. Raises `ReadError` where the file holds none, and `OSError` where it cannot be opened.
#[pyfunction]
#[pyo3(signature = (path, *, channel=None, time=None, series=None, strict=false))]
pub fn open_volume(
    py: Python<'_>,
    path: PathBuf,
    channel: Option<Number<u32>>,
    time: Option<Number<u32>>,
    series: Option<Number<i64>>,
    strict: bool,
) -> PyResult<PyVolume> {
    let options = import_options(channel, time, series, strict)?;
    read(py, || import::read_volume(&path, &options)).map(PyVolume)
}

/// A built-in scene: `"church"`, `"operating-room"`, `"city"`, `"forest"`, of about so many voxels, or of so many instances (forest).
///
/// Raises `ValueError` for another name or size.
#[pyfunction]
#[pyo3(signature = (name, *, voxels=None, instances=None))]
pub fn builtin(
    py: Python<'_>,
    name: &str,
    voxels: Option<Number<u64>>,
    instances: Option<Number<u32>>,
) -> PyResult<PyScene> {
    let (voxels, instances) = (number_of(voxels, "voxels", 1)?, number_of(instances, "instances", 1)?);
    let wanted = AtomicBool::new(true);
    let goes_on = || wanted.load(Ordering::Relaxed);
    let stop = || wanted.store(false, Ordering::Relaxed);
    let work = || match instances {
        Some(instances) if name == scenes::FOREST => scenes::generate_forest_while(instances, &goes_on),
        Some(_) => Err(SceneError::NotOfInstances(name.to_owned())),
        None => scenes::generate_while(name, voxels, &goes_on),
    };
    match run(py, stop, |_| Ok(()), work)? {
        Ok(scene) => Ok(PyScene::of(scene)),
        Err(SceneError::Stopped) => Err(other(py, "stopped")),
        Err(error) => Err(argument(error)),
    }
}
