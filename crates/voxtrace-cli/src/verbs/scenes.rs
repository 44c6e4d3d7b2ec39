//! `voxtrace scenes`: the built-in scenes.

use crate::failure::Failure;
use serde_json::json;
use voxtrace::scenes;

/// List the built-in scenes
#[derive(clap::Args, Clone, Debug)]
pub struct ScenesArgs {
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

impl ScenesArgs {
    pub fn run(self) -> Result<(), Failure> {
        let all = scenes::NAMES.map(|name| (name, scenes::default_voxels(name)));
        if self.json {
            let all = all.map(|(name, voxels)| match voxels {
                Some(voxels) => json!({ "name": name, "voxels": voxels }),
                None => json!({ "name": name, "instances": scenes::FOREST_INSTANCES }),
            });
            crate::stdout::print(&format!("{:#}\n", json!({ "scenes": all })));
        } else {
            for (name, voxels) in all {
                let size = match voxels {
                    Some(voxels) => format!("{:>6.1} M voxels", voxels as f64 / 1e6),
                    None => format!("{:>6} instances", scenes::FOREST_INSTANCES),
                };
                crate::stdout::print(&format!("{name:<16}{size}\n"));
            }
            crate::stdout::print(
                "A name stands wherever a file may; --voxels N makes it smaller or larger, and forest --instances N.\n",
            );
        }
        Ok(())
    }
}
