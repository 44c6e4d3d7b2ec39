//! What a face is to somebody who draws it out: the voxels around one that lie in one plane, are of one material and are seen from one side.

use rustc_hash::FxHashSet;
use voxtrace::PackedScene;
use voxtrace::dynamic::Edit;
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::ray::Face;

/// Most voxels of a face.
pub const MOST: usize = 1 << 16;

/// Voxels of a plane.
#[derive(Clone, Debug, PartialEq)]
pub struct FaceRegion {
    /// The face.
    pub face: Face,
    /// The voxels, as boxes of one row each.
    pub rows: Vec<VoxelBox>,
    /// The edges around it, in the plane of the face: corners of voxels.
    pub outline: Vec<[Vec3; 2]>,
}

impl FaceRegion {
    /// The region around a voxel, `None` where it is larger than can be drawn out at once.
    pub fn around(scene: &PackedScene, grid: u32, start: IVec3, face: Face) -> Option<Self> {
        let geometry = scene.geometry();
        let packed = *scene.grids().get(grid as usize)?;
        let of = |voxel: IVec3| geometry.material_at(&packed, voxel);
        let material = of(start)?;
        let is_in = |voxel: IVec3| of(voxel) == Some(material) && of(voxel + face.normal()).is_none();
        let axis = face.axis();
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let step = |axis: usize| {
            let mut step = IVec3::ZERO;
            step[axis] = 1;
            step
        };
        let steps = [step(u), -step(u), step(v), -step(v)];
        let mut found = FxHashSet::from_iter([start]);
        let mut waiting = vec![start];
        while let Some(voxel) = waiting.pop() {
            for beside in steps.map(|step| voxel + step) {
                if !found.contains(&beside) && is_in(beside) {
                    if found.len() == MOST {
                        return None;
                    }
                    found.insert(beside);
                    waiting.push(beside);
                }
            }
        }
        let mut cells: Vec<IVec3> = found.iter().copied().collect();
        cells.sort_unstable_by_key(|cell| (cell[v], cell[u]));
        let mut rows: Vec<VoxelBox> = Vec::new();
        for &cell in &cells {
            match rows.last_mut() {
                Some(last) if last.max == cell + step(v) + step(axis) => last.max[u] += 1,
                _ => rows.push(VoxelBox { min: cell, max: cell + 1 }),
            }
        }
        let outline = outline_of(&cells, &found, face, (u, v));
        Some(Self { face, rows, outline })
    }

    /// Voxels.
    pub fn count(&self) -> usize {
        self.rows.iter().map(|row| row.size().element_product() as usize).sum()
    }

    /// What draws it out so far, or pushes it in.
    pub fn edits(&self, distance: i32) -> Vec<Edit> {
        self.rows.iter().map(|&layer| Edit::Extrude { layer, face: self.face, distance }).collect()
    }
}

/// The edges of a region, those in one line joined.
fn outline_of(cells: &[IVec3], found: &FxHashSet<IVec3>, face: Face, (u, v): (usize, usize)) -> Vec<[Vec3; 2]> {
    let mut edges: Vec<[IVec3; 2]> = Vec::new();
    let lift = face.normal().max(IVec3::ZERO);
    for (across, along) in [(u, v), (v, u)] {
        let mut cells = cells.to_vec();
        cells.sort_unstable_by_key(|cell| (cell[across], cell[along]));
        for side in [0, 1] {
            // The last edge of this side: those of a row follow each other.
            let mut last: Option<usize> = None;
            for &cell in &cells {
                let mut beside = cell;
                beside[across] += 2 * side - 1;
                if found.contains(&beside) {
                    continue;
                }
                let mut from = cell + lift;
                from[across] += side;
                let mut to = from;
                to[along] += 1;
                match last.filter(|&last| edges[last][1] == from) {
                    Some(last) => edges[last][1] = to,
                    None => {
                        last = Some(edges.len());
                        edges.push([from, to]);
                    }
                }
            }
        }
    }
    edges.into_iter().map(|edge| edge.map(|corner| corner.as_vec3())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::{Material, Scene, VoxelGrid};

    #[test]
    fn a_face_is_what_is_connected_seen_and_of_one_material() {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(12, 10, 3) }, 0);
        // A wall on it, a strip of another material, and an island.
        grid.fill_box(VoxelBox { min: IVec3::new(5, 0, 3), max: IVec3::new(6, 10, 6) }, 0);
        grid.fill_box(VoxelBox { min: IVec3::new(0, 4, 2), max: IVec3::new(3, 5, 3) }, 1);
        grid.fill_box(VoxelBox { min: IVec3::new(20, 0, 0), max: IVec3::new(22, 2, 3) }, 0);
        let scene = Scene::from_grid("faces", grid, vec![Material::default(); 2]);
        let scene = PackedScene::pack(&scene).unwrap();
        let region = FaceRegion::around(&scene, 0, IVec3::new(1, 1, 2), Face::PosZ).unwrap();
        assert_eq!(region.count(), 5 * 10 - 3);
        assert!(region.rows.iter().all(|row| row.min.z == 2 && row.max.z == 3 && row.max.x <= 5));
        assert_eq!(region.rows.len(), 10, "a row is one box");
        let around: f32 = region.outline.iter().map(|[from, to]| from.distance(*to)).sum();
        assert_eq!(around, 2.0 * (5.0 + 10.0) + 2.0 * 3.0, "the notch of the strip, too");
        assert_eq!(region.outline.len(), 8);
        assert!(region.outline.iter().flatten().all(|corner| corner.z == 3.0));
        let side = FaceRegion::around(&scene, 0, IVec3::new(0, 0, 0), Face::NegX).unwrap();
        assert_eq!((side.count(), side.outline.iter().flatten().all(|corner| corner.x == 0.0)), (29, true));
        assert_eq!(region.edits(3).len(), 10);
    }
}
