//! Skins: meshes whose vertices follow the joints of a skeleton, each by shares (glTF 2.0, section 3.7.3.1). The joints are nodes, and stand where their
//! transforms put them, without an animation or at a time; the node that has the mesh does not move it. A primitive without joints, or without shares in
//! them, has nothing but its node.

use super::Fault;
use super::accessor::{Accessors, is_whole};
use super::document::{Document, Primitive};
use super::moving::{Carried, Movers};
use super::primitives::{Source, check_count};
use super::scene::{Worn, local};
use glam::{DAffine3, DMat4, DVec3};
use std::collections::HashMap;
use std::rc::Rc;
use voxtrace_voxelize::Limits;

/// The skins of a document, and how the nodes that move carry them.
pub(super) struct Skins {
    /// The parent of each node; empty where there are no skins.
    parents: Vec<Option<usize>>,
    /// Most nodes above one another.
    most: usize,
    /// Of each skin.
    carriers: Vec<Carriers>,
}

/// The nodes that move and carry the joints of a skin.
#[derive(Default)]
struct Carriers {
    /// The innermost one that carries all joints, by its index in the document.
    common: Option<usize>,
    /// Whether some joints move and others do not, or otherwise, and a node wears the skin.
    is_bent: bool,
}

impl Skins {
    /// Those of a document, of which no node that moves was met yet.
    pub fn of(document: &Document, limits: &Limits, movers: &Movers) -> Self {
        let most = limits.depth as usize + 1;
        if document.skins.is_empty() {
            return Self { parents: Vec::new(), most, carriers: Vec::new() };
        }
        let mut parents = vec![None; document.nodes.len()];
        for (index, node) in document.nodes.iter().enumerate() {
            for &child in &node.children {
                if let Some(parent) = parents.get_mut(child) {
                    *parent = Some(index);
                }
            }
        }
        let mut skins = Self { parents, most, carriers: Vec::new() };
        let mut is_worn = vec![false; document.skins.len()];
        for skin in document.nodes.iter().filter(|node| node.mesh.is_some()).filter_map(|node| node.skin) {
            is_worn.get_mut(skin).into_iter().for_each(|worn| *worn = true);
        }
        let carriers =
            document.skins.iter().zip(is_worn).map(|(skin, is_worn)| {
                if is_worn { skins.carriers_of(&skin.joints, movers) } else { Carriers::default() }
            });
        skins.carriers = carriers.collect();
        skins
    }

    fn carriers_of(&self, joints: &[usize], movers: &Movers) -> Carriers {
        // Outermost first.
        let chain = |&joint: &usize| {
            let mut chain: Vec<usize> = self.upwards(joint).filter(|&node| movers.awaits(node)).collect();
            chain.reverse();
            chain
        };
        let mut chains = joints.iter().map(chain);
        let (mut common, mut is_bent) = (chains.next().unwrap_or_default(), false);
        for chain in chains {
            let same = common.iter().zip(&chain).take_while(|(a, b)| a == b).count();
            is_bent |= same < common.len().max(chain.len());
            common.truncate(same);
        }
        Carriers { common: common.last().copied(), is_bent }
    }

    /// A node and those above it, one more than there may be where there are too many: a node may be its own ancestor.
    fn upwards(&self, node: usize) -> impl Iterator<Item = usize> {
        let above = std::iter::successors(Some(node), |&node| self.parents.get(node).copied().flatten());
        above.take(self.most + 1)
    }

    /// Primitives that joints place, with the pose of these, and what carries all of them where it was met.
    pub fn posed<'a>(
        &self,
        skinned: &[(Worn<'a>, usize)],
        accessors: &Accessors,
        movers: &Movers,
    ) -> Result<Vec<Posed<'a>>, Fault> {
        let mut known: HashMap<usize, Rc<Pose>> = HashMap::new();
        let mut posed = Vec::with_capacity(skinned.len());
        for &(worn, skin) in skinned {
            let carriers = self.carriers.get(skin);
            let common = carriers.and_then(|carriers| carriers.common);
            let carried = common.and_then(|node| movers.carrier(node));
            // What moves all joints outside of the scene carries nothing.
            let bends = carriers.is_some_and(|carriers| carriers.is_bent) || (common.is_some() && carried.is_none());
            let pose = match known.get(&skin) {
                Some(pose) => Rc::clone(pose),
                None => Rc::new(self.pose(skin, common.filter(|_| carried.is_some()), accessors)?),
            };
            known.insert(skin, Rc::clone(&pose));
            posed.push(Posed { worn, carried, pose, bends });
        }
        Ok(posed)
    }

    /// The pose of a skin at rest, in the space of the node that carries it, else in the world.
    fn pose(&self, skin: usize, carrier: Option<usize>, accessors: &Accessors) -> Result<Pose, Fault> {
        let fault = |what: String| Fault::malformed(format!("skin {skin} {what}"));
        let document = accessors.document;
        let joints = &document.skins.get(skin).ok_or_else(|| fault("is missing".into()))?.joints;
        if let Some(joint) = joints.iter().find(|&&joint| joint >= document.nodes.len()) {
            return Err(fault(format!("has node {joint} for a joint, which is missing")));
        }
        if let Some(joint) = joints.iter().find(|&&joint| self.upwards(joint).count() > self.most) {
            return Err(fault(format!("has node {joint} for a joint, which has more than {} above it", self.most - 1)));
        }
        let inverse = match document.skins[skin].inverse_bind_matrices {
            Some(inverse) => accessors.matrices(inverse, joints.len())?,
            None => vec![DMat4::IDENTITY.as_mat4().to_cols_array(); joints.len()],
        };
        if inverse.len() < joints.len() {
            return Err(fault(format!("has {} inverse bind matrices for {} joints", inverse.len(), joints.len())));
        }
        let inverse = inverse.into_iter().map(|own| DAffine3::from_mat4(DMat4::from_cols_array(&own.map(f64::from))));
        let mut pose = Pose { skin, carrier, joints: Vec::new(), inverse: inverse.collect() };
        pose.joints = self.joints(&pose, document, &|node| local(&document.nodes[node]));
        if !pose.joints.iter().all(DAffine3::is_finite) {
            return Err(fault("has joints or matrices that are not finite".into()));
        }
        Ok(pose)
    }

    /// The joints of a pose as [`Pose::joints`] has them, with other places of nodes in those above them.
    pub fn joints(&self, pose: &Pose, document: &Document, local: &dyn Fn(usize) -> DAffine3) -> Vec<DAffine3> {
        let map = |(&joint, inverse): (&usize, &DAffine3)| {
            let nodes = self.upwards(joint).take_while(|&node| Some(node) != pose.carrier);
            nodes.fold(DAffine3::IDENTITY, |below, node| local(node) * below) * *inverse
        };
        document.skins[pose.skin].joints.iter().zip(&pose.inverse).map(map).collect()
    }
}

/// A primitive that joints place.
pub(super) struct Posed<'a> {
    pub worn: Worn<'a>,
    /// The node that moves and carries all of the joints, where one does.
    pub carried: Option<Carried>,
    /// Where the joints are at rest.
    pub pose: Rc<Pose>,
    /// Whether they move each on its own.
    pub bends: bool,
}

/// Where the joints of a skin are.
pub(super) struct Pose {
    skin: usize,
    /// The node that carries them, by its index in the document.
    carrier: Option<usize>,
    /// For each joint the map from the space of the mesh to that of what carries it, or to the world.
    joints: Vec<DAffine3>,
    /// For each joint the map from the space of the mesh to its own, as the mesh was bound.
    inverse: Vec<DAffine3>,
}

/// Whether joints place a primitive.
pub(super) fn is_bound(primitive: &Primitive) -> bool {
    ["JOINTS_0", "WEIGHTS_0"].iter().all(|name| primitive.attributes.contains_key(*name))
}

/// Whether a primitive has joints without shares in them, or shares without joints.
pub(super) fn lacks_half(primitive: &Primitive) -> bool {
    let has = |name: &str| primitive.attributes.contains_key(name);
    has("JOINTS_0") != has("WEIGHTS_0")
}

impl Pose {
    /// For each joint the map from the space of the mesh to that of what carries it, or to the world, at rest.
    pub fn joints(&self) -> &[DAffine3] {
        &self.joints
    }

    /// Whether most joints mirror what follows them.
    pub fn is_mirrored(&self) -> bool {
        let mirrored = self.joints.iter().filter(|joint| joint.matrix3.determinant() < 0.0).count();
        2 * mirrored > self.joints.len()
    }
}

/// Vertices that follow joints.
#[derive(Debug)]
pub(super) struct Bound {
    /// Four joints of each vertex and their shares, for each set of attributes.
    sets: Vec<[Vec<[f32; 4]>; 2]>,
}

impl Bound {
    /// What the attributes of a primitive say about the joints of a pose. A set without joints or without shares, and those after it, are left out.
    pub fn read(pose: &Pose, primitive: &Primitive, source: &Source) -> Result<Self, Fault> {
        let attribute = |name: &str| primitive.attributes.get(name).copied();
        let mut sets = Vec::new();
        for set in 0.. {
            let (joints, weights) = (format!("JOINTS_{set}"), format!("WEIGHTS_{set}"));
            match (attribute(&joints), attribute(&weights)) {
                (None, _) | (_, None) => break,
                (Some(at_joints), Some(at_weights)) => {
                    let accessor = source.accessors.of_kinds(at_joints, &["VEC4"])?;
                    if !is_whole(accessor.component_type) || accessor.normalized {
                        return Err(Fault::malformed(format!("{joints} holds no indices")));
                    }
                    let read = |name: &str, index: usize| {
                        let mut vectors = Vec::new();
                        source.vectors(name, index, &["VEC4"], 0.0, |vector| vectors.push(vector))?;
                        Ok::<_, Fault>(vectors)
                    };
                    let (own_joints, own_weights) = (read(&joints, at_joints)?, read(&weights, at_weights)?);
                    check_count(own_weights.len(), own_joints.len())?;
                    sets.push([own_joints, own_weights]);
                    // A small file may name one array many times.
                    let (all, limit) = (accessor.count as u64 * sets.len() as u64, source.accessors.limits.points);
                    if all > limit {
                        return Err(Fault::limit("joints of vertices", all, limit));
                    }
                }
            }
        }
        let bound = Self { sets };
        for [joints, weights] in &bound.sets {
            check_count(joints.len(), bound.count())?;
            check(pose, joints.as_flattened(), weights.as_flattened())?;
        }
        Ok(bound)
    }

    /// How many vertices there are.
    pub fn count(&self) -> usize {
        self.sets.first().map_or(0, |[joints, _]| joints.len())
    }

    /// How many vertices all sets have together.
    pub fn size(&self) -> usize {
        self.sets.len() * self.count()
    }

    /// A vertex in the space of the joints.
    pub fn placed(&self, vertex: usize, point: DVec3, places: &[DAffine3]) -> DVec3 {
        let (mut sum, mut whole) = (DVec3::ZERO, 0.0);
        for [joints, weights] in &self.sets {
            let (Some(joints), Some(weights)) = (joints.get(vertex), weights.get(vertex)) else { continue };
            for (&joint, &weight) in joints.iter().zip(weights).filter(|&(_, &weight)| weight > 0.0) {
                sum += f64::from(weight) * places[joint as usize].transform_point3(point);
                whole += f64::from(weight);
            }
        }
        if whole > 0.0 {
            // Shares of bytes add up to one only nearly.
            return sum / whole;
        }
        // Nobody has a share: the first joint that is named has all, as other readers have it.
        let first = self.sets.first().and_then(|[joints, _]| joints.get(vertex)).map_or(0, |joints| joints[0] as usize);
        places[first.min(places.len() - 1)].transform_point3(point)
    }
}

/// Whether joints and shares of vertices are sound.
fn check(pose: &Pose, joints: &[f32], weights: &[f32]) -> Result<(), Fault> {
    let (count, skin) = (pose.joints.len(), pose.skin);
    if count == 0 {
        return Err(Fault::malformed(format!("skin {skin} has no joints")));
    }
    if weights.iter().any(|weight| !weight.is_finite()) {
        return Err(Fault::malformed("a vertex whose share in a joint is not finite"));
    }
    // A joint without a share may have any number.
    let is_wrong = |&(joint, weight): &(&f32, &f32)| *weight > 0.0 && *joint as usize >= count;
    match joints.iter().zip(weights).find(is_wrong) {
        Some((joint, _)) => Err(Fault::malformed(format!("a vertex names joint {joint} of {count} of skin {skin}"))),
        None => Ok(()),
    }
}
