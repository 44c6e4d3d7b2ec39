//! The bytes of a .vox document: the inverse of `parse`.

use super::document::{Body, Chunk, Dict, VoxFile};
use std::borrow::Cow;

impl VoxFile<'_> {
    /// The bytes of the file with all models empty: what it says beyond voxels. `None` as [`Self::to_bytes`].
    pub fn to_bytes_without_voxels(&self) -> Option<Vec<u8>> {
        self.encoded(|out, chunk| match chunk {
            Chunk { body: Body::Voxels(_), extra, children, offset } => {
                let (extra, children) = (Cow::Borrowed(&extra[..]), Cow::Borrowed(&children[..]));
                put_chunk(out, &Chunk { body: Body::Voxels(Cow::Borrowed(&[])), extra, children, offset: *offset })
            }
            chunk => put_chunk(out, chunk),
        })
    }

    /// The bytes of the file, `None` where a chunk does not fit the format's 32-bit lengths.
    pub fn to_bytes(&self) -> Option<Vec<u8>> {
        self.encoded(put_chunk)
    }

    fn encoded(&self, put_chunk: impl Fn(&mut Vec<u8>, &Chunk) -> Option<()>) -> Option<Vec<u8>> {
        let mut out = Vec::new();
        out.extend_from_slice(b"VOX ");
        put(&mut out, self.version);
        out.extend_from_slice(b"MAIN");
        put(&mut out, u32::try_from(self.main.len()).ok()?);
        let children_length = out.len();
        put(&mut out, 0);
        out.extend_from_slice(&self.main);
        let children = out.len();
        for chunk in &self.chunks {
            put_chunk(&mut out, chunk)?;
        }
        let length = u32::try_from(out.len() - children).ok()?;
        out[children_length..children_length + 4].copy_from_slice(&length.to_le_bytes());
        out.extend_from_slice(&self.trailing);
        Some(out)
    }
}

fn put(out: &mut Vec<u8>, number: u32) {
    out.extend_from_slice(&number.to_le_bytes());
}

fn put_signed(out: &mut Vec<u8>, number: i32) {
    out.extend_from_slice(&number.to_le_bytes());
}

fn put_count(out: &mut Vec<u8>, count: usize) -> Option<()> {
    put(out, u32::try_from(count).ok()?);
    Some(())
}

fn put_text(out: &mut Vec<u8>, text: &[u8]) -> Option<()> {
    put_count(out, text.len())?;
    out.extend_from_slice(text);
    Some(())
}

fn put_dict(out: &mut Vec<u8>, dict: &Dict) -> Option<()> {
    put_count(out, dict.0.len())?;
    for (key, value) in &dict.0 {
        put_text(out, key)?;
        put_text(out, value)?;
    }
    Some(())
}

fn put_chunk(out: &mut Vec<u8>, chunk: &Chunk) -> Option<()> {
    out.extend_from_slice(&chunk.name());
    let content_length = out.len();
    put(out, 0);
    put_count(out, chunk.children.len())?;
    let content = out.len();
    put_body(out, &chunk.body)?;
    out.extend_from_slice(&chunk.extra);
    let length = u32::try_from(out.len() - content).ok()?;
    out[content_length..content_length + 4].copy_from_slice(&length.to_le_bytes());
    out.extend_from_slice(&chunk.children);
    Some(())
}

fn put_body(out: &mut Vec<u8>, body: &Body) -> Option<()> {
    match body {
        Body::Pack(models) => put(out, *models),
        Body::Size(size) => size.iter().for_each(|&edge| put(out, edge)),
        Body::Voxels(voxels) => {
            put_count(out, voxels.len())?;
            out.extend_from_slice(bytemuck::cast_slice(voxels));
        }
        Body::Palette(palette) => out.extend_from_slice(palette.as_flattened()),
        Body::Material(numbered) | Body::Camera(numbered) => {
            put_signed(out, numbered.id);
            put_dict(out, &numbered.properties)?;
        }
        Body::OldMaterial(material) => {
            put_signed(out, material.id);
            put(out, material.kind);
            out.extend_from_slice(&material.weight.to_le_bytes());
            put(out, material.properties);
            material.values.iter().for_each(|value| out.extend_from_slice(&value.to_le_bytes()));
        }
        Body::Transform(node) => {
            put_signed(out, node.id);
            put_dict(out, &node.attributes)?;
            [node.child, node.reserved, node.layer].into_iter().for_each(|number| put_signed(out, number));
            put_count(out, node.frames.len())?;
            node.frames.iter().try_for_each(|frame| put_dict(out, frame))?;
        }
        Body::Group(node) => {
            put_signed(out, node.id);
            put_dict(out, &node.attributes)?;
            put_count(out, node.children.len())?;
            node.children.iter().for_each(|&child| put_signed(out, child));
        }
        Body::Shape(node) => {
            put_signed(out, node.id);
            put_dict(out, &node.attributes)?;
            put_count(out, node.models.len())?;
            for (model, attributes) in &node.models {
                put_signed(out, *model);
                put_dict(out, attributes)?;
            }
        }
        Body::Layer(numbered, reserved) => {
            put_signed(out, numbered.id);
            put_dict(out, &numbered.properties)?;
            put_signed(out, *reserved);
        }
        Body::RenderObject(properties) => put_dict(out, properties)?,
        Body::Notes(notes) => {
            put_count(out, notes.len())?;
            notes.iter().try_for_each(|note| put_text(out, note))?;
        }
        Body::IndexMap(map) => out.extend_from_slice(map.as_slice()),
        Body::Unknown(_, content) => out.extend_from_slice(content),
    }
    Some(())
}
