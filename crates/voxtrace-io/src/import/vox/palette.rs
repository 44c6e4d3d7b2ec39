//! MagicaVoxel's default palette, which holds where a file has no RGBA chunk.

/// The colours of indices 1 to 255 (entry i is index i + 1; entry 255 is unused): a 6×6×6 cube of web colours from white
/// downwards, blue fastest and without its black corner, then ramps of red, green, blue and grey between the cube's steps.
pub fn default_palette() -> [[u8; 4]; 256] {
    let cube = (0..215u32).map(|i| [i / 36, i / 6 % 6, i % 6].map(|step| 0xff - 0x33 * step as u8));
    let ramp = [0xee, 0xdd, 0xbb, 0xaa, 0x88, 0x77, 0x55, 0x44, 0x22, 0x11];
    let ramps = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
        .into_iter()
        .flat_map(|hue| ramp.into_iter().map(move |value| hue.map(|channel| channel * value)));
    let mut palette = [[0; 4]; 256];
    for (entry, [r, g, b]) in palette.iter_mut().zip(cube.chain(ramps)) {
        *entry = [r, g, b, 0xff];
    }
    palette
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_palette_has_its_known_colors() {
        let palette = default_palette();
        for (index, color) in [
            (1, [0xff, 0xff, 0xff]),
            (2, [0xff, 0xff, 0xcc]),
            (7, [0xff, 0xcc, 0xff]),
            (37, [0xcc, 0xff, 0xff]),
            (215, [0x00, 0x00, 0x33]),
            (216, [0xee, 0x00, 0x00]),
            (226, [0x00, 0xee, 0x00]),
            (236, [0x00, 0x00, 0xee]),
            (246, [0xee, 0xee, 0xee]),
            (255, [0x11, 0x11, 0x11]),
        ] {
            assert_eq!(palette[index - 1][..3], color, "index {index}");
        }
        assert_eq!(palette[255], [0; 4]);
    }
}
