//! Tests across tracers: reference walk, physics, image comparison.
