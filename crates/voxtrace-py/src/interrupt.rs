//! Long work that Ctrl-C ends: it runs on a thread of its own, without the interpreter's lock, while this one looks for signals.

use crate::forks::detach;
use pyo3::prelude::*;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Time between two looks.
const PERIOD: Duration = Duration::from_millis(50);

/// Runs `work`, and calls `stop` once somebody interrupts it, or `tick`, which is called again and again, refuses. The exception is raised when `work` has
/// ended, which it should soon.
pub fn run<T: Send>(
    py: Python<'_>,
    stop: impl Fn() + Sync,
    tick: impl Fn(Python<'_>) -> PyResult<()> + Sync,
    work: impl FnOnce() -> T + Send,
) -> PyResult<T> {
    detach(py, || {
        thread::scope(|scope| {
            let (sender, receiver) = channel();
            scope.spawn(move || {
                // Whoever waits is there until this was sent.
                let _ = sender.send(work());
            });
            let mut interrupted = None;
            loop {
                match receiver.recv_timeout(PERIOD) {
                    Ok(value) => return interrupted.map_or(Ok(value), Err),
                    Err(RecvTimeoutError::Timeout) if interrupted.is_none() => {
                        interrupted = Python::attach(|py| py.check_signals().and_then(|()| tick(py)).err());
                        if interrupted.is_some() {
                            stop();
                        }
                    }
                    Err(RecvTimeoutError::Timeout) => {}
                    // The work panicked; the scope passes that on.
                    Err(RecvTimeoutError::Disconnected) => break,
                }
            }
            Err(interrupted.unwrap_or_else(|| pyo3::exceptions::PyRuntimeError::new_err("a fault of voxtrace")))
        })
    })?
}
