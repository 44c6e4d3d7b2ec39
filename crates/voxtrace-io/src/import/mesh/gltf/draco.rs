//! Primitives that are compressed by `KHR_draco_mesh_compression`, by the crate `draco-core`.

use super::Fault;
use super::accessor::{normalized, width_of};
use super::buffers::Buffers;
use super::document::{Accessor, Draco};
use draco_core::{DecodeLimits, DecoderBuffer, Mesh, MeshDecoder};
use voxtrace_voxelize::Limits;

/// The vertices and triangles of a primitive.
pub(super) struct Geometry<'a> {
    mesh: Mesh,
    names: &'a Draco,
}

impl<'a> Geometry<'a> {
    pub fn read(names: &'a Draco, buffers: &Buffers, limits: &Limits) -> Result<Self, Fault> {
        let (bytes, _) = buffers.view(names.buffer_view)?;
        let most = DecodeLimits::default()
            .with_max_points(limits.points)
            .with_max_faces(limits.points)
            .with_max_decoded_bytes(limits.bytes);
        let mut mesh = Mesh::new();
        let decoded = MeshDecoder::new().decode(&mut DecoderBuffer::new(bytes).with_limits(most), &mut mesh);
        decoded.map_err(|error| Fault::malformed(format!("KHR_draco_mesh_compression: {error}")))?;
        if mesh.num_points() as u64 > limits.points {
            return Err(Fault::limit("vertices", mesh.num_points() as u64, limits.points));
        }
        Ok(Self { mesh, names })
    }

    /// The corners of the triangles.
    pub fn corners(&self) -> Vec<u32> {
        self.mesh.faces().iter().flatten().map(|corner| corner.0).collect()
    }

    /// As `Accessors::vectors`, where the attribute is among the compressed ones.
    pub fn vectors(
        &self,
        name: &str,
        accessor: &Accessor,
        missing: f32,
        mut each: impl FnMut([f32; 4]),
    ) -> Option<usize> {
        let attribute = self.mesh.attribute_by_unique_id(*self.names.attributes.get(name)?)?;
        let width = width_of(&accessor.kind)?.min(attribute.num_components().into());
        let count = self.mesh.num_points();
        if width == 0 {
            return None;
        }
        for element in attribute.read_f32s(count, width).chunks_exact(width) {
            let mut vector = [missing; 4];
            for (value, &stored) in vector.iter_mut().zip(element) {
                *value = if accessor.normalized { normalized(stored, accessor.component_type) } else { stored };
            }
            each(vector);
        }
        Some(count)
    }
}
