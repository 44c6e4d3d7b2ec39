//! Scenes that came from a .vox file go back into the chunks that they came from: what has not changed since is written as the
//! file said it, with all that voxtrace does not interpret, and only the rest is made anew. What has changed is seen by reading
//! the kept document (the scene's attachment) once more.

use super::{camera, entry::Entry, layer_of, light, palette::Palette, pieces};
use crate::export::{ExportError, Wanted};
use crate::import::Limits;
use crate::import::vox::{
    ATTACHMENT, Body, Chunk, VoxFile,
    light::{Picture, is_light, is_understood},
    palette::default_palette,
};
use glam::{IVec3, UVec3};
use rayon::prelude::*;
use std::{borrow::Cow, collections::BTreeSet, path::Path, sync::Arc};
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::Scene;

/// The document that a scene came from, and the scene as it was then, its models empty.
pub struct Kept<'s> {
    file: VoxFile<'s>,
    before: Scene,
}

impl<'s> Kept<'s> {
    /// The document of a scene, `None` where it came from elsewhere.
    pub fn of(scene: &'s Scene) -> Option<Self> {
        let attachment = scene.attachments.iter().find(|attachment| attachment.format == ATTACHMENT)?;
        let none = u64::MAX;
        let limits = Limits { bytes: none, voxels: none, points: none, items: none, depth: u32::MAX, ratio: none };
        let file = VoxFile::parse(&attachment.bytes, Path::new(&scene.name), &limits).ok()?;
        // Where the sky was a picture, it still is unless it was changed.
        let mut map_of = |_: &Picture| scene.sky.background().environment().map(|now| now.map().clone());
        let before = file.scene_under(Path::new(&scene.name), &limits, &mut map_of).ok()?;
        Some(Self { file, before })
    }

    /// What the document says beyond a scene, one phrase each.
    pub fn beyond_scenes(&self) -> Vec<String> {
        let (mut materials, mut settings, mut others) = (0, 0, BTreeSet::new());
        for chunk in &self.file.chunks {
            match &chunk.body {
                Body::Material(material) => {
                    let kind = material.properties.get("_type").unwrap_or(b"_diffuse");
                    let is_known = [&b"_diffuse"[..], b"_emit", b"_metal", b"_glass", b"_blend"].contains(&kind);
                    materials += usize::from(!is_known);
                }
                Body::RenderObject(properties) => settings += usize::from(!is_understood(properties)),
                Body::Notes(_) | Body::IndexMap(_) | Body::Unknown(..) => {
                    others.insert(String::from_utf8_lossy(&chunk.name()).into_owned());
                }
                _ => {}
            }
        }
        let counts = [("materials of other kinds", materials), ("render settings", settings)];
        let counted =
            counts.into_iter().filter(|&(_, count)| count > 0).map(|(what, count)| format!("{what} ({count})"));
        counted.chain(others).collect()
    }

    fn sizes(&self) -> Vec<[u32; 3]> {
        let size = |chunk: &Chunk| if let Body::Size(size) = chunk.body { Some(size) } else { None };
        self.file.chunks.iter().filter_map(size).collect()
    }

    /// Whether the models still fit their sizes and stand where they stood.
    fn has_same_graph(&self, scene: &Scene) -> bool {
        let fits = |(grid, size): (&Arc<VoxelGrid>, &[u32; 3])| {
            let size = UVec3::from_array(*size).as_ivec3();
            grid.bounds().is_none_or(|b| b.min.cmpge(IVec3::ZERO).all() && b.max.cmple(size).all())
        };
        let sizes = self.sizes();
        scene.instances == self.before.instances
            && scene.layers == self.before.layers
            && scene.grids.len() == sizes.len()
            && scene.grids.iter().zip(&sizes).all(fits)
    }

    /// The colour indices whose material is another one than before; `None` where the list of materials is another one.
    fn changed_colors(&self, scene: &Scene) -> Option<Vec<usize>> {
        let pairs = scene.materials.iter().zip(&self.before.materials);
        let is_dimmed = scene.light_intensity != self.before.light_intensity;
        let is_other = |(is, was): (&Material, &Material)| is != was || (is.is_emissive() && is_dimmed);
        let is_same_list = scene.materials.len() == self.before.materials.len();
        let changed = (1..).zip(pairs).filter(|(_, pair)| is_other(*pair)).map(|(index, _)| index);
        is_same_list.then(|| changed.collect())
    }

    /// The document of the scene as it is now, and what of the old one could not be kept, one phrase each.
    ///
    /// # Errors
    /// As [`super::document_of`].
    pub fn document_of(self, scene: &'s Scene, wanted: Wanted) -> Result<(VoxFile<'s>, Vec<String>), ExportError> {
        let mut rewrite = Rewrite {
            scene,
            palette: Palette::of(scene),
            changed: self.changed_colors(scene),
            same_graph: self.has_same_graph(scene),
            same_sky: scene.sky == self.before.sky,
            same_cameras: scene.cameras == self.before.cameras,
            lost: Lost::default(),
        };
        let mut chunks = Vec::new();
        let mut models = Vec::new().into_iter();
        if rewrite.same_graph {
            let voxels_of = |grid: &Arc<VoxelGrid>| pieces::voxels_of(grid, &rewrite.palette, wanted);
            models = scene.grids.par_iter().map(voxels_of).collect::<Vec<_>>().into_iter();
        } else {
            chunks.extend(super::models_and_nodes(scene, &rewrite.palette, wanted)?.into_iter().map(Chunk::new));
        }
        for mut chunk in self.file.chunks {
            if rewrite.keeps(&mut chunk.body) {
                if let Body::Voxels(voxels) = &mut chunk.body {
                    *voxels = Cow::Owned(models.next().unwrap_or_default());
                }
                chunks.push(chunk);
            }
        }
        let has_palette = chunks.iter().any(|chunk| matches!(chunk.body, Body::Palette(_)));
        chunks.extend(rewrite.made_anew(has_palette).into_iter().map(Chunk::new));
        let mut lost = rewrite.lost.told();
        lost.extend(light::lost_of(&scene.sky).filter(|_| !rewrite.same_sky));
        Ok((VoxFile { chunks, ..self.file }, lost))
    }
}

/// What of a document is kept and what is made anew.
struct Rewrite<'s> {
    scene: &'s Scene,
    palette: Palette,
    /// As [`Kept::changed_colors`] says.
    changed: Option<Vec<usize>>,
    same_graph: bool,
    same_sky: bool,
    same_cameras: bool,
    lost: Lost,
}

impl Rewrite<'_> {
    /// Whether a chunk is kept; a palette that is gets the colours that have changed.
    fn keeps(&mut self, body: &mut Body) -> bool {
        match body {
            Body::Pack(_) | Body::Size(_) | Body::Voxels(_) | Body::Shape(_) | Body::Layer(..) => self.same_graph,
            Body::Transform(_) => self.same_graph,
            Body::Group(_) => {
                self.lost.has_groups |= !self.same_graph;
                self.same_graph
            }
            Body::Palette(colors) => {
                self.paint(colors);
                self.changed.is_some()
            }
            Body::Material(material) => {
                let is_kept = self.is_unchanged(material.id);
                let is_plain = material.properties.get("_type").is_none_or(|kind| kind == b"_diffuse");
                self.lost.materials += usize::from(!is_kept && !is_plain);
                is_kept
            }
            Body::OldMaterial(material) => self.is_unchanged(material.id),
            Body::Notes(_) | Body::IndexMap(_) => {
                self.lost.has_order |= self.changed.is_none();
                self.changed.is_some()
            }
            Body::RenderObject(properties) => self.same_sky || !is_light(properties),
            Body::Camera(_) => self.same_cameras,
            Body::Unknown(..) => true,
        }
    }

    /// What stands in for the chunks that are not kept.
    fn made_anew(&self, has_palette: bool) -> Vec<Body<'static>> {
        let scene = self.scene;
        let mut bodies = Vec::new();
        if !self.same_graph {
            bodies.extend((0..).zip(&scene.layers).map(|(id, layer)| layer_of(id, layer)));
        }
        match &self.changed {
            None => {
                bodies.push(Body::Palette(self.palette.colors()));
                bodies.extend(self.palette.materials());
            }
            Some(changed) => {
                if !changed.is_empty() && !has_palette {
                    let mut colors = Box::new(default_palette());
                    self.paint(&mut colors);
                    bodies.push(Body::Palette(colors));
                }
                let entry = |&index: &usize| Entry::of(&scene.materials[index - 1], scene.light_intensity);
                bodies.extend(changed.iter().map(|index| entry(index).chunk(*index as i32)));
            }
        }
        if !self.same_sky {
            bodies.extend(light::objects_of(&scene.sky));
        }
        if !self.same_cameras {
            bodies.extend(camera::cameras_of(&scene.cameras));
        }
        bodies
    }

    fn is_unchanged(&self, id: i32) -> bool {
        self.changed.as_ref().is_some_and(|changed| !changed.iter().any(|&index| i32::try_from(index) == Ok(id)))
    }

    /// Gives a palette the colours that have changed.
    fn paint(&self, colors: &mut [[u8; 4]; 256]) {
        let own = self.palette.colors();
        for &index in self.changed.iter().flatten() {
            colors[index - 1] = own[index - 1];
        }
    }
}

/// What could not be kept.
#[derive(Default)]
struct Lost {
    has_groups: bool,
    materials: usize,
    has_order: bool,
}

impl Lost {
    fn told(&self) -> Vec<String> {
        let mut told = Vec::new();
        if self.has_groups {
            told.push("the groups of the scene graph".to_owned());
        }
        if self.materials > 0 {
            told.push(format!("MagicaVoxel's settings of {} materials", self.materials));
        }
        if self.has_order {
            told.push("names and order of the palette".into());
        }
        told
    }
}
