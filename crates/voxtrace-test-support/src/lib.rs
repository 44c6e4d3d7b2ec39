//! What the tests of all crates share: files that other programs have made ([`data`]), a tile of a scan ([`las_tile`]), one way for a test to be skipped
//! ([`skip`]), so that a run can say at its end which ones were, and tests in processes of their own ([`in_own_process`]).

mod alone;
mod data;
mod las;
mod own_process;
mod skip;

pub use alone::Alone;
pub use data::{data, files_below};
pub use las::las_tile;
pub use own_process::in_own_process;
pub use skip::{Need, skip, skip_without};
