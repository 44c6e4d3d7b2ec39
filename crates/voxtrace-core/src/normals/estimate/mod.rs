//! Normals of voxels from which voxels there are around them, at several scales.
//!
//! Occupancy is blurred by a window that is nearly a Gaussian, which has the same width in all directions, so that its gradient is the normal of a
//! plane however that lies among the voxels. A small window follows the shape but sees a gentle slope as flat treads with steps between them; a
//! large one sees the slope but rounds the shape off. So each voxel begins with the smallest window and goes on to one of twice the width as long as that
//! differs by no more than what the smaller could not tell. Where a sheet is so thin that its two sides cancel, the gradient says nothing, and the direction
//! in which the blurred occupancy is bent most is the normal, of both sides.
//!
//! Sums, products, quotients and roots in a fixed order: the same voxels have the same normals on every machine.

mod bend;
mod field;
mod shape;

use super::code::{NO_NORMAL, encode};
use crate::math::normalize;
use bend::strongest_bend;
use field::{Field, Jet, Sampled};
use glam::{IVec3, Vec3};
use rayon::prelude::*;
pub use shape::Occupancy;
use shape::Shape;
use voxtrace_scene::brick::voxel_of;
use voxtrace_scene::ray::FACES;

/// Bricks along an edge of a tile, whose fields are in memory at a time.
const TILE: i32 = 4;
/// Below this gradient (1 over voxels) the smallest window sees both sides of a surface: that of a half space is 0.24, of a sheet of three voxels 0.17
/// and of two 0.07.
const THIN: f32 = 0.1;
/// Least bend of a thin surface, and how much less the bend along it may be than that across.
const LEAST_BEND: f64 = 0.02;
const LEAST_FLATNESS: f64 = 0.5;
/// For each larger window the cosines of the angles to the one before: up to the first it counts in full, from the second on not at all. A window
/// of half the reach takes slopes of up to a step in its width for flat.
const AGREEMENT: [(f32, f32); 3] = [(0.970, 0.914), (0.993, 0.970), (0.998, 0.993)];

/// How far behind a voxel, along its normal, there are others in what is not thin; two steps of this, voxels.
const BEHIND: f32 = 1.1;

/// The codes of the normals of all voxels of a grid, brick by brick, in rank order; [`NO_NORMAL`] where there is none to be found, and within the solid.
pub fn normals_of(bricks: &Occupancy) -> Vec<(IVec3, Vec<u16>)> {
    let shape = Shape::new(bricks);
    let mut tiles: Vec<IVec3> = bricks.keys().map(|&at| at.div_euclid(IVec3::splat(TILE))).collect();
    tiles.par_sort_unstable_by_key(|at| (at.z, at.y, at.x));
    tiles.dedup();
    tiles.par_iter().flat_map_iter(|&tile| normals_of_tile(&shape, tile)).collect()
}

fn normals_of_tile(shape: &Shape, tile: IVec3) -> Vec<(IVec3, Vec<u16>)> {
    let voxels = Scales::of(&|at| shape.voxels(at), tile);
    let solid = shape.has_enclosed().then(|| Scales::of(&|at| shape.solid(at), tile));
    let solid = solid.as_ref().unwrap_or(&voxels);
    let mut found = Vec::new();
    for place in 0..TILE * TILE * TILE {
        let within = IVec3::new(place % TILE, place / TILE % TILE, place / (TILE * TILE));
        let Some(masks) = shape.voxels(tile * TILE + within) else { continue };
        let mut codes = Vec::new();
        for (block, &mask) in masks.iter().enumerate() {
            for bit in (0..64).filter(|bit| mask >> bit & 1 == 1) {
                let normal = normal_of_voxel(&voxels, solid, within * 8 + voxel_of(block, bit));
                let code = normal.map_or(NO_NORMAL, |(normal, is_two_sided)| encode(normal, is_two_sided));
                codes.push(code as u16);
            }
        }
        found.push((tile * TILE + within, codes));
    }
    found
}

/// The normal of a voxel, and whether it is that of both sides; `None` within the solid. What is seen from outside is shaped as if it was not hollow.
fn normal_of_voxel(voxels: &Scales, solid: &Scales, voxel: IVec3) -> Option<(Vec3, bool)> {
    let has_neighbor = |is: &dyn Fn(IVec3) -> bool| FACES.iter().any(|face| is(voxel + face.normal()));
    let is_outside = has_neighbor(&|next| !solid.finest.is_occupied(next));
    let is_inside = has_neighbor(&|next| !voxels.finest.is_occupied(next) && solid.finest.is_occupied(next));
    if !is_outside && !is_inside {
        return None;
    }
    let scales = if is_outside { solid } else { voxels };
    let (normal, is_two_sided) = normal_at(scales, voxel)?;
    let is_empty_behind = |steps: f32| {
        let place = voxel.as_vec3() + 0.5 - normal * (steps * BEHIND);
        !scales.finest.is_occupied(place.floor().as_ivec3())
    };
    let is_thin = is_empty_behind(1.0) || is_empty_behind(2.0);
    Some((normal, is_two_sided || is_thin))
}

/// The fields of a tile, fine to coarse.
struct Scales {
    finest: Field,
    coarser: Vec<Sampled>,
}

impl Scales {
    fn of(masks_of: &dyn Fn(IVec3) -> Option<[u64; 8]>, tile: IVec3) -> Self {
        let field = |level: u32| Field::of(masks_of, tile * (TILE * 8), TILE * 8, level);
        let coarser = (1..=AGREEMENT.len() as u32).map(|level| Sampled::new(field(level), level)).collect();
        Self { finest: field(0), coarser }
    }
}

/// The normal of a voxel of a tile, and whether it is that of both sides.
fn normal_at(scales: &Scales, voxel: IVec3) -> Option<(Vec3, bool)> {
    let jet = scales.finest.jet_at_voxel(voxel);
    let is_two_sided = jet.gradient.length_squared() < THIN * THIN;
    let mut normal = normal_of(&jet, is_two_sided)?;
    for (field, (full, none)) in scales.coarser.iter().zip(AGREEMENT) {
        let Some(next) = normal_of(&field.at(voxel), is_two_sided) else { break };
        let next = if is_two_sided && next.dot(normal) < 0.0 { -next } else { next };
        let weight = ((next.dot(normal) - none) / (full - none)).clamp(0.0, 1.0);
        if weight == 0.0 {
            break;
        }
        normal = normalize(normal * (1.0 - weight) + next * weight);
    }
    Some((normal, is_two_sided))
}

fn normal_of(jet: &Jet, is_two_sided: bool) -> Option<Vec3> {
    if is_two_sided {
        let (bend, across, along) = strongest_bend(&jet.bend);
        let is_sheet = -bend >= LEAST_BEND && along.abs() <= -bend * LEAST_FLATNESS;
        return is_sheet.then_some(across);
    }
    (jet.gradient.length_squared() > 1e-6).then(|| normalize(-jet.gradient))
}

#[cfg(test)]
mod tests;
