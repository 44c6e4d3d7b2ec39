//! Samples with colours of their own, as those of a picture or of several channels: a voxel has the mean of those that it covers, in linear
//! light.

use super::Volume;
use super::resample::{Axis, Taps};
use super::transfer::LabelColor;
use glam::Vec3;
use rayon::prelude::*;
use voxtrace_scene::material::{linear_color, srgb_from_linear};

/// Most colours that are kept as they are: the materials of a scene, and some room for what lies over them.
const MOST_COLORS: usize = 60_000;
/// Samples looked at by one task.
const TASK: usize = 1 << 20;

/// The colours of a volume on a grid.
pub(super) struct OwnColors<'a> {
    colors: &'a [[u8; 3]],
    /// Bits of each channel that are kept.
    kept: [u8; 3],
    /// Linear light of each byte.
    linear: [f32; 256],
}

impl<'a> OwnColors<'a> {
    /// Those of a volume; `None` where it has none.
    pub fn of(volume: &'a Volume, axes: &[Axis; 3]) -> Option<Self> {
        let colors = &volume.colors;
        if colors.is_empty() {
            return None;
        }
        let is_resampled = axes.iter().any(|axis| axis.taps.iter().any(|taps| taps.weights.len() > 1));
        let kept = if is_resampled || are_many(colors) { [0xf8; 3] } else { [0xff; 3] };
        let linear = std::array::from_fn(|byte| linear_color([byte as u8; 3]).x);
        Some(Self { colors, kept, linear })
    }

    /// The colour of a voxel as one number.
    pub fn key(&self, axes: &[Axis; 3], [x, y, z]: [&Taps; 3]) -> u32 {
        let start = x.start + y.start + z.start;
        let color = if x.weights.len() + y.weights.len() + z.weights.len() == 3 {
            self.colors[start]
        } else {
            let mut sum = Vec3::ZERO;
            for (k, weight_z) in z.weights.iter().enumerate() {
                for (j, weight_y) in y.weights.iter().enumerate() {
                    let row = start + k * axes[2].stride + j * axes[1].stride;
                    for (i, weight_x) in x.weights.iter().enumerate() {
                        let color = self.colors[row + i * axes[0].stride];
                        let light = Vec3::from_array(color.map(|byte| self.linear[usize::from(byte)]));
                        sum += weight_x * weight_y * weight_z * light;
                    }
                }
            }
            sum.to_array().map(srgb_from_linear)
        };
        let [red, green, blue] = std::array::from_fn(|channel| color[channel] & self.kept[channel]);
        u32::from_be_bytes([0, red, green, blue])
    }

    /// The look of a key.
    pub fn look(&self, key: u32, opacity: f32) -> LabelColor {
        let [_, color @ ..] = key.to_be_bytes();
        // In the middle of what was cut off.
        let [red, green, blue] =
            std::array::from_fn(|channel| color[channel] | !self.kept[channel] & (color[channel] >> 5));
        LabelColor { color: linear_color([red, green, blue]), opacity }
    }
}

/// Whether there are more colours than a scene can have.
fn are_many(colors: &[[u8; 3]]) -> bool {
    let empty = || vec![0u64; 1 << 18];
    let seen = colors.par_chunks(TASK).fold(empty, |mut seen, colors| {
        for &[red, green, blue] in colors {
            let key = u32::from_be_bytes([0, red, green, blue]) as usize;
            seen[key / 64] |= 1 << (key % 64);
        }
        seen
    });
    let both = |mut a: Vec<u64>, b: Vec<u64>| {
        a.iter_mut().zip(b).for_each(|(a, b)| *a |= b);
        a
    };
    let seen = seen.reduce(empty, both);
    seen.iter().map(|word| word.count_ones() as usize).sum::<usize>() > MOST_COLORS
}

#[cfg(test)]
mod tests {
    use super::super::{Preset, VolumeOptions, voxelize};
    use super::*;
    use crate::limits::Limits;
    use crate::voxelize::Scale;

    /// A box of 8 x 4 x 2 samples, half of them dark, of as many colours as they are.
    fn colored() -> Volume {
        let count = 64usize;
        let values = (0..count).map(|n| if n % 2 == 0 { 200.0 } else { 10.0 }).collect();
        let colors = (0..count).map(|n| [n as u8 * 3 + 1, 255 - n as u8, 77]).collect();
        Volume { colors, ..Volume::new([8, 4, 2], values) }
    }

    fn found(volume: &Volume, scale: Option<Scale>) -> Vec<[u8; 3]> {
        let transfer = Some(Preset::Surface.transfer());
        let options =
            VolumeOptions { transfer, threshold: Some(100.0), shell: false, scale, ..VolumeOptions::default() };
        let scene = voxelize(volume, &options, &Limits::default()).unwrap();
        let color = |material: u16| scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
        scene.grids[0].voxels().map(|(_, material)| color(material)).collect()
    }

    #[test]
    fn voxels_have_the_colours_of_their_samples_where_these_are_seen() {
        let volume = colored();
        let mut wanted: Vec<[u8; 3]> = volume.colors.iter().step_by(2).copied().collect();
        let mut colors = found(&volume, None);
        colors.sort_unstable();
        wanted.sort_unstable();
        assert_eq!(colors, wanted);
        wanted[3][0] ^= 1;
        assert_ne!(colors, wanted);
    }

    #[test]
    fn what_is_resampled_is_mixed_in_linear_light_to_thirty_seconds() {
        let values = vec![200.0; 8];
        let colors = (0..8).map(|n| if n % 2 == 0 { [255; 3] } else { [0; 3] }).collect();
        let volume = Volume { colors, ..Volume::new([2; 3], values) };
        // Half the light is 188.
        for color in found(&volume, Some(Scale::Resolution(1))) {
            assert!(color.iter().all(|channel| channel.abs_diff(188) <= 4), "{color:?}");
        }
    }

    #[test]
    fn more_colours_than_materials_are_cut_to_fewer() {
        let count = 48 * 48 * 48;
        let colors = (0..count).map(|n: usize| [n % 48, n / 48 % 48, n / 48 / 48].map(|n| n as u8 * 5)).collect();
        let volume = Volume { colors, ..Volume::new([48; 3], vec![200.0; count]) };
        let colors = found(&volume, None);
        assert_eq!(colors.len(), count);
        let far = volume.colors.iter().zip(&colors).count();
        assert!(far == count && colors.iter().flatten().max() > Some(&230));
    }

    #[test]
    fn as_many_colours_as_samples_or_it_is_no_volume() {
        let mut volume = colored();
        volume.colors.pop();
        assert!(volume.validate().is_err());
    }
}
