//! `voxtrace bench`: the study's measurement on this machine, by one command: frame times, rays and memory of each
//! traversal and primitive, as a report, JSON and CSV.

mod against;

use crate::camera_file;
use crate::changes::ChangeArgs;
use crate::failure::{Failure, Kind};
use crate::import::ImportArgs;
use crate::integrator::IntegratorArg;
use crate::interrupt;
use crate::light::{LightArgs, set_light_of};
use crate::load::{MemoryArgs, SceneArgs};
use crate::outputs;
use crate::parse::{self, Size};
use crate::probes;
use crate::read_failure::import_failure;
use crate::report::Report;
use crate::session::trace_failure;
use crate::verbs::convert::{Target, export_failure};
use crate::views::PlaceArgs;
use clap::{Args, FromArgMatches};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::time::Duration;
use voxtrace::import::{Content, ImportError, ImportErrorKind, ImportOptions, opened};
use voxtrace::{Camera, TraceError, export, scenes};
use voxtrace_bench::quantity::QuantityError;
use voxtrace_bench::shell::quoted;
use voxtrace_bench::{
    BenchError, Host, LoadedScene, Monitor, PlanFile, Request, Results, ResumeErrorKind, SceneEntry, run,
};

/// Default folder of the report.
const FOLDER: &str = "voxtrace-bench";

/// Size of the pictures where none is said, for the shape of a view that shows everything.
const STUDY_SIZE: Size = (1980, 1080);

/// Measure frame times, rays and memory, and write a report
#[derive(clap::Args, Clone, Debug)]
pub struct BenchArgs {
    /// Files or names of built-in scenes [default: city, operating-room and church]
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    /// A plan in TOML, ours or FastVoxels' config.toml; options override it
    #[arg(long, value_name = "FILE")]
    plan: Option<PathBuf>,
    /// Size of the built-in scenes, for example 500000, 500k or 13.6M voxels
    #[arg(long, value_name = "N", value_parser = parse::voxels)]
    voxels: Option<u64>,
    /// Trees, rocks and lamps of the built-in scene `forest`, up to a million [default: 10000]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(scenes::MAX_INSTANCES)))]
    instances: Option<u32>,
    /// Folder of the report, created if missing [default: voxtrace-bench]
    #[arg(short = 'o', long = "output", value_name = "FOLDER")]
    folder: Option<PathBuf>,
    /// Write into an existing folder `voxtrace-bench` that holds no benchmark
    #[arg(long)]
    force: bool,
    #[arg(skip)]
    output: PathBuf,
    /// The command as a shell takes it, where it is not the one that the program was started with.
    #[arg(skip)]
    pub command: Option<String>,
    /// Frames of each cell [default: 4096; with --quick 256]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    frames: Option<u32>,
    /// Warm-up frames, not measured [default: 20]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=100_000))]
    warm_up: Option<u32>,
    /// Time limit for the frames of each cell [default: none on a GPU, 60s in software, 20s on the CPU beside a GPU; with --quick 4s]
    #[arg(long, value_name = "TIME", value_parser = parse::duration)]
    time_limit: Option<Duration>,
    /// Measure less: about a minute in all
    #[arg(long)]
    quick: bool,
    /// Every traversal and primitive that the device offers, and the CPU
    #[arg(long, conflicts_with = "cells")]
    full: bool,
    /// Resume an interrupted benchmark: what is in the folder is not measured again
    #[arg(long)]
    resume: bool,
    /// Sizes of the built-in scenes for frame time and memory against voxels; `none` skips them [default: 500k to
    /// 16M, in software to 4M, with --quick none]
    #[arg(long, value_name = "N,…", value_delimiter = ',', value_parser = sweep_size)]
    sweep: Option<Vec<u64>>,
    /// What to measure: TRAVERSAL, TRAVERSAL:PRIMITIVE or TRAVERSAL:all, with :fast or :precise behind it; cpu:INSTRUCTIONS or cpu:all [default: pipeline:voxel-exact,pipeline:voxel-approx; without a GPU cpu]
    #[arg(long, value_name = "CELL", value_delimiter = ',')]
    cells: Vec<String>,
    /// Size of the picture [default: 1980x1080; with --quick on the CPU one that is quick enough, on a device in software 495x270]
    #[arg(long, value_name = "WxH", value_parser = parse::size)]
    size: Option<Size>,
    /// How light is computed [default: essay]
    #[arg(long, value_enum)]
    integrator: Option<IntegratorArg>,
    /// Largest number of bounces of a path [default: 3 for essay, 8 for path]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=1024))]
    max_bounces: Option<u32>,
    /// Use shaders whose results are bit for bit the CPU's, instead of the faster ones with relaxed rounding
    #[arg(long)]
    precise: bool,
    /// Device by its number or a part of its name, as `voxtrace devices` lists them
    #[arg(long, value_name = "DEVICE", env = "VOXTRACE_DEVICE", hide_env_values = true)]
    device: Option<String>,
    /// Another voxtrace, for example an older one: both measure the same in turns, and are compared
    #[arg(long, value_name = "PROGRAM", conflicts_with_all = ["resume", "sweep"])]
    against: Option<PathBuf>,
    /// Rounds of --against, in which each program gets its share of the frames and of the time [default: 5]
    #[arg(long, value_name = "N", requires = "against", value_parser = clap::value_parser!(u32).range(3..=100))]
    rounds: Option<u32>,
    /// Print results.json instead of a table
    #[arg(long)]
    json: bool,
    /// Camera from a TOML file, for every scene: eye, target, up, fov_y (or x, y, z, pitch, yaw, fov), and its light
    #[arg(long, value_name = "TOML", help_heading = "View")]
    camera_file: Option<PathBuf>,
    #[command(flatten, next_help_heading = "View")]
    place: PlaceArgs,
    #[command(flatten)]
    light: LightArgs,
    #[command(flatten)]
    changes: ChangeArgs,
    #[command(flatten)]
    import: ImportArgs,
    #[command(flatten)]
    memory: MemoryArgs,
}

/// A size of the sweep; 0 for `none`.
fn sweep_size(text: &str) -> Result<u64, QuantityError> {
    if text == "none" { Ok(0) } else { parse::voxels(text) }
}

impl BenchArgs {
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        let is_json = self.json;
        let show = |results: &Results| {
            crate::stdout::print(&if is_json { format!("{:#}\n", results.json()) } else { results.table() });
        };
        self.run_showing(&show, report)
    }

    /// As [`Self::run`]; `show` gets the results.
    pub fn run_showing(mut self, show: &dyn Fn(&Results), report: &mut Report) -> Result<(), Failure> {
        self.output = self.folder.clone().unwrap_or(FOLDER.into());
        let mut request = self.request();
        if let Some(path) = &self.plan {
            request.follow(PlanFile::open(path).map_err(BenchError::from)?);
        }
        self.check_folder(&request)?;
        self.check_files(&request)?;
        let is_forest = |entry: &SceneEntry| entry.name == scenes::FOREST;
        if request.instances.is_some() && !request.scenes.iter().any(is_forest) {
            let hint = "name it: voxtrace bench forest --instances 10000";
            return Err(
                Failure::usage("--instances is for the built-in scene forest, which is not measured").hint(hint)
            );
        }
        (self.instances, self.size) = (request.instances, request.size);
        if let Some(program) = &self.against {
            return against::run(program, self.rounds.unwrap_or(against::ROUNDS), &self, &request, report);
        }
        let results = run(&request, &mut CommandLine { args: &self, report })?;
        show(&results);
        report.remark(&format!("the report is {}", self.output.join("report.html").display()));
        if interrupt::is_requested() {
            let hint = format!("what was measured is in {}", self.output.display());
            return Err(Failure::new(Kind::Interrupted, "interrupted").hint(hint));
        }
        Ok(())
    }

    /// Refuses a folder that nobody named and that holds something else than a benchmark. What a scene names is known when it is
    /// loaded, before its files are written.
    fn check_folder(&self, request: &Request) -> Result<(), Failure> {
        let scenes = request.scenes.iter().filter(|entry| !scenes::NAMES.contains(&entry.name.as_str()));
        scenes.for_each(|entry| opened::note(Path::new(&entry.name)));
        request.scenes.iter().filter_map(|entry| entry.camera.as_deref()).for_each(opened::note);
        let written = ["results.json", "against.json", "report.md", "report.html"].map(|name| self.output.join(name));
        written.iter().try_for_each(|path| outputs::refuse_inputs(path))?;
        let mut files = std::fs::read_dir(&self.output).into_iter().flatten();
        let is_foreign = files.next().is_some() && !self.has_results();
        if self.folder.is_none() && !self.force && is_foreign {
            let message = format!("the folder {} is there already, and no benchmark is in it", self.output.display());
            return Err(Failure::new(Kind::Output, message).hint("name the folder with -o, or say --force"));
        }
        Ok(())
    }

    /// Refuses scenes that are not there and cameras that cannot be read now, rather than when the scenes before them are measured.
    fn check_files(&self, request: &Request) -> Result<(), Failure> {
        // What a benchmark that goes on has measured needs its files no more.
        if self.resume {
            return Ok(());
        }
        let cameras = || request.scenes.iter().filter_map(|entry| entry.camera.as_ref());
        for camera in self.camera_file.as_ref().map_or_else(|| cameras().collect(), |one| vec![one]) {
            camera_file::open(camera)?;
        }
        for entry in request.scenes.iter().filter(|entry| !scenes::NAMES.contains(&entry.name.as_str())) {
            let path = Path::new(&entry.name);
            let missing = |error| import_failure(&ImportError::of_file(path, ImportErrorKind::Io(error)));
            std::fs::metadata(path).map_err(missing)?;
        }
        Ok(())
    }

    /// Whether a benchmark is in the folder.
    fn has_results(&self) -> bool {
        ["results.json", "against.json"].iter().any(|name| self.output.join(name).is_file())
    }

    fn request(&self) -> Request {
        Request {
            scenes: self.scenes.iter().map(|name| SceneEntry::named(name)).collect(),
            cells: self.cells.clone(),
            full: self.full,
            quick: self.quick,
            resume: self.resume,
            precise: self.precise,
            frames: self.frames,
            warm_up: self.warm_up,
            time_limit: self.time_limit,
            size: self.size,
            max_bounces: self.max_bounces,
            integrator: self.integrator.map(Into::into),
            voxels: self.voxels,
            instances: self.instances,
            sweep: self.sweep.clone(),
            device: self.device.clone(),
            output: self.output.clone(),
            probes: probes::cache(),
            command: self.command.clone().or_else(|| Some(typed())),
            commit: option_env!("VOXTRACE_COMMIT").map(str::to_owned),
            scene_options: self.scene_options(),
            skip_probes: false,
        }
    }

    /// A hash of the options that say how scenes are read, seen and lit; `None` where none is given.
    fn scene_options(&self) -> Option<String> {
        let text = |args: &Self| {
            let camera = args.camera_file.as_ref().map(std::fs::read);
            let mut import = args.import.clone();
            import.mesh = import.mesh.without_limits();
            format!("{:?}", (camera, &args.place, &args.light, &args.changes, import))
        };
        let none = Self::augment_args(clap::Command::new("bench").no_binary_name(true)).try_get_matches_from([""; 0]);
        let usual = none.and_then(|none| Self::from_arg_matches(&none)).map(|args| text(&args));
        let own = text(self);
        (usual.ok().as_ref() != Some(&own)).then(|| {
            let mut hash = DefaultHasher::new();
            own.hash(&mut hash);
            format!("{:016x}", hash.finish())
        })
    }
}

/// The command as a shell takes it again.
fn typed() -> String {
    let program = env!("CARGO_BIN_NAME").to_owned();
    let words = std::env::args_os().skip(1).map(|word| quoted(&word.to_string_lossy()));
    std::iter::once(program).chain(words).collect::<Vec<_>>().join(" ")
}

/// The command line as the host of a benchmark.
pub(super) struct CommandLine<'a> {
    args: &'a BenchArgs,
    report: &'a mut Report,
}

impl Monitor for CommandLine<'_> {
    fn remark(&mut self, text: &str) {
        self.report.remark(text);
    }

    fn warn(&mut self, text: &str) {
        self.report.warn(text);
    }

    fn begin(&mut self, name: &str, total: u64) {
        self.report.begin_work(name, total);
    }

    fn update(&mut self, done: u64) {
        self.report.update(done, None);
    }

    fn end(&mut self) {
        self.report.end();
    }

    fn is_interrupted(&self) -> bool {
        interrupt::is_requested()
    }

    fn explain(&self, error: TraceError) -> String {
        trace_failure(error).line().trim_start_matches("error: ").to_owned()
    }
}

impl Host for CommandLine<'_> {
    type Error = Failure;

    fn load(&mut self, entry: &SceneEntry, voxels: Option<u64>) -> Result<LoadedScene, Failure> {
        let own = self.args;
        let (import, memory) = (own.import.clone(), own.memory);
        let instances = own.instances.filter(|_| entry.name == scenes::FOREST);
        let args = SceneArgs { scenes: vec![entry.name.clone()], voxels, instances, import, memory };
        let content = if entry.is_vox { through_vox(args.clone(), self.report)? } else { args.load(self.report)? };
        let mut scene = own.changes.packed(content, own.memory)?;
        if let Some(path) = own.camera_file.as_ref().or(entry.camera.as_ref()) {
            let file = camera_file::open(path)?;
            set_light_of(&file, &mut scene);
            scene.cameras.insert(0, file.camera);
        }
        own.light.apply(&mut scene)?;
        if own.place.says_camera() {
            let (width, height) = own.size.unwrap_or(STUDY_SIZE);
            let overview = || Camera { name: "auto".into(), ..scene.overview(width as f32 / height as f32) };
            let mut camera = scene.cameras.first().cloned().unwrap_or_else(overview);
            own.place.apply(&mut camera)?;
            scene.cameras.insert(0, camera);
        }
        let stem = if entry.is_vox { format!("{}-vox", args.stem()) } else { args.stem() };
        Ok(LoadedScene { stem, scene })
    }
}

/// A scene as `convert` writes it to a `.vox` file, read again.
fn through_vox(mut args: SceneArgs, report: &mut Report) -> Result<Content, Failure> {
    let out = PathBuf::from(format!("{}.vox", args.stem()));
    args.import.edits.most_colors = Target::of(&out)?.most_colors();
    let scene = args.load(report)?.into_scene();
    let document = export::vox::document_of(&scene).map_err(|error| export_failure(&out, &error))?;
    let bytes =
        document.to_bytes().ok_or_else(|| Failure::input(format!("{} does not fit in a .vox file", args.scene())))?;
    let loaded = voxtrace::import::load_bytes(&bytes, &out, &ImportOptions::default());
    loaded.map(|loaded| loaded.content).map_err(|error| import_failure(&error))
}

impl From<BenchError> for Failure {
    fn from(error: BenchError) -> Self {
        let text = error.to_string();
        match error {
            BenchError::Plan(_) => {
                Self::input(text).hint("docs/command-line.md has an example; config.toml of FastVoxels is read too")
            }
            BenchError::Cell(_) | BenchError::Scene(_) => Self::usage(text),
            BenchError::Trace(error) => trace_failure(error),
            BenchError::Resume(error) => match error.kind {
                ResumeErrorKind::OtherBenchmark(_) => {
                    Self::mismatch(text).hint("give the same options as before, or another folder")
                }
                ResumeErrorKind::Damaged(_) => Self::input(text).hint("begin anew without --resume"),
                _ => Self::input(text),
            },
            BenchError::OtherScene { .. } => Self::mismatch(text).hint("name another folder for the report"),
            BenchError::Output { path, source } => Self::output(&path, &source),
            _ => Self::other(text),
        }
    }
}
