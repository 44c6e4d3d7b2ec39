//! Small pictures of the built-in scenes for the welcome. They are part of the program, 76 kB together: rendering them at the start would take
//! the processor from the first picture, and a cache would have to be kept right. `cargo xtask pictures thumbnails` renders them.

use egui::{ColorImage, Context, Id, TextureHandle, TextureOptions};
use std::io::Cursor;

/// Names of scenes and their PNG files.
const FILES: [(&str, &[u8]); 4] = [
    ("city", include_bytes!("../thumbnails/city.png")),
    ("operating-room", include_bytes!("../thumbnails/operating-room.png")),
    ("church", include_bytes!("../thumbnails/church.png")),
    ("forest", include_bytes!("../thumbnails/forest.png")),
];

/// The picture of a built-in scene, decoded once for each window.
pub fn thumbnail(context: &Context, scene: &str) -> Option<TextureHandle> {
    let (name, bytes) = FILES.iter().find(|(name, _)| *name == scene)?;
    let id = Id::new(("thumbnail", name));
    if let Some(texture) = context.data(|data| data.get_temp::<TextureHandle>(id)) {
        return Some(texture);
    }
    let texture = context.load_texture(*name, decoded(bytes)?, TextureOptions::LINEAR);
    context.data_mut(|data| data.insert_temp(id, texture.clone()));
    Some(texture)
}

fn decoded(bytes: &[u8]) -> Option<ColorImage> {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut pixels).ok()?;
    let size = [info.width as usize, info.height as usize];
    let is_rgb = (info.color_type, info.bit_depth) == (png::ColorType::Rgb, png::BitDepth::Eight);
    is_rgb.then(|| ColorImage::from_rgb(size, &pixels[..info.buffer_size()]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_scene_has_a_small_picture() {
        let names: Vec<&str> = FILES.iter().map(|(name, _)| *name).collect();
        assert_eq!(names, voxtrace::scenes::NAMES);
        assert!(FILES.iter().map(|(_, bytes)| bytes.len()).sum::<usize>() <= 80_000);
        for (name, bytes) in FILES {
            let picture = decoded(bytes).unwrap();
            assert_eq!(picture.size, [112, 70], "{name}");
            assert!(picture.pixels.iter().any(|pixel| *pixel != picture.pixels[0]));
            assert!(decoded(&bytes[..bytes.len() / 2]).is_none(), "half a file is no picture");
        }
        let context = Context::default();
        assert_eq!(thumbnail(&context, "city").unwrap().id(), thumbnail(&context, "city").unwrap().id());
        assert!(thumbnail(&context, "nowhere").is_none());
    }
}
