//! What moves the camera at once, and how. Places in the picture are those of [`Camera`]'s rays: from the upper left corner, x to the
//! right and y down, in the unit of [`super::Navigator::set_viewport`].

use super::fit::{Bounds, framed};
use super::parallel;
use super::pose::{FURTHEST, NEAREST, Pose};
use std::f64::consts::PI;
use voxtrace::Camera;
use voxtrace::camera::Lens;
use voxtrace::glam::{DVec2, DVec3, Vec2, Vec3};

/// How much nearer one step of [`Motion::Zoom`] brings what is under the cursor.
pub const ZOOM_STEP: f32 = 1.15;
/// Most steps of one event.
const MOST_STEPS: f64 = 20.0;
/// Heights of the picture that a drag over the whole height turns the view by: quicker than the picture, so that the mouse is not lifted often.
const LOOK: f64 = 2.0;
/// Angle that a drag over the whole height carries the camera around, radians.
const ORBIT: f64 = PI;
/// Fields of view that can be chosen, degrees.
pub const FIELDS_OF_VIEW: std::ops::RangeInclusive<f32> = 1.0..=170.0;
/// Least distance that zooming keeps from what is under the cursor, voxels.
const LEAST_GAP: f64 = 0.05;
/// Least distance of zooming into the void, as a share of the scene's diagonal: there one moves on and on.
const VOID: f64 = 0.02;

/// A view along an axis of the world, z up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AxisView {
    /// From the front, along +y.
    Front,
    /// From behind, along -y.
    Back,
    /// From the right, along -x.
    Right,
    /// From the left, along +x.
    Left,
    /// From above, along -z; +y is upwards in the picture.
    Top,
    /// From below, along +z; -y is upwards in the picture.
    Bottom,
}

/// A change of the camera. Lengths are voxels; what is not finite changes nothing.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// Turns the view by a drag over the picture: rightwards to the right, upwards up.
    Look(Vec2),
    /// Carries the camera around a point, which keeps its place in the picture.
    Orbit {
        /// The drag.
        delta: Vec2,
        /// The point, usually that under the cursor when the drag began; without one, the target.
        pivot: Option<Vec3>,
    },
    /// Moves the camera sideways, so that what was under the cursor stays there.
    Pan {
        /// Where the cursor was.
        from: Vec2,
        /// Where it is.
        to: Vec2,
        /// What was under it when the drag began, if something was; the same through the drag. It comes to lie at `to`.
        anchor: Option<Vec3>,
    },
    /// Towards the point under the cursor, or away from it where `steps` is negative, by [`ZOOM_STEP`] a step, and never through it.
    Zoom {
        /// Where the cursor is.
        cursor: Vec2,
        /// How far what is under it is from the eye, if something is.
        distance: Option<f32>,
        /// How many steps; the wheel's notches.
        steps: f32,
    },
    /// Shows the whole scene from the present direction.
    FrameAll,
    /// Shows a whole box from the present direction.
    Frame {
        /// Its least corner.
        min: Vec3,
        /// Its greatest corner.
        max: Vec3,
    },
    /// Shows the whole scene along an axis, z up.
    View(AxisView),
    /// Takes z for up.
    Level,
    /// Sets the vertical field of view, degrees, within [`FIELDS_OF_VIEW`].
    FieldOfView(f32),
    /// Looks through another lens. One that is not set right changes nothing.
    Lens(Lens),
    /// Takes another camera as it is. One that cannot send rays changes nothing.
    GoTo(Camera),
    /// Changes the speed of flight, not the camera: steps of the wheel.
    Speed(f32),
}

/// What motions need to know beside the pose.
#[derive(Clone, Copy, Debug)]
pub struct Surroundings {
    pub bounds: Bounds,
    /// Size of the picture.
    pub width: f64,
    pub height: f64,
    /// Whether looking up and down is exchanged.
    pub is_inverted: bool,
}

impl Surroundings {
    pub fn aspect(&self) -> f64 {
        self.width / self.height
    }

    /// A place in the picture from -1 to 1, to the right and up. What is not finite is the middle.
    pub fn place(&self, cursor: Vec2) -> DVec2 {
        let place = cursor.as_dvec2() / DVec2::new(self.width, self.height) * 2.0 - 1.0;
        let place = if place.is_finite() { place } else { DVec2::ZERO };
        DVec2::new(place.x, -place.y).clamp(DVec2::splat(-100.0), DVec2::splat(100.0))
    }

    /// The eye, not lost in the void: at most a hundred diagonals from the scene, or as far as it was.
    pub fn reached(&self, eye: DVec3, before: DVec3) -> DVec3 {
        let middle = self.bounds.middle();
        let most = (self.bounds.diagonal() * 100.0).clamp(1e4, FURTHEST).max(before.distance(middle));
        match eye.distance(middle) {
            distance if distance <= most => eye,
            distance if distance.is_finite() => middle + (eye - middle) * (most / distance),
            _ => before,
        }
    }

    /// The pose after a motion; those that are none of the pose leave it.
    pub fn moved(&self, pose: Pose, motion: &Motion) -> Pose {
        let moved = match motion {
            Motion::Look(delta) => {
                let angle = drag(*delta) / self.height * f64::from(pose.fov_y).to_radians() * LOOK;
                pose.turned(angle.x, if self.is_inverted { angle.y } else { -angle.y })
            }
            Motion::Orbit { delta, pivot } => {
                let angle = drag(*delta) / self.height * ORBIT;
                pose.around(point(*pivot).unwrap_or(pose.target()), angle.x, -angle.y)
            }
            Motion::Pan { from, to, anchor } => self.panned(pose, *from, *to, point(*anchor)),
            Motion::Zoom { cursor, distance, steps } => self.zoomed(pose, *cursor, *distance, *steps),
            Motion::FrameAll => framed(pose, &self.bounds, self.aspect()),
            Motion::Frame { min, max } => match Bounds::new(min.as_dvec3(), max.as_dvec3()) {
                Some(bounds) => framed(pose, &bounds, self.aspect()),
                None => pose,
            },
            Motion::View(view) => framed(along(pose, *view), &self.bounds, self.aspect()),
            Motion::Level => pose.levelled(),
            Motion::FieldOfView(degrees) if degrees.is_finite() => {
                Pose { fov_y: degrees.clamp(*FIELDS_OF_VIEW.start(), *FIELDS_OF_VIEW.end()), ..pose }
            }
            Motion::Lens(lens) if lens.check().is_ok() => Pose { lens: *lens, ..pose },
            Motion::Lens(_) | Motion::FieldOfView(_) | Motion::GoTo(_) | Motion::Speed(_) => pose,
        };
        Pose { eye: self.reached(moved.eye, pose.eye), ..moved }
    }

    fn panned(&self, pose: Pose, from: Vec2, to: Vec2, anchor: Option<DVec3>) -> Pose {
        if let Some(height) = parallel::height(&pose) {
            let places = (self.place(from), self.place(to));
            return parallel::panned(pose, height, places, anchor, self.aspect());
        }
        if matches!(pose.lens, Lens::Panorama { .. } | Lens::Fisheye { .. }) {
            return self.panned_around(pose, from, to, anchor);
        }
        let through = |cursor| pose.through(self.place(cursor), self.aspect());
        // What lies behind the eye is under no cursor.
        let depth = anchor.map(|anchor| (anchor - pose.eye).dot(pose.forward())).filter(|depth| *depth > NEAREST);
        let eye = match anchor.zip(depth) {
            Some((anchor, depth)) => anchor - through(to) * depth,
            None => pose.eye + (through(from) - through(to)) * self.depth_of_void(pose),
        };
        Pose { eye, ..pose }
    }

    /// As [`Self::panned`], in pictures that show what lies beside the camera, too, where no depth along the view says how far to go: what is held
    /// keeps its distance.
    fn panned_around(&self, pose: Pose, from: Vec2, to: Vec2, anchor: Option<DVec3>) -> Pose {
        let direction = |cursor| self.towards(pose, cursor).normalize();
        let held = anchor.map(|anchor| (anchor, anchor.distance(pose.eye))).filter(|(_, far)| *far > NEAREST);
        let eye = match held {
            Some((anchor, far)) => anchor - direction(to) * far,
            None => pose.eye + (direction(from) - direction(to)) * self.depth_of_void(pose),
        };
        Pose { eye, ..pose }
    }

    fn zoomed(&self, pose: Pose, cursor: Vec2, distance: Option<f32>, steps: f32) -> Pose {
        let through = self.towards(pose, cursor);
        let share = f64::from(ZOOM_STEP).powf(-clean_steps(steps));
        if share == 1.0 {
            return pose;
        }
        if let Some(height) = parallel::height(&pose) {
            return parallel::zoomed(pose, height, share, self.place(cursor), self.aspect());
        }
        match distance.map(f64::from).filter(|distance| *distance > 0.0 && *distance <= FURTHEST) {
            Some(distance) => {
                // Single precision must not lose the gap.
                let gap = LEAST_GAP.max(pose.eye.abs().max_element() * 2f64.powi(-20)).min(distance);
                let remaining = (distance * share).max(gap);
                let direction = through.normalize();
                // What a panorama shows behind the camera is no target.
                let depth = remaining * through.normalize().dot(pose.forward()).max(0.0);
                Pose {
                    eye: pose.eye + direction * (distance - remaining),
                    distance: depth.clamp(NEAREST, FURTHEST),
                    ..pose
                }
            }
            None => {
                let depth = self.depth_of_void(pose);
                let eye = pose.eye + through.normalize() * (depth * (1.0 - share));
                let before = Pose { distance: depth * share, ..pose };
                Pose { eye, distance: self.depth_of_void(before), ..pose }
            }
        }
    }

    /// A vector towards what the picture shows at a place.
    fn towards(&self, pose: Pose, cursor: Vec2) -> DVec3 {
        match pose.lens {
            Lens::Panorama { .. } | Lens::Fisheye { .. } if cursor.is_finite() => {
                let frame = pose.camera("").frame(self.width as u32, self.height as u32);
                frame.central_ray(cursor).direction.as_dvec3()
            }
            _ => pose.through(self.place(cursor), self.aspect()),
        }
    }

    /// How far away what is under no voxel is taken to be: as far as the target, but not so near that nothing moves any more.
    fn depth_of_void(&self, pose: Pose) -> f64 {
        pose.distance.max(self.bounds.diagonal() * VOID).min(FURTHEST)
    }
}

/// Steps of one event, a finite number.
pub fn clean_steps(steps: f32) -> f64 {
    if steps.is_nan() { 0.0 } else { f64::from(steps).clamp(-MOST_STEPS, MOST_STEPS) }
}

/// The steps of [`Motion::Zoom`] that a pinch makes: by its change of scale, more than 1 where fingers part.
pub fn steps_of_pinch(scale: f32) -> f32 {
    let steps = scale.ln() / ZOOM_STEP.ln();
    if steps.is_finite() { steps } else { 0.0 }
}

/// A drag, finite, and no longer than any screen.
fn drag(delta: Vec2) -> DVec2 {
    if delta.is_finite() { delta.as_dvec2().clamp(DVec2::splat(-1e5), DVec2::splat(1e5)) } else { DVec2::ZERO }
}

fn point(point: Option<Vec3>) -> Option<DVec3> {
    point.filter(|point| point.is_finite()).map(Vec3::as_dvec3)
}

fn along(pose: Pose, view: AxisView) -> Pose {
    let (heading, pitch) = match view {
        AxisView::Front => (DVec3::Y, 0.0),
        AxisView::Back => (DVec3::NEG_Y, 0.0),
        AxisView::Right => (DVec3::NEG_X, 0.0),
        AxisView::Left => (DVec3::X, 0.0),
        AxisView::Top => (DVec3::Y, -PI / 2.0),
        AxisView::Bottom => (DVec3::Y, PI / 2.0),
    };
    Pose { horizon: DVec3::Z, up: Vec3::Z, heading, pitch, ..pose }
}
