//! What a ray must meet, in double precision: the slab test of Kay and Kajiya (1986) on boxes a little larger and a little
//! smaller than they are, so that what single precision cannot tell is not held against a driver.

use super::boxes::Aabb;
use crate::records::{ProbeAnswer, ProbeRay};
use glam::{DVec3, Vec3};

/// Part of the size of what is looked at that single precision may be off by; a few units in the last place of the
/// subtractions and divisions of a slab test.
const PRECISION: f64 = 2e-6;

/// A ray in double precision.
#[derive(Clone, Copy, Debug)]
pub struct Segment {
    pub origin: DVec3,
    pub direction: DVec3,
    pub t_min: f64,
    pub t_max: f64,
}

impl From<&ProbeRay> for Segment {
    fn from(ray: &ProbeRay) -> Self {
        let wide = |v: [f32; 3]| Vec3::from(v).as_dvec3();
        Self {
            origin: wide(ray.origin),
            direction: wide(ray.direction),
            t_min: ray.t_min.into(),
            t_max: ray.t_max.into(),
        }
    }
}

impl Segment {
    /// Where the segment enters and leaves a box that is larger by `grow` on each side.
    pub fn span(&self, aabb: &Aabb, grow: f64) -> Option<(f64, f64)> {
        let (mut enter, mut leave) = (self.t_min, self.t_max);
        for axis in 0..3 {
            let (low, high) = (f64::from(aabb.min[axis]) - grow, f64::from(aabb.max[axis]) + grow);
            let (origin, direction) = (self.origin[axis], self.direction[axis]);
            // Also where a box that shrinks is none any more, or is inactive.
            if !matches!(low.partial_cmp(&high), Some(std::cmp::Ordering::Less | std::cmp::Ordering::Equal)) {
                return None;
            }
            if direction == 0.0 {
                if origin < low || origin > high {
                    return None;
                }
                continue;
            }
            let (first, second) = ((low - origin) / direction, (high - origin) / direction);
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        (enter <= leave).then_some((enter, leave))
    }

    /// What rounding may amount to in a scene within `size` of the ray's origin.
    pub fn margin(size: f64) -> f64 {
        size * PRECISION
    }
}

/// A box that a ray meets, or may meet within rounding.
#[derive(Clone, Copy, Debug)]
struct Meeting<Id> {
    id: Id,
    /// Where it is entered, at the earliest and, where it is met beyond doubt, at the latest.
    earliest: f64,
    latest: Option<f64>,
}

/// What one ray must meet.
#[derive(Clone, Debug)]
pub struct Expected<Id> {
    meetings: Vec<Meeting<Id>>,
    tolerance: f64,
}

impl<Id: Copy + PartialEq> Expected<Id> {
    /// Looks at all of `boxes`; `margin` as [`Segment::margin`] says.
    pub fn new<'a>(ray: &Segment, boxes: impl IntoIterator<Item = (Id, &'a Aabb)>, margin: f64) -> Self {
        let mut expected = Self { meetings: Vec::new(), tolerance: margin / ray.direction.length() };
        expected.add(ray, boxes, margin);
        expected
    }

    /// Looks at more boxes.
    pub fn add<'a>(&mut self, ray: &Segment, boxes: impl IntoIterator<Item = (Id, &'a Aabb)>, margin: f64) {
        for (id, aabb) in boxes {
            let Some((earliest, _)) = ray.span(aabb, margin) else { continue };
            // Beyond doubt also means that the segment does not just end there.
            let inside = Segment { t_max: ray.t_max - self.tolerance, ..*ray };
            let latest = inside.span(aabb, -margin).map(|(enter, _)| enter);
            self.meetings.push(Meeting { id, earliest, latest });
        }
    }

    /// Whether the ray meets the box, or may.
    pub fn may_meet(&self, id: Id) -> bool {
        self.meetings.iter().any(|meeting| meeting.id == id)
    }

    /// The boxes that it meets beyond doubt.
    pub fn sure(&self) -> impl Iterator<Item = Id> + '_ {
        self.meetings.iter().filter(|meeting| meeting.latest.is_some()).map(|meeting| meeting.id)
    }

    /// Where the nearest box that is met beyond doubt is entered.
    fn nearest(&self) -> Option<f64> {
        self.meetings.iter().filter_map(|meeting| meeting.latest).min_by(f64::total_cmp)
    }

    /// Whether a box is the first that the ray enters, within rounding. `None` stands for a miss.
    pub fn accepts(&self, id: Option<Id>) -> bool {
        let nearest = self.nearest();
        match id {
            None => nearest.is_none(),
            Some(id) => self.meetings.iter().any(|meeting| {
                meeting.id == id && nearest.is_none_or(|nearest| meeting.earliest <= nearest + self.tolerance)
            }),
        }
    }

    /// As [`Self::accepts`], for an answer whose distance counts too.
    pub fn accepts_answer(&self, answer: &ProbeAnswer, id: Id) -> bool {
        if answer.is_hit != 1 {
            return answer.is_hit == 0 && self.accepts(None);
        }
        let t = f64::from(answer.t);
        let is_there = |meeting: &Meeting<Id>| {
            let latest = meeting.latest.unwrap_or(f64::INFINITY);
            (meeting.earliest - self.tolerance..=latest + self.tolerance).contains(&t)
        };
        self.accepts(Some(id)) && self.meetings.iter().any(|meeting| meeting.id == id && is_there(meeting))
    }
}

/// The cells of a block of `size`³ unit boxes at the origin that a ray may meet, by their number, x quickest.
pub fn cells_near(ray: &Segment, size: i32, margin: f64) -> Vec<usize> {
    let mut cells = Vec::new();
    let far = size as f32;
    let slab = |ray: &Segment, min: [f32; 3], max: [f32; 3]| {
        let (enter, leave) = ray.span(&Aabb { min, max }, 2.0 * margin)?;
        Some(Segment { t_min: enter, t_max: leave, ..*ray })
    };
    // Slice by slice, row by row, cell by cell.
    for z in 0..size {
        let (low, high) = (z as f32, (z + 1) as f32);
        let Some(slice) = slab(ray, [0.0, 0.0, low], [far, far, high]) else { continue };
        for y in 0..size {
            let Some(row) = slab(&slice, [0.0, y as f32, low], [far, (y + 1) as f32, high]) else { continue };
            let ends = [row.t_min, row.t_max].map(|t| row.origin.x + t * row.direction.x);
            let first = (ends[0].min(ends[1]) - 1.0).floor().clamp(0.0, f64::from(size)) as i32;
            let last = (ends[0].max(ends[1]) + 1.0).ceil().clamp(0.0, f64::from(size)) as i32;
            cells.extend((first..last).map(|x| (x + size * (y + size * z)) as usize));
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::super::boxes::{Random, block};
    use super::*;

    fn answer(primitive: u32, t: f32) -> ProbeAnswer {
        ProbeAnswer { is_hit: 1, primitive, t, ..ProbeAnswer::default() }
    }

    #[test]
    fn the_reference_knows_the_first_box_of_a_row_and_no_other() {
        let row: Vec<Aabb> = (0..4).map(|x| Aabb::cell(glam::IVec3::new(x, 0, 0))).collect();
        let ray = Segment { origin: DVec3::new(-2.0, 0.5, 0.5), direction: DVec3::X, t_min: 0.0, t_max: 100.0 };
        let expected = Expected::new(&ray, row.iter().enumerate(), 1e-5);
        assert_eq!(expected.sure().count(), 4);
        assert!(expected.accepts_answer(&answer(0, 2.0), 0));
        assert!(!expected.accepts_answer(&answer(1, 3.0), 1), "the second box");
        assert!(!expected.accepts_answer(&answer(0, 2.1), 0), "a wrong distance");
        assert!(!expected.accepts_answer(&ProbeAnswer::default(), 0), "a miss");
        assert!(!expected.accepts_answer(&ProbeAnswer { is_hit: u32::MAX, ..answer(0, 2.0) }, 0), "no shader ran");
        let short = Segment { t_max: 1.0, ..ray };
        assert!(Expected::new(&short, row.iter().enumerate(), 1e-5).accepts(None));
    }

    #[test]
    fn the_cells_near_a_ray_are_all_that_it_meets() {
        let (boxes, mut random) = (block(7), Random(4));
        for _ in 0..500 {
            let (from, to) =
                (random.point(Vec3::splat(-9.0), Vec3::splat(16.0)), random.point(Vec3::ZERO, Vec3::splat(7.0)));
            let mut direction = to - from;
            direction[random.below(3)] *= (random.below(3) as f32 - 1.0).abs();
            let ray = ProbeRay { origin: from.into(), direction: direction.into(), t_max: 10.0, ..ProbeRay::default() };
            let ray = Segment::from(&ray);
            let all = Expected::new(&ray, boxes.iter().enumerate(), 1e-4);
            let near = cells_near(&ray, 7, 1e-4);
            assert!((0..boxes.len()).all(|id| !all.may_meet(id) || near.contains(&id)));
        }
    }
}
