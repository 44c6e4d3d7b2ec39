//! Reading any bytes as a file of voxels of each kind: `cargo +nightly fuzz run voxels`.
#![no_main]

#[path = "../check/voxels.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check_all(bytes));
