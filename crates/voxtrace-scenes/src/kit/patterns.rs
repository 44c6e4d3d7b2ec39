//! Stock paints: plaster, ashlar, brick, tiles, wood. Each is a function of the place on the surface in the
//! coordinates of the solid where it was painted (walls along x or y, z up).

use super::{
    noise::{floor, fractal_noise, fraction, hash3, signed, value_noise},
    paint::{Paint, Ramp, SurfacePoint, Tone},
};
use glam::{IVec3, Vec2, Vec3, vec2};

/// One tone modulated by noise: `level` ± `depth`, features `size` metres wide. Plaster, earth, cloth, concrete.
pub fn clouded(tone: Tone, depth: f32, size: f32) -> Paint {
    Paint::new(move |p| tone.lighter(depth * fractal_noise(p.world / size, 3, 11)))
}

/// Squared stone in courses: stones about `length` × `course` metres, each of its own shade, with darker joints of
/// two ends of the same ramp.
pub fn ashlar(ramp: Ramp, level: f32, length: f32, course: f32) -> Paint {
    Paint::new(move |p| {
        let uv = p.unfold();
        let (stone, edge) = masonry(uv, length, course);
        let clouds = 0.12 * fractal_noise(p.world / 1.7, 3, 12) + 0.10 * signed(stone);
        let joint = joint_share(edge, p.voxel);
        ramp.even(level + clouds - 0.5 * joint, 0.42)
    })
}

/// Bricks of one ramp with joints of another.
pub fn brickwork(bricks: Ramp, joints: Tone, length: f32, course: f32) -> Paint {
    Paint::new(move |p| {
        let (brick, edge) = masonry(p.unfold(), length, course);
        if edge < 0.6 * p.voxel.min(course * 0.2) {
            joints
        } else {
            bricks.tone(0.5 + 0.2 * signed(brick) + 0.1 * fractal_noise(p.world / 2.3, 2, 13))
        }
    })
}

/// Square tiles of `size` metres in two ramps like a chessboard, with dark joints.
pub fn chequered(light: Ramp, dark: Ramp, size: f32) -> Paint {
    Paint::new(move |p| {
        let uv = p.unfold() / size;
        let (i, j) = (floor(uv.x), floor(uv.y));
        let ramp = if (i + j) & 1 == 0 { light } else { dark };
        let inside = vec2(fraction(uv.x), fraction(uv.y));
        let edge = inside.min(Vec2::ONE - inside).min_element() * size;
        let shade = 0.16 * signed(hash3(IVec3::new(i, j, 0), 14)) + 0.12 * value_noise(p.world / 0.9, 15);
        ramp.tone(0.55 + shade - 0.35 * joint_share(edge, p.voxel))
    })
}

/// Wood with its grain along `along` (a unit vector); planks of different copies differ in shade.
pub fn wood(ramp: Ramp, level: f32, along: Vec3) -> Paint {
    Paint::new(move |p| {
        // Rings, drawn out twenty times along the grain.
        let across = p.at - along * p.at.dot(along) * 0.95;
        let shift = Vec3::splat(p.chance() * 37.0);
        let rings = fractal_noise(across * 14.0 + shift, 2, 16);
        let broad = value_noise(across * 3.0 + shift, 17);
        ramp.even(level + 0.22 * rings + 0.14 * broad + 0.2 * (p.chance() - 0.5), 0.4)
    })
}

/// One tone, each painted copy with a shade of its own (± `depth`): books, people, cars, leaves.
pub fn varied(tone: Tone, depth: f32) -> Paint {
    Paint::new(move |p| tone.lighter(depth * (2.0 * p.chance() - 1.0) + 0.1 * value_noise(p.world / 0.4, 18)))
}

/// Which of several paints each painted copy gets, by chance.
pub fn one_of(paints: Vec<Paint>) -> Paint {
    Paint::new(move |p: &SurfacePoint| paints[(p.chance() * paints.len() as f32) as usize].tone(p))
}

/// The stone at a place of a wall of courses (a hash), and the distance to its nearest joint, metres. Every second
/// course is shifted by about half a stone.
pub fn masonry(uv: Vec2, length: f32, course: f32) -> (u32, f32) {
    let v = uv.y / course;
    let row = floor(v);
    let shift = 0.5 * (row & 1) as f32 + 0.15 * signed(hash3(IVec3::new(row, 0, 0), 19));
    let u = uv.x / length + shift;
    let column = floor(u);
    let (fu, fv) = (fraction(u), fraction(v));
    let edge = (fu.min(1.0 - fu) * length).min(fv.min(1.0 - fv) * course);
    (hash3(IVec3::new(column, row, 1), 20), edge)
}

/// 1 in a joint, 0 beyond: joints are a centimetre or a voxel wide, whichever is more.
pub fn joint_share(edge: f32, voxel: f32) -> f32 {
    if edge < voxel.max(0.01) * 0.6 { 1.0 } else { 0.0 }
}
