//! A scene that begins with nothing: a box whose floor and far walls take the first voxels, with MagicaVoxel's palette.

use crate::editing::{Editing, Spot};
use crate::session::{Command, Session};
use crate::threads;
use std::sync::Arc;
use voxtrace::dynamic::{DynamicScene, Edit, EditError};
use voxtrace::glam::{IVec3, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::import::vox::default_palette;
use voxtrace::ray::FACES;
use voxtrace::sky::Sun;
use voxtrace::{Camera, Material, PackedScene, Ray, Scene, Shape, Sky, Transform, VoxelGrid};

/// What a scene without a file is called.
pub const NAME: &str = "untitled";
/// Most voxels along a side.
pub const LARGEST: u32 = 1024;
/// Voxels along each side, as long as nobody chose them.
pub const USUAL: [u32; 3] = [48; 3];
/// Colours of the palette; the last entry is none.
const COLORS: usize = 255;
/// The material that hands begin with: orange, which is seen before the sky.
const MATERIAL: u16 = 16;
/// How far the camera is from the middle, in diagonals of the box.
const DISTANCE: f32 = 1.35;

/// The scene, in which nothing is yet, and which can be edited.
fn empty() -> Result<DynamicScene, EditError> {
    let colors = default_palette().into_iter().take(COLORS);
    let materials = colors.map(|[red, green, blue, _]| Material::from_srgb([red, green, blue])).collect();
    // A grid without voxels is not packed: one is put there and taken away again.
    let mut grid = VoxelGrid::new();
    grid.set(IVec3::ZERO, 0);
    let mut scene = Scene::from_grid(NAME, grid, materials);
    // Darker than most skies: white voxels are seen before it.
    let background = Sky::gradient(Vec3::splat(0.16), Vec3::new(0.3, 0.36, 0.45));
    scene.sky = background.with_sun(Sun::at(215.0, 50.0, 2.0)).with_sun_disc_visible(false);
    let packed = PackedScene::pack(&scene).expect("one voxel is packed");
    let mut scene = DynamicScene::new(packed)?;
    // Nobody is to take that back.
    scene.set_undo_limit(0);
    let shape = Shape::Box(VoxelBox { min: IVec3::ZERO, max: IVec3::ONE });
    scene.edit(0, &Edit::Fill { shape, material: None })?;
    scene.take_patch();
    Ok(scene)
}

/// A view of all of a box, from above a corner.
fn camera(region: VoxelBox) -> Camera {
    let (low, high) = (region.min.as_vec3(), region.max.as_vec3());
    let middle = low.midpoint(high);
    let eye = middle + Vec3::new(0.55, -0.75, 0.55).normalize() * DISTANCE * low.distance(high);
    Camera::look_at(eye, middle)
}

/// Where a ray leaves a box: the voxel beyond, and the face of it that looks inwards. `None` where it misses the box.
fn wall(region: VoxelBox, ray: &Ray) -> Option<(IVec3, usize, Vec3)> {
    let (low, high) = (region.min.as_vec3(), region.max.as_vec3());
    let (one, other) = ((low - ray.origin) / ray.direction, (high - ray.origin) / ray.direction);
    let (entry, exit) = (one.min(other), one.max(other));
    let axis = exit.min_position();
    let t = exit[axis];
    if !(t.is_finite() && t > entry.max_element().max(0.0)) {
        return None;
    }
    let is_upper = ray.direction[axis] > 0.0;
    let point = ray.at(t);
    let mut voxel = point.floor().as_ivec3().clamp(region.min, region.max - 1);
    voxel[axis] = if is_upper { region.max[axis] } else { region.min[axis] - 1 };
    Some((voxel, 2 * axis + usize::from(!is_upper), point))
}

impl Session {
    /// Shows an empty scene to build in, of so many voxels along each side, and begins to edit it.
    pub fn show_new(&mut self, size: [u32; 3]) {
        // The tracer may hold all other threads.
        let dynamic = match threads::aside(empty) {
            Ok(dynamic) => dynamic,
            Err(error) => return self.say(error.to_string(), true),
        };
        let region =
            VoxelBox { min: IVec3::ZERO, max: IVec3::from_array(size.map(|side| side.clamp(1, LARGEST) as i32)) };
        let mut scene = dynamic.scene().unshared();
        scene.cameras = vec![camera(region)];
        // Nothing of the scene before, or of one on its way, belongs to it.
        (self.loading, self.wanted_timeline, self.moving, self.wants_motion) = (None, None, None, false);
        self.show(NAME.into(), Arc::new(scene));
        let bounds = (region.min.as_vec3(), region.max.as_vec3());
        self.navigator = self.navigator.in_scene(camera(region), Some(bounds));
        if let Some(open) = &mut self.open {
            open.canvas = Some(region);
        }
        self.take_values(None, false);
        self.points = None;
        self.editing = Some(Editing { begun: Some(Box::new(dynamic)), material: MATERIAL, ..Editing::default() });
        self.has_panels = true;
        self.ask(Command::Edit);
    }

    /// Whether the scene was begun in a window, this one or one whose edits were recovered, and no file holds it. Files have whole paths.
    pub(crate) fn is_untitled(&self) -> bool {
        self.open.as_ref().is_some_and(|open| open.source == NAME)
    }

    /// The place on the walls of the box that a ray sees behind everything.
    pub(crate) fn canvas_spot(&self, ray: &Ray) -> Option<Spot> {
        let (voxel, face, point) = wall(self.open.as_ref()?.canvas?, ray)?;
        let (instance, grid, world_from_grid) = (0, 0, Transform::IDENTITY);
        let (face, point) = (FACES[face], point.as_dvec3());
        Some(Spot { instance, grid, world_from_grid, voxel, face, material: 0, point })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use voxtrace::Face;

    #[test]
    fn a_ray_leaves_through_the_floor_or_a_far_wall_and_meets_the_side_that_looks_inwards() {
        let region = VoxelBox { min: IVec3::ZERO, max: IVec3::new(4, 6, 8) };
        let spot = |origin: Vec3, direction: Vec3| {
            wall(region, &Ray::new(origin, direction)).map(|(voxel, face, _)| (voxel, FACES[face]))
        };
        let above = Vec3::new(1.5, 2.5, 20.0);
        assert_eq!(spot(above, Vec3::NEG_Z), Some((IVec3::new(1, 2, -1), Face::PosZ)));
        assert_eq!(spot(Vec3::new(2.5, -9.0, 7.5), Vec3::Y), Some((IVec3::new(2, 6, 7), Face::NegY)));
        assert_eq!(spot(Vec3::new(2.5, 3.5, 4.5), Vec3::X), Some((IVec3::new(4, 3, 4), Face::NegX)), "from inside");
        assert_eq!(spot(above, Vec3::Z), None, "it looks away");
        assert_eq!(spot(Vec3::new(9.0, 2.5, 20.0), Vec3::NEG_Z), None, "it passes by");
    }

    #[test]
    fn the_scene_is_empty_has_the_palette_and_nothing_can_be_taken_back() {
        let scene = empty().unwrap();
        assert_eq!((scene.scene().materials().len(), scene.undo_steps()), (COLORS, (0, 0)));
        assert_eq!(scene.voxel(0, IVec3::ZERO), None);
        assert!(scene.scene().cast(&Ray::new(Vec3::new(0.5, 0.5, 9.0), Vec3::NEG_Z)).is_none());
    }
}
