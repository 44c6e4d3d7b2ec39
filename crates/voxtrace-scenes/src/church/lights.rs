//! What gives light within: chandeliers, lanterns, candles. Rods and flames are at least two voxels thick.

use super::{
    AISLE_INNER, AISLE_OUTER, AISLE_RISE, AISLE_SPRING, BAY, BAYS, CHANCEL, EAST, HALF_NAVE, NAVE_RISE, NAVE_SPRING,
    furniture,
    paints::{FLAME, Paints},
};
use crate::kit::*;
use glam::vec3;

/// All lights but those on the altar.
pub fn lights(paints: &Paints, voxel: f32) -> Solid {
    let top = NAVE_SPRING + NAVE_RISE;
    let hang = |y: f32, z: f32| chandelier(paints, voxel, top - z).at(vec3(0.0, y, z));
    let lantern = lantern(paints, voxel);
    let aisle = vec3((AISLE_INNER + AISLE_OUTER) * 0.5, BAY * 0.5, 3.5);
    let pole = pew_light(paints, voxel);
    let poles = (1..furniture::PEWS).step_by(3).map(|i| pole.at(furniture::pew_end(i)));
    union([
        hang(BAY * 1.5, 5.9),
        hang(BAY * 3.5, 5.9),
        hang(BAY * 5.5 - 0.6, 6.9),
        row(BAYS, vec3(0.0, BAY, 0.0), &lantern.at(aisle)).both_x(),
        union(poles).both_x(),
        sanctuary_lamp(paints, voxel, top - 4.4).at(vec3(0.0, EAST - 3.2, 4.4)),
        candlestick(paints, voxel, 1.15).scaled(1.25).at(vec3(2.1, CHANCEL - 1.6, 0.0)).mirror_x(),
        floods(paints),
        votive_rack(paints, voxel).at(vec3(-6.35, BAY * 4.5, 0.0)),
    ])
}

/// Radius of flames at a voxel size.
pub fn flame_radius(voxel: f32) -> f32 {
    FLAME.max(1.1 * voxel)
}

/// Lamps that nobody in the nave sees: on the capitals and over the string courses, towards the vaults, and behind the
/// chancel arch, towards the altar.
fn floods(paints: &Paints) -> Solid {
    let on_capital = block(0.14, 0.34, 0.05).at(vec3(HALF_NAVE - 0.22, 0.0, AISLE_SPRING + 0.05));
    let on_string = block(0.05, 1.6, 0.04).at(vec3(HALF_NAVE + 0.02, BAY * 0.5, 8.54));
    let behind_arch = cuboid(vec3(2.9, CHANCEL - 0.05, 3.2), vec3(3.1, CHANCEL + 0.05, 6.2));
    union([
        row(BAYS - 1, vec3(0.0, BAY, 0.0), &on_capital.y(BAY)).paint(&paints.lamp),
        row(BAYS, vec3(0.0, BAY, 0.0), &on_string).paint(&paints.flood),
        behind_arch.paint(&paints.lamp),
    ])
    .both_x()
}

/// A flame on the origin.
fn flame(paints: &Paints, voxel: f32) -> Solid {
    let radius = flame_radius(voxel);
    ellipsoid(vec3(radius, radius, 0.055_f32.max(1.6 * voxel))).z(0.05).paint(&paints.flame)
}

/// A candle of a height with its flame.
fn candle(paints: &Paints, voxel: f32, height: f32) -> Solid {
    let wax = cylinder(0.024_f32.max(1.05 * voxel), height).paint(&paints.wax);
    wax.and(flame(paints, voxel).z(height))
}

/// A brass candlestick with a candle.
pub fn candlestick(paints: &Paints, voxel: f32, height: f32) -> Solid {
    let h = height;
    let stick = revolve(&[
        (0.11, 0.0),
        (0.11, 0.03),
        (0.04, 0.08),
        (0.03, 0.3 * h),
        (0.06, 0.4 * h),
        (0.028, 0.5 * h),
        (0.028, 0.92 * h),
        (0.075, 0.97 * h),
        (0.075, h),
    ]);
    stick.paint(&paints.brass).and(candle(paints, voxel, 0.3).z(h))
}

/// A brass chandelier of two tiers; the origin is its middle, `rod` the way up to the vault.
fn chandelier(paints: &Paints, voxel: f32, rod: f32) -> Solid {
    let body = revolve(&[
        (0.0, -0.62),
        (0.05, -0.56),
        (0.03, -0.48),
        (0.17, -0.34),
        (0.2, -0.22),
        (0.14, -0.08),
        (0.05, 0.0),
        (0.08, 0.1),
        (0.05, 0.2),
        (0.11, 0.34),
        (0.1, 0.44),
        (0.04, 0.56),
        (0.06, 0.66),
        (0.03, 0.8),
    ]);
    let thin = 0.018_f32.max(1.05 * voxel);
    let arm = |reach: f32, z: f32| {
        let r = |share: f32, up: f32| vec3(reach * share, 0.0, z + up * reach);
        let curve = [r(0.1, 0.05), r(0.25, -0.1), r(0.45, -0.2), r(0.68, -0.22), r(0.88, -0.12), r(1.0, 0.04)];
        let scroll = torus(0.09 * reach, thin).turn_x(90.0).at(r(0.45, -0.1));
        let pan = revolve(&[(0.02, 0.0), (0.085, 0.05), (0.085, 0.075)]).at(r(1.0, 0.02));
        let light = candle(paints, voxel, 0.13).at(r(1.0, 0.09));
        union([bars(&curve, thin), scroll, pan]).paint(&paints.brass).and(light)
    };
    let tiers = ring(12, &arm(1.05, -0.2)).and(ring(8, &arm(0.66, 0.38)).turn_z(22.5));
    let rod = cylinder(thin, rod).and(torus(0.06, 0.02).turn_x(90.0).z(0.88));
    union([body.paint(&paints.brass), tiers, rod.paint(&paints.iron)])
}

/// An iron lantern on a chain from the aisle vault; the origin is its middle.
fn lantern(paints: &Paints, voxel: f32) -> Solid {
    let thin = 0.02_f32.max(1.05 * voxel);
    let cage = union([
        ring(6, &bar(vec3(0.15, 0.0, -0.24), vec3(0.17, 0.0, 0.2), thin)),
        cone(0.21, 0.05, 0.2).z(0.2),
        cylinder(0.17, 0.04).z(-0.28),
        cone(0.01, 0.06, 0.1).z(-0.38),
        cylinder(thin, AISLE_SPRING + AISLE_RISE - 3.5).z(0.3),
    ]);
    let glass = cylinder(0.085, 0.3).z(-0.18).paint(&paints.lamp);
    cage.paint(&paints.iron).and(glass)
}

/// A slender brass pole with a candle under a glass, at the end of a pew.
fn pew_light(paints: &Paints, voxel: f32) -> Solid {
    let thin = 0.018_f32.max(1.05 * voxel);
    let pole =
        union([cylinder(thin, 1.62), revolve(&[(0.02, 1.58), (0.07, 1.66), (0.07, 1.69)]), torus(thin, 0.03).z(1.1)]);
    pole.paint(&paints.brass).and(candle(paints, voxel, 0.12).z(1.68)).at(vec3(-0.0, 0.17, 0.0))
}

/// The lamp before the altar: a red glass in a brass bowl on three chains.
fn sanctuary_lamp(paints: &Paints, voxel: f32, chain: f32) -> Solid {
    let thin = 0.014_f32.max(1.05 * voxel);
    let bowl = revolve(&[(0.0, -0.24), (0.03, -0.2), (0.12, -0.08), (0.14, 0.0), (0.14, 0.03)]);
    let chains = ring(3, &bar(vec3(0.13, 0.0, 0.0), vec3(0.0, 0.0, 0.8), thin)).and(cylinder(thin, chain - 0.8).z(0.8));
    let glass = cylinder(0.075, 0.2).z(0.0).paint(&paints.votive);
    union([bowl.and(chains).paint(&paints.brass), glass])
}

/// A rack of votive candles before the north wall.
fn votive_rack(paints: &Paints, voxel: f32) -> Solid {
    let shelf =
        |i: f32| cuboid(vec3(-0.2 + 0.14 * i, -0.6, 0.95 - 0.13 * i), vec3(-0.06 + 0.14 * i, 0.6, 0.98 - 0.13 * i));
    let legs =
        cuboid(vec3(-0.2, 0.56, 0.0), vec3(-0.16, 0.6, 0.95)).and(cuboid(vec3(0.3, 0.56, 0.0), vec3(0.34, 0.6, 0.6)));
    let glass = cylinder(0.035_f32.max(1.1 * voxel), 0.09).paint(&paints.votive);
    let rows = union((0..4).map(|i| {
        let i = i as f32;
        row(9, vec3(0.0, 0.13, 0.0), &glass).at(vec3(-0.13 + 0.14 * i, -0.52, 0.98 - 0.13 * i))
    }));
    let iron = union([shelf(0.0), shelf(1.0), shelf(2.0), shelf(3.0), legs.both_y()]);
    iron.paint(&paints.iron).and(rows)
}
