//! One small build in every format of voxels that is read: each writes the same blocks in its own way.

mod goxel;
mod qubicle;
mod voxlap;

use super::zipped::{gzip, zlib};
use goxel::goxel;
use qubicle::{binary, exchange, project, tree};
use voxlap::{kv6, kvx, map};

/// Width (east), height, length (south).
pub const SIZE: [usize; 3] = [5, 4, 3];

/// Names in the palettes, the first one is empty. Old files have their numbers.
const STATES: [(&str, u8, u8); 6] = [
    ("minecraft:air", 0, 0),
    ("minecraft:stone", 1, 0),
    ("minecraft:red_wool", 35, 14),
    ("minecraft:oak_planks", 5, 0),
    ("minecraft:gold_block", 41, 0),
    ("minecraft:glowstone", 89, 0),
];

/// The block at a place: a floor of stone, and on it one of each that tells the directions apart.
pub fn block_at(x: usize, y: usize, z: usize) -> usize {
    match (x, y, z) {
        (_, 0, _) => 1,
        (4, 1, 0) => 2,
        (0, 1..=3, 0) => 3,
        (0, 1, 2) => 4,
        (2, 1, 1) => 5,
        _ => 0,
    }
}

/// The places, x fastest, then z, then y.
fn blocks() -> Vec<usize> {
    let [width, height, length] = SIZE;
    let places = (0..height).flat_map(|y| (0..length).flat_map(move |z| (0..width).map(move |x| block_at(x, y, z))));
    places.collect()
}

/// A tag with its name.
fn named(kind: u8, name: &str, payload: Vec<u8>) -> Vec<u8> {
    let mut bytes = vec![kind];
    bytes.extend((name.len() as u16).to_be_bytes());
    bytes.extend(name.bytes());
    bytes.extend(payload);
    bytes
}

fn short(name: &str, value: usize) -> Vec<u8> {
    named(2, name, (value as i16).to_be_bytes().to_vec())
}

fn int(name: &str, value: i32) -> Vec<u8> {
    named(3, name, value.to_be_bytes().to_vec())
}

fn text(value: &str) -> Vec<u8> {
    [&(value.len() as u16).to_be_bytes()[..], value.as_bytes()].concat()
}

fn bytes(name: &str, values: &[u8]) -> Vec<u8> {
    named(7, name, [&(values.len() as i32).to_be_bytes()[..], values].concat())
}

fn longs(name: &str, values: &[u64]) -> Vec<u8> {
    let mut payload = (values.len() as i32).to_be_bytes().to_vec();
    payload.extend(values.iter().flat_map(|value| value.to_be_bytes()));
    named(12, name, payload)
}

fn compound(name: &str, entries: &[Vec<u8>]) -> Vec<u8> {
    named(10, name, [entries.concat(), vec![0]].concat())
}

fn list(name: &str, kind: u8, items: &[Vec<u8>]) -> Vec<u8> {
    named(9, name, [&[kind][..], &(items.len() as i32).to_be_bytes(), &items.concat()].concat())
}

/// The palette as a list of compounds with names and properties.
fn palette_list(name: &str) -> Vec<u8> {
    let entry = |name: &str| {
        let properties = compound("Properties", &[named(8, "axis", text("y"))]);
        [named(8, "Name", text(name)), properties, vec![0]].concat()
    };
    let entries: Vec<Vec<u8>> = STATES.iter().map(|(name, ..)| entry(name)).collect();
    list(name, 10, &entries)
}

fn gapless(values: &[usize], bits: usize) -> Vec<u64> {
    let mut words = vec![0; (values.len() * bits).div_ceil(64)];
    for (place, value) in values.iter().enumerate() {
        for bit in 0..bits {
            let at = place * bits + bit;
            words[at / 64] |= (value >> bit & 1) as u64 * (1 << (at % 64));
        }
    }
    words
}

fn sizes() -> Vec<u8> {
    [short("Width", SIZE[0]), short("Height", SIZE[1]), short("Length", SIZE[2])].concat()
}

fn schematic() -> Vec<u8> {
    let numbers: Vec<u8> = blocks().into_iter().map(|block| STATES[block].1).collect();
    let data: Vec<u8> = blocks().into_iter().map(|block| STATES[block].2).collect();
    let entities = list("TileEntities", 10, &[[int("x", 3), vec![0]].concat()]);
    compound("Schematic", &[sizes(), entities, bytes("Blocks", &numbers), bytes("Data", &data)])
}

fn palette_names() -> Vec<Vec<u8>> {
    STATES.iter().enumerate().map(|(index, (name, ..))| int(&format!("{name}[axis=y]"), index as i32)).collect()
}

fn schem(version: i32) -> Vec<u8> {
    let data: Vec<u8> = blocks().into_iter().map(|block| block as u8).collect();
    let head = [int("Version", version), int("DataVersion", 2975), sizes()].concat();
    if version < 3 {
        let palette = compound("Palette", &palette_names());
        return compound("Schematic", &[head, palette, bytes("BlockData", &data)]);
    }
    let blocks = compound("Blocks", &[compound("Palette", &palette_names()), bytes("Data", &data)]);
    compound("", &[compound("Schematic", &[head, blocks])])
}

/// A schematic of any blocks: `at` says the index into the names of a place.
pub fn schem_of(size: [usize; 3], names: &[&str], at: impl Fn(usize, usize, usize) -> usize) -> Vec<u8> {
    let [width, height, length] = size;
    let mut data = Vec::new();
    for (y, z, x) in (0..height).flat_map(|y| (0..length).flat_map(move |z| (0..width).map(move |x| (y, z, x)))) {
        let mut index = at(x, y, z);
        while index > 127 {
            data.push(index as u8 | 128);
            index >>= 7;
        }
        data.push(index as u8);
    }
    let names: Vec<Vec<u8>> = names.iter().enumerate().map(|(index, name)| int(name, index as i32)).collect();
    let sizes = [short("Width", width), short("Height", height), short("Length", length)].concat();
    compound("Schematic", &[int("Version", 2), sizes, compound("Palette", &names), bytes("BlockData", &data)])
}

/// A region with chunks of the newest kind beside each other from (0, 0) on; those that are named are damaged in their compressed bytes.
pub fn region_of(count: usize, damaged: &[usize]) -> Vec<u8> {
    let mut file = vec![0; 8192];
    for chunk in 0..count {
        let mut packed = zlib(&chunk_1_18());
        if damaged.contains(&chunk) {
            let middle = packed.len() / 2;
            packed[middle] ^= 0x5a;
        }
        let sectors = (packed.len() + 5).div_ceil(4096);
        let place = file.len() / 4096;
        file[4 * chunk..4 * chunk + 4].copy_from_slice(&[0, 0, place as u8, sectors as u8]);
        file.extend((packed.len() as u32 + 1).to_be_bytes());
        file.push(2);
        file.extend(packed);
        file.resize((place + sectors) * 4096, 0);
    }
    file
}

fn vector(name: &str, [x, y, z]: [i32; 3]) -> Vec<u8> {
    compound(name, &[int("x", x), int("y", y), int("z", z)])
}

/// Width and length grow towards lower coordinates; the blocks are stored from the lowest corner all the same.
fn litematic() -> Vec<u8> {
    let [width, height, length] = SIZE.map(|edge| edge as i32);
    let states = longs("BlockStates", &gapless(&blocks(), 3));
    let region = [
        vector("Size", [-width, height, -length]),
        vector("Position", [7, 0, -3]),
        palette_list("BlockStatePalette"),
        states,
    ];
    compound("", &[int("Version", 6), compound("Regions", &[compound("Main", &region)])])
}

/// The states of the section whose lowest corner holds the build.
fn section() -> Vec<usize> {
    let at = |place: usize| (place % 16, place / 256, place / 16 % 16);
    let inside = |(x, y, z): (usize, usize, usize)| x < SIZE[0] && y < SIZE[1] && z < SIZE[2];
    (0..4096).map(at).map(|(x, y, z)| if inside((x, y, z)) { block_at(x, y, z) } else { 0 }).collect()
}

/// A region with one chunk, of the coordinates (2, 1) within it.
fn region(kind: u8, chunk: &[u8]) -> Vec<u8> {
    let mut file = vec![0; 8192];
    let sectors = (chunk.len() + 5).div_ceil(4096);
    let entry = 4 * (2 + 32);
    file[entry..entry + 4].copy_from_slice(&[0, 0, 2, sectors as u8]);
    file.extend((chunk.len() as u32 + 1).to_be_bytes());
    file.push(kind);
    file.extend(chunk);
    file.resize(8192 + sectors * 4096, 0);
    file
}

fn chunk_1_18() -> Vec<u8> {
    let states = section();
    let words: Vec<u64> =
        states.chunks(16).map(|part| part.iter().rev().fold(0, |word, &state| word << 4 | state as u64)).collect();
    let states = compound("block_states", &[palette_list("palette"), longs("data", &words)]);
    let height = named(1, "Y", vec![0xfc]);
    let air = compound(
        "block_states",
        &[list("palette", 10, &[[named(8, "Name", text("minecraft:air")), vec![0]].concat()])],
    );
    let sections = [[height, states, vec![0]].concat(), [named(1, "Y", vec![5]), air, vec![0]].concat()];
    compound("", &[int("DataVersion", 2975), int("xPos", 2), list("sections", 10, &sections)])
}

fn chunk_1_13() -> Vec<u8> {
    // Five bits each, so that some lie in two words.
    let mut palette = palette_list("Palette");
    let extra: Vec<u8> =
        (0..14).flat_map(|n| [named(8, "Name", text(&format!("mod:x{n}"))), vec![0]].concat()).collect();
    let count = palette.len() - palette_list("").len() + 3 + 1;
    palette[count..count + 4].copy_from_slice(&20i32.to_be_bytes());
    palette.extend(extra);
    let section = [named(1, "Y", vec![0]), palette, longs("BlockStates", &gapless(&section(), 5)), vec![0]].concat();
    compound("", &[int("DataVersion", 1631), compound("Level", &[list("Sections", 10, &[section])])])
}

fn chunk_1_12() -> Vec<u8> {
    let numbers: Vec<u8> = section().into_iter().map(|block| STATES[block].1).collect();
    let halves: Vec<u8> = section().chunks(2).map(|pair| STATES[pair[0]].2 | STATES[pair[1]].2 << 4).collect();
    let section = [named(1, "Y", vec![0]), bytes("Blocks", &numbers), bytes("Data", &halves), vec![0]].concat();
    compound("", &[compound("Level", &[list("Sections", 10, &[section])])])
}

/// Before 1.2: a column of 128 blocks for each x and z, y fastest.
fn chunk_1_1() -> Vec<u8> {
    let mut numbers = vec![0u8; 16 * 16 * 128];
    let mut data = vec![0u8; numbers.len() / 2];
    for (place, state) in section().into_iter().enumerate() {
        let at = (place % 16 * 16 + place / 16 % 16) * 128 + place / 256;
        numbers[at] = STATES[state].1;
        data[at / 2] |= STATES[state].2 << (at % 2 * 4);
    }
    compound("", &[compound("Level", &[int("xPos", 2), bytes("Blocks", &numbers), bytes("Data", &data)])])
}

/// What a structure block saves: a list of the blocks that are there.
fn structure() -> Vec<u8> {
    let ints = |values: [usize; 3]| values.map(|value| (value as i32).to_be_bytes()).concat();
    let mut items = Vec::new();
    for (place, state) in blocks().into_iter().enumerate().filter(|(_, state)| *state > 0) {
        let [x, z, y] = [place % SIZE[0], place / SIZE[0] % SIZE[2], place / (SIZE[0] * SIZE[2])];
        let at = named(9, "pos", [&[3, 0, 0, 0, 3][..], &ints([x, y, z])].concat());
        items.push([at, int("state", state as i32), vec![0]].concat());
    }
    let size = named(9, "size", [&[3, 0, 0, 0, 3][..], &ints(SIZE)].concat());
    compound("", &[size, list("entities", 10, &[]), palette_list("palette"), list("blocks", 10, &items)])
}

/// What a structure block of the Bedrock edition saves: the lowest byte first, z fastest, then y, then x.
fn bedrock() -> Vec<u8> {
    let named = |kind: u8, name: &str, payload: Vec<u8>| {
        [&[kind][..], &(name.len() as u16).to_le_bytes(), name.as_bytes(), &payload].concat()
    };
    let compound = |name: &str, entries: &[Vec<u8>]| named(10, name, [entries.concat(), vec![0]].concat());
    let text =
        |name: &str, value: &str| named(8, name, [&(value.len() as u16).to_le_bytes()[..], value.as_bytes()].concat());
    let ints = |values: &[i32]| {
        let numbers: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        [&[3][..], &(values.len() as i32).to_le_bytes(), &numbers].concat()
    };
    let items =
        |kind: u8, items: &[Vec<u8>]| [&[kind][..], &(items.len() as i32).to_le_bytes(), &items.concat()].concat();
    let entry = |name: &str| {
        // As of old: a block and its kind.
        let (name, key, kind) = match name {
            "minecraft:red_wool" => ("minecraft:wool", "color", "red"),
            "minecraft:oak_planks" => ("minecraft:planks", "wood_type", "oak"),
            name => (name, "pillar_axis", "y"),
        };
        [text("name", name), compound("states", &[text(key, kind)]), vec![0]].concat()
    };
    let palette: Vec<Vec<u8>> = STATES.iter().map(|(name, ..)| entry(name)).collect();
    let [width, height, length] = SIZE;
    let places = (0..width).flat_map(|x| (0..height).flat_map(move |y| (0..length).map(move |z| (x, y, z))));
    let indices: Vec<i32> = places.map(|(x, y, z)| block_at(x, y, z) as i32).collect();
    let layers = items(9, &[ints(&indices), ints(&vec![-1; indices.len()])]);
    let palette = compound("palette", &[compound("default", &[named(9, "block_palette", items(10, &palette))])]);
    let structure = compound("structure", &[named(9, "block_indices", layers), palette]);
    let version = named(3, "format_version", 1i32.to_le_bytes().to_vec());
    compound("", &[version, named(9, "size", ints(&SIZE.map(|edge| edge as i32))), structure])
}

/// LZ4 as lz4-java frames it, with literals alone.
fn lz4(bytes: &[u8]) -> Vec<u8> {
    let mut block = vec![0xf0];
    let mut left = bytes.len() - 15;
    while left >= 255 {
        block.push(255);
        left -= 255;
    }
    block.push(left as u8);
    block.extend(bytes);
    let head = |method: u8, packed: usize, length: usize| {
        let numbers = [packed as u32, length as u32, 0].map(u32::to_le_bytes).concat();
        [&b"LZ4Block"[..], &[method | 5], &numbers].concat()
    };
    [head(0x20, block.len(), bytes.len()), block, head(0x10, 0, 0)].concat()
}

/// Every format, with the name of its file.
pub fn minecraft() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("old.schematic", gzip(&schematic())),
        ("plain.schematic", schematic()),
        ("second.schem", gzip(&schem(2))),
        ("third.schem", zlib(&schem(3))),
        ("a.litematic", gzip(&litematic())),
        ("r.0.0.mca", region(2, &zlib(&chunk_1_18()))),
        ("lz4.mca", region(4, &lz4(&chunk_1_18()))),
        ("gzip.mca", region(1, &gzip(&chunk_1_13()))),
        ("raw.mca", region(3, &chunk_1_12())),
        ("old.mcr", region(2, &zlib(&chunk_1_1()))),
        ("structure.nbt", gzip(&structure())),
        ("bedrock.mcstructure", bedrock()),
    ]
}

/// Blocks whose shapes come from their states or from their neighbours, for the corpus.
pub fn shaped() -> Vec<(&'static str, Vec<u8>)> {
    let names = [
        "minecraft:air",
        "minecraft:oak_stairs[facing=east,half=top]",
        "minecraft:oak_fence",
        "minecraft:glass_pane",
        "minecraft:oak_door[facing=west,half=lower]",
        "minecraft:water[level=3]",
        "minecraft:candle[candles=3,lit=true,waterlogged=true]",
        "minecraft:wheat[age=5]",
    ];
    vec![("shapes.schem", gzip(&schem_of([4, 3, 3], &names, |x, y, z| (x * 5 + y * 3 + z * 2) % 8)))]
}

/// Colours of the states in the other formats.
pub const COLORS: [[u8; 3]; 6] =
    [[0; 3], [0x7d; 3], [0xa1, 0x27, 0x22], [0xa2, 0x83, 0x4f], [0xf6, 0xd0, 0x3d], [0xff, 0xd9, 0x8c]];

fn binvox() -> Vec<u8> {
    let [width, height, length] = SIZE;
    let mut file = format!("#binvox 1\ndim {width} {length} {height}\ntranslate 0 0 0\nscale 1\ndata\n").into_bytes();
    let places = (0..width).flat_map(|x| (0..length).flat_map(move |z| (0..height).map(move |y| (x, y, z))));
    let values: Vec<u8> = places.map(|(x, y, z)| u8::from(block_at(x, y, z) > 0)).collect();
    for run in values.chunk_by(|a, b| a == b) {
        file.extend([run[0], run.len() as u8]);
    }
    file
}

/// Colours of six bits, x slowest, z down and y to the viewer.
fn slab6() -> Vec<u8> {
    let [width, height, length] = SIZE;
    let mut file = SIZE.map(|_| 0u32.to_le_bytes()).concat();
    for (at, edge) in [width, length, height].into_iter().enumerate() {
        file[4 * at..4 * at + 4].copy_from_slice(&(edge as u32).to_le_bytes());
    }
    for (x, z) in (0..width).flat_map(|x| (0..length).map(move |z| (x, z))) {
        // An index of 0 is a colour.
        file.extend((0..height).rev().map(|y| (block_at(x, y, z) as u8).wrapping_sub(1)));
    }
    let colors: Vec<u8> = COLORS[1..].iter().flatten().map(|channel| channel >> 2).collect();
    file.extend(&colors);
    file.resize(file.len() + 768 - colors.len(), 0);
    file
}

/// The formats that have colours of their own, or none.
pub fn others() -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("plain.qb", binary(false, false, false)),
        ("bgra.qb", binary(true, true, false)),
        ("runs.qb", binary(false, true, true)),
        ("colors.qbt", tree(false)),
        ("palette.qbt", tree(true)),
        ("a.qbcl", project()),
        ("a.qef", exchange()),
        ("slab6.vox", slab6()),
        ("a.kv6", kv6()),
        ("a.kvx", kvx()),
        ("a.vxl", map()),
        ("a.gox", goxel(2)),
        ("old.gox", goxel(1)),
        ("a.binvox", binvox()),
    ]
}
