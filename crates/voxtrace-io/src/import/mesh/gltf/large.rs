//! Binary glTF files, and texts with one file beside them, larger than memory: the document and its pictures are read, arrays stay in the file, and triangles are
//! made one after the other. What is not plain (compressed or sparse arrays, buffers in other files, skins, morph targets with a weight, faults) is left to the
//! reader that reads all of it.

use super::arrays::{Array, Container, container, pictures};
use super::byte_cache::ByteCache;
use super::document::{Document, Primitive};
use super::moving::Movers;
use super::primitives::{coordinates, has_triangles, placed, triangle_at, triangle_count};
use super::scene::{Found, Looks, cameras_at, look, note_of_skipped, visit};
use super::{Buffers, check, morphs};
use crate::import::reader::local_origin::LocalOrigin;
use crate::import::source::folder::Folder;
use glam::{DAffine3, Vec2, Vec4};
use std::fs::File;
use std::ops::Range;
use std::path::Path;
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::mesh::source::{SourceColors, TriangleSource};
use voxtrace_voxelize::{ImportError, Limits};

/// Corners that are handed on at once.
const PIECE: usize = 3 << 15;

/// The triangles of a binary glTF file.
pub(super) struct GltfTriangles {
    parts: Vec<Part>,
    local_origin: LocalOrigin,
    frame: Mesh,
    /// Of indices, positions, colours and texture coordinates, so that none drives out another.
    caches: [ByteCache; 4],
    has_colors: bool,
    has_uvs: bool,
    bytes: u64,
}

/// The triangles of a primitive, where a node has them.
struct Part {
    world: DAffine3,
    mode: u32,
    material: u16,
    indices: Option<Array>,
    positions: Array,
    colors: Option<Array>,
    uvs: Option<Array>,
}

impl GltfTriangles {
    /// Opens a file, if its triangles can be read so.
    pub fn open(path: &Path, budget: u64, limits: &Limits) -> Result<Option<Self>, ImportError> {
        crate::import::source::opened::note(path);
        let io = |error| ImportError::io(path, error);
        let folder = Folder::of(path, limits);
        let mut bytes = std::fs::metadata(path).map_err(io)?.len();
        let Some(Container { json, arrays, binary }) = container(path, &folder, bytes, budget).map_err(io)? else {
            return Ok(None);
        };
        let mut file = File::open(&arrays).map_err(io)?;
        bytes = bytes.max(binary.end);
        let Ok(document) = serde_json::from_slice::<Document>(&json) else { return Ok(None) };
        drop(json);
        let views = pictures(&document, &mut file, &binary, budget).map_err(io)?;
        let (Some(views), Ok(())) = (views, check(&document, limits)) else { return Ok(None) };
        let Ok(Looks { mesh: mut frame, coordinate_sets }) =
            look(&document, &Buffers::of_views(&document, views), &folder, limits, false)
        else {
            return Ok(None);
        };
        let (mut parts, mut skipped, mut is_plain) = (Vec::new(), 0, true);
        let found = visit(&document, limits, &mut Movers::default(), &mut |worn, place| {
            let primitive = worn.primitive;
            if !has_triangles(primitive) {
                skipped += 1;
            } else {
                let part = Part::of(primitive, place.world, &document, &binary, &frame, &coordinate_sets);
                is_plain &= part.is_some() && !morphs::are_seen(primitive, worn.weights);
                parts.extend(part);
            }
            Ok(())
        });
        let (Ok(Found { cameras, skinned }), true) = (found, is_plain) else { return Ok(None) };
        if !skinned.is_empty() {
            return Ok(None);
        }
        let room = budget / 2;
        let open = |room: u64| ByteCache::open(&arrays, room);
        let caches = [open(1 << 18)?, open(room / 2)?, open(room / 4)?, open(room / 4)?];
        let mut source = Self {
            has_colors: parts.iter().any(|part| part.colors.is_some()),
            has_uvs: parts.iter().any(|part| part.uvs.is_some()),
            parts,
            local_origin: LocalOrigin::default(),
            frame: Mesh::new(""),
            caches,
            bytes,
        };
        // Instances are not to become more than the file has bytes, or than a mesh in memory may have.
        if source.count() == 0 || source.count() > bytes.max(limits.points) {
            return Ok(None);
        }
        source.set_local_origin()?;
        if !source.local_origin.is_set() {
            return Ok(None);
        }
        frame.offset = source.local_origin.offset();
        frame.cameras.extend(cameras_at(&cameras, frame.offset).map(|(camera, _)| camera));
        frame.notes.extend(note_of_skipped(skipped));
        source.frame = frame;
        Ok(Some(source))
    }

    /// The file that holds the arrays.
    pub fn arrays(&self) -> &Path {
        self.caches[0].path()
    }

    /// Bytes that the file and the mesh would take in memory.
    pub fn size_bytes(&self) -> u64 {
        let vertex = 12 + if self.has_colors { 16 } else { 0 } + if self.has_uvs { 8 } else { 0 };
        let vertices: u64 = self.parts.iter().map(|part| part.positions.count).sum();
        self.bytes + vertices * vertex + self.count() * 14
    }

    /// The first vertex of all decides where the local_origin is.
    fn set_local_origin(&mut self) -> Result<(), ImportError> {
        if let Some(part) = self.parts.iter().find(|part| part.positions.count > 0) {
            let point = part.positions.vector(0, 0.0, &mut self.caches[1])?;
            self.local_origin.localized(placed(&part.world, point));
        }
        Ok(())
    }
}

impl Part {
    /// `None` where it has to be read another way.
    fn of(
        primitive: &Primitive,
        world: DAffine3,
        document: &Document,
        binary: &Range<u64>,
        look: &Mesh,
        coordinate_sets: &[u32],
    ) -> Option<Self> {
        let array = |index: usize, kinds: &[&str]| Array::of(document, index, kinds, binary);
        let is_compressed = primitive.extensions.draco.is_some()
            || primitive.extensions.others.keys().any(|name| name.contains("compression"));
        let material = primitive.material.map_or(0, |material| material + 1);
        if is_compressed || material >= look.materials.len() {
            return None;
        }
        let positions = array(*primitive.attributes.get("POSITION")?, &["VEC3"])?;
        let indices = match primitive.indices {
            Some(index) => Some(array(index, &["SCALAR"]).filter(Array::holds_indices)?),
            None => None,
        };
        let vertices =
            |index: usize, kinds: &[&str]| array(index, kinds).filter(|array| array.count == positions.count);
        let colors = match primitive.attributes.get("COLOR_0") {
            Some(&index) => Some(vertices(index, &["VEC3", "VEC4"])?),
            None => None,
        };
        let uvs = match coordinates(primitive, material, look, coordinate_sets) {
            Some((_, index)) => Some(vertices(index, &["VEC2"])?),
            None => None,
        };
        Some(Self { world, mode: primitive.mode, material: material as u16, indices, positions, colors, uvs })
    }

    /// Appends a vertex to a mesh; what this part has not and others have is white, and the corner of the picture.
    fn push(
        &self,
        vertex: u64,
        [_, positions, colors, uvs]: &mut [ByteCache; 4],
        local_origin: &mut LocalOrigin,
        [has_colors, has_uvs]: [bool; 2],
        piece: &mut Mesh,
    ) -> Result<(), ImportError> {
        let count = self.positions.count;
        if vertex >= count {
            let what = format!("a triangle names vertex {vertex} of {count}");
            return Err(ImportError::malformed(positions.path(), self.indices.map_or(0, |array| array.start), what));
        }
        let position = local_origin.localized(placed(&self.world, self.positions.vector(vertex, 0.0, positions)?));
        if !position.is_finite() {
            let at = self.positions.start + vertex * self.positions.stride;
            return Err(ImportError::malformed(positions.path(), at, "a vertex that is not finite"));
        }
        piece.positions.push(position);
        if has_colors {
            let color = self.colors.map_or(Ok([1.0; 4]), |array| array.vector(vertex, 1.0, colors))?;
            piece.colors.push(Vec4::from_array(color).clamp(Vec4::ZERO, Vec4::ONE));
        }
        if has_uvs {
            let [u, v, ..] = self.uvs.map_or(Ok([0.0; 4]), |array| array.vector(vertex, 0.0, uvs))?;
            piece.uvs.push(Vec2::new(u, v));
        }
        Ok(())
    }

    fn triangles(&self) -> u64 {
        triangle_count(self.mode, self.indices.map_or(self.positions.count, |indices| indices.count))
    }
}

impl TriangleSource for GltfTriangles {
    fn frame(&mut self) -> &mut Mesh {
        &mut self.frame
    }

    fn count(&self) -> u64 {
        self.parts.iter().map(Part::triangles).sum()
    }

    fn colors(&self) -> SourceColors {
        if self.has_colors { SourceColors::Linear } else { SourceColors::None }
    }

    fn has_uvs(&self) -> bool {
        self.has_uvs
    }

    fn materials(&self) -> Option<Vec<bool>> {
        let mut used = vec![false; self.frame.materials.len()];
        let parts = self.parts.iter().filter(|part| part.triangles() > 0);
        parts.for_each(|part| used[usize::from(part.material)] = true);
        Some(used)
    }

    fn release(&mut self) {
        self.caches.iter_mut().for_each(ByteCache::release);
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let mut piece = Mesh { offset: self.frame.offset, ..Mesh::new("") };
        piece.materials.clone_from(&self.frame.materials);
        let (has_colors, has_uvs) = (self.has_colors, self.has_uvs);
        for part in &self.parts {
            let is_mirrored = part.world.matrix3.determinant() < 0.0;
            for at in 0..part.triangles() {
                let [a, b, c] = triangle_at(part.mode, at);
                for place in if is_mirrored { [a, c, b] } else { [a, b, c] } {
                    let vertex = match part.indices {
                        Some(indices) => indices.index(place, &mut self.caches[0])?,
                        None => place,
                    };
                    part.push(vertex, &mut self.caches, &mut self.local_origin, [has_colors, has_uvs], &mut piece)?;
                }
                piece.material_of.push(part.material);
                if piece.positions.len() >= PIECE {
                    if !each(&piece) {
                        return Ok(());
                    }
                    piece.clear();
                }
            }
        }
        if !piece.positions.is_empty() {
            each(&piece);
        }
        Ok(())
    }
}
