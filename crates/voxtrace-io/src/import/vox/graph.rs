//! The scene graph of a .vox file, flattened into instances: transforms are multiplied along the way down, hidden groups hide
//! what they hold, and the key frames of everything along the way are merged.
//!
//! A transform node maps p to R·p + t; a shape node puts its model so that the corner of voxel ⌊size / 2⌋ lies at the
//! origin. (The format text says that translations add up; MagicaVoxel, like every other reader, rotates a child's
//! translation by its parent.) A value holds from its key frame to the next.

use super::{
    attributes::Attributes,
    document::{Body, Chunk, GroupNode, ShapeNode, TransformNode},
    rotation::Rotation,
};
use glam::Vec3;
use rustc_hash::FxHashMap;
use std::{path::Path, rc::Rc};
use voxtrace_scene::scene::{Group, Instance, Keyframe};
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, Limits};

/// Largest translation of an instance, in voxels: f32 holds whole numbers exactly up to 2²⁴.
pub const MAX_TRANSLATION: i64 = 1 << 23;
/// Deepest nesting whatever the limits say: the walk down uses the stack.
const MAX_DEPTH: u32 = 256;

/// A rotation and a translation in whole voxels.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Placement {
    rotation: Rotation,
    translation: [i64; 3],
}

impl Placement {
    fn after(&self, first: &Self) -> Self {
        let turned = self.rotation.apply(first.translation);
        let translation = [0, 1, 2].map(|axis| self.translation[axis].saturating_add(turned[axis]));
        Self { rotation: self.rotation.after(first.rotation), translation }
    }
}

/// A value over time: key frames by rising frame number, at least one. One key frame alone holds for all time.
#[derive(Clone, Debug)]
struct Track<T>(Vec<(u32, T)>);

impl<T: Copy> Track<T> {
    /// From key frames in the order of the file; of two with the same number the later one holds. `None` without any.
    fn new(mut keys: Vec<(u32, T)>) -> Option<Self> {
        keys.sort_by_key(|&(frame, _)| frame);
        keys.reverse();
        keys.dedup_by_key(|&mut (frame, _)| frame);
        keys.reverse();
        (!keys.is_empty()).then_some(Self(keys))
    }

    fn at(&self, frame: u32) -> T {
        let after = self.0.partition_point(|&(key, _)| key <= frame);
        self.0[after.saturating_sub(1)].1
    }

    fn moving_frames(&self) -> impl Iterator<Item = u32> + '_ {
        self.0.iter().map(|&(frame, _)| frame).filter(|_| self.0.len() > 1)
    }

    /// The two tracks joined by `join` at every key frame of either.
    fn with<U: Copy, V>(&self, other: &Track<U>, join: impl Fn(T, U) -> V) -> Track<V> {
        let mut frames: Vec<u32> = self.moving_frames().chain(other.moving_frames()).collect();
        frames.sort_unstable();
        frames.dedup();
        if frames.is_empty() {
            frames.push(0);
        }
        Track(frames.into_iter().map(|frame| (frame, join(self.at(frame), other.at(frame)))).collect())
    }
}

/// What the way down to a node says about everything below it.
struct Inherited {
    placement: Rc<Track<Placement>>,
    name: String,
    layer: Option<usize>,
    group: Option<usize>,
    hidden: bool,
}

/// The nodes of a file and what they refer to.
pub struct Graph<'f> {
    /// Name of the file.
    pub path: &'f Path,
    /// Size of each model.
    pub sizes: &'f [[u32; 3]],
    /// Index of each layer, by its id in the file.
    pub layer_indices: &'f FxHashMap<i32, usize>,
    /// Whether each layer is hidden.
    pub layer_hidden: &'f [bool],
    /// What the file may at most ask for.
    pub limits: &'f Limits,
}

/// The instances of a graph and the groups that hold them.
pub type Flattened = (Vec<Instance>, Vec<Group>);

/// Walks the graph of a file.
pub struct Walk<'f> {
    graph: Graph<'f>,
    nodes: FxHashMap<i32, &'f Chunk<'f>>,
    ancestors: Vec<i32>,
    items: u64,
    instances: Vec<Instance>,
    groups: Vec<Group>,
}

impl<'f> Walk<'f> {
    /// The instances of the graph in `chunks` and the groups that hold them, `None` where there is no graph.
    pub fn instances(graph: Graph<'f>, chunks: &'f [Chunk<'f>]) -> Result<Option<Flattened>, ImportError> {
        let mut nodes = FxHashMap::default();
        let mut lowest: Option<i32> = None;
        for chunk in chunks {
            let id = match &chunk.body {
                Body::Transform(node) => node.id,
                Body::Group(node) => node.id,
                Body::Shape(node) => node.id,
                _ => continue,
            };
            lowest = Some(lowest.map_or(id, |lowest| lowest.min(id)));
            if nodes.insert(id, chunk).is_some() {
                return Err(ImportError::malformed(graph.path, chunk.offset, format!("a second node {id}")));
            }
        }
        let Some(lowest) = lowest else { return Ok(None) };
        // MagicaVoxel's root is node 0; other writers may count from elsewhere.
        let root = if nodes.contains_key(&0) { 0 } else { lowest };
        let offset = nodes[&root].offset;
        let (instances, groups) = (Vec::new(), Vec::new());
        let mut walk = Self { graph, nodes, ancestors: Vec::new(), items: 0, instances, groups };
        let still = Placement { rotation: Rotation::IDENTITY, translation: [0; 3] };
        let placement = Rc::new(Track(vec![(0, still)]));
        let nothing = Inherited { placement, name: String::new(), layer: None, group: None, hidden: false };
        walk.node(root, offset, &nothing)?;
        Ok(Some((walk.instances, walk.groups)))
    }

    fn malformed(&self, offset: u64, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.graph.path, offset, what)
    }

    fn attributes<'d>(&'d self, dict: &'d super::document::Dict<'d>, offset: u64) -> Attributes<'d> {
        Attributes { dict, path: self.graph.path, offset }
    }

    /// Counts what the walk makes: a graph may show one node many times over.
    fn spend(&mut self, count: usize, offset: u64) -> Result<(), ImportError> {
        self.items += count as u64;
        if self.items <= self.graph.limits.items {
            return Ok(());
        }
        let what = "nodes, instances and key frames of the scene graph";
        Err(ImportError::limit(self.graph.path, Some(offset), what, self.items, self.graph.limits.items))
    }

    /// Visits the node `id`, named by the node at `offset`.
    fn node(&mut self, id: i32, offset: u64, above: &Inherited) -> Result<(), ImportError> {
        self.spend(1, offset)?;
        let Some(&chunk) = self.nodes.get(&id) else {
            return Err(self.malformed(offset, format!("the scene graph has no node {id}")));
        };
        if self.ancestors.contains(&id) {
            return Err(self.malformed(offset, format!("node {id} of the scene graph contains itself")));
        }
        if self.ancestors.len() as u32 >= self.graph.limits.depth.min(MAX_DEPTH) {
            let (depth, limit) = (self.ancestors.len() as u64 + 1, self.graph.limits.depth.min(MAX_DEPTH).into());
            return Err(ImportError::limit(self.graph.path, Some(offset), "depth of the scene graph", depth, limit));
        }
        self.ancestors.push(id);
        match &chunk.body {
            Body::Transform(node) => self.transform(node, chunk.offset, above)?,
            Body::Group(node) => self.group(node, chunk.offset, above)?,
            Body::Shape(node) => self.shape(node, chunk.offset, above)?,
            _ => {}
        }
        self.ancestors.pop();
        Ok(())
    }

    fn transform(&mut self, node: &TransformNode, offset: u64, above: &Inherited) -> Result<(), ImportError> {
        let keys = node.frames.iter().map(|frame| self.key(frame, offset)).collect::<Result<Vec<_>, _>>()?;
        let own = Track::new(keys).ok_or_else(|| self.malformed(offset, "a transform node without a frame"))?;
        let placement = above.placement.with(&own, |parent, own| parent.after(&own));
        self.spend(placement.0.len() - 1, offset)?;
        let attributes = Attributes { dict: &node.attributes, path: self.graph.path, offset };
        let own_layer = self.graph.layer_indices.get(&node.layer).copied();
        // What stands in a hidden group's layer stays hidden when it has a layer of its own.
        let group_hidden = own_layer.is_some() && above.layer.is_some_and(|layer| self.graph.layer_hidden[layer]);
        let name = attributes.text("_name").unwrap_or_default();
        // A graph may show one long name many times over.
        self.spend(name.len() / 64, offset)?;
        let below = Inherited {
            placement: Rc::new(placement),
            name,
            layer: own_layer.or(above.layer),
            group: above.group,
            hidden: above.hidden || attributes.flag("_hidden") || group_hidden,
        };
        self.node(node.child, offset, &below)
    }

    /// Frame number and placement of one frame of a transform node.
    fn key(&self, frame: &super::document::Dict, offset: u64) -> Result<(u32, Placement), ImportError> {
        let attributes = self.attributes(frame, offset);
        let rotation = match attributes.integer::<u8>("_r")? {
            Some(byte) => {
                let wrong = || self.malformed(offset, format!("_r is {byte}, which names no rotation"));
                Rotation::from_byte(byte).ok_or_else(wrong)?
            }
            None => Rotation::IDENTITY,
        };
        let translation = attributes.numbers::<i32, 3>("_t")?.unwrap_or_default().map(i64::from);
        Ok((attributes.integer("_f")?.unwrap_or(0), Placement { rotation, translation }))
    }

    fn group(&mut self, node: &GroupNode, offset: u64, above: &Inherited) -> Result<(), ImportError> {
        let hidden = above.hidden || self.attributes(&node.attributes, offset).flag("_hidden");
        let placement = Rc::clone(&above.placement);
        // The root of the graph holds everything: it is no group that somebody made.
        let group = match self.ancestors.len() {
            0..=2 => None,
            _ => {
                self.groups.push(Group { name: above.name.clone(), parent: above.group });
                Some(self.groups.len() - 1)
            }
        };
        let below = Inherited { placement, name: String::new(), layer: above.layer, group, hidden };
        node.children.iter().try_for_each(|&child| self.node(child, offset, &below))
    }

    fn shape(&mut self, node: &ShapeNode, offset: u64, above: &Inherited) -> Result<(), ImportError> {
        let mut keys = Vec::new();
        for (model, attributes) in &node.models {
            let grid = usize::try_from(*model).ok().filter(|&grid| grid < self.graph.sizes.len());
            let grid = grid.ok_or_else(|| {
                self.malformed(offset, format!("a shape shows model {model}, which the file has not"))
            })?;
            keys.push((self.attributes(attributes, offset).integer("_f")?.unwrap_or(0), grid));
        }
        let models = Track::new(keys).ok_or_else(|| self.malformed(offset, "a shape node without a model"))?;
        let joined = above.placement.with(&models, |placement, grid| (placement, grid));
        self.spend(joined.0.len() - 1, offset)?;
        let mut keyframes = Vec::with_capacity(joined.0.len());
        for (frame, (placement, grid)) in joined.0 {
            let world_from_grid = self.world_from_grid(&placement, grid, offset)?;
            keyframes.push(Keyframe { frame, grid, world_from_grid });
        }
        let mut instance = Instance::new(keyframes[0].grid, keyframes[0].world_from_grid);
        instance.name = above.name.clone();
        (instance.layer, instance.group) = (above.layer, above.group);
        instance.hidden = above.hidden || self.attributes(&node.attributes, offset).flag("_hidden");
        instance.keyframes = if keyframes.len() > 1 { keyframes } else { Vec::new() };
        self.instances.push(instance);
        Ok(())
    }

    fn world_from_grid(&self, placement: &Placement, grid: usize, offset: u64) -> Result<Transform, ImportError> {
        let pivot = self.graph.sizes[grid].map(|edge| -i64::from(edge / 2));
        let corner = placement.after(&Placement { rotation: Rotation::IDENTITY, translation: pivot }).translation;
        if corner.iter().any(|coordinate| coordinate.abs() > MAX_TRANSLATION) {
            return Err(self.malformed(offset, format!("a model stands at {corner:?}, beyond ±{MAX_TRANSLATION}")));
        }
        let translation = Vec3::from_array(corner.map(|coordinate| coordinate as f32));
        Ok(Transform { linear: placement.rotation.to_matrix(), translation })
    }
}
