//! What a glTF document holds that scenes do not have: further animations, lights, maps of normals and occlusion, and extensions that nothing here knows.

use super::KNOWN;
use super::document::Document;
use super::skins;
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

/// The parts of a document that are not shown; one of its animations may be, at once or later.
pub(super) fn parts(document: &Document, is_played: bool) -> NotShown {
    let mut parts = NotShown::default();
    parts.count("animation", (document.animations.len() as u64).saturating_sub(u64::from(is_played)));
    let mut is_unbound = vec![false; document.skins.len()];
    for node in &document.nodes {
        let (Some(skin), Some(mesh)) = (node.skin, node.mesh.and_then(|mesh| document.meshes.get(mesh))) else {
            continue;
        };
        if let Some(is_unbound) = is_unbound.get_mut(skin) {
            *is_unbound |= mesh.primitives.iter().any(skins::lacks_half);
        }
    }
    parts.count("skin", is_unbound.into_iter().map(u64::from).sum());
    let targets = || document.meshes.iter().flat_map(|mesh| &mesh.primitives).flat_map(|primitive| &primitive.targets);
    let is_of_looks = |name: &String| name.starts_with("COLOR_") || name.starts_with("TEXCOORD_");
    parts.count("colouring morph target", targets().filter(|target| target.keys().any(is_of_looks)).count() as u64);
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
