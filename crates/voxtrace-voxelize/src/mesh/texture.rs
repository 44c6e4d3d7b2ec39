//! Textures with mipmaps: sRGB texels with alpha, filtered bilinearly in linear light at the mip level that suits the footprint
//! (Williams, "Pyramidal Parametrics", SIGGRAPH 1983).

use glam::{Vec2, Vec3, Vec4};
use std::sync::LazyLock;
use voxtrace_scene::material::{linear_from_srgb, srgb_from_linear};

/// Wrap mode: the texel for coordinates outside [0, 1].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wrap {
    /// The texture repeats.
    #[default]
    Repeat,
    /// The texture repeats, mirrored every second time.
    Mirror,
    /// Coordinates are clamped to the edge.
    Clamp,
}

/// A texture of sRGB texels with linear alpha, row by row from the top, and its mip levels.
#[derive(Clone, PartialEq)]
pub struct Texture {
    levels: Vec<Level>,
}

#[derive(Clone, PartialEq)]
struct Level {
    width: u32,
    height: u32,
    texels: Vec<[u8; 4]>,
}

static LINEAR: LazyLock<[f32; 256]> = LazyLock::new(|| std::array::from_fn(|byte| linear_from_srgb(byte as u8)));

impl Texture {
    /// A texture from its texels; `None` where their number is not `width` × `height` ≥ 1.
    pub fn new(width: u32, height: u32, texels: Vec<[u8; 4]>) -> Option<Self> {
        let count = u64::from(width) * u64::from(height);
        if count == 0 || count != texels.len() as u64 {
            return None;
        }
        let mut levels = vec![Level { width, height, texels }];
        while let Some(smaller) = levels.last().and_then(Level::halved) {
            levels.push(smaller);
        }
        Some(Self { levels })
    }

    /// Width and height in texels.
    pub fn size(&self) -> [u32; 2] {
        [self.levels[0].width, self.levels[0].height]
    }

    /// The texels, row by row from the top.
    pub fn texels(&self) -> &[[u8; 4]] {
        &self.levels[0].texels
    }

    /// Bytes of all mip levels.
    pub fn size_bytes(&self) -> usize {
        self.levels.iter().map(|level| size_of_val(&*level.texels)).sum()
    }

    /// Linear colour and alpha at `uv`, (0, 0) at the top left corner, filtered over an area of about `footprint` texels.
    pub fn sample(&self, uv: Vec2, wrap: [Wrap; 2], nearest: bool, footprint: f32) -> Vec4 {
        let level = if footprint > 1.0 { (footprint.log2() * 0.5) as usize } else { 0 };
        let level = &self.levels[level.min(self.levels.len() - 1)];
        let size = Vec2::new(level.width as f32, level.height as f32);
        // Coordinates that are not finite, or too large to have a fraction, become 0.
        let uv = Vec2::select((uv.abs()).cmplt(Vec2::splat(1e6)), uv, Vec2::ZERO);
        if nearest {
            let at = (uv * size).floor();
            return level.texel(at.x as i64, at.y as i64, wrap);
        }
        let at = uv * size - 0.5;
        let corner = at.floor();
        let part = at - corner;
        let (x, y) = (corner.x as i64, corner.y as i64);
        let top = level.texel(x, y, wrap).lerp(level.texel(x + 1, y, wrap), part.x);
        let bottom = level.texel(x, y + 1, wrap).lerp(level.texel(x + 1, y + 1, wrap), part.x);
        top.lerp(bottom, part.y)
    }
}

impl Level {
    fn texel(&self, x: i64, y: i64, wrap: [Wrap; 2]) -> Vec4 {
        let (x, y) = (wrapped(x, self.width, wrap[0]), wrapped(y, self.height, wrap[1]));
        linear_of(self.texels[y * self.width as usize + x])
    }

    /// The next mip level; `None` after that of one texel. Colours are weighted by alpha.
    fn halved(&self) -> Option<Self> {
        if self.width == 1 && self.height == 1 {
            return None;
        }
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let mut texels = Vec::with_capacity(width as usize * height as usize);
        let columns: Vec<Taps> = (0..width).map(|x| Taps::of(x, self.width)).collect();
        for y in 0..height {
            let rows = Taps::of(y, self.height);
            for columns in &columns {
                let (mut color, mut plain, mut alpha) = (Vec3::ZERO, Vec3::ZERO, 0.0);
                for (row, of_row) in rows.iter() {
                    for (column, of_column) in columns.iter() {
                        let texel = linear_of(self.texels[row as usize * self.width as usize + column as usize]);
                        let weight = of_row * of_column;
                        color += texel.truncate() * (texel.w * weight);
                        plain += texel.truncate() * weight;
                        alpha += texel.w * weight;
                    }
                }
                let color = if alpha > 0.0 { color / alpha } else { plain };
                let [r, g, b] = color.to_array().map(srgb_from_linear);
                texels.push([r, g, b, (alpha * 255.0).round() as u8]);
            }
        }
        Some(Self { width, height, texels })
    }
}

/// The texels along an axis of which one of the next mip level is the mean, and their shares.
struct Taps {
    first: u32,
    shares: [f32; 3],
    count: usize,
}

impl Taps {
    /// Those of texel `at` where there are `size` texels. Of an odd number each is a part of one or of two that are a little wider than two.
    fn of(at: u32, size: u32) -> Self {
        if size == 1 {
            return Self { first: 0, shares: [1.0, 0.0, 0.0], count: 1 };
        }
        if size.is_multiple_of(2) {
            return Self { first: 2 * at, shares: [0.5, 0.5, 0.0], count: 2 };
        }
        let shares = [size / 2 - at, size / 2, at + 1].map(|part| part as f32 / size as f32);
        Self { first: 2 * at, shares, count: 3 }
    }

    fn iter(&self) -> impl Iterator<Item = (u32, f32)> {
        (self.first..).zip(self.shares).take(self.count)
    }
}

fn linear_of([r, g, b, a]: [u8; 4]) -> Vec4 {
    let linear = |byte: u8| LINEAR[usize::from(byte)];
    Vec4::new(linear(r), linear(g), linear(b), f32::from(a) / 255.0)
}

fn wrapped(at: i64, size: u32, wrap: Wrap) -> usize {
    let size = i64::from(size);
    // Most texels are inside, and divisions are slow.
    if (0..size).contains(&at) {
        return at as usize;
    }
    let inside = match wrap {
        Wrap::Repeat => at.rem_euclid(size),
        Wrap::Clamp => at.clamp(0, size - 1),
        Wrap::Mirror => {
            let at = at.rem_euclid(2 * size);
            if at < size { at } else { 2 * size - 1 - at }
        }
    };
    inside as usize
}

impl std::fmt::Debug for Texture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [width, height] = self.size();
        write!(f, "[{width} x {height} texels]")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_by_two() -> Texture {
        let texels = vec![[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255], [255, 255, 255, 0]];
        Texture::new(2, 2, texels).unwrap()
    }

    #[test]
    fn the_middle_of_a_texel_is_that_texel_and_between_two_is_their_mean_in_linear_light() {
        let texture = two_by_two();
        let sample = |u, v| texture.sample(Vec2::new(u, v), [Wrap::Clamp; 2], false, 0.0);
        assert_eq!(sample(0.25, 0.25), Vec4::new(1.0, 0.0, 0.0, 1.0));
        assert_eq!(sample(0.25, 0.75), Vec4::new(0.0, 0.0, 1.0, 1.0));
        assert_eq!(sample(0.5, 0.25), Vec4::new(0.5, 0.5, 0.0, 1.0));
    }

    #[test]
    fn each_wrap_mode_continues_the_picture_in_its_way() {
        let texture = two_by_two();
        let green_or_red = |u, wrap| {
            let sample = texture.sample(Vec2::new(u, 0.25), [wrap; 2], true, 0.0);
            if sample.y > 0.5 { 'g' } else { 'r' }
        };
        let row = |wrap| [-0.75, -0.25, 0.25, 0.75, 1.25, 1.75].map(|u| green_or_red(u, wrap));
        assert_eq!(row(Wrap::Repeat), ['r', 'g', 'r', 'g', 'r', 'g']);
        assert_eq!(row(Wrap::Mirror), ['g', 'r', 'r', 'g', 'g', 'r']);
        assert_eq!(row(Wrap::Clamp), ['r', 'r', 'r', 'g', 'g', 'g']);
    }

    #[test]
    fn a_large_footprint_sees_the_mean_without_what_is_transparent() {
        let mean = two_by_two().sample(Vec2::splat(0.5), [Wrap::Repeat; 2], false, 4.0);
        assert!((mean - Vec4::new(1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 0.75)).abs().max_element() < 0.01, "{mean}");
    }

    #[test]
    fn a_mean_has_all_texels_of_a_texture_whose_size_is_odd() {
        let [red, green, blue] = [[255, 0, 0, 255], [0, 255, 0, 255], [0, 0, 255, 255]];
        let far = |width, height, texels: &[[u8; 4]]| {
            let texture = Texture::new(width, height, texels.to_vec()).unwrap();
            texture.sample(Vec2::splat(0.5), [Wrap::Clamp; 2], false, 1e4)
        };
        for mean in [far(3, 1, &[red, green, blue]), far(1, 3, &[blue, red, green])] {
            assert!((mean - Vec4::new(1.0, 1.0, 1.0, 3.0) / 3.0).abs().max_element() < 0.01, "{mean}");
        }
        // Ramps of any length have the mean of their ends.
        for count in 1..40u32 {
            let grey: Vec<[u8; 4]> =
                (0..count).map(|at| [255, 255, 255, ((at * 2 + 1) * 255 / (2 * count)) as u8]).collect();
            assert!((far(count, 1, &grey).w - 0.5).abs() < 0.02, "{count}: {}", far(count, 1, &grey).w);
        }
    }

    #[test]
    fn coordinates_that_are_no_numbers_are_harmless() {
        for uv in [Vec2::NAN, Vec2::INFINITY, Vec2::splat(1e30)] {
            assert!(two_by_two().sample(uv, [Wrap::Repeat; 2], false, f32::NAN).is_finite());
        }
    }
}
