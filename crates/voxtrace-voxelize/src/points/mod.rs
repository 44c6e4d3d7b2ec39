//! Clouds of points, as importers make them and the voxelizer takes them: positions with an offset in f64, and the attributes
//! measured at each point. Space is right-handed, z up.

mod color;
mod density;
pub mod source;

pub use color::ColorBy;
pub use color::{Attributes, ColorMap, ValueHistogram};
pub use density::Density;

use crate::mesh::{Mesh, UpAxis};
use glam::{DAffine3, DMat3, DVec3, Vec3};
use rayon::prelude::*;
use voxtrace_scene::Invalid;
use voxtrace_scene::scene::LengthUnit;

/// Points processed by one task.
const TASK: usize = 1 << 16;

/// Points with their attributes. Arrays other than `positions` are empty or as long as it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointCloud {
    /// Name for people, for example the file's stem.
    pub name: String,
    /// Added to every position: large coordinates stay exact.
    pub offset: DVec3,
    /// Positions, without the offset.
    pub positions: Vec<Vec3>,
    /// Colours, sRGB.
    pub colors: Vec<[u8; 3]>,
    /// Return intensities, in no unit.
    pub intensities: Vec<u16>,
    /// ASPRS classes of the points: 2 ground, 5 high vegetation, 6 building, 9 water.
    pub classes: Vec<u8>,
    /// Unit of the positions.
    pub unit: LengthUnit,
    /// Their reference system as the file says it: WKT, `EPSG:` and a number, or words; empty where it says none.
    pub crs: String,
    /// From the positions, with the offset, to coordinates of that system, where the reader had to change them: degrees, or heights in another unit.
    pub crs_from_cloud: DAffine3,
    /// What the reader left out or put up with, one sentence each, for people.
    pub notes: Vec<String>,
}

impl PointCloud {
    /// The corners of a mesh that has no faces.
    pub fn from_corners(mesh: Mesh) -> Self {
        let srgb = |linear: &glam::Vec4| linear.truncate().to_array().map(voxtrace_scene::material::srgb_from_linear);
        Self {
            name: mesh.name,
            offset: mesh.offset,
            colors: mesh.colors.iter().map(srgb).collect(),
            positions: mesh.positions,
            unit: mesh.unit,
            notes: mesh.notes,
            ..Self::default()
        }
    }

    /// The box around all points, offset included; `None` where there are none.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        bounds(&self.positions).map(|(min, max)| (min + self.offset, max + self.offset))
    }

    /// Turns the cloud so that what was along `up` points along +z.
    pub fn make_z_up(&mut self, up: UpAxis) {
        self.positions.iter_mut().for_each(|position| *position = up.to_z_up(*position));
        self.offset = DVec3::from_array(up.to_z_up_array(self.offset.to_array()));
        // The axes of the coordinates are turned with those of the cloud. The inverse of a turn is its transpose.
        let turn = DMat3::from_cols(up.to_z_up_f64(DVec3::X), up.to_z_up_f64(DVec3::Y), up.to_z_up_f64(DVec3::Z));
        self.crs_from_cloud = DAffine3::from_mat3(turn) * self.crs_from_cloud * DAffine3::from_mat3(turn.transpose());
    }

    /// The finest resolution on which surfaces through the points stay closed, in voxels along the longest side: 16 to 2048.
    pub fn suited_resolution(&self) -> u32 {
        density::suited_resolution(self)
    }

    /// Bytes that the arrays take.
    pub fn size_bytes(&self) -> u64 {
        let arrays = size_of_val(&*self.positions)
            + size_of_val(&*self.colors)
            + size_of_val(&*self.intensities)
            + size_of_val(&*self.classes);
        arrays as u64
    }

    /// Checks that the arrays have consistent lengths and every position is finite.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), Invalid> {
        let count = self.positions.len();
        if [self.colors.len(), self.intensities.len(), self.classes.len()].iter().any(|&n| n != 0 && n != count) {
            return Err("colours, intensities or classes are not one for each point".into());
        }
        if !self.offset.is_finite() {
            return Err("the offset is not finite".into());
        }
        // Finite is an exponent that is not all ones; bits are checked faster than floats.
        let is_finite = |value: f32| value.to_bits() << 1 < f32::INFINITY.to_bits() << 1;
        let is_good = |part: &[Vec3]| flat(part).iter().fold(true, |good, &value| good & is_finite(value));
        if self.positions.par_chunks(TASK).all(is_good) {
            return Ok(());
        }
        let at = self.positions.iter().position(|position| !position.is_finite());
        Err(format!("point {} is not finite", at.unwrap_or_default()).into())
    }
}

/// The coordinates as a flat slice.
fn flat(positions: &[Vec3]) -> &[f32] {
    bytemuck::cast_slice(positions)
}

/// The box around positions; `None` where there are none.
fn bounds(positions: &[Vec3]) -> Option<(DVec3, DVec3)> {
    /// Coordinates compared in parallel lanes: a multiple of three.
    const LANES: usize = 48;
    type Ends = ([f32; LANES], [f32; LANES]);
    let start = || ([f32::INFINITY; LANES], [f32::NEG_INFINITY; LANES]);
    let add = |(mut min, mut max): Ends, values: &[f32]| {
        for (lane, &value) in values.iter().enumerate() {
            min[lane] = if value < min[lane] { value } else { min[lane] };
            max[lane] = if value > max[lane] { value } else { max[lane] };
        }
        (min, max)
    };
    let of_part = |part: &[Vec3]| {
        let (whole, rest) = flat(part).as_chunks::<LANES>();
        add(whole.iter().fold(start(), |ends, values| add(ends, values)), rest)
    };
    let (min, max) = positions.par_chunks(TASK).map(of_part).reduce(start, |a, b| {
        let (min, _) = add(a, &b.0);
        (min, add(a, &b.1).1)
    });
    let end = |lanes: &[f32; LANES], choose: fn(f32, f32) -> f32| {
        let axis = |axis: usize| lanes[axis..].iter().step_by(3).copied().fold(lanes[axis], choose);
        Vec3::new(axis(0), axis(1), axis(2)).as_dvec3()
    };
    let (min, max) = (end(&min, f32::min), end(&max, f32::max));
    (min.x <= max.x).then_some((min, max))
}
