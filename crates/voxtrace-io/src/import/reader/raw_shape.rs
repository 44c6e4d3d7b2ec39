//! What a file without a header holds, described by whoever reads it: `512x512x300:u16le`.

use std::str::FromStr;

/// How a sample is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Sample {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    U64,
    I64,
    F16,
    F32,
    F64,
}

impl Sample {
    /// By the name that NumPy, Zarr and N5 have for it.
    #[cfg(feature = "volumes")]
    pub fn of_numpy(name: &str) -> Option<Self> {
        Some(match name {
            "bool" | "uint8" => Self::U8,
            "int8" => Self::I8,
            "uint16" => Self::U16,
            "int16" => Self::I16,
            "uint32" => Self::U32,
            "int32" => Self::I32,
            "uint64" => Self::U64,
            "int64" => Self::I64,
            "float16" => Self::F16,
            "float32" => Self::F32,
            "float64" => Self::F64,
            _ => return None,
        })
    }

    /// By the letter and digit that NumPy and Zarr 2 have for it, behind the byte order.
    #[cfg(feature = "volumes")]
    pub fn of_letters(letters: &str) -> Option<Self> {
        Some(match letters {
            "b1" | "u1" => Self::U8,
            "i1" => Self::I8,
            "u2" => Self::U16,
            "i2" => Self::I16,
            "u4" => Self::U32,
            "i4" => Self::I32,
            "u8" => Self::U64,
            "i8" => Self::I64,
            "f2" => Self::F16,
            "f4" => Self::F32,
            "f8" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of one.
    pub fn size(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 | Self::F16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }
}

/// Size and kind of the samples of a raw file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RawShape {
    pub(crate) size: [u64; 3],
    pub(crate) sample: Sample,
    pub(crate) big_endian: bool,
    /// Bytes before the first sample.
    pub(crate) skip: u64,
}

impl FromStr for RawShape {
    type Err = String;

    /// `XxYxZ:KIND` or `XxYxZ:KIND:SKIP`: samples along x (the fastest), y and z; `u8`, `i8`, `u16le`, `i16be`, `f32le` and so on;
    /// bytes to skip.
    fn from_str(text: &str) -> Result<Self, String> {
        let mut parts = text.split(':');
        let size = parts.next().unwrap_or_default().split('x').map(str::parse).collect::<Result<Vec<u64>, _>>();
        let size = size.ok().and_then(|size| <[u64; 3]>::try_from(size).ok()).filter(|size| !size.contains(&0));
        let size = size.ok_or_else(|| format!("{text:?} does not begin with three sizes like 512x512x300"))?;
        let kind = parts.next().unwrap_or("u8");
        let (name, big_endian) = match kind.strip_suffix("be") {
            Some(name) => (name, true),
            None => (kind.strip_suffix("le").unwrap_or(kind), false),
        };
        let sample = match name {
            "u8" => Sample::U8,
            "i8" => Sample::I8,
            "u16" => Sample::U16,
            "i16" => Sample::I16,
            "u32" => Sample::U32,
            "i32" => Sample::I32,
            "u64" => Sample::U64,
            "i64" => Sample::I64,
            "f16" => Sample::F16,
            "f32" => Sample::F32,
            "f64" => Sample::F64,
            _ => {
                return Err(format!(
                    "{kind:?} is no kind of number: u8, i8, u16le, i16be, u32le, f16le, f32le, f64le …"
                ));
            }
        };
        let skip = parts.next().map_or(Ok(0), str::parse).map_err(|_| "the bytes to skip are no number".to_owned())?;
        match parts.next() {
            Some(rest) => Err(format!("{rest:?} after the shape")),
            None => Ok(Self { size, sample, big_endian, skip }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_read_and_nonsense_is_refused() {
        let shape: RawShape = "4x3x2:i16be:10".parse().unwrap();
        assert_eq!(shape, RawShape { size: [4, 3, 2], sample: Sample::I16, big_endian: true, skip: 10 });
        assert_eq!("1x1x1".parse::<RawShape>().unwrap().sample, Sample::U8);
        for wrong in ["", "4x3", "4x3x2x1", "4x0x2:u8", "4x3x2:u9", "4x3x2:u8:x", "4x3x2:u8:0:0", "-4x3x2", "4x3x2:"] {
            assert!(wrong.parse::<RawShape>().is_err(), "{wrong}");
        }
    }
}
