//! The benchmark of voxtrace, without a command line: the study's measurement on this machine (frame times, rays and memory
//! of each traversal and primitive) as a report, two reports side by side, and what a machine has to trace with.
#![doc = include_str!("../README.md")]

mod against;
mod compare;
pub mod doctor;
mod error;
mod measure;
mod monitor;
mod numbers;
mod plan;
pub mod quantity;
mod reason;
mod report;
mod results;
mod run;
#[doc(hidden)]
pub mod shell;

pub use against::{Against, AgainstError};
pub use compare::{CompareError, CompareErrorKind, Comparison, rounds::Duel};
pub use error::BenchError;
pub use measure::{is_same_voxel, open_device};
pub use monitor::{Host, LoadedScene, Monitor};
pub use plan::{CellError, PlanError, PlanErrorKind, PlanFile, Request, SceneEntry};
pub use reason::reason;
pub use results::{Measurement, Results, ResumeError, ResumeErrorKind, Times};
pub use run::run;
