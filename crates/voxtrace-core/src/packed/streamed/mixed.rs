//! A scene of chunks of several levels: near things fine, far ones coarse, as a page shows a scene whose parts arrive or that is larger than its memory.
//!
//! Each chunk is a grid of its own, placed as often as its grid is. Levels have materials of their own, which are joined into one list; when it is full the nearest one is
//! taken. Normals of voxels are left out.

use super::super::file_error::FileErrorKind;
use super::super::lights::append_lights_of_grid;
use super::super::pack::{GridPart, pack_grid};
use super::super::{Geometry, Outline, PackedInstance, PackedMaterial, PackedScene, Placement};
use super::chunk::ChunkRecord;
use super::head::{Front, StreamHead, invalid};
use super::nearest_material::NearestMaterial;
use super::whole::scaled;
use glam::IVec3;
use rustc_hash::FxHashMap;
use std::sync::Arc;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::MAX_MATERIALS;

/// Bits of a palette entry.
const ENTRY_BITS: u32 = 16;

/// The levels of a file for streaming, as far as they have arrived.
pub struct StreamedLevels {
    head: StreamHead,
    levels: FxHashMap<u32, LevelSoFar>,
    materials: Vec<PackedMaterial>,
    number_of: FxHashMap<[u32; 16], u16>,
    /// Of a full list.
    nearest: Option<NearestMaterial>,
    parts: FxHashMap<(u32, u32), Part>,
}

struct LevelSoFar {
    front: Front,
    /// The number that each of its materials has here.
    numbers: Vec<u16>,
}

/// A chunk, ready to be placed.
struct Part {
    grid: GridPart,
    emitting: Vec<(IVec3, u16)>,
}

impl StreamedLevels {
    /// None yet.
    pub fn new(head: &StreamHead) -> Self {
        Self {
            head: head.clone(),
            levels: FxHashMap::default(),
            materials: Vec::new(),
            number_of: FxHashMap::default(),
            nearest: None,
            parts: FxHashMap::default(),
        }
    }

    /// Takes the front of a level, inflated.
    ///
    /// # Errors
    /// Where it is damaged.
    pub fn add_front(&mut self, level: u32, front: &[u8]) -> Result<(), FileErrorKind> {
        let front = Front::read(front, level, &self.head)?;
        let numbers = front.materials.iter().map(|material| self.number_of(material)).collect();
        self.levels.insert(level, LevelSoFar { front, numbers });
        Ok(())
    }

    /// The number of a material in the list of all.
    fn number_of(&mut self, material: &PackedMaterial) -> u16 {
        let key: [u32; 16] = bytemuck::cast(*material);
        if let Some(&number) = self.number_of.get(&key) {
            return number;
        }
        let number = if self.materials.len() < MAX_MATERIALS {
            self.materials.push(*material);
            (self.materials.len() - 1) as u16
        } else {
            let nearest = self.nearest.get_or_insert_with(|| NearestMaterial::new(&self.materials));
            nearest.find(&self.materials, material)
        };
        self.number_of.insert(key, number);
        number
    }

    /// The chunks of a level whose front is there.
    pub fn index(&self, level: u32) -> Option<&[ChunkRecord]> {
        self.levels.get(&level).map(|level| &*level.front.index)
    }

    /// Takes a chunk of such a level, inflated.
    ///
    /// # Errors
    /// Where it is damaged.
    pub fn add_chunk(&mut self, level: u32, number: u32, bytes: &[u8]) -> Result<(), FileErrorKind> {
        let of_level = self.levels.get(&level).ok_or_else(|| invalid("the front of the level is missing"))?;
        let chunk = of_level.front.chunk(number, bytes)?;
        let unknown = || invalid("a voxel names a material that is missing");
        let mut bricks = Vec::with_capacity(chunk.bricks.len());
        let mut emitting = Vec::new();
        for stored in &chunk.bricks {
            let brick = chunk.brick(stored, &of_level.numbers).ok_or_else(unknown)?;
            let emits = |material: u16| self.materials[usize::from(material)].surface_emission().max_element() > 0.0;
            if brick.materials().iter().any(|&material| emits(material)) {
                let found = brick.voxels().filter(|&(_, material)| emits(material));
                emitting.extend(found.map(|(local, material)| (stored.at * BRICK_SIZE + local, material)));
            }
            bricks.push((stored.at, brick));
        }
        let grid = pack_grid(&VoxelGrid::from_bricks(bricks), ENTRY_BITS, &|| Ok(()));
        let grid = grid.map_err(|error| FileErrorKind::Invalid(error.to_string().into()))?;
        self.parts.insert((level, number), Part { grid, emitting });
        Ok(())
    }

    /// Lets go of a chunk.
    pub fn remove_chunk(&mut self, level: u32, number: u32) {
        self.parts.remove(&(level, number));
    }

    /// The scene of these chunks, which must be there and none within another.
    ///
    /// # Errors
    /// Where one is not there, or the scene gets too large.
    pub fn scene(&self, chunks: &[(u32, u32)]) -> Result<PackedScene, FileErrorKind> {
        let (mut cells, mut bricks) = (Vec::new(), Vec::new());
        let (mut brick_materials, mut grids, mut instances) = (Vec::new(), Vec::new(), Vec::new());
        let mut placed: FxHashMap<u32, Vec<usize>> = FxHashMap::default();
        for (index, instance) in self.head.instances.iter().enumerate() {
            placed.entry(instance.grid).or_default().push(index);
        }
        let missing = || invalid("a chunk is missing");
        for &(level, number) in chunks {
            let part = self.parts.get(&(level, number)).ok_or_else(missing)?;
            let of_level = self.levels.get(&level).ok_or_else(missing)?;
            let record = of_level.front.index.get(number as usize).ok_or_else(missing)?;
            for &index in placed.get(&record.grid).into_iter().flatten() {
                let instance = scaled(&self.head.instances[index], level);
                instances.push(PackedInstance { grid: grids.len() as u32, ..instance });
            }
            let appended = part.grid.clone().append(&mut cells, &mut bricks, &mut brick_materials, &mut grids);
            appended.map_err(|error| FileErrorKind::Invalid(error.to_string().into()))?;
        }
        let mut geometry = Geometry {
            cells: cells.into(),
            bricks: bricks.into(),
            brick_materials: brick_materials.into(),
            grids: grids.into(),
            materials: self.materials.clone().into(),
            ..Geometry::default()
        };
        let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
        for (index, chunk) in chunks.iter().enumerate() {
            append_lights_of_grid(&geometry, index, self.parts[chunk].emitting.clone(), &mut emitters, &mut nodes);
        }
        (geometry.emitters, geometry.light_nodes) = (emitters.into(), nodes.into());
        let geometry = geometry.finished();
        let placement = Placement::of_sound(&geometry, instances);
        let outline = Arc::new(Outline::of_instances(placement.instances()));
        Ok(PackedScene { geometry: Arc::new(geometry), placement, outline, ..self.head.settings.clone() })
    }
}
