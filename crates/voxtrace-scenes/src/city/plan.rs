//! The plan of the city: x east, y north, metres. Two avenues run north, three streets run east, and one old road
//! runs aslant, which leaves a wedge of a block at the square. A park lies north of the square.

use glam::{Vec2, vec2};

/// Edge of the built square.
pub const SIZE: f32 = 240.0;
/// Width of the sidewalks.
pub const SIDEWALK: f32 = 4.0;
/// The tip of the wedge block, on the avenue.
pub const TIP: Vec2 = vec2(90.0, 107.0);
/// Direction of the slanted road, southwards: one east for two south.
pub const SLANT: Vec2 = vec2(0.447_213_6, -0.894_427_2);
/// The park.
pub const PARK: (Vec2, Vec2) = (vec2(90.0, 134.0), vec2(175.0, 196.0));
/// Margin that stays free at the border of the scene.
pub const MARGIN: f32 = 1.6;

/// A roadway.
pub struct Road {
    /// Where its middle line begins.
    pub from: Vec2,
    /// Its direction, a unit vector.
    pub along: Vec2,
    pub length: f32,
    /// Half the width between the kerbs.
    pub half: f32,
    /// Broken white lines, metres to the right of the middle.
    pub lines: &'static [f32],
    /// Double yellow line.
    pub middle: Option<f32>,
    /// Bicycle lane, from and to.
    pub bikes: Option<(f32, f32)>,
    /// Bus lane, from and to.
    pub buses: Option<(f32, f32)>,
}

/// All roadways.
pub fn roads() -> Vec<Road> {
    let road = |from: Vec2, along: Vec2, length: f32, half: f32| Road {
        from,
        along,
        length,
        half,
        lines: &[],
        middle: None,
        bikes: None,
        buses: None,
    };
    vec![
        // The avenue: one way south, a bus lane on its western side.
        Road { lines: &[-1.9, 1.8], buses: Some((2.2, 5.3)), ..road(vec2(78.0, SIZE), Vec2::NEG_Y, SIZE, 8.0) },
        // The slanted road: one way south, bicycles on the eastern side.
        Road { lines: &[0.6], bikes: Some((-4.4, -2.0)), ..road(vec2(99.8, 111.9) - SLANT * 12.0, SLANT, 140.0, 7.0) },
        // The eastern avenue: one way north.
        Road { lines: &[-1.5, 1.5], ..road(vec2(186.0, 130.0), Vec2::Y, 110.0, 7.0) },
        // The wide cross street, both ways.
        Road { lines: &[-2.9, 2.9], middle: Some(0.0), ..road(vec2(0.0, 122.0), Vec2::X, SIZE, 8.0) },
        road(vec2(0.0, 48.0), Vec2::X, SIZE, 4.0),
        road(vec2(0.0, 204.0), Vec2::X, SIZE, 4.0),
    ]
}

/// The building lines of all blocks, counter-clockwise.
pub fn blocks() -> Vec<Vec<Vec2>> {
    let (low, high) = (-20.0, SIZE + 20.0);
    let rectangle = |x0: f32, x1: f32, y0: f32, y1: f32| vec![vec2(x0, y0), vec2(x1, y0), vec2(x1, y1), vec2(x0, y1)];
    vec![
        rectangle(low, 66.0, low, 40.0),
        rectangle(low, 66.0, 56.0, 110.0),
        rectangle(low, 66.0, 134.0, 196.0),
        rectangle(low, 66.0, 212.0, high),
        vec![vec2(90.0, low), vec2(west_line(low), low), vec2(west_line(40.0), 40.0), vec2(90.0, 40.0)],
        vec![vec2(90.0, 56.0), vec2(west_line(56.0), 56.0), TIP],
        vec![vec2(east_line(56.0), 56.0), vec2(high, 56.0), vec2(high, 110.0), vec2(east_line(110.0), 110.0)],
        vec![vec2(east_line(low), low), vec2(high, low), vec2(high, 40.0), vec2(east_line(40.0), 40.0)],
        rectangle(PARK.0.x, PARK.1.x, PARK.0.y, PARK.1.y),
        rectangle(197.0, high, 134.0, 196.0),
        rectangle(90.0, 175.0, 212.0, high),
        rectangle(197.0, high, 212.0, high),
    ]
}

/// x of the slanted road's western building line at a y.
pub fn west_line(y: f32) -> f32 {
    TIP.x + 0.5 * (TIP.y - y)
}

/// x of the slanted road's eastern building line at a y.
pub fn east_line(y: f32) -> f32 {
    west_line(y) + 24.6
}

/// A zebra crossing: people walk along y.
pub struct Crossing {
    pub middle: Vec2,
    /// Direction of the stripes' row, a unit vector.
    pub along: Vec2,
    /// Half the width of the road, half the length of the stripes.
    pub half: Vec2,
}

impl Crossing {
    pub fn local(&self, at: Vec2) -> Vec2 {
        let by = at - self.middle;
        vec2(by.dot(self.along), by.perp_dot(self.along))
    }
}

/// All crossings.
pub fn crossings() -> Vec<Crossing> {
    let over = |x: f32, y: f32, along: Vec2, half_road: f32| Crossing {
        middle: vec2(x, y),
        along,
        half: vec2(half_road, 1.7),
    };
    let slanted = |y: f32| {
        let middle = vec2(0.5 * (west_line(y) + east_line(y)), y);
        over(middle.x, middle.y, vec2(-SLANT.y, SLANT.x), 7.0)
    };
    let mut all = vec![slanted(60.0), slanted(37.0)];
    for y in [40.5, 55.5, 110.5, 133.0, 197.0, 211.0] {
        all.push(over(78.0, y, Vec2::X, 8.0));
    }
    for y in [133.0, 197.0, 211.0] {
        all.push(over(186.0, y, Vec2::X, 7.0));
    }
    for x in [67.5, 174.0, 198.0] {
        all.push(over(x, 122.0, Vec2::Y, 8.0));
    }
    for (x, y) in [(67.5, 48.0), (88.5, 48.0), (67.5, 204.0), (88.5, 204.0), (176.5, 204.0), (195.5, 204.0)] {
        all.push(over(x, y, Vec2::Y, 4.0));
    }
    all
}

/// Whether a place is on the gravel plaza at the tip of the wedge.
pub fn plaza(at: Vec2) -> bool {
    at.x > 86.2 && at.y > 100.0 && at.y < 119.0 && at.x < west_line(at.y) + 5.4
}

/// Whether a place is where roads cross, without lane lines.
pub fn crossing_area(at: Vec2) -> bool {
    let within = |x0: f32, x1: f32, y0: f32, y1: f32| at.x > x0 && at.x < x1 && at.y > y0 && at.y < y1;
    within(64.0, 114.0, 110.0, 134.0)
        || within(66.0, 90.0, 40.0, 56.0)
        || within(66.0, 90.0, 196.0, 212.0)
        || within(175.0, 197.0, 110.0, 134.0)
        || within(175.0, 197.0, 196.0, 212.0)
        || within(112.0, 144.0, 39.0, 57.0)
}
