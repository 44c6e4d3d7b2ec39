//! Light inside of voxels. The medium is a function of the position: that of the voxel there, so there is no stack of media and no order
//! among them, and nothing is between two voxels of one material. Where instances overlap, the one with the lowest index counts.
//!
//! Coefficients count voxels of the instance's grid; scattering has no colour, so distances are chosen alike for all channels (Pharr, Jakob
//! and Humphreys 2023, chapters 11 and 14).

pub mod phase;
mod shadow;
mod surrounding;
mod walk;

use crate::math::{exponential, logarithm};
use crate::packed::{PackedInstance, PackedMaterial, PackedScene};
use crate::surface::{Surface, clamp_to_voxel};
use glam::{IVec3, Vec3};
pub use shadow::{MAX_BOUNDARIES, Transit};
pub use surrounding::{RaysWithin, Surrounding};
use voxtrace_scene::ray::{Face, Hit, Ray};
pub use walk::cast_inside;

/// Below this optical depth absorption is taken from its series.
const FEW: f32 = 1.0 / 64.0;

/// The voxel that a path is in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// Index of the instance.
    pub instance: u32,
    /// The voxel, in the coordinates of its grid.
    pub voxel: IVec3,
    /// Index of the medium's material.
    pub material: u32,
}

impl Inside {
    /// Where a path is that goes through the face that it met; `None` in air.
    pub fn beyond(scene: &PackedScene, hit: &Hit) -> Option<Self> {
        let material = scene.material_beyond(hit)?;
        Some(Self { instance: hit.instance, voxel: hit.voxel, material })
    }

    /// Where a path is that stays in front of the face that it met at `surface`.
    pub fn in_front(&self, scene: &PackedScene, hit: &Hit, surface: &Surface) -> Option<Self> {
        if hit.instance != self.instance {
            return scene.medium_at(surface.origin);
        }
        // What leaves a cut names the last voxel within.
        let step = if hit.leaves_cut() { IVec3::ZERO } else { hit.face().normal() };
        Some(Self { voxel: hit.voxel + step, ..*self })
    }

    /// The material.
    pub fn medium<'a>(&self, scene: &'a PackedScene) -> &'a PackedMaterial {
        &scene.geometry.materials[self.material as usize]
    }

    /// Voxels in one unit of t of a ray.
    pub fn voxels_per_t(&self, scene: &PackedScene, ray: &Ray) -> f32 {
        self.placed(scene).grid_from_world.direction(ray.direction).length_squared().sqrt()
    }

    /// The point `ray.at(t)`, moved off the faces of this voxel into it.
    pub fn point(&self, scene: &PackedScene, ray: &Ray, t: f32) -> Vec3 {
        let placed = self.placed(scene);
        let point = placed.grid_from_world.point(ray.origin) + placed.grid_from_world.direction(ray.direction) * t;
        placed.world_from_grid.point(clamp_to_voxel(placed, self.voxel.as_vec3(), point))
    }

    fn placed<'a>(&self, scene: &'a PackedScene) -> &'a PackedInstance {
        &scene.placement.instances[self.instance as usize]
    }
}

impl PackedMaterial {
    /// Whether it is matte: a diffuse surface, which may emit.
    #[doc(hidden)]
    pub fn is_matte(&self) -> bool {
        self.metallic <= 0.0 && self.transmission <= 0.0 && self.specular <= 0.0
    }
}

impl PackedScene {
    /// Whether all materials are matte: diffuse surfaces, which may emit.
    pub fn is_matte(&self) -> bool {
        self.geometry.materials.iter().all(PackedMaterial::is_matte)
    }

    /// Whether light enters any material.
    pub fn has_media(&self) -> bool {
        self.geometry.materials.iter().any(|material| material.transmission > 0.0)
    }

    /// Index of the material behind the face that a path met, `None` for air: paths leave media there.
    pub fn material_beyond(&self, hit: &Hit) -> Option<u32> {
        if hit.leaves_cut() {
            return None;
        }
        let grid = &self.geometry.grids[self.placement.instances[hit.instance as usize].grid as usize];
        self.geometry.material_at(grid, hit.voxel)
    }

    /// The medium around a point, world space; `None` in air and in opaque voxels.
    pub fn medium_at(&self, point: Vec3) -> Option<Inside> {
        let (instance, voxel) = walk::voxel_at(self, point, None)?;
        let grid = &self.geometry.grids[self.placement.instances[instance as usize].grid as usize];
        let material = self.geometry.material_at(grid, voxel)?;
        let is_medium = self.geometry.materials[material as usize].transmission > 0.0;
        is_medium.then_some(Inside { instance, voxel, material })
    }
}

/// Share of light left after some voxels in a medium, without what scattering takes away.
#[inline]
pub fn attenuation(medium: &PackedMaterial, voxels: f32) -> Vec3 {
    let sigma = medium.absorption;
    Vec3::new(exponential(-(sigma.x * voxels)), exponential(-(sigma.y * voxels)), exponential(-(sigma.z * voxels)))
}

/// How many voxels of a medium a way of `voxels` counts for that which the medium emits, each channel: what is emitted farther away is absorbed on
/// the way, and (1 − e^−σx) / σ is left.
#[inline]
pub fn emitting_length(medium: &PackedMaterial, voxels: f32) -> Vec3 {
    let sigma = medium.absorption;
    let length = |sigma: f32| {
        let x = sigma * voxels;
        // The difference would cancel where little is absorbed.
        if x < FEW { voxels * (1.0 - x * (0.5 - x * (1.0 / 6.0))) } else { (1.0 - exponential(-x)) / sigma }
    };
    Vec3::new(length(sigma.x), length(sigma.y), length(sigma.z))
}

/// Share of light that some voxels of a medium do not scatter.
#[inline]
pub fn unscattered(medium: &PackedMaterial, voxels: f32) -> f32 {
    exponential(-(medium.scattering * voxels))
}

/// The way in voxels to the next scattering, for `u` uniform in [0, 1): infinite in clear media.
#[inline]
pub fn free_path(medium: &PackedMaterial, u: f32) -> f32 {
    if medium.scattering > 0.0 { -logarithm(1.0 - u) / medium.scattering } else { f32::INFINITY }
}

/// The face of an instance that looks most nearly along a direction of world space.
fn face_towards(placed: &PackedInstance, direction: Vec3) -> Face {
    let local = placed.grid_from_world.direction(direction);
    let size = local.abs();
    let axis = if size.x >= size.y && size.x >= size.z { 0 } else { 1 + usize::from(size.z > size.y) };
    voxtrace_scene::ray::FACES[2 * axis + usize::from(local[axis] > 0.0)]
}
