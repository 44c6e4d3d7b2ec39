//! Bytes to a .vox document. Every length is checked against the bytes that are there before anything is allocated.

use super::document::{Body, Chunk, Dict, GroupNode, Numbered, OldMaterial, ShapeNode, Text, TransformNode, VoxFile};
use super::slab6::is_slab6;
use std::{borrow::Cow, path::Path};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

impl<'a> VoxFile<'a> {
    /// Takes the bytes of a file apart. `path` names the file in errors.
    ///
    /// # Errors
    /// If the bytes are no MagicaVoxel file, end early, contradict their own lengths or go beyond `limits`.
    pub fn parse(bytes: &'a [u8], path: &Path, limits: &Limits) -> Result<Self, ImportError> {
        if bytes.len() as u64 > limits.bytes {
            return Err(ImportError::limit(path, None, "bytes of input", bytes.len() as u64, limits.bytes));
        }
        let mut file = Reader { bytes, at: 0, end: bytes.len(), path, what: "the file header", items: limits.items };
        check_magic(bytes, path)?;
        file.take(4)?;
        let version = file.u32()?;
        if !(150..=200).contains(&version) {
            let what = format!("version {version} of the .vox format, only 150 to 200 are known");
            return Err(ImportError::at(path, 4, ImportErrorKind::Unsupported(what)));
        }
        file.what = "the MAIN chunk";
        if file.take(4)? != b"MAIN" {
            return Err(ImportError::malformed(path, 8, "the file does not begin with a MAIN chunk"));
        }
        let (main_length, children_length) = (file.u32()?, file.u32()?);
        let main = Cow::Borrowed(file.take(main_length as usize)?);
        let children_end = file.at as u64 + u64::from(children_length);
        // A cut file is reported where it is cut, which is inside one of the chunks.
        file.end = bytes.len().min(usize::try_from(children_end).unwrap_or(usize::MAX));
        let mut chunks = Vec::new();
        while file.at < file.end {
            chunks.push(file.chunk(limits)?);
        }
        if children_end > bytes.len() as u64 {
            return Err(ImportError::truncated(path, bytes.len() as u64, "the MAIN chunk"));
        }
        Ok(Self { version, main, chunks, trailing: Cow::Borrowed(&bytes[file.end..]) })
    }
}

fn check_magic(bytes: &[u8], path: &Path) -> Result<(), ImportError> {
    match bytes.get(..4) {
        Some(b"VOX ") => Ok(()),
        Some(b"TDCZ") => {
            let what = "a .vox that Teardown has packed in a way of its own, which is not documented; take the plain .vox that it was made of";
            Err(ImportError::at(path, 0, ImportErrorKind::Unsupported(what.into())))
        }
        Some(_) => {
            let what = if is_slab6(bytes, bytes.len() as u64) {
                "a Slab6 .vox, which has only the name in common with MagicaVoxel's"
            } else {
                "this is no MagicaVoxel file, which would begin with `VOX `"
            };
            Err(ImportError::at(path, 0, ImportErrorKind::UnknownFormat(what.into())))
        }
        None => Err(ImportError::truncated(path, bytes.len() as u64, "the file header")),
    }
}

/// A cursor over `bytes[at..end]`.
struct Reader<'a, 'p> {
    bytes: &'a [u8],
    at: usize,
    end: usize,
    path: &'p Path,
    /// What is being read, for errors.
    what: &'static str,
    /// Items that may still be read.
    items: u64,
}

impl<'a> Reader<'a, '_> {
    fn take(&mut self, length: usize) -> Result<&'a [u8], ImportError> {
        match self.at.checked_add(length) {
            Some(end) if end <= self.end => {
                let taken = &self.bytes[self.at..end];
                self.at = end;
                Ok(taken)
            }
            Some(end) if end <= self.bytes.len() => {
                let what = format!("{} asks for {length} bytes, beyond its own end", self.what);
                Err(ImportError::malformed(self.path, self.at as u64, what))
            }
            _ => Err(ImportError::truncated(self.path, self.at as u64, self.what)),
        }
    }

    fn array<const N: usize>(&mut self) -> Result<&'a [u8; N], ImportError> {
        let at = self.at as u64;
        self.take(N)?.try_into().map_err(|_| ImportError::truncated(self.path, at, self.what))
    }

    fn u32(&mut self) -> Result<u32, ImportError> {
        Ok(u32::from_le_bytes(*self.array()?))
    }

    fn i32(&mut self) -> Result<i32, ImportError> {
        Ok(i32::from_le_bytes(*self.array()?))
    }

    fn finite(&mut self) -> Result<f32, ImportError> {
        let at = self.at as u64;
        let value = f32::from_le_bytes(*self.array()?);
        if value.is_finite() {
            Ok(value)
        } else {
            Err(ImportError::malformed(self.path, at, format!("{}: a property is {value}", self.what)))
        }
    }

    /// The number of things that follow, of at least `smallest` bytes each.
    fn count(&mut self, smallest: usize) -> Result<usize, ImportError> {
        let at = self.at as u64;
        let count = self.u32()? as usize;
        let room = (self.end - self.at) / smallest;
        if count > room {
            let what = format!("{} announces {count} entries, there is room for {room}", self.what);
            return Err(ImportError::malformed(self.path, at, what));
        }
        Ok(count)
    }

    /// As [`Self::count`], for things that cost more memory than their bytes in the file.
    fn item_count(&mut self, smallest: usize, limits: &Limits) -> Result<usize, ImportError> {
        let at = self.at as u64;
        let count = self.count(smallest)?;
        self.spend(count as u64, at, limits)?;
        Ok(count)
    }

    fn spend(&mut self, count: u64, at: u64, limits: &Limits) -> Result<(), ImportError> {
        let over =
            || ImportError::limit(self.path, Some(at), "chunks and their entries", limits.items + 1, limits.items);
        self.items = self.items.checked_sub(count).ok_or_else(over)?;
        Ok(())
    }

    fn text(&mut self) -> Result<Text<'a>, ImportError> {
        let length = self.count(1)?;
        Ok(Cow::Borrowed(self.take(length)?))
    }

    fn dict(&mut self, limits: &Limits) -> Result<Dict<'a>, ImportError> {
        let count = self.item_count(8, limits)?;
        (0..count).map(|_| Ok((self.text()?, self.text()?))).collect::<Result<_, _>>().map(Dict)
    }

    fn numbered(&mut self, limits: &Limits) -> Result<Numbered<'a>, ImportError> {
        Ok(Numbered { id: self.i32()?, properties: self.dict(limits)? })
    }

    fn chunk(&mut self, limits: &Limits) -> Result<Chunk<'a>, ImportError> {
        let offset = self.at;
        self.spend(1, offset as u64, limits)?;
        self.what = "a chunk header";
        let name = *self.array::<4>()?;
        let (content_length, children_length) = (self.u32()? as usize, self.u32()? as usize);
        self.what = describe(&name);
        let content_at = self.at;
        self.take(content_length)?;
        let children = Cow::Borrowed(self.take(children_length)?);
        let (after, end) = (self.at, self.end);
        (self.at, self.end) = (content_at, content_at + content_length);
        let body = self.body(&name, limits)?;
        let extra = Cow::Borrowed(&self.bytes[self.at..self.end]);
        (self.at, self.end) = (after, end);
        Ok(Chunk { offset: offset as u64, body, extra, children })
    }

    fn body(&mut self, name: &[u8; 4], limits: &Limits) -> Result<Body<'a>, ImportError> {
        Ok(match name {
            b"PACK" => Body::Pack(self.u32()?),
            b"SIZE" => Body::Size([self.u32()?, self.u32()?, self.u32()?]),
            b"XYZI" => {
                let count = self.count(4)?;
                Body::Voxels(Cow::Borrowed(self.take(count * 4)?.as_chunks::<4>().0))
            }
            b"RGBA" => {
                let mut palette = Box::new([[0; 4]; 256]);
                palette.as_flattened_mut().copy_from_slice(self.array::<1024>()?);
                Body::Palette(palette)
            }
            b"MATL" => Body::Material(self.numbered(limits)?),
            b"MATT" => Body::OldMaterial(self.old_material()?),
            b"nTRN" => Body::Transform(self.transform(limits)?),
            b"nGRP" => {
                let (id, attributes) = (self.i32()?, self.dict(limits)?);
                let count = self.count(4)?;
                Body::Group(GroupNode {
                    id,
                    attributes,
                    children: (0..count).map(|_| self.i32()).collect::<Result<_, _>>()?,
                })
            }
            b"nSHP" => {
                let (id, attributes) = (self.i32()?, self.dict(limits)?);
                let count = self.item_count(8, limits)?;
                let models = (0..count).map(|_| Ok((self.i32()?, self.dict(limits)?))).collect::<Result<_, _>>()?;
                Body::Shape(ShapeNode { id, attributes, models })
            }
            b"LAYR" => Body::Layer(self.numbered(limits)?, self.i32()?),
            b"rOBJ" => Body::RenderObject(self.dict(limits)?),
            b"rCAM" => Body::Camera(self.numbered(limits)?),
            b"NOTE" => {
                let count = self.item_count(4, limits)?;
                Body::Notes((0..count).map(|_| self.text()).collect::<Result<_, _>>()?)
            }
            b"IMAP" => Body::IndexMap(Box::new(*self.array()?)),
            _ => Body::Unknown(*name, Cow::Borrowed(self.take(self.end - self.at)?)),
        })
    }

    fn old_material(&mut self) -> Result<OldMaterial, ImportError> {
        let (id, kind, weight, properties) = (self.i32()?, self.u32()?, self.finite()?, self.u32()?);
        let count = (properties & 0x7f).count_ones();
        let values = (0..count).map(|_| self.finite()).collect::<Result<_, _>>()?;
        Ok(OldMaterial { id, kind, weight, properties, values })
    }

    fn transform(&mut self, limits: &Limits) -> Result<TransformNode<'a>, ImportError> {
        let (id, attributes) = (self.i32()?, self.dict(limits)?);
        let (child, reserved, layer) = (self.i32()?, self.i32()?, self.i32()?);
        let count = self.item_count(4, limits)?;
        let frames = (0..count).map(|_| self.dict(limits)).collect::<Result<_, _>>()?;
        Ok(TransformNode { id, attributes, child, reserved, layer, frames })
    }
}

fn describe(name: &[u8; 4]) -> &'static str {
    match name {
        b"PACK" => "the PACK chunk",
        b"SIZE" => "a SIZE chunk",
        b"XYZI" => "an XYZI chunk",
        b"RGBA" => "the RGBA chunk",
        b"MATL" => "a MATL chunk",
        b"MATT" => "a MATT chunk",
        b"nTRN" => "an nTRN chunk",
        b"nGRP" => "an nGRP chunk",
        b"nSHP" => "an nSHP chunk",
        b"LAYR" => "a LAYR chunk",
        b"rOBJ" => "an rOBJ chunk",
        b"rCAM" => "an rCAM chunk",
        b"NOTE" => "the NOTE chunk",
        b"IMAP" => "the IMAP chunk",
        _ => "a chunk of a kind unknown to voxtrace",
    }
}
