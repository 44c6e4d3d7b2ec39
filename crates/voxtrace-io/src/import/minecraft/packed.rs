//! Indices of a few bits each in 64-bit words, lowest bits first: one after the other without a gap (`.litematic`, worlds
//! before 1.16), or as many as fit into each word (worlds since).

/// Packed indices of one box of blocks.
pub(super) struct Packed<'a> {
    words: &'a [u64],
    bits: usize,
    /// Indices in each word, where none lies in two words.
    per_word: Option<usize>,
}

/// Bits that an index into so many states takes, at least `least`.
pub(super) fn bits_of(states: usize, least: usize) -> usize {
    let bits = usize::BITS - states.saturating_sub(1).leading_zeros();
    (bits as usize).max(least)
}

impl<'a> Packed<'a> {
    /// Indices without a gap between them; `None` where the words are too few for `count` of them.
    pub fn gapless(words: &'a [u64], count: usize, bits: usize) -> Option<Self> {
        let is_enough = count as u128 * bits as u128 <= words.len() as u128 * 64;
        (is_enough && (1..=32).contains(&bits)).then_some(Self { words, bits, per_word: None })
    }

    /// Indices of a section of a world, gapless or not: the number of words tells.
    pub fn of_section(words: &'a [u64], count: usize, bits: usize) -> Option<Self> {
        if !(1..=32).contains(&bits) {
            return None;
        }
        let per_word = 64 / bits;
        if words.len() == count.div_ceil(per_word) {
            return Some(Self { words, bits, per_word: Some(per_word) });
        }
        if words.len() == (count * bits).div_ceil(64) { Self::gapless(words, count, bits) } else { None }
    }

    /// The index at a place below the count.
    pub fn get(&self, place: usize) -> usize {
        let (word, shift) = match self.per_word {
            Some(per_word) => (place / per_word, place % per_word * self.bits),
            None => (place * self.bits / 64, place * self.bits % 64),
        };
        let mut value = self.words[word] >> shift;
        if shift + self.bits > 64 {
            value |= self.words[word + 1] << (64 - shift);
        }
        (value & ((1 << self.bits) - 1)) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_come_back_from_both_ways_of_packing() {
        for bits in 1usize..=14 {
            let count = 4096usize;
            let value = |place: usize| (place * 2_654_435_761) >> 7 & ((1 << bits) - 1);
            let mut gapless = vec![0u64; (count * bits).div_ceil(64)];
            let per_word = 64 / bits;
            let mut apart = vec![0u64; count.div_ceil(per_word)];
            for place in 0..count {
                for bit in 0..bits {
                    let one = (value(place) >> bit & 1) as u64;
                    gapless[(place * bits + bit) / 64] |= one << ((place * bits + bit) % 64);
                }
                apart[place / per_word] |= (value(place) as u64) << (place % per_word * bits);
            }
            for packed in [
                Packed::gapless(&gapless, count, bits).unwrap(),
                Packed::of_section(&gapless, count, bits).unwrap(),
                Packed::of_section(&apart, count, bits).unwrap(),
            ] {
                assert!((0..count).all(|place| packed.get(place) == value(place)), "{bits}");
            }
            assert!(Packed::gapless(&gapless[1..], count, bits).is_none());
            assert!(Packed::of_section(&apart[1..], count, bits).is_none() || gapless.len() == apart.len() - 1);
        }
    }

    #[test]
    fn a_palette_tells_its_bits() {
        assert_eq!([1, 2, 3, 4, 5, 16, 17, 257].map(|states| bits_of(states, 1)), [1, 1, 2, 2, 3, 4, 5, 9]);
        assert_eq!((bits_of(0, 2), bits_of(2, 4)), (2, 4));
    }
}
