//! Reading scenes from files.

mod error;
mod limits;

pub use error::{ImportError, ImportErrorKind};
pub use limits::Limits;
