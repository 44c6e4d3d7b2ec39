//! Packing a grid brick by brick straight into a native file, for scenes larger than memory: the bricks and their materials,
//! which are nearly all of it, never are in memory together. The scene that is opened then is the one that packing at once
//! gives, bit for bit.

use super::brick_record::{BrickWords, encode_bricks};
use super::bytes::Bytes;
use super::file::VERSION;
use super::instance_record::InstanceRecord;
use super::lights::{append_lights_of_grid, surface_luminance};
use super::material_records::MaterialRecords;
use super::pack::{CellsOfGrid, cells_of, levels_of, material_bits_of, name_bricks, ordered_position};
use super::section_writer::SectionWriter;
use super::settings::{EnvironmentSections, Settings};
use super::{CELL_OCCUPIED, Geometry, PackError, PackedGrid, PackedInstance, PackedMaterial, PackedScene};
use super::{Placement, Section};
use crate::atomic_file::{TemporaryFile, check_replaceable};
use crate::cuts::Cuts;
use glam::IVec3;
use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::panic::resume_unwind;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::sync_channel;
use std::thread;
use voxtrace_scene::Lens;
use voxtrace_scene::brick::{BRICK_SIZE, Brick};
use voxtrace_scene::scene::Scene;
use voxtrace_scene::transform::Transform;

/// Sections that every native file has.
const SECTIONS: usize = 12;

/// Bricks that can be gone through once, in an order that packing chooses. Each has voxels, and none comes twice.
pub trait BrickSource {
    /// Coordinates of all bricks.
    fn coordinates(&self) -> Vec<IVec3>;
    /// Puts the bricks into ascending order of a key.
    fn sort_by_key(&mut self, key: &(dyn Fn(IVec3) -> u64 + Sync));
    /// Goes through all bricks in pieces: threads call `make` with several at once, and what it makes of them goes to `each` in that order.
    ///
    /// # Errors
    /// If they cannot be read; also those of `each`.
    fn for_each_piece<T: Send>(
        &mut self,
        make: impl Fn(Vec<(IVec3, Brick)>) -> T + Sync,
        each: impl FnMut(T) -> io::Result<()>,
    ) -> io::Result<()>;
    /// Where the grid of the bricks stands: at the origin, unless it says otherwise.
    fn world_from_grid(&self) -> Transform {
        Transform::IDENTITY
    }
}

/// A scene cannot be written brick by brick.
#[derive(Debug, thiserror::Error)]
pub enum StreamError {
    /// The operating system refused.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The scene is more than the format can number.
    #[error("{0}")]
    Pack(#[from] PackError),
}

/// Saves `scene`, whose own grids and instances are not looked at, with one grid of the bricks, where
/// [`BrickSource::world_from_grid`] says. The file at `path` is replaced whole or not at all; it must be a regular file or not be there yet.
///
/// # Errors
/// What the operating system reports, or if there are more bricks or materials than the format can number.
pub fn save_streamed(path: &Path, scene: &Scene, source: &mut impl BrickSource) -> Result<(), StreamError> {
    check_replaceable(path)?;
    if scene.materials.len() > voxtrace_scene::material::MAX_MATERIALS {
        return Err(PackError::TooManyMaterials(scene.materials.len()).into());
    }
    let coordinates = source.coordinates();
    let low = coordinates.iter().copied().reduce(IVec3::min).unwrap_or(IVec3::ZERO);
    let high = coordinates.iter().copied().reduce(IVec3::max).unwrap_or(IVec3::ZERO);
    let relative: Vec<IVec3> = coordinates.into_iter().map(|at| at - low).collect();
    let levels = levels_of(&relative, (high - low + 1) * BRICK_SIZE);
    drop(relative);
    source.sort_by_key(&|at| ordered_position(&levels, at - low));

    let temporary = TemporaryFile::beside(path)?;
    let of_georeference = if scene.georeference.is_some() { 2 } else { 0 };
    let of_lenses = usize::from(scene.cameras.iter().any(|camera| camera.lens != Lens::Pinhole));
    let of_environment = if scene.sky.background().environment().is_some() { 2 } else { 0 };
    let materials: Vec<PackedMaterial> = scene.materials.iter().map(PackedMaterial::from).collect();
    let of_media = usize::from(!MaterialRecords::of(&materials).media.is_empty());
    let sections = SECTIONS + of_georeference + of_lenses + of_environment + of_media;
    let mut writer = SectionWriter::new(temporary.try_clone()?, sections)?;
    let pass = write_bricks(path, scene, source, &mut writer)?;
    let CellsOfGrid { mut cells, base } = cells_of(&levels);
    name_bricks(&levels, &mut cells[base..], pass.records.iter().copied());
    if cells.len() as u64 / 64 >= u64::from(CELL_OCCUPIED) {
        return Err(PackError::TooLarge(cells.len() as u64 / 64, "cells").into());
    }
    let top = &levels[0];
    let grid = PackedGrid {
        origin: low * BRICK_SIZE,
        top_shift: top.shift,
        top_size: top.size,
        top_offset: 0,
        min: pass.min,
        voxels: [pass.voxels as u32, (pass.voxels >> 32) as u32],
        max: pass.max,
        material_bits: material_bits_of(scene),
    };
    drop(levels);
    writer.section(b"CELL", &cells)?;
    let has_grid = pass.voxels > 0;
    let mut geometry = Geometry {
        grids: has_grid.then_some(grid).into_iter().collect::<Vec<_>>().into(),
        materials: scene.materials.iter().map(PackedMaterial::from).collect::<Vec<_>>().into(),
        cells: cells.into(),
        ..Geometry::default()
    };
    if !pass.emitting.is_empty() {
        // Which faces are free is looked up in what was written.
        map_bricks(&mut geometry, &mut writer, &temporary.try_clone()?)?;
        let (mut emitters, mut nodes) = (Vec::new(), Vec::new());
        append_lights_of_grid(&geometry, 0, pass.emitting, &mut emitters, &mut nodes);
        (geometry.emitters, geometry.light_nodes) = (emitters.into(), nodes.into());
    }
    let geometry = geometry.finished();
    let instances: Vec<_> = has_grid.then(|| PackedInstance::new(0, source.world_from_grid(), 0)).into_iter().collect();
    let packed = PackedScene {
        name: scene.name.clone(),
        placement: Placement::of_sound(&geometry, instances),
        geometry: Arc::new(geometry),
        sky: scene.sky.clone(),
        light_intensity: scene.light_intensity,
        cameras: scene.cameras.clone(),
        cuts: Cuts::default(),
        ground: None,
        voxel_size: scene.voxel_size,
        outline: Arc::default(),
        georeference: scene.georeference.clone(),
        unit: scene.unit,
    };
    write_rest(&packed, &mut writer)?;
    writer.finish(VERSION)?;
    drop(packed);
    Ok(temporary.replace(path)?)
}

/// Gives the geometry its bricks, as they lie in the file that is being written.
pub(super) fn map_bricks(geometry: &mut Geometry, writer: &mut SectionWriter, file: &File) -> Result<(), StreamError> {
    let ranges = [writer.flushed_range(b"BRIK")?, writer.flushed_range(b"BMAT")?];
    let file = Arc::new(Bytes::map(file)?);
    let written = |range: Option<(usize, usize)>| {
        let section = range.and_then(|(start, end)| Section::from_shared(file.clone(), start, end));
        section.ok_or_else(|| io::Error::other("what was written is not in the file"))
    };
    (geometry.bricks, geometry.brick_materials) = (written(ranges[0])?, written(ranges[1])?);
    Ok(())
}

/// Writes all sections but the cells and the bricks.
fn write_rest(packed: &PackedScene, writer: &mut SectionWriter) -> Result<(), StreamError> {
    let settings = Settings::of(packed);
    writer.section(b"SETT", std::slice::from_ref(&settings.record))?;
    writer.section(b"CAMS", &settings.cameras)?;
    writer.section(b"TEXT", &settings.text)?;
    if !settings.lenses.is_empty() {
        writer.section(b"LENS", &settings.lenses)?;
    }
    writer.section(b"GRID", &packed.geometry.grids)?;
    writer.section(b"INST", &InstanceRecord::all_of(&packed.placement))?;
    writer.section(b"INOD", &packed.placement.instance_nodes)?;
    let materials = MaterialRecords::of(&packed.geometry.materials);
    writer.section(b"MATS", &materials.surfaces)?;
    if !materials.media.is_empty() {
        writer.section(b"MEDI", &materials.media)?;
    }
    writer.section(b"EMIT", &packed.geometry.emitters)?;
    writer.section(b"LNOD", &packed.geometry.light_nodes)?;
    if let Some(georeference) = &packed.georeference {
        writer.section(b"GEOR", &[georeference.to_array()])?;
        writer.section(b"GCRS", georeference.crs.as_bytes())?;
    }
    if let Some(EnvironmentSections { record, texels }) = &settings.environment {
        writer.section(b"ENVI", std::slice::from_ref(record))?;
        writer.section(b"ENVT", texels)?;
    }
    Ok(())
}

/// What is known when all bricks are written.
struct Pass {
    /// The number of each brick's record, in the order of the source.
    records: Vec<u32>,
    voxels: u64,
    min: IVec3,
    max: IVec3,
    /// Voxels that emit, and their materials.
    emitting: Vec<(IVec3, u16)>,
}

/// Pieces that wait to be written.
const WAITING: usize = 1 << 6;

/// Writes the sections BRIK and BMAT. The materials wait in a file of their own until all records are written.
fn write_bricks(
    path: &Path,
    scene: &Scene,
    source: &mut impl BrickSource,
    writer: &mut SectionWriter,
) -> Result<Pass, StreamError> {
    let emits: Vec<bool> = scene.materials.iter().map(|material| surface_luminance(material) > 0.0).collect();
    let emits_at_all = emits.iter().any(|&emits| emits);
    let entry_bits = material_bits_of(scene);
    let mut waiting = TemporaryFile::nameless(path)?;
    let (mut record_words, mut material_words) = (0u64, 0u64);
    let (min, max) = (IVec3::splat(i32::MAX), IVec3::splat(i32::MIN));
    let mut pass = Pass { records: vec![], voxels: 0, min, max, emitting: vec![] };
    let mut missing = None;
    writer.begin::<u32>(b"BRIK")?;
    let mut write = |Piece { mut words, found }: Piece| {
        for &position in &words.positions {
            words.records[position + 1] = words.records[position + 1].wrapping_add(material_words as u32);
            pass.records.push(((record_words + position as u64) / 2) as u32);
        }
        record_words += words.records.len() as u64;
        material_words += words.materials.len() as u64;
        for found in found {
            missing = missing.or(found.missing);
            pass.add(found);
        }
        writer.write(bytemuck::cast_slice(&words.records))?;
        waiting.file().write_all(bytemuck::cast_slice(&words.materials))
    };
    let encode = |bricks: Vec<(IVec3, Brick)>| {
        let words = encode_bricks(&bricks, entry_bits);
        let found = bricks.iter().map(|(at, brick)| Found::of(*at, brick, &emits, emits_at_all)).collect();
        Piece { words, found }
    };
    // Bricks are encoded while those before them are written.
    thread::scope(|scope| {
        let (to_write, encoded) = sync_channel(WAITING);
        let writing = scope.spawn(move || encoded.into_iter().try_for_each(&mut write));
        // Who writes says why it has ended.
        let read =
            source.for_each_piece(encode, |piece| to_write.send(piece).map_err(|_| io::ErrorKind::BrokenPipe.into()));
        drop(to_write);
        writing.join().unwrap_or_else(|panic| resume_unwind(panic)).and(read)
    })?;
    if let Some(material) = missing {
        return Err(PackError::MissingMaterial { grid: 0, material, count: scene.materials.len() }.into());
    }
    for (name, words) in [("bricks", record_words), ("materials", material_words)] {
        if words / 2 >= u64::from(CELL_OCCUPIED) {
            return Err(PackError::TooLarge(words / 2, name).into());
        }
    }
    writer.begin::<u32>(b"BMAT")?;
    copy(waiting.file(), writer)?;
    Ok(pass)
}

/// Bricks on their way into the file.
struct Piece {
    words: BrickWords,
    found: Vec<Found>,
}

/// What there is to be known of a brick.
struct Found {
    voxels: u64,
    min: IVec3,
    max: IVec3,
    /// A material that the scene does not have.
    missing: Option<u16>,
    emitting: Vec<(IVec3, u16)>,
}

impl Found {
    fn of(at: IVec3, brick: &Brick, emits: &[bool], emits_at_all: bool) -> Self {
        let corner = at * BRICK_SIZE;
        let missing = brick.materials().iter().find(|&&material| usize::from(material) >= emits.len()).copied();
        let (low, high) = brick.extent();
        let mut emitting = Vec::new();
        if emits_at_all && missing.is_none() {
            let voxels = brick.voxels().filter(|&(_, material)| emits[usize::from(material)]);
            emitting.extend(voxels.map(|(local, material)| (corner + local, material)));
        }
        let voxels = brick.materials().len() as u64;
        Self { voxels, min: corner + low, max: corner + high, missing, emitting }
    }
}

impl Pass {
    fn add(&mut self, found: Found) {
        self.voxels += found.voxels;
        (self.min, self.max) = (self.min.min(found.min), self.max.max(found.max));
        self.emitting.extend(found.emitting);
    }
}

pub(super) fn copy(from: &mut File, to: &mut SectionWriter) -> io::Result<()> {
    from.seek(SeekFrom::Start(0))?;
    let mut buffer = vec![0; 1 << 20];
    loop {
        match from.read(&mut buffer)? {
            0 => return Ok(()),
            count => to.write(&buffer[..count])?,
        }
    }
}
