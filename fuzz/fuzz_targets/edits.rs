//! Any sequence of edits of a scene that is traced: `cargo +nightly fuzz run edits`.
#![no_main]

#[path = "../check/edits.rs"]
mod check;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| check::check(bytes));
