//! Transfer syntaxes (PS3.5, section 10 and annex A): byte order, whether values name their kind, and how pixels are packed.

/// How a file is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Syntax {
    pub is_explicit: bool,
    pub big_endian: bool,
    pub is_deflated: bool,
    pub packing: Packing,
}

/// How pixels are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    None,
    /// Run lengths of bytes.
    Rle,
    /// JPEG with 8 or 12 bits, or lossless with up to 16.
    Jpeg,
    JpegLs,
    Jpeg2000,
}

/// What to do about pixels that are packed in another way.
pub(super) const ADVICE: &str = "unpack the file first, for example by `gdcmconv --raw IN OUT`";

/// Syntaxes that are not read, by name.
const FOREIGN: [(&str, &str); 7] = [
    ("1.2.840.10008.1.2.4.100", "MPEG-2"),
    ("1.2.840.10008.1.2.4.102", "MPEG-4"),
    ("1.2.840.10008.1.2.4.107", "HEVC"),
    ("1.2.840.10008.1.2.4.110", "JPEG XL lossless"),
    ("1.2.840.10008.1.2.4.112", "JPEG XL"),
    ("1.2.840.10008.1.2.4.201", "high-throughput JPEG 2000 lossless"),
    ("1.2.840.10008.1.2.4.203", "high-throughput JPEG 2000"),
];

impl Syntax {
    pub const NAME_OF_IMPLICIT: &str = "1.2.840.10008.1.2";
    pub const IMPLICIT: Self = Self { is_explicit: false, ..Self::EXPLICIT };
    pub const EXPLICIT: Self =
        Self { is_explicit: true, big_endian: false, is_deflated: false, packing: Packing::None };

    /// The syntax of a unique identifier, or a sentence about one that is not read.
    pub fn named(name: &str) -> Result<Self, String> {
        Ok(match name {
            Self::NAME_OF_IMPLICIT => Self::IMPLICIT,
            "1.2.840.10008.1.2.1" => Self::EXPLICIT,
            "1.2.840.10008.1.2.1.99" => Self { is_deflated: true, ..Self::EXPLICIT },
            "1.2.840.10008.1.2.2" => Self { big_endian: true, ..Self::EXPLICIT },
            "1.2.840.10008.1.2.5" => Self { packing: Packing::Rle, ..Self::EXPLICIT },
            // Baseline, extended, lossless, and lossless with the predictor of the left neighbour.
            "1.2.840.10008.1.2.4.50"
            | "1.2.840.10008.1.2.4.51"
            | "1.2.840.10008.1.2.4.57"
            | "1.2.840.10008.1.2.4.70" => Self { packing: Packing::Jpeg, ..Self::EXPLICIT },
            "1.2.840.10008.1.2.4.80" | "1.2.840.10008.1.2.4.81" => Self { packing: Packing::JpegLs, ..Self::EXPLICIT },
            "1.2.840.10008.1.2.4.90" | "1.2.840.10008.1.2.4.91" => {
                Self { packing: Packing::Jpeg2000, ..Self::EXPLICIT }
            }
            other => {
                let known = FOREIGN.iter().find(|(foreign, _)| *foreign == other);
                let about = known.map(|(_, about)| format!(", {about}")).unwrap_or_default();
                return Err(format!("the transfer syntax {other}{about}: {ADVICE}"));
            }
        })
    }
}
