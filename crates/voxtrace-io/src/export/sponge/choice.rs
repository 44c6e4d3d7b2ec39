//! Which block shows a material: of those that shine, let light through, are metal or none of that the one whose colour, as the reader of
//! builds takes it, is nearest in Oklab.

use crate::export::flat_color::shown_color;
use crate::import::minecraft::{DYE_NAMES, material_of_block};
use glam::Vec3;
use rayon::prelude::*;
use std::collections::BTreeSet;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::oklab::oklab_of;

/// Whole blocks that stay where they are put, besides those that are dyed.
const BLOCKS: [&str; 84] = [
    "stone",
    "smooth_stone",
    "andesite",
    "polished_andesite",
    "diorite",
    "polished_diorite",
    "granite",
    "polished_granite",
    "cobblestone",
    "mossy_cobblestone",
    "stone_bricks",
    "mossy_stone_bricks",
    "cobbled_deepslate",
    "polished_deepslate",
    "deepslate_bricks",
    "deepslate_tiles",
    "tuff",
    "calcite",
    "dripstone_block",
    "bricks",
    "mud_bricks",
    "packed_mud",
    "sandstone",
    "red_sandstone",
    "dirt",
    "coarse_dirt",
    "rooted_dirt",
    "clay",
    "moss_block",
    "snow_block",
    "netherrack",
    "nether_bricks",
    "red_nether_bricks",
    "blackstone",
    "polished_blackstone",
    "polished_blackstone_bricks",
    "smooth_basalt",
    "end_stone",
    "end_stone_bricks",
    "obsidian",
    "purpur_block",
    "quartz_block",
    "prismarine",
    "prismarine_bricks",
    "dark_prismarine",
    "terracotta",
    "coal_block",
    "lapis_block",
    "emerald_block",
    "diamond_block",
    "amethyst_block",
    "raw_iron_block",
    "raw_gold_block",
    "raw_copper_block",
    "honeycomb_block",
    "nether_wart_block",
    "warped_wart_block",
    "brown_mushroom_block",
    "red_mushroom_block",
    "mushroom_stem",
    "dried_kelp_block",
    "melon",
    "pumpkin",
    "sponge",
    "wet_sponge",
    "sculk",
    "soul_soil",
    "crimson_nylium",
    "warped_nylium",
    "oak_planks",
    "spruce_planks",
    "birch_planks",
    "jungle_planks",
    "acacia_planks",
    "dark_oak_planks",
    "mangrove_planks",
    "crimson_planks",
    "warped_planks",
    "oak_wood",
    "spruce_wood",
    "birch_wood",
    "jungle_wood",
    "acacia_wood",
    "dark_oak_wood",
];
/// Blocks that always shine.
const LAMPS: [&str; 6] =
    ["glowstone", "sea_lantern", "shroomlight", "ochre_froglight", "verdant_froglight", "pearlescent_froglight"];
const METALS: [&str; 7] = [
    "iron_block",
    "gold_block",
    "waxed_copper_block",
    "waxed_exposed_copper",
    "waxed_weathered_copper",
    "waxed_oxidized_copper",
    "netherite_block",
];
const GLASSES: [&str; 3] = ["glass", "packed_ice", "blue_ice"];
/// Water is told from glass by its index of refraction.
const WATER_IOR: f32 = 1.33;

/// A block, and the material that it is read as.
struct Candidate {
    name: String,
    material: Material,
    color: Vec3,
}

/// The blocks of the materials of a scene; 0 is air.
pub struct Choice {
    names: Vec<String>,
    block_of: Vec<u16>,
    is_exact: bool,
}

impl Choice {
    /// Chooses for every material that a voxel has.
    pub fn of(materials: &[Material], grid: &VoxelGrid) -> Self {
        let bricks = grid.sorted_bricks();
        let of_brick =
            |(_, brick): &(_, &voxtrace_scene::Brick)| BTreeSet::from_iter(brick.materials().iter().copied());
        let join = |mut a: BTreeSet<u16>, b: BTreeSet<u16>| {
            a.extend(b);
            a
        };
        let used = bricks.par_iter().map(of_brick).reduce(BTreeSet::new, join);
        let candidates = candidates();
        let mut choice = Self { names: vec!["air".into()], block_of: vec![0; materials.len()], is_exact: true };
        for index in used {
            let material = &materials[usize::from(index)];
            let nearest = nearest(&candidates, material);
            choice.is_exact &= nearest.material == *material;
            let known = choice.names.iter().position(|name| *name == nearest.name);
            choice.block_of[usize::from(index)] = known.unwrap_or_else(|| {
                choice.names.push(nearest.name.clone());
                choice.names.len() - 1
            }) as u16;
        }
        choice
    }

    /// The number of a material's block.
    pub fn block_of(&self, material: u16) -> u16 {
        self.block_of[usize::from(material)]
    }

    /// The blocks' names without the game's namespace, by number.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Whether every block is read as the very material that it stands for.
    pub fn is_exact(&self) -> bool {
        self.is_exact
    }
}

/// All blocks to choose from. Of two of one colour the first is taken.
fn candidates() -> Vec<Candidate> {
    let dyed = DYE_NAMES
        .iter()
        .flat_map(|dye| ["concrete", "wool", "terracotta", "stained_glass"].map(|made| format!("{dye}_{made}")));
    let named = [&BLOCKS[..], &LAMPS, &METALS, &GLASSES, &["water"]].concat();
    let names = named.into_iter().map(String::from).chain(dyed);
    let candidate = |name: String| {
        let material = material_of_block(&name)?;
        Some(Candidate { name, material, color: hue(&material) })
    };
    names.filter_map(candidate).collect()
}

/// The materials of all blocks.
#[cfg(test)]
pub fn all_materials() -> Vec<Material> {
    candidates().into_iter().map(|candidate| candidate.material).collect()
}

/// What is compared: the colour, of what shines as bright as it can be.
fn hue(material: &Material) -> Vec3 {
    let color = shown_color(material);
    let most = color.max_element();
    let is_dim_light = material.is_emissive() && most > 0.0;
    oklab_of(if is_dim_light { color / most } else { color })
}

fn nearest<'a>(candidates: &'a [Candidate], material: &Material) -> &'a Candidate {
    type Is = fn(&Material) -> bool;
    let is_water: Is = |one| one.is_transmissive() && (one.ior - WATER_IOR).abs() < 0.01;
    let is_clear: Is = |one| one.transmission >= 0.5 && (one.ior - WATER_IOR).abs() >= 0.01;
    let is_metal: Is = |one| one.metallic >= 0.5;
    let kinds: [Is; 4] = [Material::is_emissive, is_water, is_clear, is_metal];
    let kind = |one: &Material| kinds.iter().position(|is| is(one));
    let own = kind(material);
    // There are few metals: stone of its colour is nearer to a blue one than gold is.
    let suits = |other: Option<usize>| other == own || (own == Some(3) && other.is_none());
    let wanted = hue(material);
    let suited = candidates.iter().filter(|candidate| suits(kind(&candidate.material)));
    let distance = |candidate: &&Candidate| {
        let is_other = candidate.material != *material;
        (candidate.color.distance_squared(wanted), is_other)
    };
    let order = |a: &&Candidate, b: &&Candidate| {
        let ((a, is_a_other), (b, is_b_other)) = (distance(a), distance(b));
        a.total_cmp(&b).then(is_a_other.cmp(&is_b_other))
    };
    suited.min_by(order).expect("there is a block of each kind")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name_of(material: Material) -> String {
        nearest(&candidates(), &material).name.clone()
    }

    #[test]
    fn every_block_stands_for_itself_or_for_one_that_looks_the_same() {
        let candidates = candidates();
        assert_eq!(candidates.len(), BLOCKS.len() + LAMPS.len() + METALS.len() + GLASSES.len() + 1 + 4 * 16);
        for candidate in &candidates {
            let chosen = nearest(&candidates, &candidate.material);
            assert_eq!(chosen.material, candidate.material, "{} became {}", candidate.name, chosen.name);
        }
    }

    #[test]
    fn what_shines_is_a_lamp_what_is_clear_is_glass_and_the_rest_has_the_nearest_colour() {
        assert_eq!(name_of(Material::from_srgb([0x8e, 0x21, 0x20])), "red_concrete");
        assert_eq!(name_of(Material::from_srgb([0x7d, 0x7e, 0x7d])), "stone");
        assert_eq!(name_of(Material::from_srgb([255, 200, 100]).glowing(3.0)), "glowstone");
        assert_eq!(name_of(Material::metal(Vec3::new(0.95, 0.7, 0.05), 0.2)), "gold_block");
        assert_eq!(name_of(Material::metal(Vec3::new(0.03, 0.03, 0.28), 0.2)), "blue_concrete");
        let red = Material::glass(1.5, 0.0).tinted(Vec3::new(0.3, 0.02, 0.02), 2.0);
        assert_eq!(name_of(red), "red_stained_glass");
        assert_eq!(name_of(Material { ior: 1.33, ..red }), "water");
    }
}
