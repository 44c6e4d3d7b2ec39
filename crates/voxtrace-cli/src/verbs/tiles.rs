//! `voxtrace tiles`: a scan or a mesh of many files becomes voxels by many processes, each a command of its own, for whatever runs commands.

mod meshes;
mod plan;

use crate::failure::{Failure, reason};
use crate::import::warn_of_needless;
use crate::levels::LevelsArg;
use crate::load::is_native;
use crate::mesh::{MeshArgs, voxelize_failure, watched};
use crate::outputs;
use crate::parse;
use crate::read_failure::import_failure;
use crate::report::Report;
use std::fs;
use std::io::Write;
use std::ops::Range;
use std::path::{Path, PathBuf};
use voxtrace::import::{ImportOptions, Limits, READERS, TiledCloud};
use voxtrace::voxelize::large::MeshTiles;
use voxtrace::voxelize::large_points::{TileSurvey, joined_bytes};
use voxtrace::voxelize::{VoxelizeError, VoxelizeOptions, Written};

/// Voxelize the LAS or LAZ files of a scan, or meshes of several files, by many processes, to the file that `voxelize` makes
///
/// `plan` prints the commands of all stages as lines of JSON. Commands of one stage run at once and anywhere, those of the next one when all are done. Files
/// are told by their numbers, from 0 on. All commands take the same options about points or meshes.
#[derive(clap::Args, Clone, Debug)]
pub struct TilesArgs {
    /// What to do
    #[arg(value_name = "STAGE")]
    stage: Stage,
    /// The files of the scan or the mesh, or the scan's folder; of `join` what the commands before it have written
    #[arg(value_name = "INPUT", required = true)]
    inputs: Vec<PathBuf>,
    /// File to write: a survey, a part, or the .vxt file
    #[arg(short, long = "output", value_name = "OUT")]
    out: PathBuf,
    /// Number of parts; of a scan no more than there are files
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=512))]
    parts: Option<u32>,
    /// Files that this command is for, by their numbers: the first, and the one after the last
    #[arg(long, value_name = "FIRST..END", value_parser = range)]
    files: Option<Range<usize>>,
    /// Share of a mesh's space that this command is for: its number, from 0 on, and how many there are
    #[arg(long, value_name = "K/N", value_parser = share)]
    share: Option<(usize, usize)>,
    /// Survey of all files, which `join` has written
    #[arg(long, value_name = "SURVEY")]
    survey: Option<PathBuf>,
    /// What was expected of all files, where parts were made with that; `merge` holds the survey against it
    #[arg(long, value_name = "SURVEY")]
    expected: Option<PathBuf>,
    /// Plan to read each file once, by what its header and its first points say. Where that is wrong, `merge` says so
    #[arg(long)]
    read_once: bool,
    /// A part, once for each
    #[arg(long, value_name = "PART")]
    part: Vec<PathBuf>,
    /// Memory to work in, for example 1GB; intermediate data beyond it goes to disk
    #[arg(long, value_name = "BYTES", value_parser = parse::bytes)]
    memory_budget: Option<u64>,
    #[command(flatten)]
    mesh: MeshArgs,
    #[command(flatten)]
    levels: LevelsArg,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Stage {
    /// Print all commands
    Plan,
    /// Say what headers and first points let expect of all files
    Expect,
    /// Look through some files; with --survey measure what must be known of all beyond that
    Survey,
    /// Bring together what commands have found
    Join,
    /// Voxelize some files, or a share of a mesh's space, into a part
    Voxelize,
    /// Make the .vxt file of all parts
    Merge,
}

fn range(text: &str) -> Result<Range<usize>, String> {
    let bounds = text.split_once("..").and_then(|(first, end)| Some(first.parse().ok()?..end.parse().ok()?));
    bounds.filter(|range| range.start < range.end).ok_or_else(|| format!("{text:?} is no range of files like 0..4"))
}

fn share(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(share, all)| Some((share.parse().ok()?, all.parse().ok()?)));
    numbers.filter(|(share, all)| share < all).ok_or_else(|| format!("{text:?} is no share like 0/16"))
}

/// Why files are to be read twice.
const NOT_EXPECTED: &str = "headers and first points do not say enough: all points decide here what voxels are";
/// What to do then.
const WITHOUT: &str = "make the plan without --read-once";

/// The files of a scan, and how they become voxels.
struct Work {
    cloud: TiledCloud,
    options: VoxelizeOptions,
    limits: Limits,
}

impl TilesArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        self.inputs.iter().for_each(|input| voxtrace::import::opened::note(input));
        self.warn_of_other_stages(report);
        if self.stage != Stage::Plan {
            outputs::check(&self.out)?;
        }
        if matches!(self.stage, Stage::Plan | Stage::Merge) && !is_native(&self.out) {
            return Err(Failure::usage(format!("{}: parts become a .vxt file", self.out.display())));
        }
        if self.stage != Stage::Join {
            let input = self.inputs[0].display();
            if self.is_mesh()? {
                warn_of_needless(self.mesh.only_for_points(), &format!("{input} is a mesh"), report);
                return self.run_mesh(report);
            }
            warn_of_needless(self.mesh.only_for_meshes(), &format!("{input} holds points"), report);
        }
        if self.share.is_some() {
            return Err(Failure::usage("--share is about meshes; of a scan each part is of some --files"));
        }
        match self.stage {
            Stage::Plan => self.plan(),
            Stage::Expect => self.expect(),
            Stage::Survey => self.look(report),
            Stage::Join => self.join(),
            Stage::Voxelize => self.voxelize(report),
            Stage::Merge => self.merge(report),
        }
    }

    /// Says which options are those of other stages.
    fn warn_of_other_stages(&self, report: &Report) {
        let (name, own): (&str, &[&str]) = match self.stage {
            Stage::Plan => ("plan", &["--parts", "--read-once"]),
            Stage::Expect => ("expect", &[]),
            Stage::Survey => ("survey", &["--files", "--survey"]),
            Stage::Join => ("join", &[]),
            Stage::Voxelize => ("voxelize", &["--files", "--share", "--survey"]),
            Stage::Merge => ("merge", &["--survey", "--expected", "--part"]),
        };
        let asked = [
            ("--parts", self.parts.is_some()),
            ("--files", self.files.is_some()),
            ("--share", self.share.is_some()),
            ("--survey", self.survey.is_some()),
            ("--expected", self.expected.is_some()),
            ("--read-once", self.read_once),
            ("--part", !self.part.is_empty()),
        ];
        let needless = asked.into_iter().filter(|(option, is_asked)| *is_asked && !own.contains(option));
        warn_of_needless(needless.map(|(option, _)| option), &format!("`tiles {name}` has no use for that"), report);
    }

    fn open(&self) -> Result<Work, Failure> {
        let options = self.mesh.import_options();
        let limits = options.limits;
        let mut cloud = self.open_cloud(&options)?;
        let unit = self.mesh.settled(cloud.unit());
        cloud.set_unit(unit);
        let options = self.mesh.voxelize_options(unit, VoxelizeOptions::default().max_materials);
        Ok(Work { cloud, options: VoxelizeOptions { memory_budget: self.memory_budget, ..options }, limits })
    }

    fn open_cloud(&self, options: &ImportOptions) -> Result<TiledCloud, Failure> {
        let opened = READERS.open_all(&self.inputs, options).and_then(|mut opened| opened.open_tiled());
        opened.map_err(|error| import_failure(&error))
    }

    fn files(&self) -> Result<Range<usize>, Failure> {
        self.files.clone().ok_or_else(|| Failure::usage("--files FIRST..END is missing: which files this is for"))
    }

    fn read_survey(&self) -> Result<TileSurvey, Failure> {
        let missing = || Failure::usage("--survey is missing: the survey of all files, which `tiles join` writes");
        survey_of(self.survey.as_deref().ok_or_else(missing)?)
    }

    fn failure(&self, error: VoxelizeError) -> Failure {
        match error {
            VoxelizeError::Io(error) => Failure::output(&self.out, &error),
            VoxelizeError::Parts(_) => Failure::input(error).hint("`voxtrace tiles plan` prints all commands"),
            error => voxelize_failure(&self.inputs[0], error),
        }
    }

    fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        outputs::write(&self.out, |out| out.write_all(bytes))
    }

    /// What is expected of all files.
    fn expect(&self) -> Result<(), Failure> {
        let Work { mut cloud, options, .. } = self.open()?;
        let expected = cloud.expected(&options).map_err(|error| self.failure(error))?;
        let mut expected = expected.ok_or_else(|| Failure::input(NOT_EXPECTED).hint(WITHOUT))?;
        self.write(&expected.to_bytes())
    }

    /// The first pass over some files, or with a survey the second one.
    fn look(&self, report: &mut Report) -> Result<(), Failure> {
        let Work { mut cloud, options, .. } = self.open()?;
        let files = self.files()?;
        let bytes = match &self.survey {
            None => watched("survey", report, |progress| {
                cloud.survey(files, &options, progress).map(|mut survey| survey.to_bytes())
            }),
            Some(_) => {
                let survey = self.read_survey()?;
                watched("measure", report, |progress| cloud.measure(&survey, files, &options, progress))
            }
        };
        self.write(&bytes.map_err(|error| self.failure(error))?)
    }

    fn join(&self) -> Result<(), Failure> {
        let found = self.inputs.iter().map(|path| read(path)).collect::<Result<Vec<_>, _>>()?;
        if found.iter().any(|found| MeshTiles::is_in(found)) {
            return self.write(&meshes::joined(&found).map_err(|error| self.failure(error))?);
        }
        let joined = joined_bytes(found.iter().map(Vec::as_slice)).map_err(|error| self.failure(error))?;
        self.write(&joined)
    }

    fn voxelize(&self, report: &mut Report) -> Result<(), Failure> {
        let Work { mut cloud, options, limits } = self.open()?;
        let (survey, files) = (self.read_survey()?, self.files()?);
        let part = watched("voxelize", report, |progress| {
            cloud.voxelize(&survey, files, &options, &limits, &self.out, progress)
        });
        let part = part.map_err(|error| self.failure(error))?;
        // What was found in the files goes beside the part.
        let Some(mut found) = part.found else { return Ok(()) };
        outputs::write(&self.out.with_extension("found"), |out| out.write_all(&found.to_bytes()))
    }

    fn merge(&self, report: &mut Report) -> Result<(), Failure> {
        let Work { mut cloud, options, limits } = self.open()?;
        let mut survey = self.read_survey()?;
        if let Some(expected) = &self.expected
            && !survey.bear_out(&survey_of(expected)?, &options).map_err(|error| self.failure(error))?
        {
            let what = "points are not as the headers or the first points of their files say";
            return Err(Failure::input(what).hint(WITHOUT));
        }
        let written = watched("merge", report, |progress| {
            cloud.merge(&survey, &self.part, &options, &limits, &self.out, progress)
        });
        let written = written.map_err(|error| self.failure(error))?;
        for note in cloud.notes() {
            report.warn(&format!("{}: {note}", self.inputs[0].display()));
        }
        self.end(written, report)
    }

    /// Ends the merge.
    fn end(&self, written: Written, report: &mut Report) -> Result<(), Failure> {
        if !written.is_exact {
            report.remark(&format!("more colours than materials: quantized to {}", written.materials));
        }
        self.levels.add(&self.out, report)?;
        report.wrote(&self.out);
        Ok(())
    }

    fn part_count(&self) -> Result<usize, Failure> {
        let parts = self.parts.ok_or_else(|| Failure::usage("--parts is missing: how many parts there are"))?;
        Ok(parts as usize)
    }

    /// Prints the commands.
    fn plan(&self) -> Result<(), Failure> {
        let parts = self.part_count()?;
        let Work { mut cloud, options, .. } = self.open()?;
        if self.read_once && cloud.expected(&options).map_err(|error| self.failure(error))?.is_none() {
            return Err(Failure::input(NOT_EXPECTED).hint(WITHOUT));
        }
        plan::print(&cloud.shares(parts), &options, (&self.out, self.read_once))
    }
}

fn survey_of(path: &Path) -> Result<TileSurvey, Failure> {
    TileSurvey::from_bytes(&read(path)?).map_err(|error| Failure::input(format!("{}: {error}", path.display())))
}

fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    fs::read(path).map_err(|error| Failure::input(format!("cannot read {}: {}", path.display(), reason(&error))))
}
