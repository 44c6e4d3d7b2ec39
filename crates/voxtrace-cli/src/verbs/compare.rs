//! `voxtrace compare A B`: two reports of `bench` side by side.

use crate::failure::Failure;
use std::path::PathBuf;
use voxtrace_bench::{CompareError, CompareErrorKind, Comparison};

/// Put two reports of `bench` side by side
#[derive(clap::Args, Clone, Debug)]
pub struct CompareArgs {
    /// Folder of a report, or its results.json
    #[arg(value_name = "A")]
    a: PathBuf,
    /// Folder of the other report
    #[arg(value_name = "B")]
    b: PathBuf,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl CompareArgs {
    pub fn run(self) -> Result<(), Failure> {
        let comparison = Comparison::open(&self.a, &self.b)?;
        crate::stdout::print(&if self.json { format!("{:#}\n", comparison.json()) } else { comparison.text() });
        Ok(())
    }
}

impl From<CompareError> for Failure {
    fn from(error: CompareError) -> Self {
        let failure = Self::input(&error);
        match error.kind {
            CompareErrorKind::Io(_) => failure.hint("name the folder of a report of `voxtrace bench`"),
            CompareErrorKind::Schema(_) => failure.hint("run the benchmark again"),
            _ => failure,
        }
    }
}
