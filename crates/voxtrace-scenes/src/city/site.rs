//! What every part of the city is built with: paints, the voxel lattice, and chance.

use super::paints::Paints;
use crate::kit::{
    Solid,
    noise::{floor, hash, unit},
};
use glam::{Vec2, Vec3, vec2, vec3};

/// Paints, and the lattice that straight things are laid on.
pub struct Site {
    pub paints: Paints,
    pub voxel: f32,
}

impl Site {
    /// The plane between voxels that is nearest to `x`: what lies on one comes out straight. Voxels too coarse for
    /// any detail keep their places instead.
    pub fn snap(&self, x: f32) -> f32 {
        if self.voxel > 0.6 { x } else { floor(x / self.voxel + 0.5) as f32 * self.voxel }
    }

    /// A width that is a whole number of voxels, at least one: for what lies on the lattice.
    pub fn width(&self, x: f32) -> f32 {
        self.snap(x).max(self.voxel)
    }

    /// A width that stays without holes wherever a thing stands.
    pub fn thick(&self, x: f32) -> f32 {
        x.max(1.5 * self.voxel)
    }

    /// A width that is an even number of voxels, at least two: for what stands centred on a crossing of the lattice.
    pub fn even(&self, x: f32) -> f32 {
        2.0 * self.width(0.5 * x)
    }

    /// The nearest crossing of the lattice on the ground.
    pub fn snap2(&self, at: Vec2) -> Vec2 {
        vec2(self.snap(at.x), self.snap(at.y))
    }

    /// The centre near `at` of something `size` wide, so that both of its ends lie between voxels.
    pub fn center(&self, at: f32, size: f32) -> f32 {
        self.snap(at - 0.5 * size) + 0.5 * size
    }
}

/// A sequence of random numbers.
#[derive(Clone)]
pub struct Dice(u32);

impl Dice {
    pub fn new(seed: u32) -> Self {
        Self(hash(seed ^ 0x6c07_8965))
    }

    /// A number in [0, 1).
    pub fn draw(&mut self) -> f32 {
        self.0 = hash(self.0.wrapping_add(0x9e37_79b9));
        unit(self.0)
    }

    /// A number from `low` to `high`.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.draw()
    }

    /// An index below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.draw() * count as f32) as usize).min(count - 1)
    }

    /// Whether something of this probability happens.
    pub fn chance(&mut self, probability: f32) -> bool {
        self.draw() < probability
    }

    pub fn seed(&mut self) -> u32 {
        self.draw();
        self.0
    }
}

/// Turned so that its x axis runs along `along`, then moved to `from`.
pub fn place(solid: &Solid, from: Vec2, along: Vec2) -> Solid {
    let turned = if along.y == 0.0 && along.x > 0.0 { solid.clone() } else { solid.turn_towards(along.x, along.y) };
    turned.at(vec3(from.x, from.y, 0.0))
}

/// `at` on the ground.
pub fn ground(at: Vec2) -> Vec3 {
    vec3(at.x, at.y, 0.0)
}
