//! Materials of a .vox file: MATL (since MagicaVoxel 0.99) and MATT (before).
//!
//! The format text names the keys and leaves their meaning to the program. What voxtrace takes them to be:
//! - the palette's colour (sRGB) is the base colour; a type uses only its own keys, others are left-overs of an editor;
//! - `_diffuse`, `_media` (clouds) and unknown types are diffuse surfaces;
//! - `_emit` emits base colour × `_emit` × 10^`_flux` (`_flux`, "Power", counts powers of ten from 0 to 4);
//! - `_metal` has `_metal` and `_rough`, `_glass` has `_trans` (older: `_alpha`), `_rough` and `_ri`, `_blend` has all;
//! - `_weight` stands for the type's own key in MagicaVoxel 0.99.0 to 0.99.4; `_ior` is the refractive index − 1.

use super::{attributes::Attributes, document::OldMaterial, light::factor_of_light};
use glam::Vec3;
use voxtrace_scene::material::Material;
use voxtrace_voxelize::ImportError;

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
        Ok(Material { roughness, ior: at_least_one(ior), ..diffuse })
    };
    let transparency = || -> Result<f64, ImportError> {
        Ok(attributes.float("_trans")?.or(attributes.float("_alpha")?).or(weight).unwrap_or(0.0))
    };
    Ok(match kind {
        b"_emit" => {
            let power = attributes.float("_flux")?.unwrap_or(0.0);
            Material { emission: emission(base, own("_emit")?, power), ..diffuse }
        }
        b"_metal" => Material { metallic: unit(own("_metal")?), ..surface()? },
        b"_glass" => Material { transmission: unit(transparency()?), ..surface()? },
        b"_blend" => {
            let metallic = unit(attributes.float("_metal")?.unwrap_or(0.0));
            Material { metallic, transmission: unit(transparency()?), ..surface()? }
        }
        _ => diffuse,
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
        ..diffuse
    };
    let weight = f64::from(old.weight);
    match old.kind {
        1 => Material { metallic: unit(weight), ..surface },
        2 => Material { transmission: unit(weight), ..surface },
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
