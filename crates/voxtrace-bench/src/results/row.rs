//! What was measured of one cell of one scene, and what the numbers come to.

use super::facts::{Figures, SceneFacts};
use crate::measure::Measured;
use crate::numbers::{Speeds, Summary};
use crate::plan::Cell;
use voxtrace_vulkan::AccelReport;

/// Names of the device's allocations that hold the scene, see [`Row::scene_bytes`].
const SCENE_ARRAYS: [&str; 9] = [
    "cells",
    "bricks",
    "voxel materials",
    "grids",
    "instances",
    "instance nodes",
    "materials",
    // Where the scene does not fit the device, cells, bricks and materials of voxels are in these.
    "pages",
    "page table",
];

/// One cell of one scene.
#[derive(Clone, Debug)]
pub struct Row {
    /// Index of the scene.
    pub scene: usize,
    pub cell: Cell,
    pub csv: Option<String>,
    pub primary_csv: Option<String>,
    /// Names of the pictures of this cell.
    pub figures: Figures,
    pub measured: Measured,
    summary: Option<Summary>,
    primary: Option<Summary>,
}

impl Row {
    pub fn new(scene: usize, cell: Cell, measured: Measured) -> Self {
        let (summary, primary) = (Summary::of(&measured.frames), Summary::of(&measured.primary));
        let (csv, primary_csv, figures) = (None, None, Figures::default());
        Self { scene, cell, csv, primary_csv, figures, measured, summary, primary }
    }

    pub fn summary(&self) -> Option<Summary> {
        self.summary
    }

    pub fn primary(&self) -> Option<Summary> {
        self.primary
    }

    /// Whether every frame that was begun was proved.
    pub fn is_stable(&self) -> bool {
        let measured = &self.measured;
        measured.lost == 0 && measured.failure.is_none() && measured.film_checks > 0 && self.summary.is_some()
    }

    pub fn speeds(&self) -> Speeds {
        self.summary().map_or_else(Speeds::default, |summary| Speeds::of(&summary, self.primary().as_ref()))
    }

    /// Bytes of the scene's arrays that a tracer of voxels reads, lights left out, as allocated; on the CPU as packed.
    pub fn scene_bytes(&self, facts: &SceneFacts) -> u64 {
        let memory = self.measured.memory.as_ref();
        memory.map_or(facts.packed_bytes, |memory| SCENE_ARRAYS.iter().filter_map(|name| memory.bytes.get(*name)).sum())
    }

    /// Bytes of the records of primitives.
    pub fn record_bytes(&self) -> u64 {
        self.accel().map_or(0, |accel| accel.record_bytes)
    }

    /// Bytes of all acceleration structures.
    pub fn accel_bytes(&self) -> u64 {
        self.accel().map_or(0, |accel| accel.bytes + accel.top_level_bytes)
    }

    /// Bytes of what is traced: structures, records and the scene's arrays.
    pub fn traced_bytes(&self, facts: &SceneFacts) -> u64 {
        self.accel_bytes() + self.record_bytes() + self.scene_bytes(facts)
    }

    fn accel(&self) -> Option<&AccelReport> {
        self.measured.memory.as_ref()?.accel.as_ref()
    }
}

/// One size of a scene in the sweep.
#[derive(Clone, Debug)]
pub struct SweepRow {
    pub scene: String,
    pub cell: Cell,
    /// Voxels asked for.
    pub wanted: u64,
    /// Voxels there are.
    pub voxels: u64,
    /// Median milliseconds of the frames, `None` where it failed.
    pub median: Option<f64>,
    pub frames: usize,
    pub lost: u32,
    /// Bytes of what is traced.
    pub bytes: u64,
    pub failure: Option<String>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Memory;
    use voxtrace_vulkan::Traversal;

    #[test]
    fn a_scene_in_pages_takes_the_memory_of_its_pages() {
        let bytes = [("pages", 4096), ("page table", 96), ("grids", 64), ("film", 1 << 20)];
        let bytes = bytes.map(|(name, bytes)| (name.to_owned(), bytes)).into();
        let measured = Measured { memory: Some(Memory { bytes, ..Memory::default() }), ..Measured::default() };
        let facts = SceneFacts {
            name: "city".into(),
            voxels: 1000,
            voxels_placed: 1000,
            hash: "0".into(),
            camera: "default".into(),
            packed_bytes: 9000,
            exact_figure: None,
            emulation: None,
        };
        let row = Row::new(0, Cell::new(Traversal::Walk, None), measured);
        assert_eq!(row.traced_bytes(&facts), 4096 + 96 + 64);
    }
}
