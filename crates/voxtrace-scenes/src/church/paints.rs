//! The church's colours: ramps of stone, wood, tile and metal, the glass and the lights, and the paints made of them.

use super::glass;
use crate::kit::{noise::*, patterns::*, *};
use glam::{IVec3, Vec2, Vec3, vec2};

/// Radiance of white glass in daylight, before the scene's light intensity.
const DAYLIGHT: f32 = 4.6;
/// Radiance of white glass that the sun shines on.
const SUNLIGHT: f32 = 32.0;
/// Radiance of flames of [`FLAME`] radius.
const LAMPLIGHT: f32 = 220.0;
/// Radius of a flame, metres, where voxels are small enough.
pub const FLAME: f32 = 0.024;

/// Every paint of the church.
pub struct Paints {
    pub ashlar: Paint,
    pub dressed: Paint,
    pub carved: Paint,
    pub vault: Paint,
    pub floor: Paint,
    pub steps: Paint,
    pub oak: Paint,
    pub oak_across: Paint,
    pub oak_upright: Paint,
    pub walnut: Paint,
    pub brass: Paint,
    pub gilded: Paint,
    pub iron: Paint,
    pub pipes: Paint,
    pub marble: Paint,
    /// Dark tablets with gilded lettering.
    pub slate: Paint,
    pub linen: Paint,
    pub carpet: Paint,
    pub frontal: Paint,
    pub kneelers: Paint,
    pub books: Paint,
    pub leaves: Paint,
    pub flowers: Paint,
    pub wax: Paint,
    pub flame: Paint,
    pub lamp: Paint,
    pub votive: Paint,
    pub flood: Paint,
    pub east_glass: Paint,
    pub aisle_glass: Paint,
    pub north_glass: Paint,
    pub south_glass: Paint,
    pub rose_glass: Paint,
}

impl Paints {
    /// The paints, and the palette that they use.
    pub fn new(voxel: f32) -> (Self, Palette) {
        // Where voxels make flames larger than they should be, they are dimmer: the light stays the same.
        let share = (FLAME / super::lights::flame_radius(voxel)).powi(2);
        let mut palette = Palette::default();
        let stone = palette.ramp(&[[156, 140, 115], [185, 169, 142], [210, 196, 168]], 16);
        let web = palette.ramp(&[[176, 162, 136], [200, 188, 162], [220, 210, 188]], 16);
        let slate = palette.ramp(&[[46, 48, 53], [66, 68, 72], [86, 87, 90]], 16);
        let clay = palette.ramp(&[[86, 40, 26], [134, 68, 42], [168, 98, 64]], 16);
        let buff = palette.ramp(&[[148, 127, 94], [178, 156, 118], [202, 182, 144]], 16);
        let oak = palette.ramp(&[[84, 57, 36], [120, 85, 54], [152, 114, 76]], 16);
        let walnut = palette.ramp(&[[58, 35, 21], [84, 52, 32], [110, 72, 46]], 16);
        let brass = palette.ramp(&[[96, 66, 24], [168, 126, 52], [222, 184, 96]], 14);
        let iron = palette.ramp(&[[18, 18, 20], [52, 50, 50]], 8);
        let tin = palette.ramp(&[[104, 104, 104], [152, 152, 150], [198, 198, 194]], 10);
        let marble = palette.ramp(&[[190, 186, 180], [214, 211, 205], [236, 234, 229]], 16);
        let red = palette.ramp(&[[92, 12, 16], [124, 19, 24], [152, 32, 34]], 16);
        let blue = palette.ramp(&[[20, 28, 66], [40, 56, 112], [74, 96, 150]], 12);
        let green = palette.ramp(&[[22, 40, 18], [52, 82, 34], [96, 126, 58]], 14);
        let petals = palette.ramp(&[[196, 92, 110], [236, 196, 200], [250, 244, 232]], 7);
        let glass = glass::Colors::new(&mut palette, DAYLIGHT);
        let sun = palette.glow(&[[255, 232, 190], [255, 244, 218]], 4, SUNLIGHT);
        let warm = palette.glow(&[[255, 208, 148], [255, 218, 168]], 2, LAMPLIGHT * share);
        let lamp = palette.glow(&[[255, 212, 156], [255, 222, 176]], 2, 90.0);
        let ember = palette.glow(&[[255, 60, 30], [255, 96, 48]], 2, 10.0);
        let flood = palette.glow(&[[255, 236, 206], [255, 240, 216]], 2, 100.0);
        let paints = Self {
            ashlar: weathered(stone, 0.50),
            dressed: clouded(stone.even(0.58, 0.45), 0.16, 1.1),
            carved: clouded(stone.even(0.66, 0.45), 0.12, 0.4),
            vault: webbing(web),
            floor: floor_of_tiles(slate, clay, buff),
            steps: ashlar(stone, 0.62, 1.4, 5.0),
            oak: wood(oak, 0.5, Vec3::X),
            oak_across: wood(oak, 0.5, Vec3::Y),
            oak_upright: wood(oak, 0.55, Vec3::Z),
            walnut: wood(walnut, 0.5, Vec3::Z),
            brass: clouded(brass.even(0.5, 0.5), 0.2, 0.15),
            gilded: clouded(brass.even(0.72, 0.4), 0.15, 0.1),
            iron: Paint::plain(iron.tone(0.5)),
            pipes: clouded(tin.even(0.6, 0.45), 0.2, 0.3),
            marble: clouded(marble.even(0.6, 0.45), 0.25, 0.35),
            slate: inscribed(slate, brass),
            linen: clouded(marble.even(0.85, 0.45), 0.08, 0.2),
            carpet: clouded(red.even(0.5, 0.5), 0.1, 0.5),
            frontal: embroidered(red, brass),
            kneelers: one_of(vec![
                varied(red.tone(0.5), 0.2),
                varied(blue.tone(0.5), 0.2),
                varied(green.tone(0.4), 0.15),
            ]),
            books: one_of(vec![
                varied(red.tone(0.3), 0.2),
                varied(green.tone(0.25), 0.1),
                varied(slate.tone(0.3), 0.2),
            ]),
            leaves: clouded(green.tone(0.5), 0.3, 0.08),
            flowers: Paint::plain(petals.even(0.55, 0.6)),
            wax: Paint::plain(marble.even(0.8, 0.3)),
            flame: Paint::plain(warm.even(0.5, 0.5)),
            lamp: Paint::plain(lamp.even(0.5, 0.5)),
            votive: Paint::plain(ember.even(0.5, 0.5)),
            flood: Paint::plain(flood.even(0.5, 0.5)),
            east_glass: glass.saints(),
            aisle_glass: glass.medallions(),
            north_glass: glass.quarries(None),
            south_glass: glass.quarries(Some(sun)),
            rose_glass: glass.rose(),
        };
        (paints, palette)
    }
}

/// Ashlar that grew darker near the floor and stained under the string courses.
fn weathered(ramp: Ramp, level: f32) -> Paint {
    let stones = ashlar(ramp, level, 0.72, 0.34);
    Paint::new(move |p| {
        let soot = 0.10 * (1.0 - smooth_step(0.0, 1.6, p.world.z)) * (0.6 + value_noise(p.world / 0.8, 31));
        let streaks = 0.10 * value_noise(Vec3::new(p.world.x * 2.0, p.world.y * 2.0, p.world.z * 0.25), 32);
        stones.tone(p).lighter(streaks - soot)
    })
}

/// Vault webs: narrow courses of light stone, faintly jointed.
fn webbing(ramp: Ramp) -> Paint {
    Paint::new(move |p| {
        let n = p.normal().abs();
        let course = (if n.x > n.y { p.at.y } else { p.at.x }) / 0.31;
        let joint = if fraction(course) * 0.31 < 0.6 * p.voxel.max(0.015) { 0.22 } else { 0.0 };
        let shade = 0.08 * signed(hash3(IVec3::new(floor(course), floor(p.at.z / 0.9), 0), 33));
        ramp.even(0.58 + shade - joint + 0.14 * fractal_noise(p.world / 2.1, 2, 34), 0.45)
    })
}

/// The floor: a diagonal chequer along the middle of the nave between borders, encaustic tiles in the chancel,
/// flagstones with dark ledger stones in the aisles.
fn floor_of_tiles(slate: Ramp, clay: Ramp, buff: Ramp) -> Paint {
    Paint::new(move |p| {
        let at = vec2(p.world.x, p.world.y);
        let (x, y) = (at.x.abs(), at.y);
        let wear = 0.12 * fractal_noise(p.world / 1.3, 2, 35);
        let line = 0.6 * p.voxel.max(0.012);
        if y > 26.7 {
            return encaustic(at, line, clay, buff).lighter(wear);
        }
        if x < 0.98 {
            if x > 0.84 {
                return slate.tone(0.5 + wear);
            }
            if x > 0.80 {
                return buff.tone(0.6 + wear);
            }
            // Squares of 40 cm on their corners.
            let uv = vec2(at.x + at.y, at.x - at.y) / 0.565;
            let (i, j) = (floor(uv.x), floor(uv.y));
            let inside = vec2(fraction(uv.x), fraction(uv.y));
            let edge = inside.min(Vec2::ONE - inside).min_element() * 0.4;
            let shade = 0.14 * signed(hash3(IVec3::new(i, j, 2), 36)) + wear - 0.3 * f32::from(u8::from(edge < line));
            return if (i + j) & 1 == 0 { slate.tone(0.45 + shade) } else { buff.tone(0.66 + shade) };
        }
        let (stone, edge) = masonry(vec2(at.y, at.x), 0.9, 0.6);
        let ledger = masonry(vec2(at.y + 0.7, at.x - 5.3), 2.4, 1.1);
        if x > 4.2 && x < 6.4 && ledger.0.is_multiple_of(5) {
            let frame = f32::from(u8::from((0.10..0.10 + 2.0 * line).contains(&ledger.1)));
            // Rows of worn lettering.
            let word = hash3(IVec3::new(floor(at.x / 0.05), floor(at.y / 0.16), 3), 37);
            let letters = fraction(at.y / 0.16) < 0.4 && !word.is_multiple_of(3);
            let text = f32::from(u8::from(letters && ledger.1 > 0.25));
            let shade = 0.2 * signed(hash(ledger.0)) + wear + 0.3 * frame + 0.25 * text;
            let joint = 0.3 * f32::from(u8::from(ledger.1 < line));
            return if ledger.0 & 64 == 0 { slate.tone(0.75 + shade - joint) } else { buff.tone(0.2 + shade - joint) };
        }
        buff.tone(0.38 + 0.2 * signed(stone) + wear - 0.3 * f32::from(u8::from(edge < line)))
    })
}

/// Slate with rows of gilded letters on the faces towards x, in the plane (y, z).
fn inscribed(ramp: Ramp, gold: Ramp) -> Paint {
    Paint::new(move |p| {
        let (row, column) = (floor(p.at.z / 0.13), floor(p.at.y / 0.045));
        let inside = fraction(p.at.z / 0.13) < 0.45 && p.at.y.abs() < 0.2 + 0.05 * signed(hash(row as u32));
        let letter = !hash3(IVec3::new(column, row, 6), p.seed).is_multiple_of(4);
        if inside && letter { gold.even(0.5, 0.4) } else { ramp.even(0.4 + 0.2 * value_noise(p.world / 0.3, 39), 0.4) }
    })
}

/// Red and buff tiles of four: a ring, a cross, a plain one.
fn encaustic(at: Vec2, line: f32, clay: Ramp, buff: Ramp) -> Tone {
    let uv = at / 0.32;
    let (i, j) = (floor(uv.x), floor(uv.y));
    let c = vec2(fraction(uv.x), fraction(uv.y)) - Vec2::splat(0.5);
    let edge = (0.5 - c.abs().max_element()) * 0.32;
    let radius = c.length();
    let figure = match (i + 2 * j).rem_euclid(4) {
        0 => (0.26..0.40).contains(&radius) || radius < 0.1,
        1 => c.abs().min_element() < 0.09 && radius < 0.4,
        2 => (c.x.abs() + c.y.abs()) < 0.34 && (c.x.abs() + c.y.abs()) > 0.16,
        _ => false,
    };
    let shade = 0.1 * signed(hash3(IVec3::new(i, j, 4), 38)) - 0.35 * f32::from(u8::from(edge < line));
    if figure { buff.tone(0.6 + shade) } else { clay.tone(0.5 + shade) }
}

/// A red cloth with golden bands and crosses, in the plane (x, z).
fn embroidered(cloth: Ramp, thread: Ramp) -> Paint {
    Paint::new(move |p| {
        let (u, v) = (p.at.x / 0.52, p.at.z);
        let c = vec2((fraction(u) - 0.5) * 0.52, v - 0.48);
        let cross = c.abs().min_element() < 0.03 && c.abs().max_element() < 0.17;
        let ring = (0.19..0.225).contains(&c.length());
        let band = !(0.1..=0.86).contains(&v) || c.x.abs() > 0.245;
        if cross || ring || band { thread.even(0.7, 0.4) } else { cloth.tone(0.5) }
    })
}
