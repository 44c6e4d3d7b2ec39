//! The look of a surface: material, vertex colours and textures of a triangle at any place of it.

use super::key::{Class, Key, emission_bits, key_of, rgb_bits};
use super::triangle::Triangle;
use crate::mesh::{Mesh, MeshMaterial, TextureUse};
use glam::{DVec2, Vec2, Vec3, Vec4};

/// How the mesh looks, material by material.
pub(super) struct Paints<'a> {
    mesh: &'a Mesh,
    class_of: Vec<u8>,
    pub classes: Vec<Class>,
    /// The one look of all voxels, where there is only one.
    pub uniform: Option<Key>,
    /// Whether any material emits.
    pub emits: bool,
}

/// How a triangle looks.
pub(super) struct Paint<'a> {
    mesh: &'a Mesh,
    material: &'a MeshMaterial,
    pub class: u8,
    corners: [usize; 3],
    /// From two coordinates of a point to its weights of the second and third corner.
    origin: DVec2,
    weights: [DVec2; 2],
    axes: [usize; 2],
    /// Area of the surface for an area of its projection along the widest axis.
    pub stretch: f64,
    /// The look, where it is the same everywhere.
    pub constant: Option<Look>,
    /// Whether parts of the triangle may be cut out.
    pub has_holes: bool,
    /// Texels on an area of one voxel face, of the base and the emission texture.
    density: [f32; 2],
}

/// A linear colour and what it emits.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub color: Vec3,
    pub emission: Vec3,
}

impl<'a> Paints<'a> {
    pub fn of(mesh: &'a Mesh) -> Self {
        let mut used = vec![mesh.material_of.is_empty(); mesh.materials.len()];
        used.iter_mut().skip(1).for_each(|used| *used &= !mesh.material_of.is_empty());
        mesh.material_of.iter().for_each(|&material| used[usize::from(material)] = true);
        Self::among(mesh, &used)
    }

    /// Of a part of a mesh whose triangles have these materials and no others.
    pub fn among(mesh: &'a Mesh, used: &[bool]) -> Self {
        let (class_of, classes) = Class::of_materials(&mesh.materials);
        let looks = mesh.materials.iter().zip(&class_of).zip(used).filter(|(_, used)| **used);
        let mut keys: Vec<Option<Key>> = looks
            .map(|((material, &class), _)| {
                let is_plain = mesh.colors.is_empty() && !has_texture(material) && material.alpha_cutoff == 0.0;
                let rgb = rgb_bits(material.base_color.truncate());
                is_plain.then(|| key_of(rgb, class, emission_bits(material.emission)))
            })
            .collect();
        keys.sort_unstable();
        keys.dedup();
        let uniform = if let [only] = keys[..] { only } else { None };
        let emits = mesh.materials.iter().zip(used).any(|(material, &used)| used && material.emission != Vec3::ZERO);
        Self { mesh, class_of, classes, uniform, emits }
    }

    /// The look of a triangle, `None` where it is not there at all.
    pub fn triangle(&self, index: usize, triangle: &Triangle) -> Option<Paint<'a>> {
        let mesh = self.mesh;
        let material_index = mesh.material(index);
        let material = &mesh.materials[material_index];
        let corners = mesh.corners(index);
        let widest = triangle.widest_axis();
        let axes = [(widest + 1) % 3, (widest + 2) % 3];
        let flat = |corner: usize| DVec2::from_array(axes.map(|axis| triangle.corners[corner][axis]));
        let (origin, a, b) = (flat(0), flat(1) - flat(0), flat(2) - flat(0));
        let twice_area = a.perp_dot(b);
        let weights = [DVec2::new(b.y, -b.x) / twice_area, DVec2::new(-a.y, a.x) / twice_area];
        let size = triangle.normal.length();
        let is_varying = !mesh.colors.is_empty() || has_texture(material);
        let constant =
            (!is_varying).then(|| Look { color: material.base_color.truncate(), emission: material.emission });
        if constant.is_some() && material.base_color.w < material.alpha_cutoff {
            return None;
        }
        let density = |texture: Option<TextureUse>| {
            let (Some(texture), false) = (texture, mesh.uvs.is_empty()) else { return 0.0 };
            let [p, q, r] = corners.map(|corner| texture.place(mesh.uvs[corner]));
            let [width, height] = mesh.textures[texture.texture as usize].size();
            (q - p).perp_dot(r - p).abs() * width as f32 * height as f32 / size as f32
        };
        Some(Paint {
            mesh,
            material,
            class: self.class_of[material_index],
            corners,
            origin,
            weights,
            axes,
            stretch: size / triangle.normal[widest].abs(),
            constant,
            has_holes: is_varying && material.alpha_cutoff > 0.0,
            density: [density(material.base_texture.or(material.alpha_texture)), density(material.emission_texture)],
        })
    }
}

fn has_texture(material: &MeshMaterial) -> bool {
    material.base_texture.is_some() || material.alpha_texture.is_some() || material.emission_texture.is_some()
}

impl Paint<'_> {
    /// The two axes that span the projection in which areas and centroids are found.
    pub fn axes(&self) -> [usize; 2] {
        self.axes
    }

    /// The look around a point, given by its two coordinates, averaged over an area; `None` where it is cut out.
    pub fn at(&self, point: DVec2, area: f64) -> Option<Look> {
        if let Some(look) = self.constant {
            return Some(look);
        }
        let (mesh, material) = (self.mesh, self.material);
        let from_origin = point - self.origin;
        let b = self.weights[0].dot(from_origin) as f32;
        let c = self.weights[1].dot(from_origin) as f32;
        let a = 1.0 - b - c;
        let [p, q, r] = self.corners;
        let mut base = material.base_color;
        if !mesh.colors.is_empty() {
            base *= mesh.colors[p] * a + mesh.colors[q] * b + mesh.colors[r] * c;
        }
        let mut emission = material.emission;
        if !mesh.uvs.is_empty() {
            let uv = mesh.uvs[p] * a + mesh.uvs[q] * b + mesh.uvs[r] * c;
            let area = area as f32;
            if let Some(texture) = &material.base_texture {
                base *= self.sample(texture, uv, area * self.density[0]);
            }
            if let Some(texture) = &material.alpha_texture {
                base.w *= self.sample(texture, uv, area * self.density[0]).x;
            }
            if let Some(texture) = &material.emission_texture {
                emission *= self.sample(texture, uv, area * self.density[1]).truncate();
            }
        }
        (base.w >= material.alpha_cutoff).then(|| Look { color: base.truncate(), emission })
    }

    fn sample(&self, texture: &TextureUse, uv: Vec2, footprint: f32) -> Vec4 {
        self.mesh.textures[texture.texture as usize].sample(texture.place(uv), texture.wrap, texture.nearest, footprint)
    }
}
