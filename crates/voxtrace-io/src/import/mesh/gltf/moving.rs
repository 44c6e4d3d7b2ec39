//! Nodes of a glTF document that move, and what they carry: the primitives of a node that moves, and of those below it that do not move by themselves,
//! are one part, in its own space. As that space is at rest so large are the voxels of the part: a scale that is not uniform at rest, or a mirror, is a
//! matter of its shape. A node whose shape changes has a part of its own, too, whether it moves or not.

use super::Fault;
use super::accessor::Accessors;
use super::animations::{self, Channels};
use super::changing::{Shaper, Times};
use super::document::{Document, GltfMesh, Node, Primitive};
use super::morphs;
use super::primitives::{Form, Target};
use super::scene::{Place, Worn, pose};
use super::skins::{Pose, Posed, Skins, is_bound};
use crate::import::reader::local_origin::LocalOrigin;
use glam::{DAffine3, DMat3, DMat4, DQuat, DVec3};
use std::collections::HashMap;
use std::rc::Rc;
use std::sync::Arc;
use voxtrace_scene::animation::{
    Attached, Channel, KeyTrack, MovingNode, NodeMotion, NodePose, similarity_of, turn_of,
};
use voxtrace_voxelize::mesh::{Mesh, MovingParts};

/// From y up to z up, as `primitives::placed` has it.
const UP: DMat3 = DMat3::from_cols(DVec3::X, DVec3::Z, DVec3::NEG_Y);
/// Most times at which nodes are looked at, to know whether they are stretched, and most poses in all.
const MOST_LOOKS: usize = 128;
const MOST_POSES: usize = 1 << 20;
/// The pose of what stands where the space around it is.
const AS_IT_IS: NodePose = NodePose { translation: DVec3::ZERO, rotation: DQuat::IDENTITY, scale: DVec3::ONE };
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
    /// Those that wait to be met, by their index in the document, as if they hung on nothing.
    waiting: HashMap<usize, MovingNode>,
    met: Vec<MovingNode>,
    /// Their names.
    names: Vec<String>,
    /// The places in `met` of nodes of the document.
    places: HashMap<usize, usize>,
    /// The weights of the morph targets of nodes' meshes, where they change.
    weights: HashMap<usize, Vec<KeyTrack<1>>>,
    /// Of nodes that wear a bending skin which nothing carries what stands for them, at rest in the world.
    standing: HashMap<usize, Carried>,
}

impl Movers {
    /// Those of an animation; channels that say what a node is anyway, as exporters write them, move nothing.
    pub fn of(animation: usize, accessors: &Accessors) -> Result<Self, Fault> {
        let document = accessors.document;
        let mut waiting = HashMap::new();
        let Channels { of_nodes, mut weights } = animations::channels(&document.animations[animation], accessors)?;
        for (node, mut channels) in of_nodes {
            let rest = rest_of(&document.nodes[node]);
            channels.retain(|channel| !channel.is_at_rest(&rest));
            if !channels.is_empty() {
                waiting.insert(node, moving(rest, channels));
            }
        }
        weights.retain(|&node, tracks| {
            let Some((node, mesh)) = with_mesh(document, node) else { return false };
            let rest =
                morphs::weights(node, mesh).iter().map(|&weight| f64::from(weight)).chain(std::iter::repeat(0.0));
            !tracks.iter().zip(rest).all(|(track, rest)| track.is_at_rest([rest]))
        });
        for &node in weights.keys() {
            let Some((own, mesh)) = with_mesh(document, node) else { continue };
            if own.skin.is_none() || !mesh.primitives.iter().all(is_bound) {
                waiting.entry(node).or_insert_with(|| moving(rest_of(own), Vec::new()));
            }
        }
        Ok(Self { waiting, weights, ..Self::default() })
    }

    /// Whether a node that was not met yet moves.
    pub fn awaits(&self, index: usize) -> bool {
        self.waiting.get(&index).is_some_and(|node| !node.channels.is_empty())
    }

    /// The weights of the morph targets of a node's mesh, where they change.
    pub fn weights(&self, index: usize) -> Option<&[KeyTrack<1>]> {
        self.weights.get(&index).map(Vec::as_slice)
    }

    /// The pose of a node at a time, in seconds; `None` where it does not move.
    pub fn pose_at(&self, index: usize, time: f64) -> Option<NodePose> {
        let met = self.places.get(&index).map(|&place| &self.met[place]);
        let node = met.or_else(|| self.waiting.get(&index)).filter(|node| !node.channels.is_empty())?;
        Some(node.pose_at(Some(time)))
    }

    /// What carries a primitive that joints place. Where nothing does, and it changes its shape, something stands still for it, named as its node.
    pub fn carry(&mut self, posed: &Posed, document: &Document) -> Option<Carried> {
        let node = posed.worn.node;
        if posed.carried.is_some() || !(posed.bends || self.weights.contains_key(&node)) {
            return posed.carried;
        }
        if let Some(&known) = self.standing.get(&node) {
            return Some(known);
        }
        self.met.push(moving(AS_IT_IS, Vec::new()));
        self.names.push(document.nodes[node].name.clone());
        let carried = Carried { node: self.met.len() - 1, node_from_own: DAffine3::IDENTITY };
        self.standing.insert(node, carried);
        Some(carried)
    }

    /// A node that moves, if it was met, as what carries something in its own space.
    pub fn carrier(&self, index: usize) -> Option<Carried> {
        self.places.get(&index).map(|&node| Carried { node, node_from_own: DAffine3::IDENTITY })
    }

    /// What carries the mesh of a node, and what carries all else of it and below it, within the place `outer` around it and with its own `local` map.
    pub fn enter(&mut self, index: usize, name: &str, outer: &Place, local: &DAffine3) -> [Option<Carried>; 2] {
        let by_outer = outer.carried.map(|outer| Carried { node_from_own: outer.node_from_own * *local, ..outer });
        let Some(mut node) = self.waiting.remove(&index) else { return [by_outer; 2] };
        node.parent = outer.carried.map(|carried| carried.node);
        node.parent_from_outer = outer.carried.map_or(outer.world, |carried| carried.node_from_own);
        let is_still = node.channels.is_empty();
        if is_still {
            // What changes its shape alone stands where its matrix has it, whatever that does.
            (node.parent_from_outer, node.rest) = (node.parent_from_outer * *local, AS_IT_IS);
        }
        self.met.push(node);
        self.names.push(name.to_owned());
        self.places.insert(index, self.met.len() - 1);
        let own = Some(Carried { node: self.met.len() - 1, node_from_own: DAffine3::IDENTITY });
        [own, if is_still { by_outer } else { own }]
    }
}

/// A node that hangs on nothing.
fn moving(rest: NodePose, channels: Vec<Channel>) -> MovingNode {
    MovingNode { parent: None, parent_from_outer: DAffine3::IDENTITY, rest, channels }
}

/// A node of the document with its mesh.
fn with_mesh(document: &Document, node: usize) -> Option<(&Node, &GltfMesh)> {
    let node = document.nodes.get(node)?;
    Some((node, document.meshes.get(node.mesh?)?))
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

/// A primitive that a node carries.
pub(super) struct Piece<'a> {
    pub worn: Worn<'a>,
    /// From its own space, or from that of its pose where it follows joints, to that of the node.
    pub node_from_own: DAffine3,
    pub pose: Option<Rc<Pose>>,
    /// Whether its joints move each on its own.
    pub bends: bool,
}

/// The primitives that nodes carry.
#[derive(Default)]
pub(super) struct Parts<'a>(Vec<Vec<Piece<'a>>>);

impl<'a> Parts<'a> {
    /// Adds one, with the pose of its joints and whether these move each on its own.
    pub fn add(&mut self, worn: Worn<'a>, carried: Carried, posed: Option<(Rc<Pose>, bool)>) {
        if self.0.len() <= carried.node {
            self.0.resize_with(carried.node + 1, Vec::new);
        }
        let bends = posed.as_ref().is_some_and(|(_, bends)| *bends);
        let pose = posed.map(|(pose, _)| pose);
        self.0[carried.node].push(Piece { worn, node_from_own: carried.node_from_own, pose, bends });
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Makes meshes of the parts, hangs them and the cameras on the nodes that carry them, and gives the motion to the clip of the mesh. Parts that
    /// change their shape have so many shapes a second as `rate` says.
    pub fn hang(
        self,
        (movers, skins): (Movers, &Skins),
        cameras: Vec<Attached>,
        (clip, rate): (usize, Option<f64>),
        mesh: &mut Mesh,
        (accessors, coordinate_sets): (&Accessors, &[u32]),
    ) -> Result<(), Fault> {
        let times = Times::new(rate, mesh.clips[clip].seconds);
        let mut shaper = Shaper::new(accessors, skins, &movers, times, self.0.iter().map(Vec::as_slice));
        mesh.notes.extend(shaper.note());
        let world_from_file = DAffine3::from_mat3(UP);
        let (nodes, names) = (movers.met.clone(), &movers.names);
        let mut motion = NodeMotion { nodes, world_from_file, instances: Vec::new(), cameras, shapes: Vec::new() };
        let looks = looks(&motion);
        let (mut parts, mut known, mut stretched) = (MovingParts::default(), HashMap::new(), 0);
        for (node, primitives) in self.0.into_iter().enumerate().filter(|(_, primitives)| !primitives.is_empty()) {
            // What never has a size is never seen.
            let Some(shape) = looks.iter().find_map(|maps| shape_of(&maps[node].matrix3)) else { continue };
            let bits = |map: &DAffine3| map.to_cols_array().map(f64::to_bits);
            let of_primitive = |piece: &Piece| {
                let primitive = std::ptr::from_ref::<Primitive>(piece.worn.primitive);
                let weights: Vec<u32> = piece.worn.weights.iter().map(|weight| weight.to_bits()).collect();
                (primitive, weights, bits(&piece.node_from_own), piece.pose.as_ref().map(Rc::as_ptr))
            };
            let key =
                (primitives.iter().map(of_primitive).collect::<Vec<_>>(), shape.to_cols_array().map(f64::to_bits));
            let changes = primitives.iter().any(|piece| shaper.changes(piece));
            let part = match known.get(&key).filter(|_| !changes) {
                Some(&part) => part,
                None => {
                    let own = part_mesh(&primitives, &shape, mesh, accessors, coordinate_sets)?;
                    parts.changing.extend(shaper.changing(parts.meshes.len(), &primitives, (&shape, own.offset))?);
                    parts.meshes.push(own);
                    let count = parts.meshes.iter().map(|part| part.positions.len() as u64).sum::<u64>();
                    if count > accessors.limits.points {
                        return Err(Fault::limit("vertices", count, accessors.limits.points));
                    }
                    if !changes {
                        known.insert(key, parts.meshes.len() - 1);
                    }
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
    for Piece { worn, node_from_own, pose, .. } in primitives {
        let form = Form { weights: worn.weights, pose: pose.as_deref() };
        target.push(worn.primitive, accessors, &(DAffine3::from_mat3(*shape) * *node_from_own), form)?;
    }
    let offset = target.local_origin.offset();
    mesh.materials = std::mem::take(&mut part.materials);
    Ok(Mesh { offset, ..part })
}
