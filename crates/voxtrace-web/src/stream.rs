//! A file for streaming as the worker has it that fetches its parts: scenes of those that are there, as the bytes of native files for the workers that trace. The worker
//! fetches and inflates; here parts are checked and put together.

use crate::error_of;
use voxtrace_core::packed::{FileErrorKind, StreamHead, StreamedLevels, WholeLevel};
use wasm_bindgen::prelude::*;
use xxhash_rust::xxh3::xxh3_64;

/// The checksum of a section, XXH3-64.
#[wasm_bindgen]
pub fn checksum(bytes: &[u8]) -> u64 {
    xxh3_64(bytes)
}

/// The parts of a file that have arrived.
#[wasm_bindgen]
pub struct Stream {
    head: StreamHead,
    levels: StreamedLevels,
    whole: Option<WholeLevel>,
}

/// An error for JavaScript.
fn fault(kind: FileErrorKind) -> JsError {
    error_of(kind)
}

#[wasm_bindgen]
impl Stream {
    /// Of the head, inflated, as are all further parts.
    ///
    /// # Errors
    /// Where it is damaged.
    #[wasm_bindgen(constructor)]
    pub fn new(head: &[u8]) -> Result<Self, JsError> {
        let head = StreamHead::read(head).map_err(fault)?;
        let levels = StreamedLevels::new(&head);
        Ok(Self { head, levels, whole: None })
    }

    /// Number of voxels of the whole scene, those of instances counted once for each.
    #[wasm_bindgen(getter)]
    pub fn voxels(&self) -> f64 {
        self.head.voxels() as f64
    }

    /// Bytes of the whole scene in memory.
    #[wasm_bindgen(getter)]
    pub fn bytes(&self) -> f64 {
        self.head.bytes() as f64
    }

    /// The hash of the whole scene, in hexadecimal digits.
    #[wasm_bindgen(getter)]
    pub fn hash(&self) -> String {
        format!("{:016x}", self.head.content_hash())
    }

    /// Where the grids stand: for each instance the index of its grid, the three columns of its matrix and its translation, 13 numbers.
    pub fn instances(&self) -> Vec<f64> {
        let numbers = self.head.instances().iter().flat_map(|instance| {
            let transform = instance.world_from_grid;
            let place = transform.linear.to_cols_array().into_iter().chain(transform.translation.to_array());
            std::iter::once(f64::from(instance.grid)).chain(place.map(f64::from))
        });
        numbers.collect()
    }

    /// Takes the front of a level and gives its index: for each chunk its grid, its place (three), and the bytes that it takes and is stored in, six numbers.
    ///
    /// # Errors
    /// Where it is damaged.
    pub fn add_front(&mut self, level: u32, front: &[u8]) -> Result<Vec<f64>, JsError> {
        self.levels.add_front(level, front).map_err(fault)?;
        let index = self.levels.index(level).unwrap_or_default();
        let numbers = index.iter().flat_map(|chunk| {
            let [x, y, z] = chunk.at.to_array().map(f64::from);
            [f64::from(chunk.grid), x, y, z, f64::from(chunk.size), f64::from(chunk.stored)]
        });
        Ok(numbers.collect())
    }

    /// Takes a chunk of a level whose front is there.
    ///
    /// # Errors
    /// Where it is damaged.
    pub fn add_chunk(&mut self, level: u32, number: u32, bytes: &[u8]) -> Result<(), JsError> {
        self.levels.add_chunk(level, number, bytes).map_err(fault)
    }

    /// Lets go of a chunk.
    pub fn remove_chunk(&mut self, level: u32, number: u32) {
        self.levels.remove_chunk(level, number);
    }

    /// The scene of some chunks, level and number of each, as the bytes of a native file.
    ///
    /// # Errors
    /// Where one is not there, or there are too many.
    pub fn scene(&self, chunks: &[u32]) -> Result<Vec<u8>, JsError> {
        let chunks: Vec<(u32, u32)> = chunks.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect();
        Ok(self.levels.scene(&chunks).map_err(fault)?.to_bytes())
    }

    /// Begins the scene itself: the front of level 0, and the tail where there is one.
    ///
    /// # Errors
    /// Where they are damaged.
    pub fn begin_whole(&mut self, front: &[u8], tail: Option<Vec<u8>>) -> Result<(), JsError> {
        self.whole = Some(WholeLevel::new(&self.head, 0, front, tail.as_deref()).map_err(fault)?);
        Ok(())
    }

    /// Takes a chunk of level 0 for the scene itself.
    ///
    /// # Errors
    /// Where it is damaged, or the scene was not begun.
    pub fn add_whole(&mut self, number: u32, bytes: &[u8]) -> Result<(), JsError> {
        let whole = self.whole.as_mut().ok_or_else(|| JsError::new("the scene was not begun"))?;
        whole.add(number, bytes).map_err(fault)
    }

    /// The scene itself as the bytes of a native file, once all its chunks are there.
    ///
    /// # Errors
    /// Where some are missing, or it is not the scene that was saved.
    pub fn finish_whole(&mut self) -> Result<Vec<u8>, JsError> {
        let whole = self.whole.take().ok_or_else(|| JsError::new("the scene was not begun"))?;
        Ok(whole.finish().map_err(fault)?.to_bytes())
    }
}
