//! `voxtrace convert`: from one scene format to another.

use crate::failure::{Failure, Kind};
use crate::interrupt;
use crate::load::{SceneArgs, into_packed, is_native};
use crate::outputs;
use crate::report::Report;
use std::path::{Path, PathBuf};
use voxtrace::PackedScene;
use voxtrace::export::{self, ExportError};
use voxtrace::import::Content;
use voxtrace::packed::{FileError, FileErrorKind};

/// Colours of a .vox file.
pub const VOX_COLORS: usize = 255;

/// Convert a scene to another format
#[derive(clap::Args, Clone, Debug)]
pub struct ConvertArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// File to write: .vxt or .vox
    #[arg(value_name = "OUT")]
    out: PathBuf,
}

impl ConvertArgs {
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        let out = self.out.as_path();
        let is_vox = is_vox(out)?;
        self.scene.note();
        outputs::check(out)?;
        report.remark(&format!("loading {}", self.scene.scene));
        if is_vox {
            self.scene.import.edits.most_colors = Some(VOX_COLORS);
        }
        let scene = self.scene.load(report)?;
        interrupt::check()?;
        write(out, scene, self.scene.memory.keep_instances, report)
    }
}

/// Whether a file is a .vox, or a .vxt: others are refused.
fn is_vox(out: &Path) -> Result<bool, Failure> {
    let is_vox = out.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("vox"));
    if !is_vox && !is_native(out) {
        let failure = Failure::usage(format!("{}: unknown kind of scene file", out.display()));
        return Err(failure.hint("name it .vxt or .vox; `voxtrace formats` lists what can be written"));
    }
    Ok(is_vox)
}

/// Writes a scene that is open, the window's, as `convert` writes it.
#[cfg(feature = "view")]
pub fn write_shown(out: &Path, packed: &PackedScene, report: &Report) -> Result<(), Failure> {
    let is_vox = is_vox(out)?;
    outputs::check(out)?;
    if !is_vox {
        return save(out, packed, report);
    }
    write(out, Content::Scene(packed.to_scene().into()), false, report)
}

/// Writes a scene to a .vox or .vxt file, the latter with instances merged unless they are to be kept apart, and says what of it could not be kept.
pub fn write(out: &Path, content: Content, keep_instances: bool, report: &Report) -> Result<(), Failure> {
    if is_native(out) {
        let left_out = match &content {
            Content::Scene(scene) => export::native::left_out(scene),
            Content::Packed(_) => Vec::new(),
        };
        let packed = into_packed(content, keep_instances)?;
        if !left_out.is_empty() {
            report.remark(&format!("left out, as .vxt has no place for it: {}", left_out.join(", ")));
        }
        return save(out, &packed, report);
    }
    let scene = &content.into_scene();
    outputs::refuse_inputs(out)?;
    let lost = export::vox::write(out, scene).map_err(|error| export_failure(out, &error))?;
    if !lost.is_empty() {
        report.remark(&format!("changed too much to keep from the .vox file: {}", lost.join(", ")));
    }
    report.wrote(out);
    Ok(())
}

fn save(out: &Path, packed: &PackedScene, report: &Report) -> Result<(), Failure> {
    outputs::refuse_inputs(out)?;
    packed.save(out).map_err(|error| save_failure(out, &error))?;
    report.wrote(out);
    Ok(())
}

pub fn export_failure(out: &Path, error: &ExportError) -> Failure {
    match error {
        ExportError::Io { error, .. } => Failure::output(out, error),
        error => Failure::new(Kind::Output, format!("cannot write {}: {error}", out.display()))
            .hint("a .vxt file holds any scene"),
    }
}

fn save_failure(out: &Path, error: &FileError) -> Failure {
    match &error.kind {
        FileErrorKind::Io(error) => Failure::output(out, error),
        _ => Failure::new(Kind::Output, format!("cannot write {error}")),
    }
}
