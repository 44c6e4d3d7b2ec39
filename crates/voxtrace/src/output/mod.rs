//! Pictures out: a film becomes a PNG for people, an EXR for compositors, or a film file that a later run continues.
//! Every writer is deterministic: the same film gives the same bytes.

mod atomic;
mod exr;
mod film_file;
mod film_format;
mod metadata;
mod png;
mod tone_map;

pub(crate) use atomic::{TemporaryFile, check_replaceable, follow_link};
pub use atomic::{check_writable, write_atomically};
pub use exr::{ExrOptions, write_exr};
pub use film_file::{FilmFile, FilmFileError, SceneStamp};
pub use metadata::Metadata;
pub use png::{PngDepth, PngOptions, write_png};
pub use tone_map::{Operator, ToneMap};
