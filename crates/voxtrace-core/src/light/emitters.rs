//! Emissive voxels as lights: a stochastic descent of their tree, each node weighed by what it can send at most (Conty
//! Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", HPG 2018), then a face of the
//! leaf, then a point of the face.

use super::{BELOW_ONE, LightSample, Receiver};
use crate::math::normalize;
use crate::packed::{Emitter, LEAF_EMITTERS, LightNode, PackedScene, morton_order};
use crate::surface::{faces_of, point_off_face};
use glam::Vec3;
use voxtrace_scene::ray::{Face, Hit, Ray};

/// What the emitters of a node can send to the receiver: an upper bound of their cosines over their squared distance,
/// which is not taken below the squared radius of their box. It is 0 only where nothing can arrive.
pub fn node_importance(node: &LightNode, receiver: &Receiver) -> f32 {
    let half = (node.max - node.min) * 0.5;
    let toward = (node.min + node.max) * 0.5 - receiver.point;
    let normal = receiver.normal;
    let above = toward.dot(normal) + half.dot(normal.abs());
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
    let above = toward.dot(receiver.normal) + half.dot(receiver.normal.abs());
    if in_front <= 0.0 || above <= 0.0 {
        return 0.0;
    }
    let distance_squared = toward.length_squared().max(0.5);
    let distance = distance_squared.sqrt();
    emitter.luminance * in_front.min(distance) * above.min(distance) / (distance_squared * distance_squared)
}

/// Probability of going left at an inner node; `None` where neither side can send anything.
fn left_probability(nodes: &[LightNode], node: usize, receiver: &Receiver) -> Option<f32> {
    let left = node_importance(&nodes[node + 1], receiver);
    let right = node_importance(&nodes[nodes[node].index as usize], receiver);
    (left + right > 0.0).then(|| left / (left + right))
}

/// The importances of the faces of a leaf's emitters, and their sum; 0 for covered faces.
fn leaf_importances(emitters: &[Emitter], receiver: &Receiver) -> ([[f32; 6]; LEAF_EMITTERS], f32) {
    let (mut importances, mut sum) = ([[0.0; 6]; LEAF_EMITTERS], 0.0);
    for (emitter, importances) in emitters.iter().zip(&mut importances) {
        for face in faces_of(emitter.faces) {
            importances[face as usize] = face_importance(emitter, face, receiver);
            sum += importances[face as usize];
        }
    }
    (importances, sum)
}

/// The receiver in the grid space of an instance.
fn in_grid(scene: &PackedScene, instance: u32, receiver: &Receiver) -> Receiver {
    let grid_from_world = &scene.instances[instance as usize].grid_from_world;
    Receiver {
        point: grid_from_world.point(receiver.point),
        normal: normalize(grid_from_world.direction(receiver.normal)),
    }
}

fn leaf_emitters<'a>(scene: &'a PackedScene, leaf: &LightNode) -> &'a [Emitter] {
    &scene.emitters[leaf.index as usize..(leaf.index + leaf.count) as usize]
}

/// Chooses a leaf of the tree, then a face of one of its emitters, then a point of the face.
pub fn sample_emitter(scene: &PackedScene, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
    let nodes = &*scene.light_nodes;
    let (mut node, mut choice, mut probability) = (0, u[0], 1.0);
    while nodes.get(node)?.count == 0 {
        let left = left_probability(nodes, node, receiver)?;
        if choice < left {
            (node, choice, probability) = (node + 1, choice / left, probability * left);
        } else {
            let right = 1.0 - left;
            (node, choice, probability) = (nodes[node].index as usize, (choice - left) / right, probability * right);
        }
        choice = choice.min(BELOW_ONE);
    }
    let emitters = leaf_emitters(scene, &nodes[node]);
    let local = in_grid(scene, emitters[0].instance, receiver);
    let (importances, sum) = leaf_importances(emitters, &local);
    let (emitter, face, importance) = choose_face(emitters, &importances, u[1] * sum)?;
    probability *= importance / sum;

    let instance = &scene.instances[emitter.instance as usize];
    let low = emitter.voxel.as_vec3();
    let on_face = point_of_face(low, face, u[2], u[3]);
    let pdf = probability * face_pdf(on_face - local.point, face)?;
    let target = instance.world_from_grid.point(point_off_face(instance, low, face, on_face));
    let direction = target - receiver.point;
    let cos_theta = receiver.normal.dot(direction) / direction.length_squared().sqrt();
    let ray = Ray { t_max: 1.0, ..Ray::new(receiver.point, direction) };
    let radiance = scene.materials[emitter.material as usize].emission * scene.light_intensity;
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
pub fn find_emitter<'a>(scene: &'a PackedScene, hit: &Hit) -> Option<&'a Emitter> {
    let order =
        |emitter: &Emitter| emitter.instance.cmp(&hit.instance).then_with(|| morton_order(emitter.voxel, hit.voxel));
    scene.emitters.binary_search_by(order).ok().map(|index| &scene.emitters[index])
}

/// Density over solid angle with which [`sample_emitter`] chooses the point where `ray` met `emitter`.
pub fn emitter_pdf(scene: &PackedScene, receiver: &Receiver, ray: &Ray, hit: &Hit, emitter: &Emitter) -> f32 {
    let nodes = &*scene.light_nodes;
    let (face, local) = (hit.face(), in_grid(scene, hit.instance, receiver));
    let toward = scene.instances[hit.instance as usize].grid_from_world.direction(ray.direction) * hit.t;
    let emitters = leaf_emitters(scene, &nodes[emitter.leaf as usize]);
    let (_, sum) = leaf_importances(emitters, &local);
    let own = if emitter.faces >> hit.face & 1 != 0 { face_importance(emitter, face, &local) } else { 0.0 };
    let Some(area_pdf) = face_pdf(toward, face).filter(|_| own > 0.0) else { return 0.0 };

    let (mut node, mut probability) = (emitter.leaf, own / sum);
    while nodes[node as usize].parent != LightNode::NONE {
        let parent = nodes[node as usize].parent;
        let Some(left) = left_probability(nodes, parent as usize, receiver) else { return 0.0 };
        probability *= if node == parent + 1 { left } else { 1.0 - left };
        node = parent;
    }
    probability * area_pdf
}
