//! The material that is most like another one, among as many as a scene can have: coarse levels bring thousands that find no place of their own.

use super::super::PackedMaterial;
use glam::Vec3;

/// What rounding may add to the square of a distance, as a share of it.
const SLACK: f64 = 0.999;

/// Materials by the sum of all that they are compared by. Two are never nearer to each other than their sums are, so that few have to be compared.
pub(super) struct NearestMaterial {
    sums: Vec<(f64, u16)>,
}

impl NearestMaterial {
    pub fn new(all: &[PackedMaterial]) -> Self {
        let mut sums: Vec<_> = all.iter().enumerate().map(|(number, own)| (sum(own), number as u16)).collect();
        sums.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { sums }
    }

    /// The number of the nearest one among those that this was made of, the first of equals.
    pub fn find(&self, all: &[PackedMaterial], material: &PackedMaterial) -> u16 {
        let wanted = sum(material);
        let middle = self.sums.partition_point(|&(sum, _)| sum < wanted);
        let (mut below, mut above) =
            (self.sums[..middle].iter().rev().peekable(), self.sums[middle..].iter().peekable());
        let mut best = (f32::INFINITY, 0);
        loop {
            let gaps = (below.peek().map(|(sum, _)| wanted - sum), above.peek().map(|(sum, _)| sum - wanted));
            let (gap, next) = match gaps {
                (Some(down), up) if up.is_none_or(|up| down <= up) => (down, below.next()),
                (_, Some(up)) => (up, above.next()),
                _ => break,
            };
            if gap * gap * SLACK > f64::from(best.0) {
                break;
            }
            let Some(&(_, number)) = next else { break };
            let distance = distance(&all[usize::from(number)], material);
            if distance < best.0 || (distance == best.0 && number < best.1) {
                best = (distance, number);
            }
        }
        best.1
    }
}

/// What materials are compared by.
fn features(material: &PackedMaterial) -> [Vec3; 3] {
    let kind = Vec3::new(material.transmission, material.metallic, material.roughness) * 4.0;
    [material.base_color, kind, material.emission]
}

/// All of them, by the square root of how many they are: how far along the diagonal of their space a material lies.
fn sum(material: &PackedMaterial) -> f64 {
    features(material).iter().flat_map(|part| part.to_array()).map(f64::from).sum::<f64>() / 3.0
}

/// The square of how far two are apart.
fn distance(one: &PackedMaterial, other: &PackedMaterial) -> f32 {
    features(one).into_iter().zip(features(other)).map(|(own, other)| (own - other).length_squared()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::Material;

    /// Colours, kinds and lamps by a little generator, many of them alike.
    fn materials(count: u32, seed: u32) -> Vec<PackedMaterial> {
        let mut state = seed;
        let mut next = |most: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((state >> 16) % most) as f32 / most as f32
        };
        let mut one = || {
            let color = Vec3::new(next(12), next(12), next(12));
            match next(8) {
                share if share < 0.2 => Material::metal(color, next(4)),
                share if share < 0.3 => Material::emissive(color * 40.0),
                _ => Material::diffuse(color),
            }
        };
        (0..count).map(|_| PackedMaterial::from(&one())).collect()
    }

    #[test]
    fn it_is_the_first_of_the_nearest_as_if_all_were_compared() {
        let all = materials(3000, 1);
        let nearest = NearestMaterial::new(&all);
        let mut exact = 0;
        for material in materials(500, 2) {
            let distances = all.iter().map(|own| distance(own, &material)).enumerate();
            let (number, least) = distances.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap();
            assert_eq!(usize::from(nearest.find(&all, &material)), number);
            exact += u32::from(least == 0.0);
        }
        assert!((50..450).contains(&exact), "{exact}: some are there themselves, others are not");
        assert_eq!(NearestMaterial::new(&[]).find(&[], &all[0]), 0);
    }
}
