//! Pools of threads, of which there is one: that which calls.

use std::convert::Infallible;

/// A pool without threads.
#[derive(Debug)]
pub struct ThreadPool;

impl ThreadPool {
    /// Calls `f`.
    pub fn install<R>(&self, f: impl FnOnce() -> R) -> R {
        f()
    }
}

/// Makes a pool.
#[derive(Debug, Default)]
pub struct ThreadPoolBuilder;

/// There is none.
pub type ThreadPoolBuildError = Infallible;

impl ThreadPoolBuilder {
    /// A pool of one thread.
    pub fn new() -> Self {
        Self
    }

    /// A pool of one thread, whatever is asked for.
    #[must_use]
    pub fn num_threads(self, _: usize) -> Self {
        self
    }

    /// The pool.
    ///
    /// # Errors
    /// None.
    pub fn build(self) -> Result<ThreadPool, ThreadPoolBuildError> {
        Ok(ThreadPool)
    }
}

/// One.
pub fn current_num_threads() -> usize {
    1
}

/// Calls both, the first one first.
pub fn join<A, B>(a: impl FnOnce() -> A, b: impl FnOnce() -> B) -> (A, B) {
    (a(), b())
}

/// Where work is begun that may go on beside what follows: here it is done at once.
#[derive(Debug)]
pub struct Scope;

impl Scope {
    /// Calls `f`.
    pub fn spawn(&self, f: impl FnOnce(&Self)) {
        f(self);
    }
}

/// Calls `f`.
pub fn in_place_scope<R>(f: impl FnOnce(&Scope) -> R) -> R {
    f(&Scope)
}
