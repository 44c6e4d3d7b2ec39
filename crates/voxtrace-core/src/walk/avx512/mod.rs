//! Packets with AVX-512: sixteen neighbours in the batch that start at one point, as camera rays do. `coherent` finds packets,
//! `beam` takes four of them through the empty space before them, `packet` takes them to their voxels with what `cells`
//! remembers, `hits` makes their hits. The steps are those of [`super::scalar`]; those that are too near to a plane go to [`super::exact`], as
//! there, so the voxels are the same.

#![expect(clippy::needless_range_loop, reason = "an axis or a lane indexes several arrays")]
#![expect(unsafe_code, reason = "vector loads, and calls of functions for certain processors")]

/// An array of a value for each of some values. As `map` of arrays, but its closure would not be inlined into functions that are compiled for certain
/// processors: it would be called, with all registers saved.
macro_rules! each {
    ($value:ident in [$($of:expr),+] => $body:expr) => {
        [$({
            let $value = $of;
            $body
        }),+]
    };
}

mod beam;
mod cells;
mod coherent;
mod hits;
mod octant;
mod packet;
mod records;
mod shared;
mod vectors;

pub use coherent::cast;
