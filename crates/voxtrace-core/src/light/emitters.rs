//! Emissive voxels as lights: a stochastic descent of the tree over instances, then, in the space of the grid, of the tree
//! over its emitters, each node weighed by what it can send at most (Conty Estevez and Kulla, "Importance Sampling of Many
//! Lights with Adaptive Tree Splitting", HPG 2018), then a face of the leaf, then a point of the face. Nothing on the way is divided, and
//! no root is taken: with the same bits on every device they took most of the time that light takes.

use super::{LightSample, Receiver};
use crate::math::{inverse_power_of_two, normalize, reciprocal_guess};
use crate::packed::{Emitter, Geometry, LightNode, PackedInstance, PackedMaterial, PackedScene};
use crate::surface::offset_ray_origin;
use glam::{IVec3, Vec3};
use voxtrace_scene::ray::{FACES, Face, Hit, Ray};

/// An upper bound, of at most 1.23 times, of the length of a vector whose components have these absolute values.
fn length_bound(absolute: Vec3) -> f32 {
    (absolute.max_element() + (absolute.x + absolute.y + absolute.z)) * 0.5
}

/// What the emitters of a node can send to the receiver: an upper bound of their cosines over their squared distance,
/// which is not taken below the squared radius of their box. It is 0 only where nothing can arrive. Node and receiver are in
/// the same space.
fn node_importance(node: &LightNode, receiver: &Receiver) -> f32 {
    let half = (node.max - node.min) * 0.5;
    let toward = (node.min + node.max) * 0.5 - receiver.point;
    let normal = receiver.normal;
    let above = toward.dot(normal) + half.dot(normal.abs()) + receiver.slack;
    if above <= 0.0 {
        return 0.0;
    }
    let (far, near) = (toward.length_squared(), half.length_squared());
    let distance = length_bound(if far > near { toward.abs() } else { half });
    // How far the point lies in front of the foremost face that looks along each direction: at most, per emitter.
    let beyond_min = (receiver.point - node.min).max(Vec3::ZERO).min(Vec3::splat(distance));
    let beyond_max = (node.max - receiver.point).max(Vec3::ZERO).min(Vec3::splat(distance));
    let power = &node.power;
    let sent = (power[0] * beyond_max.x + power[1] * beyond_min.x)
        + (power[2] * beyond_max.y + power[3] * beyond_min.y)
        + (power[4] * beyond_max.z + power[5] * beyond_min.z);
    let falloff = reciprocal_guess(far.max(near));
    sent * above.min(distance) * (falloff * falloff)
}

/// What the faces of an emitter along each axis can send, as [`node_importance`], of which one at most can look at the receiver, in its grid
/// space; 0 for covered ones and those that look away.
fn face_importances(emitter: &Emitter, receiver: &Receiver) -> Vec3 {
    let toward = emitter.voxel.as_vec3() + 0.5 - receiver.point;
    let (aside, normal) = (toward.abs(), receiver.normal);
    let in_front = aside - 0.5;
    let (nearest, squares) = (in_front * in_front, aside * aside);
    // The middle of a face is nearer by half a voxel than that of the emitter; its highest corner is half of one aside along the others.
    let middle = toward.dot(normal) + receiver.slack;
    let height = normal.abs() * 0.5;
    let highest = height.x + height.y + height.z;
    let bound = length_bound(aside);
    let importance = |axis: usize| {
        let is_upper = toward[axis] < 0.0;
        let nearer = if is_upper { normal[axis] } else { -normal[axis] } * 0.5;
        let above = middle + nearer + (highest - height[axis]);
        let is_free = emitter.faces >> (2 * axis + usize::from(is_upper)) & 1 != 0;
        if !is_free || in_front[axis] <= 0.0 || above <= 0.0 {
            return 0.0;
        }
        let distance_squared = nearest[axis] + (squares[(axis + 1) % 3] + squares[(axis + 2) % 3]);
        let falloff = reciprocal_guess(distance_squared.max(0.5));
        emitter.luminance * in_front[axis] * above.min(bound) * (falloff * falloff)
    };
    Vec3::new(importance(0), importance(1), importance(2))
}

/// Sum of the importances of an emitter's faces.
fn sum_of(importances: Vec3) -> f32 {
    importances.x + importances.y + importances.z
}

/// Weights of two children with the ratio of their importances, whose sum is in [1, 2); `None` where neither can send anything.
fn weights_of(left: f32, right: f32) -> Option<[f32; 2]> {
    // Devices may take smaller numbers for zero.
    let normal_or_zero = |weight: f32| if weight < f32::MIN_POSITIVE { 0.0 } else { weight };
    let (left, right) = (normal_or_zero(left), normal_or_zero(right));
    let unit = inverse_power_of_two(left + right);
    (left + right > 0.0).then(|| [normal_or_zero(left * unit), normal_or_zero(right * unit)])
}

/// Luminance of the irradiance of all emitters together, as far as the root of their tree tells: at most, for each of them.
fn importance_of_all(scene: &PackedScene, receiver: &Receiver) -> f32 {
    let root = scene.placement.light_nodes.first();
    root.map_or(0.0, |root| node_importance(root, receiver) * scene.light_intensity)
}

/// A way down the trees.
#[derive(Clone, Copy)]
pub(super) struct Descent {
    pub node: u32,
    /// Inner node: its right child. Leaf: the first of `count` emitters, or the instance.
    pub index: u32,
    pub count: u32,
    /// The probability of the way is the quotient of these two.
    pub weight: f32,
    pub total: f32,
    /// What is left of the random number, times `weight`.
    pub choice: f32,
}

impl Descent {
    /// Begins at the top, with a random number in [0, 1).
    fn begin(choice: f32) -> Self {
        Self { node: 0, index: 0, count: 0, weight: 1.0, total: 1.0, choice }
    }

    /// Goes on at a root.
    fn at(self, root: u32, nodes: &[LightNode]) -> Option<Self> {
        let LightNode { index, count, .. } = *nodes.get(root as usize)?;
        Some(Self { node: root, index, count, ..self })
    }
}

/// Goes down to a leaf: by the random number, or to the one with the emitter at `voxel`. `None` where nothing can be sent.
fn descend(nodes: &[LightNode], receiver: &Receiver, voxel: Option<IVec3>, mut descent: Descent) -> Option<Descent> {
    while descent.count == 0 {
        let (left, right) = (&nodes[descent.node as usize + 1], &nodes[descent.index as usize]);
        let weights = weights_of(node_importance(left, receiver), node_importance(right, receiver))?;
        let total = weights[0] + weights[1];
        let is_left = match voxel.map(IVec3::as_vec3) {
            // Emitters of two children lie on two sides of a plane.
            Some(low) => low.cmpge(left.min).all() && low.cmplt(left.max).all(),
            None => weights[1] <= 0.0 || descent.choice * total < weights[0] * descent.weight,
        };
        descent.choice = descent.choice * total - if is_left { 0.0 } else { weights[0] * descent.weight };
        descent.node = if is_left { descent.node + 1 } else { descent.index };
        let child = if is_left { left } else { right };
        (descent.index, descent.count) = (child.index, child.count);
        descent.weight *= weights[usize::from(!is_left)];
        descent.total *= total;
        if descent.weight <= 0.0 {
            return None;
        }
    }
    Some(descent)
}

/// `descent` with the weights of coming from the root to the leaf of an instance. `None` where [`descend`] never does.
fn climb(nodes: &[LightNode], receiver: &Receiver, start: u32, mut descent: Descent) -> Option<Descent> {
    let mut at = start;
    let mut node = &nodes[start as usize];
    while node.parent != LightNode::NONE {
        let up = node.parent;
        let parent = &nodes[up as usize];
        let is_left = at == up + 1;
        let sibling = &nodes[if is_left { parent.index } else { up + 1 } as usize];
        let (left, right) = if is_left { (node, sibling) } else { (sibling, node) };
        let weights = weights_of(node_importance(left, receiver), node_importance(right, receiver))?;
        descent.weight *= weights[usize::from(!is_left)];
        descent.total *= weights[0] + weights[1];
        (at, node) = (up, parent);
    }
    (descent.weight > 0.0).then_some(descent)
}

/// The receiver in the grid space of an instance.
#[inline]
pub(super) fn in_grid(instance: &PackedInstance, receiver: &Receiver) -> Receiver {
    let point = instance.grid_from_world.point(receiver.point);
    if receiver.slack > 0.0 {
        return Receiver { point, ..*receiver };
    }
    Receiver { point, normal: normalize(instance.grid_from_world.direction(receiver.normal)), slack: 0.0 }
}

/// The emitters of the leaf that was come to.
fn emitters_of<'a>(geometry: &'a Geometry, leaf: &Descent) -> &'a [Emitter] {
    &geometry.emitters[leaf.index as usize..(leaf.index + leaf.count) as usize]
}

/// Chooses an instance, then a leaf of its grid's tree, then a face of one of its emitters, then a point of the face.
fn sample_emitter(scene: &PackedScene, intensity: f32, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
    let (geometry, placement) = (&*scene.geometry, &scene.placement);
    let (top, nodes) = (&placement.light_nodes, &geometry.light_nodes);
    let above = descend(top, receiver, None, Descent::begin(u[0]).at(0, top)?)?;
    let instance = &placement.instances[above.index as usize];
    let local = in_grid(instance, receiver);
    let leaf = descend(nodes, &local, None, above.at(top[above.node as usize].root, nodes)?)?;
    let emitters = emitters_of(geometry, &leaf);
    let sum: f32 = emitters.iter().fold(0.0, |sum, emitter| sum + sum_of(face_importances(emitter, &local)));
    let (emitter, axis, importance) = choose_face(emitters, &local, u[1] * sum)?;
    let emitter_tree = EmitterTree { scene, intensity };
    emitter_sample(&emitter_tree, receiver, (above.index, local.point), leaf, (emitter, axis, importance, sum), u)
}

/// Chooses a point of a face by `u[2]` and `u[3]`: of an emitter of the leaf that was come to, which is one of an instance, for the receiver, whose point is
/// also that in the space of the grid. The face has this axis and this importance of the leaf's sum.
#[inline]
pub(super) fn emitter_sample(
    tree: &EmitterTree,
    receiver: &Receiver,
    (instance, point): (u32, Vec3),
    leaf: Descent,
    (emitter, axis, importance, sum): (&Emitter, usize, f32, f32),
    u: [f32; 4],
) -> Option<LightSample> {
    let (geometry, instance) = (&*tree.scene.geometry, &tree.scene.placement.instances[instance as usize]);
    let low = emitter.voxel.as_vec3();
    let face = FACES[2 * axis + usize::from(low[axis] + 0.5 < point[axis])];
    let on_face = point_of_face(low, face, u[2], u[3]);
    let pdf = density(leaf, (importance, sum), on_face - point, face)?;
    let target = instance.world_from_grid.point(offset_ray_origin(instance, low, face, on_face));
    let direction = target - receiver.point;
    let cos_theta = receiver.normal.dot(direction) / direction.length_squared().sqrt() + receiver.slack;
    let ray = Ray { t_max: 1.0, ..Ray::new(receiver.point, direction) };
    let radiance = geometry.materials[emitter.material as usize].surface_emission() * tree.intensity;
    (cos_theta > 0.0).then_some(LightSample { ray, cos_theta, radiance, pdf })
}

/// The emitter and the axis of the face at which the running sum of importances passes `threshold`, and the face's importance; `None` where all
/// are 0.
fn choose_face<'a>(emitters: &'a [Emitter], receiver: &Receiver, threshold: f32) -> Option<(&'a Emitter, usize, f32)> {
    let (mut passed, mut chosen) = (0.0, None);
    for emitter in emitters {
        let importances = face_importances(emitter, receiver);
        let sum = sum_of(importances);
        if sum > 0.0 {
            let axis = choose_axis(importances, threshold - passed);
            chosen = Some((emitter, axis, importances[axis]));
            passed += sum;
            if threshold < passed {
                return chosen;
            }
        }
    }
    chosen
}

/// The axis at which the running sum of importances, not all of them 0, passes `threshold`.
fn choose_axis(importances: Vec3, threshold: f32) -> usize {
    if threshold < importances.x {
        0
    } else if threshold < importances.x + importances.y {
        1
    } else if importances.z > 0.0 {
        2
    } else {
        usize::from(importances.y > 0.0)
    }
}

/// The point of a face of the voxel with the lowest corner `low`, for `u` and `v` uniform in [0, 1).
fn point_of_face(low: Vec3, face: Face, u: f32, v: f32) -> Vec3 {
    let away = if face as u32 & 1 == 1 { 1.0 } else { 0.0 };
    low + match face.axis() {
        0 => Vec3::new(away, u, v),
        1 => Vec3::new(u, away, v),
        _ => Vec3::new(u, v, away),
    }
}

/// Density over solid angle of a point of a face, to which `toward` leads from the receiver in grid space, where faces have an area of 1; the
/// face has this importance of the leaf's sum. `None` behind the face. Solid angles are the same in grid and world space, as instances keep
/// angles.
fn density(leaf: Descent, (importance, sum): (f32, f32), toward: Vec3, face: Face) -> Option<f32> {
    let in_front = if face as u32 & 1 == 1 { -toward[face.axis()] } else { toward[face.axis()] };
    let distance_squared = toward.length_squared();
    // In units of the sum: the product of small numbers may be too small.
    let unit = inverse_power_of_two(sum);
    let share = leaf.weight * (importance * unit) * (distance_squared * distance_squared.sqrt());
    (in_front > 0.0).then(|| share / (leaf.total * (sum * unit) * in_front))
}

/// Density over solid angle with which [`sample_emitter`] chooses the point that `ray`, which starts at the receiver, met; 0 where it never does.
fn emitter_pdf(scene: &PackedScene, receiver: &Receiver, ray: &Ray, hit: &Hit) -> f32 {
    pdf_of_hit(scene, receiver, ray, hit).unwrap_or(0.0)
}

fn pdf_of_hit(scene: &PackedScene, receiver: &Receiver, ray: &Ray, hit: &Hit) -> Option<f32> {
    let (geometry, placement) = (&*scene.geometry, &scene.placement);
    let instance = &placement.instances[hit.instance as usize];
    if instance.light_leaf == LightNode::NONE {
        return None;
    }
    let above = climb(&placement.light_nodes, receiver, instance.light_leaf, Descent::begin(0.0))?;
    let (face, local) = (hit.face(), in_grid(instance, receiver));
    let nodes = &geometry.light_nodes;
    let root = placement.light_nodes[instance.light_leaf as usize].root;
    let leaf = descend(nodes, &local, Some(hit.voxel), above.at(root, nodes)?)?;
    let (mut own, mut sum) = (0.0, 0.0);
    for emitter in emitters_of(geometry, &leaf) {
        let importances = face_importances(emitter, &local);
        sum += sum_of(importances);
        if emitter.voxel == hit.voxel {
            own = importances[face.axis()];
        }
    }
    let middle = hit.voxel.as_vec3() + 0.5 - local.point;
    let looks_here = (middle[face.axis()] < 0.0) == (face as u32 & 1 == 1);
    if !looks_here || own <= 0.0 {
        return None;
    }
    let toward = instance.grid_from_world.direction(ray.direction) * hit.t;
    density(leaf, (own, sum), toward, face)
}

/// Radiance that a material emits in this scene.
#[inline]
pub fn emitted(scene: &PackedScene, material: &PackedMaterial) -> Vec3 {
    material.emission * scene.light_intensity
}

/// The emissive voxels of a scene as a light.
#[derive(Clone, Copy, Debug)]
pub struct EmitterTree<'a> {
    /// The scene.
    pub scene: &'a PackedScene,
    /// Factor on every material's emission: the scene's, or 0 where this light is left out, which changes nothing about its choice.
    pub intensity: f32,
}

impl EmitterTree<'_> {
    /// Chooses a point of an emitter for `receiver` by `u`, each uniform in [0, 1): `u[0]` down the tree, `u[1]` within the leaf, `u[2]` and
    /// `u[3]` on the face. `None` where no emitter can be seen, and sometimes otherwise.
    #[inline]
    pub fn sample(&self, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
        sample_emitter(self.scene, self.intensity, receiver, u)
    }

    /// Density over solid angle with which [`Self::sample`] chooses the point that `ray`, which starts at the receiver, met; 0 where it
    /// never does.
    #[inline]
    pub fn pdf(&self, receiver: &Receiver, ray: &Ray, hit: &Hit) -> f32 {
        emitter_pdf(self.scene, receiver, ray, hit)
    }

    /// Radiance from a surface of `material`.
    #[inline]
    pub fn le(&self, material: &PackedMaterial) -> Vec3 {
        material.surface_emission() * self.intensity
    }

    /// Luminance of the irradiance of all emitters together, as far as the root of their tree tells: at most, for each of them.
    #[inline]
    pub fn importance(&self, receiver: &Receiver) -> f32 {
        importance_of_all(self.scene, receiver)
    }
}
