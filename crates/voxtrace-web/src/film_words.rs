//! The words of films as they travel between workers: 32 bytes a pixel, row by row, as in film files (`docs/film-format.md`): the sums of red, green and
//! blue as 64-bit integers in units of 2⁻³², the number of samples, and that of those which met a voxel; little-endian.

use voxtrace_core::film::{Film, Pixel};
use voxtrace_core::frame::Frame;
use voxtrace_io::output::{Operator, ToneBytes, ToneMap};
use wasm_bindgen::prelude::*;

/// The words of a film's pixels.
pub fn film_words(film: &Film) -> Vec<u8> {
    bytemuck::cast_slice(&film.pixels).to_vec()
}

/// The film of a frame's region with the pixels of `words`; empty words make a black film. `None` where they do not fit the region.
pub fn film_from_words(frame: &Frame, words: &[u8]) -> Option<Film> {
    let mut film = Film::new(frame.width, frame.height, frame.region, frame.first_sample);
    if words.is_empty() {
        return Some(film);
    }
    if words.len() != size_of_val(film.pixels.as_slice()) {
        return None;
    }
    bytemuck::cast_slice_mut(&mut film.pixels).copy_from_slice(words);
    Some(film)
}

/// What a screen shows of a film's words: red, green, blue and alpha of sRGB, a byte each, by the tone mapping of pictures that are saved, `exposure`
/// in stops.
///
/// # Errors
/// Where the words are not those of whole pixels or there is no such operator.
#[wasm_bindgen]
pub fn shown(words: &[u8], operator: &str, exposure: f32) -> Result<Vec<u8>, JsError> {
    const PIXEL: usize = size_of::<Pixel>();
    let operator = Operator::ALL.into_iter().find(|known| known.name() == operator);
    let operator = operator.ok_or_else(|| {
        let names = Operator::ALL.map(Operator::name).join(", ");
        JsError::new(&format!("there is no such tone mapping; there are {names}"))
    })?;
    if !words.len().is_multiple_of(PIXEL) {
        return Err(JsError::new("the film's words are not those of whole pixels"));
    }
    let tone = ToneBytes::new(ToneMap { operator, exposure });
    let pixels = words.chunks_exact(PIXEL).flat_map(|words| {
        let pixel: Pixel = bytemuck::pod_read_unaligned(words);
        let [red, green, blue] = tone.of(pixel.mean());
        [red, green, blue, u8::MAX]
    });
    Ok(pixels.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_core::Region;
    use voxtrace_scene::{Camera, glam::Vec3};

    fn frame() -> Frame {
        let frame = Frame::new(Camera::look_at(Vec3::NEG_Y, Vec3::ZERO), 8, 6);
        frame.region(Region { x0: 0, y0: 2, x1: 8, y1: 4 })
    }

    #[test]
    fn a_film_comes_back_from_its_words_as_it_was() {
        let mut film = film_from_words(&frame(), &[]).unwrap();
        for (pixel, number) in film.pixels.iter_mut().zip(1..) {
            pixel.add(Vec3::new(0.5, 1.5, 2.5) * number as f32, number % 2 == 0);
        }
        let words = film_words(&film);
        assert_eq!(words.len(), 8 * 2 * 32);
        assert_eq!(film_from_words(&frame(), &words).as_ref(), Some(&film));
        let mut other = words.clone();
        other[0] ^= 1;
        assert_ne!(film_from_words(&frame(), &other).as_ref(), Some(&film));
        assert!(film_from_words(&frame(), &words[1..]).is_none(), "words of another region");
    }

    #[test]
    fn what_is_shown_is_what_pictures_have() {
        let mut pixel = Pixel::default();
        pixel.add(Vec3::new(0.2, 0.02, 3.0), true);
        let signal = ToneMap { operator: Operator::Agx, exposure: 1.0 }.signal(pixel.mean());
        let expected = signal.to_array().map(|value| (value * 255.0).round() as u8);
        let bytes = shown(bytemuck::bytes_of(&pixel), "agx", 1.0).unwrap();
        assert_eq!((&bytes[..3], bytes[3]), (&expected[..], 255));
        assert_ne!(shown(bytemuck::bytes_of(&pixel), "agx", 0.0).unwrap(), bytes);
    }
}
