//! Several meshes that are one: with the materials, textures and cameras of all, in the coordinates of the first.

use super::{Mesh, MeshMaterial, Texture, TextureUse};
use glam::{DVec3, Vec2, Vec3, Vec4};
use std::collections::HashMap;
use voxtrace_scene::Invalid;

/// Most materials of a mesh: triangles have 16 bits for them.
const MOST_MATERIALS: usize = 1 << 16;

/// A mesh of several, without their triangles, and where each of them is in it.
#[derive(Clone, Debug)]
pub struct Joined {
    /// What they have in common. Textures are single white texels until they are put in with the meshes that have them.
    pub frame: Mesh,
    /// Whether one of them has texture coordinates.
    pub has_uvs: bool,
    /// Whether one of them has colours of its corners.
    pub has_colors: bool,
    /// Of each material whether a triangle uses it.
    pub used: Vec<bool>,
    places: Vec<Place>,
}

/// Where a mesh is in the whole.
#[derive(Clone, Debug)]
struct Place {
    /// Added to its positions.
    shift: DVec3,
    /// The materials of the whole that its own are.
    materials: Vec<u16>,
    /// Its textures.
    first_texture: usize,
    textures: usize,
}

/// What must be known of a mesh to join it with others, beside its triangles.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The mesh without triangles and textures. Its materials have no textures where it has no texture coordinates.
    pub frame: Mesh,
    /// Number of its textures.
    pub textures: usize,
    /// Whether it has texture coordinates.
    pub has_uvs: bool,
    /// Whether its corners have colours.
    pub has_colors: bool,
    /// Of each material whether a triangle uses it.
    pub used: Vec<bool>,
}

/// What is said of a mesh that is not the one that it was.
pub(crate) fn has_changed(name: &str) -> Invalid {
    format!("{name} has changed since it was looked through").into()
}

impl Part {
    /// What there is to know of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let has_uvs = !mesh.uvs.is_empty();
        let mut used = vec![false; mesh.materials.len()];
        (0..mesh.triangle_count()).for_each(|triangle| used[mesh.material(triangle)] = true);
        let plain = |material: &MeshMaterial| MeshMaterial {
            base_texture: None,
            alpha_texture: None,
            emission_texture: None,
            surface_texture: None,
            ..material.clone()
        };
        let materials = mesh.materials.iter().map(|material| if has_uvs { material.clone() } else { plain(material) });
        let frame = Mesh {
            name: mesh.name.clone(),
            offset: mesh.offset,
            materials: materials.collect(),
            cameras: mesh.cameras.clone(),
            unit: mesh.unit,
            notes: mesh.notes.clone(),
            ..Mesh::default()
        };
        let textures = if has_uvs { mesh.textures.len() } else { 0 };
        Self { frame, textures, has_uvs, has_colors: !mesh.colors.is_empty(), used }
    }
}

impl Joined {
    /// Joins meshes in their order.
    ///
    /// # Errors
    /// If there are none, their units differ, or there are more materials than a mesh can have.
    pub fn of<'a>(parts: impl IntoIterator<Item = &'a Part>) -> Result<Self, Invalid> {
        let mut parts = parts.into_iter().peekable();
        let Some(first) = parts.peek() else { return Err("there is no mesh".into()) };
        let Mesh { name, offset, unit, .. } = &first.frame;
        let frame = Mesh { name: name.clone(), offset: *offset, unit: *unit, ..Mesh::default() };
        let mut all = Self { frame, has_uvs: false, has_colors: false, used: Vec::new(), places: Vec::new() };
        let mut known = HashMap::new();
        for part in parts {
            all.add(part, &mut known)?;
        }
        Ok(all)
    }

    /// Adds a mesh; `known` has the texts of materials and their numbers.
    fn add(&mut self, part: &Part, known: &mut HashMap<String, usize>) -> Result<(), Invalid> {
        let frame = &mut self.frame;
        if part.frame.unit != frame.unit {
            // Two files may have one name.
            let number = if part.frame.name == frame.name {
                format!(" (mesh {})", self.places.len() + 1)
            } else {
                String::new()
            };
            return Err(format!("{} and {}{number} have different units", frame.name, part.frame.name).into());
        }
        let shift = part.frame.offset - frame.offset;
        let first_texture = frame.textures.len();
        let moved = |texture: Option<TextureUse>| {
            texture.map(|texture| TextureUse { texture: texture.texture + first_texture as u32, ..texture })
        };
        let mut materials = Vec::new();
        for (material, &is_used) in part.frame.materials.iter().zip(&part.used) {
            let material = MeshMaterial {
                // Nothing of a voxel depends on it, and many files have materials that differ in nothing else.
                name: String::new(),
                base_texture: moved(material.base_texture),
                alpha_texture: moved(material.alpha_texture),
                emission_texture: moved(material.emission_texture),
                surface_texture: moved(material.surface_texture),
                ..material.clone()
            };
            let at = *known.entry(format!("{material:?}")).or_insert_with(|| {
                frame.materials.push(material);
                self.used.push(false);
                frame.materials.len() - 1
            });
            if at >= MOST_MATERIALS {
                return Err(format!("the meshes have more than {MOST_MATERIALS} materials together").into());
            }
            self.used[at] |= is_used;
            materials.push(at as u16);
        }
        let white = Texture::new(1, 1, vec![[255; 4]]).into_iter().cycle().take(part.textures);
        frame.textures.extend(white);
        let by = shift.as_vec3();
        frame.cameras.extend(part.frame.cameras.iter().map(|camera| {
            let (eye, target) = (camera.eye + by, camera.target + by);
            voxtrace_scene::Camera { eye, target, ..camera.clone() }
        }));
        for note in &part.frame.notes {
            let note = format!("{}: {note}", part.frame.name);
            if !frame.notes.contains(&note) {
                frame.notes.push(note);
            }
        }
        self.has_uvs |= part.has_uvs;
        self.has_colors |= part.has_colors;
        self.places.push(Place { shift, materials, first_texture, textures: part.textures });
        Ok(())
    }

    /// Number of meshes.
    pub fn count(&self) -> usize {
        self.places.len()
    }

    /// A position of a mesh in the coordinates of the whole.
    pub fn position(&self, number: usize, position: Vec3) -> Vec3 {
        let shift = self.places[number].shift;
        // Most have the same offset, and keep their bits.
        if shift == DVec3::ZERO { position } else { (position.as_dvec3() + shift).as_vec3() }
    }

    /// Takes the textures of a mesh, and makes its arrays those of a part of the whole: with texture coordinates, colours and materials where
    /// the whole has them.
    ///
    /// # Errors
    /// If the mesh is not the one that it was joined as.
    pub fn take(&mut self, number: usize, mesh: Mesh) -> Result<Mesh, Invalid> {
        let place = self.places[number].clone();
        let vertices = mesh.positions.len();
        let count = mesh.triangle_count();
        let textures = if mesh.uvs.is_empty() { 0 } else { mesh.textures.len() };
        if mesh.materials.len() != place.materials.len()
            || textures != place.textures
            || mesh.offset - self.frame.offset != place.shift
            || !mesh.uvs.is_empty() && !self.has_uvs
            || !mesh.colors.is_empty() && !self.has_colors
        {
            return Err(has_changed(&mesh.name));
        }
        for (at, texture) in mesh.textures.into_iter().take(textures).enumerate() {
            self.frame.textures[place.first_texture + at] = texture;
        }
        let mut positions = mesh.positions;
        positions.iter_mut().for_each(|position| *position = self.position(number, *position));
        let filled = |own: Vec<Vec2>, has: bool| if own.is_empty() && has { vec![Vec2::ZERO; vertices] } else { own };
        let colors = mesh.colors;
        let colors = if colors.is_empty() && self.has_colors { vec![Vec4::ONE; vertices] } else { colors };
        let own =
            (0..count).map(|triangle| mesh.material_of.get(triangle).map_or(0, |&material| usize::from(material)));
        Ok(Mesh {
            name: mesh.name,
            offset: self.frame.offset,
            positions,
            material_of: own.map(|material| place.materials[material]).collect(),
            triangles: mesh.triangles,
            uvs: filled(mesh.uvs, self.has_uvs),
            colors,
            ..Mesh::default()
        })
    }

    /// All meshes as one, in the order in which they were joined.
    ///
    /// # Errors
    /// As [`Self::take`]; also if there are more corners than can be numbered.
    pub fn whole(mut self, meshes: impl IntoIterator<Item = Mesh>) -> Result<Mesh, Invalid> {
        let mut whole = Mesh::default();
        for (number, mesh) in meshes.into_iter().enumerate() {
            let mesh = self.take(number, mesh)?;
            let first = u32::try_from(whole.positions.len()).ok();
            let first = first.filter(|first| u64::from(*first) + mesh.positions.len() as u64 <= u64::from(u32::MAX));
            let first = first.ok_or_else(|| Invalid::from("the meshes have more corners than can be numbered"))?;
            let corners = |triangle| mesh.corners(triangle).map(|corner| corner as u32 + first);
            whole.triangles.extend((0..mesh.triangle_count()).map(corners));
            whole.positions.extend(mesh.positions);
            whole.uvs.extend(mesh.uvs);
            whole.colors.extend(mesh.colors);
            whole.material_of.extend(mesh.material_of);
        }
        let Mesh { positions, triangles, uvs, colors, material_of, .. } = whole;
        Ok(Mesh { positions, triangles, uvs, colors, material_of, ..self.frame })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle(name: &str, offset: DVec3, at: Vec3) -> Mesh {
        Mesh { offset, positions: vec![at, at + Vec3::X, at + Vec3::Y], ..Mesh::new(name) }
    }

    fn textured(name: &str, texel: [u8; 4]) -> Mesh {
        let material = MeshMaterial { base_texture: Some(TextureUse::new(0)), ..MeshMaterial::default() };
        Mesh {
            uvs: vec![Vec2::splat(0.5); 3],
            materials: vec![material],
            textures: vec![Texture::new(1, 1, vec![texel]).unwrap()],
            ..triangle(name, DVec3::ZERO, Vec3::ZERO)
        }
    }

    #[test]
    fn materials_textures_and_offsets_are_those_of_the_whole() {
        let far = DVec3::new(5e6, 0.0, 0.0);
        let colored = Mesh { colors: vec![Vec4::new(0.5, 0.0, 0.0, 1.0); 3], ..triangle("c", far, Vec3::ZERO) };
        let meshes = [triangle("a", far - 8.0, Vec3::ZERO), colored, triangle("d", far, Vec3::Z)];
        let joined = Joined::of(&meshes.each_ref().map(Part::of)).unwrap();
        assert_eq!((joined.count(), joined.has_uvs, joined.has_colors), (3, false, true));
        let whole = joined.whole(meshes).unwrap();
        whole.validate().unwrap();
        assert_eq!((whole.triangle_count(), whole.materials.len(), &*whole.name), (3, 1, "a"));
        assert_eq!(whole.offset, far - 8.0);
        assert_eq!((whole.positions[0], whole.positions[3], whole.positions[6].z), (Vec3::ZERO, Vec3::splat(8.0), 9.0));
        assert_eq!((whole.colors[0], whole.colors[3].x), (Vec4::ONE, 0.5));

        let plain = triangle("p", DVec3::ZERO, Vec3::ZERO);
        let meshes = [textured("t", [255, 0, 0, 255]), plain, textured("u", [0, 255, 0, 255])];
        let whole = Joined::of(&meshes.each_ref().map(Part::of)).unwrap().whole(meshes).unwrap();
        whole.validate().unwrap();
        let texel = |triangle: usize| {
            let texture = whole.materials[whole.material(triangle)].base_texture?;
            Some(whole.textures[texture.texture as usize].texels()[0])
        };
        assert_eq!([0, 1, 2].map(texel), [Some([255, 0, 0, 255]), None, Some([0, 255, 0, 255])]);
        assert_eq!(whole.uvs.len(), 9);
    }

    #[test]
    fn a_mesh_without_texture_coordinates_keeps_its_plain_colours() {
        let bare = Mesh { uvs: Vec::new(), ..textured("bare", [9, 9, 9, 255]) };
        let part = Part::of(&bare);
        assert!(part.textures == 0 && part.frame.materials[0].base_texture.is_none());
        let meshes = [bare, textured("t", [255, 0, 0, 255])];
        let whole = Joined::of(&meshes.each_ref().map(Part::of)).unwrap().whole(meshes).unwrap();
        assert!(whole.materials[whole.material(0)].base_texture.is_none());
        assert!(whole.materials[whole.material(1)].base_texture.is_some());
    }

    #[test]
    fn what_does_not_fit_together_is_told() {
        use voxtrace_scene::scene::LengthUnit;
        let one = triangle("one", DVec3::ZERO, Vec3::ZERO);
        let other = Mesh { unit: LengthUnit::METRE, ..triangle("other", DVec3::ZERO, Vec3::ZERO) };
        let error = Joined::of(&[&one, &other].map(Part::of)).unwrap_err().to_string();
        assert_eq!(error, "one and other have different units");
        let alike = Mesh { name: "one".into(), ..other };
        let error = Joined::of(&[&one, &one, &alike].map(Part::of)).unwrap_err().to_string();
        assert_eq!(error, "one and one (mesh 3) have different units");
        assert!(Joined::of(&[]).is_err());
        let mut joined = Joined::of(&[&one, &one].map(Part::of)).unwrap();
        let changed = Mesh { materials: vec![MeshMaterial::default(); 2], ..one.clone() };
        assert!(joined.take(1, one).is_ok() && joined.take(0, changed).is_err());
        let many = (0..=MOST_MATERIALS / 1024).map(|mesh| {
            let material = |at: usize| MeshMaterial { roughness: (mesh * 1024 + at) as f32, ..MeshMaterial::default() };
            Part::of(&Mesh { materials: (0..1024).map(material).collect(), ..Mesh::new("many") })
        });
        let error = Joined::of(&many.collect::<Vec<_>>()).unwrap_err().to_string();
        assert_eq!(error, "the meshes have more than 65536 materials together");
    }
}
