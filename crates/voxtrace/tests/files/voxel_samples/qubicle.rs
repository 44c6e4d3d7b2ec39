//! The small build in the four formats of Qubicle.

use super::{COLORS, SIZE, block_at};
use crate::zipped::zlib;

/// Two matrices side by side: the western half, and what is left.
pub fn binary(is_bgra: bool, is_away: bool, is_compressed: bool) -> Vec<u8> {
    let [width, height, length] = SIZE;
    let mut file = Vec::new();
    let header: [u32; 6] = [0x101, is_bgra.into(), is_away.into(), is_compressed.into(), 0, 2];
    file.extend(header.map(u32::to_le_bytes).concat());
    for (name, from, to) in [("west", 0, 2), ("east", 2, width)] {
        file.push(name.len() as u8);
        file.extend(name.bytes());
        let numbers = [to - from, height, length, from, 0, 0];
        file.extend(numbers.map(|value| (value as u32).to_le_bytes()).concat());
        for layer in 0..length {
            // z of the build points to the front.
            let z = if is_away { length - 1 - layer } else { layer };
            let places = (0..height).flat_map(|y| (from..to).map(move |x| (x, y)));
            let colors: Vec<u32> = places
                .map(|(x, y)| {
                    let block = block_at(x, y, z);
                    let [r, g, b] = COLORS[block];
                    let [first, third] = if is_bgra { [b, r] } else { [r, b] };
                    u32::from_le_bytes([first, g, third, if block > 0 { 255 } else { 0 }])
                })
                .collect();
            if !is_compressed {
                file.extend(colors.iter().flat_map(|color| color.to_le_bytes()));
                continue;
            }
            for run in colors.chunk_by(|a, b| a == b) {
                let words = if run.len() > 2 { vec![2, run.len() as u32, run[0]] } else { run.to_vec() };
                file.extend(words.iter().flat_map(|word| word.to_le_bytes()));
            }
            file.extend(6u32.to_le_bytes());
        }
    }
    file
}

fn words(values: &[u32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn text(text: &str) -> Vec<u8> {
    [&(text.len() as u32).to_le_bytes()[..], text.as_bytes()].concat()
}

/// The colour at a place with its mask: hidden inside of 1, else 127 and 0 for nothing.
fn color_at(x: usize, y: usize, z: usize) -> [u8; 4] {
    let block = block_at(x, y, z);
    let [r, g, b] = COLORS[block];
    [r, g, b, if block == 0 { 0 } else { 1 + (x + y + z) as u8 * 7 }]
}

/// The columns of a matrix from x `from` to `to`: x slowest, y fastest.
fn columns(from: usize, to: usize) -> impl Iterator<Item = (usize, usize)> {
    (from..to).flat_map(|x| (0..SIZE[2]).map(move |z| (x, z)))
}

/// A matrix of a tree: kind, bytes, name, place, scale, pivot, size, voxels.
fn tree_matrix(kind: u32, name: &str, from: usize, to: usize, has_palette: bool, parts: &[Vec<u8>]) -> Vec<u8> {
    let voxels = columns(from, to).flat_map(|(x, z)| (0..SIZE[1]).map(move |y| (x, y, z)));
    let voxels = voxels.flat_map(|(x, y, z)| {
        let [r, g, b, mask] = color_at(x, y, z);
        if has_palette { [block_at(x, y, z) as u8, 0, 0, mask] } else { [r, g, b, mask] }
    });
    let voxels = zlib(&voxels.collect::<Vec<u8>>());
    let size = [to - from, SIZE[1], SIZE[2]].map(|edge| edge as u32);
    let place = [from as u32, 0, 0, 1, 1, 1, 0, 0, 0];
    let mut body = [text(name), words(&place), words(&size), words(&[voxels.len() as u32]), voxels].concat();
    if kind == 2 {
        body.extend(words(&[parts.len() as u32]));
        body.extend(parts.concat());
    }
    [words(&[kind, body.len() as u32]), body].concat()
}

/// A group that holds a group with the western half, something of a kind to come, and a compound, whose part would be there twice.
pub fn tree(has_palette: bool) -> Vec<u8> {
    let group = |parts: &[Vec<u8>]| {
        let body = [words(&[parts.len() as u32]), parts.concat()].concat();
        [words(&[1, body.len() as u32]), body].concat()
    };
    let colors: Vec<u8> = COLORS.iter().flat_map(|&[r, g, b]| [r, g, b, 255]).collect();
    let (count, colors) = if has_palette { (COLORS.len(), colors) } else { (0, Vec::new()) };
    let part = tree_matrix(0, "part", 2, 4, has_palette, &[]);
    let root = group(&[
        group(&[tree_matrix(0, "west", 0, 2, has_palette, &[])]),
        [words(&[7, 5]), vec![0; 5]].concat(),
        tree_matrix(2, "east", 2, SIZE[0], has_palette, &[part]),
    ]);
    let head = [&b"QB 2\x01\0"[..], &words(&[1f32.to_bits(); 3])].concat();
    [head, b"COLORMAP".to_vec(), words(&[count as u32]), colors, b"DATATREE".to_vec(), root].concat()
}

/// A node of a project: kind, name, whether it is seen.
fn project_node(kind: u32, name: &str, is_visible: bool, body: &[u8]) -> Vec<u8> {
    [&words(&[kind, 1]), &text(name), &[is_visible.into(), 1, 0][..], body].concat()
}

fn project_matrix(from: usize, to: usize) -> Vec<u8> {
    let mut voxels = Vec::new();
    for (x, z) in columns(from, to) {
        let colors: Vec<[u8; 4]> = (0..SIZE[1]).map(|y| color_at(x, y, z)).collect();
        let runs = colors.chunk_by(|a, b| a == b).map(|run| match run.len() {
            1 => vec![run[0]],
            count => vec![[count as u8, 0, 0, 2], run[0]],
        });
        let column: Vec<[u8; 4]> = runs.flatten().collect();
        voxels.extend((column.len() as u16).to_le_bytes());
        voxels.extend(column.concat());
    }
    let voxels = zlib(&voxels);
    let size = [to - from, SIZE[1], SIZE[2]].map(|edge| edge as u32);
    [words(&size), words(&[from as u32, 0, 0, 0, 0, 0]), words(&[voxels.len() as u32]), voxels].concat()
}

pub fn project() -> Vec<u8> {
    let group = |parts: &[Vec<u8>]| [vec![0; 36], words(&[parts.len() as u32]), parts.concat()].concat();
    let part = project_node(0, "part", true, &project_matrix(2, 3));
    let compound = [project_matrix(2, SIZE[0]), words(&[1]), part].concat();
    let root = group(&[
        project_node(1, "half", true, &group(&[project_node(0, "west", true, &project_matrix(0, 2))])),
        project_node(0, "not there", false, &project_matrix(0, SIZE[0])),
        project_node(2, "east", true, &compound),
    ]);
    let texts: Vec<u8> = ["a build", "", "", "nobody", "", "", ""].iter().flat_map(|line| text(line)).collect();
    let head = [b"QBCL".to_vec(), words(&[0x0002_0103, 2, 2, 1]), vec![9; 8], texts, vec![0; 16]].concat();
    [head, project_node(1, "root", true, &root)].concat()
}

pub fn exchange() -> Vec<u8> {
    let [width, height, length] = SIZE;
    let mut file = format!("Qubicle Exchange Format\nVersion 0.2\nwww.minddesk.com\n{width} {length} {height}\n");
    file += &format!("{}\n", COLORS.len());
    for color in COLORS {
        let [r, g, b] = color.map(|channel| f32::from(channel) / 255.0);
        file += &format!("{r:.6} {g:.6} {b:.6}\n");
    }
    for (x, y, z) in columns(0, width).flat_map(|(x, z)| (0..height).map(move |y| (x, y, z))) {
        let block = block_at(x, y, z);
        if block > 0 {
            file += &format!("{x} {z} {y} {block} 126\n");
        }
    }
    file.into_bytes()
}
