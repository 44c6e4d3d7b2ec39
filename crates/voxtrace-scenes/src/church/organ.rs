//! The organ on its gallery over the west door: towers and flats of tin pipes in a walnut case.

use super::{HALF_NAVE, paints::Paints};
use crate::kit::*;
use glam::{vec2, vec3};

/// Height of the gallery's floor.
const GALLERY: f32 = 3.7;

/// The gallery and the organ.
pub fn organ(paints: &Paints) -> Solid {
    union([gallery(paints), case(paints).at(vec3(0.0, 0.35, GALLERY))])
}

fn gallery(paints: &Paints) -> Solid {
    let depth = 2.3;
    let floor = cuboid(vec3(-HALF_NAVE, 0.0, GALLERY - 0.22), vec3(HALF_NAVE, depth, GALLERY));
    let front = cuboid(vec3(-HALF_NAVE, depth - 0.12, GALLERY - 0.3), vec3(HALF_NAVE, depth, GALLERY + 1.0));
    let panel = extrude(Profile::arch(0.44, 0.42, 0.26), Axis::Y, depth - 0.04, depth + 0.1).at(vec3(
        -3.0,
        0.0,
        GALLERY + 0.12,
    ));
    let rails = union([
        bar(vec3(-HALF_NAVE, depth - 0.04, GALLERY + 1.02), vec3(HALF_NAVE, depth - 0.04, GALLERY + 1.02), 0.09),
        bar(vec3(-HALF_NAVE, depth - 0.02, GALLERY - 0.26), vec3(HALF_NAVE, depth - 0.02, GALLERY - 0.26), 0.09),
    ]);
    let post = revolve(&[
        (0.2, 0.0),
        (0.2, 0.3),
        (0.12, 0.4),
        (0.11, 2.9),
        (0.15, 3.0),
        (0.11, 3.08),
        (0.24, 3.4),
        (0.24, 3.5),
    ]);
    let brace = bar(vec3(0.0, 0.0, 2.6), vec3(0.7, 0.0, 3.45), 0.07).both_x();
    union([
        floor,
        front.minus(row(12, vec3(0.545, 0.0, 0.0), &panel)),
        rails,
        post.and(brace).at(vec3(1.9, depth - 0.2, 0.0)).both_x(),
    ])
    .paint(&paints.oak_upright)
}

/// Pipes in a row, the tallest in the middle (`sign` > 0) or at the sides.
fn pipes(count: u32, radius: f32, low: f32, high: f32, sign: f32) -> Solid {
    let middle = (count - 1) as f32 * 0.5;
    union((0..count).map(|i| {
        let off = (i as f32 - middle).abs() / middle.max(1.0);
        let share = if sign > 0.0 { 1.0 - off } else { off };
        let height = low + (high - low) * share;
        let body = revolve(&[(0.25 * radius, 0.0), (radius, 0.45), (radius, height)]);
        let mouth =
            cuboid(vec3(-0.55 * radius, 0.6 * radius, 0.5), vec3(0.55 * radius, 2.0 * radius, 0.5 + 1.2 * radius));
        body.minus(mouth).x((i as f32 - middle) * radius * 2.12)
    }))
}

fn case(paints: &Paints) -> Solid {
    let base = rounded_cuboid(vec3(-2.5, 0.0, 0.0), vec3(2.5, 0.95, 1.15), 0.03);
    let panel =
        extrude(Profile::rectangle(vec2(-0.3, 0.0), vec2(0.3, 0.75)), Axis::Y, 0.9, 1.1).at(vec3(-2.1, 0.0, 0.2));
    let back = cuboid(vec3(-2.5, 0.0, 0.0), vec3(2.5, 0.35, 3.2));
    let tower = |x: f32, height: f32, radius: f32| {
        let foot = cylinder(radius + 0.08, 0.16).z(1.1).and(cone(0.1, radius + 0.06, 0.5).z(0.62));
        let cap = cylinder(radius + 0.1, 0.14).and(cylinder(radius + 0.02, 0.1).z(0.12)).z(1.2 + height);
        let spire = cone(0.16, 0.0, 0.7).and(ball(0.1).z(0.35)).z(1.4 + height);
        let wall = cuboid(vec3(-radius - 0.1, -0.7, 0.0), vec3(radius + 0.1, -0.1, 1.3 + height));
        union([foot, cap, wall]).paint(&paints.walnut).and(spire.paint(&paints.gilded)).at(vec3(x, 0.75, 0.0))
    };
    let round_pipes = |x: f32, height: f32, radius: f32| {
        let pipe = revolve(&[(0.03, 0.0), (0.105, 0.4), (0.105, height)]);
        let arc = union((-2..=2).map(|i| pipe.y(radius).turn_z(33.0 * i as f32)));
        arc.at(vec3(x, 0.75, 1.24))
    };
    let flat = pipes(9, 0.055, 0.9, 1.5, -1.0).at(vec3(0.98, 0.92, 1.15));
    let crest = extrude(Profile::arch(1.0, 0.1, 0.35).outline(0.1), Axis::Y, 0.8, 0.95).at(vec3(0.98, 0.0, 2.6));
    let frieze = cuboid(vec3(0.4, 0.3, 2.62), vec3(1.56, 0.9, 2.78));
    union([
        base.minus(row(8, vec3(0.6, 0.0, 0.0), &panel)).and(back).paint(&paints.walnut),
        tower(0.0, 2.3, 0.38),
        union([tower(1.95, 1.8, 0.34), frieze.both_x().paint(&paints.walnut)]).both_x(),
        union([round_pipes(0.0, 2.26, 0.3), round_pipes(1.95, 1.76, 0.26).both_x(), flat.both_x()])
            .paint(&paints.pipes),
        crest.both_x().paint(&paints.gilded),
    ])
}
