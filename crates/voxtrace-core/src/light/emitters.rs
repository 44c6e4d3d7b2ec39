//! Emissive voxels as lights: a stochastic descent of the tree over instances, then, in the space of the grid, of the tree
//! over its emitters, each node weighed by what it can send at most (Conty Estevez and Kulla, "Importance Sampling of Many
//! Lights with Adaptive Tree Splitting", HPG 2018), then a face of the leaf, then a point of the face.

use super::{BELOW_ONE, LightSample, Receiver};
use crate::math::normalize;
use crate::packed::{
    Emitter, Geometry, LEAF_EMITTERS, LightNode, PackedInstance, PackedMaterial, PackedScene, morton_order,
};
use crate::surface::{faces_of, offset_ray_origin};
use glam::Vec3;
use voxtrace_scene::ray::{Face, Hit, Ray};

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
    let distance_squared = toward.length_squared().max(half.length_squared());
    let distance = distance_squared.sqrt();
    // How far the point lies in front of the foremost face that looks along each direction: at most, per emitter.
    let beyond_min = (receiver.point - node.min).max(Vec3::ZERO).min(Vec3::splat(distance));
    let beyond_max = (node.max - receiver.point).max(Vec3::ZERO).min(Vec3::splat(distance));
    let power = &node.power;
    let sent = (power[0] * beyond_max.x + power[1] * beyond_min.x)
        + (power[2] * beyond_max.y + power[3] * beyond_min.y)
        + (power[4] * beyond_max.z + power[5] * beyond_min.z);
    sent * above.min(distance) / (distance_squared * distance_squared)
}

/// What a face of an emitter can send, as [`node_importance`]; the receiver in the emitter's grid space.
fn face_importance(emitter: &Emitter, face: Face, receiver: &Receiver) -> f32 {
    let (axis, sign) = (face.axis(), if face as u32 & 1 == 1 { 1.0 } else { -1.0 });
    let mut toward = emitter.voxel.as_vec3() + 0.5 - receiver.point;
    toward[axis] += 0.5 * sign;
    let in_front = -toward[axis] * sign;
    let mut half = Vec3::splat(0.5);
    half[axis] = 0.0;
    let above = toward.dot(receiver.normal) + half.dot(receiver.normal.abs()) + receiver.slack;
    if in_front <= 0.0 || above <= 0.0 {
        return 0.0;
    }
    let distance_squared = toward.length_squared().max(0.5);
    let distance = distance_squared.sqrt();
    emitter.luminance * in_front.min(distance) * above.min(distance) / (distance_squared * distance_squared)
}

/// The free faces of an emitter that can look at the receiver, in its grid space: at most one along each axis. Bit f is face f.
fn faces_toward(emitter: &Emitter, receiver: &Receiver) -> u32 {
    let toward = emitter.voxel.as_vec3() + 0.5 - receiver.point;
    let along = |axis: usize| if toward[axis] < 0.0 { 2 } else { 1 } << (2 * axis);
    emitter.faces & (along(0) | along(1) | along(2))
}

/// Probability of going left at an inner node between children of these importances; `None` where neither side can send anything.
fn left_probability(to_left: f32, to_right: f32) -> Option<f32> {
    (to_left + to_right > 0.0).then(|| to_left / (to_left + to_right))
}

/// The importances of the faces of a leaf's emitters, and their sum; 0 for covered faces and those that look away.
fn leaf_importances(emitters: &[Emitter], receiver: &Receiver) -> ([[f32; 6]; LEAF_EMITTERS], f32) {
    let (mut importances, mut sum) = ([[0.0; 6]; LEAF_EMITTERS], 0.0);
    for (emitter, importances) in emitters.iter().zip(&mut importances) {
        for face in faces_of(faces_toward(emitter, receiver)) {
            importances[face as usize] = face_importance(emitter, face, receiver);
            sum += importances[face as usize];
        }
    }
    (importances, sum)
}

/// Luminance of the irradiance of all emitters together, as far as the root of their tree tells: at most, for each of them.
fn importance_of_all(scene: &PackedScene, receiver: &Receiver) -> f32 {
    let root = scene.placement.light_nodes.first();
    root.map_or(0.0, |root| node_importance(root, receiver) * scene.light_intensity)
}

/// A way down a tree: where it is, what is left of the random number, and how likely it was.
#[derive(Clone, Copy)]
struct Descent {
    node: u32,
    choice: f32,
    probability: f32,
}

/// Goes down to a leaf. `None` where nothing can be sent.
fn descend(nodes: &[LightNode], receiver: &Receiver, from: Descent) -> Option<Descent> {
    let mut descent = from;
    let root = nodes.get(descent.node as usize)?;
    let (mut index, mut count) = (root.index, root.count);
    while count == 0 {
        let (left_child, right_child) = (&nodes[descent.node as usize + 1], &nodes[index as usize]);
        let left = left_probability(node_importance(left_child, receiver), node_importance(right_child, receiver))?;
        if descent.choice < left {
            descent.node += 1;
            descent.choice /= left;
            descent.probability *= left;
            (index, count) = (left_child.index, left_child.count);
        } else {
            let right = 1.0 - left;
            descent.node = index;
            descent.choice = (descent.choice - left) / right;
            descent.probability *= right;
            (index, count) = (right_child.index, right_child.count);
        }
        descent.choice = descent.choice.min(BELOW_ONE);
    }
    Some(descent)
}

/// `probability` times that of coming from the root to a node. `None` where [`descend`] never does.
fn climb(nodes: &[LightNode], receiver: &Receiver, start: u32, mut probability: f32) -> Option<f32> {
    let mut at = start;
    let mut node = &nodes[start as usize];
    while node.parent != LightNode::NONE {
        let up = node.parent;
        let parent = &nodes[up as usize];
        let is_left = at == up + 1;
        let sibling = &nodes[if is_left { parent.index } else { up + 1 } as usize];
        let (own, other) = (node_importance(node, receiver), node_importance(sibling, receiver));
        let (to_left, to_right) = if is_left { (own, other) } else { (other, own) };
        let left = left_probability(to_left, to_right)?;
        probability *= if is_left { left } else { 1.0 - left };
        (at, node) = (up, parent);
    }
    Some(probability)
}

/// The receiver in the grid space of an instance.
fn in_grid(instance: &PackedInstance, receiver: &Receiver) -> Receiver {
    let point = instance.grid_from_world.point(receiver.point);
    if receiver.slack > 0.0 {
        return Receiver { point, ..*receiver };
    }
    Receiver { point, normal: normalize(instance.grid_from_world.direction(receiver.normal)), slack: 0.0 }
}

fn leaf_emitters<'a>(geometry: &'a Geometry, leaf: &LightNode) -> &'a [Emitter] {
    &geometry.emitters[leaf.index as usize..(leaf.index + leaf.count) as usize]
}

/// Chooses an instance, then a leaf of its grid's tree, then a face of one of its emitters, then a point of the face.
fn sample_emitter(scene: &PackedScene, intensity: f32, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
    let (geometry, placement) = (&*scene.geometry, &scene.placement);
    let start = Descent { node: 0, choice: u[0], probability: 1.0 };
    let above = descend(&placement.light_nodes, receiver, start)?;
    let top = &placement.light_nodes[above.node as usize];
    let instance = &placement.instances[top.index as usize];
    let local = in_grid(instance, receiver);
    let Descent { node, probability, .. } =
        descend(&geometry.light_nodes, &local, Descent { node: top.root, ..above })?;
    let emitters = leaf_emitters(geometry, &geometry.light_nodes[node as usize]);
    let (importances, sum) = leaf_importances(emitters, &local);
    let (emitter, face, importance) = choose_face(emitters, &importances, u[1] * sum)?;
    let probability = probability * (importance / sum);

    let low = emitter.voxel.as_vec3();
    let on_face = point_of_face(low, face, u[2], u[3]);
    let pdf = probability * face_pdf(on_face - local.point, face)?;
    let target = instance.world_from_grid.point(offset_ray_origin(instance, low, face, on_face));
    let direction = target - receiver.point;
    let cos_theta = receiver.normal.dot(direction) / direction.length_squared().sqrt() + receiver.slack;
    let ray = Ray { t_max: 1.0, ..Ray::new(receiver.point, direction) };
    let radiance = geometry.materials[emitter.material as usize].surface_emission() * intensity;
    (cos_theta > 0.0).then_some(LightSample { ray, cos_theta, radiance, pdf })
}

/// The face at which the running sum of importances passes `threshold`; `None` where all are 0.
fn choose_face<'a>(
    emitters: &'a [Emitter],
    importances: &[[f32; 6]; LEAF_EMITTERS],
    threshold: f32,
) -> Option<(&'a Emitter, Face, f32)> {
    let (mut passed, mut chosen) = (0.0, None);
    for (emitter, importances) in emitters.iter().zip(importances) {
        for face in faces_of(emitter.faces) {
            let importance = importances[face as usize];
            if importance > 0.0 {
                chosen = Some((emitter, face, importance));
                passed += importance;
                if threshold < passed {
                    return chosen;
                }
            }
        }
    }
    chosen
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

/// Density over solid angle of a uniform point of a face (area 1 in grid space) at `toward` from the receiver; `None`
/// behind the face. Solid angles are the same in grid and world space, as instances keep angles.
fn face_pdf(toward: Vec3, face: Face) -> Option<f32> {
    let in_front = if face as u32 & 1 == 1 { -toward[face.axis()] } else { toward[face.axis()] };
    let distance_squared = toward.length_squared();
    (in_front > 0.0).then(|| distance_squared * distance_squared.sqrt() / in_front)
}

/// The emitter that a ray hit, `None` where the hit voxel is none.
fn find_emitter<'a>(scene: &'a PackedScene, hit: &Hit) -> Option<&'a Emitter> {
    let (emitters, grid) = (&*scene.geometry.emitters, scene.placement.instances[hit.instance as usize].grid);
    let order = |emitter: &Emitter| emitter.grid.cmp(&grid).then_with(|| morton_order(emitter.voxel, hit.voxel));
    emitters.binary_search_by(order).ok().map(|index| &emitters[index])
}

/// Density over solid angle with which [`sample_emitter`] chooses the point where `ray` met `emitter`.
fn emitter_pdf(scene: &PackedScene, receiver: &Receiver, ray: &Ray, hit: &Hit, emitter: &Emitter) -> f32 {
    let (geometry, placement) = (&*scene.geometry, &scene.placement);
    let instance = &placement.instances[hit.instance as usize];
    let (face, local) = (hit.face(), in_grid(instance, receiver));
    let toward = instance.grid_from_world.direction(ray.direction) * hit.t;
    let emitters = leaf_emitters(geometry, &geometry.light_nodes[emitter.leaf as usize]);
    let (_, sum) = leaf_importances(emitters, &local);
    let own = if emitter.faces >> hit.face & 1 != 0 { face_importance(emitter, face, &local) } else { 0.0 };
    let Some(area_pdf) = face_pdf(toward, face).filter(|_| own > 0.0) else { return 0.0 };

    let in_tree = climb(&geometry.light_nodes, &local, emitter.leaf, own / sum);
    let probability = in_tree.and_then(|below| climb(&placement.light_nodes, receiver, instance.light_leaf, below));
    probability.map_or(0.0, |probability| probability * area_pdf)
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
        match find_emitter(self.scene, hit) {
            Some(emitter) => emitter_pdf(self.scene, receiver, ray, hit, emitter),
            None => 0.0,
        }
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
