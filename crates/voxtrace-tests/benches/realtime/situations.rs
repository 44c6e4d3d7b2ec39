//! What happens while real-time light is measured: a row of frames each.

use super::Outcome;
use glam::{IVec3, Quat, Vec2, Vec3};
use std::fmt::{self, Display};
use std::sync::Arc;
use voxtrace::camera::Projection;
use voxtrace::transform::Transform;
use voxtrace::{
    Camera, DynamicScene, Edit, Frame, Instance, Material, PackedScene, Patch, Placement, Scene, Shape, VoxelGrid,
};
use voxtrace_core::packed::PackedInstance;
use voxtrace_core::walk;

/// Frames in which what was there settles before something happens.
const SETTLING: u32 = 64;
/// Frames of the camera's way.
const WAY: u32 = 120;
/// Of the frames of a way or of what moves, one of so many is compared.
const STRIDE: u32 = 10;
/// Samples of the pictures that single frames are compared with.
const MANY: u32 = 4096;
/// Samples of those of ways, of which there are many.
const FEWER: u32 = 1024;
/// Radius of the edit, voxels.
const RADIUS: f64 = 8.0;
/// Instances that move.
const MOVING: usize = 64;
/// Their radius, voxels.
const BALL: f32 = 4.0;

/// What happens.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Situation {
    /// The first frames of a view
    Cut,
    /// A camera that goes forward, around what it sees, and to the side
    Way,
    /// A ball of voxels appears
    Edit,
    /// The lamps give a tenth of their light, or the sun
    Dimmed,
    /// 64 instances move
    Moving,
}

/// One frame.
#[derive(Clone)]
pub struct Step {
    pub scene: Arc<PackedScene>,
    pub frame: Frame,
    /// Samples of the picture that it is compared with, 0 for none.
    pub samples: u32,
    pub label: String,
    /// Whether light may have changed since the frame before.
    pub is_changed: bool,
    /// What of the voxels changed.
    pub patch: Option<Arc<Patch>>,
    /// Where instances stood at the frame before, where they moved.
    pub moved_from: Option<Vec<PackedInstance>>,
}

impl Situation {
    pub const ALL: [Self; 5] = [Self::Cut, Self::Way, Self::Edit, Self::Dimmed, Self::Moving];

    /// Whether each compared frame has a line of its own.
    pub fn has_each_step(self) -> bool {
        matches!(self, Self::Cut | Self::Edit | Self::Dimmed)
    }

    /// Whether the camera and all things stand still.
    pub fn is_still(self) -> bool {
        self == Self::Cut
    }

    /// The frames; `None` where the scene has nothing of the kind.
    pub fn steps(self, scene: PackedScene, frame: &Frame) -> Outcome<Option<Vec<Step>>> {
        let scene = Arc::new(scene);
        let still = |scene: &Arc<PackedScene>, number: u32, samples: u32| Step {
            scene: Arc::clone(scene),
            frame: frame.clone(),
            samples,
            label: number.to_string(),
            is_changed: false,
            patch: None,
            moved_from: None,
        };
        // Frames 1, 4, 16, 64 are compared.
        let samples = |number: u32| if number.is_power_of_two() && number.ilog2().is_multiple_of(2) { MANY } else { 0 };
        let after = |first: &Arc<PackedScene>, changed: PackedScene, patch: Option<Patch>| {
            let (changed, patch) = (Arc::new(changed), patch.map(Arc::new));
            let settling = |number| Step { label: "before".into(), ..still(first, number, 0) };
            let before = (1..=SETTLING).map(settling);
            let after = (1..=64).map(|number| {
                let is_changed = number == 1;
                let patch = patch.clone().filter(|_| is_changed);
                Step { is_changed, patch, ..still(&changed, number, samples(number)) }
            });
            before.chain(after).collect()
        };
        Ok(match self {
            Self::Cut => Some((1..=64).map(|number| still(&scene, number, samples(number))).collect()),
            Self::Way => {
                let step = |number: u32| {
                    let compared = number > 0 && number.is_multiple_of(STRIDE);
                    let mut frame = frame.clone();
                    frame.camera = on_the_way(&frame.camera, number, size_of(&scene));
                    Step { frame, ..still(&scene, number, if compared { FEWER } else { 0 }) }
                };
                Some((0..=WAY).map(step).collect())
            }
            Self::Edit => {
                let scene = Arc::new(scene.split());
                edited(&scene, frame)?.map(|(changed, patch)| after(&scene, changed, Some(patch)))
            }
            Self::Dimmed => Some(after(&scene, dimmed(&scene), None)),
            Self::Moving => Some(moving(&scene, frame)?),
        })
    }
}

impl Display for Situation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Cut => "cut",
            Self::Way => "way",
            Self::Edit => "edit",
            Self::Dimmed => "dimmed",
            Self::Moving => "moving",
        })
    }
}

/// How far the scene's view reaches, world units: from the camera to what it looks at, at most half of the scene.
pub fn size_of(scene: &PackedScene) -> f32 {
    scene.bounds().map_or(1.0, |(low, high)| 0.5 * (high - low).max_element())
}

/// A camera that goes forward for a third of the way, then around what it looks at, then to the side: about one pixel of 240 a frame and more.
pub fn on_the_way(camera: &Camera, number: u32, size: f32) -> Camera {
    let third = WAY / 3;
    let part = |from: u32| number.saturating_sub(from).min(third) as f32 / third as f32;
    let reach = (camera.target - camera.eye).length().min(size);
    let forward = (camera.target - camera.eye).normalize() * (0.1 * reach * part(0));
    let turn = Quat::from_rotation_z(0.08 * part(third));
    let eye = camera.target + turn * (camera.eye + forward - camera.target);
    let aside = camera.axes().right * (0.03 * reach * part(2 * third));
    Camera { eye: eye + aside, target: camera.target + aside, ..camera.clone() }
}

/// The scene with a ball of what is seen in the middle of the picture, a little before it.
fn edited(scene: &PackedScene, frame: &Frame) -> Outcome<Option<(PackedScene, Patch)>> {
    let middle = Vec2::new(0.5 * frame.width as f32, 0.65 * frame.height as f32);
    let ray = frame.camera.frame(frame.width, frame.height).ray(middle, Vec2::splat(0.5));
    let hit = walk::cast(scene, &ray);
    if hit.is_miss() {
        return Ok(None);
    }
    let grid = scene.instances()[hit.instance as usize].grid;
    let material = scene.geometry().material_at(&scene.grids()[grid as usize], hit.voxel).unwrap_or(0);
    let Ok(mut dynamic) = DynamicScene::new(scene.clone()) else { return Ok(None) };
    let centre = hit.voxel + hit.face().normal() * (RADIUS as i32 - 2);
    let edit = Edit::Fill {
        shape: Shape::Sphere { center: centre.as_dvec3(), radius: RADIUS },
        material: Some(material as u16),
    };
    dynamic.edit(grid, &edit)?;
    let patch = dynamic.take_patch();
    Ok(Some((dynamic.scene().clone(), patch)))
}

/// The scene with a tenth of the light that its lamps give; without lamps, of its sky and sun.
fn dimmed(scene: &PackedScene) -> PackedScene {
    let mut dimmed = scene.clone();
    dimmed.light_intensity *= 0.1;
    dimmed
}

/// Adds the balls that move to a scene.
pub fn add_moving(scene: &mut Scene) -> Outcome<()> {
    add_balls(scene, &[Material { base_color: Vec3::new(0.7, 0.5, 0.3), ..Material::default() }])
}

/// Adds 64 balls to a scene, instances of one grid for each of `materials`, before the middle of what its first camera sees.
pub fn add_balls(scene: &mut Scene, materials: &[Material]) -> Outcome<()> {
    let camera = scene.cameras.first().ok_or("a scene without a camera")?.clone();
    let first = scene.grids.len();
    for material in materials {
        let index = u16::try_from(scene.materials.len())?;
        scene.materials.push(*material);
        scene.grids.push(ball(index).into());
    }
    let axes = camera.axes();
    let distance = 0.5 * (camera.target - camera.eye).length();
    let step = distance * (0.5 * camera.fov_y).to_radians().tan() * 2.0 / 10.0;
    // As large as they look from anywhere: a third of what lies between them.
    let size = step / (3.0 * BALL);
    for number in 0..MOVING {
        let (column, row) = ((number % 8) as f32 - 3.5, (number / 8) as f32 - 3.5);
        let place = camera.eye + axes.forward * distance + (axes.right * column * 1.5 + axes.up * row) * step;
        let transform = Transform::IDENTITY.scaled(size).translated(place);
        scene.instances.push(Instance::new(first + number % materials.len(), transform));
    }
    Ok(())
}

/// A ball of voxels of a material.
fn ball(material: u16) -> VoxelGrid {
    let mut ball = VoxelGrid::default();
    let reach = BALL as i32;
    for (x, (y, z)) in
        (-reach..=reach).flat_map(|x| (-reach..=reach).flat_map(move |y| (-reach..=reach).map(move |z| (x, (y, z)))))
    {
        let voxel = IVec3::new(x, y, z);
        if voxel.length_squared() <= reach * reach {
            ball.set(voxel, material);
        }
    }
    ball
}

/// Frames in which the last 64 instances go in circles.
fn moving(scene: &Arc<PackedScene>, frame: &Frame) -> Outcome<Vec<Step>> {
    let instances = scene.instances();
    let first = instances.len().checked_sub(MOVING).ok_or("a scene without balls")?;
    let size = instances[first].world_from_grid.direction(Vec3::X).length() * BALL;
    let axes = frame.camera.axes();
    let at = |number: u32| -> Outcome<Arc<PackedScene>> {
        let mut placed = instances.to_vec();
        for (which, placed) in placed.iter_mut().skip(first).enumerate() {
            let angle = number as f32 * 0.05 + which as f32;
            let by = (axes.right * angle.cos() + axes.up * angle.sin()) * size;
            let world_from_grid: Transform = placed.world_from_grid.translated(by);
            *placed = PackedInstance::new(placed.grid, world_from_grid, placed.scene_instance);
        }
        let placement = Placement::new(scene.geometry(), placed)?;
        Ok(Arc::new(scene.with_placement(&placement)?))
    };
    let mut steps = Vec::new();
    let mut before: Option<Arc<PackedScene>> = None;
    for number in 0..=60 {
        let scene = at(number)?;
        steps.push(Step {
            frame: frame.clone(),
            samples: if number > 0 && number.is_multiple_of(STRIDE) { FEWER } else { 0 },
            label: number.to_string(),
            is_changed: false,
            patch: None,
            moved_from: before.as_ref().map(|before| before.instances().to_vec()),
            scene: Arc::clone(&scene),
        });
        before = Some(scene);
    }
    Ok(steps)
}
