//! Small files of OpenVDB, each with another kind of number, compression and place: a ball as a level set, and a slope with a tile.

use crate::zipped::zlib;
use voxtrace::glam::{IVec3, Vec3};

/// Where nothing is in the level set: as far away as it goes.
pub const BAND: f32 = 2.0;
/// A leaf whose voxels have all this value and are stored as one.
pub const TILE: (IVec3, f32) = (IVec3::new(8, 0, 0), 2.5);

/// Distance from a ball, and whether it is near enough to be stored.
pub fn ball(at: IVec3) -> (f32, bool) {
    let distance = (at.as_vec3() - Vec3::new(6.0, 5.0, 7.0)).length() - 3.5;
    (distance.clamp(-BAND, BAND), distance.abs() < BAND)
}

/// Eighths that halves hold, in a box with a missing corner.
pub fn slope(at: IVec3) -> (f32, bool) {
    let is_there = at.cmplt(IVec3::new(7, 6, 5)).all() && at.cmpge(IVec3::ONE).all() && at.element_sum() < 15;
    let value = 0.125 * (8 + at.x + 3 * at.y + 9 * at.z) as f32;
    if is_there { (value, true) } else { (0.0, false) }
}

/// How a file is written.
struct Style {
    version: u32,
    /// 1 zlib, 2 active numbers alone, 4 Blosc.
    packing: u32,
    is_half: bool,
    is_double: bool,
    class: &'static str,
    place: (&'static str, Vec<f64>),
    background: f32,
}

fn text(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes()[..], text.as_bytes()].concat()
}

fn fact(name: &str, kind: &str, value: &[u8]) -> Vec<u8> {
    [text(name), text(kind), (value.len() as u32).to_le_bytes().to_vec(), value.to_vec()].concat()
}

/// Sixteen bits of a number that they hold.
fn half(value: f32) -> u16 {
    if value == 0.0 {
        return 0;
    }
    let bits = value.to_bits();
    ((bits >> 31) << 15 | ((bits >> 23 & 255) - 112) << 10 | (bits >> 13 & 0x3ff)) as u16
}

impl Style {
    fn single(&self, value: f32) -> Vec<u8> {
        if self.is_double { f64::from(value).to_le_bytes().to_vec() } else { value.to_le_bytes().to_vec() }
    }

    /// The numbers of a node behind its masks. Inactive ones are the background, or with a choice that or its opposite.
    fn numbers(&self, values: &[(f32, bool)]) -> Vec<u8> {
        let has_choice = self.packing & 2 != 0 && values.iter().any(|&(value, on)| !on && value != self.background);
        let mut bytes = vec![if has_choice {
            3
        } else if self.packing & 2 != 0 {
            0
        } else {
            6
        }];
        if has_choice {
            bytes.extend(mask(values.iter().map(|&(value, _)| value == self.background)));
        }
        let there = values.iter().filter(|&&(_, on)| on || self.packing & 2 == 0);
        let plain: Vec<u8> = there
            .flat_map(|&(value, _)| if self.is_half { half(value).to_le_bytes().to_vec() } else { self.single(value) })
            .collect();
        if self.is_half && plain.is_empty() {
            return bytes;
        }
        let packed = match self.packing & 5 {
            1 => zlib(&plain),
            4 => {
                let length = plain.len() as u32;
                [&[2, 1, 2, 8][..], &[length, length, length + 16].map(u32::to_le_bytes).concat(), &plain].concat()
            }
            _ => return [bytes, plain].concat(),
        };
        // What does not become shorter stays as it is, with its length less than nothing; an empty one is of that kind.
        if packed.len() < plain.len() || self.packing & 4 != 0 && !plain.is_empty() {
            bytes.extend((packed.len() as i64).to_le_bytes());
            bytes.extend(packed);
        } else {
            bytes.extend((-(plain.len() as i64)).to_le_bytes());
            bytes.extend(plain);
        }
        bytes
    }

    /// A file with one grid, of whose leaves some are there, and perhaps the tile, and a grid of vectors that nobody reads.
    fn file(&self, voxel: fn(IVec3) -> (f32, bool), leaves: &[IVec3], has_tile: bool) -> Vec<u8> {
        let at = |n: usize, log: u32| {
            let low = (1 << log) - 1;
            IVec3::new((n >> (2 * log)) as i32, (n >> log & low) as i32, (n & low) as i32)
        };
        let nowhere = (self.background, false);
        let values = |leaf: IVec3| (0..512).map(move |n| voxel(leaf + at(n, 3))).collect::<Vec<_>>();
        let mut tree = [1u32.to_le_bytes().to_vec(), self.single(self.background)].concat();
        tree.extend([0u32, 1, 0, 0, 0].map(u32::to_le_bytes).concat());
        let only_first = |count: usize| mask((0..count).map(|n| n == 0));
        tree.extend(only_first(32_768));
        tree.extend(mask((0..32_768).map(|_| false)));
        tree.extend(self.numbers(&vec![nowhere; 32_768]));
        let is_tile = |n: usize| has_tile && at(n, 4) * 8 == TILE.0;
        let children = (0..4096).filter(|&n| leaves.contains(&(at(n, 4) * 8)));
        tree.extend(mask((0..4096).map(|n| leaves.contains(&(at(n, 4) * 8)))));
        tree.extend(mask((0..4096).map(is_tile)));
        let parts = (0..4096).map(|n| if is_tile(n) { (TILE.1, true) } else { nowhere });
        tree.extend(self.numbers(&parts.collect::<Vec<_>>()));
        let actives = |leaf: IVec3| mask(values(leaf).into_iter().map(|(_, on)| on));
        tree.extend(children.clone().flat_map(|n| actives(at(n, 4) * 8)));
        let blocks = children.flat_map(|n| {
            let leaf = at(n, 4) * 8;
            [actives(leaf), self.numbers(&values(leaf))].concat()
        });
        let blocks: Vec<u8> = blocks.collect();

        let (map, numbers) = &self.place;
        let numbers: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        let facts = [fact("class", "string", self.class.as_bytes()), fact("name", "string", b"lump")].concat();
        let head = [&self.packing.to_le_bytes()[..], &2u32.to_le_bytes(), &facts, &text(map), &numbers].concat();
        let kind = if self.is_double { "Tree_double_5_4_3" } else { "Tree_float_5_4_3" };
        let kind = format!("{kind}{}", if self.is_half { "_HalfFloat" } else { "" });

        let mut file =
            [crate::vdb_files::MAGIC, &[self.version, 10, 0].map(u32::to_le_bytes).concat(), &[1], &[b'-'; 36]]
                .concat();
        file.extend(
            [1u32.to_le_bytes().to_vec(), fact("creator", "string", b"nobody"), 2u32.to_le_bytes().to_vec()].concat(),
        );
        file.extend([text("wind"), text("Tree_vec3s_5_4_3"), text("")].concat());
        let end = file.len() as i64 + 24;
        file.extend([end, end, end].map(i64::to_le_bytes).concat());
        file.extend([text("lump\x1e1"), text(&kind), text("")].concat());
        let start = file.len() as i64 + 24;
        let middle = start + (head.len() + tree.len()) as i64;
        file.extend([start, middle, middle + blocks.len() as i64].map(i64::to_le_bytes).concat());
        [file, head, tree, blocks].concat()
    }
}

fn mask(bits: impl Iterator<Item = bool>) -> Vec<u8> {
    let bits: Vec<bool> = bits.collect();
    bits.chunks(8).map(|byte| byte.iter().rev().fold(0, |all, &bit| all << 1 | u8::from(bit))).collect()
}

/// Each file with its name.
pub fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let corners: Vec<IVec3> = (0..8).map(|n| IVec3::new(n & 1, n >> 1 & 1, n >> 2) * 8).collect();
    let scale = |edge: f64| [[edge; 3], [edge; 3], [1.0 / edge; 3], [0.0; 3], [0.0; 3]].concat();
    let ball_of = Style {
        version: 222,
        packing: 2,
        is_half: false,
        is_double: false,
        class: "level set",
        place: ("UniformScaleMap", scale(0.5)),
        background: BAND,
    };
    let fog = Style {
        version: 224,
        packing: 1,
        is_half: true,
        class: "fog volume",
        place: ("UniformScaleTranslateMap", [vec![1.0, 2.0, 3.0], scale(0.25)].concat()),
        background: 0.0,
        ..ball_of
    };
    let rows = vec![0.0, 0.0, 2.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 10.0, 20.0, 30.0, 1.0];
    let doubles = Style {
        version: 223,
        packing: 6,
        is_half: false,
        is_double: true,
        class: "unknown",
        place: ("AffineMap", rows),
        background: 0.0,
    };
    vec![
        ("ball.vdb", ball_of.file(ball, &corners, false)),
        ("zip.vdb", fog.file(slope, &[IVec3::ZERO], true)),
        ("blosc.vdb", doubles.file(slope, &[IVec3::ZERO], true)),
    ]
}
