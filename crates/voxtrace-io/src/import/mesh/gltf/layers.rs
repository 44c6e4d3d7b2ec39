//! Extensions of glTF materials that say more than a base surface, as the models that there are:
//! - `KHR_materials_volume`: where it is thick, its attenuation is what the inside absorbs (Beer's law; distances are those of the scene). A colour of
//!   the surface beside it is left out. A volume that is not thick is a sheet, whose colour tints as without it;
//! - `KHR_materials_specular`: factor times the largest channel of its colour is the weight of the coat over the diffuse surface;
//! - `KHR_materials_clearcoat`: the coat over the diffuse surface is the clear one as far as there is any, also its roughness. What it covers
//!   shines no more by itself, and metal has no coat.
//!
//! Textures of all of them are left out.

use super::document::MaterialExtensions;
use glam::Vec3;
use voxtrace_voxelize::mesh::MeshMaterial;

/// Darkest colour that a way through a medium may have.
const DARKEST: f32 = 1.0 / 16_777_216.0;

/// The material with what the extensions say; `None` where that is no number.
pub(super) fn layered(material: MeshMaterial, extensions: &MaterialExtensions) -> Option<MeshMaterial> {
    let mut material = material;
    if let Some(volume) = extensions.volume.as_ref().filter(|volume| volume.thickness_factor > 0.0) {
        let color = Vec3::from_array(volume.attenuation_color);
        let distance = volume.attenuation_distance.unwrap_or(f32::INFINITY);
        if !color.is_finite() || distance.is_nan() || distance <= 0.0 {
            return None;
        }
        let coefficient = |channel: f32| -channel.clamp(DARKEST, 1.0).ln() / distance;
        material.absorption = Some(Vec3::from_array(color.to_array().map(coefficient)));
    }
    if let Some(specular) = &extensions.specular {
        let weight = specular.specular_factor * Vec3::from_array(specular.specular_color_factor).max_element();
        material.coat = Some(unit(weight)?);
    }
    if let Some(clearcoat) = &extensions.clearcoat {
        let (weight, roughness) = (unit(clearcoat.clearcoat_factor)?, unit(clearcoat.clearcoat_roughness_factor)?);
        if weight > 0.0 && material.metallic < 1.0 {
            let own = material.coat.unwrap_or(if material.roughness < 1.0 { 1.0 } else { 0.0 });
            material.coat = Some(own.max(weight));
            material.roughness += (roughness - material.roughness) * weight;
        }
    }
    Some(material)
}

fn unit(value: f32) -> Option<f32> {
    value.is_finite().then(|| value.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the extensions of a material, as JSON, make of one.
    fn read(json: &str, material: MeshMaterial) -> Option<MeshMaterial> {
        layered(material, &serde_json::from_str(json).unwrap())
    }

    #[test]
    fn a_thick_volume_absorbs_and_a_thin_one_is_a_sheet() {
        let volume = |rest: &str| {
            let json = format!(r#"{{"KHR_materials_volume": {{{rest}}}}}"#);
            read(&json, MeshMaterial::default()).map(|material| material.absorption)
        };
        let found = volume(r#""thicknessFactor": 1, "attenuationDistance": 0.5, "attenuationColor": [1, 0.5, 0]"#);
        let found = found.unwrap().unwrap();
        // After half a unit, half of green is left.
        assert_eq!((found.x, (-found.y * 0.5).exp(), found.z > 30.0), (0.0, 0.5, true));
        assert_eq!(volume(r#""thicknessFactor": 1"#), Some(Some(Vec3::ZERO)), "clear");
        assert_eq!(volume(r#""attenuationDistance": 0.5, "attenuationColor": [1, 0.5, 0]"#), Some(None), "a sheet");
        assert_eq!(volume(r#""thicknessFactor": 1, "attenuationDistance": 0"#), None);
        assert_eq!(volume(r#""thicknessFactor": 1, "attenuationColor": [1e39, 0, 0]"#), None);
    }

    #[test]
    fn coats_come_from_the_specular_weight_and_from_the_clear_coat() {
        let rough = MeshMaterial { roughness: 0.8, ..MeshMaterial::default() };
        let coat = |json: &str, material: &MeshMaterial| {
            read(json, material.clone()).map(|material| (material.coat, material.roughness))
        };
        assert_eq!(coat("{}", &rough), Some((None, 0.8)));
        let specular = r#"{"KHR_materials_specular": {"specularFactor": 0.5, "specularColorFactor": [0.25, 0.5, 0]}}"#;
        assert_eq!(coat(specular, &rough), Some((Some(0.25), 0.8)));
        let clear = r#"{"KHR_materials_clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.125}}"#;
        assert_eq!(coat(clear, &rough), Some((Some(1.0), 0.125)));
        let half =
            r#"{"KHR_materials_specular": {"specularFactor": 0}, "KHR_materials_clearcoat": {"clearcoatFactor": 0.5}}"#;
        assert_eq!(coat(half, &rough), Some((Some(0.5), 0.4)));
        let metal = MeshMaterial { metallic: 1.0, ..rough.clone() };
        assert_eq!(coat(clear, &metal), Some((None, 0.8)), "metal has none");
        assert_eq!(coat(r#"{"KHR_materials_clearcoat": {}}"#, &rough), Some((None, 0.8)), "none at all");
        assert_eq!(coat(r#"{"KHR_materials_specular": {"specularFactor": 1e39}}"#, &rough), None);
    }
}
