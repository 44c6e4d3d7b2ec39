//! Sequences of edits against a plain map of voxels: what the fuzz target `edits` checks, with bytes of our own.

#[path = "../../../fuzz/check/edits.rs"]
mod edits;

use voxtrace_tests::random::Random;

fn bytes(seed: u64) -> Vec<u8> {
    let mut random = Random(seed);
    (0..400).map(|_| random.below(256) as u8).collect()
}

#[test]
fn sequences_of_edits_leave_the_voxels_of_a_plain_map() {
    edits::check(&[]);
    (0..60).for_each(|seed| edits::check(&bytes(seed)));
}
