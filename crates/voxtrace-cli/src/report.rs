//! Telling how far the work is, on stderr: a bar for people at a terminal, JSON lines for programs that ask, nothing
//! otherwise. stdout is left to results.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde_json::{Value, json};
use std::cell::RefCell;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use voxtrace_bench::quantity::clock;

/// How progress is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum ProgressStyleArg {
    /// A bar where stderr is a terminal, else nothing
    #[default]
    Auto,
    /// A bar
    Bar,
    /// JSON lines on stderr
    Json,
    /// Nothing
    None,
}

/// Time between two JSON lines.
const JSON_INTERVAL: Duration = Duration::from_millis(500);

/// What a listener is told.
#[cfg_attr(not(feature = "view"), allow(dead_code, reason = "only the window listens"))]
pub enum Said<'a> {
    /// A remark or a warning.
    Text(&'a str),
    /// What is done, which share of it, and how many seconds are left.
    Progress(&'a str, f32, Option<f64>),
}

/// Gets what would be written on stderr.
type Listener = Box<dyn Fn(Said) + Send>;

/// Shows progress and remarks.
pub struct Report {
    listener: Option<Listener>,
    style: ProgressStyleArg,
    quiet: bool,
    bar: Option<ProgressBar>,
    name: String,
    /// Whether it is samples that are counted.
    is_render: bool,
    start: Instant,
    last: Option<Instant>,
    /// Work done when this part began: it does not count for the speed.
    initial: u64,
    total: u64,
    /// Pictures that come after this one, and how many there were.
    following: (usize, u32),
    /// When the first picture began.
    first: Option<Instant>,
    /// Files below it are not named when they are written.
    unnamed: Option<PathBuf>,
    warnings: RefCell<Vec<String>>,
    not_shown: RefCell<Vec<String>>,
}

impl Report {
    pub fn new(style: ProgressStyleArg, quiet: bool) -> Self {
        let style = match style {
            _ if quiet => ProgressStyleArg::None,
            ProgressStyleArg::Auto if std::io::stderr().is_terminal() => ProgressStyleArg::Bar,
            ProgressStyleArg::Auto => ProgressStyleArg::None,
            style => style,
        };
        let start = Instant::now();
        Self {
            listener: None,
            style,
            quiet,
            bar: None,
            name: String::new(),
            is_render: true,
            start,
            last: None,
            initial: 0,
            total: 0,
            following: (0, 0),
            first: None,
            unnamed: None,
            warnings: RefCell::default(),
            not_shown: RefCell::default(),
        }
    }

    /// A report that tells a listener and nobody else.
    #[cfg(feature = "view")]
    pub fn to(listener: Listener) -> Self {
        Self { listener: Some(listener), ..Self::new(ProgressStyleArg::None, true) }
    }

    /// A remark for people, unless they asked for quiet; programs that asked for JSON get it as an event.
    pub fn remark(&self, text: &str) {
        match self.style {
            _ if self.listener.is_some() => self.tell(Said::Text(text)),
            ProgressStyleArg::Json => self.event(&json!({ "event": "remark", "text": text })),
            _ if self.quiet => {}
            _ => self.line(text),
        }
    }

    /// Something that went wrong without ending the work: said even when quiet.
    pub fn warn(&self, text: &str) {
        self.warnings.borrow_mut().push(text.to_owned());
        match self.style {
            _ if self.listener.is_some() => self.tell(Said::Text(text)),
            ProgressStyleArg::Json => self.event(&json!({ "event": "warning", "text": text })),
            _ => self.line(&format!("warning: {text}")),
        }
    }

    /// All that went wrong so far without ending the work.
    pub fn warnings(&self) -> Vec<String> {
        self.warnings.borrow().clone()
    }

    /// Keeps what a file asks for and is not shown, one phrase each, for whoever tells all of a file.
    pub fn leave_out(&self, phrases: Vec<String>) {
        self.not_shown.borrow_mut().extend(phrases);
    }

    /// What files ask for and is not shown.
    pub fn left_out(&self) -> Vec<String> {
        self.not_shown.borrow().clone()
    }

    /// Says that so many pictures come after the next one.
    pub fn follow(&mut self, pictures: usize) {
        self.following.0 = pictures;
    }

    /// Keeps files in a folder to itself: they are on the way to something else.
    pub fn leave_unnamed(&mut self, folder: PathBuf) {
        self.unnamed = Some(folder);
    }

    /// Seconds until all pictures are there, where this one has `left` to go.
    fn left_in_all(&self, left: Option<f64>) -> Option<f64> {
        let (following, done) = self.following;
        let left = left?;
        // What lies between pictures counts, too: they are written, and scenes posed.
        let each = (self.first?.elapsed().as_secs_f64() + left) / f64::from(done + 1);
        (following > 0).then_some(left + each * following as f64)
    }

    /// The share of all pictures that is done, and the seconds that are left, where this one is so far.
    fn of_all(&self, share: f32, left: Option<f64>) -> (f32, Option<f64>) {
        let (following, done) = self.following;
        if !self.is_render || following as u64 + u64::from(done) == 0 {
            return (share, left);
        }
        let all = (following + 1) as f32 + done as f32;
        ((done as f32 + share) / all, self.left_in_all(left).or(left))
    }

    /// Tells of a file that was written to those who read events alone.
    pub fn wrote_silently(&self, path: &Path) {
        if self.style == ProgressStyleArg::Json {
            self.event(&json!({ "event": "wrote", "path": path.display().to_string() }));
        }
    }

    /// Names on stdout a file that was written.
    pub fn wrote(&self, path: &Path) {
        if self.unnamed.as_ref().is_some_and(|folder| path.starts_with(folder)) {
            return;
        }
        self.wrote_silently(path);
        if !self.quiet {
            crate::stdout::print(&format!("{}\n", path.display()));
        }
    }

    /// Begins a part of the work: `total` samples of which `done` are there already.
    pub fn begin(&mut self, name: &str, done: u64, total: u64) {
        self.is_render = true;
        self.first.get_or_insert_with(Instant::now);
        self.start_part(name, done, total);
    }

    /// Begins a part of the work that counts no samples but pieces of its own.
    pub fn begin_work(&mut self, name: &str, total: u64) {
        self.is_render = false;
        self.start_part(name, 0, total);
    }

    fn start_part(&mut self, name: &str, done: u64, total: u64) {
        (self.name, self.initial, self.total) = (name.into(), done, total);
        (self.start, self.last) = (Instant::now(), None);
        if self.style == ProgressStyleArg::Bar {
            let template = "{prefix} [{wide_bar}] {percent:>3}% {msg}";
            let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
            let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr_with_hz(8));
            self.bar = Some(bar.with_style(style.progress_chars("=> ")).with_prefix(name.to_owned()));
        }
        self.update(done, None);
    }

    /// Says how much is done. `limit` is the time left until a time limit ends the work.
    pub fn update(&mut self, done: u64, limit: Option<Duration>) {
        let elapsed = self.start.elapsed().as_secs_f64();
        let speed = (done.saturating_sub(self.initial)) as f64 / elapsed.max(1e-6);
        let left = (speed > 0.0).then(|| self.total.saturating_sub(done) as f64 / speed);
        let eta = match (left, limit.map(|limit| limit.as_secs_f64())) {
            (Some(left), Some(limit)) => Some(left.min(limit)),
            (left, limit) => left.or(limit),
        };
        let share = (done as f64 / self.total.max(1) as f64) as f32;
        let (share_of_all, left_in_all) = self.of_all(share, eta);
        self.tell(Said::Progress(&self.name, share_of_all, left_in_all));
        if let Some(bar) = &self.bar {
            let in_all = self.left_in_all(eta).map_or_else(String::new, |all| format!(", {} in all", clock(all)));
            let eta = eta.map_or_else(String::new, |eta| format!(", {} left{in_all}", clock(eta)));
            bar.set_position(done);
            bar.set_message(if self.is_render {
                format!("{:.1} M samples/s{eta}", speed / 1e6)
            } else {
                eta.trim_start_matches([',', ' ']).to_owned()
            });
        }
        let is_due = self.last.is_none_or(|last| last.elapsed() >= JSON_INTERVAL) || done >= self.total;
        if self.style == ProgressStyleArg::Json && is_due {
            self.last = Some(Instant::now());
            let event = if self.is_render {
                json!({
                    "event": "progress",
                    "view": self.name,
                    "samples_done": done,
                    "samples_total": self.total,
                    "seconds": elapsed,
                    "seconds_left": eta,
                    "pictures_left": self.following.0,
                    "seconds_left_in_all": self.left_in_all(eta).or(eta),
                })
            } else {
                json!({
                    "event": "progress",
                    "work": self.name,
                    "done": done,
                    "total": self.total,
                    "seconds": elapsed,
                    "seconds_left": eta,
                })
            };
            self.event(&event);
        }
    }

    /// Ends the part that [`Self::begin`] began.
    pub fn end(&mut self) {
        if self.is_render {
            self.following.1 += 1;
        }
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }

    fn tell(&self, said: Said) {
        if let Some(listener) = &self.listener {
            listener(said);
        }
    }

    fn line(&self, text: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| eprint_line(text)),
            None => eprint_line(text),
        }
    }

    fn event(&self, value: &Value) {
        eprint_line(&value.to_string());
    }
}

/// Like `eprintln!`, but a closed stderr is no reason to panic.
fn eprint_line(text: &str) {
    let _ = writeln!(std::io::stderr(), "{text}");
}
