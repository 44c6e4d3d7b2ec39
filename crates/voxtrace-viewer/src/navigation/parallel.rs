//! Motions of a camera with parallel rays, where things are larger for the height that the picture shows, and not for being near.

use super::fit::Bounds;
use super::pose::{FURTHEST, NEAREST, Pose};
use voxtrace::camera::Lens;
use voxtrace::glam::{DVec2, DVec3};

/// The height that the picture shows, where rays are parallel.
pub fn height(pose: &Pose) -> Option<f64> {
    match pose.lens {
        Lens::Orthographic { view_height } => Some(f64::from(view_height)),
        _ => None,
    }
}

fn with_height(pose: Pose, height: f64) -> Pose {
    Pose { lens: Lens::Orthographic { view_height: height.clamp(NEAREST, FURTHEST) as f32 }, ..pose }
}

/// The vector in the plane of the picture that leads from its middle to a place, which runs from -1 to 1, to the right and up.
fn in_plane(pose: &Pose, place: DVec2, height: f64, aspect: f64) -> DVec3 {
    let basis = pose.basis();
    (basis.x_axis * (place.x * aspect) + basis.y_axis * place.y) * (0.5 * height)
}

/// Moved sideways, so that `anchor`, or else what was at `from`, comes to lie at `to`.
pub fn panned(pose: Pose, height: f64, (from, to): (DVec2, DVec2), anchor: Option<DVec3>, aspect: f64) -> Pose {
    let place = |place| in_plane(&pose, place, height, aspect);
    let step = match anchor {
        Some(anchor) => (anchor - pose.eye).reject_from_normalized(pose.forward()) - place(to),
        None => place(from) - place(to),
    };
    Pose { eye: pose.eye + step, ..pose }
}

/// Shows `share` of the height, with what is at `place` staying there.
pub fn zoomed(pose: Pose, height: f64, share: f64, place: DVec2, aspect: f64) -> Pose {
    let zoomed = with_height(pose, height * share);
    let new = self::height(&zoomed).unwrap_or(height);
    Pose { eye: pose.eye + in_plane(&pose, place, height - new, aspect), ..zoomed }
}

/// With the height that shows the whole box, where the camera looks at its middle, with a border that is this share of the picture.
pub fn framed(pose: Pose, bounds: &Bounds, aspect: f64, margin: f64) -> Pose {
    let (middle, basis) = (bounds.middle(), pose.basis());
    let half = bounds.corners().map(|corner| {
        let offset = basis.transpose() * (corner - middle);
        (offset.x.abs() / aspect).max(offset.y.abs())
    });
    with_height(pose, 2.0 * half.fold(NEAREST, f64::max) / (1.0 - margin))
}
