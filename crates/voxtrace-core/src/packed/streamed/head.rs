//! What stands before the chunks: the head, with all that is no voxel, and the front of each level, with its grids, its materials and the index of its chunks.

use super::super::bytes::Bytes;
use super::super::file_error::FileErrorKind;
use super::super::instance_record::InstanceRecord;
use super::super::lights::morton_order;
use super::super::material_records::{MaterialRecords, MediumRecord};
use super::super::section_reader::Reader;
use super::super::validate::validate_each;
use super::super::{PackedGrid, PackedInstance, PackedMaterial, PackedScene, Section, normals};
use super::chunk::{CHUNK_SHIFT, ChunkRecord};
use bytemuck::{Pod, Zeroable};
use glam::IVec3;
use std::cmp::Ordering;
use std::sync::Arc;
use voxtrace_scene::Invalid;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::grid::MAX_COORDINATE;

/// What is known of the scene itself before any of its voxels is there, the section `SCEN`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct SceneRecord {
    /// [`PackedScene::content_hash`].
    pub hash: u64,
    /// Voxels, those of instances counted once for each.
    pub voxels: u64,
    /// Bytes of the scene in memory.
    pub bytes: u64,
    /// Grids.
    pub grids: u64,
}

/// The head of a file for streaming.
#[derive(Clone)]
pub struct StreamHead {
    /// Name, cameras, light; no voxels, and where the sky is a map its mean.
    pub(super) settings: PackedScene,
    pub(super) instances: Arc<[PackedInstance]>,
    /// What it says of the scene.
    pub(super) scene: SceneRecord,
}

impl StreamHead {
    /// Of its bytes, inflated.
    ///
    /// # Errors
    /// Where they are damaged.
    pub fn read(bytes: &[u8]) -> Result<Self, FileErrorKind> {
        let reader = reader_of(bytes)?;
        let instances: Vec<PackedInstance> =
            reader.section::<InstanceRecord>(b"INST")?.iter().map(InstanceRecord::instance).collect();
        let scene = *reader.section::<SceneRecord>(b"SCEN")?.first().ok_or_else(|| invalid("the head is empty"))?;
        validate_each(&instances, usize::try_from(scene.grids).unwrap_or(usize::MAX))
            .map_err(FileErrorKind::Invalid)?;
        Ok(Self { settings: PackedScene::settings_of(&reader)?, instances: instances.into(), scene })
    }

    /// Everything of the scene but its voxels.
    pub fn settings(&self) -> &PackedScene {
        &self.settings
    }

    /// [`PackedScene::content_hash`] of the scene.
    pub fn content_hash(&self) -> u64 {
        self.scene.hash
    }

    /// Voxels of the scene, those of instances counted once for each.
    pub fn voxels(&self) -> u64 {
        self.scene.voxels
    }

    /// Bytes of the scene in memory.
    pub fn bytes(&self) -> u64 {
        self.scene.bytes
    }

    /// Where its grids stand: the index of each, its matrix and its translation.
    pub fn instances(&self) -> &[PackedInstance] {
        &self.instances
    }
}

/// The front of a level.
pub struct Front {
    pub(super) level: u32,
    pub(super) grids: Section<PackedGrid>,
    pub(super) materials: Vec<PackedMaterial>,
    pub(super) has_normals: bool,
    pub(super) index: Section<ChunkRecord>,
}

impl Front {
    /// Of its bytes, inflated.
    ///
    /// # Errors
    /// Where they are damaged, or of another scene.
    pub fn read(bytes: &[u8], level: u32, head: &StreamHead) -> Result<Self, FileErrorKind> {
        let reader = reader_of(bytes)?;
        let media = if reader.has(b"MEDI") { reader.section::<MediumRecord>(b"MEDI")?.to_vec() } else { Vec::new() };
        let materials =
            MaterialRecords::materials(&reader.section(b"MATS")?, &media).map_err(FileErrorKind::Invalid)?;
        let has_normals =
            reader.has(b"NORM") && normals::is_known_kind(&reader.section(b"NORM")?).map_err(FileErrorKind::Invalid)?;
        let front =
            Self { level, grids: reader.section(b"GRID")?, materials, has_normals, index: reader.section(b"INDX")? };
        front.check(head).map_err(FileErrorKind::Invalid)?;
        Ok(front)
    }

    fn check(&self, head: &StreamHead) -> Result<(), Invalid> {
        if self.grids.len() as u64 != head.scene.grids {
            return Err(format!("level {} has grids of another scene", self.level).into());
        }
        for (index, grid) in self.grids.iter().enumerate() {
            let far = IVec3::splat(MAX_COORDINATE + BRICK_SIZE);
            let is_near = |point: IVec3| point.cmple(far).all() && point.cmpge(-far).all();
            let is_box = grid.origin.cmple(grid.min).all() && grid.min.cmplt(grid.max).all();
            let is_sound = is_near(grid.origin) && is_near(grid.max) && is_box && grid.origin & 7 == IVec3::ZERO;
            if !is_sound || grid.material_bits != 8 && grid.material_bits != 16 {
                return Err(format!("grid {index} of level {} has an impossible shape", self.level).into());
            }
        }
        let far = IVec3::splat((MAX_COORDINATE >> (3 + CHUNK_SHIFT)) + 1);
        let is_near = |point: IVec3| point.cmple(far).all() && point.cmpge(-far).all();
        let is_in_order = |pair: &[ChunkRecord]| match pair[0].grid.cmp(&pair[1].grid) {
            Ordering::Equal => morton_order(pair[0].at, pair[1].at) == Ordering::Less,
            order => order == Ordering::Less,
        };
        let is_sound = |chunk: &ChunkRecord| (chunk.grid as usize) < self.grids.len() && is_near(chunk.at);
        if !self.index.iter().all(is_sound) || !self.index.windows(2).all(is_in_order) {
            return Err(format!("the index of level {} is out of order", self.level).into());
        }
        Ok(())
    }

    /// Where the chunks lie in their section.
    #[cfg(not(target_arch = "wasm32"))]
    pub fn ranges(&self) -> impl Iterator<Item = std::ops::Range<u64>> {
        self.index.iter().scan(0, |end, chunk| {
            let start = *end;
            *end += u64::from(chunk.stored);
            Some(start..*end)
        })
    }
}

/// The sections of a part of a file that was inflated.
pub(super) fn reader_of(bytes: &[u8]) -> Result<Reader, FileErrorKind> {
    let bytes = Arc::new(Bytes::copy_of(bytes)?);
    let length = bytes.len();
    Reader::new(bytes, 0..length)
}

pub(super) fn invalid(what: &str) -> FileErrorKind {
    FileErrorKind::Invalid(what.into())
}
