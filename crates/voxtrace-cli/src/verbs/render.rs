//! `voxtrace render`: from a scene to pictures.

mod denoise;
mod files;
mod groups;
mod jobs;
mod limits;
mod moving;
mod resume;
mod shared;

use crate::adaptive::run_adaptively;
use crate::animation::{Director, Stage};
use crate::camera_file::CameraFile;
use crate::changes::ChangeArgs;
use crate::cuts::CutArgs;
use crate::failure::Failure;
use crate::integrator::IntegratorArg;
use crate::interrupt;
use crate::light::{LightArgs, set_light_of};
use crate::lines::{LineArgs, or_of_film};
use crate::load::SceneArgs;
use crate::outputs::{self, part_path};
use crate::parse::{self, MAX_SAMPLES, Size};
use crate::picture::PictureArgs;
use crate::report::Report;
use crate::session::{End, Limits, run};
use crate::surroundings::SurroundingsArgs;
use crate::tracer::TracerArgs;
use crate::views::{View, ViewArgs};
use denoise::{DenoiseArg, Filter};
use files::{FileArgs, Job};
use groups::trace_groups;
use limits::LimitArgs;
use resume::{Resumed, stamp_of};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use voxtrace::film::Pixel;
use voxtrace::frame::MAX_PIXELS;
use voxtrace::glam::Vec3;
use voxtrace::motion::MovingTracer;
use voxtrace::output::{FilmFile, PictureFormat, SceneStamp};
use voxtrace::{Film, PackedScene, Region, Tracer};
use voxtrace_bench::quantity::{clock, counted};

const DEFAULT_SIZE: Size = (1280, 720);
const DEFAULT_SAMPLES: u32 = 64;

/// Render pictures of a scene
#[derive(clap::Args, Clone, Debug)]
pub struct RenderArgs {
    #[command(flatten)]
    pub(super) scene: SceneArgs,
    #[command(flatten)]
    pub(super) picture: PictureArgs,
    #[command(flatten)]
    pub(super) view: ViewArgs,
    #[command(flatten)]
    light: LightArgs,
    #[command(flatten)]
    surroundings: SurroundingsArgs,
    #[command(flatten)]
    lines: LineArgs,
    #[command(flatten)]
    cuts: CutArgs,
    #[command(flatten)]
    changes: ChangeArgs,
    #[command(flatten)]
    quality: QualityArgs,
    #[command(flatten)]
    tracer: TracerArgs,
    #[command(flatten)]
    film: FilmArgs,
    #[command(flatten)]
    pub(super) files: FileArgs,
}

/// Options about what is computed.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Quality")]
struct QualityArgs {
    /// Size of the whole picture in pixels [default: 1280x720]
    #[arg(long, value_name = "WxH", value_parser = parse::size)]
    size: Option<Size>,
    /// Render only the pixels x0 <= x < x1, y0 <= y < y1
    #[arg(long, value_name = "X0,X1,Y0,Y1", value_parser = parse::crop)]
    crop: Option<Region>,
    /// Samples per pixel [default: 64, or until the time limit]
    #[arg(long, value_name = "N", alias = "samples", value_parser = parse::samples)]
    spp: Option<u32>,
    /// Stop each view after this time, for example 30s, 5m or 1h30m
    #[arg(long, value_name = "TIME", value_parser = parse::duration)]
    time_limit: Option<Duration>,
    /// Sample each part of the picture until its relative error is estimated to be below this, for example 0.02; --spp is then the most
    #[arg(long, value_name = "ERROR", value_parser = parse::error)]
    noise: Option<f64>,
    /// Light transport [default: path]
    #[arg(long, value_name = "NAME")]
    integrator: Option<IntegratorArg>,
    /// Largest number of bounces of a path [default: 8 for path, 3 for essay]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=1024))]
    max_bounces: Option<u32>,
    #[command(flatten)]
    limits: LimitArgs,
    /// Seed of the random numbers; each frame of an animation adds its number [default: 0]
    #[arg(long, value_name = "N")]
    seed: Option<u32>,
    /// Leave the background transparent
    #[arg(long)]
    transparent: bool,
    /// Remove the noise from PNG and EXR (which keeps the noisy picture, too) [default filter: voxtrace]
    #[arg(long, value_name = "FILTER", num_args = 0..=1, default_missing_value = "voxtrace")]
    denoise: Option<DenoiseArg>,
    /// Also write albedo, normal, depth, instance and voxel of each pixel (EXR)
    #[arg(long, visible_alias = "layers")]
    aovs: bool,
    /// Also write the light of sun, sky and emitters apart (EXR), which takes as long as a picture for each
    #[arg(long, conflicts_with = "time_limit")]
    light_groups: bool,
}

/// Options about films that are stopped, continued and merged.
#[derive(clap::Args, Clone, Debug)]
#[command(next_help_heading = "Stop and continue")]
struct FilmArgs {
    /// Save the film (.vxf) at intervals, at the end, and when interrupted
    #[arg(long, value_name = "FILE")]
    checkpoint: Option<PathBuf>,
    /// Time between two checkpoints
    #[arg(long, value_name = "TIME", default_value = "60s", value_parser = parse::duration, requires = "checkpoint")]
    checkpoint_every: Duration,
    /// Continue a film with its settings, where no option says otherwise; of a turntable or flight the films of its frames, as --checkpoint names them
    #[arg(long, value_name = "FILE")]
    resume: Option<PathBuf>,
    /// Index of the first sample, to share one picture among machines; `merge` adds the parts up
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=i64::from(MAX_SAMPLES)))]
    first_sample: Option<u32>,
}

impl RenderArgs {
    /// Renders every view and writes its files.
    pub fn run(self, report: &mut Report) -> Result<(), Failure> {
        self.view.check_frames()?;
        self.run_directed(None, &mut |_| (), report)
    }

    /// Renders every view, or the frames of an animation, of which `learn` is told once it is known.
    pub(super) fn run_directed(
        mut self,
        director: Option<&Director>,
        learn: &mut dyn FnMut(&Stage),
        report: &mut Report,
    ) -> Result<(), Failure> {
        self.scene.refuse_pictures()?;
        let is_stopped =
            self.quality.time_limit.is_some() || self.quality.noise.is_some() || self.film.checkpoint.is_some();
        if self.tracer.has_cluster() && is_stopped {
            return Err(Failure::usage(
                "a cluster traces all samples at once: --cluster goes with none of --time-limit, --noise and --checkpoint",
            ));
        }
        let is_default = self.picture.output.is_empty() && self.film.checkpoint.is_none();
        if is_default {
            self.picture.output.push(format!("{}.png", self.scene.stem()).into());
        }
        if self.picture.output.is_empty() && self.files.skip_existing {
            return Err(Failure::usage("--skip-existing looks for pictures").hint("name them with -o"));
        }
        self.scene.note();
        let resume = self.film.resume.as_deref().map(|film| self.open_films(film, director)).transpose()?;
        let resumed = resume.as_ref().map(|resume| resume.settings.clone());
        if self.cuts.is_cut() || resumed.as_ref().is_some_and(|film| !film.scene.cuts.is_none()) {
            self.scene.import.keep_inside();
        }
        let camera_file = self.view.camera_file()?;
        let check = |outputs: &[PathBuf], checkpoint: Option<&Path>, film: Option<&Path>| {
            self.files.check(outputs, checkpoint, film, is_default)
        };
        if self.view.is_one() && director.is_none() {
            // What the scene names is not known yet: this is looked at once more when it is.
            check(&self.picture.output, self.film.checkpoint.as_deref(), self.film.resume.as_deref())?;
        }
        self.picture.check(self.film.checkpoint.as_deref())?;

        report.remark(&format!("loading {}", self.scene.shown()));
        let start = Instant::now();
        let content = self.scene.load(report)?;
        let film = resumed.as_ref().map(|film| &film.frame);
        let (surroundings, lines) = (self.surroundings.of(&content)?, or_of_film(self.lines.of(&content)?, film));
        let (content, cast) = match director {
            Some(director) => {
                let (content, cast) = director.cast(content, &self.view, self.changes.shown())?;
                (content, Some(cast))
            }
            None => (content, None),
        };
        // What a camera frames is the scene without what is around it. Lines end where an instance does, and what moves stays apart.
        let is_apart = !lines.is_none() || cast.as_ref().is_some_and(|cast| cast.is_moving);
        let framed = self.changes.packed(content, self.scene.memory.keeping_instances(is_apart))?;
        let mut scene = surroundings.around(&framed)?;
        interrupt::check()?;
        let size = self.size(resumed.as_ref());
        let stage = cast
            .zip(director)
            .map(|(cast, director)| self.stage(cast, director, &framed, &mut scene, camera_file.as_ref(), size));
        let stage = stage.transpose()?;
        stage.iter().for_each(learn);
        let stamp = self.lit(&mut scene, camera_file.as_ref(), resumed.as_ref())?;
        CutArgs::warn_of_nothing(&scene, report);
        report.remark(&format!("loaded {} in {}", scene.name, clock(start.elapsed().as_secs_f64())));

        let views = match (&resumed, &stage) {
            (_, Some(stage)) => stage.views()?,
            (Some(file), None) if !self.view.says_camera() && self.view.frames().is_none() => {
                vec![View { camera: file.frame.camera.clone(), camera_suffix: None, frame: None }]
            }
            _ => self.view.views(&framed, &scene, camera_file.as_ref(), size)?,
        };
        if resumed.is_some() && views.iter().filter(|view| view.frame == views[0].frame).count() > 1 {
            return Err(Failure::usage("--resume continues films of one camera, but several were asked for"));
        }
        let jobs = self.jobs(views, lines, resumed.as_ref())?;
        let films = |job: &Job| resume.as_ref().map(|resume| resume.path(job.number));
        jobs.iter().try_for_each(|job| check(&job.outputs, job.checkpoint.as_deref(), films(job).as_deref()))?;
        if jobs.iter().all(|job| self.files.skips(job)) {
            report.remark(&format!("nothing to do: {} there already", counted(jobs.len() as u64, "picture")));
            return Ok(());
        }
        if self.film.checkpoint.is_none() && !self.picture.has_layers() {
            let asked = [(self.quality.aovs, "--aovs"), (self.quality.light_groups, "--light-groups")];
            for (_, option) in asked.iter().filter(|(is_asked, _)| *is_asked) {
                report.warn(&format!("{option} is for EXR and films, and there is none: add -o NAME.exr"));
            }
        }
        self.picture.warn_of_needless(report);
        if self.quality.denoise.is_some() && !self.picture.has_picture() {
            report.remark(denoise::OF_FILMS);
        }
        self.render_all(&jobs, stage.as_ref(), (scene, stamp), surroundings.background, resume, report)
    }

    /// Everything that says what the pictures are like, as text: where it is the same, so are they.
    pub(super) fn settings(&self) -> String {
        let Self { scene, view, light, surroundings, lines, cuts, changes, quality, picture, tracer, film, .. } = self;
        let view = ViewArgs { frames: None, ..view.clone() };
        let picture = (picture.exposure, picture.tone_map, &picture.bit_depth);
        let rest = (film.first_sample, &film.resume, tracer.changes_of_pictures());
        format!("{:?}", (scene, view, light, surroundings, lines, cuts, changes, quality, picture, rest))
    }

    /// Width and height of the pictures, as far as options say them.
    pub(super) fn size_of_pictures(&self) -> Option<Size> {
        let whole = self.quality.size.or_else(|| self.film.resume.is_none().then_some(DEFAULT_SIZE));
        self.quality.crop.map(|crop| (crop.width(), crop.height())).or(whole)
    }

    /// Whether films have no sky: a background comes behind them when pictures are made.
    fn is_transparent(&self) -> bool {
        self.quality.transparent || self.surroundings.has_background() || self.surroundings.has_shadow_catcher()
    }

    fn size(&self, resumed: Option<&FilmFile>) -> Size {
        let of_film = resumed.map(|file| (file.frame.width, file.frame.height));
        self.quality.size.or(of_film).unwrap_or(DEFAULT_SIZE)
    }

    /// Sets the light and the cuts that are asked for. Returns the stamp of films of the scene.
    fn lit(
        &self,
        scene: &mut PackedScene,
        camera_file: Option<&CameraFile>,
        resumed: Option<&FilmFile>,
    ) -> Result<SceneStamp, Failure> {
        let stamp = stamp_of(scene, resumed);
        if let Some(file) = camera_file {
            set_light_of(file, scene);
        }
        self.set_light(scene, resumed)?;
        let (sky, light_intensity, cuts) = (scene.sky.clone(), scene.light_intensity, scene.cuts.clone());
        Ok(SceneStamp { sky, light_intensity, cuts, ..stamp })
    }

    fn set_light(&self, scene: &mut PackedScene, resumed: Option<&FilmFile>) -> Result<(), Failure> {
        if let Some(file) = resumed {
            (scene.sky, scene.light_intensity) = (file.scene.sky.clone(), file.scene.light_intensity);
            scene.cuts = file.scene.cuts.clone();
        }
        self.cuts.apply(scene)?;
        self.light.apply(scene)
    }

    /// Brings a film to its end: `start`, or a new one.
    fn trace(
        &self,
        tracer: &mut (dyn Tracer + Send),
        job: &Job,
        start: Option<Film>,
        limits: Limits,
        save: &dyn Fn(&Report, Film),
        report: &mut Report,
    ) -> Result<(End, Film), Failure> {
        let frame = &job.frame;
        if let Some(noise) = self.quality.noise {
            let empty = || Film::new(frame.width, frame.height, frame.region, frame.first_sample);
            let film = start.unwrap_or_else(empty);
            return run_adaptively(tracer, frame, (&job.name, noise), film, &limits, save, report);
        }
        let (mut done, mut earlier) = (0, None);
        if let Some(mut film) = start {
            done = film.pixels.iter().map(|pixel| u64::from(pixel.samples)).sum();
            // How it stood earlier tells the noise as long as that is a good part of the samples asked for.
            let is_good_part = |pixel: &Pixel| pixel.samples >= frame.samples / 4;
            earlier = film.earlier.take().filter(|earlier| limits.halfway && earlier.iter().all(is_good_part));
            tracer.resume(frame, film).map_err(Failure::mismatch)?;
        }
        report.begin(&job.name, done, frame.region.pixels() as u64 * u64::from(frame.samples));
        run(tracer, frame, done, &Limits { earlier, ..limits }, save, report)
    }

    fn render(
        &self,
        tracer: &mut MovingTracer,
        job: &Job,
        start: Option<Film>,
        (scene, stamp): (&PackedScene, &SceneStamp),
        (filter, background): (Option<&Filter>, Option<Vec3>),
        report: &mut Report,
    ) -> Result<(), Failure> {
        let checkpoint_every = job.checkpoint.as_ref().map(|_| self.film.checkpoint_every);
        let limits =
            Limits { time: self.quality.time_limit, checkpoint_every, halfway: filter.is_some(), earlier: None };
        let file_of = |film| FilmFile { frame: job.frame.clone(), scene: stamp.clone(), film };
        let save = |report: &Report, film| {
            let Some(path) = &job.checkpoint else { return };
            // The work goes on: the disk may have room again when it is done.
            if let Err(error) = file_of(film).save(path) {
                report.warn(&format!("no checkpoint: {}", Failure::output(path, &error).line()));
            }
        };
        let begin = Instant::now();
        let mut start = start;
        let begun = start.as_mut().map(|film| std::mem::take(&mut film.groups)).unwrap_or_default();
        let has_groups = self.quality.light_groups || !begun.is_empty();
        let keeping = |report: &Report, film| save(report, Film { groups: begun.clone(), ..film });
        let (mut end, mut film) = self.trace(tracer, job, start, limits, &keeping, report)?;
        film.groups = begun;
        if has_groups && end == End::Complete {
            end = trace_groups(tracer, job, &mut film, scene, checkpoint_every, &save, report)?;
        }
        let (least, most) = film.sample_range();
        let samples = if least == most { most.to_string() } else { format!("{least} to {most}") };
        let seconds = clock(begin.elapsed().as_secs_f64());
        report.remark(&format!(
            "{}: {samples} {} a pixel in {seconds}",
            job.name,
            if most == 1 { "sample" } else { "samples" }
        ));

        // Every file is tried, so that one full disk does not cost the others.
        let mut file = file_of(film);
        if self.quality.noise.is_some() && end == End::Complete {
            // As many as its noisiest part needed.
            file.frame.samples = most;
        }
        let mut result = Ok(());
        if let Some(path) = &job.checkpoint {
            let saved = file.save(path).map_err(|error| Failure::output(path, &error));
            if saved.is_ok() {
                report.wrote(path);
            }
            result = result.and(saved);
        }
        let denoised = match filter {
            Some(filter) if self.picture.has_picture() => {
                let start = Instant::now();
                let denoised = filter.apply(scene, &file, tracer.shot())?;
                report.remark(&format!("{}: denoised in {}", job.name, clock(start.elapsed().as_secs_f64())));
                Some(denoised)
            }
            _ => None,
        };
        let is_whole = end != End::Interrupted;
        let behind = background.map(|color| file.over(color, denoised.as_ref()));
        for path in &job.outputs {
            // The final name says that the picture is whole.
            let (name, part) = (if is_whole { path.clone() } else { part_path(path) }, part_path(path));
            let shown = behind.as_ref().filter(|_| PictureFormat::of(&name) != Some(PictureFormat::Film));
            let (file, denoised) =
                shown.map_or((&file, denoised.as_ref()), |(file, denoised)| (file, denoised.as_ref()));
            let written = self.picture.write(&name, file, denoised, report);
            if is_whole && written.is_ok() && outputs::is_ours(&part) {
                // Left from an interrupted run; the whole picture is there, so that nothing is lost where this fails.
                let _ = std::fs::remove_file(&part);
            }
            result = result.and(written);
        }
        result?;
        if is_whole { Ok(()) } else { Err(job.interrupted(&samples)) }
    }
}
