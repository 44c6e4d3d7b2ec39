//! Sponge schematics, `.schem`, version 2 (SpongePowered, "Sponge Schematic Specification"), which WorldEdit and most others read: all
//! visible voxels as one box of blocks, each the one whose colour is nearest. The game's y is up and its z goes south, our −y.

mod choice;
mod nbt;

use super::{ExportError, bake_failure};
use crate::output::write_atomically;
use choice::Choice;
use flate2::Compression;
use flate2::write::GzEncoder;
use nbt::Writer;
use std::io::Write;
use std::path::Path;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::bake::flattened;

const FORMAT: &str = ".schem";
const VERSION: i32 = 2;
/// That of the game's version 1.20.1, whose blocks all are known since.
const DATA_VERSION: i32 = 3465;
/// Most blocks along an edge, which has 16 bits.
const LONGEST_EDGE: i32 = 65_535;

/// Writes the visible voxels of a scene as a Sponge schematic. Returns what it does not hold.
pub fn write(path: &Path, scene: &Scene) -> Result<Vec<String>, ExportError> {
    let (grid, _) = flattened(scene).map_err(|error| bake_failure(FORMAT, error))?;
    let Some(bounds) = grid.bounds() else { return Err(ExportError::Empty { format: FORMAT }) };
    let size = bounds.size();
    let volume = size.as_i64vec3().element_product();
    if size.max_element() > LONGEST_EDGE || volume > i64::from(i32::MAX) / 2 {
        return Err(ExportError::TooLarge { format: FORMAT, what: "the voxels" });
    }
    let choice = Choice::of(&scene.materials, &grid);
    let mut blocks = vec![0u16; volume as usize];
    for (voxel, material) in grid.voxels() {
        let at = (voxel - bounds.min).as_i64vec3();
        let south = i64::from(size.y) - 1 - at.y;
        let place = (at.z * i64::from(size.y) + south) * i64::from(size.x) + at.x;
        blocks[place as usize] = choice.block_of(material);
    }
    write_atomically(path, |file| {
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
        tags.bytes("BlockData", &packed(&blocks))?;
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

/// Indices with seven bits in each byte, the lowest first.
fn packed(blocks: &[u16]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(blocks.len());
    for &block in blocks {
        let mut left = block;
        while left >= 0x80 {
            bytes.push(left as u8 | 0x80);
            left >>= 7;
        }
        bytes.push(left as u8);
    }
    bytes
}
