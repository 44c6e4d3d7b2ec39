//! What a cell gave, in few numbers, for whoever shows it.

use super::Results;

/// What was measured of a cell of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// What the scene's files are called after.
    pub scene: String,
    /// Traversal and primitive, as `--cells` has them.
    pub cell: String,
    /// How the shaders round: "precise", or "fast".
    pub rounding: &'static str,
    /// The times; `None` where no frame was proved.
    pub times: Option<Times>,
    /// Bytes of what is traced: acceleration structures, records, and the scene's arrays, lights left out.
    pub traced_bytes: u64,
    /// Most bytes on the device at a time; `None` on the CPU.
    pub peak_bytes: Option<u64>,
    /// Rays through the middles of pixels that met another voxel than the reference, and all of them.
    pub wrong_voxels: Option<(u64, u64)>,
    /// Why there are no frames, or no more of them.
    pub failure: Option<String>,
}

/// Times of frames, each of one sample a pixel. They are the device's own where it has a clock.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Frames that were measured.
    pub frames: usize,
    /// Median, milliseconds.
    pub median_ms: f64,
    /// The time that 99 % of the frames stayed below, milliseconds.
    pub p99_ms: f64,
    /// Rays of all kinds a second; `None` where they were not counted: on the CPU by earlier versions.
    pub rays_per_second: Option<f64>,
}

impl Results {
    /// What was measured, a row for each cell of each scene.
    pub fn measurements(&self) -> Vec<Measurement> {
        let measurement = |row: &super::Row| {
            let facts = &self.scenes[row.scene];
            let times = row.summary().map(|summary| Times {
                frames: summary.frames,
                median_ms: summary.median,
                p99_ms: summary.p99,
                rays_per_second: summary.rays.map(|rays| rays / summary.mean * 1e3),
            });
            Measurement {
                scene: facts.name.clone(),
                cell: row.cell.name(),
                rounding: self.rounding(row.cell),
                times,
                traced_bytes: row.traced_bytes(facts),
                peak_bytes: row.measured.memory.as_ref().map(|memory| memory.peak),
                wrong_voxels: row.measured.conformance.map(|found| (found.errors(), found.rays)),
                failure: row.measured.failure.clone(),
            }
        };
        self.rows.iter().map(measurement).collect()
    }
}
