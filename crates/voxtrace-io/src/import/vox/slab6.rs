//! Telling apart the files of Slab6 (Ken Silverman, slab6.txt), which have only the extension in common with MagicaVoxel's: three
//! sizes, a byte for each voxel, 256 colours, and nothing else.

/// Bytes of the sizes, and of the colours.
pub(crate) const HEAD: usize = 12;
pub(crate) const COLORS: usize = 768;

/// Whether a file that begins so has the length of a Slab6 file.
pub(crate) fn is_slab6(head: &[u8], length: u64) -> bool {
    let Some((sizes, _)) = head.split_first_chunk::<HEAD>() else { return false };
    let places = sizes.as_chunks::<4>().0.iter().map(|edge| u128::from(u32::from_le_bytes(*edge))).product::<u128>();
    places + (HEAD + COLORS) as u128 == u128::from(length)
}

/// A channel of a colour of six bits, in eight.
#[cfg(feature = "voxels")]
pub(crate) fn from_six_bits(value: u8) -> u8 {
    let value = value & 63;
    value << 2 | value >> 4
}
