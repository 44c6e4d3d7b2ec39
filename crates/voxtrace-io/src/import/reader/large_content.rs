//! The two kinds of geometry that stay in their file behind one face: each is a source of triangles or of points, and what was
//! learned by reading it once.

use super::PointFilter;
use super::filtered_points::FilteredPoints;
use super::up_axis::{ZUpPoints, ZUpTriangles};
use std::path::{Path, PathBuf};
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::{UpAxis, source::TriangleSource};
use voxtrace_voxelize::points::source::PointSource;
use voxtrace_voxelize::voxelize::{
    self, Estimate, VoxelizeError, VoxelizeOptions, VoxelizeProgress, Written, large, large_points,
};

/// What a reader has opened, and the bytes that it would take in memory.
pub(crate) struct LargeContent {
    pub content: Box<dyn Content>,
    pub size_bytes: u64,
    /// Further files that it reads, for what becomes of work after they have changed.
    pub files: Vec<PathBuf>,
}

impl LargeContent {
    /// Triangles.
    pub fn of_triangles(source: impl TriangleSource + 'static, size_bytes: u64) -> Self {
        Self { content: Triangles::boxed(source), size_bytes, files: Vec::new() }
    }

    /// Points.
    pub fn of_points(source: impl PointSource + 'static, size_bytes: u64) -> Self {
        Self { content: Points::boxed(source), size_bytes, files: Vec::new() }
    }
}

/// What stays in a file. To estimate and to voxelize it wants a survey first.
pub(crate) trait Content: Send {
    fn about(&mut self) -> About<'_>;
    fn z_up(self: Box<Self>, up: UpAxis) -> Box<dyn Content>;
    /// Those points alone that are asked for; of a mesh all. `path` names it in errors.
    fn filtered(self: Box<Self>, path: &Path, filter: PointFilter) -> Box<dyn Content>;
    fn is_points(&self) -> bool {
        false
    }
    /// The source of points, where it is one.
    fn into_points(self: Box<Self>) -> Option<Box<dyn PointSource>> {
        None
    }
    /// Triangles or points, known once there was a survey.
    fn count(&self) -> Option<u64>;
    fn survey(&mut self, options: &VoxelizeOptions, progress: &VoxelizeProgress) -> Result<(), VoxelizeError>;
    fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError>;
    fn voxelize_to_file(
        &mut self,
        stamp: &str,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError>;
}

/// What is known of either kind.
pub(crate) struct About<'a> {
    pub name: &'a mut String,
    pub unit: &'a mut LengthUnit,
    pub notes: &'a [String],
}

/// A mesh.
struct Triangles {
    source: Box<dyn TriangleSource>,
    survey: Option<large::Survey>,
}

impl Triangles {
    fn boxed(source: impl TriangleSource + 'static) -> Box<dyn Content> {
        Box::new(Self { source: Box::new(source), survey: None })
    }
}

impl Content for Triangles {
    fn about(&mut self) -> About<'_> {
        let frame = self.source.frame();
        About { name: &mut frame.name, unit: &mut frame.unit, notes: &frame.notes }
    }

    fn z_up(self: Box<Self>, up: UpAxis) -> Box<dyn Content> {
        Self::boxed(ZUpTriangles::new(self.source, up))
    }

    fn filtered(self: Box<Self>, _: &Path, _: PointFilter) -> Box<dyn Content> {
        self
    }

    fn count(&self) -> Option<u64> {
        self.survey.as_ref().map(large::Survey::triangles)
    }

    fn survey(&mut self, _: &VoxelizeOptions, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        self.survey = Some(large::Survey::of(self.source.as_mut(), progress)?);
        Ok(())
    }

    fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        self.survey.as_ref().ok_or(VoxelizeError::Empty)?.estimate(self.source.as_mut(), options)
    }

    fn voxelize_to_file(
        &mut self,
        stamp: &str,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        let survey = self.survey.as_ref().ok_or(VoxelizeError::Empty)?;
        voxelize::voxelize_large_to_file((self.source.as_mut(), stamp), survey, options, limits, path, progress)
    }
}

/// A cloud.
struct Points {
    source: Box<dyn PointSource>,
    survey: Option<large_points::Survey>,
}

impl Points {
    fn boxed(source: impl PointSource + 'static) -> Box<dyn Content> {
        Box::new(Self { source: Box::new(source), survey: None })
    }
}

impl Content for Points {
    fn about(&mut self) -> About<'_> {
        let frame = self.source.frame();
        About { name: &mut frame.name, unit: &mut frame.unit, notes: &frame.notes }
    }

    fn z_up(self: Box<Self>, up: UpAxis) -> Box<dyn Content> {
        Self::boxed(ZUpPoints::new(self.source, up))
    }

    fn filtered(self: Box<Self>, path: &Path, filter: PointFilter) -> Box<dyn Content> {
        Self::boxed(FilteredPoints::new(self.source, path, filter))
    }

    fn is_points(&self) -> bool {
        true
    }

    fn into_points(self: Box<Self>) -> Option<Box<dyn PointSource>> {
        Some(self.source)
    }

    fn count(&self) -> Option<u64> {
        self.survey.as_ref().map(large_points::Survey::points)
    }

    fn survey(&mut self, options: &VoxelizeOptions, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
        self.survey = Some(large_points::Survey::of(self.source.as_mut(), options, progress)?);
        Ok(())
    }

    fn estimate(&mut self, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
        self.survey.as_ref().ok_or(VoxelizeError::NoPoints)?.estimate(self.source.as_mut(), options)
    }

    fn voxelize_to_file(
        &mut self,
        stamp: &str,
        options: &VoxelizeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        let survey = self.survey.as_ref().ok_or(VoxelizeError::NoPoints)?;
        voxelize::voxelize_large_points_to_file((self.source.as_mut(), stamp), survey, options, limits, path, progress)
    }
}
