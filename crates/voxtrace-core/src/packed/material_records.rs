//! Materials as native files have them: ten numbers for each, and six more for each where one of them is not what a matte surface has.
//! So files of matte scenes stay as they were before there were others, and files from before are read.

use super::PackedMaterial;
use bytemuck::{Pod, Zeroable};
use glam::Vec3;
use voxtrace_scene::Invalid;
use voxtrace_scene::material::Material;

/// The section `MATS`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct SurfaceRecord {
    base_color: Vec3,
    roughness: f32,
    emission: Vec3,
    metallic: f32,
    transmission: f32,
    ior: f32,
}

/// The section `MEDI`: coat and medium of each material.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub(super) struct MediumRecord {
    specular: f32,
    anisotropy: f32,
    absorption: Vec3,
    scattering: f32,
}

/// Both sections; the second is empty where it says nothing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MaterialRecords {
    pub surfaces: Vec<SurfaceRecord>,
    pub media: Vec<MediumRecord>,
}

impl MaterialRecords {
    pub fn of(materials: &[PackedMaterial]) -> Self {
        let surface = |material: &PackedMaterial| {
            let PackedMaterial { base_color, roughness, emission, metallic, transmission, ior, .. } = *material;
            SurfaceRecord { base_color, roughness, emission, metallic, transmission, ior }
        };
        let medium = |material: &PackedMaterial| {
            let PackedMaterial { specular, anisotropy, absorption, scattering, .. } = *material;
            MediumRecord { specular, anisotropy, absorption, scattering }
        };
        let mut media: Vec<MediumRecord> = materials.iter().map(medium).collect();
        if media.iter().all(|record| *record == MediumRecord::zeroed()) {
            media.clear();
        }
        Self { surfaces: materials.iter().map(surface).collect(), media }
    }

    /// # Errors
    /// One sentence where the sections do not fit.
    pub fn materials(surfaces: &[SurfaceRecord], media: &[MediumRecord]) -> Result<Vec<PackedMaterial>, Invalid> {
        if !media.is_empty() && media.len() != surfaces.len() {
            return Err("there are not as many media as materials".into());
        }
        let media = media.iter().copied().chain(std::iter::repeat(MediumRecord::zeroed()));
        let material = |(surface, medium): (&SurfaceRecord, MediumRecord)| {
            let SurfaceRecord { base_color, roughness, emission, metallic, transmission, ior } = *surface;
            let MediumRecord { specular, anisotropy, absorption, scattering } = medium;
            PackedMaterial {
                base_color,
                roughness,
                emission,
                metallic,
                transmission,
                ior,
                specular,
                anisotropy,
                absorption,
                scattering,
            }
        };
        Ok(surfaces.iter().zip(media).map(material).collect())
    }
}

impl From<&Material> for PackedMaterial {
    fn from(material: &Material) -> Self {
        Self {
            base_color: material.base_color,
            roughness: material.roughness,
            emission: material.emission,
            metallic: material.metallic,
            transmission: material.transmission,
            ior: material.ior,
            specular: material.specular,
            anisotropy: material.anisotropy,
            absorption: material.absorption,
            scattering: material.scattering,
        }
    }
}
