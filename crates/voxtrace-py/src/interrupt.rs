//! Long work that Ctrl-C ends: it runs on a thread of its own, without the interpreter's lock, while this one looks for signals.

use crate::forks::detach;
use pyo3::prelude::*;
use std::cell::Cell;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

/// Time between two looks.
const PERIOD: Duration = Duration::from_millis(50);

thread_local! {
    /// Whether this thread is within a handler of a signal that came while it worked or waited here.
    static IN_HANDLER: Cell<bool> = const { Cell::new(false) };
}

/// Looks for signals.
fn look(py: Python<'_>) -> PyResult<()> {
    let before = IN_HANDLER.replace(true);
    let looked = py.check_signals();
    IN_HANDLER.set(before);
    looked
}

/// Whether work or waiting of this thread goes on only once the handler of a signal has returned, which this is called from.
pub fn is_in_handler() -> bool {
    IN_HANDLER.get()
}

/// Lets other threads run for a while.
///
/// # Errors
/// What a signal raises.
pub fn pause(py: Python<'_>, time: Duration) -> PyResult<()> {
    detach(py, || thread::sleep(time))?;
    look(py)
}

/// As [`run`], of work that is told how to ask whether somebody still waits for it.
pub fn run_while<T: Send>(py: Python<'_>, work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T + Send) -> PyResult<T> {
    let wanted = AtomicBool::new(true);
    let stop = || wanted.store(false, Ordering::Relaxed);
    run(py, stop, |_| Ok(()), || work(&|| wanted.load(Ordering::Relaxed)))
}

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
                        interrupted = Python::attach(|py| look(py).and_then(|()| tick(py)).err());
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
