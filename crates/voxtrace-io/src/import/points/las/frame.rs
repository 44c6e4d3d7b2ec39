//! What the reference system of a LAS file means for its points. Lengths stay as they are, and only heights in another unit are
//! changed to it. Degrees become metres around the middle of the file, or of all that are one cloud.

use crate::import::reader::map_units::{Horizontal, MapUnits};
use glam::{DAffine3, DVec3};
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::points::PointCloud;

/// How points of files are measured: from another origin, then in other steps than the files do.
pub(super) struct Joint {
    pub origin: DVec3,
    pub scale: DVec3,
    /// The cloud without its points.
    pub frame: PointCloud,
}

/// Says what points are measured in, of which headers say the box around all. `asked` is the unit that a person says they have, in
/// place of what the files say.
pub(super) fn settle(bounds: Option<(DVec3, DVec3)>, crs: String, units: MapUnits, asked: Option<LengthUnit>) -> Joint {
    let frame = PointCloud { crs, ..PointCloud::default() };
    let mut joint = Joint { origin: DVec3::ZERO, scale: DVec3::ONE, frame };
    if asked.is_some() {
        return joint;
    }
    let frame = &mut joint.frame;
    match units.horizontal {
        Horizontal::Length(plane) => {
            frame.unit = plane;
            let heights = units.vertical.metres().zip(plane.metres()).map_or(1.0, |(height, plane)| height / plane);
            // Where both are feet, by either definition, they are one thing for a scene of any height.
            if (heights - 1.0).abs() > 1e-4 {
                joint.scale = DVec3::new(1.0, 1.0, heights);
                frame.crs_from_cloud = DAffine3::from_scale(DVec3::new(1.0, 1.0, heights.recip()));
                let [from, to] = [units.vertical, plane].map(LengthUnit::suffix);
                frame.notes.push(format!("heights in{from} are changed to{to}, the unit of the map"));
            }
        }
        Horizontal::Angle(degrees) => match bounds.and_then(|bounds| middle_of(bounds, degrees)) {
            Some(middle) => {
                let [east, north] = metres_of_degree(middle.y * degrees);
                let scale = DVec3::new(east * degrees, north * degrees, units.vertical.metres().unwrap_or(1.0));
                (joint.origin, joint.scale) = (middle, scale);
                frame.unit = LengthUnit::METRE;
                frame.crs_from_cloud = DAffine3::from_translation(middle) * DAffine3::from_scale(scale.recip());
                let (latitude, longitude) = ((middle.y * degrees) as f32, (middle.x * degrees) as f32);
                frame
                    .notes
                    .push(format!("degrees are changed to metres around latitude {latitude}, longitude {longitude}"));
            }
            None => frame.notes.push(
                "the reference system is in degrees, and the points lie beyond them: they stay as they are".into(),
            ),
        },
    }
    joint
}

/// The middle of the box around the points, in the unit of the file; `None` where that is not on the globe.
fn middle_of((low, high): (DVec3, DVec3), degrees: f64) -> Option<DVec3> {
    let is_on_globe =
        |place: DVec3| place.x.abs() * degrees <= 540.0 && place.y.abs() * degrees <= 90.0 && place.is_finite();
    (is_on_globe(low) && is_on_globe(high)).then(|| ((low + high) * 0.5).with_z(0.0))
}

/// Metres of a degree eastwards and northwards at a latitude in degrees, on the ellipsoid of WGS 84 (the series of its arcs).
fn metres_of_degree(latitude: f64) -> [f64; 2] {
    let phi = latitude.to_radians();
    let east = 111_412.84 * phi.cos() - 93.5 * (3.0 * phi).cos() + 0.118 * (5.0 * phi).cos();
    let north = 111_132.92 - 559.82 * (2.0 * phi).cos() + 1.175 * (4.0 * phi).cos() - 0.0023 * (6.0 * phi).cos();
    // At the poles all longitudes are one place.
    [east.max(1e-3), north]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_degree_is_as_long_as_geodesy_says() {
        // By pyproj's geodesics on WGS 84, half a degree to both sides.
        for (latitude, wanted) in
            [(0.0, [111_319.49, 110_574.30]), (45.0, [78_846.84, 111_131.78]), (60.0, [55_800.00, 111_412.27])]
        {
            let found = metres_of_degree(latitude);
            for axis in 0..2 {
                assert!((found[axis] / wanted[axis] - 1.0).abs() < 2e-5, "{latitude}: {found:?}");
            }
        }
    }
}
