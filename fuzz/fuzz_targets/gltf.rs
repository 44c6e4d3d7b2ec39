//! Reading any bytes as a mesh of this kind: `cargo +nightly fuzz run gltf`.
#![no_main]

#[path = "../check/mesh.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check("fuzzed.gltf", bytes));
