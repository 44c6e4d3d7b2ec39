//! A level whose chunks are unpacked as layers of samples are asked for: those around the rows of a layer, which the layers behind it need too.

use super::Store;
use super::chunks::{self, Lattice};
use super::multiscale::Level;
use super::shard::Files;
use rayon::prelude::*;
use std::ops::Range;
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::volume::large::{Block, Coding, SampleSource};

/// The samples of a level at one place of all other axes.
pub(super) struct ChunkSamples {
    store: Store,
    level: Level,
    lattice: Lattice,
    frame: Volume,
    coding: Coding,
    /// What samples are in no chunk, as a code.
    fill: usize,
    /// The chunks that are unpacked.
    kept: Option<Kept>,
}

struct Kept {
    layer: usize,
    rows: Range<usize>,
    /// Row by row; `None` where there is none.
    chunks: Vec<Option<Vec<u8>>>,
}

impl ChunkSamples {
    pub fn new(store: Store, level: Level, lattice: Lattice, frame: Volume) -> Self {
        let (coding, fill) = (chunks::layout(&level.array, 1).coding(), level.array.fill);
        // There may be no code for what is in no chunk.
        let code = coding.table().iter().position(|&value| value == fill);
        let (coding, fill) = code.map_or((Coding::Reals, 0), |code| (coding, code));
        Self { store, level, lattice, frame, coding, fill, kept: None }
    }

    /// Unpacks the chunks of some rows of chunks in a layer of chunks.
    fn keep(&mut self, layer: usize, rows: Range<usize>) -> Result<(), ImportError> {
        let is_there = |kept: &Kept| kept.layer == layer && kept.rows.start <= rows.start && rows.end <= kept.rows.end;
        if self.kept.as_ref().is_some_and(is_there) {
            return Ok(());
        }
        // What is not needed any more makes room first.
        self.kept = None;
        let files = Files::new(&self.store, &self.level.array);
        let count = self.lattice.counts[0];
        let places = (rows.start * count..rows.end * count).into_par_iter();
        let unpack = |place: usize| {
            let at = self.lattice.chunk_at([place % count, place / count, layer], &self.level);
            chunks::bytes(&files, &self.store, &self.level.array, &at)
        };
        let chunks = places.map(unpack).collect::<Result<_, _>>()?;
        self.kept = Some(Kept { layer, rows, chunks });
        Ok(())
    }
}

impl ChunkSamples {
    /// Hands the bytes of each chunk's row to `put`, beside the samples that they become; where there is no chunk, these are `fill`.
    fn put<T: Copy + Send + Sync>(
        &self,
        kept: &Kept,
        (layer, rows): (usize, Range<usize>),
        samples: &mut [T],
        fill: T,
        put: impl Fn(&[u8], &mut [T]) + Sync,
    ) {
        let [wide, deep, high] = self.lattice.chunk;
        let width = self.frame.size[0];
        let (lattice, array) = (&self.lattice, &self.level.array);
        samples.par_chunks_mut(width).zip(rows).for_each(|(samples, row)| {
            let first = (row / deep - kept.rows.start) * lattice.counts[0];
            for (n, samples) in samples.chunks_mut(wide).enumerate() {
                match &kept.chunks[first + n] {
                    Some(bytes) => put(&lattice.row(array, bytes, [row % deep, layer % high], samples.len()), samples),
                    None => samples.fill(fill),
                }
            }
        });
    }
}

impl SampleSource for ChunkSamples {
    fn frame(&self) -> &Volume {
        &self.frame
    }

    fn frame_mut(&mut self) -> &mut Volume {
        &mut self.frame
    }

    fn bytes_of_row(&self) -> u64 {
        let [wide, deep, high] = self.lattice.chunk;
        // Whole chunks, those of other axes too, and rows that fill no chunk.
        let others = self.level.array.chunk_samples() / (wide * deep * high) as u64;
        let of_row = (self.lattice.counts[0] * wide * high) as u64 * others * self.level.array.sample.size() as u64;
        of_row.saturating_mul(5) / 4
    }

    fn coding(&self) -> Coding {
        self.coding.clone()
    }

    fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError> {
        let [_, deep, high] = self.lattice.chunk;
        self.keep(layer / high, rows.start / deep..rows.end.div_ceil(deep))?;
        let Some(kept) = &self.kept else { return Ok(()) };
        let layout = chunks::layout(&self.level.array, 1);
        let place = (layer, rows);
        match block {
            Block::Bytes(codes) => {
                let put = |bytes: &[u8], codes: &mut [u8]| {
                    codes.copy_from_slice(bytes);
                    layout.encode_bytes(codes);
                };
                self.put(kept, place, codes, self.fill as u8, put);
            }
            Block::Words(codes) => {
                let put = |bytes: &[u8], codes: &mut [u16]| {
                    bytemuck::cast_slice_mut(codes).copy_from_slice(bytes);
                    layout.encode_words(codes);
                };
                self.put(kept, place, codes, self.fill as u16, put);
            }
            Block::Reals(values) => {
                let put = |bytes: &[u8], values: &mut [f32]| layout.convert_into(bytes, values);
                self.put(kept, place, values, self.level.array.fill, put);
            }
        }
        Ok(())
    }
}
