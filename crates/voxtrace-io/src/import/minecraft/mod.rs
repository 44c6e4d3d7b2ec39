//! Minecraft: builds (`.schematic` of MCEdit, `.schem` of Sponge, `.litematic`, `.nbt`, `.mcstructure`) and worlds (`.mca`, `.mcr`). All become
//! blocks with colours by their names, each a voxel, or with its shape. The game's x is east, y up, z south: our x is east, y north, z up, so nothing is mirrored.

mod bedrock;
mod blocks;
mod build;
mod chunk;
mod colors;
mod dyes;
mod legacy;
mod legacy_names;
mod legacy_states;
mod litematic;
mod looks;
mod lz4;
mod mcedit;
mod model;
mod nbt;
mod neighbours;
mod pack;
mod packed;
mod palette;
mod places;
mod region;
mod shapes;
mod sponge;
mod sprouts;
mod state;
mod structure;
mod voxels;
mod world;

use crate::import::reader::{ImportOptions, Kind, Reader, Voxels};
use crate::import::source::folder::Folder;
use crate::import::source::input::Input;
use build::Build;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::mesh::UpAxis;

/// What the table of readers has of this format.
pub(crate) const BUILDS: Reader = Reader::new(
    "Minecraft build",
    Kind::Voxels,
    &["schem", "schematic", "litematic", "nbt", "mcstructure"],
    "Minecraft build, and .schematic, .litematic, .nbt, .mcstructure: colours by the names of the blocks",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read_build(input, options)?.into())
    },
)
.with_up_axis(Some(UpAxis::Y));

/// What the table of readers has of this format.
pub(crate) const WORLDS: Reader = Reader::new(
    "Minecraft world",
    Kind::Voxels,
    &["mca", "mcr"],
    "region of a Minecraft world; or name the world's folder",
    |source, options| {
        if source.is_folder() {
            return Ok(world::read_world(source.path(), options)?.into());
        }
        let (input, folder) = source.into_input()?;
        Ok(read_region(input, &folder, options)?.into())
    },
)
.with_up_axis(Some(UpAxis::Y))
.with_folders(|clues| Ok(world::holds_regions(clues.path)));

/// Names of the dyes, for the writer of builds.
pub(crate) const DYE_NAMES: [&str; 16] = {
    let mut names = [""; 16];
    let mut index = 0;
    while index < names.len() {
        names[index] = dyes::DYES[index].0;
        index += 1;
    }
    names
};

/// The material that a block is read as, by its name without a namespace; `None` where nobody sees it or the name is unknown.
pub(crate) fn material_of_block(name: &str) -> Option<Material> {
    match blocks::block(name, false) {
        blocks::Block::Known(look) => Some(look.material(1.0)),
        _ => None,
    }
}

/// Reads a build; what kind it is, its tags say.
fn read_build(input: Input, options: &ImportOptions) -> Result<Voxels, ImportError> {
    let path = input.path();
    let mut blocks = build::blocks(options)?;
    let (root, offset, left) = build::tags(input, &options.limits)?;
    let build = Build { path, offset, limits: &options.limits };
    if left > 0 {
        let what = format!("{left} bytes behind the build are left out");
        let error = build.malformed(format!("{left} bytes behind the build"));
        build::damage(options, &mut blocks, || what, error)?;
    }
    blocks.entities = root.entities();
    // Since version 3, Sponge's root has no name and holds the compound of this name.
    let inner = root.compound("Schematic").unwrap_or(&root);
    let mut scene = Scene::new("");
    if let Some(regions) = root.compound("Regions") {
        litematic::read(&build, regions, &mut blocks, &mut scene)?;
    } else if let Some(structure) = root.compound("structure") {
        bedrock::read(&build, &root, structure, &mut blocks, &mut scene)?;
    } else if root.list("blocks").is_some() {
        structure::read(&build, &root, &mut blocks, &mut scene)?;
    } else if inner.bytes("Blocks").is_some() {
        mcedit::read(&build, inner, &mut blocks, &mut scene)?;
    } else {
        sponge::read(&build, inner, &mut blocks, &mut scene)?;
    }
    Ok(blocks.finish(scene))
}

/// Reads one file of regions of a world.
fn read_region(input: Input, folder: &Folder, options: &ImportOptions) -> Result<Voxels, ImportError> {
    let path = input.path();
    let at = world::place_of(path).unwrap_or_default();
    let mut blocks = build::blocks(options)?;
    let grid = region::read(input, folder, options, at, at, &mut blocks)?;
    let mut scene = Scene::new("");
    scene.add_instance(grid, Transform::IDENTITY);
    Ok(blocks.finish(scene))
}
