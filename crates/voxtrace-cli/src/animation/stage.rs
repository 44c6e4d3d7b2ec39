//! A packed scene in motion: the camera and the placement of any time, and what films of a frame are told from others by.

use super::{Cast, Director, cameras};
use crate::failure::Failure;
use crate::session::trace_failure;
use crate::views::{View, ViewArgs};
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use voxtrace::animation::{Animation, Attached, CameraMotion, CameraTrack, playing};
use voxtrace::camera::Flight;
use voxtrace::changes::{PartName, SunSetting};
use voxtrace::motion::{Moment, Moments, Shot};
use voxtrace::output::SceneStamp;
use voxtrace::packed::PackedInstance;
use voxtrace::{Camera, Geometry, PackedScene, Placement, Scene, TraceError};

/// A scene in motion.
pub struct Stage {
    moved: Arc<Moved>,
    moments: Moments,
    animation: Arc<Animation>,
    fps: f64,
    shutter: f64,
    /// Those to render.
    pub frames: RangeInclusive<u32>,
    /// Whether the sky is the air's in the light of a sun that may move.
    is_physical: bool,
}

/// What a stage is set with.
pub struct Setting<'s> {
    pub view: &'s ViewArgs,
    /// Parts that are not seen.
    pub hidden: &'s [PartName],
    /// The scene that a camera frames.
    pub framed: &'s PackedScene,
    /// The camera that options and files name, for a scene whose animation has none.
    pub camera: &'s dyn Fn(Option<&str>) -> Result<Camera, Failure>,
    pub with_lens: &'s dyn Fn(Camera) -> Result<Camera, Failure>,
    /// The file that the scene comes from, beside which its bookmarks are.
    pub scene_file: Option<&'s Path>,
    pub is_physical: bool,
}

impl Cast {
    /// Puts the scene in motion: `scene` is the packed one with what is around it, and stands at time 0 afterwards.
    pub fn stage(mut self, director: &Director, setting: &Setting, scene: &mut PackedScene) -> Result<Stage, Failure> {
        let last = f64::from(self.total.saturating_sub(1)) / self.fps;
        self.animation.camera = Some(self.camera(director, setting, last)?);
        for part in setting.hidden {
            for object in part.objects(&self.outline).map_err(Failure::usage)? {
                self.base.instances[object].hidden = true;
                self.animation.objects.iter_mut().for_each(|track| track.instances.retain(|&own| own != object));
            }
        }
        let frames = setting.view.frames.clone().unwrap_or(1..=self.total);
        if *frames.end() > self.total && self.is_ended {
            let message = format!("frame {} is behind the end of {} frames", frames.end(), self.total);
            return Err(Failure::usage(message).hint("`frames` or `seconds` in the TOML say how many there are"));
        }
        // What is around the scene comes behind its objects.
        let objects = setting.framed.outline.objects.len() as u32;
        let further: Vec<_> = scene.instances().iter().filter(|own| own.scene_instance >= objects).copied().collect();
        let animation = Arc::new(self.animation);
        let geometry = self.is_moving.then(|| Arc::clone(scene.geometry()));
        let moved = Moved { now: Mutex::new(self.base.clone()), base: self.base, animation: Arc::clone(&animation) };
        let moved = Arc::new(moved);
        let moments = moments_of(Arc::clone(&moved), geometry, further);
        if let Some(placement) = moments(0.0).map_err(trace_failure)?.placement {
            *scene = scene.with_placement(&placement).map_err(Failure::other)?;
        }
        let (fps, shutter, is_physical) = (self.fps, self.shutter, setting.is_physical);
        Ok(Stage { moved, moments, animation, fps, shutter, frames, is_physical })
    }

    /// The camera: options come before the file.
    fn camera(&self, director: &Director, setting: &Setting, last: f64) -> Result<CameraTrack, Failure> {
        let view = setting.view;
        if let Some(path) = &view.flight {
            let cameras = crate::camera_file::open_all(path)?;
            let cameras = cameras.into_iter().map(setting.with_lens).collect::<Result<Vec<_>, _>>()?;
            let flight =
                Flight::through(&cameras).map_err(|reason| Failure::input(format!("{}: {reason}", path.display())))?;
            let all = f64::from(view.flight_frames.unwrap_or(self.total).saturating_sub(1).max(1));
            let (start, seconds, ease) = (0.0, all / self.fps, voxtrace::animation::Ease::None);
            return Ok(CameraTrack::new(CameraMotion::Flight { flight: flight.into(), start, seconds, ease }));
        }
        let camera = || (setting.camera)(None);
        if let Some(turn) = view.turntable {
            let turn = f64::from(if turn > 0 { turn } else { self.total });
            return Ok(CameraTrack::new(CameraMotion::Orbit { camera: camera()?, turns_per_second: self.fps / turn }));
        }
        let script = director.script.as_ref().filter(|_| !view.says_camera());
        let of_script = script.map(|script| {
            let bookmarks = script.bookmarks.clone().or_else(|| setting.scene_file.and_then(bookmarks_beside));
            script.with_table(|table| {
                let Some(table) = table.table("camera")? else { return Ok(None) };
                let around = cameras::Surroundings {
                    outline: &self.outline,
                    named: setting.camera,
                    with_lens: setting.with_lens,
                    bookmarks: bookmarks.as_deref(),
                    seconds: f64::from(self.total) / self.fps,
                    last,
                };
                cameras::track(&table, &around).map(Some)
            })
        });
        match of_script.transpose()?.flatten() {
            Some(CameraTrack { motion: CameraMotion::Still(camera), look_at, focuses_on_target }) => {
                Ok(CameraTrack { motion: self.on_its_node(camera), look_at, focuses_on_target })
            }
            Some(track) => Ok(track),
            None => {
                let mut camera = camera()?;
                // Where nothing else moves, it is the camera that does.
                if let Some(moving) = self.first_moving_camera().filter(|_| !self.is_moving && !view.says_camera()) {
                    camera = (setting.with_lens)(moving.clone())?;
                }
                Ok(CameraTrack::new(self.on_its_node(camera)))
            }
        }
    }

    /// The first camera that the file moves.
    fn first_moving_camera(&self) -> Option<&Camera> {
        let (_, motion) = playing(&self.base)?;
        self.base.cameras.get(motion.cameras.iter().map(|own| own.index).min()?)
    }

    /// A camera as the file moves it: where it is one of those that hang on a node, and stands where that has it.
    fn on_its_node(&self, camera: Camera) -> CameraMotion {
        let clip = self.base.clips.iter().find(|clip| clip.motion.is_some());
        let own = clip.and_then(|clip| {
            let is_it = |own: &&Attached| {
                self.base.cameras.get(own.index).is_some_and(|own| {
                    (&own.name, own.eye, own.target, own.up) == (&camera.name, camera.eye, camera.target, camera.up)
                })
            };
            clip.motion.as_ref()?.cameras.iter().find(is_it).copied()
        });
        match clip.zip(own) {
            Some((clip, own)) => {
                CameraMotion::OnNode { camera, clip: clip.clone(), playback: self.animation.clip, own }
            }
            None => CameraMotion::Still(camera),
        }
    }
}

/// Where the window keeps the bookmarks of a file.
fn bookmarks_beside(file: &Path) -> Option<PathBuf> {
    let name = file.file_name()?.to_str()?;
    let stem = name.strip_suffix(".nii.gz").or(name.rsplit_once('.').map(|(stem, _)| stem)).unwrap_or(name);
    Some(file.with_file_name(format!("{stem}.cameras.toml")))
}

/// The scene that is moved about, so that names and keyframes of thousands of objects are not copied for each moment.
struct Moved {
    base: Scene,
    now: Mutex<Scene>,
    animation: Arc<Animation>,
}

impl Moved {
    /// The camera at a time, and what `place` makes of the scene as it is then.
    fn at<R>(
        &self,
        seconds: f64,
        place: impl FnOnce(&Scene) -> Result<R, TraceError>,
    ) -> Result<(Camera, R), TraceError> {
        let mut now = self.now.lock().unwrap_or_else(PoisonError::into_inner);
        self.animation.apply(&self.base, &mut now, seconds);
        let camera = self.animation.camera_at(&now, seconds);
        let camera = camera.ok_or_else(|| TraceError::BadFrame("the animation has no camera".into()))?;
        Ok((camera, place(&now)?))
    }
}

/// The moments of a scene; the last one is kept, as a frame asks for its middle several times.
fn moments_of(moved: Arc<Moved>, geometry: Option<Arc<Geometry>>, further: Vec<PackedInstance>) -> Moments {
    let last: Mutex<Option<(f64, Moment)>> = Mutex::new(None);
    Arc::new(move |seconds| {
        let mut last = last.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, moment)) = last.as_ref().filter(|(time, _)| *time == seconds) {
            return Ok(moment.clone());
        }
        let before = last.as_ref().and_then(|(_, moment)| moment.placement.as_ref());
        let place = |geometry: &Arc<Geometry>, now: &Scene| match before {
            Some(before) => before.moved_to_scene_and(geometry, now, &further),
            None => Placement::of_scene_and(geometry, now, &further),
        };
        let placed = |now: &Scene| Ok(geometry.as_ref().map(|geometry| place(geometry, now)).transpose()?);
        let (camera, placement) = moved.at(seconds, placed)?;
        let moment = Moment { camera, placement };
        *last = Some((seconds, moment.clone()));
        Ok(moment)
    })
}

impl Stage {
    /// The shot of a frame, counted from 1: its shutter opens when its time comes.
    pub fn shot(&self, frame: u32) -> Shot {
        let opens = f64::from(frame.saturating_sub(1)) / self.fps;
        Shot { opens, exposure: self.shutter / self.fps, moments: Arc::clone(&self.moments) }
    }

    /// The views of the frames to render, each with the camera of the middle of its exposure.
    pub fn views(&self) -> Result<Vec<View>, Failure> {
        let view = |frame| {
            let shot = self.shot(frame);
            // Where things are then is looked up when it is their turn.
            let (camera, ()) = self.moved.at(shot.opens + 0.5 * shot.exposure, |_| Ok(())).map_err(trace_failure)?;
            Ok(View { camera, camera_suffix: None, frame: Some(frame) })
        };
        self.frames.clone().map(view).collect()
    }

    /// Whether the light changes, which is a part of the scene.
    pub fn moves_light(&self) -> bool {
        self.animation.sun.is_some() || self.animation.sky_brightness.is_some()
    }

    /// The scene as it is in the middle of a frame's exposure, and the stamp of its films.
    pub fn scene_of(
        &self,
        frame: u32,
        scene: &PackedScene,
        stamp: &SceneStamp,
    ) -> Result<(PackedScene, SceneStamp), Failure> {
        let shot = self.shot(frame);
        let (mut scene, mut stamp) = (scene.clone(), stamp.clone());
        if let Some(placement) = shot.middle().map_err(trace_failure)?.placement {
            scene = scene.with_placement(&placement).map_err(Failure::other)?;
        }
        let middle = shot.opens + 0.5 * shot.exposure;
        if let Some(sun) = &self.animation.sun {
            let [bearing, height, strength] = sun.at(middle).map(|value| value as f32);
            // A spline may leave the range of its keys.
            let sun = SunSetting { bearing, height: height.clamp(-90.0, 90.0), strength: strength.max(0.0) };
            let (brightness, has_disc) = (scene.sky.brightness(), scene.sky.is_sun_disc_visible());
            match self.is_physical.then(|| sun.physical_sky()).flatten() {
                Some(sky) => scene.sky = sky.with_brightness(brightness).with_sun_disc_visible(has_disc),
                None => scene.sky.set_sun(sun.sun()),
            }
        }
        if let Some(brightness) = &self.animation.sky_brightness {
            scene.sky.set_brightness(brightness.at(middle)[0].max(0.0) as f32);
        }
        stamp.sky = scene.sky.clone();
        stamp.content_hash = shot.stamp(stamp.content_hash).map_err(trace_failure)?;
        Ok((scene, stamp))
    }

    /// Frames a second.
    pub fn fps(&self) -> f64 {
        self.fps
    }
}
