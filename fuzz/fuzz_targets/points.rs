//! Reading any bytes as points of each kind: `cargo +nightly fuzz run points`.
#![no_main]

#[path = "../check/points.rs"]
mod check;

// The decoder of LAZ has assertions of its own, for which it stops on damaged points. The library makes errors of them, and
// the hook that ends the process at every panic would keep it from that.
libfuzzer_sys::fuzz_target!(init: drop(std::panic::take_hook()), |bytes: &[u8]| check::check_all(bytes));
