//! `voxtrace view`: the window. Scenes are read with the same options as `render` reads them.

use super::kept_volume::KeptVolume;
use super::motion::{director_of, in_motion, plays_of};
use super::{beside, convert};
use crate::changes::packed_with;
use crate::cuts::CutArgs;
use crate::failure::Failure;
use crate::import::ImportArgs;
use crate::interrupt;
use crate::load::{MemoryArgs, SceneArgs};
use crate::parse;
use crate::report::{Report, Said};
use crate::session::trace_failure;
use crate::tracer::TraversalArg;
use std::ffi::OsString;
use std::path::Path;
use std::sync::{Arc, Mutex, PoisonError};
use voxtrace::import::{Data, Kind, READERS};
use voxtrace::{PackedScene, TraceError, Volume, scenes};
use voxtrace_viewer::frame_bench::{self, FrameBench, Times, middle_and_most};
use voxtrace_viewer::{Loader, Plays, Reading, Told, ViewerError, Wanted, WindowOptions, open_window};
use voxtrace_vulkan::{Device, Rate, Settings, Traversal};

/// Fly through a scene in a window, while the light gathers
///
/// F1 lists the keys. Files are dropped on the window, too; options about reading hold for all of them.
#[derive(clap::Args, Clone, Debug)]
pub struct ViewerArgs {
    /// A file (`voxtrace formats` lists the kinds) or the name of a built-in scene. Several LAS or LAZ files are one cloud, several meshes one mesh
    #[arg(value_name = "SCENE")]
    scenes: Vec<String>,
    /// Size of built-in scenes, for example 500000, 500k or 13.6M voxels
    #[arg(long, value_name = "N", value_parser = parse::voxels)]
    voxels: Option<u64>,
    #[command(flatten)]
    import: ImportArgs,
    #[command(flatten)]
    memory: MemoryArgs,
    #[command(flatten)]
    cuts: CutArgs,
    /// How rays find voxels [default: walk on a GPU, cpu where there is none]
    #[arg(long, value_name = "NAME", help_heading = "Device")]
    traversal: Option<TraversalArg>,
    /// Device of the window by its number or a part of its name, as `voxtrace devices` lists them
    #[arg(long, value_name = "DEVICE", env = "VOXTRACE_DEVICE", hide_env_values = true, help_heading = "Device")]
    device: Option<String>,
    /// Open no window: print how long so many frames of 1920 × 1080 pixels take on their way to one
    #[arg(long, value_name = "N", requires = "scenes", help_heading = "Device")]
    bench_frames: Option<u32>,
    /// Open no window: print how long frames of real-time light take while the camera moves, in so many of 1920 × 1080 pixels, and how soon a view that
    /// stands has its film
    #[arg(long, value_name = "N", requires = "scenes", conflicts_with = "bench_frames", help_heading = "Device")]
    bench_moving: Option<u32>,
}

impl ViewerArgs {
    pub fn run(mut self) -> Result<(), Failure> {
        if let Some(frames) = self.bench_frames {
            return self.bench(frames);
        }
        if let Some(frames) = self.bench_moving {
            return self.bench_moving(frames);
        }
        self.cuts.check()?;
        let cutting = self.cuts.take_cutting();
        let words = words_of_view(std::env::args_os())?;
        let options = WindowOptions {
            scene: self.scenes.first().cloned(),
            traversal: self.traversal.map(Into::into),
            device: self.device.clone(),
            validation: voxtrace_vulkan::Options::from_environment().validation,
            scene_options: reading_options(&words, self.scenes.first().map(String::as_str)),
            cutting,
            built_in_voxels: self.voxels,
        };
        let loader = self.into_loader();
        open_window(options, Arc::new(loader)).map_err(|error| match error {
            ViewerError::Device(error) => trace_failure(error),
            ViewerError::Window(_) => Failure::other(error).hint("`voxtrace render` needs no screen"),
            error => Failure::other(error),
        })?;
        interrupt::check()
    }
}

impl ViewerArgs {
    pub(super) fn into_loader(self) -> Files {
        let Self { scenes, import, memory, cuts, voxels, .. } = self;
        Files { tiles: scenes, import, memory, cuts, voxels, volume: KeptVolume::default() }
    }

    /// The device, what traces and the scene of frames that are measured.
    fn subject(self) -> Result<(Arc<Device>, Traversal, Arc<PackedScene>), Failure> {
        // The processor cannot take the place of the device here.
        let device = frame_bench::open_device(self.device.as_deref()).map_err(|error| match error {
            TraceError::Unsupported(_) => {
                Failure::other(error).hint("`voxtrace devices` lists those that --device takes, by number or name")
            }
            error => trace_failure(error),
        })?;
        let traversal = self.traversal.map_or(Traversal::Walk, Into::into);
        let source = self.scenes.first().cloned().unwrap_or_default();
        let reading = Reading::default();
        let scene = self.into_loader().load(&source, &reading, Box::new(|_| {}), &Wanted::default());
        // A device in software takes seconds for a frame.
        interrupt::end_at_once()?;
        Ok((device, traversal, Arc::new(scene.map_err(Failure::input)?)))
    }

    /// Prints the time of frames of a camera that moves, without a window or a screen.
    fn bench_moving(self, frames: u32) -> Result<(), Failure> {
        let source = self.scenes.first().cloned().unwrap_or_default();
        let (device, traversal, scene) = self.subject()?;
        let settings = Settings { traversal, ..Settings::default() };
        let taken = frame_bench::moving(&device, settings, &scene, (1920, 1080), frames).map_err(Failure::other)?;
        let name = &device.info().name;
        say(&format!("{source}, real-time light, 1920 × 1080, {frames} frames of a camera that moves, on {name}"));
        say("milliseconds                 median      p99");
        let line = |what: &str, times: &[f64]| {
            let (middle, most) = middle_and_most(times);
            say(&format!("{what:<26} {middle:>8.3} {most:>8.3}"));
        };
        line("picture to picture, wall", &taken.wall_ms);
        line("frame, by the GPU", &taken.gpu_ms);
        taken.passes.iter().for_each(|(pass, times)| line(&format!("  {pass}"), times));
        for (quality, count) in &taken.qualities {
            let rate = if quality.rate == Rate::Half { "every other pixel" } else { "each pixel" };
            say(&format!("{count} frames at 1/{} of the resolution, a path for {rate}", quality.scale));
        }
        say(&format!("{:.1} MiB beyond the scene", taken.bytes as f64 / f64::from(1 << 20)));
        for (samples, ms) in &taken.film {
            say(&format!("{samples} samples of the film {ms:.0} ms after the view stood"));
        }
        Ok(())
    }

    /// Prints the time of frames, without a window or a screen.
    fn bench(self, frames: u32) -> Result<(), Failure> {
        let source = self.scenes.first().cloned().unwrap_or_default();
        let (device, traversal, scene) = self.subject()?;
        let queue = if device.has_present_queue() { "a queue of its own shows them" } else { "one queue does all" };
        let frame = frame_bench::essay(&scene);
        say(&format!(
            "{source}, essay, 1920 × 1080, {frames} frames of a sample a pixel, on {}: {queue}",
            device.info().name
        ));
        say(
            "milliseconds a frame; by the GPU: medians; excess: beyond tracing alone, by the wall (means) and by the GPU",
        );
        say(
            "arithmetic  what               wall: mean   median      p99    tracing  resolving  drawing     panels     excess",
        );
        let bench = |is_exact| {
            let settings = Settings { traversal, is_exact, ..Settings::default() };
            FrameBench { device: &device, settings, scene: &scene, frame: &frame, frames }
        };
        let mut line = Line::default();
        for (name, has_panels) in PANELS {
            line.say("-", &format!("drawn, {name}"), &bench(true).drawn(has_panels).map_err(Failure::other)?);
        }
        for (arithmetic, is_exact) in [("precise", true), ("fast", false)] {
            let bench = bench(is_exact);
            let traced = bench.traced().map_err(trace_failure)?;
            line.traced = None;
            line.say(arithmetic, "traced", &traced);
            line.traced = Some(traced);
            for (name, has_panels) in PANELS {
                line.say(arithmetic, &format!("shown, {name}"), &bench.shown(has_panels).map_err(Failure::other)?);
            }
        }
        Ok(())
    }
}

/// The panels of a window that is measured.
const PANELS: [(&str, bool); 2] = [("no panels", false), ("panels", true)];

/// Writes lines of the table of times.
#[derive(Default)]
struct Line {
    /// Those of tracing alone, which the others are held against.
    traced: Option<Times>,
}

impl Line {
    fn say(&self, arithmetic: &str, what: &str, times: &Times) {
        let mean = |times: &Times| times.wall_ms.iter().sum::<f64>() / times.wall_ms.len().max(1) as f64;
        let by_gpu =
            |times: &Times| [&times.trace_ms, &times.resolve_ms, &times.draw_ms].map(|times| middle_and_most(times).0);
        let ((middle, most), (panels, _)) = (middle_and_most(&times.wall_ms), middle_and_most(&times.panels_ms));
        let [trace, resolve, draw] = by_gpu(times);
        let excess = self.traced.as_ref().map(|traced| {
            let all: f64 = by_gpu(times).iter().sum();
            format!("{:>+7.3} {:>+7.3}", mean(times) - mean(traced), all - by_gpu(traced).iter().sum::<f64>())
        });
        say(&format!(
            "{arithmetic:<11} {what:<17} {:>11.3} {middle:>8.3} {most:>8.3} {trace:>10.3} {resolve:>10.3} {draw:>8.3} {panels:>10.3}    {}",
            mean(times),
            excess.unwrap_or_default()
        ));
    }
}

fn say(line: &str) {
    crate::stdout::print(&format!("{line}\n"));
}

/// The words behind the verb. The window says them again in commands that it copies and runs, which are text.
fn words_of_view(words: impl Iterator<Item = OsString>) -> Result<Vec<String>, Failure> {
    let text = |word: OsString| {
        let refused = |word: OsString| Failure::usage(format!("{} is no UTF-8", word.display()));
        word.into_string().map_err(|word| refused(word).hint("rename it: the window names files in text"))
    };
    words.skip_while(|word| word != "view").skip(1).map(text).collect()
}

/// The words of a command that say how a scene is read: all but the scene itself and what says how it is shown.
fn reading_options(words: &[String], scene: Option<&str>) -> Vec<String> {
    const OTHERS: [&str; 8] =
        ["--voxels", "--traversal", "--device", "--threads", "--progress", "--clip-box", "--slice", "--clip-plane"];
    let mut kept = Vec::new();
    let mut words = words.iter().peekable();
    let mut scene = scene;
    while let Some(word) = words.next() {
        let name = word.split('=').next().unwrap_or_default();
        if OTHERS.contains(&name) {
            if !word.contains('=') {
                words.next();
            }
        } else if scene == Some(word.as_str()) {
            scene = None;
        } else if !["-q", "--quiet", "--", "--clip-shadows"].contains(&word.as_str()) {
            kept.push(word.clone());
        }
    }
    kept
}

/// Reads what the window is given.
pub(super) struct Files {
    /// What the command names: several files are one scene, that of the first of them.
    tiles: Vec<String>,
    import: ImportArgs,
    memory: MemoryArgs,
    cuts: CutArgs,
    voxels: Option<u64>,
    /// The volume that is shown.
    volume: KeptVolume,
}

impl Files {
    /// Whether a file is read otherwise where the scene is cut: with what nobody sees inside, which volumes, heightmaps and blocks leave out.
    fn depends_on_cuts(&self, path: &Path) -> bool {
        if self.cuts.is_cut() || self.import.volume.shell.is_some() {
            return false;
        }
        let options = self.import.options(self.memory.in_memory);
        // What is wrong with the file, reading it says.
        let reader = READERS.open(path, &options).map(|opened| (opened.reader().kind, opened.reader().name));
        match reader {
            Ok((Kind::Volume, _) | (Kind::Voxels, "heightmap")) => true,
            Ok((_, name)) => self.import.blocks.have_shapes() && name.starts_with("Minecraft"),
            Err(_) => false,
        }
    }
}

impl Loader for Files {
    fn load(
        &self,
        source: &str,
        reading: &Reading,
        tell: Box<dyn Fn(Told) + Send>,
        wanted: &Wanted,
    ) -> Result<PackedScene, String> {
        let is_built_in = scenes::NAMES.contains(&source);
        if !is_built_in && !reading.is_again && self.depends_on_cuts(Path::new(source)) {
            tell(Told::DependsOnCuts);
        }
        let mut scene = SceneArgs {
            scenes: match self.tiles.first() {
                Some(first) if first == source => self.tiles.clone(),
                _ => vec![source.to_owned()],
            },
            voxels: self.voxels.filter(|_| scenes::default_voxels(source).is_some()),
            instances: None,
            import: self.import.clone(),
            memory: self.memory,
        };
        if self.cuts.is_cut() || reading.is_cut {
            scene.import.keep_inside();
        }
        if let Some(transfer) = &reading.transfer {
            (scene.import.volume.transfer, scene.import.volume.threshold) = (Some(transfer.clone()), None);
        }
        scene.import.volume.coarse = reading.coarse;
        let director = match reading.moves {
            true => Some(director_of(reading.animation.as_deref()).map_err(|failure| failure.line())?),
            false => None,
        };
        match &director {
            Some(director) => scene.import.play(director.clip(), director.shape_rate()),
            None => scene.import.play_later(),
        }
        if let Some(points) = &reading.points {
            scene.import.mesh.choose_points(points)?;
        }
        // What reads tells of values, too.
        let told = Arc::new(Mutex::new(tell));
        let of_report = Arc::clone(&told);
        let tell = move |what| (told.lock().unwrap_or_else(PoisonError::into_inner))(what);
        let mut report = Report::to(Box::new(move |said| {
            (of_report.lock().unwrap_or_else(PoisonError::into_inner))(match said {
                Said::Text(text) => Told::Note(text.to_owned()),
                Said::Progress(work, share, seconds_left) => {
                    Told::Progress { work: work.to_owned(), share: Some(share), seconds_left }
                }
            });
        }));
        let wanted = wanted.clone();
        interrupt::also_when(move || wanted.is_over());
        let again = reading.is_again;
        let content = self.volume.load(&scene, again, &tell, &mut report).and_then(|content| {
            interrupt::check()?;
            let plays = plays_of(&content);
            if plays != Plays::Nothing {
                tell(Told::Plays(plays));
            }
            let (content, moving) = match &director {
                Some(director) => in_motion(content, director, &reading.shown)?,
                None => (content, None),
            };
            // What moves stays apart; parts that are hidden were shown before it was put in motion.
            let mut packed = match &moving {
                Some(moving) => moving.begun(packed_with(content, &[], self.memory.keeping_instances(true))?)?,
                None => packed_with(content, &reading.shown, self.memory)?,
            };
            if let Some(moving) = moving {
                tell(Told::Moves(moving.motion));
            }
            self.cuts.apply(&mut packed)?;
            CutArgs::warn_of_nothing(&packed, &report);
            Ok(packed)
        });
        content.map_err(|failure| failure.line())
    }

    fn save(&self, scene: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
        let notes = Arc::new(Mutex::new(Vec::new()));
        let kept = Arc::clone(&notes);
        let mut report = Report::to(Box::new(move |said| {
            if let Said::Text(text) = said {
                kept.lock().unwrap_or_else(PoisonError::into_inner).push(text.to_owned());
            }
        }));
        convert::write_shown(path, scene, &mut report).map_err(|failure| failure.line())?;
        drop(report);
        Ok(std::mem::take(&mut *notes.lock().unwrap_or_else(PoisonError::into_inner)))
    }

    fn volume(&self, source: &str, wanted: &Wanted) -> Result<Option<Volume>, String> {
        if scenes::NAMES.contains(&source) {
            return Ok(None);
        }
        let options = self.import.options(self.memory.in_memory);
        let opened = READERS.open(Path::new(source), &options).map_err(|error| error.to_string())?;
        if opened.reader().kind != Kind::Volume || wanted.is_over() {
            return Ok(None);
        }
        match opened.read() {
            Ok(Data::Volume(volume)) => Ok(Some(volume)),
            Ok(_) => Ok(None),
            Err(error) => Err(format!("no values: {error}")),
        }
    }

    fn run(&self, words: &[String], tell: Box<dyn Fn(Told) + Send>, wanted: &Wanted) -> Result<(), String> {
        beside::run(words, tell, wanted)
    }

    fn is_interrupted(&self) -> bool {
        interrupt::is_requested()
    }

    fn built_in(&self) -> Vec<(String, String)> {
        let about = |name: &str| {
            let Some(usual) = scenes::default_voxels(name) else {
                return format!("{} instances", scenes::FOREST_INSTANCES);
            };
            let voxels = self.voxels.unwrap_or(usual);
            format!("{:.1} million voxels", voxels as f64 / 1e6)
        };
        scenes::NAMES.iter().map(|&name| (name.to_owned(), about(name))).collect()
    }
}

#[cfg(test)]
mod tests;
