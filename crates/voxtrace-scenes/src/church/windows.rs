//! Tracery windows. Each is modelled in the plane y = 0 with the church towards −y and the glass towards +y, standing
//! on its sill at the origin, then turned into its wall.

use super::{
    AISLE_OUTER, BAY, BAYS, CHANCEL, CHANCEL_BAY, EAST, HALF_NAVE,
    glass::{AISLE_LIGHT, EAST_LIGHT},
    paints::Paints,
};
use crate::kit::*;
use glam::{Vec2, vec2, vec3};

/// A window: the hole that it makes in the wall, and what stands in the hole.
#[derive(Clone)]
struct Window {
    opening: Solid,
    filling: Solid,
}

impl Window {
    /// A window of an outline, with stone bars and glass, `depth` metres into the wall.
    fn new(outline: Profile, bars: Vec<Profile>, depth: f32, glass: &Paint, paints: &Paints) -> Self {
        let splay = |grow: f32, to: f32| extrude(outline.clone().offset(grow), Axis::Y, -0.1, to);
        let opening = union([splay(0.0, depth), splay(0.09, depth * 0.55), splay(0.2, depth * 0.25)]);
        let roll = |out: f32, radius: f32, y: f32| {
            moulding(outline.clone().offset(out), Profile::Disc(radius), Axis::Y).y(y).paint(&paints.dressed)
        };
        let bars = bars.into_iter().map(|bar| bar.within(outline.clone().offset(0.1)));
        let frame = Profile::Union(bars.chain([outline.clone().outline(0.16)]).collect());
        let filling = union([
            extrude(outline.clone().offset(0.08), Axis::Y, depth - 0.06, depth + 0.1).paint(glass),
            extrude(frame, Axis::Y, depth - 0.24, depth - 0.03).paint(&paints.carved),
            roll(0.09, 0.05, depth * 0.55),
            roll(0.24, 0.07, 0.0),
        ]);
        Self { opening: opening.paint(&paints.dressed), filling }
    }

    fn map(&self, change: impl Fn(&Solid) -> Solid) -> Self {
        Self { opening: change(&self.opening), filling: change(&self.filling) }
    }
}

/// The openings of all windows, and their fillings.
pub fn all(paints: &Paints) -> (Solid, Solid) {
    let step = vec3(0.0, BAY, 0.0);
    let aisle = two_lights(2.0 * AISLE_LIGHT, 1.95, 1.75, &paints.aisle_glass, paints);
    let south = two_lights(1.9, 1.55, 1.75, &paints.south_glass, paints);
    let north = two_lights(1.9, 1.55, 1.75, &paints.north_glass, paints);
    let choir = two_lights(2.0 * AISLE_LIGHT, 1.95, 1.75, &paints.aisle_glass, paints);
    let east =
        Window::new(Profile::arch(5.0 * EAST_LIGHT, 4.6, 3.6), great_tracery(4.6), 0.55, &paints.east_glass, paints);
    let rose = Window::new(Profile::Disc(1.75), rose_tracery(), 0.5, &paints.rose_glass, paints);
    let windows = [
        aisle.map(|w| row(BAYS, step, &w.turn_z(-90.0).at(vec3(AISLE_OUTER, BAY * 0.5, 1.85))).both_x()),
        south.map(|w| row(BAYS, step, &w.turn_z(-90.0).at(vec3(HALF_NAVE, BAY * 0.5, 8.95)))),
        north.map(|w| row(BAYS, step, &w.turn_z(90.0).at(vec3(-HALF_NAVE, BAY * 0.5, 8.95)))),
        choir.map(|w| {
            let w = w.turn_z(-90.0).at(vec3(HALF_NAVE, CHANCEL + CHANCEL_BAY * 0.5, 5.4));
            row(2, vec3(0.0, CHANCEL_BAY, 0.0), &w).both_x()
        }),
        east.map(|w| w.at(vec3(0.0, EAST, 3.55))),
        rose.map(|w| w.turn_z(180.0).at(vec3(0.0, 0.0, 9.7))),
    ];
    (union(windows.iter().map(|w| w.opening.clone())), union(windows.iter().map(|w| w.filling.clone())))
}

/// The head of one light, `width` wide, its arch springing at `legs`: cusps that leave a trefoil.
fn cusped_light(width: f32, legs: f32, rise: f32, x: f32) -> [Profile; 2] {
    let arch = Profile::arch(width, legs, rise);
    let trefoil = Profile::foil(3, 0.17 * width, 0.23 * width).moved(vec2(0.0, legs + 0.24 * width));
    let shaft = Profile::rectangle(vec2(-0.4 * width, 0.0), vec2(0.4 * width, legs + 0.1 * width));
    let plate = arch.clone().minus(trefoil.and(shaft));
    let head = Profile::rectangle(vec2(-width, legs - 0.15), vec2(width, legs + rise + 1.0));
    [arch.outline(0.09), plate.within(head)].map(|part| part.moved(vec2(x, 0.0)))
}

/// A circle with a foil of `lobes` cut into it.
fn foiled_circle(radius: f32, lobes: u32, at: Vec2) -> [Profile; 2] {
    let share = if lobes > 4 { 0.6 } else { 0.45 };
    let lobe = if lobes > 4 { 0.32 } else { 0.43 };
    let foil = Profile::foil(lobes, share * radius, lobe * radius).and(Profile::Disc(0.4 * radius));
    [Profile::Disc(radius).outline(0.09), Profile::Disc(radius).minus(foil)].map(|part| part.moved(at))
}

/// Two lights under a quatrefoil.
fn two_lights(span: f32, legs: f32, rise: f32, glass: &Paint, paints: &Paints) -> Window {
    let width = span * 0.5;
    let half = 0.5 * width;
    let circle = foiled_circle(0.40 * width, 4, vec2(0.0, legs + 1.02 * width));
    let light = |x: f32| cusped_light(width, legs, 0.85 * width, x);
    let bars = [light(-half), light(half), circle].concat();
    Window::new(Profile::arch(span, legs, rise), bars, 0.42, glass, paints)
}

/// Five lights: a pair under an arch on either side, one in the middle, a rose above.
fn great_tracery(legs: f32) -> Vec<Profile> {
    let mut bars: Vec<Profile> =
        (-2..=2).flat_map(|i| cusped_light(EAST_LIGHT, legs - 0.35, 0.85, i as f32 * EAST_LIGHT)).collect();
    for side in [-1.0, 1.0] {
        bars.push(Profile::arch(2.0 * EAST_LIGHT, legs, 1.75).outline(0.12).moved(vec2(1.5 * side, 0.0)));
        bars.extend(foiled_circle(0.42, 4, vec2(1.5 * side, legs + 0.85)));
        bars.extend(foiled_circle(0.24, 3, vec2(1.28 * side, legs + 2.0)));
    }
    let rose = vec2(0.0, legs + 2.02);
    bars.extend(foiled_circle(1.12, 6, rose));
    bars.extend(foiled_circle(0.42, 6, rose));
    bars
}

/// Twelve petals around an eye.
fn rose_tracery() -> Vec<Profile> {
    let petal = Profile::arch(0.5, 0.62, 0.3).outline(0.08).moved(vec2(0.0, 0.52));
    let rim = Profile::Disc(0.16).outline(0.07).moved(vec2(0.0, 1.58)).turned(15.0);
    let mut bars: Vec<Profile> = foiled_circle(0.5, 6, Vec2::ZERO).into();
    for i in 0..12 {
        bars.extend([petal.clone(), rim.clone()].map(|part| part.turned(30.0 * i as f32)));
    }
    bars
}
