//! A box of colours of a Qubicle model becomes a grid with its place in the scene.

use crate::import::grids::checked_size;
use crate::import::grids::paints::Paints;
use crate::import::grids::slab::Slabs;
use crate::import::reader::Voxels;
use glam::{IVec3, Vec3};
use std::path::Path;
use voxtrace_scene::grid::{MAX_COORDINATE, VoxelGrid};
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, Limits};

/// A scene in the making, matrix by matrix.
pub(super) struct Model<'a> {
    pub path: &'a Path,
    pub limits: &'a Limits,
    pub paints: Paints,
    pub notes: Vec<String>,
    scene: Scene,
    /// Places of voxels in all matrices so far.
    places: u64,
    /// Nodes of the tree so far.
    nodes: u64,
}

/// What a file says of a matrix, in its own axes.
#[derive(Clone)]
pub(super) struct Matrix {
    pub name: String,
    /// Width, height, depth.
    pub size: [u32; 3],
    /// Of its lowest corner.
    pub position: [i32; 3],
    /// Whether z points away from the viewer.
    pub is_away: bool,
}

impl<'a> Model<'a> {
    pub fn new(path: &'a Path, limits: &'a Limits) -> Self {
        let (paints, notes, scene) = (Paints::default(), Vec::new(), Scene::new(""));
        Self { path, limits, paints, notes, scene, places: 0, nodes: 0 }
    }

    /// Counts a node of a tree, which begins at `offset`, below `depth` others.
    pub fn enter_node(&mut self, offset: u64, depth: u32) -> Result<(), ImportError> {
        let (path, limits) = (self.path, self.limits);
        self.nodes += 1;
        if self.nodes > limits.items {
            return Err(ImportError::limit(path, Some(offset), "nodes", self.nodes, limits.items));
        }
        if depth > limits.depth {
            return Err(ImportError::limit(path, Some(offset), "depth", depth.into(), limits.depth.into()));
        }
        Ok(())
    }

    /// The size of a matrix on the grid, checked; its numbers stand at `offset`.
    pub fn check(&mut self, matrix: &Matrix, offset: u64) -> Result<IVec3, ImportError> {
        if let Some(far) = matrix.position.iter().find(|at| at.unsigned_abs() > MAX_COORDINATE as u32) {
            return Err(ImportError::malformed(self.path, offset, format!("a matrix at {far}, too far away")));
        }
        let [width, height, depth] = matrix.size.map(u64::from);
        let size = checked_size(self.path, offset, [width, depth, height], self.limits)?;
        self.places += size.to_array().iter().map(|&edge| edge as u64).product::<u64>();
        if self.places > self.limits.voxels {
            let limit = self.limits.voxels;
            return Err(ImportError::limit(self.path, Some(offset), "places of voxels", self.places, limit));
        }
        Ok(size)
    }

    /// As [`Self::check`], with a grid whose voxels come in order along the file's x (`axis` 0) or z (1).
    pub fn slabs(&mut self, matrix: &Matrix, offset: u64, axis: usize) -> Result<Slabs, ImportError> {
        let size = self.check(matrix, offset)?;
        Slabs::new(self.path, offset, size, axis)
    }

    /// Puts a matrix with its voxels into the scene.
    pub fn add(&mut self, matrix: Matrix, grid: VoxelGrid) {
        let [x, up, z] = matrix.position.map(|at| at as f32);
        let y = if matrix.is_away { z } else { -z - matrix.size[2] as f32 };
        let place = Transform::from_translation(Vec3::new(x, y, up));
        let instance = self.scene.add_instance(grid, place);
        self.scene.instances[instance].name = matrix.name;
    }

    pub fn finish(mut self) -> Voxels {
        self.scene.materials = self.paints.finish();
        Voxels { scene: self.scene, notes: self.notes }
    }
}

impl Matrix {
    /// Where a voxel of the file lies on the grid: the viewer looks along our +y.
    pub fn place(&self, x: u32, up: u32, z: u32) -> IVec3 {
        let y = if self.is_away { z } else { self.size[2] - 1 - z };
        IVec3::new(x as i32, y as i32, up as i32)
    }
}
