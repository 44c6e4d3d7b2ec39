//! P1: rows of touching boxes along each axis, looked through in both directions. A driver that merges boxes reports one
//! number for several: the study's Figure 6.

use super::Effort;
use super::boxes::{Aabb, Random};
use super::lab::Lab;
use super::merging::Merging;
use super::model::{Bottom, Model};
use super::reference::{Expected, Segment};
use super::report::Finding;
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::Vec3;
use voxtrace_core::TraceError;

const LENGTHS: [usize; 3] = [2, 64, 1000];
/// From row to row.
const APART: f32 = 8.0;

/// The order of the boxes of a row.
fn orders(length: usize, random: &mut Random) -> [Vec<usize>; 3] {
    [(0..length).collect(), (0..length).rev().collect(), random.shuffled(length)]
}

/// Box number `place` of a row along `axis` at a place of its own.
fn box_at(axis: usize, row: usize, place: usize) -> Aabb {
    let mut min = Vec3::splat(APART * (1 + row) as f32);
    min[axis] = place as f32;
    Aabb::new(min, min + 1.0)
}

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let mut random = Random(1);
    let through = effort.pick(4, 64);
    let mut merging: Vec<Merging> = lab.traversals().into_iter().map(Merging::new).collect();
    for order in 0..3 {
        let (mut bottoms, mut rays, mut expected) = (Vec::new(), Vec::<ProbeRay>::new(), Vec::new());
        for row in 0..3 * LENGTHS.len() {
            let (axis, length) = (row / 3, LENGTHS[row % 3]);
            let order = &orders(length, &mut random)[order];
            let boxes: Vec<Aabb> = order.iter().map(|&place| box_at(axis, row, place)).collect();
            for index in 0..2 * through {
                let ends = [-3.0, length as f32 + 3.0];
                let (from, to) = if index % 2 == 0 { (ends[0], ends[1]) } else { (ends[1], ends[0]) };
                let mut origin =
                    Vec3::splat(APART * (1 + row) as f32) + random.point(Vec3::splat(0.1), Vec3::splat(0.9));
                origin[axis] = from;
                let mut direction = Vec3::ZERO;
                direction[axis] = (to - from).signum();
                let ray = ray(origin, direction);
                let segment = Segment::from(&ray);
                let margin = Segment::margin(length as f64 + 80.0);
                expected.push(Expected::new(
                    &segment,
                    boxes.iter().enumerate().map(|(id, aabb)| ((row, id), aabb)),
                    margin,
                ));
                rays.push(ray);
            }
            bottoms.push(Bottom::of(boxes));
        }
        let built = lab.build(&Model::of(bottoms))?;
        for merging in &mut merging {
            let room = LENGTHS[2] + 128;
            let logged = lab.cast(&built, merging.traversal, &rays, Reports::Nothing, room)?;
            let exact = lab.cast(&built, merging.traversal, &rays, Reports::Exact, 0)?;
            let centre = lab.cast(&built, merging.traversal, &rays, Reports::Centre, 0)?;
            for (index, expected) in expected.iter().enumerate() {
                let row = index / (2 * through);
                merging.look(expected, &logged, &exact, &centre, index, &|instance, primitive| match instance {
                    Some(instance) => (instance as usize, primitive as usize),
                    None => (row, primitive as usize),
                });
            }
        }
    }
    Ok(merging.iter().map(|merging| merging.finding(None)).collect())
}
