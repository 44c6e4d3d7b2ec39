//! The park: lawns, curved paths, trees, a fountain, benches, a monument.

use super::{
    paints::paving,
    plan::PARK,
    site::{Dice, Site, ground},
    streets::kerb,
    trees::{Trees, bush},
};
use crate::kit::{noise::*, *};
use glam::{Vec2, Vec3, vec2, vec3};

/// Middle of the fountain.
pub const FOUNTAIN: Vec2 = vec2(131.0, 163.0);

/// The park and all in it.
pub fn park(site: &Site, trees: &Trees) -> Solid {
    let ramps = site.paints.ramps;
    let mut dice = Dice::new(77);
    let (min, max) = PARK;
    let center = (min + max) * 0.5;
    let top = kerb(site);
    let paths = paths();
    let lawn = Paint::new(move |p| {
        let mown = 0.08 * f32::from(u8::from(fraction((p.world.x + p.world.y) / 3.0) < 0.5));
        ramps.grass.even(0.42 + mown + 0.3 * fractal_noise(p.world / 3.5, 3, 91), 0.45)
    });
    let area = Profile::rectangle(min + 1.2, max - 1.2);
    let meadow = extrude(area.clone().minus(paths.clone()), Axis::Z, -3.0, top + site.width(0.25));
    let hills = hills(0.55, 16.0, 5).z(top + 0.2);
    let raised =
        meadow.clone().and(hills.within(extrude(area.clone().minus(paths.clone().offset(1.5)), Axis::Z, -3.0, 4.0)));
    let gravel = extrude(area.within(paths.clone()), Axis::Z, -3.0, top + 0.02).paint(&paving(ramps.buff, 0.6, 1.1));
    let mut parts = vec![gravel, raised.paint(&lawn), fountain(site).at(ground(FOUNTAIN).with_z(top))];
    // A low railing and its piers along the border, open at the gates.
    let rail = Profile::rectangle(min + 0.6, max - 0.6).outline(site.thick(0.14)).minus(paths.clone().offset(0.6));
    let thick = site.thick(0.2);
    parts.push(extrude(rail.clone(), Axis::Z, top + 0.75, top + 0.75 + thick).paint(&site.paints.iron));
    parts.push(extrude(rail, Axis::Z, top - 0.5, top + 0.25).paint(&site.paints.granite));
    let mut planted: Vec<Vec2> = Vec::new();
    for _ in 0..420 {
        let at = vec2(dice.between(min.x + 3.5, max.x - 3.5), dice.between(min.y + 3.5, max.y - 3.5));
        let free = paths.distance(at) > 1.3 && (at - center).abs().x > 9.0 || (at - center).abs().y > 15.0;
        let clear = paths.distance(at) > 1.3 && planted.iter().all(|other| (*other - at).length() > 6.2);
        if free && clear && planted.len() < 58 {
            planted.push(at);
            let height = dice.between(8.5, 13.0);
            parts.push(trees.pick(&mut dice, height, 0.45).at(ground(at).with_z(top)));
        }
    }
    for _ in 0..90 {
        let at = vec2(dice.between(min.x + 2.0, max.x - 2.0), dice.between(min.y + 2.0, max.y - 2.0));
        let edge = paths.distance(at);
        if (0.7..1.6).contains(&edge) {
            parts.push(bush(site, &mut dice).at(ground(at).with_z(top + 0.2)));
        }
    }
    let bench = bench(site);
    for i in 0..14 {
        let (sin, cos) = sin_cos_degrees(360.0 / 14.0 * i as f32 + 12.0);
        if i % 7 != 3 {
            let at = FOUNTAIN + vec2(cos, sin) * 9.6;
            parts.push(bench.turn_towards(-sin, cos).at(ground(at).with_z(top)));
        }
    }
    parts.push(monument(site).at(vec3(102.0, 143.5, top)));
    union(parts)
}

/// The figure of the paths: a ring around the fountain, two diagonals, a loop, and gates at the corners.
fn paths() -> Profile {
    let f = FOUNTAIN;
    let stroke = |points: &[(f32, f32)], width: f32| Profile::stroke(points, width);
    Profile::Disc(10.5)
        .moved(f)
        .and(stroke(&[(88.0, 132.0), (101.0, 143.0), (112.0, 152.0), (f.x, f.y)], 4.0))
        .and(stroke(&[(177.0, 132.0), (163.0, 141.0), (148.0, 154.0), (f.x, f.y)], 4.0))
        .and(stroke(&[(88.0, 198.0), (100.0, 188.0), (112.0, 178.0), (f.x, f.y)], 4.0))
        .and(stroke(&[(177.0, 198.0), (162.0, 189.0), (150.0, 176.0), (f.x, f.y)], 4.0))
        .and(stroke(&[(101.0, 143.0), (97.0, 158.0), (97.0, 172.0), (100.0, 188.0)], 2.6))
        .and(stroke(&[(163.0, 141.0), (168.5, 158.0), (168.0, 174.0), (162.0, 189.0)], 2.6))
        .and(stroke(&[(f.x, f.y), (131.0, 132.0)], 3.0))
        .and(stroke(&[(f.x, f.y), (131.0, 198.0)], 3.0))
}

fn fountain(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let stone = &site.paints.granite;
    let water = Paint::new(move |p| {
        let ripple = value_noise(p.world / 0.6, 92);
        ramps.curtain.even(0.55 + 0.3 * ripple, 0.4)
    });
    let basin = revolve(&[(4.6, -1.0), (4.6, 0.75), (4.1, 0.75), (4.1, -1.0)]);
    let bowl =
        revolve(&[(0.5, 0.0), (0.35, 1.4), (1.7, 2.0), (1.75, 2.2), (0.3, 2.2), (0.25, 3.0), (0.8, 3.3), (0.8, 3.45)]);
    let jet = cylinder(0.75 * site.voxel.max(0.12), 1.8)
        .z(3.3)
        .and(ring(8, &bar(vec3(0.6, 0.0, 3.3), vec3(1.3, 0.0, 2.3), 0.12_f32.max(0.6 * site.voxel))));
    union([
        basin.paint(stone),
        bowl.paint(stone),
        cylinder(4.2, 1.45).z(-1.0).paint(&water),
        jet.paint(&Paint::plain(ramps.cream.even(0.8, 0.3))),
    ])
}

/// A bench on the origin; one sits on it facing +y.
fn bench(site: &Site) -> Solid {
    let thick = site.thick(0.12);
    let seat = cuboid(vec3(-1.0, -0.3, 0.3), vec3(1.0, 0.35, 0.3 + thick));
    let back = cuboid(vec3(-1.0, -0.3 - thick, 0.3), vec3(1.0, -0.3, 1.05));
    seat.and(back).paint(&site.paints.wood)
}

fn monument(site: &Site) -> Solid {
    let stone = &site.paints.granite;
    let figure = union([
        bar(vec3(0.0, 0.0, 3.2), vec3(0.0, 0.0, 4.6), 0.45),
        ball(0.34).z(5.25),
        bar(vec3(0.3, 0.0, 4.6), vec3(0.95, 0.35, 5.2), 0.2_f32.max(0.75 * site.voxel)),
    ]);
    union([
        block(3.0, 3.0, 0.6).paint(stone),
        block(2.0, 2.0, 0.7).z(0.5).paint(stone),
        block(1.4, 1.4, 2.2).z(1.1).paint(stone),
        figure.paint(&site.paints.copper),
    ])
}

/// Lamps along the paths and streets: a post with a lantern.
pub fn lantern(site: &Site) -> Solid {
    let radius = 0.09_f32.max(0.75 * site.voxel);
    let post = cylinder(radius, 3.6).and(cylinder(0.3, 0.5)).paint(&site.paints.iron);
    let globe = ball(0.32_f32.max(1.2 * site.voxel)).z(3.8).paint(&site.paints.glow);
    post.and(globe).z(-0.1)
}

/// The places of lanterns in the park.
pub fn lanterns() -> Vec<Vec3> {
    let spots = [
        (108.0, 146.0),
        (119.0, 157.0),
        (108.0, 184.0),
        (120.0, 175.0),
        (156.0, 144.5),
        (143.0, 156.0),
        (156.0, 186.0),
        (142.0, 172.0),
        (128.5, 145.0),
        (133.5, 183.0),
    ];
    spots.iter().map(|&(x, y)| vec3(x, y, 0.3)).collect()
}
