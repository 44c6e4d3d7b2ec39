//! `voxtrace formats`: every kind of file that is read or written.

use crate::failure::Failure;
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::Path;
use voxtrace::export::writer_of;
use voxtrace::import::READERS;

/// A kind of file.
struct Format {
    extension: &'static str,
    read: bool,
    write: bool,
    about: &'static str,
}

/// Films and pictures. A picture may also be read as a heightmap.
const OUTPUTS: [Format; 3] = [
    Format {
        extension: "vxf",
        read: true,
        write: true,
        about: "voxtrace film: continue it (render --resume), add it up (merge)",
    },
    Format {
        extension: "png",
        read: true,
        write: true,
        about: "picture, 8 or 16 bits, sRGB, optional alpha; read as a heightmap, a folder of them as slices",
    },
    Format {
        extension: "exr",
        read: false,
        write: true,
        about: "picture, linear, 16- or 32-bit floats, optional AOVs",
    },
];

/// Every kind once, by the first extension of each reader.
fn formats() -> Vec<Format> {
    let mut formats: Vec<Format> = Vec::new();
    for reader in READERS.iter() {
        let Some(&extension) = reader.extensions.first() else { continue };
        // Slab6 shares the extension of MagicaVoxel.
        if formats.iter().all(|format| format.extension != extension) {
            let write = extension == "vxt" || writer_of(Path::new(&format!("a.{extension}"))).is_some();
            formats.push(Format { extension, read: true, write, about: reader.about });
        }
    }
    formats.extend(OUTPUTS);
    formats
}

/// All extensions of the readers whose first one this is; it alone where there is no reader.
fn extensions_of(first: &'static str) -> BTreeSet<&'static str> {
    let readers = READERS.iter().filter(|reader| reader.extensions.first() == Some(&first));
    readers.flat_map(|reader| reader.extensions.iter().copied()).chain([first]).collect()
}

/// List the kinds of files that can be read and written
#[derive(clap::Args, Clone, Debug)]
pub struct FormatsArgs {
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

impl FormatsArgs {
    pub fn run(self) -> Result<(), Failure> {
        if self.json {
            let formats = formats().into_iter().map(|format| {
                json!({
                    "extension": format.extension, "extensions": extensions_of(format.extension), "read": format.read,
                    "write": format.write, "about": format.about,
                })
            });
            let formats: Vec<Value> = formats.collect();
            crate::stdout::print(&format!("{:#}\n", json!({ "formats": formats })));
            return Ok(());
        }
        let yes = |yes: bool| if yes { "yes" } else { "-" };
        let formats = formats();
        let widest = formats.iter().map(|format| format.extension.len() + 1).max().unwrap_or(0);
        crate::stdout::print(&format!("{:<widest$}  {:<6}{:<7}{}\n", "kind", "read", "write", "what"));
        for format in formats {
            let name = format!(".{}", format.extension);
            let (read, write) = (yes(format.read), yes(format.write));
            crate::stdout::print(&format!("{name:<widest$}  {read:<6}{write:<7}{}\n", format.about));
        }
        Ok(())
    }
}
