//! A scene that is larger than the memory that it may take on a device: cells, bricks and materials of voxels lie there in pages, those
//! that rays came to. Twin of `shaders/pages.slang`; `docs/decisions/0150-scenes-in-pages.md` says how it goes.
//!
//! Shaders mark each page that they come to. A sample that comes to one which is not there is given up, and its pixel traces it again
//! once the page is there: samples are functions of their number, so the film is the same to the last bit.

mod slots;

use crate::buffer::Buffer;
use crate::commands::Submitter;
use crate::device::Device;
use crate::transfer::{Transfer, Write};
use ash::vk;
use bytemuck::cast_slice;
use gpu_allocator::MemoryLocation;
use slots::Slots;
use std::sync::Arc;
use voxtrace_core::TraceError;
use voxtrace_core::packed::Geometry;

/// log₂ of the words of a page: 16 KiB.
pub const PAGE_BITS: u32 = 12;
/// Words before the slots of the pages.
pub const PAGE_HEADER: u32 = 4;

/// Words and bytes of a page.
const PAGE_WORDS: usize = 1 << PAGE_BITS;
const PAGE_BYTES: u64 = 4 << PAGE_BITS;
/// Fewest pages with which anything can be traced.
const FEWEST: u64 = 16;

/// What a round of tracing asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Served {
    /// All that it came to was there.
    Everything,
    /// What it asked for is there now, or as much of it as there was room for beside what the round used.
    Some,
    /// There was no room for any of it.
    Nothing,
}

/// The pages of a scene on a device.
pub struct Pages {
    device: Arc<Device>,
    /// The slots, the first of which is all zeros.
    pub pool: Buffer,
    /// Which page is where, and marks: see `shaders/pages.slang`.
    pub table: Buffer,
    /// The first pages of bricks and of materials, and the number of all.
    starts: [u32; 3],
    slots: Slots,
    /// Bytes of pages that were uploaded.
    loaded_bytes: u64,
    /// Pages to bring as if nothing were in them, for tests.
    #[cfg(feature = "faults")]
    pub emptied: usize,
}

impl Pages {
    /// Bytes of what may lie in pages.
    pub fn bytes_of(geometry: &Geometry) -> u64 {
        arrays_of(geometry).iter().map(|words| 4 * words.len() as u64).sum()
    }

    /// Room for as many pages of `geometry` as `budget` bytes hold. None is there yet.
    ///
    /// # Errors
    /// [`TraceError::OutOfMemory`] where that is less than a few.
    pub fn new(
        device: &Arc<Device>,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        geometry: &Geometry,
        budget: u64,
    ) -> Result<Self, TraceError> {
        let [cells, bricks, materials] = arrays_of(geometry).map(|words| words.len().div_ceil(PAGE_WORDS) as u64);
        let count = cells + bricks + materials;
        let table_bytes = 4 * (u64::from(PAGE_HEADER) + 2 * count);
        let room = budget.saturating_sub(table_bytes).min(device.info().limits.max_storage_buffer_range) / PAGE_BYTES;
        if room <= FEWEST {
            return Err(TraceError::OutOfMemory { needed: table_bytes + (FEWEST + 1) * PAGE_BYTES, available: budget });
        }
        let starts = [cells as u32, (cells + bricks) as u32, count as u32];
        // The first slot holds no page.
        let slots = Slots::new(count as usize, room.min(count + 1) as usize);
        let pool = Buffer::storage(device, "pages", slots.len() as u64 * PAGE_BYTES)?;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let table = Buffer::new(device, "page table", table_bytes, usage, MemoryLocation::GpuOnly)?;
        let words = vec![0u32; (table_bytes / 4) as usize];
        let header = [starts[0], starts[1], starts[2], 0];
        let writes = [
            Write { buffer: &pool, at: 0, bytes: cast_slice(&[0u32; PAGE_WORDS]) },
            Write { buffer: &table, at: 0, bytes: cast_slice(&header) },
            Write { buffer: &table, at: 4 * u64::from(PAGE_HEADER), bytes: cast_slice(&words[PAGE_HEADER as usize..]) },
        ];
        transfer.write(submitter, &writes, None)?;
        Ok(Self {
            device: Arc::clone(device),
            pool,
            table,
            starts,
            slots,
            loaded_bytes: 0,
            #[cfg(feature = "faults")]
            emptied: 0,
        })
    }

    /// Brings what the last round came to and did not find. What it found stays, and of the rest what was not used for longest makes room.
    pub fn serve(
        &mut self,
        submitter: &mut Submitter,
        transfer: &mut Transfer,
        geometry: &Geometry,
    ) -> Result<Served, TraceError> {
        let count = self.starts[2] as usize;
        let mut marks = vec![0u32; count];
        let marks_at = 4 * u64::from(PAGE_HEADER + self.starts[2]);
        transfer.download(submitter, &self.table, marks_at, bytemuck::cast_slice_mut(&mut marks))?;
        let marked = marks.iter().enumerate().filter(|(_, mark)| **mark != 0).map(|(page, _)| page);
        let brought = self.slots.bring(marked);
        if brought.wanted == 0 {
            return Ok(Served::Everything);
        }
        #[cfg_attr(not(feature = "faults"), expect(unused_mut, reason = "tests plant faults"))]
        let mut pages: Vec<(u64, &[u32])> = brought
            .pages
            .iter()
            .map(|&(page, slot)| (slot as u64 * PAGE_BYTES, words_of(geometry, self.starts, page)))
            .collect();
        let mut writes = Vec::with_capacity(pages.len() + 1);
        #[cfg(feature = "faults")]
        for (_, words) in pages.iter_mut().take(std::mem::take(&mut self.emptied)) {
            *words = &[0; PAGE_WORDS][..words.len()];
        }
        writes.extend(pages.iter().map(|&(at, words)| Write { buffer: &self.pool, at, bytes: cast_slice(words) }));
        let slots_at = 4 * u64::from(PAGE_HEADER);
        writes.push(Write { buffer: &self.table, at: slots_at, bytes: cast_slice(self.slots.of_pages()) });
        let (raw, table) = (&self.device.raw, self.table.handle);
        let clear = |commands| {
            // SAFETY: the marks lie inside the table; the commands are being recorded.
            unsafe { raw.cmd_fill_buffer(commands, table, marks_at, 4 * count as u64, 0) }
        };
        transfer.write(submitter, &writes, Some(("bringing pages of the scene", &clear)))?;
        self.loaded_bytes += pages.len() as u64 * PAGE_BYTES;
        Ok(if pages.is_empty() { Served::Nothing } else { Served::Some })
    }

    /// Bytes of pages that were uploaded so far.
    pub fn loaded_bytes(&self) -> u64 {
        self.loaded_bytes
    }
}

/// What lies in pages, in their order.
fn arrays_of(geometry: &Geometry) -> [&[u32]; 3] {
    [geometry.cells(), geometry.bricks(), geometry.brick_materials()]
}

/// The words of a page, fewer than a whole one at the end of an array.
fn words_of(geometry: &Geometry, starts: [u32; 3], page: usize) -> &[u32] {
    let firsts = [0, starts[0] as usize, starts[1] as usize];
    let which = firsts.iter().rposition(|&first| first <= page).unwrap_or(0);
    // An array without words has no page, and the one before it the same first page.
    let first = (page - firsts[which]) * PAGE_WORDS;
    let words = arrays_of(geometry)[which];
    &words[first..words.len().min(first + PAGE_WORDS)]
}
