//! Voxelizes a solid as the shell that a photogrammetry scan would leave, one to two voxels thick and slightly uneven. An octree is
//! refined at the surface only, in parallel, each node with a tape of the operations that matter inside it.
//!
//! Why no ray gets through: let e be the solid's signed distance in voxels plus the uneven part. Between voxels that
//! share a face e changes by at most 1 + 3·`UNEVEN` ÷ 4 < `THINNEST` (the noise blends values up to 2 apart
//! over the 4 voxels of a block with a cubic of slope up to 1.5), so no step through a face leads from outside (e > 0) past the shell
//! (−thickness < e ≤ 0): the shell is 6-separating, and a ray goes from voxel to voxel through faces.

use super::{
    noise::{hash, hash3, mix, signed, unit},
    paint::SurfacePoint,
    program::{Program, Region, Stack},
};
use glam::IVec3;
use rayon::prelude::*;
use voxtrace_scene::brick::{BLOCK_SIZE, BRICK_SIZE, Brick, block_bit, voxel_of};
use voxtrace_scene::grid::VoxelGrid;

/// Largest displacement of the surface, voxels.
const UNEVEN: f32 = 0.3;
/// Smallest and largest thickness of the shell, voxels, drawn for each voxel.
const THINNEST: f32 = 1.25;
const THICKEST: f32 = 1.75;
/// How far outside and inside of the surface the shell can lie, voxels; a little more, for rounding.
const OUTER: f32 = UNEVEN + 0.01;
const INNER: f32 = THICKEST + UNEVEN + 0.01;
/// Edge, in voxels, of the octree nodes that are processed as one task.
const TILE: i32 = 64;
/// Tiles processed before their bricks go into the grid: bounds the memory besides the grid's.
const TILES_AT_ONCE: usize = 4096;

/// A solid and the voxel lattice to build it on.
#[derive(Debug)]
pub struct Lattice {
    /// The solid.
    pub program: Program,
    /// Lowest corner of the built box, in voxels from the origin of the scene.
    pub origin: IVec3,
    /// Edge of a voxel, metres.
    pub voxel: f32,
    /// Size of the built box, voxels.
    pub size: IVec3,
}

/// An octree node with the tape for its inside.
struct Node {
    at: IVec3,
    size: i32,
    tape: Vec<u32>,
}

impl Lattice {
    /// Builds the voxels of the shell, or only some tiles of it once they are not `wanted` any more.
    pub fn build(&self, wanted: &(dyn Fn() -> bool + Sync)) -> VoxelGrid {
        let mut grid = VoxelGrid::new();
        for tiles in self.tiles().chunks(TILES_AT_ONCE) {
            let bricks: Vec<Vec<(IVec3, Brick)>> = tiles
                .par_iter()
                .map(|tile| {
                    let mut bricks = Vec::new();
                    if !wanted() {
                        return bricks;
                    }
                    self.visit_bricks(tile, &mut |at, tape| bricks.push((at, self.brick(at, tape))));
                    bricks
                })
                .collect();
            for (at, brick) in bricks.into_iter().flatten() {
                grid.set_brick(at, brick);
            }
        }
        grid
    }

    /// Counts the voxels that [`Self::build`] would make, without painting them: exactly with a `stride` of 1, else
    /// from a sample of one in `stride` bricks.
    pub fn count(&self, stride: u32) -> u64 {
        let count = |tile: &Node| {
            // Every stride-th brick on the way, from a random one on.
            let (mut count, mut brick) = (0, hash3(tile.at, 4));
            self.visit_bricks(tile, &mut |at, tape| {
                brick = brick.wrapping_add(1);
                if brick.is_multiple_of(stride) {
                    self.visit_voxels(at, tape, |_, _| count += 1);
                }
            });
            count
        };
        self.tiles().par_iter().map(count).sum::<u64>() * u64::from(stride)
    }

    /// The tiles that may hold some of the shell, in octree order.
    fn tiles(&self) -> Vec<Node> {
        let mut size = TILE;
        while size < self.size.max_element() {
            size *= 2;
        }
        let mut nodes = vec![Node { at: IVec3::ZERO, size, tape: self.program.tape().to_vec() }];
        while size > TILE {
            size /= 2;
            nodes = nodes
                .into_par_iter()
                .flat_map_iter(|node| {
                    children(node.at, size).filter_map(move |at| {
                        let mut tape = Vec::new();
                        (self.shorten(&node.tape, at, size, &mut tape) == Region::Mixed).then(|| {
                            tape.shrink_to_fit();
                            Node { at, size, tape }
                        })
                    })
                })
                .collect();
        }
        nodes
    }

    fn shorten(&self, tape: &[u32], at: IVec3, size: i32, short: &mut Vec<u32>) -> Region {
        if at.cmpge(self.size).any() {
            return Region::Outside;
        }
        let half = size as f32 * 0.5;
        let center = ((self.origin + at).as_vec3() + half) * self.voxel;
        // √3 to the cube's corners.
        self.program.shorten(tape, center, half * 1.7321 * self.voxel, (OUTER * self.voxel, INNER * self.voxel), short)
    }

    fn visit_bricks(&self, tile: &Node, visit: &mut impl FnMut(IVec3, &[u32])) {
        let mut buffers = [const { Vec::new() }; 8];
        self.descend(tile.at, tile.size, &tile.tape, &mut buffers, visit);
    }

    fn descend(
        &self,
        at: IVec3,
        size: i32,
        tape: &[u32],
        buffers: &mut [Vec<u32>],
        visit: &mut impl FnMut(IVec3, &[u32]),
    ) {
        if size == BRICK_SIZE {
            return visit(at / BRICK_SIZE, tape);
        }
        let (short, deeper) = buffers.split_first_mut().expect("a buffer for each level");
        for child in children(at, size / 2) {
            if self.shorten(tape, child, size / 2, short) == Region::Mixed {
                self.descend(child, size / 2, short, deeper, visit);
            }
        }
    }

    fn brick(&self, at: IVec3, tape: &[u32]) -> Brick {
        let (mut occupancy, mut materials) = ([0; 8], Vec::with_capacity(96));
        self.visit_voxels(at, tape, |(block, bit), material| {
            occupancy[block] |= 1 << bit;
            materials.push(material());
        });
        materials.shrink_to_fit();
        Brick::new(occupancy, materials)
    }

    /// Visits the voxels of a brick in rank order: block and bit, and what determines the material.
    fn visit_voxels(&self, brick: IVec3, tape: &[u32], mut visit: impl FnMut((usize, u32), &dyn Fn() -> u16)) {
        let mut short = Vec::with_capacity(tape.len());
        let mut stack = Stack::default();
        for block in 0..8 {
            let corner = brick * BRICK_SIZE + voxel_of(block, 0);
            if self.shorten(tape, corner, BLOCK_SIZE, &mut short) != Region::Mixed {
                continue;
            }
            let bumps = Bumps::new(corner);
            for row in 0..BLOCK_SIZE * BLOCK_SIZE {
                let mut local = IVec3::new(0, row % BLOCK_SIZE, row / BLOCK_SIZE);
                while local.x < BLOCK_SIZE {
                    let voxel = corner + local;
                    let at = ((self.origin + voxel).as_vec3() + 0.5) * self.voxel;
                    let nearest = self.program.nearest(&short, at, &mut stack);
                    let distance = nearest.distance / self.voxel;
                    // Far from the shell the distance says how many voxels of the row can be skipped.
                    let beyond = (distance - OUTER).max(-distance - INNER);
                    if beyond > 0.0 {
                        local.x += (beyond as i32).max(1);
                        continue;
                    }
                    let thickness = THINNEST + (THICKEST - THINNEST) * unit(hash3(voxel, 1));
                    let uneven = distance + UNEVEN * bumps.at(local);
                    if uneven <= 0.0 && uneven > -thickness && voxel.cmplt(self.size).all() {
                        visit((block, block_bit(local)), &|| {
                            let (leaf, placed, inside_out) = self.program.surface(nearest);
                            let draw = hash3(voxel, 3);
                            let point = SurfacePoint {
                                at: placed.placement.inverse_point(at),
                                world: at,
                                seed: placed.seed,
                                hash: draw,
                                voxel: self.voxel,
                                depth: -uneven * self.voxel,
                                distance: nearest.distance,
                                leaf,
                                placed,
                                inside_out,
                            };
                            placed.paint.tone(&point).material(hash(draw))
                        });
                    }
                    local.x += 1;
                }
            }
        }
    }
}

/// Smooth noise in [−1, 1] over one block of voxels: random values at its corners, shared with its neighbours.
struct Bumps([f32; 8]);

impl Bumps {
    fn new(corner: IVec3) -> Self {
        Self(std::array::from_fn(|i| signed(hash3(corner + voxel_of(i, 0), 2))))
    }

    fn at(&self, local: IVec3) -> f32 {
        // 3t² − 2t³ at the middles of four voxels.
        const BLEND: [f32; 4] = [0.042_968_75, 0.316_406_25, 0.683_593_75, 0.957_031_25];
        let [x, y, z] = local.to_array().map(|i| BLEND[i as usize]);
        let along_x = |i: usize| mix(self.0[i], self.0[i + 1], x);
        mix(mix(along_x(0), along_x(2), y), mix(along_x(4), along_x(6), y), z)
    }
}

/// Corners of the eight nodes of edge `size` that make up the node at `at`.
fn children(at: IVec3, size: i32) -> impl Iterator<Item = IVec3> {
    (0..8).map(move |i| at + IVec3::new(i & 1, i >> 1 & 1, i >> 2) * size)
}
