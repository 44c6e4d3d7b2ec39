//! The numbers of a node: of which kind they are, and how inactive ones are left out and all are compressed (OpenVDB's
//! `io/Compression.h`).

use super::cursor::Cursor;
use super::grid::Packing;
use crate::import::samples::real_of_half;
use crate::import::volumes::zarr::blosc::unpack as unblosc;
use flate2::read::ZlibDecoder;
use std::io::Read;
use voxtrace_voxelize::ImportError;

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Number {
    kind: Kind,
    /// Whether the numbers of nodes, but not single ones, are halves.
    is_half: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    F32,
    F64,
    I32,
    I64,
    /// A byte, but in leaves a bit.
    Bool,
}

impl Number {
    /// The numbers of a kind of tree, if they are single ones.
    pub fn of_tree(kind: &str) -> Option<Self> {
        let (name, is_half) = kind.strip_suffix("_HalfFloat").map_or((kind, false), |name| (name, true));
        let kind = match name {
            "Tree_float_5_4_3" => Kind::F32,
            "Tree_double_5_4_3" => Kind::F64,
            "Tree_int32_5_4_3" => Kind::I32,
            "Tree_int64_5_4_3" => Kind::I64,
            "Tree_bool_5_4_3" => Kind::Bool,
            _ => return None,
        };
        Some(Self { kind, is_half: is_half && matches!(kind, Kind::F32 | Kind::F64) })
    }

    /// Whether leaves have a bit for each place, and no packing (OpenVDB's `tree/LeafNodeBool.h`).
    pub fn is_bit(self) -> bool {
        self.kind == Kind::Bool
    }

    /// The opposite of a number.
    fn negated(self, value: f32) -> f32 {
        if self.is_bit() { 1.0 - value } else { -value }
    }

    /// Bytes of a single number.
    fn size(self) -> usize {
        match self.kind {
            Kind::F32 | Kind::I32 => 4,
            Kind::F64 | Kind::I64 => 8,
            Kind::Bool => 1,
        }
    }

    /// Takes a single number.
    pub fn take(self, cursor: &mut Cursor, what: &str) -> Result<f32, ImportError> {
        Ok(self.real(cursor.take(self.size() as u64, what)?))
    }

    fn real(self, bytes: &[u8]) -> f32 {
        let eight = || *bytes.first_chunk().unwrap_or(&[0; 8]);
        let four = || *bytes.first_chunk().unwrap_or(&[0; 4]);
        match self.kind {
            Kind::F32 => f32::from_le_bytes(four()),
            Kind::F64 => f64::from_le_bytes(eight()) as f32,
            Kind::I32 => i32::from_le_bytes(four()) as f32,
            Kind::I64 => i64::from_le_bytes(eight()) as f32,
            Kind::Bool => f32::from(u8::from(bytes.first() != Some(&0))),
        }
    }
}

/// Reads the numbers of nodes of one tree.
#[derive(Clone, Copy)]
pub(super) struct Values {
    pub number: Number,
    pub packing: Packing,
    /// What is where nothing is.
    pub background: f32,
}

/// Which inactive numbers there are, by the byte in front of a node's numbers.
const BACKGROUND: u8 = 0;
const NEGATED: u8 = 1;
const ONE: u8 = 2;
const CHOSEN: u8 = 3;
const CHOSEN_ONE: u8 = 4;
const CHOSEN_TWO: u8 = 5;
const ALL: u8 = 6;

/// Where the numbers of a node lie.
pub(super) struct Packed<'a> {
    /// What stands for inactive numbers, and those that take the second one.
    inactive: [f32; 2],
    chosen: &'a [u8],
    /// The numbers that are there.
    count: usize,
    data: Data<'a>,
}

enum Data<'a> {
    Plain(&'a [u8]),
    Zip(&'a [u8]),
    Blosc(&'a [u8]),
}

impl Values {
    /// Goes over the numbers of a node, of which those with a bit in `active` are active.
    pub fn take<'a>(&self, cursor: &mut Cursor<'a>, active: &[u8]) -> Result<Packed<'a>, ImportError> {
        let what = "the numbers of a node";
        let kind = cursor.array::<1>(what)?[0];
        let negated = self.number.negated(self.background);
        let mut inactive = [if kind == BACKGROUND { self.background } else { negated }, self.background];
        match kind {
            ONE | CHOSEN_ONE => inactive[0] = self.number.take(cursor, what)?,
            CHOSEN_TWO => {
                for value in &mut inactive {
                    *value = self.number.take(cursor, what)?;
                }
            }
            BACKGROUND | NEGATED | CHOSEN | ALL => {}
            _ => return Err(cursor.malformed(format!("a kind {kind} of inactive numbers"))),
        }
        let has_choice = matches!(kind, CHOSEN | CHOSEN_ONE | CHOSEN_TWO);
        let chosen = if has_choice { cursor.take(active.len() as u64, what)? } else { &[] };
        let is_partial = self.packing.active && kind != ALL;
        let count = if is_partial { ones(active) } else { active.len() * 8 };
        let size = if self.number.is_half { 2 } else { self.number.size() };
        let plain = (count * size) as u64;
        // Halves that are none have not even a length.
        let data = if self.number.is_half && count == 0 {
            Data::Plain(&[])
        } else if self.packing.zip || self.packing.blosc {
            let length = cursor.i64(what)?;
            let bytes = cursor.take(length.unsigned_abs(), what)?;
            if length > 0 {
                if self.packing.blosc { Data::Blosc(bytes) } else { Data::Zip(bytes) }
            } else if bytes.len() as u64 == plain {
                Data::Plain(bytes)
            } else {
                return Err(cursor.malformed("as many numbers as a node does not have"));
            }
        } else {
            Data::Plain(cursor.take(plain, what)?)
        };
        Ok(Packed { inactive, chosen, count, data })
    }

    /// The numbers of a node, inactive ones among them, as many as `active` has bits.
    ///
    /// # Errors
    /// One sentence about what is wrong.
    pub fn unpack(&self, packed: &Packed, active: &[u8]) -> Result<Vec<f32>, String> {
        let size = if self.number.is_half { 2 } else { self.number.size() };
        let plain = packed.count * size;
        let owned;
        let bytes = match packed.data {
            Data::Plain(bytes) => bytes,
            Data::Zip(bytes) => {
                let mut out = Vec::with_capacity(plain);
                let took = ZlibDecoder::new(bytes).take(plain as u64).read_to_end(&mut out);
                took.map_err(|error| format!("compressed data: {error}"))?;
                owned = out;
                &*owned
            }
            Data::Blosc(bytes) => {
                owned = unblosc(bytes, plain)?;
                &*owned
            }
        };
        if bytes.len() != plain {
            return Err("compressed data: fewer numbers than a node has".into());
        }
        let mut there = bytes.chunks_exact(size).map(|bytes| {
            if self.number.is_half { real_of_half([bytes[0], bytes[1]]) } else { self.number.real(bytes) }
        });
        let count = active.len() * 8;
        if packed.count == count {
            return Ok(there.collect());
        }
        let value = |place| {
            if bit(active, place) {
                there.next().unwrap_or(self.background)
            } else {
                packed.inactive[usize::from(!packed.chosen.is_empty() && bit(packed.chosen, place))]
            }
        };
        Ok((0..count).map(value).collect())
    }
}

/// Whether a bit is set; those of a byte from the lowest on.
pub(super) fn bit(mask: &[u8], place: usize) -> bool {
    mask[place / 8] >> (place % 8) & 1 != 0
}

/// Bits that are set.
pub(super) fn ones(mask: &[u8]) -> usize {
    mask.iter().map(|byte| byte.count_ones() as usize).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_have_their_values() {
        let half = |bits: u16| real_of_half(bits.to_le_bytes());
        for (bits, wanted) in [
            (0x3c00, 1.0),
            (0xc000, -2.0),
            (0x7bff, 65_504.0),
            (0x0400, 2f32.powi(-14)),
            (0x0001, 2f32.powi(-24)),
            (0x83ff, -1023.0 * 2f32.powi(-24)),
            (0x3555, 0.333_251_95),
            (0x7c00, f32::INFINITY),
            (0x0000, 0.0),
        ] {
            assert_eq!(half(bits), wanted, "{bits:x}");
        }
        assert!(half(0x7e00).is_nan() && half(0x8000).is_sign_negative());
    }
}
