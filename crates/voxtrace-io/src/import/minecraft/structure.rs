//! `.nbt`, what the game's structure blocks save and its own structures are: a size, a palette, and a list of blocks with their places.

use super::build::Build;
use super::nbt::{Compound, Tag};
use super::state::State;
use super::voxels::Blocks;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::ImportError;

pub(super) fn read(build: &Build, tags: &Compound, kinds: &mut Blocks, scene: &mut Scene) -> Result<(), ImportError> {
    let size = tags.ints("size").and_then(|size| size.first_chunk::<3>());
    let size = size.ok_or_else(|| build.malformed("a structure without its size"))?;
    let edges = size.map(|edge| u64::try_from(edge).unwrap_or(u64::MAX));
    let size = build.checked(edges)?;
    // Some structures have several palettes, of which the game chooses one.
    let first = tags.list("palettes").and_then(|palettes| match palettes.first() {
        Some(Tag::List(palette)) => Some(palette.as_slice()),
        _ => None,
    });
    let palette = tags.list("palette").or(first).ok_or_else(|| build.malformed("a structure without a palette"))?;
    let numbers: Vec<u16> = State::of_list(palette).into_iter().map(|state| kinds.number(state)).collect();
    let count: usize = size.iter().product();
    let mut blocks = Vec::new();
    blocks.try_reserve_exact(count).map_err(|_| build.malformed("more blocks than memory"))?;
    blocks.resize(count, 0);
    for tag in tags.list("blocks").unwrap_or_default() {
        let Tag::Compound(block) = tag else { return Err(build.malformed("a block that is no compound")) };
        let at = block.ints("pos").and_then(|at| at.first_chunk::<3>());
        let at = at.ok_or_else(|| build.malformed("a block without a place"))?;
        let within: Option<Vec<usize>> =
            at.iter().zip(size).map(|(&at, edge)| usize::try_from(at).ok().filter(|&at| at < edge)).collect();
        let Some(&[x, y, z]) = within.as_deref() else {
            return Err(build.malformed(format!("a block at {at:?}, outside of the structure")));
        };
        let number = block.whole("state").and_then(|state| numbers.get(usize::try_from(state).ok()?));
        let number = number.ok_or_else(|| build.malformed("a block that is not in the palette"))?;
        blocks[(y * size[2] + z) * size[0] + x] = *number;
    }
    build.add(kinds, scene, size, |place| blocks[place])?;
    Ok(())
}
