//! A smooth path through points, walked at one speed: the spline of Catmull and Rom (1974) with centripetal knots (Yuksel, Schaefer and
//! Keyser, 2011), which has neither loops nor cusps between two points.

use super::curve::{Curve, Interpolation};
use glam::DVec3;

/// Pieces of a leg between two points, within which speed is taken to be even.
const PIECES: usize = 256;

/// A path.
#[derive(Clone, Debug, PartialEq)]
pub struct SmoothPath {
    curve: Curve<3>,
    /// Knots at which the walked part of the curve begins and ends.
    knots: (f64, f64),
    /// Length of the path up to each piece, and at its end.
    lengths: Vec<f64>,
}

impl SmoothPath {
    /// The path through points, in this order, and back to the first where it is closed. Points that follow each other in one place are one.
    ///
    /// # Errors
    /// Says what is wrong: fewer than two places, or one that is not finite.
    pub fn through(points: &[DVec3], is_closed: bool) -> Result<Self, &'static str> {
        if !points.iter().all(|point| point.is_finite()) {
            return Err("a point is not finite");
        }
        let mut places = points.to_vec();
        places.dedup();
        if is_closed && places.len() > 1 && places.first() == places.last() {
            places.pop();
        }
        if places.len() < 2 {
            return Err("a path leads through two places or more");
        }
        let count = places.len();
        // A closed path comes from its last leg and goes on to its first: two more points on either side.
        let order: Vec<usize> = if is_closed {
            (count - 2..count).chain(0..count).chain(0..3).map(|at| at % count).collect()
        } else {
            (0..count).collect()
        };
        let (first, last) = if is_closed { (2, count + 2) } else { (0, count - 1) };
        let mut knot = 0.0;
        let mut keys: Vec<(f64, [f64; 3])> = Vec::with_capacity(order.len());
        for (index, &at) in order.iter().enumerate() {
            if index > 0 {
                knot += places[at].distance(places[order[index - 1]]).sqrt();
            }
            keys.push((knot, places[at].to_array()));
        }
        let knots = (keys[first].0, keys[last].0);
        let pieces = (last - first) * PIECES;
        let curve = Curve::new(keys, Interpolation::Smooth);
        let mut path = Self { curve, knots, lengths: vec![0.0] };
        let (mut before, mut length) = (path.place(0.0), 0.0);
        for piece in 1..=pieces {
            let place = path.place(piece as f64 / pieces as f64);
            length += before.distance(place);
            path.lengths.push(length);
            before = place;
        }
        Ok(path)
    }

    /// Length of the path, world units.
    pub fn length(&self) -> f64 {
        self.lengths[self.lengths.len() - 1]
    }

    /// Where one is after a share of the way, from 0 to 1, and the direction in which one walks there, a unit vector.
    pub fn at(&self, share: f64) -> (DVec3, DVec3) {
        let length = share.clamp(0.0, 1.0) * self.length();
        let last = self.lengths.len() - 1;
        let piece = self.lengths.partition_point(|&end| end <= length).clamp(1, last);
        let (start, end) = (self.lengths[piece - 1], self.lengths[piece]);
        let within = if end > start { (length - start) / (end - start) } else { 0.0 };
        let at = ((piece - 1) as f64 + within) / last as f64;
        let step = 0.5 / last as f64;
        let ahead = self.place((at + step).min(1.0)) - self.place((at - step).max(0.0));
        (self.place(at), ahead.normalize_or(DVec3::Y))
    }

    fn place(&self, share: f64) -> DVec3 {
        self.curve.at(self.knots.0 + (self.knots.1 - self.knots.0) * share).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_is_walked_at_one_speed_and_passes_its_points() {
        let points = [[0.0, 0.0, 0.0], [10.0, 0.0, 2.0], [12.0, 30.0, 0.0], [-5.0, 8.0, 1.0]].map(DVec3::from);
        for is_closed in [false, true] {
            let path = SmoothPath::through(&points, is_closed).unwrap();
            let walked: Vec<DVec3> = (0..=1000).map(|step| path.at(f64::from(step) / 1000.0).0).collect();
            let speeds: Vec<f64> = walked.windows(2).map(|pair| pair[0].distance(pair[1])).collect();
            let (least, most) = speeds.iter().fold((f64::MAX, 0f64), |(least, most), &v| (least.min(v), most.max(v)));
            assert!(most / least < 1.1, "{least} to {most}");
            for point in points {
                assert!(walked.iter().any(|place| place.distance(point) < 0.1), "{point}");
            }
            assert!(walked[0].distance(points[0]) < 1e-9);
            let end = if is_closed { points[0] } else { points[3] };
            assert!(walked[1000].distance(end) < 1e-9, "{}", walked[1000]);
        }
    }

    #[test]
    fn a_closed_path_has_no_corner_where_it_closes() {
        let points = [[0.0, 0.0, 0.0], [10.0, 0.0, 0.0], [10.0, 10.0, 0.0], [0.0, 10.0, 0.0]].map(DVec3::from);
        let (open, closed) =
            (SmoothPath::through(&points, false).unwrap(), SmoothPath::through(&points, true).unwrap());
        assert!(closed.at(0.0).1.dot(closed.at(1.0).1) > 0.99 && open.at(0.0).1.dot(open.at(1.0).1) < 0.0);
        assert!(
            SmoothPath::through(&points[..1], true).is_err() && SmoothPath::through(&[DVec3::NAN; 2], false).is_err()
        );
    }
}
