//! voxtrace as a module of WebAssembly, as the workers of the element `<voxtrace-viewer>` (`web/`) use it: scenes from names and from bytes, parts of
//! pictures as the words of their film, films as what screens show. It has no file system, no threads and no clock; a worker calls it.
//! `docs/web.md` says how pages use it, `docs/decisions/0210-viewer-for-pages.md` why it is as it is.
//!
//! Errors reach JavaScript as values of `Error` whose message is the library's own line.

#[cfg(feature = "tracer")]
mod film_words;
#[cfg(feature = "gpu")]
mod gpu;
#[cfg(any(feature = "tracer", feature = "gpu"))]
mod part;
#[cfg(feature = "tracer")]
mod render;
#[cfg(any(feature = "tracer", feature = "scenes", feature = "readers"))]
mod scene;
#[cfg(feature = "tracer")]
mod selftest;
#[cfg(feature = "stream")]
mod stream;

#[cfg(feature = "tracer")]
pub use film_words::{film_from_words, film_words, shown};
#[cfg(feature = "gpu")]
pub use gpu::{GpuArrays, GpuRealTime, GpuScene};
#[cfg(any(feature = "tracer", feature = "gpu"))]
pub use part::Part;
#[cfg(feature = "tracer")]
pub use render::render_part;
#[cfg(any(feature = "tracer", feature = "scenes", feature = "readers"))]
pub use scene::{WebScene, format_of};
#[cfg(feature = "tracer")]
pub use selftest::selftest;
#[cfg(feature = "stream")]
pub use stream::{Stream, checksum};

use wasm_bindgen::prelude::*;

/// Lets a panic end the call with its message as the error, not as `unreachable`. Called once, when the module has started.
#[cfg(target_arch = "wasm32")]
#[wasm_bindgen(start)]
fn start() {
    std::panic::set_hook(Box::new(|panic| wasm_bindgen::throw_str(&panic.to_string())));
}

/// An error for JavaScript with the message of one of ours.
fn error_of(error: impl std::error::Error) -> JsError {
    JsError::new(&error.to_string())
}
