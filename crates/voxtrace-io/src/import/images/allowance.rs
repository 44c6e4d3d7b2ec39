//! How much pictures may become. Their headers say it, and it is held against the bytes that there are before anything is unpacked: no more
//! comes of a byte than the format's compression can make of it.

use std::fmt;
use std::path::Path;
#[cfg(feature = "rasters")]
use voxtrace_voxelize::ImportErrorKind;
use voxtrace_voxelize::{ImportError, Limits};

/// Bytes that may come out of any picture.
const FREE: u64 = 16 << 20;

/// A kind of compression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Packing {
    /// PNG: Deflate makes at most 1,032 bytes of one.
    Deflate,
    /// TIFF: also LZW, whose longest strings have some 3,800 bytes for a code of twelve bits.
    Tiff,
    /// TIFF in Zstandard, a block of which repeats a byte 131,072 times for four, or JPEG 2000, where what is even takes some bits.
    #[cfg(feature = "rasters")]
    TiffAnew,
    /// JPEG: a block of 64 pixels takes some bits.
    Jpeg,
    /// WebP: pixels that are all alike take no bits at all.
    Webp,
}

/// Why a picture is not read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Refused {
    /// It would become more than it may.
    TooLarge { width: u32, height: u32, bytes: u64, limit: u64 },
    /// It contradicts its format.
    Malformed(String),
    /// It is of a kind that is not read.
    #[cfg(feature = "rasters")]
    Foreign(String),
}

/// Checks that `count` pixels (of pages of `width` x `height`) of `pixel_bits` each, as the format stores them, may be unpacked from so many bytes.
pub(crate) fn check(
    (width, height, count): (u32, u32, u64),
    pixel_bits: u64,
    packed: u64,
    packing: Packing,
    limits: &Limits,
) -> Result<(), Refused> {
    let bytes = count.saturating_mul(pixel_bits) / 8;
    let (free, ratio) = match packing {
        Packing::Deflate | Packing::Jpeg => (FREE, 1032),
        Packing::Tiff => (FREE, 2600),
        #[cfg(feature = "rasters")]
        Packing::TiffAnew => (16 * FREE, 32_768),
        Packing::Webp => (16 * FREE, 1032),
    };
    let limit = packed.saturating_mul(ratio.max(limits.ratio)).max(free).min(limits.bytes);
    if bytes > limit { Err(Refused::TooLarge { width, height, bytes, limit }) } else { Ok(()) }
}

impl Refused {
    /// The fault of a file that is such a picture.
    pub fn into_import_error(self, path: &Path) -> ImportError {
        match self {
            Self::TooLarge { width, height, bytes, limit } => {
                let what = format!("bytes of pixels, of {width} x {height},");
                ImportError::limit(path, None, what, bytes, limit)
            }
            Self::Malformed(what) => ImportError::malformed(path, 0, what),
            #[cfg(feature = "rasters")]
            Self::Foreign(what) => ImportError::at(path, 0, ImportErrorKind::Unsupported(what)),
        }
    }
}

impl fmt::Display for Refused {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::TooLarge { width, height, bytes, limit } => {
                write!(f, "a picture of {width} x {height} has {bytes} bytes of pixels, more than {limit}")
            }
            Self::Malformed(what) => f.write_str(what),
            #[cfg(feature = "rasters")]
            Self::Foreign(what) => f.write_str(what),
        }
    }
}

impl From<String> for Refused {
    fn from(what: String) -> Self {
        Self::Malformed(what)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_much_may_come_out_as_the_compression_can_make_and_no_more_unless_it_is_trusted() {
        let limits = Limits::default();
        let trusted = Limits { ratio: u64::MAX, ..limits };
        for (packing, ratio) in [(Packing::Deflate, 1032), (Packing::Tiff, 2600), (Packing::Jpeg, 1032)] {
            let packed = 100_000;
            let rows = u32::try_from(packed * ratio / 1000).unwrap();
            let of =
                |rows: u32, limits: &Limits| check((1000, rows, 1000 * u64::from(rows)), 8, packed, packing, limits);
            assert_eq!(of(rows, &limits), Ok(()), "{packing:?}");
            assert!(matches!(of(rows + 1, &limits), Err(Refused::TooLarge { .. })), "{packing:?}");
            assert_eq!(of(rows + 1, &trusted), Ok(()), "{packing:?}");
        }
        // Bits are counted as they are stored.
        assert_eq!(check((8000, 8000, 64_000_000), 1, 100, Packing::Deflate, &limits), Ok(()));
        assert!(check((8000, 8000, 64_000_000), 24, 100, Packing::Deflate, &limits).is_err());
        assert_eq!(check((8000, 8000, 64_000_000), 32, 30, Packing::Webp, &limits), Ok(()));
        let small = Limits { bytes: 1000, ..trusted };
        assert!(check((50, 50, 2500), 8, 5000, Packing::Deflate, &small).is_err());
    }
}
