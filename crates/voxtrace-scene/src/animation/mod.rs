//! Scenes that change with time: objects that move, turn, come and go, cameras on their way, a sun that wanders. An [`Animation`] is a pure
//! function of time, in seconds: only + − × ÷ √ and our own sine, so that every machine gets the same frames.

mod camera;
mod curve;
mod keyframes;
mod motion;
mod nodes;
mod path;
mod turn;

pub use camera::{CameraMotion, CameraTrack, LookAt};
pub use curve::{Curve, Ease, Interpolation};
pub use keyframes::{keyframe_count, placed_at};
pub use motion::{Motion, PoseKey};
pub use nodes::{
    Attached, Channel, Clip, KeyKind, KeyTrack, MovingNode, NodeMotion, NodePose, Playback, Shape, ShapeSteps,
};
/// For meshes whose nodes move, in other crates of voxtrace: not covered by semantic versioning.
#[doc(hidden)]
pub use nodes::{similarity_of, turn_of};
pub use path::SmoothPath;
pub use turn::{rotation, slerp};

use crate::camera::Camera;
use crate::scene::{Instance, Scene};
use glam::Vec3;

/// What changes about a scene, and how.
#[derive(Clone, Debug, Default)]
pub struct Animation {
    /// Frames a second of the keyframes that instances bring along ([`crate::Instance::keyframes`]); 0: they stand still.
    pub keyframe_rate: f64,
    /// How the clip that the scene brings along is played ([`Scene::clips`]: the first with a motion).
    pub clip: Playback,
    /// Objects that move or come and go, beside that. Of one instance all count, one after the other.
    pub objects: Vec<ObjectTrack>,
    /// The camera; `None`: the scene's.
    pub camera: Option<CameraTrack>,
    /// Bearing and height of the sun, degrees, and its strength; `None`: the scene's.
    pub sun: Option<Curve<3>>,
    /// Factor on the sky; `None`: the scene's.
    pub sky_brightness: Option<Curve<1>>,
}

/// Objects that move as one.
#[derive(Clone, Debug, Default)]
pub struct ObjectTrack {
    /// Indices into [`Scene::instances`].
    pub instances: Vec<usize>,
    /// How they move in the world: the first one first.
    pub motions: Vec<Motion>,
    /// From when on they are seen or not, by rising time; before the first that holds. Empty: as the scene says.
    pub visible: Vec<(f64, bool)>,
    /// From when on they show which grid of the scene, by rising time; before the first that holds. Empty: the grid that they have.
    pub grids: Vec<(f64, usize)>,
}

impl Animation {
    /// Whether objects move or change, and not the camera and the light alone.
    pub fn moves_objects(&self, scene: &Scene) -> bool {
        let has_keyframes = scene.instances.iter().any(|instance| instance.keyframes.len() > 1);
        let of_clip = self.clip != Playback::Still && playing(scene).is_some_and(|(_, own)| !own.instances.is_empty());
        !self.objects.is_empty() || (self.keyframe_rate > 0.0 && has_keyframes) || of_clip
    }

    /// Which instances of the scene move or change.
    pub fn moving(&self, scene: &Scene) -> Vec<bool> {
        let has_keyframes = |instance: &Instance| self.keyframe_rate > 0.0 && instance.keyframes.len() > 1;
        let mut moving: Vec<bool> = scene.instances.iter().map(has_keyframes).collect();
        let tracked = self.objects.iter().flat_map(|track| track.instances.iter().copied());
        let clip = playing(scene).filter(|_| self.clip != Playback::Still);
        let of_clip = clip.into_iter().flat_map(|(_, own)| own.instances.iter().map(|instance| instance.index));
        tracked.chain(of_clip).for_each(|index| moving[index] = true);
        moving
    }

    /// The scene as it is at a time: what moves stands where it is then.
    pub fn scene_at(&self, scene: &Scene, seconds: f64) -> Scene {
        let mut now = scene.clone();
        self.apply(scene, &mut now, seconds);
        now
    }

    /// As [`Self::scene_at`], into the scene of another time: `now` must have been made of `scene`.
    pub fn apply(&self, scene: &Scene, now: &mut Scene, seconds: f64) {
        if self.keyframe_rate > 0.0 {
            let frame = seconds * self.keyframe_rate;
            for (instance, now) in scene.instances.iter().zip(&mut now.instances) {
                (now.grid, now.world_from_grid) = placed_at(instance, frame);
            }
        }
        let tracked = || self.objects.iter().flat_map(|track| &track.instances);
        for &index in tracked() {
            if self.keyframe_rate <= 0.0 {
                let original = &scene.instances[index];
                (now.instances[index].grid, now.instances[index].world_from_grid) =
                    (original.grid, original.world_from_grid);
            }
        }
        let played = playing(scene).and_then(|(length, own)| Some((self.clip.time(seconds, length)?, own)));
        let flat = played.map(|(time, motion)| motion.place(scene, now, time)).unwrap_or_default();
        for track in &self.objects {
            let motion = track.motions.iter().map(|motion| motion.at(seconds)).reduce(|first, next| next.after(&first));
            let (visible, grid) = (step_at(&track.visible, seconds), step_at(&track.grids, seconds));
            for &index in &track.instances {
                let instance = &mut now.instances[index];
                if let Some(motion) = motion {
                    instance.world_from_grid = motion.after(&instance.world_from_grid);
                }
                // What the clip leaves without a size is not seen whatever is said.
                instance.hidden = visible.map_or(instance.hidden, |visible| !visible || flat.contains(&index));
                instance.grid = grid.unwrap_or(instance.grid);
            }
        }
    }

    /// As [`Self::scene_at`], but a scene that stands still from then on: without keyframes and clips, and with the cameras that hang on nodes of the clip
    /// where they are.
    pub fn still_at(&self, scene: &Scene, seconds: f64) -> Scene {
        let mut now = self.scene_at(scene, seconds);
        if let Some((clip, motion)) = scene.clips.iter().find_map(|clip| Some((clip, clip.motion.as_ref()?))) {
            for &own in &motion.cameras {
                let (camera, clip) = (scene.cameras[own.index].clone(), clip.clone());
                let on_node = CameraMotion::OnNode { camera, clip, playback: self.clip, own };
                now.cameras[own.index] = CameraTrack::new(on_node).at(scene, seconds);
            }
        }
        for instance in &mut now.instances {
            instance.keyframes.clear();
            instance.repeats = None;
        }
        now.clips.clear();
        now
    }

    /// The camera at a time; `now` is the scene as it is then. `None` where the animation has none.
    pub fn camera_at(&self, now: &Scene, seconds: f64) -> Option<Camera> {
        self.camera.as_ref().map(|track| track.at(now, seconds))
    }
}

/// How long the clip lasts that a scene brings along, seconds, and what moves in it.
pub fn playing(scene: &Scene) -> Option<(f64, &NodeMotion)> {
    scene.clips.iter().find_map(|clip| Some((clip.seconds, &**clip.motion.as_ref()?)))
}

/// What holds at a time.
fn step_at<T: Copy>(keys: &[(f64, T)], seconds: f64) -> Option<T> {
    let after = keys.partition_point(|&(time, _)| time <= seconds);
    keys.get(after.saturating_sub(1)).map(|&(_, value)| value)
}

/// The middle of the box around instances, world space; `None` where they have no voxels.
pub fn middle_of(scene: &Scene, instances: &[usize]) -> Option<Vec3> {
    bounds_of(scene, instances).map(|(min, max)| (min + max) * 0.5)
}

/// The box around instances, world space; `None` where they have no voxels.
pub fn bounds_of(scene: &Scene, instances: &[usize]) -> Option<(Vec3, Vec3)> {
    let (mut min, mut max) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &index in instances {
        let instance = &scene.instances[index];
        let Some(bounds) = scene.grids[instance.grid].bounds() else { continue };
        for corner in 0..8 {
            let pick = |axis: usize| if corner >> axis & 1 == 1 { bounds.max[axis] } else { bounds.min[axis] } as f32;
            let corner = instance.world_from_grid.point(Vec3::new(pick(0), pick(1), pick(2)));
            (min, max) = (min.min(corner), max.max(corner));
        }
    }
    min.is_finite().then_some((min, max))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VoxelGrid;
    use crate::material::Material;
    use crate::scene::Keyframe;
    use crate::transform::Transform;
    use glam::{DAffine3, DQuat, DVec3, IVec3};

    /// Two boxes of 2³ voxels; the second one has keyframes, of which the middle one shows the other grid.
    fn scene() -> Scene {
        let mut scene = Scene { materials: vec![Material::default()], ..Scene::new("boxes") };
        for edge in [2, 4] {
            let mut grid = VoxelGrid::new();
            (0..edge * edge * edge)
                .for_each(|i| _ = grid.set(IVec3::new(i % edge, i / edge % edge, i / edge / edge), 0));
            scene.grids.push(grid.into());
        }
        let at = |x: f32| Transform::from_translation(Vec3::X * x);
        let keyframes =
            vec![Keyframe { end: at(30.0), ..Keyframe::still(0, 0, at(10.0)) }, Keyframe::still(10, 1, at(50.0))];
        let moving = Instance { keyframes, repeats: Some(0..20), ..Instance::new(0, at(10.0)) };
        scene.instances = vec![Instance::new(0, at(0.0)), moving];
        scene
    }

    #[test]
    fn keyframes_play_at_their_rate_and_come_again() {
        let (scene, animation) = (scene(), Animation { keyframe_rate: 10.0, ..Animation::default() });
        let now = |seconds: f64| {
            let instance = &animation.scene_at(&scene, seconds).instances[1];
            (instance.grid, instance.world_from_grid.translation.x)
        };
        assert_eq!((now(0.0), now(0.5), now(1.0), now(1.9)), ((0, 10.0), (0, 20.0), (1, 50.0), (1, 50.0)));
        assert_eq!((now(2.0), now(4.5)), ((0, 10.0), (0, 20.0)));
        // 0.7 seconds are 7 frames, whatever the rounding.
        assert_eq!(now(7.0 / 10.0 * 1.0), (0, 24.0));
        let faster = Animation { keyframe_rate: 20.0, ..animation.clone() };
        assert_ne!(faster.scene_at(&scene, 0.5), animation.scene_at(&scene, 0.5), "the comparison sees another rate");
        assert_eq!(Animation::default().scene_at(&scene, 3.0), scene);
    }

    #[test]
    fn what_stands_still_from_a_time_on_is_where_it_was_then() {
        let (scene, animation) = (scene(), Animation { keyframe_rate: 10.0, ..Animation::default() });
        let still = animation.still_at(&scene, 0.5);
        let placed = |scene: &Scene| scene.instances[1].world_from_grid.translation.x;
        assert_eq!((placed(&still), still.instances[1].keyframes.len(), keyframe_count(&still)), (20.0, 0, 0));
        assert_eq!(animation.scene_at(&still, 1.0), still);
        assert_ne!(animation.scene_at(&scene, 1.0), scene, "the comparison sees what moves");
    }

    #[test]
    fn motions_follow_one_another_and_a_scene_of_another_time_leaves_nothing() {
        let scene = scene();
        let middle = middle_of(&scene, &[0]).unwrap();
        assert_eq!(middle, Vec3::ONE);
        let spin = Motion::Spin { pivot: middle.as_dvec3(), axis: DVec3::Z, turns_per_second: 0.25 };
        let still = |time: f64, offset: DVec3| PoseKey { time, offset, turn: DQuat::IDENTITY, scale: 1.0 };
        let keys = vec![still(0.0, DVec3::ZERO), still(2.0, DVec3::Y * 8.0)];
        let slide = Motion::keys(middle.as_dvec3(), keys, Interpolation::Linear);
        let track = ObjectTrack {
            instances: vec![0],
            motions: vec![spin, slide],
            visible: vec![(0.0, true), (1.5, false)],
            ..ObjectTrack::default()
        };
        let animation = Animation { objects: vec![track], ..Animation::default() };
        assert!(animation.moves_objects(&scene));
        assert_eq!(animation.moving(&scene), [true, false]);
        let now = animation.scene_at(&scene, 1.0);
        // A quarter turn about the middle, then four along y.
        let corner = now.instances[0].world_from_grid.point(Vec3::ZERO);
        assert!(corner.abs_diff_eq(Vec3::new(2.0, 4.0, 0.0), 1e-5), "{corner}");
        assert!(!now.instances[0].hidden && animation.scene_at(&scene, 1.5).instances[0].hidden);
        let mut reused = animation.scene_at(&scene, 1.7);
        animation.apply(&scene, &mut reused, 1.0);
        assert_eq!(reused, now);
        assert_ne!(animation.scene_at(&scene, 1.01), now, "the comparison sees another time");
    }

    #[test]
    fn what_a_clip_leaves_without_a_size_is_not_shown_by_a_track() {
        let mut scene = scene();
        let grows = KeyTrack::new(vec![0.0, 1.0], vec![[0.0; 3], [1.0; 3]], KeyKind::Step).unwrap();
        let rest = NodePose { translation: DVec3::ZERO, rotation: DQuat::IDENTITY, scale: DVec3::ONE };
        let (parent_from_outer, channels) = (DAffine3::IDENTITY, vec![Channel::Scale(grows)]);
        let motion = NodeMotion {
            nodes: vec![MovingNode { parent: None, parent_from_outer, rest, channels }],
            world_from_file: DAffine3::IDENTITY,
            instances: vec![Attached { index: 0, node: 0, node_from_own: DAffine3::IDENTITY }],
            cameras: Vec::new(),
            shapes: Vec::new(),
        };
        scene.clips = vec![Clip { name: "grows".into(), seconds: 3.0, motion: Some(motion.into()) }];
        let track =
            ObjectTrack { instances: vec![0], visible: vec![(0.0, true), (2.0, false)], ..ObjectTrack::default() };
        let animation = Animation { clip: Playback::Once, objects: vec![track], ..Animation::default() };
        let hidden = [0.5, 1.5, 2.5].map(|seconds| animation.scene_at(&scene, seconds).instances[0].hidden);
        assert_eq!(hidden, [true, false, true]);
    }

    #[test]
    fn an_instance_has_a_shape_from_each_step_until_the_next() {
        let mut scene = scene();
        let goes = KeyTrack::new(vec![0.0, 2.0], vec![[0.0; 3], [8.0, 0.0, 0.0]], KeyKind::Linear).unwrap();
        let rest = NodePose { translation: DVec3::ZERO, rotation: DQuat::IDENTITY, scale: DVec3::ONE };
        let (parent_from_outer, channels) = (DAffine3::IDENTITY, vec![Channel::Translation(goes)]);
        let at = |y: f64| DAffine3::from_translation(DVec3::Y * y);
        let shapes = vec![Shape { grid: 1, node_from_grid: at(3.0) }, Shape { grid: 0, node_from_grid: at(5.0) }];
        let steps = ShapeSteps { index: 0, node: 0, rate: 3.0, shapes, steps: vec![Some(0), Some(1), None, Some(0)] };
        let motion = NodeMotion {
            nodes: vec![MovingNode { parent: None, parent_from_outer, rest, channels }],
            world_from_file: DAffine3::IDENTITY,
            instances: vec![Attached { index: 0, node: 0, node_from_own: DAffine3::IDENTITY }],
            cameras: Vec::new(),
            shapes: vec![steps],
        };
        let first = motion.all_shapes().into_iter().map(|(index, grid, placed)| (index, grid, placed.translation));
        let third = 4.0f64 / 3.0;
        assert_eq!(first.collect::<Vec<_>>(), [(0, 1, Vec3::Y * 3.0), (0, 0, DVec3::new(third, 5.0, 0.0).as_vec3())]);
        scene.clips = vec![Clip { name: "bends".into(), seconds: 2.0, motion: Some(motion.into()) }];
        let shown = |clip: Playback, seconds: f64| {
            let instance = &Animation { clip, ..Animation::default() }.scene_at(&scene, seconds).instances[0];
            (!instance.hidden).then_some((instance.grid, instance.world_from_grid.translation))
        };
        let once = |seconds: f64| shown(Playback::Once, seconds);
        assert_eq!(once(0.25), Some((1, Vec3::new(1.0, 3.0, 0.0))), "it moves between steps");
        assert_eq!((once(0.5), once(0.75)), (Some((0, Vec3::new(2.0, 5.0, 0.0))), None));
        // A third of a second is a step, whatever the rounding.
        assert_eq!(once(1.0 / 3.0).map(|(grid, _)| grid), Some(0));
        assert_eq!((once(1.0), once(90.0)), (Some((1, Vec3::new(4.0, 3.0, 0.0))), Some((1, Vec3::new(8.0, 3.0, 0.0)))));
        assert_eq!(shown(Playback::Repeated, 2.5), once(0.5));
        assert_ne!(shown(Playback::Repeated, 2.5), once(2.5), "the comparison sees another time");
    }

    #[test]
    fn a_shape_that_is_seen_only_after_its_step_has_begun_is_one_of_all() {
        // It has a size from half a second on, and its only step begins at 0.
        let grows = KeyTrack::new(vec![0.0, 0.5], vec![[0.0; 3], [2.0; 3]], KeyKind::Step).unwrap();
        let rest = NodePose { translation: DVec3::X * 4.0, rotation: DQuat::IDENTITY, scale: DVec3::ONE };
        let (parent_from_outer, channels) = (DAffine3::IDENTITY, vec![Channel::Scale(grows)]);
        let shapes = vec![Shape { grid: 1, node_from_grid: DAffine3::from_translation(DVec3::Y) }];
        let motion = NodeMotion {
            nodes: vec![MovingNode { parent: None, parent_from_outer, rest, channels }],
            world_from_file: DAffine3::IDENTITY,
            instances: vec![Attached { index: 0, node: 0, node_from_own: DAffine3::IDENTITY }],
            cameras: Vec::new(),
            shapes: vec![ShapeSteps { index: 0, node: 0, rate: 1.0, shapes, steps: vec![Some(0)] }],
        };
        let mut now = scene();
        motion.apply(&scene(), &mut now, 0.25);
        assert!(now.instances[0].hidden);
        motion.apply(&scene(), &mut now, 0.75);
        assert_eq!((now.instances[0].hidden, now.instances[0].grid), (false, 1));
        let all = motion.all_shapes();
        assert_eq!(all, [(0, 1, Transform::from_translation(Vec3::new(4.0, 1.0, 0.0)))]);
        assert_ne!(now.instances[0].world_from_grid, all[0].2, "the place at rest is another one");
    }

    #[test]
    fn objects_show_the_grid_of_their_time() {
        let scene = scene();
        let track = ObjectTrack { instances: vec![0], grids: vec![(1.0, 1), (2.0, 0)], ..ObjectTrack::default() };
        let animation = Animation { objects: vec![track], ..Animation::default() };
        let grids = [0.5, 1.0, 1.9, 2.0].map(|seconds| animation.scene_at(&scene, seconds).instances[0].grid);
        assert_eq!(grids, [1, 1, 1, 0]);
    }
}
