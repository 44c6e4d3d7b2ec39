//! A page for a folder of voxel scenes: what is there with thumbnails, each scene in the viewer, files that are dropped converted, and pictures that the
//! server traces where the page cannot. `voxtrace serve` is its command line, `docs/serve.md` says how it is used and what it withstands,
//! `docs/decisions/0217-serving-a-folder.md` why it is as it is.
//!
//! ```no_run
//! # fn main() -> Result<(), voxtrace_serve::ServeError> {
//! use voxtrace_serve::{Server, Settings};
//!
//! let server = Server::bind(Settings::new("scans", "127.0.0.1:8080".parse().unwrap()))?;
//! println!("{}", server.url());
//! server.run(|| false)
//! # }
//! ```

#![forbid(unsafe_code)]

mod access;
mod connections;
mod files;
mod info;
mod joint;
mod kept;
mod listing;
mod page;
mod picture;
mod places;
mod refusal;
mod remote;
mod scenes;
mod server;
mod settings;
mod sources;
mod thumbnails;
mod upload;

pub use server::{ServeError, Server, Viewers};
pub use settings::{Limits, Settings};
