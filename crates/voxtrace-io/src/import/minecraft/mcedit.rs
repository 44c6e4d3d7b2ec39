//! MCEdit's `.schematic`, of the time when blocks had numbers: a byte for each block, four bits of data, and four more bits of
//! the number in `AddBlocks`.

use super::build::Build;
use super::legacy_states;
use super::nbt::Compound;
use super::state::State;
use super::voxels::Blocks;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::ImportError;

pub(super) fn read(build: &Build, tags: &Compound, kinds: &mut Blocks, scene: &mut Scene) -> Result<(), ImportError> {
    if tags.text("Materials").is_some_and(|materials| materials.eq_ignore_ascii_case("classic")) {
        return Err(build.unsupported("blocks of Minecraft Classic"));
    }
    let size = build.size(tags)?;
    let count: usize = size.iter().product();
    let blocks = tags.bytes("Blocks").unwrap_or_default();
    if blocks.len() < count {
        return Err(build.malformed(format!("{} blocks, where {count} are announced", blocks.len())));
    }
    let data = tags.bytes("Data").unwrap_or_default();
    let more = tags.bytes("AddBlocks").unwrap_or_default();
    let data_at = |place: usize| data.get(place).copied().unwrap_or(0) & 15;
    // Two blocks share a byte; the even one has the low half.
    let more_at = |place: usize| more.get(place / 2).map_or(0, |byte| byte >> (place % 2 * 4) & 15);
    let key = |place: usize| {
        usize::from(more_at(place)) << 12 | usize::from(blocks[place]) << 4 | usize::from(data_at(place))
    };
    let mut is_there = vec![false; 1 << 16];
    (0..count).for_each(|place| is_there[key(place)] = true);
    let numbers: Vec<u16> = (0u32..1 << 16)
        .map(|key| {
            if !is_there[key as usize] {
                return 0;
            }
            let (id, data) = (key >> 4, key as u8 & 15);
            kinds.number(match u8::try_from(id) {
                Ok(id) => legacy_states::state(id, data),
                Err(_) => State::new(format!("number_{id}")),
            })
        })
        .collect();
    build.add(kinds, scene, size, |place| numbers[key(place)])?;
    Ok(())
}
