//! Opening any bytes as a native file whose checksums are right, and tracing what is opened, on a Vulkan device too where there is
//! one: `cargo +nightly fuzz run native`. Software takes `VOXTRACE_DEVICE=llvmpipe`.
#![no_main]

#[path = "../check/native.rs"]
mod check;
#[path = "../check/checksums.rs"]
mod checksums;
#[path = "../check/devices.rs"]
mod devices;

use devices::Tracers;
use std::cell::RefCell;
use voxtrace_tests::gpu::device;

thread_local! {
    static TRACERS: RefCell<Option<Tracers>> = RefCell::new(device().map(|device| Tracers::few(&device)));
}

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let Some(traced) = check::check(bytes) else { return };
    TRACERS.with_borrow_mut(|tracers| tracers.as_mut().map(|tracers| tracers.check(&traced)));
});
