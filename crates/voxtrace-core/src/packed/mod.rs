//! The packed scene: immutable flat arrays that every tracer reads, on the CPU and on a GPU, and the content of the
//! native file. `docs/format.md` describes every record.
//!
//! A grid is a dense top array of cells over a tree of nodes with 4×4×4 cells over bricks of 8×8×8 voxels. A cell is
//! one word: what it holds, or, where it is empty, how far a ray of each octant may leap.

mod boxes;
mod brick_record;
mod bytes;
mod device_cells;
mod file;
mod instances;
mod leaps;
mod lights;
mod lookup;
mod pack;
mod section;
mod section_writer;
mod settings;
mod statistics;
mod stream;
mod unpack;
mod validate;

pub use device_cells::DeviceCells;
pub use file::{FileError, FileErrorKind, MAGIC};
pub use instances::MAX_INSTANCE_DEPTH;
pub use leaps::LEAPS;
pub use lights::morton_order;
pub(crate) use lookup::cell_in_node;
pub use pack::PackError;
pub use section::Section;
pub use statistics::Statistics;
pub use stream::{BrickSource, StreamError, save_streamed};

use bytemuck::{Pod, Zeroable};
use glam::{IVec3, Vec3};
use voxtrace_scene::camera::Camera;
use voxtrace_scene::georeference::Georeference;
use voxtrace_scene::ray::Hit;
use voxtrace_scene::scene::Unit;
use voxtrace_scene::sky::Sky;
use voxtrace_scene::transform::Transform;

/// Set in a cell word that holds a child; the other bits are then the child's index.
pub const CELL_OCCUPIED: u32 = 1 << 31;

/// The immutable scene that tracers read. Its arrays are always consistent ([`Self::validate`]): only packing and
/// opening a file fill them.
#[derive(Clone, Debug)]
pub struct PackedScene {
    /// Name for people.
    pub name: String,
    /// Cells: the top arrays of all grids, each padded to 64 words, and the nodes of 64 cells.
    pub(crate) cells: Section<u32>,
    /// Brick records: header, position of the materials, masks of the blocks that hold a voxel (two words each).
    pub(crate) bricks: Section<u32>,
    /// Materials of the voxels: for each brick its palette and its packed indices.
    pub(crate) brick_materials: Section<u32>,
    /// Grids.
    pub(crate) grids: Section<PackedGrid>,
    /// Visible instances.
    pub(crate) instances: Section<PackedInstance>,
    /// Bounding volume hierarchy over the instances.
    pub(crate) instance_nodes: Section<InstanceNode>,
    /// Materials.
    pub(crate) materials: Section<PackedMaterial>,
    /// Emissive voxels that light can leave, ordered by instance and [`morton_order`].
    pub(crate) emitters: Section<Emitter>,
    /// Tree over the emitters for importance sampling.
    pub(crate) light_nodes: Section<LightNode>,
    /// Light from outside.
    pub sky: Sky,
    /// Factor on every material's emission.
    pub light_intensity: f32,
    /// Named cameras.
    pub cameras: Vec<Camera>,
    /// Edge of a voxel in `unit`s.
    pub voxel_size: f64,
    /// Unit of `voxel_size`.
    pub unit: Unit,
    /// The coordinates that it was made from, where there are any.
    pub georeference: Option<Georeference>,
}

/// One grid. Its cells cover the voxels from `origin` on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct PackedGrid {
    /// Voxel at the lowest corner of the top array.
    pub origin: IVec3,
    /// log₂ of the voxels along one edge of a top cell: 5, 7, 9, …
    pub top_shift: u32,
    /// Top cells along each axis.
    pub top_size: IVec3,
    /// Index of the first top cell in [`PackedScene::cells`], a multiple of 64.
    pub top_offset: u32,
    /// Lowest occupied voxel in each axis.
    pub min: IVec3,
    /// Voxels stored, low and high word.
    pub voxels: [u32; 2],
    /// One past the highest occupied voxel in each axis.
    pub max: IVec3,
    /// Bits of a palette entry: 8 where the scene has at most 256 materials, else 16.
    pub material_bits: u32,
}

/// One placed grid.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct PackedInstance {
    /// From world to grid space.
    pub grid_from_world: Transform,
    /// From grid to world space.
    pub world_from_grid: Transform,
    /// Index of the grid.
    pub grid: u32,
    /// Index in [`voxtrace_scene::Scene::instances`].
    pub scene_instance: u32,
}

/// A node of the hierarchy over instances: the box around what is below it, world space.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct InstanceNode {
    /// Lowest corner.
    pub min: Vec3,
    /// Inner node: index of the right child, the left one follows the node. Leaf: the instance.
    pub index: u32,
    /// Highest corner.
    pub max: Vec3,
    /// 1 in a leaf, 0 in an inner node.
    pub is_leaf: u32,
}

/// A material as tracers read it. All values as in [`voxtrace_scene::Material`].
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct PackedMaterial {
    /// Diffuse reflectance, linear.
    pub base_color: Vec3,
    /// Roughness.
    pub roughness: f32,
    /// Emitted radiance, linear, before the scene's light intensity.
    pub emission: Vec3,
    /// Metalness.
    pub metallic: f32,
    /// Share of light let through.
    pub transmission: f32,
    /// Index of refraction.
    pub ior: f32,
}

/// Most emitters in a leaf of the tree over them.
pub const LEAF_EMITTERS: usize = 8;

/// An emissive voxel with at least one face that no voxel of its grid covers.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Emitter {
    /// The voxel in its grid.
    pub voxel: IVec3,
    /// Index of the packed instance.
    pub instance: u32,
    /// Bit f is set where [`voxtrace_scene::Face`] f is free.
    pub faces: u32,
    /// Index of the material.
    pub material: u32,
    /// Luminance of the material's emission, > 0.
    pub luminance: f32,
    /// Index of the leaf in [`PackedScene::light_nodes`] that holds it.
    pub leaf: u32,
}

/// A node of the tree over emitters.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct LightNode {
    /// Lowest corner of the emitters' box, world space.
    pub min: Vec3,
    /// Inner node: index of the right child, the left one follows the node. Leaf: the first emitter.
    pub index: u32,
    /// Highest corner.
    pub max: Vec3,
    /// Emitters of a leaf, all of one instance, at most [`LEAF_EMITTERS`]; 0 in an inner node.
    pub count: u32,
    /// Power (luminance × area) that leaves along each direction −x, +x, −y, +y, −z, +z of world space.
    pub power: [f32; 6],
    /// Index of the parent, [`LightNode::NONE`] in the root.
    pub parent: u32,
    /// Always 0: makes the record 64 bytes.
    pub padding: u32,
}

impl LightNode {
    /// The parent of the root.
    pub const NONE: u32 = u32::MAX;
    const EMPTY: Self = Self {
        min: Vec3::INFINITY,
        index: 0,
        max: Vec3::NEG_INFINITY,
        count: 0,
        power: [0.0; 6],
        parent: Self::NONE,
        padding: 0,
    };
}

impl PackedScene {
    /// A scene without anything in it, under a black sky.
    pub fn empty() -> Self {
        Self {
            name: String::new(),
            cells: Section::default(),
            bricks: Section::default(),
            brick_materials: Section::default(),
            grids: Section::default(),
            instances: Section::default(),
            instance_nodes: Section::default(),
            materials: Section::default(),
            emitters: Section::default(),
            light_nodes: Section::default(),
            sky: Sky::black(),
            light_intensity: 1.0,
            cameras: Vec::new(),
            voxel_size: 1.0,
            georeference: None,
            unit: Unit::Voxel,
        }
    }

    /// Replaces the tree over the emitters, to try importances of one's own.
    ///
    /// # Errors
    /// As [`Self::validate`]; the scene is then unchanged.
    pub fn set_light_nodes(&mut self, nodes: Vec<LightNode>) -> Result<(), String> {
        let changed = Self { light_nodes: nodes.into(), ..self.clone() };
        changed.validate()?;
        *self = changed;
        Ok(())
    }

    /// Whether signed 32-bit numbers reach every word of the arrays that walks read.
    #[cfg(target_arch = "x86_64")]
    pub(crate) fn is_within_gather_reach(&self) -> bool {
        self.cells.len() <= i32::MAX as usize && self.bricks.len() <= i32::MAX as usize
    }

    /// The material of the voxel that `hit` met. The hit must be one of this scene and no miss.
    pub fn material(&self, hit: &Hit) -> &PackedMaterial {
        &self.materials[self.material_index(hit) as usize]
    }
}

/// The arrays, for tracers on other devices.
impl PackedScene {
    /// Top arrays of all grids, each padded to 64 words, and nodes of 64 cells.
    pub fn cells(&self) -> &[u32] {
        &self.cells
    }

    /// Brick records: header, position of the materials, masks of the blocks that hold a voxel.
    pub fn bricks(&self) -> &[u32] {
        &self.bricks
    }

    /// For each brick its palette and its packed indices.
    pub fn brick_materials(&self) -> &[u32] {
        &self.brick_materials
    }

    /// Grids.
    pub fn grids(&self) -> &[PackedGrid] {
        &self.grids
    }

    /// Visible instances.
    pub fn instances(&self) -> &[PackedInstance] {
        &self.instances
    }

    /// Bounding volume hierarchy over the instances.
    pub fn instance_nodes(&self) -> &[InstanceNode] {
        &self.instance_nodes
    }

    /// Materials.
    pub fn materials(&self) -> &[PackedMaterial] {
        &self.materials
    }

    /// Emissive voxels that light can leave.
    pub fn emitters(&self) -> &[Emitter] {
        &self.emitters
    }

    /// Tree over the emitters.
    pub fn light_nodes(&self) -> &[LightNode] {
        &self.light_nodes
    }
}
