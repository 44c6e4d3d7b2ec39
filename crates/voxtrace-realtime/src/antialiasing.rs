//! Temporal antialiasing: where something moves, a picture is averaged with those before it, in which each pixel is found again where its middle was. What they showed,
//! the history, is held within the colours around the pixel now, so that nothing trails behind what moves: variance clipping, by axes (Salvi, "An Excursion in Temporal Supersampling", GDC 2016; Karis,
//! "High Quality Temporal Supersampling", SIGGRAPH 2014).

use crate::memory::Memory;
use glam::Vec3;
use rayon::prelude::*;

/// Share of the newest picture while something moves, and in the first frame after that: what is seen does not jump where it comes to rest.
const SHARES: [f32; 2] = [1.0 / 3.0, 0.5];
/// The same of pixels in which nothing moved: they show what they did, and its light follows the sooner.
const KEPT_SHARE: f32 = 0.5;
/// How many standard deviations from the mean of the colours around, on either side, what was shown may be.
const SHOWN_REACH: f32 = 1.5;
/// Largest channel that a word holds.
const SHOWN_MOST: f32 = 65_408.0;

/// Frames since something moved.
#[derive(Clone, Copy)]
pub(crate) struct Rest(usize);

impl Rest {
    /// Nothing has moved for so long that pictures are not averaged.
    pub(crate) const LONG: Self = Self(SHARES.len());

    /// After a frame in which something moved, in which nothing did, or in which light changed where it stood.
    pub(crate) fn after(self, is_in_motion: bool, is_still: bool) -> Self {
        match (is_in_motion, is_still) {
            (true, _) => Self(0),
            (false, true) => Self((self.0 + 1).min(SHARES.len())),
            (false, false) => Self::LONG,
        }
    }

    /// Share of the newest picture in what is shown.
    pub(crate) fn share(self) -> f32 {
        SHARES.get(self.0).copied().unwrap_or(1.0)
    }
}

/// The picture, `width` pixels in a row, averaged with what each pixel remembers of what was shown; `share` is that of the new one. Where pixels that show nothing that moved
/// `keep` what they know, their history is whole: nothing can trail there but light.
pub(crate) fn antialiased(memory: &[Memory], picture: &[Vec3], width: usize, share: f32, keep: bool) -> Vec<Vec3> {
    let colors: Vec<Vec3> = picture.par_iter().map(|color| ycocg(*color)).collect();
    let pixel = |index: usize| {
        if memory[index].shown == 0 {
            return picture[index];
        }
        if keep && memory[index].is_kept() {
            let shown = shown_in(memory[index].shown);
            return shown + (picture[index] - shown) * KEPT_SHARE;
        }
        let (x, y) = (index % width, index / width);
        let (mut sum, mut squares, mut count) = (Vec3::ZERO, Vec3::ZERO, 0.0);
        for y in y.saturating_sub(1)..=(y + 1).min(picture.len() / width - 1) {
            for color in &colors[y * width..][x.saturating_sub(1)..=(x + 1).min(width - 1)] {
                sum += color;
                squares += color * color;
                count += 1.0;
            }
        }
        let mean = sum / count;
        let reach = SHOWN_REACH * (squares / count - mean * mean).max(Vec3::ZERO).map(f32::sqrt);
        let shown = ycocg(shown_in(memory[index].shown)).clamp(mean - reach, mean + reach);
        rgb(shown + (colors[index] - shown) * share).max(Vec3::ZERO)
    };
    (0..picture.len()).into_par_iter().map(pixel).collect()
}

/// A colour in a word: nine bits a channel, and the exponent of the largest, as Vulkan's format E5B9G9R9 has them. Never 0, which is none.
pub(crate) fn word_of(color: Vec3) -> u32 {
    let color = color.clamp(Vec3::ZERO, Vec3::splat(SHOWN_MOST));
    // The largest channel is below 2 to the power of this.
    let exponent = ((color.max_element().to_bits() >> 23) as i32 - 126).max(-15);
    let scale = f32::from_bits(((136 - exponent) as u32) << 23);
    let [r, g, b] = (color * scale + 0.5).to_array().map(|part| (part as u32).min(511));
    (r | g << 9 | b << 18 | ((exponent + 15) as u32) << 27).max(1 << 27)
}

/// The colour in a word.
pub(crate) fn shown_in(word: u32) -> Vec3 {
    let parts = [word & 511, word >> 9 & 511, word >> 18 & 511];
    Vec3::from(parts.map(|part| part as f32)) * f32::from_bits((103 + (word >> 27)) << 23)
}

/// YCoCg: brightness, orange against blue, and green against both (Malvar and Sullivan, "YCoCg-R", JVT-I014, 2003).
fn ycocg(color: Vec3) -> Vec3 {
    let (r, g, b) = color.into();
    Vec3::new(0.25 * r + 0.5 * g + 0.25 * b, 0.5 * (r - b), 0.5 * g - 0.25 * (r + b))
}

/// The colour of that.
fn rgb(color: Vec3) -> Vec3 {
    let (y, co, cg) = color.into();
    Vec3::new(y + co - cg, y + cg, y - co - cg)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_hold_colours_to_nine_bits_and_are_never_0() {
        for color in [[0.0, 0.0, 0.0], [1e-7, 0.0, 0.0], [1.0, 0.5, 0.25], [0.9999, 0.3, 0.0], [65_408.0, 1.0, 3e4]] {
            let color = Vec3::from_array(color);
            let word = word_of(color);
            let most = color.max_element() / 256.0 + 1e-7;
            assert!(word != 0 && shown_in(word).abs_diff_eq(color, most), "{color}: {}", shown_in(word));
            assert_eq!(word_of(shown_in(word)), word, "{color}");
        }
        assert_eq!(shown_in(word_of(Vec3::new(f32::INFINITY, -1.0, 0.0))), Vec3::new(65_408.0, 0.0, 0.0));
        let color = Vec3::new(3.0, 0.2, 1.0);
        assert!(rgb(ycocg(color)).abs_diff_eq(color, 1e-6));
    }

    #[test]
    fn what_was_shown_counts_where_it_is_among_the_colours_around() {
        // A chequer of 0 and 1, before which a grey, a light of 50, and nothing were shown.
        let picture: Vec<Vec3> = (0..25).map(|index| Vec3::splat((index % 2) as f32)).collect();
        let of = |shown: u32| {
            let memory = vec![Memory { shown, ..Memory::default() }; 25];
            antialiased(&memory, &picture, 5, SHARES[0], false)[12].x
        };
        assert!((of(word_of(Vec3::splat(0.5))) - 1.0 / 3.0).abs() < 2e-3);
        let bright = of(word_of(Vec3::splat(50.0)));
        assert!((0.5..1.0).contains(&bright), "a ghost: {bright}");
        assert_eq!(of(0), 0.0);
        // Where nothing moved all of it counts.
        let kept = |is_at_rest: bool, looks: f32| {
            let shown = word_of(Vec3::splat(50.0));
            let memory = vec![Memory { shown, is_at_rest, looks, ..Memory::default() }; 25];
            antialiased(&memory, &picture, 5, SHARES[0], true)[12].x
        };
        assert_eq!(kept(true, 5.0), 25.0);
        assert_eq!([kept(false, 5.0), kept(true, 4.0)], [bright; 2], "this frame alone has looked");
    }

    #[test]
    fn pictures_are_averaged_in_motion_and_in_the_frame_after() {
        let moved = Rest::LONG.after(true, false);
        let next = moved.after(false, true);
        let shares = [Rest::LONG, moved, next, next.after(false, true), moved.after(false, false)].map(Rest::share);
        assert_eq!(shares, [1.0, 1.0 / 3.0, 0.5, 1.0, 1.0]);
    }
}
