//! The scene graph of a .vox file, flattened into instances: transforms are multiplied along the way down, hidden groups hide
//! what they hold, and the key frames of everything along the way are merged.
//!
//! A transform node maps p to R·p + t; a shape node puts its model so that the corner of voxel ⌊size / 2⌋ lies at the
//! origin. (The format text says that translations add up; MagicaVoxel, like every other reader, rotates a child's
//! translation by its parent.) `timeline` says what happens between key frames.

use super::{
    attributes::Attributes,
    document::{Body, Chunk, GroupNode, ShapeNode, TransformNode},
    rotation::Rotation,
    timeline::{Event, Placement, Timeline, Track, Way},
};
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::{path::Path, rc::Rc};
use voxtrace_scene::scene::{Group, Instance, Keyframe};
use voxtrace_scene::transform::Transform;
use voxtrace_voxelize::{ImportError, Limits};

/// Largest translation of an instance, in voxels: f32 holds whole numbers exactly up to 2²⁴.
pub const MAX_TRANSLATION: i64 = 1 << 23;
/// Deepest nesting whatever the limits say: the walk down uses the stack.
const MAX_DEPTH: u32 = 256;

/// What the way down to a node says about everything below it.
struct Inherited {
    way: Rc<Way>,
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
        let way = Rc::new(Way::default());
        let nothing = Inherited { way, name: String::new(), layer: None, group: None, hidden: false };
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
        let attributes = Attributes { dict: &node.attributes, path: self.graph.path, offset };
        let own = Track::new(keys, attributes.flag("_loop"));
        let own = own.ok_or_else(|| self.malformed(offset, "a transform node without a frame"))?;
        self.spend(own.len() - 1, offset)?;
        let way = Rc::new(above.way.with(own));
        self.spend(way.moving(), offset)?;
        let own_layer = self.graph.layer_indices.get(&node.layer).copied();
        // What stands in a hidden group's layer stays hidden when it has a layer of its own.
        let group_hidden = own_layer.is_some() && above.layer.is_some_and(|layer| self.graph.layer_hidden[layer]);
        let name = attributes.text("_name").unwrap_or_default();
        // A graph may show one long name many times over.
        self.spend(name.len() / 64, offset)?;
        let below = Inherited {
            way,
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
        let translation = DVec3::from_array(attributes.numbers::<i32, 3>("_t")?.unwrap_or_default().map(f64::from));
        Ok((attributes.integer("_f")?.unwrap_or(0), Placement { rotation, translation }))
    }

    fn group(&mut self, node: &GroupNode, offset: u64, above: &Inherited) -> Result<(), ImportError> {
        let hidden = above.hidden || self.attributes(&node.attributes, offset).flag("_hidden");
        let way = Rc::clone(&above.way);
        // The root of the graph holds everything: it is no group that somebody made.
        let group = match self.ancestors.len() {
            0..=2 => None,
            _ => {
                self.groups.push(Group { name: above.name.clone(), parent: above.group });
                Some(self.groups.len() - 1)
            }
        };
        let below = Inherited { way, name: String::new(), layer: above.layer, group, hidden };
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
        let attributes = Attributes { dict: &node.attributes, path: self.graph.path, offset };
        let models = Track::new(keys, attributes.flag("_loop"));
        let models = models.ok_or_else(|| self.malformed(offset, "a shape node without a model"))?;
        let timeline = Timeline::of(&above.way, &models);
        self.spend(timeline.events() - 1, offset)?;
        let mut keyframes = Vec::new();
        for Event { frame, model, placement, end } in timeline.iter() {
            let world_from_grid = self.world_from_grid(&placement, model, offset)?;
            let end = self.world_from_grid(&end, model, offset)?;
            keyframes.push(Keyframe { frame, grid: model, world_from_grid, end });
        }
        let mut instance = Instance::new(keyframes[0].grid, keyframes[0].world_from_grid);
        instance.name = above.name.clone();
        (instance.layer, instance.group) = (above.layer, above.group);
        instance.hidden = above.hidden || attributes.flag("_hidden");
        if keyframes.len() > 1 {
            (instance.keyframes, instance.repeats) = (keyframes, timeline.repeats());
        }
        self.instances.push(instance);
        Ok(())
    }

    fn world_from_grid(&self, placement: &Placement, grid: usize, offset: u64) -> Result<Transform, ImportError> {
        let pivot = DVec3::from_array(self.graph.sizes[grid].map(|edge| -f64::from(edge / 2)));
        let corner = placement.after(&Placement { rotation: Rotation::IDENTITY, translation: pivot }).translation;
        if corner.abs().max_element() > MAX_TRANSLATION as f64 {
            let corner = corner.to_array();
            return Err(self.malformed(offset, format!("a model stands at {corner:?}, beyond ±{MAX_TRANSLATION}")));
        }
        Ok(Transform { linear: placement.rotation.to_matrix(), translation: corner.as_vec3() })
    }
}
