//! MCEdit's `.schematic`, of the time when blocks had numbers: a byte for each block, four bits of data, and four more bits of
//! the number in `AddBlocks`.

use super::legacy;
use super::nbt::Compound;
use super::palette::Palette;
use super::{Build, ImportError};
use voxtrace_scene::scene::Scene;

pub(super) fn read(
    build: &Build,
    tags: &Compound,
    palette: &mut Palette,
    scene: &mut Scene,
) -> Result<(), ImportError> {
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
    let materials: Vec<Option<u16>> = (0u32..1 << 16)
        .map(|key| {
            if !is_there[key as usize] {
                return None;
            }
            let (id, data) = (key >> 4, key as u8 & 15);
            let state = match u8::try_from(id) {
                Ok(id) => legacy::name(id, data),
                Err(_) => (format!("number_{id}"), false),
            };
            palette.material(state)
        })
        .collect();
    build.add(scene, size, |place| materials[key(place)])?;
    Ok(())
}
