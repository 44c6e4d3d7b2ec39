//! Gaussian splats in a PLY file, as their training writes them (Kerbl et al., "3D Gaussian Splatting for Real-Time Radiance Field
//! Rendering", 2023): ellipsoids by their centre, the logarithms of their radii and a quaternion; opacities before the sigmoid;
//! colours as spherical harmonics, of which the constant one is read. They become points on their discs.

use super::header::Element;
use super::values::Values;
use super::vertices::for_each_row;
use crate::import::reader::ImportOptions;
use crate::import::reader::local_origin::LocalOrigin;
use glam::{DVec3, Quat, Vec3};
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, Limits};

/// The constant spherical harmonic: 1 / (2 √π).
const HARMONIC: f64 = 0.282_094_791_773_878_14;
/// Splats that hide less than this share of what is behind them are left out: haze, which is no surface.
const LEAST_OPACITY: f64 = 0.2;
/// One splat of so many may stand out on each side of an axis.
const MOST_OF: usize = 20;
/// Most points along a disc.
const MOST_ALONG: f32 = 9.0;
/// Properties of a splat behind its place, in the order in which they are looked for.
const NAMES: [&str; 11] =
    ["f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1", "scale_2", "rot_0", "rot_1", "rot_2", "rot_3"];

/// One ellipsoid.
struct Splat {
    centre: Vec3,
    /// Its two longer half axes, at one standard deviation.
    axes: [Vec3; 2],
    color: [u8; 3],
}

/// Columns of the place and of [`NAMES`].
pub(super) struct Columns {
    place: [usize; 3],
    others: [usize; 11],
}

/// The columns of splats, if vertices are such.
pub(super) fn columns(element: &Element) -> Option<Columns> {
    let find = |name: &str| element.find(&[name]).filter(|&at| element.properties[at].list.is_none());
    let mut others = [0; 11];
    for (column, name) in others.iter_mut().zip(NAMES) {
        *column = find(name)?;
    }
    Some(Columns { place: [find("x")?, find("y")?, find("z")?], others })
}

/// Reads splats as points: one at each centre, and more on discs that are larger than half of the others, as densely as those lie.
pub(super) fn read(
    values: &mut Values,
    element: &Element,
    columns: &Columns,
    options: &ImportOptions,
) -> Result<PointCloud, ImportError> {
    let limits = &options.limits;
    let mut local_origin = LocalOrigin::default();
    let (mut splats, mut faint, mut broken) = (Vec::new(), 0u64, 0u64);
    for_each_row(values, element, &mut |row, _| {
        let [red, green, blue, opacity, scales @ .., _, _, _, _] = columns.others.map(|column| row[column]);
        let rotation: [f32; 4] = std::array::from_fn(|at| row[columns.others[7 + at]] as f32);
        let centre = local_origin.localized(DVec3::from_array(columns.place.map(|column| row[column])));
        let [a, b, c] = scales.map(|scale| scale.exp() as f32);
        if !(centre.is_finite() && [a, b, c].iter().all(|radius| radius.is_finite()) && opacity.is_finite()) {
            broken += 1;
        } else if 1.0 / (1.0 + (-opacity).exp()) < LEAST_OPACITY {
            faint += 1;
        } else {
            let color = [red, green, blue].map(|value| byte(0.5 + HARMONIC * value));
            splats.push(Splat { centre, axes: longer_axes([a, b, c], rotation), color });
        }
        Ok(())
    })?;
    let opaque = splats.len();
    if options.points.bounds.is_none() {
        leave_out_strays(&mut splats);
    }
    let far = opaque - splats.len();
    let mut cloud =
        points_of(&splats, limits).map_err(|count| values.limit("points of splats", count, limits.points))?;
    cloud.offset = local_origin.offset();
    if faint > 0 {
        let all = element.count;
        cloud.notes.push(format!("{faint} of {all} splats that are less than {LEAST_OPACITY} opaque are left out"));
    }
    if far > 0 {
        cloud.notes.push(format!("{far} splats that stand far outside of most others are left out"));
    }
    if broken > 0 {
        cloud.notes.push(format!("{broken} splats that are not finite are left out"));
    }
    Ok(cloud)
}

fn byte(share: f64) -> u8 {
    (share.clamp(0.0, 1.0) * 255.0).round() as u8
}

/// Leaves out splats beyond the box around most of them, and as much again: a few that float far out would make everything else small.
fn leave_out_strays(splats: &mut Vec<Splat>) {
    let share = splats.len() / MOST_OF;
    if share == 0 {
        return;
    }
    let ends = [0, 1, 2].map(|axis| {
        let mut places: Vec<f32> = splats.iter().map(|splat| splat.centre[axis]).collect();
        let last = places.len() - 1 - share;
        let low = *places.select_nth_unstable_by(share, f32::total_cmp).1;
        let high = *places.select_nth_unstable_by(last, f32::total_cmp).1;
        [low, high]
    });
    let [low, high] = [0, 1].map(|end| Vec3::from_array(ends.map(|ends| ends[end])));
    let room = Vec3::splat((high - low).max_element() * 0.5);
    let (low, high) = (low - room, high + room);
    splats.retain(|splat| splat.centre.cmpge(low).all() && splat.centre.cmple(high).all());
}

/// The two longer half axes of an ellipsoid; its quaternion has w first and any length.
fn longer_axes(radii: [f32; 3], [w, x, y, z]: [f32; 4]) -> [Vec3; 2] {
    let rotation = Quat::from_xyzw(x, y, z, w);
    let length = rotation.length();
    let rotation = if length.is_normal() { rotation / length } else { Quat::IDENTITY };
    let mut axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| rotation * axis);
    axes.iter_mut().zip(radii).for_each(|(axis, radius)| *axis *= radius);
    axes.sort_by(|a, b| b.length_squared().total_cmp(&a.length_squared()));
    [axes[0], axes[1]]
}

/// Points on the discs of splats; the number of them where they are more than allowed.
fn points_of(splats: &[Splat], limits: &Limits) -> Result<PointCloud, u64> {
    let mut sizes: Vec<f32> = splats.iter().map(|splat| splat.axes[1].length()).collect();
    let middle = sizes.len() / 2;
    let step = if sizes.is_empty() { 1.0 } else { *sizes.select_nth_unstable_by(middle, f32::total_cmp).1 };
    let step = step.max(f32::MIN_POSITIVE);
    // How many points lie on either side of the centre along an axis.
    let beside = |axis: Vec3| (axis.length() / step).min((MOST_ALONG - 1.0) / 2.0).floor() as i32;
    let mut cloud = PointCloud::default();
    for splat in splats {
        let [long, short] = splat.axes;
        let (along, across) = (beside(long), beside(short));
        for (i, j) in (-across..=across).flat_map(|j| (-along..=along).map(move |i| (i, j))) {
            let [u, v] = [(i, along), (j, across)].map(|(at, count)| at as f32 / count.max(1) as f32);
            let point = splat.centre + long * u + short * v;
            if u * u + v * v > 1.0 || !point.is_finite() {
                continue;
            }
            if cloud.positions.len() as u64 >= limits.points {
                return Err(limits.points + 1);
            }
            cloud.positions.push(point);
            cloud.colors.push(splat.color);
        }
    }
    Ok(cloud)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_are_turned_by_the_quaternion_and_the_shortest_is_left_out() {
        // A quarter turn about z brings x to y.
        let half = std::f32::consts::FRAC_1_SQRT_2;
        let [long, short] = longer_axes([3.0, 2.0, 1.0], [2.0 * half, 0.0, 0.0, 2.0 * half]);
        assert!((long - Vec3::Y * 3.0).length() < 1e-5 && (short + Vec3::X * 2.0).length() < 1e-5, "{long} {short}");
        assert_eq!(longer_axes([1.0, 2.0, 3.0], [0.0; 4]), [Vec3::Z * 3.0, Vec3::Y * 2.0]);
    }

    #[test]
    fn a_few_that_float_far_out_are_left_out_and_what_is_long_stays_whole() {
        let splat = |x: f32| Splat { centre: Vec3::new(x, 0.0, 0.0), axes: [Vec3::X, Vec3::Y], color: [1, 2, 3] };
        let mut splats: Vec<Splat> = (0..100).map(|x| splat(x as f32)).chain([splat(-900.0), splat(500.0)]).collect();
        leave_out_strays(&mut splats);
        assert_eq!(splats.len(), 100);
        leave_out_strays(&mut splats);
        assert_eq!(splats.len(), 100);
    }

    #[test]
    fn larger_discs_get_more_points_and_no_more_than_allowed() {
        let splat = |size: f32| Splat { centre: Vec3::ZERO, axes: [Vec3::X * size, Vec3::Y * size], color: [1, 2, 3] };
        let count = |size: f32| {
            let splats: Vec<Splat> = [1.0, 1.0, size].map(splat).into();
            points_of(&splats, &Limits::default()).unwrap().positions.len() - 2 * 5
        };
        // Within a circle of radius 4: Gauss counted 49.
        assert_eq!([0.5, 1.0, 4.0, 1000.0].map(count), [1, 5, 49, 49]);
        let limits = Limits { points: 4, ..Limits::default() };
        assert_eq!(points_of(&[splat(1.0)], &limits), Err(5));
    }
}
