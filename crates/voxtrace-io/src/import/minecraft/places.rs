//! Which block is where: sections of 16³ places, of which only those with blocks are kept. Directions are ours: x east, y north, z up.

use glam::IVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Blocks along an edge of a section.
pub(super) const SECTION: i32 = 16;
/// Blocks of a section.
pub(super) const BLOCKS: usize = 4096;

/// The states of a section by their number; 0 is nothing. x fastest, then y, then z.
pub(super) type Section = [u16; BLOCKS];

#[derive(Default)]
pub(super) struct Places {
    pub sections: FxHashMap<IVec3, Box<Section>>,
}

/// The place within its section, of a block's coordinates there.
pub(super) fn index(local: IVec3) -> usize {
    ((local.z * SECTION + local.y) * SECTION + local.x) as usize
}

/// The coordinates of a place within its section.
pub(super) fn local(index: usize) -> IVec3 {
    let index = index as i32;
    IVec3::new(index % SECTION, index / SECTION % SECTION, index / (SECTION * SECTION))
}

impl Places {
    /// Places of blocks in a box from the origin on. `state_at` gets the index of a place of the file: x fastest, then z (south), then y (up).
    pub fn of_box([width, height, length]: [usize; 3], state_at: impl Fn(usize) -> u16 + Sync) -> Self {
        let [across, deep, high] = [width, length, height].map(|edge| edge.div_ceil(SECTION as usize));
        let section = |number: usize| {
            let at = [number % across, number / across % deep, number / (across * deep)];
            let at = IVec3::from_array(at.map(|c| c as i32));
            let mut of = Box::new([0; BLOCKS]);
            let mut is_empty = true;
            for (place, state) in of.iter_mut().enumerate() {
                let [x, y, z] = (at * SECTION + local(place)).to_array().map(|c| c as usize);
                if x < width && y < length && z < height {
                    // South is −y: the last row of the file is the first of the grid.
                    *state = state_at((z * length + length - 1 - y) * width + x);
                    is_empty &= *state == 0;
                }
            }
            (!is_empty).then_some((at, of))
        };
        Self { sections: (0..across * deep * high).into_par_iter().filter_map(section).collect() }
    }

    /// The state at a place next to or in a section that is at hand.
    pub fn get(&self, section: IVec3, of: &Section, local: IVec3) -> u16 {
        if local.cmpge(IVec3::ZERO).all() && local.cmplt(IVec3::splat(SECTION)).all() {
            return of[index(local)];
        }
        let at = section * SECTION + local;
        let other = at.div_euclid(IVec3::splat(SECTION));
        self.sections.get(&other).map_or(0, |of| of[index(at - other * SECTION)])
    }

    /// The sections in the order of their places.
    pub fn sorted(&self) -> Vec<(IVec3, &Section)> {
        let mut sections: Vec<_> = self.sections.iter().map(|(at, of)| (*at, &**of)).collect();
        sections.sort_unstable_by_key(|(at, _)| (at.z, at.y, at.x));
        sections
    }
}
