//! What is around a scene: a ground without end, and fog. Both are objects of voxels behind those of the scene, so that every tracer has them
//! already, with the same bits, and scenes without them pay nothing (`docs/decisions/0053-surroundings.md`).

use crate::PackedScene;
use crate::packed::{Addition, PackError};
use glam::{IVec3, Mat3, Vec3};
use voxtrace_scene::grid::{VoxelBox, VoxelGrid};
use voxtrace_scene::material::Material;
use voxtrace_scene::transform::Transform;

/// Half the edge of the ground's squares, in voxels of their own.
const HALF: i32 = 128;
/// How much larger the voxels of a square are than those of the one within it.
const STEP: i32 = 8;
/// Half the edge of the hole for the square within: a voxel less than that is wide, so that no ray slips between the two.
const HOLE: i32 = HALF / STEP - 1;
/// Least edge of a voxel of the ground.
const LEAST_EDGE: f32 = 1.0 / 64.0;
/// Squares around the innermost.
const RINGS: i32 = 4;
/// Half the edge of the fog's cube, in diagonals of the scene.
const FOG_REACH: f32 = 4.0;

/// A horizontal plane without end: half a million times as wide as its voxels below the scene, which is beyond what a picture can tell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    /// Height of the plane, world space; `None`: that of the lowest voxel's lower face.
    pub height: Option<f32>,
    /// Diffuse reflectance, linear, each channel in [0, 1].
    pub color: Vec3,
}

/// A medium in the air, in a cube around the scene, eight of its diagonals wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog {
    /// Scattering in a voxel on average, > 0.
    pub density: f32,
    /// Share of the light that goes on where it is scattered, linear, each channel in [0, 1].
    pub color: Vec3,
    /// Mean cosine of the angle by which light is scattered, in (−1, 1), > 0 forwards.
    pub anisotropy: f32,
}

impl PackedScene {
    /// The same scene on a ground, in fog, or both.
    ///
    /// # Errors
    /// [`PackError`] when the scene gets too large.
    pub fn with_surroundings(&self, ground: Option<&Ground>, fog: Option<&Fog>) -> Result<Self, PackError> {
        let bounds = self.bounds().unwrap_or((Vec3::ZERO, Vec3::ONE));
        let mut scene = self.clone();
        if let Some(ground) = ground {
            scene = scene.with_ground(ground, bounds)?;
        }
        if let Some(fog) = fog {
            scene = scene.with_fog(fog, bounds)?;
        }
        Ok(scene)
    }

    /// Index of the ground's material, which nothing else has; `None` where there is no ground.
    #[doc(hidden)]
    pub fn ground_material(&self) -> Option<u32> {
        self.ground.map(u32::from)
    }

    fn with_ground(&self, ground: &Ground, (min, max): (Vec3, Vec3)) -> Result<Self, PackError> {
        let middle = ((min + max) * 0.5).round();
        let height = ground.height.unwrap_or(min.z);
        let reach = (max - min).truncate().max_element().max(1.0);
        // A power of two, so that places in all squares are the same numbers but for their exponents: their voxels meet without gaps. The
        // innermost square is four times as wide as the scene, and its voxels small: rays leave a surface a share of a voxel above it.
        let mut edge = LEAST_EDGE;
        while HALF as f32 * edge < 2.0 * reach {
            edge *= 2.0;
        }
        let material = self.next_material()?;
        let layer = |half: i32| VoxelBox { min: IVec3::new(-half, -half, -1), max: IVec3::new(half, half, 0) };
        let mut square = VoxelGrid::new();
        square.fill_box(layer(HALF), material);
        let mut ring = square.clone();
        ring.clear_box(layer(HOLE));
        let place = |index: i32| {
            let linear = Mat3::from_diagonal(Vec3::splat(edge * STEP.pow(index as u32) as f32));
            (usize::from(index > 0), Transform { linear, translation: middle.with_z(height) })
        };
        let scene = self.with_addition(&Addition {
            name: "ground",
            material: Material::diffuse(ground.color),
            grids: &[square, ring],
            places: &(0..=RINGS).map(place).collect::<Vec<_>>(),
        })?;
        Ok(Self { ground: Some(material), ..scene })
    }

    fn with_fog(&self, fog: &Fog, (min, max): (Vec3, Vec3)) -> Result<Self, PackError> {
        let half = (FOG_REACH * (max - min).length()).max(1.0);
        let mut voxel = VoxelGrid::new();
        voxel.set(IVec3::ZERO, self.next_material()?);
        let edge = 2.0 * half;
        let place = Transform { linear: Mat3::from_diagonal(Vec3::splat(edge)), translation: (min + max) * 0.5 - half };
        self.with_addition(&Addition {
            name: "fog",
            // Media count voxels of their own.
            material: Material::cloud(fog.color, fog.density * edge, fog.anisotropy),
            grids: &[voxel],
            places: &[(0, place)],
        })
    }
}
