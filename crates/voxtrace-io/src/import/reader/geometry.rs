//! What a file holds that becomes voxels: a mesh or a cloud of points.

use std::path::Path;
use voxtrace_scene::scene::{LengthUnit, Scene};
use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::{Mesh, UpAxis};
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::voxelize::{self, Estimate, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written};

/// A mesh or a cloud of points.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// Triangles.
    Mesh(Mesh),
    /// Points.
    Points(PointCloud),
}

impl Geometry {
    /// What the reader left out or put up with.
    pub fn notes(&self) -> &[String] {
        match self {
            Self::Mesh(mesh) => &mesh.notes,
            Self::Points(cloud) => &cloud.notes,
        }
    }

    /// Unit of the positions.
    pub fn unit(&self) -> LengthUnit {
        match self {
            Self::Mesh(mesh) => mesh.unit,
            Self::Points(cloud) => cloud.unit,
        }
    }

    /// Says what the unit of the positions is.
    pub fn set_unit(&mut self, unit: LengthUnit) {
        match self {
            Self::Mesh(mesh) => mesh.unit = unit,
            Self::Points(cloud) => cloud.unit = unit,
        }
    }

    /// Turns it so that what was along `up` points along +z.
    pub fn make_z_up(&mut self, up: UpAxis) {
        match self {
            Self::Mesh(mesh) => mesh.make_z_up(up),
            Self::Points(cloud) => cloud.make_z_up(up),
        }
    }

    /// [`Scale::Automatic`], for points as the resolution that it comes to.
    pub fn suited_scale(&self) -> Scale {
        match self {
            Self::Mesh(_) => Scale::Automatic,
            Self::Points(cloud) => Scale::Resolution(cloud.suited_resolution()),
        }
    }

    /// [`voxelize::estimate`] or [`voxelize::estimate_points`].
    ///
    /// # Errors
    /// As those.
    pub fn estimate(&self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        match self {
            Self::Mesh(mesh) => voxelize::estimate(mesh, options),
            Self::Points(cloud) => voxelize::estimate_points(cloud, options),
        }
    }

    /// [`voxelize::voxelize_with_progress`] or [`voxelize::voxelize_points`].
    ///
    /// # Errors
    /// As those.
    pub fn voxelize(
        &self,
        options: &VoxelizeOptions,
        limits: &Limits,
        progress: &VoxelizeProgress,
    ) -> Result<Scene, VoxelizeError> {
        match self {
            Self::Mesh(mesh) => voxelize::voxelize_with_progress(mesh, options, limits, progress),
            Self::Points(cloud) => voxelize::voxelize_points(cloud, options, limits, progress),
        }
    }

    /// [`voxelize::voxelize_to_file`] or [`voxelize::voxelize_points_to_file`].
    ///
    /// # Errors
    /// As those.
    pub fn voxelize_to_file(
        self,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        match self {
            Self::Mesh(mesh) => voxelize::voxelize_to_file(mesh, options, limits, path, progress),
            Self::Points(cloud) => voxelize::voxelize_points_to_file(cloud, options, limits, path, progress),
        }
    }
}
