//! Binary PLY meshes larger than memory: faces are read one after the other, their corners through a cache of vertices.

use super::faces::{Columns as FaceColumns, Face, STRIPS, Wanted, column_of, triangles_of_strips, unread_colors};
use super::header::{Element, Encoding, Header};
use super::values::Values;
use super::vertex_cache::VertexCache;
use super::vertices::{Columns, FullIntensity};
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use glam::{Vec2, Vec4};
use std::path::{Path, PathBuf};
use voxtrace_voxelize::mesh::source::{SourceColors, TriangleSource};
use voxtrace_voxelize::mesh::{Mesh, polygon::triangulate};
use voxtrace_voxelize::{ImportError, Limits};

/// Corners that are handed on at once, about.
const PIECE: usize = 3 << 15;

/// The triangles of a binary PLY file.
pub(crate) struct PlyTriangles {
    path: PathBuf,
    encoding: Encoding,
    /// Elements behind the vertices, and where they begin.
    elements: Vec<Element>,
    start: u64,
    vertices: VertexCache,
    vertex_count: u64,
    colors: SourceColors,
    /// Whether faces say how they look, so that in memory each triangle has corners of its own.
    has_own_corners: bool,
    /// What is taken of faces.
    wanted: Wanted,
    frame: Mesh,
}

/// What is read here of a file: nothing but sizes is checked, since the file itself is the bound of what it can ask for.
pub(super) fn unbounded() -> Limits {
    Limits { bytes: u64::MAX, points: u64::MAX, ..Limits::default() }
}

impl PlyTriangles {
    /// Opens a file, if it is one whose triangles can be read so: binary, vertices without lists and before the faces.
    pub fn open(path: &Path, budget: u64, limits: &Limits) -> Result<Option<Self>, ImportError> {
        let mut input = Input::open(path, &unbounded())?;
        if input.remaining().is_none() {
            return Ok(None);
        }
        let header = Header::read(&mut input, &unbounded())?;
        let (start, wanted) = (input.offset(), Wanted::of(&header));
        if header.textures.len() > 1 {
            return Ok(None);
        }
        let mut elements = header.elements.into_iter();
        let vertices = elements.next().filter(|element| element.name == "vertex");
        let elements: Vec<Element> = elements.collect();
        let is_vertex = |element: &Element| element.name == "vertex";
        let has_faces = elements.iter().any(|element| is_faces(element) && element.count > 0);
        let (Some(vertices), false, true) = (vertices, elements.iter().any(is_vertex), has_faces) else {
            return Ok(None);
        };
        let has_lists = vertices.properties.iter().any(|property| property.list.is_some());
        let Some(columns) = Columns::of(&vertices).filter(|_| !has_lists) else { return Ok(None) };
        if header.encoding == Encoding::Text || vertices.count > u64::from(u32::MAX) {
            return Ok(None);
        }
        let mut values = Values::new(input, header.encoding);
        values.check_count(&vertices)?;
        let full = FullIntensity::of_element(&mut values, &vertices)?;
        let size = vertices.properties.iter().map(|property| property.kind.size() as u64).sum::<u64>();
        let start_of_faces = start + vertices.count * size;
        let values = Values::new(Input::open_at(path, start_of_faces, &unbounded())?, header.encoding);
        elements.iter().try_for_each(|element| values.check_count(element))?;
        let of_faces: Vec<_> = elements
            .iter()
            .filter(|element| is_faces(element))
            .filter_map(|element| FaceColumns::of(element, wanted))
            .collect();
        let colors = match (columns.color, columns.alpha) {
            (None, _) if of_faces.iter().any(|columns| columns.color.is_some()) => SourceColors::Bytes,
            (None, _) => SourceColors::None,
            (Some(_), None) => SourceColors::Bytes,
            (Some(_), Some(_)) => SourceColors::Linear,
        };
        let mut frame = Mesh::new("");
        frame.notes.extend(super::not_shown(elements.iter().chain([&vertices])));
        frame.notes.extend(unread_colors(elements.iter(), wanted));
        let has_own_corners = of_faces.iter().any(|columns| columns.color.is_some() || columns.uvs.is_some());
        let has_uvs = columns.uv.is_some() || of_faces.iter().any(|columns| columns.uvs.is_some());
        super::set_look(&mut frame, &header.textures, has_uvs, &Folder::of(path, limits), limits);
        if colors != SourceColors::None {
            frame.materials[0].base_color = Vec4::ONE;
        }
        let has_uvs = !frame.textures.is_empty();
        let vertex_count = vertices.count;
        let of_vertices = has_uvs && columns.uv.is_some();
        let vertices = VertexCache::open(path, (vertices, full), header.encoding, start, of_vertices, budget / 2)?;
        frame.offset = vertices.offset();
        Ok(Some(Self {
            path: path.into(),
            encoding: header.encoding,
            elements,
            start: start_of_faces,
            vertices,
            vertex_count,
            colors,
            has_own_corners,
            wanted,
            frame,
        }))
    }

    /// Bytes that the mesh would take in memory.
    pub fn size_bytes(&self) -> u64 {
        let vertex = 12 + if self.colors == SourceColors::None { 0 } else { 16 } + if self.has_uvs() { 8 } else { 0 };
        let vertices = if self.has_own_corners { 3 * self.count() } else { self.vertex_count };
        vertices * vertex + self.count() * 12
    }
}

fn is_faces(element: &Element) -> bool {
    matches!(element.name.as_str(), "face" | STRIPS) && column_of(element).is_some()
}

impl TriangleSource for PlyTriangles {
    fn frame(&mut self) -> &mut Mesh {
        &mut self.frame
    }

    fn count(&self) -> u64 {
        self.elements.iter().filter(|element| is_faces(element)).map(|element| element.count).sum()
    }

    fn colors(&self) -> SourceColors {
        self.colors
    }

    fn has_uvs(&self) -> bool {
        !self.frame.textures.is_empty()
    }

    fn release(&mut self) {
        self.vertices.release();
    }

    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError> {
        let path = self.path.clone();
        let mut values = Values::new(Input::open_at(&path, self.start, &unbounded())?, self.encoding);
        let mut piece = Mesh { offset: self.frame.offset, ..Mesh::new("") };
        piece.materials.clone_from(&self.frame.materials);
        let (mut face, mut points, mut cut) = (Face::default(), Vec::new(), Vec::new());
        let (has_uvs, has_colors) = (self.has_uvs(), self.colors != SourceColors::None);
        for element in &self.elements {
            let Some(columns) = FaceColumns::of(element, self.wanted).filter(|_| is_faces(element)) else {
                super::skip(&mut values, element)?;
                continue;
            };
            for _ in 0..element.count {
                face.take(&mut values, element, columns)?;
                let corners = &face.corners;
                let is_strips = element.name == STRIPS;
                let beyond =
                    |&&corner: &&u32| u64::from(corner) >= self.vertex_count && !(is_strips && corner == u32::MAX);
                if let Some(at) = corners.iter().find(beyond) {
                    let what = format!("a face has corner {at}, but there are {} vertices", self.vertex_count);
                    return Err(values.malformed(what));
                }
                if is_strips {
                    for corner in triangles_of_strips(corners).flatten() {
                        self.vertices.push(&path, corner, &mut piece)?;
                    }
                } else {
                    cut.clear();
                    if corners.len() == 3 {
                        cut.push([0, 1, 2]);
                    } else {
                        points.clear();
                        for &corner in corners {
                            points.push(self.vertices.position(&path, corner)?);
                        }
                        triangulate(&points, &mut cut);
                    }
                    for &corner in cut.iter().flatten() {
                        self.vertices.push(&path, corners[corner], &mut piece)?;
                        if has_uvs && columns.uvs.is_some() {
                            piece.uvs.push(face.uv(corner));
                        }
                    }
                    if columns.color.is_some() {
                        piece.colors.resize(piece.positions.len(), face.color().extend(1.0));
                    }
                }
                // Faces of another element may say how they look, and these do not.
                if has_uvs {
                    piece.uvs.resize(piece.positions.len(), Vec2::ZERO);
                }
                if has_colors {
                    piece.colors.resize(piece.positions.len(), Vec4::ONE);
                }
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
