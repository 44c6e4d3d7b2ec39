//! What rays met, as arrays. Rays are cast some at a time, so that what lies between the arrays of Python stays small, and every core makes its share of them.

use crate::errors::argument;
use numpy::IntoPyArray;
use numpy::ndarray::Array2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use voxtrace::glam::Vec3;
use voxtrace::{Hit, PackedScene, Ray, TraceError, Tracer};

/// Rays that are cast at a time: enough for a device, 64 bytes each with their hits.
const AT_A_TIME: usize = 1 << 20;
/// Rays of one task.
const CHUNK: usize = 1 << 12;

/// Arrays of one entry for each ray; zeros for misses, but for `t`, which is infinite, and `instance` and `material`, which are the largest number.
pub struct Found {
    hit: Vec<bool>,
    t: Vec<f32>,
    position: Vec<[f32; 3]>,
    normal: Vec<[f32; 3]>,
    voxel: Vec<[i32; 3]>,
    instance: Vec<u32>,
    material: Vec<u32>,
}

impl Found {
    /// Casts `count` rays; an exception where one of them is not finite. What was found so far where nobody wants more.
    pub fn by(
        tracer: &mut (dyn Tracer + Send),
        scene: &PackedScene,
        count: usize,
        ray: &(impl Fn(usize) -> Ray + Sync),
        wanted: &AtomicBool,
    ) -> PyResult<Result<Self, TraceError>> {
        let mut found = Self {
            hit: vec![false; count],
            t: vec![0.0; count],
            position: vec![[0.0; 3]; count],
            normal: vec![[0.0; 3]; count],
            voxel: vec![[0; 3]; count],
            instance: vec![0; count],
            material: vec![0; count],
        };
        let length = count.min(AT_A_TIME);
        let (mut rays, mut hits) = (vec![Ray::new(Vec3::ZERO, Vec3::ZERO); length], vec![Hit::MISS; length]);
        for first in (0..count).step_by(AT_A_TIME) {
            if !wanted.load(Ordering::Relaxed) {
                break;
            }
            let end = (first + AT_A_TIME).min(count);
            let (rays, hits) = (&mut rays[..end - first], &mut hits[..end - first]);
            let are_sound = rays.par_chunks_mut(CHUNK).enumerate().map(|(chunk, rays)| {
                let mut are_sound = true;
                for (index, place) in rays.iter_mut().enumerate() {
                    *place = ray(first + chunk * CHUNK + index);
                    are_sound &= place.origin.is_finite() & place.direction.is_finite() & !place.t_max.is_nan();
                }
                are_sound
            });
            if !are_sound.reduce(|| true, |a, b| a & b) {
                return Err(argument("rays are finite"));
            }
            if let Err(error) = tracer.cast_into(rays, hits) {
                return Ok(Err(error));
            }
            found.put(first..end, scene, rays, hits);
        }
        Ok(Ok(found))
    }

    fn put(&mut self, range: std::ops::Range<usize>, scene: &PackedScene, rays: &[Ray], hits: &[Hit]) {
        let distances = (self.hit[range.clone()].par_chunks_mut(CHUNK), self.t[range.clone()].par_chunks_mut(CHUNK));
        let vectors =
            (self.position[range.clone()].par_chunks_mut(CHUNK), self.normal[range.clone()].par_chunks_mut(CHUNK));
        let names =
            (self.instance[range.clone()].par_chunks_mut(CHUNK), self.material[range.clone()].par_chunks_mut(CHUNK));
        let voxels = self.voxel[range].par_chunks_mut(CHUNK);
        let given = (rays.par_chunks(CHUNK), hits.par_chunks(CHUNK));
        let all = (distances.0, distances.1, vectors.0, vectors.1, voxels, names.0, names.1, given.0, given.1);
        all.into_par_iter().for_each(|(is_hit, t, position, normal, voxel, instance, material, rays, hits)| {
            material.fill(u32::MAX);
            scene.material_indices(hits, material);
            for (index, (ray, hit)) in rays.iter().zip(hits).enumerate() {
                instance[index] = hit.instance;
                if hit.is_miss() {
                    t[index] = f32::INFINITY;
                    continue;
                }
                (is_hit[index], t[index], voxel[index]) = (true, hit.t, hit.voxel.to_array());
                (position[index], normal[index]) = (ray.at(hit.t).to_array(), scene.normal(hit).to_array());
            }
        });
    }

    pub fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let count = self.hit.len();
        let rows =
            |values: Vec<[f32; 3]>| Array2::from_shape_vec((count, 3), values.into_flattened()).map_err(argument);
        let voxels = Array2::from_shape_vec((count, 3), self.voxel.into_flattened()).map_err(argument)?;
        let found = PyDict::new(py);
        found.set_item("hit", self.hit.into_pyarray(py))?;
        found.set_item("t", self.t.into_pyarray(py))?;
        found.set_item("position", rows(self.position)?.into_pyarray(py))?;
        found.set_item("normal", rows(self.normal)?.into_pyarray(py))?;
        found.set_item("voxel", voxels.into_pyarray(py))?;
        found.set_item("instance", self.instance.into_pyarray(py))?;
        found.set_item("material", self.material.into_pyarray(py))?;
        Ok(found)
    }
}
