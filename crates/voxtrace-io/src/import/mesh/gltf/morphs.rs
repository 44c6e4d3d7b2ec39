//! Morph targets: what is added to the positions of vertices, each by a weight, before joints place them (glTF 2.0, section 3.7.2.2). Colours and
//! texture coordinates of targets are left out.

use super::Fault;
use super::document::{GltfMesh, Node, Primitive};
use super::primitives::{Source, check_count};
use glam::{DVec3, Vec3};
use std::collections::BTreeMap;

/// The weights that a mesh has at a node, without an animation.
pub(super) fn weights<'a>(node: &'a Node, mesh: &'a GltfMesh) -> &'a [f32] {
    node.weights.as_deref().unwrap_or(&mesh.weights)
}

/// Whether some target with a weight moves vertices.
pub(super) fn are_seen(primitive: &Primitive, weights: &[f32]) -> bool {
    seen(primitive, weights).next().is_some()
}

/// The weights that are not 0, and the accessors of their targets.
fn seen(primitive: &Primitive, weights: &[f32]) -> impl Iterator<Item = (f64, usize)> {
    let targets = primitive.targets.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
    targets.filter_map(|(target, &weight)| Some((weight.into(), *target.get("POSITION")?)))
}

/// What the targets of a primitive of so many vertices add to them; empty where they add nothing.
pub(super) fn offsets(
    primitive: &Primitive,
    weights: &[f32],
    count: usize,
    source: &Source,
) -> Result<Vec<DVec3>, Fault> {
    let mut sums: Vec<DVec3> = Vec::new();
    for (number, (weight, accessor)) in seen(primitive, weights).enumerate() {
        check_count(source.accessors.of_kinds(accessor, &["VEC3"])?.count, count)?;
        check_limit(number + 1, count, source)?;
        sums.resize(count, DVec3::ZERO);
        let mut vertex = 0;
        source.accessors.vectors(accessor, &["VEC3"], 0.0, |[x, y, z, _]| {
            sums[vertex] += weight * DVec3::new(x.into(), y.into(), z.into());
            vertex += 1;
        })?;
    }
    Ok(sums)
}

/// Whether so many targets of so many vertices may be read: a small file may name one array many times.
fn check_limit(targets: usize, vertices: usize, source: &Source) -> Result<(), Fault> {
    let (all, limit) = ((targets as u64).saturating_mul(vertices as u64), source.accessors.limits.points);
    if all > limit { Err(Fault::limit("vertices of morph targets", all, limit)) } else { Ok(()) }
}

/// A target: the vertices that it moves, and by how much at the weight 1.
pub(super) type Target = Vec<(u32, Vec3)>;

/// All targets of a primitive of so many vertices.
pub(super) fn targets(primitive: &Primitive, count: usize, source: &Source) -> Result<Vec<Target>, Fault> {
    let target = |attributes: &BTreeMap<String, usize>| {
        let Some(&accessor) = attributes.get("POSITION") else { return Ok(Target::new()) };
        check_count(source.accessors.of_kinds(accessor, &["VEC3"])?.count, count)?;
        let (mut moved, mut vertex) = (Target::new(), 0);
        source.accessors.vectors(accessor, &["VEC3"], 0.0, |[x, y, z, _]| {
            let offset = Vec3::new(x, y, z);
            if offset != Vec3::ZERO {
                moved.push((vertex, offset));
            }
            vertex += 1;
        })?;
        Ok(moved)
    };
    check_limit(primitive.targets.len(), count, source)?;
    primitive.targets.iter().map(target).collect()
}
