//! `voxtrace man`: the manual pages that an installed program comes with.

use crate::failure::Failure;
use clap::Command;
use std::path::PathBuf;

/// Write the manual pages into a folder: one of the program, and one of each verb
#[derive(clap::Args, Clone, Debug)]
pub struct ManArgs {
    /// Folder to write to, created if missing
    folder: PathBuf,
}

impl ManArgs {
    pub fn run(self, program: Command) -> Result<(), Failure> {
        std::fs::create_dir_all(&self.folder)
            .and_then(|()| clap_mangen::generate_to(program, &self.folder))
            .map_err(|error| Failure::output(&self.folder, &error))
    }
}
