//! Meshes that tests voxelize, and random numbers that are the same on every run.

#![allow(dead_code, reason = "each test uses some")]

use voxtrace::glam::{Mat3, Vec3};
use voxtrace::mesh::Mesh;

/// Random numbers that are the same on every run.
pub struct Random(pub u64);

impl Random {
    /// A number in [0, 1).
    pub fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 40) as f32 / (1 << 24) as f32
    }

    /// A number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        (self.unit() * end as f32) as usize % end.max(1)
    }

    /// A point in the cube [0, size)³.
    pub fn point(&mut self, size: f32) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * size
    }
}

/// A mesh of indexed triangles.
pub fn indexed(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Mesh {
    Mesh { positions, triangles, ..Mesh::new("mesh") }
}

/// A surface over a grid of two parameters in [0, 1], closed along both where `closed` says so.
pub fn surface(across: u32, along: u32, closed: [bool; 2], point: impl Fn(f32, f32) -> Vec3) -> Mesh {
    let [columns, rows] = [across + u32::from(!closed[0]), along + u32::from(!closed[1])];
    let at = |i: u32, j: u32| point(i as f32 / across as f32, j as f32 / along as f32);
    let positions = (0..rows).flat_map(|j| (0..columns).map(move |i| (i, j))).map(|(i, j)| at(i, j)).collect();
    let index = |i: u32, j: u32| (j % rows) * columns + i % columns;
    let triangles = (0..along).flat_map(|j| (0..across).map(move |i| (i, j))).flat_map(|(i, j)| {
        let [a, b, c, d] = [index(i, j), index(i + 1, j), index(i + 1, j + 1), index(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    indexed(positions, triangles.collect())
}

/// A sphere of latitudes and longitudes, normals outwards.
pub fn sphere(center: Vec3, radius: f32, steps: u32) -> Mesh {
    surface(2 * steps, steps, [true, false], |u, v| {
        let (longitude, latitude) = (u * std::f32::consts::TAU, (v - 0.5) * std::f32::consts::PI);
        let circle = latitude.cos();
        center + radius * Vec3::new(circle * longitude.cos(), circle * longitude.sin(), latitude.sin())
    })
}

/// A torus around z.
pub fn torus(center: Vec3, ring: f32, tube: f32, steps: u32) -> Mesh {
    surface(2 * steps, steps, [true, true], |u, v| {
        let (turn, around) = (u * std::f32::consts::TAU, v * std::f32::consts::TAU);
        let distance = ring + tube * around.cos();
        center + Vec3::new(distance * turn.cos(), distance * turn.sin(), tube * around.sin())
    })
}

/// A box of twelve triangles, normals outwards, turned about its middle.
pub fn cuboid(min: Vec3, max: Vec3, turn: Mat3) -> Mesh {
    let middle = (min + max) * 0.5;
    let positions = (0..8).map(|corner| {
        let pick = Vec3::new((corner & 1) as f32, (corner >> 1 & 1) as f32, (corner >> 2) as f32);
        middle + turn * (min + (max - min) * pick - middle)
    });
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    indexed(positions.collect(), triangles)
}
