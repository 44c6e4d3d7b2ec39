//! The parts of grids: their bricks, split where rays have least to do, the part of the largest surface first, as long as the trees over all parts of all
//! instances do not grow too much.

use super::hull::Hull;
use crate::packed::shape::occupancy;
use crate::packed::{Geometry, PackedGrid, PackedInstance};
use glam::IVec3;
use rayon::prelude::*;
use std::collections::BinaryHeap;
use std::ops::Range;
use voxtrace_scene::brick::BRICK_SIZE;

/// Most leaves of the trees beyond one for each instance.
const MOST_FURTHER: usize = 16_384;
/// Most voxels of a grid that is looked at, and most bricks.
const MOST_VOXELS: u64 = 1 << 25;
const MOST_BRICKS: usize = 1 << 18;
/// Places along an axis at which a part may be split.
const BINS: usize = 32;
/// Parts of this extent are split whatever their surfaces are, voxels.
const LARGE: i32 = 32;
/// Others where the surfaces of both halves are at most so much of their own.
const LESS: f32 = 0.9;

/// A box of voxels, its upper corner exclusive.
type Voxels = (IVec3, IVec3);

/// A part of a grid.
#[derive(Debug)]
pub struct Part {
    /// The lowest voxel, and the one past the highest.
    pub min: IVec3,
    pub max: IVec3,
    pub hull: Hull,
}

/// What may be split.
struct Piece {
    grid: usize,
    /// Numbers of its bricks, or nothing where they were not looked at.
    bricks: Vec<u32>,
    around: Voxels,
}

/// The parts of all grids, and which of them are those of each grid.
pub fn parts_of(geometry: &Geometry, instances: &[PackedInstance]) -> (Vec<Part>, Vec<Range<u32>>) {
    let mut shown = vec![0usize; geometry.grids.len()];
    instances.iter().for_each(|instance| shown[instance.grid as usize] += 1);
    let bricks: Vec<Vec<Voxels>> = (geometry.grids.iter().zip(&shown))
        .map(|(grid, &times)| if times > 0 { bricks_of(geometry, grid) } else { Vec::new() })
        .collect();
    let pieces = pieces_of(geometry, &bricks, &shown);
    let part = |piece: &Piece| {
        let (min, max) = piece.around;
        let own = |&brick: &u32| bricks[piece.grid][brick as usize];
        let hull = match piece.bricks.is_empty() {
            true => Hull::of([piece.around].into_iter()),
            false => Hull::of(piece.bricks.iter().map(own)),
        };
        Part { min, max, hull }
    };
    let parts = pieces.par_iter().map(part).collect();
    let of_grid = |grid| {
        let before = |limit: usize| pieces.partition_point(|piece| piece.grid < limit) as u32;
        before(grid)..before(grid + 1)
    };
    (parts, (0..geometry.grids.len()).map(of_grid).collect())
}

/// The boxes around the voxels of a grid's bricks; none where these are too many.
fn bricks_of(geometry: &Geometry, grid: &PackedGrid) -> Vec<Voxels> {
    if u64::from(grid.voxels[0]) | u64::from(grid.voxels[1]) << 32 > MOST_VOXELS {
        return Vec::new();
    }
    let places = geometry.bricks_of(grid);
    if places.len() > MOST_BRICKS {
        return Vec::new();
    }
    let of_brick = |at: &IVec3| {
        let corner = grid.origin + *at * BRICK_SIZE;
        let record = geometry.find_brick(grid, corner)?;
        let (min, max) = occupancy(geometry, record).extent();
        Some((corner + min, corner + max))
    };
    places.par_iter().with_min_len(256).filter_map(of_brick).collect()
}

/// Splits grids, ordered by grid.
fn pieces_of(geometry: &Geometry, bricks: &[Vec<Voxels>], shown: &[usize]) -> Vec<Piece> {
    let whole = |(grid, packed): (usize, &PackedGrid)| Piece {
        grid,
        bricks: (0..bricks[grid].len() as u32).collect(),
        around: (packed.min, packed.max),
    };
    let mut pieces: Vec<Piece> = geometry.grids.iter().enumerate().map(whole).collect();
    // The largest first; of equals the one that came first.
    let key = |pieces: &[Piece], at: usize| (surface(pieces[at].around).to_bits(), usize::MAX - at);
    let mut open: BinaryHeap<(u32, usize)> = (0..pieces.len()).map(|at| key(&pieces, at)).collect();
    let mut left = MOST_FURTHER;
    while let Some((_, at)) = open.pop() {
        let at = usize::MAX - at;
        let (grid, times) = (pieces[at].grid, shown[pieces[at].grid]);
        if times == 0 || times > left {
            continue;
        }
        let Some([first, second]) = halves(&bricks[grid], &pieces[at]) else { continue };
        left -= times;
        pieces[at] = first;
        pieces.push(second);
        open.extend([key(&pieces, at), key(&pieces, pieces.len() - 1)]);
    }
    pieces.sort_by_key(|piece| piece.grid);
    pieces
}

/// Splits a piece where the surface area heuristic says, if it is worth it.
fn halves(bricks: &[Voxels], piece: &Piece) -> Option<[Piece; 2]> {
    let extent = (piece.around.1 - piece.around.0).max_element();
    if piece.bricks.len() < 2 || extent <= BRICK_SIZE {
        return None;
    }
    let own = || piece.bricks.iter().map(|&brick| bricks[brick as usize]);
    let bin_of = |axis: usize, (min, max): Voxels| {
        let (low, size) = (2 * piece.around.0[axis], 2 * (piece.around.1[axis] - piece.around.0[axis]));
        (i64::from(min[axis] + max[axis] - low) * BINS as i64 / i64::from(size)).clamp(0, BINS as i64 - 1) as usize
    };
    let mut best: Option<(f32, usize, usize)> = None;
    for axis in 0..3 {
        let mut bins = [(EMPTY, 0u32); BINS];
        for brick in own() {
            let bin = &mut bins[bin_of(axis, brick)];
            *bin = (around(bin.0, brick), bin.1 + 1);
        }
        let join = |a: (Voxels, u32), b: (Voxels, u32)| (around(a.0, b.0), a.1 + b.1);
        let cost = |(voxels, count): (Voxels, u32)| if count == 0 { 0.0 } else { surface(voxels) * count as f32 };
        for first in 1..BINS {
            let (below, above) = bins.split_at(first);
            let (below, above) =
                (below.iter().fold((EMPTY, 0), |a, &b| join(a, b)), above.iter().fold((EMPTY, 0), |a, &b| join(a, b)));
            let cost = cost(below) + cost(above);
            if below.1 > 0 && above.1 > 0 && best.is_none_or(|(least, ..)| cost < least) {
                best = Some((cost, axis, first));
            }
        }
    }
    let (_, axis, first) = best?;
    let half = |is_above: bool| {
        let is_own = |&&brick: &&u32| (bin_of(axis, bricks[brick as usize]) >= first) == is_above;
        let own: Vec<u32> = piece.bricks.iter().filter(is_own).copied().collect();
        let all = own.iter().fold(EMPTY, |all, &brick| around(all, bricks[brick as usize]));
        Piece { grid: piece.grid, bricks: own, around: all }
    };
    let halves = [half(false), half(true)];
    let both: f32 = halves.iter().map(|half| surface(half.around)).sum();
    (extent > LARGE || both < LESS * surface(piece.around)).then_some(halves)
}

const EMPTY: Voxels = (IVec3::MAX, IVec3::MIN);

fn around(a: Voxels, b: Voxels) -> Voxels {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Half the surface of a box.
fn surface((min, max): Voxels) -> f32 {
    let size = (max - min).as_vec3();
    size.x * size.y + size.y * size.z + size.z * size.x
}
