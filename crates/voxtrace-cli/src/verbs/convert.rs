//! `voxtrace convert`: from one scene format to another.

use crate::failure::{Failure, Kind};
use crate::interrupt;
use crate::lattice::{LatticeArgs, OFF_LATTICE_HINT};
use crate::levels::LevelsArg;
use crate::load::{MemoryArgs, SceneArgs, into_packed, is_native};
use crate::normals::NormalsArg;
use crate::outputs;
use crate::report::Report;
use std::path::{Path, PathBuf};
use voxtrace::PackedScene;
use voxtrace::export::{self, ExportError, WRITERS, Writer, writer_of};
use voxtrace::import::Content;
use voxtrace::normals::Normals;
use voxtrace::packed::{FileError, FileErrorKind};

/// What stands on the command line without options.
const SCENES_AND_OUT: &str = "A file (`voxtrace formats` lists the kinds) or the name of a built-in scene; several LAS or LAZ \
    files are one cloud, several meshes one mesh. The last is the file to write: .vxt, .vox, a mesh (.glb, .obj, .ply), .qb, .schem, or a heightmap (.asc, .png)";

/// Convert a scene to another format
#[derive(clap::Args, Clone, Debug)]
#[command(override_usage = "voxtrace convert [OPTIONS] <SCENE>... <OUT>")]
#[command(mut_arg("scenes", |scenes| scenes.help(SCENES_AND_OUT)))]
pub struct ConvertArgs {
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    lattice: LatticeArgs,
    #[command(flatten)]
    levels: LevelsArg,
}

impl ConvertArgs {
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        // Options may stand between files, so that which one is the last is not known before.
        let out = self.scene.scenes.pop().map(PathBuf::from).filter(|_| !self.scene.scenes.is_empty());
        let missing = || Failure::usage("the file to write is missing").hint("`voxtrace convert SCENE OUT`");
        let out = out.as_deref().ok_or_else(missing)?;
        let target = Target::of(out)?;
        self.scene.note();
        target.check(out)?;
        self.levels.check(out)?;
        report.remark(&format!("loading {}", self.scene.shown()));
        self.scene.import.edits.most_colors = target.most_colors();
        let content = self.scene.load(report)?;
        interrupt::check()?;
        let mut memory = self.scene.memory;
        let content = if self.lattice.is_asked() {
            if matches!(&content, Content::Packed(packed) if packed.normals() == Normals::Smooth) {
                // Those of the file are of other voxels.
                memory.normals.get_or_insert(NormalsArg::Smooth);
            }
            let mut scene = content.into_scene();
            let limits = self.scene.import.mesh.import_options().limits;
            self.lattice.apply(&mut scene, &limits, report)?;
            interrupt::check()?;
            Content::Scene(scene.into())
        } else {
            content
        };
        if let Some(input) = self.scene.file().filter(|_| is_native(out) && self.scene.memory.level.is_none()) {
            self.levels.remark_lost(input, report);
        }
        target.write(out, content, (memory, self.levels), report)
    }
}

/// What is to be written.
#[derive(Clone, Copy)]
pub enum Target {
    /// A scene of voxtrace, `.vxt`.
    Native,
    /// A format of others.
    Foreign(&'static Writer),
}

impl Target {
    /// By the name of the file.
    pub fn of(out: &Path) -> Result<Self, Failure> {
        let target = writer_of(out).map(Self::Foreign).or(is_native(out).then_some(Self::Native));
        target.ok_or_else(|| {
            let names: Vec<String> = WRITERS.iter().map(|writer| format!(".{}", writer.extension)).collect();
            let failure = Failure::usage(format!("{}: unknown kind of scene file", out.display()));
            failure.hint(format!("name it .vxt, {}; `voxtrace formats` lists what they are", names.join(", ")))
        })
    }

    /// Refuses, before the long work starts, what cannot be written or is read.
    pub fn check(self, out: &Path) -> Result<(), Failure> {
        outputs::check(out)?;
        self.companions(out).iter().try_for_each(|path| {
            outputs::check(path)?;
            outputs::refuse_foreign_companion(path, out)
        })
    }

    /// As many colours as the format may have.
    pub fn most_colors(self) -> Option<usize> {
        match self {
            Self::Native => None,
            Self::Foreign(writer) => writer.most_colors,
        }
    }

    fn companions(self, out: &Path) -> Vec<PathBuf> {
        match self {
            Self::Native => Vec::new(),
            Self::Foreign(writer) => writer.companions(out),
        }
    }

    /// Writes a scene, into a `.vxt` file with instances merged unless they are to be kept apart, and says what of it could not be kept.
    pub fn write(
        self,
        out: &Path,
        content: Content,
        how: (MemoryArgs, LevelsArg),
        report: &mut Report,
    ) -> Result<(), Failure> {
        let Self::Foreign(writer) = self else { return write_native(out, content, how, report) };
        let scene = &content.into_scene();
        outputs::refuse_inputs(out)?;
        let companions = self.companions(out);
        companions.iter().try_for_each(|path| outputs::refuse_inputs(path))?;
        let lost = writer.write(out, scene).map_err(|error| export_failure(out, &error))?;
        if !lost.is_empty() {
            report.remark(&match writer.extension {
                "vox" => format!("changed too much to keep from the .vox file: {}", lost.join(", ")),
                extension => format!("left out, as .{extension} has no place for it: {}", lost.join(", ")),
            });
        }
        report.wrote(out);
        companions.iter().for_each(|path| report.wrote(path));
        if writer.extension == "png" {
            report
                .remark("a heightmap: the brighter, the higher; `voxtrace render SCENE -o PICTURE.png` makes pictures");
        }
        Ok(())
    }
}

/// Writes a scene that is open, the window's, as `convert` writes it.
#[cfg(feature = "view")]
pub fn write_shown(out: &Path, packed: &PackedScene, report: &mut Report) -> Result<(), Failure> {
    let target = Target::of(out)?;
    target.check(out)?;
    match target {
        Target::Native => save(out, packed, LevelsArg::default(), report),
        Target::Foreign(_) => target.write(out, Content::Scene(packed.to_scene().into()), Default::default(), report),
    }
}

fn write_native(
    out: &Path,
    content: Content,
    (memory, levels): (MemoryArgs, LevelsArg),
    report: &mut Report,
) -> Result<(), Failure> {
    let left_out = match &content {
        Content::Scene(scene) => export::native::left_out(scene),
        Content::Packed(_) => Vec::new(),
    };
    let packed = into_packed(content, memory)?;
    if !left_out.is_empty() {
        report.remark(&format!("left out, as .vxt has no place for it: {}", left_out.join(", ")));
    }
    save(out, &packed, levels, report)
}

fn save(out: &Path, packed: &PackedScene, levels: LevelsArg, report: &mut Report) -> Result<(), Failure> {
    outputs::refuse_inputs(out)?;
    levels.save(out, packed, report)?;
    report.wrote(out);
    Ok(())
}

pub fn export_failure(out: &Path, error: &ExportError) -> Failure {
    match error {
        ExportError::Io { path, error } => Failure::output(path, error),
        ExportError::Placement { .. } => {
            Failure::new(Kind::Output, format!("cannot write {}: {error}", out.display())).hint(OFF_LATTICE_HINT)
        }
        error => Failure::new(Kind::Output, format!("cannot write {}: {error}", out.display()))
            .hint("a .vxt file holds any scene"),
    }
}

pub fn save_failure(out: &Path, error: &FileError) -> Failure {
    match &error.kind {
        FileErrorKind::Io(error) => Failure::output(out, error),
        _ => Failure::new(Kind::Output, format!("cannot write {error}")),
    }
}
