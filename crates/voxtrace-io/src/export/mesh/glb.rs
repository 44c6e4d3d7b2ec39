//! Binary glTF 2.0 (Khronos): a mesh for each grid and a node for each instance, so that what stands many times is stored once. Matte
//! materials are colours of vertices in one primitive; each other one has a primitive of its own. y is up; a unit is a metre, or a voxel
//! where a scene has no size.

use super::{Surfaces, gltf_material, left_out};
use crate::export::{ExportError, Wanted, go_on};
use glam::{IVec3, Vec3};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::Path;
use voxtrace_core::atomic_file::write_atomically_while;
use voxtrace_scene::faces::FaceRectangle;
use voxtrace_scene::scene::{Instance, Scene, Unit};

const FORMAT: &str = ".glb";
/// Component types of glTF.
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
/// Targets of buffer views.
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
/// Corners of the two triangles of a quadrilateral.
const TRIANGLES: [u32; 6] = [0, 1, 2, 0, 2, 3];

/// Writes the surface of a scene as a binary glTF file.
pub fn write(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let surfaces = Surfaces::of(scene, wanted)?;
    let document = Document::of(&surfaces, wanted);
    go_on(wanted)?;
    let json = document.json(&surfaces).to_string();
    let json_size = json.len().next_multiple_of(4) as u64;
    // Two chunks behind a header.
    let size = 12 + 8 + json_size + 8 + document.bytes;
    let Ok(size) = u32::try_from(size) else {
        return Err(ExportError::TooLarge { format: FORMAT, what: "the faces" });
    };
    write_atomically_while(path, wanted, |file| {
        let words = [0x4654_6c67, 2, size, json_size as u32, 0x4e4f_534a];
        words.iter().try_for_each(|word: &u32| file.write_all(&word.to_le_bytes()))?;
        file.write_all(json.as_bytes())?;
        // Chunks are filled up with spaces.
        file.write_all(&b"   "[..json_size as usize - json.len()])?;
        [document.bytes as u32, 0x004e_4942].iter().try_for_each(|word: &u32| file.write_all(&word.to_le_bytes()))?;
        document.primitives.iter().try_for_each(|primitive| primitive.write(file, scene))
    })
    .map_err(|error| ExportError::Io { path: path.into(), error })?;
    let scattering = scene.materials.iter().filter(|material| material.scattering > 0.0).count();
    let mut lost = left_out(scene);
    lost.extend((scattering > 0).then(|| format!("scattering in media ({scattering})")));
    Ok(lost)
}

/// Rectangles of one material, or of all matte ones, of a grid.
struct Primitive {
    /// `None` where vertices have colours.
    material: Option<u16>,
    rectangles: Vec<FaceRectangle>,
    /// Where its bytes begin.
    offset: u64,
}

impl Primitive {
    fn vertices(&self) -> u64 {
        4 * self.rectangles.len() as u64
    }

    /// Bytes of positions, of colours and of indices.
    fn sizes(&self) -> [u64; 3] {
        let colors = if self.material.is_none() { 8 * self.vertices() } else { 0 };
        [12 * self.vertices(), colors, 6 * self.vertices()]
    }

    fn bounds(&self) -> (Vec3, Vec3) {
        let corners = self.rectangles.iter().flat_map(FaceRectangle::corners);
        let fold = |(low, high): (IVec3, IVec3), corner: IVec3| (low.min(corner), high.max(corner));
        let (low, high) = corners.fold((IVec3::MAX, IVec3::MIN), fold);
        (low.as_vec3(), high.as_vec3())
    }

    fn write(&self, file: &mut impl Write, scene: &Scene) -> io::Result<()> {
        for corner in self.rectangles.iter().flat_map(FaceRectangle::corners) {
            for coordinate in corner.as_vec3().to_array() {
                file.write_all(&coordinate.to_le_bytes())?;
            }
        }
        if self.material.is_none() {
            for rectangle in &self.rectangles {
                let color = scene.materials[usize::from(rectangle.material)].base_color;
                let [red, green, blue] = color.to_array().map(|channel| (channel.clamp(0.0, 1.0) * 65_535.0).round());
                let color = [red, green, blue, 65_535.0].map(|channel| (channel as u16).to_le_bytes());
                (0..4).try_for_each(|_| file.write_all(color.as_flattened()))?;
            }
        }
        for first in (0..self.vertices() as u32).step_by(4) {
            TRIANGLES.iter().try_for_each(|corner| file.write_all(&(first + corner).to_le_bytes()))?;
        }
        Ok(())
    }
}

/// What goes into the file, and where.
struct Document {
    primitives: Vec<Primitive>,
    /// For each grid its mesh, and for each mesh its primitives.
    mesh_of_grid: Vec<Option<usize>>,
    meshes: Vec<std::ops::Range<usize>>,
    bytes: u64,
}

impl Document {
    /// Where it is not wanted any more rectangles are missing.
    fn of(surfaces: &Surfaces, wanted: Wanted) -> Self {
        let mut document = Self { primitives: Vec::new(), mesh_of_grid: Vec::new(), meshes: Vec::new(), bytes: 0 };
        for rectangles in &surfaces.rectangles {
            let mut parts: BTreeMap<Option<u16>, Vec<FaceRectangle>> = BTreeMap::new();
            for rectangle in rectangles.iter().take_while(|_| wanted()) {
                let is_plain = gltf_material::is_plain(&surfaces.scene.materials[usize::from(rectangle.material)]);
                let material = Some(rectangle.material).filter(|_| !is_plain);
                parts.entry(material).or_default().push(*rectangle);
            }
            let first = document.primitives.len();
            for (material, rectangles) in parts {
                let primitive = Primitive { material, rectangles, offset: document.bytes };
                document.bytes += primitive.sizes().iter().sum::<u64>();
                document.primitives.push(primitive);
            }
            let is_empty = rectangles.is_empty();
            document.mesh_of_grid.push((!is_empty).then_some(document.meshes.len()));
            if !is_empty {
                document.meshes.push(first..document.primitives.len());
            }
        }
        document
    }

    fn json(&self, surfaces: &Surfaces) -> Value {
        let scene = surfaces.scene;
        let edge = scene.voxel_size * if scene.unit == Unit::Millimetre { 1e-3 } else { 1.0 };
        let (mut views, mut accessors, mut parts) = (Vec::new(), Vec::new(), Vec::new());
        let (mut materials, mut material_of): (Vec<Value>, BTreeMap<Option<u16>, usize>) = Default::default();
        for primitive in &self.primitives {
            let material = *material_of.entry(primitive.material).or_insert_with(|| {
                materials.push(match primitive.material {
                    None => gltf_material::colors(),
                    Some(index) => {
                        let material = &scene.materials[usize::from(index)];
                        gltf_material::of(material, index, scene.light_intensity, edge)
                    }
                });
                materials.len() - 1
            });
            let (low, high) = primitive.bounds();
            let mut view = |offset: u64, size: u64, target: u32| {
                views.push(json!({ "buffer": 0, "byteOffset": offset, "byteLength": size, "target": target }));
                views.len() - 1
            };
            let [positions, colors, indices] = primitive.sizes();
            let (begin, vertices) = (primitive.offset, primitive.vertices());
            let mut accessor = |value: Value| {
                accessors.push(value);
                accessors.len() - 1
            };
            let (min, max) = (low.to_array(), high.to_array());
            let mut attributes = json!({ "POSITION": accessor(json!({
                "bufferView": view(begin, positions, ARRAY_BUFFER),
                "componentType": FLOAT, "count": vertices, "type": "VEC3", "min": min, "max": max,
            })) });
            if colors > 0 {
                attributes["COLOR_0"] = json!(accessor(json!({
                    "bufferView": view(begin + positions, colors, ARRAY_BUFFER),
                    "componentType": UNSIGNED_SHORT, "normalized": true, "count": vertices, "type": "VEC4",
                })));
            }
            let indices = accessor(json!({
                "bufferView": view(begin + positions + colors, indices, ELEMENT_ARRAY_BUFFER),
                "componentType": UNSIGNED_INT, "count": vertices / 4 * 6, "type": "SCALAR",
            }));
            parts.push(json!({ "attributes": attributes, "indices": indices, "material": material, "mode": 4 }));
        }
        let meshes = self.meshes.iter().map(|range| json!({ "primitives": parts[range.clone()] }));
        let meshes: Vec<Value> = meshes.collect();
        // From z up to y up, and from voxels to metres: the columns of a matrix.
        let root = [edge, 0.0, 0.0, 0.0, 0.0, 0.0, -edge, 0.0, 0.0, edge, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
        let instances: Vec<Value> =
            surfaces.instances().map(|(instance, _)| node(instance, self.mesh_of_grid[instance.grid])).collect();
        let children: Vec<usize> = (1..=instances.len()).collect();
        let mut nodes = vec![json!({ "name": scene.name, "matrix": root })];
        let extensions = gltf_material::extensions_of(&materials);
        let mut document = json!({
            "asset": { "version": "2.0", "generator": "voxtrace" },
            "scene": 0,
            "scenes": [{ "nodes": [0] }],
        });
        let mut add = |name: &str, all: Vec<Value>| {
            // The format has no empty lists.
            if !all.is_empty() {
                document[name] = all.into();
            }
        };
        if !children.is_empty() {
            nodes[0]["children"] = json!(children);
            add("buffers", vec![json!({ "byteLength": self.bytes })]);
        }
        nodes.extend(instances);
        add("nodes", nodes);
        add("meshes", meshes);
        add("materials", materials);
        add("accessors", accessors);
        add("bufferViews", views);
        add("extensionsUsed", extensions.into_iter().map(Value::from).collect());
        document
    }
}

/// The node of an instance.
fn node(instance: &Instance, mesh: Option<usize>) -> Value {
    let columns = instance.world_from_grid.linear.to_cols_array().map(f64::from);
    let [x, y, z] = instance.world_from_grid.translation.to_array().map(f64::from);
    let [a, b, c, d, e, f, g, h, i] = columns;
    let mut node = json!({ "mesh": mesh, "matrix": [a, b, c, 0.0, d, e, f, 0.0, g, h, i, 0.0, x, y, z, 1.0] });
    if !instance.name.is_empty() {
        node["name"] = json!(instance.name);
    }
    node
}
