//! Scenes as meshes: the faces that nothing covers, merged greedily to rectangles. Instances may stand and be turned as they like. The
//! meshes are upright as their readers take them, in the scene's unit.

mod glb;
mod gltf_material;
mod obj;
mod ply;
mod vertices;

pub use glb::write as write_glb;
pub use obj::{companions as obj_companions, write as write_obj};
pub use ply::write as write_ply;

use super::{ExportError, Wanted};
use glam::{DVec3, IVec3};
use rayon::prelude::*;
use std::io::{self, Write};
use voxtrace_scene::faces::{FaceRectangle, face_rectangles_while};
use voxtrace_scene::scene::{Instance, Scene};

/// The surfaces of a scene.
struct Surfaces<'s> {
    scene: &'s Scene,
    /// The rectangles of each grid; none of grids that are not seen.
    rectangles: Vec<Vec<FaceRectangle>>,
}

impl<'s> Surfaces<'s> {
    fn of(scene: &'s Scene, wanted: Wanted) -> Result<Self, ExportError> {
        let is_seen = |grid: usize| scene.instances.iter().any(|one| one.grid == grid && scene.is_visible(one));
        let of_grid = |(index, grid)| match is_seen(index) {
            true => face_rectangles_while(grid, &scene.materials, wanted),
            false => Some(Vec::new()),
        };
        let grids: Vec<_> = scene.grids.iter().map(|grid| &**grid).enumerate().collect();
        let rectangles: Option<_> = grids.into_par_iter().map(of_grid).collect();
        Ok(Self { scene, rectangles: rectangles.ok_or(ExportError::Stopped)? })
    }

    /// The visible instances that have a surface, with it.
    fn instances(&self) -> impl Iterator<Item = (&'s Instance, &[FaceRectangle])> {
        let visible = self.scene.instances.iter().filter(|instance| self.scene.is_visible(instance));
        let all = visible.map(|instance| (instance, self.rectangles[instance.grid].as_slice()));
        all.filter(|(_, rectangles)| !rectangles.is_empty())
    }

    /// The corners of a rectangle in its grid; counter-clockwise from outside also where the instance is mirrored.
    fn corners(instance: &Instance, rectangle: &FaceRectangle) -> [IVec3; 4] {
        let mut corners = rectangle.corners();
        let is_mirrored = instance.world_from_grid.linear.as_dmat3().determinant() < 0.0;
        if is_mirrored {
            corners.swap(1, 3);
        }
        corners
    }

    /// Where a corner stands in the world, in voxels.
    fn place(instance: &Instance, corner: IVec3) -> DVec3 {
        let placed = &instance.world_from_grid;
        placed.linear.as_dmat3() * corner.as_dvec3() + placed.translation.as_dvec3()
    }
}

/// Writes each of these, many at a time.
fn write_each<T: Sync>(
    file: &mut impl Write,
    all: &[T],
    write: impl Fn(&mut Vec<u8>, &T) -> io::Result<()> + Sync,
) -> io::Result<()> {
    // A brick may be 512 lines of text: at worst a few hundred megabytes at once, in parts so small that all cores have some.
    for some in all.chunks(1 << 14) {
        let of_part = |part: &[T]| {
            let mut bytes = Vec::new();
            part.iter().try_for_each(|one| write(&mut bytes, one)).map(|()| bytes)
        };
        let parts: Vec<_> = some.par_chunks(1 << 8).map(of_part).collect();
        for bytes in parts {
            file.write_all(&bytes?)?;
        }
    }
    Ok(())
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
