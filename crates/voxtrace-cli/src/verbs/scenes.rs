//! `voxtrace scenes`: the built-in scenes.

use crate::failure::Failure;
use serde_json::json;
use voxtrace::scenes;

/// List the built-in scenes
#[derive(clap::Args, Clone, Debug)]
pub struct ScenesArgs {
    /// As JSON
    #[arg(long)]
    json: bool,
}

impl ScenesArgs {
    pub fn run(self) -> Result<(), Failure> {
        let all = scenes::NAMES.map(|name| (name, scenes::default_voxels(name).unwrap_or(0)));
        if self.json {
            let all = all.map(|(name, voxels)| json!({ "name": name, "voxels": voxels }));
            crate::stdout::print(&format!("{:#}\n", json!({ "scenes": all })));
        } else {
            for (name, voxels) in all {
                crate::stdout::print(&format!("{name:<16}{:>6.1} M voxels\n", voxels as f64 / 1e6));
            }
            crate::stdout::print("A name stands wherever a file may; --voxels N makes it smaller or larger.\n");
        }
        Ok(())
    }
}
