//! What the points of a measurement say: pure functions, in voxels of the world and degrees.

use super::{Kind, Measure};
use crate::scale::Quantity;
use voxtrace::glam::DVec3;

/// One number of a measurement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value {
    /// What it is, in files.
    pub name: &'static str,
    /// What it counts.
    pub quantity: Quantity,
    /// How much, in voxels, square voxels, cubic voxels or degrees.
    pub number: f64,
}

impl Measure {
    /// Its numbers, the first of which is the one that is asked for; none where points are missing.
    pub fn values(&self) -> Vec<Value> {
        if let Some(component) = &self.component {
            return component.values();
        }
        values(self.kind, &self.points)
    }
}

/// The numbers of some points.
pub fn values(kind: Kind, points: &[DVec3]) -> Vec<Value> {
    let length = |name, number| Value { name, quantity: Quantity::Length, number };
    let area = |name, number| Value { name, quantity: Quantity::Area, number };
    match (kind, points) {
        (Kind::Distance, [from, to, ..]) => {
            let delta = *to - *from;
            let rest = [("dx", delta.x), ("dy", delta.y), ("dz", delta.z), ("horizontal", horizontal(delta))];
            let rest = rest.map(|(name, number)| length(name, number));
            [vec![length("distance", delta.length())], rest.to_vec()].concat()
        }
        (Kind::Height, [from, to, ..]) => {
            let delta = *to - *from;
            vec![length("height", delta.z), length("horizontal", horizontal(delta))]
        }
        (Kind::Angle, [from, at, to, ..]) => {
            let number = angle(*from - *at, *to - *at);
            vec![Value { name: "angle", quantity: Quantity::Angle, number }]
        }
        (Kind::Path, [_, _, ..]) => {
            let climbs = points.windows(2).map(|pair| (pair[1].z - pair[0].z).max(0.0)).sum();
            vec![
                length("length", path_length(points)),
                length("climb", climbs),
                length("between ends", points[0].distance(points[points.len() - 1])),
            ]
        }
        (Kind::Area, [first, .., last]) if points.len() >= 3 => {
            let vector = area_vector(points);
            vec![
                area("area", vector.length()),
                area("area from above", vector.z.abs()),
                length("perimeter", path_length(points) + last.distance(*first)),
                length("beside its plane", beside_plane(points, vector)),
            ]
        }
        _ => Vec::new(),
    }
}

fn horizontal(delta: DVec3) -> f64 {
    delta.truncate().length()
}

/// Between two directions, degrees; exact also for small ones.
fn angle(a: DVec3, b: DVec3) -> f64 {
    a.cross(b).length().atan2(a.dot(b)).to_degrees()
}

fn path_length(points: &[DVec3]) -> f64 {
    points.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
}

/// Half the sum of the cross products of a polygon's corners (Newell): at right angles to its plane, and as long as its area.
fn area_vector(points: &[DVec3]) -> DVec3 {
    // Around the first one: coordinates of maps are large.
    let around = |index: usize| points[index % points.len()] - points[0];
    (0..points.len()).map(|index| around(index).cross(around(index + 1))).sum::<DVec3>() * 0.5
}

/// How far a corner is from the plane through their middle, at most.
fn beside_plane(points: &[DVec3], vector: DVec3) -> f64 {
    let Some(normal) = vector.try_normalize() else { return 0.0 };
    let middle = points.iter().sum::<DVec3>() / points.len() as f64;
    points.iter().map(|point| (*point - middle).dot(normal).abs()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(kind: Kind, points: &[[f64; 3]]) -> Vec<(&'static str, f64)> {
        let points: Vec<DVec3> = points.iter().map(|&point| point.into()).collect();
        values(kind, &points).iter().map(|value| (value.name, value.number)).collect()
    }

    fn near(found: &[(&str, f64)], expected: &[(&str, f64)]) -> bool {
        found.len() == expected.len()
            && found.iter().zip(expected).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-9 * b.1.abs().max(1.0))
    }

    #[test]
    fn a_distance_is_that_of_pythagoras_with_its_parts_along_the_axes() {
        let found = of(Kind::Distance, &[[1.0, 2.0, 3.0], [4.0, -2.0, 15.0]]);
        let expected = [("distance", 13.0), ("dx", 3.0), ("dy", -4.0), ("dz", 12.0), ("horizontal", 5.0)];
        assert!(near(&found, &expected), "{found:?}");
        assert!(!near(&of(Kind::Distance, &[[1.0, 2.0, 3.0], [4.0, -2.0, 14.0]]), &expected), "a voxel is seen");
        assert!(of(Kind::Distance, &[[1.0; 3]]).is_empty());
    }

    #[test]
    fn a_height_is_upwards_alone() {
        assert!(near(
            &of(Kind::Height, &[[9.0, 9.0, 10.0], [6.0, 5.0, 2.5]]),
            &[("height", -7.5), ("horizontal", 5.0)]
        ));
    }

    #[test]
    fn an_angle_is_at_the_second_point_and_exact_from_small_to_straight() {
        for (to, degrees) in [
            ([0.0, 5.0, 0.0], 90.0),
            ([3.0, 3.0, 0.0], 45.0),
            ([-2.0, 0.0, 0.0], 180.0),
            ([1.0, 1e-9, 0.0], 1e-9f64.to_degrees()),
        ] {
            let found = of(Kind::Angle, &[[7.0, 0.0, 0.0], [0.0; 3], to]);
            assert!((found[0].1 - degrees).abs() < 1e-12 * degrees.max(1e-3), "{found:?} {degrees}");
        }
        assert!(
            (of(Kind::Angle, &[[0.0; 3], [7.0, 0.0, 0.0], [7.0, 1.0, 0.0]])[0].1 - 90.0).abs() < 1e-12,
            "not the first"
        );
    }

    #[test]
    fn a_path_is_the_sum_of_its_parts() {
        let found = of(Kind::Path, &[[0.0; 3], [3.0, 4.0, 0.0], [3.0, 4.0, 2.0], [3.0, 4.0, 1.0]]);
        assert!(near(&found, &[("length", 8.0), ("climb", 2.0), ("between ends", 26f64.sqrt())]), "{found:?}");
    }

    #[test]
    fn an_area_is_that_of_the_polygon_on_any_plane_and_far_from_the_origin() {
        // An L of 3 squares, in the plane z = 100; its sides are whole.
        let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        let flat: Vec<[f64; 3]> = corners.iter().map(|&[x, y]| [6e5 + x, 5e6 + y, 100.0]).collect();
        let expected = [("area", 3.0), ("area from above", 3.0), ("perimeter", 8.0), ("beside its plane", 0.0)];
        assert!(near(&of(Kind::Area, &flat), &expected), "{:?}", of(Kind::Area, &flat));
        // The same on a slope of 3 in 4: y and z stretch by 5 in 4.
        let slope: Vec<[f64; 3]> = corners.iter().map(|&[x, y]| [x, 4.0 * y, 3.0 * y]).collect();
        let found = of(Kind::Area, &slope);
        assert!((found[0].1 - 15.0).abs() < 1e-9 && (found[1].1 - 12.0).abs() < 1e-9, "{found:?}");
        let bent = of(Kind::Area, &[[0.0; 3], [2.0, 0.0, 0.0], [2.0, 2.0, 1.0], [0.0, 2.0, 0.0]]);
        assert!(bent[3].1 > 0.1, "a corner that is not on the plane is told of: {bent:?}");
        let reversed: Vec<[f64; 3]> = flat.iter().rev().copied().collect();
        assert!(near(&of(Kind::Area, &reversed), &expected), "whichever way around");
        assert!(!near(&of(Kind::Area, &flat[..5]), &expected), "the comparison sees a corner that is missing");
    }
}
