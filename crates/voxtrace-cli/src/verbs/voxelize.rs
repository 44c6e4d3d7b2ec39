//! `voxtrace voxelize`: from a mesh, a cloud of points or a volume to a scene of voxels.

use crate::edits::EditArgs;
use crate::failure::Failure;
use crate::interrupt;
use crate::load::is_native;
use crate::mesh::{Content, MeshArgs, UpArg, announce, settled, voxelize_failure, watched};
use crate::outputs;
use crate::parse;
use crate::read_failure::import_failure;
use crate::report::Report;
use crate::verbs::convert::{self, VOX_COLORS};
use crate::volume::VolumeArgs;
use crate::voxels::HeightArgs;
use std::path::{Path, PathBuf};
use voxtrace::import::{self, LargeGeometry, Limits, opened};
use voxtrace::scene::Unit;
use voxtrace::voxelize::{Scale, VoxelizeError, VoxelizeOptions, Written};

/// Turn a mesh or a scan into voxels
#[derive(clap::Args, Clone, Debug)]
pub struct VoxelizeArgs {
    /// A mesh, points, a volume or other voxels, or a folder of slices or a world: `voxtrace formats` lists the kinds
    #[arg(value_name = "INPUT")]
    input: PathBuf,
    /// File to write: .vxt or .vox
    #[arg(short, long = "output", value_name = "OUT")]
    out: PathBuf,
    #[command(flatten)]
    mesh: MeshArgs,
    #[command(flatten)]
    volume: VolumeArgs,
    #[command(flatten)]
    heights: HeightArgs,
    #[command(flatten)]
    edits: EditArgs,
    /// The same as --up-axis
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true, conflicts_with = "up_axis")]
    up: Option<UpArg>,
    /// Bytes of memory to work in, for example 1GB; the rest waits on the disk
    #[arg(long, value_name = "BYTES", value_parser = parse::bytes)]
    memory_budget: Option<u64>,
}

impl VoxelizeArgs {
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        self.mesh.up_axis = self.mesh.up_axis.or(self.up);
        let (input, out) = (self.input.as_path(), self.out.as_path());
        let is_vox = out.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("vox"));
        if !is_vox && !is_native(out) {
            let failure = Failure::usage(format!("{}: unknown kind of scene file", out.display()));
            return Err(failure.hint("name it .vxt or .vox; `voxtrace formats` lists what can be written"));
        }
        opened::note(input);
        outputs::check(out)?;
        report.remark(&format!("loading {}", input.display()));
        let import_options = self.volume.import_options(&self.mesh);
        let limits = import_options.limits;
        if is_vox {
            self.edits.most_colors = Some(VOX_COLORS);
        }
        if self.edits.is_asked() && self.memory_budget.is_some() {
            let failure = Failure::usage("--close, --excavate and --palette-image want the whole scene in memory");
            return Err(failure.hint("leave out --memory-budget, or convert the .vxt file in a second step"));
        }
        let format = import::detect(input, &import_options).map_err(|error| import_failure(&error))?;
        if !format.is_geometry() || self.edits.is_asked() {
            let mut scene = if format.is_geometry() {
                self.mesh.scene(input, self.edits.most_colors(), report)?
            } else if format.is_volume() {
                self.volume.scene(input, &self.mesh, report)?
            } else if format.is_voxels() {
                self.heights.scene(input, &self.mesh, self.volume.shell, report)?
            } else {
                import::open(input, &self.mesh.import_options()).map_err(|error| import_failure(&error))?
            };
            self.edits.apply(&mut scene, &self.mesh, report)?;
            interrupt::check()?;
            return convert::write(out, &scene, report);
        }
        if let Some(budget) = self.memory_budget.filter(|_| !is_vox)
            && let Some(large) = self.mesh.open_large(input, budget)?
        {
            return self.voxelize_large(large, &limits, report);
        }
        let geometry = self.mesh.read(input, report)?;
        let options = self.options(geometry.unit());
        let content = Content::of(&geometry, &options);
        let options = settled(options, &geometry);
        let estimate = geometry.estimate(&options).map_err(|error| voxelize_failure(input, error))?;
        announce(content, &estimate, geometry.unit(), report);
        if is_vox {
            let scene = watched("voxelize", report, |progress| geometry.voxelize(&options, &limits, progress));
            let scene = scene.map_err(|error| voxelize_failure(input, error))?;
            return convert::write(out, &scene, report);
        }
        self.refuse_inputs()?;
        let write = |progress: &_| geometry.voxelize_to_file(&options, &limits, out, progress);
        let written = watched("voxelize", report, write);
        self.end(written, report)
    }

    /// Voxelizes what stays in its file.
    fn voxelize_large(&self, mut large: LargeGeometry, limits: &Limits, report: &mut Report) -> Result<(), Failure> {
        let failure = |error| voxelize_failure(&self.input, error);
        let options = self.options(large.unit());
        watched("survey", report, |progress| large.survey(&options, progress)).map_err(failure)?;
        for note in large.notes() {
            report.warn(&format!("{}: {note}", self.input.display()));
        }
        let estimate = large.estimate(&options).map_err(failure)?;
        let content = match options.scale {
            _ if !large.is_points() => Content::Triangles,
            Scale::Automatic => Content::DensePoints,
            _ => Content::Points,
        };
        announce(content(large.count()), &estimate, large.unit(), report);
        self.refuse_inputs()?;
        let write = |progress: &_| large.voxelize_to_file(&options, limits, &self.out, progress);
        let written = watched("voxelize", report, write);
        self.end(written, report)
    }

    fn options(&self, unit: Unit) -> VoxelizeOptions {
        let options = self.mesh.voxelize_options(unit, self.edits.most_colors());
        VoxelizeOptions { memory_budget: self.memory_budget, ..options }
    }

    /// Refuses to write over what is read, also by the part file beside the output.
    fn refuse_inputs(&self) -> Result<(), Failure> {
        let mut part = self.out.clone().into_os_string();
        part.push(".part");
        outputs::refuse_inputs(&self.out)?;
        outputs::refuse_inputs(Path::new(&part))
    }

    /// Says what was written, or why not.
    fn end(&self, written: Result<Written, VoxelizeError>, report: &Report) -> Result<(), Failure> {
        let written = written.map_err(|error| match error {
            VoxelizeError::Io(error) => Failure::output(&self.out, &error),
            error => voxelize_failure(&self.input, error),
        })?;
        if !written.is_exact {
            report.remark(&format!("more colours than materials: gathered into {}", written.materials));
        }
        report.wrote(&self.out);
        Ok(())
    }
}
