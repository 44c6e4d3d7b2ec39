//! The editable scene: grids, instances, materials, sky and cameras. Packing turns it into the immutable arrays that every
//! tracer reads.

use crate::animation::Clip;
use crate::camera::Camera;
use crate::georeference::Georeference;
use crate::grid::VoxelGrid;
use crate::material::Material;
use crate::sky::Sky;
use crate::transform::Transform;
use std::ops::Range;
use std::sync::Arc;

pub use crate::length_unit::LengthUnit;

/// A scene. Grids are shared: many instances may show one grid.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Name for people, for example the file's stem.
    pub name: String,
    /// Voxel grids; instances refer to them by index.
    pub grids: Vec<Arc<VoxelGrid>>,
    /// Placed grids.
    pub instances: Vec<Instance>,
    /// Materials; voxels refer to them by index. At most [`crate::material::MAX_MATERIALS`].
    pub materials: Vec<Material>,
    /// Layers that instances may belong to; hiding one hides its instances.
    pub layers: Vec<Layer>,
    /// Groups that instances may belong to.
    pub groups: Vec<Group>,
    /// Sky and sun.
    pub sky: Sky,
    /// Factor on every material's emission.
    pub light_intensity: f32,
    /// Named cameras, the first one is the default.
    pub cameras: Vec<Camera>,
    /// Edge of a voxel of scale 1 in `unit`s, for people and measurements; rays are in voxels.
    pub voxel_size: f64,
    /// Unit of `voxel_size`.
    pub unit: Unit,
    /// Place of the scene in the coordinates of its source (a map, a patient), if known.
    pub georeference: Option<Georeference>,
    /// What the file that it came from says beyond all this, for the format that wrote it. Clear it to write a scene as if
    /// it came from nowhere.
    pub attachments: Vec<Attachment>,
    /// Animations of the file: those of a mesh by their names, and the motion of the one that was asked for. Whoever removes instances clears them.
    pub clips: Vec<Clip>,
}

/// What a format knows and a scene has no place for, kept beside the scene as it is, so that a file that is read and written
/// again is the same file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attachment {
    /// The format, for example `vox`.
    pub format: &'static str,
    /// In a form that the format chooses.
    pub bytes: Arc<[u8]>,
}

/// A grid placed in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Name, empty where there is none.
    pub name: String,
    /// Index into [`Scene::grids`].
    pub grid: usize,
    /// From grid space to world space.
    pub world_from_grid: Transform,
    /// Index into [`Scene::layers`].
    pub layer: Option<usize>,
    /// Index into [`Scene::groups`] of the innermost group that holds it.
    pub group: Option<usize>,
    /// Whether it, or a group that contains it, is hidden.
    pub hidden: bool,
    /// Keyframes of the file's animation; empty for a static instance. Rendering a still shows the first frame.
    pub keyframes: Vec<Keyframe>,
    /// Frames that come again and again: after the last of them the first. `None`: the last keyframe holds for ever.
    pub repeats: Option<Range<u32>>,
}

/// One moment of an instance's animation.
#[derive(Clone, Debug, PartialEq)]
pub struct Keyframe {
    /// Frame number.
    pub frame: u32,
    /// Index into [`Scene::grids`].
    pub grid: usize,
    /// From grid space to world space.
    pub world_from_grid: Transform,
    /// Where it has moved, evenly, when the next keyframe comes, which may leave it elsewhere; turning and scale are those of `world_from_grid`.
    pub end: Transform,
}

/// A named layer.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layer {
    /// Name, empty where there is none.
    pub name: String,
    /// Whether its instances are hidden.
    pub hidden: bool,
    /// Display colour in an editor, sRGB.
    pub color: Option<[u8; 3]>,
}

/// A group of instances, which may be part of another.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Group {
    /// Name, empty where there is none.
    pub name: String,
    /// Index into [`Scene::groups`] of the group around it, which comes before it.
    pub parent: Option<usize>,
}

/// Unit of length of [`Scene::voxel_size`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Unit {
    /// No physical size: a voxel is a voxel.
    #[default]
    Voxel = 0,
    /// Metres.
    Metre = 1,
    /// Millimetres.
    Millimetre = 2,
}

impl Scene {
    /// An empty scene under the study's sky.
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), light_intensity: 1.0, voxel_size: 1.0, ..Self::default() }
    }

    /// A scene of one grid at the origin.
    pub fn from_grid(name: impl Into<String>, grid: VoxelGrid, materials: Vec<Material>) -> Self {
        let mut scene = Self { materials, ..Self::new(name) };
        scene.add_instance(grid, Transform::IDENTITY);
        scene
    }

    /// Adds a grid and one instance of it. Returns the index of the instance.
    pub fn add_instance(&mut self, grid: VoxelGrid, world_from_grid: Transform) -> usize {
        self.grids.push(Arc::new(grid));
        self.instances.push(Instance::new(self.grids.len() - 1, world_from_grid));
        self.instances.len() - 1
    }

    /// Whether an instance is visible: neither it nor its layer is hidden.
    pub fn is_visible(&self, instance: &Instance) -> bool {
        let layer_hidden = instance.layer.and_then(|layer| self.layers.get(layer)).is_some_and(|layer| layer.hidden);
        !instance.hidden && !layer_hidden
    }
}

impl Keyframe {
    /// A moment from which on a grid stands still.
    pub fn still(frame: u32, grid: usize, world_from_grid: Transform) -> Self {
        Self { frame, grid, world_from_grid, end: world_from_grid }
    }
}

impl Instance {
    /// A visible, static instance without name or layer.
    pub fn new(grid: usize, world_from_grid: Transform) -> Self {
        Self {
            name: String::new(),
            grid,
            world_from_grid,
            layer: None,
            group: None,
            hidden: false,
            keyframes: Vec::new(),
            repeats: None,
        }
    }
}
