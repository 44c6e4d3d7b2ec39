//! Scenes as meshes: the faces that nothing covers, merged greedily to rectangles. Instances may stand and be turned as they like. The
//! meshes are upright as their readers take them, in the scene's unit.

mod glb;
mod gltf_material;
mod obj;
mod ply;

pub use glb::write as write_glb;
pub use obj::{companions as obj_companions, write as write_obj};
pub use ply::write as write_ply;

use glam::{DVec3, IVec3};
use rayon::prelude::*;
use voxtrace_scene::faces::{FaceRectangle, face_rectangles};
use voxtrace_scene::scene::{Instance, Scene};

/// The surfaces of a scene.
struct Surfaces<'s> {
    scene: &'s Scene,
    /// The rectangles of each grid; none of grids that are not seen.
    rectangles: Vec<Vec<FaceRectangle>>,
}

impl<'s> Surfaces<'s> {
    fn of(scene: &'s Scene) -> Self {
        let is_seen = |grid: usize| scene.instances.iter().any(|one| one.grid == grid && scene.is_visible(one));
        let of_grid = |(index, grid)| match is_seen(index) {
            true => face_rectangles(grid, &scene.materials),
            false => Vec::new(),
        };
        let grids: Vec<_> = scene.grids.iter().map(|grid| &**grid).enumerate().collect();
        Self { scene, rectangles: grids.into_par_iter().map(of_grid).collect() }
    }

    /// The visible instances that have a surface, with it.
    fn instances(&self) -> impl Iterator<Item = (&'s Instance, &[FaceRectangle])> {
        let visible = self.scene.instances.iter().filter(|instance| self.scene.is_visible(instance));
        let all = visible.map(|instance| (instance, self.rectangles[instance.grid].as_slice()));
        all.filter(|(_, rectangles)| !rectangles.is_empty())
    }

    /// The corners of a rectangle, in the grid and in the world, in voxels; counter-clockwise from outside also where the instance is mirrored.
    fn corners(instance: &Instance, rectangle: &FaceRectangle) -> [(IVec3, DVec3); 4] {
        let placed = &instance.world_from_grid;
        let (linear, translation) = (placed.linear.as_dmat3(), placed.translation.as_dvec3());
        let mut corners = rectangle.corners().map(|corner| (corner, linear * corner.as_dvec3() + translation));
        let is_mirrored = linear.determinant() < 0.0;
        if is_mirrored {
            corners.swap(1, 3);
        }
        corners
    }
}

/// What of a scene no mesh holds, one phrase each.
fn left_out(scene: &Scene) -> Vec<String> {
    let instances = || scene.instances.iter();
    let counts = [
        ("hidden instances", instances().filter(|instance| !scene.is_visible(instance)).count()),
        ("movement of instances", instances().filter(|instance| instance.keyframes.len() > 1).count()),
        ("cameras", scene.cameras.len()),
    ];
    let counted = counts.into_iter().filter(|&(_, count)| count > 0).map(|(what, count)| format!("{what} ({count})"));
    counted.chain(scene.georeference.as_ref().map(|_| "the place on the map".into())).collect()
}

#[cfg(test)]
mod tests;
