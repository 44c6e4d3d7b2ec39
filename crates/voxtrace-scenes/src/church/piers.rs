//! The arcade piers: a core with eight shafts on a moulded base, under a capital of two rows of leaves.

use super::{AISLE_INNER, AISLE_SPRING, BAY, BAYS, HALF_NAVE, NAVE_END, paints::Paints};
use crate::kit::*;
use glam::vec3;

/// A regular octagon, flat sides towards the axes, `width` between opposite sides.
pub fn octagon(width: f32) -> Profile {
    Profile::Octagon(width * 0.5)
}

/// All piers, and half piers at both ends.
pub fn arcades(paints: &Paints) -> Solid {
    let x = 0.5 * (HALF_NAVE + AISLE_INNER);
    let inside = cuboid(vec3(-9.0, 0.0, -1.0), vec3(9.0, NAVE_END, 20.0));
    row(BAYS + 1, vec3(0.0, BAY, 0.0), &pier(paints).x(x)).both_x().within(inside)
}

fn pier(paints: &Paints) -> Solid {
    let prism = |width: f32, from: f32, to: f32| extrude(octagon(width), Axis::Z, from, to);
    let base = union([
        prism(1.36, 0.0, 0.26),
        prism(1.24, 0.2, 0.36),
        revolve(&[(0.62, 0.3), (0.62, 0.4), (0.57, 0.44), (0.53, 0.5), (0.57, 0.56), (0.55, 0.61), (0.46, 0.66)]),
    ]);
    let shaft = |radius: f32, out: f32| {
        let foot = torus(radius + 0.02, 0.045).z(0.68);
        let band = torus(radius + 0.005, 0.035).z(2.15);
        let neck = torus(radius + 0.005, 0.04).z(3.62);
        union([cylinder(radius, 4.1), foot, band, neck]).x(out)
    };
    let shafts = ring(4, &shaft(0.145, 0.385)).and(ring(4, &shaft(0.085, 0.44)).turn_z(45.0));
    let body = union([cylinder(0.38, 4.1), shafts]);
    let bell = revolve(&[(0.48, 3.62), (0.5, 3.72), (0.52, 3.86), (0.58, 4.0), (0.68, 4.12), (0.68, 4.16)]);
    let low = ellipsoid(vec3(0.08, 0.11, 0.15)).turn_y(25.0).at(vec3(0.56, 0.0, 3.84));
    let tip = ball(0.055).at(vec3(0.66, 0.0, 3.92));
    let high = ellipsoid(vec3(0.09, 0.1, 0.12)).turn_y(35.0).at(vec3(0.66, 0.0, 4.03));
    let leaves = ring(12, &low.and(tip)).and(ring(12, &high).turn_z(15.0));
    let abacus = union([prism(1.42, 4.14, 4.22), prism(1.5, 4.22, AISLE_SPRING + 0.04)]);
    union([
        base.paint(&paints.dressed),
        body.paint(&paints.ashlar),
        union([bell, leaves]).paint(&paints.carved),
        abacus.paint(&paints.dressed),
    ])
}
