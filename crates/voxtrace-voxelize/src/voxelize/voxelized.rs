//! The last step of voxelizing: when all tiles are done, their bricks and the palette become a scene or a native file.

use super::appearance::AppearanceKey;
use super::palette::Palette;
use super::spill::SpillBuffer;
use super::{Placement, VoxelizeError, VoxelizeProgress, Written};
use glam::{IVec3, Vec3};
use std::io;
use std::path::Path;
use voxtrace_core::packed::{BrickSource, save_streamed};
use voxtrace_scene::brick::Brick;
use voxtrace_scene::grid::VoxelGrid;
use voxtrace_scene::material::Material;
use voxtrace_scene::scene::{LengthUnit, Scene};
use voxtrace_scene::sky::{Sky, Sun};
use voxtrace_scene::transform::Transform;

/// The result of voxelizing all tiles, beside the bricks in the spill buffer.
pub(super) struct Voxelized {
    pub placement: Placement,
    pub palette: Palette,
}

/// A scene without a grid, whose voxel is as large as the unit of what it is made of.
pub(super) fn scene_of_source(name: &str, unit: LengthUnit) -> Scene {
    Scene { voxel_size: unit.in_scene(), unit: unit.of_scene(), ..Scene::new(name) }
}

/// The grid of all bricks in a spill buffer.
pub(super) fn grid_of(palette: &Palette, spill: &mut SpillBuffer) -> Result<VoxelGrid, VoxelizeError> {
    let mut bricks = Vec::with_capacity(spill.brick_count());
    let collect = |piece: Vec<(IVec3, Brick)>| {
        bricks.extend(piece);
        Ok(())
    };
    spill.for_each_piece(&|key, voxel| palette.index(key, voxel), |piece| piece, collect)?;
    Ok(VoxelGrid::from_bricks(bricks))
}

impl Voxelized {
    /// The scene of all bricks in the spill buffer.
    pub fn into_scene(self, name: &str, unit: LengthUnit, mut spill: SpillBuffer) -> Result<Scene, VoxelizeError> {
        let grid = grid_of(&self.palette, &mut spill)?;
        let mut scene = Scene::from_grid(name, grid, self.palette.materials);
        (scene.voxel_size, scene.unit) = (self.placement.voxel_size * unit.in_scene(), unit.of_scene());
        scene.sky = sky_of(&scene.materials);
        Ok(scene)
    }

    /// Writes a native file of `scene`, which is of [`scene_of_source`], with all bricks of the spill buffer.
    pub fn write(
        self,
        mut scene: Scene,
        spill: &mut SpillBuffer,
        path: &Path,
        progress: &VoxelizeProgress,
    ) -> Result<Written, VoxelizeError> {
        scene.materials = self.palette.materials.clone();
        scene.voxel_size *= self.placement.voxel_size;
        scene.sky = sky_of(&scene.materials);
        let (voxels, materials) = (spill.voxels(), scene.materials.len());
        let written = Written { voxels, materials, is_exact: self.palette.is_exact };
        let palette = self.palette;
        let material = |key, voxel| palette.index(key, voxel);
        let bricks = SpilledBricks { spill, material, world_from_grid: Transform::IDENTITY, progress };
        bricks.save(path, &scene).map(|()| written)
    }
}

/// Least of each channel of a colour that is pale, linear, and most that channels differ.
const PALE: (f32, f32) = (0.35, 0.1);

/// The light of what is voxelized: the usual sky, but where all is white and grey, as a mesh without textures is, that would vanish before it:
/// then one of a darker grey, with a soft sun beside the camera that shows everything.
pub(super) fn sky_of(materials: &[Material]) -> Sky {
    let is_pale = |material: &Material| {
        let color = material.base_color;
        color.min_element() >= PALE.0
            && color.max_element() - color.min_element() <= PALE.1
            && !material.is_emissive()
            && !material.is_transmissive()
    };
    if !materials.iter().all(is_pale) {
        return Sky::default();
    }
    let gradient = Sky::gradient(Vec3::splat(0.16), Vec3::new(0.40, 0.46, 0.55));
    gradient.with_sun(Sun::at(205.0, 50.0, 2.2)).with_sun_disc_visible(false)
}

/// The bricks of a spill buffer, with the materials that `material` chooses by appearance and voxel, and where their grid stands.
pub(crate) struct SpilledBricks<'a, M> {
    pub spill: &'a mut SpillBuffer,
    pub material: M,
    pub world_from_grid: Transform,
    pub progress: &'a VoxelizeProgress,
}

impl<M: Fn(AppearanceKey, IVec3) -> u16 + Sync> SpilledBricks<'_, M> {
    /// Writes them with all else of a scene into a native file.
    pub fn save(mut self, path: &Path, scene: &Scene) -> Result<(), VoxelizeError> {
        match save_streamed(path, scene, &mut self) {
            Err(_) if self.progress.is_cancelled() => Err(VoxelizeError::Cancelled),
            saved => Ok(saved?),
        }
    }
}

impl<M: Fn(AppearanceKey, IVec3) -> u16 + Sync> BrickSource for SpilledBricks<'_, M> {
    fn coordinates(&self) -> Vec<IVec3> {
        self.spill.coordinates().collect()
    }

    fn sort_by_key(&mut self, key: &(dyn Fn(IVec3) -> u64 + Sync)) {
        self.spill.sort_by_key(key);
    }

    fn for_each_piece<T: Send>(
        &mut self,
        make: impl Fn(Vec<(IVec3, Brick)>) -> T + Sync,
        mut each: impl FnMut(T) -> io::Result<()>,
    ) -> io::Result<()> {
        let progress = self.progress;
        self.spill.for_each_piece(&self.material, make, |made| {
            if progress.is_cancelled() { Err(io::ErrorKind::Interrupted.into()) } else { each(made) }
        })
    }

    fn world_from_grid(&self) -> Transform {
        self.world_from_grid
    }
}
