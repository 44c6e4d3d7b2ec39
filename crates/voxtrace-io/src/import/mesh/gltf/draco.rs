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
        let bytes = buffers.view(names.buffer_view)?.0.bytes()?;
        let most = DecodeLimits::default()
            .with_max_points(limits.points)
            .with_max_faces(limits.points)
            .with_max_decoded_bytes(limits.bytes);
        let mut mesh = Mesh::new();
        let decoded = MeshDecoder::new().decode(&mut DecoderBuffer::new(&bytes).with_limits(most), &mut mesh);
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

    /// As `Accessors::vectors`; `None` where the attribute is not among the compressed ones, and may be read from its accessor.
    pub fn vectors(
        &self,
        name: &str,
        accessor: &Accessor,
        missing: f32,
        mut each: impl FnMut([f32; 4]),
    ) -> Result<Option<usize>, Fault> {
        let Some(&number) = self.names.attributes.get(name) else { return Ok(None) };
        let attribute = self.mesh.attribute_by_unique_id(number);
        let components = attribute.map_or(0, |attribute| attribute.num_components().into());
        let width = width_of(&accessor.kind).unwrap_or(0).min(components);
        let Some(attribute) = attribute.filter(|_| width > 0) else {
            if accessor.buffer_view.is_some() {
                return Ok(None);
            }
            // Its accessor has no bytes of its own: without these all would be 0.
            let what = format!("KHR_draco_mesh_compression: {name} is attribute {number}, which is not packed");
            return Err(Fault::malformed(what));
        };
        let count = self.mesh.num_points();
        for element in attribute.read_f32s(count, width).chunks_exact(width) {
            let mut vector = [missing; 4];
            for (value, &stored) in vector.iter_mut().zip(element) {
                *value = if accessor.normalized { normalized(stored, accessor.component_type) } else { stored };
            }
            each(vector);
        }
        Ok(Some(count))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::import::mesh::gltf::document::Document;

    /// Two triangles of four vertices, as Draco 1.5.7 packs them without quantization.
    const PACKED: &str = "\
        445241434f02020101000000040200020000011fff011101ff000001000903000000000000000000004000000000\
        0000803f00000000000000000000803f0000004000004040000000000000000000000000";

    #[test]
    fn an_attribute_that_is_named_and_not_there_is_an_error() {
        let digits: Vec<u8> = PACKED.bytes().map(|digit| char::from(digit).to_digit(16).unwrap() as u8).collect();
        let packed: Vec<u8> = digits.as_chunks().0.iter().map(|[high, low]| high << 4 | low).collect();
        let view = format!(r#"{{"buffer": 0, "byteLength": {}}}"#, packed.len());
        let text = format!(r#"{{"asset": {{"version": "2.0"}}, "bufferViews": [{view}]}}"#);
        let document: Document = serde_json::from_str(&text).unwrap();
        let buffers = Buffers::of_views(&document, vec![Some(packed)]);
        let names = r#"{"bufferView": 0, "attributes": {"POSITION": 0, "COLOR_0": 7}}"#;
        let names: Draco = serde_json::from_str(names).unwrap();
        let accessor = r#"{"componentType": 5126, "count": 4, "type": "VEC3"}"#;
        let mut accessor: Accessor = serde_json::from_str(accessor).unwrap();
        let Ok(geometry) = Geometry::read(&names, &buffers, &Limits::default()) else { panic!("it is not read") };
        let mut found = Vec::new();
        let mut read = |name: &str, from: &Accessor| geometry.vectors(name, from, 1.0, |vector| found.push(vector));
        assert!(matches!(read("POSITION", &accessor), Ok(Some(4))));
        assert!(matches!(read("TEXCOORD_0", &accessor), Ok(None)));
        assert!(read("COLOR_0", &accessor).is_err());
        // It may stand there unpacked as well.
        accessor.buffer_view = Some(0);
        assert!(matches!(read("COLOR_0", &accessor), Ok(None)));
        assert!(found.contains(&[1.0, 2.0, 3.0, 1.0]) && geometry.corners().len() == 6, "{found:?}");
    }
}
