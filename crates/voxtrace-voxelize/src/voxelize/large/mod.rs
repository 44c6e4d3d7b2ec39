//! Out-of-core voxelization of meshes larger than memory. A first pass over the file surveys its triangles; a second one
//! bucket-sorts them on the disk by the part of the grid that they reach into; then each part is voxelized as a small mesh. Voxels
//! and colours are the same bits as for a mesh in memory, since every tile sees its triangles in the order of the file.

use super::appearance::{BsdfClass, rgb_bits};
use super::binning::{self, TileGrid, for_each_tile};
use super::color_histogram::ColorHistogram;
use super::disk_buckets::DiskBuckets;
use super::estimate::bytes_of;
use super::mesh_appearance::MeshAppearance;
use super::palette::Palette;
use super::partition::{Part, TilePartition};
use super::polygon::Pieces;
use super::spill::SpillBuffer;
use super::tile::TileJob;
use super::triangle::Triangle;
use super::voxelized::{Voxelized, scene_of_source};
use super::{
    Estimate, Placement, SurfaceRule, VoxelizeError, VoxelizeOptions, VoxelizeProgress, cameras_of, material_count,
    surface, tile_grid,
};
use crate::limits::Limits;
use crate::mesh::Mesh;
use crate::mesh::source::{Sample, SourceColors, TriangleSource};
use glam::{DVec3, Vec2, Vec3, Vec4};
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::material::linear_from_srgb;
use voxtrace_scene::scene::Scene;

/// Memory budget by default, in bytes.
pub(crate) const DEFAULT_BUDGET: u64 = 2 << 30;
/// Triangles processed by one task.
const CHUNK: usize = 1 << 11;

/// Statistics of a first pass over all triangles: count, bounds, projected areas and a sample.
#[derive(Clone, Debug)]
pub struct Survey {
    low: Vec3,
    high: Vec3,
    /// Sums over the triangles of area · (|n.x| + |n.y| + |n.z|) and of area · max(|n.x|, |n.y|, |n.z|).
    areas: [f64; 2],
    /// A sample of the triangles, by their first corners.
    sample: Sample,
}

impl Survey {
    /// Makes the first pass.
    ///
    /// # Errors
    /// If they cannot be read; also if it was cancelled.
    pub fn of(source: &mut dyn TriangleSource, progress: &VoxelizeProgress) -> Result<Self, VoxelizeError> {
        let (low, high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        let mut survey = Self { low, high, areas: [0.0; 2], sample: Sample::default() };
        progress.begin(source.count());
        source.for_each(&mut |piece| {
            for triangle in piece.positions.as_chunks::<3>().0 {
                for &corner in triangle {
                    (survey.low, survey.high) = (survey.low.min(corner), survey.high.max(corner));
                }
                let [a, b, c] = triangle.map(|corner| corner.as_dvec3());
                let area = (b - a).cross(c - a).abs() * 0.5;
                survey.areas[0] += area.element_sum();
                survey.areas[1] += area.max_element();
                survey.sample.add(|| triangle[0]);
            }
            progress.add((piece.positions.len() / 3) as u64);
            !progress.is_cancelled()
        })?;
        if progress.is_cancelled() {
            return Err(VoxelizeError::Cancelled);
        }
        if survey.triangles() == 0 {
            return Err(VoxelizeError::Empty);
        }
        Ok(survey)
    }

    /// Number of triangles.
    pub fn triangles(&self) -> u64 {
        self.sample.seen()
    }

    /// Everything but the sample, to tell one file from another.
    pub fn summary(&self) -> impl std::fmt::Debug + use<> {
        (self.triangles(), self.low, self.high, self.areas)
    }

    fn placement(&self, offset: DVec3, options: &VoxelizeOptions) -> Result<Placement, VoxelizeError> {
        Placement::over((self.low.as_dvec3() + offset, self.high.as_dvec3() + offset), offset, options.scale)
    }

    /// Estimates the voxels of the mesh, as [`super::estimate`] does.
    ///
    /// # Errors
    /// If there is no grid for it.
    pub fn estimate(
        &self,
        source: &mut dyn TriangleSource,
        options: &VoxelizeOptions,
    ) -> Result<Estimate, VoxelizeError> {
        let is_plain = source.colors() == SourceColors::None && !source.has_uvs() && source.materials().is_none();
        let placement = self.placement(source.frame().offset, options)?;
        let sum = self.areas[usize::from(options.rule == SurfaceRule::Thin)];
        let voxels = placement.at_most(sum / placement.voxel_size.powi(2));
        Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, is_plain), is_bound: false })
    }
}

/// Voxelizes a mesh that is read piece by piece into the spill buffer.
pub(super) fn run(
    source: &mut dyn TriangleSource,
    survey: &Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    spill: &mut SpillBuffer,
    progress: &VoxelizeProgress,
) -> Result<(Voxelized, Scene), VoxelizeError> {
    let budget = options.memory_budget.unwrap_or(DEFAULT_BUDGET);
    let placement = survey.placement(source.frame().offset, options)?;
    let tiles = tile_grid(&placement)?;
    let materials = source.materials();
    let record = Record { colors: source.colors(), has_uvs: source.has_uvs(), has_materials: materials.is_some() };
    let sample = survey.sample.points();
    let places = sample.iter().map(|&corner| (placement.voxels(corner) / f64::from(binning::TILE)).floor());
    let partition = TilePartition::of(
        &tiles,
        places.map(|tile| tile.as_ivec3().to_array()),
        survey.sample.stride(),
        budget / 4 / record.bytes_in_memory(),
    );
    // Sorting counts as one half of the work, voxelizing as the other.
    let all = survey.triangles();
    progress.begin(2 * all);
    let mut buckets = DiskBuckets::beside(path, partition.part_count(), budget / 16)?;
    let histogram = ColorHistogram::default();
    spill.resume(&histogram, progress)?;
    let is_done = |part: u32| spill.is_past(part);
    sort(source, &placement, &tiles, &partition, &is_done, &record, &mut buckets, progress)?;
    let frame = source.frame();
    let mut scene = scene_of_source(&frame.name, frame.unit);
    scene.cameras = cameras_of(frame, &placement);
    source.release();

    let sizes = || (0..partition.part_count()).map(|part| buckets.size(part) / record.size() as u64);
    let records = sizes().sum::<u64>().max(1);
    let sizes: Vec<u64> = sizes().collect();
    let until = |done: u64| (u128::from(all) * u128::from(done) / u128::from(records)) as u64;
    let (mut mesh, mut done) = (source.frame().clone(), 0);
    for (number, size) in sizes.into_iter().enumerate() {
        mesh.clear();
        buckets.read(number, |bytes| record.append_all(bytes, &mut mesh))?;
        // A part may use fewer materials, but its appearance must be that of the whole mesh.
        let appearance =
            materials.as_ref().map_or_else(|| MeshAppearance::of(&mesh), |used| MeshAppearance::among(&mesh, used));
        let job = TileJob {
            mesh: &mesh,
            placement: &placement,
            appearance: &appearance,
            rule: options.rule,
            histogram: &histogram,
        };
        let part = Part { partition: &partition, number: number as u32 };
        let pairs = binning::pairs_of(&mesh, &placement, &tiles, &part);
        let share = until(done + size) - until(done);
        done += size;
        surface::run_band(&job, &tiles, &pairs, number as u32, share, spill, limits, progress)?;
    }
    if spill.brick_count() == 0 {
        return Err(VoxelizeError::Empty);
    }
    progress.add(all - until(done));
    mesh.clear();
    let classes = BsdfClass::in_voxels(&MeshAppearance::of(&mesh).classes, placement.voxel_size);
    let palette = Palette::of(&histogram, &classes, material_count(options), options.dither);
    Ok((Voxelized { placement, palette }, scene))
}

/// Puts every triangle into the buckets of the parts that it reaches into, unless they are done.
#[expect(clippy::too_many_arguments, reason = "each is another thing")]
fn sort(
    source: &mut dyn TriangleSource,
    placement: &Placement,
    tiles: &TileGrid,
    partition: &TilePartition,
    is_done: &dyn Fn(u32) -> bool,
    record: &Record,
    buckets: &mut DiskBuckets,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    let everything = 0..tiles.layers();
    let mut failure = None;
    source.for_each(&mut |piece| {
        let count = piece.positions.len() / 3;
        let targets: Vec<Vec<(u32, u32)>> = (0..count.div_ceil(CHUNK))
            .into_par_iter()
            .map(|chunk| {
                let (mut targets, mut pieces) = (Vec::with_capacity(CHUNK), Pieces::new());
                for index in chunk * CHUNK..((chunk + 1) * CHUNK).min(count) {
                    let Some(triangle) = Triangle::of(piece, placement, index) else { continue };
                    let first = targets.len();
                    for_each_tile(&triangle, tiles, &everything, &mut pieces, |tile| {
                        let target = (partition.part(tiles, tile), index as u32);
                        if !targets[first..].contains(&target) {
                            targets.push(target);
                        }
                    });
                }
                targets
            })
            .collect();
        let mut bytes = Vec::with_capacity(record.size());
        for (part, index) in targets.into_iter().flatten().filter(|(part, _)| !is_done(*part)) {
            bytes.clear();
            record.encode(piece, index as usize, &mut bytes);
            if let Err(error) = buckets.push(part, &bytes) {
                failure = Some(error);
                return false;
            }
        }
        progress.add(count as u64);
        !progress.is_cancelled()
    })?;
    buckets.end(failure, progress)
}

/// Layout of a triangle on the disk: positions, colours and texture coordinates of its corners, then its material.
struct Record {
    colors: SourceColors,
    has_uvs: bool,
    has_materials: bool,
}

impl Record {
    fn color_size(&self) -> usize {
        match self.colors {
            SourceColors::None => 0,
            SourceColors::Bytes => 3,
            SourceColors::Linear => 16,
        }
    }

    /// Bytes of a triangle on the disk.
    fn size(&self) -> usize {
        let material = if self.has_materials { 2 } else { 0 };
        3 * (12 + self.color_size() + if self.has_uvs { 8 } else { 0 }) + material
    }

    /// Bytes of a triangle in memory, its (tile, triangle) pairs included.
    fn bytes_in_memory(&self) -> u64 {
        let (colors, uvs) = (if self.colors == SourceColors::None { 0 } else { 48 }, if self.has_uvs { 24 } else { 0 });
        36 + colors + uvs + 24 + if self.has_materials { 2 } else { 0 }
    }

    fn encode(&self, mesh: &Mesh, triangle: usize, bytes: &mut Vec<u8>) {
        let corners = 3 * triangle..3 * triangle + 3;
        bytes.extend_from_slice(bytemuck::cast_slice(&mesh.positions[corners.clone()]));
        match self.colors {
            SourceColors::None => {}
            SourceColors::Bytes => {
                for color in &mesh.colors[corners.clone()] {
                    bytes.extend_from_slice(&rgb_bits(color.truncate()).to_le_bytes()[..3]);
                }
            }
            SourceColors::Linear => bytes.extend_from_slice(bytemuck::cast_slice(&mesh.colors[corners.clone()])),
        }
        if self.has_uvs {
            bytes.extend_from_slice(bytemuck::cast_slice(&mesh.uvs[corners]));
        }
        if self.has_materials {
            bytes.extend_from_slice(&mesh.material_of[triangle].to_ne_bytes());
        }
    }

    /// Appends whole records to a mesh.
    fn append_all(&self, bytes: &[u8], mesh: &mut Mesh) {
        let linear: [f32; 256] = std::array::from_fn(|byte| linear_from_srgb(byte as u8));
        for record in bytes.chunks_exact(self.size()) {
            let (positions, rest) = record.split_at(36);
            let (colors, rest) = rest.split_at(3 * self.color_size());
            let (uvs, material) = rest.split_at(if self.has_uvs { 24 } else { 0 });
            mesh.positions.extend(floats::<3>(positions).map(Vec3::from_array));
            match self.colors {
                SourceColors::None => {}
                SourceColors::Bytes => {
                    let linear = |byte: u8| linear[usize::from(byte)];
                    let colors = colors.as_chunks().0.iter();
                    mesh.colors.extend(colors.map(|&[b, g, r]| Vec4::new(linear(r), linear(g), linear(b), 1.0)));
                }
                SourceColors::Linear => mesh.colors.extend(floats::<4>(colors).map(Vec4::from_array)),
            }
            mesh.uvs.extend(floats::<2>(uvs).map(Vec2::from_array));
            mesh.material_of.extend(material.first_chunk().map(|bytes| u16::from_ne_bytes(*bytes)));
        }
    }
}

fn floats<const N: usize>(bytes: &[u8]) -> impl Iterator<Item = [f32; N]> + '_ {
    bytes.chunks_exact(4 * N).map(|vector| {
        std::array::from_fn(|at| {
            let bytes = &vector[4 * at..4 * at + 4];
            f32::from_ne_bytes([bytes[0], bytes[1], bytes[2], bytes[3]])
        })
    })
}
