//! The faces of a PLY file: polygons, or strips of triangles with −1 between two strips.

use super::header::Element;
use super::values::Values;
use crate::import::{ImportError, Limits};
use crate::mesh::{Mesh, polygon::triangulate};

pub(super) fn read(
    values: &mut Values,
    element: &Element,
    limits: &Limits,
    mesh: &mut Mesh,
) -> Result<(), ImportError> {
    let Some(column) = element.find(&["vertex_indices", "vertex_index"]) else {
        return super::skip(values, element);
    };
    let is_strips = element.name == "tristrips";
    if !is_strips && values.has_length() {
        mesh.triangles.reserve(element.count as usize);
    }
    let (mut corners, mut cut) = (Vec::new(), Vec::new());
    for _ in 0..element.count {
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
        values.end_of_item()?;
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
    for strip in corners.split(|&corner| corner == u32::MAX) {
        for (at, triangle) in strip.windows(3).enumerate() {
            let (a, b, c) = (triangle[0], triangle[1], triangle[2]);
            mesh.triangles.push(if at % 2 == 0 { [a, b, c] } else { [b, a, c] });
        }
    }
}
