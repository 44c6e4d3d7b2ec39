//! The appearance of a mesh's surface: material, vertex colours and textures, evaluated at points of a triangle.

use super::appearance::{AppearanceKey, BsdfClass, appearance_key, emission_bits, rgb_bits};
use super::triangle::Triangle;
use crate::mesh::{Mesh, MeshMaterial, TextureUse};
use glam::{DVec2, Vec2, Vec3, Vec4};
use voxtrace_scene::material::encode_srgb;

/// The appearance of a mesh, material by material.
pub(super) struct MeshAppearance<'a> {
    mesh: &'a Mesh,
    class_of: Vec<u8>,
    /// For each material whose texture says roughness and metalness, the classes of their levels.
    levels_of: Vec<Option<SurfaceLevels>>,
    pub classes: Vec<BsdfClass>,
    /// The appearance of all voxels, where the whole mesh has only one.
    pub uniform: Option<AppearanceKey>,
    /// Whether any material emits.
    pub emits: bool,
}

/// The appearance of a triangle, ready to be evaluated.
pub(super) struct TriangleAppearance<'a> {
    mesh: &'a Mesh,
    material: &'a MeshMaterial,
    class: u8,
    levels: Option<&'a SurfaceLevels>,
    corners: [usize; 3],
    /// From the projected point to its barycentric coordinates of the second and third corner.
    origin: DVec2,
    weights: [DVec2; 2],
    axes: [usize; 2],
    /// Surface area divided by the area projected along the dominant axis of the normal.
    pub stretch: f64,
    /// The appearance, where it is the same everywhere.
    pub constant: Option<Appearance>,
    /// Whether the alpha cutoff may remove parts of the triangle.
    pub has_holes: bool,
    /// Texels per unit of surface area (voxel edges squared), of the textures of base, emission and surface.
    density: [f32; 3],
}

/// A linear colour, the emitted radiance, and the BSDF class.
#[derive(Clone, Copy)]
pub(super) struct Appearance {
    pub color: Vec3,
    pub emission: Vec3,
    pub class: u8,
}

/// Levels of roughness, 0 and 1 among them.
const ROUGHNESSES: usize = 9;
/// Levels of metalness: none, half, all.
const METALNESSES: usize = 3;

/// The BSDF classes of the levels of roughness and metalness, roughness fastest. Textures of materials that are alike otherwise share them.
pub(super) struct SurfaceLevels([u8; ROUGHNESSES * METALNESSES]);

impl SurfaceLevels {
    /// Roughness and metalness of each level.
    fn all() -> impl Iterator<Item = (f32, f32)> {
        let share = |at: usize, count: usize| at as f32 / (count - 1) as f32;
        (0..METALNESSES).flat_map(move |metal| {
            (0..ROUGHNESSES).map(move |rough| (share(rough, ROUGHNESSES), share(metal, METALNESSES)))
        })
    }

    /// The class of the nearest level.
    fn class(&self, roughness: f32, metallic: f32) -> u8 {
        let level = |value: f32, count: usize| (value.clamp(0.0, 1.0) * (count - 1) as f32).round() as usize;
        self.0[level(metallic, METALNESSES) * ROUGHNESSES + level(roughness, ROUGHNESSES)]
    }
}

impl<'a> MeshAppearance<'a> {
    pub fn of(mesh: &'a Mesh) -> Self {
        let mut used = vec![mesh.material_of.is_empty(); mesh.materials.len()];
        used.iter_mut().skip(1).for_each(|used| *used &= !mesh.material_of.is_empty());
        mesh.material_of.iter().for_each(|&material| used[usize::from(material)] = true);
        Self::among(mesh, &used)
    }

    /// As [`Self::of`], for a mesh whose triangles use only the materials flagged in `used`.
    pub fn among(mesh: &'a Mesh, used: &[bool]) -> Self {
        let textured = |material: &&MeshMaterial| material.surface_texture.is_some() && !mesh.uvs.is_empty();
        let of_levels = mesh.materials.iter().filter(textured).flat_map(|material| {
            let class = BsdfClass::of(material);
            SurfaceLevels::all().map(move |(roughness, metallic)| class.with_surface(roughness, metallic))
        });
        let (mut class_of, classes) = BsdfClass::grouped(mesh.materials.iter().map(BsdfClass::of).chain(of_levels));
        let of_levels = class_of.split_off(mesh.materials.len());
        let mut of_levels = of_levels.as_chunks().0.iter().map(|levels| SurfaceLevels(*levels));
        let levels_of: Vec<_> =
            mesh.materials.iter().map(|material| textured(&material).then(|| of_levels.next()).flatten()).collect();
        let materials = mesh.materials.iter().zip(&class_of).zip(used).filter(|(_, used)| **used);
        let mut keys: Vec<Option<AppearanceKey>> = materials
            .map(|((material, &class), _)| {
                let is_plain = mesh.colors.is_empty() && !has_texture(material) && material.alpha_cutoff == 0.0;
                let rgb = rgb_bits(material.base_color.truncate());
                is_plain.then(|| appearance_key(rgb, class, emission_bits(material.emission)))
            })
            .collect();
        keys.sort_unstable();
        keys.dedup();
        let uniform = if let [only] = keys[..] { only } else { None };
        let emits = mesh.materials.iter().zip(used).any(|(material, &used)| used && material.emission != Vec3::ZERO);
        Self { mesh, class_of, levels_of, classes, uniform, emits }
    }

    /// The appearance of a triangle, `None` where its alpha is below the cutoff everywhere.
    pub fn triangle<'b>(&'b self, index: usize, triangle: &Triangle) -> Option<TriangleAppearance<'b>> {
        let mesh = self.mesh;
        let material_index = mesh.material(index);
        let material = &mesh.materials[material_index];
        let corners = mesh.corners(index);
        let dominant = triangle.dominant_axis();
        let axes = [(dominant + 1) % 3, (dominant + 2) % 3];
        let flat = |corner: usize| DVec2::from_array(axes.map(|axis| triangle.corners[corner][axis]));
        let (origin, a, b) = (flat(0), flat(1) - flat(0), flat(2) - flat(0));
        let twice_area = a.perp_dot(b);
        let weights = [DVec2::new(b.y, -b.x) / twice_area, DVec2::new(-a.y, a.x) / twice_area];
        let size = triangle.normal.length();
        let is_varying = !mesh.colors.is_empty() || has_texture(material);
        let class = self.class_of[material_index];
        let constant = (!is_varying).then(|| {
            let (color, emission) = (material.base_color.truncate(), material.emission);
            Appearance { color, emission, class }
        });
        if constant.is_some() && material.base_color.w < material.alpha_cutoff {
            return None;
        }
        let density = |texture: Option<TextureUse>| {
            let (Some(texture), false) = (texture, mesh.uvs.is_empty()) else { return 0.0 };
            let [p, q, r] = corners.map(|corner| texture.place(mesh.uvs[corner]));
            let [width, height] = mesh.textures[texture.texture as usize].size();
            (q - p).perp_dot(r - p).abs() * width as f32 * height as f32 / size as f32
        };
        Some(TriangleAppearance {
            mesh,
            material,
            class,
            levels: self.levels_of[material_index].as_ref(),
            corners,
            origin,
            weights,
            axes,
            stretch: size / triangle.normal[dominant].abs(),
            constant,
            has_holes: is_varying && material.alpha_cutoff > 0.0,
            density: [
                density(material.base_texture.or(material.alpha_texture)),
                density(material.emission_texture),
                density(material.surface_texture),
            ],
        })
    }
}

fn has_texture(material: &MeshMaterial) -> bool {
    let textures = [material.base_texture, material.alpha_texture, material.emission_texture, material.surface_texture];
    textures.iter().any(Option::is_some)
}

impl TriangleAppearance<'_> {
    /// The two axes that span the plane into which areas and centroids are projected.
    pub fn axes(&self) -> [usize; 2] {
        self.axes
    }

    /// The appearance at a projected point, textures filtered over a surface area of `area`; `None` where the alpha is below
    /// the cutoff.
    pub fn at(&self, point: DVec2, area: f64) -> Option<Appearance> {
        if let Some(appearance) = self.constant {
            return Some(appearance);
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
        let (mut emission, mut class) = (material.emission, self.class);
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
            if let (Some(texture), Some(levels)) = (&material.surface_texture, self.levels) {
                let [_, rough, metal, _] = self.sample(texture, uv, area * self.density[2]).to_array();
                // The bytes as they are: textures are taken for colours.
                let byte = |linear: f32| encode_srgb(linear.into()) as f32;
                class = levels.class(material.roughness * byte(rough), material.metallic * byte(metal));
            }
        }
        (base.w >= material.alpha_cutoff).then(|| Appearance { color: base.truncate(), emission, class })
    }

    fn sample(&self, texture: &TextureUse, uv: Vec2, footprint: f32) -> Vec4 {
        self.mesh.textures[texture.texture as usize].sample(texture.place(uv), texture.wrap, texture.nearest, footprint)
    }
}
