//! A scene that is larger than the memory that it may take on a device: cells, bricks, materials of voxels and lights lie there in pages, those
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
use voxtrace_core::packed::{Emitter, Geometry, LightNode};

/// log₂ of the words of a page: 4 KiB.
pub const PAGE_BITS: u32 = 10;
/// Words before the slots of the pages.
pub const PAGE_HEADER: u32 = 8;
/// The word of the header that is not 0 where lights lie in pages.
pub const PAGES_HAVE_LIGHTS: u32 = 5;
/// Words of an [`Emitter`] and of a [`LightNode`]. Powers of two: none lies in two pages.
pub const EMITTER_WORDS: u32 = 8;
pub const LIGHT_NODE_WORDS: u32 = 16;

const _: () = assert!(size_of::<Emitter>() == 4 * EMITTER_WORDS as usize);
const _: () = assert!(size_of::<LightNode>() == 4 * LIGHT_NODE_WORDS as usize);

/// What lies in pages: cells, bricks, materials of voxels, emitters and the trees over those of each grid.
const ARRAYS: usize = 5;
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
    /// The first page of each array.
    starts: [u32; ARRAYS],
    /// The number of all.
    count: u32,
    /// Whether emitters and the trees over them lie in pages, too.
    pub has_lights: bool,
    slots: Slots,
    /// Bytes of pages that were uploaded.
    loaded_bytes: u64,
    rounds: u64,
    /// Pages to bring as if nothing were in them, for tests.
    #[cfg(feature = "faults")]
    pub emptied: usize,
}

impl Pages {
    /// Bytes of emitters and the trees over them.
    pub fn light_bytes_of(geometry: &Geometry) -> u64 {
        (size_of_val(geometry.emitters()) + size_of_val(geometry.light_nodes())) as u64
    }

    /// Bytes of what may lie in pages.
    pub fn bytes_of(geometry: &Geometry) -> u64 {
        arrays_of(geometry, true).iter().map(|words| 4 * words.len() as u64).sum()
    }

    /// Room for as many pages of `geometry` as `budget` bytes hold. None is there yet. Lights lie there whole where they take at most half of it: a choice among
    /// all of them comes to pages everywhere.
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
        let most = device.info().limits.max_storage_bytes();
        let plan = |has_lights| Plan::new(geometry, has_lights, budget, most);
        let has_lights = Self::light_bytes_of(geometry) > budget / 2 || plan(false).room <= FEWEST;
        let Plan { starts, count, room, whole } = plan(has_lights);
        if room <= FEWEST {
            return Err(TraceError::OutOfMemory { needed: whole + (FEWEST + 1) * PAGE_BYTES, available: budget });
        }
        let table_bytes = table_bytes(count);
        // The first slot holds no page.
        let slots = Slots::new(count as usize, room.min(count + 1) as usize);
        let pool = Buffer::storage(device, "pages", slots.len() as u64 * PAGE_BYTES)?;
        let usage = vk::BufferUsageFlags::STORAGE_BUFFER
            | vk::BufferUsageFlags::TRANSFER_SRC
            | vk::BufferUsageFlags::TRANSFER_DST;
        let table = Buffer::new(device, "page table", table_bytes, usage, MemoryLocation::GpuOnly)?;
        let words = vec![0u32; (table_bytes / 4) as usize];
        let mut header = [0; PAGE_HEADER as usize];
        header[0] = count as u32;
        header[1..ARRAYS].copy_from_slice(&starts[1..]);
        header[PAGES_HAVE_LIGHTS as usize] = has_lights.into();
        let writes = [
            Write::new(&pool, 0, cast_slice(&[0u32; PAGE_WORDS])),
            Write::new(&table, 0, cast_slice(&header)),
            Write::new(&table, 4 * u64::from(PAGE_HEADER), cast_slice(&words[PAGE_HEADER as usize..])),
        ];
        transfer.write(submitter, &writes, None)?;
        Ok(Self {
            device: Arc::clone(device),
            pool,
            table,
            starts,
            count: count as u32,
            has_lights,
            slots,
            rounds: 0,
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
        let count = self.count as usize;
        let mut marks = vec![0u32; count];
        let marks_at = 4 * u64::from(PAGE_HEADER + self.count);
        transfer.download(submitter, &self.table, marks_at, bytemuck::cast_slice_mut(&mut marks))?;
        let marked = marks.iter().enumerate().filter(|(_, mark)| **mark != 0).map(|(page, _)| page);
        let brought = self.slots.bring(marked);
        let (device, table) = (Arc::clone(&self.device), self.table.handle);
        let clear = |commands| {
            // SAFETY: the marks lie inside the table; the commands are being recorded.
            unsafe { device.raw.cmd_fill_buffer(commands, table, marks_at, 4 * count as u64, 0) }
        };
        if brought.wanted == 0 {
            // Else the next round would seem to use what this one came to, and leave no room for what it wants.
            submitter.run_commands("clearing the marks of pages", &clear)?;
            return Ok(Served::Everything);
        }
        #[cfg_attr(not(feature = "faults"), expect(unused_mut, reason = "tests plant faults"))]
        let mut pages: Vec<(u64, &[u32])> = brought
            .pages
            .iter()
            .map(|&(page, slot)| (slot as u64 * PAGE_BYTES, self.words_of(geometry, page)))
            .collect();
        let mut writes = Vec::with_capacity(pages.len() + 1);
        #[cfg(feature = "faults")]
        for (_, words) in pages.iter_mut().take(std::mem::take(&mut self.emptied)) {
            *words = &[0; PAGE_WORDS][..words.len()];
        }
        writes.extend(pages.iter().map(|&(at, words)| Write::new(&self.pool, at, cast_slice(words))));
        let slots_at = 4 * u64::from(PAGE_HEADER);
        writes.push(Write::new(&self.table, slots_at, cast_slice(self.slots.of_pages())));
        transfer.write(submitter, &writes, Some(("bringing pages of the scene", &clear)))?;
        self.rounds += 1;
        self.loaded_bytes += pages.len() as u64 * PAGE_BYTES;
        Ok(if pages.is_empty() { Served::Nothing } else { Served::Some })
    }

    /// Pages that are marked, for tests.
    #[cfg(feature = "faults")]
    pub fn marked(&self, submitter: &mut Submitter, transfer: &mut Transfer) -> Result<usize, TraceError> {
        let mut marks = vec![0u32; self.count as usize];
        let at = 4 * u64::from(PAGE_HEADER + self.count);
        transfer.download(submitter, &self.table, at, bytemuck::cast_slice_mut(&mut marks))?;
        Ok(marks.into_iter().filter(|mark| *mark != 0).count())
    }

    /// Bytes of pages that were uploaded so far, and rounds of tracing after which some were asked for.
    pub fn loaded(&self) -> (u64, u64) {
        (self.loaded_bytes, self.rounds)
    }

    /// The words of a page, fewer than a whole one at the end of an array.
    fn words_of<'a>(&self, geometry: &'a Geometry, page: usize) -> &'a [u32] {
        // An array without words has no page, and the same first one as the array after it.
        let which = self.starts.iter().rposition(|&start| start as usize <= page).unwrap_or(0);
        let first = (page - self.starts[which] as usize) * PAGE_WORDS;
        let words = arrays_of(geometry, self.has_lights)[which];
        &words[first..words.len().min(first + PAGE_WORDS)]
    }
}

/// How the memory for a scene is divided.
struct Plan {
    /// The first page of each array, and the number of all.
    starts: [u32; ARRAYS],
    count: u64,
    /// Pages that there is room for.
    room: u64,
    /// Bytes of what is no page.
    whole: u64,
}

impl Plan {
    fn new(geometry: &Geometry, has_lights: bool, budget: u64, most: u64) -> Self {
        let mut count = 0u64;
        let starts = arrays_of(geometry, has_lights).map(|words| {
            count += words.len().div_ceil(PAGE_WORDS) as u64;
            (count - words.len().div_ceil(PAGE_WORDS) as u64) as u32
        });
        let lights = if has_lights { 0 } else { Pages::light_bytes_of(geometry) };
        let whole = lights + table_bytes(count);
        Self { starts, count, room: budget.saturating_sub(whole).min(most) / PAGE_BYTES, whole }
    }
}

/// Bytes of the table of so many pages.
fn table_bytes(count: u64) -> u64 {
    4 * (u64::from(PAGE_HEADER) + 2 * count)
}

/// What lies in pages, in their order.
fn arrays_of(geometry: &Geometry, has_lights: bool) -> [&[u32]; ARRAYS] {
    let (emitters, nodes) = if has_lights { (geometry.emitters(), geometry.light_nodes()) } else { (&[][..], &[][..]) };
    [geometry.cells(), geometry.bricks(), geometry.brick_materials(), cast_slice(emitters), cast_slice(nodes)]
}
