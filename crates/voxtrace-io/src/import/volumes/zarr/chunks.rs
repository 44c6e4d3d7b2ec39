//! The samples of an array: its chunks, unpacked side by side and put together, at one place of all axes beyond three.

use super::multiscale::Level;
use super::shard::Files;
use super::{Array, Store};
use crate::import::samples::{Layout, checked_size};
use rayon::prelude::*;
use voxtrace_voxelize::{ImportError, Limits};

/// Reads the samples of a level at a place of the array's axes, of which those of space do not matter.
pub(super) fn read(store: &Store, level: &Level, entry: &[u64], limits: &Limits) -> Result<Vec<f32>, ImportError> {
    let array = &level.array;
    let size = checked_size(store.path, 0, level.size(), limits)?;
    let chunk = level.axes.map(|axis| axis.map_or(1, |axis| array.chunk[axis]));
    // Where an axis of a chunk is found among its samples.
    let mut strides = vec![0usize; array.shape.len()];
    let mut stride = 1usize;
    for &axis in array.order.iter().rev() {
        strides[axis] = stride;
        stride = stride.saturating_mul(array.chunk[axis] as usize);
    }
    let others = (0..array.shape.len()).filter(|axis| !level.axes.contains(&Some(*axis)));
    let others: Vec<usize> = others.collect();
    let within: usize = others.iter().map(|&axis| (entry[axis] % array.chunk[axis]) as usize * strides[axis]).sum();
    let strides = level.axes.map(|axis| axis.map_or(0, |axis| strides[axis]));
    let counts: [u64; 3] = std::array::from_fn(|n| (size[n] as u64).div_ceil(chunk[n]));
    let chunk = chunk.map(|size| size as usize);
    let mut values = vec![array.fill; size.iter().product()];
    let layer = size[0] * size[1];
    let files = Files::new(store, array);
    // Layers of chunks that share their shards.
    let shared = level.axes[2].zip(array.sharding.as_ref()).map_or(1, |(axis, sharding)| sharding.chunks[axis]);
    // A layer of chunks at a time: what is unpacked beside the result stays small.
    for (z, part) in values.chunks_mut(layer * chunk[2].min(size[2])).enumerate() {
        if (z as u64).is_multiple_of(shared) {
            files.forget();
        }
        let places: Vec<[u64; 2]> = (0..counts[1]).flat_map(|y| (0..counts[0]).map(move |x| [x, y])).collect();
        for places in places.chunks(rayon::current_num_threads() * 2) {
            let unpack = |&[x, y]: &[u64; 2]| {
                let mut at = vec![0; array.shape.len()];
                others.iter().for_each(|&axis| at[axis] = entry[axis] / array.chunk[axis]);
                for (axis, place) in level.axes.iter().zip([x, y, z as u64]) {
                    if let Some(axis) = axis {
                        at[*axis] = place;
                    }
                }
                samples(&files, store, array, &at)
            };
            let unpacked: Vec<_> = places.par_iter().map(unpack).collect();
            for (&[x, y], samples) in places.iter().zip(unpacked) {
                let Some(samples) = samples? else { continue };
                let [x, y] = [x as usize * chunk[0], y as usize * chunk[1]];
                let (width, depth) = (chunk[0].min(size[0] - x), chunk[1].min(size[1] - y));
                for k in 0..part.len() / layer {
                    for j in 0..depth {
                        let row = &mut part[k * layer + (y + j) * size[0] + x..][..width];
                        let from = within + k * strides[2] + j * strides[1];
                        for (i, value) in row.iter_mut().enumerate() {
                            *value = samples[from + i * strides[0]];
                        }
                    }
                }
            }
        }
    }
    Ok(values)
}

/// The samples of a chunk in the order in which they are stored, `None` where it is not there.
fn samples(files: &Files, store: &Store, array: &Array, at: &[u64]) -> Result<Option<Vec<f32>>, ImportError> {
    let (Some(mut bytes), name) = files.chunk(at)? else { return Ok(None) };
    let count = array.chunk_samples() as usize;
    let size = count * array.sample.size();
    for codec in array.codecs.iter().rev() {
        // A checksum makes what is inside a little longer.
        let unpacked = codec.undo(bytes, size + 4 * array.codecs.len());
        bytes = unpacked.map_err(|what| store.malformed(&name, &what))?;
    }
    if bytes.len() != size {
        return Err(store.malformed(&name, &format!("a chunk of {} bytes where there are to be {size}", bytes.len())));
    }
    let layout = Layout {
        sample: array.sample,
        big_endian: array.big_endian,
        size: [count, 1, 1],
        components: 1,
        rescale: (1.0, 0.0),
    };
    Ok(Some(layout.of_bytes(&bytes)))
}
