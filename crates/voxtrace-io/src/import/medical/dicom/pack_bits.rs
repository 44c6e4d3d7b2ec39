//! Run lengths of DICOM (PS3.5, annex G), which are those of PackBits (TIFF 6.0, section 9).

/// Bytes of runs, as they are or repeated.
pub(super) fn unpack_bits(packed: &[u8], size: usize) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::with_capacity(size);
    let mut rest = packed;
    while bytes.len() < size {
        let [control, after @ ..] = rest else { return Err("run lengths that end too early".into()) };
        let count = match control {
            0..=127 => {
                let count = usize::from(*control) + 1;
                let run = after.get(..count).ok_or("run lengths that end too early")?;
                bytes.extend_from_slice(run);
                count
            }
            128 => 0,
            _ => {
                let byte = *after.first().ok_or("run lengths that end too early")?;
                bytes.resize(bytes.len() + 257 - usize::from(*control), byte);
                1
            }
        };
        rest = &after[count..];
    }
    bytes.truncate(size);
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_of_bytes_are_unpacked_and_short_ones_refused() {
        // The example of PS3.5, G.3: literal runs and repeated bytes.
        let packed = [2, 1, 2, 3, 128, 254, 9, 0, 7];
        assert_eq!(unpack_bits(&packed, 7).unwrap(), [1, 2, 3, 9, 9, 9, 7]);
        assert_eq!(unpack_bits(&packed, 5).unwrap(), [1, 2, 3, 9, 9]);
        assert!(
            unpack_bits(&packed, 8).is_err() && unpack_bits(&[5, 1], 2).is_err() && unpack_bits(&[254], 2).is_err()
        );
    }
}
