//! Volumes: scalar samples on a regular lattice, as scanners and simulations make them. A [`Transfer`] function maps values to
//! colours or to nothing; [`voxelize`] resamples the volume to cubic voxels.

mod automatic;
mod estimate;
mod labels;
pub mod large;
mod overlay;
mod own_colors;
mod resample;
mod slab;
mod statistics;
mod transfer;

pub use estimate::{VolumeEstimate, estimate};
pub use overlay::Overlay;
pub use statistics::ValueStatistics;
pub use transfer::{LabelColor, Preset, Ramp, Transfer};

use crate::import_error::{ImportError, ImportErrorKind};
use crate::limits::Limits;
use crate::mesh::UpAxis;
use crate::voxelize::Scale;
use glam::{DAffine3, DMat3, DVec3};
use overlay::Layers;
use rayon::prelude::*;
use resample::Axis;
use std::path::Path;
use voxtrace_scene::Invalid;
use voxtrace_scene::Transform;
use voxtrace_scene::VoxelGrid;
use voxtrace_scene::georeference::Georeference;
use voxtrace_scene::grid::MAX_COORDINATE;
use voxtrace_scene::scene::{Scene, Unit};

/// Most voxels along an axis by default.
const DEFAULT_MAX_SIZE: f64 = 2048.0;
/// Sine of the angle up to which a lattice axis counts as parallel to a world axis.
const MAX_TILT: f64 = 1e-3;

/// Samples on a lattice, and the lattice's place in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Volume {
    /// Name for people, for example the file's stem.
    pub name: String,
    /// Samples along each axis of the lattice, ≥ 1.
    pub size: [usize; 3],
    /// The samples after rescaling, the first axis fastest.
    pub values: Vec<f32>,
    /// Colours of the samples, sRGB, which voxels then have in place of those of the transfer function; empty where there are none. The
    /// function still says which values are seen.
    pub colors: Vec<[u8; 3]>,
    /// From lattice indices (whole at the middle of a sample) to the world: right-handed, z up, in `unit`s. A patient
    /// stands upright and looks along −y, towards the camera of [`voxtrace_core::PackedScene::overview`]: the axes point to
    /// the left, to the back and to the head (LPS).
    pub world_from_index: DAffine3,
    /// Unit of the world.
    pub unit: Unit,
    /// Whether the file says that its values are labels.
    pub is_labels: bool,
    /// The transfer function for the kind of data that the file says it holds.
    pub suited: Option<Preset>,
    /// Warnings of the reader, for people.
    pub notes: Vec<String>,
}

/// How a volume is voxelized.
#[derive(Clone, Debug, PartialEq)]
pub struct VolumeOptions {
    /// Edge of a voxel; `None` takes the smallest spacing of the samples.
    pub scale: Option<Scale>,
    /// The transfer function; `None` chooses one by the values ([`Transfer::automatic`]).
    pub transfer: Option<Transfer>,
    /// Overrides the transfer function's threshold.
    pub threshold: Option<f32>,
    /// Whether only voxels with an empty neighbour (of six) are kept; no ray from outside reaches the others. All are kept where something is not
    /// opaque.
    pub shell: bool,
    /// What lies over the volume, the topmost last.
    pub overlays: Vec<Overlay>,
}

impl Default for VolumeOptions {
    fn default() -> Self {
        Self { scale: None, transfer: None, threshold: None, shell: true, overlays: Vec::new() }
    }
}

/// Why a volume cannot be voxelized.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum VolumeError {
    /// Size, samples and transform contradict each other.
    #[error("the volume is broken: {0}")]
    BadVolume(Invalid),
    /// The transfer function shows none of the samples.
    #[error(
        "no sample is to be seen: values lie between {lowest} and {highest}, and the transfer function {transfer} shows {shown}"
    )]
    Empty {
        /// The least value.
        lowest: f32,
        /// The greatest value.
        highest: f32,
        /// Name of the transfer function.
        transfer: String,
        /// What it shows, for people.
        shown: String,
    },
    /// A volume and what is to lie over it are in different places.
    #[error("{overlay} lies beside {volume}: {there}, not {here}")]
    Apart {
        /// Name of what is to lie over the volume.
        overlay: String,
        /// Name of the volume.
        volume: String,
        /// Where the former reaches from and to, for people.
        there: String,
        /// Where the volume does.
        here: String,
    },
    /// Neither the place of an overlay nor the number of its samples says where it lies.
    #[error("{overlay} does not say where it lies, and its {there} samples are not the {here} of {volume}")]
    NoPlace {
        /// Name of what is to lie over the volume.
        overlay: String,
        /// Name of the volume.
        volume: String,
        /// Samples of the former along its axes, for people.
        there: String,
        /// Those of the volume.
        here: String,
    },
    /// The values of a volume are no labels.
    #[error("{name} holds no labels: {reason}")]
    NoLabels {
        /// Name of the volume.
        name: String,
        /// What is in the way, for people.
        reason: String,
    },
    /// The transfer function of an overlay shows nothing within the volume.
    #[error("nothing of {overlay} is to be seen within {volume}: {transfer} shows {shown}")]
    EmptyOverlay {
        /// Name of what lies over the volume.
        overlay: String,
        /// Name of the volume.
        volume: String,
        /// Name of the transfer function.
        transfer: String,
        /// What it shows, for people.
        shown: String,
    },
    /// The size of a voxel is not a positive, finite number.
    #[error("{0} is no size of a voxel")]
    BadScale(f64),
    /// A limit is exceeded.
    #[error("{what}: {needed} is more than the limit of {limit}")]
    TooLarge {
        /// The limited quantity, for people.
        what: &'static str,
        /// How much of it there would be.
        needed: u64,
        /// How much is allowed.
        limit: u64,
    },
}

impl VolumeError {
    /// The same error as one of importing the file at `path`, which held the volume.
    pub fn into_import_error(self, path: &Path) -> ImportError {
        let kind = match self {
            Self::TooLarge { what, needed, limit } => {
                ImportErrorKind::Limit { what: what.into(), value: needed, limit }
            }
            error => ImportErrorKind::Malformed(error.to_string()),
        };
        ImportError { path: path.into(), offset: None, kind }
    }
}

impl Volume {
    /// A volume with an identity transform (spacing 1) and no unit.
    pub fn new(size: [usize; 3], values: Vec<f32>) -> Self {
        Self {
            name: String::new(),
            size,
            values,
            colors: Vec::new(),
            world_from_index: DAffine3::IDENTITY,
            unit: Unit::Voxel,
            is_labels: false,
            suited: None,
            notes: Vec::new(),
        }
    }

    /// Distance between samples along each axis of the lattice.
    pub fn spacing(&self) -> DVec3 {
        let axes = self.world_from_index.matrix3;
        DVec3::new(axes.x_axis.length(), axes.y_axis.length(), axes.z_axis.length())
    }

    /// Sets the distance between samples along each axis of the lattice; the first sample stays in place.
    pub fn set_spacing(&mut self, spacing: DVec3) {
        let factors = spacing / self.spacing();
        self.world_from_index.matrix3 *= DMat3::from_diagonal(factors);
    }

    /// Turns the world so that `up` becomes +z.
    pub fn make_z_up(&mut self, up: UpAxis) {
        let turn = DMat3::from_cols(up.to_z_up_f64(DVec3::X), up.to_z_up_f64(DVec3::Y), up.to_z_up_f64(DVec3::Z));
        self.world_from_index = DAffine3::from_mat3(turn) * self.world_from_index;
    }

    /// Checks that the number of samples is that of lattice points and that the transform is invertible.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), Invalid> {
        let count = self.size.iter().try_fold(1usize, |count, &size| count.checked_mul(size));
        if count != Some(self.values.len()) || self.values.is_empty() {
            return Err(format!("{:?} samples are not the {} that there are", self.size, self.values.len()).into());
        }
        if !self.colors.is_empty() && self.colors.len() != self.values.len() {
            return Err("there is not one colour for each sample".into());
        }
        self.validate_lattice()
    }

    /// Checks that there are samples and that the transform is invertible, whether the samples are here or not.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate_lattice(&self) -> Result<(), Invalid> {
        if self.size.contains(&0) {
            return Err("a volume without samples".into());
        }
        let place = self.world_from_index;
        let spacing = self.spacing();
        if !place.is_finite() || !spacing.cmpgt(DVec3::splat(1e-12)).all() || !spacing.cmplt(DVec3::splat(1e12)).all() {
            return Err("the places of the samples are not finite or not apart".into());
        }
        if (place.matrix3.determinant() / spacing.element_product()).abs() < 1e-3 {
            return Err("the axes of the lattice lie in a plane".into());
        }
        Ok(())
    }

    /// Statistics of the values.
    pub fn statistics(&self) -> ValueStatistics {
        ValueStatistics::of(self)
    }
}

/// How the lattice is laid onto the voxel grid.
struct Placement {
    /// For each axis of the grid: the lattice axis along it, and whether it runs backwards.
    axes: [Axis; 3],
    voxel_size: f64,
    world_from_grid: Transform,
    georeference: Georeference,
    /// From the coordinates of the grid to the world of the volume, in its unit.
    coordinates_from_grid: DAffine3,
}

impl Placement {
    /// `box_limit` is the most voxels that the whole box may have, empty ones included.
    fn of(volume: &Volume, scale: Option<Scale>, box_limit: u64, nearest: bool) -> Result<Self, VolumeError> {
        let spacing = volume.spacing();
        let lengths = spacing * DVec3::from_array(volume.size.map(|size| size as f64));
        let voxel_size = match scale {
            Some(Scale::VoxelSize(size)) => size,
            Some(Scale::Resolution(count)) => lengths.max_element() / f64::from(count.max(1)),
            None | Some(Scale::Automatic) => spacing.min_element().max(lengths.max_element() / DEFAULT_MAX_SIZE),
        };
        if !voxel_size.is_finite() || voxel_size <= 0.0 {
            return Err(VolumeError::BadScale(voxel_size));
        }
        let axes = volume.world_from_index.matrix3;
        let directions = [axes.x_axis / spacing.x, axes.y_axis / spacing.y, axes.z_axis / spacing.z];
        let order = nearest_axes(directions);
        let mut counts = [0; 3];
        for (world, &(lattice, _)) in order.iter().enumerate() {
            let count = (lengths[lattice] / voxel_size).round().max(1.0);
            let most = f64::from(MAX_COORDINATE / 2);
            if count > most {
                return Err(VolumeError::TooLarge {
                    what: "voxels along an axis",
                    needed: count as u64,
                    limit: most as u64,
                });
            }
            counts[world] = count as usize;
        }
        let needed = counts.iter().map(|&count| count as u64).fold(1, u64::saturating_mul);
        if needed > box_limit {
            return Err(VolumeError::TooLarge { what: "voxels of the whole box", needed, limit: box_limit });
        }
        // From the axes of the grid, which are the lattice's in another order, to the world.
        let signed = |world: usize| {
            let (lattice, backwards) = order[world];
            if backwards { -directions[lattice] } else { directions[lattice] }
        };
        let linear = DMat3::from_cols(signed(0), signed(1), signed(2));
        // A voxel is a little longer or shorter along an axis where its length is no multiple of the edge.
        let edges = DVec3::from_array(std::array::from_fn(|world| lengths[order[world].0] / counts[world] as f64));
        let coordinates = linear * DMat3::from_diagonal(edges);
        let is_straight = (linear - DMat3::IDENTITY).to_cols_array().iter().all(|value| value.abs() < MAX_TILT);
        let is_rotation =
            (linear.transpose() * linear - DMat3::IDENTITY).to_cols_array().iter().all(|v| v.abs() < 1e-5);
        let linear = if is_straight || !is_rotation { DMat3::IDENTITY } else { linear };
        let first = DVec3::from_array(std::array::from_fn(|lattice| {
            let backwards = order.iter().any(|&(axis, backwards)| axis == lattice && backwards);
            if backwards { volume.size[lattice] as f64 - 0.5 } else { -0.5 }
        }));
        let first = volume.world_from_index.transform_point3(first);
        let corner = first / voxel_size;
        // Whole voxels, so that the volume keeps the grid's alignment; what is too far away for f32 stays here.
        let corner = if linear == DMat3::IDENTITY { corner.round() } else { corner };
        let corner = if corner.abs().max_element() < f64::from(MAX_COORDINATE / 2) { corner } else { DVec3::ZERO };
        let axes = std::array::from_fn(|world| {
            let (lattice, backwards) = order[world];
            Axis::new(lattice, volume.size, backwards, counts[world], nearest)
        });
        let world_from_grid = Transform { linear: linear.as_mat3(), translation: corner.as_vec3() };
        let grid_from_world = DAffine3 { matrix3: linear, translation: corner }.inverse();
        let coordinates_from_grid = DAffine3 { matrix3: coordinates, translation: first };
        let coordinates_from_world = coordinates_from_grid * grid_from_world;
        let georeference = Georeference { coordinates_from_world, crs: String::new() };
        Ok(Self { axes, voxel_size, world_from_grid, georeference, coordinates_from_grid })
    }
}

impl Placement {
    /// For each axis of the lattice the axis of the grid along it.
    fn world_of_lattice(&self) -> [usize; 3] {
        std::array::from_fn(|lattice| self.axes.iter().position(|axis| axis.lattice == lattice).unwrap_or(lattice))
    }

    /// The axes in the order of the lattice.
    fn axes_of_lattice(&self) -> [&Axis; 3] {
        self.world_of_lattice().map(|world| &self.axes[world])
    }
}

/// For each axis of the world the lattice axis nearest to it, and whether that runs backwards.
fn nearest_axes(directions: [DVec3; 3]) -> [(usize, bool); 3] {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let fit = |order: &[usize; 3]| (0..3).map(|world| directions[order[world]][world].abs()).sum::<f64>();
    let mut best = ORDERS[0];
    for order in ORDERS {
        // Ties keep the order of the file.
        if fit(&order) > fit(&best) + 1e-9 {
            best = order;
        }
    }
    std::array::from_fn(|world| (best[world], directions[best[world]][world] < 0.0))
}

/// Makes a scene of one grid of cubic voxels.
///
/// # Errors
/// If the volume is broken, nothing in it is to be seen, or there would be more voxels than the limits allow.
pub fn voxelize(volume: &Volume, options: &VolumeOptions, limits: &Limits) -> Result<Scene, VolumeError> {
    volume.validate().map_err(VolumeError::BadVolume)?;
    voxelize_with_statistics(volume, &volume.statistics(), options, limits)
}

/// As [`voxelize`], where the volume's [`Volume::statistics`] are known already.
///
/// # Errors
/// As [`voxelize`].
pub fn voxelize_with_statistics(
    volume: &Volume,
    values: &ValueStatistics,
    options: &VolumeOptions,
    limits: &Limits,
) -> Result<Scene, VolumeError> {
    volume.validate().map_err(VolumeError::BadVolume)?;
    let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(values));
    transfer.resolve(values, options.threshold);
    let placement = Placement::of(volume, options.scale, limits.voxels, transfer.is_labels())?;
    let lookup = transfer.lookup();
    let layers = Layers::new(volume, &placement, &lookup, &options.overlays)?;
    let shell = options.shell && layers.is_opaque();
    let found: Vec<_> = (0..placement.axes[2].count().div_ceil(8))
        .into_par_iter()
        .map(|layer| slab::bricks(&layers, layer, shell))
        .collect();
    let (bricks, materials) = layers.settled(found)?;
    let grid = VoxelGrid::from_bricks(bricks);
    let count = grid.count();
    if count == 0 {
        let (transfer, shown) = (transfer.name.clone(), transfer.shown());
        return Err(VolumeError::Empty { lowest: values.lowest, highest: values.highest, transfer, shown });
    }
    let mut scene = Scene { materials, ..Scene::new(volume.name.clone()) };
    scene.add_instance(grid, placement.world_from_grid);
    (scene.voxel_size, scene.unit) = (placement.voxel_size, volume.unit);
    scene.georeference = Some(placement.georeference);
    Ok(scene)
}
