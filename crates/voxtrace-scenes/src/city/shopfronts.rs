//! Façades at the street: shop windows under signs and awnings, stoops, lobbies with canopies.

use super::{
    facade::{Dressing, Facade},
    paints::Ramps,
    site::{Dice, Site},
};
use crate::kit::{
    noise::{floor, fraction, hash, hash3, unit},
    *,
};
use glam::{IVec3, vec2, vec3};

impl Facade {
    /// Shops of one to three bays each.
    pub fn shops(&self, site: &Site, dice: &mut Dice, bays: u32, bay: f32, storey: f32, out: &mut Dressing) {
        let ramps = site.paints.ramps;
        let mut i = 0;
        while i < bays {
            let count = (1 + dice.below(3) as u32).min(bays - i);
            let (from, to) = (0.4 + bay * i as f32, 0.4 + bay * (i + count) as f32);
            let (left, right) = (site.snap(from + 0.35), site.snap(to - 0.35));
            let head = site.snap(storey - 1.3);
            let recess = site.width(0.6);
            let sign = [
                trim_tone(ramps.green, 0.2),
                trim_tone(ramps.red, 0.6),
                trim_tone(ramps.iron, 0.3),
                trim_tone(ramps.blue, 0.5),
                trim_tone(ramps.cream, 0.8),
                trim_tone(ramps.wood, 0.4),
            ][dice.below(6)];
            let paint = shop_window(site, left, recess, storey, sign, dice.seed());
            out.cuts.push(cuboid(vec3(left, -1.5, site.snap(0.5)), vec3(right, recess, head)).paint(&paint));
            let board = vec2(head + site.snap(0.1), site.snap(storey - 0.35));
            let lettering = lettering(sign, ramps, dice.seed());
            out.parts.push(
                cuboid(vec3(left - 0.1, -site.width(0.3), board.x), vec3(right + 0.1, 0.5, board.y)).paint(&lettering),
            );
            if dice.chance(0.5) {
                let (z, reach) = (head, 1.7);
                let wedge = Profile::polygon(&[(0.3, z + 0.5), (0.3, z - 0.1), (-reach, z - 0.95), (-reach, z - 0.45)]);
                let colour = [ramps.green, ramps.red, ramps.blue, ramps.cream, ramps.gold, ramps.russet];
                let (a, b) = (colour[dice.below(6)], colour[3 + dice.below(2)]);
                let stripes = dice.chance(0.5);
                let cloth = Paint::new(move |p| {
                    let stripe = stripes && (p.at.x / 0.6) as i32 % 2 == 0;
                    if stripe { b.even(0.7, 0.3) } else { a.even(0.5, 0.4) }
                });
                out.parts.push(extrude(wedge, Axis::X, left + 0.1, right - 0.1).paint(&cloth));
            }
            i += count;
        }
    }

    /// A flight of steps to the door around `x`.
    pub fn stoop(&self, site: &Site, x: f32) -> Solid {
        // The door is half a storey up; the flight comes straight down to the sidewalk.
        let rise = 1.8;
        let flight = Profile::polygon(&[(0.5, -1.0), (0.5, rise), (-0.9, rise), (-3.1, 0.1), (-3.1, -1.0)]);
        let cheek = Profile::polygon(&[(0.5, -1.0), (0.5, rise + 0.9), (-0.9, rise + 0.9), (-3.2, 0.9), (-3.2, -1.0)]);
        let wing = site.width(0.3);
        let cheeks = extrude(cheek.clone(), Axis::X, x - 1.1, x - 1.1 + wing).and(extrude(
            cheek,
            Axis::X,
            x + 1.1 - wing,
            x + 1.1,
        ));
        let hood = cuboid(vec3(x - 1.1, -0.7, rise + 3.0), vec3(x + 1.1, 0.4, rise + 3.5));
        let jambs = cuboid(vec3(x - 1.0, -0.3, rise), vec3(x - 0.6, 0.4, rise + 3.1));
        let door = cuboid(vec3(x - 0.6, -0.15, rise), vec3(x + 0.6, 0.4, rise + 2.7));
        let surround = union([hood, jambs.clone(), jambs.x(1.6)]).paint(&self.trim);
        union([extrude(flight, Axis::X, x - 1.0, x + 1.0), cheeks])
            .paint(&self.trim)
            .and(surround)
            .and(door.paint(&site.paints.wood))
    }

    /// A wide door around `x` under a canopy.
    pub fn lobby(&self, site: &Site, x: f32, out: &mut Dressing) {
        let glow = site.paints.ramps.glow;
        let glass = site.paints.ramps.glass;
        let brass = site.paints.ramps.gold;
        let door = Paint::new(move |p| {
            if p.at.y > 0.5 && p.at.z > 2.6 {
                glow.even(0.5, 0.5)
            } else if (p.at.x * 1.4) as i32 % 2 == 0 {
                glass.even(0.3, 0.3)
            } else {
                brass.even(0.4, 0.3)
            }
        });
        out.cuts.push(cuboid(vec3(x - 1.7, -1.5, 0.0), vec3(x + 1.7, 0.9, 3.6)).paint(&door));
        let cloth = Paint::plain(site.paints.ramps.green.even(0.15, 0.25));
        let canopy = cuboid(vec3(x - 1.5, -3.4, 3.0), vec3(x + 1.5, 0.5, 3.6)).paint(&cloth);
        let radius = 0.5 * site.thick(0.16);
        let pole = bar(vec3(1.3, -3.2, -0.5), vec3(1.3, -3.2, 3.2), radius).both_x().x(x).paint(&site.paints.steel);
        out.parts.extend([canopy, pole]);
    }
}

fn trim_tone(ramp: Ramp, level: f32) -> Tone {
    ramp.even(level, 0.25)
}

/// A sign: light letters, two voxels wide, on its ground.
fn lettering(sign: Tone, ramps: Ramps, seed: u32) -> Paint {
    let pale = ramps.cream;
    Paint::new(move |p| {
        let cell = p.at / (1.6 * p.voxel.max(0.12));
        let letter = unit(hash3(IVec3::new(floor(cell.x), floor(cell.z), 3), seed));
        if letter > 0.62 && p.at.y < 0.0 { pale.even(0.8, 0.3) } else { sign }
    })
}

/// The inside of a shop window: dark glass over things in many colours, here and there a lamp.
fn shop_window(site: &Site, left: f32, recess: f32, storey: f32, sign: Tone, seed: u32) -> Paint {
    let ramps = site.paints.ramps;
    let lit = unit(hash(seed)) < 0.45;
    Paint::new(move |p| {
        if p.at.y < recess {
            return sign;
        }
        let cell = IVec3::new(floor((p.at.x - left) / 0.9), floor(p.at.z / 0.8), 4);
        let h = hash3(cell, seed);
        if fraction((p.at.x - left) / 2.4) * 2.4 < p.voxel.max(0.1) {
            return sign;
        }
        if p.at.z > storey - 2.1 && lit {
            return ramps.glow.even(0.5, 0.5);
        }
        let goods = [ramps.red, ramps.gold, ramps.cream, ramps.blue, ramps.wood, ramps.green];
        if p.at.z < 1.7 && unit(h) < 0.5 {
            return goods[(hash(h) % 6) as usize].even(0.5, 0.4);
        }
        ramps.glass.even(0.3 + 0.3 * unit(h), 0.3)
    })
}
