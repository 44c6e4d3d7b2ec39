//! What to measure: the cells, a plan's file, what somebody asks for, and the settings that come of it.

mod cell;
mod file;
mod request;
mod settings;

pub use cell::{Cell, CellError, parse};
pub use file::{PlanError, PlanErrorKind, PlanFile, SceneEntry};
pub use request::Request;
pub use settings::{LEAST_FRAMES, Plan, STUDY_SIZE};
