//! A .vox document as a scene.

use super::{
    attributes::Attributes,
    camera::camera_of,
    document::{Body, Chunk, VoxFile},
    graph::{Graph, Walk},
    light::{Light, Picture},
    material::{material_of, old_material_of},
    model::{first_outside, grid_of},
    palette::default_palette,
};
use glam::Vec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::{path::Path, sync::Arc};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::{Material, linear_color};
use voxtrace_scene::scene::{Attachment, Instance, Keyframe, Layer, Scene};
use voxtrace_scene::sky::EnvironmentMap;
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, Limits};

/// Largest edge of a model: coordinates are bytes.
pub const MAX_EDGE: u32 = 256;

/// A model as the file holds it.
struct Model<'f> {
    size: [u32; 3],
    voxels: &'f [[u8; 4]],
    /// Byte offset of the first voxel.
    offset: u64,
}

impl VoxFile<'_> {
    /// The scene that the file describes: a grid for each model, a material for each of the 255 colour indices (index i is
    /// material i − 1), an instance for each shape of the scene graph. The document without its voxels goes along as an
    /// attachment, from which `export::vox` writes what the scene has no place for.
    ///
    /// # Errors
    /// If the file contradicts itself or goes beyond `limits`.
    pub fn to_scene(&self, path: &Path, limits: &Limits) -> Result<Scene, ImportError> {
        self.scene_under(path, limits, &mut |_| None)
    }

    /// As [`Self::to_scene`]; `map_of` gives the map of a picture that is the sky, `None` where it is not there.
    pub(crate) fn scene_under(
        &self,
        path: &Path,
        limits: &Limits,
        map_of: &mut dyn FnMut(&Picture) -> Option<Arc<EnvironmentMap>>,
    ) -> Result<Scene, ImportError> {
        let models = self.models(path, limits)?;
        let mut scene = Scene::new(path.file_stem().map(|stem| stem.to_string_lossy()).unwrap_or_default());
        scene.materials = self.materials(path)?;
        let (mut layer_indices, mut light) = (FxHashMap::default(), Light::default());
        for chunk in &self.chunks {
            let attributes = |dict| Attributes { dict, path, offset: chunk.offset };
            match &chunk.body {
                Body::Layer(layer, _) => {
                    layer_indices.insert(layer.id, scene.layers.len());
                    scene.layers.push(layer_of(&attributes(&layer.properties))?);
                }
                Body::Camera(camera) => scene.cameras.extend(camera_of(camera.id, &attributes(&camera.properties))?),
                Body::RenderObject(properties) => light.read(&attributes(properties))?,
                _ => {}
            }
        }
        scene.sky = light.sky(map_of).unwrap_or_default();
        if let Some(bytes) = self.to_bytes_without_voxels() {
            scene.attachments.push(Attachment { format: super::ATTACHMENT, bytes: bytes.into() });
        }
        let sizes: Vec<[u32; 3]> = models.iter().map(|model| model.size).collect();
        let layer_hidden: Vec<bool> = scene.layers.iter().map(|layer| layer.hidden).collect();
        let graph = Graph { path, sizes: &sizes, layer_indices: &layer_indices, layer_hidden: &layer_hidden, limits };
        (scene.instances, scene.groups) = match Walk::instances(graph, &self.chunks)? {
            Some(graph) => graph,
            None => {
                let is_packed = self.chunks.iter().any(|chunk| matches!(chunk.body, Body::Pack(_)));
                (without_graph(&sizes, is_packed), Vec::new())
            }
        };
        scene.grids = models.par_iter().map(|model| model.grid(path).map(Arc::new)).collect::<Result<_, _>>()?;
        Ok(scene)
    }

    /// The models, each with its size checked.
    fn models(&self, path: &Path, limits: &Limits) -> Result<Vec<Model<'_>>, ImportError> {
        let (mut models, mut size, mut count) = (Vec::new(), None, 0);
        for chunk in &self.chunks {
            let malformed = |what: &str| Err(ImportError::malformed(path, chunk.offset, what));
            match (&chunk.body, size) {
                (Body::Size(_), Some(_)) => return malformed("two sizes without voxels between them"),
                (Body::Size(edges), None) if edges.iter().any(|&edge| edge > MAX_EDGE) => {
                    let what = format!("a model of size {edges:?}, more than {MAX_EDGE} a side");
                    return Err(ImportError::malformed(path, chunk.offset + 12, what));
                }
                (Body::Size(edges), None) => size = Some((*edges, chunk)),
                (Body::Voxels(_), None) => return malformed("voxels without a size before them"),
                (Body::Voxels(voxels), Some((edges, _))) => {
                    count += voxels.len() as u64;
                    if count > limits.voxels {
                        return Err(ImportError::limit(path, Some(chunk.offset), "voxels", count, limits.voxels));
                    }
                    // Twelve bytes of chunk header and the count stand before the voxels.
                    models.push(Model { size: edges, voxels, offset: chunk.offset + 16 });
                    size = None;
                }
                _ => {}
            }
        }
        match size {
            Some((_, chunk)) => Err(ImportError::malformed(path, chunk.offset, "a size without voxels after it")),
            None => Ok(models),
        }
    }

    fn materials(&self, path: &Path) -> Result<Vec<Material>, ImportError> {
        let given = self.chunks.iter().rev().find_map(|chunk| match &chunk.body {
            Body::Palette(palette) => Some(**palette),
            _ => None,
        });
        let palette = given.unwrap_or_else(default_palette);
        let colors: Vec<Vec3> = palette[..255].iter().map(|[r, g, b, _]| linear_color([*r, *g, *b])).collect();
        let mut materials: Vec<Material> = colors.iter().copied().map(Material::diffuse).collect();
        for Chunk { body, offset, .. } in &self.chunks {
            let id = match body {
                Body::Material(material) => material.id,
                Body::OldMaterial(material) => material.id,
                _ => continue,
            };
            let Some(index) = usize::try_from(id).ok().and_then(|id| id.checked_sub(1)).filter(|&index| index < 255)
            else {
                continue;
            };
            materials[index] = match body {
                Body::Material(material) => {
                    material_of(&Attributes { dict: &material.properties, path, offset: *offset }, colors[index])?
                }
                Body::OldMaterial(material) => old_material_of(material, colors[index]),
                _ => continue,
            };
        }
        Ok(materials)
    }
}

impl Model<'_> {
    fn grid(&self, path: &Path) -> Result<VoxelGrid, ImportError> {
        match first_outside(self.size, self.voxels) {
            Some(index) => {
                let [x, y, z, _] = self.voxels[index];
                let what = format!("the voxel {:?} lies outside its model of size {:?}", [x, y, z], self.size);
                Err(ImportError::malformed(path, self.offset + 4 * index as u64, what))
            }
            None => Ok(grid_of(self.voxels)),
        }
    }
}

fn layer_of(attributes: &Attributes) -> Result<Layer, ImportError> {
    Ok(Layer {
        name: attributes.text("_name").unwrap_or_default(),
        hidden: attributes.flag("_hidden"),
        color: attributes.numbers("_color")?,
    })
}

/// The instances of a file from before the scene graph: MagicaVoxel stands such a model on the ground plane in the middle.
/// Several models are the frames of an animation where the file says PACK, and otherwise stand in one place.
fn without_graph(sizes: &[[u32; 3]], packed: bool) -> Vec<Instance> {
    let placed = |grid: usize| {
        let [x, y, _] = sizes[grid].map(|edge| (edge / 2) as f32);
        (grid, Transform::from_translation(Vec3::new(-x, -y, 0.0)))
    };
    let mut instances: Vec<Instance> =
        (0..sizes.len()).map(placed).map(|(grid, transform)| Instance::new(grid, transform)).collect();
    if packed && instances.len() > 1 {
        let keyframe = |(frame, instance): (usize, &Instance)| {
            Keyframe::still(frame as u32, instance.grid, instance.world_from_grid)
        };
        let keyframes: Vec<Keyframe> = instances.iter().enumerate().map(keyframe).collect();
        instances.truncate(1);
        instances[0].repeats = Some(0..keyframes.len() as u32);
        instances[0].keyframes = keyframes;
    }
    instances
}
