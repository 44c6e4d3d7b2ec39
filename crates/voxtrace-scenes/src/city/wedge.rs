//! The wedge: a tower of limestone on the narrow block between the avenue and the slanted road.

use super::{
    facade::{Band, Facade},
    house::footprint,
    landmarks::band,
    paints::{Panes, glazing, roofing, trim, wall},
    plan::{self, TIP},
    roofs,
    site::{Dice, Site, place},
    styles::common,
};
use crate::kit::*;
use glam::{Vec2, vec2, vec3};

/// Radius of the drum that rounds the nose, metres.
const NOSE_RADIUS: f32 = 1.9;

/// The wedge in its place.
pub fn wedge(site: &Site) -> Solid {
    let ramps = site.paints.ramps;
    let stone = wall(ramps.limestone, 0.5);
    let carved = trim(ramps.limestone, 0.66);
    let facade = facade(site, &stone, &carved);
    let Plan { sides, nose, outline } = Plan::new(site);
    let roof = roofing(ramps.tar, 0.6);
    let top = site.snap(facade.height());
    let well = extrude(outline.clone().offset(-0.9), Axis::Z, top - 1.5, top + 5.0).paint(&roof);
    let body = extrude(outline.clone(), Axis::Z, -4.0, top).paint(&stone);
    let (mut cuts, mut parts) = (vec![well], Vec::new());
    let bay = bay_window(site, &carved, facade.frame);
    for (i, (from, to)) in sides.into_iter().enumerate() {
        let length = (to - from).length();
        let dressing = facade.dress(site, length, 31 + i as u32);
        cuts.extend(dressing.cuts.iter().map(|solid| place(solid, from, to - from)));
        parts.extend(dressing.parts.iter().map(|solid| place(solid, from, to - from)));
        // Shallow bay windows ripple along the long sides.
        if i > 0 {
            let count = (length / 11.0) as u32;
            for k in 0..count {
                let x = length * (k as f32 + 0.5) / count as f32;
                parts.push(place(&bay.x(x), from, to - from));
            }
        }
    }
    cuts.extend(nose_windows(site, nose));
    parts.push(body.minus(union(cuts)));
    parts.extend(mouldings(site, &outline, top).map(|solid| solid.paint(&carved)));
    // A penthouse, tanks and a flagpole on the roof.
    let mut dice = Dice::new(8);
    parts.push(roofs::furniture(site, &mut dice, vec2(92.0, 58.5), vec2(107.0, 72.0)).z(top - 1.5));
    parts.push(block(5.0, 8.0, 3.4).at(vec3(95.0, 80.0, top - 1.6)).paint(&wall(ramps.limestone, 0.4)));
    parts.push(cylinder(site.voxel.max(0.12), 9.0).at(vec3(TIP.x + 2.6, 92.0, top - 2.0)).paint(&site.paints.steel));
    union(parts)
}

fn facade(site: &Site, stone: &Paint, carved: &Paint) -> Facade {
    Facade {
        wall: stone.clone(),
        trim: carved.clone(),
        frame: site.paints.ramps.wood.even(0.3, 0.25),
        recess: 0.5,
        bands: vec![
            band(1, 6.0, (1.9, 3.8), 1.0, true),
            band(3, 3.9, (1.6, 2.3), 0.9, true),
            band(4, 3.5, (1.5, 2.2), 0.8, false),
            band(5, 3.5, (1.5, 2.2), 0.8, true),
            Band { arched: true, ..band(2, 4.2, (1.5, 2.4), 0.8, true) },
            band(1, 3.2, (1.2, 1.6), 0.9, false),
        ],
        lit: 0.015,
        ..common(site)
    }
}

/// Where the tower stands, metres.
struct Plan {
    /// The south side and the two long ones, each from its start to its end.
    sides: [(Vec2, Vec2); 3],
    /// Centre of the drum at the nose, which touches both long sides.
    nose: Vec2,
    outline: Profile,
}

impl Plan {
    fn new(site: &Site) -> Self {
        let (south, radius, west) = (site.snap(56.0), NOSE_RADIUS, site.snap(TIP.x));
        let nose = vec2(west + radius, TIP.y - radius * 4.236);
        let (a, b) = (vec2(west, south), vec2(plan::west_line(south), south));
        let east_end = nose + vec2(0.894_427_2, 0.447_213_6) * radius;
        let west_end = vec2(west, nose.y);
        let arc = (0..=8).map(|i| {
            let (sin, cos) = noise::sin_cos_degrees(26.565 + (180.0 - 26.565) * i as f32 / 8.0);
            nose + vec2(cos, sin) * radius
        });
        let corners: Vec<Vec2> = [a, b].into_iter().chain(arc).collect();
        Self { sides: [(a, b), (b, east_end), (west_end, a)], nose, outline: footprint(&corners) }
    }
}

/// A shallow bay window over eight floors, on a wall along x that looks towards −y.
fn bay_window(site: &Site, carved: &Paint, frame: Tone) -> Solid {
    let oriel = Profile::polygon(&[(-2.1, 0.6), (-1.2, -0.75), (1.2, -0.75), (2.1, 0.6)]);
    let (low, high) = (6.0 + 3.0 * 3.9 + 0.6, 6.0 + 3.0 * 3.9 + 8.0 * 3.5 - 0.5);
    let panes = Panes {
        first: vec2(-1.45, low + 0.6),
        pitch: vec2(1.45, 3.5),
        size: vec2(site.width(0.9), site.width(2.0)),
        recess: -0.45,
        frame,
        lit: 0.015,
        seed: 87,
    };
    let glass = glazing(panes, carved.clone(), site.paints.ramps);
    let lines = |offset: f32| (0..8).map(|j| site.snap(low + 0.6 + 3.5 * j as f32) + offset).collect::<Vec<_>>();
    let hole = Profile::Rectangle(panes.size * 0.5).grid(vec![-0.75, 0.75], lines(panes.size.y * 0.5));
    let hole = extrude(hole, Axis::Y, -2.0, -0.4).paint(&glass);
    let corbel = revolve(&[(0.2, low - 1.6), (1.2, low), (1.9, low + 0.1)])
        .within(half_space(vec3(0.0, 0.4, 0.0), vec3(0.0, 1.0, 0.0)));
    let bay = extrude(oriel.clone(), Axis::Z, low, high).minus(hole).and(corbel);
    let bands = moulding(oriel, Profile::rectangle(vec2(-0.3, -0.25), vec2(0.3, 0.25)), Axis::Z);
    bay.and(bands.clone().z(high)).and(bands.z(low + 0.1)).paint(carved)
}

/// Windows around the nose, one above the other.
fn nose_windows(site: &Site, nose: Vec2) -> [Solid; 3] {
    let nose_width = 1.5;
    let figure = Profile::Rectangle(vec2(0.5 * nose_width, 1.05));
    let rows: Vec<f32> = [2.9, 8.0, 11.9, 15.8]
        .into_iter()
        .chain((0..9).map(|j| 6.0 + 11.7 + 1.85 + 3.5 * j as f32))
        .chain([51.2, 55.4])
        .map(|z| site.center(z, 2.1))
        .collect();
    let dark = Paint::plain(site.paints.ramps.glass.even(0.3, 0.4));
    [-38.0, 20.0, 78.0].map(|degrees| {
        let windows = extrude(figure.clone().grid(vec![0.0], rows.clone()), Axis::Y, -2.0, 0.7);
        // The local façade looks along −y; the nose looks north.
        let turned = windows.y(-NOSE_RADIUS).turn_z(180.0 - 25.0 + degrees - 20.0);
        turned.at(vec3(nose.x, nose.y, 0.0)).paint(&dark)
    })
}

/// Belts and the great cornice, which follow the whole outline.
fn mouldings(site: &Site, outline: &Profile, top: f32) -> [Solid; 6] {
    let belt = |z: f32, out: f32, high: f32| {
        let section = Profile::rectangle(vec2(-0.6, -0.5 * high), vec2(out, 0.5 * high));
        moulding(outline.clone(), section, Axis::Z).z(site.snap(z))
    };
    let cornice =
        Profile::polygon(&[(-0.8, -2.4), (0.2, -2.4), (0.4, -1.6), (0.9, -1.2), (1.5, -0.5), (1.7, 0.2), (-0.8, 0.2)]);
    let teeth =
        moulding(outline.clone(), Profile::rectangle(vec2(-0.5, -0.25), vec2(0.55, 0.25)), Axis::Z).z(top - 3.2);
    [
        belt(6.0, 0.55, 0.8),
        belt(17.7, 0.5, 0.7),
        belt(49.2, 0.6, 0.9),
        belt(57.6, 0.4, 0.5),
        teeth,
        moulding(outline.clone(), cornice, Axis::Z).z(top),
    ]
}
