//! The colour of a point: its own, or one that a colour map gives to an attribute.

use super::{PointCloud, TASK};
use rayon::prelude::*;
use std::ops::Range;
use voxtrace_scene::material::linear_from_srgb;

/// The attribute that colours points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColorBy {
    /// The points' own colours, or where there are none their heights.
    #[default]
    Auto,
    /// Their own colours.
    Rgb,
    /// The return intensity, through a colour map from dark violet to yellow.
    Intensity,
    /// The ASPRS class: ground brown, vegetation green, buildings red, water blue.
    Classification,
    /// The height (z), through the same colour map.
    Height,
}

/// Fraction bits of linear light in fixed point: sums of whole numbers do not depend on their order.
const FIXED_BITS: u32 = 24;

/// Colour map for scalars with evenly growing lightness, as viridis: sRGB, interpolated linearly.
const RAMP: [[u8; 3]; 6] =
    [[56, 14, 94], [52, 76, 140], [30, 128, 142], [58, 176, 108], [168, 212, 60], [252, 234, 64]];

/// Colours of the ASPRS classes 0 to 18 (LAS 1.4 R15, table 17), sRGB.
const CLASSES: [[u8; 3]; 19] = [
    [150, 150, 150], // never classified
    [170, 170, 170], // unclassified
    [150, 110, 70],  // ground
    [150, 200, 100], // low vegetation
    [90, 165, 70],   // medium vegetation
    [40, 115, 50],   // high vegetation
    [200, 80, 60],   // building
    [230, 0, 230],   // low noise
    [240, 220, 80],  // key point
    [50, 110, 200],  // water
    [90, 70, 100],   // rail
    [80, 80, 85],    // road
    [180, 180, 200], // overlap
    [250, 190, 60],  // wire guard
    [250, 150, 30],  // wire
    [120, 130, 170], // transmission tower
    [240, 120, 120], // wire connector
    [190, 150, 130], // bridge deck
    [255, 80, 255],  // high noise
];
/// Colour of reserved and user-defined classes.
const OTHER_CLASS: [u8; 3] = [200, 160, 220];

impl ColorBy {
    /// Resolves [`ColorBy::Auto`] and checks that the points have the attribute.
    ///
    /// # Errors
    /// The name of the attribute that the points do not have.
    pub fn resolved(self, has: Attributes) -> Result<Self, &'static str> {
        match self {
            Self::Auto if !has.colors => Ok(Self::Height),
            Self::Auto => Ok(Self::Rgb),
            Self::Rgb if !has.colors => Err("colours"),
            Self::Intensity if !has.intensities => Err("intensities"),
            Self::Classification if !has.classes => Err("classification"),
            by => Ok(by),
        }
    }

    /// The attribute of a point, in 32 bits. `self` must be [`Self::resolved`] for the cloud.
    #[inline]
    pub fn value(self, cloud: &PointCloud, point: usize) -> u32 {
        match self {
            Self::Height => cloud.positions[point].z.to_bits(),
            Self::Intensity => cloud.intensities[point].into(),
            Self::Classification => cloud.classes[point].into(),
            Self::Rgb | Self::Auto => {
                let [r, g, b] = cloud.colors[point];
                u32::from_be_bytes([0, r, g, b])
            }
        }
    }
}

/// Which attributes points have besides their positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Attributes {
    /// Each has a colour.
    pub colors: bool,
    /// Each has a return intensity.
    pub intensities: bool,
    /// Each has an ASPRS class.
    pub classes: bool,
}

impl Attributes {
    /// The attributes of a cloud in memory.
    pub fn of(cloud: &PointCloud) -> Self {
        Self {
            colors: !cloud.colors.is_empty(),
            intensities: !cloud.intensities.is_empty(),
            classes: !cloud.classes.is_empty(),
        }
    }
}

/// Maps attributes of points to colours.
pub struct ColorMap {
    by: ColorBy,
    low: f32,
    scale: f32,
    ramp: Vec<[u8; 3]>,
    fixed: [u32; 256],
}

impl ColorMap {
    /// The map for a cloud; heights and intensities are scaled to the range that nearly all of them lie in.
    ///
    /// # Errors
    /// The name of the attribute that the points do not have.
    pub fn of(cloud: &PointCloud, by: ColorBy) -> Result<Self, &'static str> {
        let by = by.resolved(Attributes::of(cloud))?;
        Ok(Self::new(
            by,
            match by {
                ColorBy::Height => ValueHistogram::percentile_range_of(cloud.positions.len(), |run| {
                    cloud.positions[run].iter().map(|position| position.z)
                }),
                ColorBy::Intensity => {
                    let values = |run: Range<usize>| cloud.intensities[run].iter().map(|&value| f32::from(value));
                    ValueHistogram::percentile_range_of(cloud.intensities.len(), values)
                }
                _ => (0.0, 1.0),
            },
        ))
    }

    /// The map for a resolved attribute; heights and intensities are scaled to `low..high`.
    pub fn new(by: ColorBy, (low, high): (f32, f32)) -> Self {
        let fixed =
            |byte: usize| (f64::from(linear_from_srgb(byte as u8)) * f64::from(1u32 << FIXED_BITS)).round() as u32;
        Self {
            by,
            low,
            scale: if high > low { 1.0 / (high - low) } else { 0.0 },
            ramp: (0..256).map(|at| ramp(at as f32 / 255.0)).collect(),
            fixed: std::array::from_fn(fixed),
        }
    }

    /// The attribute that gives the colours.
    pub fn by(&self) -> ColorBy {
        self.by
    }

    /// The linear colour of a [`ColorBy::value`], in fixed point: multiples of 2⁻²⁴.
    pub fn fixed(&self, value: u32) -> [u32; 3] {
        let of_ramp = |value: f32| {
            let share = ((value - self.low) * self.scale).clamp(0.0, 1.0);
            self.ramp[(share * 255.0).round() as usize]
        };
        let srgb = match self.by {
            ColorBy::Height => of_ramp(f32::from_bits(value)),
            ColorBy::Intensity => of_ramp(value as f32),
            ColorBy::Classification => CLASSES.get(value as usize).copied().unwrap_or(OTHER_CLASS),
            ColorBy::Rgb | ColorBy::Auto => {
                let [_, r, g, b] = value.to_be_bytes();
                [r, g, b]
            }
        };
        srgb.map(|byte| self.fixed[usize::from(byte)])
    }

    /// The linear mean colour of `count` points, from the sums of their [`Self::fixed`].
    pub fn mean(sums: [u64; 3], count: u64) -> glam::Vec3 {
        let unit = f64::from(1u32 << FIXED_BITS) * count as f64;
        glam::Vec3::from_array(sums.map(|sum| (sum as f64 / unit) as f32))
    }
}

fn ramp(share: f32) -> [u8; 3] {
    let along = share * (RAMP.len() - 1) as f32;
    let at = (along as usize).min(RAMP.len() - 2);
    let part = along - at as f32;
    std::array::from_fn(|channel| {
        let (from, to) = (f32::from(RAMP[at][channel]), f32::from(RAMP[at + 1][channel]));
        (from + (to - from) * part).round() as u8
    })
}

/// Histogram of scalar values between two bounds.
#[derive(Clone, Debug)]
pub struct ValueHistogram {
    low: f32,
    high: f32,
    counts: Vec<u64>,
    all: u64,
}

impl ValueHistogram {
    const BINS: usize = 4096;

    /// An empty histogram between two bounds.
    pub fn between(low: f32, high: f32) -> Self {
        Self { low, high, counts: vec![0; Self::BINS], all: 0 }
    }

    /// Adds a value that occurs `times` times.
    #[inline]
    pub fn add(&mut self, value: f32, times: u64) {
        let width = (self.high - self.low) / Self::BINS as f32;
        self.counts[(((value - self.low) / width) as usize).min(Self::BINS - 1)] += times;
        self.all += times;
    }

    /// The range from the first to the 99th percentile, so that outliers do not use up the colours.
    pub fn percentile_range(&self) -> (f32, f32) {
        if self.low.is_nan() || self.low >= self.high {
            return (self.low, self.high);
        }
        let skip = self.all / 100;
        let reach = |counts: &mut dyn Iterator<Item = &u64>| {
            let mut sum = 0;
            counts
                .take_while(|&&count| {
                    sum += count;
                    sum <= skip
                })
                .count()
        };
        let (below, above) = (reach(&mut self.counts.iter()), reach(&mut self.counts.iter().rev()));
        let width = (self.high - self.low) / Self::BINS as f32;
        (self.low + below as f32 * width, self.high - above as f32 * width)
    }

    /// The percentile range of `count` values, which `values` returns for a range of indices.
    fn percentile_range_of<I: Iterator<Item = f32>>(
        count: usize,
        values: impl Fn(Range<usize>) -> I + Sync,
    ) -> (f32, f32) {
        let runs = || (0..count.div_ceil(TASK)).into_par_iter().map(|run| run * TASK..((run + 1) * TASK).min(count));
        let none = || (f32::INFINITY, f32::NEG_INFINITY);
        let join = |a: (f32, f32), b: (f32, f32)| (a.0.min(b.0), a.1.max(b.1));
        let bounds = |run| values(run).fold(none(), |bounds, value| join(bounds, (value, value)));
        let (low, high) = runs().map(bounds).reduce(none, join);
        let histogram = || Self::between(low, high);
        let add = |mut histogram: Self, run| {
            values(run).for_each(|value| histogram.add(value, 1));
            histogram
        };
        runs().fold(histogram, add).reduce(histogram, Self::joined).percentile_range()
    }

    /// The bounds.
    pub(crate) fn ends(&self) -> (f32, f32) {
        (self.low, self.high)
    }

    /// The counts of its bins, from the lowest on.
    pub(crate) fn counts(&self) -> &[u64] {
        &self.counts
    }

    /// A histogram with counts. `None` where there are not as many as bins.
    pub(crate) fn of_counts(low: f32, high: f32, counts: Vec<u64>) -> Option<Self> {
        let all = counts.iter().sum();
        (counts.len() == Self::BINS).then_some(Self { low, high, counts, all })
    }

    /// With the values of another histogram between the same bounds.
    pub(crate) fn joined(mut self, other: Self) -> Self {
        self.counts.iter_mut().zip(other.counts).for_each(|(own, other)| *own += other);
        self.all += other.all;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn the_ramp_grows_brighter_all_the_way() {
        let brightness = |at: usize| {
            let [r, g, b] = ramp(at as f32 / 255.0).map(linear_from_srgb);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert_eq!((ramp(0.0), ramp(1.0)), (RAMP[0], RAMP[5]));
        assert!((0..255).all(|at| brightness(at) <= brightness(at + 1) + 2e-3));
    }

    #[test]
    fn strays_do_not_take_the_colours() {
        let mut positions: Vec<Vec3> = (0..1000).map(|z| Vec3::new(0.0, 0.0, z as f32 / 100.0)).collect();
        positions.push(Vec3::new(0.0, 0.0, 500.0));
        let span =
            |count| ValueHistogram::percentile_range_of(count, |run| positions[run].iter().map(|position| position.z));
        let low = span(1000);
        assert!((low.0 - 0.1).abs() < 0.02 && (low.1 - 9.89).abs() < 0.02, "{low:?}");
        assert!(span(1001).1 < 10.2);
    }

    #[test]
    fn what_points_do_not_have_cannot_colour_them() {
        let cloud = PointCloud { positions: vec![Vec3::ZERO], ..PointCloud::default() };
        for by in [ColorBy::Rgb, ColorBy::Intensity, ColorBy::Classification] {
            assert!(ColorMap::of(&cloud, by).is_err(), "{by:?}");
        }
        assert!(ColorMap::of(&cloud, ColorBy::Auto).is_ok());
    }
}
