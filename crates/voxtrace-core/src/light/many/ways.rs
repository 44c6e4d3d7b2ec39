//! Ways down a tree of lights, many at once, as arrays.

use crate::light::Receiver;
use crate::walk::simd::LANES;
use glam::Vec3;

/// Most ways at a time.
pub const CAPACITY: usize = 256;

/// Places of the quantities among the floats.
pub const POINT: usize = 0;
pub const NORMAL: usize = 3;
pub const SLACK: usize = 6;
/// What [`super::super::emitters::Descent`] has under these names.
pub const WEIGHT: usize = 7;
pub const TOTAL: usize = 8;
pub const CHOICE: usize = 9;
/// The random number that chooses within the node.
pub const WITHIN: usize = 10;
/// Probability of choosing an emitter at all.
pub const SHARE: usize = 11;
pub const FLOATS: usize = 12;
/// Once a side is chosen: the power on it of the node where the way ended, and what is left of the running sum of powers.
pub const POWER: usize = WITHIN;
pub const THRESHOLD: usize = CHOICE;
/// Places of the quantities among the integers. An inner node and its right child; of a leaf what it holds, and how many.
pub const NODE: usize = 0;
pub const INDEX: usize = 1;
pub const COUNT: usize = 2;
/// The side that was chosen.
pub const SIDE: usize = 3;
pub const INTEGERS: usize = 4;
/// In the end, in place of the node.
pub const EMITTER: usize = NODE;

/// One array for each quantity, a vector longer than there are ways, so that whole vectors can be read.
pub struct Ways {
    pub floats: [[f32; CAPACITY + LANES]; FLOATS],
    pub integers: [[i32; CAPACITY + LANES]; INTEGERS],
    pub count: usize,
}

impl Ways {
    /// None.
    pub fn none() -> Box<Self> {
        let (floats, integers) = ([[0.0; CAPACITY + LANES]; FLOATS], [[0; CAPACITY + LANES]; INTEGERS]);
        Box::new(Self { floats, integers, count: 0 })
    }

    /// Sets where way `index` leads from.
    #[inline]
    pub fn set_receiver(&mut self, index: usize, receiver: &Receiver) {
        for axis in 0..3 {
            self.floats[POINT + axis][index] = receiver.point[axis];
            self.floats[NORMAL + axis][index] = receiver.normal[axis];
        }
        self.floats[SLACK][index] = receiver.slack;
    }

    /// The place that way `index` leads from.
    #[inline]
    pub fn receiver(&self, index: usize) -> Receiver {
        let vector = |first: usize| Vec3::from_array(std::array::from_fn(|axis| self.floats[first + axis][index]));
        Receiver { point: vector(POINT), normal: vector(NORMAL), slack: self.floats[SLACK][index] }
    }
}
