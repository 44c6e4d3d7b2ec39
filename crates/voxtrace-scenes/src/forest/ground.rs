//! The hillside: its height at a place, its paths, and its voxels, one column after the other, closed against rays.

use super::plants::Ramps;
use crate::kit::noise::{floor, fractal_noise, fraction, hash3, signed, sin_cos_degrees, smooth_step, unit};
use crate::kit::{Ramp, Tone};
use glam::{IVec3, Vec2, vec3};
use rayon::prelude::*;
use voxtrace_scene::brick::Brick;
use voxtrace_scene::grid::VoxelGrid;

/// Distance from path to path, metres.
const PATHS: f32 = 100.0;
/// Half the width of a path, metres.
pub const PATH: f32 = 1.7;
/// Edge of a task of [`Ground::build`], bricks.
const BRICK: i32 = 8;

/// A square hillside that rises towards +y.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    /// Edge, metres.
    pub side: f32,
    /// Edge of its voxels, metres.
    pub voxel: f32,
}

impl Ground {
    /// Height at a place, metres: a slope, ridges as wide as the whole, knolls and hummocks.
    pub fn height(&self, at: Vec2) -> f32 {
        let relief = |size: f32, seed| fractal_noise(vec3(at.x / size, at.y / size, 0.5), 2, seed);
        let along = (at.y / self.side).clamp(0.0, 1.0);
        let slope = self.side * (0.06 * along + 0.24 * along * along);
        let knolls = 3.5 * relief(45.0, 302) + 0.5 * relief(9.0, 303);
        slope + 0.055 * self.side * relief(0.45 * self.side, 301) * (0.3 + 0.7 * along) + knolls
    }

    /// Where the nearest path runs at a place's y, and how far from it the place is, metres.
    pub fn path(&self, at: Vec2) -> (f32, f32) {
        let bend = 14.0 * sin_cos_degrees(at.y * 2.9).0 + 6.0 * sin_cos_degrees(at.y * 7.1 + 50.0).0;
        let x = at.x - bend;
        let middle = (floor(x / PATHS) as f32 + 0.5) * PATHS;
        (middle + bend, (x - middle).abs())
    }

    /// The plane between voxels that things stand on at a place, metres.
    pub fn top(&self, at: Vec2) -> f32 {
        let column = vec3(at.x, at.y, 0.0) / self.voxel;
        (self.cells(floor(column.x), floor(column.y)) + 1) as f32 * self.voxel
    }

    /// Number of columns along an edge.
    fn columns(&self) -> i32 {
        floor(self.side / self.voxel).max(1)
    }

    /// The highest voxel of a column.
    fn cells(&self, x: i32, y: i32) -> i32 {
        floor(self.height(Vec2::new(x as f32 + 0.5, y as f32 + 0.5) * self.voxel) / self.voxel)
    }

    /// The colour of a place.
    fn tone(&self, at: Vec2, ramps: &Ramps) -> Tone {
        let (_, far) = self.path(at);
        let patches = fractal_noise(vec3(at.x / 7.0, at.y / 7.0, 0.2), 3, 304);
        let edge = PATH + 0.7 * patches;
        let shade = 0.45 + 0.3 * fractal_noise(vec3(at.x / 2.2, at.y / 2.2, 0.7), 2, 305);
        let of = |ramp: Ramp, level| ramp.even(level, 0.4);
        match () {
            () if far < edge => of(ramps.path, shade + 0.15),
            () if patches > 0.38 => of(ramps.earth, shade),
            () => of(ramps.grass, shade + 0.1 * smooth_step(0.0, 6.0, far)),
        }
    }

    /// The bricks of a tower of bricks.
    fn tower(&self, x: i32, y: i32, ramps: &Ramps) -> Vec<(IVec3, Brick)> {
        const WIDTH: i32 = BRICK + 2;
        let heights: Vec<i32> =
            (0..WIDTH * WIDTH).map(|i| self.cells(x * BRICK + i % WIDTH - 1, y * BRICK + i / WIDTH - 1)).collect();
        let height = |i: i32, j: i32| heights[((j + 1) * WIDTH + i + 1) as usize];
        let mut bricks: Vec<(IVec3, Brick)> = Vec::new();
        for (i, j) in (0..BRICK * BRICK).map(|i| (i % BRICK, i / BRICK)) {
            let (u, v) = (x * BRICK + i, y * BRICK + j);
            if u.max(v) >= self.columns() {
                continue;
            }
            let top = height(i, j);
            let lowest = [height(i - 1, j), height(i + 1, j), height(i, j - 1), height(i, j + 1)].into_iter().min();
            let tone = self.tone(Vec2::new(u as f32 + 0.5, v as f32 + 0.5) * self.voxel, ramps);
            for z in lowest.unwrap_or(top).min(top - 1)..=top {
                let at = IVec3::new(u, v, z);
                let coordinates = at >> 3;
                let index = bricks.iter().position(|(other, _)| *other == coordinates).unwrap_or_else(|| {
                    bricks.push((coordinates, Brick::default()));
                    bricks.len() - 1
                });
                bricks[index].1.set(at & 7, Some(tone.material(hash3(at, 306))));
            }
        }
        bricks
    }

    /// The voxels.
    pub fn build(&self, ramps: &Ramps, wanted: &(dyn Fn() -> bool + Sync)) -> VoxelGrid {
        let across = (self.columns() + BRICK - 1) / BRICK;
        let towers = (0..across * across).into_par_iter().filter(|_| wanted());
        let bricks: Vec<_> = towers.map(|i| self.tower(i % across, i / across, ramps)).collect();
        VoxelGrid::from_bricks(bricks.into_iter().flatten())
    }
}

/// A place of the square for each number: the additive recurrence R2 of Roberts (2018), which spreads any first part of it evenly, with jitter.
pub fn place(index: u32, side: f32, jitter: f32) -> Vec2 {
    let along = |step: u32, seed| {
        let even = unit(index.wrapping_mul(step).wrapping_add(0x8000_0000));
        even * side + jitter * signed(hash3(IVec3::new(index as i32, seed, 0), 307))
    };
    let at = Vec2::new(along(0xC13F_A9A9, 1), along(0x91E1_0DA5, 2)) / side;
    Vec2::new(fraction(at.x), fraction(at.y)) * side
}
