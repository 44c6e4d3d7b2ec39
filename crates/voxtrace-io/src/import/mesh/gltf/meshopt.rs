//! Buffer views that are compressed by `EXT_` or `KHR_meshopt_compression` (the extensions' specification, its appendices A and B):
//! attributes byte by byte as differences, triangles by what came shortly before them, other indices as differences.

mod attributes;
mod filters;
mod indices;

use super::Fault;
use super::document::Meshopt;
use voxtrace_voxelize::Limits;

/// Largest element of attributes.
const LARGEST: usize = 256;
/// Bytes that may come out of anything.
const FREE: u64 = 16 << 20;

/// The bytes of a view, from the compressed ones.
pub(super) fn decode(view: &Meshopt, packed: &[u8], limits: &Limits) -> Result<Vec<u8>, Fault> {
    let (stride, count) = (view.byte_stride, view.count);
    let size = (stride as u64).saturating_mul(count as u64);
    if count as u64 > limits.points || size > limits.bytes {
        return Err(Fault::limit("elements of a compressed buffer view", count as u64, limits.points));
    }
    if size > FREE && size / limits.ratio.max(1) > packed.len() as u64 {
        return Err(Fault::limit("bytes out of each compressed one", size / packed.len().max(1) as u64, limits.ratio));
    }
    let fault = |what: &str| Fault::malformed(format!("EXT_meshopt_compression: {what}"));
    let is_small = matches!(stride, 2 | 4);
    match view.mode.as_str() {
        "ATTRIBUTES" if stride.is_multiple_of(4) && (4..=LARGEST).contains(&stride) => {
            let mut bytes = attributes::decode(packed, count, stride).map_err(fault)?;
            filters::apply(view.filter.as_deref().unwrap_or("NONE"), &mut bytes, stride).map_err(fault)?;
            Ok(bytes)
        }
        "TRIANGLES" if is_small && count.is_multiple_of(3) => {
            Ok(bytes_of(indices::triangles(packed, count).map_err(fault)?, stride))
        }
        "INDICES" if is_small => Ok(bytes_of(indices::sequence(packed, count).map_err(fault)?, stride)),
        mode => Err(fault(&format!("{mode:?} with elements of {stride} bytes"))),
    }
}

fn bytes_of(indices: Vec<u32>, stride: usize) -> Vec<u8> {
    if stride == 2 {
        return indices.into_iter().flat_map(|index| (index as u16).to_le_bytes()).collect();
    }
    indices.into_iter().flat_map(u32::to_le_bytes).collect()
}
