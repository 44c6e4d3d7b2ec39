//! A bit for each voxel of a brick, as eight layers along z: what lies beside voxels is then found for 64 of them at once.

use glam::IVec3;

/// Bit x + 8 y of layer z.
pub(super) type Layers = [u64; 8];

/// The voxels with x = 0 of a layer.
const LOWEST_X: u64 = 0x0101_0101_0101_0101;

/// Places of a brick in Morton order: x + 8 y + 64 z.
const PLACES: [u16; 512] = {
    let mut places = [0; 512];
    let mut key = 0;
    while key < 512 {
        let mut bit = 0;
        while bit < 3 {
            let (x, y, z) = (key >> (3 * bit) & 1, key >> (3 * bit + 1) & 1, key >> (3 * bit + 2) & 1);
            places[key] |= ((x | y << 3 | z << 6) << bit) as u16;
            bit += 1;
        }
        key += 1;
    }
    places
};

/// By the place of a voxel where it is in Morton order.
const KEYS: [u16; 512] = {
    let mut keys = [0; 512];
    let mut key = 0;
    while key < 512 {
        keys[PLACES[key] as usize] = key as u16;
        key += 1;
    }
    keys
};

/// From masks of the eight blocks of a brick.
pub(super) fn layers_of(masks: &[u64; 8]) -> Layers {
    std::array::from_fn(|z| {
        (0..4).fold(0, |layer, block| {
            let rows = masks[block | (z >> 2) << 2] >> (16 * (z & 3)) & 0xffff;
            let rows = (rows | rows << 8) & 0x00ff_00ff;
            let rows = (rows | rows << 4) & 0x0f0f_0f0f;
            layer | rows << (4 * (block & 1) + 32 * (block >> 1))
        })
    })
}

/// The places in front of each face, −x, +x, −y, +y, −z and +z, of the voxels of a brick that are not taken, by what takes them in the brick and in the
/// six beside it.
pub(super) fn uncovered(own: &Layers, beside: &[Layers; 6]) -> [Layers; 6] {
    [
        std::array::from_fn(|z| !((own[z] << 1) & !LOWEST_X | beside[0][z] >> 7 & LOWEST_X)),
        std::array::from_fn(|z| !(own[z] >> 1 & !(LOWEST_X << 7) | (beside[1][z] & LOWEST_X) << 7)),
        std::array::from_fn(|z| !(own[z] << 8 | beside[2][z] >> 56)),
        std::array::from_fn(|z| !(own[z] >> 8 | beside[3][z] << 56)),
        std::array::from_fn(|z| !if z > 0 { own[z - 1] } else { beside[4][7] }),
        std::array::from_fn(|z| !if z < 7 { own[z + 1] } else { beside[5][0] }),
    ]
}

/// The voxels that are set, in Morton order.
pub(super) fn in_morton_order(layers: &Layers) -> impl Iterator<Item = IVec3> {
    let mut sorted = [0u64; 8];
    for (z, &layer) in layers.iter().enumerate() {
        let mut left = layer;
        while left != 0 {
            let key = KEYS[64 * z + left.trailing_zeros() as usize];
            sorted[usize::from(key >> 6)] |= 1 << (key & 63);
            left &= left - 1;
        }
    }
    (0..8).flat_map(move |word| {
        let mut left: u64 = sorted[word];
        std::iter::from_fn(move || {
            let bit = (left != 0).then(|| left.trailing_zeros() as usize)?;
            left &= left - 1;
            let place = i32::from(PLACES[64 * word + bit]);
            Some(IVec3::new(place & 7, place >> 3 & 7, place >> 6))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::morton_order;
    use voxtrace_scene::brick::{BRICK_SIZE, block_bit, block_index};
    use voxtrace_scene::ray::FACES;

    #[test]
    fn faces_are_free_where_nothing_is_beside_them() {
        let mut random = crate::dynamic::tests::plain::Random(5);
        let mut some = || -> [u64; 8] {
            std::array::from_fn(|_| (0..8).fold(0, |word, _| word << 8 | u64::from(random.below(256))))
        };
        for _ in 0..20 {
            let (own, beside) = (some(), [(); 6].map(|()| some()));
            let is_set = |masks: &[u64; 8], at: IVec3| masks[block_index(at)] >> block_bit(at) & 1 == 1;
            let free = uncovered(&layers_of(&own), &beside.map(|masks| layers_of(&masks)));
            let all: Vec<IVec3> = in_morton_order(&[u64::MAX; 8]).collect();
            assert!(all.len() == 512 && all.is_sorted_by(|a, b| morton_order(*a, *b).is_lt()));
            let expected: Vec<IVec3> = all.iter().copied().filter(|&at| is_set(&own, at)).collect();
            assert_eq!(in_morton_order(&layers_of(&own)).collect::<Vec<_>>(), expected);
            for at in all {
                for (face, layers) in FACES.into_iter().zip(&free) {
                    let (next, inside) = (at + face.normal(), (at + face.normal()) & (BRICK_SIZE - 1));
                    let masks = if next == inside { &own } else { &beside[face as usize] };
                    let is_free = layers[at.z as usize] >> (at.x + 8 * at.y) & 1 == 1;
                    assert_eq!(is_free, !is_set(masks, inside), "{at} {face:?}");
                }
            }
        }
    }
}
