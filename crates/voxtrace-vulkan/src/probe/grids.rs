//! P2: solid blocks of boxes under random rays, built with different flags, and once with boxes 1/64 smaller on each side: where
//! that brings missing candidates back, the driver merges boxes that touch.

use super::Effort;
use super::boxes::{Aabb, Random, block};
use super::lab::Lab;
use super::merging::Merging;
use super::model::{Bottom, BuildFlags, Model, Treatment};
use super::reference::{Expected, Segment, cells_near};
use super::report::Finding;
use super::shot::{Reports, ray};
use crate::records::ProbeRay;
use glam::Vec3;
use voxtrace_core::TraceError;

const INSET: f32 = 1.0 / 64.0;

/// Rays from outside through a block of `size`³ boxes.
pub fn rays_through(size: i32, count: usize, random: &mut Random) -> Vec<ProbeRay> {
    let size = size as f32;
    let through = |random: &mut Random| {
        let target = random.point(Vec3::ZERO, Vec3::splat(size));
        let direction = random.direction();
        ray(target - direction * 2.0 * size, direction)
    };
    (0..count).map(|_| through(random)).collect()
}

pub fn run(lab: &mut Lab, effort: Effort) -> Result<Vec<Finding>, TraceError> {
    let (sizes, count): (&[i32], usize) = effort.pick((&[8, 16], 1024), (&[8, 16, 32, 64, 96], 8192));
    let flags = [
        BuildFlags::PREFER_FAST_TRACE,
        BuildFlags::PREFER_FAST_BUILD,
        BuildFlags::LOW_MEMORY,
        BuildFlags::PREFER_FAST_TRACE | BuildFlags::ALLOW_COMPACTION | BuildFlags::ALLOW_UPDATE,
    ];
    let traversals = lab.traversals();
    let mut touching: Vec<Merging> = traversals.iter().map(|&traversal| Merging::new(traversal)).collect();
    let mut inset: Vec<Merging> = traversals.iter().map(|&traversal| Merging::new(traversal)).collect();
    let mut random = Random(2);
    for &size in sizes {
        let boxes = block(size);
        let rays = rays_through(size, count, &mut random);
        let margin = Segment::margin(f64::from(4 * size));
        let expect = |boxes: &[Aabb]| -> Vec<Expected<usize>> {
            let near = |ray: &ProbeRay| {
                let ray = Segment::from(ray);
                let cells = cells_near(&ray, size, margin);
                Expected::new(&ray, cells.into_iter().map(|id| (id, &boxes[id])), margin)
            };
            rays.iter().map(near).collect()
        };
        let capacity = 8 * size as usize;
        let look = |lab: &mut Lab, merging: &mut [Merging], boxes: &[Aabb], flags, expected: &[Expected<usize>]| {
            let bottom = Bottom { geometries: vec![boxes.to_vec()], flags, treatment: Treatment::Built };
            let built = lab.build(&Model::of(vec![bottom]))?;
            for merging in merging {
                let logged = lab.cast(&built, merging.traversal, &rays, Reports::Nothing, capacity)?;
                let exact = lab.cast(&built, merging.traversal, &rays, Reports::Exact, 0)?;
                let centre = lab.cast(&built, merging.traversal, &rays, Reports::Centre, 0)?;
                for (index, expected) in expected.iter().enumerate() {
                    merging.look(expected, &logged, &exact, &centre, index, &|_, primitive| primitive as usize);
                }
            }
            Ok::<(), TraceError>(())
        };
        let expected = expect(&boxes);
        for flags in flags {
            look(lab, &mut touching, &boxes, flags, &expected)?;
        }
        let smaller: Vec<_> = boxes.iter().map(|aabb| aabb.inset(INSET)).collect();
        look(lab, &mut inset, &smaller, flags[0], &expect(&smaller))?;
    }
    Ok(touching.iter().zip(&inset).map(|(touching, inset)| touching.finding(Some(inset.missing))).collect())
}
