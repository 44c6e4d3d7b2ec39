//! How objects move in the world.

use super::curve::{Curve, Ease, Interpolation};
use super::path::SmoothPath;
use super::turn::{rotation, slerp};
use crate::transform::Transform;
use glam::{DMat3, DQuat, DVec3};

/// A motion: for each time a rotation, a uniform scale and a translation of the world.
#[derive(Clone, Debug)]
pub enum Motion {
    /// Turning about an axis.
    Spin {
        /// A point on the axis, world space.
        pivot: DVec3,
        /// Its direction.
        axis: DVec3,
        /// Turns a second, counter-clockwise seen from the positive end of the axis.
        turns_per_second: f64,
    },
    /// Going along a path.
    Path {
        /// The point of the object that goes along it, world space.
        pivot: DVec3,
        /// The path of that point.
        path: SmoothPath,
        /// When it sets out, seconds.
        start: f64,
        /// How long it takes, > 0.
        seconds: f64,
        /// How it speeds up and slows down.
        ease: Ease,
        /// Whether it sets out again and again.
        repeats: bool,
        /// The side of the object that leads, horizontal: it is turned about the vertical into the direction of the path. `None`: it keeps its direction.
        front: Option<DVec3>,
    },
    /// Poses at times.
    Keys {
        /// The point about which it turns and grows, world space.
        pivot: DVec3,
        /// Offset and scale.
        curve: Curve<4>,
        /// When which rotation is reached.
        turns: Vec<(f64, DQuat)>,
        /// How it goes from one to the next.
        interpolation: Interpolation,
    },
}

/// A pose at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseKey {
    /// Seconds.
    pub time: f64,
    /// Translation, world units.
    pub offset: DVec3,
    /// Rotation about the pivot.
    pub turn: DQuat,
    /// Uniform scale about the pivot, > 0.
    pub scale: f64,
}

impl Motion {
    /// A motion through poses.
    ///
    /// # Panics
    /// Without keys, or where their times do not rise.
    pub fn keys(pivot: DVec3, keys: Vec<PoseKey>, interpolation: Interpolation) -> Self {
        let numbers = |key: &PoseKey| (key.time, [key.offset.x, key.offset.y, key.offset.z, key.scale]);
        let turns = keys.iter().map(|key| (key.time, key.turn)).collect();
        Self::Keys { pivot, curve: Curve::new(keys.iter().map(numbers).collect(), interpolation), turns, interpolation }
    }

    /// The motion at a time, as a map of the world.
    pub fn at(&self, time: f64) -> Transform {
        match self {
            Self::Spin { pivot, axis, turns_per_second } => {
                about(*pivot, *pivot, DMat3::from_quat(rotation(*axis, turns_per_second * time)))
            }
            Self::Path { pivot, path, start, seconds, ease, repeats, front } => {
                let gone = (time - start) / seconds;
                let share = if *repeats && gone > 0.0 { gone - gone.floor() } else { gone };
                let (place, ahead) = path.at(ease.at(share));
                let turned = front.and_then(|front| heading(front, ahead)).unwrap_or(DMat3::IDENTITY);
                about(*pivot, place, turned)
            }
            Self::Keys { pivot, curve, turns, interpolation } => {
                let [x, y, z, scale] = curve.at(time);
                let turn = DMat3::from_quat(turn_at(turns, time, *interpolation));
                about(*pivot, *pivot + DVec3::new(x, y, z), turn * scale.max(1e-6))
            }
        }
    }

    /// When it comes to an end, seconds; `None` where it goes on for ever.
    pub fn end(&self) -> Option<f64> {
        match self {
            Self::Spin { .. } => None,
            Self::Path { repeats: true, .. } => None,
            Self::Path { start, seconds, .. } => Some(start + seconds),
            Self::Keys { curve, .. } => Some(curve.end()),
        }
    }
}

/// The map that takes the pivot to a place, and what is around it along.
fn about(pivot: DVec3, place: DVec3, linear: DMat3) -> Transform {
    Transform { linear: linear.as_mat3(), translation: (place - linear * pivot).as_vec3() }
}

/// The rotation about the vertical from one direction into another; `None` where one of them is vertical.
fn heading(from: DVec3, to: DVec3) -> Option<DMat3> {
    let (from, to) = (from.with_z(0.0).try_normalize()?, to.with_z(0.0).try_normalize()?);
    let (cos, sin) = (from.dot(to), from.cross(to).z);
    Some(DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z))
}

fn turn_at(turns: &[(f64, DQuat)], time: f64, interpolation: Interpolation) -> DQuat {
    let key = turns.partition_point(|&(key, _)| key <= time).saturating_sub(1);
    let (start, from) = turns[key];
    let goes_on = time > start && interpolation != Interpolation::Step;
    match turns.get(key + 1).filter(|_| goes_on) {
        Some(&(end, to)) => slerp(from, to, (time - start) / (end - start)),
        None => from,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn an_object_on_a_path_goes_ahead_with_its_front_and_sets_out_again() {
        let path = SmoothPath::through(&[DVec3::new(10.0, 0.0, 0.0), DVec3::new(10.0, 20.0, 0.0)], false).unwrap();
        let motion = |repeats| Motion::Path {
            pivot: DVec3::new(1.0, 1.0, 0.0),
            path: path.clone(),
            start: 1.0,
            seconds: 2.0,
            ease: Ease::None,
            repeats,
            front: Some(DVec3::X),
        };
        let at = |time: f64| motion(false).at(time);
        assert!(at(0.0).point(Vec3::new(1.0, 1.0, 0.0)).abs_diff_eq(Vec3::new(10.0, 0.0, 0.0), 1e-5));
        assert!(at(2.0).point(Vec3::new(1.0, 1.0, 0.0)).abs_diff_eq(Vec3::new(10.0, 10.0, 0.0), 1e-4));
        // What was in front along x is in front along y.
        assert!(at(2.0).direction(Vec3::X).abs_diff_eq(Vec3::Y, 1e-6) && at(2.0).is_similarity());
        assert_eq!((at(3.0), motion(true).at(4.0)), (at(99.0), at(2.0)));
        assert_ne!(motion(true).at(99.5), at(99.5), "the comparison sees what repeats");
    }

    #[test]
    fn keys_turn_and_grow_about_their_pivot() {
        let key =
            |time, turns: f64, scale| PoseKey { time, offset: DVec3::ZERO, turn: rotation(DVec3::Z, turns), scale };
        let pivot = DVec3::new(4.0, 4.0, 0.0);
        let motion = Motion::keys(pivot, vec![key(0.0, 0.0, 1.0), key(1.0, 0.5, 3.0)], Interpolation::Linear);
        let half = motion.at(0.5);
        assert!(half.point(pivot.as_vec3()).abs_diff_eq(pivot.as_vec3(), 1e-5) && (half.scale() - 2.0).abs() < 1e-6);
        assert!(half.direction(Vec3::X).abs_diff_eq(Vec3::Y * 2.0, 1e-5), "{}", half.direction(Vec3::X));
        let stepped = Motion::keys(pivot, vec![key(0.0, 0.0, 1.0), key(1.0, 0.5, 3.0)], Interpolation::Step);
        assert_eq!(stepped.at(0.99), stepped.at(0.0));
        assert_eq!((motion.end(), stepped.at(1.0)), (Some(1.0), motion.at(1.0)));
    }
}
