//! Reading any files as a folder of Zarr: `cargo +nightly fuzz run zarr`.
#![no_main]

#[path = "../check/zarr.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check(bytes));
