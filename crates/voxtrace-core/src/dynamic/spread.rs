//! Edits that follow what is there: a layer of voxels that is drawn out, and a flood of connected ones.

use super::EditError;
use super::sketch::Sketch;
use glam::IVec3;
use voxtrace_scene::Face;
use voxtrace_scene::grid::VoxelBox;
use voxtrace_scene::ray::FACES;

/// Repeats each voxel of a layer `distance` times along the outward normal of a face; a negative distance empties as many voxels from the layer inward.
pub(super) fn extrude(sketch: &mut Sketch, layer: VoxelBox, face: Face, distance: i32) {
    let size = layer.size();
    for z in 0..size.z {
        for y in 0..size.y {
            for x in 0..size.x {
                let voxel = layer.min + IVec3::new(x, y, z);
                let Some(material) = sketch.get(voxel) else { continue };
                if distance >= 0 {
                    (1..=distance).for_each(|step| sketch.set(voxel + face.normal() * step, Some(material)));
                } else {
                    (0..-distance).for_each(|step| sketch.set(voxel - face.normal() * step, None));
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
