//! Reading any bytes as points of each kind: `cargo +nightly fuzz run points`.
#![no_main]

#[path = "../check/points.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check_all(bytes));
