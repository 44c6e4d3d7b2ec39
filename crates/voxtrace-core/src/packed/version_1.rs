//! Native files of version 1, which had emitters for each instance under one tree in world space: from them the emitters of
//! each grid under a tree of its own, as they are now.

use super::lights::{append_lights, morton_order};
use super::{Emitter, Geometry, PackedInstance};
use crate::math::luminance;
use std::cmp::Ordering;
use voxtrace_scene::Invalid;

/// The geometry of a file of version 1 whose arrays were read as they are: the second word of an emitter is its instance.
/// The instances of a grid all had the same emitters, so those of the first one count.
///
/// # Errors
/// One sentence about the first emitter that does not make sense.
pub(super) fn geometry_of_version_1(read: Geometry, instances: &[PackedInstance]) -> Result<Geometry, Invalid> {
    let mut shown_by = vec![None; read.grids.len()];
    for (index, instance) in instances.iter().enumerate() {
        if let Some(first) = shown_by.get_mut(instance.grid as usize) {
            first.get_or_insert(index as u32);
        }
    }
    let mut found: Vec<Emitter> = Vec::new();
    for (index, emitter) in read.emitters.iter().enumerate() {
        let instance = emitter.grid;
        let sentence = || format!("emitter {index} points outside");
        let grid = instances.get(instance as usize).ok_or_else(|| Invalid::from(sentence()))?.grid;
        let material = read.materials.get(emitter.material as usize).ok_or_else(|| Invalid::from(sentence()))?;
        if emitter.faces >> 6 != 0 {
            return Err(sentence().into());
        }
        if shown_by.get(grid as usize) == Some(&Some(instance)) {
            found.push(Emitter { grid, luminance: luminance(material.surface_emission()), ..*emitter });
        }
    }
    let order = |a: &Emitter, b: &Emitter| a.grid.cmp(&b.grid).then_with(|| morton_order(a.voxel, b.voxel));
    found.sort_by(order);
    found.dedup_by(|a, b| order(a, b) == Ordering::Equal);
    let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
    for of_grid in found.chunk_by(|a, b| a.grid == b.grid) {
        append_lights(of_grid.to_vec(), &mut emitters, &mut nodes);
    }
    Ok(Geometry { emitters: emitters.into(), light_nodes: nodes.into(), ..read })
}
