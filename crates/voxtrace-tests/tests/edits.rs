//! Sequences of edits against a plain map of voxels: what the fuzz target `edits` checks, with bytes of our own.

#[path = "../../../fuzz/check/edits.rs"]
mod edits;

use std::time::{Duration, Instant};
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

/// `VOXTRACE_SECONDS=600 cargo test --release --workspace --test edits -- --ignored` where there is no nightly toolchain to fuzz with.
#[test]
#[ignore = "takes as long as it is asked to"]
fn sequences_of_edits_for_a_while() {
    let seconds = std::env::var("VOXTRACE_SECONDS").ok().and_then(|seconds| seconds.parse().ok()).unwrap_or(60);
    let (start, mut seed) = (Instant::now(), 1000);
    while start.elapsed() < Duration::from_secs(seconds) {
        edits::check(&bytes(seed));
        seed += 1;
    }
    println!("{} sequences", seed - 1000);
}
