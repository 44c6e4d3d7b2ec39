//! Opening scenes on a thread of their own, with what is told meanwhile. The last scene that was asked for counts.

use crate::cloud::{PointsChoice, PointsSeen};
use crate::motion::{Motion, Plays};
use crate::threads;
use crate::tr;
use crate::transfer::ValuesSeen;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use voxtrace::changes::PartName;
use voxtrace::{PackedScene, Volume};
use voxtrace_bench::Measurement;

/// What a loader says while it works.
#[derive(Clone, Debug, PartialEq)]
pub enum Told {
    /// What it does, and which share of it is done, where that is known.
    Progress {
        /// For example "voxelizing".
        work: String,
        /// In [0, 1].
        share: Option<f32>,
        /// Seconds that are left, as far as can be told.
        seconds_left: Option<f64>,
    },
    /// A line for people about something in the file.
    Note(String),
    /// The file is read otherwise where the scene is cut: with what nobody sees inside.
    DependsOnCuts,
    /// The scene is a cloud of points: what they are.
    Points(Arc<PointsSeen>),
    /// The scene moves, and how.
    Moves(Arc<Motion>),
    /// The file brings something along that plays; what moves comes where it is asked for ([`Reading::moves`]).
    Plays(Plays),
    /// What a benchmark measured.
    Measured(Vec<Measurement>),
    /// The scene is a volume in memory: what its values are.
    Values(Arc<ValuesSeen>),
}

/// How a scene is to be read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Parts that its file hides and that are to be seen.
    pub shown: Vec<PartName>,
    /// Whether the window cuts it open.
    pub is_cut: bool,
    /// Whether it is the scene that was read last: a volume may be taken from memory.
    pub is_again: bool,
    /// Whether what moves is wanted.
    pub moves: bool,
    /// The TOML that says what else moves.
    pub animation: Option<PathBuf>,
    /// What was chosen about points, in place of what the command line says.
    pub points: Option<PointsChoice>,
    /// The transfer function of a volume, as `--transfer` has it, in place of that of the command line.
    pub transfer: Option<String>,
    /// Of a volume: how many voxels lie along its longest side at most, for a quick look.
    pub coarse: Option<u32>,
}

/// Whether a scene that is being read is still wanted.
#[derive(Clone, Debug, Default)]
pub struct Wanted(Arc<AtomicBool>);

impl Wanted {
    /// Whether nobody waits for the scene any more: reading it should end soon.
    pub fn is_over(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }

    /// Nobody waits for it any more.
    pub fn end(&self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

/// Reads scenes by their file's path or their name: the program around the window knows formats and their options.
pub trait Loader: Send + Sync {
    /// Reads a scene as long as it is `wanted`.
    ///
    /// # Errors
    /// One line for people: what is wrong, where, and what to do.
    fn load(
        &self,
        source: &str,
        reading: &Reading,
        tell: Box<dyn Fn(Told) + Send>,
        wanted: &Wanted,
    ) -> Result<PackedScene, String>;

    /// Runs a command of the program, as long as it is `wanted`: its words, `voxtrace` first. It makes what the command line makes.
    ///
    /// # Errors
    /// One line for people: what is wrong, where, and what to do.
    fn run(&self, words: &[String], tell: Box<dyn Fn(Told) + Send>, wanted: &Wanted) -> Result<(), String> {
        let _ = (tell, wanted);
        Err(format!("this window runs no commands: {}", words.join(" ")))
    }

    /// Whether somebody asked the program to end, by a signal say: then the window closes.
    fn is_interrupted(&self) -> bool {
        false
    }

    /// Writes a scene to a file, whose ending says how, whole or not at all. Returns what is to be said about it.
    ///
    /// # Errors
    /// One line for people: what is wrong, and what to do.
    fn save(&self, scene: &PackedScene, path: &Path) -> Result<Vec<String>, String>;

    /// Reads the volume that a scene was made of, as long as it is `wanted`; `None` where it was made of something else.
    ///
    /// # Errors
    /// One line for people: why there are no values.
    fn volume(&self, source: &str, wanted: &Wanted) -> Result<Option<Volume>, String> {
        let _ = (source, wanted);
        Ok(None)
    }

    /// Names of the scenes that need no file, each with a line about it.
    fn built_in(&self) -> Vec<(String, String)>;
}

/// A scene that is being opened.
pub struct Loading {
    /// Its path or name.
    pub source: String,
    /// Whether it is the scene that is shown, read again in another way.
    pub is_again: bool,
    /// What is done now.
    pub work: String,
    /// Which share of that is done.
    pub share: Option<f32>,
    /// Seconds that are left of it.
    pub seconds_left: Option<f64>,
    depends_on_cuts: bool,
    values: Option<Arc<ValuesSeen>>,
    points: Option<Arc<PointsSeen>>,
    motion: Option<Arc<Motion>>,
    plays: Plays,
    answers: Receiver<Answer>,
    wanted: Wanted,
}

impl Drop for Loading {
    fn drop(&mut self) {
        self.wanted.end();
    }
}

enum Answer {
    Told(Told),
    Done(Result<Box<PackedScene>, String>),
}

/// What has come of a loading since it was asked last.
#[derive(Default)]
pub struct Came {
    /// Whether the file is read otherwise where the scene is cut.
    pub depends_on_cuts: bool,
    /// What the values of a volume are.
    pub values: Option<Arc<ValuesSeen>>,
    /// What moves in it.
    pub motion: Option<Arc<Motion>>,
    /// What its file brings along that plays.
    pub plays: Plays,
    /// What its points are.
    pub points: Option<Arc<PointsSeen>>,
    /// Notes about the file.
    pub notes: Vec<String>,
    /// The scene, or why there is none.
    pub result: Option<Result<Arc<PackedScene>, String>>,
}

impl Loading {
    /// Begins to open a scene, or, where it `is_again`, the one that is shown, read in another way. `wake` is called whenever there is news.
    pub fn start(
        loader: &Arc<dyn Loader>,
        source: &str,
        reading: Reading,
        is_again: bool,
        wake: Arc<dyn Fn() + Send + Sync>,
    ) -> Self {
        let (sender, answers) = channel();
        let (loader, name) = (Arc::clone(loader), source.to_owned());
        let wanted = Wanted::default();
        let of_thread = wanted.clone();
        std::thread::spawn(move || {
            threads::yield_to_window();
            let (to_tell, told_wake) = (sender.clone(), Arc::clone(&wake));
            let tell = move |told| {
                // Nobody listens to what is not wanted any more.
                let _ = to_tell.send(Answer::Told(told));
                told_wake();
            };
            let read = catch_unwind(AssertUnwindSafe(|| loader.load(&name, &reading, Box::new(tell), &of_thread)));
            let result = read.unwrap_or_else(|_| Err(tr!("said.reading_failed", name = name)));
            let _ = sender.send(Answer::Done(result.map(Box::new)));
            wake();
        });
        Self {
            source: source.to_owned(),
            is_again,
            work: tr!("messages.work").to_owned(),
            share: None,
            seconds_left: None,
            depends_on_cuts: false,
            values: None,
            points: None,
            motion: None,
            plays: Plays::Nothing,
            answers,
            wanted,
        }
    }

    /// Takes what has come.
    pub fn take(&mut self) -> Came {
        let mut came = Came::default();
        loop {
            match self.answers.try_recv() {
                Ok(Answer::Told(Told::Progress { work, share, seconds_left })) => {
                    (self.work, self.share, self.seconds_left) = (work, share, seconds_left);
                }
                Ok(Answer::Told(Told::Note(note))) => came.notes.push(note),
                Ok(Answer::Told(Told::DependsOnCuts)) => self.depends_on_cuts = true,
                Ok(Answer::Told(Told::Points(points))) => self.points = Some(points),
                Ok(Answer::Told(Told::Measured(_))) => {}
                Ok(Answer::Told(Told::Moves(motion))) => self.motion = Some(motion),
                Ok(Answer::Told(Told::Plays(plays))) => self.plays = plays,
                Ok(Answer::Told(Told::Values(values))) => self.values = Some(values),
                Ok(Answer::Done(result)) => {
                    came.result = Some(result.map(|scene| Arc::new(*scene)));
                    came.depends_on_cuts = self.depends_on_cuts;
                    (came.values, came.points) = (self.values.take(), self.points.take());
                    (came.motion, came.plays) = (self.motion.take(), self.plays);
                }
                Err(TryRecvError::Empty) => return came,
                Err(TryRecvError::Disconnected) => {
                    return came;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::{Duration, Instant};

    /// Reads as long as the scene is wanted.
    struct Patient(Arc<AtomicBool>);

    impl Loader for Patient {
        fn load(
            &self,
            _: &str,
            _: &Reading,
            _: Box<dyn Fn(Told) + Send>,
            wanted: &Wanted,
        ) -> Result<PackedScene, String> {
            while !wanted.is_over() {
                std::thread::sleep(Duration::from_millis(1));
            }
            self.0.store(true, Ordering::Relaxed);
            Err("nobody waits".into())
        }

        fn save(&self, _: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
            Err(format!("{} is not written here", path.display()))
        }

        fn built_in(&self) -> Vec<(String, String)> {
            Vec::new()
        }
    }

    #[test]
    fn a_scene_that_nobody_waits_for_any_more_is_not_read_on() {
        let has_ended = Arc::new(AtomicBool::new(false));
        let loader: Arc<dyn Loader> = Arc::new(Patient(Arc::clone(&has_ended)));
        let mut loading = Loading::start(&loader, "a scene", Reading::default(), false, Arc::new(|| {}));
        assert!(loading.take().result.is_none() && !has_ended.load(Ordering::Relaxed), "it is read while it is wanted");
        drop(loading);
        let start = Instant::now();
        while !has_ended.load(Ordering::Relaxed) {
            assert!(start.elapsed() < Duration::from_secs(60), "it is read on");
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}
