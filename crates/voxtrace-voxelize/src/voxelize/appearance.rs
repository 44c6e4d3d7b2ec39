//! The appearance of a voxel before it has a material, packed into a key of 64 bits: sRGB colour, BSDF class and emission.

use crate::mesh::MeshMaterial;
use glam::Vec3;
use std::sync::LazyLock;
use voxtrace_scene::material::{Material, linear_color, linear_from_srgb};

/// Most BSDF classes in one scene: those of one textured material ([`SurfaceLevels`]) and as many more.
pub(super) const MAX_BSDF_CLASSES: usize = 64;

/// sRGB colour (bits 0 to 23, blue lowest), BSDF class (24 to 31) and emission (32 to 63, [`emission_bits`]).
pub(crate) type AppearanceKey = u64;

pub(super) fn appearance_key(rgb: u32, class: u8, emission: u32) -> AppearanceKey {
    u64::from(rgb) | u64::from(class) << 24 | u64::from(emission) << 32
}

/// BSDF parameters other than colour, shared by many materials.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BsdfClass {
    pub roughness: f32,
    pub metallic: f32,
    pub transmission: f32,
    pub ior: f32,
    /// As [`MeshMaterial::coat`].
    pub coat: Option<f32>,
    /// As [`MeshMaterial::absorption`], in a unit of the mesh, or a voxel after [`Self::in_voxels`].
    pub absorption: Option<Vec3>,
}

impl BsdfClass {
    pub fn of(material: &MeshMaterial) -> Self {
        let MeshMaterial { roughness, metallic, transmission, ior, coat, absorption, .. } = *material;
        Self { roughness, metallic, transmission, ior, coat, absorption }
    }

    /// The classes of a mesh whose voxels have an edge of so many of its units.
    pub fn in_voxels(classes: &[Self], edge: f64) -> Vec<Self> {
        let most = Vec3::splat(MOST_ABSORPTION);
        let scaled = |absorption: Vec3| (absorption.as_dvec3() * edge).as_vec3().min(most);
        classes.iter().map(|class| Self { absorption: class.absorption.map(scaled), ..*class }).collect()
    }

    fn distance(&self, other: &Self) -> f32 {
        let differences = [
            self.roughness - other.roughness,
            self.metallic - other.metallic,
            self.transmission - other.transmission,
            self.ior - other.ior,
            self.coat.unwrap_or(1.0) - other.coat.unwrap_or(1.0),
        ];
        let squares: f32 = differences.iter().map(|difference| difference * difference).sum();
        // Units may be anything: what counts is whether there is a volume, and its colour.
        let hue = |class: &Self| class.absorption.map_or(Vec3::NEG_ONE, Vec3::normalize_or_zero);
        squares + hue(self).distance_squared(hue(other))
    }

    /// The same with another roughness and metalness.
    pub fn with_surface(self, roughness: f32, metallic: f32) -> Self {
        Self { roughness, metallic, ..self }
    }

    /// The class of each material, of whose BSDF parameters it is told, and the classes. Beyond [`MAX_BSDF_CLASSES`] a material takes the nearest class.
    pub fn grouped(of_materials: impl Iterator<Item = Self>) -> (Vec<u8>, Vec<Self>) {
        let mut classes: Vec<Self> = Vec::new();
        let of_material = of_materials.map(|class| {
            let nearest =
                (0..classes.len()).min_by(|&a, &b| classes[a].distance(&class).total_cmp(&classes[b].distance(&class)));
            match nearest {
                Some(at) if classes[at] == class || classes.len() == MAX_BSDF_CLASSES => at as u8,
                _ => {
                    classes.push(class);
                    (classes.len() - 1) as u8
                }
            }
        });
        (of_material.collect(), classes)
    }
}

/// The material of a key.
pub(super) fn material_of(key: AppearanceKey, classes: &[BsdfClass]) -> Material {
    let [_, r, g, b] = (key as u32).to_be_bytes();
    material_with(linear_color([r, g, b]), key, classes)
}

/// The material of a key, with another colour.
pub(super) fn material_with(base_color: Vec3, key: AppearanceKey, classes: &[BsdfClass]) -> Material {
    let class = classes[(key >> 24 & 0xff) as usize];
    let mut material = Material::diffuse(base_color);
    material.emission = emission_of((key >> 32) as u32);
    material.roughness = class.roughness;
    material.metallic = class.metallic;
    material.transmission = class.transmission;
    material.ior = class.ior;
    // A surface that says how rough it is has something that shines, unless it is as rough as can be.
    material.specular = class.coat.unwrap_or(if class.roughness < 1.0 { 1.0 } else { 0.0 });
    match class.absorption {
        _ if class.transmission <= 0.0 => material,
        Some(absorption) => Material { absorption, ..material },
        None => material.tinted(base_color, TINT_VOXELS),
    }
}

/// Way through a transparent mesh after which white light has its colour: formats that have no volumes give their colour to the surface.
const TINT_VOXELS: f32 = 16.0;

/// Most absorption in a voxel: nothing is left behind it.
const MOST_ABSORPTION: f32 = 1e6;

/// Linear values that lie half way, in sRGB, between a byte and the next one.
static THRESHOLDS: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|byte| match byte {
        255 => f32::INFINITY,
        _ => {
            let signal = (byte as f64 + 0.5) / 255.0;
            (if signal <= 0.04045 { signal / 12.92 } else { ((signal + 0.055) / 1.055).powf(2.4) }) as f32
        }
    })
});
const GUESSES: usize = 1024;
/// By the square root of the linear value: a lower bound of the byte, at most a few below it.
static GUESS: LazyLock<[u8; GUESSES + 1]> = LazyLock::new(|| {
    std::array::from_fn(|at| {
        let low = (at as f32 / GUESSES as f32).powi(2);
        (0..=254).rev().find(|&byte| linear_from_srgb(byte) <= low).unwrap_or(0).saturating_sub(1)
    })
});

/// The nearest sRGB byte of a linear value, as [`voxtrace_scene::material::srgb_from_linear`], by tables.
fn srgb_byte(linear: f32) -> u32 {
    if linear.is_nan() || linear <= 0.0 {
        return 0;
    }
    if linear >= 1.0 {
        return 255;
    }
    let mut byte = usize::from(GUESS[(linear.sqrt() * GUESSES as f32) as usize]);
    while linear >= THRESHOLDS[byte] {
        byte += 1;
    }
    byte as u32
}

/// A linear colour as 0xRRGGBB of sRGB.
pub(super) fn rgb_bits(linear: Vec3) -> u32 {
    srgb_byte(linear.x) << 16 | srgb_byte(linear.y) << 8 | srgb_byte(linear.z)
}

/// Mantissa bits of each channel of an emission.
const MANTISSA: u32 = 9;
/// Bias of the shared exponent.
const BIAS: i32 = 12;

/// An emission in 32 bits: three mantissas of 9 bits and a shared exponent of 5, as RGB9E5. 0 where nothing is emitted.
pub(super) fn emission_bits(emission: Vec3) -> u32 {
    let largest = emission.max_element();
    if largest.is_nan() || largest <= 0.0 {
        return 0;
    }
    // Half an ulp more than the largest must still fit.
    let exponent = ((largest * (1.0 + 1.0 / 512.0)).log2().floor() as i32 + 1).clamp(-BIAS + 1, 31 - BIAS);
    let scale = 2f32.powi(MANTISSA as i32 - exponent);
    let [r, g, b] = emission.to_array().map(|value| ((value.max(0.0) * scale).round() as u32).min(511));
    if r | g | b == 0 {
        return 0;
    }
    r | g << 9 | b << 18 | ((exponent + BIAS) as u32) << 27
}

/// The emission that [`emission_bits`] encoded.
pub(super) fn emission_of(bits: u32) -> Vec3 {
    let scale = 2f32.powi((bits >> 27) as i32 - BIAS - MANTISSA as i32);
    Vec3::new((bits & 511) as f32, (bits >> 9 & 511) as f32, (bits >> 18 & 511) as f32) * scale
}

/// An emission without the lowest `lost` bits of its mantissas.
pub(super) fn coarser_emission(bits: u32, lost: u32) -> u32 {
    let mask = (511 >> lost) << lost;
    bits & (mask | mask << 9 | mask << 18 | 31 << 27)
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace_scene::material::srgb_from_linear;

    #[test]
    fn the_tables_agree_with_the_formula() {
        for step in 0..200_000 {
            let linear = (step as f32 / 199_000.0).powi(3);
            let (fast, slow) = (srgb_byte(linear), u32::from(srgb_from_linear(linear)));
            // Exactly between two bytes either is right.
            assert!(
                fast == slow || (linear - THRESHOLDS[fast.min(slow) as usize]).abs() < 1e-6,
                "{linear} {fast} {slow}"
            );
        }
        for byte in 0..=255 {
            assert_eq!(srgb_byte(linear_from_srgb(byte)), u32::from(byte));
        }
        assert_eq!((srgb_byte(f32::NAN), srgb_byte(-1.0), srgb_byte(2.0)), (0, 0, 255));
    }

    #[test]
    fn emission_keeps_its_colour_and_strength() {
        for emission in [[1.0, 1.0, 1.0], [15.0, 4.0, 0.5], [0.001, 0.0, 0.002], [3000.0, 2999.0, 1.0], [0.0, 0.0, 0.0]]
        {
            let emission = Vec3::from_array(emission);
            let back = emission_of(emission_bits(emission));
            assert!((back - emission).abs().max_element() <= emission.max_element() / 400.0, "{emission} {back}");
        }
        assert_eq!(emission_bits(Vec3::splat(f32::NAN)), 0);
        assert!(emission_of(emission_bits(Vec3::splat(1e30))).is_finite());
    }

    #[test]
    fn what_the_inside_absorbs_counts_voxels_and_without_it_the_colour_tints() {
        let glass =
            MeshMaterial { transmission: 1.0, absorption: Some(Vec3::new(2.0, 0.0, 1.0)), ..MeshMaterial::default() };
        let plain = MeshMaterial { absorption: None, ..glass.clone() };
        let of =
            |material: &MeshMaterial| material_of(0x808080, &BsdfClass::in_voxels(&[BsdfClass::of(material)], 0.25));
        assert_eq!(of(&glass).absorption, Vec3::new(0.5, 0.0, 0.25));
        assert_eq!(of(&plain).absorption, material_of(0x808080, &[BsdfClass::of(&plain)]).absorption);
        assert!(of(&plain).absorption.min_element() > 0.0);
        let opaque = MeshMaterial { transmission: 0.0, ..glass };
        assert_eq!(of(&opaque).absorption, Vec3::ZERO, "light does not enter it");
    }

    #[test]
    fn materials_alike_share_a_class_and_too_many_share_the_nearest() {
        let material = |roughness: f32| MeshMaterial { roughness, ..MeshMaterial::default() };
        let of = |materials: &[MeshMaterial]| BsdfClass::grouped(materials.iter().map(BsdfClass::of));
        let (of_material, classes) = of(&[material(0.5), material(0.1), material(0.5)]);
        assert_eq!((of_material, classes.len()), (vec![0, 1, 0], 2));
        let coated = MeshMaterial { coat: Some(0.5), ..material(0.5) };
        assert_eq!(of(&[material(0.5), coated]).1.len(), 2);
        let many: Vec<_> = (0..90).map(|i| material(i as f32 / 90.0)).collect();
        let (of_material, classes) = of(&many);
        assert_eq!((classes.len(), of_material[89]), (MAX_BSDF_CLASSES, 63));
    }
}
