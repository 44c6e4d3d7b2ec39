//! The part of a packed scene that says where things are: instances, the hierarchy over them, and the top of the light tree.
//! Some hundred bytes for each instance: a frame in which things only move makes it anew and keeps the geometry.

use super::instances::{cost_of, hierarchy_of, refitted};
use super::top_lights::top_lights_of;
use super::wide_tree::WideTree;
use super::{Geometry, InstanceNode, LightNode, PackedInstance, PlacementError, Section};
use rayon::prelude::*;
use std::sync::{Arc, OnceLock};
use voxtrace_scene::Invalid;
use voxtrace_scene::scene::{Instance, Scene};

/// Where the grids of a [`Geometry`] stand. Cheap to clone.
#[derive(Clone, Debug)]
pub struct Placement {
    /// Visible instances.
    pub(crate) instances: Section<PackedInstance>,
    /// Bounding volume hierarchy over the instances.
    pub(crate) instance_nodes: Section<InstanceNode>,
    /// Expected work of a ray in the hierarchy when it was built.
    built_cost: f32,
    /// Tree over the instances that emit.
    pub(crate) light_nodes: Section<LightNode>,
    /// Of the geometry that it was made for.
    fingerprint: u64,
    /// The hierarchy as processors walk it, once they do.
    wide_tree: Arc<OnceLock<Option<WideTree>>>,
}

impl Placement {
    /// Places instances of the grids of `geometry`. Of an instance only `grid`, `world_from_grid` and `scene_instance`
    /// are read.
    ///
    /// # Errors
    /// [`PlacementError`] where there is no such grid or a transform is no similarity; [`PlacementError::Merged`] where instances were merged.
    pub fn new(
        geometry: &Geometry,
        instances: impl IntoIterator<Item = PackedInstance>,
    ) -> Result<Self, PlacementError> {
        Ok(Self::of_sound(geometry, checked(geometry, instances.into_iter().collect())?))
    }

    /// Places instances as [`Self::new`] does, quicker where things have moved a little: where as many instances show the same grids as in `self`,
    /// the hierarchy over them is kept and its boxes made anew, as long as rays have at most half as much work again with it as when it was
    /// built. Hits and pictures are those of [`Self::new`], whatever came before.
    ///
    /// # Errors
    /// As [`Self::new`]; [`PlacementError::OtherGeometry`] where `self` was made for another geometry.
    pub fn moved(
        &self,
        geometry: &Geometry,
        instances: impl IntoIterator<Item = PackedInstance>,
    ) -> Result<Self, PlacementError> {
        self.check_geometry(geometry)?;
        Ok(self.moved_sound(geometry, checked(geometry, instances.into_iter().collect())?))
    }

    /// As [`Self::of_scene`], quicker where things have moved a little since `self`: see [`Self::moved`].
    ///
    /// # Errors
    /// As [`Self::of_scene`]; [`PlacementError::OtherGeometry`] where `self` was made for another geometry.
    pub fn moved_to_scene(&self, geometry: &Geometry, scene: &Scene) -> Result<Self, PlacementError> {
        self.moved_to_scene_and(geometry, scene, &[])
    }

    /// As [`Self::of_scene_and`], quicker where things have moved a little since `self`: see [`Self::moved`].
    ///
    /// # Errors
    /// As [`Self::moved_to_scene`].
    pub fn moved_to_scene_and(
        &self,
        geometry: &Geometry,
        scene: &Scene,
        further: &[PackedInstance],
    ) -> Result<Self, PlacementError> {
        self.check_geometry(geometry)?;
        Ok(self.moved_sound(geometry, placed_in(geometry, scene, further)?))
    }

    /// The visible instances of a scene that was packed to `geometry`, as they stand now: what packing it anew would give,
    /// if its grids and materials did not change.
    ///
    /// # Errors
    /// As [`Self::new`]; [`PlacementError::NotPacked`] where a grid was hidden when the scene was packed.
    pub fn of_scene(geometry: &Geometry, scene: &Scene) -> Result<Self, PlacementError> {
        Self::of_scene_and(geometry, scene, &[])
    }

    /// As [`Self::of_scene`], with further instances behind them: those of [`crate::surroundings`], say, which the scene does not know.
    ///
    /// # Errors
    /// As [`Self::of_scene`].
    pub fn of_scene_and(
        geometry: &Geometry,
        scene: &Scene,
        further: &[PackedInstance],
    ) -> Result<Self, PlacementError> {
        Ok(Self::of_sound(geometry, placed_in(geometry, scene, further)?))
    }

    /// Places instances that were checked.
    pub(crate) fn of_sound(geometry: &Geometry, instances: Vec<PackedInstance>) -> Self {
        let nodes = hierarchy_of(&instances, &geometry.grids);
        let cost = cost_of(&nodes);
        Self::with_hierarchy(geometry, instances, nodes.into(), cost)
    }

    fn moved_sound(&self, geometry: &Geometry, instances: Vec<PackedInstance>) -> Self {
        match refitted(&self.instance_nodes, self.built_cost, &instances, &geometry.grids) {
            Some(nodes) => Self::with_hierarchy(geometry, instances, nodes.into(), self.built_cost),
            None => Self::of_sound(geometry, instances),
        }
    }

    /// Places the instances of a file with the hierarchy over them that it has.
    ///
    /// # Errors
    /// One sentence about the first fault.
    pub(super) fn of_file(
        geometry: &Geometry,
        instances: Vec<PackedInstance>,
        instance_nodes: Section<InstanceNode>,
    ) -> Result<Self, Invalid> {
        let read = Self {
            instances: instances.into(),
            instance_nodes,
            built_cost: 0.0,
            light_nodes: Section::default(),
            fingerprint: geometry.fingerprint(),
            wide_tree: Arc::default(),
        };
        read.validate_instances(geometry)?;
        let cost = cost_of(&read.instance_nodes);
        Ok(Self::with_hierarchy(geometry, read.instances.to_vec(), read.instance_nodes, cost))
    }

    fn with_hierarchy(
        geometry: &Geometry,
        mut instances: Vec<PackedInstance>,
        instance_nodes: Section<InstanceNode>,
        built_cost: f32,
    ) -> Self {
        let light_nodes = top_lights_of(geometry, &mut instances).into();
        let (instances, fingerprint) = (instances.into(), geometry.fingerprint());
        Self { instances, instance_nodes, built_cost, light_nodes, fingerprint, wide_tree: Arc::default() }
    }

    /// Whether it was made for this geometry, or one with the same grids and lights.
    ///
    /// # Errors
    /// [`PlacementError::OtherGeometry`] where not.
    pub fn check_geometry(&self, geometry: &Geometry) -> Result<(), PlacementError> {
        match self.fingerprint == geometry.fingerprint() {
            true => Ok(()),
            false => Err(PlacementError::OtherGeometry),
        }
    }

    /// Visible instances.
    pub fn instances(&self) -> &[PackedInstance] {
        &self.instances
    }

    /// Bounding volume hierarchy over the instances.
    #[doc(hidden)]
    pub fn instance_nodes(&self) -> &[InstanceNode] {
        &self.instance_nodes
    }

    /// The hierarchy over the instances as processors walk it; `None` where the binary tree has to do.
    pub(crate) fn wide_tree(&self) -> Option<&WideTree> {
        self.wide_tree.get_or_init(|| WideTree::new(&self.instance_nodes)).as_ref()
    }

    /// Tree over the instances that emit, world space; the root comes first.
    #[doc(hidden)]
    pub fn light_nodes(&self) -> &[LightNode] {
        &self.light_nodes
    }

    /// Bytes of all of it: what a frame in which things move writes.
    pub fn size_bytes(&self) -> u64 {
        self.instances.size_bytes() + self.instance_nodes.size_bytes() + self.light_nodes.size_bytes()
    }
}

/// Whether its instances can be placed one by one.
fn check_kept(geometry: &Geometry) -> Result<(), PlacementError> {
    if geometry.parts.is_none() { Ok(()) } else { Err(PlacementError::Merged) }
}

/// Instances of the grids of `geometry` as [`PackedInstance::new`] makes them.
fn checked(geometry: &Geometry, mut instances: Vec<PackedInstance>) -> Result<Vec<PackedInstance>, PlacementError> {
    check_kept(geometry)?;
    let count = geometry.grids.len();
    let check = |(index, given): (usize, &mut PackedInstance)| {
        let instance = PackedInstance::new(given.grid, given.world_from_grid, given.scene_instance);
        if instance.grid as usize >= count {
            let grid = instance.grid as usize;
            return Err(PlacementError::MissingGrid { instance: index, grid, count });
        }
        if !instance.world_from_grid.is_similarity() || !instance.grid_from_world.is_similarity() {
            return Err(PlacementError::BadTransform(index));
        }
        *given = instance;
        Ok(())
    };
    // Of several faults the first one is told, on any number of threads.
    let fault = instances.par_iter_mut().enumerate().with_min_len(1024).map(check).find_map_first(Result::err);
    fault.map_or(Ok(instances), Err)
}

/// The visible instances of a scene that was packed to `geometry`, checked, with further ones behind them.
fn placed_in(
    geometry: &Geometry,
    scene: &Scene,
    further: &[PackedInstance],
) -> Result<Vec<PackedInstance>, PlacementError> {
    check_kept(geometry)?;
    let place = |(index, instance): (usize, &Instance)| {
        if !scene.is_visible(instance) {
            return Ok(None);
        }
        let (grid, count) = (instance.grid, scene.grids.len());
        let given = scene.grids.get(grid);
        let given = given.ok_or(PlacementError::MissingGrid { instance: index, grid, count })?;
        if given.is_empty() {
            return Ok(None);
        }
        let packed = geometry.grid_of_scene(grid);
        let packed = packed.ok_or(PlacementError::NotPacked { instance: index, grid })?;
        if !instance.world_from_grid.is_similarity() {
            return Err(PlacementError::BadTransform(index));
        }
        Ok(Some(PackedInstance::new(packed, instance.world_from_grid, index as u32)))
    };
    let placed: Vec<_> = scene.instances.par_iter().enumerate().with_min_len(1024).map(place).collect();
    let further = further.iter().map(|own| PackedInstance::new(own.grid, own.world_from_grid, own.scene_instance));
    placed.into_iter().filter_map(Result::transpose).chain(further.map(Ok)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::packed::PackedScene;
    use crate::{CpuTracer, Film, Frame, Progress, Tracer};
    use glam::{IVec3, Mat3, Vec3};
    use voxtrace_scene::grid::VoxelGrid;
    use voxtrace_scene::material::Material;
    use voxtrace_scene::transform::Transform;

    /// Twenty turned instances of a lamp, a dark grid and another lamp.
    fn example() -> PackedScene {
        let materials = vec![Material::default(), Material::emissive(Vec3::ONE)];
        let mut scene = Scene { materials, ..Scene::new("example") };
        for grid in 0..3u16 {
            let mut voxels = VoxelGrid::new();
            voxels.set(IVec3::new(i32::from(grid), 2, 3), u16::from(grid != 1));
            scene.grids.push(voxels.into());
        }
        for index in 0..20 {
            let linear = Mat3::from_rotation_z(index as f32) * (1.0 + index as f32 * 0.1);
            let translation = Vec3::new((index * 7 % 20) as f32, index as f32, 5.0);
            scene.instances.push(Instance::new(index % 3, Transform { linear, translation }));
        }
        PackedScene::pack(&scene).unwrap()
    }

    #[test]
    fn faults_of_a_placement_are_found() {
        let scene = example();
        let geometry = scene.geometry();
        scene.placement.validate(geometry).unwrap();
        type Fault = fn(&mut Vec<PackedInstance>, &mut Vec<InstanceNode>, &mut Vec<LightNode>);
        let faults: [Fault; 13] = [
            |instances, _, _| instances[4].grid = 3,
            |instances, _, _| instances[4].world_from_grid.linear.x_axis.x += 1.0,
            |instances, _, _| instances[4].light_leaf = 0,
            |instances, _, _| instances[0].light_leaf = LightNode::NONE,
            |instances, _, _| instances[0].light_leaf = u32::MAX - 1,
            |instances, _, _| _ = instances.pop(),
            |_, nodes, _| nodes[0].index = 0,
            |_, _, lights| lights[0].index = lights.len() as u32,
            |_, _, lights| lights[3].parent = 3,
            |_, _, lights| lights[0].parent = 1,
            |_, _, lights| lights[1].parent = LightNode::NONE,
            |_, _, lights| lights.last_mut().unwrap().root += 1,
            |_, _, lights| lights.last_mut().unwrap().count = 2,
        ];
        for (which, fault) in faults.into_iter().enumerate() {
            let placement = &scene.placement;
            let mut instances = placement.instances.to_vec();
            let (mut nodes, mut lights) = (placement.instance_nodes.to_vec(), placement.light_nodes.to_vec());
            fault(&mut instances, &mut nodes, &mut lights);
            let (instances, instance_nodes, light_nodes) = (instances.into(), nodes.into(), lights.into());
            let broken = Placement { instances, instance_nodes, light_nodes, ..placement.clone() };
            assert!(broken.validate(geometry).is_err(), "fault {which}");
        }
        assert!(Placement { fingerprint: 1, ..scene.placement.clone() }.validate(geometry).is_err());
    }

    #[test]
    fn what_moves_a_little_keeps_its_hierarchy_and_what_moves_far_gets_another() {
        let scene = example();
        let (geometry, first) = (scene.geometry(), scene.placement());
        let links = |placement: &Placement| -> Vec<(u32, u32)> {
            placement.instance_nodes.iter().map(|node| (node.index, node.is_leaf)).collect()
        };
        let moved = |by: f32| {
            let instances = first.instances().iter().enumerate().map(|(index, instance)| {
                let turned = Vec3::new((index * 13 % 20) as f32, (index * 3 % 20) as f32, 0.0);
                let translation = instance.world_from_grid.translation + turned * by;
                let world_from_grid = Transform { translation, ..instance.world_from_grid };
                PackedInstance::new(instance.grid, world_from_grid, instance.scene_instance)
            });
            let instances: Vec<_> = instances.collect();
            let (moved, anew) = (first.moved(geometry, instances.clone()), Placement::new(geometry, instances));
            (moved.unwrap(), anew.unwrap())
        };
        for by in [0.0, 0.01, 40.0] {
            let (moved, anew) = moved(by);
            moved.validate(geometry).unwrap();
            assert_eq!(moved.instances(), anew.instances());
            assert_eq!(moved.light_nodes(), anew.light_nodes(), "lights do not depend on what was before");
            assert_eq!(links(&moved) == links(first), by < 1.0, "by {by}");
            if by > 1.0 {
                assert_eq!(moved.instance_nodes(), anew.instance_nodes());
            }
            // Boxes that were not made anew are seen.
            let stale = Placement { instance_nodes: first.instance_nodes.clone(), ..moved };
            assert_eq!(stale.validate(geometry).is_err(), by > 0.0, "by {by}");
        }
        // Another number of instances, and another geometry.
        let fewer = first.moved(geometry, first.instances()[3..].to_vec()).unwrap();
        assert_eq!(
            fewer.instance_nodes(),
            Placement::new(geometry, first.instances()[3..].to_vec()).unwrap().instance_nodes()
        );
        let other = Placement { fingerprint: 1, ..first.clone() };
        assert_eq!(other.moved(geometry, []).unwrap_err(), PlacementError::OtherGeometry);
    }

    #[test]
    fn a_tree_over_the_lights_of_another_moment_is_another_picture() {
        let scene = example();
        let (geometry, first) = (scene.geometry(), scene.placement());
        let turn = Transform { linear: Mat3::from_rotation_z(2.0) * 1.5, translation: Vec3::ZERO };
        let turned =
            |own: &PackedInstance| PackedInstance::new(own.grid, turn.after(&own.world_from_grid), own.scene_instance);
        let instances: Vec<_> = first.instances().iter().map(turned).collect();
        let moved = first.moved(geometry, instances.clone()).unwrap();
        let anew = Placement::new(geometry, instances).unwrap();
        let stale = Placement { light_nodes: first.light_nodes.clone(), ..moved.clone() };
        let film = |placement: &Placement| {
            let scene = scene.with_placement(placement).unwrap();
            let frame = Frame::new(scene.overview(1.0), 24, 24).samples(4);
            let mut tracer = CpuTracer::new(Some(1));
            tracer.set_scene(&Arc::new(scene)).unwrap();
            tracer.render(&frame, &Progress::default()).unwrap();
            let mut film = Film::new(0, 0, frame.region, 0);
            tracer.read(&mut film).unwrap();
            film
        };
        assert!(film(&moved) == film(&anew) && film(&stale) != film(&anew));
    }

    #[test]
    fn what_instances_say_beside_their_place_is_made_anew() {
        let scene = example();
        let mut given = scene.placement.instances.to_vec();
        for instance in &mut given {
            (instance.light_leaf, instance.grid_from_world) = (77, Transform::IDENTITY);
        }
        let placement = Placement::new(&scene.geometry, given).unwrap();
        assert_eq!(placement.instances(), scene.instances());
        assert_eq!(placement.light_nodes(), scene.placement.light_nodes());
    }

    #[test]
    fn the_root_of_the_lights_holds_every_lamp() {
        let scene = example();
        let (geometry, placement) = (&scene.geometry, &scene.placement);
        let check = |instances: &[PackedInstance]| {
            let root = placement.light_nodes()[0];
            let lit = instances.iter().filter(|instance| geometry.light_root(instance.grid).is_some());
            // A cube sends as much in all directions, whichever way it is turned, and at least its area along each axis.
            let area: f32 = lit.clone().map(|instance| instance.world_from_grid.scale().powi(2)).sum();
            let is_in = |instance: &PackedInstance| {
                let voxel = geometry.emitters()[instance.grid.min(1) as usize].voxel.as_vec3();
                let center = instance.world_from_grid.point(voxel + 0.5);
                center.cmpgt(root.min).all() && center.cmplt(root.max).all()
            };
            root.power.iter().all(|&power| power > 0.999 * area && power < 1.5 * area) && lit.clone().all(is_in)
        };
        assert!(check(placement.instances()));
        let mut larger = placement.instances().to_vec();
        larger.iter_mut().for_each(|instance| instance.world_from_grid.linear *= 2.0);
        assert!(!check(&larger), "lamps of another size");
    }
}
