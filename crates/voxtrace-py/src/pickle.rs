//! Scenes and grids taken apart for pickle, and put together again: exactly, and with all that files leave out.

use crate::errors::{argument, of_packed, other};
use crate::forks::detach;
use crate::grid::BRICK_VOXELS;
use pyo3::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;
use voxtrace::glam::{IVec3, Mat3, Vec3};
use voxtrace::import::vox;
use voxtrace::scene::{Attachment, Group, Keyframe, Layer};
use voxtrace::{Brick, Instance, PackedScene, Scene, Transform, VoxelGrid};

/// What the bytes of a grid begin with: another form of them has another number.
const FORM: u8 = 1;

/// A scene: the `.vxt` file of what there is without its grids, the grids, instances, layers (name, whether it is hidden, colour), groups (name and the group around
/// it) and attachments. Animations of meshes are left out, since nothing here shows or writes them.
pub type SceneParts = (
    Vec<u8>,
    Vec<Vec<u8>>,
    Vec<InstanceParts>,
    Vec<(String, bool, Option<[u8; 3]>)>,
    Vec<(String, Option<usize>)>,
    Vec<(String, Vec<u8>)>,
);
/// An instance: name, grid, transform, layer, group, whether it is hidden, its keyframes, and which of them come again.
type InstanceParts =
    (String, usize, [f32; 12], Option<usize>, Option<usize>, bool, Vec<KeyframeParts>, Option<(u32, u32)>);
/// A keyframe: frame, grid, and where it is and has moved to.
type KeyframeParts = (u32, usize, [f32; 12], [f32; 12]);

/// Takes a scene apart.
///
/// # Errors
/// Where it has more materials than there may be.
pub fn parts_of(scene: &Scene) -> Result<SceneParts, voxtrace::packed::PackError> {
    // All that there is by name, so that nothing new is forgotten.
    let Scene {
        name,
        grids,
        instances,
        materials,
        layers,
        groups,
        sky,
        light_intensity,
        cameras,
        voxel_size,
        unit,
        georeference,
        attachments,
        clips: _,
    } = scene;
    let without_grids = Scene {
        name: name.clone(),
        materials: materials.clone(),
        sky: sky.clone(),
        light_intensity: *light_intensity,
        cameras: cameras.clone(),
        voxel_size: *voxel_size,
        unit: *unit,
        georeference: georeference.clone(),
        ..Scene::default()
    };
    let keyframe = |keyframe: &Keyframe| {
        (keyframe.frame, keyframe.grid, numbers_of(&keyframe.world_from_grid), numbers_of(&keyframe.end))
    };
    let instance = |instance: &Instance| {
        let Instance { name, grid, world_from_grid, layer, group, hidden, keyframes, repeats } = instance;
        let keyframes = keyframes.iter().map(keyframe).collect();
        let repeats = repeats.as_ref().map(|frames| (frames.start, frames.end));
        (name.clone(), *grid, numbers_of(world_from_grid), *layer, *group, *hidden, keyframes, repeats)
    };
    Ok((
        PackedScene::pack(&without_grids)?.to_bytes(),
        grids.iter().map(|grid| bytes_of_grid(grid)).collect(),
        instances.iter().map(instance).collect(),
        layers.iter().map(|layer| (layer.name.clone(), layer.hidden, layer.color)).collect(),
        groups.iter().map(|group| (group.name.clone(), group.parent)).collect(),
        attachments.iter().map(|of| (of.format.to_owned(), of.bytes.to_vec())).collect(),
    ))
}

/// The scene that was taken apart.
pub fn scene_of(py: Python<'_>, parts: SceneParts) -> PyResult<Scene> {
    let (without_grids, grids, instances, layers, groups, attachments) = parts;
    let scene = detach(py, || PackedScene::from_bytes(&without_grids).map(|packed| packed.to_scene()))?;
    let scene = scene.map_err(|error| of_packed(py, error))?;
    let grids: Option<Vec<_>> = py.detach(|| grids.iter().map(|grid| grid_of(grid).map(Arc::new)).collect());
    let keyframe = |(frame, grid, start, end): KeyframeParts| Keyframe {
        frame,
        grid,
        world_from_grid: transform_of(start),
        end: transform_of(end),
    };
    let instance = |(name, grid, place, layer, group, hidden, keyframes, repeats): InstanceParts| Instance {
        name,
        grid,
        world_from_grid: transform_of(place),
        layer,
        group,
        hidden,
        keyframes: keyframes.into_iter().map(keyframe).collect(),
        repeats: repeats.map(|(start, end)| start..end),
    };
    let attachment = |(format, bytes): (String, Vec<u8>)| {
        (format == vox::ATTACHMENT).then(|| Attachment { format: vox::ATTACHMENT, bytes: bytes.into() })
    };
    Ok(Scene {
        grids: grids.ok_or_else(no_grid)?,
        instances: instances.into_iter().map(instance).collect(),
        layers: layers.into_iter().map(|(name, hidden, color)| Layer { name, hidden, color }).collect(),
        groups: groups.into_iter().map(|(name, parent)| Group { name, parent }).collect(),
        attachments: attachments.into_iter().filter_map(attachment).collect(),
        ..scene
    })
}

/// A scene that could not be taken apart.
pub fn of_packing(py: Python<'_>, error: impl std::fmt::Display) -> PyErr {
    other(py, format!("the scene cannot be pickled: {error}"))
}

/// Bytes that are no grid.
pub fn no_grid() -> PyErr {
    argument("these are no voxels that this version of voxtrace has pickled")
}

/// A grid as bytes: for each brick its coordinates, occupancy, whether all of its voxels have one material, and that, or those of all.
pub fn bytes_of_grid(grid: &VoxelGrid) -> Vec<u8> {
    let mut bytes = vec![FORM];
    for (place, brick) in grid.sorted_bricks() {
        let materials = brick.materials();
        let is_uniform = materials.iter().all(|&material| material == materials[0]);
        bytes.extend(place.to_array().into_iter().flat_map(i32::to_le_bytes));
        bytes.extend(brick.occupancy().iter().flat_map(|mask| mask.to_le_bytes()));
        bytes.push(u8::from(is_uniform));
        let kept = if is_uniform { &materials[..1] } else { materials };
        bytes.extend(kept.iter().flat_map(|material| material.to_le_bytes()));
    }
    bytes
}

/// The grid of such bytes, where they are some. Bricks of one material share it.
pub fn grid_of(bytes: &[u8]) -> Option<VoxelGrid> {
    let mut rest = bytes;
    if taken(&mut rest)? != [FORM] {
        return None;
    }
    let (mut bricks, mut uniform) = (Vec::new(), HashMap::<u16, Arc<[u16]>>::new());
    while !rest.is_empty() {
        let mut place = [0; 3];
        for part in &mut place {
            *part = i32::from_le_bytes(taken(&mut rest)?);
        }
        let mut occupancy = [0; 8];
        for mask in &mut occupancy {
            *mask = u64::from_le_bytes(taken(&mut rest)?);
        }
        let [is_uniform] = taken(&mut rest)?;
        let brick = if is_uniform == 0 {
            let count: usize = occupancy.iter().map(|mask| mask.count_ones() as usize).sum();
            let (materials, after) = rest.split_at_checked(2 * count)?;
            rest = after;
            Brick::new(
                occupancy,
                materials.as_chunks::<2>().0.iter().map(|&material| u16::from_le_bytes(material)).collect(),
            )
        } else {
            let material = u16::from_le_bytes(taken(&mut rest)?);
            let shared = uniform.entry(material).or_insert_with(|| Arc::from([material; BRICK_VOXELS]));
            Brick::sharing(occupancy, Arc::clone(shared))
        };
        bricks.push((IVec3::from_array(place), brick));
    }
    Some(VoxelGrid::from_bricks(bricks))
}

/// The next bytes, where there are so many.
fn taken<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (first, after) = rest.split_first_chunk()?;
    *rest = after;
    Some(*first)
}

/// The columns of a transform.
fn numbers_of(transform: &Transform) -> [f32; 12] {
    let (Mat3 { x_axis, y_axis, z_axis }, translation) = (transform.linear, transform.translation);
    let mut numbers = [0.0; 12];
    let columns = [x_axis, y_axis, z_axis, translation];
    numbers.as_chunks_mut::<3>().0.iter_mut().zip(columns).for_each(|(numbers, column)| *numbers = column.to_array());
    numbers
}

/// The transform of such columns.
fn transform_of(numbers: [f32; 12]) -> Transform {
    let column = |at: usize| Vec3::from_slice(&numbers[3 * at..]);
    Transform { linear: Mat3::from_cols(column(0), column(1), column(2)), translation: column(3) }
}
