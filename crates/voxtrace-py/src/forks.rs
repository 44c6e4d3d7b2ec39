//! Processes that were forked, as `multiprocessing` does on some systems: the threads that all work shares stay with the parent, and a child that waited for
//! them would wait for ever. It is told so instead: whatever may use those threads, or waits for a lock that one of them may have held, goes through [`detach`]
//! or [`check`]. `python/tests/test_forks.py` calls all that is public in such a child.

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::process;
use std::sync::atomic::{AtomicU32, Ordering};

/// The process whose threads work; 0 before there was any work.
static OWNER: AtomicU32 = AtomicU32::new(0);

/// Before work that threads share.
///
/// # Errors
/// `RuntimeError` in a child of a process that has worked before.
pub fn check() -> PyResult<()> {
    let own = process::id();
    match OWNER.compare_exchange(0, own, Ordering::Relaxed, Ordering::Relaxed) {
        Err(owner) if owner != own => Err(PyRuntimeError::new_err(
            "this process was forked from one that has worked with voxtrace, and the threads that do the work did not come along: start it anew, as \
             multiprocessing.get_context(\"spawn\") does",
        )),
        _ => Ok(()),
    }
}

/// Does work without the interpreter's lock.
///
/// # Errors
/// As [`check`].
pub fn detach<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    check()?;
    Ok(py.detach(work))
}
