//! The materials of a level of detail: those that it keeps, and mixed ones, whose colours are rounded so that there are not too many.

use super::block::Block;
use crate::packed::PackedMaterial;
use glam::Vec3;
use rustc_hash::FxHashMap;
use voxtrace_scene::material::MAX_MATERIALS;

/// Materials that differ in nothing but their colour, and what their surface emits.
pub struct Kinds {
    /// The kind of each material.
    pub of_material: Vec<u16>,
    /// One of each kind, without colour.
    pub materials: Vec<PackedMaterial>,
}

impl Kinds {
    pub fn of(materials: &[PackedMaterial]) -> Self {
        let mut kinds = Self { of_material: Vec::new(), materials: Vec::new() };
        let mut known: FxHashMap<[u32; 16], u16> = FxHashMap::default();
        for material in materials {
            // What glows within belongs to the medium.
            let emission = if material.is_without_surface() { material.emission } else { Vec3::ZERO };
            let kind = PackedMaterial { base_color: Vec3::ZERO, emission, ..*material };
            let number = *known.entry(bytemuck::cast(kind)).or_insert_with(|| {
                kinds.materials.push(kind);
                (kinds.materials.len() - 1) as u16
            });
            kinds.of_material.push(number);
        }
        kinds
    }

    /// Whether what is within voxels of a kind does something to light.
    pub fn has_medium(&self, kind: u16) -> bool {
        let material = &self.materials[usize::from(kind)];
        material.scattering > 0.0 || material.absorption != Vec3::ZERO || material.emission != Vec3::ZERO
    }
}

/// How finely colours are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rounding {
    /// Bits of the square root of a channel.
    bits: u32,
    /// Whether materials that are not mixed are kept as they are.
    keeps: bool,
    /// Whether the nearest material is taken where there is no room for another.
    pub is_last: bool,
}

impl Rounding {
    /// What is tried one after the other, until the materials suffice.
    pub const ALL: [Self; 4] = [
        Self { bits: 7, keeps: true, is_last: false },
        Self { bits: 6, keeps: false, is_last: false },
        Self { bits: 5, keeps: false, is_last: false },
        Self { bits: 4, keeps: false, is_last: true },
    ];
}

/// What materials are told apart by.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Look {
    /// A material that is kept.
    Kept(u16),
    /// Kind, share of the block where there is a medium, colour, and emission.
    Mixed(u16, u8, [u8; 3], [u32; 3]),
}

/// Bits of the fraction of an emission that are kept.
const EMISSION_BITS: u32 = 5;

impl Look {
    pub fn of(block: &Block, kinds: &Kinds, rounding: Rounding) -> Self {
        if let Some(material) = block.same.filter(|_| rounding.keeps) {
            return Self::Kept(material);
        }
        let most = ((1 << rounding.bits) - 1) as f32;
        // The square root is near to how bright people see, and rounded alike on all machines.
        let color = block.base_color.to_array().map(|channel| (channel.clamp(0.0, 1.0).sqrt() * most).round() as u8);
        let lost = 23 - EMISSION_BITS;
        let emission = block.emission.to_array().map(|channel| (channel.to_bits() + (1 << (lost - 1))) >> lost << lost);
        Self::Mixed(block.kind, if kinds.has_medium(block.kind) { block.share } else { 0 }, color, emission)
    }

    fn material(self, materials: &[PackedMaterial], kinds: &Kinds, rounding: Rounding) -> PackedMaterial {
        match self {
            Self::Kept(material) => materials[usize::from(material)],
            Self::Mixed(kind, share, color, emission) => {
                let most = ((1 << rounding.bits) - 1) as f32;
                let material = kinds.materials[usize::from(kind)];
                let root = Vec3::from_array(color.map(|code| f32::from(code) / most));
                // Coefficients are per voxel, which is twice as long and filled to a share.
                let thicker = if share > 0 { 2.0 * f32::from(share) / 8.0 } else { 1.0 };
                let surface = Vec3::from_array(emission.map(f32::from_bits));
                PackedMaterial {
                    base_color: root * root,
                    emission: if material.is_without_surface() { material.emission * thicker } else { surface },
                    absorption: material.absorption * thicker,
                    scattering: material.scattering * thicker,
                    ..material
                }
            }
        }
    }
}

/// The materials of a level so far, in the order in which they came.
pub struct Materials<'a> {
    below: &'a [PackedMaterial],
    kinds: &'a Kinds,
    rounding: Rounding,
    index_of: FxHashMap<Look, u16>,
    pub all: Vec<PackedMaterial>,
}

impl<'a> Materials<'a> {
    pub fn new(below: &'a [PackedMaterial], kinds: &'a Kinds, rounding: Rounding) -> Self {
        Self { below, kinds, rounding, index_of: FxHashMap::default(), all: Vec::new() }
    }

    /// The material of a look; `None` where there is no room for another.
    pub fn index(&mut self, look: Look) -> Option<u16> {
        if let Some(&index) = self.index_of.get(&look) {
            return Some(index);
        }
        let material = look.material(self.below, self.kinds, self.rounding);
        let index = if self.all.len() < MAX_MATERIALS {
            self.all.push(material);
            self.all.len() - 1
        } else if self.rounding.is_last {
            let distance = |other: &PackedMaterial| {
                let of_kind = |m: &PackedMaterial| Vec3::new(m.transmission, m.metallic, m.roughness) * 4.0;
                (other.base_color - material.base_color).length_squared()
                    + (of_kind(other) - of_kind(&material)).length_squared()
                    + (other.emission - material.emission).length_squared()
            };
            let by_distance = |a: &(usize, f32), b: &(usize, f32)| a.1.total_cmp(&b.1);
            self.all.iter().map(distance).enumerate().min_by(by_distance)?.0
        } else {
            return None;
        };
        self.index_of.insert(look, index as u16);
        Some(index as u16)
    }
}
