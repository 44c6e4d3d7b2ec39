//! Voxelizes a volume by slabs of eight layers, one layer of bricks each. Samples are resampled and classified by the transfer
//! function into a bit mask of visible voxels; the shell, where only that is wanted, is found with word operations on the mask.

use super::Volume;
use super::overlay::{Layers, Looks};
use super::resample::{Axis, Taps};
use super::transfer::Lookup;
use glam::IVec3;
use rayon::prelude::*;
use std::ops::Range;
use voxtrace_scene::brick::{BRICK_SIZE, Brick, bits, voxel_of};

/// Voxels along an edge of a brick.
pub(super) const EDGE: usize = BRICK_SIZE as usize;
/// Voxels in a word.
pub(super) const WORD: usize = u64::BITS as usize;

/// One layer of bricks.
pub(super) struct LayerBricks {
    /// Their materials are places in `looks`; without overlays they are those of the volume's transfer function.
    pub bricks: Vec<(IVec3, Brick)>,
    pub looks: Looks,
}

/// The bricks of one layer of bricks, with places in the looks of `layers` for materials; some of them where they are not `wanted` any more.
pub(super) fn bricks(layers: &Layers, layer: usize, shell: bool, wanted: &(dyn Fn() -> bool + Sync)) -> LayerBricks {
    let axes = layers.axes;
    let slab = Slab::seen(layers, layer, shell, wanted);
    let (wide, deep) = (axes[0].count().div_ceil(EDGE), axes[1].count().div_ceil(EDGE));
    let (mut bricks, mut looks) = (Vec::new(), Looks::default());
    for y in (0..deep).take_while(|_| wanted()) {
        for word in 0..slab.words {
            let rows: [u64; EDGE * EDGE] =
                std::array::from_fn(|at| slab.row(y * EDGE + at % EDGE + 1, at / EDGE + 1)[word]);
            if rows.iter().all(|&row| row == 0) {
                continue;
            }
            for x in word * EDGE..((word + 1) * EDGE).min(wide) {
                let occupancy = occupancy_of(&rows, x % EDGE * EDGE);
                if occupancy == [0; 8] {
                    continue;
                }
                let at = IVec3::new(x as i32, y as i32, layer as i32);
                let voxels = (0..8).flat_map(|block| bits(occupancy[block]).map(move |bit| voxel_of(block, bit)));
                let materials = voxels.map(|local| {
                    let voxel = (at * BRICK_SIZE + local).to_array().map(|at| at as usize);
                    let below = layers.lookup.material(value_at(layers, voxel));
                    if layers.are_plain() { below } else { looks.place_of(layers.stack(below, voxel)) }
                });
                bricks.push((at, Brick::new(occupancy, materials.collect())));
            }
        }
    }
    LayerBricks { bricks, looks }
}

/// The number of occupied voxels in one layer of bricks.
pub(super) fn count(layers: &Layers, layer: usize, shell: bool) -> u64 {
    let slab = Slab::seen(layers, layer, shell, &|| true);
    let rows = (1..=EDGE).flat_map(|z| (1..slab.rows - 1).map(move |y| (y, z)));
    rows.flat_map(|(y, z)| slab.row(y, z)).map(|word| u64::from(word.count_ones())).sum()
}

/// The resampled value of a voxel.
fn value_at(layers: &Layers, [x, y, z]: [usize; 3]) -> f32 {
    let axes = layers.axes;
    sample(layers.volume, axes, [&axes[0].taps[x], &axes[1].taps[y], &axes[2].taps[z]])
}

/// The values of all voxels; of some where they are not `wanted` any more.
pub(super) fn values(volume: &Volume, axes: &[Axis; 3], wanted: &(dyn Fn() -> bool + Sync)) -> Vec<f32> {
    let layer = |at_z: &Taps| {
        if !wanted() {
            return Vec::new();
        }
        let rows = axes[1].taps.iter();
        let voxels = rows.flat_map(|at_y| axes[0].taps.iter().map(move |at_x| [at_x, at_y]));
        voxels.map(|[at_x, at_y]| sample(volume, axes, [at_x, at_y, at_z])).collect::<Vec<_>>()
    };
    axes[2].taps.par_iter().flat_map_iter(layer).collect()
}

/// The occupancy of a brick from its 64 rows, z slowest; in each row's word the brick has the byte at `shift`.
pub(super) fn occupancy_of(rows: &[u64; EDGE * EDGE], shift: usize) -> [u64; 8] {
    let mut occupancy = [0; 8];
    for (at, row) in rows.iter().enumerate() {
        let (y, z, byte) = (at % EDGE, at / EDGE, row >> shift & 0xff);
        let (block, place) = ((y >> 2) << 1 | (z >> 2) << 2, (y & 3) << 2 | (z & 3) << 4);
        occupancy[block] |= (byte & 15) << place;
        occupancy[block + 1] |= (byte >> 4) << place;
    }
    occupancy
}

/// Bit masks of eight layers, of the layers below and above, and of an empty row before and behind each layer.
struct Slab {
    bits: Vec<u64>,
    /// Words in a row.
    words: usize,
    /// Rows in a layer.
    rows: usize,
}

impl Slab {
    /// What is seen: of the shell alone, where that is wanted.
    fn seen(layers: &Layers, layer: usize, shell: bool, wanted: &(dyn Fn() -> bool + Sync)) -> Self {
        let slab = Self::new(layers, layer, wanted);
        if shell { slab.shell() } else { slab }
    }

    fn new(layers: &Layers, layer: usize, wanted: &(dyn Fn() -> bool + Sync)) -> Self {
        let axes = layers.axes;
        let (words, rows) = (axes[0].count().div_ceil(WORD), axes[1].count().next_multiple_of(EDGE) + 2);
        let mut slab = Self { bits: vec![0; words * rows * (EDGE + 2)], words, rows };
        let reader = RowReader::new(layers.volume, axes, layers.lookup);
        for z in (0..EDGE + 2).take_while(|_| wanted()) {
            let Some(at_z) = (layer * EDGE + z).checked_sub(1).and_then(|z| axes[2].taps.get(z)) else { continue };
            for (y, at_y) in axes[1].taps.iter().enumerate() {
                let start = (z * rows + y + 1) * words;
                let row = &mut slab.bits[start..start + words];
                reader.read(at_y, at_z, row);
                layers.overlays.iter().for_each(|overlay| overlay.mark(y, layer * EDGE + z - 1, row));
            }
        }
        slab
    }

    /// Row `y` of layer `z`, counted with the borders.
    fn row(&self, y: usize, z: usize) -> &[u64] {
        let start = (z * self.rows + y) * self.words;
        &self.bits[start..start + self.words]
    }

    /// The mask of voxels with an empty neighbour, in the eight layers.
    fn shell(&self) -> Self {
        let mut shell = Self { bits: vec![0; self.bits.len()], ..*self };
        for z in 1..=EDGE {
            for y in 1..self.rows - 1 {
                let row = self.row(y, z);
                let around = [self.row(y - 1, z), self.row(y + 1, z), self.row(y, z - 1), self.row(y, z + 1)];
                let start = (z * self.rows + y) * self.words;
                for (word, seen) in shell.bits[start..start + self.words].iter_mut().enumerate() {
                    let bits = row[word];
                    let before = word.checked_sub(1).map_or(0, |before| row[before]);
                    let after = row.get(word + 1).copied().unwrap_or(0);
                    let sides = (bits << 1 | before >> 63) & (bits >> 1 | after << 63);
                    *seen = bits & !around.iter().fold(sides, |hidden, row| hidden & row[word]);
                }
            }
        }
        shell
    }
}

/// Resamples rows of voxels into bits, set where the transfer function shows the value.
struct RowReader<'a> {
    volume: &'a Volume,
    axes: &'a [Axis; 3],
    lookup: &'a Lookup,
    order: Order,
}

/// Memory layout of a row's samples.
#[derive(Clone, Copy, PartialEq)]
enum Order {
    /// One sample per voxel, contiguous.
    Forward,
    Backward,
    /// Any other layout.
    Any,
}

impl<'a> RowReader<'a> {
    fn new(volume: &'a Volume, axes: &'a [Axis; 3], lookup: &'a Lookup) -> Self {
        let (count, taps) = (axes[0].count(), &axes[0].taps);
        let follows = |place: &dyn Fn(usize) -> usize| {
            taps.iter().enumerate().all(|(at, taps)| taps.weights.len() == 1 && taps.start == place(at))
        };
        let order = if follows(&|at| at) {
            Order::Forward
        } else if follows(&|at| count - 1 - at) {
            Order::Backward
        } else {
            Order::Any
        };
        Self { volume, axes, lookup, order }
    }

    fn read(&self, at_y: &Taps, at_z: &Taps, words: &mut [u64]) {
        let count = self.axes[0].count();
        for (at, word) in words.iter_mut().enumerate() {
            let range = at * WORD..((at + 1) * WORD).min(count);
            let (mut values, mut seen) = ([0.0; WORD], [false; WORD]);
            let values = &mut values[..range.len()];
            if self.order == Order::Any {
                for (value, at_x) in values.iter_mut().zip(&self.axes[0].taps[range]) {
                    *value = sample(self.volume, self.axes, [at_x, at_y, at_z]);
                }
            } else {
                self.mix(at_y, at_z, range, values);
            }
            self.lookup.see(values, &mut seen);
            *word = packed(&seen);
        }
    }

    /// Resamples voxels `range` of a row at once, with the same result as [`sample`] for each.
    fn mix(&self, at_y: &Taps, at_z: &Taps, range: Range<usize>, values: &mut [f32]) {
        let [x, y, z] = self.axes;
        let is_backward = self.order == Order::Backward;
        let place = if is_backward { x.count() - range.end } else { range.start };
        // Sums run along the lattice, not the grid.
        let ((fast, at_fast), (slow, at_slow)) =
            if y.lattice < z.lattice { ((y, at_y), (z, at_z)) } else { ((z, at_z), (y, at_y)) };
        for (k, weight_slow) in at_slow.weights.iter().enumerate() {
            for (j, weight_fast) in at_fast.weights.iter().enumerate() {
                let start = place + at_y.start + at_z.start + k * slow.stride + j * fast.stride;
                let samples = &self.volume.values[start..start + range.len()];
                let weight = weight_fast * weight_slow;
                if is_backward {
                    values.iter_mut().zip(samples.iter().rev()).for_each(|(value, sample)| *value += weight * sample);
                } else {
                    values.iter_mut().zip(samples).for_each(|(value, sample)| *value += weight * sample);
                }
            }
        }
    }
}

/// 64 booleans as bits, the first one lowest.
pub(super) fn packed(truths: &[bool; WORD]) -> u64 {
    /// Brings the lowest bits of eight bytes together in the highest byte.
    const GATHER: u64 = 0x0102_0408_1020_4080;
    let bytes: &[u8; WORD] = bytemuck::cast_ref(truths);
    let mut word = 0;
    for (at, &bytes) in bytes.as_chunks::<8>().0.iter().enumerate() {
        word |= (u64::from_le_bytes(bytes).wrapping_mul(GATHER) >> 56) << (8 * at);
    }
    word
}

/// The value at a voxel. It is summed in the order of the samples, so that a volume that is read layer by layer has the same.
fn sample(volume: &Volume, axes: &[Axis; 3], taps: [&Taps; 3]) -> f32 {
    let start = taps.iter().map(|taps| taps.start).sum::<usize>();
    if taps.iter().all(|taps| taps.weights.len() == 1) {
        return volume.values[start];
    }
    let along = |lattice: usize| {
        let at = axes.iter().position(|axis| axis.lattice == lattice).unwrap_or(lattice);
        (axes[at].stride, &taps[at].weights)
    };
    let ([x, y, z], mut sum) = ([0, 1, 2].map(along), 0.0f32);
    for (k, weight_z) in z.1.iter().enumerate() {
        for (j, weight_y) in y.1.iter().enumerate() {
            let row = start + k * z.0 + j * y.0;
            for (i, weight_x) in x.1.iter().enumerate() {
                sum += weight_x * weight_y * weight_z * volume.values[row + i * x.0];
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::volume::{Ramp, Transfer};
    use glam::Vec3;

    /// Voxels of a lump with holes, of which some are seen, wherever the words and bricks end.
    fn voxels(backwards: bool, shell: bool) -> (Vec<IVec3>, Vec<IVec3>) {
        const SIZE: [usize; 3] = [75, 19, 21];
        let is_set = |at: IVec3| {
            let inside = at.cmpge(IVec3::ZERO).all() && at.cmplt(IVec3::from_array(SIZE.map(|n| n as i32))).all();
            let at = if backwards { IVec3::new(SIZE[0] as i32 - 1 - at.x, at.y, at.z) } else { at };
            inside && (at.x * 7 + at.y * 5 + at.z * 3) % 61 != 0 && at.x > 1
        };
        let all: Vec<IVec3> = (0..SIZE.iter().product::<usize>())
            .map(|i| IVec3::new((i % 75) as i32, (i / 75 % 19) as i32, (i / (75 * 19)) as i32))
            .collect();
        let lattice = |at: IVec3| if backwards { IVec3::new(74 - at.x, at.y, at.z) } else { at };
        let values = all.iter().map(|&at| if is_set(lattice(at)) { 5.0 } else { -1.0 }).collect();
        let volume = Volume::new(SIZE, values);
        let ramp = Ramp::Absolute { low: 0.0, high: 9.0, stops: vec![(0.0, Vec3::ONE)] };
        let lookup = Transfer::new("", ramp).lookup();
        let axes = [0, 1, 2].map(|axis| Axis::new(axis, SIZE, axis == 0 && backwards, SIZE[axis], false));
        let layers = Layers { volume: &volume, axes: &axes, lookup: &lookup, colors: None, overlays: Vec::new() };
        let found = (0..3).flat_map(|layer| bricks(&layers, layer, shell, &|| true).bricks);
        let voxels =
            found.flat_map(|(at, brick)| brick.voxels().map(|voxel| at * BRICK_SIZE + voxel.0).collect::<Vec<_>>());
        let mut voxels: Vec<IVec3> = voxels.collect();
        voxels.sort_by_key(|at| (at.z, at.y, at.x));
        let has_way = |at: IVec3| IVec3::AXES.iter().any(|&step| !is_set(at + step) || !is_set(at - step));
        let wanted = all.into_iter().filter(|&at| is_set(at) && (!shell || has_way(at))).collect();
        (voxels, wanted)
    }

    #[test]
    fn words_of_bits_hold_the_voxels_that_a_look_at_each_one_finds() {
        for (backwards, shell) in [(false, false), (false, true), (true, false), (true, true)] {
            let (found, wanted) = voxels(backwards, shell);
            assert!(found == wanted, "{backwards} {shell}: {} {}", found.len(), wanted.len());
        }
        let (mut planted, wanted) = voxels(false, true);
        planted.pop();
        assert!(planted != wanted);
    }

    #[test]
    fn whole_rows_are_mixed_as_single_samples_are() {
        const SIZE: [usize; 3] = [70, 6, 5];
        let values = (0..70 * 6 * 5u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 20) as f32 / 7.0).collect();
        let volume = Volume::new(SIZE, values);
        let ramp = Ramp::Absolute { low: 300.0, high: 500.0, stops: vec![(0.0, Vec3::ONE)] };
        let lookup = Transfer::new("", ramp).lookup();
        for backwards in [false, true] {
            let counts = [70, 9, 4];
            let axes = [0, 1, 2].map(|axis| Axis::new(axis, SIZE, backwards, counts[axis], false));
            let reader = RowReader::new(&volume, &axes, &lookup);
            assert!(reader.order != Order::Any);
            let mut planted = 0;
            for (at_z, at_y) in axes[2].taps.iter().flat_map(|z| axes[1].taps.iter().map(move |y| (z, y))) {
                let mut words = [0; 2];
                reader.read(at_y, at_z, &mut words);
                for (x, at_x) in axes[0].taps.iter().enumerate() {
                    let value = sample(&volume, &axes, [at_x, at_y, at_z]);
                    assert_eq!(words[x / WORD] >> (x % WORD) & 1 != 0, (300.0..=500.0).contains(&value), "{x} {value}");
                    planted += usize::from((300.0..=500.0).contains(&value) != (301.0..=499.0).contains(&value));
                }
            }
            assert!(planted > 0);
        }
    }

    #[test]
    fn truths_become_bits_in_their_order() {
        let truths: [bool; WORD] = std::array::from_fn(|at| at * at % 7 < 3);
        let bits = (0..WORD).filter(|&at| truths[at]).fold(0u64, |bits, at| bits | 1 << at);
        assert_eq!(packed(&truths), bits);
    }
}
