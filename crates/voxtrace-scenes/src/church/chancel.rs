//! The chancel: choir stalls, communion rail, altar with its cross and candles, reredos, flowers.

use super::{CHANCEL, CHANCEL_FLOOR, EAST, HALF_NAVE, SANCTUARY_FLOOR, lights, paints::Paints};
use crate::kit::{noise::*, *};
use glam::{vec2, vec3};

/// Everything that stands in the chancel.
pub fn chancel(paints: &Paints, voxel: f32) -> Solid {
    let flowers = flowers(paints);
    union([
        stalls(paints).both_x().at(vec3(0.0, CHANCEL + 0.5, CHANCEL_FLOOR)),
        rail(paints).both_x().at(vec3(0.0, EAST - 3.0, SANCTUARY_FLOOR)),
        altar(paints, voxel).at(vec3(0.0, EAST - 1.35, SANCTUARY_FLOOR)),
        reredos(paints).at(vec3(0.0, EAST, SANCTUARY_FLOOR)),
        flowers.at(vec3(-2.35, EAST - 1.2, SANCTUARY_FLOOR)),
        flowers.turn_z(70.0).at(vec3(2.35, EAST - 1.2, SANCTUARY_FLOOR)),
        flowers.turn_z(150.0).at(vec3(2.55, CHANCEL - 1.7, 0.0)),
    ])
}

/// Two rows of stalls on the south side that face north, the rear one against a panelled back with a cresting.
fn stalls(paints: &Paints) -> Solid {
    let length = 4.4;
    let desk = |x: f32, z: f32| {
        let front = cuboid(vec3(x, 0.0, z), vec3(x + 0.06, length, z + 0.95));
        let top = cuboid(vec3(x - 0.05, 0.0, z + 0.9), vec3(x + 0.36, length, z + 0.95));
        let niche = extrude(Profile::arch(0.3, 0.36, 0.24), Axis::X, x - 0.1, x + 0.035).at(vec3(0.0, 0.28, z + 0.16));
        let seat = cuboid(vec3(x + 0.72, 0.0, z + 0.42), vec3(x + 1.08, length, z + 0.47));
        let end = cuboid(vec3(x - 0.02, -0.04, z), vec3(x + 0.3, 0.04, z + 1.05));
        let knob = ball(0.09).at(vec3(x + 0.14, 0.0, z + 1.13));
        union([
            front.minus(row(10, vec3(0.0, 0.428, 0.0), &niche)),
            top,
            seat,
            end.and(knob.clone()),
            end.and(knob).y(length),
        ])
    };
    let step = cuboid(vec3(2.05, -0.05, 0.0), vec3(HALF_NAVE, length + 0.05, 0.16));
    let back = cuboid(vec3(HALF_NAVE - 0.1, 0.0, 0.0), vec3(HALF_NAVE + 0.1, length, 2.5));
    let panel =
        extrude(Profile::arch(0.44, 0.9, 0.4), Axis::X, HALF_NAVE - 0.2, HALF_NAVE - 0.05).at(vec3(0.0, 0.3, 1.0));
    let finial = cone(0.06, 0.0, 0.34).and(ball(0.06).z(0.1)).at(vec3(HALF_NAVE - 0.06, 0.04, 2.6));
    let cornice = cuboid(vec3(HALF_NAVE - 0.24, 0.0, 2.42), vec3(HALF_NAVE + 0.1, length, 2.58));
    let wood = union([
        desk(1.35, 0.0),
        desk(2.1, 0.16),
        back.minus(row(8, vec3(0.0, 0.545, 0.0), &panel)),
        cornice,
        row(9, vec3(0.0, 0.54, 0.0), &finial),
    ]);
    wood.paint(&paints.oak_upright).and(step.paint(&paints.oak_across))
}

/// The communion rail south of the middle.
fn rail(paints: &Paints) -> Solid {
    let baluster =
        revolve(&[(0.05, 0.0), (0.05, 0.06), (0.03, 0.1), (0.055, 0.24), (0.03, 0.42), (0.045, 0.56), (0.04, 0.66)]);
    union([
        row(10, vec3(0.24, 0.0, 0.0), &baluster.x(0.86)),
        rounded_cuboid(vec3(0.72, -0.09, 0.64), vec3(HALF_NAVE, 0.09, 0.72), 0.03),
        cuboid(vec3(0.72, -0.06, 0.0), vec3(HALF_NAVE, 0.06, 0.05)),
        cuboid(vec3(0.72, -0.07, 0.0), vec3(0.86, 0.07, 0.72)).and(ball(0.085).at(vec3(0.79, 0.0, 0.78))),
    ])
    .paint(&paints.oak_upright)
}

fn altar(paints: &Paints, voxel: f32) -> Solid {
    let table = block(2.6, 0.9, 1.0).paint(&paints.frontal).at(vec3(0.0, 0.0, 0.0));
    let cloth = union([
        rounded_cuboid(vec3(-1.36, -0.49, 0.99), vec3(1.36, 0.49, 1.04), 0.02),
        cuboid(vec3(1.3, -0.47, 0.45), vec3(1.36, 0.47, 1.03)).both_x(),
        cuboid(vec3(-1.36, -0.5, 0.88), vec3(1.36, -0.45, 1.03)),
    ]);
    let shelf = block(2.5, 0.26, 0.22).at(vec3(0.0, 0.5, 1.0)).paint(&paints.marble);
    let cross = union([
        revolve(&[(0.14, 0.0), (0.14, 0.03), (0.05, 0.1), (0.03, 0.16)]),
        cuboid(vec3(-0.028, -0.028, 0.1), vec3(0.028, 0.028, 0.86)),
        cuboid(vec3(-0.22, -0.028, 0.56), vec3(0.22, 0.028, 0.62)),
        torus(0.11, 0.025).turn_x(90.0).z(0.59),
    ]);
    let stick = lights::candlestick(paints, voxel, 0.42);
    let sticks = union([stick.x(0.45), stick.x(0.75), stick.x(1.05)]).both_x().at(vec3(0.0, 0.5, 1.22));
    let book =
        rounded_cuboid(vec3(-0.2, -0.14, 0.0), vec3(0.2, 0.14, 0.05), 0.015).turn_x(30.0).at(vec3(-0.5, -0.1, 1.12));
    let chalice =
        revolve(&[(0.09, 0.0), (0.03, 0.05), (0.03, 0.12), (0.085, 0.17), (0.09, 0.26)]).at(vec3(0.0, -0.12, 1.04));
    union([
        table,
        union([cloth, book]).paint(&paints.linen),
        shelf,
        union([cross.at(vec3(0.0, 0.5, 1.22)), chalice]).paint(&paints.gilded),
        sticks,
    ])
}

/// A screen of gilded niches with figures behind the altar, and blind arcading on the wall beside it.
fn reredos(paints: &Paints) -> Solid {
    let width = 0.62;
    let niche = extrude(Profile::arch(0.46, 0.8, 0.42), Axis::Y, -0.5, -0.12).z(1.1);
    let gable = extrude(Profile::polygon(&[(-0.3, 0.0), (0.3, 0.0), (0.0, 0.62)]), Axis::Y, -0.32, -0.2);
    let gable = gable.minus(extrude(Profile::Disc(0.1), Axis::Y, -0.5, -0.27).z(0.2)).z(2.3);
    let pinnacle = block(0.1, 0.12, 1.9).and(cone(0.1, 0.0, 0.5).z(1.88)).at(vec3(0.31, -0.3, 0.95));
    let figure = revolve(&[(0.14, 0.0), (0.11, 0.3), (0.13, 0.5), (0.05, 0.6)]).and(ball(0.075).z(0.67));
    let figure = figure.at(vec3(0.0, -0.2, 1.1));
    let screen = cuboid(vec3(-2.2, -0.28, 0.0), vec3(2.2, 0.2, 2.38));
    let count = 7;
    let across = |part: &Solid| row(count, vec3(width, 0.0, 0.0), part).x(-width * 0.5 * (count - 1) as f32);
    let stone = screen.minus(across(&niche)).paint(&paints.carved);
    let gilding = union([across(&gable), across(&pinnacle), pinnacle.x(-width * 0.5 * (count + 1) as f32)]);
    let arch = moulding(Profile::arch(0.5, 1.3, 0.45), Profile::Disc(0.05), Axis::Y).at(vec3(2.58, 0.0, 0.4)).both_x();
    union([stone, gilding.paint(&paints.gilded), across(&figure).paint(&paints.marble), arch.paint(&paints.dressed)])
}

/// A pedestal with a great bunch of white and pink flowers.
fn flowers(paints: &Paints) -> Solid {
    let stand = union([
        revolve(&[(0.18, 0.0), (0.18, 0.04), (0.04, 0.12), (0.035, 0.9), (0.14, 1.0), (0.16, 1.08)]),
        revolve_profile(Profile::Disc(0.03).moved(vec2(0.06, 0.5))),
    ]);
    let sprig = |i: u32| {
        let draw = |k: u32| hash(i * 16 + k + 500);
        let out = vec3(signed(draw(0)), signed(draw(1)), 0.2 + 0.9 * unit(draw(2)));
        let at = out.normalize() * (0.2 + 0.2 * unit(draw(3)));
        (at * vec3(1.0, 1.0, 1.35) + vec3(0.0, 0.0, 1.18), 0.04 + 0.03 * unit(draw(4)))
    };
    let blooms = union((0..46).map(|i| {
        let (at, radius) = sprig(i);
        ball(radius).at(at)
    }));
    let leaves = union((46..80).map(|i| {
        let (at, radius) = sprig(i);
        ellipsoid(vec3(1.6, 0.8, 1.1) * radius).turn_z(360.0 * unit(hash(i))).at(at)
    }));
    let heart = ellipsoid(vec3(0.2, 0.2, 0.24)).z(1.28);
    union([stand.paint(&paints.iron), leaves.and(heart).paint(&paints.leaves), blooms.paint(&paints.flowers)])
}
