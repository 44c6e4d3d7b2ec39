//! The samples of an array: its chunks, unpacked side by side and put together, at one place of all axes beyond three.

use super::multiscale::Level;
use super::shard::Files;
use super::{Array, Store, n5};
use crate::import::samples::{Layout, checked_size};
use rayon::prelude::*;
use std::borrow::Cow;
use voxtrace_voxelize::{ImportError, Limits};

/// Where the samples of a level lie among chunks, at one place of all other axes.
pub(super) struct Lattice {
    /// Samples along x, y and z.
    pub size: [usize; 3],
    /// Those of a chunk.
    pub chunk: [usize; 3],
    /// How many chunks there are.
    pub counts: [usize; 3],
    /// Numbers of a chunk's sample from one to the next along each axis, and of the first.
    strides: [usize; 3],
    within: usize,
    /// The chunk along each axis of the array that is none of space.
    others: Vec<(usize, u64)>,
}

impl Lattice {
    /// At a place of the array's axes, of which those of space do not matter.
    pub fn of(store: &Store, level: &Level, entry: &[u64], limits: &Limits) -> Result<Self, ImportError> {
        let array = &level.array;
        let size = checked_size(&store.path, 0, level.size(), limits)?;
        let chunk = level.axes.map(|axis| axis.map_or(1, |axis| array.chunk[axis] as usize));
        // Where an axis of a chunk is found among its samples.
        let mut strides = vec![0usize; array.shape.len()];
        let mut stride = 1usize;
        for &axis in array.order.iter().rev() {
            strides[axis] = stride;
            stride = stride.saturating_mul(array.chunk[axis] as usize);
        }
        let others = (0..array.shape.len()).filter(|axis| !level.axes.contains(&Some(*axis)));
        let others: Vec<usize> = others.collect();
        let within = others.iter().map(|&axis| (entry[axis] % array.chunk[axis]) as usize * strides[axis]).sum();
        let others = others.into_iter().map(|axis| (axis, entry[axis] / array.chunk[axis])).collect();
        let strides = level.axes.map(|axis| axis.map_or(0, |axis| strides[axis]));
        let counts = std::array::from_fn(|n| size[n].div_ceil(chunk[n]));
        Ok(Self { size, chunk, counts, strides, within, others })
    }

    /// The number of a chunk along each axis of the array.
    pub fn chunk_at(&self, place: [usize; 3], level: &Level) -> Vec<u64> {
        let mut at = vec![0; level.array.shape.len()];
        self.others.iter().for_each(|&(axis, number)| at[axis] = number);
        for (axis, place) in level.axes.iter().zip(place) {
            if let Some(axis) = axis {
                at[*axis] = place as u64;
            }
        }
        at
    }

    /// The bytes of so many samples of a chunk's row, y and z of it.
    pub fn row<'b>(&self, array: &Array, bytes: &'b [u8], [y, z]: [usize; 2], count: usize) -> Cow<'b, [u8]> {
        let size = array.sample.size();
        let first = self.within + z * self.strides[2] + y * self.strides[1];
        if self.strides[0] == 1 {
            return bytes[first * size..(first + count) * size].into();
        }
        let place = |x: usize| (first + x * self.strides[0]) * size;
        (0..count).flat_map(|x| bytes[place(x)..place(x) + size].iter().copied()).collect()
    }
}

/// How the samples of a chunk are stored.
pub(super) fn layout(array: &Array, count: usize) -> Layout {
    let (sample, big_endian) = (array.sample, array.big_endian);
    Layout { sample, big_endian, size: [count, 1, 1], components: 1, rescale: array.rescale }
}

/// Reads the samples of a level.
pub(super) fn read(store: &Store, level: &Level, entry: &[u64], limits: &Limits) -> Result<Vec<f32>, ImportError> {
    let array = &level.array;
    let lattice = Lattice::of(store, level, entry, limits)?;
    let Lattice { size, chunk, counts, .. } = lattice;
    let mut values = vec![array.fill; size.iter().product()];
    let layer = size[0] * size[1];
    let files = Files::new(store, array);
    // A layer of chunks at a time: what is unpacked beside the result stays small.
    for (z, part) in values.chunks_mut(layer * chunk[2].min(size[2])).enumerate() {
        let places: Vec<[usize; 2]> = (0..counts[1]).flat_map(|y| (0..counts[0]).map(move |x| [x, y])).collect();
        for places in places.chunks(rayon::current_num_threads() * 2) {
            let unpack = |&[x, y]: &[usize; 2]| bytes(&files, store, array, &lattice.chunk_at([x, y, z], level));
            let unpacked: Vec<_> = places.par_iter().map(unpack).collect();
            for (&[x, y], bytes) in places.iter().zip(unpacked) {
                let Some(bytes) = bytes? else { continue };
                let [x, y] = [x * chunk[0], y * chunk[1]];
                let (width, depth) = (chunk[0].min(size[0] - x), chunk[1].min(size[1] - y));
                for k in 0..part.len() / layer {
                    for j in 0..depth {
                        let row = &mut part[k * layer + (y + j) * size[0] + x..][..width];
                        layout(array, row.len()).convert_into(&lattice.row(array, &bytes, [j, k], row.len()), row);
                    }
                }
            }
        }
    }
    Ok(values)
}

/// The bytes of a chunk's samples in the order in which they are stored, `None` where it is not there.
pub(super) fn bytes(files: &Files, store: &Store, array: &Array, at: &[u64]) -> Result<Option<Vec<u8>>, ImportError> {
    let (Some(mut bytes), name) = files.chunk(at)? else { return Ok(None) };
    let malformed = |what: &str| store.malformed(&name, what);
    let mut own = None;
    if array.has_head {
        let (sizes, rest) = n5::head(&bytes).map_err(malformed)?;
        if sizes.len() != array.chunk.len() || sizes.iter().zip(&array.chunk).any(|(own, most)| own > most) {
            return Err(malformed("a block of another size than its array says"));
        }
        bytes = rest.to_vec();
        own = Some(sizes);
    }
    let count: u64 = own.as_ref().unwrap_or(&array.chunk).iter().product();
    let size = count as usize * array.sample.size();
    for codec in array.codecs.iter().rev() {
        // A checksum makes what is inside a little longer.
        bytes = codec.undo(bytes, size + 4 * array.codecs.len()).map_err(|what| malformed(&what))?;
    }
    if bytes.len() != size {
        return Err(malformed(&format!("a chunk of {} bytes where there are to be {size}", bytes.len())));
    }
    Ok(Some(match own {
        Some(own) => n5::whole(bytes, &own, &array.chunk, array.sample.size()),
        None => bytes,
    }))
}
