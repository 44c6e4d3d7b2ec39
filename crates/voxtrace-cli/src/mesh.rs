//! Meshes on the command line: how they become voxels, and the watch over that work.

use crate::failure::{Failure, Kind};
use crate::interrupt;
use crate::load::import_failure;
use crate::parse;
use crate::report::Report;
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;
use voxtrace::Scene;
use voxtrace::import::{self, ImportOptions, Limits};
use voxtrace::mesh::{Mesh, UpAxis};
use voxtrace::scene::Unit;
use voxtrace::voxelize::{self, Estimate, Scale, SurfaceRule, VoxelizeError, VoxelizeOptions, VoxelizeProgress};

/// How often the watching thread looks around.
const TICK: Duration = Duration::from_millis(50);
/// Work below this many voxels is not announced.
const WORTH_TELLING: u64 = 1_000_000;

/// Options about meshes.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Meshes")]
pub struct MeshArgs {
    /// Voxels along the longest side of a mesh [default: 512]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=500_000))]
    resolution: Option<u32>,
    /// Edge of a voxel, in the file's unit or with one: 0.02, 2cm, 20mm, 0.02m
    #[arg(long, value_name = "SIZE", value_parser = parse::length, conflicts_with = "resolution")]
    voxel_size: Option<parse::Length>,
    /// Which voxels a surface takes
    #[arg(long, value_name = "RULE", default_value = "conservative")]
    surface: SurfaceArg,
    /// Fill the inside of closed surfaces too
    #[arg(long)]
    fill: bool,
    /// Axis that points up in the file [default: y for glTF, else z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub up_axis: Option<UpArg>,
    /// Unit of the file's coordinates [default: metres for glTF, else unknown]
    #[arg(long, value_name = "UNIT")]
    unit: Option<UnitArg>,
    /// Most colours, 1 to 65535; more are gathered to look alike [default: 65535, and 255 for .vox]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=65_535))]
    palette: Option<u32>,
    /// Mix two colours where none fits (for at most 1024 colours)
    #[arg(long)]
    dither: bool,
    /// Read files of any size: the limits that protect from hostile files do not hold
    #[arg(long)]
    trusted: bool,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum SurfaceArg {
    /// Every voxel that the surface crosses
    Conservative,
    /// As few as keep it closed seen through faces
    Thin,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
pub enum UpArg {
    X,
    Y,
    Z,
    #[value(name = "-x")]
    MinusX,
    #[value(name = "-y")]
    MinusY,
    #[value(name = "-z")]
    MinusZ,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum UnitArg {
    M,
    Mm,
}

impl MeshArgs {
    /// How files are read.
    pub fn import_options(&self) -> ImportOptions {
        let unlimited =
            Limits { bytes: u64::MAX, voxels: u64::MAX, points: u64::MAX, items: u64::MAX, ..Limits::default() };
        ImportOptions {
            limits: if self.trusted { unlimited } else { Limits::default() },
            up: self.up_axis.map(|up| match up {
                UpArg::X => UpAxis::X,
                UpArg::Y => UpAxis::Y,
                UpArg::Z => UpAxis::Z,
                UpArg::MinusX => UpAxis::MinusX,
                UpArg::MinusY => UpAxis::MinusY,
                UpArg::MinusZ => UpAxis::MinusZ,
            }),
            unit: self.unit.map(|unit| match unit {
                UnitArg::M => Unit::Metre,
                UnitArg::Mm => Unit::Millimetre,
            }),
            voxelize: VoxelizeOptions::default(),
        }
    }

    /// Reads the mesh of a file and says what was left out.
    pub fn read(&self, path: &Path, report: &Report) -> Result<Mesh, Failure> {
        let mut mesh = import::read_mesh(path, &self.import_options()).map_err(|error| import_failure(&error))?;
        for note in &mesh.notes {
            report.warn(&format!("{}: {note}", path.display()));
        }
        // A size with a unit makes the file's unit metres where nothing else is known.
        if mesh.unit == Unit::Voxel && self.voxel_size.is_some_and(|size| size.metres) {
            mesh.unit = Unit::Metre;
        }
        Ok(mesh)
    }

    /// How the mesh becomes voxels; `palette` is the number of colours where none is asked for.
    pub fn voxelize_options(&self, mesh: &Mesh, palette: usize) -> VoxelizeOptions {
        let scale = match self.voxel_size {
            Some(size) => Scale::VoxelSize(size.in_unit(mesh.unit)),
            None => Scale::Resolution(self.resolution.unwrap_or(512)),
        };
        VoxelizeOptions {
            scale,
            rule: match self.surface {
                SurfaceArg::Conservative => SurfaceRule::Conservative,
                SurfaceArg::Thin => SurfaceRule::Thin,
            },
            fill: self.fill,
            max_materials: self.palette.map_or(palette, |palette| palette as usize),
            dither: self.dither,
            ..VoxelizeOptions::default()
        }
    }

    /// Voxelizes the mesh of a file into a scene.
    pub fn scene(&self, path: &Path, palette: usize, report: &mut Report) -> Result<Scene, Failure> {
        let mesh = self.read(path, report)?;
        let options = self.voxelize_options(&mesh, palette);
        let estimate = voxelize::estimate(&mesh, &options).map_err(|error| voxelize_failure(path, error))?;
        announce(&mesh, &estimate, false, report);
        let limits = self.import_options().limits;
        watched(report, |progress| voxelize::voxelize_watched(&mesh, &options, &limits, progress))
            .map_err(|error| voxelize_failure(path, error))
    }
}

/// Says what the work will come to; small work only if asked.
pub fn announce(mesh: &Mesh, estimate: &Estimate, always: bool, report: &Report) {
    if !always && estimate.voxels < WORTH_TELLING {
        return;
    }
    let size = estimate.placement.size;
    let voxel_size = estimate.placement.voxel_size as f32;
    let unit = match mesh.unit {
        Unit::Voxel => "",
        Unit::Metre => " m",
        Unit::Millimetre => " mm",
    };
    report.remark(&format!(
        "{} triangles on {} x {} x {} voxels of {voxel_size}{unit}: about {} voxels, {}",
        number(mesh.triangle_count() as u64),
        size.x,
        size.y,
        size.z,
        number(estimate.voxels),
        bytes(estimate.bytes),
    ));
}

/// Works on another thread while this one shows how far it is and listens to signals.
pub fn watched<T: Send>(
    report: &mut Report,
    work: impl FnOnce(&VoxelizeProgress) -> Result<T, VoxelizeError> + Send,
) -> Result<T, VoxelizeError> {
    let progress = VoxelizeProgress::default();
    let result = thread::scope(|scope| {
        let (sender, receiver) = channel();
        let progress = &progress;
        scope.spawn(move || {
            // The receiver is there until this answer has come.
            let _ = sender.send(work(progress));
        });
        let mut has_begun = false;
        loop {
            match receiver.recv_timeout(TICK) {
                Ok(result) => return result,
                // The thread panicked; leaving the scope passes the panic on.
                Err(RecvTimeoutError::Disconnected) => return Err(VoxelizeError::Cancelled),
                Err(RecvTimeoutError::Timeout) => {
                    if interrupt::is_requested() {
                        progress.cancel();
                    }
                    if !has_begun && progress.total() > 0 {
                        report.begin_work("voxelize", progress.total());
                        has_begun = true;
                    }
                    if has_begun {
                        report.update(progress.done(), None);
                    }
                }
            }
        }
    });
    report.end();
    result
}

/// The failure of voxelizing a file.
pub fn voxelize_failure(path: &Path, error: VoxelizeError) -> Failure {
    let message = format!("{}: {error}", path.display());
    match error {
        VoxelizeError::Cancelled => Failure::new(Kind::Interrupted, "interrupted"),
        VoxelizeError::Empty => Failure::input(message),
        VoxelizeError::TooLarge { .. } => {
            Failure::usage(message).hint("a smaller --resolution or larger --voxel-size; --trusted lifts the limits")
        }
        VoxelizeError::BadScale(_) => Failure::usage(message),
        _ => Failure::other(message),
    }
}

/// A number as people say it.
fn number(value: u64) -> String {
    match value {
        0..10_000 => value.to_string(),
        10_000..10_000_000 => format!("{} k", value / 1000),
        _ => format!("{:.1} M", value as f64 / 1e6),
    }
}

fn bytes(value: u64) -> String {
    match value {
        0..10_000_000 => format!("{} kB", value / 1000),
        10_000_000..10_000_000_000 => format!("{} MB", value / 1_000_000),
        _ => format!("{:.1} GB", value as f64 / 1e9),
    }
}
