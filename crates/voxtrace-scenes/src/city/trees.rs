//! Trees: a trunk that forks, and clumps of leaves.

use super::{
    paints::leaves,
    site::{Dice, Site},
};
use crate::kit::*;
use glam::{Vec3, vec3};

/// A few designs of trees to be copied, turned and scaled.
pub struct Trees {
    designs: Vec<Solid>,
}

impl Trees {
    pub fn new(site: &Site) -> Self {
        let ramps = site.paints.ramps;
        let colours =
            [(ramps.green, 0.5), (ramps.gold, 0.5), (ramps.green, 0.62), (ramps.russet, 0.5), (ramps.green, 0.4)];
        let designs = colours.iter().enumerate().map(|(i, &(ramp, level))| tree(site, i as u32, ramp, level));
        Self { designs: designs.collect() }
    }

    /// A tree of about `height` metres; `autumn` is the share of trees that have turned.
    pub fn pick(&self, dice: &mut Dice, height: f32, autumn: f32) -> Solid {
        let design = if dice.chance(autumn) { [1, 3][dice.below(2)] } else { [0, 2, 4][dice.below(3)] };
        self.designs[design].turn_z(dice.between(0.0, 360.0)).scaled(height / 10.0 * dice.between(0.85, 1.15))
    }
}

/// A tree 10 m high on the origin.
fn tree(site: &Site, seed: u32, ramp: Ramp, level: f32) -> Solid {
    let mut dice = Dice::new(900 + seed);
    let bark = Paint::plain(site.paints.ramps.wood.even(0.15, 0.4));
    let thick = 0.24_f32.max(0.7 * site.voxel);
    let mut wood = vec![bar(vec3(0.0, 0.0, -0.6), vec3(0.1, 0.1, 4.4), thick)];
    let mut crown = Vec::new();
    for i in 0..22 {
        // Clumps on rings of an egg, the widest at two fifths of its height.
        let level = (i as f32 + 0.5) / 22.0;
        let turn = noise::sin_cos_degrees(137.5 * i as f32 + dice.between(-20.0, 20.0));
        let reach = 3.3 * (1.0 - (level - 0.36) * (level - 0.36) * 2.2).max(0.1) * dice.between(0.55, 1.0);
        let at = vec3(turn.1 * reach, turn.0 * reach, 3.4 + 5.9 * level);
        let radius = dice.between(0.75, 1.35) * (1.15 - 0.45 * level);
        let clump = ellipsoid(vec3(radius, radius * dice.between(0.8, 1.0), radius * dice.between(0.7, 0.9)));
        crown.push(clump.turn_z(dice.between(0.0, 180.0)).at(at));
        if i % 4 == 1 {
            wood.push(bar(vec3(0.05, 0.05, 3.2), at, 0.6 * thick));
        }
    }
    let paint = leaves(ramp, level, 9.5);
    union([union(wood).paint(&bark), union(crown).paint(&paint)])
}

/// A clipped bush.
pub fn bush(site: &Site, dice: &mut Dice) -> Solid {
    let ramps = site.paints.ramps;
    let ramp = [ramps.green, ramps.green, ramps.gold, ramps.russet][dice.below(4)];
    let size = dice.between(0.5, 0.95);
    ellipsoid(Vec3::new(size, size * 0.9, size * 0.8)).z(0.3).paint(&leaves(ramp, 0.5, 1.0))
}
