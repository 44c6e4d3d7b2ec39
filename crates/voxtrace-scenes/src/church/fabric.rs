//! The walls: the cavity of the church with its arcades and windows, the floor, the steps.

use super::{
    AISLE_INNER, AISLE_OUTER, AISLE_SPRING, BAY, BAYS, CHANCEL, CHANCEL_BAY, CHANCEL_FLOOR, EAST, HALF_NAVE, NAVE_END,
    NAVE_SPRING, SANCTUARY_FLOOR, paints::Paints, vaults, windows,
};
use crate::kit::*;
use glam::{vec2, vec3};

/// Walls, vault webs, windows, floor and steps.
pub fn fabric(paints: &Paints) -> Solid {
    // Below the floor slab, so that the cavity's own bottom is never seen.
    let below = -0.4;
    let nave = cuboid(vec3(-HALF_NAVE, 0.0, below), vec3(HALF_NAVE, NAVE_END, NAVE_SPRING));
    let chancel = cuboid(vec3(-HALF_NAVE, CHANCEL, below), vec3(HALF_NAVE, EAST, NAVE_SPRING));
    let aisle = cuboid(vec3(AISLE_INNER, 0.0, below), vec3(AISLE_OUTER, NAVE_END, AISLE_SPRING)).both_x();
    let between_piers = cuboid(vec3(-AISLE_OUTER, 0.0, below), vec3(AISLE_OUTER, NAVE_END, AISLE_SPRING));
    let cavity = union([nave, chancel, aisle, between_piers, arcade_arches(), chancel_arch()]);
    let (openings, fillings) = windows::all(paints);
    union([
        around(union([cavity.paint(&paints.ashlar), vaults::webs(paints), openings, triforium(paints)])),
        fillings,
        strings(paints),
        floors(paints),
        doors(paints),
    ])
}

/// The openings of the arcade arches above the capitals, in two orders, on both sides.
fn arcade_arches() -> Solid {
    let arch = |span: f32, rise: f32, from: f32, to: f32| extrude(Profile::arch(span, 0.2, rise), Axis::X, from, to);
    let opening = union([
        arch(3.1, 2.05, HALF_NAVE - 0.1, AISLE_INNER + 0.1),
        arch(3.5, 2.25, HALF_NAVE - 0.1, HALF_NAVE + 0.16),
        arch(3.5, 2.25, AISLE_INNER - 0.16, AISLE_INNER + 0.1),
    ]);
    row(BAYS, vec3(0.0, BAY, 0.0), &opening.at(vec3(0.0, BAY * 0.5, AISLE_SPRING - 0.2))).both_x()
}

fn chancel_arch() -> Solid {
    let arch = |span: f32, rise: f32, from: f32, to: f32| extrude(Profile::arch(span, 6.6, rise), Axis::Y, from, to);
    union([
        arch(5.3, 4.5, NAVE_END - 0.1, CHANCEL + 0.1),
        arch(5.7, 4.7, NAVE_END - 0.1, NAVE_END + 0.2),
        arch(5.7, 4.7, CHANCEL - 0.2, CHANCEL + 0.1),
    ])
    .z(-0.2)
}

/// Blind arcading between the arcade and the clerestory: five trefoil-headed niches a bay.
fn triforium(paints: &Paints) -> Solid {
    let head = Profile::foil(3, 0.13, 0.15).moved(vec2(0.0, 0.68));
    let niche = Profile::rectangle(vec2(-0.22, 0.0), vec2(0.22, 0.62)).and(head);
    let niche = extrude(niche, Axis::X, HALF_NAVE - 0.1, HALF_NAVE + 0.16);
    let frame = extrude(Profile::arch(0.62, 0.62, 0.46), Axis::X, HALF_NAVE - 0.1, HALF_NAVE + 0.05);
    let bay = row(5, vec3(0.0, 0.68, 0.0), &niche.and(frame)).y(-1.36);
    row(BAYS, vec3(0.0, BAY, 0.0), &bay.at(vec3(0.0, BAY * 0.5, 7.22))).both_x().paint(&paints.dressed)
}

/// String courses and the mouldings around arches.
fn strings(paints: &Paints) -> Solid {
    let string = |z: f32, radius: f32, x: f32, from: f32, to: f32| bar(vec3(x, from, z), vec3(x, to, z), radius);
    let nave = union([
        string(7.02, 0.10, HALF_NAVE, 0.0, NAVE_END),
        string(8.46, 0.08, HALF_NAVE, 0.0, NAVE_END),
        string(1.25, 0.06, AISLE_OUTER, 0.0, NAVE_END),
        string(4.6, 0.09, HALF_NAVE, CHANCEL, EAST),
    ])
    .both_x();
    let plinth = cuboid(vec3(AISLE_OUTER - 0.09, 0.0, 0.0), vec3(AISLE_OUTER + 0.1, NAVE_END, 0.34)).both_x();
    let roll = Profile::Disc(0.085).moved(vec2(0.05, 0.0)).and(Profile::Disc(0.05).moved(vec2(0.22, 0.0)));
    let above = half_space(vec3(0.0, 0.0, AISLE_SPRING), vec3(0.0, 0.0, -1.0));
    let hood = moulding(Profile::endless_arch(3.5, 2.25), roll.clone(), Axis::X).x(HALF_NAVE);
    let hoods = row(BAYS, vec3(0.0, BAY, 0.0), &hood.at(vec3(0.0, BAY * 0.5, AISLE_SPRING))).both_x().within(above);
    let soffit =
        moulding(Profile::endless_arch(3.1, 2.05), Profile::Disc(0.1), Axis::X).x(0.5 * (HALF_NAVE + AISLE_INNER));
    let above = half_space(vec3(0.0, 0.0, AISLE_SPRING), vec3(0.0, 0.0, -1.0));
    let soffits = row(BAYS, vec3(0.0, BAY, 0.0), &soffit.at(vec3(0.0, BAY * 0.5, AISLE_SPRING))).both_x().within(above);
    let chancel = moulding(Profile::arch(5.7, 6.6, 4.7), roll, Axis::Y).at(vec3(0.0, NAVE_END, -0.2));
    let inner =
        moulding(Profile::arch(5.3, 6.6, 4.5), Profile::Disc(0.11), Axis::Y).at(vec3(0.0, NAVE_END + 0.35, -0.2));
    union([nave, plinth, hoods, soffits, chancel, inner]).paint(&paints.dressed)
}

fn floors(paints: &Paints) -> Solid {
    let slab = cuboid(vec3(-9.0, -2.0, -1.0), vec3(9.0, EAST + 2.0, 0.0));
    let chancel = cuboid(vec3(-4.5, CHANCEL - 0.1, -0.5), vec3(4.5, EAST + 1.0, CHANCEL_FLOOR));
    let sanctuary = cuboid(vec3(-4.5, EAST - 3.1, -0.5), vec3(4.5, EAST + 1.0, SANCTUARY_FLOOR));
    let tiles = union([slab, chancel, sanctuary]).paint(&paints.floor);
    let step = |half: f32, y: f32, z: f32| cuboid(vec3(-half, y, 0.0), vec3(half, y + 1.2, z));
    let steps = union([
        step(2.9, CHANCEL - 1.3, 0.16),
        step(2.75, CHANCEL - 0.9, 0.32),
        step(2.6, CHANCEL - 0.5, 0.48),
        step(3.6, EAST - 3.9, 0.64),
        step(3.6, EAST - 3.5, 0.80),
        cuboid(vec3(-3.6, EAST - 3.15, 0.0), vec3(3.6, EAST - 2.8, SANCTUARY_FLOOR)),
    ]);
    let carpet = union([
        cuboid(vec3(-0.6, CHANCEL, 0.0), vec3(0.6, EAST - 3.9, CHANCEL_FLOOR + 0.02)),
        cuboid(vec3(-0.6, EAST - 3.9, 0.0), vec3(0.6, EAST - 3.5, 0.66)),
        cuboid(vec3(-0.6, EAST - 3.5, 0.0), vec3(0.6, EAST - 3.15, 0.82)),
        cuboid(vec3(-0.6, EAST - 3.16, 0.0), vec3(0.6, EAST - 1.9, SANCTUARY_FLOOR + 0.02)),
        cuboid(vec3(-2.2, EAST - 2.6, 0.0), vec3(2.2, EAST - 1.0, SANCTUARY_FLOOR + 0.02)),
    ]);
    union([tiles, steps.paint(&paints.steps), carpet.paint(&paints.carpet)])
}

/// Doors of planks with iron straps: the west door, and one in each aisle's second bay.
fn doors(paints: &Paints) -> Solid {
    let door = |span: f32, legs: f32, rise: f32| {
        let leaf = extrude(Profile::arch(span, legs, rise), Axis::Y, -0.02, 0.3).paint(&paints.walnut);
        let split = cuboid(vec3(-0.015, -0.1, 0.0), vec3(0.015, 0.3, legs + rise));
        let strap = |z: f32| cuboid(vec3(0.1, -0.05, z), vec3(span * 0.46, 0.1, z + 0.09)).both_x();
        let frame = moulding(Profile::arch(span, legs, rise), Profile::Disc(0.12), Axis::Y).paint(&paints.dressed);
        let outer = moulding(Profile::arch(span + 0.5, legs, rise + 0.3), Profile::Disc(0.08), Axis::Y);
        let straps = union([strap(0.5), strap(legs * 0.95)]).paint(&paints.iron);
        union([leaf.minus(split), straps, frame, outer.paint(&paints.dressed)])
    };
    let west = door(2.4, 2.0, 1.3).turn_z(180.0);
    let north = door(1.4, 1.5, 0.9).turn_z(90.0).at(vec3(-AISLE_OUTER, BAY * 0.22, 0.0));
    let vestry = door(1.1, 1.4, 0.7).turn_z(-90.0).at(vec3(HALF_NAVE, CHANCEL + CHANCEL_BAY + 0.2, CHANCEL_FLOOR));
    union([west, north, vestry])
}
