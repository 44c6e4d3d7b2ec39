//! OpenEXR pictures, by the crate `exr`: the first layer that has R, G and B.

use super::{Picture, check_size};
use exr::prelude::{MetaData, ReadChannels, ReadLayers, read};
use std::io::Cursor;
use voxtrace_scene::glam::Vec3;
use voxtrace_voxelize::Limits;

/// The pixels of an OpenEXR.
///
/// # Errors
/// One sentence about what is wrong.
pub fn decode(bytes: &[u8], limits: &Limits) -> Result<Picture, String> {
    let text = |error: exr::error::Error| format!("OpenEXR: {error}");
    // Sizes are looked at before anything of them is allocated.
    let headers = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(text)?.headers;
    for header in &headers {
        check_size(header.layer_size.x(), header.layer_size.y(), bytes.len(), limits)?;
    }
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            |size, _| Picture { width: size.x(), height: size.y(), pixels: vec![Vec3::ZERO; size.x() * size.y()] },
            |picture, at, (red, green, blue): (f32, f32, f32)| {
                let place = at.y() * picture.width + at.x();
                picture.pixels[place] = Vec3::new(red, green, blue);
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_buffered(Cursor::new(bytes))
        .map_err(text)?;
    Ok(image.layer_data.channel_data.pixels)
}
