//! Coordinates from f64 to f32 without losing small things far from the origin: the first point of a file that is far out
//! becomes the offset of all.

use glam::{DVec3, Vec3};

/// From this distance on (1/2048 is then the spacing of f32), coordinates are kept relative to the first point.
const FAR: f64 = 4096.0;

/// The offset of a file's points, decided by the first one.
#[derive(Default)]
pub(crate) struct LocalOrigin {
    offset: Option<DVec3>,
}

impl LocalOrigin {
    /// An offset that others have decided; `None` where they have not.
    #[cfg(feature = "points")]
    pub fn at(offset: Option<DVec3>) -> Self {
        Self { offset }
    }

    /// The offset, if a point has decided.
    #[cfg(feature = "points")]
    pub fn decided(&self) -> Option<DVec3> {
        self.offset
    }

    /// A point relative to the offset, infinite or NaN where it does not fit into f32. One that is nowhere decides nothing.
    pub fn localized(&mut self, point: DVec3) -> Vec3 {
        if !point.is_finite() {
            return Vec3::NAN;
        }
        let is_far = point.abs().max_element() >= FAR;
        let offset = *self.offset.get_or_insert_with(|| if is_far { point.round() } else { DVec3::ZERO });
        (point - offset).as_vec3()
    }

    /// Whether a point has decided.
    pub fn is_set(&self) -> bool {
        self.offset.is_some()
    }

    /// What was taken off placed points, finite or not.
    pub fn raw_offset(&self) -> DVec3 {
        self.offset.unwrap_or(DVec3::ZERO)
    }

    /// What to add to placed points.
    pub fn offset(&self) -> DVec3 {
        self.offset.filter(|offset| offset.is_finite()).unwrap_or(DVec3::ZERO)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_far_from_the_origin_keep_their_millimetres() {
        let mut local_origin = LocalOrigin::default();
        let points = [DVec3::new(691_000.125, 5_335_000.5, 512.25), DVec3::new(691_000.126, 5_335_000.5, 512.25)];
        let [a, b] = points.map(|point| local_origin.localized(point));
        assert!(((b.x - a.x) - 0.001).abs() < 1e-6);
        assert_eq!((a.as_dvec3() + local_origin.offset()).y, 5_335_000.5);
    }

    #[test]
    fn a_point_that_is_nowhere_does_not_decide_for_the_others() {
        for nowhere in [DVec3::NAN, DVec3::new(f64::NAN, 5e6, 5e6), DVec3::splat(f64::INFINITY)] {
            let mut local_origin = LocalOrigin::default();
            assert!(!local_origin.localized(nowhere).is_finite() && !local_origin.is_set());
            let point = local_origin.localized(DVec3::new(691_000.125, 5_335_000.5, 512.25));
            assert_eq!((point, local_origin.offset().x), (Vec3::new(0.125, -0.5, 0.25), 691_000.0));
            assert!(!local_origin.localized(nowhere).is_finite());
        }
    }

    #[test]
    fn points_near_the_origin_stay_as_they_are() {
        let mut local_origin = LocalOrigin::default();
        assert_eq!(local_origin.localized(DVec3::new(0.1, 100.0, -3.0)), Vec3::new(0.1, 100.0, -3.0));
        assert_eq!(local_origin.localized(DVec3::splat(1e6)), Vec3::splat(1e6));
        assert_eq!(local_origin.offset(), DVec3::ZERO);
    }
}
