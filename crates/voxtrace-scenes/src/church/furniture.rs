//! Pews, pulpit, lectern, font, and the monuments on the walls.

use super::{AISLE_OUTER, BAY, BAYS, NAVE_END, paints::Paints, piers::octagon};
use crate::kit::{noise::*, *};
use glam::{vec2, vec3};

/// First row of pews, and the distance between rows.
const FIRST_PEW: f32 = 5.0;
const PEW_STEP: f32 = 0.94;
/// Rows of pews.
pub const PEWS: u32 = 20;
/// From the middle of the nave to the pews, and their length.
const PEW_X: f32 = 1.06;
const PEW_LENGTH: f32 = 1.86;

/// Where the end of a pew stands, on the south side.
pub fn pew_end(index: u32) -> glam::Vec3 {
    vec3(PEW_X, FIRST_PEW + PEW_STEP * index as f32, 0.06)
}

/// The rows of pews on both sides, on their platforms.
pub fn pews(paints: &Paints) -> Solid {
    let frame = pew(paints);
    let length = PEW_STEP * PEWS as f32 + 0.5;
    let platform =
        cuboid(vec3(PEW_X - 0.08, FIRST_PEW - 0.5, -0.1), vec3(PEW_X + PEW_LENGTH + 0.06, FIRST_PEW + length, 0.06));
    let side = |seed: u32| {
        let rows = (0..PEWS).map(|i| frame.and(things(paints, seed + i)).at(pew_end(i)));
        union(rows).and(platform.paint(&paints.oak_across))
    };
    side(0).and(side(1000).mirror_x())
}

/// A pew from x = 0 to its length; who sits on it looks towards +y. Panelled back, ledge for books, carved ends.
fn pew(paints: &Paints) -> Solid {
    let l = PEW_LENGTH;
    let boards = union([
        cuboid(vec3(0.0, 0.0, 0.41), vec3(l, 0.42, 0.46)),
        cuboid(vec3(0.0, 0.06, 0.05), vec3(l, 0.10, 0.43)),
        cuboid(vec3(0.0, -0.03, 0.30), vec3(l, 0.03, 0.90)),
        bar(vec3(0.0, 0.0, 0.92), vec3(l, 0.0, 0.92), 0.045),
        cuboid(vec3(0.0, -0.21, 0.74), vec3(l, -0.02, 0.77)),
        cuboid(vec3(0.0, -0.22, 0.74), vec3(l, -0.19, 0.80)),
    ]);
    let panel = cuboid(vec3(0.0, -0.06, 0.36), vec3(0.36, -0.015, 0.70));
    let boards = boards.minus(row(4, vec3(0.45, 0.0, 0.0), &panel).x(0.07));
    let outline = Profile::polygon(&[
        (-0.13, 0.0),
        (0.47, 0.0),
        (0.47, 0.44),
        (0.44, 0.52),
        (0.32, 0.58),
        (0.2, 0.7),
        (0.13, 0.9),
        (0.1, 1.02),
        (-0.08, 1.02),
        (-0.13, 0.9),
    ]);
    // A poppyhead: three buds over the end.
    let poppy = Profile::Disc(0.075)
        .moved(vec2(0.0, 1.2))
        .and(Profile::Disc(0.06).moved(vec2(0.09, 1.11)))
        .and(Profile::Disc(0.06).moved(vec2(-0.07, 1.11)))
        .and(Profile::rectangle(vec2(-0.06, 1.0), vec2(0.08, 1.1)));
    let end = extrude(outline.and(poppy), Axis::X, -0.04, 0.04);
    let niche = extrude(Profile::arch(0.26, 0.35, 0.22), Axis::X, -0.08, -0.015).at(vec3(0.16, 0.0, 0.0));
    let niche = niche.turn_z(0.0).at(vec3(-0.16, 0.17, 0.1));
    let end = end.minus(niche);
    let ends = end.and(end.mirror_x().x(l));
    union([boards.paint(&paints.oak), ends.paint(&paints.oak_upright)])
}

/// Kneelers on the floor and hymn books on the ledge, as people left them.
fn things(paints: &Paints, seed: u32) -> Solid {
    let kneeler = rounded_cuboid(vec3(-0.17, -0.1, 0.0), vec3(0.17, 0.1, 0.12), 0.03).paint(&paints.kneelers);
    let book = block(0.13, 0.17, 0.035).paint(&paints.books);
    let place = |i: u32| {
        let draw = |k: u32| hash(seed * 64 + i * 8 + k);
        let x = 0.3 + 0.42 * i as f32;
        let turn = 12.0 * signed(draw(1));
        let lies = unit(draw(2)) < 0.8;
        let hangs = unit(draw(3)) < 0.5;
        let kneeler = if hangs {
            kneeler.turn_x(80.0).at(vec3(x, -0.16, 0.45))
        } else {
            kneeler.turn_z(turn).at(vec3(x, -0.36, 0.0))
        };
        let book = book.turn_z(turn).at(vec3(x + 0.1 * signed(draw(4)), -0.12, 0.77));
        let pile = if unit(draw(5)) < 0.3 { book.and(book.turn_z(0.5 * turn).at(vec3(0.0, 0.0, 0.035))) } else { book };
        let mut parts = vec![kneeler];
        if lies {
            parts.push(pile);
        }
        union(parts)
    };
    union((0..4).map(place))
}

/// The pulpit to the north of the chancel arch, the brass lectern to the south, the font in the north-west.
pub fn pulpit_and_lectern(paints: &Paints) -> Solid {
    let prism = |width: f32, from: f32, to: f32| extrude(octagon(width), Axis::Z, from, to);
    let tub = prism(1.2, 1.35, 2.45).minus(prism(1.06, 1.45, 3.0));
    let panel = extrude(Profile::arch(0.3, 0.45, 0.28), Axis::X, 0.56, 0.7).z(1.55);
    let tub = tub.minus(ring(8, &panel));
    let rail = prism(1.32, 2.4, 2.5).minus(prism(1.0, 2.3, 2.6));
    let sill = prism(1.3, 1.32, 1.42);
    let tester =
        union([prism(1.6, 3.55, 3.7), prism(1.3, 3.68, 3.8), revolve(&[(0.5, 3.78), (0.12, 4.25), (0.0, 4.7)])]);
    let crockets = ring(8, &cone(0.07, 0.0, 0.3).at(vec3(0.74, 0.0, 3.7)));
    let post = cuboid(vec3(-0.12, -0.7, 1.4), vec3(0.12, -0.58, 3.6)).turn_z(180.0);
    let stem = revolve(&[
        (0.5, 0.0),
        (0.5, 0.14),
        (0.34, 0.22),
        (0.2, 0.4),
        (0.17, 0.8),
        (0.22, 0.86),
        (0.17, 0.92),
        (0.3, 1.2),
        (0.62, 1.36),
    ]);
    let stairs = union((0..6).map(|i| {
        let i = i as f32;
        cuboid(vec3(-0.95 - 0.22 * (5.0 - i), 0.0, 0.0), vec3(-0.5 - 0.22 * (5.0 - i), 0.75, 0.23 * (i + 1.0)))
    }));
    let pulpit = union([
        union([tub, post, stairs.y(-0.2)]).paint(&paints.oak_upright),
        union([rail, sill, tester, crockets]).paint(&paints.walnut),
        stem.paint(&paints.marble),
    ]);
    let stand = revolve(&[
        (0.34, 0.0),
        (0.34, 0.06),
        (0.22, 0.12),
        (0.1, 0.2),
        (0.06, 0.5),
        (0.12, 0.62),
        (0.06, 0.72),
        (0.06, 1.0),
        (0.16, 1.08),
        (0.05, 1.16),
    ]);
    let globe = ball(0.13).z(1.2);
    let eagle = union([
        ellipsoid(vec3(0.1, 0.12, 0.2)).turn_x(-20.0).z(1.46),
        ball(0.065).at(vec3(0.0, 0.12, 1.68)),
        cone(0.03, 0.0, 0.1).turn_x(-100.0).at(vec3(0.0, 0.17, 1.68)),
        rounded_cuboid(vec3(-0.34, -0.03, -0.2), vec3(0.34, 0.02, 0.22), 0.02).turn_x(38.0).at(vec3(0.0, -0.04, 1.52)),
    ]);
    let lectern = union([stand, globe, eagle]).paint(&paints.brass);
    let bible = rounded_cuboid(vec3(-0.26, -0.08, -0.17), vec3(0.26, -0.03, 0.19), 0.02)
        .turn_x(38.0)
        .at(vec3(0.0, -0.06, 1.53));
    let font = union([
        prism(1.3, 0.0, 0.16),
        prism(1.0, 0.16, 0.3),
        prism(0.5, 0.3, 0.75),
        prism(0.9, 0.72, 1.15).minus(extrude(Profile::Disc(0.33), Axis::Z, 0.9, 1.3)),
        ring(8, &ball(0.08).at(vec3(0.43, 0.0, 0.94))),
    ]);
    union([
        pulpit.at(vec3(-2.1, NAVE_END - 1.3, 0.0)),
        lectern.and(bible.paint(&paints.linen)).turn_z(180.0).at(vec3(1.75, NAVE_END - 1.15, 0.0)),
        font.paint(&paints.carved).at(vec3(-5.4, 6.6, 0.0)),
    ])
}

/// Tablets between the aisle windows, and a tomb chest in the north aisle.
pub fn monuments(paints: &Paints) -> Solid {
    let tablet = |width: f32, height: f32| {
        let field = cuboid(vec3(-0.06, -width * 0.5, 0.0), vec3(0.1, width * 0.5, height)).paint(&paints.slate);
        let column = cylinder(0.05, height).at(vec3(-0.06, width * 0.5 + 0.06, 0.0)).both_y();
        let shelf = cuboid(vec3(-0.14, -width * 0.5 - 0.16, -0.1), vec3(0.1, width * 0.5 + 0.16, 0.0));
        let pediment = extrude(
            Profile::polygon(&[(-width * 0.5 - 0.18, 0.0), (width * 0.5 + 0.18, 0.0), (0.0, 0.34)]),
            Axis::X,
            -0.13,
            0.1,
        );
        let cornice = cuboid(vec3(-0.15, -width * 0.5 - 0.18, -0.04), vec3(0.1, width * 0.5 + 0.18, 0.05));
        let urn = revolve(&[(0.06, 0.0), (0.04, 0.06), (0.11, 0.2), (0.12, 0.28), (0.05, 0.34), (0.0, 0.42)]);
        union([
            field,
            union([column, shelf, pediment.and(cornice).z(height), urn.at(vec3(-0.04, 0.0, height + 0.3))])
                .paint(&paints.marble),
        ])
    };
    let wall = union((0..BAYS).flat_map(|bay| {
        let draw = hash(bay + 77);
        let place = |k: u32, side: f32| {
            let size = tablet(0.5 + 0.2 * unit(hash(draw + k)), 0.7 + 0.4 * unit(hash(draw + k + 9)));
            size.at(vec3(AISLE_OUTER, BAY * (bay as f32 + 0.5) + side * 1.62, 1.95))
        };
        let south = place(1, if draw & 1 == 0 { 1.0 } else { -1.0 });
        let north = place(2, if draw & 2 == 0 { 1.0 } else { -1.0 }).mirror_x();
        [south, north]
    }));
    let chest = rounded_cuboid(vec3(-0.5, -1.1, 0.0), vec3(0.5, 1.1, 0.85), 0.02);
    let panel = extrude(Profile::arch(0.34, 0.35, 0.2), Axis::X, 0.44, 0.6).at(vec3(0.0, -0.84, 0.14));
    let chest = chest.minus(row(5, vec3(0.0, 0.42, 0.0), &panel)).and(rounded_cuboid(
        vec3(-0.6, -1.2, 0.85),
        vec3(0.6, 1.2, 0.96),
        0.03,
    ));
    // The knight who lies on it.
    let effigy = union([
        ellipsoid(vec3(0.26, 0.5, 0.17)).at(vec3(0.0, 0.3, 1.06)),
        ellipsoid(vec3(0.2, 0.6, 0.13)).at(vec3(0.0, -0.4, 1.04)),
        ball(0.13).at(vec3(0.0, 0.85, 1.12)),
        rounded_cuboid(vec3(-0.26, 0.78, 0.95), vec3(0.26, 1.08, 1.06), 0.04),
        bar(vec3(-0.2, 0.45, 1.16), vec3(0.0, 0.3, 1.28), 0.05).both_x(),
        cone(0.06, 0.02, 0.16).at(vec3(0.0, 0.3, 1.22)),
        ellipsoid(vec3(0.2, 0.14, 0.16)).at(vec3(0.0, -1.0, 1.08)),
    ]);
    let tomb = union([chest.paint(&paints.carved), effigy.paint(&paints.marble)]);
    union([wall, tomb.at(vec3(-6.15, BAY * 3.5, 0.0))])
}
