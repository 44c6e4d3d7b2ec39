//! SIGINT and SIGTERM: the first one asks the work to end well, the second one ends the process at once.

use crate::failure::{Failure, Kind};
use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);

/// Installs the handler, once in a process.
pub fn install() -> Result<(), Failure> {
    let handler = || {
        if REQUESTED.swap(true, Ordering::SeqCst) {
            std::process::exit(Kind::Interrupted as i32);
        }
    };
    ctrlc::set_handler(handler).map_err(|error| Failure::other(format!("cannot handle signals: {error}")))
}

/// Whether somebody asked to stop.
pub fn is_requested() -> bool {
    REQUESTED.load(Ordering::SeqCst)
}

/// The end of work that was interrupted before there was anything to keep.
pub fn check() -> Result<(), Failure> {
    if is_requested() { Err(Failure::new(Kind::Interrupted, "interrupted")) } else { Ok(()) }
}
