//! Handles of a path: the inner control points of cubic Bézier curves between cameras, relative to where the cameras stand.

use glam::{DVec3, Vec3};

/// Cosine of the angle, a degree, by which the handles of a camera may differ from one straight line.
const STRAIGHT: f64 = 0.9998;

/// The handles of a camera of a [`super::Flight`]. Without any its curve is that of Catmull and Rom there; with one the other is its mirror image.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Handles {
    /// On the curve that arrives: from the camera to the control point before it.
    pub arriving: Option<Vec3>,
    /// On the curve that leaves: from the camera to the control point after it.
    pub leaving: Option<Vec3>,
    /// Whether the path may have a corner there.
    pub is_corner: bool,
}

impl Handles {
    /// Whether the path goes on smoothly there.
    ///
    /// # Errors
    /// Says what is wrong: a handle that is not finite or has no length, or two that are not on one line.
    pub fn check(&self) -> Result<(), &'static str> {
        let both = [self.arriving, self.leaving].map(|handle| handle.map(|handle| handle.as_dvec3()));
        if both.iter().flatten().any(|handle| !handle.is_finite()) {
            return Err("a handle is not finite");
        }
        if self.is_corner {
            return Ok(());
        }
        if both.iter().flatten().any(|handle| *handle == DVec3::ZERO) {
            return Err("a handle has no length, so that the path may have a corner there: `corner = true` allows it");
        }
        match both {
            [Some(arriving), Some(leaving)] if arriving.normalize().dot(leaving.normalize()) > -STRAIGHT => {
                Err("both handles are not on one line, so that the path has a corner there: `corner = true` allows it")
            }
            _ => Ok(()),
        }
    }

    /// The change of place with the knots' unit where the curve arrives and where it leaves, as far as the handles say it; `before` and `after`
    /// are the legs in those units, 0 where there is none. A missing handle is the mirror image, longer or shorter as its leg is.
    pub(super) fn tangents(&self, before: f64, after: f64) -> [Option<DVec3>; 2] {
        let own =
            |handle: Option<Vec3>, leg: f64| handle.filter(|_| leg > 0.0).map(|handle| handle.as_dvec3() * (3.0 / leg));
        let (arriving, leaving) = (own(self.arriving, before).map(|tangent| -tangent), own(self.leaving, after));
        if self.is_corner {
            return [arriving, leaving];
        }
        [arriving.or(leaving), leaving.or(arriving)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn handles_that_make_a_corner_are_told_unless_one_is_wanted() {
        let handles = |arriving: Vec3, leaving: Vec3, is_corner| Handles {
            arriving: Some(arriving),
            leaving: Some(leaving),
            is_corner,
        };
        assert!(handles(Vec3::NEG_X, Vec3::X * 3.0, false).check().is_ok(), "lengths may differ");
        let bent = Vec3::new(1.0, 0.03, 0.0);
        assert!(handles(Vec3::NEG_X, bent, false).check().is_err() && handles(Vec3::NEG_X, bent, true).check().is_ok());
        assert!(
            handles(Vec3::X, Vec3::X, false).check().is_err() && handles(Vec3::ZERO, Vec3::X, false).check().is_err()
        );
        assert!(handles(Vec3::NAN, Vec3::X, true).check().is_err() && Handles::default().check().is_ok());
    }

    #[test]
    fn a_missing_handle_is_the_mirror_image_of_the_other() {
        let leaving = Handles { leaving: Some(Vec3::new(2.0, 0.0, 1.0)), ..Handles::default() };
        assert_eq!(leaving.tangents(1.0, 2.0), [Some(DVec3::new(3.0, 0.0, 1.5)); 2]);
        let corner = Handles { is_corner: true, ..leaving };
        assert_eq!(corner.tangents(1.0, 2.0), [None, Some(DVec3::new(3.0, 0.0, 1.5))]);
        assert_eq!(Handles::default().tangents(1.0, 1.0), [None, None]);
    }
}
