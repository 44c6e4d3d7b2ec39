//! The bytes behind a glTF document: the binary chunk, `data:` URIs and files in the document's folder.

use super::file_part::FilePart;
use super::{Fault, base64, document::Document, meshopt};
use crate::import::source::folder::{Folder, Refused};
use std::borrow::Cow;
use std::ops::Range;
use voxtrace_voxelize::{ImportErrorKind, Limits};

/// Files that stay open for what is read of them later. Systems give a process some hundreds: what lies in more files is read at once.
const MOST_FILES: usize = 64;

/// The buffers, each as long as the document says.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    content: Vec<Content<'a>>,
    /// What views hold that were compressed, or read by themselves.
    unpacked: Vec<Option<Vec<u8>>>,
}

/// The bytes of a buffer.
pub(super) enum Content<'a> {
    Memory(Cow<'a, [u8]>),
    File(FilePart),
}

/// Some bytes of a buffer.
pub(super) enum Part<'a> {
    Memory(&'a [u8]),
    File(&'a FilePart, Range<usize>),
}

impl Content<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Memory(bytes) => bytes.len(),
            Self::File(part) => part.len(),
        }
    }
}

impl<'a> Part<'a> {
    /// Those from an offset on, so many; `None` where there are fewer.
    pub fn slice(&self, offset: usize, length: usize) -> Option<Self> {
        let end = offset.checked_add(length)?;
        match *self {
            Self::Memory(bytes) => bytes.get(offset..end).map(Self::Memory),
            Self::File(part, ref range) => {
                (end <= range.len()).then(|| Self::File(part, range.start + offset..range.start + end))
            }
        }
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        match self {
            Self::Memory(bytes) => bytes.len(),
            Self::File(_, range) => range.len(),
        }
    }

    /// All of them in memory.
    pub fn bytes(self) -> Result<Cow<'a, [u8]>, Fault> {
        match self {
            Self::Memory(bytes) => Ok(Cow::Borrowed(bytes)),
            Self::File(part, range) => part.bytes(range).map(Cow::Owned),
        }
    }
}

impl<'a> Buffers<'a> {
    pub fn read(
        document: &'a Document,
        mut binary: Option<Content<'a>>,
        folder: &Folder,
        limits: &Limits,
    ) -> Result<Self, Fault> {
        let (mut content, mut total, mut files) = (Vec::new(), 0, 0);
        for (index, buffer) in document.buffers.iter().enumerate() {
            let found = match &buffer.uri {
                Some(uri) if files < MOST_FILES => named(uri, folder)?,
                Some(uri) => Content::Memory(Cow::Owned(read_uri(uri, folder)?)),
                // Without bytes, as the fallback of compressed buffers has it: a fault only if something reads it.
                None => binary.take().filter(|_| index == 0).unwrap_or(Content::Memory(Cow::Borrowed(&[]))),
            };
            if found.len() < buffer.byte_length && buffer.uri.is_some() {
                let what = format!("buffer {index} has {} of its {} bytes", found.len(), buffer.byte_length);
                return Err(Fault::malformed(what));
            }
            total += found.len() as u64;
            if total > limits.bytes {
                return Err(Fault::limit("bytes of input", total, limits.bytes));
            }
            files += usize::from(matches!(found, Content::File(_)));
            content.push(found);
        }
        let mut buffers = Self { document, content, unpacked: Vec::new() };
        // Many views may name one place.
        let mut stored = 0_u64;
        for (index, view) in document.buffer_views.iter().enumerate() {
            let Some(packed) = &view.extensions.meshopt else {
                buffers.unpacked.push(None);
                continue;
            };
            let part = buffers.part(index, packed.buffer, packed.byte_offset, packed.byte_length)?;
            stored = stored.saturating_add(part.len() as u64);
            if stored > limits.bytes {
                return Err(Fault::limit("bytes of compressed buffer views", stored, limits.bytes));
            }
            let bytes = part.bytes()?;
            let bytes = meshopt::decode(packed, &bytes, limits)?;
            total += bytes.len() as u64;
            if total > limits.bytes {
                return Err(Fault::limit("bytes of input", total, limits.bytes));
            }
            if bytes.len() < view.byte_length {
                return Err(Fault::malformed(format!("buffer view {index} goes beyond what it is packed as")));
            }
            buffers.unpacked.push(Some(bytes));
        }
        Ok(buffers)
    }

    /// No buffers but some of their views.
    pub fn of_views(document: &'a Document, views: Vec<Option<Vec<u8>>>) -> Self {
        Self { document, content: Vec::new(), unpacked: views }
    }

    /// Bytes of a buffer that a view names.
    fn part(&self, view: usize, buffer: usize, offset: usize, length: usize) -> Result<Part<'_>, Fault> {
        let content = self.content.get(buffer);
        let whole = match content.ok_or_else(|| Fault::malformed(format!("buffer {buffer} is missing")))? {
            Content::Memory(bytes) => Part::Memory(bytes),
            Content::File(part) => Part::File(part, 0..part.len()),
        };
        whole
            .slice(offset, length)
            .ok_or_else(|| Fault::malformed(format!("buffer view {view} goes beyond its buffer")))
    }

    /// The bytes of a view and its stride.
    pub fn view(&self, index: usize) -> Result<(Part<'_>, Option<usize>), Fault> {
        let view = self.document.buffer_views.get(index);
        let view = view.ok_or_else(|| Fault::malformed(format!("buffer view {index} is missing")))?;
        if let Some(bytes) = self.unpacked.get(index).and_then(Option::as_ref) {
            return Ok((Part::Memory(bytes), view.byte_stride));
        }
        Ok((self.part(index, view.buffer, view.byte_offset, view.byte_length)?, view.byte_stride))
    }
}

/// The buffer that a URI names: a file beside the document is read as it is needed.
fn named(uri: &str, folder: &Folder) -> Result<Content<'static>, Fault> {
    if !uri.starts_with("data:")
        && let Some((file, length)) = folder.open_uri(uri).map_err(refused)?
    {
        return Ok(Content::File(FilePart::new(Box::new(file), 0..length)));
    }
    read_uri(uri, folder).map(|bytes| Content::Memory(Cow::Owned(bytes)))
}

/// The bytes that a URI names.
pub(super) fn read_uri(uri: &str, folder: &Folder) -> Result<Vec<u8>, Fault> {
    if uri.starts_with("data:") {
        return base64::of_data_uri(uri).ok_or_else(|| Fault::malformed("a data: URI that is not base64"));
    }
    folder.read_uri(uri).map_err(refused)
}

fn refused(refused: Refused) -> Fault {
    let kind = match refused {
        Refused::Io { name, error } => {
            ImportErrorKind::Io(std::io::Error::new(error.kind(), format!("{name}: {error}")))
        }
        Refused::TooLong { .. } | Refused::NoFolder(_) | Refused::Outside(_) => {
            ImportErrorKind::Unsupported(refused.to_string())
        }
    };
    Fault { offset: 0, kind }
}
