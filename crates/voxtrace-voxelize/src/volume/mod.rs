//! Volumes: scalar samples on a regular lattice, as scanners and simulations make them. A [`Transfer`] function maps values to
//! colours or to nothing; [`voxelize`] resamples the volume to cubic voxels.

mod automatic;
mod coarse;
mod estimate;
mod labels;
pub mod large;
mod overlay;
mod own_colors;
mod placement;
mod resample;
mod slab;
mod statistics;
mod transfer;

pub use coarse::voxelize_coarse;
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
use placement::Placement;
use rayon::prelude::*;
use std::path::Path;
use voxtrace_scene::Invalid;
use voxtrace_scene::VoxelGrid;
use voxtrace_scene::scene::{Scene, Unit};

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
    /// Nobody waits for it any more: see [`voxelize_while`].
    #[error("the voxels of the volume are not wanted any more")]
    Stopped,
}

impl VolumeError {
    /// The same error as one of importing the file at `path`, which held the volume.
    pub fn into_import_error(self, path: &Path) -> ImportError {
        let kind = match self {
            Self::TooLarge { what, needed, limit } => {
                ImportErrorKind::Limit { what: what.into(), value: needed, limit }
            }
            Self::Stopped => ImportErrorKind::Stopped,
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

    /// How many finite values lie in each of 1024 equal parts from `low` to `high`; what is higher is in the last one.
    pub fn histogram(&self, low: f32, high: f32) -> Vec<u64> {
        statistics::binned(&self.values, low, high)
    }

    /// Statistics of the values.
    pub fn statistics(&self) -> ValueStatistics {
        ValueStatistics::of(self)
    }
}

/// Makes a scene of one grid of cubic voxels. Where the transfer function is chosen by the values, and voxels are so coarse that none of them
/// reaches its threshold, they are shown from a threshold of their own on ([`threshold_of_voxels`]).
///
/// # Errors
/// If the volume is broken, nothing in it is to be seen, or there would be more voxels than the limits allow.
pub fn voxelize(volume: &Volume, options: &VolumeOptions, limits: &Limits) -> Result<Scene, VolumeError> {
    voxelize_while(volume, options, limits, &|| true)
}

/// As [`voxelize`], as long as it is `wanted`, which is asked now and then, on several threads, and which says no for good.
///
/// # Errors
/// As [`voxelize`]; [`VolumeError::Stopped`] once it is not wanted any more.
pub fn voxelize_while(
    volume: &Volume,
    options: &VolumeOptions,
    limits: &Limits,
    wanted: &(dyn Fn() -> bool + Sync),
) -> Result<Scene, VolumeError> {
    volume.validate().map_err(VolumeError::BadVolume)?;
    let values = ValueStatistics::of_while(volume, wanted);
    let scene = voxelize_by(volume, &values, options, limits, wanted);
    if options.transfer.is_none() && options.threshold.is_none() && matches!(scene, Err(VolumeError::Empty { .. })) {
        let threshold = threshold_while(volume, options, limits, wanted)?;
        let options = VolumeOptions { threshold: Some(threshold), ..options.clone() };
        return voxelize_by(volume, &values, &options, limits, wanted);
    }
    scene
}

/// Otsu's threshold of the values that voxels have, each the mean of the samples that it covers. Where voxels are much coarser than what is to
/// be seen, it is below that of the samples.
///
/// # Errors
/// If the volume is broken, or there is no grid for it within the limits.
pub fn threshold_of_voxels(volume: &Volume, options: &VolumeOptions, limits: &Limits) -> Result<f32, VolumeError> {
    threshold_while(volume, options, limits, &|| true)
}

/// As [`threshold_of_voxels`], as long as it is wanted; anything where it is not.
fn threshold_while(
    volume: &Volume,
    options: &VolumeOptions,
    limits: &Limits,
    wanted: &(dyn Fn() -> bool + Sync),
) -> Result<f32, VolumeError> {
    volume.validate().map_err(VolumeError::BadVolume)?;
    let placement = Placement::of(volume, options.scale, limits.voxels, false)?;
    let size = [0, 1, 2].map(|axis| placement.axes[axis].count());
    let values = slab::values(volume, &placement.axes, wanted);
    Ok(ValueStatistics::of_while(&Volume::new(size, values), wanted).threshold)
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
    voxelize_by(volume, values, options, limits, &|| true)
}

fn voxelize_by(
    volume: &Volume,
    values: &ValueStatistics,
    options: &VolumeOptions,
    limits: &Limits,
    wanted: &(dyn Fn() -> bool + Sync),
) -> Result<Scene, VolumeError> {
    // What statistics say that were not wanted any more is no fault of the volume.
    if !wanted() {
        return Err(VolumeError::Stopped);
    }
    volume.validate().map_err(VolumeError::BadVolume)?;
    let mut transfer = options.transfer.clone().unwrap_or_else(|| Transfer::automatic(values));
    transfer.resolve(values, options.threshold);
    let placement = Placement::of(volume, options.scale, limits.voxels, transfer.is_labels())?;
    voxelize_placed(volume, values, options, &transfer, placement, wanted)
}

/// The scene of a volume on a grid, by a transfer function that is resolved.
fn voxelize_placed(
    volume: &Volume,
    values: &ValueStatistics,
    options: &VolumeOptions,
    transfer: &Transfer,
    placement: Placement,
    wanted: &(dyn Fn() -> bool + Sync),
) -> Result<Scene, VolumeError> {
    let lookup = transfer.lookup();
    let layers = Layers::new(volume, &placement, &lookup, &options.overlays)?;
    let shell = options.shell && layers.is_opaque();
    let found: Vec<_> = (0..placement.axes[2].count().div_ceil(8))
        .into_par_iter()
        .map(|layer| slab::bricks(&layers, layer, shell, wanted))
        .collect();
    if !wanted() {
        return Err(VolumeError::Stopped);
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicU32, Ordering};

    #[test]
    fn voxels_are_made_as_long_as_somebody_waits() {
        const SIZE: usize = 40;
        let place = |i: usize| [i % SIZE, i / SIZE % SIZE, i / SIZE / SIZE].map(|at| at as f32 - 19.5);
        let value = |i: usize| 20.25 - place(i).iter().map(|at| at * at).sum::<f32>().sqrt();
        let volume = Volume::new([SIZE; 3], (0..SIZE * SIZE * SIZE).map(value).collect());
        // By a transfer function that is chosen, and from samples that show nothing: by the values of voxels.
        for scale in [None, Some(Scale::VoxelSize(20.0))] {
            let options = VolumeOptions { scale, ..VolumeOptions::default() };
            let asked = AtomicU32::new(0);
            let made = |most: u32| {
                asked.store(0, Ordering::Relaxed);
                let wanted = || asked.fetch_add(1, Ordering::Relaxed) < most;
                voxelize_while(&volume, &options, &Limits::default(), &wanted)
            };
            let whole = made(u32::MAX).unwrap();
            assert!(whole == voxelize(&volume, &options, &Limits::default()).unwrap());
            let times = asked.load(Ordering::Relaxed);
            // For each layer of each layer of bricks.
            assert!(scale.is_some() || times > SIZE as u32, "{times}");
            for most in 0..times {
                let stopped = made(most);
                assert!(matches!(stopped, Err(VolumeError::Stopped)), "{most} of {times}: {stopped:?}");
            }
        }
    }
}
