//! Meshes and points on the command line: options of voxelization, its progress and interruption.

use crate::failure::{Failure, Kind};
use crate::interrupt;
use crate::parse;
use crate::read_failure::import_failure;
use crate::report::Report;
use std::path::Path;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;
use voxtrace::Scene;
use voxtrace::import::{ClassSet, Geometry, ImportOptions, Limits, MapBounds, PointFilter, READERS};
use voxtrace::mesh::UpAxis;
use voxtrace::points::ColorBy;
use voxtrace::scene::LengthUnit;
use voxtrace::voxelize::{
    Estimate, PointOptions, Scale, SurfaceRule, VoxelizeError, VoxelizeOptions, VoxelizeProgress,
};

/// How often the main thread looks for signals and progress.
const TICK: Duration = Duration::from_millis(50);
/// Voxelization of fewer voxels than this is not announced.
const ANNOUNCED_FROM: u64 = 1_000_000;

/// Options about meshes and points.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Meshes and points")]
pub struct MeshArgs {
    /// Voxels along the longest side of a mesh or scan [default: by the density of points, 512 for a mesh]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=500_000))]
    resolution: Option<u32>,
    /// Edge of a voxel, in the file's unit or with one: 0.02, 2cm, 20mm, 0.02m, 2ft
    #[arg(long, value_name = "SIZE", value_parser = parse::length, conflicts_with = "resolution")]
    voxel_size: Option<parse::Length>,
    /// Which voxels a surface sets
    #[arg(long, value_name = "RULE", default_value = "conservative")]
    surface: SurfaceArg,
    /// Also fill the inside of closed surfaces
    #[arg(long)]
    fill: bool,
    /// Which attribute of points gives their colours
    #[arg(long, value_name = "WHAT", default_value = "auto")]
    color_by: ColorArg,
    /// Least number of points that set a voxel
    #[arg(long, value_name = "N", default_value = "1", value_parser = clap::value_parser!(u32).range(1..))]
    min_points: u32,
    /// Points of these classes alone, by number or name: 2,6 or ground,building
    #[arg(long, value_name = "LIST")]
    classes: Option<ClassSet>,
    /// Points in this box of the map alone, in the coordinates of the file
    #[arg(long, value_name = "X0,Y0,[Z0,]X1,Y1[,Z1]", allow_hyphen_values = true)]
    bounds: Option<MapBounds>,
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true, help = up_axis_help())]
    pub up_axis: Option<UpArg>,
    /// Unit of the file's coordinates: m, mm, cm, km, ft, us-ft [default: what the file says, metres for glTF, else unknown]
    #[arg(long, value_name = "UNIT", value_parser = parse::unit)]
    unit: Option<LengthUnit>,
    /// Quantize the palette to at most N colours, 1 to 65535 [default: 65535, and 255 for .vox]
    #[arg(long, value_name = "N", help_heading = "Any scene", value_parser = clap::value_parser!(u32).range(1..=65_535))]
    palette: Option<u32>,
    /// Dither between colours of the palette (for at most 1024 colours)
    #[arg(long, help_heading = "Any scene")]
    pub dither: bool,
    /// Lift the limits on size, counts and compression ratio that protect from hostile files; that on nesting stays, and what a format has no room for
    #[arg(long)]
    trusted: bool,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum SurfaceArg {
    /// Every voxel that the surface touches
    Conservative,
    /// Fewer voxels, still closed for paths through faces (6-separating)
    Thin,
}

#[derive(Clone, Copy, Debug, clap::ValueEnum)]
enum ColorArg {
    /// Their own colours, or heights for points without colours
    Auto,
    /// Their own colours
    Rgb,
    /// Return intensity
    Intensity,
    /// ASPRS class: ground brown, vegetation green, buildings red, water blue
    Classification,
    /// Height
    Height,
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

/// What is said about the option, by the table of readers.
fn up_axis_help() -> String {
    let of = |axis: UpAxis| {
        let names = READERS.iter().filter(|reader| reader.up_axis == Some(axis)).map(|reader| reader.name);
        names.collect::<Vec<&str>>().join(", ")
    };
    let (y, down) = (of(UpAxis::Y), of(UpAxis::MinusZ));
    format!("Axis that points up in the file [default: y for {y}, -z for {down}, else z]")
}

impl MeshArgs {
    /// The options that change what is made of a file. Limits refuse one, or they do not.
    pub fn without_limits(&self) -> Self {
        Self { trusted: false, ..self.clone() }
    }

    /// How files are read.
    pub fn import_options(&self) -> ImportOptions {
        let most = u64::MAX;
        // Depth stays limited: it takes from the stack.
        let unlimited =
            Limits { bytes: most, voxels: most, points: most, items: most, ratio: most, ..Limits::default() };
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
            unit: self.unit,
            points: PointFilter { classes: self.classes, bounds: self.bounds },
            ..ImportOptions::default()
        }
    }

    /// Takes what was chosen in a window in the place of the options.
    ///
    /// # Errors
    /// One line: what is no choice.
    #[cfg(feature = "view")]
    pub fn choose_points(&mut self, choice: &voxtrace_viewer::PointsChoice) -> Result<(), String> {
        if let Some(word) = choice.color_by {
            self.color_by = clap::ValueEnum::from_str(word, false)?;
        }
        if let Some(classes) = choice.classes_word() {
            self.classes = Some(classes.parse()?);
        }
        self.min_points = choice.min_points.unwrap_or(self.min_points);
        if let Some(resolution) = choice.resolution {
            (self.resolution, self.voxel_size) = (Some(resolution), None);
        }
        Ok(())
    }

    /// Refuses options that choose among points: `path` holds none.
    pub fn refuse_choice_of_points(&self, path: &Path) -> Result<(), Failure> {
        let asked = [("--classes", self.classes.is_some()), ("--bounds", self.bounds.is_some())];
        match asked.iter().find(|(_, is_asked)| *is_asked) {
            Some((option, _)) => {
                Err(Failure::usage(format!("{option} chooses among points, and {} holds none", path.display())))
            }
            None => Ok(()),
        }
    }

    /// Options that are given and say only how what is no voxels becomes voxels.
    pub fn only_for_others(&self) -> impl Iterator<Item = &'static str> {
        let asked = [("--resolution", self.resolution.is_some()), ("--voxel-size", self.voxel_size.is_some())];
        let sizes = asked.into_iter().filter_map(|(option, is_asked)| is_asked.then_some(option));
        sizes.chain(self.only_for_meshes()).chain(self.only_for_points())
    }

    /// Those among them about the surfaces of meshes.
    pub fn only_for_meshes(&self) -> impl Iterator<Item = &'static str> + use<> {
        let asked = [("--surface", matches!(self.surface, SurfaceArg::Thin)), ("--fill", self.fill)];
        asked.into_iter().filter_map(|(option, is_asked)| is_asked.then_some(option))
    }

    /// Those among them about points.
    pub fn only_for_points(&self) -> impl Iterator<Item = &'static str> + use<> {
        let asked = [("--color-by", !matches!(self.color_by, ColorArg::Auto)), ("--min-points", self.min_points > 1)];
        asked.into_iter().filter_map(|(option, is_asked)| is_asked.then_some(option))
    }

    /// Options that are given and say what scenes that say everything about themselves do not ask for: which way is up, and how large things are.
    pub fn only_for_foreign(&self) -> impl Iterator<Item = &'static str> {
        let asked = [("--up-axis", self.up_axis.is_some()), ("--unit", self.unit.is_some())];
        asked.into_iter().filter_map(|(option, is_asked)| is_asked.then_some(option))
    }

    /// Whether the inside of closed surfaces is filled, for which the whole mesh has to be in memory.
    pub fn fills(&self) -> bool {
        self.fill
    }

    /// The unit of a file: a size with a unit makes it metres where nothing else is known.
    pub fn settled(&self, unit: LengthUnit) -> LengthUnit {
        let is_metre = unit == LengthUnit::UNKNOWN && self.voxel_size.is_some_and(|size| size.unit.is_some());
        if is_metre { LengthUnit::METRE } else { unit }
    }

    /// The size of a voxel, if an option gives one.
    pub fn scale_asked_for(&self, unit: LengthUnit) -> Option<Scale> {
        let size = self.voxel_size.map(|size| Scale::VoxelSize(size.in_unit(unit)));
        size.or_else(|| self.resolution.map(Scale::Resolution))
    }

    /// As [`Self::scale_asked_for`], of a volume, whose lattice is in the unit of its scene already.
    pub fn scale_asked_for_volume(&self, unit: LengthUnit) -> Option<Scale> {
        self.scale_asked_for(unit).map(|scale| match scale {
            Scale::VoxelSize(size) => Scale::VoxelSize(size * unit.in_scene()),
            scale => scale,
        })
    }

    /// The number of colours, if an option gives one.
    pub fn palette(&self) -> Option<usize> {
        self.palette.map(|palette| palette as usize)
    }

    /// How what has a unit becomes voxels; `palette` is the number of colours where none is asked for.
    pub fn voxelize_options(&self, unit: LengthUnit, palette: usize) -> VoxelizeOptions {
        VoxelizeOptions {
            scale: self.scale_asked_for(unit).unwrap_or(Scale::Automatic),
            rule: match self.surface {
                SurfaceArg::Conservative => SurfaceRule::Conservative,
                SurfaceArg::Thin => SurfaceRule::Thin,
            },
            fill: self.fill,
            max_materials: self.palette().unwrap_or(palette),
            dither: self.dither,
            points: PointOptions {
                min_points: self.min_points,
                color_by: match self.color_by {
                    ColorArg::Auto => ColorBy::Auto,
                    ColorArg::Rgb => ColorBy::Rgb,
                    ColorArg::Intensity => ColorBy::Intensity,
                    ColorArg::Classification => ColorBy::Classification,
                    ColorArg::Height => ColorBy::Height,
                },
            },
            ..VoxelizeOptions::default()
        }
    }

    /// Voxelizes the mesh or points of a file into a scene.
    pub fn scene(
        &self,
        geometry: &Geometry,
        path: &Path,
        palette: usize,
        report: &mut Report,
    ) -> Result<Scene, Failure> {
        let options = self.voxelize_options(geometry.unit(), palette);
        let content = Content::of(geometry, &options);
        let options = settled(options, geometry);
        let estimate = geometry.estimate(&options).map_err(|error| voxelize_failure(path, error))?;
        if estimate.voxels >= ANNOUNCED_FROM {
            announce(content, &estimate, geometry.unit(), report);
        }
        let limits = self.import_options().limits;
        watched("voxelize", report, |progress| geometry.voxelize(&options, &limits, progress))
            .map_err(|error| voxelize_failure(path, error))
    }
}

/// Options with the scale that suits points, where none is asked for. Finding it takes long, and both the estimate and the work need it.
pub fn settled(options: VoxelizeOptions, geometry: &Geometry) -> VoxelizeOptions {
    match options.scale {
        Scale::Automatic => VoxelizeOptions { scale: geometry.suited_scale(), ..options },
        _ => options,
    }
}

/// What is to become voxels.
#[derive(Clone, Copy)]
pub enum Content {
    /// So many triangles.
    Triangles(u64),
    /// So many points.
    Points(u64),
    /// So many points, with a voxel size chosen by their density.
    DensePoints(u64),
}

impl Content {
    pub fn of(geometry: &Geometry, options: &VoxelizeOptions) -> Self {
        match geometry {
            Geometry::Mesh(mesh) => Self::Triangles(mesh.triangle_count() as u64),
            Geometry::Points(cloud) => {
                let count = cloud.positions.len() as u64;
                if options.scale == Scale::Automatic { Self::DensePoints(count) } else { Self::Points(count) }
            }
        }
    }
}

/// Reports the estimated size and memory.
pub fn announce(content: Content, estimate: &Estimate, unit: LengthUnit, report: &Report) {
    let size = estimate.placement.size;
    let voxel_size = estimate.placement.voxel_size as f32;
    let unit = unit.suffix();
    let (count, what) = match content {
        Content::Triangles(count) => (count, "triangles"),
        Content::Points(count) => (count, "points"),
        Content::DensePoints(count) => (count, "points, voxel size by their density,"),
    };
    let about = if estimate.is_bound { "at most" } else { "about" };
    report.remark(&format!(
        "{} {what} on {} x {} x {} voxels of {voxel_size}{unit}: {about} {} voxels, {}",
        number(count),
        size.x,
        size.y,
        size.z,
        number(estimate.voxels),
        bytes(estimate.bytes),
    ));
}

/// Runs `work` on another thread while this one shows progress and reacts to signals.
pub fn watched<T: Send>(
    name: &str,
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
                    progress.take_notes().iter().for_each(|note| report.remark(note));
                    if !has_begun && progress.total() > 0 {
                        report.begin_work(name, progress.total());
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
    progress.take_notes().iter().for_each(|note| report.remark(note));
    result
}

/// The failure of voxelizing a file.
pub fn voxelize_failure(path: &Path, error: VoxelizeError) -> Failure {
    let message = format!("{}: {error}", path.display());
    match error {
        VoxelizeError::Cancelled => Failure::new(Kind::Interrupted, "interrupted"),
        VoxelizeError::Empty | VoxelizeError::NoPoints => Failure::input(message),
        VoxelizeError::TooThin(_) => Failure::usage(message).hint("a smaller --min-points or larger voxels"),
        VoxelizeError::Missing(_) => Failure::usage(message).hint("another --color-by"),
        VoxelizeError::TooLarge { what: "voxels", .. } => {
            Failure::usage(message).hint("a smaller --resolution or larger --voxel-size; --trusted lifts the limits")
        }
        // What a grid cannot have nobody can lift.
        VoxelizeError::TooLarge { .. } => Failure::usage(message).hint("a smaller --resolution or larger --voxel-size"),
        VoxelizeError::BadScale(_) => Failure::usage(message),
        VoxelizeError::Import(error) => import_failure(&error),
        _ => Failure::other(message),
    }
}

/// A count, abbreviated: `12 k`, `3.4 million`.
pub fn number(value: u64) -> String {
    match value {
        0..10_000 => value.to_string(),
        10_000..1_000_000 => format!("{} k", value / 1000),
        _ => format!("{:.1} million", value as f64 / 1e6),
    }
}

pub fn bytes(value: u64) -> String {
    match value {
        0..10_000_000 => format!("{} kB", value / 1000),
        10_000_000..10_000_000_000 => format!("{} MB", value / 1_000_000),
        _ => format!("{:.1} GB", value as f64 / 1e9),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_that_nobody_can_lift_are_told_without_the_option_that_lifts_limits() {
        let failure =
            |what| voxelize_failure(Path::new("a.obj"), VoxelizeError::TooLarge { what, needed: 9, limit: 8 }).line();
        assert!(failure("voxels").contains("--trusted"));
        assert!(!failure("voxels along an axis").contains("--trusted"), "{}", failure("voxels along an axis"));
    }

    #[test]
    fn counts_have_at_most_four_digits() {
        let counts = [1, 9_999, 10_000, 999_999, 1_000_000, 2_544_000, 123_456_789];
        let texts = ["1", "9999", "10 k", "999 k", "1.0 million", "2.5 million", "123.5 million"];
        assert_eq!(counts.map(number), texts.map(String::from));
    }
}
