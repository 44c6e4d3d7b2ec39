//! Skins: meshes whose vertices follow the joints of a skeleton, each by shares (glTF 2.0, section 3.7.3.1). The joints are nodes, and stand where their
//! transforms put them, without an animation; the node that has the mesh does not move it.

use super::Fault;
use super::accessor::{Accessors, is_whole};
use super::document::{Document, Primitive};
use super::moving::{Carried, Movers};
use super::primitives::{Source, check_count};
use super::scene::local;
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

    /// How many change their shape while things move: each is seen as it is at rest.
    pub fn bent(&self) -> u64 {
        self.carriers.iter().filter(|carriers| carriers.is_bent).count() as u64
    }

    /// Primitives that joints place, with the pose of these, and what carries all of them where it was met.
    pub fn posed<'a>(
        &self,
        skinned: &[(&'a Primitive, usize)],
        accessors: &Accessors,
        movers: &Movers,
    ) -> Result<Vec<Posed<'a>>, Fault> {
        let mut known: HashMap<usize, Rc<Pose>> = HashMap::new();
        let mut posed = Vec::with_capacity(skinned.len());
        for &(primitive, skin) in skinned {
            let common = self.carriers.get(skin).and_then(|carriers| carriers.common);
            let carried = common.and_then(|node| movers.carrier(node));
            let pose = match known.get(&skin) {
                Some(pose) => Rc::clone(pose),
                None => Rc::new(self.pose(skin, common.filter(|_| carried.is_some()), accessors)?),
            };
            known.insert(skin, Rc::clone(&pose));
            posed.push((primitive, carried, pose));
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
        let map = |&joint: &usize| {
            let nodes = self.upwards(joint).take_while(|&node| Some(node) != carrier);
            nodes.fold(DAffine3::IDENTITY, |below, node| local(&document.nodes[node]) * below)
        };
        let mut maps: Vec<DAffine3> = joints.iter().map(map).collect();
        if let Some(inverse) = document.skins[skin].inverse_bind_matrices {
            let inverse = accessors.matrices(inverse, joints.len())?;
            if inverse.len() < joints.len() {
                return Err(fault(format!("has {} inverse bind matrices for {} joints", inverse.len(), joints.len())));
            }
            for (map, inverse) in maps.iter_mut().zip(inverse) {
                *map *= DAffine3::from_mat4(DMat4::from_cols_array(&inverse.map(f64::from)));
            }
        }
        if !maps.iter().all(DAffine3::is_finite) {
            return Err(fault("has joints or matrices that are not finite".into()));
        }
        Ok(Pose { skin, joints: maps })
    }
}

/// A primitive, what carries it, and the pose of its joints.
pub(super) type Posed<'a> = (&'a Primitive, Option<Carried>, Rc<Pose>);

/// Where the joints of a skin are.
pub(super) struct Pose {
    skin: usize,
    /// For each joint the map from the space of the mesh to that of what carries it, or to the world.
    joints: Vec<DAffine3>,
}

impl Pose {
    /// Whether most joints mirror what follows them.
    pub fn is_mirrored(&self) -> bool {
        let mirrored = self.joints.iter().filter(|joint| joint.matrix3.determinant() < 0.0).count();
        2 * mirrored > self.joints.len()
    }
}

/// Vertices that follow the joints of a pose.
pub(super) struct Bound<'a> {
    pose: &'a Pose,
    /// Four joints of each vertex and their shares, for each set of attributes.
    sets: Vec<[Vec<[f32; 4]>; 2]>,
}

impl<'a> Bound<'a> {
    /// What the attributes of a primitive say.
    pub fn read(pose: &'a Pose, primitive: &Primitive, source: &Source) -> Result<Self, Fault> {
        let attribute = |name: &str| primitive.attributes.get(name).copied();
        let mut sets = Vec::new();
        for set in 0.. {
            let (joints, weights) = (format!("JOINTS_{set}"), format!("WEIGHTS_{set}"));
            match (attribute(&joints), attribute(&weights)) {
                (None, None) => break,
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
                }
                (Some(_), None) => return Err(Fault::malformed(format!("{joints} without {weights}"))),
                (None, Some(_)) => return Err(Fault::malformed(format!("{weights} without {joints}"))),
            }
        }
        let bound = Self { pose, sets };
        for [joints, weights] in &bound.sets {
            check_count(joints.len(), bound.count())?;
            bound.check(joints.as_flattened(), weights.as_flattened())?;
        }
        Ok(bound)
    }

    fn check(&self, joints: &[f32], weights: &[f32]) -> Result<(), Fault> {
        let (count, skin) = (self.pose.joints.len(), self.pose.skin);
        if count == 0 {
            return Err(Fault::malformed(format!("skin {skin} has no joints")));
        }
        if weights.iter().any(|weight| !weight.is_finite()) {
            return Err(Fault::malformed("a vertex whose share in a joint is not finite"));
        }
        // A joint without a share may have any number.
        let is_wrong = |&(joint, weight): &(&f32, &f32)| *weight > 0.0 && *joint as usize >= count;
        match joints.iter().zip(weights).find(is_wrong) {
            Some((joint, _)) => {
                Err(Fault::malformed(format!("a vertex names joint {joint} of {count} of skin {skin}")))
            }
            None => Ok(()),
        }
    }

    /// How many vertices there are.
    pub fn count(&self) -> usize {
        self.sets.first().map_or(0, |[joints, _]| joints.len())
    }

    /// A vertex in the space of the pose.
    pub fn placed(&self, vertex: usize, [x, y, z, _]: [f32; 4]) -> DVec3 {
        let point = DVec3::new(x.into(), y.into(), z.into());
        let (mut sum, mut whole) = (DVec3::ZERO, 0.0);
        for [joints, weights] in &self.sets {
            let (Some(joints), Some(weights)) = (joints.get(vertex), weights.get(vertex)) else { continue };
            for (&joint, &weight) in joints.iter().zip(weights).filter(|&(_, &weight)| weight > 0.0) {
                sum += f64::from(weight) * self.pose.joints[joint as usize].transform_point3(point);
                whole += f64::from(weight);
            }
        }
        if whole > 0.0 {
            // Shares of bytes add up to one only nearly.
            return sum / whole;
        }
        // Nobody has a share: the first joint that is named has all, as other readers have it.
        let first = self.sets.first().and_then(|[joints, _]| joints.get(vertex)).map_or(0, |joints| joints[0] as usize);
        self.pose.joints[first.min(self.pose.joints.len() - 1)].transform_point3(point)
    }
}
