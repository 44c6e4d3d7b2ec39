//! The faces of voxels that nothing covers, merged greedily to rectangles of one material (after Lysenko, "Meshing in a Minecraft
//! Game", 2012): within a layer of each brick first, then across bricks, along rows and then along columns.

use crate::brick::{BRICK_SIZE, Brick};
use crate::grid::{VoxelGrid, brick_of, local_of};
use crate::material::Material;
use crate::ray::{FACES, Face};
use glam::IVec3;
use rayon::prelude::*;

/// Both other axes of each axis, the lower first.
pub const OTHER_AXES: [[usize; 2]; 3] = [[1, 2], [0, 2], [0, 1]];
/// No material: the voxel is empty. No scene has so many.
const EMPTY: u16 = u16::MAX;

/// A rectangle of faces in one plane, all of one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FaceRectangle {
    /// Number of the [`Face`].
    face: u8,
    /// Coordinate of the plane along the face's axis.
    plane: i32,
    /// Index of the material.
    pub material: u16,
    /// First voxel along the two other axes, lower axis first.
    pub first: [i32; 2],
    /// Voxels along them.
    pub count: [i32; 2],
}

impl FaceRectangle {
    /// Where the rectangle looks.
    pub fn face(&self) -> Face {
        FACES[usize::from(self.face)]
    }

    /// The corners, in voxels, counter-clockwise as seen from outside.
    pub fn corners(&self) -> [IVec3; 4] {
        let axis = usize::from(self.face / 2);
        let ([a, b], [u, v], [width, height]) = (OTHER_AXES[axis], self.first, self.count);
        let corner = |u: i32, v: i32| {
            let mut corner = IVec3::ZERO;
            (corner[axis], corner[a], corner[b]) = (self.plane, u, v);
            corner
        };
        let (right, top) = (u + width, v + height);
        let corners = [corner(u, v), corner(right, v), corner(right, top), corner(u, top)];
        // The two other axes of y turn to −y.
        let turns_outwards = (self.face & 1 == 1) != (axis == 1);
        if turns_outwards { corners } else { [corners[0], corners[3], corners[2], corners[1]] }
    }
}

/// The faces of a grid that nothing covers, in an order that depends on the grid alone. A face towards another material is covered
/// where both are opaque. Where one of them lets light through, both have their face: then the surface around each material is closed.
///
/// # Panics
/// If a voxel's material is not one of `materials`.
pub fn face_rectangles(grid: &VoxelGrid, materials: &[Material]) -> Vec<FaceRectangle> {
    face_rectangles_while(grid, materials, &|| true).expect("nobody stops it")
}

/// As [`face_rectangles`], as long as they are `wanted`, which several threads ask, and which says no for good; `None` once they are not.
///
/// # Panics
/// As [`face_rectangles`].
pub fn face_rectangles_while(
    grid: &VoxelGrid,
    materials: &[Material],
    wanted: &(dyn Fn() -> bool + Sync),
) -> Option<Vec<FaceRectangle>> {
    let clear: Vec<bool> = materials.iter().map(Material::is_transmissive).collect();
    let bricks = grid.sorted_bricks();
    let of_brick = |(at, brick): &(IVec3, &Brick)| {
        let mut found = Vec::new();
        if wanted() {
            BrickFaces::new(grid, *at, brick, &clear).each(&mut |rectangle| found.push(rectangle));
        }
        found
    };
    let mut all: Vec<FaceRectangle> = bricks.par_iter().flat_map_iter(of_brick).collect();
    for along in [0, 1] {
        if !wanted() {
            return None;
        }
        join(&mut all, along);
    }
    wanted().then_some(all)
}

/// Joins rectangles that lie side by side `along` one of their axes and are alike across it.
fn join(all: &mut Vec<FaceRectangle>, along: usize) {
    let across = 1 - along;
    let row = |r: &FaceRectangle| (r.face, r.plane, r.material, r.first[across], r.count[across]);
    all.par_sort_unstable_by_key(|r| (row(r), r.first[along]));
    all.dedup_by(|next, last| {
        let is_beside = row(next) == row(last) && last.first[along] + last.count[along] == next.first[along];
        if is_beside {
            last.count[along] += next.count[along];
        }
        is_beside
    });
}

/// A brick with what is around it.
struct BrickFaces<'a> {
    grid: &'a VoxelGrid,
    low: IVec3,
    /// Material of each voxel, x fastest.
    materials: [u16; 512],
    clear: &'a [bool],
}

impl<'a> BrickFaces<'a> {
    fn new(grid: &'a VoxelGrid, at: IVec3, brick: &Brick, clear: &'a [bool]) -> Self {
        let mut materials = [EMPTY; 512];
        brick.voxels().for_each(|(local, material)| materials[place(local)] = material);
        Self { grid, low: at * BRICK_SIZE, materials, clear }
    }

    /// Whether the face of a material towards another one is seen.
    fn is_seen(&self, material: u16, front: u16) -> bool {
        let is_clear = |material: u16| self.clear[usize::from(material)];
        front == EMPTY || (material != front && (is_clear(material) || is_clear(front)))
    }

    fn each(&self, found: &mut impl FnMut(FaceRectangle)) {
        for (number, face) in (0..).zip(FACES) {
            let (axis, step) = (face.axis(), face.normal());
            let beside = self.grid.brick(brick_of(self.low + step * BRICK_SIZE));
            let [a, b] = OTHER_AXES[axis];
            for layer in 0..BRICK_SIZE {
                // Bit u of `rows[v]`: the face of the voxel at (u, v) is of this material and seen.
                let mut by_material: Vec<(u16, [u8; 8])> = Vec::new();
                for i in 0..64 {
                    let (u, v) = (i & 7, i >> 3);
                    let mut voxel = IVec3::ZERO;
                    (voxel[axis], voxel[a], voxel[b]) = (layer, u, v);
                    let material = self.materials[place(voxel)];
                    if material == EMPTY {
                        continue;
                    }
                    let front = voxel + step;
                    let is_inside = (0..BRICK_SIZE).contains(&front[axis]);
                    let front = match is_inside {
                        true => self.materials[place(front)],
                        false => beside.and_then(|brick| brick.get(local_of(front))).unwrap_or(EMPTY),
                    };
                    if !self.is_seen(material, front) {
                        continue;
                    }
                    let known = by_material.iter().position(|(other, _)| *other == material);
                    let index = known.unwrap_or_else(|| {
                        by_material.push((material, [0; 8]));
                        by_material.len() - 1
                    });
                    by_material[index].1[v as usize] |= 1 << u;
                }
                let plane = self.low[axis] + layer + i32::from(number & 1 == 1);
                for (material, rows) in by_material {
                    merge_bits(rows, &mut |first, count| {
                        let first = [self.low[a] + first[0], self.low[b] + first[1]];
                        found(FaceRectangle { face: number, plane, material, first, count });
                    });
                }
            }
        }
    }
}

fn place(local: IVec3) -> usize {
    (local.x | local.y << 3 | local.z << 6) as usize
}

/// Covers the set bits of eight rows with rectangles, first and size of which `found` gets: the longest run of a row, then as many rows
/// as hold it.
pub fn merge_bits(mut rows: [u8; 8], found: &mut impl FnMut([i32; 2], [i32; 2])) {
    for v in 0..8 {
        while rows[v] != 0 {
            let u = rows[v].trailing_zeros();
            let width = (rows[v] >> u).trailing_ones();
            let run = (((1u32 << width) - 1) << u) as u8;
            let height = rows[v..].iter().take_while(|row| **row & run == run).count();
            for row in &mut rows[v..v + height] {
                *row &= !run;
            }
            found([u as i32, v as i32], [width as i32, height as i32]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::VoxelBox;
    use glam::Vec3;
    use std::collections::BTreeMap;

    fn random(state: &mut u32) -> u32 {
        *state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        *state >> 8
    }

    #[test]
    fn rectangles_cover_every_bit_once() {
        let mut state = 1u32;
        for _ in 0..1000 {
            let rows = [0; 8].map(|_: u8| (random(&mut state) | random(&mut state) >> 3) as u8);
            let mut covered = [0u8; 8];
            merge_bits(rows, &mut |first, count| {
                for v in first[1]..first[1] + count[1] {
                    for u in first[0]..first[0] + count[0] {
                        assert_eq!(covered[v as usize] >> u & 1, 0, "covered twice");
                        covered[v as usize] |= 1 << u;
                    }
                }
            });
            assert_eq!(covered, rows);
        }
    }

    #[test]
    fn a_full_layer_is_one_rectangle() {
        let mut all = Vec::new();
        merge_bits([0xff; 8], &mut |first, count| all.push((first, count)));
        assert_eq!(all, [([0, 0], [8, 8])]);
    }

    /// Every face that is seen, by its voxel and number, from its definition.
    fn faces_one_by_one(grid: &VoxelGrid, materials: &[Material]) -> BTreeMap<([i32; 3], u32), u16> {
        let mut faces = BTreeMap::new();
        for (voxel, material) in grid.voxels() {
            for face in FACES {
                let is_seen = grid.get(voxel + face.normal()).is_none_or(|front| {
                    let is_clear = |index: u16| materials[usize::from(index)].is_transmissive();
                    front != material && (is_clear(front) || is_clear(material))
                });
                if is_seen {
                    faces.insert((voxel.to_array(), face as u32), material);
                }
            }
        }
        faces
    }

    /// The faces that rectangles cover.
    fn faces_of(rectangles: &[FaceRectangle]) -> BTreeMap<([i32; 3], u32), u16> {
        let mut faces = BTreeMap::new();
        for rectangle in rectangles {
            let (face, corners) = (rectangle.face(), rectangle.corners());
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[1]);
            assert_eq!(normal.signum(), face.normal(), "counter-clockwise from outside");
            let min = corners.into_iter().reduce(IVec3::min).unwrap();
            let behind = if face as u32 & 1 == 1 { face.normal() } else { IVec3::ZERO };
            let [a, b] = OTHER_AXES[face.axis()];
            for u in 0..rectangle.count[0] {
                for v in 0..rectangle.count[1] {
                    let mut voxel = min - behind;
                    voxel[a] += u;
                    voxel[b] += v;
                    let old = faces.insert((voxel.to_array(), face as u32), rectangle.material);
                    assert_eq!(old, None, "{voxel} is covered twice");
                }
            }
        }
        faces
    }

    #[test]
    fn rectangles_are_the_faces_that_are_seen_each_once() {
        let glass = Material::glass(1.5, 0.0);
        let materials = [Material::diffuse(Vec3::ONE), glass, Material::diffuse(Vec3::ZERO), glass];
        let (mut grid, mut state) = (VoxelGrid::new(), 7);
        for i in 0..20 * 20 * 20 {
            let voxel = IVec3::new(i % 20, i / 20 % 20, i / 400) - 9;
            if !random(&mut state).is_multiple_of(5) {
                grid.set(voxel, (random(&mut state) % 4) as u16);
            }
        }
        let wanted = faces_one_by_one(&grid, &materials);
        assert!(wanted.len() > 10_000);
        let found = face_rectangles(&grid, &materials);
        assert_eq!(faces_of(&found), wanted);
        // A rectangle that is lost, or of another material, is seen.
        assert_ne!(faces_of(&found[1..]), wanted);
        let mut changed = found;
        changed[0].material ^= 1;
        assert_ne!(faces_of(&changed), wanted);
    }

    #[test]
    fn a_box_over_many_bricks_has_six_rectangles_and_one_more_for_each_patch_of_colour() {
        let mut grid = VoxelGrid::new();
        grid.fill_box(VoxelBox { min: IVec3::splat(-5), max: IVec3::new(40, 20, 33) }, 0);
        let materials = [Material::diffuse(Vec3::ONE), Material::diffuse(Vec3::X)];
        assert_eq!(face_rectangles(&grid, &materials).len(), 6);
        // A patch in the middle of the top: the rest around it is cut, no more than into eight.
        grid.fill_box(VoxelBox { min: IVec3::new(8, 8, 32), max: IVec3::new(16, 16, 33) }, 1);
        let found = face_rectangles(&grid, &materials);
        assert_eq!(found.iter().filter(|rectangle| rectangle.material == 1).count(), 1);
        assert!((10..=14).contains(&found.len()), "{}", found.len());
    }
}
