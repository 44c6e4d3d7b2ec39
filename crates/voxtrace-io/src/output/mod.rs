//! Pictures out: a film becomes a PNG for people, an EXR for compositors, or a film file that a later run continues.
//! Every writer is deterministic: the same film gives the same bytes.

#[cfg(feature = "pictures")]
mod background;
#[cfg(feature = "pictures")]
pub mod clip;
#[cfg(feature = "pictures")]
mod exr;
mod film_file;
mod film_format;
mod film_input;
mod metadata;
#[cfg(feature = "pictures")]
mod picture;
#[cfg(feature = "pictures")]
mod png;
mod tone_bytes;
mod tone_map;

#[cfg(feature = "pictures")]
pub use exr::{ExrOptions, write_exr};
pub use film_file::{FilmFile, FilmFileError, SceneStamp};
pub use film_format::MAGIC as FILM_MAGIC;
pub use metadata::Metadata;
#[cfg(feature = "pictures")]
pub use picture::{Denoised, PictureFormat, PictureOptions};
#[cfg(feature = "pictures")]
pub(crate) use png::into_io as png_error;
#[cfg(feature = "pictures")]
pub use png::{PngDepth, PngOptions, write_png};
pub use tone_bytes::ToneBytes;
pub use tone_map::{Operator, ToneMap};
pub use voxtrace_core::atomic_file::{check_writable, write_atomically};
