//! LZF (Marc Lehmann's LibLZF): literal runs and copies of what came before.

/// Unpacks exactly `size` bytes; `None` where the data say otherwise.
pub(super) fn unpack(packed: &[u8], size: usize) -> Option<Vec<u8>> {
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(size).ok()?;
    let mut rest = packed;
    while let [control, after @ ..] = rest {
        let control = usize::from(*control);
        if control < 32 {
            let (run, after) = after.split_at_checked(control + 1)?;
            bytes.extend_from_slice(run);
            rest = after;
        } else {
            let (longer, after) = if control >> 5 == 7 { after.split_first()? } else { (&0, after) };
            let (low, after) = after.split_first()?;
            let length = (control >> 5) + usize::from(*longer) + 2;
            let back = ((control & 31) << 8 | usize::from(*low)) + 1;
            let start = bytes.len().checked_sub(back)?;
            // A copy may reach into itself.
            for at in start..start + length {
                bytes.push(bytes[at]);
            }
            rest = after;
        }
        if bytes.len() > size {
            return None;
        }
    }
    (bytes.len() == size).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::unpack;

    #[test]
    fn runs_and_copies_are_unpacked_and_what_leads_outside_is_refused() {
        // "abc", then four from three back, then nine (a long copy) of one back.
        let packed = [2, b'a', b'b', b'c', 2 << 5, 2, 7 << 5, 0, 0];
        assert_eq!(unpack(&packed, 16).unwrap(), b"abcabcaaaaaaaaaa");
        assert!(unpack(&packed, 15).is_none() && unpack(&packed, 17).is_none());
        assert!(unpack(&[2 << 5, 0], 4).is_none() && unpack(&[5, 1], 6).is_none() && unpack(&[7 << 5], 1).is_none());
    }
}
