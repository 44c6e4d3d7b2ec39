//! glTF 2.0, as text with its files beside it and as one binary file (Khronos, "glTF 2.0 Specification"). Read are triangles
//! with their nodes, skins, morph targets, materials, pictures and cameras, and animations; of a document without triangles its points and lines.

mod accessor;
mod animations;
mod arrays;
mod base64;
mod buffers;
mod byte_cache;
mod cameras;
mod changing;
mod document;
mod draco;
mod file_part;
mod large;
mod layers;
mod material_json;
mod materials;
mod meshopt;
mod morphs;
mod moving;
mod not_shown;
mod primitives;
mod scene;
mod skins;

use crate::import::reader::{Geometry, ImportOptions, Kind, LargeContent, Magic, Reader};
use crate::import::source::folder::Folder;
use crate::import::source::input::{Input, without_mark};
use buffers::{Buffers, Content};
use document::Document;
use file_part::FilePart;
use serde::de::IgnoredAny;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io::{ErrorKind, SeekFrom};
use std::ops::Range;
use std::path::Path;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "glTF",
    Kind::Mesh,
    &["glb", "gltf"],
    "glTF 2.0 mesh, and .gltf: materials, pictures, nodes that move, cameras",
    |source, options| {
        let (input, folder) = source.into_input()?;
        Ok(read(input, &folder, options)?.into())
    },
)
.with_magic(&[Magic::first(MAGIC)])
.with_up_axis(Some(UpAxis::Y))
.with_large(|source, budget, options| {
    let (path, limits) = (source.path(), &options.limits);
    let source = large::GltfTriangles::open(path, budget, limits)?;
    Ok(source.map(|source| {
        let (size, arrays) = (source.size_bytes(), source.arrays().to_path_buf());
        LargeContent { files: vec![arrays], ..LargeContent::of_triangles(source, size) }
    }))
});

/// First bytes of a binary file.
const MAGIC: &[u8; 4] = b"glTF";
const CHUNK_JSON: u32 = 0x4e4f_534a;
const CHUNK_BIN: u32 = 0x004e_4942;

/// Extensions that may be required: those that are read, and those that only change the shading.
const KNOWN: [&str; 8] = [
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
    "EXT_texture_webp",
    "KHR_lights_punctual",
    "KHR_xmp_json_ld",
];

/// A fault without the name of the file.
pub(super) struct Fault {
    offset: u64,
    kind: ImportErrorKind,
}

impl Fault {
    fn malformed(what: impl Into<String>) -> Self {
        Self { offset: 0, kind: ImportErrorKind::Malformed(what.into()) }
    }

    fn unsupported(what: impl Into<String>) -> Self {
        Self { offset: 0, kind: ImportErrorKind::Unsupported(what.into()) }
    }

    fn limit(what: &str, value: u64, limit: u64) -> Self {
        Self { offset: 0, kind: ImportErrorKind::Limit { what: what.into(), value, limit } }
    }
}

/// Reads a glTF file of either kind. The arrays of a binary one stay in the file until they are needed.
fn read(mut input: Input, folder: &Folder, options: &ImportOptions) -> Result<Geometry, ImportError> {
    let path = input.path();
    if !input.peek(MAGIC.len())?.starts_with(MAGIC) || input.file()?.is_none() {
        return read_whole(&input.rest()?, path, folder, options);
    }
    let (mut file, length) = input.seekable()?;
    let mut fill = |at: u64, bytes: &mut [u8]| {
        let read = file.seek(SeekFrom::Start(at)).and_then(|_| file.read_exact(bytes));
        read.map_err(|error| match error.kind() {
            // It has become shorter meanwhile.
            ErrorKind::UnexpectedEof => ImportError::truncated(path, at, "a chunk"),
            _ => ImportError::io(path, error),
        })
    };
    let Container { json, binary } = container(length, path, &mut fill)?;
    let mut text = vec![0; (json.end - json.start) as usize];
    fill(json.start, &mut text)?;
    let document = parse(&text, json.start, path)?;
    drop(text);
    let binary = binary.map(|range| Content::File(FilePart::new(file, range)));
    geometry(&document, json.start, binary, (path, folder, options))
}

fn read_whole(bytes: &[u8], path: &Path, folder: &Folder, options: &ImportOptions) -> Result<Geometry, ImportError> {
    let (json, json_offset, binary) = split(bytes, path)?;
    let document = parse(json, json_offset, path)?;
    let binary = binary.map(|bytes| Content::Memory(Cow::Borrowed(bytes)));
    geometry(&document, json_offset, binary, (path, folder, options))
}

/// The document of a text, which begins at a byte of the file.
fn parse(json: &[u8], json_offset: u64, path: &Path) -> Result<Document, ImportError> {
    serde_json::from_slice(json).map_err(|error| {
        if let Some(version) = old_version(json) {
            return ImportError::at(path, json_offset, ImportErrorKind::Unsupported(too_old(&version)));
        }
        let offset = json_offset + offset_of(json, error.line(), error.column());
        if error.is_eof() {
            ImportError::truncated(path, offset, "the JSON of a glTF file")
        } else {
            ImportError::malformed(path, offset, format!("JSON: {error}"))
        }
    })
}

/// What a document and its binary chunk say.
fn geometry(
    document: &Document,
    json_offset: u64,
    binary: Option<Content>,
    (path, folder, options): (&Path, &Folder, &ImportOptions),
) -> Result<Geometry, ImportError> {
    let limits = &options.limits;
    let read = || {
        check(document, limits)?;
        let buffers = Buffers::read(document, binary, folder, limits)?;
        scene::read(document, &buffers, folder, options)
    };
    read().map_err(|fault| ImportError::at(path, json_offset + fault.offset, fault.kind))
}

/// The version that a document says, where it is not 2: what older documents hold is written otherwise. Those of version 1 need not
/// say any.
fn old_version(json: &[u8]) -> Option<String> {
    #[derive(serde::Deserialize)]
    struct Old {
        #[serde(default)]
        asset: Option<OldAsset>,
        /// Lists of version 2 are objects there.
        #[serde(default)]
        meshes: BTreeMap<String, IgnoredAny>,
    }
    #[derive(serde::Deserialize)]
    struct OldAsset {
        #[serde(default)]
        version: Option<serde_json::Value>,
    }
    let old: Old = serde_json::from_slice(json).ok()?;
    let version = old.asset.and_then(|asset| asset.version).map(|version| match version {
        serde_json::Value::String(text) => text,
        other => other.to_string(),
    });
    let is_one = version.is_none() && !old.meshes.is_empty();
    version.or(is_one.then(|| "1.0".to_owned())).filter(|version| !version.starts_with('2'))
}

fn too_old(version: &str) -> String {
    format!("glTF of version {version:.40}; version 2 is read: convert it, for example with gltf-pipeline")
}

/// Where the parts of a binary file lie.
struct Container {
    json: Range<u64>,
    binary: Option<Range<u64>>,
}

/// The parts of a file in memory: its text, where that begins, and the binary chunk.
type Parts<'a> = (&'a [u8], u64, Option<&'a [u8]>);

fn split<'a>(bytes: &'a [u8], path: &Path) -> Result<Parts<'a>, ImportError> {
    if !bytes.starts_with(MAGIC) {
        let json = without_mark(bytes);
        return Ok((json, (bytes.len() - json.len()) as u64, None));
    }
    let part = |range: &Range<u64>| &bytes[range.start as usize..range.end as usize];
    let fill = |at: u64, word: &mut [u8]| {
        word.copy_from_slice(part(&(at..at + word.len() as u64)));
        Ok(())
    };
    let Container { json, binary } = container(bytes.len() as u64, path, fill)?;
    Ok((part(&json), json.start, binary.as_ref().map(part)))
}

/// Where the parts of a binary file of so many bytes lie, of which `fill` gives those from a place on that is in it.
fn container(
    bytes: u64,
    path: &Path,
    mut fill: impl FnMut(u64, &mut [u8]) -> Result<(), ImportError>,
) -> Result<Container, ImportError> {
    let mut word = |at: u64| {
        if at + 4 > bytes {
            return Err(ImportError::truncated(path, bytes, "a header"));
        }
        let mut word = [0; 4];
        fill(at, &mut word).map(|()| u32::from_le_bytes(word))
    };
    let (version, length) = (word(4)?, u64::from(word(8)?));
    if version != 2 {
        return Err(ImportError::at(path, 4, ImportErrorKind::Unsupported(too_old(&version.to_string()))));
    }
    if length > bytes {
        let what = format!("the {length} bytes that its header announces");
        return Err(ImportError::truncated(path, bytes, what));
    }
    let (mut json, mut binary) = (None, None);
    let mut at = 12;
    while at + 8 <= length {
        let (size, kind) = (u64::from(word(at)?), word(at + 4)?);
        let chunk = at + 8..at + 8 + size;
        if chunk.end > length {
            return Err(ImportError::truncated(path, length, "a chunk"));
        }
        at = chunk.end;
        match kind {
            CHUNK_JSON if json.is_none() => json = Some(chunk),
            CHUNK_BIN if binary.is_none() => binary = Some(chunk),
            _ => {}
        }
    }
    let json = json.ok_or_else(|| ImportError::malformed(path, 12, "the JSON chunk is missing"))?;
    Ok(Container { json, binary })
}

/// Byte of a line and a column, both from 1 on.
fn offset_of(text: &[u8], line: usize, column: usize) -> u64 {
    let lines = text.split_inclusive(|&byte| byte == b'\n').take(line.saturating_sub(1));
    let offset = lines.map(<[u8]>::len).sum::<usize>() + column.saturating_sub(1);
    offset.min(text.len()) as u64
}

/// What can be said before anything is read.
fn check(document: &Document, limits: &Limits) -> Result<(), Fault> {
    if !document.asset.version.starts_with("2.") {
        return Err(Fault::unsupported(too_old(&document.asset.version)));
    }
    for name in &document.extensions_required {
        if !KNOWN.contains(&name.as_str()) && !name.starts_with("KHR_materials_") {
            let hint = match name.as_str() {
                "KHR_texture_basisu" => "; save its pictures as PNG, JPEG or WebP",
                _ => "",
            };
            return Err(Fault::unsupported(format!("the file requires the glTF extension {name}{hint}")));
        }
    }
    let items = document.nodes.len() + document.meshes.len() + document.accessors.len() + document.buffer_views.len();
    let items = (items + document.materials.len() + document.images.len()) as u64;
    if items > limits.items {
        return Err(Fault::limit("items of the glTF document", items, limits.items));
    }
    Ok(())
}
