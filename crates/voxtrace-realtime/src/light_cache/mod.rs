//! Light on the faces of voxels, in the space of their grids, so that it moves with them: a hash table of cells, each a face of a voxel or of a cube of 2, 4, …
//! of them. Paths ask it where they met their second surface. Cells that were asked for trace rays of their own, whose ends ask the table again, and those
//! that nobody asks for any more go.
//!
//! Cells for positions and normals are due to Binder et al. ("Massively Parallel Path Space Filtering", 2019) and to Boissé et al. ("GI-1.0", 2022); that cells pull
//! their light, rather than paths pushing it, lets the table do with words of 32 bits and the mean over a face be one without bias.

mod key;
mod tracing;

pub use key::{Key, Request};

use glam::Vec3;

/// Frames that a cell lives after it was asked for.
pub(crate) const LIFE: u32 = 10;
/// Places after a key's own at which it is looked for.
const PROBES: u32 = 8;
/// Share of the picture's height that a cell is wide where it is seen.
const WIDTH: f32 = 1.0 / 17.0;
/// How many times its cell's width a face must be away from a path's first surface, so that it looks like one there.
const LEAST_DISTANCE: f32 = 1.0;
/// Most samples that a cell remembers: its light follows what changes as quickly as that.
const MOST_SAMPLES: f32 = 128.0;

/// One cell; without life, and where nobody asked for it, it is free.
#[derive(Clone, Copy, Debug, Default)]
struct Cell {
    key: Key,
    /// Frames that it is kept if nobody asks.
    life: u32,
    /// Which of its voxels its rays leave: [`Request::voxel_code`] of the last frame, 0 where nobody asked.
    voxel_code: u32,
    /// [`Request::rank`] of who asked in this frame, the largest; 0 where nobody did.
    asked: u32,
    /// What its face sends on of the light that falls on it, were it white: a mean of samples.
    light: Vec3,
    /// How many samples that is a mean of.
    samples: f32,
}

/// The cells.
pub struct LightCache {
    cells: Vec<Cell>,
    /// Most cells that trace rays in one frame, about.
    budget: usize,
    /// What voxel codes of the last frame are scrambled by.
    scramble: u32,
}

impl LightCache {
    /// Cells of the default cache: 11 MB on devices.
    pub const CAPACITY: usize = 1 << 18;
    /// Cells that trace rays in one frame.
    pub const BUDGET: usize = 1 << 16;
    /// Room for those on devices: random numbers may choose a few more.
    pub const MOST_CHOSEN: usize = (1 << 16) + (1 << 13);

    /// One without cells, with room for `capacity` of them, a power of two.
    pub fn new(capacity: usize, budget: usize) -> Self {
        assert!(capacity.is_power_of_two(), "the capacity is a power of two");
        Self { cells: vec![Cell::default(); capacity], budget, scramble: 0 }
    }

    /// Number of cells that are alive.
    pub fn len(&self) -> usize {
        self.cells.iter().filter(|cell| cell.life > 0).count()
    }

    /// Whether none is.
    pub fn is_empty(&self) -> bool {
        self.cells.iter().all(|cell| cell.life == 0)
    }

    /// How large a cell is `distance` away from a camera that sees `view_angle` from top to bottom, world units.
    pub(crate) fn size(view_angle: f32, distance: f32) -> f32 {
        distance * view_angle * WIDTH
    }

    /// How far away a face must be from who asks for its cell, voxels.
    pub(crate) fn least_distance(request: &Request) -> f32 {
        LEAST_DISTANCE * request.key.width()
    }

    /// What a face sends on of the light that falls on it, were it white; `None` where nobody knows yet.
    pub fn light(&self, key: &Key) -> Option<Vec3> {
        let cell = &self.cells[self.find(key)?];
        (cell.samples > 0.0).then_some(cell.light)
    }

    /// The place of a cell.
    fn find(&self, key: &Key) -> Option<usize> {
        self.places(key).find(|&place| !self.cells[place].is_free() && self.cells[place].key == *key)
    }

    /// The places at which a cell may be.
    fn places(&self, key: &Key) -> impl Iterator<Item = usize> + use<> {
        let (first, mask) = (key.hash(), self.cells.len() - 1);
        (0..PROBES).map(move |probe| first.wrapping_add(probe) as usize & mask)
    }

    /// Takes what was asked for in a frame. Where there is no room, nobody learns of it: the path goes on without. To be called before `update`.
    pub fn insert(&mut self, requests: &[Request]) {
        for request in requests.iter().filter(|request| request.life > 0) {
            let free = || self.places(&request.key).find(|&place| self.cells[place].is_free());
            let Some(place) = self.find(&request.key).or_else(free) else { continue };
            let cell = &mut self.cells[place];
            if cell.is_free() {
                *cell = Cell { key: request.key, ..Cell::default() };
            }
            cell.asked = cell.asked.max(request.rank());
        }
    }

    /// Something changed: of what cells know, as much as `samples` counts beside what they learn. With none they know nothing until they traced rays.
    pub fn doubt(&mut self, samples: f32) {
        self.cells.iter_mut().for_each(|cell| cell.samples = cell.samples.min(samples));
    }

    /// Ends a frame, whose voxel codes were scrambled by `scramble`: adds what cells found, by their places, and lets them grow older.
    pub(crate) fn update(&mut self, found: &[(usize, Vec3)], scramble: u32) {
        self.scramble = scramble;
        for &(place, light) in found {
            let cell = &mut self.cells[place];
            cell.samples = (cell.samples + 1.0).min(MOST_SAMPLES);
            cell.light += (light - cell.light) / cell.samples;
        }
        for cell in &mut self.cells {
            cell.life = cell.life.saturating_sub(1).max(Request::life_of(cell.asked));
            cell.voxel_code = Request::code_of(cell.asked);
            cell.asked = 0;
        }
    }
}

impl Cell {
    /// Whether its place can be taken.
    fn is_free(&self) -> bool {
        self.life == 0 && self.asked == 0
    }
}
