//! Tiled surfaces of the theatre: the floor with its border, the wall with dado and frieze, the ceiling's panels.

use super::{DEPTH, WIDTH};
use crate::kit::{noise::*, *};
use glam::{IVec3, Vec2, vec2};

/// Upper edge of the wall tiles.
const DADO: f32 = 2.1;

/// The tile of a square grid at a place (a hash) and the distance to its nearest joint, metres.
fn tile(at: Vec2, size: f32, seed: u32) -> (u32, f32) {
    let uv = at / size;
    let (i, j) = (floor(uv.x), floor(uv.y));
    let inside = vec2(fraction(uv.x), fraction(uv.y));
    (hash3(IVec3::new(i, j, 0), seed), inside.min(Vec2::ONE - inside).min_element() * size)
}

/// 1 in a joint between tiles, 0 on them: a joint is one voxel wide, never less than 8 mm.
fn joint(edge: f32, voxel: f32) -> f32 {
    f32::from(u8::from(edge < 0.5 * voxel.max(0.008)))
}

/// Tiles of 45 cm, speckled, with a teal border along the walls and scuffs in the middle.
pub fn floor_tiles(p: &SurfacePoint, ramp: Ramp, border: Ramp) -> Tone {
    let at = vec2(p.world.x, p.world.y);
    let wall = at.min(vec2(WIDTH, DEPTH) - at).min_element();
    let (stone, edge) = tile(at, 0.45, 71);
    let wear = 0.12 * fractal_noise(p.world / 1.4, 3, 72);
    let scuff = smooth_step(0.55, 0.75, value_noise(p.world / glam::vec3(0.9, 0.12, 1.0), 73));
    let shade = 0.10 * signed(stone) + wear - 0.45 * joint(edge, p.voxel);
    if (0.42..0.56).contains(&wall) {
        border.even(0.5 + shade, 0.45)
    } else {
        ramp.even(0.6 + shade - 0.12 * scuff, 0.45)
    }
}

/// Mint tiles of 20 cm up to the frieze, a dark plinth, painted plaster above.
pub fn wall_tiles(p: &SurfacePoint, plaster: Ramp, tiles: Ramp, frieze: Ramp) -> Tone {
    let at = p.unfold();
    let z = p.world.z;
    let wear = 0.10 * fractal_noise(p.world / 1.1, 3, 74);
    if z > DADO {
        return plaster.even(0.62 + wear - 0.04 * value_noise(p.world / 0.25, 75), 0.5);
    }
    let (stone, edge) = tile(at, 0.20, 76);
    let shade = 0.10 * signed(stone) + wear - 0.5 * joint(edge, p.voxel);
    if z < 0.1 || (1.40..1.60).contains(&z) || z > DADO - 0.03 {
        frieze.even(0.5 + shade, 0.45)
    } else {
        let splash = 0.12 * (1.0 - smooth_step(0.1, 0.7, z));
        tiles.even(0.62 + shade - splash, 0.45)
    }
}

/// Metal panels of 60 cm with rows of holes.
pub fn ceiling_tiles(p: &SurfacePoint, ramp: Ramp) -> Tone {
    let at = vec2(p.world.x, p.world.y);
    let (panel, edge) = tile(at + vec2(0.05, 0.16), 0.6, 77);
    let hole = edge > 0.08 && tile(at, 0.06, 78).1 > 0.5 * (0.06 - p.voxel.clamp(0.008, 0.02));
    let shade = 0.08 * signed(panel) + 0.08 * fractal_noise(p.world / 1.7, 2, 79);
    ramp.even(0.66 + shade - 0.6 * joint(edge, p.voxel) - if hole { 0.28 } else { 0.0 }, 0.5)
}
