//! Towers: the stepped ones of the 1930s and the glass ones after them, each on a lot from (0, 0) to `lot`.

use super::{
    facade::{Band, Facade, Street},
    house::House,
    paints::{curtain, roofing, trim},
    roofs,
    site::{Dice, Site, place},
    styles::Kind,
};
use crate::kit::*;
use glam::{Vec2, vec2, vec3};

/// A stepped tower: a base as wide as the lot, tiers that step back, a crown.
pub fn stepped_tower(site: &Site, dice: &mut Dice, lot: Vec2, floors: u32, blind: [bool; 4]) -> Solid {
    let ramps = site.paints.ramps;
    let low = Kind::Deco.facade(site, dice, (floors as f32 * 0.55) as u32);
    let roof = roofing(ramps.tar, 0.5);
    let mut parts = Vec::new();
    let (mut min, mut max, mut foot) = (Vec2::ZERO, lot, 0.0);
    let tiers = 4;
    for tier in 0..tiers {
        let upper = Facade {
            bands: vec![Band {
                floors: (floors as f32 * [0.55, 0.24, 0.14, 0.07][tier]).max(1.0) as u32,
                ..low.bands[1].clone()
            }],
            street: Street::Nothing,
            ..low.clone()
        };
        let facade = if tier == 0 { &low } else { &upper };
        let height = facade.height();
        let size = max - min;
        let walls = (0..4).map(|i| (tier > 0 || !blind[i]).then_some(facade)).collect();
        let house = House {
            corners: vec![min, vec2(max.x, min.y), max, vec2(min.x, max.y)],
            walls,
            foot,
            height,
            paint: facade.wall.clone(),
            roof: roof.clone(),
            parapet: 1.2,
            seed: dice.seed(),
        };
        parts.push(house.build(site));
        foot = site.snap(foot + site.snap(height) - site.snap(1.2));
        if tier + 1 == tiers || size.min_element() < 9.0 {
            break;
        }
        let step = if tier == 0 { vec2(0.14, 0.14) } else { vec2(0.15, 0.13) } * size;
        min = vec2(site.snap(min.x + step.x), site.snap(min.y + step.y));
        max = vec2(site.snap(max.x - step.x), site.snap(max.y - step.y));
    }
    // The crown: ribs around a lantern with a copper cap.
    let middle = (min + max) * 0.5;
    let half = (max - min).min_element() * 0.5;
    let crown = union([
        block(1.5 * half, 1.5 * half, 3.0).paint(&low.wall),
        block(1.1 * half, 1.1 * half, 5.2).paint(&low.trim),
        ring(4, &block(0.5, 1.9 * half, 4.2).x(0.62 * half)).paint(&low.wall),
        cone(0.72 * half, 0.2, 3.4).z(5.1).paint(&site.paints.copper),
        cylinder(site.voxel.max(0.15), 5.0).z(8.0).paint(&site.paints.steel),
    ]);
    parts.push(crown.at(vec3(middle.x, middle.y, foot)));
    union(parts)
}

/// A glass tower: a lobby, a shaft with fins between the panes, machines behind a screen on top.
pub fn glass_tower(site: &Site, dice: &mut Dice, lot: Vec2, floors: u32) -> Solid {
    let ramps = site.paints.ramps;
    let (bay, storey, lobby) = (1.8, 3.7, site.snap(6.0));
    let height = site.snap(lobby + storey * floors as f32);
    let skin = curtain(ramps, bay, storey, dice.between(0.4, 0.55), dice.seed());
    let metal = trim(ramps.steel, dice.between(0.25, 0.7));
    let inset = site.snap(1.6);
    let (min, max) = (Vec2::splat(inset), lot - inset);
    let roof = roofing(ramps.tar, 0.7);
    let (rim, floor) = (site.width(0.6), height - site.width(2.2));
    let well = cuboid(vec3(min.x + rim, min.y + rim, floor), vec3(max.x - rim, max.y - rim, height + 5.0));
    let shaft = cuboid(vec3(min.x, min.y, lobby), vec3(max.x, max.y, height)).paint(&skin).minus(well.paint(&roof));
    let warm = Paint::new(move |p| if p.at.z > 4.2 { ramps.glow.even(0.4, 0.4) } else { ramps.glass.even(0.5, 0.3) });
    let core = cuboid(vec3(min.x + 2.2, min.y + 2.2, -2.0), vec3(max.x - 2.2, max.y - 2.2, lobby + 1.0)).paint(&warm);
    let mut parts = vec![shaft, core];
    let fin = site.width(0.16);
    let size = max - min;
    for (from, along, width) in [
        (min, Vec2::X, size.x),
        (vec2(max.x, min.y), Vec2::Y, size.y),
        (max, -Vec2::X, size.x),
        (vec2(min.x, max.y), -Vec2::Y, size.y),
    ] {
        let count = (width / bay) as u32;
        let us: Vec<f32> = (0..=count).map(|i| site.center(width * i as f32 / count as f32, fin)).collect();
        let fins =
            Profile::Rectangle(vec2(0.5 * fin, 0.5 * (height - lobby))).grid(us.clone(), vec![0.5 * (height + lobby)]);
        let columns: Vec<f32> = us.iter().copied().step_by(3).collect();
        let legs = Profile::Rectangle(vec2(0.4, 0.5 * lobby + 1.0)).grid(columns, vec![0.5 * lobby]);
        let edge = |z: f32| Profile::rectangle(vec2(-0.4, z), vec2(0.5, z + 0.8));
        let side = union([
            extrude(fins, Axis::Y, -fin, 0.4),
            extrude(legs, Axis::Y, 0.2, 1.0),
            extrude(edge(lobby - 0.4), Axis::X, -0.3, width + 0.3),
            extrude(edge(height - 0.6), Axis::X, -0.3, width + 0.3),
        ]);
        parts.push(place(&side, from, along).paint(&metal));
    }
    let things = roofs::furniture(site, dice, min + 2.0, max - 2.0).z(floor);
    parts.push(things);
    union(parts)
}
