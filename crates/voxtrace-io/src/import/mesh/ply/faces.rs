//! The faces of a PLY file: polygons, or strips of triangles with −1 between two strips; and how faces look, where vertices do not say it.

use super::header::{Element, Header, Kind};
use super::values::Values;
use super::vertices;
use glam::{Vec2, Vec3};
use voxtrace_scene::material::linear_color;
use voxtrace_voxelize::mesh::{Mesh, polygon::triangulate};
use voxtrace_voxelize::{ImportError, Limits};

/// Name of the element that holds strips.
pub(super) const STRIPS: &str = "tristrips";

/// What is taken of faces beside their corners.
#[derive(Clone, Copy)]
pub(super) struct Wanted {
    uvs: bool,
    colors: bool,
    textures: bool,
}

impl Wanted {
    /// What vertices do not say.
    pub fn of(header: &Header) -> Self {
        let vertices = header.elements.iter().filter(|element| element.name == "vertex");
        let columns: Vec<vertices::Columns> = vertices.filter_map(vertices::Columns::of).collect();
        Self {
            uvs: !header.textures.is_empty() && columns.iter().all(|columns| columns.uv.is_none()),
            colors: columns.iter().all(|columns| columns.color.is_none()),
            textures: header.textures.len() > 1,
        }
    }
}

/// Which columns of faces hold what.
#[derive(Clone, Copy)]
pub(super) struct Columns {
    corners: usize,
    pub uvs: Option<usize>,
    pub color: Option<[usize; 3]>,
    pub texture: Option<usize>,
}

impl Columns {
    /// None where an element has no corners.
    pub fn of(element: &Element, wanted: Wanted) -> Option<Self> {
        let corners = column_of(element)?;
        let plain = Self { corners, uvs: None, color: None, texture: None };
        if element.name == STRIPS {
            return Some(plain);
        }
        let find = |name: &str, is_list: bool| {
            element.find(&[name]).filter(|&at| element.properties[at].list.is_some() == is_list)
        };
        let color = vertices::color_of(element).filter(|&color| are_whole(element, color));
        Some(Self {
            uvs: find("texcoord", true).filter(|_| wanted.uvs),
            color: color.filter(|_| wanted.colors),
            texture: find("texnumber", false).filter(|_| wanted.textures),
            ..plain
        })
    }
}

/// Whether colours are whole numbers.
fn are_whole(element: &Element, color: [usize; 3]) -> bool {
    !color.iter().any(|&at| matches!(element.properties[at].kind, Kind::F32 | Kind::F64))
}

/// What is said of colours that are left out: of floating-point numbers only all of them would tell what full intensity is.
pub(super) fn unread_colors<'e>(mut elements: impl Iterator<Item = &'e Element>, wanted: Wanted) -> Option<String> {
    let is_unread = |element: &Element| {
        element.name == "face" && vertices::color_of(element).is_some_and(|color| !are_whole(element, color))
    };
    (wanted.colors && elements.any(is_unread))
        .then(|| "colours of faces are left out: they are no whole numbers, as those of vertices may be".into())
}

/// The property that holds the corners of faces.
pub(super) fn column_of(element: &Element) -> Option<usize> {
    element.find(&["vertex_indices", "vertex_index"])
}

/// One item.
#[derive(Default)]
pub(super) struct Face {
    /// `u32::MAX` stands between two strips.
    pub corners: Vec<u32>,
    /// Texture coordinates, two for each corner.
    uvs: Vec<f32>,
    /// As shares.
    color: Vec3,
    texture: f64,
}

impl Face {
    /// Takes the next item.
    pub fn take(&mut self, values: &mut Values, element: &Element, columns: Columns) -> Result<(), ImportError> {
        let is_strips = element.name == STRIPS;
        self.uvs.clear();
        for (at, property) in element.properties.iter().enumerate() {
            let count = match property.list {
                Some(kind) => values.count(kind)?,
                None => 1,
            };
            if at != columns.corners {
                for _ in 0..count {
                    let number = values.number(property.kind)?;
                    if columns.uvs == Some(at) {
                        self.uvs.push(number as f32);
                    } else if columns.texture == Some(at) {
                        self.texture = number;
                    } else if let Some(channel) = columns.color.and_then(|all| all.iter().position(|&own| own == at)) {
                        self.color[channel] = (number / property.kind.full()) as f32;
                    }
                }
                continue;
            }
            self.corners.clear();
            for _ in 0..count {
                let corner = values.number(property.kind)?;
                let is_break = is_strips && corner == -1.0;
                if !is_break && (!(0.0..4_294_967_295.0).contains(&corner) || corner.fract() != 0.0) {
                    return Err(values.malformed(format!("a face with the corner {corner}")));
                }
                self.corners.push(if is_break { u32::MAX } else { corner as u32 });
            }
        }
        values.end_of_item()
    }

    /// The texture coordinates of a corner.
    pub fn uv(&self, corner: usize) -> Vec2 {
        let uv = self.uvs.get(2 * corner..2 * corner + 2);
        // The format counts v from the bottom.
        uv.map_or(Vec2::ZERO, |uv| Vec2::new(uv[0], 1.0 - uv[1]))
    }

    /// Linear.
    pub fn color(&self) -> Vec3 {
        linear_color(self.color.to_array().map(|share| (share.clamp(0.0, 1.0) * 255.0).round() as u8))
    }
}

/// How triangles look that do not say it by their vertices; empty where no face says it.
#[derive(Default)]
pub(super) struct Looks {
    uvs: Vec<[Vec2; 3]>,
    colors: Vec<Vec3>,
}

impl Looks {
    pub fn has_uvs(&self) -> bool {
        !self.uvs.is_empty()
    }

    /// Makes room for those of some triangles, which are white where nothing says it.
    fn resize(&mut self, columns: Columns, count: usize, mesh: &mut Mesh) {
        if columns.uvs.is_some() || !self.uvs.is_empty() {
            self.uvs.resize(count, [Vec2::ZERO; 3]);
        }
        if columns.color.is_some() || !self.colors.is_empty() {
            self.colors.resize(count, Vec3::ONE);
        }
        if columns.texture.is_some() || !mesh.material_of.is_empty() {
            mesh.material_of.resize(count, 0);
        }
    }

    /// Gives each triangle corners of its own, which look as it does.
    pub fn spread(self, mesh: &mut Mesh) {
        if self.uvs.is_empty() && self.colors.is_empty() {
            return;
        }
        fn spread<T: Copy>(of_vertices: &mut Vec<T>, corners: &[u32]) {
            if !of_vertices.is_empty() {
                *of_vertices = corners.iter().map(|&corner| of_vertices[corner as usize]).collect();
            }
        }
        let triangles = std::mem::take(&mut mesh.triangles);
        let corners = triangles.as_flattened();
        spread(&mut mesh.positions, corners);
        spread(&mut mesh.colors, corners);
        spread(&mut mesh.uvs, corners);
        if !self.uvs.is_empty() {
            mesh.uvs = self.uvs.into_flattened();
        }
        if !self.colors.is_empty() {
            mesh.colors = self.colors.into_iter().flat_map(|color| [color.extend(1.0); 3]).collect();
        }
    }
}

pub(super) fn read(
    values: &mut Values,
    element: &Element,
    wanted: Wanted,
    limits: &Limits,
    mesh: &mut Mesh,
    looks: &mut Looks,
) -> Result<(), ImportError> {
    let Some(columns) = Columns::of(element, wanted) else {
        return super::skip(values, element);
    };
    let is_strips = element.name == STRIPS;
    if !is_strips && values.has_length() {
        mesh.triangles.reserve(element.count as usize);
    }
    looks.resize(columns, mesh.triangles.len(), mesh);
    let (mut face, mut cut) = (Face::default(), Vec::new());
    for _ in 0..element.count {
        face.take(values, element, columns)?;
        if is_strips {
            mesh.triangles.extend(triangles_of_strips(&face.corners));
        } else {
            push_polygon(values, &face.corners, &mut cut, mesh)?;
            if columns.uvs.is_some() {
                looks.uvs.extend(cut.iter().map(|triangle| triangle.map(|corner| face.uv(corner))));
            }
            if columns.color.is_some() {
                looks.colors.resize(mesh.triangles.len(), face.color());
            }
            if columns.texture.is_some() {
                // A number that is none, and one that no texture has, stand for the first.
                mesh.material_of.resize(mesh.triangles.len(), face.texture as u16);
            }
        }
        if mesh.triangles.len() as u64 > limits.points {
            return Err(values.limit("triangles", mesh.triangles.len() as u64, limits.points));
        }
    }
    looks.resize(columns, mesh.triangles.len(), mesh);
    Ok(())
}

/// Pushes the triangles of a polygon; `cut` are their corners among its own.
fn push_polygon(
    values: &Values,
    corners: &[u32],
    cut: &mut Vec<[usize; 3]>,
    mesh: &mut Mesh,
) -> Result<(), ImportError> {
    cut.clear();
    if let [a, b, c] = *corners {
        cut.push([0, 1, 2]);
        mesh.triangles.push([a, b, c]);
        return Ok(());
    }
    let position = |&corner: &u32| mesh.positions.get(corner as usize).copied();
    let points: Option<Vec<_>> = corners.iter().map(position).collect();
    let points = points.ok_or_else(|| values.malformed("a face with a corner that is missing"))?;
    triangulate(&points, cut);
    mesh.triangles.extend(cut.iter().map(|triangle| triangle.map(|corner| corners[corner])));
    Ok(())
}

/// The triangles of strips, every second one turned.
pub(super) fn triangles_of_strips(corners: &[u32]) -> impl Iterator<Item = [u32; 3]> + '_ {
    corners.split(|&corner| corner == u32::MAX).flat_map(|strip| {
        strip.windows(3).enumerate().map(|(at, triangle)| {
            let (a, b, c) = (triangle[0], triangle[1], triangle[2]);
            if at % 2 == 0 { [a, b, c] } else { [b, a, c] }
        })
    })
}
