//! Volumes larger than memory: their samples are read again whenever they are needed, layer by layer.

use super::large::stamp_of;
use std::path::Path;
use voxtrace_voxelize::volume::large::{SampleSource, Survey, voxelize_large_volume_to_file};
use voxtrace_voxelize::volume::{Volume, VolumeError, VolumeOptions};
use voxtrace_voxelize::voxelize::{VoxelizeError, VoxelizeProgress, Written};
use voxtrace_voxelize::{ImportError, Limits};

/// A volume whose samples stay in their file.
pub struct LargeVolume {
    source: Box<dyn SampleSource>,
    survey: Option<Survey>,
    /// Whether the survey was used, and is not to be used for other options.
    is_used: bool,
    lowered: Option<f32>,
    /// Length and time of the file.
    stamp: String,
    memory_budget: u64,
}

impl LargeVolume {
    /// What a reader has opened, to be worked on in so many bytes of memory.
    pub(crate) fn new(source: Box<dyn SampleSource>, path: &Path, memory_budget: u64) -> Result<Self, ImportError> {
        Ok(Self { source, survey: None, is_used: false, lowered: None, stamp: stamp_of(path)?, memory_budget })
    }

    /// The volume without its samples.
    pub fn frame(&self) -> &Volume {
        self.source.frame()
    }

    /// Reads all samples, to know their range and the transfer function that suits; none where one is given that does not go by them.
    ///
    /// # Errors
    /// If they cannot be read, or it was cancelled.
    pub fn survey(&mut self, options: &VolumeOptions, progress: &VoxelizeProgress) -> Result<&Survey, VoxelizeError> {
        let survey = Survey::of(self.source.as_mut(), options, Some(self.memory_budget), progress)?;
        self.is_used = false;
        Ok(self.survey.insert(survey))
    }

    /// What was learned by the survey, and by the work after it.
    pub fn surveyed(&self) -> Option<&Survey> {
        self.survey.as_ref()
    }

    /// Where the last work showed voxels from a threshold of their own on, because no voxel reached that of the samples: it.
    pub fn lowered_threshold(&self) -> Option<f32> {
        self.lowered
    }

    /// Voxelizes into a native file; makes a survey where there was none with the same options. The scene is the one of the same volume in
    /// memory, bit for bit. Interrupted work leaves `PATH.part`, from which the same call goes on.
    ///
    /// # Errors
    /// As [`Self::survey`]; also if nothing is to be seen, there are more voxels than allowed, or the file cannot be written.
    pub fn voxelize_to_file(
        &mut self,
        options: &VolumeOptions,
        limits: &Limits,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        let budget = Some(self.memory_budget);
        let source = self.source.as_mut();
        let survey = match self.survey.take().filter(|_| !self.is_used) {
            Some(survey) => survey,
            None => Survey::of(source, options, budget, progress)?,
        };
        (self.is_used, self.lowered) = (true, None);
        let survey = self.survey.insert(survey);
        let written = |source: &mut dyn SampleSource, survey: &mut Survey| {
            let work = (options, budget);
            voxelize_large_volume_to_file((source, &self.stamp), survey, work, limits, path, progress)
        };
        let result = written(source, survey);
        if matches!(result, Err(VoxelizeError::Volume(VolumeError::Empty { .. }))) {
            // As in memory.
            self.lowered = survey.lower(source, options, budget, progress)?;
        }
        if self.lowered.is_some() { written(source, survey) } else { result }
    }
}
