//! What a report says of a scene, beside its cells.

use crate::measure::Conformance;
use serde_json::{Value, json};
use voxtrace::PackedScene;

/// A scene as the rows need it.
#[derive(Clone, Debug)]
pub struct SceneFacts {
    pub name: String,
    pub voxels: u64,
    pub voxels_placed: u64,
    pub hash: String,
    pub camera: String,
    /// Bytes of the packed arrays but the lights, on the host.
    pub packed_bytes: u64,
    /// The picture of the right voxels.
    pub exact_figure: Option<String>,
    /// What the nearest-centre rule would find, where no device was asked.
    pub emulation: Option<Emulation>,
}

/// The study's approximate method, emulated on the CPU.
#[derive(Clone, Debug)]
pub struct Emulation {
    /// How much larger than voxels their boxes are.
    pub margin: f64,
    pub conformance: Conformance,
    pub figures: Figures,
}

impl SceneFacts {
    pub fn of(name: &str, scene: &PackedScene, camera: &str) -> Self {
        let statistics = scene.statistics();
        Self {
            name: name.to_owned(),
            voxels: statistics.voxels,
            voxels_placed: statistics.voxels_placed,
            hash: format!("{:016x}", scene.content_hash()),
            camera: camera.to_owned(),
            packed_bytes: statistics.bytes.iter().filter(|(kind, _)| *kind != "lights").map(|(_, bytes)| bytes).sum(),
            exact_figure: None,
            emulation: None,
        }
    }
}

/// Files of pictures, in the folder of the report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    /// The film.
    pub render: Option<String>,
    /// The voxels that it finds, wrong ones black.
    pub voxels: Option<String>,
    /// Where those are.
    pub difference: Option<String>,
}

impl Figures {
    pub fn json(&self) -> Value {
        json!({ "render": self.render, "voxels": self.voxels, "difference": self.difference })
    }
}
