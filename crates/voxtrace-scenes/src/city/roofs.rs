//! What stands on roofs: water tanks, stair houses, machines, chimneys, skylights, a few gardens.

use super::site::{Dice, Site};
use crate::{
    city::paints::{leaves, roofing, wall},
    kit::*,
};
use glam::{Vec2, vec2, vec3};

/// Things spread over a rectangle of a roof at z = 0.
pub fn furniture(site: &Site, dice: &mut Dice, min: Vec2, max: Vec2) -> Solid {
    let size = max - min;
    let mut parts = Vec::new();
    if size.min_element() < 4.0 {
        return union(parts);
    }
    // Cells of about 5 m, each with at most one thing, so that nothing collides.
    let cells = (size / 5.2).max(Vec2::ONE);
    let (columns, rows) = (cells.x as u32, cells.y as u32);
    let cell = vec2(size.x / columns as f32, size.y / rows as f32);
    let house = dice.below((columns * rows) as usize) as u32;
    let tank = (house + 1 + dice.below(3) as u32) % (columns * rows);
    for i in 0..columns * rows {
        let corner = min + cell * vec2((i % columns) as f32, (i / columns) as f32);
        let middle = corner + cell * (0.5 + 0.16 * vec2(dice.draw() - 0.5, dice.draw() - 0.5));
        let kind = dice.draw();
        let thing = if i == house {
            stair_house(site, dice)
        } else if i == tank && dice.chance(0.7) && cell.min_element() > 3.6 {
            water_tank(site, dice)
        } else if kind < 0.34 {
            machine(site, dice)
        } else if kind < 0.46 {
            chimney(site, dice)
        } else if kind < 0.56 {
            skylight(site)
        } else if kind < 0.66 {
            planters(site, dice)
        } else if kind < 0.74 {
            duct(site, dice)
        } else {
            continue;
        };
        parts.push(thing.at(vec3(site.snap(middle.x), site.snap(middle.y), 0.0)));
    }
    union(parts)
}

/// A wooden tank on steel legs under a conical roof.
pub fn water_tank(site: &Site, dice: &mut Dice) -> Solid {
    let ramps = site.paints.ramps;
    let (radius, height, legs) = (dice.between(1.5, 1.9), dice.between(3.2, 4.2), dice.between(1.8, 3.6));
    let staves = Paint::new(move |p| {
        // Hoops, closer together towards the bottom where the water presses most.
        let hoop = [0.3, 0.8, 1.4, 2.1, 2.9].iter().any(|z| (p.at.z - z).abs() < 0.5 * p.voxel.max(0.06));
        let stave = noise::signed(noise::hash3((p.at * 3.5).as_ivec3().with_z(0), 71));
        let stain = 0.2 * noise::value_noise(vec3(p.world.x, p.world.y, p.world.z * 0.2) * 1.5, 72);
        if hoop { ramps.iron.even(0.6, 0.3) } else { ramps.wood.even(0.5 + 0.22 * stave + stain, 0.25) }
    });
    let roof = Paint::plain(ramps.tar.even(dice.between(0.2, 0.8), 0.3));
    let leg = site.thick(0.2) * 0.5;
    let frame = bar(vec3(0.75 * radius, 0.75 * radius, -0.5), vec3(0.75 * radius, 0.75 * radius, legs + 0.2), leg);
    let beam = block(2.0 * radius, site.width(0.3), site.width(0.3)).z(legs - 0.3);
    union([
        cylinder(radius, height).paint(&staves).z(legs),
        cone(radius + 0.25, 0.1, 1.3).paint(&roof).z(legs + height - 0.05),
        union([ring(4, &frame), beam.clone(), beam.turn_z(90.0)]).paint(&site.paints.iron),
    ])
}

fn stair_house(site: &Site, dice: &mut Dice) -> Solid {
    let ramps = site.paints.ramps;
    let ramp = [ramps.brick, ramps.buff, ramps.grey, ramps.cream][dice.below(4)];
    let (width, depth, height) = (dice.between(3.0, 4.2), dice.between(2.8, 3.8), dice.between(2.6, 3.6));
    let size = vec3(site.even(width), site.even(depth), site.snap(height));
    let door = cuboid(vec3(-0.55, -0.5 * size.y - 0.15, -0.2), vec3(0.55, 0.0, 2.2)).paint(&site.paints.iron);
    let cap = block(size.x + 2.0 * site.width(0.25), size.y + 2.0 * site.width(0.25), site.width(0.25))
        .z(size.z)
        .paint(&roofing(ramps.tar, 0.5));
    let side = dice.below(4) as f32 * 90.0;
    union([block(size.x, size.y, size.z).paint(&wall(ramp, 0.5)), cap, door]).turn_z(side)
}

fn machine(site: &Site, dice: &mut Dice) -> Solid {
    let ramps = site.paints.ramps;
    let steel = ramps.steel;
    let (width, depth, height) = (dice.between(1.4, 3.2), dice.between(1.2, 2.0), dice.between(1.0, 1.9));
    let size = vec3(site.even(width), site.even(depth), site.width(height));
    let fan = Paint::new(move |p| {
        let slats = p.at.z < 0.8 * size.z && noise::fraction(p.at.z / (3.0 * p.voxel)) < 0.34;
        let grille = p.at.z > size.z - p.voxel && (p.at.truncate().length() - 0.45).abs() < 0.25;
        steel.even(if slats || grille { 0.12 } else { 0.6 }, 0.3)
    });
    let one = block(size.x, size.y, size.z).paint(&fan);
    let base = block(size.x + 0.5, size.y + 0.5, 0.3).paint(&site.paints.iron);
    one.and(base).turn_z(dice.below(2) as f32 * 90.0)
}

fn duct(site: &Site, dice: &mut Dice) -> Solid {
    let thick = site.even(0.7);
    let run =
        block(3.6, thick, thick).z(0.5).and(block(thick, thick, 1.4).x(1.6)).and(block(thick, thick, 1.4).x(-1.6));
    let vent = revolve(&[(0.3, -0.2), (0.3, 0.9), (0.55, 1.0), (0.4, 1.5)]).y(1.4);
    run.and(vent).paint(&site.paints.steel).turn_z(dice.below(4) as f32 * 90.0)
}

fn chimney(site: &Site, dice: &mut Dice) -> Solid {
    let ramps = site.paints.ramps;
    let height = dice.between(1.6, 2.8);
    let pot = cylinder(0.24_f32.max(0.75 * site.voxel), 0.7).z(height - 0.1).paint(&trim_of(ramps.russet));
    let stack = block(site.even(0.9), site.even(1.7), site.snap(height)).paint(&wall(ramps.brick, 0.4));
    union([stack, pot.y(0.45), pot.y(-0.45)])
}

fn skylight(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let glass = Paint::new(move |p| {
        if noise::fraction(p.at.y / 0.9) * 0.9 < p.voxel {
            ramps.steel.even(0.5, 0.3)
        } else {
            ramps.glass.even(0.7, 0.3)
        }
    });
    gable(2.2, 3.4, 1.1).z(0.4).paint(&glass).and(block(2.4, 3.6, 0.6).paint(&site.paints.iron))
}

fn planters(site: &Site, dice: &mut Dice) -> Solid {
    let ramps = site.paints.ramps;
    let deck = block(4.4, 4.2, site.width(0.25)).paint(&site.paints.wood);
    let bush = ellipsoid(vec3(0.65, 0.6, 0.7)).paint(&leaves(ramps.green, 0.5, 0.7));
    let boxes = block(3.8, 0.7, 0.7).paint(&trim_of(ramps.brownstone));
    let mut parts = vec![deck, boxes.y(1.5), boxes.y(-1.5)];
    for i in 0..6 {
        let side = if i < 3 { 1.5 } else { -1.5 };
        parts.push(bush.scaled(dice.between(0.8, 1.2)).at(vec3((i % 3) as f32 * 1.3 - 1.3, side, 0.9)));
    }
    let parasol = cone(1.3, 0.1, 0.6).z(2.1).paint(&trim_of(if dice.chance(0.5) { ramps.cream } else { ramps.red }));
    let pole = cylinder(0.75 * site.voxel.min(0.4), 2.2).paint(&site.paints.wood);
    parts.extend([parasol, pole]);
    union(parts)
}

fn trim_of(ramp: Ramp) -> Paint {
    Paint::plain(ramp.even(0.55, 0.4))
}
