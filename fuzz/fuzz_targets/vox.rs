//! Reading any bytes as a MagicaVoxel file: `cargo +nightly fuzz run vox`.
#![no_main]

#[path = "../check/vox.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check(bytes));
