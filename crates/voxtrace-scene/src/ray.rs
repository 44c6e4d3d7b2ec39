//! Rays and hits: the contract between every tracer. A hit is the first occupied voxel that the ray's segment
//! [t_min, t_max] passes through.

use bytemuck::{Pod, Zeroable};
use glam::{IVec3, Vec3};

/// A ray segment: the points `origin + t * direction`, `t_min ≤ t ≤ t_max`.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Ray {
    /// Start of the parametrization.
    pub origin: Vec3,
    /// Smallest t, ≥ 0.
    pub t_min: f32,
    /// Direction; t counts in multiples of its length.
    pub direction: Vec3,
    /// Largest t.
    pub t_max: f32,
}

impl Ray {
    /// The ray from `origin` to infinity.
    #[inline]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, t_min: 0.0, direction, t_max: f32::INFINITY }
    }

    /// The point at `t`.
    #[inline]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + self.direction * t
    }
}

/// A face of a voxel, by its outward normal in grid space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Face {
    /// Towards −x.
    NegX = 0,
    /// Towards +x.
    PosX = 1,
    /// Towards −y.
    NegY = 2,
    /// Towards +y.
    PosY = 3,
    /// Towards −z.
    NegZ = 4,
    /// Towards +z.
    PosZ = 5,
}

/// All faces, in the order of their numbers.
pub const FACES: [Face; 6] = [Face::NegX, Face::PosX, Face::NegY, Face::PosY, Face::NegZ, Face::PosZ];

impl Face {
    /// Axis at right angles to the face: 0, 1 or 2.
    #[inline]
    pub fn axis(self) -> usize {
        self as usize / 2
    }

    /// The outward unit normal in grid space.
    #[inline]
    pub fn normal(self) -> IVec3 {
        let mut normal = IVec3::ZERO;
        normal[self.axis()] = if self as u32 & 1 == 1 { 1 } else { -1 };
        normal
    }
}

/// The hit of a ray. `instance == Hit::NONE` marks a miss; then the other members are those of [`Hit::MISS`].
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Hit {
    /// Where the ray enters the voxel, or `t_min` where the segment begins inside it.
    pub t: f32,
    /// Index of the instance in the packed scene.
    pub instance: u32,
    /// The voxel, in the coordinates of the instance's grid.
    pub voxel: IVec3,
    /// Number of the [`Face`] through which the ray's line enters the voxel. From [`Self::FIRST_CUT`] on the face of a cut: twice the number
    /// of its plane, + 1 where the ray leaves what is kept there.
    pub face: u32,
}

impl Hit {
    /// The instance of a miss.
    pub const NONE: u32 = u32::MAX;
    /// The hit of a ray that meets nothing.
    pub const MISS: Self = Self { t: f32::INFINITY, instance: Self::NONE, voxel: IVec3::ZERO, face: 0 };

    /// Number of the first face of a cut.
    pub const FIRST_CUT: u32 = 6;

    /// The hit, or `None` for a miss.
    pub fn found(self) -> Option<Self> {
        (!self.is_miss()).then_some(self)
    }

    /// Whether the ray met nothing.
    #[inline]
    pub fn is_miss(&self) -> bool {
        self.instance == Self::NONE
    }

    /// Index of the plane whose cut through the voxel the ray met, `None` on a face of the voxel.
    #[inline]
    pub fn cut(&self) -> Option<usize> {
        self.face.checked_sub(Self::FIRST_CUT).map(|face| face as usize / 2)
    }

    /// Whether the ray left what a cut keeps, and with it a medium.
    #[inline]
    pub fn leaves_cut(&self) -> bool {
        self.face >= Self::FIRST_CUT && self.face & 1 == 1
    }

    /// The face of the voxel through which the ray entered. Without meaning on the face of a cut.
    #[inline]
    pub fn face(&self) -> Face {
        FACES[self.face as usize % 6]
    }
}
