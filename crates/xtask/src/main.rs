//! Maintenance tasks of the repository: `cargo xtask pictures` renders the pictures of the documentation again, or those that are
//! named, `cargo xtask shaders` compiles the shaders, `cargo xtask shaders --check` says whether the committed ones are up to date,
//! `cargo xtask dist` packs the program for this machine, `cargo xtask web` builds the modules for pages.

mod dist;
mod pictures;
mod shaders;
mod web;

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let result = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["dist"] => dist::pack(),
        ["pictures", ref names @ ..] => pictures::render(names),
        ["shaders"] => shaders::generate(),
        ["shaders", "--check"] => shaders::check(),
        ["web", ref names @ ..] => web::build(names),
        _ => {
            eprintln!("usage: cargo xtask dist | pictures [NAME…] | shaders [--check] | web [MODULE…]");
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
