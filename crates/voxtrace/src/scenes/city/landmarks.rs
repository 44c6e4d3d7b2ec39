//! The landmarks: the wedge at the square, the campanile beside the park, a church with a spire.

use super::{
    facade::{Band, Cornice, Facade, Street},
    house::{House, footprint},
    paints::{roofing, trim, wall},
    plan::{self, TIP},
    roofs,
    site::{Dice, Site, place},
};
use crate::scenes::kit::*;
use glam::{Vec2, vec2, vec3};

fn band(floors: u32, storey: f32, window: (f32, f32), sill: f32, belt: bool) -> Band {
    Band { floors, storey, window: vec2(window.0, window.1), sill, per_bay: 1, arched: false, belt }
}

/// The wedge: a tower of limestone on the narrow block between the avenue and the slanted road.
pub fn wedge(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let stone = wall(ramps.limestone, 0.5);
    let carved = trim(ramps.limestone, 0.66);
    let facade = Facade {
        wall: stone.clone(),
        trim: carved.clone(),
        frame: ramps.wood.even(0.3, 0.25),
        bay: 2.9,
        recess: 0.6,
        bands: vec![
            band(1, 6.0, (1.9, 3.8), 1.0, true),
            band(3, 3.9, (1.6, 2.3), 0.9, true),
            band(4, 3.5, (1.3, 2.1), 0.8, false),
            Band { belt: true, ..band(5, 3.5, (1.3, 2.1), 0.8, true) },
            Band { arched: true, ..band(2, 4.2, (1.5, 2.4), 0.8, true) },
            band(1, 3.2, (1.2, 1.6), 0.9, false),
        ],
        sills: true,
        lintels: false,
        piers: 0.3,
        cornice: Cornice::Coping,
        street: Street::Nothing,
        fire_escape: false,
        lit: 0.015,
    };
    let height = facade.height();
    // The nose is part of a drum that touches both long sides.
    let (south, radius, west) = (site.snap(56.0), 1.9, site.snap(TIP.x));
    let nose = vec2(west + radius, TIP.y - radius * 4.236);
    let (a, b) = (vec2(west, south), vec2(plan::west_line(south), south));
    let east_end = nose + vec2(0.894_427_2, 0.447_213_6) * radius;
    let west_end = vec2(west, nose.y);
    let arc = (0..=8).map(|i| {
        let (sin, cos) = noise::sin_cos_degrees(26.565 + (180.0 - 26.565) * i as f32 / 8.0);
        nose + vec2(cos, sin) * radius
    });
    let corners: Vec<Vec2> = [a, b].into_iter().chain(arc).collect();
    let rounded = footprint(&corners);
    let roof = roofing(ramps.tar, 0.6);
    let top = site.snap(height);
    let well = extrude(rounded.clone().offset(-0.9), Axis::Z, top - 1.5, top + 5.0).paint(&roof);
    let body = extrude(rounded.clone(), Axis::Z, -4.0, top).paint(&stone);
    let (mut cuts, mut parts) = (vec![well], Vec::new());
    for (i, (from, to)) in [(a, b), (b, east_end), (west_end, a)].into_iter().enumerate() {
        let dressing = facade.dress(site, (to - from).length(), 31 + i as u32);
        cuts.extend(dressing.cuts.iter().map(|solid| place(solid, from, to - from)));
        parts.extend(dressing.parts.iter().map(|solid| place(solid, from, to - from)));
        // Shallow bay windows ripple along the long sides.
        if i > 0 {
            let length = (to - from).length();
            let oriel = Profile::polygon(&[(-2.1, 0.6), (-1.2, -0.75), (1.2, -0.75), (2.1, 0.6)]);
            let (low, high) = (6.0 + 3.0 * 3.9 + 0.6, 6.0 + 3.0 * 3.9 + 8.0 * 3.5 - 0.5);
            let panes = super::paints::Panes {
                first: vec2(-1.45, low + 0.6),
                pitch: vec2(1.45, 3.5),
                size: vec2(site.width(0.9), site.width(2.0)),
                recess: -0.45,
                frame: facade.frame,
                lit: 0.015,
                seed: 87,
            };
            let glass = super::paints::glazing(panes, carved.clone(), ramps);
            let lines =
                |offset: f32| (0..8).map(|j| site.snap(low + 0.6 + 3.5 * j as f32) + offset).collect::<Vec<_>>();
            let hole = Profile::Rectangle(panes.size * 0.5).grid(vec![-0.75, 0.75], lines(panes.size.y * 0.5));
            let hole = extrude(hole, Axis::Y, -2.0, -0.4).paint(&glass);
            let corbel = revolve(&[(0.2, low - 1.6), (1.2, low), (1.9, low + 0.1)])
                .within(half_space(vec3(0.0, 0.4, 0.0), vec3(0.0, 1.0, 0.0)));
            let bay = extrude(oriel.clone(), Axis::Z, low, high).minus(hole).and(corbel);
            let bands = moulding(oriel, Profile::rectangle(vec2(-0.3, -0.25), vec2(0.3, 0.25)), Axis::Z);
            let bay = bay.and(bands.clone().z(high)).and(bands.z(low + 0.1)).paint(&carved);
            let count = (length / 11.0) as u32;
            for k in 0..count {
                let x = length * (k as f32 + 0.5) / count as f32;
                parts.push(place(&bay.x(x), from, to - from));
            }
        }
    }
    // Windows around the nose, one above the other.
    let nose_width = 1.5;
    let figure = Profile::Rectangle(vec2(0.5 * nose_width, 1.05));
    let rows: Vec<f32> = [2.9, 8.0, 11.9, 15.8]
        .into_iter()
        .chain((0..9).map(|j| 6.0 + 11.7 + 1.85 + 3.5 * j as f32))
        .chain([51.2, 55.4])
        .map(|z| site.center(z, 2.1))
        .collect();
    let dark = Paint::plain(ramps.glass.even(0.3, 0.4));
    for degrees in [-38.0, 20.0, 78.0] {
        let windows = extrude(figure.clone().grid(vec![0.0], rows.clone()), Axis::Y, -2.0, 0.7);
        // The local façade looks along −y; the nose looks north.
        cuts.push(windows.y(-radius).turn_z(180.0 - 25.0 + degrees - 20.0).at(vec3(nose.x, nose.y, 0.0)).paint(&dark));
    }
    parts.push(body.minus(union(cuts)));
    // Belts and the great cornice follow the whole outline.
    let belt = |z: f32, out: f32, high: f32| {
        let section = Profile::rectangle(vec2(-0.6, -0.5 * high), vec2(out, 0.5 * high));
        moulding(rounded.clone(), section, Axis::Z).z(site.snap(z))
    };
    let cornice =
        Profile::polygon(&[(-0.8, -2.4), (0.2, -2.4), (0.4, -1.6), (0.9, -1.2), (1.5, -0.5), (1.7, 0.2), (-0.8, 0.2)]);
    let teeth =
        moulding(rounded.clone(), Profile::rectangle(vec2(-0.5, -0.25), vec2(0.55, 0.25)), Axis::Z).z(top - 3.2);
    parts.extend(
        [
            belt(6.0, 0.55, 0.8),
            belt(17.7, 0.5, 0.7),
            belt(49.2, 0.6, 0.9),
            belt(57.6, 0.4, 0.5),
            teeth,
            moulding(rounded, cornice, Axis::Z).z(top),
        ]
        .map(|solid| solid.paint(&carved)),
    );
    // A glazed shop front in the nose, and a penthouse and tank on the roof.
    let mut dice = Dice::new(8);
    parts.push(roofs::furniture(site, &mut dice, vec2(92.0, 58.5), vec2(107.0, 72.0)).z(top - 1.5));
    parts.push(block(5.0, 8.0, 3.4).at(vec3(95.0, 80.0, top - 1.6)).paint(&wall(ramps.limestone, 0.4)));
    parts.push(cylinder(site.voxel.max(0.12), 9.0).at(vec3(TIP.x + 2.6, 92.0, top - 2.0)).paint(&site.paints.steel));
    union(parts)
}

/// The campanile beside the park: a marble tower with clocks, a loggia and a pyramid, after that of St Mark's.
pub fn campanile(site: &Site, corner: Vec2, width: f32) -> Solid {
    let ramps = site.paints.ramps;
    let marble = wall(ramps.cream, 0.5);
    let carved = trim(ramps.cream, 0.68);
    let facade = Facade {
        wall: marble.clone(),
        trim: carved.clone(),
        frame: ramps.iron.even(0.6, 0.25),
        bay: 3.1,
        recess: 0.6,
        bands: vec![
            band(1, 6.0, (1.7, 3.6), 1.2, true),
            band(3, 3.8, (1.4, 2.2), 0.9, true),
            band(9, 3.3, (1.3, 1.9), 0.8, true),
        ],
        sills: true,
        lintels: false,
        piers: 0.0,
        cornice: Cornice::Plain,
        street: Street::Lobby,
        fire_escape: false,
        lit: 0.015,
    };
    let shaft_height = facade.height();
    let size = Vec2::splat(width);
    let shaft = House {
        corners: House::rectangle(size),
        walls: vec![Some(&facade); 4],
        foot: 0.0,
        height: shaft_height,
        paint: marble.clone(),
        roof: roofing(ramps.tar, 0.5),
        parapet: 0.6,
        seed: 61,
    }
    .build(site);
    let foot = site.snap(shaft_height - 0.6);
    let half = 0.5 * width;
    // The clocks.
    let dial = Paint::new(move |p| {
        let (r, at) = (vec2(p.at.x, p.at.z).length(), vec2(p.at.x, p.at.z));
        let hand = |x: f32, y: f32, length: f32| {
            let along = at.dot(vec2(x, y));
            along > -0.3 && along < length && at.perp_dot(vec2(x, y)).abs() < 0.17
        };
        let mark = noise::fraction(noise::turns(at.x, at.y) * 12.0 + 0.14) < 0.28 && (2.0..2.45).contains(&r);
        if hand(0.5, 0.866, 1.4) || hand(-0.866, 0.5, 2.2) || mark || r > 2.62 {
            ramps.iron.even(0.4, 0.3)
        } else {
            ramps.cream.even(0.9, 0.2)
        }
    });
    let clock = extrude(Profile::Disc(2.9), Axis::Y, -0.35, 0.4).paint(&dial).z(shaft_height - 5.2);
    let clocks = ring(4, &clock.y(-half)).at(vec3(half, half, 0.0));
    let opening = extrude(
        Profile::arch(1.5, 3.4, 0.75)
            .and(Profile::arch(1.5, 3.4, 0.75).moved(vec2(2.3, 0.0)))
            .and(Profile::arch(1.5, 3.4, 0.75).moved(vec2(-2.3, 0.0))),
        Axis::Y,
        -half - 2.0,
        -half + 1.6,
    )
    .paint(&Paint::plain(ramps.glass.even(0.25, 0.3)));
    let loggia = block(width - 0.8, width - 0.8, 6.2).minus(ring(4, &opening).z(0.8));
    let cornice = |z: f32, out: f32| block(width - 0.8 + 2.0 * out, width - 0.8 + 2.0 * out, site.width(0.6)).z(z);
    let pyramid = extrude(
        Profile::polygon(&[(-half + 0.6, 0.0), (half - 0.6, 0.0), (0.9, 9.5), (-0.9, 9.5)]),
        Axis::Y,
        -half,
        half,
    )
    .within(extrude(
        Profile::polygon(&[(-half + 0.6, 0.0), (half - 0.6, 0.0), (0.9, 9.5), (-0.9, 9.5)]),
        Axis::X,
        -half,
        half,
    ));
    let dormer = cuboid(vec3(-0.5, -half + 0.8, 1.0), vec3(0.5, 0.0, 2.4))
        .and(cuboid(vec3(-0.4, -half + 2.0, 4.0), vec3(0.4, 0.0, 5.2)));
    let lantern = union([cylinder(1.25, 2.6), ring(8, &cylinder(0.3, 2.6).x(1.35))]).paint(&carved).z(9.4);
    let dome = revolve(&[(1.7, 0.0), (1.6, 0.7), (1.1, 1.5), (0.3, 2.0), (0.25, 3.4), (0.02, 4.0)]);
    let golden = Paint::plain(ramps.gold.even(0.7, 0.35));
    let top = union([
        loggia.paint(&marble),
        cornice(6.0, 0.8).paint(&carved),
        cornice(-0.1, 0.7).paint(&carved),
        pyramid.z(6.4).paint(&site.paints.copper),
        ring(4, &dormer).z(6.4).paint(&carved),
        lantern.z(6.4),
        dome.z(6.4 + 11.9).paint(&golden),
    ]);
    union([shaft, clocks, top.at(vec3(half, half, foot))]).at(vec3(corner.x, corner.y, 0.0))
}

/// A church with its west front and spire on y = 0, about 16 × 34 m.
pub fn church(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let stone = wall(ramps.brownstone, 0.62);
    let light = trim(ramps.limestone, 0.45);
    let slate = roofing(ramps.grey, 0.35);
    let pane = Paint::new(move |p| {
        if (p.at.x * 2.2) as i32 % 2 == 0 { ramps.glass.even(0.25, 0.3) } else { ramps.glass.even(0.5, 0.3) }
    });
    let lancet =
        |width: f32, legs: f32| extrude(Profile::arch(width, legs, 0.95 * width), Axis::Y, -1.0, 0.7).paint(&pane);
    let nave = cuboid(vec3(3.0, 4.0, -3.0), vec3(15.0, 34.0, 11.0)).paint(&stone);
    let roof = gable(13.4, 31.0, 8.0).at(vec3(9.0, 19.3, 10.7)).paint(&slate);
    let side = |x: f32, along: f32| {
        place(
            &row(5, vec3(5.4, 0.0, 0.0), &lancet(1.7, 5.0).z(3.0)),
            vec2(x, if along > 0.0 { 8.5 } else { 30.0 }),
            vec2(0.0, along),
        )
    };
    let buttress = union([block(1.2, 2.2, 7.0), block(1.0, 1.4, 9.5)]).paint(&light);
    let buttresses = row(6, vec3(0.0, 5.4, 0.0), &buttress.turn_z(90.0).at(vec3(15.4, 5.8, 0.0))).and(row(
        6,
        vec3(0.0, 5.4, 0.0),
        &buttress.turn_z(90.0).at(vec3(2.6, 5.8, 0.0)),
    ));
    let front = extrude(
        Profile::polygon(&[(-6.4, -3.0), (6.4, -3.0), (6.4, 11.4), (0.0, 19.8), (-6.4, 11.4)]),
        Axis::Y,
        3.4,
        4.6,
    )
    .x(9.0)
    .paint(&stone);
    let rose = extrude(Profile::Disc(2.3), Axis::Y, 2.0, 3.9).at(vec3(10.8, 0.0, 10.6)).paint(&pane);
    let rim = extrude(
        Profile::Disc(2.5).outline(0.5).and(Profile::Disc(0.7).moved(vec2(0.0, 1.35)).outline(0.3).ring(6)),
        Axis::Y,
        3.2,
        3.8,
    )
    .at(vec3(10.8, 0.0, 10.6))
    .paint(&light);
    let portal =
        extrude(Profile::arch(3.4, 3.0, 2.6), Axis::Y, 2.0, 4.0).at(vec3(10.8, 0.0, 0.0)).paint(&site.paints.wood);
    let frame =
        extrude(Profile::arch(3.4, 3.0, 2.6).outline(0.7), Axis::Y, 3.0, 3.9).at(vec3(10.8, 0.0, 0.0)).paint(&light);
    // The tower stands at the corner; buttresses and pinnacles lead over to an eight-sided spire.
    let tower = block(7.0, 7.0, 27.0).z(-3.0);
    let louvres = Paint::new(move |p| {
        if noise::fraction(p.at.z / 0.9) < 0.4 { ramps.wood.even(0.5, 0.3) } else { ramps.iron.even(0.3, 0.3) }
    });
    let belfry = extrude(
        Profile::arch(1.5, 4.6, 1.5).and(Profile::arch(1.5, 4.6, 1.5).moved(vec2(2.4, 0.0))),
        Axis::Y,
        -5.0,
        -2.9,
    )
    .at(vec3(-1.2, 0.0, 16.0))
    .paint(&louvres);
    let low = extrude(Profile::arch(1.8, 3.6, 1.7), Axis::Y, -5.0, -2.9).z(6.0).paint(&pane);
    let pinnacle = union([block(1.5, 1.5, 28.0).z(-3.0), cone(0.95, 0.05, 4.6).z(24.9)]).at(vec3(3.2, 3.2, 0.0));
    let octagon = |width: f32| {
        let flat = |degrees: f32| Profile::Rectangle(vec2(0.5 * width, 0.5 * width)).turned(degrees);
        flat(0.0).within(flat(45.0))
    };
    let tiers = 18;
    // The spire in tiers, each a slightly smaller octagon: courses of stone.
    let spire = union((0..tiers).map(|i| {
        let z = 24.0 + 22.0 * i as f32 / tiers as f32;
        let width = 6.0 * (1.0 - i as f32 / tiers as f32) + 0.35;
        extrude(octagon(width), Axis::Z, z - 1.5, z + 22.0 / tiers as f32)
    }));
    let cross = union([block(0.4, 0.4, 2.6), block(1.5, 0.4, 0.45).z(1.5)])
        .z(45.8)
        .paint(&Paint::plain(ramps.gold.even(0.6, 0.3)));
    let belt =
        union([block(7.7, 7.7, 0.6).z(14.2), block(7.7, 7.7, 0.6).z(23.6), block(7.6, 7.6, 0.8).z(1.0)]).paint(&light);
    let tower = union([
        tower.minus(ring(4, &belfry).and(ring(4, &low))).paint(&stone),
        ring(4, &pinnacle).paint(&light),
        spire.paint(&wall(ramps.limestone, 0.35)),
        belt,
        cross,
    ]);
    let body = union([
        nave.minus(union([side(15.0, 1.0), side(3.0, -1.0)])),
        front.minus(rose.and(portal)).and(rim).and(frame),
        roof,
        buttresses,
    ]);
    union([body, tower.at(vec3(4.0, 3.6, 0.0))])
}
