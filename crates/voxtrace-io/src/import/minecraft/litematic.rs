//! Litematica's `.litematic`: several boxes of blocks, each with a palette and packed indices. A size below zero grows towards
//! lower coordinates.

use super::build::Build;
use super::nbt::{Compound, Tag};
use super::packed::{Packed, bits_of};
use super::state::State;
use super::voxels::Blocks;
use glam::Vec3;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::ImportError;

pub(super) fn read(
    build: &Build,
    regions: &Compound,
    blocks: &mut Blocks,
    scene: &mut Scene,
) -> Result<(), ImportError> {
    let mut boxes = Vec::new();
    let mut places = 0u64;
    for (name, tag) in regions.entries() {
        let Tag::Compound(region) = tag else { continue };
        let triple = |key: &str| {
            let tags = region.compound(key)?;
            Some([tags.whole("x")?, tags.whole("y")?, tags.whole("z")?])
        };
        let (Some(size), Some(position)) = (triple("Size"), triple("Position")) else {
            return Err(build.malformed(format!("the region {name:?} has no size or no position")));
        };
        // The corner with the lowest coordinates; all are 32 bits.
        let min: [i64; 3] = std::array::from_fn(|axis| position[axis] + (size[axis] + 1).min(0));
        let size = size.map(i64::unsigned_abs);
        places = places.saturating_add(size.into_iter().fold(1, u64::saturating_mul));
        if places > build.limits.voxels {
            let (path, most) = (build.path, build.limits.voxels);
            return Err(ImportError::limit(path, Some(build.offset), "places of voxels", places, most));
        }
        boxes.push((name, region, min, build.checked(size)?));
    }
    let origin: [i64; 3] = std::array::from_fn(|axis| boxes.iter().map(|(_, _, min, _)| min[axis]).min().unwrap_or(0));
    for (name, region, min, size) in boxes {
        let list = region.list("BlockStatePalette").unwrap_or_default();
        let words = region.longs("BlockStates").unwrap_or_default();
        let count: usize = size.iter().product();
        let packed = Packed::gapless(words, count, bits_of(list.len(), 2));
        let packed = packed.ok_or_else(|| build.malformed(format!("the region {name:?} has too few blocks")))?;
        let numbers: Vec<u16> = State::of_list(list).into_iter().map(|state| blocks.number(state)).collect();
        if let Some(index) = (0..count).map(|place| packed.get(place)).find(|&index| index >= numbers.len()) {
            return Err(build.malformed(format!("the index {index} is not in the palette of region {name:?}")));
        }
        let instance = build.add(blocks, scene, size, |place| numbers[packed.get(place)])?;
        let offset: [i64; 3] = std::array::from_fn(|axis| min[axis] - origin[axis]);
        if let Some(far) = offset.iter().find(|&&far| far > i64::from(MAX_COORDINATE / blocks.edge())) {
            return Err(build.malformed(format!("the region {name:?} is {far} blocks from another")));
        }
        let [x, y, z] = offset.map(|offset| offset as f32);
        let edge = blocks.edge() as f32;
        let instance = &mut scene.instances[instance];
        instance.name = name.to_owned();
        // The grid begins at its southern end.
        instance.world_from_grid = Transform::from_translation(Vec3::new(x, -z - size[2] as f32, y) * edge);
    }
    Ok(())
}
