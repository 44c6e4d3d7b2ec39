//! The vertices of a PLY file: positions, colours (sRGB) and texture coordinates.

use super::header::{Element, Kind};
use super::values::{Values, number_of};
use crate::import::reader::local_origin::LocalOrigin;
use glam::{DVec3, Vec2, Vec4};
use voxtrace_scene::material::linear_from_srgb;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::mesh::Mesh;

/// Vertices taken at once.
const CHUNK: usize = 1024;

/// Which columns hold what.
pub(super) struct Columns {
    position: [usize; 3],
    pub color: Option<[usize; 3]>,
    pub alpha: Option<usize>,
    pub uv: Option<[usize; 2]>,
}

/// What stands for full intensity in a file's colours and in its opacities: 1 once whole numbers are shares, but 255 where floating-point
/// numbers are written as bytes would be, as some programs do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FullIntensity {
    color: f32,
    alpha: f32,
}

impl FullIntensity {
    /// By the largest value of each.
    fn of(colors: impl Iterator<Item = Vec4>) -> Self {
        // Vec4::max would forget all others at a value that is no number.
        let [red, green, blue, alpha] = colors.fold([0.0f32; 4], |largest, color| {
            let color = color.to_array();
            std::array::from_fn(|at| largest[at].max(color[at]))
        });
        // Colours that are brighter than white are shares yet, and a stray value is none of a byte.
        let full = |largest: f32| if (16.0..256.0).contains(&largest) { 255.0 } else { 1.0 };
        Self { color: full(red.max(green).max(blue)), alpha: full(alpha) }
    }

    /// That of an element's vertices, which are only read where their types leave it open.
    pub fn of_element(values: &mut Values, element: &Element) -> Result<Self, ImportError> {
        let full = Self { color: 1.0, alpha: 1.0 };
        let Some(columns) = Columns::of(element) else { return Ok(full) };
        let Some(color) = columns.color else { return Ok(full) };
        let is_float = |&column: &usize| matches!(element.properties[column].kind, Kind::F32 | Kind::F64);
        if !color.iter().chain(&columns.alpha).any(is_float) {
            return Ok(full);
        }
        let mut largest = [0.0f32; 4];
        for_each_row(values, element, &mut |row, _| {
            let own = columns.signals(row, element, color).to_array();
            largest = std::array::from_fn(|at| largest[at].max(own[at]));
            Ok(())
        })?;
        Ok(Self::of(std::iter::once(Vec4::from_array(largest))))
    }

    /// Makes linear colours of what [`append`] appended.
    pub fn make_linear(self, colors: &mut [Vec4]) {
        let linear: Vec<f32> = (0..=255).map(linear_from_srgb).collect();
        for color in colors {
            let srgb = color.truncate().to_array().map(|signal| (signal / self.color).clamp(0.0, 1.0));
            let [red, green, blue] = srgb.map(|signal| linear[(signal * 255.0).round() as usize]);
            *color = Vec4::new(red, green, blue, (color.w / self.alpha).clamp(0.0, 1.0));
        }
    }
}

pub(super) fn read(values: &mut Values, element: &Element, mesh: &mut Mesh) -> Result<(), ImportError> {
    let mut local_origin = LocalOrigin::default();
    let first = mesh.colors.len();
    append(values, element, &mut local_origin, mesh)?;
    let colors = &mut mesh.colors[first..];
    FullIntensity::of(colors.iter().copied()).make_linear(colors);
    mesh.offset = local_origin.offset();
    Ok(())
}

/// Appends the vertices of an element, relative to an local_origin. Their colours are signals as in the file, those of whole numbers as
/// shares: [`FullIntensity`] makes them linear.
pub(super) fn append(
    values: &mut Values,
    element: &Element,
    local_origin: &mut LocalOrigin,
    mesh: &mut Mesh,
) -> Result<(), ImportError> {
    let columns = Columns::of(element).ok_or_else(|| values.malformed("vertices without x, y and z"))?;
    let count = element.count as usize;
    // The count has been held against the length of the file, where that is known.
    let room = if values.has_length() { count } else { CHUNK };
    mesh.positions.reserve_exact(room);
    mesh.colors.reserve_exact(if columns.color.is_some() { room } else { 0 });
    mesh.uvs.reserve_exact(if columns.uv.is_some() { room } else { 0 });

    for_each_row(values, element, &mut |row, fault| {
        let position = local_origin.localized(DVec3::from_array(columns.position.map(|column| row[column])));
        if !position.is_finite() {
            return Err(fault("a vertex that is not finite"));
        }
        mesh.positions.push(position);
        if let Some(color) = columns.color {
            mesh.colors.push(columns.signals(row, element, color));
        }
        if let Some([u, v]) = columns.uv {
            mesh.uvs.push(Vec2::new(row[u] as f32, 1.0 - row[v] as f32));
        }
        Ok(())
    })
}

/// What is done with the numbers of a vertex; a function makes errors at its place.
type TakeRow<'r> = &'r mut dyn FnMut(&[f64], &dyn Fn(&str) -> ImportError) -> Result<(), ImportError>;

/// Hands on the numbers of one vertex after the other; of a list its last one.
pub(super) fn for_each_row(values: &mut Values, element: &Element, each: TakeRow) -> Result<(), ImportError> {
    // Without lists every vertex has the same size, and a chunk of them is taken at once.
    let has_lists = element.properties.iter().any(|property| property.list.is_some());
    let mut starts = Vec::new();
    let mut size = 0;
    for property in &element.properties {
        starts.push(size);
        size += property.kind.size();
    }
    let kinds: Vec<Kind> = element.properties.iter().map(|property| property.kind).collect();
    let encoding = values.encoding();
    let mut row = vec![0.0; element.properties.len()];
    let mut left = element.count as usize;
    while left > 0 {
        let now = if has_lists { 1 } else { left.min(CHUNK) };
        let offset = values.offset();
        let mut records = Vec::new();
        if !has_lists && let Some(bytes) = values.records(size, now)? {
            records.extend_from_slice(bytes);
        }
        for index in 0..now {
            if records.is_empty() {
                for (value, property) in row.iter_mut().zip(&element.properties) {
                    let numbers = match property.list {
                        Some(kind) => values.count(kind)?,
                        None => 1,
                    };
                    for _ in 0..numbers {
                        *value = values.number(property.kind)?;
                    }
                }
                values.end_of_item()?;
            } else {
                let record = &records[index * size..];
                for ((value, &start), &kind) in row.iter_mut().zip(&starts).zip(&kinds) {
                    *value = number_of(&record[start..], kind, encoding);
                }
            }
            let is_text = records.is_empty();
            each(&row, &|what| {
                let fault = values.malformed(what);
                if is_text { fault } else { fault.with_offset(Some(offset)) }
            })?;
        }
        left -= now;
    }
    Ok(())
}

/// The column of single numbers with one of these names.
fn single(element: &Element, names: &[&str]) -> Option<usize> {
    element.find(names).filter(|&at| element.properties[at].list.is_none())
}

/// The columns of red, green and blue.
pub(super) fn color_of(element: &Element) -> Option<[usize; 3]> {
    let red = single(element, &["red", "diffuse_red", "r"])?;
    let green = single(element, &["green", "diffuse_green", "g"])?;
    Some([red, green, single(element, &["blue", "diffuse_blue", "b"])?])
}

impl Columns {
    pub fn of(element: &Element) -> Option<Self> {
        let find = |names: &[&str]| single(element, names);
        let position = [find(&["x"])?, find(&["y"])?, find(&["z"])?];
        let uv = find(&["s", "u", "texture_u"]).zip(find(&["t", "v", "texture_v"]));
        Some(Self {
            position,
            color: color_of(element),
            alpha: find(&["alpha", "diffuse_alpha"]),
            uv: uv.map(|(u, v)| [u, v]),
        })
    }

    /// Colour and opacity of a vertex, of whole numbers as shares.
    fn signals(&self, row: &[f64], element: &Element, color: [usize; 3]) -> Vec4 {
        let share = |column: usize| (row[column] / element.properties[column].kind.full()) as f32;
        let [red, green, blue] = color.map(share);
        Vec4::new(red, green, blue, self.alpha.map_or(1.0, share))
    }
}
