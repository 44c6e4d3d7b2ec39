//! The models of the forest, each a solid on the origin, in metres.

use crate::kit::{noise::*, *};
use glam::{Vec3, vec3};

/// The colours of the forest.
#[derive(Clone, Copy, Debug)]
pub struct Ramps {
    pub grass: Ramp,
    pub earth: Ramp,
    pub path: Ramp,
    pub stone: Ramp,
    pub bark: Ramp,
    pub birch: Ramp,
    pub spruce: Ramp,
    pub pine: Ramp,
    pub green: Ramp,
    pub gold: Ramp,
    pub russet: Ramp,
    pub fern: Ramp,
    pub heather: Ramp,
    pub iron: Ramp,
    pub glow: Ramp,
}

impl Ramps {
    pub fn new() -> (Self, Palette) {
        let mut palette = Palette::default();
        let mut ramp = |stops: &[[u8; 3]]| palette.ramp(stops, 16);
        let ramps = Self {
            grass: ramp(&[[46, 62, 22], [86, 104, 40], [136, 142, 66]]),
            earth: ramp(&[[58, 42, 28], [96, 74, 48], [138, 112, 74]]),
            path: ramp(&[[112, 94, 70], [160, 140, 110], [206, 188, 156]]),
            stone: ramp(&[[72, 72, 74], [118, 116, 112], [172, 168, 158]]),
            bark: ramp(&[[40, 28, 20], [76, 56, 40], [118, 92, 68]]),
            birch: ramp(&[[52, 50, 48], [190, 184, 172], [238, 234, 224]]),
            spruce: ramp(&[[12, 30, 22], [30, 62, 42], [66, 100, 66]]),
            pine: ramp(&[[24, 44, 20], [54, 82, 38], [104, 126, 64]]),
            green: ramp(&[[30, 48, 14], [70, 98, 30], [132, 150, 58]]),
            gold: ramp(&[[140, 82, 14], [204, 144, 32], [242, 200, 88]]),
            russet: ramp(&[[92, 26, 12], [156, 58, 22], [210, 112, 48]]),
            fern: ramp(&[[38, 62, 18], [84, 118, 34], [148, 168, 66]]),
            heather: ramp(&[[74, 40, 84], [140, 84, 146], [206, 150, 196]]),
            iron: ramp(&[[20, 21, 23], [58, 58, 60]]),
            glow: palette.glow(&[[255, 168, 84], [255, 204, 136]], 4, 14.0),
        };
        (ramps, palette)
    }
}

/// What a model is: how instances of it stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Conifer,
    Broadleaf,
    Undergrowth,
    Rock,
    Lamp,
}

/// A model of the forest.
pub struct Plant {
    pub name: &'static str,
    pub kind: Kind,
    pub solid: Solid,
    /// Half its width and its height, metres; roots reach a metre below the origin.
    pub reach: (f32, f32),
}

/// The dozen.
pub fn plants(ramps: &Ramps, voxel: f32) -> Vec<Plant> {
    let plant = |name, kind, solid, reach| Plant { name, kind, solid, reach };
    let lamp = lamp(ramps, voxel);
    vec![
        plant("tall spruce", Kind::Conifer, spruce(ramps.spruce, 17.0, 3.6, 1, voxel, ramps), (5.0, 18.5)),
        plant("young spruce", Kind::Conifer, spruce(ramps.spruce, 8.5, 2.3, 2, voxel, ramps), (3.5, 10.0)),
        plant("pine", Kind::Conifer, spruce(ramps.pine, 13.5, 3.4, 3, voxel, ramps), (5.0, 15.0)),
        plant("oak", Kind::Broadleaf, tree(ramps.green, ramps.bark, 11.0, 1.25, 4, voxel), (7.5, 14.5)),
        plant("maple", Kind::Broadleaf, tree(ramps.russet, ramps.bark, 9.0, 1.0, 5, voxel), (5.5, 12.0)),
        plant("birch", Kind::Broadleaf, tree(ramps.gold, ramps.birch, 11.5, 0.72, 6, voxel), (5.5, 15.0)),
        plant("boulder", Kind::Rock, rock(ramps, 1.5, 7), (2.8, 3.0)),
        plant("stone", Kind::Rock, rock(ramps, 0.7, 8), (1.6, 1.6)),
        plant("bush", Kind::Undergrowth, bush(ramps.green, 1.0, 9), (2.2, 2.6)),
        plant("fern", Kind::Undergrowth, bush(ramps.fern, 0.55, 10), (1.4, 1.6)),
        plant("heather", Kind::Undergrowth, bush(ramps.heather, 0.5, 11), (1.4, 1.5)),
        plant("lamp", Kind::Lamp, lamp, (0.9, 4.6)),
    ]
}

/// A number in [0, 1) for a part of a model.
fn draw(seed: u32, part: u32) -> f32 {
    unit(hash(seed * 977 + part))
}

/// Leaves: light where they face the sky, dark within and below.
fn leaves(ramp: Ramp, top: f32) -> Paint {
    Paint::new(move |p| {
        let height = (p.at.z / top).clamp(0.0, 1.0);
        ramp.even(0.24 + 0.42 * height + 0.34 * fractal_noise(p.world / 0.8, 2, 311), 0.5)
    })
}

/// A conifer: tiers of drooping skirts, each a little turned and uneven.
fn spruce(ramp: Ramp, height: f32, width: f32, seed: u32, voxel: f32, ramps: &Ramps) -> Solid {
    let trunk = cone(0.035 * height, 0.012 * height + voxel, 0.9 * height + 1.0).z(-1.0);
    let tiers = 9;
    let mut parts = Vec::new();
    for tier in 0..tiers {
        let along = tier as f32 / tiers as f32;
        let low = height * (0.12 + 0.8 * along);
        let reach = width * (1.0 - 0.88 * along);
        for branch in 0..7 {
            let part = tier * 7 + branch;
            let (sin, cos) =
                sin_cos_degrees(51.43 * (branch as f32 + 0.5 * (tier % 2) as f32) + 18.0 * draw(seed, part));
            let far = reach * (0.72 + 0.4 * draw(seed, part + 500));
            let (from, to) = (vec3(0.0, 0.0, low + 0.16 * height), vec3(cos * far, sin * far, low));
            parts.push(bar(from, to, (0.2 * reach).max(1.2 * voxel)));
        }
        parts.push(cone(0.62 * reach, 0.1 * reach, 0.17 * height).z(low));
    }
    let bark = Paint::plain(ramps.bark.even(0.35, 0.45));
    trunk.paint(&bark).and(union(parts).paint(&leaves(ramp, height)))
}

/// A broad-leaved tree: a trunk that forks, and clumps of leaves on rings of an egg.
fn tree(ramp: Ramp, bark: Ramp, height: f32, breadth: f32, seed: u32, voxel: f32) -> Solid {
    let thick = (0.024 * height).max(0.8 * voxel);
    let mut wood = vec![bar(vec3(0.0, 0.0, -1.0), vec3(0.1, 0.1, 0.45 * height), thick)];
    let mut crown = Vec::new();
    for i in 0..26 {
        let level = (i as f32 + 0.5) / 26.0;
        let (sin, cos) = sin_cos_degrees(137.5 * i as f32 + 40.0 * draw(seed, i) - 20.0);
        let reach = 0.33 * height * breadth * (1.0 - (level - 0.36) * (level - 0.36) * 2.2).max(0.1);
        let reach = reach * (0.55 + 0.45 * draw(seed, i + 100));
        let at = vec3(cos * reach, sin * reach, height * (0.32 + 0.6 * level));
        let radius = 0.1 * height * breadth.max(0.85) * (0.75 + 0.6 * draw(seed, i + 200)) * (1.15 - 0.45 * level);
        crown.push(ellipsoid(Vec3::new(radius, 0.9 * radius, 0.8 * radius)).turn_z(180.0 * draw(seed, i + 300)).at(at));
        if i % 4 == 1 {
            wood.push(bar(vec3(0.05, 0.05, 0.3 * height), at, 0.6 * thick));
        }
    }
    let bark = Paint::new(move |p| bark.even(0.45 + 0.5 * value_noise(p.at * vec3(2.0, 2.0, 3.0), 312), 0.35));
    union(wood).paint(&bark).and(union(crown).paint(&leaves(ramp, height)))
}

/// A rock: ellipsoids grown together, mossy on top.
fn rock(ramps: &Ramps, size: f32, seed: u32) -> Solid {
    let (stone, moss) = (ramps.stone, ramps.grass);
    let paint = Paint::new(move |p| {
        let cracks = 0.35 * fractal_noise(p.at / 0.6, 3, 313);
        match p.at.z > 0.55 * size && value_noise(p.at / 0.5, 314) > 0.1 {
            true => moss.even(0.4 + cracks, 0.4),
            false => stone.even(0.5 + cracks, 0.4),
        }
    });
    let part = |i| {
        let offset = vec3(draw(seed, i) - 0.5, draw(seed, i + 10) - 0.5, 0.5 * draw(seed, i + 20)) * size;
        ellipsoid(Vec3::new(1.0, 0.8, 0.7) * size * (0.6 + 0.4 * draw(seed, i + 30))).turn_z(60.0 * i as f32).at(offset)
    };
    union((0..4).map(part)).paint(&paint)
}

/// A low plant: clumps on the ground.
fn bush(ramp: Ramp, size: f32, seed: u32) -> Solid {
    let clump = |i| {
        let (sin, cos) = sin_cos_degrees(72.0 * i as f32 + 30.0 * draw(seed, i));
        let far = size * 0.75 * draw(seed, i + 10);
        let at = vec3(cos * far, sin * far, size * (0.35 + 0.35 * draw(seed, i + 20)));
        ellipsoid(Vec3::new(0.7, 0.6, 0.65) * size).at(at)
    };
    union((0..6).map(clump)).paint(&leaves(ramp, 1.3 * size))
}

/// A post with a glowing lantern under a roof.
fn lamp(ramps: &Ramps, voxel: f32) -> Solid {
    let iron = Paint::plain(ramps.iron.even(0.4, 0.5));
    let thick = 0.1_f32.max(0.8 * voxel);
    let post = cylinder(thick, 4.0).z(-1.0).and(cylinder(0.28_f32.max(1.3 * voxel), 0.35));
    let roof = cone(0.45_f32.max(2.2 * voxel), 0.05, 0.4).z(3.65);
    let light = ball(0.3_f32.max(1.5 * voxel)).z(3.35).paint(&Paint::plain(ramps.glow.even(0.5, 0.5)));
    union([post.paint(&iron), roof.paint(&iron), light])
}
