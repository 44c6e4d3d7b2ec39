//! What the tests across tracers share: the reference walk, sets of rays, scenes to trace, land to scan.

pub mod estimate;
pub mod gpu;
pub mod moving;
pub mod random;
pub mod rays;
pub mod reference;
pub mod rooms;
pub mod scenes;
pub mod terrain;
