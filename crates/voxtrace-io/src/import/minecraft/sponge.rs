//! Sponge's `.schem`, versions 1 to 3: a palette of texts, and for each block an index of as many bytes as it needs, seven bits
//! in each.

use super::build::Build;
use super::nbt::{Compound, Tag};
use super::state::State;
use super::voxels::Blocks;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::ImportError;

/// Most bytes of an index.
const LONGEST: u32 = 5;

pub(super) fn read(build: &Build, tags: &Compound, kinds: &mut Blocks, scene: &mut Scene) -> Result<(), ImportError> {
    // Since version 3 a compound of its own holds them.
    let (names, data) = match tags.compound("Blocks") {
        Some(blocks) => (blocks.compound("Palette"), blocks.bytes("Data")),
        None => (tags.compound("Palette"), tags.bytes("BlockData")),
    };
    let (Some(names), Some(data)) = (names, data) else {
        return Err(build.unsupported("tags without the blocks of a schematic or a region"));
    };
    let size = build.size(tags)?;
    let count: usize = size.iter().product();
    let mut numbers = Vec::new();
    // No index of a palette without gaps is beyond this; with gaps it may be a few times that.
    let most = 4 * names.entries().count() + 4096;
    for (name, index) in names.entries() {
        let index = match index {
            Tag::Whole(index) => usize::try_from(*index).ok(),
            _ => None,
        };
        let index = index.filter(|&index| index < most);
        let index = index.ok_or_else(|| build.malformed(format!("an impossible index of {name:?}")))?;
        if numbers.len() <= index {
            numbers.resize(index + 1, None);
        }
        numbers[index] = Some(kinds.number(State::of_text(name)));
    }
    let mut blocks = Vec::new();
    let mut bytes = data.iter();
    // A byte at least for each block.
    blocks.try_reserve_exact(count.min(data.len())).map_err(|_| build.malformed("more blocks than memory"))?;
    for _ in 0..count {
        let (mut index, mut shift) = (0u64, 0);
        loop {
            let byte = bytes.next().ok_or_else(|| build.malformed("the blocks end too early"))?;
            index |= u64::from(byte & 0x7f) << (7 * shift);
            shift += 1;
            if byte & 0x80 == 0 {
                break;
            }
            if shift == LONGEST {
                return Err(build.malformed("an index of more than five bytes"));
            }
        }
        let number = usize::try_from(index).ok().and_then(|index| *numbers.get(index)?);
        blocks.push(number.ok_or_else(|| build.malformed(format!("the index {index} is not in the palette")))?);
    }
    build.add(kinds, scene, size, |place| blocks[place])?;
    Ok(())
}
