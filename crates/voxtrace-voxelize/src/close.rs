//! Morphological closing with a cube as structuring element: dilation, then erosion (Serra, "Image Analysis and Mathematical
//! Morphology", 1982). Holes narrower than the cube are filled; outer surfaces do not grow, and slanted ones keep their
//! thickness.

use glam::{IVec3, Vec3};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::Arc;
use voxtrace_scene::brick::{BRICK_SIZE, voxel_of};
use voxtrace_scene::grid::{VoxelGrid, brick_of};
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::Scene;

/// Largest radius: a row of a tile and its surroundings then fits into 128 bits.
pub const LARGEST_RADIUS: u32 = 16;
/// Voxels along an edge of the tiles that are processed in parallel.
const TILE: i32 = 32;

/// Closes the holes of every grid that a cube with an edge of 2 `radius` + 1 voxels does not fit into; each grid is closed on its
/// own. `radius` is clamped to 1 to [`LARGEST_RADIUS`]. Returns the number of new voxels. Each takes the material of the nearest
/// voxel; of several as near, the one whose colour is nearest to their mean.
pub fn close(scene: &mut Scene, radius: u32) -> u64 {
    let cube = Cube::new(radius.clamp(1, LARGEST_RADIUS) as i32);
    let mut added = 0;
    for grid in &mut scene.grids {
        let new = closing(grid, &scene.materials, &cube);
        added += new.len() as u64;
        if !new.is_empty() {
            let grid = Arc::make_mut(grid);
            for (voxel, material) in new {
                grid.set(voxel, material);
            }
        }
    }
    added
}

/// The structuring element: the offsets of at most `radius` along each axis.
struct Cube {
    radius: i32,
    /// All offsets but zero, the nearest first, with their squared lengths.
    steps: Vec<(i32, IVec3)>,
}

impl Cube {
    fn new(radius: i32) -> Self {
        let span = || -radius..=radius;
        let all = span().flat_map(|z| span().flat_map(move |y| span().map(move |x| IVec3::new(x, y, z))));
        let mut steps: Vec<_> = all.map(|step| (step.length_squared(), step)).filter(|step| step.0 > 0).collect();
        steps.sort_by_key(|&(square, step)| (square, step.z, step.y, step.x));
        Self { radius, steps }
    }
}

/// The voxels that closing adds to a grid, with their materials.
fn closing(grid: &VoxelGrid, materials: &[Material], cube: &Cube) -> Vec<(IVec3, u16)> {
    let bricks = grid.sorted_bricks();
    let tile_of = |brick: IVec3| brick.div_euclid(IVec3::splat(TILE / BRICK_SIZE));
    let near = |brick: IVec3| {
        // Bricks as far away as the cube reaches.
        let around = (cube.radius + BRICK_SIZE - 1) / BRICK_SIZE;
        let steps = (0..27).map(move |i| (IVec3::new(i % 3, i / 3 % 3, i / 9) - 1) * around);
        steps.map(move |step| tile_of(brick + step).to_array())
    };
    let tiles: BTreeSet<[i32; 3]> = bricks.iter().flat_map(|&(at, _)| near(at)).collect();
    let tiles: Vec<IVec3> = tiles.into_iter().map(IVec3::from_array).collect();
    let new = tiles.par_iter().map(|&tile| {
        let window = Window::new(grid, tile * TILE, cube);
        let added = window.closed(cube);
        let voxels = added.into_iter().map(|at| (at, window.material(grid, materials, at, cube)));
        voxels.collect::<Vec<_>>()
    });
    new.collect::<Vec<_>>().concat()
}

/// The occupancy of a tile and its surroundings, two radii wide: a row of bits along x for each y and z.
struct Window {
    /// The lowest voxel of the window.
    low: IVec3,
    /// Voxels along each edge, at most 96.
    edge: usize,
    rows: Vec<u128>,
}

impl Window {
    fn new(grid: &VoxelGrid, tile: IVec3, cube: &Cube) -> Self {
        let (low, edge) = (tile - 2 * cube.radius, (TILE + 4 * cube.radius) as usize);
        let mut window = Self { low, edge, rows: vec![0; edge * edge] };
        let first = brick_of(low);
        let size = brick_of(low + edge as i32 - 1) - first + 1;
        for i in 0..size.element_product() {
            let at = first + IVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y));
            let Some(brick) = grid.brick(at) else { continue };
            for (block, &mask) in brick.occupancy().iter().enumerate() {
                // Rows of four voxels.
                for row in (0..16).filter(|row| mask >> (4 * row) & 15 != 0) {
                    let local = at * BRICK_SIZE + voxel_of(block, 4 * row) - low;
                    if local.y < 0 || local.z < 0 || local.y >= edge as i32 || local.z >= edge as i32 {
                        continue;
                    }
                    let bits = u128::from(mask >> (4 * row) & 15);
                    let bits = if local.x < 0 { bits >> -local.x } else { bits << local.x };
                    window.rows[local.z as usize * edge + local.y as usize] |= bits;
                }
            }
        }
        let inside = u128::MAX >> (u128::BITS as usize - edge);
        window.rows.iter_mut().for_each(|row| *row &= inside);
        window
    }

    /// The voxels that closing adds to the tile in the middle, in order.
    fn closed(&self, cube: &Cube) -> Vec<IVec3> {
        let (edge, reach) = (self.edge, cube.radius as usize);
        if self.rows.iter().all(|&row| row == 0) {
            return Vec::new();
        }
        let mut dilated = self.dilated(&self.rows, reach..edge - reach, reach);
        // Eroding the voxels is dilating what is empty.
        dilated.iter_mut().for_each(|row| *row = !*row);
        let empty = self.dilated(&dilated, 2 * reach..edge - 2 * reach, reach);
        let tile = u128::from(u32::MAX) << (2 * reach);
        let mut added = Vec::new();
        for (z, y) in (2 * reach..edge - 2 * reach).flat_map(|z| (2 * reach..edge - 2 * reach).map(move |y| (z, y))) {
            let mut new = !empty[z * edge + y] & !self.rows[z * edge + y] & tile;
            while new != 0 {
                added.push(self.low + IVec3::new(new.trailing_zeros() as i32, y as i32, z as i32));
                new &= new - 1;
            }
        }
        added
    }

    /// Rows dilated by a cube, for y and z in `range`, which must be at least `radius` away from the window's border.
    fn dilated(&self, rows: &[u128], range: Range<usize>, radius: usize) -> Vec<u128> {
        let edge = self.edge;
        let wide: Vec<u128> =
            rows.iter().map(|row| (0..=radius).fold(0, |wide, step| wide | row << step | row >> step)).collect();
        let join = |rows: &[u128], at: usize, stride: usize| {
            (at - radius * stride..=at + radius * stride).step_by(stride).fold(0, |joined, at| joined | rows[at])
        };
        let (mut deep, mut high) = (vec![0; rows.len()], vec![0; rows.len()]);
        for (z, y) in (range.start - radius..range.end + radius).flat_map(|z| range.clone().map(move |y| (z, y))) {
            deep[z * edge + y] = join(&wide, z * edge + y, 1);
        }
        for (z, y) in range.clone().flat_map(|z| range.clone().map(move |y| (z, y))) {
            high[z * edge + y] = join(&deep, z * edge + y, edge);
        }
        high
    }

    fn is_set(&self, voxel: IVec3) -> bool {
        let local = voxel - self.low;
        self.rows[local.z as usize * self.edge + local.y as usize] >> local.x & 1 == 1
    }

    /// The material of a new voxel.
    fn material(&self, grid: &VoxelGrid, materials: &[Material], voxel: IVec3, cube: &Cube) -> u16 {
        let set = || cube.steps.iter().filter(|(_, step)| self.is_set(voxel + *step));
        // The cube around a new voxel always holds a voxel, else closing would not have added it.
        let nearest = set().next().map_or(0, |&(square, _)| square);
        let around = set().take_while(|&&(square, _)| square == nearest);
        let around: Vec<u16> = around.filter_map(|&(_, step)| grid.get(voxel + step)).collect();
        let color = |material: &u16| materials.get(usize::from(*material)).map_or(Vec3::ZERO, |m| m.base_color);
        let mean = around.iter().map(color).sum::<Vec3>() / around.len().max(1) as f32;
        let distance = |material: &u16| color(material).distance_squared(mean);
        around.into_iter().min_by(|a, b| distance(a).total_cmp(&distance(b)).then(a.cmp(b))).unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::material::linear_color;

    fn scene(voxels: impl IntoIterator<Item = (IVec3, u16)>) -> Scene {
        let mut grid = VoxelGrid::new();
        for (voxel, material) in voxels {
            grid.set(voxel, material);
        }
        let materials = [[10, 10, 10], [250, 0, 0], [200, 0, 0], [0, 0, 250]];
        Scene::from_grid("", grid, materials.map(|color| Material::diffuse(linear_color(color))).to_vec())
    }

    fn voxels(scene: &Scene) -> BTreeSet<[i32; 3]> {
        scene.grids[0].voxels().map(|(voxel, _)| voxel.to_array()).collect()
    }

    /// A plane across the borders of bricks and tiles with some of its voxels missing.
    fn plane(is_there: impl Fn(i32, i32) -> bool) -> Scene {
        let all = (-40..40).flat_map(|y| (-40..40).map(move |x| (x, y)));
        scene(all.filter(|&(x, y)| is_there(x, y)).map(|(x, y)| (IVec3::new(x, y, 31), 1)))
    }

    #[test]
    fn a_plane_with_holes_is_closed_and_grows_nowhere() {
        for radius in [1, 2, 5, 16] {
            let holes = |x: i32, y: i32| x.rem_euclid(9) == 4 && y.rem_euclid(7) == 3;
            let mut found = plane(|x, y| !holes(x, y));
            let added = close(&mut found, radius);
            let whole = voxels(&plane(|_, _| true));
            assert!(voxels(&found) == whole, "{radius}");
            assert_eq!(added, whole.len() as u64 - plane(|x, y| !holes(x, y)).grids[0].count());
            assert_eq!(close(&mut found, radius), 0, "what is closed stays as it is");
        }
    }

    #[test]
    fn a_hole_that_the_cube_enters_stays_open() {
        let closed = |radius: i32, width: i32| {
            let mut found = plane(|x, y| !((3..3 + width).contains(&x) && (-5..-5 + width).contains(&y)));
            close(&mut found, radius as u32);
            found.grids[0].count() == 80 * 80
        };
        for radius in [1, 2, 4] {
            assert!(closed(radius, 2 * radius) && !closed(radius, 2 * radius + 1), "{radius}");
        }
    }

    #[test]
    fn slanted_planes_keep_their_thickness() {
        for normal in [[1, 0, 7], [1, 1, 1], [3, 2, 5], [0, 1, 1], [1, -1, 2], [-4, 9, -1]].map(IVec3::from_array) {
            let all = (0..36 * 36 * 36).map(|i| IVec3::new(i % 36, i / 36 % 36, i / 1296));
            let thickness = normal.abs().element_sum();
            let middle = normal.dot(IVec3::splat(18));
            let mut found =
                scene(all.filter(|&at| (0..thickness).contains(&(normal.dot(at) - middle))).map(|at| (at, 0)));
            assert_eq!(close(&mut found, 3), 0, "{normal}");
        }
    }

    #[test]
    fn every_tile_closes_as_the_definition_says() {
        let random = |voxel: IVec3| {
            let [x, y, z] = voxel.to_array().map(|at| at as u32);
            (x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791))
                .wrapping_mul(0x85eb_ca6b)
                >> 16
        };
        let inside = |at: IVec3| at.cmpge(IVec3::splat(20)).all() && at.cmplt(IVec3::splat(38)).all();
        let is_set = |at: IVec3| inside(at) && random(at) % 100 < 7;
        let block = |low: i32, high: i32| {
            let span = move || low..high;
            span().flat_map(move |z| span().flat_map(move |y| span().map(move |x| IVec3::new(x, y, z))))
        };
        for radius in [1, 2, 3] {
            let cube = Cube::new(radius);
            let steps = || cube.steps.iter().map(|&(_, step)| step).chain([IVec3::ZERO]);
            // Middles of cubes that are clear of all voxels, and what such cubes cover.
            let is_clear = |at: IVec3| steps().all(|step| !is_set(at + step));
            let wanted: BTreeSet<[i32; 3]> =
                block(18, 40).filter(|&at| !steps().any(|step| is_clear(at + step))).map(|at| at.to_array()).collect();
            let mut found = scene(block(20, 38).filter(|&at| is_set(at)).map(|at| (at, 0)));
            let before = voxels(&found);
            close(&mut found, radius as u32);
            assert!(voxels(&found) == wanted, "{radius}");
            assert!(before.is_subset(&wanted) && (radius == 1 || before != wanted));
        }
    }

    #[test]
    fn new_voxels_take_the_material_of_the_nearest_one_and_of_several_the_one_in_the_middle() {
        let at = |x: i32, y: i32| IVec3::new(x, y, 0);
        // A frame around two voxels, of two materials.
        let frame = |left: u16, right: u16, ends: u16| {
            let sides = (0..=3).flat_map(move |x| [-1, 1].map(|y| (at(x, y), if x < 2 { left } else { right })));
            let mut found = scene(sides.chain([(at(0, 0), ends), (at(3, 0), ends)]));
            assert_eq!(close(&mut found, 1), 2);
            (found.grids[0].get(at(1, 0)), found.grids[0].get(at(2, 0)))
        };
        assert_eq!(frame(1, 3, 0), (Some(1), Some(3)));
        assert_eq!(frame(2, 2, 3), (Some(2), Some(2)));
        assert_eq!(frame(1, 1, 2), (Some(1), Some(1)));
    }
}
