//! The scene of all chunks of a level: that which was saved, array by array, whatever order the chunks come in.

use super::super::file_error::{FileErrorKind, damaged};
use super::super::lights::append_lights_of_grid;
use super::super::pack::{CellsOfGrid, cells_of, levels_of, ordered_position, top_offset};
use super::super::parts::kept_instances;
use super::super::{
    CELL_OCCUPIED, Geometry, Outline, PackedGrid, PackedInstance, PackedScene, Placement, section_reader::Reader,
    settings::EnvironmentSections,
};
use super::chunk::{Chunk, StoredBrick};
use super::head::{Front, StreamHead, invalid, reader_of};
use glam::{IVec3, Mat3, Vec3};
use rayon::prelude::*;
use std::sync::Arc;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::sky::{Background, Sky};
use voxtrace_scene::transform::Transform;

/// A level whose chunks arrive.
pub struct WholeLevel {
    head: StreamHead,
    front: Front,
    /// The environment map, and the parts of a merged grid, where there are any.
    tail: Option<Reader>,
    chunks: Vec<Option<Chunk>>,
}

/// The arrays of a geometry so far.
#[derive(Default)]
struct Arrays {
    cells: Vec<u32>,
    bricks: Vec<u32>,
    materials: Vec<u32>,
    grids: Vec<PackedGrid>,
}

impl WholeLevel {
    /// Of a level's front and of the tail, which a file has where there is one, inflated.
    ///
    /// # Errors
    /// Where they are damaged.
    pub fn new(head: &StreamHead, level: u32, front: &[u8], tail: Option<&[u8]>) -> Result<Self, FileErrorKind> {
        let front = Front::read(front, level, head)?;
        let chunks = front.index.iter().map(|_| None).collect();
        Ok(Self { head: head.clone(), front, tail: tail.map(reader_of).transpose()?, chunks })
    }

    /// Takes the chunk of a number, inflated.
    ///
    /// # Errors
    /// Where it is damaged.
    pub fn add(&mut self, number: u32, bytes: &[u8]) -> Result<(), FileErrorKind> {
        let chunk = self.front.chunk(number, bytes)?;
        self.chunks[number as usize] = Some(chunk);
        Ok(())
    }

    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn front(&self) -> &Front {
        &self.front
    }

    /// Takes all chunks at once.
    #[cfg(not(target_arch = "wasm32"))]
    pub(super) fn fill(&mut self, chunks: Vec<Chunk>) {
        self.chunks = chunks.into_iter().map(Some).collect();
    }

    /// The scene, once all chunks are there; of level 0 the one that was saved.
    ///
    /// # Errors
    /// Where some are missing, or contradict each other.
    pub fn finish(self) -> Result<PackedScene, FileErrorKind> {
        let (head, front, tail) = (self.head, self.front, self.tail);
        let chunks: Option<Vec<Chunk>> = self.chunks.into_iter().collect();
        let chunks = chunks.ok_or_else(|| invalid("some chunks are missing"))?;
        let mut arrays = Arrays::default();
        let mut rest = &chunks[..];
        for (index, grid) in front.grids.iter().enumerate() {
            let count = front.index.iter().filter(|chunk| chunk.grid as usize == index).count();
            let own;
            (own, rest) = rest.split_at(count);
            arrays.append(grid, own).map_err(FileErrorKind::Invalid)?;
        }
        drop(chunks);
        let geometry = Geometry {
            cells: arrays.cells.into(),
            bricks: arrays.bricks.into(),
            brick_materials: arrays.materials.into(),
            grids: arrays.grids.into(),
            materials: front.materials.into(),
            has_normals: front.has_normals,
            ..Geometry::default()
        };
        geometry.validate_grids().map_err(FileErrorKind::Invalid)?;
        let geometry = geometry.with_lights().finished();
        let instances = head.instances.iter().map(|instance| scaled(instance, front.level)).collect();
        let placement = Placement::of_sound(&geometry, instances);
        let parts = match &tail {
            Some(tail) if front.level == 0 => tail.parts(&placement)?,
            _ => None,
        };
        let geometry = Geometry { parts, ..geometry };
        geometry.validate_parts(&placement).map_err(FileErrorKind::Invalid)?;
        let outline = Arc::new(Outline::of_instances(&kept_instances(&geometry, &placement)));
        let mut scene = PackedScene { geometry: Arc::new(geometry), placement, outline, ..head.settings };
        if let Some(environment) = tail.as_ref().map(Reader::environment).transpose()?.flatten() {
            scene.sky = with_environment(&scene, &environment)?;
        }
        if front.level == 0 && scene.content_hash() != head.scene.hash {
            return Err(damaged("the scene is not the one that was saved: its hash is another", 0));
        }
        Ok(scene)
    }
}

impl Front {
    /// The chunk of a number.
    ///
    /// # Errors
    /// Where it is damaged.
    pub(super) fn chunk(&self, number: u32, bytes: &[u8]) -> Result<Chunk, FileErrorKind> {
        let level = self.level;
        let record = self.index.get(number as usize);
        let record = record.ok_or_else(|| FileErrorKind::Invalid(format!("there is no chunk {number}").into()))?;
        Chunk::read(bytes, record, &self.grids[record.grid as usize], self.has_normals).map_err(|fault| {
            FileErrorKind::Invalid(format!("chunk {number} of level {level} is damaged: {fault}").into())
        })
    }
}

/// An instance as a level has it, whose voxels are wider.
pub(super) fn scaled(instance: &PackedInstance, level: u32) -> PackedInstance {
    if level == 0 {
        return *instance;
    }
    let wider = Mat3::from_diagonal(Vec3::splat((1u32 << level) as f32));
    let Transform { linear, translation } = instance.world_from_grid;
    PackedInstance::new(instance.grid, Transform { linear: linear * wider, translation }, instance.scene_instance)
}

/// The sky of a scene with a map in the place of its mean.
fn with_environment(scene: &PackedScene, sections: &EnvironmentSections) -> Result<Sky, FileErrorKind> {
    let environment = sections.environment().map_err(FileErrorKind::Invalid)?;
    let sky = &scene.sky;
    let with_map = Sky::new(Background::Environment(environment)).with_brightness(sky.brightness());
    Ok(with_map.with_sun(sky.sun().copied()).with_sun_disc_visible(sky.is_sun_disc_visible()))
}

impl Arrays {
    /// Adds a grid of these chunks, its bricks in the order in which packing has them.
    fn append(&mut self, grid: &PackedGrid, chunks: &[Chunk]) -> Result<(), Invalid> {
        let (low, extent) = (grid.origin >> 3, grid.max - grid.origin);
        let bricks: Vec<(&Chunk, &StoredBrick)> =
            chunks.iter().flat_map(|chunk| chunk.bricks.iter().map(move |brick| (chunk, brick))).collect();
        let relative: Vec<IVec3> = bricks.iter().map(|(_, brick)| brick.at - low).collect();
        let is_inside = |at: &IVec3| at.cmpge(IVec3::ZERO).all() && (*at * BRICK_SIZE).cmplt(extent).all();
        if bricks.is_empty() || !relative.iter().all(is_inside) {
            return Err("the chunks of a grid are not those that it tells of".into());
        }
        let levels = levels_of(&relative, extent);
        let mut order: Vec<(u64, u32)> =
            (0..).zip(&relative).map(|(index, &at)| (ordered_position(&levels, at), index)).collect();
        order.par_sort_unstable();
        let first_node = (self.cells.len() / 64) as u32;
        let CellsOfGrid { mut cells, base } = cells_of(&levels);
        for cell in cells[..base].iter_mut().filter(|cell| **cell & CELL_OCCUPIED != 0) {
            *cell += first_node;
        }
        for (position, index) in order {
            let (chunk, brick) = bricks[index as usize];
            cells[base + position as usize] = CELL_OCCUPIED | (self.bricks.len() / 2) as u32;
            self.bricks.extend([brick.header, (self.materials.len() + brick.normals) as u32]);
            self.bricks.extend_from_slice(chunk.masks(brick));
            self.materials.extend_from_slice(chunk.materials(brick));
        }
        for words in [self.bricks.len() as u64 / 2, self.materials.len() as u64 / 2, self.cells.len() as u64 / 64] {
            if words >= u64::from(CELL_OCCUPIED) {
                return Err("there are more bricks than the format can number".into());
            }
        }
        let top_offset = top_offset(self.cells.len()).map_err(|error| error.to_string())?;
        let (top_shift, top_size) = (levels[0].shift, levels[0].size);
        self.grids.push(PackedGrid { top_shift, top_size, top_offset, ..*grid });
        self.cells.extend(cells);
        Ok(())
    }
}

impl Geometry {
    /// With the lights of its voxels, which must be valid.
    fn with_lights(self) -> Self {
        let emits: Vec<bool> =
            self.materials.iter().map(|material| material.surface_emission().max_element() > 0.0).collect();
        if !emits.contains(&true) {
            return self;
        }
        let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
        for (index, grid) in self.grids.iter().enumerate() {
            let of_brick = |at: IVec3| {
                let corner = grid.origin + at * BRICK_SIZE;
                let brick = self.find_brick(grid, corner).map(|record| self.decode_brick(grid, record));
                let voxels = brick.iter().flat_map(|brick| brick.voxels());
                let emitting = voxels.filter(|&(_, material)| emits[usize::from(material)]);
                emitting.map(|(local, material)| (corner + local, material)).collect::<Vec<_>>()
            };
            let emitting = self.bricks_of(grid).into_par_iter().flat_map_iter(of_brick).collect();
            append_lights_of_grid(&self, index, emitting, &mut emitters, &mut nodes);
        }
        Self { emitters: emitters.into(), light_nodes: nodes.into(), ..self }
    }
}
