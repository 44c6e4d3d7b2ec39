//! The ceiling pendants: columns on swivelling arms that bring gas and power and carry shelves of equipment.

use super::{HEIGHT, Workshop, parts};
use crate::kit::*;
use glam::{Vec3, vec3};

/// The anaesthetist's pendant and the surgeon's.
pub fn pendants(shop: &Workshop) -> Solid {
    union([
        pendant(
            shop,
            vec3(7.75, 6.75, 0.0),
            vec3(8.0, 6.05, 0.0),
            vec3(7.3, 6.35, 0.0),
            -35.0,
            &anaesthesia_shelves(shop),
        ),
        pendant(shop, vec3(2.75, 6.6, 0.0), vec3(2.35, 5.85, 0.0), vec3(3.05, 5.45, 0.0), 35.0, &surgery_shelves(shop)),
    ])
}

/// Hub, two arms and a column that looks towards −y, turned by `turn`; its lower end is 0.95 m above the floor.
fn pendant(shop: &Workshop, hub: Vec3, elbow: Vec3, column: Vec3, turn: f32, shelves: &Solid) -> Solid {
    let paints = &shop.paints;
    let up = |at: Vec3, z: f32| vec3(at.x, at.y, z);
    let box_arm = |from: Vec3, to: Vec3, z: f32| {
        let along = to - from;
        let length = along.length();
        let beam = rounded_cuboid(vec3(-0.06, -0.085, 0.0), vec3(length + 0.06, 0.085, 0.15), 0.03);
        beam.turn_towards(along.x, along.y).at(up(from, z))
    };
    let flange = revolve(&[(0.17, HEIGHT - 0.12), (0.22, HEIGHT - 0.03), (0.22, HEIGHT + 0.03)]);
    let joints = union([
        flange.and(cylinder(0.1, HEIGHT - 2.95).z(2.97)).at(hub),
        cylinder(0.115, 0.42).at(up(elbow, 2.74)),
        cylinder(0.10, 0.28).at(up(column, 2.46)),
    ]);
    let arms = box_arm(hub, elbow, 2.98).and(box_arm(elbow, column, 2.76));
    let body = rounded_cuboid(vec3(-0.15, -0.12, 0.95), vec3(0.15, 0.12, 2.5), 0.03).paint(&paints.enamel);
    let stripe = cuboid(vec3(-0.153, -0.08, 0.97), vec3(0.153, 0.08, 2.46)).paint(&paints.teal);
    let front = |part: Solid, x: f32, z: f32| part.at(vec3(x, -0.12, z));
    let side = |part: Solid, y: f32, z: f32| part.turn_z(90.0).at(vec3(0.15, y, z));
    let collars = [&paints.blue, &paints.yellow, &paints.black, &paints.gauze];
    let outlets = collars.into_iter().enumerate().map(|(i, collar)| {
        let outlet = parts::gas_outlet(shop, collar);
        front(outlet.clone(), 0.0, 2.30 - 0.11 * i as f32).and(side(outlet, 0.0, 2.30 - 0.11 * i as f32))
    });
    let sockets = (0..3).map(|i| {
        let socket = parts::socket(shop);
        side(socket.clone(), 0.0, 1.80 - 0.12 * i as f32).and(side(socket, 0.0, 1.80 - 0.12 * i as f32).mirror_x())
    });
    let column_parts = union([body, stripe, union(outlets), union(sockets), shelves.clone()]);
    union([
        joints.paint(&paints.grey),
        arms.paint(&paints.enamel),
        column_parts.turn_z(turn).at(vec3(column.x, column.y, 0.0)),
        hoses(shop, up(elbow, 2.7), up(column, 2.4)),
    ])
}

/// Hoses that sag between the joints.
fn hoses(shop: &Workshop, from: Vec3, to: Vec3) -> Solid {
    let one = |offset: Vec3| {
        let sag = (from + to) * 0.5 + offset - vec3(0.0, 0.0, 0.22);
        parts::hose(&[from + offset, sag, to + offset], shop.rod(0.014))
    };
    let paints = &shop.paints;
    one(vec3(0.1, 0.0, 0.0)).paint(&paints.blue).and(one(vec3(0.0, 0.11, 0.03)).paint(&paints.black))
}

/// A shelf before the column at a height, with rails at its sides.
fn shelf(shop: &Workshop, z: f32) -> Solid {
    let paints = &shop.paints;
    let board = rounded_cuboid(vec3(-0.30, -0.52, z), vec3(0.30, -0.08, z + 0.035), 0.01).paint(&paints.enamel);
    let rail = cuboid(vec3(0.31, -0.50, z - 0.005), vec3(0.335, -0.1, z + 0.045)).both_x().paint(&paints.steel);
    let grip = bar(vec3(-0.24, -0.56, z + 0.02), vec3(0.24, -0.56, z + 0.02), shop.rod(0.014));
    let posts = bar(vec3(0.24, -0.56, z + 0.02), vec3(0.24, -0.5, z + 0.02), shop.rod(0.012)).both_x();
    union([board, rail, grip.and(posts).paint(&paints.grey)])
}

/// An apparatus, `height` high, with a screen, knobs and plugs, on the shelf at `z`.
pub fn apparatus(shop: &Workshop, height: f32, case: &Paint, picture: &Paint) -> Solid {
    let paints = &shop.paints;
    let body = rounded_cuboid(vec3(-0.23, -0.19, 0.01), vec3(0.23, 0.19, height), 0.015).paint(case);
    let feet = block(0.04, 0.04, 0.02).at(vec3(0.18, 0.14, 0.0)).both_x().both_y().paint(&paints.black);
    let screen = parts::monitor(shop, 0.16, height * 0.5, picture, &paints.black).at(vec3(-0.1, -0.205, height * 0.25));
    let knob = extrude(Profile::Disc(0.022), Axis::Y, -0.225, -0.15).paint(&paints.grey);
    let plugs = [&paints.blue, &paints.yellow, &paints.red]
        .map(|paint| extrude(Profile::Disc(0.016), Axis::Y, -0.215, -0.15).paint(paint));
    let [a, b, c] = plugs;
    let low = height * 0.28;
    let front = union([
        knob.at(vec3(0.06, 0.0, height * 0.65)),
        knob.at(vec3(0.14, 0.0, height * 0.65)),
        a.at(vec3(0.05, 0.0, low)),
        b.at(vec3(0.11, 0.0, low)),
        c.at(vec3(0.17, 0.0, low)),
        block(0.02, 0.03, 0.02).at(vec3(0.2, -0.19, height * 0.6)).paint(&paints.lamp_green),
    ]);
    union([body, feet, screen, front])
}

fn anaesthesia_shelves(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let vitals = parts::monitor(shop, 0.46, 0.30, &paints.screens.vitals(0.46, 0.30), &paints.ivory);
    let on_shelf = |z: f32, height: f32, case: &Paint, picture: &Paint| {
        apparatus(shop, height, case, picture).at(vec3(0.0, -0.30, z))
    };
    let text = paints.screens.text(0.16, 0.1);
    union([
        shelf(shop, 1.06),
        on_shelf(1.095, 0.18, &paints.ivory, &text),
        shelf(shop, 1.42),
        vitals.at(vec3(0.0, -0.42, 1.52)),
        block(0.2, 0.2, 0.06).at(vec3(0.0, -0.3, 1.45)).paint(&paints.grey),
    ])
}

fn surgery_shelves(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let on_shelf = |z: f32, height: f32, case: &Paint, picture: &Paint| {
        apparatus(shop, height, case, picture).at(vec3(0.0, -0.30, z))
    };
    let text = paints.screens.text(0.16, 0.09);
    let light_cable = [
        vec3(0.12, -0.5, 1.2),
        vec3(0.2, -0.62, 1.05),
        vec3(0.3, -0.7, 0.8),
        vec3(0.42, -0.72, 0.72),
        vec3(0.45, -0.6, 0.95),
        vec3(0.36, -0.45, 1.06),
    ];
    union([
        shelf(shop, 1.06),
        on_shelf(1.095, 0.16, &paints.enamel, &text),
        shelf(shop, 1.36),
        on_shelf(1.395, 0.20, &paints.grey, &text),
        shelf(shop, 1.72),
        on_shelf(1.755, 0.14, &paints.ivory, &text),
        parts::hose(&light_cable, shop.rod(0.013)).paint(&paints.black),
    ])
}
