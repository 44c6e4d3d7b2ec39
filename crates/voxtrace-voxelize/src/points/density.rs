//! Chooses the resolution of a cloud of points: the finest grid on which scanned surfaces stay closed. By the Good–Turing estimate
//! the share of singletons, points alone in their cell, is the chance that one more point would fall into an empty cell, that is
//! into a hole (Good, "The population frequencies of species and the estimation of population parameters", 1953). Dense regions
//! weigh as much as they have points.

use super::{PointCloud, bounds};
use crate::fields::{FieldReader, FieldWriter};
use glam::{DVec3, UVec3, Vec3};
use rayon::prelude::*;

/// Most cells along the longest side.
pub const FINEST: u32 = 2048;
/// Least cells along the longest side.
pub const COARSEST: u32 = 16;
/// Share of singletons accepted. For points scattered at random, the same share of a surface's voxels is missing.
const MAX_SINGLETONS: f64 = 0.03;
/// Bits of a coordinate on the finest grid. Points in one of its cells count as one point measured repeatedly.
const BITS: u32 = 16;
/// Size aimed at of the sample, which is made of all points in randomly chosen cells of a coarse grid.
const SAMPLE: u64 = 1 << 20;
/// Bits of a coordinate of the coarse grid.
const COARSE_BITS: u32 = 6;
/// Bits of a Morton code below its coarse cell.
const COARSE_SHIFT: u32 = 3 * (BITS - COARSE_BITS);
/// Most Morton codes kept, where points cluster in few coarse cells.
const MAX_CODES: usize = 1 << 22;

/// The finest resolution, in cells along the longest side, on which surfaces through the points stay closed: [`COARSEST`] to
/// [`FINEST`].
pub fn suited_resolution(cloud: &PointCloud) -> u32 {
    let Some((min, max)) = bounds(&cloud.positions) else { return FINEST };
    let mut density = Density::over(min.as_vec3(), max.as_vec3(), cloud.positions.len() as u64);
    cloud.positions.chunks(SAMPLE as usize).for_each(|points| density.add(points));
    density.resolution()
}

/// A sample of points to measure their density, filled in any number of steps.
#[derive(Clone, Debug)]
pub struct Density {
    bounds: (Vec3, Vec3),
    count: u64,
    /// `None` where all points coincide.
    lattice: Option<Lattice>,
    /// Morton codes of the distinct finest cells with points. Once they are sorted, the codes in a cell of a coarser grid are
    /// consecutive.
    codes: Vec<u64>,
    /// Codes left when they were last sorted.
    sorted: usize,
}

impl Density {
    /// An empty sample for `count` points between two corners.
    pub fn over(low: Vec3, high: Vec3, count: u64) -> Self {
        let lattice = Lattice::over((low.as_dvec3(), high.as_dvec3()), count);
        Self { bounds: (low, high), count, lattice, codes: Vec::new(), sorted: 0 }
    }

    /// Whether the sample was created for these bounds and this many points.
    pub fn is_over(&self, low: Vec3, high: Vec3, count: u64) -> bool {
        self.bounds == (low, high) && self.count == count
    }

    /// Samples points, which must lie within the bounds.
    pub fn add(&mut self, points: &[Vec3]) {
        let Some(lattice) = &self.lattice else { return };
        self.codes.par_extend(points.par_iter().filter_map(|&point| lattice.code(point)));
        if self.codes.len() > self.sorted + MAX_CODES {
            self.sort();
        }
    }

    /// Adds the points of another sample that was created for the same bounds and number of points. What comes of several does not
    /// depend on their order.
    pub fn join(&mut self, mut other: Self) {
        let (Some(own), Some(theirs)) = (&mut self.lattice, &mut other.lattice) else { return };
        while own.most > theirs.most {
            own.halve_sample();
        }
        self.codes.extend(other.codes);
        self.codes.retain(|&code| own.is_chosen(code));
        self.sort();
    }

    /// Adds the sample to what is written.
    pub(crate) fn write(&mut self, out: &mut FieldWriter) {
        self.sort();
        out.value(self.bounds.0);
        out.value(self.bounds.1);
        out.value(self.count);
        out.value(self.lattice.as_ref().map_or(0, |lattice| lattice.most));
        out.values(&self.codes);
    }

    /// The sample that was written.
    pub(crate) fn read(from: &mut FieldReader) -> Option<Self> {
        let (low, high, count, most) = (from.value()?, from.value()?, from.value()?, from.value::<u64>()?);
        let mut own = Self::over(low, high, count);
        while let Some(lattice) = own.lattice.as_mut().filter(|lattice| lattice.most > most) {
            lattice.halve_sample();
        }
        own.codes = from.values()?;
        own.sorted = own.codes.len();
        Some(own)
    }

    /// Sorts the codes. Where there are too many, half of the coarse cells are dropped; which ones depends on their hashes alone,
    /// so that the order of the points does not matter.
    fn sort(&mut self) {
        let Some(lattice) = &mut self.lattice else { return };
        self.codes.par_sort_unstable();
        self.codes.dedup();
        while self.codes.len() > MAX_CODES {
            lattice.halve_sample();
            self.codes.retain(|&code| lattice.is_chosen(code));
        }
        self.sorted = self.codes.len();
    }

    /// The finest resolution on which surfaces through the points stay closed, as `suited_resolution` returns it.
    pub fn resolution(mut self) -> u32 {
        self.sort();
        let codes = &self.codes;
        let share = |level: u32| singleton_share(codes, 3 * (BITS - level));
        let (mut level, mut before) = (COARSEST.ilog2(), 0.0);
        while level < BITS {
            let found = share(level);
            if found > MAX_SINGLETONS {
                // Interpolates the logarithm of the share between the two levels; a share of 0 counts as half a point.
                let least = 0.5 / codes.len() as f64;
                let (low, high) = (f64::ln(f64::max(before, least)), f64::ln(f64::max(found, least)));
                let part = if high > low { ((MAX_SINGLETONS.ln() - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 };
                return ((f64::from(level) - 1.0 + part).exp2().round() as u32).clamp(COARSEST, FINEST);
            }
            if 1 << level >= FINEST {
                break;
            }
            (level, before) = (level + 1, found);
        }
        FINEST
    }
}

/// The finest and the coarse grid over a cloud, and which coarse cells are sampled.
#[derive(Clone, Debug)]
struct Lattice {
    min: DVec3,
    /// Finest cells per unit of length.
    factor: f64,
    /// Coarse cells whose hash is less than this are sampled.
    most: u64,
    /// A bit for each coarse cell, x fastest: whether it is sampled.
    chosen: Vec<u64>,
}

impl Lattice {
    /// `None` where the box has no extent.
    fn over((min, max): (DVec3, DVec3), count: u64) -> Option<Self> {
        let longest = (max - min).max_element();
        if longest.is_nan() || longest <= 0.0 {
            return None;
        }
        let most = if count > SAMPLE { SAMPLE * (1 << 32) / count } else { 1 << 32 };
        let mut own = Self { min, factor: f64::from(1u32 << BITS) / longest, most, chosen: Vec::new() };
        own.choose_cells();
        Some(own)
    }

    fn choose_cells(&mut self) {
        let code = |cell: u64| {
            let axis = |axis: u32| (cell >> (axis * COARSE_BITS)) as u32 % (1 << COARSE_BITS);
            morton_code(UVec3::new(axis(0), axis(1), axis(2))) << COARSE_SHIFT
        };
        let is_chosen = |cell: u64| self.is_chosen(code(cell));
        let word = |word: u64| (0..64).filter(|bit| is_chosen(word * 64 + bit)).fold(0, |mask, bit| mask | 1 << bit);
        self.chosen = (0..1 << (3 * COARSE_BITS - 6)).map(word).collect();
    }

    fn halve_sample(&mut self) {
        self.most /= 2;
        self.choose_cells();
    }

    /// Whether the coarse cell of a Morton code is sampled.
    fn is_chosen(&self, code: u64) -> bool {
        u64::from(hash((code >> COARSE_SHIFT) as u32)) < self.most
    }

    /// The Morton code of a point's finest cell, if the point is sampled.
    #[inline]
    fn code(&self, point: Vec3) -> Option<u64> {
        let most = f64::from((1u32 << BITS) - 1);
        let cell = ((point.as_dvec3() - self.min) * self.factor).min(DVec3::splat(most)).as_uvec3();
        let coarse = cell >> (BITS - COARSE_BITS);
        let at = coarse.z << (2 * COARSE_BITS) | coarse.y << COARSE_BITS | coarse.x;
        (self.chosen[at as usize / 64] >> (at % 64) & 1 != 0).then(|| morton_code(cell))
    }
}

/// The share of singletons: codes that no other code equals in the bits above the lowest `lost`.
fn singleton_share(codes: &[u64], lost: u32) -> f64 {
    let alone = codes.chunk_by(|a, b| a >> lost == b >> lost).filter(|cell| cell.len() == 1).count();
    alone as f64 / codes.len().max(1) as f64
}

/// Morton code of a cell: the bits of its coordinates, interleaved.
fn morton_code(cell: UVec3) -> u64 {
    let [x, y, z] = cell.to_array().map(|value| {
        let mut bits = u64::from(value);
        for (shift, mask) in [(16, 0x00ff_0000_ff00_00ff), (8, 0xf00f_00f0_0f00_f00f), (4, 0x30c3_0c30_c30c_30c3)] {
            bits = (bits | bits << shift) & mask;
        }
        (bits | bits << 2) & 0x9249_2492_4924_9249
    });
    x | y << 1 | z << 2
}

/// The finalizer of MurmurHash3 (Appleby, 2011).
fn hash(mut value: u32) -> u32 {
    value = (value ^ value >> 16).wrapping_mul(0x85eb_ca6b);
    value = (value ^ value >> 13).wrapping_mul(0xc2b2_ae35);
    value ^ value >> 16
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cloud(positions: Vec<Vec3>) -> PointCloud {
        PointCloud { positions, ..PointCloud::default() }
    }

    /// Points at random on a sphere.
    fn sphere(count: u32) -> Vec<Vec3> {
        let random = |at: u32| hash(at.wrapping_mul(2_654_435_761) ^ 0x5bd1_e995) as f32 / u32::MAX as f32;
        let point = |at: u32| {
            let (z, turn) = (random(2 * at) * 2.0 - 1.0, random(2 * at + 1) * std::f32::consts::TAU);
            let circle = (1.0 - z * z).max(0.0).sqrt();
            Vec3::new(circle * turn.cos(), circle * turn.sin(), z)
        };
        (0..count).map(point).collect()
    }

    #[test]
    fn four_times_as_many_points_on_a_surface_bear_twice_the_resolution() {
        let found: Vec<u32> = [5_000, 20_000, 80_000].map(|count| suited_resolution(&cloud(sphere(count)))).into();
        for pair in found.windows(2) {
            let factor = f64::from(pair[1]) / f64::from(pair[0]);
            assert!((1.8..2.2).contains(&factor), "{found:?}");
        }
    }

    #[test]
    fn few_more_points_fall_into_an_empty_voxel_and_with_four_times_the_resolution_many() {
        let points = sphere(100_000);
        let (points, more) = points.split_at(50_000);
        let missed = |resolution: u32| {
            let cell = |point: &Vec3| ((*point + 1.0) * 0.5 * resolution as f32).as_ivec3().to_array();
            let cells: std::collections::BTreeSet<_> = points.iter().map(cell).collect();
            more.iter().filter(|point| !cells.contains(&cell(point))).count() as f64 / more.len() as f64
        };
        let resolution = suited_resolution(&cloud(points.to_vec()));
        assert!((0.02..0.04).contains(&missed(resolution)), "{resolution}: {}", missed(resolution));
        assert!(missed(resolution * 4) > 0.5);
    }

    #[test]
    fn points_measured_twice_are_one_and_of_large_clouds_a_part_tells_all() {
        let points = sphere(60_000);
        let once = suited_resolution(&cloud(points.clone()));
        assert_eq!(suited_resolution(&cloud([points.clone(), points].concat())), once);
        let (large, small) = (suited_resolution(&cloud(sphere(4 << 20))), suited_resolution(&cloud(sphere(1 << 20))));
        let factor = f64::from(large) / f64::from(small);
        assert!((1.8..2.2).contains(&factor), "{large} {small}");
    }

    #[test]
    fn samples_of_parts_join_to_the_sample_of_all_in_any_order() {
        // So many that cells are dropped, in some parts earlier than in others.
        let random = |at: u32| hash(at.wrapping_mul(2_654_435_761)) as f32 / u32::MAX as f32;
        let points: Vec<Vec3> =
            (0..9_000_000).map(|at| Vec3::new(random(3 * at), random(3 * at + 1), random(3 * at + 2))).collect();
        let sample = |points: &[Vec3]| {
            // Created for few points, it takes all.
            let mut density = Density::over(Vec3::ZERO, Vec3::ONE, 1000);
            points.chunks(1 << 20).for_each(|points| density.add(points));
            density
        };
        let mut all = sample(&points);
        all.sort();
        let (head, rest) = points.split_at(5_500_000);
        let (body, tail) = rest.split_at(10);
        for order in [[head, body, tail], [tail, body, head], [body, head, tail]] {
            let mut joined = sample(&[]);
            for part in order {
                let mut out = FieldWriter::new(b"density\0");
                sample(part).write(&mut out);
                let bytes = out.finish();
                joined.join(Density::read(&mut FieldReader::open(&bytes, b"density\0").unwrap()).unwrap());
            }
            assert_eq!(joined.lattice.as_ref().unwrap().most, all.lattice.as_ref().unwrap().most);
            assert!(joined.lattice.as_ref().unwrap().most < 1 << 32 && joined.codes == all.codes);
        }
        assert!(all.codes.len() > 1_000_000);
    }

    #[test]
    fn the_coarsest_and_the_finest_grid_bound_the_choice() {
        assert_eq!(suited_resolution(&cloud(vec![Vec3::ZERO, Vec3::ONE, Vec3::X])), COARSEST);
        assert_eq!(suited_resolution(&cloud(vec![Vec3::ONE; 5])), FINEST);
        let line = (0..1 << 17).map(|at| Vec3::X * at as f32).collect();
        assert_eq!(suited_resolution(&cloud(line)), FINEST);
    }

    #[test]
    fn bits_are_taken_in_turn() {
        assert_eq!(morton_code(UVec3::new(0xffff, 0, 0)), 0x2492_4924_9249);
        assert_eq!(morton_code(UVec3::new(0b101, 0b010, 0b111)), 0b1_0111_0101);
    }
}
