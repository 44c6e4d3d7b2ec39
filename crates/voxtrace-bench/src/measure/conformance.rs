//! Whether a cell finds the right voxels: the ray through the middle of each pixel, beside what the library's plain walk
//! finds, which tests hold against a walk in double precision.

use rayon::prelude::*;
use serde_json::{Value, json};
use voxtrace::glam::{DVec3, Vec2};
use voxtrace::{Frame, Hit, PackedScene, Ray};
use voxtrace_core::walk;

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
        let rays: Vec<Ray> =
            (0..width * height).into_par_iter().map(|index| camera.central_ray(middle(index))).collect();
        let hits = rays.par_iter().map(|ray| scene.hit_of_part(&walk::cast(scene, ray))).collect();
        Self { rays, hits, width, height }
    }
}

/// Whether two hits are of the same voxel, or both of none.
pub fn is_same_voxel(a: &Hit, b: &Hit) -> bool {
    a.instance == b.instance && (a.is_miss() || a.voxel == b.voxel)
}

/// How many rays of a picture met something else than they should.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    /// The farthest that a ray that met another voxel is from the nearest edge of one of the two, voxels. Rounding explains
    /// what lies on an edge.
    pub from_edge: f64,
}

/// How far, in voxels, from the nearest edge of its face a ray enters the voxel of `hit`; on the face of a cut, which no axis crosses, from its nearest
/// neighbour. Infinite where it hit nothing.
fn distance_from_edge(scene: &PackedScene, ray: &Ray, hit: &Hit) -> f64 {
    if hit.is_miss() {
        return f64::INFINITY;
    }
    let grid_from_world = scene.instance(hit).grid_from_world;
    let linear = grid_from_world.linear.as_dmat3();
    let origin = linear * ray.origin.as_dvec3() + grid_from_world.translation.as_dvec3();
    let direction = linear * ray.direction.as_dvec3();
    if hit.cut().is_some() {
        let point = origin + direction * f64::from(hit.t);
        return (point - point.round()).abs().min_element();
    }
    let axis = hit.face as usize / 2;
    let plane = f64::from(hit.voxel[axis] + (hit.face & 1) as i32);
    let point = origin + direction * ((plane - origin[axis]) / direction[axis]);
    let aside = (point - point.round()).abs();
    let apart =
        DVec3::from_array(std::array::from_fn(|other| if other == axis { f64::INFINITY } else { aside[other] }));
    apart.min_element()
}

impl Conformance {
    /// Counts the rays of a picture of `scene` whose `hits` are not those of the reference.
    pub fn of(scene: &PackedScene, reference: &Reference, hits: &[Hit]) -> Self {
        let mut counts = Self { rays: reference.rays.len() as u64, ..Self::default() };
        for ((ray, right), hit) in reference.rays.iter().zip(&reference.hits).zip(hits) {
            if !is_same_voxel(right, hit) {
                let distance = distance_from_edge(scene, ray, right).min(distance_from_edge(scene, ray, hit));
                counts.from_edge = counts.from_edge.max(distance);
            }
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
            "other_face": self.other_face, "share": self.share(), "from_edge": self.from_edge,
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
            // Reports of before it was measured lack it.
            from_edge: value["from_edge"].as_f64().unwrap_or(f64::NAN),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::glam::{IVec3, Vec3};
    use voxtrace::{Material, Scene, VoxelGrid};

    #[test]
    fn each_kind_of_error_is_counted_once() {
        let mut row = VoxelGrid::new();
        for x in 1..5 {
            row.set(IVec3::new(x, 0, 0), 0);
        }
        let scene = PackedScene::pack(&Scene::from_grid("row", row, vec![Material::default()])).unwrap();
        let hit = |x: i32, face: u32| Hit { t: 1.0, instance: 0, voxel: IVec3::new(x, 0, 0), face };
        let right = [hit(1, 5), hit(2, 5), hit(3, 5), hit(4, 5), Hit::MISS, Hit::MISS];
        // Down onto the row, a quarter of a voxel from an edge, but for the first, a tenth.
        let down = |x: f32| Ray::new(Vec3::new(x, 0.5, 9.0), Vec3::NEG_Z);
        let reference = Reference {
            rays: [1.9, 2.25, 3.25, 4.25, 5.25, 6.25].map(down).to_vec(),
            hits: right.to_vec(),
            width: 3,
            height: 2,
        };
        let of = |hits: &[Hit]| Conformance::of(&scene, &reference, hits);
        assert_eq!(of(&right), Conformance { rays: 6, ..Conformance::default() });
        // Planted: another voxel, another face, a hole, a voxel in the sky.
        let hits = [hit(2, 5), hit(2, 3), Hit::MISS, hit(4, 5), hit(4, 5), Hit::MISS];
        let counts = of(&hits);
        let few = Conformance { rays: 6, wrong: 1, invented: 1, missed: 1, other_face: 1, from_edge: counts.from_edge };
        assert_eq!(counts, few);
        assert!((counts.from_edge - 0.25).abs() < 1e-6, "{}", counts.from_edge);
        assert!((of(&[&hits[..1], &right[1..]].concat()).from_edge - 0.1).abs() < 1e-6);
        // A cut goes through a voxel where it likes.
        let cut = Hit { t: 8.6, face: Hit::FIRST_CUT, ..hit(2, 5) };
        assert!((of(&[&[cut], &right[1..]].concat()).from_edge - 0.1).abs() < 1e-6);
        assert_eq!((counts.errors(), counts.holds(false)), (3, false));
        assert_eq!(Conformance::from_json(&counts.json()), Some(counts));
        let rare = Conformance { rays: 1_000_000, wrong: 99, ..Conformance::default() };
        assert!(rare.holds(false) && !rare.holds(true));
    }
}
