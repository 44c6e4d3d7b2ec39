//! Which files a render may write: none that it reads, none of others under a name that nobody chose, and the final name of a
//! picture only when it is whole.

use crate::failure::{Failure, Kind};
use crate::outputs::{self, part_path};
use std::path::{Path, PathBuf};
use voxtrace::Frame;
use voxtrace::import::opened::Inputs;

/// Options about files that are there already.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Files that are there")]
pub struct FileArgs {
    /// Skip pictures whose files all exist, to finish an interrupted animation
    #[arg(long)]
    pub skip_existing: bool,
    /// Without -o, overwrite a SCENE.png that voxtrace did not write
    #[arg(long)]
    pub force: bool,
}

impl FileArgs {
    /// Refuses to write over what is read, and under a default name over what others wrote. A film may be continued in its file.
    pub fn check(
        &self,
        outputs: &[PathBuf],
        checkpoint: Option<&Path>,
        resumed: Option<&Path>,
        is_default: bool,
    ) -> Result<(), Failure> {
        let inputs = Inputs::now();
        for path in outputs.iter().map(PathBuf::as_path).chain(checkpoint) {
            outputs::refuse(&inputs, path)?;
            let is_film = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("vxf"));
            if let Some(film) = resumed.filter(|_| !is_film) {
                outputs::refuse_same(path, film)?;
            }
        }
        for path in outputs {
            let part = part_path(path);
            outputs::refuse(&inputs, &part)?;
            outputs::refuse_foreign(&part, self.force)?;
            outputs::refuse_foreign(path, self.force || !is_default)?;
        }
        Ok(())
    }

    /// Whether a picture is left out because its files are there.
    pub fn skips(&self, job: &Job) -> bool {
        let is_there = |path: &PathBuf| path.metadata().is_ok_and(|metadata| metadata.is_file() && metadata.len() > 0);
        self.skip_existing && job.outputs.iter().all(is_there)
    }
}

/// One picture to make.
pub struct Job {
    pub name: String,
    pub frame: Frame,
    pub outputs: Vec<PathBuf>,
    pub checkpoint: Option<PathBuf>,
    /// The frame of an animation.
    pub number: Option<u32>,
    /// What is to be said after --resume to continue it, and with it other frames.
    pub films: Option<PathBuf>,
}

impl Job {
    /// The end of a picture that was broken off.
    pub fn interrupted(&self, samples: &str) -> Failure {
        let parts: Vec<String> = self.outputs.iter().map(|path| part_path(path).display().to_string()).collect();
        let so_far =
            if parts.is_empty() { String::new() } else { format!("the picture so far is {}; ", parts.join(", ")) };
        let unit = if samples == "1" { "sample" } else { "samples" };
        let failure = Failure::new(Kind::Interrupted, format!("interrupted at {samples} {unit} a pixel"));
        failure.hint(match &self.films {
            Some(path) => format!("{so_far}continue with --resume {}", path.display()),
            None => format!("{so_far}with --checkpoint it could be continued"),
        })
    }
}
