//! Results, on stdout.

use crate::failure::{Failure, Kind, reason};
use std::io::{ErrorKind, IsTerminal, Write};
use std::sync::OnceLock;

/// What stdout said when something could not be printed: the first time.
static LOST: OnceLock<std::io::Error> = OnceLock::new();

/// Whether stdout was a terminal when the program began.
static IS_TERMINAL: OnceLock<bool> = OnceLock::new();

/// Asks whether stdout is a terminal: once that is closed, the system no longer says that it was one.
pub fn begin() {
    let _ = IS_TERMINAL.set(std::io::stdout().is_terminal());
}

/// Prints to stdout. A reader that has gone away (`voxtrace … | head`, a terminal that was closed) is no failure; of any other, [`lost`] tells.
pub fn print(text: &str) {
    let mut stdout = std::io::stdout().lock();
    keep(stdout.write_all(text.as_bytes()).and_then(|()| stdout.flush()));
}

/// Keeps for [`lost`] what went wrong when something was printed.
pub fn keep(printed: std::io::Result<()>) {
    match printed {
        Err(error) if error.kind() != ErrorKind::BrokenPipe && IS_TERMINAL.get() != Some(&true) => {
            drop(LOST.set(error));
        }
        _ => {}
    }
}

/// A failure where results were lost: a plan on a full disk must not pass for a whole one.
pub fn lost() -> Result<(), Failure> {
    LOST.get().map_or(Ok(()), |error| {
        Err(Failure::new(Kind::Output, format!("cannot write to standard output: {}", reason(error))))
    })
}
