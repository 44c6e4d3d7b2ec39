//! From meshes to voxels: conservative or thin surfaces, and the insides of closed ones, in tiles that fit into the cache,
//! each voxel with the mean colour of the surface inside it. `docs/decisions/0012-voxelize.md` says why it is done so.

mod bins;
mod census;
mod fill;
mod key;
mod paint;
mod palette;
mod placement;
mod points;
mod polygon;
mod progress;
mod recolor;
mod spool;
mod thin;
mod tile;
mod triangle;

pub use placement::Placement;
pub use points::PointOptions;
pub use progress::VoxelizeProgress;
pub use recolor::{colors_of_texels, recolor};

use crate::brick::Brick;
use crate::grid::VoxelGrid;
use crate::import::{ImportError, ImportErrorKind, Limits};
use crate::material::MAX_MATERIALS;
use crate::mesh::Mesh;
use crate::output::TemporaryFile;
use crate::packed::{BrickSource, PackError, StreamError, save_streamed};
use crate::points::PointCloud;
use crate::scene::{Scene, Unit};
use bins::{TILE, Tiles};
use census::Census;
use fill::Column;
use glam::IVec3;
use paint::Paints;
use palette::Palette;
use rayon::prelude::*;
use spool::Spool;
use std::io;
use std::ops::Range;
use std::path::Path;
use tile::{Job, Scratch};
use triangle::Triangle;

/// How a mesh, or a cloud of points, becomes voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VoxelizeOptions {
    /// How large voxels are.
    pub scale: Scale,
    /// Which voxels a surface takes.
    pub rule: SurfaceRule,
    /// Also take the voxels inside closed surfaces.
    pub fill: bool,
    /// Most materials, 1 to [`MAX_MATERIALS`]; more colours than that are gathered.
    pub max_materials: usize,
    /// Mix two materials where none fits, if there are at most 1,024.
    pub dither: bool,
    /// Bytes of memory to aim at, the mesh included; `None` takes what is needed.
    pub memory_budget: Option<u64>,
    /// What is only asked where points become voxels.
    pub points: PointOptions,
}

impl Default for VoxelizeOptions {
    fn default() -> Self {
        Self {
            scale: Scale::Resolution(512),
            rule: SurfaceRule::Conservative,
            fill: false,
            max_materials: MAX_MATERIALS,
            dither: false,
            memory_budget: None,
            points: PointOptions::default(),
        }
    }
}

/// How large voxels are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// So many voxels along the longest side of the mesh.
    Resolution(u32),
    /// This edge, in the mesh's units.
    VoxelSize(f64),
}

/// Which voxels a surface takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurfaceRule {
    /// Every voxel that the surface crosses: nothing passes, not even along diagonals (26-separating).
    Conservative,
    /// Only as many as it takes that nothing passes through faces (6-separating): about two thirds of the others.
    Thin,
}

/// A mesh cannot be voxelized.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum VoxelizeError {
    /// The arrays of the mesh contradict each other.
    #[error("the mesh is broken: {0}")]
    BadMesh(String),
    /// There is no triangle with an area.
    #[error("the mesh has no surface")]
    Empty,
    /// The arrays of the cloud contradict each other.
    #[error("the points are broken: {0}")]
    BadPoints(String),
    /// There is no point.
    #[error("there are no points")]
    NoPoints,
    /// No voxel has so many points.
    #[error("no voxel has {0} points")]
    TooThin(u32),
    /// The points do not have what is to colour them.
    #[error("the points have no {0}")]
    Missing(&'static str),
    /// The size of a voxel is impossible.
    #[error("{0} is no size of a voxel")]
    BadScale(f64),
    /// More than allowed or possible.
    #[error("{what}: {needed} is more than {limit}")]
    TooLarge {
        /// What there would be too much of.
        what: &'static str,
        /// How much.
        needed: u64,
        /// How much may be.
        limit: u64,
    },
    /// Somebody asked to stop.
    #[error("stopped")]
    Cancelled,
    /// The operating system refused to write the file, or to keep what waits on the disk.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// The scene is too large for its file.
    #[error("{0}")]
    Pack(#[from] PackError),
}

impl From<StreamError> for VoxelizeError {
    fn from(error: StreamError) -> Self {
        match error {
            StreamError::Io(error) => Self::Io(error),
            StreamError::Pack(error) => Self::Pack(error),
        }
    }
}

impl VoxelizeError {
    /// The error of reading the file that held the mesh.
    pub(crate) fn into_import_error(self, path: &Path) -> ImportError {
        let kind = match self {
            Self::TooLarge { what, needed, limit } => {
                ImportErrorKind::Limit { what: what.into(), value: needed, limit }
            }
            Self::Io(error) => ImportErrorKind::Io(error),
            error => ImportErrorKind::Malformed(error.to_string()),
        };
        ImportError { path: path.into(), offset: None, kind }
    }
}

/// What voxelizing a mesh will come to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The grid.
    pub placement: Placement,
    /// Voxels, usually within a tenth, too many where surfaces share voxels.
    pub voxels: u64,
    /// Bytes of the scene.
    pub bytes: u64,
}

/// Estimates the voxels of a mesh: a plane of area A and normal n crosses A·(|n.x|+|n.y|+|n.z|) voxels, and takes the
/// largest of the three terms where it is thin.
///
/// # Errors
/// If there is no surface, or no grid for it.
pub fn estimate(mesh: &Mesh, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
    mesh.validate().map_err(VoxelizeError::BadMesh)?;
    let placement = Placement::of(mesh, options.scale)?;
    let chunk = 1 << 14;
    let count = mesh.triangle_count();
    let sums: Vec<f64> = (0..count.div_ceil(chunk))
        .into_par_iter()
        .map(|at| {
            let triangles = at * chunk..((at + 1) * chunk).min(count);
            let normals = triangles.filter_map(|index| Triangle::of(mesh, &placement, index)).map(|t| t.normal.abs());
            let voxels = normals.map(|normal| match options.rule {
                SurfaceRule::Conservative => normal.element_sum(),
                SurfaceRule::Thin => normal.max_element(),
            });
            voxels.sum::<f64>() * 0.5
        })
        .collect();
    // No more than there are in the grid.
    let most = placement.size.to_array().iter().map(|&n| n as f64).product::<f64>();
    let voxels = sums.iter().sum::<f64>().min(most).max(1.0);
    let is_plain = Paints::of(mesh).uniform.is_some();
    let bytes = voxels * if is_plain { 1.0 } else { 2.2 };
    Ok(Estimate { placement, voxels: voxels as u64, bytes: bytes as u64 })
}

/// Voxelizes a mesh into a scene of one grid.
///
/// # Errors
/// If the mesh has no surface, or its voxels go beyond the limit.
pub fn voxelize(mesh: &Mesh, options: &VoxelizeOptions, limits: &Limits) -> Result<Scene, VoxelizeError> {
    voxelize_watched(mesh, options, limits, &VoxelizeProgress::default())
}

/// As [`voxelize`], and tells how far it is.
///
/// # Errors
/// As [`voxelize`]; also if it was cancelled.
pub fn voxelize_watched(
    mesh: &Mesh,
    options: &VoxelizeOptions,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<Scene, VoxelizeError> {
    let mut spool = Spool::in_memory();
    let run = Run::start(mesh, options, limits, &mut spool, progress)?;
    let cameras = cameras_of(mesh, &run.placement);
    Ok(Scene { cameras, ..run.into_scene(&mesh.name, mesh.unit, spool)? })
}

/// Estimates the voxels of a cloud of points: not more than there are points.
///
/// # Errors
/// If there is no point, or no grid for them.
pub fn estimate_points(cloud: &PointCloud, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
    cloud.validate().map_err(VoxelizeError::BadPoints)?;
    let placement = Placement::of_points(cloud, options.scale)?;
    let most = placement.size.to_array().iter().map(|&n| n as f64).product::<f64>();
    let voxels = (cloud.positions.len() as f64).min(most);
    Ok(Estimate { placement, voxels: voxels as u64, bytes: (voxels * 2.2) as u64 })
}

/// Voxelizes a cloud of points into a scene of one grid: a voxel for every cube with points in it, in their mean colour.
///
/// # Errors
/// If there are no points, or their voxels go beyond the limit; also if it was cancelled.
pub fn voxelize_points(
    cloud: &PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<Scene, VoxelizeError> {
    let mut spool = Spool::in_memory();
    let run = points::run(cloud, options, limits, &mut spool, progress)?;
    let georeference = Some(run.placement.georeference(&cloud.crs));
    Ok(Scene { georeference, ..run.into_scene(&cloud.name, cloud.unit, spool)? })
}

/// Voxelizes a cloud of points straight into a native file, which holds the scene of [`voxelize_points`], packed.
///
/// # Errors
/// As [`voxelize_points`]; also if the file cannot be written.
pub fn voxelize_points_to_file(
    cloud: PointCloud,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let mut spool = spool_for(estimate_points(&cloud, options)?, options, path)?;
    let run = points::run(&cloud, options, limits, &mut spool, progress)?;
    let mut scene = Scene::new(cloud.name.clone());
    scene.unit = cloud.unit;
    scene.georeference = Some(run.placement.georeference(&cloud.crs));
    // The points may be the larger part of the memory.
    drop(cloud);
    run.write(scene, spool, path)
}

/// What was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Written {
    /// Voxels of the scene.
    pub voxels: u64,
    /// Its materials.
    pub materials: usize,
    /// Whether every colour is there as it was.
    pub is_exact: bool,
}

/// Bytes of bricks that may wait in memory where no budget is given.
const WAITING_BYTES: u64 = 1 << 30;

/// Voxelizes a mesh straight into a native file, tile by tile: with a memory budget, what waits lies on the disk beside it.
/// The file holds the scene that [`voxelize`] makes, packed.
///
/// # Errors
/// As [`voxelize_watched`]; also if the file cannot be written.
pub fn voxelize_to_file(
    mesh: Mesh,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let mut spool = spool_for(estimate(&mesh, options)?, options, path)?;
    let run = Run::start(&mesh, options, limits, &mut spool, progress)?;
    let mut scene = Scene::new(mesh.name.clone());
    scene.unit = mesh.unit;
    scene.cameras = cameras_of(&mesh, &run.placement);
    // The mesh may be the larger part of the memory.
    drop(mesh);
    run.write(scene, spool, path)
}

/// A spool in memory where all will fit, else in a file beside the output.
fn spool_for(estimate: Estimate, options: &VoxelizeOptions, path: &Path) -> Result<Spool, VoxelizeError> {
    let fits = options.memory_budget.is_none() && estimate.voxels.saturating_mul(5) < WAITING_BYTES;
    Ok(if fits { Spool::in_memory() } else { Spool::in_file(TemporaryFile::beside(path)?) })
}

/// The bricks of a spool with the materials of a palette.
struct SpooledBricks {
    spool: Spool,
    palette: Palette,
}

impl BrickSource for SpooledBricks {
    fn coordinates(&self) -> Vec<IVec3> {
        self.spool.coordinates().collect()
    }

    fn sort_by_key(&mut self, key: &(dyn Fn(IVec3) -> u64 + Sync)) {
        self.spool.sort_by_key(key);
    }

    fn for_each_batch(&mut self, each: &mut dyn FnMut(Vec<(IVec3, Brick)>) -> io::Result<()>) -> io::Result<()> {
        let palette = &self.palette;
        self.spool.for_each_batch(&|look, voxel| palette.index(look, voxel), each)
    }
}

fn cameras_of(mesh: &Mesh, placement: &Placement) -> Vec<crate::Camera> {
    let placed = mesh.cameras.iter().map(|camera| {
        let (eye, target) = (placement.point(camera.eye), placement.point(camera.target));
        crate::Camera { eye, target, ..camera.clone() }
    });
    placed.collect()
}

/// What is known when all tiles are done.
struct Run {
    placement: Placement,
    palette: Palette,
}

impl Run {
    /// The scene of all bricks in the spool.
    fn into_scene(self, name: &str, unit: Unit, mut spool: Spool) -> Result<Scene, VoxelizeError> {
        let mut bricks = Vec::with_capacity(spool.brick_count());
        let palette = &self.palette;
        spool.for_each_batch(&|look, voxel| palette.index(look, voxel), |batch| {
            bricks.extend(batch);
            Ok(())
        })?;
        let mut scene = Scene::from_grid(name, VoxelGrid::from_bricks(bricks), self.palette.materials);
        (scene.voxel_size, scene.unit) = (self.placement.voxel_size, unit);
        Ok(scene)
    }

    /// Writes a native file of `scene`, which has no grid, with all bricks of the spool.
    fn write(self, mut scene: Scene, spool: Spool, path: &Path) -> Result<Written, VoxelizeError> {
        scene.materials = self.palette.materials.clone();
        scene.voxel_size = self.placement.voxel_size;
        let (voxels, materials) = (spool.voxels(), scene.materials.len());
        let written = Written { voxels, materials, is_exact: self.palette.is_exact };
        save_streamed(path, &scene, &mut SpooledBricks { spool, palette: self.palette })?;
        Ok(written)
    }

    /// Works through all tiles and leaves their bricks in the spool.
    fn start(
        mesh: &Mesh,
        options: &VoxelizeOptions,
        limits: &Limits,
        spool: &mut Spool,
        progress: &VoxelizeProgress,
    ) -> Result<Self, VoxelizeError> {
        mesh.validate().map_err(VoxelizeError::BadMesh)?;
        let placement = Placement::of(mesh, options.scale)?;
        let tiles = tiles_of(&placement)?;
        let (paints, census) = (Paints::of(mesh), Census::default());
        let job = Job { mesh, placement: &placement, paints: &paints, rule: options.rule, census: &census };
        if options.fill {
            let mut pairs = bins::pairs_of(mesh, &placement, &tiles, &(0..tiles.layers()));
            progress.begin(pairs.len() as u64);
            run_columns(&job, &tiles, &mut pairs, spool, limits, progress)?;
        }
        let (bands, total) = match options.memory_budget {
            _ if options.fill => (Vec::new(), None),
            None => (vec![(0..tiles.layers(), None)], None),
            Some(budget) => {
                let by_layer = bins::pairs_by_layer(mesh, &placement, &tiles);
                let sum = |layers: &Range<usize>| by_layer[layers.clone()].iter().sum::<u64>();
                let bands = bands(&by_layer, pairs_within(budget, mesh.size_bytes()));
                (
                    bands.into_iter().map(|layers| (layers.clone(), Some(sum(&layers)))).collect(),
                    Some(by_layer.iter().sum()),
                )
            }
        };
        for (layers, announced) in bands {
            let pairs = bins::pairs_of(mesh, &placement, &tiles, &layers);
            let announced = announced.unwrap_or(pairs.len() as u64);
            progress.begin(total.unwrap_or(announced));
            run_band(&job, &tiles, &pairs, announced, spool, limits, progress)?;
        }
        if spool.brick_count() == 0 {
            return Err(VoxelizeError::Empty);
        }
        let palette = Palette::of(&census, &paints.classes, material_count(options), options.dither);
        Ok(Self { placement, palette })
    }
}

/// The tiles of a grid.
fn tiles_of(placement: &Placement) -> Result<Tiles, VoxelizeError> {
    let limit = u64::from(u32::MAX);
    Tiles::of(placement).ok_or(VoxelizeError::TooLarge { what: "tiles of the grid", needed: limit + 1, limit })
}

/// Most materials that there may be.
fn material_count(options: &VoxelizeOptions) -> usize {
    options.max_materials.clamp(1, MAX_MATERIALS)
}

/// Pairs of a tile and what is in it that may be in memory at once, besides a model of `bytes`.
fn pairs_within(budget: u64, bytes: u64) -> u64 {
    /// Bytes of a pair, while two lists of them exist.
    const PAIR: u64 = 16;
    (budget.saturating_sub(bytes) / 4 / PAIR).max(1 << 20)
}

/// Runs of layers whose pairs fit into memory; a layer that does not fit is one on its own.
fn bands(by_layer: &[u64], most: u64) -> Vec<Range<usize>> {
    let (mut bands, mut start, mut sum) = (Vec::new(), 0, 0);
    for (layer, &pairs) in by_layer.iter().enumerate() {
        if sum + pairs > most && layer > start {
            bands.push(start..layer);
            (start, sum) = (layer, 0);
        }
        sum += pairs;
    }
    bands.push(start..by_layer.len());
    bands
}

/// Works through the columns of tiles of the pairs, the insides included.
fn run_columns(
    job: &Job,
    tiles: &Tiles,
    pairs: &mut [u64],
    spool: &mut Spool,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    /// Columns that are done before their bricks go to the spool.
    const BATCH: usize = 16;
    let place = |pair: &u64| tiles.tile((pair >> 32) as u32);
    pairs.par_sort_by_key(|pair| {
        let tile = place(pair);
        (tile.y, tile.x, tile.z, *pair as u32)
    });
    let columns: Vec<&[u64]> = pairs.chunk_by(|a, b| place(a).truncate() == place(b).truncate()).collect();
    for batch in columns.chunks(BATCH) {
        let work = |scratch: &mut Scratch, pairs: &&[u64]| {
            let mut triangles: Vec<usize> = pairs.iter().map(|&pair| pair as u32 as usize).collect();
            triangles.sort_unstable();
            triangles.dedup();
            let first = place(&pairs[0]);
            let column = Column::of(job.mesh, job.placement, first, &triangles);
            let (low, high) = column
                .extent()
                .map_or((first.z, first.z), |(low, high)| (low.div_euclid(TILE), (high - 1).div_euclid(TILE)));
            let (low, high) = (low.min(first.z), high.max(place(&pairs[pairs.len() - 1]).z));
            let mut rest = *pairs;
            let tile = |z: i32| {
                let (own, after) = rest.split_at(rest.partition_point(|pair| place(pair).z <= z));
                rest = after;
                let triangles = own.iter().map(|&pair| pair as u32 as usize);
                job.tile(IVec3::new(first.x, first.y, z), triangles, Some(&column), scratch)
            };
            (low..=high).map(tile).collect::<Vec<_>>()
        };
        let records: Vec<Vec<_>> = batch.par_iter().with_max_len(1).map_init(Scratch::new, work).collect();
        for record in records.into_iter().flatten() {
            spool.push(record)?;
        }
        check_on(spool, limits, progress)?;
        progress.add(batch.iter().map(|pairs| pairs.len() as u64).sum());
    }
    Ok(())
}

/// Whether the work may go on.
fn check_on(spool: &Spool, limits: &Limits, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
    if spool.voxels() > limits.voxels {
        return Err(VoxelizeError::TooLarge { what: "voxels", needed: spool.voxels(), limit: limits.voxels });
    }
    if progress.is_cancelled() { Err(VoxelizeError::Cancelled) } else { Ok(()) }
}

/// Works through the tiles of sorted pairs.
fn run_band(
    job: &Job,
    tiles: &Tiles,
    pairs: &[u64],
    announced: u64,
    spool: &mut Spool,
    limits: &Limits,
    progress: &VoxelizeProgress,
) -> Result<(), VoxelizeError> {
    /// Tiles that are done before their bricks go to the spool.
    const BATCH: usize = 256;
    let tile_of = |pair: &u64| (pair >> 32) as u32;
    let parts: Vec<&[u64]> = pairs.chunk_by(|a, b| tile_of(a) == tile_of(b)).collect();
    let mut told = 0;
    for batch in parts.chunks(BATCH) {
        let work = |scratch: &mut Scratch, pairs: &&[u64]| {
            let triangles = pairs.iter().map(|&pair| pair as u32 as usize);
            job.tile(tiles.tile(tile_of(&pairs[0])), triangles, None, scratch)
        };
        let records: Vec<_> = batch.par_iter().with_max_len(4).map_init(Scratch::new, work).collect();
        for record in records {
            spool.push(record)?;
        }
        check_on(spool, limits, progress)?;
        let done = batch.iter().map(|pairs| pairs.len() as u64).sum::<u64>().min(announced - told);
        told += done;
        progress.add(done);
    }
    // Announced was an upper bound.
    progress.add(announced - told);
    Ok(())
}
