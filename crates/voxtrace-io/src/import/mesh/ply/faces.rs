//! The faces of a PLY file: polygons, or strips of triangles with −1 between two strips.

use super::header::Element;
use super::values::Values;
use voxtrace_voxelize::mesh::{Mesh, polygon::triangulate};
use voxtrace_voxelize::{ImportError, Limits};

/// Name of the element that holds strips.
pub(super) const STRIPS: &str = "tristrips";

pub(super) fn read(
    values: &mut Values,
    element: &Element,
    limits: &Limits,
    mesh: &mut Mesh,
) -> Result<(), ImportError> {
    let Some(column) = column_of(element) else {
        return super::skip(values, element);
    };
    let is_strips = element.name == STRIPS;
    if !is_strips && values.has_length() {
        mesh.triangles.reserve(element.count as usize);
    }
    let (mut corners, mut cut) = (Vec::new(), Vec::new());
    for _ in 0..element.count {
        take_corners(values, element, column, &mut corners)?;
        if is_strips {
            push_strips(&corners, mesh);
        } else {
            push_polygon(values, &corners, &mut cut, mesh)?;
        }
        if mesh.triangles.len() as u64 > limits.points {
            return Err(values.limit("triangles", mesh.triangles.len() as u64, limits.points));
        }
    }
    Ok(())
}

/// The property that holds the corners of faces.
pub(super) fn column_of(element: &Element) -> Option<usize> {
    element.find(&["vertex_indices", "vertex_index"])
}

/// Takes an item, and of it the corners; `u32::MAX` stands between two strips.
pub(super) fn take_corners(
    values: &mut Values,
    element: &Element,
    column: usize,
    corners: &mut Vec<u32>,
) -> Result<(), ImportError> {
    let is_strips = element.name == STRIPS;
    for (at, property) in element.properties.iter().enumerate() {
        let count = match property.list {
            Some(kind) => values.count(kind)?,
            None => 1,
        };
        if at != column {
            for _ in 0..count {
                values.number(property.kind)?;
            }
            continue;
        }
        corners.clear();
        for _ in 0..count {
            let corner = values.number(property.kind)?;
            let is_break = is_strips && corner == -1.0;
            if !is_break && (!(0.0..4_294_967_295.0).contains(&corner) || corner.fract() != 0.0) {
                return Err(values.malformed(format!("a face with the corner {corner}")));
            }
            corners.push(if is_break { u32::MAX } else { corner as u32 });
        }
    }
    values.end_of_item()
}

fn push_polygon(
    values: &Values,
    corners: &[u32],
    cut: &mut Vec<[usize; 3]>,
    mesh: &mut Mesh,
) -> Result<(), ImportError> {
    if let [a, b, c] = *corners {
        mesh.triangles.push([a, b, c]);
        return Ok(());
    }
    let position = |&corner: &u32| mesh.positions.get(corner as usize).copied();
    let points: Option<Vec<_>> = corners.iter().map(position).collect();
    let points = points.ok_or_else(|| values.malformed("a face with a corner that is missing"))?;
    cut.clear();
    triangulate(&points, cut);
    mesh.triangles.extend(cut.iter().map(|triangle| triangle.map(|corner| corners[corner])));
    Ok(())
}

fn push_strips(corners: &[u32], mesh: &mut Mesh) {
    mesh.triangles.extend(triangles_of_strips(corners));
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
