//! Whether a cell finds the right voxels: the ray through the middle of each pixel, beside what the library's plain walk
//! finds, which tests hold against a walk in double precision.

use rayon::prelude::*;
use serde_json::{Value, json};
use voxtrace::glam::Vec2;
use voxtrace::{Frame, Hit, PackedScene, Ray, walk};

/// Part of the rays that may meet another voxel where shaders round as the driver likes: rays along edges.
pub const ROUNDING: f64 = 1e-4;

/// The rays of a picture and what they meet.
pub struct Reference {
    pub rays: Vec<Ray>,
    pub hits: Vec<Hit>,
    pub width: usize,
    pub height: usize,
}

impl Reference {
    pub fn of(scene: &PackedScene, frame: &Frame) -> Self {
        let (width, height) = (frame.width as usize, frame.height as usize);
        let camera = frame.camera.frame(frame.width, frame.height);
        let middle = |index: usize| Vec2::new((index % width) as f32 + 0.5, (index / width) as f32 + 0.5);
        let rays: Vec<Ray> = (0..width * height).into_par_iter().map(|index| camera.ray(middle(index))).collect();
        let hits = rays.par_iter().map(|ray| walk::cast(scene, ray)).collect();
        Self { rays, hits, width, height }
    }
}

/// Whether two hits are of the same voxel, or both of none.
pub fn is_same_voxel(a: &Hit, b: &Hit) -> bool {
    a.instance == b.instance && (a.is_miss() || a.voxel == b.voxel)
}

/// How many rays of a picture met something else than they should.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Conformance {
    pub rays: u64,
    /// Another voxel.
    pub wrong: u64,
    /// A voxel where there is none on the way.
    pub invented: u64,
    /// Nothing, although there is a voxel.
    pub missed: u64,
    /// The right voxel through another face.
    pub other_face: u64,
}

impl Conformance {
    pub fn of(reference: &Reference, hits: &[Hit]) -> Self {
        let mut counts = Self { rays: reference.rays.len() as u64, ..Self::default() };
        for (right, hit) in reference.hits.iter().zip(hits) {
            match (right.is_miss(), hit.is_miss()) {
                (true, true) => {}
                (true, false) => counts.invented += 1,
                (false, true) => counts.missed += 1,
                _ if !is_same_voxel(right, hit) => counts.wrong += 1,
                _ => counts.other_face += u64::from(right.face != hit.face),
            }
        }
        counts
    }

    /// Rays with another voxel than the right one.
    pub fn errors(&self) -> u64 {
        self.wrong + self.invented + self.missed
    }

    /// Their part of all rays.
    pub fn share(&self) -> f64 {
        self.errors() as f64 / self.rays.max(1) as f64
    }

    /// Whether the errors are no more than rounding explains; with `is_exact` there must be none.
    pub fn holds(&self, is_exact: bool) -> bool {
        if is_exact { self.errors() == 0 } else { self.share() <= ROUNDING }
    }

    pub fn json(&self) -> Value {
        json!({
            "rays": self.rays, "wrong": self.wrong, "invented": self.invented, "missed": self.missed,
            "other_face": self.other_face, "share": self.share(),
        })
    }

    pub fn from_json(value: &Value) -> Option<Self> {
        let count = |name: &str| value[name].as_u64();
        Some(Self {
            rays: count("rays")?,
            wrong: count("wrong")?,
            invented: count("invented")?,
            missed: count("missed")?,
            other_face: count("other_face")?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::IVec3;

    #[test]
    fn each_kind_of_error_is_counted_once() {
        let hit = |x: i32, face: u32| Hit { t: 1.0, instance: 0, voxel: IVec3::new(x, 0, 0), face };
        let right = [hit(1, 0), hit(2, 0), hit(3, 0), hit(4, 0), Hit::MISS, Hit::MISS];
        let reference = Reference {
            rays: vec![Ray::new(Default::default(), Default::default()); 6],
            hits: right.to_vec(),
            width: 3,
            height: 2,
        };
        assert_eq!(Conformance::of(&reference, &right), Conformance { rays: 6, ..Conformance::default() });
        // Planted: another voxel, another face, a hole, a voxel in the sky.
        let hits = [hit(7, 0), hit(2, 3), Hit::MISS, hit(4, 0), hit(9, 0), Hit::MISS];
        let counts = Conformance::of(&reference, &hits);
        assert_eq!(counts, Conformance { rays: 6, wrong: 1, invented: 1, missed: 1, other_face: 1 });
        assert_eq!((counts.errors(), counts.holds(false)), (3, false));
        assert_eq!(Conformance::from_json(&counts.json()), Some(counts));
        let rare = Conformance { rays: 1_000_000, wrong: 99, ..Conformance::default() };
        assert!(rare.holds(false) && !rare.holds(true));
    }
}
