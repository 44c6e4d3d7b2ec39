//! The bytes behind a glTF document: the binary chunk, `data:` URIs and files in the document's folder.

use super::{Fault, base64, document::Document, meshopt};
use crate::import::source::folder::{Folder, Refused};
use std::borrow::Cow;
use voxtrace_voxelize::{ImportErrorKind, Limits};

/// The buffers, each as long as the document says.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    bytes: Vec<Cow<'a, [u8]>>,
    /// What views hold that were compressed, or read by themselves.
    unpacked: Vec<Option<Vec<u8>>>,
}

impl<'a> Buffers<'a> {
    pub fn read(
        document: &'a Document,
        binary: Option<&'a [u8]>,
        folder: &Folder,
        limits: &Limits,
    ) -> Result<Self, Fault> {
        let (mut bytes, mut total) = (Vec::new(), 0);
        for (index, buffer) in document.buffers.iter().enumerate() {
            let found = match (&buffer.uri, binary) {
                (Some(uri), _) => Cow::Owned(read_uri(uri, folder)?),
                (None, Some(binary)) if index == 0 => Cow::Borrowed(binary),
                // Without bytes, as the fallback of compressed buffers has it: a fault only if something reads it.
                (None, _) => Cow::Borrowed(&[][..]),
            };
            if found.len() < buffer.byte_length && buffer.uri.is_some() {
                let what = format!("buffer {index} has {} of its {} bytes", found.len(), buffer.byte_length);
                return Err(Fault::malformed(what));
            }
            total += found.len() as u64;
            if total > limits.bytes {
                return Err(Fault::limit("bytes of input", total, limits.bytes));
            }
            bytes.push(found);
        }
        let mut buffers = Self { document, bytes, unpacked: Vec::new() };
        for (index, view) in document.buffer_views.iter().enumerate() {
            let Some(packed) = &view.extensions.meshopt else {
                buffers.unpacked.push(None);
                continue;
            };
            let bytes = buffers.part(index, packed.buffer, packed.byte_offset, packed.byte_length)?;
            let bytes = meshopt::decode(packed, bytes, limits)?;
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
        Self { document, bytes: Vec::new(), unpacked: views }
    }

    /// Bytes of a buffer that a view names.
    fn part(&self, view: usize, buffer: usize, offset: usize, length: usize) -> Result<&[u8], Fault> {
        let bytes = self.bytes.get(buffer);
        let bytes = bytes.ok_or_else(|| Fault::malformed(format!("buffer {buffer} is missing")))?;
        let part = offset.checked_add(length).and_then(|end| bytes.get(offset..end));
        part.ok_or_else(|| Fault::malformed(format!("buffer view {view} goes beyond its buffer")))
    }

    /// The bytes of a view and its stride.
    pub fn view(&self, index: usize) -> Result<(&[u8], Option<usize>), Fault> {
        let view = self.document.buffer_views.get(index);
        let view = view.ok_or_else(|| Fault::malformed(format!("buffer view {index} is missing")))?;
        if let Some(bytes) = self.unpacked.get(index).and_then(Option::as_ref) {
            return Ok((bytes, view.byte_stride));
        }
        Ok((self.part(index, view.buffer, view.byte_offset, view.byte_length)?, view.byte_stride))
    }
}

/// The bytes that a URI names.
pub(super) fn read_uri(uri: &str, folder: &Folder) -> Result<Vec<u8>, Fault> {
    if uri.starts_with("data:") {
        return base64::of_data_uri(uri).ok_or_else(|| Fault::malformed("a data: URI that is not base64"));
    }
    folder.read_uri(uri).map_err(|refused| {
        let kind = match refused {
            Refused::Io { name, error } => {
                ImportErrorKind::Io(std::io::Error::new(error.kind(), format!("{name}: {error}")))
            }
            Refused::TooLong { .. } | Refused::NoFolder(_) | Refused::Outside(_) => {
                ImportErrorKind::Unsupported(refused.to_string())
            }
        };
        Fault { offset: 0, kind }
    })
}
