//! The blocks, each with its rows of buildings.

use super::{
    landmarks,
    plan::{MARGIN, SIZE, east_line, west_line},
    rows::{Lot, Row},
    site::{Site, place},
    styles::Kind::{Apartments, Brownstone, Deco, Glass, Loft, Tenement},
};
use crate::scenes::kit::*;
use glam::{Vec2, vec2};

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
        row((90.0, 40.0), (90.0, low), 17.0, &[LOFT, WALKUP, LOFT], both, 12),
        // East of the slanted road.
        row((east_line(110.0) + 25.0, 56.0), (197.0, 56.0), 22.0, &[WALKUP, LOFT, WALKUP, WALKUP], [false, false], 14),
        row((197.0, 56.0), (high, 56.0), 22.0, &[HOUSE, HOUSE, WALKUP, HOUSE, HOUSE, WALKUP], [false, true], 15),
        row(
            (high, 110.0),
            (east_line(110.0) + 18.0, 110.0),
            25.0,
            &[LOFT, (Deco, 18, 26.0), WALKUP, (Glass, 15, 22.0), LOFT, (Apartments, 12, 20.0)],
            [true, false],
            16,
        ),
        row(
            (high, 40.0),
            (east_line(40.0) + 19.0, 40.0),
            17.0,
            &[WALKUP, LOFT, WALKUP, WALKUP, LOFT, WALKUP],
            [true, false],
            17,
        ),
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
    let along_slant = |from: Vec2, to: Vec2, depth: f32, lots: &[Lot], ends: [bool; 2], seed: u32| {
        Row { from, to, depth, lots, ends, seed }.build(site)
    };
    // Both sides of the slanted road.
    parts.push(along_slant(
        vec2(west_line(2.0), 2.0),
        vec2(west_line(39.0), 39.0),
        13.0,
        &[WALKUP, LOFT, WALKUP],
        both,
        24,
    ));
    parts.push(along_slant(
        vec2(east_line(109.0), 109.0),
        vec2(east_line(57.0), 57.0),
        17.0,
        &[(Loft, 9, 17.0), WALKUP, LOFT, (Tenement, 6, 9.0)],
        both,
        25,
    ));
    parts.push(along_slant(
        vec2(east_line(39.0), 39.0),
        vec2(east_line(2.0), 2.0),
        15.0,
        &[LOFT, WALKUP, LOFT],
        both,
        26,
    ));
    parts.push(landmarks::campanile(site, vec2(site.snap(197.0), site.snap(134.0)), site.snap(17.0)));
    parts.push(place(&landmarks::church(site), site.snap2(vec2(66.0, 178.0)), Vec2::Y));
    union(parts)
}
