//! The transfer function that suits a volume, chosen by its values.

use super::{Preset, Transfer, ValueStatistics};

/// Up to so many distinct values are taken for labels where the file does not say what they are.
const FEW_LABELS: usize = 48;

impl Transfer {
    /// Chooses a transfer function: for level sets and fog the file's own kind; for few whole numbers a colour for each label; for
    /// a CT, known by its file or by values from air to bone, the bones; else a warm grey from Otsu's threshold on.
    pub fn automatic(values: &ValueStatistics) -> Self {
        let is_named = values.labels.as_ref().is_some_and(|labels| {
            values.is_labels || labels.len() <= FEW_LABELS && labels.first().is_some_and(|&first| first >= 0)
        });
        let preset = if let Some(preset @ (Preset::Surface | Preset::Fog)) = values.suited {
            preset
        } else if is_named {
            Preset::Labels
        } else if let Some(preset) = values.suited.filter(|&preset| preset != Preset::CtBone || values.highest > 300.0)
        {
            preset
        } else if (-5000.0..=-800.0).contains(&values.lowest) && (300.0..=33_000.0).contains(&values.highest) {
            Preset::CtBone
        } else {
            Preset::Mri
        };
        preset.transfer()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::limits::Limits;
    use crate::volume::{Volume, VolumeError, VolumeOptions, voxelize};
    use crate::voxelize::Scale;

    fn values(samples: Vec<f32>) -> ValueStatistics {
        ValueStatistics::of(&Volume::new([samples.len(), 1, 1], samples))
    }

    #[test]
    fn the_choice_follows_the_values() {
        let name = |samples: Vec<f32>| Transfer::automatic(&values(samples)).name;
        assert_eq!(name((0..5000).map(|i| i as f32 - 1024.0).collect()), "ct-bone");
        assert_eq!(name((0..5000).map(|i| i as f32 - 600.0).collect()), "mri");
        assert_eq!(name((0..5000).map(|i| (i % 7) as f32).collect()), "labels");
        assert_eq!(name((0..5000).map(|i| (i % 200) as f32).collect()), "mri");
        assert_eq!(name((0..5000).map(|i| (i % 7) as f32 + 0.5).collect()), "mri");
    }

    #[test]
    fn voxels_coarser_than_what_is_to_be_seen_show_something_where_nobody_chose_what() {
        // One bright sample among sixty-four.
        let volume = Volume::new([4; 3], (0..64).map(|n| if n == 21 { 243.0 } else { 65.25 }).collect());
        let options = VolumeOptions { scale: Some(Scale::Resolution(1)), ..VolumeOptions::default() };
        assert_eq!(voxelize(&volume, &options, &Limits::default()).unwrap().grids[0].count(), 1);
        // Whoever chose is told.
        let chosen = VolumeOptions { transfer: Some(Preset::Mri.transfer()), ..options };
        let error = voxelize(&volume, &chosen, &Limits::default()).unwrap_err();
        assert!(matches!(error, VolumeError::Empty { .. }), "{error}");
    }
}
