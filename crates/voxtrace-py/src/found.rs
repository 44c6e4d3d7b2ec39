//! What rays met, as arrays. Rays are cast some at a time, so that what lies between the arrays of Python stays small, and every core makes its share of them.

use crate::errors::argument;
use numpy::IntoPyArray;
use numpy::ndarray::Array2;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
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
        ray: &(dyn Fn(usize) -> Ray + Sync),
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
        let (mut rays, mut hits) = (Vec::new(), Vec::new());
        for first in (0..count).step_by(AT_A_TIME) {
            if !wanted.load(Ordering::Relaxed) {
                break;
            }
            let end = (first + AT_A_TIME).min(count);
            (first..end).into_par_iter().with_min_len(CHUNK).map(ray).collect_into_vec(&mut rays);
            let is_sound = |ray: &Ray| ray.origin.is_finite() && ray.direction.is_finite() && !ray.t_max.is_nan();
            if !rays.par_iter().with_min_len(CHUNK).all(is_sound) {
                return Err(argument("rays are finite"));
            }
            hits.resize(rays.len(), Hit::MISS);
            if let Err(error) = tracer.cast_into(&rays, &mut hits) {
                return Ok(Err(error));
            }
            found.put(first..end, scene, &rays, &hits);
        }
        Ok(Ok(found))
    }

    fn put(&mut self, range: std::ops::Range<usize>, scene: &PackedScene, rays: &[Ray], hits: &[Hit]) {
        let places = (self.hit[range.clone()].par_iter_mut(), self.t[range.clone()].par_iter_mut());
        let vectors = (self.position[range.clone()].par_iter_mut(), self.normal[range.clone()].par_iter_mut());
        let names = (self.instance[range.clone()].par_iter_mut(), self.material[range.clone()].par_iter_mut());
        let voxels = self.voxel[range].par_iter_mut();
        let all = (places.0, places.1, vectors.0, vectors.1, voxels, names.0, names.1, rays, hits).into_par_iter();
        all.with_min_len(CHUNK).for_each(|(is_hit, t, position, normal, voxel, instance, material, ray, hit)| {
            *instance = hit.instance;
            if hit.is_miss() {
                (*t, *material) = (f32::INFINITY, u32::MAX);
                return;
            }
            (*is_hit, *t, *voxel) = (true, hit.t, hit.voxel.to_array());
            (*position, *normal) = (ray.at(hit.t).to_array(), scene.normal(hit).to_array());
            *material = scene.material_index(hit);
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
