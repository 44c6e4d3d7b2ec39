//! Where points of other files may fall into the bricks of some files: within the bounds of those.

use super::tiles::SurveyedTile;
use crate::voxelize::points::Grid;
use glam::{IVec3, Vec3};
use std::ops::Range;
use voxtrace_scene::brick::BRICK_SIZE;

/// What is known of the points of some files beside those of others.
pub(in crate::voxelize) struct Seams {
    /// Bounds of the own files' points.
    own: Vec<(Vec3, Vec3)>,
    /// Number of the own files' points.
    points: u64,
    /// The lowest and the highest brick of each other file that reaches into the own ones' bounds.
    others: Vec<(IVec3, IVec3)>,
}

impl Seams {
    /// The seams of some files among all that were surveyed.
    pub fn of(all: &[SurveyedTile], files: &Range<usize>, grid: &Grid) -> Self {
        let (own, others): (Vec<&SurveyedTile>, Vec<&SurveyedTile>) =
            all.iter().filter(|tile| tile.facts.chosen > 0).partition(|tile| files.contains(&(tile.number as usize)));
        let bricks = |low: Vec3, high: Vec3| (grid.voxel(low) / BRICK_SIZE, grid.voxel(high) / BRICK_SIZE);
        let low = own.iter().fold(Vec3::INFINITY, |low, tile| low.min(tile.low));
        let high = own.iter().fold(Vec3::NEG_INFINITY, |high, tile| high.max(tile.high));
        let points = own.iter().map(|tile| tile.facts.chosen).sum();
        let reach = bricks(low, high);
        let others = others.iter().map(|tile| bricks(tile.low, tile.high));
        let others = others.filter(|other| reach.0.cmple(other.1).all() && other.0.cmple(reach.1).all());
        let others = if points == 0 { Vec::new() } else { others.collect() };
        Self { own: own.iter().map(|tile| (tile.low, tile.high)).collect(), points, others }
    }

    /// Number of the own files' points.
    pub fn points(&self) -> u64 {
        self.points
    }

    /// Whether a point may be of the own files.
    pub fn may_own(&self, point: Vec3) -> bool {
        self.own.iter().any(|&(low, high)| low.cmple(point).all() && point.cmple(high).all())
    }

    /// Whether points of other files may be in a brick.
    pub fn reach(&self, brick: IVec3) -> bool {
        self.others.iter().any(|&(low, high)| low.cmple(brick).all() && brick.cmple(high).all())
    }
}
