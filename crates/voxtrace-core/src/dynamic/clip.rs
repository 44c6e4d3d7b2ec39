//! What is copied of a grid, and the ways in which it can be turned when it is pasted.

use super::sketch::Sketch;
use super::{DynamicScene, EditError};
use glam::IVec3;
use voxtrace_scene::Axis;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::{VoxelBox, VoxelGrid};

/// Voxels that were copied: those of a box whose lowest corner is voxel 0 now.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    pub(super) voxels: VoxelGrid,
    pub(super) size: IVec3,
}

impl Clip {
    /// Voxels of a grid of one's own, from voxel 0 to before `size`.
    pub fn new(voxels: VoxelGrid, size: IVec3) -> Self {
        Self { voxels, size: size.max(IVec3::ZERO) }
    }

    /// The voxels.
    pub fn voxels(&self) -> &VoxelGrid {
        &self.voxels
    }

    /// Edges of the box, in voxels.
    pub fn size(&self) -> IVec3 {
        self.size
    }

    /// Turned by so many quarters about an axis, counterclockwise as seen from its positive end.
    pub fn turned(&self, axis: Axis, quarters: i32) -> Self {
        (0..quarters.rem_euclid(4)).fold(self.clone(), |clip, _| {
            let (a, b) = ((axis as usize + 1) % 3, (axis as usize + 2) % 3);
            clip.mapped(|at, size| {
                let mut to = at;
                (to[a], to[b]) = (size[b] - 1 - at[b], at[a]);
                to
            })
        })
    }

    /// Mirrored along an axis.
    pub fn mirrored(&self, axis: Axis) -> Self {
        self.mapped(|at, size| {
            let mut to = at;
            to[axis as usize] = size[axis as usize] - 1 - at[axis as usize];
            to
        })
    }

    fn mapped(&self, map: impl Fn(IVec3, IVec3) -> IVec3) -> Self {
        let mut voxels = VoxelGrid::new();
        for (at, material) in self.voxels.voxels() {
            voxels.set(map(at, self.size), material);
        }
        let (low, high) = (map(IVec3::ZERO, self.size), map(self.size - 1, self.size));
        Self { voxels, size: low.max(high) + 1 }
    }
}

impl DynamicScene {
    /// Copies the voxels of a box of a grid.
    ///
    /// # Errors
    /// [`EditError::NoGrid`] where there is no such grid.
    pub fn copy(&self, grid: u32, region: VoxelBox) -> Result<Clip, EditError> {
        self.check_grid(grid)?;
        let mut voxels = VoxelGrid::new();
        let (geometry, packed) = (self.geometry(), &self.geometry().grids[grid as usize]);
        if region.size().min_element() > 0 {
            for at in geometry.bricks_in(grid as usize, super::plan::brick_box(super::plan::within_range(region))) {
                let Some(record) = geometry.find_brick(packed, at * BRICK_SIZE) else { continue };
                for (local, material) in geometry.decode_brick(packed, record).voxels() {
                    let voxel = at * BRICK_SIZE + local;
                    if region.contains(voxel) {
                        voxels.set(voxel - region.min, material);
                    }
                }
            }
        }
        Ok(Clip { voxels, size: region.size() })
    }
}

/// Writes a clip with its lowest corner at a voxel; its empty voxels too, where `with_empty`.
pub(super) fn paste(sketch: &mut Sketch, clip: &Clip, at: IVec3, with_empty: bool) {
    if with_empty {
        for z in 0..clip.size.z {
            for y in 0..clip.size.y {
                (0..clip.size.x).for_each(|x| sketch.set(at + IVec3::new(x, y, z), None));
            }
        }
    }
    clip.voxels.voxels().for_each(|(local, material)| sketch.set(at + local, Some(material)));
}
