//! Materials and pictures of a glTF document.

use super::Fault;
use super::buffers::{Buffers, read_uri};
use super::document::{self, AlphaMode, Document, TextureInfo};
use super::layers::layered;
use crate::import::images::texture;
use crate::import::source::folder::Folder;
use glam::{Vec3, Vec4};
use voxtrace_voxelize::Limits;
use voxtrace_voxelize::mesh::{Mesh, MeshMaterial, TextureUse, Wrap};

const NEAREST: u32 = 9728;
const CLAMP: u32 = 33071;
const MIRROR: u32 = 33648;
/// Share of alpha from which a surface that fades counts as there.
const FADED: f32 = 0.1;

/// Set of texture coordinates that each material's primitives take.
pub(super) type CoordinateSets = Vec<u32>;

/// Puts all materials, with the pictures that they need, after those of the mesh; returns the coordinate set of each.
pub(super) fn read(
    document: &Document,
    buffers: &Buffers,
    folder: &Folder,
    limits: &Limits,
    mesh: &mut Mesh,
) -> Result<CoordinateSets, Fault> {
    let known = vec![None; document.images.len()];
    let mut images = Images { document, buffers, folder, limits, taken: 0, stored: 0, known };
    let mut sets = Vec::new();
    mesh.notes.extend(unread_textures(document));
    for material in &document.materials {
        let (set, material) = convert(material, &mut images, mesh)?;
        sets.push(set);
        mesh.materials.push(material);
    }
    Ok(sets)
}

fn convert(material: &document::Material, images: &mut Images, mesh: &mut Mesh) -> Result<(u32, MeshMaterial), Fault> {
    let extensions = &material.extensions;
    let metallic = &material.pbr_metallic_roughness;
    let glossiness = extensions.glossiness.as_ref();
    let factor = glossiness.map_or(metallic.base_color_factor, |glossiness| glossiness.diffuse_factor);
    let base_info = match glossiness {
        Some(glossiness) => glossiness.diffuse_texture.as_ref(),
        None => metallic.base_color_texture.as_ref(),
    };
    let emission_info = material.emissive_texture.as_ref();
    // What is not lit has its colour alone. Light falls on it here, so it is matte: the usual factors would make it metal.
    let is_unlit = extensions.unlit.is_some();
    let surface_info = metallic.metallic_roughness_texture.as_ref().filter(|_| glossiness.is_none() && !is_unlit);
    let set = base_info.or(emission_info).or(surface_info).map_or(0, coordinate_set);
    let mut texture = |info: Option<&TextureInfo>| match info {
        Some(info) if coordinate_set(info) == set => images.texture(info, mesh),
        Some(_) => {
            mesh.notes.push(format!("{}: a texture on other coordinates is left out", material.name));
            Ok(None)
        }
        None => Ok(None),
    };
    let base_texture = texture(base_info)?;
    let emission_texture = texture(emission_info)?;
    let surface_texture = texture(surface_info)?;
    let strength = extensions.emissive_strength.as_ref().map_or(1.0, |strength| strength.emissive_strength);
    let emission = Vec3::from_array(material.emissive_factor) * strength;
    let base_color = Vec4::from_array(factor);
    let transmission = extensions.transmission.as_ref().map_or(0.0, |transmission| transmission.transmission_factor);
    let ior = extensions.ior.as_ref().map_or(1.5, |ior| ior.ior);
    // A texture says where there is metal and how rough it is; without it its factors would make all of it metal.
    let lacks_texture = is_unlit || surface_info.is_some() && surface_texture.is_none();
    let own_roughness = if lacks_texture { 1.0 } else { metallic.roughness_factor };
    let roughness = glossiness.map_or(own_roughness, |glossiness| 1.0 - glossiness.glossiness_factor);
    let is_finite =
        emission.is_finite() && base_color.is_finite() && [transmission, ior, roughness].iter().all(|v| v.is_finite());
    let not_finite = || Fault::malformed(format!("the material {:?} is not finite", material.name));
    if !is_finite {
        return Err(not_finite());
    }
    let (alpha_cutoff, fade) = match material.alpha_mode {
        AlphaMode::Opaque => (0.0, 0.0),
        AlphaMode::Mask => (material.alpha_cutoff.unwrap_or(0.5).max(1e-6), 0.0),
        // What a factor makes fade is glass, what a picture makes fade is an outline.
        AlphaMode::Blend => (FADED * base_color.w.clamp(0.01, 1.0), 1.0 - base_color.w.clamp(0.0, 1.0)),
    };
    let base = MeshMaterial {
        name: material.name.clone(),
        base_color: base_color.clamp(Vec4::ZERO, Vec4::ONE),
        base_texture,
        alpha_texture: None,
        alpha_cutoff,
        emission: emission.max(Vec3::ZERO),
        emission_texture,
        roughness: roughness.clamp(0.0, 1.0),
        metallic: if glossiness.is_some() || lacks_texture { 0.0 } else { metallic.metallic_factor.clamp(0.0, 1.0) },
        surface_texture,
        transmission: transmission.max(fade).clamp(0.0, 1.0),
        ior: ior.max(1.0),
        ..MeshMaterial::default()
    };
    Ok((set, layered(base, extensions).ok_or_else(not_finite)?))
}

/// What is said of textures that say more than is read: one sentence for each kind.
fn unread_textures(document: &Document) -> Vec<String> {
    type Has = fn(&document::MaterialExtensions) -> bool;
    let kinds: [(&str, Has); 4] = [
        ("transmission", |all| all.transmission.as_ref().is_some_and(|own| own.transmission_texture.is_some())),
        ("thickness", |all| all.volume.as_ref().is_some_and(|own| own.thickness_texture.is_some())),
        ("the weight or colour of reflections", |all| {
            all.specular
                .as_ref()
                .is_some_and(|own| own.specular_texture.is_some() || own.specular_color_texture.is_some())
        }),
        ("clear coats", |all| {
            let is_textured = |own: &document::Clearcoat| {
                own.clearcoat_texture.is_some() || own.clearcoat_roughness_texture.is_some()
            };
            all.clearcoat.as_ref().is_some_and(is_textured)
        }),
    ];
    let said = |(what, has): (&str, Has)| {
        let count = document.materials.iter().filter(|material| has(&material.extensions)).count();
        let materials = if count == 1 { "material" } else { "materials" };
        (count > 0)
            .then(|| format!("textures of {what} are left out ({count} {materials}); their factors hold everywhere"))
    };
    kinds.into_iter().filter_map(said).collect()
}

fn coordinate_set(info: &TextureInfo) -> u32 {
    info.extensions.transform.as_ref().and_then(|transform| transform.tex_coord).unwrap_or(info.tex_coord)
}

/// The pictures of a document, each decoded once.
struct Images<'a> {
    document: &'a Document,
    buffers: &'a Buffers<'a>,
    folder: &'a Folder,
    limits: &'a Limits,
    /// Bytes of all pictures.
    taken: u64,
    /// Bytes of the views that they were in: many pictures may name one.
    stored: u64,
    /// Index in the mesh; the inner `None` is a picture that cannot be read.
    known: Vec<Option<Option<u32>>>,
}

impl Images<'_> {
    fn texture(&mut self, info: &TextureInfo, mesh: &mut Mesh) -> Result<Option<TextureUse>, Fault> {
        let texture = self.document.textures.get(info.index);
        let texture = texture.ok_or_else(|| Fault::malformed(format!("texture {} is missing", info.index)))?;
        let webp = texture.extensions.webp.as_ref().map(|webp| webp.source);
        let Some(source) = texture.source.or(webp) else {
            mesh.notes.push("a texture in a format of an extension is left out".into());
            return Ok(None);
        };
        let known = self.known.get(source);
        let index = match *known.ok_or_else(|| Fault::malformed(format!("image {source} is missing")))? {
            Some(known) => known,
            None => {
                let index = self.read(source, mesh)?;
                self.known[source] = Some(index);
                index
            }
        };
        let sampler = texture.sampler.and_then(|index| self.document.samplers.get(index));
        let wrap = |mode: Option<u32>| match mode {
            Some(CLAMP) => Wrap::Clamp,
            Some(MIRROR) => Wrap::Mirror,
            _ => Wrap::Repeat,
        };
        let mut placed = TextureUse::new(index.unwrap_or(0));
        if let Some(sampler) = sampler {
            placed.wrap = [wrap(sampler.wrap_s), wrap(sampler.wrap_t)];
            placed.nearest = sampler.mag_filter == Some(NEAREST);
        }
        if let Some(transform) = &info.extensions.transform {
            // Scale first, then the rotation, then the offset (KHR_texture_transform).
            let (sin, cos) = transform.rotation.sin_cos();
            let [su, sv] = transform.scale;
            let [u, v] = transform.offset;
            placed.transform = [Vec3::new(cos * su, sin * sv, u), Vec3::new(-sin * su, cos * sv, v)];
        }
        Ok(index.map(|_| placed))
    }

    /// Decodes a picture. One that is damaged or missing is noted; one that is named outside the folder is a fault.
    fn read(&mut self, source: usize, mesh: &mut Mesh) -> Result<Option<u32>, Fault> {
        let image = &self.document.images[source];
        let (taken, limits) = (&mut self.taken, self.limits);
        let mut decode =
            |bytes: &[u8]| texture::decode_another(bytes, taken, limits).map_err(|refused| refused.to_string());
        let decoded = match (&image.uri, image.buffer_view) {
            (Some(uri), _) => match read_uri(uri, self.folder) {
                Ok(bytes) => decode(&bytes),
                Err(Fault { kind: voxtrace_voxelize::ImportErrorKind::Io(error), .. }) => Err(error.to_string()),
                Err(fault) => return Err(fault),
            },
            (None, Some(view)) => {
                let part = self.buffers.view(view)?.0;
                self.stored = self.stored.saturating_add(part.len() as u64);
                if self.stored > limits.bytes {
                    return Err(Fault::limit("bytes of pictures", self.stored, limits.bytes));
                }
                decode(&part.bytes()?)
            }
            (None, None) => Err("nothing says where it is".into()),
        };
        match decoded {
            Ok(texture) => {
                mesh.textures.push(texture);
                Ok(Some((mesh.textures.len() - 1) as u32))
            }
            Err(fault) => {
                mesh.notes.push(format!("image {source} is left out: {fault}"));
                Ok(None)
            }
        }
    }
}
