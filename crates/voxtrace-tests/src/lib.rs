//! What the tests across tracers share: the reference walk, sets of rays, scenes to trace.

pub mod estimate;
pub mod gpu;
pub mod random;
pub mod rays;
pub mod reference;
pub mod rooms;
pub mod scenes;
