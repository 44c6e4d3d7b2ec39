//! Cameras on their way.

use super::curve::Ease;
use super::middle_of;
use super::nodes::{Attached, Clip, Playback};
use super::turn::rotation;
use crate::camera::{Camera, Flight, Lens};
use crate::scene::Scene;
use glam::{DAffine3, DVec3, Vec3};

/// A camera over time.
#[derive(Clone, Debug)]
pub struct CameraTrack {
    /// How it moves.
    pub motion: CameraMotion,
    /// What it looks at, whatever the motion says.
    pub look_at: Option<LookAt>,
    /// Whether a thin lens is in focus at the target.
    pub focuses_on_target: bool,
}

/// How a camera moves.
#[derive(Clone, Debug)]
pub enum CameraMotion {
    /// Not at all.
    Still(Camera),
    /// Around the vertical through its target, counter-clockwise seen from above.
    Orbit {
        /// At time 0.
        camera: Camera,
        /// Turns a second.
        turns_per_second: f64,
    },
    /// Along a flight.
    Flight {
        /// The way.
        flight: Box<Flight>,
        /// When it sets out, seconds.
        start: f64,
        /// How long it takes, > 0.
        seconds: f64,
        /// How it speeds up and slows down.
        ease: Ease,
    },
    /// On a node of a clip that the scene brings along.
    OnNode {
        /// What it is like, and where it stands at rest.
        camera: Camera,
        /// The clip.
        clip: Clip,
        /// How it is played.
        playback: Playback,
        /// Where it hangs, one of the cameras of the clip.
        own: Attached,
    },
}

/// What a camera looks at.
#[derive(Clone, Debug, PartialEq)]
pub enum LookAt {
    /// A point, world space.
    Point(Vec3),
    /// The middle of instances, wherever they are, and so far from it.
    Instances(Vec<usize>, Vec3),
}

impl CameraTrack {
    /// A camera that moves so.
    pub fn new(motion: CameraMotion) -> Self {
        Self { motion, look_at: None, focuses_on_target: false }
    }

    /// The camera at a time; `now` is the scene as it is then.
    pub fn at(&self, now: &Scene, seconds: f64) -> Camera {
        let mut camera = match &self.motion {
            CameraMotion::Still(camera) => camera.clone(),
            CameraMotion::Orbit { camera, turns_per_second } => orbited(camera, turns_per_second * seconds),
            CameraMotion::Flight { flight, start, seconds: length, ease } => {
                flight.at(ease.at((seconds - start) / length))
            }
            CameraMotion::OnNode { camera, clip, playback, own } => {
                let time = playback.time(seconds, clip.seconds);
                let map = time.zip(clip.motion.as_ref()).map(|(time, motion)| motion.world_from_camera(own, time));
                map.and_then(|map| carried(camera, &map)).unwrap_or_else(|| camera.clone())
            }
        };
        let target = match &self.look_at {
            Some(LookAt::Point(point)) => Some(*point),
            Some(LookAt::Instances(instances, offset)) => middle_of(now, instances).map(|middle| middle + *offset),
            None => None,
        };
        camera.target = target.filter(|&target| target != camera.eye).unwrap_or(camera.target);
        if let (true, Lens::Thin { focus, .. }) = (self.focuses_on_target, &mut camera.lens) {
            *focus = camera.eye.distance(camera.target).max(f32::MIN_POSITIVE);
        }
        camera
    }

    /// When it comes to an end, seconds; `None` where it goes on for ever, or does not move.
    pub fn end(&self) -> Option<f64> {
        match &self.motion {
            CameraMotion::Flight { start, seconds, .. } => Some(start + seconds),
            _ => None,
        }
    }
}

/// A camera at the origin of a space, looking along its −z with y up, as far from its target as it is; `None` where the map is flat.
fn carried(camera: &Camera, map: &DAffine3) -> Option<Camera> {
    let forward = map.transform_vector3(DVec3::NEG_Z).try_normalize()?;
    let up = map.transform_vector3(DVec3::Y).try_normalize()?;
    let distance = f64::from(camera.eye.distance(camera.target));
    let target = (map.translation + forward * distance).as_vec3();
    Some(Camera { eye: map.translation.as_vec3(), target, up: up.as_vec3(), ..camera.clone() })
}

/// The camera, carried around the vertical through its target.
fn orbited(camera: &Camera, turns: f64) -> Camera {
    let turn = rotation(DVec3::Z, turns);
    let offset = turn * (camera.eye - camera.target).as_dvec3();
    let eye = (camera.target.as_dvec3() + offset).as_vec3();
    Camera { eye, up: (turn * camera.up.as_dvec3()).as_vec3(), ..camera.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Instance, Transform, VoxelGrid};
    use glam::IVec3;

    #[test]
    fn a_camera_looks_at_what_moves_and_is_in_focus_there() {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        let mut scene = Scene::from_grid("one", grid, vec![crate::Material::default()]);
        scene.instances = vec![Instance::new(0, Transform::from_translation(Vec3::new(9.5, 29.5, -0.5)))];
        let lens = Lens::Thin { aperture: 1.0, focus: 5.0, blades: 0, blade_rotation: 0.0 };
        let camera = Camera::look_at(Vec3::new(10.0, 0.0, 0.0), Vec3::ZERO).with_lens(lens);
        let track = CameraTrack {
            look_at: Some(LookAt::Instances(vec![0], Vec3::ZERO)),
            focuses_on_target: true,
            motion: CameraMotion::Still(camera.clone()),
        };
        let seen = track.at(&scene, 0.0);
        assert_eq!(seen.target, Vec3::new(10.0, 30.0, 0.0));
        assert!(matches!(seen.lens, Lens::Thin { focus, .. } if focus == 30.0));
        assert_eq!(CameraTrack::new(CameraMotion::Still(camera.clone())).at(&scene, 3.0), camera);
    }

    #[test]
    fn an_orbit_is_a_turntable() {
        let camera = Camera::look_at(Vec3::new(10.0, 3.0, 5.0), Vec3::new(2.0, 1.0, 0.0));
        let track = CameraTrack::new(CameraMotion::Orbit { camera: camera.clone(), turns_per_second: 0.5 });
        let scene = Scene::new("empty");
        for frame in 1..=8u32 {
            let (ours, turned) = (track.at(&scene, f64::from(frame - 1) / 4.0), camera.turned(frame, 8));
            assert!(ours.eye.abs_diff_eq(turned.eye, 1e-4) && ours.target == turned.target, "{frame}");
        }
        assert!(!track.at(&scene, 0.25).eye.abs_diff_eq(camera.eye, 1.0), "the comparison sees another place");
    }
}
