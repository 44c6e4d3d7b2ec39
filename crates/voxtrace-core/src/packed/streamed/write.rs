//! Writing files for streaming: the levels are made as those of any file, and each is then compressed chunk by chunk.

use super::super::file::{STREAMED_VERSION, SectionBytes, section_of, write_sections};
use super::super::instance_record::InstanceRecord;
use super::super::levels::{self, LevelCount, LevelListener, LevelProgress, LevelStep, tell};
use super::super::lights::morton_order;
use super::super::material_records::MaterialRecords;
use super::super::normals::normal_words;
use super::super::section_writer::SectionWriter;
use super::super::settings::{EnvironmentSections, Settings};
use super::super::stream::copy;
use super::super::{FileError, FileErrorKind, Geometry, PackedGrid, PackedScene, bytes::Bytes};
use super::chunk::{CHUNK_SHIFT, ChunkRecord};
use super::head::SceneRecord;
use super::{chunks_tag, front_tag};
use crate::atomic_file::{TemporaryFile, check_replaceable};
use flate2::{Compression, write::DeflateEncoder};
use glam::IVec3;
use rayon::prelude::*;
use std::io::{self, Write};
use std::path::Path;
use std::sync::Arc;
use voxtrace_scene::brick::BRICK_SIZE;
use voxtrace_scene::georeference::Georeference;
use xxhash_rust::xxh3::xxh3_64;

/// Chunks that are compressed at a time.
const BATCH: usize = 256;

impl PackedScene {
    /// Saves the scene with all levels of detail in compressed chunks, the coarsest level first, for pages that show it while it arrives. With its levels such a file is
    /// about as large as what [`Self::save`] writes without any. It is read into memory, not mapped. Levels are made as by [`Self::save_with_levels`], and `progress` hears
    /// of that and of compressing them. What was written is read once more before it takes the place of `path`.
    ///
    /// # Errors
    /// As [`Self::save_with_levels`].
    pub fn save_for_streaming(&self, path: &Path, progress: LevelListener) -> Result<(), FileError> {
        if self.geometry.is_edited {
            return self.compacted().save_for_streaming(path, progress);
        }
        let failure = |kind| FileError { path: path.into(), kind };
        check_replaceable(path).map_err(|error| failure(error.into()))?;
        let written = self.streamed_beside(path, progress).map_err(failure)?;
        written.replace(path).map_err(|error| failure(error.into()))
    }

    /// The file that is to take the place of `path`.
    fn streamed_beside(&self, path: &Path, progress: LevelListener) -> Result<TemporaryFile, FileErrorKind> {
        let levels = self.levels_beside(path, LevelCount::All, progress)?;
        let temporary = TemporaryFile::beside(path)?;
        let sections = 2 + 2 * (levels.len() + 1);
        let mut writer = SectionWriter::new(temporary.try_clone()?, sections)?;
        writer.section(b"HEAD", &deflated(&head_of(self)?)?)?;
        for (index, bytes) in levels.iter().enumerate().rev() {
            let level = index as u32 + 1;
            let scene = levels::scene_of(Arc::clone(bytes), 0..bytes.len(), self)?;
            write_level(&scene.geometry, level, &mut writer, path, progress)?;
        }
        write_level(&self.geometry, 0, &mut writer, path, progress)?;
        if let Some(tail) = tail_of(self)? {
            writer.section(b"TAIL", &deflated(&tail)?)?;
        }
        writer.finish(STREAMED_VERSION)?;
        drop(levels);
        // A scene whose arrays are in an order of their own would not come back as it is.
        let read = Self::of_shared(Arc::new(Bytes::map(&temporary.try_clone()?)?))?;
        match read.content_hash() == self.content_hash() {
            true => Ok(temporary),
            false => Err(FileErrorKind::Invalid("what was written is not what is read back".into())),
        }
    }
}

/// Writes a native file anew for streaming. It is replaced whole or not at all.
///
/// # Errors
/// As [`PackedScene::open`] and [`PackedScene::save_for_streaming`].
pub fn rewrite_for_streaming(path: &Path, progress: LevelListener) -> Result<(), FileError> {
    let failure = |kind| FileError { path: path.into(), kind };
    let scene = PackedScene::open(path)?;
    let written = scene.streamed_beside(path, progress).map_err(failure)?;
    // Windows replaces no file that is mapped.
    drop(scene);
    written.replace(path).map_err(|error| failure(error.into()))
}

fn deflated(bytes: &[u8]) -> io::Result<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    encoder.finish()
}

fn packed(sections: &[SectionBytes]) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    write_sections(&mut bytes, sections)?;
    Ok(bytes)
}

/// Everything that a first picture needs but voxels.
fn head_of(scene: &PackedScene) -> io::Result<Vec<u8>> {
    let (settings, instances) = (Settings::of(scene), InstanceRecord::all_of(&scene.placement));
    let geometry = &scene.geometry;
    let words = geometry.cells.size_bytes() + geometry.bricks.size_bytes() + geometry.brick_materials.size_bytes();
    let record = SceneRecord {
        hash: scene.content_hash(),
        voxels: scene.voxel_count(),
        bytes: words + geometry.emitters.size_bytes() + geometry.light_nodes.size_bytes(),
        grids: geometry.grids.len() as u64,
    };
    let mut sections = vec![
        section_of(b"SCEN", std::slice::from_ref(&record)),
        section_of(b"SETT", std::slice::from_ref(&settings.record)),
        section_of(b"CAMS", &settings.cameras),
        section_of(b"TEXT", &settings.text),
        section_of(b"INST", &instances),
    ];
    if !settings.lenses.is_empty() {
        sections.push(section_of(b"LENS", &settings.lenses));
    }
    let matrix = scene.georeference.as_ref().map(Georeference::to_array);
    if let (Some(georeference), Some(matrix)) = (&scene.georeference, &matrix) {
        sections.push(section_of(b"GEOR", std::slice::from_ref(matrix)));
        sections.push(section_of(b"GCRS", georeference.crs.as_bytes()));
    }
    packed(&sections)
}

/// What only the whole scene has: the environment map, and what a grid was merged of.
fn tail_of(scene: &PackedScene) -> io::Result<Option<Vec<u8>>> {
    let settings = Settings::of(scene);
    let of_sky = settings.environment.iter().flat_map(EnvironmentSections::parts);
    let of_parts = scene.geometry.parts.iter().flat_map(|parts| parts.sections());
    let sections: Vec<SectionBytes> = of_sky.chain(of_parts).collect();
    (!sections.is_empty()).then(|| packed(&sections)).transpose()
}

/// A brick: its grid, its chunk, its place in it, and half the position of its record.
type Placed = (u32, IVec3, u16, u32);

/// The bricks of a geometry, chunk by chunk.
fn bricks_of(geometry: &Geometry) -> Vec<Placed> {
    let mut bricks: Vec<Placed> = Vec::new();
    for (index, grid) in (0..).zip(geometry.grids.iter()) {
        let place = |at: IVec3| {
            let record = geometry.find_brick(grid, grid.origin + at * BRICK_SIZE)?;
            let at = at + (grid.origin >> 3);
            let local: IVec3 = at & IVec3::splat((1 << CHUNK_SHIFT) - 1);
            let place = local.x | local.y << CHUNK_SHIFT | local.z << (2 * CHUNK_SHIFT);
            Some((index, at >> CHUNK_SHIFT, place as u16, (record / 2) as u32))
        };
        bricks.par_extend(geometry.bricks_of(grid).into_par_iter().filter_map(place));
    }
    bricks.par_sort_unstable_by(|a, b| a.0.cmp(&b.0).then_with(|| morton_order(a.1, b.1)).then_with(|| a.2.cmp(&b.2)));
    bricks
}

/// Writes the front of a level and its chunks, which wait in a file beside `path` until the front is there.
fn write_level(
    geometry: &Geometry,
    level: u32,
    writer: &mut SectionWriter,
    path: &Path,
    progress: LevelListener,
) -> io::Result<()> {
    let mut waiting = TemporaryFile::nameless(path)?;
    let bricks = bricks_of(geometry);
    let chunks: Vec<&[Placed]> = bricks.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)).collect();
    let mut index = Vec::with_capacity(chunks.len());
    let total = chunks.len() as u64;
    let mut told = |done: u64| tell(&mut *progress, LevelProgress { step: LevelStep::Compress, level, done, total });
    for batch in chunks.chunks(BATCH) {
        told(index.len() as u64)?;
        let made = batch.par_iter().map(|chunk| compressed(geometry, chunk)).collect::<io::Result<Vec<_>>>()?;
        for (record, bytes) in made {
            index.push(record);
            waiting.file().write_all(&bytes)?;
        }
    }
    let materials = MaterialRecords::of(&geometry.materials);
    let mut sections = vec![
        section_of(b"GRID", &geometry.grids),
        section_of(b"MATS", &materials.surfaces),
        section_of(b"INDX", &index),
    ];
    if !materials.media.is_empty() {
        sections.push(section_of(b"MEDI", &materials.media));
    }
    sections.extend(geometry.normal_section());
    writer.section(&front_tag(level), &deflated(&packed(&sections)?)?)?;
    writer.begin::<u8>(&chunks_tag(level))?;
    copy(waiting.file(), writer)?;
    told(total)
}

fn compressed(geometry: &Geometry, bricks: &[Placed]) -> io::Result<(ChunkRecord, Vec<u8>)> {
    let (grid, at, ..) = bricks[0];
    let places: Vec<(u16, usize)> = bricks.iter().map(|&(.., place, record)| (place, record as usize * 2)).collect();
    let (bytes, voxels) = bytes_of(geometry, &geometry.grids[grid as usize], &places);
    let (sum, stored) = (xxh3_64(&bytes), deflated(&bytes)?);
    let checksum = [sum as u32, (sum >> 32) as u32];
    let (size, count) = (bytes.len() as u32, stored.len() as u32);
    Ok((ChunkRecord { grid, at, bricks: places.len() as u32, voxels, size, stored: count, checksum }, stored))
}

/// The bytes of a chunk, and its voxels. `bricks` are places in the chunk, ascending, and the positions of the records.
fn bytes_of(geometry: &Geometry, grid: &PackedGrid, bricks: &[(u16, usize)]) -> (Vec<u8>, u32) {
    let mut words = vec![bricks.len() as u32];
    let places: Vec<u16> = bricks.iter().map(|&(place, _)| place).collect();
    words.extend(places.chunks(2).map(|pair| u32::from(pair[0]) | u32::from(*pair.get(1).unwrap_or(&0)) << 16));
    words.extend(bricks.iter().map(|&(_, record)| geometry.bricks[record]));
    for &(_, record) in bricks {
        let blocks = (geometry.bricks[record] & 0xff).count_ones() as usize;
        words.extend_from_slice(&geometry.bricks[record + 2..record + 2 + 2 * blocks]);
    }
    let mut all = 0;
    for &(_, record) in bricks {
        let voxels = geometry.voxels_of(record);
        let start = geometry.bricks[record + 1] as usize;
        let before = if geometry.has_normals { normal_words(voxels) } else { 0 };
        let end = start + geometry.material_words(grid, record, voxels);
        words.extend_from_slice(&geometry.brick_materials[start - before..end]);
        all += voxels;
    }
    (bytemuck::pod_collect_to_vec(&words), all)
}
