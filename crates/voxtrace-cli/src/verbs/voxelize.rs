//! `voxtrace voxelize`: from a mesh, a cloud of points or a volume to a scene of voxels.

use crate::failure::Failure;
use crate::import::ImportArgs;
use crate::interrupt;
use crate::lattice::LatticeArgs;
use crate::levels::LevelsArg;
use crate::load::{MemoryArgs, first_and_more, is_native, named};
use crate::mesh::{Content, UpArg, announce, settled, voxelize_failure, watched};
use crate::normals::{NormalsArg, with_normals};
use crate::outputs;
use crate::parse;
use crate::read_failure::import_failure;
use crate::report::Report;
use crate::verbs::convert::{Target, save_failure};
use crate::volume::{lowered, volume_failure};
use std::path::{Path, PathBuf};
use voxtrace::PackedScene;
use voxtrace::import::{self, Data, Geometry, Kind, LargeGeometry, LargeVolume, Limits, opened};
use voxtrace::scene::LengthUnit;
use voxtrace::voxelize::{Scale, VoxelizeError, VoxelizeOptions, Written};

/// Turn a mesh or a scan into voxels
#[derive(clap::Args, Clone, Debug)]
pub struct VoxelizeArgs {
    /// A mesh, points, a volume or other voxels, or a folder of tiles, of slices or a world: `voxtrace formats` lists the kinds. Several LAS or LAZ files are one cloud, several meshes one mesh
    #[arg(value_name = "INPUT", required = true)]
    inputs: Vec<PathBuf>,
    /// File to write: .vxt, .vox, a mesh (.glb, .obj, .ply), .qb or .schem
    #[arg(short, long = "output", value_name = "OUT")]
    out: PathBuf,
    #[command(flatten)]
    import: ImportArgs,
    #[command(flatten)]
    lattice: LatticeArgs,
    /// The same as --up-axis
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true, conflicts_with = "up_axis")]
    up: Option<UpArg>,
    /// Memory to work in, for example 1GB; intermediate data beyond it goes to disk
    #[arg(long, value_name = "BYTES", value_parser = parse::bytes)]
    memory_budget: Option<u64>,
    #[command(flatten)]
    levels: LevelsArg,
    /// Normals that surfaces are shaded with, kept in the .vxt file [default: faces]
    #[arg(long, value_name = "NORMALS")]
    normals: Option<NormalsArg>,
}

impl VoxelizeArgs {
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        self.import.mesh.up_axis = self.import.mesh.up_axis.or(self.up);
        self.inputs.iter_mut().for_each(|input| *input = named(input));
        let target = Target::of(&self.out)?;
        self.import.edits.most_colors = target.most_colors();
        let (input, out) = (self.input(), self.out.as_path());
        if matches!(target, Target::Foreign(writer) if !writer.keeps_voxels) {
            let failure = Failure::usage(format!("{}: a heightmap, which has no voxels", out.display()));
            return Err(failure.hint("name it .vxt or .vox; `convert` writes heightmaps"));
        }
        self.inputs.iter().for_each(|input| opened::note(input));
        target.check(out)?;
        self.levels.check(out)?;
        report.remark(&format!("loading {}", first_and_more(&input.to_string_lossy(), self.inputs.len())));
        let is_edited = self.import.edits.is_asked() || self.lattice.is_asked();
        if is_edited && self.memory_budget.is_some() {
            let what = "--close, --excavate, --palette-image, --straighten, --bake and --flatten";
            let failure = Failure::usage(format!("{what} want the whole scene in memory"));
            return Err(failure.hint("leave out --memory-budget, or convert the .vxt file in a second step"));
        }
        if self.normals == Some(NormalsArg::Smooth) && self.memory_budget.is_some() {
            let failure = Failure::usage("--normals smooth wants the whole scene in memory");
            return Err(failure.hint("leave out --memory-budget, or convert the .vxt file in a second step"));
        }
        // Native files are not mapped: what is unpacked takes more memory anyway.
        let options = self.import.options(true);
        let mut opened = self.import.open_all(&self.inputs, &options)?;
        let reader = opened.reader();
        let budget = self.memory_budget.filter(|_| is_native(out) && !is_edited && !self.import.mesh.fills());
        if let Some(budget) = budget
            && let Some(large) = opened.open_large(budget).map_err(|error| import_failure(&error))?
        {
            let kind = if large.is_points() { Kind::Points } else { Kind::Mesh };
            self.import.warn_of_kind(kind, reader, input, report);
            return self.voxelize_large(large, &options.limits, report);
        }
        let budget =
            self.memory_budget.filter(|_| is_native(out) && !is_edited && self.import.volume.overlays.is_bare());
        if let Some(budget) = budget
            && let Some(large) = opened.open_large_volume(budget).map_err(|error| import_failure(&error))?
        {
            self.import.warn_of_kind(Kind::Volume, reader, input, report);
            return self.voxelize_large_volume(large, &options.limits, report);
        }
        let data = match self.import.read(opened, input, report)? {
            Data::Geometry(geometry) if !is_edited => return self.voxelize_geometry(geometry, &options.limits, report),
            data => data,
        };
        let mut scene = self.import.scene(data, input, report)?.into_scene();
        self.import.edits.apply(&mut scene, &self.import.mesh, report)?;
        self.lattice.apply(&mut scene, &options.limits, report)?;
        interrupt::check()?;
        target.write(out, import::Content::Scene(scene.into()), (self.memory(), self.levels), report)
    }

    /// Voxelizes what is in memory, into a native file brick by brick.
    fn voxelize_geometry(&self, geometry: Geometry, limits: &Limits, report: &mut Report) -> Result<(), Failure> {
        let (input, out) = (self.input(), self.out.as_path());
        let failure = |error| voxelize_failure(input, error);
        let options = self.options(geometry.unit());
        let content = Content::of(&geometry, &options);
        let options = settled(options, &geometry);
        let estimate = geometry.estimate(&options).map_err(failure)?;
        announce(content, &estimate, geometry.unit(), report);
        if !is_native(out) {
            let scene = watched("voxelize", report, |progress| geometry.voxelize(&options, limits, progress));
            let scene = import::Content::Scene(scene.map_err(failure)?.into());
            return Target::of(out)?.write(out, scene, (self.memory(), self.levels), report);
        }
        self.refuse_inputs()?;
        let write = |progress: &_| geometry.voxelize_to_file(&options, limits, out, progress);
        let written = watched("voxelize", report, write);
        self.end(written, report)
    }

    /// Voxelizes what stays in its file.
    fn voxelize_large(&self, mut large: LargeGeometry, limits: &Limits, report: &mut Report) -> Result<(), Failure> {
        let failure = |error| voxelize_failure(self.input(), error);
        if !large.is_points() {
            self.import.mesh.refuse_choice_of_points(self.input())?;
        }
        let unit = self.import.mesh.settled(large.unit());
        large.set_unit(unit);
        let options = self.options(large.unit());
        watched("survey", report, |progress| large.survey(&options, progress)).map_err(failure)?;
        for note in large.notes() {
            report.warn(&format!("{}: {note}", self.input().display()));
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

    /// Voxelizes a volume that stays in its file.
    fn voxelize_large_volume(
        &self,
        mut large: LargeVolume,
        limits: &Limits,
        report: &mut Report,
    ) -> Result<(), Failure> {
        let failure = |error| match error {
            VoxelizeError::Volume(error) => volume_failure(self.input(), error),
            error => voxelize_failure(self.input(), error),
        };
        for note in &large.frame().notes {
            report.warn(&format!("{}: {note}", self.input().display()));
        }
        let options = self.import.volume.options_of_large(large.frame(), &self.import.mesh)?;
        watched("survey", report, |progress| large.survey(&options, progress).map(drop)).map_err(failure)?;
        let is_known = large.surveyed().is_some_and(|survey| survey.values().is_some());
        if let Some(survey) = large.surveyed() {
            self.import.volume.announce_large(large.frame(), survey, &options, self.input(), report)?;
            self.import.volume.warn_of_large(survey, self.input(), report);
        }
        self.refuse_inputs()?;
        let write = |progress: &_| large.voxelize_to_file(&options, limits, &self.out, progress);
        watched("voxelize", report, write).map_err(|error| match error {
            VoxelizeError::Io(error) => Failure::output(&self.out, &error),
            error => failure(error),
        })?;
        if let Some(survey) = large.surveyed().filter(|_| !is_known) {
            self.import.volume.warn_of_large(survey, self.input(), report);
        }
        if let Some(threshold) = large.lowered_threshold() {
            report.remark(&lowered(threshold));
        }
        self.levels.add(&self.out, report)?;
        report.wrote(&self.out);
        Ok(())
    }

    /// The input, or the first of several.
    fn input(&self) -> &Path {
        &self.inputs[0]
    }

    /// How the scene is packed.
    fn memory(&self) -> MemoryArgs {
        MemoryArgs { normals: self.normals, ..MemoryArgs::default() }
    }

    fn options(&self, unit: LengthUnit) -> VoxelizeOptions {
        let options = self.import.mesh.voxelize_options(unit, self.import.edits.most_colors());
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
    fn end(&self, written: Result<Written, VoxelizeError>, report: &mut Report) -> Result<(), Failure> {
        let written = written.map_err(|error| match error {
            VoxelizeError::Io(error) => Failure::output(&self.out, &error),
            error => voxelize_failure(self.input(), error),
        })?;
        if !written.is_exact {
            report.remark(&format!("more colours than materials: quantized to {}", written.materials));
        }
        if self.normals == Some(NormalsArg::Smooth) {
            // They follow from the voxels, which are all in the file now.
            let packed = PackedScene::read(&self.out).map_err(|error| save_failure(&self.out, &error))?;
            let packed = with_normals(packed, self.normals)?;
            self.levels.save(&self.out, &packed, report)?;
        } else {
            self.levels.add(&self.out, report)?;
        }
        report.wrote(&self.out);
        Ok(())
    }
}
