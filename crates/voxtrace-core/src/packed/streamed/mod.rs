//! Files for streaming: a scene and all its levels of detail in compressed chunks, the coarsest level first, so that a picture can be made of the first bytes and
//! refined by those parts that it needs. `docs/format.md` has the layout, `docs/decisions/0214-files-for-streaming.md` says why it is so.
//!
//! `chunk` is a chunk and its bytes, `head` what stands before the chunks. `whole` makes the scene of all chunks of a level, `mixed` one of chunks of several levels, with the `nearest_material` where there are too many.
//! Where there are files, `read` opens one and `write` writes one; in pages a worker fetches and inflates the parts itself.

mod chunk;
mod head;
mod mixed;
mod nearest_material;
#[cfg(not(target_arch = "wasm32"))]
mod read;
mod whole;
#[cfg(not(target_arch = "wasm32"))]
mod write;

pub use head::StreamHead;
pub use mixed::StreamedLevels;
pub(super) use read::{ranges_of, scene_of, summary_of};
pub use whole::WholeLevel;
#[cfg(not(target_arch = "wasm32"))]
pub use write::rewrite_for_streaming;

/// The tag of what stands before the chunks of a level.
#[cfg(not(target_arch = "wasm32"))]
fn front_tag(level: u32) -> [u8; 4] {
    [b'F', b'R', b'0' + (level / 10) as u8, b'0' + (level % 10) as u8]
}

/// The tag of the chunks of a level.
#[cfg(not(target_arch = "wasm32"))]
fn chunks_tag(level: u32) -> [u8; 4] {
    [b'C', b'H', b'0' + (level / 10) as u8, b'0' + (level % 10) as u8]
}

/// What pages have in the place of `read`: there the worker that fetches a file opens it part by part.
#[cfg(target_arch = "wasm32")]
mod read {
    use crate::packed::{FileErrorKind, PackedScene, section_reader::Reader};
    use std::ops::Range;

    fn elsewhere<T>() -> Result<T, FileErrorKind> {
        Err(FileErrorKind::Invalid("a file for streaming is opened part by part".into()))
    }

    pub fn scene_of(_reader: &Reader, _level: u32) -> Result<PackedScene, FileErrorKind> {
        elsewhere()
    }

    pub fn summary_of(_reader: &Reader, _level: u32) -> Result<u64, FileErrorKind> {
        elsewhere()
    }

    pub fn ranges_of(_reader: &Reader) -> Result<Vec<(Range<usize>, u64)>, FileErrorKind> {
        elsewhere()
    }
}
