//! Interleaved measurement: in each round every contender casts the same rays, so that disturbances by other processes affect
//! all of them, and their hits are compared.

use crate::clock;
use crate::contender::Contender;
use crate::ray_sets::RaySet;
use voxtrace::glam::IVec3;

/// The measurement of one contender on one set of rays.
pub struct Measured {
    /// The way in which it cast them.
    pub way: &'static str,
    /// Millions of rays per second in each round.
    pub mrays: Vec<f64>,
    /// Number of rays whose hit differs from the first contender's, in voxel or in place.
    pub mismatches: usize,
}

/// Measures all contenders on one set of rays. One untimed pass, in which the hits are compared with those of the first
/// contender, goes before the rounds.
pub fn measure(contenders: &mut [Box<dyn Contender + '_>], set: &RaySet, rounds: usize) -> Vec<Measured> {
    let mut measured = Vec::new();
    for index in 0..contenders.len() {
        let way = contenders[index].tune(set);
        contenders[index].cast(set);
        let differs = |&ray: &usize| !agree(contenders[0].found(ray), contenders[index].found(ray));
        let mismatches = (0..set.rays.len()).filter(differs).count();
        measured.push(Measured { way, mrays: Vec::new(), mismatches });
    }
    for round in 0..rounds {
        for turn in 0..contenders.len() {
            let index = (round + turn) % contenders.len();
            let time = clock::time(|| contenders[index].cast(set));
            measured[index].mrays.push(set.rays.len() as f64 / time.as_secs_f64() / 1e6);
        }
    }
    measured
}

/// Whether two hits agree: the same voxel, at the same place to a hundredth of a voxel.
fn agree(a: Option<(IVec3, f32)>, b: Option<(IVec3, f32)>) -> bool {
    match (a, b) {
        (Some((a, t_of_a)), Some((b, t_of_b))) => a == b && (t_of_a - t_of_b).abs() < 0.01,
        (None, None) => true,
        _ => false,
    }
}

/// The median, the least and the largest of the values.
pub fn spread(values: impl Iterator<Item = f64>) -> [f64; 3] {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    [(values[(values.len() - 1) / 2] + values[values.len() / 2]) / 2.0, values[0], values[values.len() - 1]]
}
