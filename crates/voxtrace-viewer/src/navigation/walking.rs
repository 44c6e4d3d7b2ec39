//! Walking: a body that stands on surfaces, falls, climbs steps, slides along walls and jumps, by a few rays a step. Lengths follow from the
//! height of its eye; z is up. It knows the scene by [`Ground`] alone.

use super::pose::Pose;
use voxtrace::glam::{DVec2, DVec3, Vec3};
use voxtrace::{PackedScene, Ray};

/// All lengths in heights of the eye: radius of the body, steps that it climbs, how high it jumps, what is free above the eye.
const RADIUS: f64 = 0.14;
const STEP: f64 = 0.35;
/// Where voxels are large, one of them is a step, unless it is this high: voxels, and heights of the eye.
const ONE_VOXEL: (f64, f64) = (1.05, 0.6);
const JUMP: f64 = 0.65;
const HEAD: f64 = 0.08;
/// Of a person of 1.7 m, in heights of the eye a second, squared.
const GRAVITY: f64 = 9.81 / 1.7;
/// Heights of the eye a second: a run, since scenes are large.
const SPEED: f64 = 2.2;
/// Seconds that the longest way to a clicked place takes.
const LONGEST_WAY: f64 = 4.0;
/// Longest step of time.
const TICK: f64 = 1.0 / 60.0;
/// How quickly the eye follows a step, one over seconds.
const EASE: f64 = 14.0;
/// Seconds without getting nearer after which a way is given up.
const PATIENCE: f64 = 0.4;
/// Heights of the eye that count as none.
const SMALL: f64 = 1e-3;

/// What a body meets.
pub trait Ground {
    /// How far it is along a unit vector to the first surface within `most`, and that surface's unit normal. 0 within something solid.
    fn cast(&self, origin: DVec3, direction: DVec3, most: f64) -> Option<(f64, DVec3)>;
}

impl Ground for PackedScene {
    fn cast(&self, origin: DVec3, direction: DVec3, most: f64) -> Option<(f64, DVec3)> {
        let ray = Ray { t_max: most as f32, ..Ray::new(origin.as_vec3(), direction.as_vec3()) };
        let hit = PackedScene::cast(self, &ray)?;
        let normal = match hit.cut().and_then(|index| self.cuts.planes().get(index)) {
            Some(plane) => plane.normal(),
            None => {
                let instance = self.instance(&hit);
                instance.world_from_grid.direction(hit.face().normal().as_vec3()).normalize_or(Vec3::Z)
            }
        };
        Some((f64::from(hit.t), normal.as_dvec3()))
    }
}

/// A body that walks.
#[derive(Clone, Debug, PartialEq)]
pub struct Walker {
    /// From the feet to the eye, voxels.
    pub eye_height: f64,
    /// Where it walks by itself, and the time since it came nearer to that.
    goal: Option<(DVec3, Goal)>,
    /// Upwards, voxels a second.
    rising: f64,
    is_on_ground: bool,
    /// How much the eye is behind the feet after a step, upwards.
    lag: f64,
}

/// How a way goes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Goal {
    speed: f64,
    nearest: f64,
    waited: f64,
}

/// What is wanted of a body.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wish {
    /// To the right and forward, at most of length 1.
    pub direction: DVec2,
    /// Factor on the speed.
    pub speed: f64,
    /// Whether it is to jump.
    pub jumps: bool,
}

impl Default for Walker {
    fn default() -> Self {
        Self { eye_height: 10.0, goal: None, rising: 0.0, is_on_ground: false, lag: 0.0 }
    }
}

impl Walker {
    /// Walks to below or above a point; the way is straight, along walls.
    pub fn walk_to(&mut self, goal: DVec3, from: DVec3) {
        let distance = (goal - from).truncate().length();
        let speed = (SPEED * self.eye_height).max(distance / LONGEST_WAY);
        self.goal = Some((goal, Goal { speed, nearest: f64::INFINITY, waited: 0.0 }));
    }

    /// Stops a way.
    pub fn stop(&mut self) {
        self.goal = None;
    }

    /// The highest step that it climbs.
    fn step(&self) -> f64 {
        let (voxel, most) = ONE_VOXEL;
        (STEP * self.eye_height).max(voxel.min(most * self.eye_height))
    }

    /// Where it walks to by itself.
    pub fn goal(&self) -> Option<DVec3> {
        self.goal.map(|(goal, _)| goal)
    }

    /// Whether it stands.
    pub fn is_on_ground(&self) -> bool {
        self.is_on_ground
    }

    /// Puts the eye where somebody stands who is dropped at a place: `None` where nothing is below.
    pub fn dropped(&mut self, eye: DVec3, ground: &dyn Ground) -> Option<DVec3> {
        let (below, _) = ground.cast(eye, DVec3::NEG_Z, f64::INFINITY)?;
        *self = Self { eye_height: self.eye_height, ..Self::default() };
        // Somebody within a floor comes out above it.
        Some(eye - DVec3::Z * (below - self.eye_height).max(0.0))
    }

    /// The pose after some time.
    pub fn moved(&mut self, pose: Pose, wish: Wish, seconds: f64, ground: &dyn Ground) -> Pose {
        if wish.direction != DVec2::ZERO {
            self.goal = None;
        }
        let ticks = (seconds / TICK).ceil().max(1.0);
        let mut feet = pose.eye - DVec3::Z * (self.eye_height - self.lag);
        for _ in 0..ticks as usize {
            feet = self.tick(feet, &pose, wish, seconds / ticks, ground);
        }
        let eye = feet + DVec3::Z * (self.eye_height - self.lag);
        // What rounding moves is no movement: the picture would begin anew.
        let has_moved = eye.distance(pose.eye) > SMALL * 0.01 * self.eye_height;
        if has_moved { Pose { eye, ..pose } } else { pose }
    }

    fn tick(&mut self, feet: DVec3, pose: &Pose, wish: Wish, seconds: f64, ground: &dyn Ground) -> DVec3 {
        let height = self.eye_height;
        let right = pose.heading.cross(DVec3::Z);
        let walk = (right * wish.direction.x + pose.heading * wish.direction.y) * (SPEED * height * wish.speed);
        let mut step = walk.with_z(0.0) * seconds;
        if let Some((goal, way)) = self.goal.as_mut() {
            let rest = (*goal - feet).with_z(0.0);
            way.waited = if rest.length() < way.nearest - SMALL * height { 0.0 } else { way.waited + seconds };
            way.nearest = way.nearest.min(rest.length());
            step = rest.clamp_length_max(way.speed * seconds);
            if rest.length() <= RADIUS * height || way.waited > PATIENCE {
                self.goal = None;
                step = DVec3::ZERO;
            }
        }
        let mut feet = feet;
        if ground.cast(feet + DVec3::Z * (0.5 * height), DVec3::Z, SMALL * height).is_some() {
            // Within something: out of it upwards, and wherever one wants.
            (self.rising, self.is_on_ground) = (0.0, false);
            return feet + step + DVec3::Z * (2.0 * height * seconds);
        }
        if step != DVec3::ZERO {
            feet = self.slid(feet, step, ground);
        }
        self.risen(feet, wish.jumps, seconds, ground)
    }

    /// After a level step, along walls, and never to where there is nothing below.
    fn slid(&self, feet: DVec3, step: DVec3, ground: &dyn Ground) -> DVec3 {
        let (mut now, mut step) = (feet, step);
        for _ in 0..3 {
            let Some(direction) = step.try_normalize() else { break };
            let (free, wall) = self.free(now, direction, step.length(), ground);
            now += direction * free;
            let rest = step - direction * free;
            let Some(normal) = wall.and_then(|wall| wall.with_z(0.0).try_normalize()) else { break };
            step = rest - normal * rest.dot(normal).min(0.0);
        }
        let has_ground = |at: DVec3| ground.cast(at + DVec3::Z * self.step(), DVec3::NEG_Z, f64::INFINITY).is_some();
        let ways = [now, DVec3::new(now.x, feet.y, feet.z), DVec3::new(feet.x, now.y, feet.z)];
        // Somebody who has nothing below already may go wherever he wants.
        if !has_ground(feet) { now } else { ways.into_iter().find(|way| has_ground(*way)).unwrap_or(feet) }
    }

    /// How far the body gets in a level direction, and the normal of what it meets there.
    fn free(&self, feet: DVec3, direction: DVec3, most: f64, ground: &dyn Ground) -> (f64, Option<DVec3>) {
        let (height, radius) = (self.eye_height, RADIUS * self.eye_height);
        let side = direction.cross(DVec3::Z) * radius;
        let mut free = (most, None);
        for up in [self.step() / height * 1.02, 0.7, 1.0] {
            for across in [0.0, 0.9, -0.9] {
                let origin = feet + DVec3::Z * (up * height) + side * across;
                if let Some((t, normal)) = ground.cast(origin, direction, most + radius) {
                    let until = (t - radius).max(0.0);
                    // A shoulder that grazes a wall which runs along does not stop anybody.
                    if until < free.0 && (across == 0.0 || normal.dot(direction) < -0.05) {
                        free = (until, Some(normal));
                    }
                }
            }
        }
        free
    }

    /// After falling, climbing, standing or jumping.
    fn risen(&mut self, mut feet: DVec3, jumps: bool, seconds: f64, ground: &dyn Ground) -> DVec3 {
        let height = self.eye_height;
        let knee = DVec3::Z * self.step();
        let below = [DVec2::ZERO, DVec2::X, DVec2::NEG_X, DVec2::Y, DVec2::NEG_Y].into_iter().filter_map(|side| {
            let origin = feet + knee + (side * (0.8 * RADIUS * height)).extend(0.0);
            let (t, _) = ground.cast(origin, DVec3::NEG_Z, f64::INFINITY)?;
            // A wall beside the body is no ground.
            (t > 0.0 || side == DVec2::ZERO).then_some(origin.z - t)
        });
        let floor = below.reduce(f64::max);
        self.lag *= (-EASE * seconds).exp();
        if self.lag.abs() < SMALL * height {
            self.lag = 0.0;
        }
        let before = feet.z;
        let Some(floor) = floor else {
            // Nothing below: on the air, as nobody wants to fall for ever.
            (self.rising, self.is_on_ground) = (0.0, true);
            return feet;
        };
        let reaches = if self.is_on_ground { self.step() } else { SMALL * height };
        if self.rising <= 0.0 && feet.z - floor <= reaches {
            feet.z = floor;
            self.lag += feet.z - before;
            (self.rising, self.is_on_ground) = (0.0, true);
            if jumps {
                self.rising = (2.0 * GRAVITY * JUMP).sqrt() * height;
                self.is_on_ground = false;
            }
            return feet;
        }
        self.is_on_ground = false;
        let fall = self.rising * seconds - 0.5 * GRAVITY * height * seconds * seconds;
        self.rising -= GRAVITY * height * seconds;
        let eye = feet + DVec3::Z * height;
        if fall > 0.0 && ground.cast(eye, DVec3::Z, fall + HEAD * height).is_some() {
            self.rising = 0.0;
            return feet;
        }
        feet.z = (feet.z + fall).max(floor);
        if feet.z == floor {
            (self.rising, self.is_on_ground) = (0.0, true);
        }
        feet
    }
}
