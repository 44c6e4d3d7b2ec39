//! Which voxels there are, and which of the empty ones nothing reaches from outside: scans are often read without what nobody sees in them, and a hollow
//! solid has the normals of a whole one.

use glam::IVec3;
use rustc_hash::FxHashMap;

/// Which voxels of bricks there are: the occupancy of each, by its coordinates in bricks.
pub type Occupancy = FxHashMap<IVec3, [u64; 8]>;

/// Most bricks of the box around a grid in which enclosed voxels are looked for; in larger ones all that are empty count as air.
const MOST_BRICKS: i64 = 1 << 26;
/// Columns of a layer with the lowest and the highest x.
const LOW_X: u64 = 0x0101_0101_0101_0101;
const HIGH_X: u64 = LOW_X << 7;

/// A brick as layers along z, bit x + 8·y of each.
type Layers = [u64; 8];

/// The voxels of a grid and what they enclose.
pub struct Shape<'a> {
    voxels: &'a Occupancy,
    /// Bricks with voxels that enclose some: both together.
    filled: Occupancy,
    /// Lowest brick of the box, and its bricks along each axis.
    low: IVec3,
    size: IVec3,
    /// Of each brick of the box whether air fills it; empty where that is not known.
    is_air: Vec<bool>,
    has_enclosed: bool,
}

impl<'a> Shape<'a> {
    /// Looks for what the voxels enclose.
    pub fn new(voxels: &'a Occupancy) -> Self {
        let (mut low, mut high) = (IVec3::MAX, IVec3::MIN);
        for &at in voxels.keys() {
            (low, high) = (low.min(at), high.max(at));
        }
        let mut shape =
            Self { voxels, filled: Occupancy::default(), low, size: IVec3::ZERO, is_air: vec![], has_enclosed: false };
        if voxels.is_empty() {
            return shape;
        }
        (shape.low, shape.size) = (low - 1, high - low + 3);
        if shape.size.as_i64vec3().element_product() <= MOST_BRICKS {
            shape.flood();
        }
        shape
    }

    /// Whether there is anything that the voxels enclose.
    pub fn has_enclosed(&self) -> bool {
        self.has_enclosed
    }

    /// The voxels of a brick.
    pub fn voxels(&self, at: IVec3) -> Option<[u64; 8]> {
        self.voxels.get(&at).copied()
    }

    /// The voxels of a brick and those that are enclosed.
    pub fn solid(&self, at: IVec3) -> Option<[u64; 8]> {
        if let Some(masks) = self.filled.get(&at).or_else(|| self.voxels.get(&at)) {
            return Some(*masks);
        }
        let is_enclosed = self.index(at).is_some_and(|index| self.is_air.get(index) == Some(&false));
        is_enclosed.then_some([u64::MAX; 8])
    }

    fn index(&self, at: IVec3) -> Option<usize> {
        let place = at - self.low;
        let is_within = place.cmpge(IVec3::ZERO).all() && place.cmplt(self.size).all();
        let [x, y, z] = place.to_array().map(|place| place as usize);
        is_within.then(|| (z * self.size.y as usize + y) * self.size.x as usize + x)
    }

    /// Lets air in at a corner of the box, which is empty.
    fn flood(&mut self) {
        self.is_air = vec![false; self.size.as_i64vec3().element_product() as usize];
        // Of each brick with voxels what is free, and what of that is air.
        let free = |masks: &[u64; 8]| (layers_of(masks).map(|layer| !layer), [0; 8]);
        let mut parts: FxHashMap<IVec3, (Layers, Layers)> =
            self.voxels.iter().map(|(&at, masks)| (at, free(masks))).collect();
        self.is_air[0] = true;
        let mut waiting = vec![self.low];
        while let Some(at) = waiting.pop() {
            let air = parts.get(&at).map_or([u64::MAX; 8], |(_, air)| *air);
            for axis in 0..3 {
                for is_up in [false, true] {
                    let mut next = at;
                    next[axis] += if is_up { 1 } else { -1 };
                    let Some(index) = self.index(next) else { continue };
                    let enters = through(&air, axis, is_up);
                    if let Some((free, air)) = parts.get_mut(&next) {
                        if spread(free, air, &enters) {
                            waiting.push(next);
                        }
                    } else if !self.is_air[index] && enters != [0; 8] {
                        self.is_air[index] = true;
                        waiting.push(next);
                    }
                }
            }
        }
        for (at, (free, air)) in parts {
            if free != air {
                self.filled.insert(at, masks_of(&air.map(|layer| !layer)));
                self.has_enclosed = true;
            }
            if let Some(index) = self.index(at) {
                self.is_air[index] = true;
            }
        }
        self.has_enclosed |= self.is_air.contains(&false);
    }
}

/// What gets through a face of a brick into the next one.
fn through(air: &Layers, axis: usize, is_up: bool) -> Layers {
    match (axis, is_up) {
        (0, false) => air.map(|layer| (layer & LOW_X) << 7),
        (0, true) => air.map(|layer| (layer & HIGH_X) >> 7),
        (1, false) => air.map(|layer| layer << 56),
        (1, true) => air.map(|layer| layer >> 56),
        (_, false) => std::array::from_fn(|z| if z == 7 { air[0] } else { 0 }),
        (_, true) => std::array::from_fn(|z| if z == 0 { air[7] } else { 0 }),
    }
}

/// Spreads what enters through the free voxels of a brick; whether there is more than before.
fn spread(free: &Layers, air: &mut Layers, enters: &Layers) -> bool {
    let mut now: Layers = std::array::from_fn(|z| air[z] | enters[z] & free[z]);
    if now == *air {
        return false;
    }
    loop {
        let next: Layers = std::array::from_fn(|z| {
            let layer = now[z];
            let across = (layer & !HIGH_X) << 1 | (layer & !LOW_X) >> 1 | layer << 8 | layer >> 8;
            let along = if z > 0 { now[z - 1] } else { 0 } | if z < 7 { now[z + 1] } else { 0 };
            layer | (across | along) & free[z]
        });
        if next == now {
            *air = now;
            return true;
        }
        now = next;
    }
}

/// Where the row of four voxels (y, z) of a block is: its layer, and its first bit there.
fn row(block: usize, y: usize, z: usize) -> (usize, usize) {
    ((block >> 2) * 4 + z, (block & 1) * 4 + 8 * ((block >> 1 & 1) * 4 + y))
}

/// From blocks of 4³ voxels to layers.
fn layers_of(masks: &[u64; 8]) -> Layers {
    let mut layers = [0; 8];
    for (block, mask) in masks.iter().enumerate() {
        for place in 0..16 {
            let (layer, bit) = row(block, place & 3, place >> 2);
            layers[layer] |= (mask >> (4 * place) & 0xf) << bit;
        }
    }
    layers
}

/// From layers to blocks of 4³ voxels.
fn masks_of(layers: &Layers) -> [u64; 8] {
    let mut masks = [0; 8];
    for (block, mask) in masks.iter_mut().enumerate() {
        for place in 0..16 {
            let (layer, bit) = row(block, place & 3, place >> 2);
            *mask |= (layers[layer] >> bit & 0xf) << (4 * place);
        }
    }
    masks
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::brick::{block_bit, block_index};

    #[test]
    fn layers_and_blocks_are_the_same_voxels() {
        for place in 0..512 {
            let local = IVec3::new(place & 7, place >> 3 & 7, place >> 6);
            let mut masks = [0; 8];
            masks[block_index(local)] = 1 << block_bit(local);
            let layers = layers_of(&masks);
            assert_eq!(layers[local.z as usize], 1 << (local.x + 8 * local.y));
            assert_eq!(masks_of(&layers), masks);
        }
    }

    #[test]
    fn what_a_shell_encloses_is_solid_unless_there_is_a_hole() {
        let shell = |has_hole: bool| {
            let mut voxels = Occupancy::default();
            for place in 0..40 * 40 * 40 {
                let voxel = IVec3::new(place % 40, place / 40 % 40, place / 1600) - 20;
                let is_wall = voxel.abs().max_element() == 19;
                if is_wall && !(has_hole && voxel == IVec3::new(19, 3, -4)) {
                    let local = voxel & 7;
                    voxels.entry(voxel >> 3).or_default()[block_index(local)] |= 1 << block_bit(local);
                }
            }
            voxels
        };
        for has_hole in [false, true] {
            let voxels = shell(has_hole);
            let shape = Shape::new(&voxels);
            assert_eq!(shape.has_enclosed(), !has_hole);
            let is_solid = |voxel: IVec3| {
                let local = voxel & 7;
                shape.solid(voxel >> 3).is_some_and(|masks| masks[block_index(local)] >> block_bit(local) & 1 == 1)
            };
            for voxel in [IVec3::ZERO, IVec3::splat(18), IVec3::new(-18, 5, 9)] {
                assert_eq!(is_solid(voxel), !has_hole, "{voxel}");
            }
            assert!(is_solid(IVec3::splat(19)) && !is_solid(IVec3::new(-20, 0, 0)) && !is_solid(IVec3::splat(100)));
        }
    }
}
