//! Vertices of a PLY file by their numbers: blocks of them are read when they are needed and kept as long as there is room.

use super::header::{Element, Encoding};
use super::values::Values;
use super::vertices::{Columns, FullIntensity, append};
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::source::input::Input;
use glam::{DVec3, Vec2, Vec3, Vec4};
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::{ImportError, Limits};

/// Vertices of a block: 2^12.
const BLOCK_BITS: u32 = 12;
const BLOCK: usize = 1 << BLOCK_BITS;
/// No block.
const NONE: u32 = u32::MAX;

/// Vertices of a block. Arrays that the file or its user do not have are empty.
#[derive(Default)]
struct Block {
    positions: Vec<Vec3>,
    colors: Vec<Vec4>,
    uvs: Vec<Vec2>,
}

/// Vertices without lists in a binary file.
pub(super) struct VertexCache {
    file: File,
    element: Element,
    full: FullIntensity,
    encoding: Encoding,
    /// Where the first vertex begins, and the bytes of each.
    start: u64,
    size: u64,
    local_origin: LocalOrigin,
    has_uvs: bool,
    /// Which block is in which slot; block b can only be in slot b modulo their number.
    held: Vec<u32>,
    slots: Vec<Block>,
    mask: u32,
    bytes: Vec<u8>,
}

impl VertexCache {
    /// The vertices of an element that begins at byte `start`, with what is full intensity in its colours, in about `budget` bytes.
    pub fn open(
        path: &Path,
        (element, full): (Element, FullIntensity),
        encoding: Encoding,
        start: u64,
        has_uvs: bool,
        budget: u64,
    ) -> Result<Self, ImportError> {
        crate::import::source::opened::note(path);
        let file = File::open(path).map_err(|error| ImportError::io(path, error))?;
        let size = element.properties.iter().map(|property| property.kind.size() as u64).sum();
        let blocks = element.count.div_ceil(BLOCK as u64);
        let block_bytes = BLOCK as u64 * Self::vertex_bytes(&element, has_uvs);
        let room = (budget / block_bytes).max(4);
        // All of them, or a power of two.
        let slots = if blocks <= room { blocks.next_power_of_two() } else { 1 << room.ilog2() };
        let mut cache = Self {
            file,
            element,
            full,
            encoding,
            start,
            size,
            local_origin: LocalOrigin::default(),
            has_uvs,
            held: vec![NONE; slots as usize],
            slots: Vec::new(),
            mask: slots as u32 - 1,
            bytes: Vec::new(),
        };
        cache.slots.resize_with(slots as usize, Block::default);
        // The first vertex decides where the local_origin is.
        if cache.element.count > 0 {
            cache.find(path, 0)?;
        }
        Ok(cache)
    }

    /// Bytes of a vertex in memory.
    fn vertex_bytes(element: &Element, has_uvs: bool) -> u64 {
        let has_colors = Columns::of(element).is_some_and(|columns| columns.color.is_some());
        12 + if has_colors { 16 } else { 0 } + if has_uvs { 8 } else { 0 }
    }

    /// What all positions are relative to.
    pub fn offset(&self) -> DVec3 {
        self.local_origin.offset()
    }

    /// Gives the memory back.
    pub fn release(&mut self) {
        self.held.fill(NONE);
        self.slots.iter_mut().for_each(|slot| *slot = Block::default());
    }

    /// The position of a vertex.
    #[inline]
    pub fn position(&mut self, path: &Path, vertex: u32) -> Result<Vec3, ImportError> {
        let (slot, at) = self.find(path, vertex)?;
        Ok(self.slots[slot].positions[at])
    }

    /// Appends a vertex to a mesh.
    #[inline]
    pub fn push(&mut self, path: &Path, vertex: u32, mesh: &mut Mesh) -> Result<(), ImportError> {
        let (slot, at) = self.find(path, vertex)?;
        let block = &self.slots[slot];
        mesh.positions.push(block.positions[at]);
        if let Some(&color) = block.colors.get(at) {
            mesh.colors.push(color);
        }
        if let Some(&uv) = block.uvs.get(at) {
            mesh.uvs.push(uv);
        }
        Ok(())
    }

    /// Slot and place in it of a vertex that exists.
    #[inline]
    fn find(&mut self, path: &Path, vertex: u32) -> Result<(usize, usize), ImportError> {
        let block = vertex >> BLOCK_BITS;
        let slot = (block & self.mask) as usize;
        if self.held[slot] != block {
            self.load(path, block, slot)?;
        }
        Ok((slot, vertex as usize & (BLOCK - 1)))
    }

    #[cold]
    fn load(&mut self, path: &Path, block: u32, slot: usize) -> Result<(), ImportError> {
        let first = u64::from(block) * BLOCK as u64;
        let count = (self.element.count - first).min(BLOCK as u64);
        let start = self.start + first * self.size;
        self.bytes.resize((count * self.size) as usize, 0);
        let read = self.file.seek(SeekFrom::Start(start)).and_then(|_| self.file.read_exact(&mut self.bytes));
        read.map_err(|error| match error.kind() {
            std::io::ErrorKind::UnexpectedEof => ImportError::truncated(path, start, "the vertices"),
            _ => ImportError::io(path, error),
        })?;
        let limits = Limits { bytes: u64::MAX, ..Limits::default() };
        let mut values = Values::new(Input::of_bytes(&self.bytes, path, &limits)?, self.encoding);
        let element = Element { count, ..self.element.clone() };
        let mut mesh = Mesh::new("");
        let appended = append(&mut values, &element, &mut self.local_origin, &mut mesh);
        appended.map_err(|error| {
            let offset = error.offset.map(|offset| start + offset);
            error.with_offset(offset)
        })?;
        self.full.make_linear(&mut mesh.colors);
        let uvs = if self.has_uvs { mesh.uvs } else { Vec::new() };
        self.slots[slot] = Block { positions: mesh.positions, colors: mesh.colors, uvs };
        self.held[slot] = block;
        Ok(())
    }
}
