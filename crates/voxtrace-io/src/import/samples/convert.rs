//! Samples of every width and byte order become f32, piece by piece.

use crate::import::reader::Sample;
use crate::import::source::input::Input;
use rayon::prelude::*;
use std::path::Path;
use std::sync::mpsc::channel;
use voxtrace_voxelize::volume::large::Coding;
use voxtrace_voxelize::{ImportError, Limits};

/// Bytes converted by one task.
const PIECE: usize = 1 << 20;
/// Pieces that wait for a thread; this one does more by itself.
const WAITING: usize = 8;

/// What is stored where.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    pub sample: Sample,
    pub big_endian: bool,
    /// Samples along each axis, the first fastest.
    pub size: [usize; 3],
    /// Numbers at each place; the first is taken.
    pub components: usize,
    /// Slope and intercept from stored to real values.
    pub rescale: (f64, f64),
}

/// Sizes of a file as sizes in memory, if they are ≥ 1 and within the limit.
pub(crate) fn checked_size(
    path: &Path,
    offset: u64,
    size: [u64; 3],
    limits: &Limits,
) -> Result<[usize; 3], ImportError> {
    if size.contains(&0) {
        return Err(ImportError::malformed(path, offset, "a volume without samples"));
    }
    let count = size.iter().try_fold(1u64, |count, &size| count.checked_mul(size)).unwrap_or(u64::MAX);
    let limit = limits.points.min((isize::MAX / 4) as u64);
    if count > limit {
        return Err(ImportError::limit(path, Some(offset), "samples", count, limit));
    }
    // Each is at most the product.
    Ok(size.map(|size| size as usize))
}

impl Layout {
    fn count(&self) -> usize {
        self.size.iter().product()
    }

    /// Bytes of all samples.
    pub fn bytes(&self) -> u64 {
        let numbers = self.size.iter().map(|&size| size as u64).product::<u64>().saturating_mul(self.components as u64);
        numbers.saturating_mul(self.sample.size() as u64)
    }

    /// Bytes of all numbers at one place, within what is taken at once.
    fn stride(&self, input: &Input) -> Result<usize, ImportError> {
        let stride = (self.components as u64).saturating_mul(self.sample.size() as u64);
        if stride > PIECE as u64 {
            return Err(ImportError::limit(
                input.path(),
                Some(input.offset()),
                "bytes of a sample",
                stride,
                PIECE as u64,
            ));
        }
        Ok(stride as usize)
    }

    /// Reads the samples that come next.
    pub fn read(&self, input: &mut Input) -> Result<Vec<f32>, ImportError> {
        let (count, stride) = (self.count(), self.stride(input)?);
        if let Some(remaining) = input.remaining() {
            let needed = (count as u64).saturating_mul(stride as u64);
            if remaining < needed {
                let what = format!("its samples, which take {needed} bytes");
                return Err(ImportError::truncated(input.path(), input.offset() + remaining, what));
            }
        }
        // Pages come from the system when they are written: what a file only claims to hold takes none.
        let mut values: Vec<f32> = bytemuck::allocation::try_zeroed_vec(count)
            .map_err(|()| ImportError::io(input.path(), std::io::ErrorKind::OutOfMemory.into()))?;
        self.read_into(input, stride, &mut values)?;
        Ok(values)
    }

    /// Reads pieces one after the other while other threads convert those before.
    fn read_into(&self, input: &mut Input, stride: usize, values: &mut [f32]) -> Result<(), ImportError> {
        let (give_back, free) = channel();
        for _ in 0..WAITING {
            // The receiver is here.
            let _ = give_back.send(Vec::new());
        }
        let mut own = Vec::new();
        rayon::in_place_scope(|scope| {
            for part in values.chunks_mut((PIECE / stride).max(1)) {
                let size = part.len() * stride;
                let Ok(mut piece) = free.try_recv() else {
                    own.resize(size, 0);
                    input.take_into(&mut own, "its samples")?;
                    self.convert(&own, stride, part);
                    continue;
                };
                piece.resize(size, 0);
                input.take_into(&mut piece, "its samples")?;
                let give_back = give_back.clone();
                scope.spawn(move |_| {
                    self.convert(&piece, stride, part);
                    // Nobody wants it after the last piece.
                    let _ = give_back.send(piece);
                });
            }
            Ok(())
        })
    }

    /// The samples of bytes in memory.
    #[cfg(any(feature = "rasters", feature = "volumes"))]
    pub fn convert_into(&self, bytes: &[u8], values: &mut [f32]) {
        self.convert(bytes, self.sample.size() * self.components, values);
    }

    /// The samples of bytes in memory, on all threads.
    pub fn convert_all(&self, bytes: &[u8], values: &mut [f32]) {
        let stride = self.sample.size() * self.components;
        let piece = (PIECE / stride).max(1);
        let pieces = values.par_chunks_mut(piece).zip(bytes.par_chunks(piece * stride));
        pieces.for_each(|(values, bytes)| self.convert(bytes, stride, values));
    }

    fn convert(&self, bytes: &[u8], stride: usize, values: &mut [f32]) {
        let (slope, intercept) = self.rescale;
        macro_rules! converted {
            ($type:ty, $read:ident, $value:ident, $real:expr) => {
                if stride == size_of::<$type>() {
                    for (real, &bytes) in values.iter_mut().zip(bytes.as_chunks().0) {
                        let $value = <$type>::$read(bytes);
                        *real = $real;
                    }
                } else {
                    let places = bytes.chunks_exact(stride).filter_map(|place| place.first_chunk());
                    for (real, &bytes) in values.iter_mut().zip(places) {
                        let $value = <$type>::$read(bytes);
                        *real = $real;
                    }
                }
            };
            ($type:ty) => {
                match (self.big_endian, self.rescale == (1.0, 0.0)) {
                    (false, true) => converted!($type, from_le_bytes, value, value as f32),
                    (true, true) => converted!($type, from_be_bytes, value, value as f32),
                    (false, false) => {
                        converted!($type, from_le_bytes, value, (value as f64 * slope + intercept) as f32)
                    }
                    (true, false) => converted!($type, from_be_bytes, value, (value as f64 * slope + intercept) as f32),
                }
            };
        }
        match self.sample {
            Sample::U8 => converted!(u8),
            Sample::I8 => converted!(i8),
            Sample::U16 => converted!(u16),
            Sample::I16 => converted!(i16),
            Sample::U32 => converted!(u32),
            Sample::I32 => converted!(i32),
            Sample::U64 => converted!(u64),
            Sample::I64 => converted!(i64),
            Sample::F16 => {
                for (real, place) in values.iter_mut().zip(bytes.chunks_exact(stride)) {
                    let (a, b) = if self.big_endian { (place[1], place[0]) } else { (place[0], place[1]) };
                    *real = (f64::from(real_of_half([a, b])) * slope + intercept) as f32;
                }
            }
            Sample::F32 => converted!(f32),
            Sample::F64 => converted!(f64),
        }
    }

    /// What single numbers are where they are read layer by layer: those of 8 and 16 bits are codes.
    pub fn coding(&self) -> Coding {
        // Codes of signed numbers count from the least one on.
        let coded = |count: u32, flip: u32| {
            let stored = (0..count).map(|code| (code ^ flip) as u16);
            let bytes: Vec<u8> = match (count, self.big_endian) {
                (256, _) => stored.map(|code| code as u8).collect(),
                (_, true) => stored.flat_map(u16::to_be_bytes).collect(),
                (_, false) => stored.flat_map(u16::to_le_bytes).collect(),
            };
            let mut table = vec![0.0; count as usize];
            self.convert(&bytes, self.sample.size(), &mut table);
            table
        };
        match self.sample {
            Sample::U8 => Coding::Bytes(coded(256, 0)),
            Sample::I8 => Coding::Bytes(coded(256, 0x80)),
            Sample::U16 => Coding::Words(coded(65_536, 0)),
            Sample::I16 => Coding::Words(coded(65_536, 0x8000)),
            _ => Coding::Reals,
        }
    }

    /// Makes codes of [`Self::coding`] of the numbers of a file, in place.
    pub fn encode_bytes(&self, codes: &mut [u8]) {
        if self.sample == Sample::I8 {
            codes.iter_mut().for_each(|code| *code ^= 0x80);
        }
    }

    /// As [`Self::encode_bytes`], of numbers of 16 bits.
    pub fn encode_words(&self, codes: &mut [u16]) {
        let flip = if self.sample == Sample::I16 { 0x8000 } else { 0 };
        let own = if self.big_endian { u16::from_be } else { u16::from_le };
        codes.iter_mut().for_each(|code| *code = own(*code) ^ flip);
    }

    /// Reads the samples that come next as text.
    pub fn read_text(&self, input: &mut Input) -> Result<Vec<f32>, ImportError> {
        let (count, path) = (self.count(), input.path());
        self.stride(input)?;
        let (slope, intercept) = self.rescale;
        let mut values = Vec::new();
        let mut component = 0;
        while values.len() < count {
            let offset = input.offset();
            let Some(line) = input.line()? else {
                return Err(ImportError::truncated(path, offset, format!("its {count} samples")));
            };
            let words = line.split(|byte| byte.is_ascii_whitespace() || *byte == b',').filter(|word| !word.is_empty());
            for word in words {
                let number = std::str::from_utf8(word).ok().and_then(|word| word.parse::<f64>().ok());
                let number =
                    number.ok_or_else(|| ImportError::malformed(path, offset, "a sample that is no number"))?;
                if component == 0 && values.len() < count {
                    values.push((number * slope + intercept) as f32);
                }
                component = (component + 1) % self.components.max(1);
            }
        }
        Ok(values)
    }
}

/// A number of 16 bits (IEEE 754, binary16).
pub(crate) fn real_of_half(bytes: [u8; 2]) -> f32 {
    let bits = u32::from(u16::from_le_bytes(bytes));
    let (sign, exponent, fraction) = (bits >> 15 << 31, bits >> 10 & 31, bits & 0x3ff);
    let magnitude = match exponent {
        // Steps of 2⁻²⁴.
        0 => fraction as f32 / 16_777_216.0,
        31 => f32::from_bits(0x7f80_0000 | fraction << 13),
        _ => f32::from_bits((exponent + 112) << 23 | fraction << 13),
    };
    f32::from_bits(magnitude.to_bits() | sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(sample: Sample, big_endian: bool, components: usize, bytes: &[u8]) -> Result<Vec<f32>, ImportError> {
        let limits = Limits::default();
        let mut input = Input::of_bytes(bytes, Path::new("a.raw"), &limits)?;
        Layout { sample, big_endian, size: [2, 1, 1], components, rescale: (1.0, 0.0) }.read(&mut input)
    }

    #[test]
    fn every_kind_of_sample_is_read_in_both_byte_orders() {
        macro_rules! check {
            ($($kind:ident $type:ty: $value:expr),*) => {$(
                let values: [$type; 2] = [$value, 7 as $type];
                let little: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
                let big: Vec<u8> = values.iter().flat_map(|value| value.to_be_bytes()).collect();
                let wanted = vec![values[0] as f32, 7.0];
                assert_eq!(read(Sample::$kind, false, 1, &little).unwrap(), wanted);
                assert_eq!(read(Sample::$kind, true, 1, &big).unwrap(), wanted);
                assert!(read(Sample::$kind, true, 1, &big[1..]).is_err());
            )*};
        }
        check!(U8 u8: 200, I8 i8: -100, U16 u16: 60_000, I16 i16: -30_000, U32 u32: 4_000_000_000, I32 i32: -2_000_000_000,
            U64 u64: 1 << 60, I64 i64: -(1 << 60), F32 f32: -1.5e30, F64 f64: 2.25e-20);
    }

    #[test]
    fn codes_stand_for_the_numbers_that_were_stored_and_are_in_their_order() {
        let stored: Vec<u8> = (0..512u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 19) as u8).collect();
        for (sample, big_endian) in
            [Sample::U8, Sample::I8, Sample::U16, Sample::I16].map(|own| [(own, false), (own, true)]).concat()
        {
            let size = [512 / sample.size(), 1, 1];
            for rescale in [(1.0, 0.0), (-0.5, 7.0)] {
                let layout = Layout { sample, big_endian, size, components: 1, rescale };
                let mut wanted = vec![0.0; size[0]];
                layout.convert_all(&stored, &mut wanted);
                let (coding, mut codes) = (layout.coding(), stored.clone());
                let table = coding.table();
                assert!(if rescale.0 > 0.0 { table.is_sorted() } else { table.iter().rev().is_sorted() });
                let found: Vec<f32> = if sample.size() == 1 {
                    layout.encode_bytes(&mut codes);
                    codes.iter().map(|&code| table[usize::from(code)]).collect()
                } else {
                    let mut words: Vec<u16> = bytemuck::pod_collect_to_vec(&codes);
                    layout.encode_words(&mut words);
                    words.iter().map(|&code| table[usize::from(code)]).collect()
                };
                assert_eq!(found, wanted, "{sample:?} {big_endian} {rescale:?}");
                let planted = Layout { big_endian: !big_endian, rescale: (2.0, 0.0), ..layout };
                planted.convert_all(&stored, &mut wanted);
                assert_ne!(found, wanted);
            }
        }
        let layout = |sample| Layout { sample, big_endian: false, size: [1; 3], components: 1, rescale: (1.0, 0.0) };
        assert!([Sample::F16, Sample::F32, Sample::U32].into_iter().all(|own| layout(own).coding().table().is_empty()));
    }

    #[test]
    fn halves_are_read_in_both_byte_orders() {
        // 1.5 and −0.25 (IEEE 754, binary16).
        assert_eq!(read(Sample::F16, false, 1, &[0, 0x3e, 0, 0xb4]).unwrap(), [1.5, -0.25]);
        assert_eq!(read(Sample::F16, true, 1, &[0x3e, 0, 0xb4, 0]).unwrap(), [1.5, -0.25]);
    }

    #[test]
    fn of_several_numbers_at_a_place_the_first_is_taken() {
        assert_eq!(read(Sample::U8, false, 3, &[1, 2, 3, 4, 5, 6]).unwrap(), [1.0, 4.0]);
        assert!(read(Sample::U8, false, 3, &[1, 2, 3, 4, 5]).is_err());
        assert!(read(Sample::U8, false, usize::MAX, &[1, 2, 3]).is_err());
    }
}
