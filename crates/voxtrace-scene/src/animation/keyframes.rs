//! Instances of files that bring keyframes along.

use crate::scene::{Instance, Scene};
use crate::transform::Transform;

/// Parts of a frame that are told apart: what rounding leaves of a whole number of frames is that number.
const STEPS: f64 = 1e6;

/// A number of steps, or of frames, without what rounding left.
pub(super) fn whole_steps(steps: f64) -> f64 {
    (steps * STEPS).round() / STEPS
}

/// The grid that an instance shows at a frame of its keyframes, counted from 0, and where it stands.
pub fn placed_at(instance: &Instance, frame: f64) -> (usize, Transform) {
    let keys = &instance.keyframes;
    let mut frame = whole_steps(frame);
    if let Some(cycle) = instance.repeats.clone().filter(|cycle| !cycle.is_empty()) {
        let (start, length) = (f64::from(cycle.start), f64::from(cycle.end - cycle.start));
        if frame >= start {
            frame = start + (frame - start) - ((frame - start) / length).floor() * length;
        }
    }
    let after = keys.partition_point(|key| f64::from(key.frame) <= frame);
    let Some(key) = keys.get(after.saturating_sub(1)) else { return (instance.grid, instance.world_from_grid) };
    let (from, to) = (key.world_from_grid.translation, key.end.translation);
    match keys.get(after).filter(|_| after > 0 && from != to) {
        Some(next) => {
            let share = (frame - f64::from(key.frame)) / f64::from(next.frame - key.frame);
            let translation = from.as_dvec3().lerp(to.as_dvec3(), share).as_vec3();
            (key.grid, Transform { translation, ..key.world_from_grid })
        }
        None => (key.grid, key.world_from_grid),
    }
}

/// Frames that the keyframes of a scene's instances last: up to the last key, or the end of what comes again; 0 without any.
pub fn keyframe_count(scene: &Scene) -> u32 {
    let lasts = |instance: &Instance| {
        let last = instance.keyframes.last().map_or(0, |key| key.frame.saturating_add(1));
        instance.repeats.as_ref().map_or(last, |cycle| last.max(cycle.end))
    };
    let moving = scene.instances.iter().filter(|instance| instance.keyframes.len() > 1);
    moving.map(lasts).max().unwrap_or(0)
}
