//! What a glTF document holds that scenes do not have: motion of shapes, lights, maps of normals and occlusion, and extensions that nothing here knows.

use super::KNOWN;
use super::document::Document;
use crate::import::reader::NotShown;

/// Extensions of materials that are read, see `material_json`.
const OF_MATERIALS: [&str; 7] = [
    "KHR_materials_emissive_strength",
    "KHR_materials_transmission",
    "KHR_materials_ior",
    "KHR_materials_volume",
    "KHR_materials_specular",
    "KHR_materials_clearcoat",
    "KHR_materials_pbrSpecularGlossiness",
];

/// The parts of a document that are not shown; one of its animations may be, which bends so many skins.
pub(super) fn parts(document: &Document, is_played: bool, bent_skins: u64) -> NotShown {
    let mut parts = NotShown::default();
    parts.count("animation", document.animations.len() as u64 - u64::from(is_played));
    parts.count("skin", bent_skins);
    let primitives = || document.meshes.iter().flat_map(|mesh| &mesh.primitives);
    parts.count("morph target", primitives().map(|primitive| primitive.targets.len() as u64).sum());
    parts.count("light", document.extensions.lights.as_ref().map_or(0, |own| own.lights.len() as u64));
    let count = |has: fn(&super::document::Material) -> bool| {
        document.materials.iter().filter(|material| has(material)).count() as u64
    };
    parts.count("normal map", count(|material| material.normal_texture.is_some()));
    parts.count("occlusion map", count(|material| material.occlusion_texture.is_some()));
    let is_read = |name: &&String| KNOWN.contains(&name.as_str()) || OF_MATERIALS.contains(&name.as_str());
    document.extensions_used.iter().filter(|name| !is_read(name)).for_each(|name| parts.name(name));
    parts
}
