//! The picture in the making: for each pixel the sum of its samples' radiance and their number. Sums are fixed-point
//! integers, so that adding is associative: any order of samples, passes, tiles and machines gives the same bytes.

pub use crate::crops::JoinError;
use crate::light_group::LightGroup;
use crate::region::Region;
use bytemuck::{Pod, Zeroable};
use glam::{IVec3, Vec3};

/// Bits of the fixed-point sums below one unit of radiance.
const RADIANCE_BITS: u32 = 32;
/// Units of the fixed-point sums in one unit of radiance: 2³².
pub const RADIANCE_ONE: f64 = (1u64 << RADIANCE_BITS) as f64;
/// A sample's radiance is clamped to this in each channel, so that 2¹² samples of it fit a sum and the conversion
/// is exact on a GPU with 32-bit integers.
pub const MAX_SAMPLE_RADIANCE: f32 = 1_048_576.0;

/// Radiance sums, sample counts and AOVs of a region of a picture. Pixels are stored row by row, top to bottom.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// The part of it that this film holds.
    pub region: Region,
    /// Number of the first sample; pixel `p` holds the samples `first_sample .. first_sample + pixels[p].samples`.
    pub first_sample: u32,
    /// One entry for each pixel of the region.
    pub pixels: Vec<Pixel>,
    /// Arbitrary output variables: one entry for each pixel of the region, where asked for.
    pub aovs: Option<Vec<AovPixel>>,
    /// The pixels as they stood after the first part of their samples, where somebody kept them: the difference tells how noisy
    /// they are. Tracers neither need nor make them.
    pub earlier: Option<Vec<Pixel>>,
    /// The pixels of films that gathered the light of one group alone ([`crate::Frame::light_group`]), where somebody made them: of the same
    /// samples they add up to `pixels`, but for rounding. Tracers neither need nor make them.
    pub groups: Vec<(LightGroup, Vec<Pixel>)>,
}

/// The samples of one pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Pixel {
    /// Sum of the samples' linear radiance in units of 2⁻³², red, green, blue.
    pub radiance: [u64; 3],
    /// Number of samples.
    pub samples: u32,
    /// Number of samples whose camera ray met a voxel: `covered / samples` is the pixel's alpha.
    pub covered: u32,
}

/// What the ray through the middle of a pixel meets; noise-free. A miss has albedo, normal and depth 0. Albedo and normal are those of what is
/// seen in a mirror or behind clear glass, the rest is that of the mirror or the glass.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct AovPixel {
    /// Share of light that the surface scatters, times what mirrors and media leave of it, linear, in [0, 1].
    pub albedo: Vec3,
    /// Unit normal in world space.
    pub normal: Vec3,
    /// Distance from the camera along the ray, world units (voxels).
    pub depth: f32,
    /// Index of the instance, [`voxtrace_scene::Hit::NONE`] for a miss.
    pub instance: u32,
    /// The voxel in the instance's grid.
    pub voxel: IVec3,
}

impl AovPixel {
    /// What a ray that meets nothing leaves.
    pub const MISS: Self = Self {
        albedo: Vec3::ZERO,
        normal: Vec3::ZERO,
        depth: 0.0,
        instance: voxtrace_scene::Hit::NONE,
        voxel: IVec3::ZERO,
    };
}

impl Pixel {
    /// Adds one sample. What is not a number counts as black; each channel is clamped to
    /// 0..=[`MAX_SAMPLE_RADIANCE`].
    #[expect(clippy::manual_clamp, reason = "clamp would keep NaN")]
    pub fn add(&mut self, radiance: Vec3, covered: bool) {
        for (sum, value) in self.radiance.iter_mut().zip(radiance.to_array()) {
            // NaN.max(0.0) is 0.0. The product is exact: scaling by a power of two.
            let value = value.max(0.0).min(MAX_SAMPLE_RADIANCE);
            // Below 2⁵³: as a signed integer it needs no second way for numbers from 2⁶³ on.
            *sum = sum.saturating_add((f64::from(value) * RADIANCE_ONE) as i64 as u64);
        }
        self.samples += 1;
        self.covered += u32::from(covered);
    }

    /// Adds the samples of another pixel.
    #[doc(hidden)]
    pub fn merge(&mut self, other: &Self) {
        for (sum, addend) in self.radiance.iter_mut().zip(other.radiance) {
            *sum = sum.saturating_add(addend);
        }
        self.samples += other.samples;
        self.covered += other.covered;
    }

    /// Mean linear radiance of the samples; black where there are none.
    pub fn mean(&self) -> Vec3 {
        let scale = 1.0 / (RADIANCE_ONE * f64::from(self.samples.max(1)));
        Vec3::from_array(self.radiance.map(|sum| (sum as f64 * scale) as f32))
    }

    /// Share of the samples whose camera ray met a voxel, in [0, 1].
    pub fn alpha(&self) -> f32 {
        self.covered as f32 / self.samples.max(1) as f32
    }
}

/// Two films cannot be added up.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum MergeError {
    /// Sizes or regions differ.
    #[error("the films show different regions: {0:?} and {1:?}")]
    Region(Region, Region),
    /// A film was interrupted: its pixels hold different numbers of samples.
    #[error("a film is incomplete: its pixels hold {0} to {1} samples; resume it first")]
    Incomplete(u32, u32),
    /// Sample ranges that do not join: they overlap or leave a gap.
    #[error("sample ranges {0}..{1} and {2}..{3} overlap or leave a gap")]
    Samples(u32, u32, u32, u32),
    /// Only one of the films has light groups, or they differ.
    #[error("the films have different light groups")]
    Groups,
    /// A film was interrupted while the light of a group was gathered: the group has fewer samples than the picture.
    #[error("a film is incomplete: not all samples have the light of {}; resume it first", .0.name())]
    IncompleteGroup(LightGroup),
}

impl Film {
    /// A black film without samples.
    pub fn new(width: u32, height: u32, region: Region, first_sample: u32) -> Self {
        Self {
            width,
            height,
            region,
            first_sample,
            pixels: vec![Pixel::default(); region.pixels()],
            aovs: None,
            earlier: None,
            groups: Vec::new(),
        }
    }

    /// The smallest and the largest number of samples of a pixel; equal when the film is complete.
    pub fn sample_range(&self) -> (u32, u32) {
        let counts = || self.pixels.iter().map(|pixel| pixel.samples);
        (counts().min().unwrap_or(0), counts().max().unwrap_or(0))
    }

    /// The first light group that has not the samples of the picture, as where its light was still gathered when a render was interrupted.
    #[doc(hidden)]
    pub fn unfinished_group(&self) -> Option<LightGroup> {
        let differs =
            |pixels: &[Pixel]| pixels.iter().zip(&self.pixels).any(|(own, pixel)| own.samples != pixel.samples);
        self.groups.iter().find(|(_, pixels)| differs(pixels)).map(|(group, _)| *group)
    }

    /// Adds the samples of `other`, which must show the same region and hold the samples just before or just after
    /// ours. The result is the film of all samples, bit for bit.
    ///
    /// # Errors
    /// [`MergeError`] when the films do not fit together; `self` is then unchanged.
    pub fn merge(&mut self, other: &Self) -> Result<(), MergeError> {
        let shown = |film: &Self| (film.width, film.height, film.region, film.pixels.len());
        if shown(self) != shown(other) {
            return Err(MergeError::Region(self.region, other.region));
        }
        for film in [&*self, other] {
            let (least, most) = film.sample_range();
            if least != most {
                return Err(MergeError::Incomplete(least, most));
            }
        }
        // A film that was made by hand, or is damaged, may count beyond all numbers of samples: nothing joins it.
        let range = |film: &Self| (film.first_sample, film.first_sample.checked_add(film.sample_range().1));
        let ((a0, a1), (b0, b1)) = (range(self), range(other));
        if a1.is_none() || b1.is_none() || (a1 != Some(b0) && b1 != Some(a0)) {
            let [a1, b1] = [a1, b1].map(|end| end.unwrap_or(u32::MAX));
            return Err(MergeError::Samples(a0, a1, b0, b1));
        }
        if let Some(group) = self.unfinished_group().or(other.unfinished_group()) {
            return Err(MergeError::IncompleteGroup(group));
        }
        let has_same_groups =
            self.groups.len() == other.groups.len()
                && self.groups.iter().zip(&other.groups).all(|((ours, a), (theirs, b))| {
                    ours == theirs && a.len() == self.pixels.len() && b.len() == a.len()
                });
        if !has_same_groups {
            return Err(MergeError::Groups);
        }
        let groups = self.groups.iter_mut().zip(&other.groups).map(|(ours, theirs)| (&mut ours.1, &theirs.1));
        for (ours, theirs) in [(&mut self.pixels, &other.pixels)].into_iter().chain(groups) {
            ours.iter_mut().zip(theirs).for_each(|(ours, theirs)| ours.merge(theirs));
        }
        self.first_sample = a0.min(b0);
        if self.aovs.is_none() {
            self.aovs.clone_from(&other.aovs);
        }
        self.earlier = None;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A film of two pixels with so many samples each.
    fn film(first_sample: u32, samples: u32) -> Film {
        let mut film = Film::new(2, 1, Region::full(2, 1), first_sample);
        film.pixels.iter_mut().for_each(|pixel| pixel.samples = samples);
        film
    }

    #[test]
    fn films_that_count_beyond_all_samples_or_lack_pixels_are_not_merged() {
        let mut merged = film(4, u32::MAX - 4);
        merged.merge(&film(0, 4)).unwrap();
        assert_eq!(merged, film(0, u32::MAX));
        // One more would be sample 0 again, where the other begins.
        for (one, other) in [(film(4, u32::MAX - 3), film(0, 4)), (film(0, 4), film(4, u32::MAX - 3))] {
            let mut merged = one.clone();
            assert!(matches!(merged.merge(&other), Err(MergeError::Samples(..))));
            assert_eq!(merged, one);
        }
        // Sums of a group that lack samples would count for others when the film is continued.
        let with_sun = |film: Film, samples: u32| {
            let sun = film.pixels.iter().map(|pixel| Pixel { samples, ..*pixel }).collect();
            Film { groups: vec![(LightGroup::Sun, sun)], ..film }
        };
        assert_eq!(with_sun(film(0, 4), 4).merge(&with_sun(film(4, 4), 4)), Ok(()));
        for samples in [[2, 2], [4, 2], [2, 4]] {
            let (mut one, other) = (with_sun(film(0, 4), samples[0]), with_sun(film(4, 4), samples[1]));
            assert_eq!(one.merge(&other), Err(MergeError::IncompleteGroup(LightGroup::Sun)));
            assert_eq!(one, with_sun(film(0, 4), samples[0]));
        }
        let short = Film { pixels: film(4, 1).pixels[..1].to_vec(), ..film(4, 1) };
        assert!(matches!(film(0, 4).merge(&short), Err(MergeError::Region(..))));
    }
}
