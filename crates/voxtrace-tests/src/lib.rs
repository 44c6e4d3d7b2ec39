//! What the tests across crates share: the reference traversal, sets of rays, scenes, and a synthetic terrain scan.

pub mod environments;
pub mod estimate;
pub mod gpu;
pub mod lattice;
pub mod moving;
pub mod phantom;
pub mod random;
pub mod rays;
pub mod reference;
pub mod rooms;
pub mod scenes;
pub mod still_lifes;
pub mod terrain;

/// The programs of the repository's page, tested.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
