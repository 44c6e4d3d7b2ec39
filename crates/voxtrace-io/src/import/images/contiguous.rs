//! Stacks of ImageJ beyond 4 GiB (ij.io.TiffDecoder): one page, whose description says how many pictures lie one behind the other, plain, from
//! its first strip on. Offsets of a TIFF could not number them.

use super::planes::{Plane, description};
use crate::import::samples::{Layout, Sample};
use std::io::{Read, Seek};
use tiff::ColorType;
use tiff::decoder::Decoder;
use tiff::tags::Tag;

/// No compression.
const PLAIN: u32 = 1;
/// Values of `SampleFormat`.
const UNSIGNED: u16 = 1;
const SIGNED: u16 = 2;
const REAL: u16 = 3;

/// Pictures one behind the other.
pub(crate) struct Contiguous {
    /// Samples of all pictures.
    pub layout: Layout,
    /// The byte of the first sample.
    pub start: u64,
}

impl Contiguous {
    /// What the only page of a file says; `None` where it is one of several, or a picture alone.
    pub fn of<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<Self> {
        let description = description(decoder).filter(|text| text.starts_with("ImageJ=") && !decoder.more_images())?;
        let count = description.lines().find_map(|line| line.strip_prefix("images="))?.trim().parse::<usize>().ok()?;
        let (width, height) = decoder.dimensions().ok()?;
        let ColorType::Gray(bits) = decoder.colortype().ok()? else { return None };
        let format = decoder.get_tag_u16_vec(Tag::SampleFormat).ok().and_then(|all| all.first().copied());
        let sample = match (bits, format.unwrap_or(UNSIGNED)) {
            (8, UNSIGNED) => Sample::U8,
            (8, SIGNED) => Sample::I8,
            (16, UNSIGNED) => Sample::U16,
            (16, SIGNED) => Sample::I16,
            (32, UNSIGNED) => Sample::U32,
            (32, SIGNED) => Sample::I32,
            (32, REAL) => Sample::F32,
            (64, REAL) => Sample::F64,
            _ => return None,
        };
        if decoder.get_tag_u32(Tag::Compression).unwrap_or(PLAIN) != PLAIN || count < 2 {
            return None;
        }
        let strips = decoder.get_tag_u64_vec(Tag::StripOffsets).ok()?;
        let lengths = decoder.get_tag_u64_vec(Tag::StripByteCounts).ok()?;
        let follows = |(pair, length): (&[u64], &u64)| pair[0].checked_add(*length) == Some(pair[1]);
        if !strips.windows(2).zip(&lengths).all(follows) {
            return None;
        }
        let big_endian = decoder.byte_order() == tiff::tags::ByteOrder::BigEndian;
        let size = [width as usize, height as usize, count];
        let layout = Layout { sample, big_endian, size, components: 1, rescale: (1.0, 0.0) };
        Some(Self { layout, start: *strips.first()? })
    }

    /// A picture of a file in memory; `None` where that is too short.
    pub fn plane(&self, bytes: &[u8], page: usize) -> Option<Plane> {
        let [width, height, _] = self.layout.size;
        let count = width.checked_mul(height)?;
        let size = count.checked_mul(self.layout.sample.size())?;
        let start = usize::try_from(self.start).ok()?.checked_add(page.checked_mul(size)?)?;
        let bytes = bytes.get(start..start.checked_add(size)?)?;
        let mut values = vec![0.0; count];
        self.layout.convert_into(bytes, &mut values);
        Some(Plane { width, height, values, colors: Vec::new() })
    }
}
