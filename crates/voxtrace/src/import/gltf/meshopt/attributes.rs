//! Attributes (appendix A.1): blocks of up to 256 elements; of each the first bytes of all elements, then the second ones and so
//! on, as differences from the element before.

/// First byte of version 0.
const HEADER: u8 = 0xa0;
const HEADER_OF_VERSION_1: u8 = 0xa1;
/// Bytes of a block and elements of one at most, and elements of a group.
const BLOCK_BYTES: usize = 8192;
const BLOCK_MOST: usize = 256;
const GROUP: usize = 16;
/// Bytes at the end at least.
const TAIL: usize = 32;

/// The elements, one after the other.
pub(super) fn decode(packed: &[u8], count: usize, stride: usize) -> Result<Vec<u8>, &'static str> {
    match packed.first() {
        Some(&HEADER) => {}
        Some(&HEADER_OF_VERSION_1) => return Err("version 1 of attributes is not read"),
        _ => return Err("attributes without their header"),
    }
    let end = packed.len().checked_sub(stride.max(TAIL)).filter(|&end| end >= 1).ok_or(SHORT)?;
    // The element before the first one.
    let mut last = packed[packed.len() - stride..].to_vec();
    let mut data = Data { bytes: &packed[1..end] };
    let block = (BLOCK_BYTES / stride / GROUP * GROUP).min(BLOCK_MOST);
    // A group of each byte takes two bits at least.
    if count / block * (block / GROUP).div_ceil(4) * stride > data.bytes.len() {
        return Err(SHORT);
    }
    let mut bytes = vec![0; count * stride];
    for elements in bytes.chunks_mut(block * stride) {
        let count = elements.len() / stride;
        for (place, last) in last.iter_mut().enumerate() {
            let groups = count.div_ceil(GROUP);
            let modes = data.take(groups.div_ceil(4))?;
            for group in 0..groups {
                let differences = data.group(modes[group / 4] >> (2 * (group % 4)) & 3)?;
                let first = group * GROUP;
                for (element, difference) in (first..count).zip(differences) {
                    let difference = (difference & 1).wrapping_neg() ^ (difference >> 1);
                    *last = last.wrapping_add(difference);
                    elements[element * stride + place] = *last;
                }
            }
        }
    }
    Ok(bytes)
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

    /// Sixteen bytes of which each is stored with 0, 2, 4 or 8 bits; one that does not fit follows in full.
    fn group(&mut self, mode: u8) -> Result<[u8; GROUP], &'static str> {
        let mut group = [0; GROUP];
        let bits = match mode {
            0 => return Ok(group),
            1 => 2,
            2 => 4,
            _ => {
                group.copy_from_slice(self.take(GROUP)?);
                return Ok(group);
            }
        };
        let (packed, each) = (self.take(GROUP * bits / 8)?, 8 / bits);
        let most = (1 << bits) - 1;
        for (place, value) in group.iter_mut().enumerate() {
            *value = packed[place / each] >> (8 - bits * (place % each + 1)) & most;
            if *value == most {
                *value = self.take(1)?[0];
            }
        }
        Ok(group)
    }
}
