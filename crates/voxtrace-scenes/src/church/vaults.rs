//! The vaults: webs as crossing barrels of equal height whose groins run straight over the diagonals, and ribs under
//! their edges.

use super::{
    AISLE_INNER, AISLE_OUTER, AISLE_RISE, AISLE_SPRING, BAY, BAYS, CHANCEL, CHANCEL_BAY, EAST, HALF_NAVE, NAVE_END,
    NAVE_RISE, NAVE_SPRING, paints::Paints,
};
use crate::kit::*;
use glam::{Vec3, vec2, vec3};

/// A bay to be vaulted: half its size along x and y, and the height of the vault above the springing.
#[derive(Clone, Copy)]
struct Bay {
    half_x: f32,
    half_y: f32,
    rise: f32,
}

const NAVE: Bay = Bay { half_x: HALF_NAVE, half_y: BAY * 0.5, rise: NAVE_RISE };
const AISLE: Bay = Bay { half_x: (AISLE_OUTER - AISLE_INNER) * 0.5, half_y: BAY * 0.5, rise: AISLE_RISE };
const CHOIR: Bay = Bay { half_x: HALF_NAVE, half_y: CHANCEL_BAY * 0.5, rise: NAVE_RISE };
const AISLE_MIDDLE: f32 = (AISLE_OUTER + AISLE_INNER) * 0.5;

impl Bay {
    /// An arch over half a span, stretched from the arch over the narrower side: arches of one bay have the same
    /// height at the same share of their spans, so that barrels cross over straight diagonals.
    fn stretched(self, arch: Profile, half_span: f32) -> Profile {
        arch.stretched((half_span / self.half_x.min(self.half_y)).max(1.0))
    }

    /// The figure under the arch, standing a little below the springing.
    fn barrel(self, half_span: f32) -> Profile {
        self.stretched(Profile::arch(2.0 * self.half_x.min(self.half_y), 0.3, self.rise), half_span)
    }

    /// The line of the arch.
    fn arch(self, half_span: f32) -> Profile {
        self.stretched(Profile::endless_arch(2.0 * self.half_x.min(self.half_y), self.rise), half_span)
    }

    fn diagonal(self) -> f32 {
        vec2(self.half_x, self.half_y).length()
    }

    /// The space under `bays` bays in a row, from y = 0 on.
    fn webs(self, bays: u32) -> Solid {
        let length = 2.0 * self.half_y * bays as f32;
        let cross = extrude(self.barrel(self.half_y), Axis::X, -self.half_x, self.half_x);
        let along = extrude(self.barrel(self.half_x), Axis::Y, 0.0, length);
        row(bays, vec3(0.0, 2.0 * self.half_y, 0.0), &cross.y(self.half_y)).and(along).z(-0.3)
    }

    /// Diagonal, transverse, wall and ridge ribs with bosses for `bays` bays in a row, from y = 0 on.
    fn ribs(self, bays: u32, width: f32, paints: &Paints) -> Solid {
        let section = |width: f32| {
            Profile::rectangle(vec2(-0.8 * width, -0.5 * width), vec2(0.6 * width, 0.5 * width))
                .and(Profile::Disc(0.42 * width).moved(vec2(-width, 0.0)))
        };
        let diagonal = moulding(self.arch(self.diagonal()), section(width), Axis::Y);
        let diagonals = diagonal.turn_towards(self.half_x, self.half_y).both_x();
        let wall = moulding(self.arch(self.half_y), Profile::Disc(0.5 * width), Axis::X).x(self.half_x).both_x();
        let top = vec3(0.0, 0.0, self.rise);
        let ridge = bar(top - Vec3::X * self.half_x, top + Vec3::X * self.half_x, 0.4 * width);
        let bay = union([diagonals, wall, ridge]).y(self.half_y);
        let step = vec3(0.0, 2.0 * self.half_y, 0.0);
        let transverse = moulding(self.arch(self.half_x), section(width * 1.35), Axis::Y);
        let ridge = bar(top, top + step * bays as f32, 0.4 * width);
        let above = half_space(vec3(0.0, 0.0, -0.05), Vec3::NEG_Z);
        let ribs = union([row(bays, step, &bay), row(bays + 1, step, &transverse), ridge]).within(above);
        let leaf = ellipsoid(vec3(0.9, 0.5, 0.4) * width).x(1.25 * width);
        let boss = ellipsoid(vec3(1.2, 1.2, 0.8) * width).and(ring(6, &leaf)).z(self.rise - 0.55 * width);
        let bosses = row(bays, step, &boss.y(self.half_y)).paint(&paints.gilded);
        union([ribs.paint(&paints.dressed), bosses])
    }
}

/// The spaces under all vaults.
pub fn webs(paints: &Paints) -> Solid {
    union([
        NAVE.webs(BAYS).z(NAVE_SPRING),
        CHOIR.webs(2).at(vec3(0.0, CHANCEL, NAVE_SPRING)),
        AISLE.webs(BAYS).at(vec3(AISLE_MIDDLE, 0.0, AISLE_SPRING)).both_x(),
    ])
    .paint(&paints.vault)
}

/// The ribs of all vaults, and the shafts that carry those of nave and chancel.
pub fn ribs(paints: &Paints) -> Solid {
    let shaft = shaft(paints);
    let pair = shaft.turn_z(90.0).x(HALF_NAVE).both_x();
    union([
        NAVE.ribs(BAYS, 0.17, paints).z(NAVE_SPRING),
        CHOIR.ribs(2, 0.17, paints).at(vec3(0.0, CHANCEL, NAVE_SPRING)),
        AISLE.ribs(BAYS, 0.13, paints).at(vec3(AISLE_MIDDLE, 0.0, AISLE_SPRING)).both_x(),
        row(BAYS + 1, vec3(0.0, BAY, 0.0), &pair).within(cuboid(vec3(-9.0, 0.0, 0.0), vec3(9.0, NAVE_END, 20.0))),
        row(3, vec3(0.0, CHANCEL_BAY, 0.0), &pair.y(CHANCEL))
            .within(cuboid(vec3(-9.0, CHANCEL, 0.0), vec3(9.0, EAST, 20.0))),
        row(BAYS + 1, vec3(0.0, BAY, 0.0), &respond(paints).x(AISLE_OUTER).both_x())
            .within(cuboid(vec3(-9.0, 0.0, 0.0), vec3(9.0, NAVE_END, 20.0))),
    ])
}

/// Three slender shafts on a corbel, in front of the plane y = 0 (towards +y), up to the springing of the nave.
fn shaft(paints: &Paints) -> Solid {
    let low = 5.35;
    let one = |x: f32, y: f32, radius: f32| {
        let height = NAVE_SPRING - low;
        let body = cylinder(radius, height);
        let rings = torus(radius + 0.01, 0.04).z(0.06).and(torus(radius + 0.01, 0.035).z(7.02 - low));
        let capital = revolve(&[
            (radius, height - 0.34),
            (radius + 0.05, height - 0.30),
            (radius, height - 0.26),
            (radius + 0.10, height - 0.06),
            (radius + 0.12, height + 0.04),
        ]);
        union([body, rings, capital]).at(vec3(x, y, low))
    };
    let corbel =
        revolve(&[(0.02, -0.75), (0.09, -0.68), (0.07, -0.6), (0.16, -0.42), (0.2, -0.2), (0.27, -0.04), (0.27, 0.03)]);
    let leaves = ring(8, &ellipsoid(vec3(0.07, 0.06, 0.11)).at(vec3(0.18, 0.0, -0.28)));
    union([one(0.0, 0.08, 0.11), one(0.17, 0.0, 0.08), one(-0.17, 0.0, 0.08), corbel.and(leaves).z(low)])
        .paint(&paints.carved)
}

/// A half column against the outer wall, from the floor to the aisle vault.
fn respond(paints: &Paints) -> Solid {
    union([
        cylinder(0.2, AISLE_SPRING),
        revolve(&[(0.36, 0.0), (0.36, 0.34), (0.3, 0.42), (0.33, 0.5), (0.2, 0.6)]),
        revolve(&[(0.2, 3.8), (0.25, 3.86), (0.2, 3.9), (0.24, 4.02), (0.36, 4.2), (0.36, 4.34)]),
        cylinder(0.07, AISLE_SPRING).at(vec3(-0.1, 0.2, 0.0)).both_y(),
    ])
    .paint(&paints.dressed)
}
