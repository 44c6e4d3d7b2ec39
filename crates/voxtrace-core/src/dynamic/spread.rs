//! Edits that follow what is there: a layer of voxels that is drawn out, and a flood of connected ones.

use super::EditError;
use super::sketch::Sketch;
use glam::IVec3;
use voxtrace_scene::Face;
use voxtrace_scene::grid::VoxelBox;
use voxtrace_scene::ray::FACES;

/// Repeats each voxel of a layer `distance` times along the outward normal of a face; a negative distance empties as many voxels from each inward.
/// Voxels of a thicker layer count as they were: those that are there stay when others are drawn out, and what is empty becomes the nearest one below.
pub(super) fn extrude(sketch: &mut Sketch, layer: VoxelBox, face: Face, distance: i32) {
    let (size, normal) = (layer.size(), face.normal());
    // Written is ahead of the voxel, along the normal or against it: so the first is the one that has no other ahead.
    let is_last_first = (normal * distance).cmpgt(IVec3::ZERO);
    for z in 0..size.z {
        for y in 0..size.y {
            for x in 0..size.x {
                let at = IVec3::new(x, y, z);
                let voxel = layer.min + IVec3::select(is_last_first, size - 1 - at, at);
                let Some(material) = sketch.get(voxel) else { continue };
                if distance >= 0 {
                    let ahead = (1..=distance).map(|step| voxel + normal * step);
                    for at in ahead {
                        if layer.contains(at) && sketch.get(at).is_some() {
                            break;
                        }
                        sketch.set(at, Some(material));
                    }
                } else {
                    (0..-distance).for_each(|step| sketch.set(voxel - normal * step, None));
                }
            }
        }
    }
}

/// Gives the voxels that are connected to `start` across faces, and are as it is, another material.
///
/// # Errors
/// [`EditError::FloodTooLarge`] where they are more than `most`.
pub(super) fn flood(
    sketch: &mut Sketch,
    start: IVec3,
    material: Option<u16>,
    within: VoxelBox,
    most: u64,
) -> Result<(), EditError> {
    let was = sketch.get(start);
    if was == material || !within.contains(start) {
        return Ok(());
    }
    let mut waiting = vec![start];
    sketch.set(start, material);
    let mut flooded = 1;
    while let Some(voxel) = waiting.pop() {
        for beside in FACES.iter().map(|face| voxel + face.normal()) {
            if within.contains(beside) && sketch.get(beside) == was {
                flooded += 1;
                if flooded > most {
                    return Err(EditError::FloodTooLarge { most });
                }
                sketch.set(beside, material);
                waiting.push(beside);
            }
        }
    }
    Ok(())
}
