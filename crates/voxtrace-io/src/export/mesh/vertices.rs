//! The corners of rectangles, each of which is a vertex once: a bit each in bricks of 8 × 8 × 8, so that its number is that of its brick's first
//! and how many bits are before its own.

use glam::IVec3;
use rustc_hash::FxHashMap;

/// Words of 64 bits in a brick, one for each layer.
const LAYERS: usize = 8;

/// One of the bricks in which there are corners.
pub struct Brick {
    /// Where it is, in bricks.
    place: IVec3,
    /// Which corners there are: a word for each z, from x = y = 0 on.
    layers: [u64; LAYERS],
    /// Corners in the bricks before it.
    before: u64,
}

/// A set of corners in the order of their numbers.
pub struct Vertices {
    bricks: Vec<Brick>,
    of_place: FxHashMap<IVec3, usize>,
}

impl Vertices {
    /// Of these corners, however often each comes.
    pub fn of(corners: impl Iterator<Item = IVec3>) -> Self {
        let mut all = Self { bricks: Vec::new(), of_place: FxHashMap::default() };
        let mut last = 0;
        for corner in corners {
            let (place, layer, bit) = parts(corner);
            // Corners that follow each other are mostly near each other.
            if all.bricks.get(last).is_none_or(|brick| brick.place != place) {
                last = *all.of_place.entry(place).or_insert_with(|| {
                    all.bricks.push(Brick { place, layers: [0; LAYERS], before: 0 });
                    all.bricks.len() - 1
                });
            }
            all.bricks[last].layers[layer] |= 1 << bit;
        }
        let mut before = 0;
        for brick in &mut all.bricks {
            brick.before = before;
            before += brick.count();
        }
        all
    }

    /// How many there are.
    pub fn count(&self) -> u64 {
        self.bricks.last().map_or(0, |last| last.before + last.count())
    }

    /// The number of a corner that is among them, from 0 on.
    pub fn number(&self, corner: IVec3) -> u64 {
        let (place, layer, bit) = parts(corner);
        let brick = &self.bricks[self.of_place[&place]];
        let whole: u32 = brick.layers[..layer].iter().map(|word| word.count_ones()).sum();
        brick.before + u64::from(whole + (brick.layers[layer] & ((1 << bit) - 1)).count_ones())
    }

    /// The bricks that hold them, in the order of their numbers.
    pub fn bricks(&self) -> &[Brick] {
        &self.bricks
    }
}

impl Brick {
    /// Its corners, in the order of their numbers.
    pub fn corners(&self) -> impl Iterator<Item = IVec3> {
        let first = self.place * LAYERS as i32;
        self.layers.iter().enumerate().flat_map(move |(z, &word)| {
            let bits = (0..64).filter(move |bit| word >> bit & 1 == 1);
            bits.map(move |bit| IVec3::new(bit & 7, bit >> 3, z as i32) + first)
        })
    }

    fn count(&self) -> u64 {
        self.layers.iter().map(|word| u64::from(word.count_ones())).sum()
    }
}

/// The brick of a corner, and the layer and the bit in it.
fn parts(corner: IVec3) -> (IVec3, usize, u32) {
    let within = corner & 7;
    (corner >> 3, within.z as usize, (within.y << 3 | within.x) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_corner_has_one_number_in_the_order_of_the_list() {
        let far = [IVec3::splat(-1), IVec3::new(1 << 20, -9, 7), IVec3::new(-8, 0, 1 << 29)];
        let near = (0..200).map(|i| IVec3::new(i % 17, i * 7 % 23 - 11, i / 9));
        let corners: Vec<IVec3> = far.into_iter().chain(near).chain(far).collect();
        let vertices = Vertices::of(corners.iter().copied());
        let listed: Vec<IVec3> = vertices.bricks().iter().flat_map(Brick::corners).collect();
        let distinct: std::collections::HashSet<IVec3> = corners.iter().copied().collect();
        assert_eq!((listed.len(), vertices.count()), (distinct.len(), distinct.len() as u64));
        for (number, &corner) in listed.iter().enumerate() {
            assert!(distinct.contains(&corner));
            assert_eq!(vertices.number(corner), number as u64);
        }
        assert_eq!(Vertices::of(std::iter::empty()).count(), 0);
    }
}
