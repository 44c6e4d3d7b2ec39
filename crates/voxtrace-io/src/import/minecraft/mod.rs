//! Minecraft: builds (`.schematic` of MCEdit, `.schem` of Sponge, `.litematic`) and worlds (`.mca`). All become blocks with
//! colours by their names. The game's x is east, y up, z south: our x is east, y north, z up, so nothing is mirrored.

mod blocks;
mod colors;
mod legacy;
mod legacy_names;
mod litematic;
mod lz4;
mod mcedit;
mod nbt;
mod packed;
mod palette;
mod region;
mod sponge;
mod world;

use crate::import::grids::{checked_size, dense};
use crate::import::reader::Voxels;
use crate::import::reader::{Kind, Reader};
use crate::import::source::folder::Folder;
use crate::import::source::inflate::{GZIP, gunzip, unzlib};
use crate::import::source::input::Input;
use nbt::Compound;
use palette::Palette;
use std::path::Path;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const BUILDS: Reader = Reader::new(
    "Minecraft build",
    Kind::Voxels,
    &["schem", "schematic", "litematic"],
    "Minecraft build, and .schematic, .litematic: colours by the names of the blocks",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read_build(input, &options.limits)?.into())
    },
)
.with_up_axis(Some(UpAxis::Y));

/// What the table of readers has of this format.
pub(crate) const WORLDS: Reader = Reader::new(
    "Minecraft world",
    Kind::Voxels,
    &["mca"],
    "region of a Minecraft world; or name the world's folder",
    |source, options| {
        if source.is_folder() {
            return Ok(world::read_world(source.path(), &options.limits)?.into());
        }
        let (input, folder) = source.into_input()?;
        Ok(read_region(input, &folder, &options.limits)?.into())
    },
)
.with_up_axis(Some(UpAxis::Y))
.with_folders(|clues| Ok(world::holds_regions(clues.path)));

/// Names of the dyes, for the writer of builds.
pub(crate) const DYE_NAMES: [&str; 16] = {
    let mut names = [""; 16];
    let mut index = 0;
    while index < names.len() {
        names[index] = colors::DYES[index].0;
        index += 1;
    }
    names
};

/// The material that a block is read as, by its name without a namespace; `None` where nobody sees it or the name is unknown.
pub(crate) fn material_of_block(name: &str) -> Option<Material> {
    match blocks::block(name, false) {
        blocks::Block::Known(look) => Some(look.material()),
        _ => None,
    }
}

/// Reads a build; what kind it is, its tags say.
fn read_build(mut input: Input, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    let head = input.peek(2)?;
    let mut input = if head.starts_with(&GZIP) {
        gunzip(input, limits)
    } else if head.first() == Some(&0x78) {
        unzlib(input, limits)
    } else {
        input
    };
    let root = nbt::read(&mut input, limits)?;
    let build = Build { path, offset: input.offset(), limits };
    // What comes after the tags is only looked at so that a cut-off file is told.
    input.rest()?;
    // Since version 3, Sponge's root has no name and holds the compound of this name.
    let inner = root.compound("Schematic").unwrap_or(&root);
    let (mut scene, mut palette) = (Scene::new(""), Palette::default());
    palette.entities = root.entities();
    if let Some(regions) = root.compound("Regions") {
        litematic::read(&build, regions, &mut palette, &mut scene)?;
    } else if inner.bytes("Blocks").is_some() {
        mcedit::read(&build, inner, &mut palette, &mut scene)?;
    } else {
        sponge::read(&build, inner, &mut palette, &mut scene)?;
    }
    Ok(palette.finish(scene))
}

/// Reads one file of regions of a world.
fn read_region(input: Input, folder: &Folder, limits: &Limits) -> Result<Voxels, ImportError> {
    let path = input.path();
    let at = world::place_of(path).unwrap_or_default();
    let mut palette = Palette::default();
    let grid = region::read(input, folder, limits, at, at, &mut palette)?;
    let mut scene = Scene::new("");
    scene.add_instance(grid, Transform::IDENTITY);
    Ok(palette.finish(scene))
}

/// What readers of builds share: where faults are, and what is allowed.
struct Build<'a> {
    path: &'a Path,
    /// The byte of the uncompressed tags where they end.
    offset: u64,
    limits: &'a Limits,
}

impl Build<'_> {
    fn malformed(&self, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.path, self.offset, what)
    }

    fn unsupported(&self, what: &str) -> ImportError {
        ImportError::at(self.path, self.offset, ImportErrorKind::Unsupported(what.into()))
    }

    /// Width, height and length of a schematic, whose sizes are 16 bits without a sign.
    fn size(&self, tags: &Compound) -> Result<[usize; 3], ImportError> {
        let mut size = [0; 3];
        for (edge, name) in size.iter_mut().zip(["Width", "Height", "Length"]) {
            let value = tags.whole(name).ok_or_else(|| self.malformed(format!("a schematic without {name}")))?;
            *edge = u64::from(value as u16);
        }
        checked_size(self.path, self.offset, size, self.limits)?;
        Ok(size.map(|edge| edge as usize))
    }

    /// Adds a box of blocks: `material_at` gets the index of a place, x fastest, then z, then y.
    fn add(
        &self,
        scene: &mut Scene,
        [width, height, length]: [usize; 3],
        material_at: impl Fn(usize) -> Option<u16> + Sync,
    ) -> Result<usize, ImportError> {
        let size = [width, length, height].map(|edge| edge as u64);
        let size = checked_size(self.path, self.offset, size, self.limits)?;
        let grid = dense::grid(size, |voxel| {
            // South is −y: the last row of the file is the first of the grid.
            let (x, z, y) = (voxel.x as usize, length - 1 - voxel.y as usize, voxel.z as usize);
            material_at((y * length + z) * width + x)
        });
        Ok(scene.add_instance(grid, Transform::IDENTITY))
    }
}
