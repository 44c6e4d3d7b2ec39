//! The landmarks beside the park: a campanile and a church with a spire.

use super::{
    facade::{Band, Cornice, Facade, Street},
    house::House,
    paints::{roofing, trim, wall},
    site::{Site, place},
};
use crate::kit::*;
use glam::{Vec2, vec2, vec3};

/// A band of floors without arches, its windows width × height.
pub fn band(floors: u32, storey: f32, window: (f32, f32), sill: f32, belt: bool) -> Band {
    Band { floors, storey, window: vec2(window.0, window.1), sill, per_bay: 1, arched: false, belt }
}

/// The campanile beside the park: a marble tower with clocks, a loggia and a pyramid, after that of St Mark's.
pub fn campanile(site: &Site, corner: Vec2, width: f32) -> Solid {
    let ramps = site.paints.ramps;
    let marble = wall(ramps.cream, 0.5);
    let carved = trim(ramps.cream, 0.68);
    let facade = shaft_facade(site, &marble, &carved);
    let shaft_height = facade.height();
    let shaft = House {
        corners: House::rectangle(Vec2::splat(width)),
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
    let clock = extrude(Profile::Disc(2.9), Axis::Y, -0.35, 0.4).paint(&dial(site)).z(shaft_height - 5.2);
    let clocks = ring(4, &clock.y(-half)).at(vec3(half, half, 0.0));
    let top = belfry_and_roof(site, width, &marble, &carved);
    union([shaft, clocks, top.at(vec3(half, half, foot))]).at(vec3(corner.x, corner.y, 0.0))
}

/// The four façades of the campanile's shaft.
fn shaft_facade(site: &Site, marble: &Paint, carved: &Paint) -> Facade {
    Facade {
        wall: marble.clone(),
        trim: carved.clone(),
        frame: site.paints.ramps.iron.even(0.6, 0.25),
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
    }
}

/// The face of a clock, in the plane of x and z around the origin.
fn dial(site: &Site) -> Paint {
    let ramps = site.paints.ramps;
    Paint::new(move |p| {
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
    })
}

/// What stands on the campanile's shaft: the loggia, the pyramid with its dormers, and the lantern.
fn belfry_and_roof(site: &Site, width: f32, marble: &Paint, carved: &Paint) -> Solid {
    let ramps = site.paints.ramps;
    let half = 0.5 * width;
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
    let slope = Profile::polygon(&[(-half + 0.6, 0.0), (half - 0.6, 0.0), (0.9, 9.5), (-0.9, 9.5)]);
    let pyramid = extrude(slope.clone(), Axis::Y, -half, half).within(extrude(slope, Axis::X, -half, half));
    let dormer = cuboid(vec3(-0.5, -half + 0.8, 1.0), vec3(0.5, 0.0, 2.4))
        .and(cuboid(vec3(-0.4, -half + 2.0, 4.0), vec3(0.4, 0.0, 5.2)));
    let lantern = union([cylinder(1.25, 2.6), ring(8, &cylinder(0.3, 2.6).x(1.35))]).paint(carved).z(9.4);
    let dome = revolve(&[(1.7, 0.0), (1.6, 0.7), (1.1, 1.5), (0.3, 2.0), (0.25, 3.4), (0.02, 4.0)]);
    let golden = Paint::plain(ramps.gold.even(0.7, 0.35));
    union([
        loggia.paint(marble),
        cornice(6.0, 0.8).paint(carved),
        cornice(-0.1, 0.7).paint(carved),
        pyramid.z(6.4).paint(&site.paints.copper),
        ring(4, &dormer).z(6.4).paint(carved),
        lantern.z(6.4),
        dome.z(6.4 + 11.9).paint(&golden),
    ])
}

/// A church with its west front and spire on y = 0, about 16 × 34 m.
pub fn church(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let pane = Paint::new(move |p| {
        if (p.at.x * 2.2) as i32 % 2 == 0 { ramps.glass.even(0.25, 0.3) } else { ramps.glass.even(0.5, 0.3) }
    });
    let masonry = Masonry { stone: wall(ramps.brownstone, 0.62), light: trim(ramps.limestone, 0.45), pane };
    let tower = church_tower(site, &masonry);
    union([church_body(site, &masonry), tower.at(vec3(4.0, 3.6, 0.0))])
}

/// The paints that the parts of the church share.
struct Masonry {
    stone: Paint,
    light: Paint,
    pane: Paint,
}

/// Nave, roof, buttresses and the west front with its rose and portal.
fn church_body(site: &Site, Masonry { stone, light, pane }: &Masonry) -> Solid {
    let slate = roofing(site.paints.ramps.grey, 0.35);
    let lancet =
        |width: f32, legs: f32| extrude(Profile::arch(width, legs, 0.95 * width), Axis::Y, -1.0, 0.7).paint(pane);
    let nave = cuboid(vec3(3.0, 4.0, -3.0), vec3(15.0, 34.0, 11.0)).paint(stone);
    let roof = gable(13.4, 31.0, 8.0).at(vec3(9.0, 19.3, 10.7)).paint(&slate);
    let side = |x: f32, along: f32| {
        place(
            &row(5, vec3(5.4, 0.0, 0.0), &lancet(1.7, 5.0).z(3.0)),
            vec2(x, if along > 0.0 { 8.5 } else { 30.0 }),
            vec2(0.0, along),
        )
    };
    let buttress = union([block(1.2, 2.2, 7.0), block(1.0, 1.4, 9.5)]).paint(light);
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
    .paint(stone);
    let rose = extrude(Profile::Disc(2.3), Axis::Y, 2.0, 3.9).at(vec3(10.8, 0.0, 10.6)).paint(pane);
    let rim = extrude(
        Profile::Disc(2.5).outline(0.5).and(Profile::Disc(0.7).moved(vec2(0.0, 1.35)).outline(0.3).ring(6)),
        Axis::Y,
        3.2,
        3.8,
    )
    .at(vec3(10.8, 0.0, 10.6))
    .paint(light);
    let portal =
        extrude(Profile::arch(3.4, 3.0, 2.6), Axis::Y, 2.0, 4.0).at(vec3(10.8, 0.0, 0.0)).paint(&site.paints.wood);
    let frame =
        extrude(Profile::arch(3.4, 3.0, 2.6).outline(0.7), Axis::Y, 3.0, 3.9).at(vec3(10.8, 0.0, 0.0)).paint(light);
    union([
        nave.minus(union([side(15.0, 1.0), side(3.0, -1.0)])),
        front.minus(rose.and(portal)).and(rim).and(frame),
        roof,
        buttresses,
    ])
}

/// The tower at the church's corner, around the z axis; buttresses and pinnacles lead over to an eight-sided spire.
fn church_tower(site: &Site, Masonry { stone, light, pane }: &Masonry) -> Solid {
    let ramps = site.paints.ramps;
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
    let low = extrude(Profile::arch(1.8, 3.6, 1.7), Axis::Y, -5.0, -2.9).z(6.0).paint(pane);
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
        union([block(7.7, 7.7, 0.6).z(14.2), block(7.7, 7.7, 0.6).z(23.6), block(7.6, 7.6, 0.8).z(1.0)]).paint(light);
    union([
        tower.minus(ring(4, &belfry).and(ring(4, &low))).paint(stone),
        ring(4, &pinnacle).paint(light),
        spire.paint(&wall(ramps.limestone, 0.35)),
        belt,
        cross,
    ])
}
