//! SIGINT and SIGTERM: the first one asks the work to end well, the second one ends the process at once.

use crate::failure::{Failure, Kind};
use std::cell::RefCell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

static REQUESTED: AtomicBool = AtomicBool::new(false);
/// Whether the first signal ends the process, too.
static AT_ONCE: AtomicBool = AtomicBool::new(false);

/// Whether work is to stop.
type IsOver = Arc<dyn Fn() -> bool + Send + Sync>;

thread_local! {
    /// What else asks the work of this thread to stop.
    static ALSO_WHEN: RefCell<Option<IsOver>> = const { RefCell::new(None) };
}

/// From now on the work of this thread is interrupted when `is_over` says so, too: a scene that a window does not wait for any more.
#[cfg(feature = "view")]
pub fn also_when(is_over: impl Fn() -> bool + Send + Sync + 'static) {
    ALSO_WHEN.set(Some(Arc::new(is_over)));
}

/// Installs the handler, once in a process.
pub fn install() -> Result<(), Failure> {
    let handler = || {
        if REQUESTED.swap(true, Ordering::SeqCst) || AT_ONCE.load(Ordering::SeqCst) {
            std::process::exit(Kind::Interrupted as i32);
        }
    };
    ctrlc::set_handler(handler).map_err(|error| Failure::other(format!("cannot handle signals: {error}")))
}

/// From now on the first signal ends the process at once: for work that keeps nothing, and looks for no end within minutes.
#[cfg(feature = "view")]
pub fn end_at_once() -> Result<(), Failure> {
    AT_ONCE.store(true, Ordering::SeqCst);
    check()
}

/// Whether somebody asked to stop.
pub fn is_requested() -> bool {
    REQUESTED.load(Ordering::SeqCst) || ALSO_WHEN.with_borrow(|also| also.as_ref().is_some_and(|is_over| is_over()))
}

/// Whether nobody asked the work of this thread to stop, for other threads that do a part of it.
pub fn watch() -> impl Fn() -> bool + Sync {
    let also = ALSO_WHEN.with_borrow(Clone::clone);
    move || !(REQUESTED.load(Ordering::SeqCst) || also.as_ref().is_some_and(|is_over| is_over()))
}

/// The end of work that was interrupted before there was anything to keep.
pub fn check() -> Result<(), Failure> {
    if is_requested() { Err(failure()) } else { Ok(()) }
}

/// That end.
pub fn failure() -> Failure {
    Failure::new(Kind::Interrupted, "interrupted")
}
