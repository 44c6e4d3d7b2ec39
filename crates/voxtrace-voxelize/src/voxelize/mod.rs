//! From meshes to voxels: conservative or thin surfaces, and the insides of closed ones, in tiles that fit into the cache,
//! each voxel with the mean colour of the surface inside it. `docs/decisions/0012-voxelize.md` says why it is done so.

mod bins;
mod blocks;
mod buckets;
mod by_tile;
mod census;
mod distinct;
mod fill;
mod fingerprint;
mod key;
pub mod large;
pub mod large_points;
mod paint;
mod palette;
mod part;
mod placement;
mod points;
mod polygon;
mod progress;
mod recolor;
mod spool;
mod surface;
mod thin;
mod tile;
mod triangle;

pub use placement::Placement;
pub use points::PointOptions;
pub use progress::VoxelizeProgress;
pub use recolor::{colors_of_texels, gather_colors, recolor};

use crate::import_error::{ImportError, ImportErrorKind};
use crate::limits::Limits;
use crate::mesh::{Mesh, source::TriangleSource};
use crate::points::{PointCloud, source::PointSource};
use bins::Tiles;
use distinct::Distinct;
use glam::IVec3;
use paint::Paints;
use palette::Palette;
use rayon::prelude::*;
use spool::Spool;
use std::io;
use std::ops::Range;
use std::path::Path;
use triangle::Triangle;
use voxtrace_core::packed::{BrickSource, PackError, StreamError, save_streamed};
use voxtrace_scene::brick::Brick;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::MAX_MATERIALS;
use voxtrace_scene::scene::{Scene, Unit};

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
            scale: Scale::Automatic,
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
    /// What suits it: for points as many as keep surfaces closed ([`PointCloud::suited_resolution`]), for a mesh 512 along the
    /// longest side, for a volume one for each sample.
    Automatic,
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
    /// The file cannot be read, of which not everything is in memory.
    #[error("{0}")]
    Import(#[from] ImportError),
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
    pub fn into_import_error(self, path: &Path) -> ImportError {
        let kind = match self {
            Self::TooLarge { what, needed, limit } => {
                ImportErrorKind::Limit { what: what.into(), value: needed, limit }
            }
            Self::Io(error) => ImportErrorKind::Io(error),
            Self::Import(error) => return error,
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
    /// Whether there may be many less of both.
    pub is_bound: bool,
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
    let voxels = placement.at_most(sums.iter().sum::<f64>());
    let is_plain = Paints::of(mesh).uniform.is_some();
    Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, is_plain), is_bound: false })
}

/// Bytes of a scene of so many voxels, in one colour or in many.
fn bytes_of(voxels: u64, is_plain: bool) -> u64 {
    (voxels as f64 * if is_plain { 1.0 } else { 2.2 }) as u64
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
    let run = surface::run(mesh, options, limits, &mut spool, progress)?;
    let cameras = cameras_of(mesh, &run.placement);
    Ok(Scene { cameras, ..run.into_scene(&mesh.name, mesh.unit, spool)? })
}

/// Estimates the voxels of a cloud of points by counting those that have any, to about one in a hundred.
///
/// # Errors
/// If there is no point, or no grid for them.
pub fn estimate_points(cloud: &PointCloud, options: &VoxelizeOptions) -> Result<Estimate, VoxelizeError> {
    cloud.validate().map_err(VoxelizeError::BadPoints)?;
    let placement = Placement::of_points(cloud, options.scale)?;
    let part = |points: &[glam::Vec3]| {
        let mut part = Distinct::default();
        points.iter().for_each(|&point| part.add(placement.voxels(point).as_ivec3()));
        part
    };
    let size = cloud.positions.len().div_ceil(rayon::current_num_threads()).max(1);
    let parts: Vec<Distinct> = cloud.positions.par_chunks(size).map(part).collect();
    let mut distinct = Distinct::default();
    parts.iter().for_each(|part| distinct.merge(part));
    let voxels = placement.at_most(distinct.count().min(cloud.positions.len() as f64));
    let is_bound = options.points.min_points > 1;
    Ok(Estimate { placement, voxels, bytes: bytes_of(voxels, false), is_bound })
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
    // Voxels are not more than points, and counting them takes a while.
    let is_small = options.memory_budget.is_none()
        && (are_few(cloud.positions.len() as u64) || are_few(estimate_points(&cloud, options)?.voxels));
    let key = (!is_small).then(|| fingerprint::of_points(&cloud, options));
    into_file(key, path, progress, |spool| {
        let run = points::run(&cloud, options, limits, spool, progress)?;
        let mut scene = Scene::new(cloud.name.clone());
        scene.unit = cloud.unit;
        scene.georeference = Some(run.placement.georeference(&cloud.crs));
        // The points may be the larger part of the memory.
        drop(cloud);
        Ok((run, scene))
    })
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
const WAITING_BYTES: u64 = 1 << 28;

/// Voxelizes a mesh straight into a native file, tile by tile: with a memory budget, and where there are many voxels, what
/// waits lies in a part file beside it. When that work is stopped or killed, the same work goes on from there.
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
    let is_small = options.memory_budget.is_none() && are_few(estimate(&mesh, options)?.voxels);
    let key = (!is_small).then(|| fingerprint::of_mesh(&mesh, options));
    into_file(key, path, progress, |spool| {
        let run = surface::run(&mesh, options, limits, spool, progress)?;
        let mut scene = Scene::new(mesh.name.clone());
        scene.unit = mesh.unit;
        scene.cameras = cameras_of(&mesh, &run.placement);
        // The mesh may be the larger part of the memory.
        drop(mesh);
        Ok((run, scene))
    })
}

/// As [`voxelize_to_file`], for triangles that are read when they are needed, from a file with a stamp.
pub fn voxelize_large_to_file(
    (source, stamp): (&mut dyn TriangleSource, &str),
    survey: &large::Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let key = fingerprint::of_large_mesh(source.frame(), stamp, survey.summary(), options);
    let work = |spool: &mut Spool| large::run(source, survey, options, limits, path, spool, progress);
    into_file(Some(key), path, progress, work)
}

/// As [`voxelize_points_to_file`], for points that are read when they are needed, from a file with a stamp.
pub fn voxelize_large_points_to_file(
    (source, stamp): (&mut dyn PointSource, &str),
    survey: &large_points::Survey,
    options: &VoxelizeOptions,
    limits: &Limits,
    path: &Path,
    progress: &VoxelizeProgress,
) -> Result<Written, VoxelizeError> {
    let key = fingerprint::of_large_points(source.frame(), stamp, survey.summary(), options);
    let work = |spool: &mut Spool| large_points::run(source, survey, options, limits, path, spool, progress);
    into_file(Some(key), path, progress, work)
}

/// Whether the bricks of so many voxels wait in memory: such work is done soon, and begins anew when it was interrupted.
fn are_few(voxels: u64) -> bool {
    voxels.saturating_mul(5) < WAITING_BYTES
}

/// Writes what `work` leaves in a spool into a native file. With a key, what is done outlives a process that ends too early.
fn into_file(
    key: Option<u128>,
    path: &Path,
    progress: &VoxelizeProgress,
    work: impl FnOnce(&mut Spool) -> Result<(Run, Scene), VoxelizeError>,
) -> Result<Written, VoxelizeError> {
    let mut spool = match key {
        None => Spool::in_memory(),
        Some(key) => Spool::beside(path, key)?,
    };
    let written = work(&mut spool).and_then(|(run, scene)| run.write(scene, &mut spool, path, progress));
    if let Err(VoxelizeError::Cancelled | VoxelizeError::Io(_)) = written {
        spool.keep(progress);
    }
    written
}

/// The bricks of a spool with the materials of a palette.
struct SpooledBricks<'a> {
    spool: &'a mut Spool,
    palette: Palette,
    progress: &'a VoxelizeProgress,
}

impl BrickSource for SpooledBricks<'_> {
    fn coordinates(&self) -> Vec<IVec3> {
        self.spool.coordinates().collect()
    }

    fn sort_by_key(&mut self, key: &(dyn Fn(IVec3) -> u64 + Sync)) {
        self.spool.sort_by_key(key);
    }

    fn for_each_batch(&mut self, each: &mut dyn FnMut(Vec<(IVec3, Brick)>) -> io::Result<()>) -> io::Result<()> {
        let (palette, progress) = (&self.palette, self.progress);
        self.spool.for_each_batch(&|look, voxel| palette.index(look, voxel), |batch| {
            if progress.is_cancelled() { Err(io::ErrorKind::Interrupted.into()) } else { each(batch) }
        })
    }
}

fn cameras_of(mesh: &Mesh, placement: &Placement) -> Vec<voxtrace_scene::Camera> {
    let placed = mesh.cameras.iter().map(|camera| {
        let (eye, target) = (placement.point(camera.eye), placement.point(camera.target));
        voxtrace_scene::Camera { eye, target, ..camera.clone() }
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
    fn write(
        self,
        mut scene: Scene,
        spool: &mut Spool,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        scene.materials = self.palette.materials.clone();
        scene.voxel_size = self.placement.voxel_size;
        let (voxels, materials) = (spool.voxels(), scene.materials.len());
        let written = Written { voxels, materials, is_exact: self.palette.is_exact };
        match save_streamed(path, &scene, &mut SpooledBricks { spool, palette: self.palette, progress }) {
            Err(_) if progress.is_cancelled() => Err(VoxelizeError::Cancelled),
            saved => Ok(saved.map(|()| written)?),
        }
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

/// Whether the work may go on.
fn check_on(spool: &Spool, limits: &Limits, progress: &VoxelizeProgress) -> Result<(), VoxelizeError> {
    if spool.voxels() > limits.voxels {
        return Err(VoxelizeError::TooLarge { what: "voxels", needed: spool.voxels(), limit: limits.voxels });
    }
    if progress.is_cancelled() { Err(VoxelizeError::Cancelled) } else { Ok(()) }
}
