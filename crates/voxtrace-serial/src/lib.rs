//! The names of rayon's loops on one thread, for WebAssembly without shared memory, where rayon's division of work is a fifth of a module's code and of
//! no use. Only what voxtrace uses of rayon is here; what a function does is said there.

#![forbid(unsafe_code)]

mod iterator;
mod slices;
mod threads;

pub use iterator::{IntoParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelExtend, Serial};
pub use slices::{ParallelSlice, ParallelSliceMut};
pub use threads::{
    Scope, ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder, current_num_threads, in_place_scope, join,
};

/// What programs take in whole.
pub mod prelude {
    pub use crate::{
        IntoParallelIterator, IntoParallelRefIterator, IntoParallelRefMutIterator, ParallelExtend, ParallelSlice,
        ParallelSliceMut,
    };
}

#[cfg(test)]
mod tests;
