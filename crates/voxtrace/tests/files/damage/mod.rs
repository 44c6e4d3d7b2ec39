//! Damage to files, for tests that nothing in an importer panics: flipped bits, other bytes, absurd numbers and texts.

/// A copy of `bytes`, at least five of them, with one to three places changed. `below` gives random numbers below a bound.
pub fn damaged(bytes: &[u8], numbers: &[u32], texts: &[&str], mut below: impl FnMut(usize) -> usize) -> Vec<u8> {
    let mut damaged = bytes.to_vec();
    for _ in 0..=below(3) {
        let at = below(damaged.len() - 4);
        match below(4) {
            0 => damaged[at] ^= 1 << below(8),
            1 => damaged[at] = below(256) as u8,
            2 => damaged[at..at + 4].copy_from_slice(&numbers[below(numbers.len())].to_le_bytes()),
            _ => {
                let text = texts[below(texts.len())].as_bytes();
                let end = damaged.len().min(at + text.len());
                damaged[at..end].copy_from_slice(&text[..end - at]);
            }
        }
    }
    damaged
}
