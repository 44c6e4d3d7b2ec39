//! Two programs measured in turns: a child process each, with the same options, in several rounds, whose results are put side by side.

use crate::compare::rounds::Duel;
use crate::compare::{self, CompareError, CompareErrorKind};
use crate::error::BenchError;
use crate::monitor::Monitor;
use crate::plan::Request;
use crate::reason::reason;
use serde_json::Value;
use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// How often the children are looked after.
const PATIENCE: Duration = Duration::from_millis(20);

/// What is to be measured.
pub struct Against {
    /// A, and B.
    pub programs: [PathBuf; 2],
    /// How often each of them measures all cells.
    pub rounds: u32,
    /// What both are told: the words up to the verb, and those behind it, without those about the report and about frames.
    pub words: [Vec<OsString>; 2],
    /// The folder of the results; each round has two below it.
    pub output: PathBuf,
    /// Frames of each cell in one round, and most time for them.
    pub frames: u32,
    /// Most time of a cell's frames in one round, milliseconds.
    pub limit_ms: u64,
    /// Whether the words say a size of the pictures.
    pub has_size: bool,
}

/// Why two programs cannot be measured in turns.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AgainstError {
    /// What is asked for makes no sense.
    #[error(transparent)]
    Request(#[from] BenchError),
    /// A program cannot be run.
    #[error("{} cannot be run: {}", program.display(), reason(source))]
    Start {
        /// Which one.
        program: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A program is none of ours.
    #[error("{} is no voxtrace: asked for its version, it {says}", program.display())]
    Foreign {
        /// Which one.
        program: PathBuf,
        /// What it did instead.
        says: String,
    },
    /// A program ended without having measured.
    #[error("{} did not measure: {says}", program.display())]
    Failed {
        /// Which one.
        program: PathBuf,
        /// The last thing it said, or how it ended.
        says: String,
    },
    /// What a program wrote is no report of this version.
    #[error("{} wrote no results that can be read: {source}", program.display())]
    Report {
        /// Which one.
        program: PathBuf,
        /// What is wrong.
        source: CompareError,
    },
}

impl Against {
    /// Measures in turns; who begins changes from round to round. An interrupted one ends with the rounds that are whole.
    ///
    /// # Errors
    /// If a program cannot be run, does not measure what it is asked for, or writes other results than this version.
    pub fn run(&self, request: &Request, monitor: &mut dyn Monitor) -> Result<Duel, AgainstError> {
        request.named_cells().map_err(BenchError::from)?;
        self.greet()?;
        std::fs::create_dir_all(&self.output).map_err(|source| BenchError::output(&self.output, source))?;
        let mut rounds: Vec<[Value; 2]> = Vec::new();
        let mut size = None;
        let mut duel = self.told(&rounds)?;
        monitor.begin("rounds", u64::from(self.rounds) * 2);
        'all: for round in 1..=self.rounds {
            let mut pair = [Value::Null, Value::Null];
            // A begins, and chooses the size of the pictures where none is said.
            for (turn, side) in if round % 2 == 1 { [0, 1] } else { [1, 0] }.into_iter().enumerate() {
                let Some(report) = self.turn(round, side, size, monitor)? else { break 'all };
                let sides = ["width", "height"].map(|name| report["settings"][name].as_u64());
                size = size.or_else(|| sides[0].zip(sides[1]));
                pair[side] = report;
                monitor.update(u64::from(round - 1) * 2 + turn as u64 + 1);
            }
            rounds.push(pair);
            duel = self.told(&rounds)?;
        }
        monitor.end();
        Ok(duel)
    }

    /// Puts the rounds so far side by side and writes down what came of it.
    fn told(&self, rounds: &[[Value; 2]]) -> Result<Duel, AgainstError> {
        let duel = Duel::of(self.programs.each_ref().map(|program| program.display().to_string()), rounds);
        let path = self.output.join("against.json");
        let text = format!("{:#}\n", duel.json());
        voxtrace::output::write_atomically(&path, |out| io::Write::write_all(out, text.as_bytes()))
            .map_err(|source| BenchError::output(&path, source))?;
        Ok(duel)
    }

    /// Asks B for its version, so that what cannot measure is known before anything is measured.
    fn greet(&self) -> Result<(), AgainstError> {
        let program = &self.programs[1];
        let said = Command::new(program).arg("--version").stdin(Stdio::null()).stderr(Stdio::null()).output();
        let said = said.map_err(|source| AgainstError::Start { program: program.clone(), source })?;
        let text = String::from_utf8_lossy(&said.stdout);
        let foreign = |says: String| Err(AgainstError::Foreign { program: program.clone(), says });
        match text.lines().next() {
            _ if !said.status.success() => foreign(format!("ended with {}", said.status)),
            Some(line) if line.starts_with("voxtrace ") => Ok(()),
            Some(line) => foreign(format!("says {line:?}")),
            None => foreign("says nothing".into()),
        }
    }

    /// One round of one program: its report, or `None` where it was interrupted.
    fn turn(
        &self,
        round: u32,
        side: usize,
        size: Option<(u64, u64)>,
        monitor: &mut dyn Monitor,
    ) -> Result<Option<Value>, AgainstError> {
        let program = &self.programs[side];
        let folder = self.output.join(format!("round-{round}-{}", ["a", "b"][side]));
        // What an earlier round left must not be taken for this one's.
        let results = folder.join("results.json");
        match std::fs::remove_file(&results) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => {
                return Err(BenchError::output(&results, error).into());
            }
            _ => {}
        }
        let mut command = Command::new(program);
        command.args(&self.words[0]).arg("-o").arg(&folder).arg("--quiet").args(["--sweep", "none"]);
        command.args(["--frames", &self.frames.to_string(), "--time-limit", &format!("{}ms", self.limit_ms)]);
        if let Some((width, height)) = size.filter(|_| !self.has_size) {
            command.args(["--size", &format!("{width}x{height}")]);
        }
        command.args(&self.words[1]).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
        let start = |source| AgainstError::Start { program: program.clone(), source };
        let child = command.spawn().map_err(start)?;
        let Some((is_well, says)) = waited(child, monitor).map_err(start)? else { return Ok(None) };
        if !is_well {
            return Err(AgainstError::Failed { program: program.clone(), says });
        }
        read(&folder).map(Some).map_err(|source| AgainstError::Report { program: program.clone(), source })
    }
}

/// The report of a folder, which must have cells.
fn read(folder: &Path) -> Result<Value, CompareError> {
    let report = compare::read(folder)?;
    if report["cells"].is_array() {
        return Ok(report);
    }
    Err(CompareError { path: folder.join("results.json"), kind: CompareErrorKind::NoReport })
}

/// Waits for a child: whether it ended well, and the last line that it said. `None` where the monitor wants to end.
fn waited(mut child: Child, monitor: &dyn Monitor) -> io::Result<Option<(bool, String)>> {
    let mut messages = child.stderr.take();
    let listener = std::thread::spawn(move || {
        let mut text = Vec::new();
        messages.as_mut().map(|messages| io::Read::read_to_end(messages, &mut text));
        String::from_utf8_lossy(&text).into_owned()
    });
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if monitor.is_interrupted() {
            child.kill()?;
            child.wait()?;
            return Ok(None);
        }
        std::thread::sleep(PATIENCE);
    };
    if monitor.is_interrupted() {
        return Ok(None);
    }
    let said = listener.join().unwrap_or_default();
    let last = said.lines().map(str::trim).rfind(|line| !line.is_empty());
    let says =
        last.map_or_else(|| format!("it ended with {status}"), |line| line.trim_start_matches("error: ").to_owned());
    Ok(Some((status.success(), says)))
}

#[cfg(all(test, unix))]
mod tests;
