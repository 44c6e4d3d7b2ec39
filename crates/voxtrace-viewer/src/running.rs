//! A command of the program that runs beside the window, on a thread of its own: recording a clip, or a whole benchmark. What it makes is what the same
//! command makes on the command line.

use crate::load::{Loader, Told, Wanted};
use crate::session::{Command, Session};
use crate::threads;
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use voxtrace_bench::Measurement;

/// What is to run.
#[derive(Clone, Debug, PartialEq)]
pub struct RunRequest {
    /// The words of the command, `voxtrace` first.
    pub words: Vec<String>,
    /// What it makes, for people.
    pub name: String,
    /// Folders that it writes to and that may not be there yet.
    pub folders: Vec<PathBuf>,
    /// Whether it measures: nothing else is traced meanwhile.
    pub measures: bool,
}

/// A command on its way.
pub struct Running {
    /// What was asked for.
    pub request: RunRequest,
    /// What is done now.
    pub work: String,
    /// Which share of it is done.
    pub share: Option<f32>,
    /// Seconds that are left of all of it.
    pub seconds_left: Option<f64>,
    /// Whether somebody asked it to stop.
    pub is_stopping: bool,
    measured: Option<Vec<Measurement>>,
    answers: Receiver<Answer>,
    wanted: Wanted,
    thread: Option<std::thread::JoinHandle<()>>,
}

enum Answer {
    Told(Told),
    Done(Result<(), String>),
}

impl Running {
    /// Begins to run a command. `wake` is called whenever there is news.
    pub fn start(loader: &Arc<dyn Loader>, request: RunRequest, wake: Arc<dyn Fn() + Send + Sync>) -> Self {
        let (sender, answers) = channel();
        let wanted = Wanted::default();
        let (loader, own, of_thread) = (Arc::clone(loader), request.clone(), wanted.clone());
        let thread = std::thread::spawn(move || {
            if !own.measures {
                threads::yield_to_window();
            }
            let (to_tell, told_wake) = (sender.clone(), Arc::clone(&wake));
            let tell = move |told| {
                // The window may be closed.
                let _ = to_tell.send(Answer::Told(told));
                told_wake();
            };
            let made = own.folders.iter().try_for_each(|folder| {
                std::fs::create_dir_all(folder)
                    .map_err(|error| tr!("running.no_folder", folder = folder.display(), error = error))
            });
            let run = || made.and_then(|()| loader.run(&own.words, Box::new(tell), &of_thread));
            let done = catch_unwind(AssertUnwindSafe(run));
            let done = done.unwrap_or_else(|_| Err(tr!("running.failed", name = own.name)));
            let _ = sender.send(Answer::Done(done));
            wake();
        });
        let (work, thread) = (tr!("running.beginning").to_owned(), Some(thread));
        let measured = None;
        Self { request, work, share: None, seconds_left: None, is_stopping: false, measured, answers, wanted, thread }
    }

    /// Asks it to stop.
    pub fn cancel(&mut self) {
        self.is_stopping = true;
        self.wanted.end();
    }

    /// Takes what has come: lines for people, and how it ended.
    fn take(&mut self) -> (Vec<String>, Option<Result<(), String>>) {
        let mut notes = Vec::new();
        loop {
            match self.answers.try_recv() {
                Ok(Answer::Told(Told::Progress { work, share, seconds_left })) => {
                    (self.work, self.share, self.seconds_left) = (work, share, seconds_left);
                }
                Ok(Answer::Told(Told::Note(note))) => notes.push(note),
                Ok(Answer::Told(Told::Measured(measured))) => self.measured = Some(measured),
                Ok(Answer::Told(_)) => {}
                Ok(Answer::Done(done)) => return (notes, Some(done)),
                Err(TryRecvError::Empty) => return (notes, None),
                Err(TryRecvError::Disconnected) => return (notes, Some(Err(tr!("running.no_word").into()))),
            }
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.wanted.end();
        if let Some(thread) = self.thread.take() {
            // A panic was caught and told.
            let _ = thread.join();
        }
    }
}

impl Session {
    /// Runs a command beside the window, unless one runs.
    pub fn run_command(&mut self, request: RunRequest) {
        if self.running.is_some() || self.exporting.is_some() {
            self.say(tr!("running.busy"), true);
            return;
        }
        self.dialog = None;
        self.ask(Command::Run(Box::new(request)));
    }

    /// Takes what has come of a command. Returns it when it has ended well.
    pub fn take_running(&mut self) -> Option<RunRequest> {
        let running = self.running.as_mut()?;
        let (notes, done) = running.take();
        // While it works, the bar says what it does.
        let is_of_work = |note: &String| note.starts_with("load") || note.contains(" a pixel in ");
        notes.into_iter().filter(|note| !is_of_work(note)).for_each(|note| self.say(note, false));
        let done = done?;
        let mut running = self.running.take()?;
        if let Some(measured) = running.measured.take() {
            self.measured = Some(measured);
        }
        if running.request.measures {
            self.ask(Command::Pause(self.pause()));
        }
        match done {
            Ok(()) => {
                self.say(tr!("said.written", name = running.request.name, kept = ""), false);
                Some(running.request.clone())
            }
            Err(_) if running.is_stopping => {
                self.say(tr!("running.stopped", name = running.request.name), false);
                None
            }
            Err(error) => {
                self.say(error, true);
                None
            }
        }
    }
}
