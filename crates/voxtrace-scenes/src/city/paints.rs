//! The city's colours, and the paints of walls, windows and ground made of them.

use crate::kit::{noise::*, patterns::*, *};
use glam::{IVec3, Vec2, Vec3, vec3};

/// How far voxels of one surface deviate: small, because a brick of voxels often shows a wall, its trim and a window.
const GRAIN: f32 = 0.26;

/// Every ramp of the palette.
#[derive(Clone, Copy)]
pub struct Ramps {
    pub asphalt: Ramp,
    pub concrete: Ramp,
    pub limestone: Ramp,
    pub brick: Ramp,
    pub brownstone: Ramp,
    pub buff: Ramp,
    pub grey: Ramp,
    pub cream: Ramp,
    pub glass: Ramp,
    pub curtain: Ramp,
    pub tar: Ramp,
    pub copper: Ramp,
    pub wood: Ramp,
    pub green: Ramp,
    pub gold: Ramp,
    pub russet: Ramp,
    pub grass: Ramp,
    pub iron: Ramp,
    pub steel: Ramp,
    pub cab: Ramp,
    pub red: Ramp,
    pub blue: Ramp,
    pub glow: Ramp,
    pub signal: Ramp,
}

/// The paints that many parts share.
pub struct Paints {
    pub ramps: Ramps,
    pub iron: Paint,
    pub steel: Paint,
    pub copper: Paint,
    pub wood: Paint,
    pub concrete: Paint,
    pub granite: Paint,
    pub tyre: Paint,
    pub glow: Paint,
}

impl Paints {
    /// The paints, and the palette that they use.
    pub fn new() -> (Self, Palette) {
        let mut palette = Palette::default();
        let mut ramp = |stops: &[[u8; 3]], shades| palette.ramp(stops, shades);
        let ramps = Ramps {
            asphalt: ramp(&[[50, 51, 54], [74, 74, 76], [100, 99, 98]], 14),
            concrete: ramp(&[[122, 117, 109], [158, 152, 143], [190, 184, 174]], 14),
            limestone: ramp(&[[142, 124, 97], [186, 168, 138], [224, 209, 180]], 16),
            brick: ramp(&[[80, 48, 39], [124, 76, 60], [160, 116, 96]], 14),
            brownstone: ramp(&[[66, 40, 31], [98, 62, 47], [134, 92, 70]], 12),
            buff: ramp(&[[136, 104, 66], [178, 144, 98], [212, 184, 138]], 14),
            grey: ramp(&[[62, 58, 57], [92, 88, 85], [128, 122, 117]], 10),
            cream: ramp(&[[170, 163, 151], [208, 202, 190], [242, 238, 229]], 12),
            glass: ramp(&[[18, 24, 33], [42, 54, 70], [104, 124, 142]], 14),
            curtain: ramp(&[[34, 58, 74], [70, 104, 122], [150, 184, 196]], 14),
            tar: ramp(&[[54, 53, 52], [86, 84, 81], [126, 122, 116]], 14),
            copper: ramp(&[[62, 104, 90], [98, 142, 124], [146, 184, 162]], 10),
            wood: ramp(&[[58, 36, 22], [96, 64, 40], [142, 102, 68]], 10),
            green: ramp(&[[24, 40, 14], [58, 84, 28], [116, 136, 56]], 14),
            gold: ramp(&[[130, 76, 16], [186, 126, 30], [230, 182, 70]], 10),
            russet: ramp(&[[88, 30, 14], [142, 56, 22], [192, 96, 42]], 10),
            grass: ramp(&[[52, 72, 26], [84, 106, 42], [124, 140, 68]], 10),
            iron: ramp(&[[20, 21, 23], [58, 58, 60]], 8),
            steel: ramp(&[[112, 114, 116], [160, 162, 162], [206, 206, 202]], 8),
            cab: ramp(&[[206, 144, 8], [240, 178, 22], [252, 202, 52]], 6),
            red: ramp(&[[108, 18, 18], [176, 40, 32]], 5),
            blue: ramp(&[[20, 36, 78], [62, 96, 150]], 5),
            glow: palette.glow(&[[255, 176, 92], [255, 208, 140]], 4, 1.2),
            signal: palette.glow(&[[255, 16, 8], [20, 255, 90]], 2, 1.5),
        };
        let paints = Self {
            iron: Paint::plain(ramps.iron.even(0.4, 0.5)),
            steel: clouded(ramps.steel.even(0.5, 0.4), 0.2, 0.8),
            copper: clouded(ramps.copper.even(0.5, 0.4), 0.3, 1.2),
            wood: Paint::new(move |p| {
                ramps.wood.even(0.45 + 0.25 * value_noise(vec3(p.world.x, p.world.y, p.world.z * 0.2) * 2.0, 61), 0.4)
            }),
            concrete: clouded(ramps.concrete.even(0.5, 0.35), 0.25, 2.0),
            granite: clouded(ramps.concrete.even(0.75, 0.35), 0.15, 1.0),
            tyre: Paint::plain(ramps.iron.even(0.2, 0.4)),
            glow: Paint::plain(ramps.glow.even(0.7, 0.4)),
            ramps,
        };
        (paints, palette)
    }
}

/// A wall of brick or stone: clouds, streaks that rain has drawn, soot near the street, faint courses.
pub fn wall(ramp: Ramp, level: f32) -> Paint {
    Paint::new(move |p| {
        let w = p.world;
        let clouds = 0.14 * fractal_noise(w / 5.0, 2, 51);
        let streaks = 0.10 * value_noise(vec3(w.x * 1.3, w.y * 1.3, w.z * 0.11), 52);
        let soot = 0.12 * (1.0 - smooth_step(0.0, 7.0, w.z));
        let course = 0.04 * signed(hash3(IVec3::new(floor(w.z / 0.62), 0, 0), 53));
        // Bricks only where voxels are fine enough to show them.
        let joint = if p.voxel < 0.03 && masonry(p.unfold(), 0.22, 0.075).1 < 0.008 { 0.3 } else { 0.0 };
        ramp.even(level + clouds + streaks + course - soot - joint, GRAIN)
    })
}

/// Dressed stone or painted metal: sills, cornices, piers.
pub fn trim(ramp: Ramp, level: f32) -> Paint {
    clouded(ramp.even(level, GRAIN), 0.12, 2.5)
}

/// A flat roof: tar with patches and puddle stains, seams of its sheets every metre.
pub fn roofing(ramp: Ramp, level: f32) -> Paint {
    Paint::new(move |p| {
        let w = p.world;
        let patch = if fractal_noise(w / 3.1, 2, 54) > 0.32 { 0.22 } else { 0.0 };
        let seam = if fraction(w.x / 1.6) * 1.6 < p.voxel { 0.08 } else { 0.0 };
        ramp.even(level + patch - seam + 0.22 * fractal_noise(w / 6.0, 2, 55), 0.4)
    })
}

/// A grid of windows, for their paint: positions in the plane of the wall, metres.
#[derive(Clone, Copy)]
pub struct Panes {
    /// Left edge of the first column's cell, and foot of the lowest window.
    pub first: Vec2,
    /// From window to window.
    pub pitch: Vec2,
    /// Size of a window.
    pub size: Vec2,
    /// Depth of the glass behind the wall.
    pub recess: f32,
    /// Bars between the panes.
    pub frame: Tone,
    /// Share of windows with lamps lit behind them.
    pub lit: f32,
    pub seed: u32,
}

/// Windows: reveals in the wall's paint; glass that mirrors a little sky, blinds, curtains, now and then a lamp.
pub fn glazing(panes: Panes, wall: Paint, ramps: Ramps) -> Paint {
    Paint::new(move |p| {
        if p.at.y < panes.recess {
            return wall.tone(p).lighter(-0.05);
        }
        let (u, v) = ((p.at.x - panes.first.x) / panes.pitch.x, (p.at.z - panes.first.y) / panes.pitch.y);
        let h = hash3(IVec3::new(floor(u), floor(v + 0.2), 0), panes.seed);
        let across = ((fraction(u) - 0.5) * panes.pitch.x).abs();
        let up = (fraction(v + 0.2) - 0.2) * panes.pitch.y / panes.size.y;
        let bar = 0.5 * p.voxel.max(0.06);
        let wide = panes.size.x > 1.7;
        let third = panes.size.x / 6.0;
        if ((up - 0.52) * panes.size.y).abs() < bar
            || wide && (across - third).abs() < bar
            || p.voxel < 0.1 && (across > 0.5 * panes.size.x - 0.06 || up < 0.05)
        {
            return panes.frame;
        }
        let (kind, drop) = (unit(h), unit(hash(h)));
        if kind < panes.lit {
            return ramps.glow.even(0.5 + 0.4 * signed(h), 0.4);
        }
        if kind < 0.34 && up > 1.0 - 0.75 * drop {
            let slats = if p.voxel < 0.05 && fraction(p.at.z / 0.05) < 0.3 { 0.2 } else { 0.0 };
            return ramps.cream.even(0.15 + 0.45 * unit(hash(h ^ 5)) - slats, 0.2);
        }
        let reflection = 0.25 * fractal_noise(p.world / 6.0, 2, 56) + 0.12 * signed(hash(h ^ 9));
        ramps.glass.even(0.2 + 0.32 * up + reflection, 0.22)
    })
}

/// A curtain wall in the plane (x, z) of the wall: panes of every blue, dark spandrels at the floors.
pub fn curtain(ramps: Ramps, bay: f32, storey: f32, level: f32, seed: u32) -> Paint {
    Paint::new(move |p| {
        let (u, v) = (p.at.x / bay, p.at.z / storey);
        let h = hash3(IVec3::new(floor(u), floor(v), 1), seed);
        if fraction(v) < 0.26 {
            return ramps.curtain.even(level - 0.32 + 0.05 * signed(h), 0.18);
        }
        let kind = unit(h);
        if kind > 0.88 {
            return ramps.curtain.even(level + 0.28, 0.15);
        }
        let sky = 0.26 * fractal_noise(vec3(p.world.x, p.world.y, p.world.z * 1.5) / 14.0, 2, 57);
        ramps.curtain.even(level + sky + 0.09 * signed(hash(h)) + 0.1 * fraction(v), 0.18)
    })
}

/// A crown of leaves: light where it faces the sky, dark within.
pub fn leaves(ramp: Ramp, level: f32, top: f32) -> Paint {
    Paint::new(move |p| {
        let height = (p.at.z / top).clamp(0.0, 1.0);
        let dapple = 0.34 * fractal_noise(p.world / 0.8, 2, 58);
        ramp.even(level - 0.22 + 0.42 * height + dapple, 0.5)
    })
}

/// Slabs of a sidewalk.
pub fn paving(ramp: Ramp, level: f32, size: f32) -> Paint {
    Paint::new(move |p| {
        let uv = Vec2::new(p.world.x, p.world.y) / size;
        let slab = hash3(IVec3::new(floor(uv.x), floor(uv.y), 2), 59);
        let edge = fraction(uv.x).min(fraction(uv.y)) * size;
        let joint = if edge < p.voxel.min(0.12) { 0.18 } else { 0.0 };
        let stains = 0.18 * fractal_noise(Vec3::new(p.world.x, p.world.y, 0.0) / 2.4, 3, 60);
        ramp.even(level + 0.1 * signed(slab) + stains - joint, 0.3)
    })
}
