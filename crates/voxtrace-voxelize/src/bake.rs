//! Instances baked into the lattice of the world: what is turned, scaled or stands between voxels is sampled anew there, so that
//! formats of whole voxels can hold it; and a whole scene as one grid.
//!
//! A voxel of the world takes the material of the voxel that its centre lies in. A surface one voxel thick stays closed for paths
//! through faces that way, as its thickness is at least the largest component of its normal (Andres, Acharya and Sibata, "Discrete
//! Analytical Hyperplanes", 1997). Where a grid is made smaller, voxels whose own centre falls into an empty place fill it, so that
//! thin walls stay.

use crate::limits::Limits;
use glam::{DMat3, DVec3, IVec3};
use rayon::prelude::*;
use std::sync::Arc;
use voxtrace_core::packed::{Lattice, Scatter};
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelBox, VoxelGrid};
use voxtrace_scene::scene::{Instance, Scene};
use voxtrace_scene::transform::Transform;

/// Scale below which a grid is made smaller: that of a rotation is 1 but for rounding.
const SMALLER: f32 = 0.999;

/// A scene could not be baked.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum BakeError {
    /// An instance is turned, scaled or stands between voxels.
    #[error("instance {instance} {name:?} does not stand on the lattice of voxels")]
    OffLattice {
        /// Index of the instance.
        instance: usize,
        /// Its name.
        name: String,
    },
    /// More voxels than allowed.
    #[error("{needed} voxels, more than {limit}")]
    TooLarge {
        /// About how many there would be.
        needed: u64,
        /// Most that are allowed.
        limit: u64,
    },
    /// The voxels lie farther apart than a grid reaches.
    #[error("voxels that lie farther apart than a grid reaches, {MAX_COORDINATE} voxels")]
    TooFar,
    /// Nobody wants it any more.
    #[error("stopped")]
    Stopped,
}

/// What baking did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Baked {
    /// Instances that were sampled anew.
    pub instances: usize,
    /// Those of them that moved, and stand still now as in their first frame.
    pub stilled: usize,
}

/// Samples every instance that does not stand on the lattice of the world anew, hidden ones too; each becomes a grid of its own at a whole
/// translation. Those on the lattice stay as they are. Grids that nothing shows any more are dropped.
///
/// # Errors
/// [`BakeError::TooLarge`] beyond `limits.voxels`, [`BakeError::TooFar`]; the scene is then unchanged.
pub fn bake(scene: &mut Scene, limits: &Limits) -> Result<Baked, BakeError> {
    let is_off = |instance: &&Instance| {
        let keys = instance.keyframes.iter().map(|key| &key.world_from_grid);
        keys.chain([&instance.world_from_grid]).any(|placed| Lattice::of(placed).is_none())
    };
    let mut needed = 0.0;
    for instance in scene.instances.iter().filter(is_off) {
        let growth = f64::from(instance.world_from_grid.scale()).powi(3);
        needed += scene.grids[instance.grid].count() as f64 * growth.max(1.0);
    }
    if needed > limits.voxels as f64 {
        return Err(BakeError::TooLarge { needed: needed as u64, limit: limits.voxels });
    }
    let mut baked = Baked::default();
    let mut resampled = Vec::new();
    for (index, instance) in scene.instances.iter().enumerate().filter(|(_, instance)| is_off(instance)) {
        resampled.push((index, resample(&scene.grids[instance.grid], &instance.world_from_grid)?));
    }
    for (index, (grid, corner)) in resampled {
        let instance = &mut scene.instances[index];
        baked.instances += 1;
        baked.stilled += usize::from(instance.keyframes.len() > 1);
        instance.keyframes.clear();
        instance.grid = scene.grids.len();
        instance.world_from_grid = Transform::from_translation(corner.as_vec3());
        scene.grids.push(Arc::new(grid));
    }
    if baked.instances > 0 {
        scene.attachments.clear();
        scene.clips.clear();
        drop_unused_grids(scene);
    }
    Ok(baked)
}

/// The voxels of all visible instances as one grid, in the world but for a translation, which comes with it. Where several have a voxel,
/// the first of them keeps it.
///
/// # Errors
/// [`BakeError::OffLattice`], [`BakeError::TooFar`].
pub fn flattened(scene: &Scene) -> Result<(VoxelGrid, IVec3), BakeError> {
    flattened_while(scene, &|| true)
}

/// As [`flattened`], as long as it is `wanted`, which says no for good.
///
/// # Errors
/// As [`flattened`], and [`BakeError::Stopped`].
#[doc(hidden)]
pub fn flattened_while(scene: &Scene, wanted: &dyn Fn() -> bool) -> Result<(VoxelGrid, IVec3), BakeError> {
    let mut placed = Vec::new();
    for (index, instance) in scene.instances.iter().enumerate().filter(|(_, one)| scene.is_visible(one)) {
        let way = Lattice::of(&instance.world_from_grid)
            .ok_or_else(|| BakeError::OffLattice { instance: index, name: instance.name.clone() })?;
        let grid = &scene.grids[instance.grid];
        if let Some(bounds) = grid.bounds() {
            placed.push((grid, way, way.bounds(bounds.min, bounds.max)));
        }
    }
    let bounds = placed.iter().map(|(_, _, bounds)| *bounds).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
    let Some((min, max)) = bounds else { return Ok((VoxelGrid::new(), IVec3::ZERO)) };
    let corner = corner_of(VoxelBox { min, max })?;
    let mut scatter = Scatter::default();
    // Of a voxel that comes twice the last counts.
    for (grid, way, _) in placed.into_iter().rev() {
        for (at, brick) in grid.sorted_bricks() {
            let low = at * BRICK_SIZE;
            if !wanted() {
                return Err(BakeError::Stopped);
            }
            brick.voxels().for_each(|(local, material)| scatter.set(way.voxel(low + local) - corner, material));
        }
    }
    Ok((VoxelGrid::from_bricks(scatter.finish()), corner))
}

/// Makes one grid, and one instance without a name, of all visible instances. Hidden ones are dropped, and with them layers and groups.
///
/// # Errors
/// As [`flattened`]; the scene is then unchanged.
pub fn flatten(scene: &mut Scene) -> Result<(), BakeError> {
    let (grid, corner) = flattened(scene)?;
    scene.grids.clear();
    scene.instances.clear();
    scene.layers.clear();
    scene.groups.clear();
    scene.attachments.clear();
    scene.clips.clear();
    scene.add_instance(grid, Transform::from_translation(corner.as_vec3()));
    Ok(())
}

/// The translation, of whole bricks, that brings a box within the reach of a grid.
fn corner_of(bounds: VoxelBox) -> Result<IVec3, BakeError> {
    let reach = IVec3::splat(MAX_COORDINATE);
    if bounds.min.cmpge(-reach).all() && bounds.max.cmple(reach).all() {
        return Ok(IVec3::ZERO);
    }
    if bounds.size().cmpge(reach - BRICK_SIZE).any() {
        return Err(BakeError::TooFar);
    }
    Ok(bounds.min.div_euclid(IVec3::splat(BRICK_SIZE)) * BRICK_SIZE)
}

/// A similarity in double precision: centres of voxels are compared with planes of others.
struct Placed {
    linear: DMat3,
    inverse: DMat3,
    translation: DVec3,
}

impl Placed {
    fn of(transform: &Transform) -> Self {
        let linear = transform.linear.as_dmat3();
        Self { linear, inverse: linear.inverse(), translation: transform.translation.as_dvec3() }
    }

    fn world(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.translation
    }

    fn grid(&self, point: DVec3) -> DVec3 {
        self.inverse * (point - self.translation)
    }

    /// The voxels of the world that a box of the grid's voxels may reach.
    fn bounds(&self, min: IVec3, max: IVec3) -> Option<VoxelBox> {
        let (centre, half) = ((min + max).as_dvec3() * 0.5, (max - min).as_dvec3() * 0.5);
        let reach =
            DMat3::from_cols(self.linear.x_axis.abs(), self.linear.y_axis.abs(), self.linear.z_axis.abs()) * half;
        let (low, high) = (self.world(centre) - reach, self.world(centre) + reach);
        // Numbers of half the range, so that differences do not overflow.
        let is_near = low.abs().max(high.abs()).max_element() < f64::from(1 << 29);
        is_near.then(|| VoxelBox { min: low.floor().as_ivec3(), max: high.ceil().as_ivec3() })
    }
}

/// A grid sampled on the lattice of the world, and the translation of what comes of it.
fn resample(grid: &VoxelGrid, transform: &Transform) -> Result<(VoxelGrid, IVec3), BakeError> {
    let Some(bounds) = grid.bounds() else { return Ok((VoxelGrid::new(), IVec3::ZERO)) };
    let placed = Placed::of(transform);
    let corner = placed.bounds(bounds.min, bounds.max).ok_or(BakeError::TooFar).and_then(corner_of)?;
    let bricks = grid.sorted_bricks();
    let mut scatter = Scatter::default();
    // As many bricks at once as their voxels take some megabytes.
    for part in bricks.chunks(4096) {
        if transform.scale() < SMALLER {
            let forward: Vec<Vec<_>> = part.par_iter().map(|(at, brick)| centres(&placed, *at, brick)).collect();
            forward.into_iter().flatten().for_each(|(voxel, material)| scatter.set_if_empty(voxel - corner, material));
        }
        let sampled: Vec<Vec<_>> = part.par_iter().map(|(at, brick)| sample(&placed, *at, brick)).collect();
        sampled.into_iter().flatten().for_each(|(voxel, material)| scatter.set(voxel - corner, material));
    }
    Ok((VoxelGrid::from_bricks(scatter.finish()), corner))
}

/// The voxels of the world that the centres of a brick's voxels lie in.
fn centres(placed: &Placed, at: IVec3, brick: &Brick) -> Vec<(IVec3, u16)> {
    let centre = |local: IVec3| placed.world((at * BRICK_SIZE + local).as_dvec3() + 0.5).floor().as_ivec3();
    brick.voxels().map(|(local, material)| (centre(local), material)).collect()
}

/// The voxels of the world whose centres lie in a brick's voxels.
fn sample(placed: &Placed, at: IVec3, brick: &Brick) -> Vec<(IVec3, u16)> {
    let low = at * BRICK_SIZE;
    let (min, max) = brick.extent();
    let Some(bounds) = placed.bounds(low + min, low + max) else { return Vec::new() };
    let mut found = Vec::new();
    for z in bounds.min.z..bounds.max.z {
        for y in bounds.min.y..bounds.max.y {
            for x in bounds.min.x..bounds.max.x {
                let voxel = IVec3::new(x, y, z);
                let local = placed.grid(voxel.as_dvec3() + 0.5).floor().as_ivec3() - low;
                let is_inside = local.cmpge(min).all() && local.cmplt(max).all();
                if let Some(material) = is_inside.then(|| brick.get(local)).flatten() {
                    found.push((voxel, material));
                }
            }
        }
    }
    found
}

/// Drops grids that no instance shows in any frame.
fn drop_unused_grids(scene: &mut Scene) {
    let mut new_index = vec![None; scene.grids.len()];
    let mut kept = Vec::new();
    let mut keep = |index: &mut usize| {
        *index = *new_index[*index].get_or_insert_with(|| {
            kept.push(scene.grids[*index].clone());
            kept.len() - 1
        });
    };
    for instance in &mut scene.instances {
        keep(&mut instance.grid);
        instance.keyframes.iter_mut().for_each(|key| keep(&mut key.grid));
    }
    scene.grids = kept;
}

#[cfg(test)]
mod tests;
