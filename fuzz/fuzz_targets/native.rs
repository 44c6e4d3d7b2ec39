//! Opening any bytes as a native file whose checksums are right: `cargo +nightly fuzz run native`.
#![no_main]

#[path = "../check/native.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check(bytes));
