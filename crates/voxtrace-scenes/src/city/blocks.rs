//! The blocks, each with its rows of buildings.

use super::{
    house::House,
    landmarks,
    paints::roofing,
    plan::{MARGIN, SIZE, east_line, west_line},
    rows::{Lot, Row},
    site::{Dice, Site, place},
    styles::Kind::{Apartments, Brownstone, Deco, Glass, Loft, Tenement},
};
use crate::kit::*;
use glam::vec2;

const HOUSE: Lot = (Brownstone, 0, 0.0);
const WALKUP: Lot = (Tenement, 0, 0.0);
const LOFT: Lot = (Loft, 0, 0.0);
const FLATS: Lot = (Apartments, 0, 0.0);
const DECO: Lot = (Deco, 0, 0.0);

/// All buildings but the wedge.
pub fn blocks(site: &Site) -> Solid {
    let (low, high) = (MARGIN, SIZE - MARGIN);
    let both = [true, true];
    let row = |from: (f32, f32), to: (f32, f32), depth: f32, lots: &[Lot], ends: [bool; 2], seed: u32| {
        Row { from: vec2(from.0, from.1), to: vec2(to.0, to.1), depth, lots, ends, seed }.build(site)
    };
    let mut parts = vec![
        // South-west: towards the avenue, then along the street.
        row((66.0, low), (66.0, 40.0), 22.0, &[FLATS, LOFT], both, 1),
        row((43.0, 40.0), (low, 40.0), 19.0, &[WALKUP, LOFT, WALKUP, WALKUP], [false, true], 2),
        row((low, low), (43.0, low), 17.0, &[LOFT, WALKUP, WALKUP, WALKUP], [true, false], 3),
        // West: the avenue's side of the square.
        row((66.0, 56.0), (66.0, 110.0), 23.0, &[LOFT, WALKUP, (Loft, 8, 13.0), (Apartments, 12, 20.0)], both, 4),
        row((42.0, 110.0), (low, 110.0), 22.0, &[LOFT, DECO, WALKUP], [false, true], 5),
        row((low, 56.0), (42.0, 56.0), 19.0, &[HOUSE, HOUSE, HOUSE, WALKUP, HOUSE, HOUSE], [true, false], 6),
        // North-west: beside the park, with the church at its corner.
        row((66.0, 134.0), (66.0, 176.0), 24.0, &[(Deco, 17, 25.0), (Loft, 8, 15.0)], both, 7),
        row((42.0, 196.0), (low, 196.0), 20.0, &[HOUSE, HOUSE, HOUSE, HOUSE, HOUSE, HOUSE], [false, true], 8),
        row((low, 134.0), (41.0, 134.0), 22.0, &[WALKUP, LOFT, WALKUP], [true, false], 9),
        row((66.0, 212.0), (66.0, high), 22.0, &[FLATS], both, 10),
        row((low, 212.0), (43.0, 212.0), 20.0, &[WALKUP, HOUSE, HOUSE, WALKUP, WALKUP], [true, false], 11),
        // South, between the avenue and the slanted road.
        row((90.0, 20.0), (90.0, low), 20.0, &[LOFT, WALKUP], [false, true], 12),
        // East of the slanted road.
        row((east_line(110.0) + 25.0, 56.0), (197.0, 56.0), 22.0, &[WALKUP, LOFT, WALKUP, WALKUP], [false, false], 14),
        row((197.0, 56.0), (high, 56.0), 22.0, &[HOUSE, HOUSE, WALKUP, HOUSE, HOUSE, WALKUP], [false, true], 15),
        row(
            (high, 110.0),
            (133.0, 110.0),
            25.0,
            &[LOFT, (Deco, 18, 26.0), WALKUP, (Glass, 15, 22.0), LOFT, (Loft, 8, 16.0)],
            [true, false],
            16,
        ),
        row((high, 40.0), (170.0, 40.0), 17.0, &[WALKUP, LOFT, WALKUP, WALKUP, LOFT, WALKUP], [true, false], 17),
        row((east_line(low) + 16.0, low), (high, low), 16.0, &[LOFT, WALKUP, HOUSE, HOUSE, WALKUP], [false, true], 18),
        // East of the park.
        row((197.0, 196.0), (197.0, 154.0), 22.0, &[(Glass, 11, 22.0), (Loft, 7, 19.0)], both, 19),
        row((215.0, 134.0), (high, 134.0), 22.0, &[LOFT, WALKUP], [false, true], 20),
        row((high, 196.0), (220.0, 196.0), 22.0, &[WALKUP, WALKUP], [true, false], 21),
        // North of the park.
        row(
            (90.0, 212.0),
            (175.0, 212.0),
            20.0,
            &[(Loft, 7, 14.0), HOUSE, HOUSE, WALKUP, HOUSE, HOUSE, WALKUP, (Loft, 8, 15.0)],
            both,
            22,
        ),
        row((197.0, 212.0), (high, 212.0), 22.0, &[LOFT, WALKUP, HOUSE, HOUSE], both, 23),
    ];
    let along_slant = |from: (f32, f32), to: (f32, f32), depth: f32, lots: &[Lot], ends: [bool; 2], seed: u32| {
        Row { from: from.into(), to: to.into(), depth, lots, ends, seed }.build(site)
    };
    // Both sides of the slanted road, and the buildings at its acute and obtuse corners.
    let (west, east) = (|y: f32| (west_line(y), y), |y: f32| (east_line(y), y));
    parts.extend([
        along_slant(west(2.0), west(20.0), 13.0, &[WALKUP, WALKUP], [true, false], 24),
        along_slant(east(86.0), east(57.0), 17.0, &[LOFT, WALKUP, (Tenement, 6, 9.0)], [false, true], 25),
        along_slant(east(22.0), east(2.0), 15.0, &[LOFT, WALKUP], [false, true], 26),
        corner(site, (Apartments, 9, 0.0), [(90.0, 20.0), west(20.0), west(40.0), (90.0, 40.0)], [1, 2, 3], 27),
        corner(site, (Loft, 9, 0.0), [east(86.0), (133.0, 86.0), (133.0, 110.0), east(110.0)], [2, 3, 2], 128),
        corner(site, (Apartments, 8, 0.0), [east(22.0), (170.0, 22.0), (170.0, 40.0), east(40.0)], [2, 3, 2], 29),
    ]);
    parts.push(landmarks::campanile(site, vec2(site.snap(197.0), site.snap(134.0)), site.snap(17.0)));
    parts.push(place(&landmarks::church(site), site.snap2(vec2(66.0, 178.0)), glam::Vec2::Y));
    union(parts)
}

/// A building on a corner that is no right angle; `streets` are the walls with façades, the others are blind.
fn corner(site: &Site, lot: Lot, corners: [(f32, f32); 4], streets: [usize; 3], seed: u32) -> Solid {
    let mut dice = Dice::new(seed);
    let facade = lot.0.facade(site, &mut dice, lot.1);
    let corners = corners.map(|at| site.snap2(at.into()));
    let house = House {
        corners: corners.to_vec(),
        walls: (0..4).map(|i| streets.contains(&i).then_some(&facade)).collect(),
        foot: 0.0,
        height: facade.height(),
        paint: facade.wall.clone(),
        roof: roofing(site.paints.ramps.tar, 0.5),
        parapet: 1.1,
        seed,
    };
    // The largest upright rectangle inside, for what stands on the roof.
    let min = vec2(corners[0].x.max(corners[3].x), corners[0].y);
    let max = vec2(corners[1].x.min(corners[2].x), corners[2].y);
    house.furnished(site, min + 1.5, max - 1.5)
}
