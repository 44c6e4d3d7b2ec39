//! What becomes of a block of 2×2×2 voxels in the next coarser level.
//!
//! - It is one voxel where any of the eight is there: what is shut stays shut.
//! - It is opaque where the opaque ones among the eight shut it, that is, lie in the way of each of the four lines along some axis, or are at least half of those that
//!   are there, or one of them emits. So a thin wall stays a wall, and a pane with bars before it stays a pane.
//! - Of the opaque ones, or of the others, it has the kind of material with most free faces, those that nothing opaque covers, and the mean colour, each voxel counted by
//!   its free faces; all alike where none has any.
//! - Surfaces emit what they did together: Σ emission × free faces, over the area of its own free faces, four each.
//! - Media are as thick as they were: coefficients per voxel grow with its edge, and shrink with the share of the block.

use super::materials::Kinds;
use super::window::{SIDES, Voxel, Window};
use crate::packed::PackedMaterial;
use glam::{DVec3, IVec3, Vec3};

/// A voxel of the coarser level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Block {
    /// The material that it keeps as it is, where all that count have one.
    pub same: Option<u16>,
    /// The kind of its material.
    pub kind: u16,
    /// Of the eight, how many are of that kind.
    pub share: u8,
    pub base_color: Vec3,
    /// What its surface emits.
    pub emission: Vec3,
    /// In sixteenths, from 1 to 16.
    pub coverage: u8,
}

/// The block at `at` of the window, `None` where it is empty.
pub fn block_at(window: &Window, at: IVec3, materials: &[PackedMaterial], kinds: &Kinds) -> Option<Block> {
    let children = window.block(at);
    let is_opaque = opacity(window, &children)?;
    let mut counted: [Option<(usize, u32)>; 8] = [None; 8];
    let mut power = DVec3::ZERO;
    for (child, material) in children.iter().enumerate().filter_map(|(child, voxel)| Some((child, voxel.material()?))) {
        let traits = window.traits(material);
        if traits.covers == is_opaque || traits.emits {
            let faces = window.free_faces(at, child);
            power += materials[material].surface_emission().as_dvec3() * f64::from(faces);
            if traits.covers == is_opaque {
                counted[child] = Some((material, faces));
            }
        }
    }
    let is_seen = counted.iter().flatten().any(|&(_, faces)| faces > 0);
    let weights = || counted.iter().flatten().map(|&(material, faces)| (material, if is_seen { faces } else { 1 }));
    let kind = most_common(weights().map(|(material, weight)| (kinds.of_material[material], weight)));
    let share = weights().filter(|&(material, _)| kinds.of_material[material] == kind).count() as u8;
    let sum: DVec3 = weights().map(|(material, w)| materials[material].base_color.as_dvec3() * f64::from(w)).sum();
    let total: u32 = weights().map(|(_, weight)| weight).sum();
    let has_surface = !kinds.materials[usize::from(kind)].is_without_surface();
    let emission = if has_surface && power != DVec3::ZERO {
        let faces = SIDES.iter().filter(|&&side| is_free(window, at + side)).count();
        if faces > 0 { power / (4 * faces) as f64 } else { DVec3::ZERO }
    } else {
        DVec3::ZERO
    };
    let emission = emission.as_vec3();
    let first = counted.iter().flatten().next().map_or(0, |&(material, _)| material);
    let is_same = weights().all(|(material, _)| material == first)
        && materials[first].surface_emission() == emission
        && (share == 4 || !kinds.has_medium(kind));
    let coverage: u32 = children.iter().map(|child| child.coverage()).sum();
    Some(Block {
        same: is_same.then_some(first as u16),
        kind,
        share,
        base_color: (sum / f64::from(total)).as_vec3(),
        emission,
        coverage: ((coverage + 4) / 8).max(1) as u8,
    })
}

/// Whether a block is opaque; `None` where it is empty.
fn opacity(window: &Window, children: &[Voxel; 8]) -> Option<bool> {
    let (mut there, mut opaque, mut emits) = (0u32, 0u32, false);
    for (child, material) in children.iter().enumerate().filter_map(|(child, voxel)| Some((child, voxel.material()?))) {
        let traits = window.traits(material);
        there += 1;
        opaque |= u32::from(traits.covers) << child;
        emits |= traits.covers && traits.emits;
    }
    (there > 0).then(|| shuts(opaque) || emits || 2 * opaque.count_ones() >= there)
}

/// Whether the voxels of a mask lie in the way of each of the four lines along some axis.
fn shuts(mask: u32) -> bool {
    [(1, 0x55), (2, 0x33), (4, 0x0f)].iter().any(|&(step, lines)| (mask | mask >> step) & lines == lines)
}

/// Whether light leaves into the block at `at`.
fn is_free(window: &Window, at: IVec3) -> bool {
    opacity(window, &window.block(at)) != Some(true)
}

/// The kind with most weight, the first of those that have as much.
fn most_common(kinds: impl Iterator<Item = (u16, u32)>) -> u16 {
    let mut found: [(u16, u32); 8] = [(u16::MAX, 0); 8];
    let mut count = 0;
    for (kind, weight) in kinds {
        match found[..count].iter_mut().find(|(known, _)| *known == kind) {
            Some((_, sum)) => *sum += weight,
            None => {
                found[count] = (kind, weight);
                count += 1;
            }
        }
    }
    found[..count].iter().max_by_key(|&&(kind, sum)| (sum, std::cmp::Reverse(kind))).map_or(0, |&(kind, _)| kind)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mask_shuts_where_it_lies_across_all_lines_along_an_axis() {
        let lies_across = |mask: u32| {
            (0..3).any(|axis: u32| {
                let step = 1 << axis;
                (0..8u32)
                    .filter(|child| child & step == 0)
                    .all(|child| mask >> child & 1 == 1 || mask >> (child + step) & 1 == 1)
            })
        };
        assert!((0..256).all(|mask| shuts(mask) == lies_across(mask)));
        assert!(!shuts(0b0000_0011) && shuts(0b0000_1111) && shuts(0b1001_0110));
        assert_eq!(most_common([(5, 1), (3, 2), (5, 1)].into_iter()), 3);
    }
}
