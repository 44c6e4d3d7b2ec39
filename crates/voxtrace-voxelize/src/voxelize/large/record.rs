//! How a triangle lies on the disk while triangles are sorted.

use crate::mesh::Mesh;
use crate::mesh::source::SourceColors;
use crate::voxelize::appearance::rgb_bits;
use glam::{Vec2, Vec3, Vec4};
use voxtrace_scene::material::linear_from_srgb;

/// Layout of a triangle on the disk: positions, colours and texture coordinates of its corners, then its material.
pub(super) struct Record {
    pub colors: SourceColors,
    pub has_uvs: bool,
    pub has_materials: bool,
}

impl Record {
    fn color_size(&self) -> usize {
        match self.colors {
            SourceColors::None => 0,
            SourceColors::Bytes => 3,
            SourceColors::Linear => 16,
        }
    }

    /// Bytes of a triangle on the disk.
    pub fn size(&self) -> usize {
        let material = if self.has_materials { 2 } else { 0 };
        3 * (12 + self.color_size() + if self.has_uvs { 8 } else { 0 }) + material
    }

    /// Bytes of a triangle in memory, its (tile, triangle) pairs included.
    pub fn bytes_in_memory(&self) -> u64 {
        let (colors, uvs) = (if self.colors == SourceColors::None { 0 } else { 48 }, if self.has_uvs { 24 } else { 0 });
        36 + colors + uvs + 24 + if self.has_materials { 2 } else { 0 }
    }

    pub fn encode(&self, mesh: &Mesh, triangle: usize, bytes: &mut Vec<u8>) {
        let corners = 3 * triangle..3 * triangle + 3;
        bytes.extend_from_slice(bytemuck::cast_slice(&mesh.positions[corners.clone()]));
        match self.colors {
            SourceColors::None => {}
            SourceColors::Bytes => {
                for color in &mesh.colors[corners.clone()] {
                    bytes.extend_from_slice(&rgb_bits(color.truncate()).to_le_bytes()[..3]);
                }
            }
            SourceColors::Linear => bytes.extend_from_slice(bytemuck::cast_slice(&mesh.colors[corners.clone()])),
        }
        if self.has_uvs {
            bytes.extend_from_slice(bytemuck::cast_slice(&mesh.uvs[corners]));
        }
        if self.has_materials {
            bytes.extend_from_slice(&mesh.material_of[triangle].to_ne_bytes());
        }
    }

    /// Appends whole records to a mesh.
    pub fn append_all(&self, bytes: &[u8], mesh: &mut Mesh) {
        let linear: [f32; 256] = std::array::from_fn(|byte| linear_from_srgb(byte as u8));
        for record in bytes.chunks_exact(self.size()) {
            let (positions, rest) = record.split_at(36);
            let (colors, rest) = rest.split_at(3 * self.color_size());
            let (uvs, material) = rest.split_at(if self.has_uvs { 24 } else { 0 });
            mesh.positions.extend(floats::<3>(positions).map(Vec3::from_array));
            match self.colors {
                SourceColors::None => {}
                SourceColors::Bytes => {
                    let linear = |byte: u8| linear[usize::from(byte)];
                    let colors = colors.as_chunks().0.iter();
                    mesh.colors.extend(colors.map(|&[b, g, r]| Vec4::new(linear(r), linear(g), linear(b), 1.0)));
                }
                SourceColors::Linear => mesh.colors.extend(floats::<4>(colors).map(Vec4::from_array)),
            }
            mesh.uvs.extend(floats::<2>(uvs).map(Vec2::from_array));
            mesh.material_of.extend(material.first_chunk().map(|bytes| u16::from_ne_bytes(*bytes)));
        }
    }
}

fn floats<const N: usize>(bytes: &[u8]) -> impl Iterator<Item = [f32; N]> + '_ {
    bytes.chunks_exact(4 * N).map(|vector| {
        std::array::from_fn(|at| {
            let bytes = &vector[4 * at..4 * at + 4];
            f32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])
        })
    })
}
