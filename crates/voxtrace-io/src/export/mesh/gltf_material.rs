//! Materials as glTF 2.0 says them, with the ratified extensions for light, glass and what is within it.

use glam::Vec3;
use serde_json::{Map, Value, json};
use voxtrace_scene::material::Material;

/// Whether a material is nothing but a matte colour, which vertices can carry.
pub fn is_plain(material: &Material) -> bool {
    *material == Material::diffuse(material.base_color)
}

/// The material of everything that is nothing but a matte colour.
pub fn colors() -> Value {
    json!({ "name": "colors", "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 1.0 } })
}

/// A material in a scene whose light is `intensity` times as strong and whose voxels are `edge` metres long.
pub fn of(material: &Material, index: u16, intensity: f32, edge: f64) -> Value {
    let [red, green, blue] = material.base_color.to_array();
    let mut extensions = Map::new();
    let mut add = |name: &str, value: Value| extensions.insert(name.into(), value);
    let emission = material.emission * intensity;
    let strength = emission.max_element().max(1.0);
    if strength > 1.0 {
        add("KHR_materials_emissive_strength", json!({ "emissiveStrength": strength }));
    }
    if material.transmission > 0.0 {
        add("KHR_materials_transmission", json!({ "transmissionFactor": material.transmission }));
        add("KHR_materials_ior", json!({ "ior": material.ior }));
    }
    let densest = material.absorption.max_element();
    if densest > 0.0 {
        // The way on which the colour that is absorbed most falls to 1 / e.
        let color = (-material.absorption / densest).exp().to_array();
        let distance = edge / f64::from(densest);
        let volume = json!({ "thicknessFactor": edge, "attenuationDistance": distance, "attenuationColor": color });
        add("KHR_materials_volume", volume);
    }
    // Without it a surface shines as far as it is smooth.
    let usual = if material.roughness < 1.0 { 1.0 } else { 0.0 };
    if material.specular != usual && material.metallic < 1.0 {
        add("KHR_materials_specular", json!({ "specularFactor": material.specular }));
    }
    let mut value = json!({
        "name": format!("material_{index}"),
        "pbrMetallicRoughness": {
            "baseColorFactor": [red, green, blue, 1.0],
            "metallicFactor": material.metallic,
            "roughnessFactor": material.roughness,
        },
    });
    if emission != Vec3::ZERO {
        value["emissiveFactor"] = json!((emission / strength).to_array());
    }
    if !extensions.is_empty() {
        value["extensions"] = extensions.into();
    }
    value
}

/// The names of all extensions that materials have.
pub fn extensions_of(materials: &[Value]) -> Vec<String> {
    let names = materials.iter().filter_map(|material| material["extensions"].as_object()).flat_map(Map::keys);
    let mut names: Vec<String> = names.cloned().collect();
    names.sort();
    names.dedup();
    names
}
