//! What a machine has to trace with, what is missing and how to get it; and what the probes of a driver said, for people and
//! for programs.

mod advice;
mod examination;
mod host;
mod manifests;
mod probes;
mod remedy;
mod tables;

pub use examination::Examination;
pub use probes::{probes_json, probes_markdown, probes_text};
