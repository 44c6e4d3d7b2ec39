//! What is copied of a grid, and the ways in which it can be turned when it is pasted.

use super::plan::check_range;
use super::sketch::Sketch;
use super::{DynamicScene, EditError};
use glam::IVec3;
use voxtrace_scene::Axis;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelBox, VoxelGrid};

/// Voxels that were copied: those of a box whose lowest corner is voxel 0 now.
#[derive(Clone, Debug, PartialEq)]
pub struct Clip {
    pub(super) voxels: VoxelGrid,
    pub(super) size: IVec3,
}

impl Clip {
    /// Voxels of a grid of one's own, from voxel 0 to before `size`; others are left out.
    pub fn new(mut voxels: VoxelGrid, size: IVec3) -> Self {
        let size = size.clamp(IVec3::ZERO, IVec3::splat(MAX_COORDINATE + 1));
        let own = VoxelBox { min: IVec3::ZERO, max: size };
        if voxels.bounds().is_some_and(|bounds| !own.contains(bounds.min) || !own.contains(bounds.max - 1)) {
            let beyond: Vec<IVec3> = voxels.voxels().map(|(at, _)| at).filter(|&at| !own.contains(at)).collect();
            beyond.into_iter().for_each(|at| _ = voxels.clear(at));
        }
        Self { voxels, size }
    }

    /// Whether a clip can be so large: its voxels count from 0, and turning may put any of them in the farthest corner.
    ///
    /// # Errors
    /// [`EditError::OutOfRange`] where it cannot.
    pub(super) fn check_size(size: IVec3) -> Result<(), EditError> {
        check_range(VoxelBox { min: IVec3::ZERO, max: size })
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
            let mut turned = clip.size;
            (turned[a], turned[b]) = (clip.size[b], clip.size[a]);
            clip.mapped(turned, |at, size| {
                let mut to = at;
                (to[a], to[b]) = (size[b] - 1 - at[b], at[a]);
                to
            })
        })
    }

    /// Mirrored along an axis.
    pub fn mirrored(&self, axis: Axis) -> Self {
        self.mapped(self.size, |at, size| {
            let mut to = at;
            to[axis as usize] = size[axis as usize] - 1 - at[axis as usize];
            to
        })
    }

    /// Of another size, with each voxel where `map` takes it from its place and the size now.
    fn mapped(&self, to: IVec3, map: impl Fn(IVec3, IVec3) -> IVec3) -> Self {
        let mut voxels = VoxelGrid::new();
        for (at, material) in self.voxels.voxels() {
            voxels.set(map(at, self.size), material);
        }
        Self { voxels, size: to }
    }
}

impl DynamicScene {
    /// Copies the voxels of a box of a grid.
    ///
    /// # Errors
    /// [`EditError::NoGrid`] where there is no such grid; [`EditError::OutOfRange`] where the box is so large that voxels which count from its corner
    /// would lie too far out.
    pub fn copy(&self, grid: u32, region: VoxelBox) -> Result<Clip, EditError> {
        self.check_grid(grid)?;
        Clip::check_size(region.size())?;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_clip_holds_what_lies_in_its_box_and_turns_with_it() {
        let mut voxels = VoxelGrid::new();
        (-1..5).for_each(|x| _ = voxels.set(IVec3::new(x, 0, 0), x as u16));
        let clip = Clip::new(voxels, IVec3::new(3, 2, 1));
        assert!(clip.voxels().voxels().map(|(_, material)| material).eq([0, 1, 2]));
        let turned = clip.turned(Axis::Z, 1);
        assert_eq!((turned.size(), turned.voxels().get(IVec3::new(1, 2, 0))), (IVec3::new(2, 3, 1), Some(2)));
        assert_eq!(turned.turned(Axis::Z, 3), clip);
        // A box without voxels stays one: pasted with what is empty in it, it would clear something.
        let none = Clip::new(VoxelGrid::new(), IVec3::new(0, 2, 5));
        assert_eq!(none.turned(Axis::Z, 1).size(), IVec3::new(2, 0, 5));
        assert_eq!(none.mirrored(Axis::X).size(), none.size());
    }
}
