//! The packed scene: immutable flat arrays that every tracer reads, on the CPU and on a GPU, and the content of the
//! native file. `docs/format.md` describes every record.
//!
//! It has two parts: the [`Geometry`], shared and large, and the [`Placement`], which is made anew whenever something
//! moves (`docs/decisions/0034-geometry-and-placement.md`).
//!
//! A grid is a dense top array of cells over a tree of nodes with 4×4×4 cells over bricks of 8×8×8 voxels. A cell is
//! one word: what it holds, or, where it is empty, how many cells a ray of each octant may skip.
//!
//! The arrays are hidden from the documentation: other crates of voxtrace read them; semantic versioning does not cover them.

mod append;
mod boxes;
mod brick_materials;
mod brick_record;
mod bytes;
mod coverage;
mod device_cells;
mod extent;
mod file;
mod file_error;
mod geometry;
mod instance_record;
mod instances;
mod levels;
mod lights;
mod lookup;
mod many_lookups;
mod material_records;
mod materials;
mod memory;
mod merge;
mod normals;
mod outline;
mod pack;
mod parts;
mod placement;
mod placement_error;
mod sah_tree;
mod section;
mod section_reader;
mod section_writer;
mod settings;
mod shape;
mod sharing;
mod skip_distances;
mod statistics;
mod stream;
mod streamed;
mod top_lights;
mod unpack;
mod validate;
mod version_1;
mod wide_tree;

pub(crate) use append::Addition;
pub(crate) use brick_materials::BrickMaterials;
pub(crate) use brick_record::encode_brick;
pub use device_cells::DeviceCells;
pub use file::MAGIC;
pub use file_error::{FileError, FileErrorKind};
pub use geometry::Geometry;
pub use levels::{LevelCount, LevelListener, LevelProgress, LevelStep, LevelSummary, Levels, MAX_LEVELS, add_levels};
#[cfg(test)]
pub(crate) use lights::tests as lights_tests;
pub(crate) use lights::{append_lights, covers, cube_of, deciding_axis, leaf_of, tree_of_cubes};
pub(crate) use lookup::cell_in_node;
#[doc(hidden)]
pub use merge::{Lattice, Scatter};
pub use outline::{Object, Outline};
pub use pack::PackError;
pub(crate) use pack::pack_grid;
pub use placement::Placement;
pub use placement_error::PlacementError;
pub(crate) use sah_tree::Shape;
#[doc(hidden)]
pub use section::Section;
#[doc(hidden)]
pub use skip_distances::SKIP_DISTANCES;
pub use statistics::Statistics;
pub use stream::{BrickSource, StreamError, save_streamed};
#[cfg(not(target_arch = "wasm32"))]
pub use streamed::rewrite_for_streaming;
#[doc(hidden)]
pub use streamed::{StreamHead, StreamedLevels, WholeLevel};
pub(crate) use wide_tree::{LEAF, WideNode, WideTree};
#[doc(hidden)]
pub use {instances::MAX_INSTANCE_DEPTH, lights::morton_order};

use crate::cuts::Cuts;
use crate::math::normalize;
use bytemuck::{Pod, Zeroable};
use glam::{IVec3, Vec3};
use std::sync::Arc;
use voxtrace_scene::Invalid;
use voxtrace_scene::camera::Camera;
use voxtrace_scene::georeference::Georeference;
use voxtrace_scene::ray::{Face, Hit};
use voxtrace_scene::scene::Unit;
use voxtrace_scene::sky::Sky;
use voxtrace_scene::transform::Transform;

/// Set in a cell word that holds a child; the other bits are then the child's index.
#[doc(hidden)]
pub const CELL_OCCUPIED: u32 = 1 << 31;

/// The immutable scene that tracers read. Its arrays are always consistent ([`Self::validate`]): only packing, placing
/// and opening a file fill them.
#[derive(Clone, Debug)]
pub struct PackedScene {
    /// Name for people.
    pub name: String,
    /// What stays while things move.
    pub(crate) geometry: Arc<Geometry>,
    /// Where its grids stand.
    pub(crate) placement: Placement,
    /// Light from outside.
    pub sky: Sky,
    /// Factor on every material's emission.
    pub light_intensity: f32,
    /// Named cameras.
    pub cameras: Vec<Camera>,
    /// What of it is shown. Files do not say it.
    pub cuts: Cuts,
    /// Material of the ground of [`crate::surroundings`], which nothing else has, where there is one. Files do not say it.
    pub(crate) ground: Option<u16>,
    /// Edge of a voxel in `unit`s.
    pub voxel_size: f64,
    /// Unit of `voxel_size`.
    pub unit: Unit,
    /// The coordinates that it was made from, where there are any.
    pub georeference: Option<Georeference>,
    /// What its parts are called.
    pub outline: Arc<Outline>,
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
    /// Index of the first top cell in [`Geometry::cells`], a multiple of 64.
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

impl PackedGrid {
    /// Voxels stored.
    pub fn voxel_count(&self) -> u64 {
        let [low, high] = self.voxels;
        u64::from(low) | u64::from(high) << 32
    }
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
    /// Index of its leaf in [`Placement::light_nodes`], [`LightNode::NONE`] where its grid emits nothing.
    pub light_leaf: u32,
}

impl PackedInstance {
    /// An instance of a packed grid, for [`Placement::new`], which looks for its light.
    pub fn new(grid: u32, world_from_grid: Transform, scene_instance: u32) -> Self {
        let grid_from_world = world_from_grid.inverse();
        Self { grid_from_world, world_from_grid, grid, scene_instance, light_leaf: LightNode::NONE }
    }

    /// Outward unit normal of a face in world space. Twin of `world_normal` in `shaders/surface.slang`.
    #[doc(hidden)]
    // Modules for pages are held small.
    #[cfg_attr(not(target_arch = "wasm32"), inline)]
    pub fn world_normal(&self, face: Face) -> Vec3 {
        normalize(self.world_from_grid.direction(face.normal().as_vec3()))
    }
}

/// A node of the hierarchy over instances: the box around what is below it, world space.
#[doc(hidden)]
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
    /// Emitted radiance, linear, before the scene's light intensity; of a medium without a surface, in each voxel of the way.
    pub emission: Vec3,
    /// Metalness.
    pub metallic: f32,
    /// Share of light that enters.
    pub transmission: f32,
    /// Index of refraction.
    pub ior: f32,
    /// Weight of the coat.
    pub specular: f32,
    /// Mean cosine of scattering in the medium.
    pub anisotropy: f32,
    /// Absorption coefficient of the medium, one over voxels.
    pub absorption: Vec3,
    /// Scattering coefficient of the medium, one over voxels.
    pub scattering: f32,
}

impl PackedMaterial {
    /// Whether all light enters the voxel without reflection or refraction: what it emits, it emits within.
    #[inline]
    pub(crate) fn is_without_surface(&self) -> bool {
        self.transmission >= 1.0 && self.ior == 1.0 && self.metallic <= 0.0
    }

    /// Radiance that the surface emits, before the scene's light intensity.
    #[inline]
    pub(crate) fn surface_emission(&self) -> Vec3 {
        if self.is_without_surface() { Vec3::ZERO } else { self.emission }
    }
}

/// Most emitters in a leaf of the tree over them.
#[doc(hidden)]
pub const LEAF_EMITTERS: usize = 8;

/// An emissive voxel with at least one face that no voxel of its grid covers.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Emitter {
    /// The voxel in its grid.
    pub voxel: IVec3,
    /// Index of the grid.
    pub grid: u32,
    /// Bit f is set where [`voxtrace_scene::Face`] f is free.
    pub faces: u32,
    /// Index of the material.
    pub material: u32,
    /// Luminance of the material's emission, > 0.
    pub luminance: f32,
    /// Index of the leaf in [`Geometry::light_nodes`] that holds it.
    pub leaf: u32,
}

/// A node of a tree of lights. There are two levels of trees: one over the emitters of each grid, in the space of the
/// grid, which all its instances share ([`Geometry::light_nodes`]), and one over the instances that emit, in world space
/// ([`Placement::light_nodes`]).
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct LightNode {
    /// Lowest corner of the box around what emits.
    pub min: Vec3,
    /// Inner node: index of the right child, the left one follows the node. Leaf: the first emitter, or the instance.
    pub index: u32,
    /// Highest corner.
    pub max: Vec3,
    /// Emitters of a leaf, at most [`LEAF_EMITTERS`], or 1 for the instance; 0 in an inner node.
    pub count: u32,
    /// Power (luminance × area) that leaves along each direction −x, +x, −y, +y, −z, +z.
    pub power: [f32; 6],
    /// Index of the parent, [`LightNode::NONE`] in a root.
    pub parent: u32,
    /// In the leaf of an instance the root of its grid's tree, elsewhere 0.
    pub root: u32,
}

impl LightNode {
    /// No node: the parent of a root.
    pub const NONE: u32 = u32::MAX;
    pub(crate) const EMPTY: Self = Self {
        min: Vec3::INFINITY,
        index: 0,
        max: Vec3::NEG_INFINITY,
        count: 0,
        power: [0.0; 6],
        parent: Self::NONE,
        root: 0,
    };
}

impl PackedScene {
    /// A scene without anything in it, under a black sky.
    pub fn empty() -> Self {
        let geometry = Geometry::default().finished();
        Self {
            name: String::new(),
            placement: Placement::of_sound(&geometry, Vec::new()),
            geometry: Arc::new(geometry),
            sky: Sky::black(),
            light_intensity: 1.0,
            cameras: Vec::new(),
            cuts: Cuts::default(),
            ground: None,
            voxel_size: 1.0,
            georeference: None,
            unit: Unit::Voxel,
            outline: Arc::default(),
        }
    }

    /// What stays while things move.
    pub fn geometry(&self) -> &Arc<Geometry> {
        &self.geometry
    }

    /// Where the grids stand.
    pub fn placement(&self) -> &Placement {
        &self.placement
    }

    /// The same scene with its grids elsewhere. The geometry is shared, not copied.
    ///
    /// # Errors
    /// [`PlacementError::OtherGeometry`] where the placement was made for another one.
    pub fn with_placement(&self, placement: &Placement) -> Result<Self, PlacementError> {
        placement.check_geometry(&self.geometry)?;
        Ok(Self { placement: placement.clone(), ..self.clone() })
    }

    /// The same voxels of other materials, as many as there were: what packing the scene with them gives.
    ///
    /// # Panics
    /// Where there are more or fewer.
    pub(crate) fn with_materials(&self, materials: Vec<PackedMaterial>) -> Self {
        if self.geometry.is_edited {
            return self.compacted().with_materials(materials);
        }
        assert_eq!(materials.len(), self.materials().len(), "as many materials as there were");
        let geometry = self.geometry.with_materials(materials);
        let placement = Placement::of_sound(&geometry, self.placement.instances().to_vec());
        Self { geometry: Arc::new(geometry), placement, ..self.clone() }
    }

    /// The same scene without some of its instances. The geometry is shared, with grids that nobody shows any more.
    pub(crate) fn without(&self, is_left_out: impl Fn(&PackedInstance) -> bool) -> Self {
        let left = self.placement.instances().iter().filter(|instance| !is_left_out(instance)).copied().collect();
        Self { placement: Placement::of_sound(&self.geometry, left), ..self.clone() }
    }

    /// The same scene with its first instances alone.
    pub(crate) fn with_first(&self, count: usize) -> Self {
        Self {
            placement: Placement::of_sound(&self.geometry, self.placement.instances()[..count].to_vec()),
            ..self.clone()
        }
    }

    /// Replaces the trees over the emitters of the grids, to try importances of one's own.
    ///
    /// # Errors
    /// As [`Self::validate`]; the scene is then unchanged.
    #[doc(hidden)]
    pub fn set_light_nodes(&mut self, nodes: Vec<LightNode>) -> Result<(), Invalid> {
        let geometry = Geometry { light_nodes: nodes.into(), ..(*self.geometry).clone() };
        geometry.validate()?;
        let geometry = geometry.finished();
        self.placement = Placement::of_sound(&geometry, self.placement.instances().to_vec());
        self.geometry = Arc::new(geometry);
        Ok(())
    }

    /// Checks the whole scene.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub fn validate(&self) -> Result<(), Invalid> {
        self.geometry.validate()?;
        self.placement.validate(&self.geometry)?;
        self.geometry.validate_parts(&self.placement)
    }

    /// The material of the voxel that `hit` met. The hit must be one of this scene and no miss.
    pub fn material(&self, hit: &Hit) -> &PackedMaterial {
        &self.geometry.materials[self.material_index(hit) as usize]
    }

    /// Index of the material of the voxel that `hit`, which is no miss, met.
    ///
    /// # Panics
    /// If the hit is not one of this scene.
    pub fn material_index(&self, hit: &Hit) -> u32 {
        self.packed_material_index(&self.hit_of_packed(hit))
    }

    /// As [`Self::material`], of a hit as tracers find it.
    pub(crate) fn packed_material(&self, hit: &Hit) -> &PackedMaterial {
        &self.geometry.materials[self.packed_material_index(hit) as usize]
    }

    /// As [`Self::material_index`], of a hit as tracers find it.
    #[doc(hidden)]
    pub fn packed_material_index(&self, hit: &Hit) -> u32 {
        let grid = &self.geometry.grids[self.placement.instances[hit.instance as usize].grid as usize];
        self.geometry.material_at(grid, hit.voxel).expect("a hit's voxel is occupied")
    }

    /// Grids, as in [`Geometry::grids`].
    pub fn grids(&self) -> &[PackedGrid] {
        self.geometry.grids()
    }

    /// Materials, as in [`Geometry::materials`].
    pub fn materials(&self) -> &[PackedMaterial] {
        self.geometry.materials()
    }

    /// Visible instances, as in [`Placement::instances`]. What was merged is one of them: [`Self::instance`] has that of a hit.
    pub fn instances(&self) -> &[PackedInstance] {
        self.placement.instances()
    }
}
