//! P8: blocks of unit boxes far from the origin, seen from nearby: how far off coordinates may be before the driver's arithmetic
//! loses boxes. Sets the distance from which scenes should be moved to the origin.

use super::Effort;
use super::boxes::{Random, block};
use super::lab::Lab;
use super::model::Model;
use super::reference::{Expected, Segment};
use super::report::{Finding, Outcome};
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::Vec3;
use voxtrace_core::TraceError;

const SIZE: i32 = 4;

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (powers, count): (&[u32], usize) =
        effort.pick((&[10, 14, 17, 20, 23], 256), (&[10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23], 4096));
    let mut random = Random(8);
    let traversals = lab.traversals();
    // Wrong rays of each traversal by power.
    let mut wrong = vec![Vec::new(); traversals.len()];
    for &power in powers {
        let at = Vec3::splat((1u32 << power) as f32);
        let boxes: Vec<_> = block(SIZE).into_iter().map(|aabb| aabb.moved(at)).collect();
        let near = |random: &mut Random| {
            let target = at + random.point(Vec3::ZERO, Vec3::splat(SIZE as f32));
            let origin = at + random.direction() * 16.0;
            ray(origin, (target - origin).normalize())
        };
        let rays: Vec<ProbeRay> = (0..count).map(|_| near(&mut random)).collect();
        let built = lab.build(&Model::single(boxes.clone()))?;
        // Differences of neighbouring coordinates are exact at any distance: the shader's test stays as good.
        let margin = Segment::margin(64.0);
        let expect = |ray: &ProbeRay| Expected::new(&Segment::from(ray), boxes.iter().enumerate(), margin);
        let expected: Vec<Expected<usize>> = rays.iter().map(expect).collect();
        for (traversal, wrong) in traversals.iter().zip(&mut wrong) {
            let answers = lab.cast(&built, *traversal, &rays, Reports::Exact, 0)?.answers;
            let right = expected
                .iter()
                .zip(&answers)
                .filter(|(expected, answer)| expected.accepts_answer(answer, answer.primitive as usize));
            wrong.push(count as u64 - right.count() as u64);
        }
    }
    let finding = |(traversal, wrong): (_, &Vec<u64>)| {
        let good = wrong.iter().take_while(|&&wrong| wrong == 0).count();
        let says = match (good.checked_sub(1).map(|last| powers[last]), powers.get(good)) {
            (Some(last), None) => format!("right up to coordinates of 2^{last}"),
            (Some(last), Some(next)) => format!(
                "right up to coordinates of 2^{last}; at 2^{next} {} of {count} rays are wrong: move scenes to the origin",
                wrong[good]
            ),
            (None, _) => format!("{} of {count} rays are wrong at coordinates of 2^{}", wrong[0], powers[0]),
        };
        let outcome = if good == 0 { Outcome::Fails } else { Outcome::Reported };
        let mut finding = Finding::new(Some(traversal), outcome, says);
        finding.rays = (count * powers.len()) as u64;
        finding.wrong = wrong.iter().sum();
        for (power, &wrong) in powers.iter().zip(wrong) {
            finding = finding.with(&format!("wrong at 2^{power}"), wrong);
        }
        finding
    };
    Ok(traversals.iter().copied().zip(&wrong).map(finding).collect())
}
