//! Roadways with their markings, and the raised blocks with kerbs and sidewalks between them.

use super::{
    house,
    paints::paving,
    plan::{self, Road},
    site::Site,
};
use crate::kit::{noise::*, *};
use glam::{IVec3, Vec2, Vec3, vec2};

/// Height of the sidewalks above the roadways.
pub fn kerb(site: &Site) -> f32 {
    site.snap(0.3).max(0.18)
}

/// Everything underfoot.
pub fn ground(site: &Site) -> Solid {
    let height = kerb(site);
    let ramps = site.paints.ramps;
    let road = half_space(Vec3::ZERO, Vec3::Z).paint(&roadway(site));
    let slabs = paving(ramps.concrete, 0.5, 1.5);
    let yards = paving(ramps.tar, 0.45, 2.2);
    let mut parts = vec![road];
    for block in plan::blocks() {
        // In order of precedence, all tops being level: yards, slabs, kerbstones.
        let layer = |grow: f32, paint: &Paint| {
            extrude(house::footprint(&block).offset(grow), Axis::Z, -3.0, height).paint(paint)
        };
        parts.push(layer(-3.0, &yards));
        parts.push(layer(plan::SIDEWALK - 0.35, &slabs));
        parts.push(layer(plan::SIDEWALK, &site.paints.granite));
    }
    union(parts)
}

/// The roadway: worn wheel tracks, patches, lane lines, crossings.
fn roadway(site: &Site) -> Paint {
    let ramps = site.paints.ramps;
    let roads = plan::roads();
    let crossings = plan::crossings();
    Paint::new(move |p| {
        let at = vec2(p.world.x, p.world.y);
        let line = 0.5 * p.voxel.max(0.14);
        let white = ramps.cream.even(0.55 + 0.3 * value_noise(p.world / 0.7, 81), 0.45);
        let wear = 0.14 * fractal_noise(p.world / 4.0, 3, 82);
        for crossing in &crossings {
            let local = crossing.local(at);
            let half = crossing.half;
            if local.x.abs() < half.x && local.y.abs() < half.y {
                return if fraction(local.x / 1.3) < 0.48 { white } else { ramps.asphalt.tone(0.45 + wear) };
            }
            // The stop line.
            if (local.y.abs() - half.y - 1.0).abs() < 1.4 * line && local.x.abs() < half.x {
                return white;
            }
        }
        if plan::plaza(at) {
            let ring = fraction((at - vec2(88.5, 116.0)).length() / 2.2);
            return ramps.buff.even(0.62 + wear + if ring < 0.16 { -0.25 } else { 0.0 }, 0.35);
        }
        if plan::crossing_area(at) {
            return ramps.asphalt.tone(0.45 + wear);
        }
        for road in &roads {
            let (across, along) = road.local(at);
            if across.abs() > road.half {
                continue;
            }
            let dash = fraction(along / 6.0) < 0.42;
            if road.lines.iter().any(|offset| (across - offset).abs() < line) && dash {
                return white;
            }
            let edge = road.half - 2.5;
            if road.half > 5.0 && (across.abs() - edge).abs() < line {
                return white;
            }
            if let Some(middle) = road.middle
                && ((across - middle).abs() - 0.3).abs() < line
            {
                return ramps.cab.even(0.4, 0.5);
            }
            if let Some((low, high)) = road.bikes
                && (low..high).contains(&across)
            {
                let edge = (across - low).min(high - across) < 2.0 * line;
                return if edge { white } else { ramps.copper.even(0.35 + wear, 0.4) };
            }
            if let Some((low, high)) = road.buses
                && (low..high).contains(&across)
            {
                return ramps.russet.even(0.3 + 0.8 * wear, 0.4);
            }
            // Wheel tracks are polished, patches darker, manholes iron.
            let track =
                0.07 * value_noise(p.world / 0.4, 83) - 0.06 * f32::from(u8::from(fraction(across / 1.6) < 0.3));
            let patch = hash3(IVec3::new(floor(along / 7.0), floor(across / 2.9), 6), 84);
            let patched = if patch.is_multiple_of(7) { -0.18 } else { 0.0 };
            if patch % 11 == 1
                && (vec2(fraction(along / 7.0) * 7.0, fraction(across / 2.9) * 2.9) - 1.4).length() < 0.45
            {
                return ramps.iron.even(0.6, 0.4);
            }
            return ramps.asphalt.tone(0.45 + wear + track + patched);
        }
        ramps.asphalt.tone(0.5 + wear)
    })
}

impl Road {
    /// Position across and along the road.
    pub fn local(&self, at: Vec2) -> (f32, f32) {
        let by = at - self.from;
        (by.perp_dot(self.along), by.dot(self.along))
    }

    /// The point at a position along and across the road.
    pub fn point(&self, along: f32, across: f32) -> Vec2 {
        self.from + self.along * along + vec2(self.along.y, -self.along.x) * across
    }
}
