//! Attributes (appendix A.1): blocks of up to 256 elements; of each the first bytes of all elements, then the second ones and so
//! on, as differences from the element before. Version 1 (`KHR_meshopt_compression`) also takes differences of 16 and 32 bits,
//! and says of each byte how it is packed.

/// First byte of version 0.
const HEADER: u8 = 0xa0;
const HEADER_OF_VERSION_1: u8 = 0xa1;
/// Bytes of a block and elements of one at most, and elements of a group.
const BLOCK_BYTES: usize = 8192;
const BLOCK_MOST: usize = 256;
const GROUP: usize = 16;
/// Bytes at the end at least, in either version.
const TAIL: [usize; 2] = [32, 24];
/// Bits of the numbers in a group by its mode: in version 0, and by the two controls of version 1 that have modes.
const BITS: [usize; 4] = [0, 2, 4, 8];
const BITS_OF_CONTROL: [[usize; 4]; 2] = [[0, 1, 2, 4], [1, 2, 4, 8]];

/// The elements, one after the other; `stride` is a multiple of four.
pub(super) fn decode(packed: &[u8], count: usize, stride: usize) -> Result<Vec<u8>, &'static str> {
    let is_new = match packed.first() {
        Some(&HEADER) => false,
        Some(&HEADER_OF_VERSION_1) => true,
        _ => return Err("attributes without their header"),
    };
    let words = stride / 4;
    // The element before the first one, and then how each four bytes of elements are differences.
    let tail = if is_new { stride + words } else { stride };
    let end = packed.len().checked_sub(tail.max(TAIL[usize::from(is_new)])).filter(|&end| end >= 1).ok_or(SHORT)?;
    let (first, channels) = packed[packed.len() - tail..].split_at(stride);
    let mut last = first.to_vec();
    let mut data = Data { bytes: &packed[1..end] };
    let block = (BLOCK_BYTES / stride / GROUP * GROUP).min(BLOCK_MOST);
    // A group of each byte takes two bits at least, or a block a byte for each four bytes of an element.
    let least = if is_new { words } else { (block / GROUP).div_ceil(4) * stride };
    if count / block * least > data.bytes.len() {
        return Err(SHORT);
    }
    let mut bytes = vec![0; count * stride];
    for elements in bytes.chunks_mut(block * stride) {
        let count = elements.len() / stride;
        let controls = if is_new { data.take(words)? } else { &[] };
        for (word, last) in last.as_chunks_mut::<4>().0.iter_mut().enumerate() {
            let mut planes = [[0; BLOCK_MOST]; 4];
            for (place, plane) in planes.iter_mut().enumerate() {
                let plane = &mut plane[..count];
                match controls.get(word).map(|control| control >> (2 * place) & 3) {
                    None => data.plane(plane, BITS)?,
                    Some(control @ (0 | 1)) => data.plane(plane, BITS_OF_CONTROL[usize::from(control)])?,
                    Some(2) => {}
                    Some(_) => plane.copy_from_slice(data.take(count)?),
                }
            }
            let channel = channels.get(word).copied().unwrap_or(0);
            for (n, element) in elements.chunks_mut(stride).enumerate() {
                let difference = [planes[0][n], planes[1][n], planes[2][n], planes[3][n]];
                *last = next(*last, difference, channel)?;
                element[4 * word..4 * word + 4].copy_from_slice(last);
            }
        }
    }
    Ok(bytes)
}

/// Four bytes of an element from those of the one before.
fn next(before: [u8; 4], difference: [u8; 4], channel: u8) -> Result<[u8; 4], &'static str> {
    match channel & 3 {
        // The lowest bit is the sign.
        0 => Ok(std::array::from_fn(|n| {
            let difference = difference[n];
            before[n].wrapping_add((difference & 1).wrapping_neg() ^ (difference >> 1))
        })),
        1 => {
            let half = |n: usize| {
                let number = |bytes: [u8; 4]| u16::from_le_bytes([bytes[2 * n], bytes[2 * n + 1]]);
                let difference = number(difference);
                number(before).wrapping_add((difference & 1).wrapping_neg() ^ (difference >> 1)).to_le_bytes()
            };
            let ([a, b], [c, d]) = (half(0), half(1));
            Ok([a, b, c, d])
        }
        2 => {
            let turn = (32 - u32::from(channel >> 4)) & 31;
            Ok((u32::from_le_bytes(difference).rotate_left(turn) ^ u32::from_le_bytes(before)).to_le_bytes())
        }
        _ => Err("differences of an unknown kind"),
    }
}

const SHORT: &str = "attributes that end too early";

struct Data<'a> {
    bytes: &'a [u8],
}

impl<'a> Data<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], &'static str> {
        let (taken, rest) = self.bytes.split_at_checked(count).ok_or(SHORT)?;
        self.bytes = rest;
        Ok(taken)
    }

    /// One byte of each element of a block, by groups, each of which has one of four numbers of bits.
    fn plane(&mut self, plane: &mut [u8], bits: [usize; 4]) -> Result<(), &'static str> {
        let modes = self.take(plane.len().div_ceil(GROUP).div_ceil(4))?;
        for (at, part) in plane.chunks_mut(GROUP).enumerate() {
            let group = self.group(bits[usize::from(modes[at / 4] >> (2 * (at % 4)) & 3)])?;
            part.copy_from_slice(&group[..part.len()]);
        }
        Ok(())
    }

    /// Sixteen bytes of which each is stored with 0, 1, 2, 4 or 8 bits; one that does not fit follows in full.
    fn group(&mut self, bits: usize) -> Result<[u8; GROUP], &'static str> {
        let mut group = [0; GROUP];
        match bits {
            0 => return Ok(group),
            8 => {
                group.copy_from_slice(self.take(GROUP)?);
                return Ok(group);
            }
            _ => {}
        }
        let (packed, each) = (self.take(GROUP * bits / 8)?, 8 / bits);
        let most = (1 << bits) - 1;
        for (place, value) in group.iter_mut().enumerate() {
            let within = place % each;
            // Single bits begin with the lowest, others with the highest.
            let shift = if bits == 1 { within } else { 8 - bits * (within + 1) };
            *value = packed[place / each] >> shift & most;
            if *value == most {
                *value = self.take(1)?[0];
            }
        }
        Ok(group)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twenty elements as meshoptimizer packs them in version 1: bits that change, shorts, bytes.
    const PACKED: &str = "\
        a199776d052aaaaaaaaa000000020519dd915519dd910f00050501090058585858585858585858585858585858585858052a\
        aaaaaaaa000000000e2a46627e9ab6d2ee0a26425e7a96b2ceea06050000055556000000052aabaaae0b0baa000000004a4a\
        4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a4a000001020100010000000000000000000000003f0000000000000500220100";

    fn elements() -> Vec<u8> {
        let element = |n: u32| {
            let bits = 0x3f00_0000 + ((5 * n * n % 16) << 14) + ((n % 2) << 31);
            let shorts = [300 * n, 7 * n * n].map(|short| (short as u16).to_le_bytes());
            let bytes = [n % 7, n * 37 % 256, 5, n / 8 % 2].map(|byte| byte as u8);
            [&bits.to_le_bytes()[..], shorts.as_flattened(), &bytes].concat()
        };
        (0..20).flat_map(element).collect()
    }

    #[test]
    fn attributes_of_version_1_are_those_that_meshoptimizer_packed() {
        let digits: Vec<u8> = PACKED.bytes().map(|digit| char::from(digit).to_digit(16).unwrap() as u8).collect();
        let packed: Vec<u8> = digits.as_chunks().0.iter().map(|[high, low]| high << 4 | low).collect();
        assert_eq!(decode(&packed, 20, 12).unwrap(), elements());
        // Each kind of difference is there.
        assert_eq!(packed[packed.len() - 3..], [0x22, 1, 0]);
        for end in 0..packed.len() {
            assert!(decode(&packed[..end], 20, 12) != Ok(elements()), "{end}");
        }
        assert!(decode(&packed[..30], 20, 12).is_err() && decode(&packed, 1 << 20, 12).is_err());
        let mut unknown = packed.clone();
        *unknown.last_mut().unwrap() = 3;
        assert!(decode(&unknown, 20, 12).is_err());
    }
}
