//! Levels of detail on the command line: which are written into a native file, whether it is one for streaming, and which one is opened.

use crate::failure::Failure;
use crate::interrupt;
use crate::load::is_native;
use crate::report::Report;
use crate::verbs::convert::save_failure;
use std::path::Path;
use voxtrace::PackedScene;
use voxtrace::packed::{
    FileErrorKind, LevelCount, LevelProgress, LevelStep, Levels, MAX_LEVELS, add_levels, rewrite_for_streaming,
};

/// Levels of detail to write.
#[derive(clap::Args, Clone, Copy, Debug, Default)]
pub struct LevelsArg {
    /// Levels of detail to write into the .vxt file, each of voxels twice as wide as those of the one before: a number, or `all`, until the scene is a few voxels wide
    #[arg(long, value_name = "N|all", value_parser = count)]
    levels: Option<LevelCount>,
    /// Write the .vxt file for streaming: all levels of detail in compressed chunks, the coarsest first, so that the viewer for pages shows it while it arrives
    #[arg(long, conflicts_with = "levels")]
    stream: bool,
}

fn count(text: &str) -> Result<LevelCount, String> {
    if text == "all" {
        return Ok(LevelCount::All);
    }
    let count = text.parse().ok().filter(|count| (1..=MAX_LEVELS).contains(count));
    count.map(LevelCount::Some).ok_or_else(|| format!("1 to {MAX_LEVELS}, or all"))
}

impl LevelsArg {
    /// Refuses files that have no place for levels.
    pub fn check(self, out: &Path) -> Result<(), Failure> {
        if self.levels.is_none() && !self.stream || is_native(out) {
            return Ok(());
        }
        if self.stream {
            let failure = Failure::usage(format!("{}: only .vxt files can be streamed", out.display()));
            return Err(failure.hint("leave out --stream, or name the file .vxt"));
        }
        let failure = Failure::usage(format!("{}: only .vxt files have levels of detail", out.display()));
        Err(failure.hint("leave out --levels, or name the file .vxt"))
    }

    /// Saves a scene, with the levels that are asked for.
    pub fn save(self, out: &Path, packed: &PackedScene, report: &mut Report) -> Result<(), Failure> {
        let saved = match self.levels {
            None if self.stream => packed.save_for_streaming(out, &mut listener(report)),
            None => packed.save(out),
            Some(count) => packed.save_with_levels(out, count, &mut listener(report)),
        };
        saved.map_err(|error| if interrupt::is_requested() { interrupt::failure() } else { save_failure(out, &error) })
    }

    /// Adds the levels that are asked for to a file that was written.
    pub fn add(self, out: &Path, report: &mut Report) -> Result<(), Failure> {
        let added = match self.levels {
            None if self.stream => rewrite_for_streaming(out, &mut listener(report)),
            None => return Ok(()),
            Some(count) => add_levels(out, count, &mut listener(report)),
        };
        added.map_err(|error| if interrupt::is_requested() { interrupt::failure() } else { save_failure(out, &error) })
    }

    /// Says that the levels of a file that is read do not come with it.
    pub fn remark_lost(self, input: &Path, report: &Report) {
        if self.levels.is_none()
            && !self.stream
            && is_native(input)
            && input.is_file()
            && Levels::open(input).is_ok_and(|levels| levels.count() > 0)
        {
            report.remark("levels of detail are left out; --levels makes them anew");
        }
    }
}

/// Shows how far the work on levels is, until it is to stop.
fn listener(report: &mut Report) -> impl FnMut(LevelProgress) -> bool {
    let mut shown = None;
    move |LevelProgress { step, level, done, total }| {
        if shown.replace((step, level)) != Some((step, level)) {
            let name = match (step, level) {
                (LevelStep::Make, _) => format!("making level {level} of detail"),
                (LevelStep::Compress, 0) => "compressing the scene".to_owned(),
                (LevelStep::Compress, _) => format!("compressing level {level}"),
            };
            report.begin_work(&name, total);
        }
        report.update(done, None);
        if done == total {
            report.end();
            if step == LevelStep::Make {
                report.remark(&format!("level {level} of detail is made"));
            }
        }
        !interrupt::is_requested()
    }
}

/// Opens a level of a native file.
pub fn open(path: &Path, level: u32, in_memory: bool) -> Result<PackedScene, Failure> {
    const HINT: &str = "`voxtrace convert SCENE OUT.vxt --levels all` writes a file with them";
    if !is_native(path) {
        let failure = Failure::usage(format!("--level {level}: only .vxt files have levels of detail"));
        return Err(failure.hint(HINT));
    }
    let levels = if in_memory { Levels::read(path) } else { Levels::open(path) };
    let levels = levels.map_err(Failure::input)?;
    if level > levels.count() {
        let found = match levels.count() {
            0 => "no levels of detail".to_owned(),
            count => format!("levels of detail up to {count}"),
        };
        let hint = if levels.count() == 0 { HINT } else { "`voxtrace info` lists what they hold" };
        let message = format!("{}: it has {found}, and --level {level} asks for more", path.display());
        return Err(Failure::input(message).hint(hint));
    }
    let failure = |kind: FileErrorKind| Failure::input(format!("{}: {kind}", path.display()));
    levels.scene(level).map_err(failure)
}
