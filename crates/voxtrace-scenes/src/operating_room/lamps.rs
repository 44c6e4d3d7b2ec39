//! The surgical lamps: two round heads of many lenses on articulated arms from one hub in the ceiling, and the arm
//! with the surgeon's screens.

use super::{HEIGHT, TABLE, Workshop, fabric::FIELD_DROP, parts};
use crate::kit::{noise::sin_cos_degrees, *};
use glam::{Vec3, vec2, vec3};

/// How deep the lenses lie in their reflectors.
pub const LENS_DEPTH: f32 = 0.016;
/// Radius of a head.
const HEAD: f32 = 0.40;

/// Hub, arms, heads, screens.
pub fn lamps(shop: &Workshop) -> Solid {
    let hub = vec3(TABLE.x + 0.1, TABLE.y + 0.12, 0.0);
    let ceiling = HEIGHT - FIELD_DROP;
    let steel = &shop.paints.enamel;
    let column = union([
        revolve(&[(0.20, ceiling - 0.10), (0.24, ceiling - 0.04), (0.24, ceiling + 0.03)]),
        cylinder(0.075, ceiling - 2.72).z(2.74),
        cylinder(0.11, 0.16).z(3.16),
        cylinder(0.11, 0.16).z(2.94),
        cylinder(0.11, 0.16).z(2.72),
        revolve(&[(0.05, 2.66), (0.10, 2.72)]),
    ]);
    let hub_at = |z: f32| vec3(hub.x, hub.y, z);
    union([
        column.paint(steel).at(vec3(hub.x, hub.y, 0.0)),
        arm(shop, hub_at(3.24), vec3(6.55, 4.05, 3.24), vec3(5.90, 3.55, 2.62)),
        head(shop, vec3(5.90, 3.55, 2.18), -170.0, -34.0),
        arm(shop, hub_at(3.02), vec3(4.45, 5.05, 3.02), vec3(4.55, 4.15, 2.60)),
        head(shop, vec3(4.55, 4.15, 2.16), 101.0, -31.0),
        arm(shop, hub_at(2.80), vec3(5.0, 5.62, 2.80), vec3(4.62, 6.02, 2.36)),
        screens(shop).turn_z(-20.0).at(vec3(4.62, 6.02, 1.50)),
    ])
}

/// A horizontal arm from the hub to the elbow, and a sprung one from there to above `end`.
fn arm(shop: &Workshop, hub: Vec3, elbow: Vec3, end: Vec3) -> Solid {
    let drop = vec3(elbow.x, elbow.y, elbow.z - 0.24);
    let above = vec3(end.x, end.y, end.z + 0.08);
    let enamel = union([
        bar(hub, elbow, 0.052),
        cylinder(0.078, 0.20).at(elbow - vec3(0.0, 0.0, 0.10)),
        cylinder(0.062, 0.18).at(drop - vec3(0.0, 0.0, 0.06)),
        bar(drop, above, 0.046),
    ]);
    let joint = ball(0.07).at(drop).and(ball(0.062).at(above));
    let sleeve = bar(drop + (above - drop) * 0.25, drop + (above - drop) * 0.7, 0.058);
    let rod = cylinder(0.03, 0.2).at(end - vec3(0.0, 0.0, 0.1)).paint(&shop.paints.steel);
    union([enamel.paint(&shop.paints.enamel), joint.paint(&shop.paints.grey), sleeve.paint(&shop.paints.teal), rod])
}

/// A lamp head around `at`: the yoke turned by `yoke` degrees about the vertical, the lamp tilted in it by `pitch`.
fn head(shop: &Workshop, at: Vec3, yoke: f32, pitch: f32) -> Solid {
    let paints = &shop.paints;
    let reach = HEAD + 0.07;
    let arc: Vec<Vec3> = (0..=10)
        .map(|i| {
            let (sin, cos) = sin_cos_degrees(90.0 - 18.0 * (i as f32 - 5.0) * 0.5);
            vec3(cos * reach, 0.0, sin * reach)
        })
        .collect();
    let quarter = bars(&arc, 0.024).and(ball(0.045).x(reach - 0.02));
    let side: Vec<Vec3> = (0..=8)
        .map(|i| {
            let (sin, cos) = sin_cos_degrees(11.25 * i as f32);
            vec3(cos * (reach - 0.02), sin * (reach - 0.02), 0.04)
        })
        .collect();
    let inner = bars(&side, 0.022).and(ball(0.04).at(side[8]));
    let lamp = lamp(shop).turn_x(pitch);
    // The outer half ring hangs from the arm, the inner one turns in it and carries the lamp.
    let gimbal = inner.paint(&paints.enamel).and(lamp);
    quarter.paint(&paints.enamel).and(gimbal).turn_z(yoke).at(at)
}

/// The lamp, its light falling towards −z.
fn lamp(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let shell = revolve(&[
        (HEAD - 0.015, 0.0),
        (HEAD, 0.015),
        (HEAD, 0.07),
        (HEAD - 0.03, 0.11),
        (0.2, 0.15),
        (0.12, 0.2),
        (0.06, 0.21),
    ]);
    let lens = Profile::Disc(0.028);
    let on_ring = |radius: f32, count: u32| lens.clone().moved(vec2(0.0, radius)).ring(count);
    let lenses = on_ring(0.112, 6).and(on_ring(0.216, 12)).and(on_ring(0.32, 18));
    let wells = extrude(lenses, Axis::Z, -0.1, LENS_DEPTH).paint(&paints.lens);
    let rim = torus(HEAD - 0.005, 0.024).z(0.05).paint(&paints.teal);
    let ribs = ring(6, &bar(vec3(0.14, 0.0, 0.165), vec3(HEAD - 0.05, 0.0, 0.095), 0.02)).paint(&paints.grey);
    let handle = revolve(&[
        (0.016, -0.17),
        (0.03, -0.16),
        (0.026, -0.1),
        (0.032, -0.06),
        (0.026, -0.03),
        (0.05, -0.02),
        (0.05, 0.02),
    ]);
    let grip = bar(vec3(HEAD + 0.05, -0.12, 0.03), vec3(HEAD + 0.05, 0.12, 0.03), 0.017);
    let stub = bar(vec3(HEAD - 0.02, 0.12, 0.03), vec3(HEAD + 0.05, 0.12, 0.03), 0.014).both_y();
    let grips = grip.and(stub).turn_z(45.0).both_x().both_y().paint(&paints.steel);
    union([shell.paint(&paints.lamp_shell).minus(wells), rim, ribs, handle.paint(&paints.green), grips])
}

/// Two screens side by side under a cross bar that hangs at z = 0.7.
fn screens(shop: &Workshop) -> Solid {
    let paints = &shop.paints;
    let (width, height) = (0.62, 0.40);
    let endoscope = parts::monitor(shop, width, height, &paints.screens.endoscope(width, height), &paints.grey);
    let vitals = parts::monitor(shop, width, height, &paints.screens.vitals(width, height), &paints.grey);
    let post = cylinder(0.035, 0.72).y(0.11).z(0.16);
    let cross = rounded_cuboid(vec3(-0.5, 0.08, 0.16), vec3(0.5, 0.14, 0.24), 0.02);
    let handle = bar(vec3(-0.2, 0.0, -0.1), vec3(0.2, 0.0, -0.1), shop.rod(0.016));
    let frame = union([post, cross, bar(vec3(0.0, 0.11, 0.86), vec3(0.0, 0.0, 0.86), 0.04)]);
    union([
        endoscope.turn_z(-8.0).at(vec3(-0.355, 0.0, 0.0)),
        vitals.turn_z(8.0).at(vec3(0.355, 0.0, 0.0)),
        frame.paint(&paints.enamel),
        handle.both_x().paint(&paints.steel),
    ])
}
