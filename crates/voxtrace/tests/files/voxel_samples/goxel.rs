//! The build in Goxel's format: the floor in one layer, what stands on it in a second, and a hidden one that fills everything.

use super::{COLORS, SIZE, block_at};

fn chunk(name: &[u8; 4], bytes: &[u8]) -> Vec<u8> {
    [&name[..], &(bytes.len() as u32).to_le_bytes(), bytes, &[0; 4]].concat()
}

/// A cube of 16 voxels along an edge as a picture.
fn cube(color_at: impl Fn(usize, usize, usize) -> Option<[u8; 3]>) -> Vec<u8> {
    let mut texels = Vec::new();
    for (z, y, x) in (0..16).flat_map(|z| (0..16).flat_map(move |y| (0..16).map(move |x| (z, y, x)))) {
        // What is nearly clear is no voxel.
        let [red, green, blue] = color_at(x, y, z).unwrap_or([9; 3]);
        texels.extend([red, green, blue, if color_at(x, y, z).is_some() { 255 } else { 100 }]);
    }
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 64, 64);
    encoder.set_color(png::ColorType::Rgba);
    encoder.write_header().unwrap().write_image_data(&texels).unwrap();
    chunk(b"BL16", &bytes)
}

fn layer(cube: u32, corner: [i32; 3], is_visible: bool) -> Vec<u8> {
    let mut bytes = [1u32.to_le_bytes(), cube.to_le_bytes()].concat();
    bytes.extend(corner.map(i32::to_le_bytes).as_flattened());
    bytes.extend([0; 4]);
    let entries: [(&[u8], &[u8]); 2] = [(b"name", b"layer"), (b"visible", &[u8::from(is_visible)])];
    for text in entries.iter().flat_map(|(name, value)| [name, value]) {
        bytes.extend((text.len() as u32).to_le_bytes());
        bytes.extend(*text);
    }
    bytes.extend([0; 4]);
    chunk(b"LAYR", &bytes)
}

/// x to the right, y away from the viewer, z up.
pub fn goxel(version: u32) -> Vec<u8> {
    let at = |x: usize, y: usize, z: usize| {
        let is_inside = x < SIZE[0] && y < SIZE[2] && z < SIZE[1];
        is_inside.then(|| block_at(x, z, SIZE[2] - 1 - y)).filter(|&block| block > 0).map(|block| COLORS[block])
    };
    // The first version says where the middle is.
    let corner = [-32, 16, 0].map(|c| if version == 1 { c + 8 } else { c });
    let floor = cube(|x, y, z| at(x, y, z).filter(|_| z == 0));
    let above = cube(|x, y, z| at(x, y, z).filter(|_| z > 0));
    let all = cube(|_, _, _| Some([1, 2, 3]));
    let layers = [layer(0, corner, true), layer(1, corner, true), layer(2, corner, false)].concat();
    let head = [&b"GOX "[..], &version.to_le_bytes()].concat();
    [head, chunk(b"IMG ", &[0; 4]), floor, above, all, layers, chunk(b"MATE", b"??")].concat()
}
