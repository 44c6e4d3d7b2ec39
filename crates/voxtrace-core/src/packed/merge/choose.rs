//! Which instances of a scene may become one grid: those that stand on the lattice of the world, once, without moving.

use super::lattice::Lattice;
use glam::{IVec3, Vec3};
use rayon::prelude::*;
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelBox};
use voxtrace_scene::scene::{Instance, Scene};

/// An instance that may be merged.
pub struct Candidate {
    /// Its index among the visible instances.
    pub instance: usize,
    /// From its voxels to those of the world.
    pub world_from_part: Lattice,
}

/// The space that an instance fills, world space.
#[derive(Clone, Copy)]
struct Space {
    min: Vec3,
    max: Vec3,
}

impl Space {
    fn of(instance: &Instance, bounds: VoxelBox) -> Self {
        let corners = (0..8).map(|corner| {
            let pick = IVec3::new(corner & 1, corner >> 1 & 1, corner >> 2);
            instance.world_from_grid.point((bounds.min + (bounds.max - bounds.min) * pick).as_vec3())
        });
        let space = corners.map(|point| Self { min: point, max: point });
        let space = space.reduce(|a, b| Self { min: a.min.min(b.min), max: a.max.max(b.max) });
        let Self { min, max } = space.expect("a box has corners");
        // What rounding may move: the sums of a turned corner are off by some units in their last places.
        let margin = 0.01 + (min.abs().max(max.abs())).max_element() * 1e-6;
        Self { min: min - margin, max: max + margin }
    }

    fn touches(&self, other: &Self) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }
}

/// Those of the visible instances, in their order, that may be merged, so that where two things are met at once the one with the
/// lowest index still is the hit: the merged one takes the place of its first, and none is in it that another instance
/// in between touches.
pub fn candidates(scene: &Scene, visible: &[(usize, &Instance)]) -> Vec<Candidate> {
    let mut uses = vec![0u32; scene.grids.len()];
    visible.iter().for_each(|(_, instance)| uses[instance.grid] += 1);
    let bounds: Vec<VoxelBox> = (visible.par_iter())
        .map(|(_, instance)| scene.grids[instance.grid].bounds().expect("what is visible is not empty"))
        .collect();
    let lattice_of = |index: usize| {
        let instance = visible[index].1;
        let stands_still = instance.keyframes.is_empty() && uses[instance.grid] == 1;
        let lattice = stands_still.then(|| Lattice::of(&instance.world_from_grid)).flatten()?;
        let (min, max) = lattice.bounds(bounds[index].min, bounds[index].max);
        let far = IVec3::splat(MAX_COORDINATE);
        (min.cmpge(-far).all() && max.cmple(far).all()).then_some(lattice)
    };
    let lattices: Vec<Option<Lattice>> = (0..visible.len()).map(lattice_of).collect();
    let Some(first) = lattices.iter().position(Option::is_some) else { return Vec::new() };
    let spaces: Vec<Space> = visible.iter().zip(&bounds).map(|((_, instance), &of)| Space::of(instance, of)).collect();
    let others: Vec<usize> = (first..visible.len()).filter(|&index| lattices[index].is_none()).collect();
    let is_apart: Vec<bool> = (lattices.par_iter().enumerate())
        .map(|(index, lattice)| {
            let between = others.iter().take_while(|&&other| other < index);
            lattice.is_some() && !between.clone().any(|&other| spaces[index].touches(&spaces[other]))
        })
        .collect();
    // What is left out is in between for those that come after it.
    let mut left_out: Vec<usize> = Vec::new();
    let mut chosen = Vec::new();
    for (index, lattice) in lattices.into_iter().enumerate() {
        let Some(world_from_part) = lattice else { continue };
        if is_apart[index] && !left_out.iter().any(|&other| spaces[index].touches(&spaces[other])) {
            chosen.push(Candidate { instance: index, world_from_part });
        } else {
            left_out.push(index);
        }
    }
    chosen
}
