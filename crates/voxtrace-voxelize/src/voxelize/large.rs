//! Meshes larger than memory: a first reading finds their bounds, a second one sorts the triangles into buckets on the disk,
//! one for each bin of tiles, and then each bin is a small mesh. Voxels and colours are those of the mesh in memory, bit for
//! bit, since every tile sees its triangles in the order of the file.

use super::bins::{self, Tiles, for_each_tile};
use super::blocks::{Bin, Blocks};
use super::buckets::Buckets;
use super::census::Census;
use super::key::rgb_bits;
use super::paint::Paints;
use super::palette::Palette;
use super::polygon::Pieces;
use super::spool::Spool;
use super::tile::Job;
use super::triangle::Triangle;
use super::{
    Estimate, Placement, Run, SurfaceRule, VoxelizeError, VoxelizeOptions, VoxelizeProgress, bytes_of, cameras_of,
    material_count, surface, tiles_of,
};
use crate::limits::Limits;
use crate::mesh::Mesh;
use crate::mesh::source::{Sample, SourceColors, TriangleSource};
use glam::{DVec3, Vec2, Vec3, Vec4};
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::material::linear_from_srgb;
use voxtrace_scene::scene::Scene;

/// Memory to work in where none is named.
pub(crate) const USUAL_BUDGET: u64 = 2 << 30;
/// Triangles looked at by one task.
const CHUNK: usize = 1 << 11;

/// What one reading of all triangles tells.
#[derive(Clone, Debug)]
pub struct Survey {
    low: Vec3,
    high: Vec3,
    /// Sums over the triangles of area times |n.x|+|n.y|+|n.z|, and times the largest of them.
    areas: [f64; 2],
    /// A corner of each triangle.
    sample: Sample,
}

impl Survey {
    /// Reads all triangles.
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

    /// All but the sample.
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

/// Voxelizes a mesh that is read piece by piece, and leaves its bricks in the spool.
pub(super) fn run(
    source: &mut dyn TriangleSource,
    survey: &Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    spool: &mut Spool,
    progress: &VoxelizeProgress,
) -> Result<(Run, Scene), VoxelizeError> {
    let budget = options.memory_budget.unwrap_or(USUAL_BUDGET);
    let placement = survey.placement(source.frame().offset, options)?;
    let tiles = tiles_of(&placement)?;
    let materials = source.materials();
    let record = Record { colors: source.colors(), has_uvs: source.has_uvs(), has_materials: materials.is_some() };
    let sample = survey.sample.points();
    let places = sample.iter().map(|&corner| (placement.voxels(corner) / f64::from(bins::TILE)).floor());
    let blocks = Blocks::of(
        &tiles,
        places.map(|tile| tile.as_ivec3().to_array()),
        survey.sample.stride(),
        budget / 4 / record.bytes_in_memory(),
    );
    // Sorting is one half of the work, what follows the other.
    let all = survey.triangles();
    progress.begin(2 * all);
    let mut buckets = Buckets::beside(path, blocks.bins(), budget / 16)?;
    let census = Census::default();
    spool.resume(&census, progress)?;
    let is_done = |bin: u32| spool.is_past(bin);
    sort(source, &placement, &tiles, &blocks, &is_done, &record, &mut buckets, progress)?;
    let mut scene = Scene::new(source.frame().name.clone());
    scene.unit = source.frame().unit;
    scene.cameras = cameras_of(source.frame(), &placement);
    source.release();

    let sizes = || (0..blocks.bins()).map(|bin| buckets.size(bin) / record.size() as u64);
    let records = sizes().sum::<u64>().max(1);
    let sizes: Vec<u64> = sizes().collect();
    let until = |done: u64| (u128::from(all) * u128::from(done) / u128::from(records)) as u64;
    let (mut mesh, mut done) = (source.frame().clone(), 0);
    for (number, size) in sizes.into_iter().enumerate() {
        mesh.clear();
        buckets.read(number, |bytes| record.append_all(bytes, &mut mesh))?;
        // A bin may have some of the materials, and is to be painted as a part of the whole.
        let paints = materials.as_ref().map_or_else(|| Paints::of(&mesh), |used| Paints::among(&mesh, used));
        let job = Job { mesh: &mesh, placement: &placement, paints: &paints, rule: options.rule, census: &census };
        let bin = Bin { blocks: &blocks, number: number as u32 };
        let pairs = bins::pairs_of(&mesh, &placement, &tiles, &bin);
        let share = until(done + size) - until(done);
        done += size;
        surface::run_band(&job, &tiles, &pairs, number as u32, share, spool, limits, progress)?;
    }
    if spool.brick_count() == 0 {
        return Err(VoxelizeError::Empty);
    }
    progress.add(all - until(done));
    mesh.clear();
    let palette = Palette::of(&census, &Paints::of(&mesh).classes, material_count(options), options.dither);
    Ok((Run { placement, palette }, scene))
}

/// Puts every triangle into the buckets of the bins that it reaches into, unless they are done.
#[expect(clippy::too_many_arguments, reason = "each is another thing")]
fn sort(
    source: &mut dyn TriangleSource,
    placement: &Placement,
    tiles: &Tiles,
    blocks: &Blocks,
    is_done: &dyn Fn(u32) -> bool,
    record: &Record,
    buckets: &mut Buckets,
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
                        let target = (blocks.bin(tiles, tile), index as u32);
                        if !targets[first..].contains(&target) {
                            targets.push(target);
                        }
                    });
                }
                targets
            })
            .collect();
        let mut bytes = Vec::with_capacity(record.size());
        for (bin, index) in targets.into_iter().flatten().filter(|(bin, _)| !is_done(*bin)) {
            bytes.clear();
            record.encode(piece, index as usize, &mut bytes);
            if let Err(error) = buckets.push(bin, &bytes) {
                failure = Some(error);
                return false;
            }
        }
        progress.add(count as u64);
        !progress.is_cancelled()
    })?;
    buckets.end(failure, progress)
}

/// How a triangle is written: its positions, then the colours and the texture coordinates of its corners, then its material.
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

    /// Bytes of a triangle in a mesh, and of its pairs.
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
