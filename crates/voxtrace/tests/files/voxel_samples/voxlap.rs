//! The build in Ken Silverman's formats, whose z points down and y to the viewer.

use super::{COLORS, SIZE, block_at};

/// The places of a column from the top down, with their blocks.
fn column(x: usize, y: usize) -> Vec<(u8, usize)> {
    let height = SIZE[1];
    let places = (0..height).map(|z| (z as u8, block_at(x, height - 1 - z, y)));
    places.filter(|(_, block)| *block > 0).collect()
}

/// All columns, x slowest.
fn columns() -> impl Iterator<Item = Vec<(u8, usize)>> {
    (0..SIZE[0]).flat_map(|x| (0..SIZE[2]).map(move |y| column(x, y)))
}

fn sizes() -> Vec<u8> {
    [SIZE[0], SIZE[2], SIZE[1]].map(|edge| (edge as u32).to_le_bytes()).concat()
}

/// Blue, green, red, and a byte that says nothing.
fn bgr(block: usize) -> [u8; 4] {
    let [red, green, blue] = COLORS[block];
    [blue, green, red, 0x80]
}

pub fn kv6() -> Vec<u8> {
    let count: usize = columns().map(|column| column.len()).sum();
    let mut file = [&b"Kvxl"[..], &sizes(), &[0; 12], &(count as u32).to_le_bytes()].concat();
    for (z, block) in columns().flatten() {
        file.extend(bgr(block));
        file.extend([z, 0, 63, 0]);
    }
    let layer = |x: usize| (0..SIZE[2]).map(|y| column(x, y).len() as u32).sum::<u32>();
    file.extend((0..SIZE[0]).flat_map(|x| layer(x).to_le_bytes()));
    file.extend(columns().flat_map(|column| (column.len() as u16).to_le_bytes()));
    file
}

/// Each voxel is a slab of its own where that tells the directions apart, and the lowest of the palettes says nothing.
pub fn kvx() -> Vec<u8> {
    let (mut offsets, mut places, mut slabs) = (Vec::new(), Vec::new(), Vec::<u8>::new());
    let head = 4 * (SIZE[0] + 1) + 2 * SIZE[0] * (SIZE[2] + 1);
    for x in 0..SIZE[0] {
        let start = slabs.len();
        offsets.push((head + start) as u32);
        for y in 0..SIZE[2] {
            places.push((slabs.len() - start) as u16);
            let column = column(x, y);
            for run in column.chunk_by(|a, b| a.0 + 1 == b.0 && x > 0) {
                slabs.extend([run[0].0, run.len() as u8, 63]);
                slabs.extend(run.iter().map(|(_, block)| *block as u8));
            }
        }
        places.push((slabs.len() - start) as u16);
    }
    offsets.push((head + slabs.len()) as u32);
    let mut model = [sizes(), vec![0; 12]].concat();
    model.extend(offsets.iter().flat_map(|offset| offset.to_le_bytes()));
    model.extend(places.iter().flat_map(|place| place.to_le_bytes()));
    model.extend(slabs);
    let mut file = [&(model.len() as u32).to_le_bytes()[..], &model].concat();
    // A model of half the resolution, which is not read.
    file.extend([4u32, 0].map(u32::to_le_bytes).concat());
    let mut palette: Vec<u8> = COLORS.iter().flatten().map(|channel| channel >> 2).collect();
    palette.resize(768, 0);
    file.extend(palette);
    file
}

/// A map with a header: of each column the run that is seen, down to the bottom.
pub fn map() -> Vec<u8> {
    let mut file = [0x0907_2000, SIZE[0] as u32, SIZE[2] as u32].map(u32::to_le_bytes).concat();
    file.resize(12 + 96, 0);
    for (x, y) in (0..SIZE[2]).flat_map(|y| (0..SIZE[0]).map(move |x| (x, y))) {
        let column = column(x, y);
        let first = 64 - SIZE[1] as u8 + column[0].0;
        file.extend([0, first, 63, 0]);
        file.extend(column.iter().flat_map(|(_, block)| bgr(*block)));
    }
    file
}
