//! The contenders of the benchmark: anything that finds the first voxel along rays. Here are our own walks.

use crate::ray_sets::{RaySet, WAVE};
use std::time::Duration;
use voxtrace::{Hit, PackedScene, glam::IVec3};
use voxtrace_core::walk::{self, Instructions};

/// One way of finding the first voxel along rays, on the calling thread alone.
pub trait Contender {
    /// Name in the report.
    fn name(&self) -> String;

    /// Selects the fastest of the contender's methods for these rays. Returns its name.
    fn tune(&mut self, rays: &RaySet) -> &'static str;

    /// Casts the rays in their order and keeps the hits. This is timed.
    fn cast(&mut self, rays: &RaySet);

    /// The voxel that a ray of the last cast met, and where on the ray.
    fn found(&self, ray: usize) -> Option<(IVec3, f32)>;

    /// Bytes by kind: everything needed to cast rays and to look up the materials of their hits, without lights.
    fn memory(&self) -> Vec<(&'static str, u64)>;

    /// Time and memory that building the structure took, for people.
    fn build(&self) -> String;
}

/// A walk of this library.
pub struct Walk<'a> {
    scene: &'a PackedScene,
    pack_time: Duration,
    /// Those of a batch; `None` for the reference, ray after ray.
    instructions: Option<Instructions>,
    hits: Vec<Hit>,
}

impl<'a> Walk<'a> {
    /// The walk of one ray after the other, which is the plain reference.
    pub fn reference(scene: &'a PackedScene, pack_time: Duration) -> Self {
        Self { scene, pack_time, instructions: None, hits: Vec::new() }
    }

    /// Batches by some instructions.
    pub fn by(scene: &'a PackedScene, pack_time: Duration, instructions: Instructions) -> Self {
        Self { scene, pack_time, instructions: Some(instructions), hits: Vec::new() }
    }

    /// The reference, then all batches that this processor can do, the one that the renderer uses first.
    pub fn all(scene: &'a PackedScene, pack_time: Duration) -> Vec<Self> {
        let batches = Instructions::ALL.into_iter().filter(|instructions| instructions.is_available());
        let batches = batches.map(|instructions| Self::by(scene, pack_time, instructions));
        std::iter::once(Self::reference(scene, pack_time)).chain(batches).collect()
    }
}

impl Contender for Walk<'_> {
    fn name(&self) -> String {
        match self.instructions {
            None => "voxtrace `walk::cast`".to_owned(),
            Some(instructions) => format!("voxtrace `walk::cast_batch`, {}", instructions.name()),
        }
    }

    fn tune(&mut self, rays: &RaySet) -> &'static str {
        self.hits.clear();
        self.hits.resize(rays.rays.len(), Hit::MISS);
        self.instructions.map_or("one by one", Instructions::name)
    }

    fn cast(&mut self, rays: &RaySet) {
        if let Some(instructions) = self.instructions {
            for (rays, hits) in rays.rays.chunks(WAVE).zip(self.hits.chunks_mut(WAVE)) {
                walk::cast_batch_with(instructions, self.scene, rays, hits);
            }
        } else {
            for (ray, hit) in rays.rays.iter().zip(&mut self.hits) {
                *hit = walk::cast(self.scene, ray);
            }
        }
    }

    fn found(&self, ray: usize) -> Option<(IVec3, f32)> {
        let hit = &self.hits[ray];
        (!hit.is_miss()).then_some((hit.voxel, hit.t))
    }

    fn memory(&self) -> Vec<(&'static str, u64)> {
        self.scene.statistics().bytes.into_iter().filter(|(kind, _)| *kind != "lights").collect()
    }

    fn build(&self) -> String {
        format!("packed in {:.1} s on all cores", self.pack_time.as_secs_f64())
    }
}
