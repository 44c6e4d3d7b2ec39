//! Rows of buildings along a side of a block, sharing their party walls.

use super::{
    house::House,
    paints::{roofing, wall},
    site::{Dice, Site, place},
    styles::{Kind, rear},
    towers::{glass_tower, stepped_tower},
};
use crate::kit::*;
use glam::{Vec2, vec2, vec3};

/// A building of a row: its kind, floors (0: the kind's own), frontage (0: the kind's own).
pub type Lot = (Kind, u32, f32);

/// A row of buildings whose fronts follow a line; the street lies to the right of it.
pub struct Row<'a> {
    pub from: Vec2,
    pub to: Vec2,
    pub depth: f32,
    pub lots: &'a [Lot],
    /// Whether the ends of the row show façades.
    pub ends: [bool; 2],
    pub seed: u32,
}

impl Row<'_> {
    /// The row. The frontages of the lots are stretched to fill it.
    pub fn build(&self, site: &Site) -> Solid {
        let mut dice = Dice::new(self.seed);
        let straight = self.from.x == self.to.x || self.from.y == self.to.y;
        let [from, to] = [self.from, self.to].map(|at| if straight { site.snap2(at) } else { at });
        let length = (to - from).length();
        let widths: Vec<f32> =
            self.lots.iter().map(|lot| if lot.2 > 0.0 { lot.2 } else { lot.0.frontage(&mut dice) }).collect();
        let stretch = length / widths.iter().sum::<f32>();
        let (mut x, mut parts) = (0.0, Vec::new());
        // Left end, width, height and depth of what is built, for the party walls.
        let mut built: Vec<(f32, f32, f32, f32)> = Vec::new();
        for (i, (lot, width)) in self.lots.iter().zip(widths).enumerate() {
            let left = site.snap(x);
            x += width * stretch;
            let width = site.snap(x) - left;
            let depth = site.snap(self.depth * if lot.0 == Kind::Brownstone { 0.8 } else { dice.between(0.88, 1.0) });
            let open = [i == 0 && self.ends[0], i + 1 == self.lots.len() && self.ends[1]];
            let (solid, height) = building(site, &mut dice, *lot, vec2(width, depth), open);
            parts.push(solid.x(left));
            built.push((left, width, height, depth));
        }
        // Lower houses reach into their taller neighbours, so that no voxels are spent on walls that nobody sees.
        for pair in built.windows(2) {
            let [(left, _, low, a), (middle, width, high, b)] = [pair[0], pair[1]];
            let reach = (3.5 * site.voxel).min(0.4 * width.min(middle - left));
            let (rim, top) = (3.5 * site.voxel, low.min(high) - 3.5 * site.voxel);
            if top > rim {
                let link = cuboid(vec3(middle - reach, rim, -5.0), vec3(middle + reach, a.min(b) - rim, top));
                parts.push(link);
            }
        }
        place(&union(parts), from, to - from)
    }
}

/// A building with its front on y = 0, from x = 0 on; and the height up to which it fills its lot.
fn building(site: &Site, dice: &mut Dice, (kind, floors, _): Lot, size: Vec2, open: [bool; 2]) -> (Solid, f32) {
    let blind = [false, !open[1], false, !open[0]];
    match kind {
        Kind::Deco => {
            let floors = if floors > 0 { floors } else { 14 + dice.below(6) as u32 };
            (stepped_tower(site, dice, size, floors, blind), floors as f32 * 0.55 * 3.4)
        }
        Kind::Glass => {
            let floors = if floors > 0 { floors } else { 12 + dice.below(5) as u32 };
            (glass_tower(site, dice, size, floors), 0.0)
        }
        _ => {
            let front = kind.facade(site, dice, floors);
            let height = front.height();
            let back = rear(site, dice, height);
            let ramps = site.paints.ramps;
            let side = [ramps.brick, ramps.buff, ramps.grey, ramps.brick][dice.below(4)];
            let house = House {
                corners: House::rectangle(size),
                walls: vec![Some(&front), open[1].then_some(&front), Some(&back), open[0].then_some(&front)],
                foot: 0.0,
                height,
                paint: if open[0] || open[1] { front.wall.clone() } else { wall(side, 0.45) },
                roof: roofing(if dice.chance(0.35) { ramps.concrete } else { ramps.tar }, dice.between(0.3, 0.8)),
                parapet: dice.between(0.8, 1.3),
                seed: dice.seed(),
            };
            (house.furnished(site, Vec2::splat(1.2), size - 1.2), height - house.parapet)
        }
    }
}
