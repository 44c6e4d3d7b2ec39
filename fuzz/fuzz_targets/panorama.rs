//! Reading any bytes as a panorama, Radiance or OpenEXR: `cargo +nightly fuzz run panorama`.
#![no_main]

#[path = "../check/panorama.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check(bytes));
