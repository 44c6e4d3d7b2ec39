//! Out-of-core voxelization of meshes larger than memory. A first pass over the file surveys its triangles; a second one
//! bucket-sorts them on the disk by the part of the grid that they reach into; then each part is voxelized as a small mesh. Voxels
//! and colours are the same bits as for a mesh in memory, since every tile sees its triangles in the order of the file.

mod part;
mod record;
mod tiles;

pub use part::{MeshFiles, ReadMesh, merge_mesh_tiles, voxelize_mesh_tiles};
pub use tiles::MeshTiles;

use super::appearance::BsdfClass;
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
use crate::mesh::source::{Sample, SourceColors, TriangleSource};
use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use record::Record;
use std::ops::Range;
use std::path::Path;
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
        let mut survey = Self::empty();
        progress.begin(source.count());
        source.for_each(&mut |piece| {
            piece.positions.as_chunks::<3>().0.iter().for_each(|triangle| survey.add(triangle));
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

    fn empty() -> Self {
        Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY, areas: [0.0; 2], sample: Sample::default() }
    }

    fn add(&mut self, triangle: &[Vec3; 3]) {
        for &corner in triangle {
            (self.low, self.high) = (self.low.min(corner), self.high.max(corner));
        }
        let [a, b, c] = triangle.map(|corner| corner.as_dvec3());
        let area = (b - a).cross(c - a).abs() * 0.5;
        self.areas[0] += area.element_sum();
        self.areas[1] += area.max_element();
        self.sample.add(|| triangle[0]);
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
    let plan = Plan::of(source, survey, options, 1)?;
    // Sorting counts as one half of the work, voxelizing as the other.
    let all = survey.triangles();
    progress.begin(2 * all);
    let histogram = ColorHistogram::default();
    spill.resume(&histogram, progress)?;
    let work = Work { plan: &plan, options, limits, path, histogram: &histogram, progress };
    work.voxelize(source, plan.partition.share(0), all, spill)?;
    if spill.brick_count() == 0 {
        return Err(VoxelizeError::Empty);
    }
    Ok((plan.finish(source, &histogram, options), plan.scene(source)))
}

/// Where the voxels lie, and how tiles are divided into parts and triangles lie on the disk.
struct Plan {
    placement: Placement,
    tiles: TileGrid,
    partition: TilePartition,
    record: Record,
    /// As [`TriangleSource::materials`].
    materials: Option<Vec<bool>>,
}

impl Plan {
    /// The plan of so many shares of about as many triangles each.
    fn of(
        source: &mut dyn TriangleSource,
        survey: &Survey,
        options: &VoxelizeOptions,
        shares: usize,
    ) -> Result<Self, VoxelizeError> {
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
            shares,
        );
        Ok(Self { placement, tiles, partition, record, materials })
    }

    /// What becomes of all bricks together: their materials are those of the histogram's colours.
    fn finish(
        &self,
        source: &mut dyn TriangleSource,
        histogram: &ColorHistogram,
        options: &VoxelizeOptions,
    ) -> Voxelized {
        let has_uvs = source.has_uvs();
        let mesh = source.frame();
        // Whether there are texture coordinates decides what classes there are.
        if has_uvs {
            mesh.uvs.push(Vec2::ZERO);
        }
        let classes = BsdfClass::in_voxels(&MeshAppearance::of(mesh).classes, self.placement.voxel_size);
        mesh.uvs.clear();
        let palette = Palette::of(histogram, &classes, material_count(options), options.dither);
        Voxelized { placement: self.placement, palette }
    }

    /// The scene without its grid.
    fn scene(&self, source: &mut dyn TriangleSource) -> Scene {
        let frame = source.frame();
        Scene { cameras: cameras_of(frame, &self.placement), ..scene_of_source(&frame.name, frame.unit) }
    }
}

/// The work of voxelizing parts of a plan.
struct Work<'a> {
    plan: &'a Plan,
    options: &'a VoxelizeOptions,
    limits: &'a Limits,
    /// Intermediate data lies beside it.
    path: &'a Path,
    histogram: &'a ColorHistogram,
    progress: &'a VoxelizeProgress,
}

impl Work<'_> {
    /// Voxelizes some parts of the plan into the spill buffer. Progress goes on by `all` while triangles are sorted, and by as much again
    /// while they are voxelized.
    fn voxelize(
        &self,
        source: &mut dyn TriangleSource,
        parts: Range<u32>,
        all: u64,
        spill: &mut SpillBuffer,
    ) -> Result<(), VoxelizeError> {
        let Plan { placement, tiles, partition, record, materials } = self.plan;
        let budget = self.options.memory_budget.unwrap_or(DEFAULT_BUDGET);
        let mut buckets = DiskBuckets::beside(self.path, partition.part_count(), budget / 16)?;
        let is_wanted = |part: u32| parts.contains(&part) && !spill.is_past(part);
        sort(source, self.plan, &is_wanted, &mut buckets, self.progress)?;
        source.release();

        let sizes: Vec<u64> = parts.clone().map(|part| buckets.size(part as usize) / record.size() as u64).collect();
        let records = sizes.iter().sum::<u64>().max(1);
        let until = |done: u64| (u128::from(all) * u128::from(done) / u128::from(records)) as u64;
        let (mut mesh, mut done) = (source.frame().clone(), 0);
        for (number, size) in parts.zip(sizes) {
            mesh.clear();
            buckets.read(number as usize, |bytes| record.append_all(bytes, &mut mesh))?;
            // A part may use fewer materials, but its appearance must be that of the whole mesh.
            let appearance =
                materials.as_ref().map_or_else(|| MeshAppearance::of(&mesh), |used| MeshAppearance::among(&mesh, used));
            let job = TileJob {
                mesh: &mesh,
                placement,
                appearance: &appearance,
                rule: self.options.rule,
                histogram: self.histogram,
            };
            let pairs = binning::pairs_of(&mesh, placement, tiles, &Part { partition, number });
            let share = until(done + size) - until(done);
            done += size;
            surface::run_band(&job, tiles, &pairs, number, share, spill, self.limits, self.progress)?;
        }
        self.progress.add(all - until(done));
        Ok(())
    }
}

/// Puts every triangle into the buckets of the parts that it reaches into, as far as they are wanted.
fn sort(
    source: &mut dyn TriangleSource,
    Plan { placement, tiles, partition, record, .. }: &Plan,
    is_wanted: &(dyn Fn(u32) -> bool + Sync),
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
        for (part, index) in targets.into_iter().flatten().filter(|(part, _)| is_wanted(*part)) {
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
