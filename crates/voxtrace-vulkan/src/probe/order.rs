//! P12: the order in which primitives, geometries and instances are given makes no difference to what is hit first.

use super::Effort;
use super::boxes::{Aabb, Random, block};
use super::grids::rays_through;
use super::lab::Lab;
use super::model::{Bottom, BuildFlags, Model, Treatment};
use super::reference::{Expected, Segment, cells_near};
use super::report::Finding;
use super::shot::Reports;
use crate::records::{ProbeAnswer, ProbeRay};
use voxtrace_core::TraceError;

const SIZE: i32 = 8;
const INSTANCES: usize = 2;
const GEOMETRIES: usize = 4;

/// The boxes of a block, dealt out to instances and geometries in an order; for each place there the box.
struct Dealt {
    model: Model,
    boxes: Vec<Vec<Vec<usize>>>,
}

fn deal(all: &[Aabb], order: &[usize]) -> Dealt {
    let mut boxes = vec![vec![Vec::new(); GEOMETRIES]; INSTANCES];
    for (place, &id) in order.iter().enumerate() {
        boxes[place % INSTANCES][place / INSTANCES % GEOMETRIES].push(id);
    }
    let bottom = |ids: &Vec<Vec<usize>>| Bottom {
        geometries: ids.iter().map(|ids| ids.iter().map(|&id| all[id]).collect()).collect(),
        flags: BuildFlags::PREFER_FAST_TRACE,
        treatment: Treatment::Built,
    };
    Dealt { model: Model::of(boxes.iter().map(bottom).collect()), boxes }
}

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (permutations, count) = effort.pick((3, 512), (8, 16384));
    let mut random = Random(12);
    let all = block(SIZE);
    let rays = rays_through(SIZE, count, &mut random);
    let margin = Segment::margin(f64::from(4 * SIZE));
    let expect = |ray: &ProbeRay| {
        let ray = Segment::from(ray);
        Expected::new(&ray, cells_near(&ray, SIZE, margin).into_iter().map(|id| (id, &all[id])), margin)
    };
    let expected: Vec<Expected<usize>> = rays.iter().map(expect).collect();
    let traversals = lab.traversals();
    let mut wrong = vec![0u64; traversals.len()];
    for _ in 0..permutations {
        let dealt = deal(&all, &random.shuffled(all.len()));
        let built = lab.build(&dealt.model)?;
        for (traversal, wrong) in traversals.iter().zip(&mut wrong) {
            let answers = lab.cast(&built, *traversal, &rays, Reports::Exact, 0)?.answers;
            let id = |answer: &ProbeAnswer| {
                let geometry = dealt.boxes.get(answer.instance as usize)?.get(answer.geometry as usize)?;
                geometry.get(answer.primitive as usize).copied()
            };
            let is_wrong = |(expected, answer): &(&Expected<usize>, &ProbeAnswer)| {
                !expected.accepts_answer(answer, id(answer).unwrap_or(usize::MAX))
            };
            *wrong += expected.iter().zip(&answers).filter(is_wrong).count() as u64;
        }
    }
    let rays = (count * permutations) as u64;
    let finding = |(traversal, &wrong)| {
        let says = match wrong {
            0 => "the order of boxes, geometries and instances makes no difference".to_owned(),
            wrong => format!("{wrong} of {rays} rays meet another box when the order changes"),
        };
        Finding::judged(traversal, rays, wrong, says)
    };
    Ok(traversals.into_iter().zip(&wrong).map(finding).collect())
}
