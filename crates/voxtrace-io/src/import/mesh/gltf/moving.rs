//! Nodes of a glTF document that move, and what they carry: the primitives of a node that moves, and of those below it that do not move by themselves,
//! are one part, in its own space. As that space is at rest so large are the voxels of the part: a scale that is not uniform at rest, or a mirror, is a
//! matter of its shape.

use super::Fault;
use super::accessor::Accessors;
use super::animations;
use super::document::{Node, Primitive};
use super::primitives::Target;
use super::scene::{Place, pose};
use super::skins::Pose;
use crate::import::reader::local_origin::LocalOrigin;
use glam::{DAffine3, DMat3, DMat4, DVec3};
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;
use voxtrace_scene::animation::{Attached, Channel, MovingNode, NodeMotion, NodePose, similarity_of, turn_of};
use voxtrace_voxelize::mesh::{Mesh, MovingParts};

/// From y up to z up, as `primitives::placed` has it.
const UP: DMat3 = DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y);
/// Most times at which nodes are looked at, to know whether they are stretched, and most poses in all.
const MOST_LOOKS: usize = 128;
const MOST_POSES: usize = 1 << 20;
/// From this share of its scale on a part counts as stretched.
const STRETCHED: f64 = 0.01;

/// What carries something: a node that moves.
#[derive(Clone, Copy)]
pub(super) struct Carried {
    /// Index among the nodes that move.
    node: usize,
    /// From what is carried to the space of that node.
    node_from_own: DAffine3,
}

impl Carried {
    /// It as something that hangs on its node.
    pub fn attached(self, index: usize) -> Attached {
        Attached { index, node: self.node, node_from_own: self.node_from_own }
    }
}

/// The nodes that move in an animation.
#[derive(Default)]
pub(super) struct Movers {
    /// Those that wait to be met, by their index in the document.
    waiting: HashMap<usize, (NodePose, Vec<Channel>)>,
    met: Vec<MovingNode>,
    /// Their names.
    names: Vec<String>,
    /// The places in `met` of nodes of the document.
    places: HashMap<usize, usize>,
}

impl Movers {
    /// Those of an animation; channels that say what a node is anyway, as exporters write them, move nothing.
    pub fn of(animation: usize, accessors: &Accessors) -> Result<Self, Fault> {
        let document = accessors.document;
        let mut waiting = HashMap::new();
        for (node, mut channels) in animations::channels(&document.animations[animation], accessors)? {
            let rest = rest_of(&document.nodes[node]);
            channels.retain(|channel| !channel.is_at_rest(&rest));
            if !channels.is_empty() {
                waiting.insert(node, (rest, channels));
            }
        }
        Ok(Self { waiting, ..Self::default() })
    }

    /// Whether a node that was not met yet moves.
    pub fn awaits(&self, index: usize) -> bool {
        self.waiting.contains_key(&index)
    }

    /// A node that moves, if it was met, as what carries something in its own space.
    pub fn carrier(&self, index: usize) -> Option<Carried> {
        self.places.get(&index).map(|&node| Carried { node, node_from_own: DAffine3::IDENTITY })
    }

    /// What carries the content of a node, within the place `outer` around it and with its own `local` map.
    pub fn enter(&mut self, index: usize, name: &str, outer: &Place, local: &DAffine3) -> Option<Carried> {
        let Some((rest, channels)) = self.waiting.remove(&index) else {
            let outer = outer.carried?;
            return Some(Carried { node_from_own: outer.node_from_own * *local, ..outer });
        };
        let parent = outer.carried.map(|carried| carried.node);
        let parent_from_outer = outer.carried.map_or(outer.world, |carried| carried.node_from_own);
        self.met.push(MovingNode { parent, parent_from_outer, rest, channels });
        self.names.push(name.to_owned());
        self.places.insert(index, self.met.len() - 1);
        Some(Carried { node: self.met.len() - 1, node_from_own: DAffine3::IDENTITY })
    }
}

/// Where a node is at rest. One with a matrix is not to be moved, but is, as far as its matrix is a pose.
fn rest_of(node: &Node) -> NodePose {
    match &node.matrix {
        Some(matrix) => {
            let (scale, rotation, translation) = DMat4::from_cols_array(matrix).to_scale_rotation_translation();
            NodePose { translation, rotation, scale }
        }
        None => pose(node),
    }
}

/// A primitive, the map from its own space, or from that of its pose where it follows joints, to that of the node that carries it, and the pose.
type Piece<'a> = (&'a Primitive, DAffine3, Option<Rc<Pose>>);

/// The primitives that nodes carry.
#[derive(Default)]
pub(super) struct Parts<'a>(Vec<Vec<Piece<'a>>>);

impl<'a> Parts<'a> {
    /// Adds one.
    pub fn add(&mut self, primitive: &'a Primitive, carried: Carried, pose: Option<Rc<Pose>>) {
        if self.0.len() <= carried.node {
            self.0.resize_with(carried.node + 1, Vec::new);
        }
        self.0[carried.node].push((primitive, carried.node_from_own, pose));
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Makes meshes of the parts, hangs them and the cameras on the nodes that carry them, and gives the motion to the clip of the mesh.
    pub fn hang(
        self,
        movers: Movers,
        cameras: Vec<Attached>,
        clip: usize,
        mesh: &mut Mesh,
        (accessors, coordinate_sets): (&Accessors, &[u32]),
    ) -> Result<(), Fault> {
        let Movers { met: nodes, names, .. } = movers;
        let world_from_file = DAffine3::from_mat3(UP);
        let mut motion = NodeMotion { nodes, world_from_file, instances: Vec::new(), cameras };
        let looks = looks(&motion);
        let (mut parts, mut known, mut stretched) = (MovingParts::default(), HashMap::new(), 0);
        for (node, primitives) in self.0.into_iter().enumerate().filter(|(_, primitives)| !primitives.is_empty()) {
            // What never has a size is never seen.
            let Some(shape) = looks.iter().find_map(|maps| shape_of(&maps[node].matrix3)) else { continue };
            let bits = |map: &DAffine3| map.to_cols_array().map(f64::to_bits);
            let of_primitive = |(primitive, map, pose): &Piece| {
                (std::ptr::from_ref::<Primitive>(primitive), bits(map), pose.as_ref().map(Rc::as_ptr))
            };
            let key =
                (primitives.iter().map(of_primitive).collect::<Vec<_>>(), shape.to_cols_array().map(f64::to_bits));
            let part = match known.get(&key) {
                Some(&part) => part,
                None => {
                    parts.meshes.push(part_mesh(&primitives, &shape, mesh, accessors, coordinate_sets)?);
                    let count = parts.meshes.iter().map(|part| part.positions.len() as u64).sum::<u64>();
                    if count > accessors.limits.points {
                        return Err(Fault::limit("vertices", count, accessors.limits.points));
                    }
                    known.insert(key, parts.meshes.len() - 1);
                    parts.meshes.len() - 1
                }
            };
            let node_from_own = DAffine3::from_mat3(shape.inverse() * UP.transpose());
            let is_stretched = |maps: &Vec<DAffine3>| {
                similarity_of(&(maps[node] * node_from_own)).is_some_and(|(_, error)| error > STRETCHED)
            };
            stretched += usize::from(looks.iter().any(is_stretched));
            motion.instances.push(Attached { index: parts.placed.len(), node, node_from_own });
            parts.placed.push((part, names[node].clone()));
        }
        if stretched > 0 {
            let what = if stretched == 1 { "part has" } else { "parts have" };
            mesh.notes.push(format!("{stretched} moving {what} scales that are not uniform: shown with their mean"));
        }
        if !(motion.instances.is_empty() && motion.cameras.is_empty()) {
            mesh.moving = (!motion.instances.is_empty()).then(|| Box::new(parts));
            mesh.clips[clip].motion = Some(Arc::new(motion));
        }
        Ok(())
    }
}

/// The nodes at rest, and at times of keys.
fn looks(motion: &NodeMotion) -> Vec<Vec<DAffine3>> {
    let channels = motion.nodes.iter().flat_map(|node| &node.channels);
    let mut times: Vec<f32> = channels.flat_map(|channel| channel.times().iter().copied()).collect();
    times.sort_unstable_by(f32::total_cmp);
    times.dedup();
    let most = (MOST_POSES / motion.nodes.len().max(1)).clamp(1, MOST_LOOKS);
    let every = times.len().div_ceil(most).max(1);
    let at = times.iter().step_by(every).map(|&time| Some(f64::from(time)));
    [None].into_iter().chain(at).map(|time| motion.nodes_at(time)).collect()
}

/// What a matrix does before it turns: a scale, as a rule. `None` where it is flat.
fn shape_of(matrix: &DMat3) -> Option<DMat3> {
    let turn = turn_of(matrix)?;
    // A rotation, not a mirrored one: what is mirrored is the shape.
    let turn = turn * turn.determinant().signum();
    // Parts that are alike but for rounding are one.
    let shape = (turn.transpose() * *matrix).as_mat3().as_dmat3();
    let mean = (shape.x_axis.x + shape.y_axis.y + shape.z_axis.z) / 3.0;
    let scale = DMat3::from_diagonal(DVec3::splat(f64::from(mean as f32)));
    let is_uniform = shape.abs_diff_eq(scale, 1e-6 * mean.abs());
    Some(if is_uniform { scale } else { shape })
}

/// The mesh of a part, without the materials, which are those of `mesh`.
fn part_mesh(
    primitives: &[Piece],
    shape: &DMat3,
    mesh: &mut Mesh,
    accessors: &Accessors,
    coordinate_sets: &[u32],
) -> Result<Mesh, Fault> {
    let mut part = Mesh { materials: std::mem::take(&mut mesh.materials), ..Mesh::default() };
    let mut target = Target { mesh: &mut part, local_origin: LocalOrigin::default(), coordinate_sets };
    for (primitive, node_from_own, pose) in primitives {
        target.push(primitive, accessors, &(DAffine3::from_mat3(*shape) * *node_from_own), pose.as_deref())?;
    }
    let offset = target.local_origin.offset();
    mesh.materials = std::mem::take(&mut part.materials);
    Ok(Mesh { offset, ..part })
}
