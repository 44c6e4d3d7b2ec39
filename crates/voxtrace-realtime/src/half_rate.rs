//! Which pixels trace in a frame: all, or every other one in turns, like the fields of a chess board. The others know what they knew, or what the pixels around see.

use crate::path::Sample;

/// How many pixels trace a path in each frame.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rate {
    /// All.
    #[default]
    Full,
    /// Every other one in turns.
    Half,
}

/// The samples of a frame.
pub struct Samples<'a> {
    /// One for each pixel, row by row; nothing where it did not trace.
    pub samples: &'a [Sample],
    /// Size of the picture, pixels.
    pub size: [u32; 2],
    pub rate: Rate,
    /// Number of the frame.
    pub number: u32,
}

/// Steps to the neighbours of a pixel.
const NEIGHBOURS: [(i32, i32); 4] = [(-1, 0), (0, -1), (1, 0), (0, 1)];

impl Rate {
    /// Whether a pixel traces in a frame.
    pub fn traces(self, x: u32, y: u32, number: u32) -> bool {
        self == Self::Full || (x + y).wrapping_add(number).is_multiple_of(2)
    }
}

impl Samples<'_> {
    /// Whether a pixel traced.
    pub fn traced(&self, index: usize) -> bool {
        let [x, y] = self.position(index);
        self.rate.traces(x, y, self.number)
    }

    /// The sample of a pixel, or of one beside it where it did not trace: the first that shows something, another one first in each frame.
    pub fn at(&self, index: usize) -> Sample {
        if self.traced(index) {
            return self.samples[index];
        }
        let beside = (0..4).filter_map(|turn| self.neighbour(index, turn + self.number / 2));
        beside.fold(Sample::default(), |found, next| if found.shown.is_some() { found } else { next })
    }

    /// The samples of the neighbours of a pixel.
    pub fn beside(&self, index: usize) -> impl Iterator<Item = Sample> {
        (0..4).filter_map(move |which| self.neighbour(index, which))
    }

    /// The neighbour by the last two bits of a number, within the picture.
    fn neighbour(&self, index: usize, which: u32) -> Option<Sample> {
        let (dx, dy) = NEIGHBOURS[which as usize % 4];
        let [x, y] = self.position(index);
        let (x, y) = (x.checked_add_signed(dx)?, y.checked_add_signed(dy)?);
        (x < self.size[0] && y < self.size[1]).then(|| self.samples[(y * self.size[0] + x) as usize])
    }

    fn position(&self, index: usize) -> [u32; 2] {
        [index as u32 % self.size[0], index as u32 / self.size[0]]
    }
}
