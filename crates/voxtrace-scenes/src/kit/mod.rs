//! The modelling kit behind the built-in scenes: solids with signed distances, paints, and the extraction of the thin
//! uneven shell that a photogrammetry scan would leave. [`super`] shows how to model with it.

pub mod model;
pub mod noise;
pub mod paint;
pub mod patterns;
pub mod profile;
mod program;
pub mod shape;
mod shell;
pub mod solid;

pub use model::Model;
pub use paint::{Paint, Palette, Ramp, SurfacePoint, Tone};
pub use profile::Profile;
pub use shape::{Axis, Shape};
pub use solid::*;
