//! Sponge schematics, `.schem`, version 2 (SpongePowered, "Sponge Schematic Specification"), which WorldEdit and most others read: all
//! visible voxels as one box of blocks, each the one whose colour is nearest. The game's y is up and its z goes south, our −y.

mod choice;
mod nbt;

use super::{ExportError, Wanted, bake_failure, go_on};
use choice::Choice;
use flate2::Compression;
use flate2::write::GzEncoder;
use glam::IVec3;
use nbt::Writer;
use rayon::prelude::*;
use std::io::{self, Write};
use std::path::Path;
use voxtrace_core::atomic_file::write_atomically_while;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::grid::VoxelBox;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::bake::flattened_while;

const FORMAT: &str = ".schem";
const VERSION: i32 = 2;
/// That of the game's version 1.20.1, whose blocks all are known since.
const DATA_VERSION: i32 = 3465;
/// Most blocks along an edge, which has 16 bits.
const LONGEST_EDGE: i32 = 65_535;

/// Writes the visible voxels of a scene as a Sponge schematic. Returns what it does not hold.
pub fn write(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let (grid, _) = flattened_while(scene, wanted).map_err(|error| bake_failure(FORMAT, error))?;
    let Some(bounds) = grid.bounds() else { return Err(ExportError::Empty { format: FORMAT }) };
    let size = bounds.size();
    let volume = size.as_i64vec3().element_product();
    if size.max_element() > LONGEST_EDGE || volume > i64::from(i32::MAX) / 2 {
        return Err(ExportError::TooLarge { format: FORMAT, what: "the voxels" });
    }
    let choice = Choice::of(&scene.materials, &grid);
    let bricks = grid.sorted_bricks();
    go_on(wanted)?;
    let length = volume as usize + second_bytes(&bricks, &choice);
    write_atomically_while(path, wanted, |file| {
        let mut tags = Writer::new(GzEncoder::new(file, Compression::default()));
        tags.begin_compound("Schematic")?;
        tags.int("Version", VERSION)?;
        tags.int("DataVersion", DATA_VERSION)?;
        tags.begin_compound("Metadata")?;
        tags.text("Name", &scene.name)?;
        tags.text("Author", "voxtrace")?;
        tags.end_compound()?;
        for (name, edge) in [("Width", size.x), ("Height", size.z), ("Length", size.y)] {
            tags.short(name, edge as u16)?;
        }
        tags.ints("Offset", &[0; 3])?;
        tags.int("PaletteMax", choice.names().len() as i32)?;
        tags.begin_compound("Palette")?;
        for (number, name) in (0..).zip(choice.names()) {
            tags.int(&format!("minecraft:{name}"), number)?;
        }
        tags.end_compound()?;
        tags.bytes("BlockData", length, |out| write_blocks(out, &bricks, bounds, &choice))?;
        tags.no_compounds("BlockEntities")?;
        tags.end_compound()?;
        tags.finish().finish()?.flush()
    })
    .map_err(|error| ExportError::Io { path: path.into(), error })?;
    let hidden = scene.instances.iter().filter(|instance| !scene.is_visible(instance)).count();
    let mut lost = vec!["colours that no block has".to_owned()];
    lost.extend((hidden > 0).then(|| format!("hidden instances ({hidden})")));
    Ok(if choice.is_exact() { lost.split_off(1) } else { lost })
}

/// How many voxels have a number that takes two bytes; there are not so many blocks that one takes three.
fn second_bytes(bricks: &[(IVec3, &Brick)], choice: &Choice) -> usize {
    let has_two = |material: &&u16| choice.block_of(**material) >= 0x80;
    if choice.names().len() <= 0x80 {
        return 0;
    }
    bricks.par_iter().map(|(_, brick)| brick.materials().iter().filter(has_two).count()).sum()
}

/// Writes the blocks of a box, air where there is no voxel: layer by layer from below, rows from north to south. Bricks are in the order of
/// [`voxtrace_scene::grid::VoxelGrid::sorted_bricks`]. Boxes are mostly air, and may be larger than memory: one row of bricks at a time is unpacked.
fn write_blocks(out: &mut impl Write, bricks: &[(IVec3, &Brick)], bounds: VoxelBox, choice: &Choice) -> io::Result<()> {
    let VoxelBox { min, max } = bounds;
    let width = (max.x - min.x) as usize;
    let mut blocks = vec![0u16; width * BRICK_SIZE as usize];
    let mut bytes = Vec::new();
    for z in min.z..max.z {
        for brick_y in (min.y.div_euclid(BRICK_SIZE)..=(max.y - 1).div_euclid(BRICK_SIZE)).rev() {
            let row = (z.div_euclid(BRICK_SIZE), brick_y);
            let first = bricks.partition_point(|(at, _)| (at.z, at.y) < row);
            blocks.fill(0);
            for (at, brick) in bricks[first..].iter().take_while(|(at, _)| (at.z, at.y) == row) {
                for (local, material) in brick.voxels().filter(|(local, _)| local.z == z.rem_euclid(BRICK_SIZE)) {
                    let x = at.x * BRICK_SIZE + local.x - min.x;
                    blocks[local.y as usize * width + x as usize] = choice.block_of(material);
                }
            }
            let is_inside = |local: &i32| (min.y..max.y).contains(&(brick_y * BRICK_SIZE + local));
            for local in (0..BRICK_SIZE).rev().filter(is_inside) {
                pack(&blocks[local as usize * width..][..width], &mut bytes);
            }
            out.write_all(&bytes)?;
            bytes.clear();
        }
    }
    Ok(())
}

/// Adds indices with seven bits in each byte, the lowest first.
fn pack(blocks: &[u16], bytes: &mut Vec<u8>) {
    for &block in blocks {
        let mut left = block;
        while left >= 0x80 {
            bytes.push(left as u8 | 0x80);
            left >>= 7;
        }
        bytes.push(left as u8);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::Material;
    use voxtrace_scene::grid::VoxelGrid;

    #[test]
    fn blocks_row_by_row_of_bricks_are_those_of_the_whole_box() {
        // So many colours that numbers take a byte or two, and voxels on both sides of the origin.
        let steps = [0, 60, 120, 180, 255];
        let colors = steps.iter().flat_map(|&r| steps.iter().flat_map(move |&g| steps.map(|b| [r, g, b])));
        let mut materials: Vec<Material> = colors.map(Material::from_srgb).collect();
        materials.extend(choice::all_materials());
        let mut grid = VoxelGrid::new();
        for index in 0..3000 {
            let at = IVec3::new(index * 7 % 37 - 19, index * 5 % 23 - 3, index * 3 % 29 - 21);
            grid.set(at, (index * 11 % materials.len() as i32) as u16);
        }
        let (choice, bounds, bricks) = (Choice::of(&materials, &grid), grid.bounds().unwrap(), grid.sorted_bricks());
        assert!(choice.names().len() > 0x80, "{}", choice.names().len());
        let mut whole = Vec::new();
        for z in bounds.min.z..bounds.max.z {
            for y in (bounds.min.y..bounds.max.y).rev() {
                let at = |x| grid.get(IVec3::new(x, y, z)).map_or(0, |material| choice.block_of(material));
                pack(&(bounds.min.x..bounds.max.x).map(at).collect::<Vec<u16>>(), &mut whole);
            }
        }
        let mut written = Vec::new();
        write_blocks(&mut written, &bricks, bounds, &choice).unwrap();
        let volume = bounds.size().as_i64vec3().element_product() as usize;
        assert_eq!(written.len(), volume + second_bytes(&bricks, &choice));
        assert!(written == whole && written.len() > volume);
    }
}
