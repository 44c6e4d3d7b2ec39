//! What moves in the streets: cabs, cars, vans, buses, people; and the furniture at the kerbs: lamps, signals, trees.

use super::{
    park,
    plan::{self, Road, SIDEWALK},
    site::{Dice, Site, ground},
    streets::kerb,
    trees::Trees,
    vehicles::Cars,
};
use crate::kit::*;
use glam::{Vec2, Vec3, vec2, vec3};

/// Everything in the streets that is not a building.
pub fn traffic(site: &Site, trees: &Trees) -> Solid {
    let mut dice = Dice::new(4242);
    let cars = Cars::new(site);
    let mut parts = Vec::new();
    for (number, road) in plan::roads().iter().enumerate() {
        parked(site, &mut dice, road, &cars, &mut parts);
        driving(site, &mut dice, road, number, &cars, &mut parts);
        furniture(site, &mut dice, road, trees, &mut parts);
    }
    people(site, &mut dice, &mut parts);
    for at in park::lanterns() {
        parts.push(park::lantern(site).at(at));
    }
    union(parts)
}

/// Whether a place is inside the scene, with room to spare.
fn inside(at: Vec2, margin: f32) -> bool {
    at.min_element() > margin && at.max_element() < plan::SIZE - margin
}

/// Whether a place is in a crossing of roads or on a zebra crossing.
fn at_crossing(at: Vec2, room: f32) -> bool {
    plan::crossing_area(at)
        || plan::crossings().iter().any(|crossing| {
            let local = crossing.local(at).abs();
            local.x < crossing.half.x + room && local.y < crossing.half.y + room
        })
}

/// Cars at both kerbs.
fn parked(site: &Site, dice: &mut Dice, road: &Road, cars: &Cars, parts: &mut Vec<Solid>) {
    for side in [-1.0, 1.0] {
        let mut along = dice.between(3.0, 9.0);
        while along < road.length - 4.0 {
            let at = road.point(along, side * (road.half - 1.25));
            let free = !at_crossing(at, 3.2) && inside(at, 4.0) && !plan::plaza(at);
            if free && dice.chance(0.72) {
                let car = if dice.chance(0.08) {
                    &cars.van
                } else if dice.chance(0.1) {
                    &cars.cab
                } else {
                    &cars.private[dice.below(cars.private.len())]
                };
                let wobble = dice.between(-0.12, 0.12);
                let at = road.point(along, side * (road.half - 1.25) + wobble);
                parts.push(car.turn_towards(road.along.x, road.along.y).at(ground(site.snap2(at))));
            }
            along += dice.between(5.6, 7.4);
        }
    }
}

/// Cars in the lanes, in clusters as signals leave them.
fn driving(site: &Site, dice: &mut Dice, road: &Road, number: usize, cars: &Cars, parts: &mut Vec<Solid>) {
    let lanes: &[(f32, f32)] = match number {
        0 => &[(-3.7, 1.0), (0.0, 1.0), (3.75, 1.0)],
        1 => &[(-0.8, 1.0), (2.6, 1.0)],
        2 => &[(-3.0, 1.0), (0.0, 1.0), (3.0, 1.0)],
        3 => &[(1.5, 1.0), (4.3, 1.0), (-1.5, -1.0), (-4.3, -1.0)],
        _ => &[(0.0, 1.0)],
    };
    for &(across, way) in lanes {
        let mut along = dice.between(4.0, 18.0);
        while along < road.length - 8.0 {
            let at = road.point(along, across + dice.between(-0.2, 0.2));
            let bus = number == 0 && across > 3.0;
            let clear = inside(at, 8.0) && !at_zebra(at) && !plan::plaza(at);
            if clear && (!plan::crossing_area(at) || dice.chance(0.3)) {
                let vehicle = if bus && dice.chance(0.6) {
                    &cars.bus
                } else if dice.chance(0.55) {
                    &cars.cab
                } else if dice.chance(0.12) {
                    &cars.van
                } else {
                    &cars.private[dice.below(cars.private.len())]
                };
                parts.push(vehicle.turn_towards(road.along.x * way, road.along.y * way).at(ground(site.snap2(at))));
            }
            along += if bus {
                dice.between(18.0, 50.0)
            } else if dice.chance(0.6) {
                dice.between(6.5, 9.0)
            } else {
                dice.between(14.0, 30.0)
            };
        }
    }
}

fn at_zebra(at: Vec2) -> bool {
    plan::crossings().iter().any(|crossing| {
        let local = crossing.local(at).abs();
        local.x < crossing.half.x && local.y < crossing.half.y + 3.2
    })
}

/// Lamps, trees, hydrants and bins along both kerbs, signals at the corners.
fn furniture(site: &Site, dice: &mut Dice, road: &Road, trees: &Trees, parts: &mut Vec<Solid>) {
    let top = kerb(site);
    let lamp = street_lamp(site);
    for side in [-1.0_f32, 1.0] {
        let mut along = dice.between(4.0, 9.0);
        let mut number = 0;
        while along < road.length - 4.0 {
            let at = road.point(along, side * (road.half + 0.9));
            let (low, high) = plan::PARK;
            let in_park = at.x > low.x - 1.0 && at.x < high.x + 1.0 && at.y > low.y - 1.0 && at.y < high.y + 1.0;
            if inside(at, 4.5) && !at_crossing(at, 1.5) && !plan::plaza(at) && !in_park {
                let base = ground(at).with_z(top);
                match number % 3 {
                    0 => {
                        let inwards = road.point(along, 0.0) - at;
                        parts.push(lamp.turn_towards(inwards.x, inwards.y).at(base));
                    }
                    _ if road.half < 5.0 || dice.chance(0.5) => {
                        let height = dice.between(6.0, 8.5);
                        parts.push(trees.pick(dice, height, 0.35).at(base));
                        let pit = block(1.7, 1.7, site.width(0.2)).z(-0.1).paint(&site.paints.wood);
                        parts.push(pit.at(base));
                    }
                    1 => parts.push(hydrant(site).at(base)),
                    _ => parts.push(bin(site).at(base)),
                }
            }
            number += 1;
            along += dice.between(6.5, 8.5);
        }
    }
    for crossing in plan::crossings() {
        let (from, to) = (
            crossing.middle - crossing.along * (crossing.half.x + 0.9),
            crossing.middle + crossing.along * (crossing.half.x + 0.9),
        );
        // Each road adds the signals of the crossings over itself.
        if road.local(crossing.middle).0.abs() < 0.6 && road.along.dot(crossing.along).abs() < 0.2 {
            for (at, way) in [(from, crossing.along), (to, -crossing.along)] {
                if inside(at, 3.0) {
                    parts.push(signal(site).turn_towards(way.x, way.y).at(ground(at).with_z(top)));
                }
            }
        }
    }
}

/// A street lamp whose arm reaches along +x.
fn street_lamp(site: &Site) -> Solid {
    let radius = 0.1_f32.max(0.75 * site.voxel);
    let pole = bars(&[vec3(0.0, 0.0, -0.3), vec3(0.0, 0.0, 7.6), vec3(0.9, 0.0, 8.5), vec3(2.4, 0.0, 8.7)], radius);
    let head = block(1.1, site.width(0.4), site.width(0.25)).at(vec3(2.6, 0.0, 8.5));
    union([pole, cylinder(0.28, 0.9)]).paint(&site.paints.iron).and(head.paint(&site.paints.steel))
}

/// A traffic signal whose arm reaches along +x.
fn signal(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let radius = 0.1_f32.max(0.75 * site.voxel);
    let pole = bars(&[vec3(0.0, 0.0, -0.3), vec3(0.0, 0.0, 5.6), vec3(4.2, 0.0, 6.2)], radius).paint(&site.paints.iron);
    let box_paint = Paint::new(move |p| {
        let third = p.at.z / 1.2;
        let side = p.at.y.abs() > 0.22;
        if side && third > 0.68 && p.chance() < 0.5 {
            ramps.signal.even(0.2, 0.0)
        } else if side && third < 0.32 && p.chance() >= 0.5 {
            ramps.signal.even(0.9, 0.0)
        } else {
            ramps.cab.even(0.3, 0.4)
        }
    });
    let width = site.width(0.5);
    let one = block(width, width, 1.2).paint(&box_paint);
    union([pole, one.at(vec3(3.9, 0.0, 5.2)), one.at(vec3(0.0, -0.5, 3.2))])
}

fn hydrant(site: &Site) -> Solid {
    let paint = Paint::plain(site.paints.ramps.red.even(0.6, 0.3));
    let radius = 0.17_f32.max(0.8 * site.voxel);
    cylinder(radius, 0.8).and(ball(radius).z(0.8)).paint(&paint)
}

fn bin(site: &Site) -> Solid {
    cylinder(0.33, 1.0).paint(&Paint::plain(site.paints.ramps.green.even(0.2, 0.3)))
}

/// People on the sidewalks, in the park and on the crossings.
fn people(site: &Site, dice: &mut Dice, parts: &mut Vec<Solid>) {
    let ramps = site.paints.ramps;
    let coats = [
        ramps.iron.even(0.3, 0.4),
        ramps.blue.even(0.3, 0.4),
        ramps.red.even(0.5, 0.4),
        ramps.cream.even(0.7, 0.3),
        ramps.buff.even(0.4, 0.3),
        ramps.green.even(0.3, 0.3),
        ramps.wood.even(0.4, 0.3),
        ramps.steel.even(0.5, 0.3),
    ]
    .map(Paint::plain);
    let skin =
        [ramps.buff.even(0.75, 0.3), ramps.brownstone.even(0.5, 0.3), ramps.buff.even(0.4, 0.3)].map(Paint::plain);
    let trousers = Paint::plain(ramps.blue.even(0.1, 0.4));
    let wide = 0.26_f32.max(0.8 * site.voxel);
    let mut person = |dice: &mut Dice, at: Vec3| {
        let height = dice.between(0.92, 1.06);
        let coat = bar(vec3(0.0, 0.0, 0.85), vec3(0.0, 0.0, 1.3), wide).paint(&coats[dice.below(coats.len())]);
        let legs = cylinder(0.75 * wide, 0.9).paint(&trousers);
        let head = ball((0.75 * wide).max(0.16)).z(1.62).paint(&skin[dice.below(3)]);
        parts.push(union([legs, coat, head]).scaled(height).at(at));
    };
    let top = kerb(site);
    for road in plan::roads() {
        for _ in 0..(road.length / 4.5) as u32 {
            let side = if dice.chance(0.5) { 1.0 } else { -1.0 };
            let across = side * (road.half + dice.between(1.6, SIDEWALK - 0.5));
            let at = road.point(dice.between(3.0, road.length - 3.0), across);
            if inside(at, 3.0) && !plan::crossing_area(at) && !at_crossing(at, 0.5) {
                person(dice, ground(at).with_z(top));
            }
        }
    }
    for crossing in plan::crossings() {
        for _ in 0..dice.below(6) {
            let at = crossing.middle
                + crossing.along * dice.between(-0.9, 0.9) * crossing.half.x
                + vec2(-crossing.along.y, crossing.along.x) * dice.between(-1.3, 1.3);
            if inside(at, 3.0) {
                person(dice, ground(at));
            }
        }
    }
    for _ in 0..34 {
        let (sin, cos) = noise::sin_cos_degrees(dice.between(0.0, 360.0));
        let out = dice.between(5.4, 9.0);
        person(dice, ground(park::FOUNTAIN + vec2(cos, sin) * out).with_z(top));
    }
    for _ in 0..14 {
        let at = vec2(dice.between(87.0, 95.0), dice.between(108.5, 118.0));
        if plan::plaza(at) {
            person(dice, ground(at));
        }
    }
}
