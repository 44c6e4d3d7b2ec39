//! Reading any bytes as a volume of each kind: `cargo +nightly fuzz run volume`.
#![no_main]

#[path = "../check/volume.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check_all(bytes));
