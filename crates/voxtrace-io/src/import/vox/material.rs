//! Materials of a .vox file: MATL (since MagicaVoxel 0.99) and MATT (before).
//!
//! The format text names the keys and leaves their meaning to the program, whose light nobody else computes. What voxtrace takes them to be,
//! approximately:
//! - the palette's colour (sRGB) is the base colour; a type uses only its own keys, others are left-overs of an editor;
//! - `_diffuse` and unknown types are diffuse surfaces;
//! - `_emit` emits base colour × `_emit` × 10^`_flux` (`_flux`, "Power", counts powers of ten from 0 to 4);
//! - `_metal` has `_metal` and `_rough`, `_glass` has `_trans` (older: `_alpha`), `_rough` and `_ri`, `_blend` has all; what is neither metal nor
//!   glass is plastic. `_rough` is the roughness, whose square is the α of the microfacets;
//! - in glass white light has the base colour after 1 / `_d` voxels (`_d`, "Density", 0.05 where it is missing);
//! - `_media` is a volume without a surface. Where `_media_type` is `_absorb` (`_media` 0) it absorbs as glass does, otherwise light is scattered `_d`
//!   times in a voxel, and the base colour of it goes on, by the anisotropy `_g`; glass with a `_media_type` likewise. A volume of `_emit` (`_media` 2)
//!   absorbs `_d` in a voxel and glows within, where it is thick with the radiance of the base colour;
//! - `_weight` stands for the type's own key in MagicaVoxel 0.99.0 to 0.99.4; `_ior` is the refractive index − 1.

use super::{attributes::Attributes, document::OldMaterial, light::factor_of_light};
use glam::Vec3;
use voxtrace_scene::material::Material;
use voxtrace_voxelize::ImportError;

/// Keys of voxtrace's own, which MagicaVoxel ignores: weight of the coat, anisotropy, absorption (three numbers) and scattering of the medium.
pub const MEDIUM_KEYS: [&str; 4] = ["_vt_specular", "_vt_anisotropy", "_vt_absorption", "_vt_scattering"];

/// Density of a medium whose entry does not say it.
const DENSITY: f64 = 0.05;
/// Powers of ten that MATT's power, in [0, 1], spans.
const OLD_POWER_RANGE: f64 = 4.0;

/// The material of a MATL chunk whose palette entry has the linear colour `base`.
pub fn material_of(attributes: &Attributes, base: Vec3) -> Result<Material, ImportError> {
    let weight = attributes.float("_weight")?;
    let own = |key| -> Result<f64, ImportError> { Ok(attributes.float(key)?.or(weight).unwrap_or(0.0)) };
    let diffuse = Material::diffuse(base);
    let kind = attributes.dict.get("_type").unwrap_or_default();
    let surface = || -> Result<Material, ImportError> {
        let offset_ior = attributes.float("_ior")?.map(|ior| 1.0 + ior);
        let ior = attributes.float("_ri")?.or(offset_ior).unwrap_or(f64::from(diffuse.ior));
        let roughness = unit(attributes.float("_rough")?.unwrap_or(0.0));
        Ok(Material { roughness, ior: at_least_one(ior), specular: 1.0, ..diffuse })
    };
    let filled = |material: Material, always: bool| -> Result<Material, ImportError> {
        let density = attributes.float("_d")?.unwrap_or(DENSITY).clamp(0.0, 1e3) as f32;
        let anisotropy = attributes.float("_g")?.unwrap_or(0.0).clamp(-0.95, 0.95) as f32;
        let scatters = match (attributes.dict.get("_media_type"), attributes.dict.get("_media")) {
            (Some(kind), _) => kind != b"_absorb",
            (None, Some(number)) => number != b"0",
            (None, None) => always,
        };
        Ok(match scatters {
            true => Material { scattering: density, anisotropy, ..material },
            false if density > 0.0 => material.tinted(base, 1.0 / density),
            false => material,
        })
    };
    let transparency = || -> Result<f64, ImportError> {
        Ok(attributes.float("_trans")?.or(attributes.float("_alpha")?).or(weight).unwrap_or(0.0))
    };
    let material = match kind {
        b"_emit" => {
            let power = attributes.float("_flux")?.unwrap_or(0.0);
            Material { emission: emission(base, own("_emit")?, power), ..diffuse }
        }
        b"_metal" => Material { metallic: unit(own("_metal")?), ..surface()? },
        b"_glass" => filled(Material { transmission: unit(transparency()?), ..surface()? }, false)?,
        b"_blend" => {
            let metallic = unit(attributes.float("_metal")?.unwrap_or(0.0));
            filled(Material { metallic, transmission: unit(transparency()?), ..surface()? }, false)?
        }
        b"_media" if emits_within(attributes) => {
            let density = attributes.float("_d")?.unwrap_or(DENSITY).clamp(0.0, 1e3) as f32;
            Material::flame(base, density)
        }
        b"_media" => filled(Material { transmission: 1.0, ior: 1.0, roughness: 0.0, ..diffuse }, true)?,
        _ => diffuse,
    };
    with_own_keys(attributes, material)
}

/// Whether the medium of an entry emits light.
fn emits_within(attributes: &Attributes) -> bool {
    match (attributes.dict.get("_media_type"), attributes.dict.get("_media")) {
        (Some(kind), _) => kind == b"_emit",
        (None, number) => number == Some(b"2"),
    }
}

/// What voxtrace wrote into the entry beside MagicaVoxel's keys.
fn with_own_keys(attributes: &Attributes, material: Material) -> Result<Material, ImportError> {
    let [specular, anisotropy, absorption, scattering] = MEDIUM_KEYS;
    let own = |key: &str, least: f64, most: f64, read: f32| -> Result<f32, ImportError> {
        Ok(attributes.float(key)?.map_or(read, |value| value.clamp(least, most) as f32))
    };
    let coefficients = attributes.floats::<3>(absorption)?;
    Ok(Material {
        specular: own(specular, 0.0, 1.0, material.specular)?,
        anisotropy: own(anisotropy, -0.999, 0.999, material.anisotropy)?,
        absorption: coefficients
            .map_or(material.absorption, |values| Vec3::from_array(values.map(|value| value.clamp(0.0, 1e6) as f32))),
        scattering: own(scattering, 0.0, 1e6, material.scattering)?,
        ..material
    })
}

/// The material of a MATT chunk whose palette entry has the linear colour `base`. Properties are normalized to [0, 1].
pub fn old_material_of(old: &OldMaterial, base: Vec3) -> Material {
    let property = |bit: u32| {
        let before = (old.properties & ((1 << bit) - 1)).count_ones() as usize;
        (old.properties >> bit & 1 != 0).then(|| old.values.get(before).copied()).flatten().map(f64::from)
    };
    let diffuse = Material::diffuse(base);
    let surface = Material {
        roughness: unit(property(1).unwrap_or(0.0)),
        ior: property(3).map_or(diffuse.ior, |ior| at_least_one(1.0 + ior)),
        specular: 1.0,
        ..diffuse
    };
    let weight = f64::from(old.weight);
    match old.kind {
        1 => Material { metallic: unit(weight), ..surface },
        2 => Material { transmission: unit(weight), ..surface }.tinted(base, 1.0 / DENSITY as f32),
        3 => Material { emission: emission(base, weight, property(5).unwrap_or(0.0) * OLD_POWER_RANGE), ..diffuse },
        _ => diffuse,
    }
}

/// Emitted radiance: base colour × emit × 10^power.
fn emission(base: Vec3, emit: f64, power: f64) -> Vec3 {
    base * factor_of_light(emit * 10f64.powf(power))
}

fn unit(value: f64) -> f32 {
    value.clamp(0.0, 1.0) as f32
}

fn at_least_one(value: f64) -> f32 {
    value.clamp(1.0, 1e6) as f32
}
