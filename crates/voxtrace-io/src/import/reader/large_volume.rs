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
    lowered: Option<f32>,
    /// Length and time of the file.
    stamp: String,
    memory_budget: u64,
}

impl LargeVolume {
    /// What a reader has opened, to be worked on in so many bytes of memory.
    pub(crate) fn new(source: Box<dyn SampleSource>, path: &Path, memory_budget: u64) -> Result<Self, ImportError> {
        Ok(Self { source, survey: None, lowered: None, stamp: stamp_of(path)?, memory_budget })
    }

    /// The volume without its samples.
    pub fn frame(&self) -> &Volume {
        self.source.frame()
    }

    /// Reads all samples, to know their range and the transfer function that suits.
    ///
    /// # Errors
    /// If they cannot be read, or it was cancelled.
    pub fn survey(&mut self, options: &VolumeOptions, progress: &VoxelizeProgress) -> Result<&Survey, VoxelizeError> {
        let survey = Survey::of(self.source.as_mut(), options, Some(self.memory_budget), progress)?;
        Ok(self.survey.insert(survey))
    }

    /// What was learned by the survey, if there was one since the last work.
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
        let mut survey = match self.survey.take() {
            Some(survey) => survey,
            None => Survey::of(source, options, budget, progress)?,
        };
        self.lowered = None;
        let written = |source: &mut dyn SampleSource, survey: &Survey| {
            voxelize_large_volume_to_file((source, &self.stamp), survey, (options, budget), limits, path, progress)
        };
        let is_chosen = options.transfer.is_some() || options.threshold.is_some();
        match written(source, &survey) {
            // As in memory.
            Err(VoxelizeError::Volume(VolumeError::Empty { .. })) if !is_chosen => {
                self.lowered = Some(survey.lower(source, options, budget, progress)?);
                written(source, &survey)
            }
            result => result,
        }
    }
}
