//! P5: boxes without a volume. P6: inactive boxes, which are left out but counted.

use super::Effort;
use super::boxes::Aabb;
use super::lab::Lab;
use super::model::Model;
use super::report::Finding;
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::{IVec3, Vec3};
use voxtrace_core::TraceError;

/// Flat along one axis, two or three, each 10 units from the next; a ray towards the middle of each along its first flat axis.
pub fn flat(lab: &mut Lab, _: Effort) -> Result<Vec<Finding>, TraceError> {
    let (mut boxes, mut rays) = (Vec::new(), Vec::<ProbeRay>::new());
    for flat in [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [1, 0, 1], [0, 1, 1], [1, 1, 1]] {
        let low = Vec3::new(10.0 * boxes.len() as f32, 2.0, 3.0);
        let size = Vec3::ONE - IVec3::from(flat).as_vec3();
        let axis = flat.iter().position(|&is_flat| is_flat == 1).unwrap_or(0);
        let mut direction = Vec3::ZERO;
        direction[axis] = 1.0;
        boxes.push(Aabb::new(low, low + size));
        rays.push(ray(low + size * 0.5 - direction * 5.0, direction));
    }
    let built = lab.build(&Model::single(boxes))?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let answers = lab.cast(&built, traversal, &rays, Reports::Exact, 0)?.answers;
        let is_right = |index: &usize| {
            answers[*index].is_hit == 1 && answers[*index].primitive as usize == *index && answers[*index].t == 5.0
        };
        let hits = |range: std::ops::Range<usize>| range.filter(is_right).count() as u64;
        let (faces, lines, points) = (hits(0..3), hits(3..6), hits(6..7));
        let says = format!("{faces} of 3 flat boxes are hit, {lines} of 3 lines, {points} of 1 point");
        findings
            .push(Finding::judged(traversal, 3, 3 - faces, says).with("lines hit", lines).with("points hit", points));
    }
    Ok(findings)
}

/// A row with one box inactive, and one with every other.
pub fn inactive(lab: &mut Lab, _: Effort) -> Result<Vec<Finding>, TraceError> {
    let count = 64;
    let rows = [("one inactive", 0..1), ("half of them inactive", 0..count / 2)].map(|(what, range)| {
        let inactive: Vec<usize> = range.map(|index| 2 * index + 1).collect();
        let boxes: Vec<Aabb> = (0..count)
            .map(|index| match inactive.contains(&index) {
                true => Aabb::INACTIVE,
                false => Aabb::cell(IVec3::new(3 * index as i32, 0, 0)),
            })
            .collect();
        (what, inactive, boxes)
    });
    let rays: Vec<ProbeRay> =
        (0..count).map(|index| ray([3.0 * index as f32 + 0.5, 0.5, -4.0], [0.0, 0.0, 1.0])).collect();
    let built =
        rows.iter().map(|(_, _, boxes)| lab.build(&Model::single(boxes.clone()))).collect::<Result<Vec<_>, _>>()?;
    let mut findings = Vec::new();
    for traversal in lab.traversals() {
        let (mut broken, mut wrong) = (Vec::new(), 0);
        for ((what, inactive, _), built) in rows.iter().zip(&built) {
            let answers = lab.cast(built, traversal, &rays, Reports::Exact, 0)?.answers;
            let (left_out, there): (Vec<usize>, Vec<usize>) = (0..count).partition(|index| inactive.contains(index));
            let seen = left_out.iter().filter(|&&index| answers[index].is_hit != 0).count();
            let is_lost = |&&index: &&usize| answers[index].is_hit != 1 || answers[index].primitive as usize != index;
            let lost = there.iter().filter(is_lost).count();
            wrong += (seen + lost) as u64;
            if seen + lost > 0 {
                broken.push(format!(
                    "with {what} {lost} of {} others are lost and {seen} inactive ones hit",
                    there.len()
                ));
            }
        }
        let says = match broken.is_empty() {
            true => "inactive boxes are left out, and the numbers of the others stay".to_owned(),
            false => broken.join("; "),
        };
        findings.push(Finding::judged(traversal, 2 * count as u64, wrong, says));
    }
    Ok(findings)
}
