//! A tracer on the workers of a Dask cluster. The Python package has the cluster: it is started as a program of its own, gets the scene and the frame as
//! files, shares the samples among workers (`python/voxtrace/dask/`), and gives their film back.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, Read};
use std::path::PathBuf;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;
use tempfile::TempDir;
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::packed::Placement;
use voxtrace::{CpuTracer, Film, Frame, Hit, PackedScene, Progress, Ray, Region, TraceError, Tracer};

/// How often it is asked whether to stop.
const TICK: Duration = Duration::from_millis(50);
/// What says that Python lacks the package, or what it needs for clusters.
const LACKING: &str = "No module named";

/// Traces on a cluster.
pub struct ClusterTracer {
    address: String,
    /// What each worker traces on.
    device: String,
    python: OsString,
    /// For the files that both programs share; removed in the end. Nobody else can have made it, or links in it.
    folder: TempDir,
    scene: Option<Arc<PackedScene>>,
    film: Option<(Frame, Film)>,
}

impl ClusterTracer {
    /// A tracer on the workers of the scheduler at an address.
    pub fn new(address: &str, device: &str) -> Result<Self, TraceError> {
        let folder = tempfile::Builder::new().prefix("voxtrace-cluster-").tempdir().map_err(failed)?;
        let python = std::env::var_os("VOXTRACE_PYTHON").unwrap_or_else(|| "python3".into());
        Ok(Self { address: address.into(), device: device.into(), python, folder, scene: None, film: None })
    }

    fn scene_file(&self) -> PathBuf {
        self.folder.path().join("scene.vxt")
    }

    /// The film of a range of samples of a frame.
    fn share(&self, scene: &PackedScene, frame: &Frame, progress: &Progress) -> Result<Option<Film>, TraceError> {
        let (like, out) = (self.folder.path().join("frame.vxf"), self.folder.path().join("film.vxf"));
        // What the picture is like, with one pixel.
        let region = frame.region;
        let corner = Region { x1: region.x0 + 1, y1: region.y0 + 1, ..region };
        let empty = Film::new(frame.width, frame.height, corner, frame.first_sample);
        let like_frame = frame.clone().region(corner).aovs(false).samples(0);
        let file = FilmFile { frame: like_frame, scene: SceneStamp::of(scene), film: empty };
        file.save(&like).map_err(|error| failed(format!("{}: {error}", like.display())))?;
        let mut command = Command::new(&self.python);
        command.args(["-m", "voxtrace._program"]).arg(&self.address).arg(&self.device);
        command.arg(self.scene_file()).arg(&like);
        command.args(
            [frame.first_sample, frame.samples, region.x0, region.y0, region.x1, region.y1].map(|n| n.to_string()),
        );
        command.arg(&out).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // Ctrl-C in a terminal is for this program, which ends that one: it would say that it failed.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let child = command.spawn().map_err(|error| self.no_python(&error))?;
        let pixels = region.pixels() as u64 * u64::from(frame.samples);
        if !self.wait(child, pixels, progress)? {
            return Ok(None);
        }
        let film = FilmFile::open(&out).map_err(|error| failed(format!("{}: {error}", out.display())))?.film;
        Ok(Some(film))
    }

    /// Waits for the program, and says how far it is. Returns whether it came to its end.
    fn wait(&self, mut child: Child, samples: u64, progress: &Progress) -> Result<bool, TraceError> {
        let mut errors = child.stderr.take();
        let said = thread::spawn(move || {
            let mut text = String::new();
            let _ = errors.as_mut().map(|errors| errors.read_to_string(&mut text));
            text
        });
        let (sender, receiver) = channel();
        let output = child.stdout.take();
        thread::spawn(move || {
            let lines = output.into_iter().flat_map(|output| BufReader::new(output).lines());
            // The receiver is gone when nobody waits any more.
            let _ = lines.map_while(Result::ok).try_for_each(|line| sender.send(line));
        });
        let mut told = 0;
        // The program says more often than there is a tick how far it is: whether it is to stop is asked each time.
        while !progress.is_cancelled() {
            match receiver.recv_timeout(TICK) {
                Ok(line) => {
                    let done = (line.parse().unwrap_or(0.0_f64) * samples as f64) as u64;
                    progress.add(done.saturating_sub(told));
                    told = told.max(done);
                }
                Err(RecvTimeoutError::Disconnected) => break,
                Err(RecvTimeoutError::Timeout) => {}
            }
        }
        if progress.is_cancelled() {
            let _ = child.kill();
            let _ = child.wait();
            return Ok(false);
        }
        let status = child.wait().map_err(failed)?;
        if status.success() {
            return Ok(true);
        }
        let said = said.join().unwrap_or_default();
        let last = said.lines().rev().map(str::trim).find(|line| !line.is_empty()).unwrap_or("it ended without a word");
        if last.contains(LACKING) {
            return Err(failed(format!(
                "{} has no package for it ({last}): install the extra `cluster` of the package voxtrace, or name another Python by VOXTRACE_PYTHON",
                self.python.display()
            )));
        }
        Err(failed(last))
    }

    fn no_python(&self, error: &io::Error) -> TraceError {
        failed(format!(
            "{} does not start ({error}): the cluster needs Python with the extra `cluster` of the package voxtrace; VOXTRACE_PYTHON names one",
            self.python.display()
        ))
    }
}

fn failed(reason: impl ToString) -> TraceError {
    TraceError::Device { step: "rendering on the cluster".into(), reason: reason.to_string() }
}

impl Tracer for ClusterTracer {
    fn set_scene(&mut self, scene: &Arc<PackedScene>) -> Result<(), TraceError> {
        (self.film, self.scene) = (None, None);
        scene.save(&self.scene_file()).map_err(failed)?;
        self.scene = Some(Arc::clone(scene));
        Ok(())
    }

    fn set_placement(&mut self, placement: &Placement) -> Result<(), TraceError> {
        let scene = self.scene.as_ref().ok_or(TraceError::NoScene)?;
        let moved = Arc::new(scene.with_placement(placement)?);
        self.set_scene(&moved)
    }

    fn patch(&mut self, _: &voxtrace::dynamic::Patch) -> Result<(), TraceError> {
        Err(TraceError::Unsupported("a cluster follows no edits".into()))
    }

    fn cast_into(&mut self, rays: &[Ray], hits: &mut [Hit]) -> Result<(), TraceError> {
        let mut here = CpuTracer::new(None);
        here.set_scene(self.scene.as_ref().ok_or(TraceError::NoScene)?)?;
        here.cast_into(rays, hits)
    }

    fn render(&mut self, frame: &Frame, progress: &Progress) -> Result<(), TraceError> {
        frame.check()?;
        let scene = self.scene.clone().ok_or(TraceError::NoScene)?;
        frame.check_in(&scene)?;
        let mut film = match self.film.take() {
            Some((last, film)) if frame.continues(&last) => film,
            _ => Film::new(frame.width, frame.height, frame.region, frame.first_sample),
        };
        if frame.aovs && film.aovs.is_none() {
            let mut here = CpuTracer::new(None);
            here.set_scene(&scene)?;
            here.render(&frame.clone().samples(0), &Progress::default())?;
            let mut found = Film::new(0, 0, frame.region, 0);
            here.read(&mut found)?;
            film.aovs = found.aovs;
        }
        let (least, most) = film.sample_range();
        if least != most {
            return Err(TraceError::BadFrame("a cluster goes on with films whose pixels have the same samples".into()));
        }
        if most < frame.samples {
            let part = frame.clone().first_sample(frame.first_sample + most).samples(frame.samples - most);
            match self.share(&scene, &part, progress)? {
                Some(more) if most == 0 => film.pixels = more.pixels,
                Some(more) => film.merge(&more).map_err(failed)?,
                None => {}
            }
        }
        self.film = Some((frame.clone(), film));
        Ok(())
    }

    fn read(&mut self, film: &mut Film) -> Result<(), TraceError> {
        film.clone_from(&self.film.as_ref().ok_or(TraceError::NoFilm)?.1);
        Ok(())
    }

    fn resume(&mut self, frame: &Frame, film: Film) -> Result<(), TraceError> {
        frame.check()?;
        frame.check_film(&film)?;
        self.film = Some((frame.clone(), film));
        Ok(())
    }

    fn set_moment(&mut self, placement: Option<&Placement>, frame: &Frame) -> Result<(), TraceError> {
        let (_, film) = self.film.take().ok_or(TraceError::NoFilm)?;
        if let Some(placement) = placement {
            self.set_placement(placement)?;
        }
        self.resume(frame, film)
    }
}
