//! What rolls: the C-arm with its monitors, the ultrasound and electrosurgery carts, suction, waste, linen.

use super::{Workshop, parts, pendants};
use crate::kit::*;
use glam::{Vec3, vec2, vec3};

/// Everything on wheels but the anaesthetist's.
pub fn carts(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    union([
        c_arm(shop).turn_z(-72.0).at(vec3(8.05, 2.85, 0.0)),
        monitor_cart(shop).turn_z(-60.0).at(vec3(9.75, 4.75, 0.0)),
        ultrasound(shop).turn_z(20.0).at(vec3(5.15, 7.75, 0.0)),
        electrosurgery(shop).turn_z(60.0).at(vec3(3.35, 4.55, 0.0)),
        suction(shop).turn_z(-20.0).at(vec3(6.55, 2.75, 0.0)),
        waste(shop, &paints.yellow).at(vec3(4.95, 0.45, 0.0)),
        waste(shop, &paints.red).at(vec3(4.4, 0.45, 0.0)),
        waste(shop, &paints.grey).at(vec3(7.95, 0.4, 0.0)),
        linen(shop, &paints.green_cloth).at(vec3(9.75, 7.35, 0.0)),
        linen(shop, &paints.blue_cloth).at(vec3(9.15, 7.6, 0.0)),
        linen(shop, &paints.gauze).at(vec3(3.98, 0.5, 0.0)),
        wheelchair_lift(shop).at(vec3(1.2, 7.1, 0.0)),
        cables(shop),
    ])
}

/// A mobile C-arm, its C in the plane (x, z), open towards −x.
fn c_arm(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let radius = 0.72;
    let arc = Profile::Disc(radius).outline(0.13).minus(Profile::rectangle(vec2(-2.0, -2.0), vec2(-0.30, 2.0)));
    let c = extrude(arc, Axis::Y, -0.05, 0.05).paint(&paints.enamel);
    let track =
        Profile::Disc(radius + 0.065).outline(0.03).minus(Profile::rectangle(vec2(-2.0, -2.0), vec2(-0.28, 2.0)));
    let track = extrude(track, Axis::Y, -0.025, 0.025).paint(&paints.steel);
    let intensifier =
        union([cylinder(0.16, 0.12).z(0.38), revolve(&[(0.16, 0.5), (0.13, 0.56), (0.13, 0.72), (0.09, 0.78)])]);
    let plate = cylinder(0.165, 0.03).z(0.36).paint(&paints.grey);
    let source = rounded_cuboid(vec3(-0.15, -0.13, -0.86), vec3(0.15, 0.13, -0.58), 0.04).paint(&paints.enamel);
    let nozzle = cone(0.10, 0.07, 0.08).z(-0.58).paint(&paints.grey);
    let ring_ =
        union([c, track, intensifier.paint(&paints.enamel).x(-0.26), plate.x(-0.26), source.x(-0.26), nozzle.x(-0.26)]);
    let ring_ = ring_.turn_y(18.0).z(1.16);
    let slide = rounded_cuboid(vec3(0.66, -0.09, 1.04), vec3(0.94, 0.09, 1.30), 0.03).paint(&paints.grey);
    let beam = rounded_cuboid(vec3(0.9, -0.06, 1.10), vec3(1.30, 0.06, 1.24), 0.03).paint(&paints.steel);
    let column = rounded_cuboid(vec3(1.18, -0.15, 0.2), vec3(1.44, 0.15, 1.36), 0.04).paint(&paints.enamel);
    let cabinet = rounded_cuboid(vec3(1.02, -0.28, 0.14), vec3(1.72, 0.28, 0.80), 0.05).paint(&paints.enamel);
    let stripe = cuboid(vec3(1.015, -0.285, 0.42), vec3(1.725, 0.285, 0.48)).paint(&paints.blue);
    let panel = parts::monitor(shop, 0.22, 0.15, &paints.screens.text(0.22, 0.15), &paints.black);
    let panel = panel.turn_x(-30.0).turn_z(90.0).at(vec3(1.56, 0.0, 1.0));
    let legs = rounded_cuboid(vec3(0.25, 0.30, 0.07), vec3(1.6, 0.40, 0.16), 0.03).both_y().paint(&paints.grey);
    let handle = bars(
        &[vec3(1.72, -0.24, 0.78), vec3(1.84, -0.24, 0.92), vec3(1.84, 0.24, 0.92), vec3(1.72, 0.24, 0.78)],
        0.018,
    );
    let wheel = parts::castor(shop, 0.12);
    let wheels = union([wheel.at(vec3(0.32, 0.35, 0.0)), wheel.scaled(1.2).at(vec3(1.5, 0.35, 0.0))]).both_y();
    let cable = [
        vec3(-0.1, 0.05, 1.95),
        vec3(0.4, 0.12, 2.02),
        vec3(0.9, 0.2, 1.75),
        vec3(1.15, 0.25, 1.2),
        vec3(1.3, 0.27, 0.85),
    ];
    let cable = parts::hose(&cable, shop.rod(0.018)).paint(&paints.black);
    union([ring_, slide, beam, column, cabinet, stripe, panel, legs, handle.paint(&paints.grey), wheels, cable])
}

/// The C-arm's monitors: two screens on a cart with a keyboard.
fn monitor_cart(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let body = rounded_cuboid(vec3(-0.34, -0.26, 0.14), vec3(0.34, 0.26, 0.84), 0.03).paint(&paints.enamel);
    let panel = cuboid(vec3(-0.28, -0.275, 0.2), vec3(0.28, -0.2, 0.6)).paint(&paints.grey);
    let slit = row(6, vec3(0.0, 0.0, 0.05), &cuboid(vec3(-0.2, -0.4, 0.26), vec3(0.2, -0.255, 0.28)));
    let column = parts::pillar(0.14, 0.10, 0.62, 0.03).at(vec3(0.0, 0.1, 0.8)).paint(&paints.grey);
    let screen = |paint: &Paint| parts::monitor(shop, 0.44, 0.36, paint, &paints.black);
    let left = screen(&paints.screens.fluoroscope(0.44, 0.36)).turn_z(-12.0).at(vec3(-0.26, -0.02, 1.16));
    let right = screen(&paints.screens.fluoroscope(0.44, 0.36)).turn_z(12.0).at(vec3(0.26, -0.02, 1.16));
    let shelf = rounded_cuboid(vec3(-0.3, -0.48, 0.84), vec3(0.3, 0.2, 0.87), 0.01).paint(&paints.grey);
    let warning = block(0.06, 0.06, 0.08).at(vec3(0.0, 0.05, 1.62)).paint(&paints.lamp_red);
    let cross = cuboid(vec3(-0.3, 0.06, 1.3), vec3(0.3, 0.12, 1.38)).paint(&paints.grey);
    union([
        body,
        panel.minus(slit),
        column.and(cylinder(0.03, 0.3).at(vec3(0.0, 0.1, 1.36)).paint(&paints.grey)),
        cross,
    ])
    .and(union([left, right, shelf, warning, parts::keyboard(shop).at(vec3(0.0, -0.38, 0.87))]))
    .and(parts::castors(shop, 0.6, 0.46, 0.14))
}

/// An ultrasound cart: console, screen on an arm, probes.
fn ultrasound(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let body = rounded_cuboid(vec3(-0.24, -0.24, 0.14), vec3(0.24, 0.28, 0.72), 0.05).paint(&paints.enamel);
    let column = parts::pillar(0.2, 0.2, 0.3, 0.04).at(vec3(0.0, 0.08, 0.65)).paint(&paints.grey);
    let console = rounded_cuboid(vec3(-0.30, -0.46, 0.0), vec3(0.30, 0.10, 0.07), 0.03).paint(&paints.ivory);
    let key = block(0.03, 0.03, 0.03).z(0.055).paint(&paints.grey);
    let keys = union((0..3).map(|j| row(9, vec3(0.05, 0.0, 0.0), &key).at(vec3(-0.2, -0.12 - 0.05 * j as f32, 0.0))));
    let ball_ = ball(0.03).at(vec3(0.0, -0.34, 0.07)).paint(&paints.blue);
    let console = union([console, keys, ball_]).turn_x(-8.0).z(0.92);
    let screen = parts::monitor(shop, 0.46, 0.36, &paints.screens.ultrasound(0.46, 0.36), &paints.black);
    let arm = bars(&[vec3(0.0, 0.1, 0.9), vec3(0.0, 0.12, 1.2), vec3(0.0, 0.08, 1.4)], 0.03).paint(&paints.grey);
    let probe = bar(vec3(0.36, -0.1, 0.86), vec3(0.36, -0.12, 1.02), 0.024).paint(&paints.ivory);
    let lead = [vec3(0.36, -0.1, 0.84), vec3(0.38, -0.2, 0.5), vec3(0.3, -0.3, 0.4), vec3(0.22, -0.25, 0.6)];
    let lead = parts::hose(&lead, shop.rod(0.01)).paint(&paints.black);
    let probes = union([probe.clone(), probe.y(0.1), lead.clone(), lead.y(0.1)]).both_x();
    union([body, column, console, screen.at(vec3(0.0, -0.02, 1.24)), arm, probes])
        .and(parts::castors(shop, 0.48, 0.48, 0.14))
}

/// The electrosurgery cart: generators on shelves, pedals before it.
fn electrosurgery(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let post = cylinder(0.018, 1.18).at(vec3(0.25, 0.2, 0.08)).and(cylinder(0.018, 0.9).at(vec3(0.25, -0.2, 0.08)));
    let shelf = rounded_cuboid(vec3(-0.28, -0.24, 0.0), vec3(0.28, 0.24, 0.03), 0.01).paint(&paints.enamel);
    let text = paints.screens.text(0.16, 0.09);
    let generator = pendants::apparatus(shop, 0.18, &paints.enamel, &text);
    let plume = pendants::apparatus(shop, 0.24, &paints.grey, &text);
    let top = union([
        parts::boxes(shop, 0.5, 0.3, 0.16, &paints.boxes, 401).at(vec3(-0.25, -0.1, 1.01)),
        bar(vec3(-0.2, -0.19, 1.03), vec3(0.1, -0.16, 1.03), shop.rod(0.012)).paint(&paints.blue),
    ]);
    let pedal = rounded_cuboid(vec3(-0.16, -0.09, 0.0), vec3(0.16, 0.09, 0.05), 0.02).paint(&paints.grey);
    let plates = block(0.11, 0.13, 0.04).turn_x(8.0).at(vec3(0.075, -0.01, 0.035));
    let pedals = union([pedal, plates.paint(&paints.yellow), plates.mirror_x().paint(&paints.blue)]);
    let wire = [
        vec3(0.1, -0.45, 0.02),
        vec3(0.2, -0.4, 0.015),
        vec3(0.3, -0.1, 0.015),
        vec3(0.2, 0.25, 0.2),
        vec3(0.15, 0.2, 0.5),
    ];
    union([
        post.both_x().paint(&paints.steel),
        shelf.z(0.14),
        shelf.z(0.58),
        shelf.z(0.98),
        generator.z(0.61),
        plume.z(0.17),
        top,
        parts::castors(shop, 0.48, 0.4, 0.1),
        pedals.turn_z(25.0).at(vec3(0.0, -0.5, 0.0)),
        parts::hose(&wire, shop.rod(0.01)).paint(&paints.black),
    ])
}

/// A suction cart with two canisters and their tubes.
fn suction(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let post = cylinder(0.022, 1.0).z(0.08).paint(&paints.steel);
    let jar = cylinder(0.085, 0.26).paint(&paints.gauze);
    let filled = cylinder(0.088, 0.11).paint(&paints.red);
    let lid = cylinder(0.092, 0.03).z(0.26).paint(&paints.blue);
    let jar = union([jar, filled, lid, cylinder(0.02, 0.06).z(0.28).paint(&paints.grey)]);
    let gauge = extrude(Profile::Disc(0.06), Axis::Y, -0.05, 0.02).z(1.02).paint(&paints.enamel);
    let bracket = cuboid(vec3(-0.2, -0.02, 0.68), vec3(0.2, 0.02, 0.73)).paint(&paints.steel);
    let tube = |side: f32| {
        let path = [
            vec3(0.19 * side, 0.0, 0.78),
            vec3(0.25 * side, -0.1, 0.9),
            vec3(0.3 * side, -0.25, 0.5),
            vec3(0.1 * side, -0.35, 0.3),
            vec3(-0.2 * side, -0.3, 0.6),
        ];
        parts::hose(&path, shop.rod(0.012)).paint(&paints.ivory)
    };
    union([parts::star_base(shop, 0.3, 0.11), post, jar.at(vec3(0.19, 0.0, 0.44)), jar.at(vec3(-0.19, 0.0, 0.44))])
        .and(union([gauge, bracket, tube(1.0), tube(-1.0)]))
}

/// A pedal bin, 70 cm high.
fn waste(shop: &Workshop, lid: &Paint) -> Solid {
    let paints = &shop.paints;
    let body = rounded_cuboid(vec3(-0.2, -0.2, 0.05), vec3(0.2, 0.2, 0.64), 0.03).paint(&paints.brushed);
    let bag = rounded_cuboid(vec3(-0.215, -0.215, 0.56), vec3(0.215, 0.215, 0.65), 0.03).paint(&paints.gauze);
    let cover = rounded_cuboid(vec3(-0.21, -0.21, 0.65), vec3(0.21, 0.21, 0.71), 0.03).paint(lid);
    let pedal = block(0.12, 0.1, 0.03).at(vec3(0.0, 0.24, 0.03)).paint(&paints.black);
    let label = cuboid(vec3(-0.1, 0.19, 0.3), vec3(0.1, 0.21, 0.5)).paint(lid);
    union([
        body,
        bag,
        cover,
        pedal,
        label,
        cuboid(vec3(-0.19, -0.19, 0.0), vec3(0.19, 0.19, 0.06)).paint(&paints.black),
    ])
}

/// A linen hamper: a cloth bag in a frame on castors.
fn linen(shop: &Workshop, cloth: &Paint) -> Solid {
    let paints = &shop.paints;
    let bag = revolve(&[(0.16, 0.16), (0.23, 0.22), (0.255, 0.4), (0.235, 0.62), (0.225, 0.86), (0.24, 0.89)]);
    let pleats = ring(14, &bar(vec3(0.2, 0.0, 0.2), vec3(0.226, 0.0, 0.85), 0.028));
    let rim = torus(0.24, 0.02).z(0.88).paint(&paints.steel);
    let lid = cylinder(0.25, 0.025).z(0.91).paint(&paints.enamel);
    let leg = bars(&[vec3(0.26, 0.0, 0.88), vec3(0.29, 0.0, 0.12), vec3(0.0, 0.0, 0.12)], 0.014);
    let leg = leg.paint(&paints.steel).and(parts::castor(shop, 0.1).x(0.29));
    union([bag.and(pleats).paint(cloth), rim, lid, ring(4, &leg).turn_z(45.0)])
}

/// A patient lifter folded into the corner: mast, boom, spread legs.
fn wheelchair_lift(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let legs = bar(vec3(0.08, 0.0, 0.1), vec3(0.3, -0.95, 0.08), 0.03).both_x();
    let mast = bar(vec3(0.0, 0.0, 0.1), vec3(0.0, 0.0, 1.45), 0.038);
    let boom = bars(&[vec3(0.0, 0.0, 1.45), vec3(0.0, -0.45, 1.78), vec3(0.0, -0.85, 1.72)], 0.032);
    let piston = bar(vec3(0.0, -0.08, 0.8), vec3(0.0, -0.4, 1.7), 0.025).paint(&paints.steel);
    let hanger = bars(&[vec3(-0.25, -0.85, 1.5), vec3(0.0, -0.85, 1.64), vec3(0.25, -0.85, 1.5)], 0.02);
    let strap = bar(vec3(0.0, -0.85, 1.7), vec3(0.0, -0.85, 1.62), 0.02);
    let handles = bar(vec3(-0.2, 0.1, 1.1), vec3(0.2, 0.1, 1.1), 0.02).paint(&paints.black);
    let sling = ellipsoid(vec3(0.24, 0.12, 0.2)).at(vec3(0.0, -0.85, 1.28)).paint(&paints.blue_cloth);
    let wheels =
        parts::castor(shop, 0.1).at(vec3(0.3, -0.95, 0.0)).and(parts::castor(shop, 0.12).at(vec3(0.12, 0.05, 0.0)));
    union([
        legs.and(mast).and(boom).and(hanger).and(strap).paint(&paints.enamel),
        piston,
        handles,
        sling,
        wheels.both_x(),
    ])
}

/// Cables and hoses across the floor.
fn cables(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let cable =
        |points: &[(f32, f32)], radius: f32, paint: &Paint| parts::floor_cable(shop, points, radius).paint(paint);
    let riser = |x: f32, y: f32, z: f32, paint: &Paint| {
        let foot = vec3(x, y, 0.0);
        bar(foot, foot + Vec3::Z * z, shop.rod(0.012)).paint(paint)
    };
    union([
        cable(
            &[(3.2, 4.75), (3.0, 5.1), (2.6, 5.6), (2.3, 6.6), (2.5, 7.4), (4.2, 7.9), (4.6, 8.52)],
            0.013,
            &paints.black,
        ),
        riser(4.6, 8.52, 1.1, &paints.black),
        cable(&[(8.3, 1.3), (7.6, 1.5), (7.4, 1.1), (8.4, 0.8), (9.3, 0.9), (9.4, 0.08)], 0.016, &paints.grey),
        riser(9.4, 0.08, 1.1, &paints.grey),
        cable(&[(8.7, 1.5), (9.3, 2.1), (9.0, 3.2), (9.4, 3.9), (9.6, 4.4)], 0.016, &paints.black),
        cable(&[(5.1, 4.0), (4.8, 3.4), (4.3, 3.0), (3.7, 3.4), (3.3, 4.0), (3.3, 4.35)], 0.012, &paints.blue),
        cable(&[(6.5, 2.9), (6.1, 3.2), (5.7, 3.1), (5.5, 3.5), (5.6, 3.9)], 0.014, &paints.ivory),
        cable(&[(5.3, 8.0), (5.8, 8.2), (6.3, 8.0), (6.2, 8.52)], 0.012, &paints.black),
        riser(6.2, 8.52, 1.1, &paints.black),
        cable(&[(7.6, 5.8), (7.2, 6.6), (7.6, 7.4), (8.2, 7.8), (8.3, 8.52)], 0.014, &paints.yellow),
    ])
}
