//! Emissive voxels as lights: a stochastic descent of the tree over instances, then, in the space of the grid, of the tree
//! over its emitters, each node weighed by what it can send at most (Conty Estevez and Kulla, "Importance Sampling of Many
//! Lights with Adaptive Tree Splitting", HPG 2018). It ends at a leaf, or at a node so far away that its emitters differ by their power alone:
//! there one of the six sides is chosen by what is sent along it, then an emitter by its power, then a point of its face on that side. Nothing on the
//! way is divided, and no root is taken: with the same bits on every device they took most of the time that light takes.

use super::{LightSample, Receiver};
use crate::math::{inverse_power_of_two, luminance, normalize, reciprocal_guess};
use crate::packed::{Geometry, LightNode, PackedInstance, PackedMaterial, PackedScene};
use crate::surface::offset_ray_origin;
use glam::{IVec3, Vec3};
use voxtrace_scene::ray::{FACES, Face, Hit, Ray};

/// How many times as far away as the radius of its box, squared, the middle of a node is at least for its emitters to be chosen by their power: nearer
/// ones would be chosen visibly worse (`docs/decisions/0081-far-lights-by-their-power.md`).
pub(super) const FAR_SQUARED: f32 = 36.0;

/// The vector whose length is taken for the distance of a node with this half of a box, whose middle lies there from the receiver: along each axis at least half the
/// box, as a receiver within a box of emitters is not at its middle (`docs/decisions/0239-trees-of-lights-that-find-near-lamps.md`).
fn reach(toward: Vec3, half: Vec3) -> Vec3 {
    toward.abs().max(half)
}

/// How near a node is taken to be at least where its box is nearest, along each axis, of half the box.
pub(super) const NEAREST_SHARE: f32 = 0.03125;

/// As [`reach`], were all emitters where the box is nearest.
fn nearest(toward: Vec3, half: Vec3) -> Vec3 {
    (toward.abs() - half).max(half * NEAREST_SHARE)
}

/// What of a choice among two nodes is by their nearest emitters, to what is by all of them.
pub(super) const BY_NEAREST: f32 = 0.5;

/// What a node can send to a receiver, both in the same space.
#[derive(Clone, Copy, Debug)]
struct View {
    /// Power times the emitters' cosines, at most, over their squared distance, that of [`reach`]. It is 0 only where nothing can arrive.
    importance: f32,
    /// The same with the distance of [`nearest`].
    of_nearest: f32,
    /// Whether the node lies so far away, and so wholly above the receiver's horizon, that its emitters differ by their power alone.
    is_far: bool,
}

fn view(node: &LightNode, receiver: &Receiver) -> View {
    let half = (node.max - node.min) * 0.5;
    let toward = (node.min + node.max) * 0.5 - receiver.point;
    let normal = receiver.normal;
    let (middle, aside) = (toward.dot(normal), half.dot(normal.abs()));
    let above = middle + aside + receiver.slack;
    let (far, near) = (reach(toward, half).length_squared(), half.length_squared());
    let is_far = middle - aside + receiver.slack > 0.0 && far > near * FAR_SQUARED;
    if above <= 0.0 {
        return View { importance: 0.0, of_nearest: 0.0, is_far };
    }
    let falloff = reciprocal_guess(far);
    let cosines = sum_of_sides(sent_by_side(node, receiver.point)) * above * falloff;
    let of_nearest = cosines * reciprocal_guess(nearest(toward, half).length_squared());
    View { importance: cosines * falloff, of_nearest, is_far }
}

/// What a node sends along each of the six directions to a point, up to a common factor: its power times how far the point lies in front of the
/// foremost face that looks there.
fn sent_by_side(node: &LightNode, point: Vec3) -> [f32; 6] {
    let beyond_min = (point - node.min).max(Vec3::ZERO);
    let beyond_max = (node.max - point).max(Vec3::ZERO);
    let power = &node.power;
    [
        power[0] * beyond_max.x,
        power[1] * beyond_min.x,
        power[2] * beyond_max.y,
        power[3] * beyond_min.y,
        power[4] * beyond_max.z,
        power[5] * beyond_min.z,
    ]
}

fn sum_of_sides(sent: [f32; 6]) -> f32 {
    (sent[0] + sent[1]) + (sent[2] + sent[3]) + (sent[4] + sent[5])
}

/// 0 for what devices may take for zero.
fn normal_or_zero(weight: f32) -> f32 {
    if weight < f32::MIN_POSITIVE { 0.0 } else { weight }
}

/// Weights of two children with the ratio of their importances, whose sum is in [1, 2); `None` where neither can send anything.
fn weights_of(left: f32, right: f32) -> Option<[f32; 2]> {
    let (left, right) = (normal_or_zero(left), normal_or_zero(right));
    let unit = inverse_power_of_two(left + right);
    (left + right > 0.0).then(|| [normal_or_zero(left * unit), normal_or_zero(right * unit)])
}

/// Weights of two children as [`weights_of`]. Where their emitters are within a box is not known: beside a lamp in a large box its middle says nothing, so a part of the choice
/// is by what the nearest ones may send.
fn weights_of_views(left: View, right: View) -> Option<[f32; 2]> {
    let [near_left, near_right] = weights_of(left.of_nearest, right.of_nearest)?;
    let (of_near, of_all) = (near_left + near_right, (left.importance + right.importance) * BY_NEAREST);
    weights_of(left.importance * of_near + near_left * of_all, right.importance * of_near + near_right * of_all)
}

/// Luminance of the irradiance of all emitters together, as far as the root of their tree tells: at most, for each of them.
fn importance_of_all(scene: &PackedScene, receiver: &Receiver) -> f32 {
    let root = scene.placement.light_nodes.first();
    root.map_or(0.0, |root| view(root, receiver).importance * scene.light_intensity)
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
    /// Whether it ends here, leaf or not.
    pub is_far: bool,
}

impl Descent {
    /// Begins at the top, with a random number in [0, 1).
    fn begin(choice: f32) -> Self {
        Self { node: 0, index: 0, count: 0, weight: 1.0, total: 1.0, choice, is_far: false }
    }

    /// Goes on at a root.
    fn at(self, root: u32, nodes: &[LightNode]) -> Option<Self> {
        let LightNode { index, count, .. } = *nodes.get(root as usize)?;
        Some(Self { node: root, index, count, is_far: false, ..self })
    }
}

/// Goes down to a leaf or, where `ends_far`, to a node that is far: by the random number, or to the one with the emitter at `voxel`. `None` where
/// nothing can be sent.
fn descend(
    nodes: &[LightNode],
    receiver: &Receiver,
    (voxel, ends_far): (Option<IVec3>, bool),
    mut descent: Descent,
) -> Option<Descent> {
    while descent.count == 0 && !descent.is_far {
        let (left, right) = (&nodes[descent.node as usize + 1], &nodes[descent.index as usize]);
        let views = [view(left, receiver), view(right, receiver)];
        let weights = weights_of_views(views[0], views[1])?;
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
        descent.is_far = ends_far && views[usize::from(!is_left)].is_far;
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
        let weights = weights_of_views(view(left, receiver), view(right, receiver))?;
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

/// The probability of a way with its side, as a quotient.
#[derive(Clone, Copy, Debug)]
pub(super) struct Odds {
    pub weight: f32,
    pub total: f32,
}

/// An emitter on whose side a point is to be chosen; its luminance and the power of its node on that side are those of the choice.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chosen {
    /// Index of the emitter.
    pub emitter: u32,
    pub side: Face,
    pub power: f32,
}

/// Chooses an instance, then a node of its grid's tree, then a side, then an emitter, then a point of its face.
fn sample_emitter(tree: &EmitterTree, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
    let (geometry, placement) = (&*tree.scene.geometry, &tree.scene.placement);
    let (top, nodes) = (&placement.light_nodes, &geometry.light_nodes);
    let above = descend(top, receiver, (None, false), Descent::begin(u[0]).at(0, top)?)?;
    let local = in_grid(&placement.instances[above.index as usize], receiver);
    let end = descend(nodes, &local, (None, true), above.at(top[above.node as usize].root, nodes)?)?;
    let (odds, side) = choose_side(&nodes[end.node as usize], local.point, None, &end)?;
    let power = nodes[end.node as usize].power[side as usize];
    let emitter = choose_emitter(geometry, end.node, side, u[1] * power)?;
    emitter_sample(tree, receiver, (above.index, local.point), odds, Chosen { emitter, side, power }, u)
}

/// Of the node where a way ended, the side of its emitters that shines: by what is left of the random number, or `met`, and the odds of it with
/// those of the way. `None` where nothing is sent to the point along it.
fn choose_side(node: &LightNode, point: Vec3, met: Option<Face>, way: &Descent) -> Option<(Odds, Face)> {
    let sent = sent_by_side(node, point);
    let sum = normal_or_zero(sum_of_sides(sent));
    let unit = inverse_power_of_two(sum);
    let total = sum * unit;
    let threshold = way.choice * total;
    let (mut passed, mut chosen, mut is_found) = (0.0, (FACES[0], 0.0), false);
    for face in FACES {
        let share = normal_or_zero(sent[face as usize] * unit);
        if met.map_or(share > 0.0 && !is_found, |met| met == face) {
            chosen = (face, share);
        }
        passed += share;
        is_found |= threshold < passed * way.weight;
    }
    let odds = Odds { weight: way.weight * chosen.1, total: way.total * total };
    (sum > 0.0 && odds.weight > 0.0).then_some((odds, chosen.0))
}

/// The emitter of a node at which the running sum of the powers on a side passes `threshold`.
fn choose_emitter(geometry: &Geometry, node: u32, side: Face, threshold: f32) -> Option<u32> {
    let nodes = &geometry.light_nodes;
    let (mut at, mut threshold) = (node as usize, threshold);
    while nodes[at].count == 0 {
        (at, threshold) = child_by_power(nodes, at, side, threshold);
    }
    emitter_by_power(geometry, &nodes[at], side, threshold)
}

/// The child of an inner node at which the running sum of the powers on a side passes `threshold`, and what of it is left there.
#[inline]
fn child_by_power(nodes: &[LightNode], at: usize, side: Face, threshold: f32) -> (usize, f32) {
    let (left, right) = (nodes[at + 1].power[side as usize], nodes[at].index as usize);
    if threshold < left || nodes[right].power[side as usize] <= 0.0 {
        return (at + 1, threshold);
    }
    (right, threshold - left)
}

/// The emitter of a leaf, as [`child_by_power`] chooses a child.
#[inline]
fn emitter_by_power(geometry: &Geometry, leaf: &LightNode, side: Face, mut threshold: f32) -> Option<u32> {
    let mut chosen = None;
    for index in leaf.index..leaf.index + leaf.count {
        let emitter = &geometry.emitters[index as usize];
        if emitter.faces >> side as u32 & 1 != 0 {
            chosen = Some(index);
            if threshold < emitter.luminance {
                break;
            }
            threshold -= emitter.luminance;
        }
    }
    chosen
}

/// Chooses a point of the chosen face by `u[2]` and `u[3]`: of an emitter of an instance, for the receiver, whose point is also that in the space of the
/// grid.
#[inline]
pub(super) fn emitter_sample(
    tree: &EmitterTree,
    receiver: &Receiver,
    (instance, point): (u32, Vec3),
    odds: Odds,
    chosen: Chosen,
    u: [f32; 4],
) -> Option<LightSample> {
    let (geometry, instance) = (&*tree.scene.geometry, &tree.scene.placement.instances[instance as usize]);
    let emitter = &geometry.emitters[chosen.emitter as usize];
    let low = emitter.voxel.as_vec3();
    let on_face = point_of_face(low, chosen.side, u[2], u[3]);
    let pdf = density(odds, (emitter.luminance, chosen.power), on_face - point, chosen.side)?;
    let target = instance.world_from_grid.point(offset_ray_origin(instance, low, chosen.side, on_face));
    let direction = target - receiver.point;
    let cos_theta = receiver.normal.dot(direction) / direction.length_squared().sqrt() + receiver.slack;
    let ray = Ray { t_max: 1.0, ..Ray::new(receiver.point, direction) };
    let radiance = geometry.materials[emitter.material as usize].surface_emission() * tree.intensity;
    (cos_theta > 0.0).then_some(LightSample { ray, cos_theta, radiance, pdf })
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
/// emitter has this luminance of the node's power. `None` behind the face. Solid angles are the same in grid and world space, as instances keep
/// angles.
fn density(odds: Odds, (luminance, power): (f32, f32), toward: Vec3, face: Face) -> Option<f32> {
    let in_front = if face as u32 & 1 == 1 { -toward[face.axis()] } else { toward[face.axis()] };
    let distance_squared = toward.length_squared();
    // In units of the power: the product of small numbers may be too small.
    let unit = inverse_power_of_two(power);
    let share = odds.weight * (luminance * unit) * (distance_squared * distance_squared.sqrt());
    (in_front > 0.0).then(|| share / (odds.total * (power * unit) * in_front))
}

/// Density over solid angle with which [`sample_emitter`] chooses the point that `ray`, which starts at the receiver, met; 0 where it never does.
fn emitter_pdf(scene: &PackedScene, receiver: &Receiver, ray: &Ray, hit: &Hit) -> f32 {
    pdf_of_hit(scene, receiver, ray, hit).unwrap_or(0.0)
}

fn pdf_of_hit(scene: &PackedScene, receiver: &Receiver, ray: &Ray, hit: &Hit) -> Option<f32> {
    let (geometry, placement) = (&*scene.geometry, &scene.placement);
    let instance = &placement.instances[hit.instance as usize];
    // Of faces that cuts make no point is ever chosen.
    if instance.light_leaf == LightNode::NONE || hit.face >= Hit::FIRST_CUT {
        return None;
    }
    let above = climb(&placement.light_nodes, receiver, instance.light_leaf, Descent::begin(0.0))?;
    let (side, local) = (hit.face(), in_grid(instance, receiver));
    let nodes = &geometry.light_nodes;
    let root = placement.light_nodes[instance.light_leaf as usize].root;
    let end = descend(nodes, &local, (Some(hit.voxel), true), above.at(root, nodes)?)?;
    let (odds, _) = choose_side(&nodes[end.node as usize], local.point, Some(side), &end)?;
    let material = geometry.material_at(&geometry.grids[instance.grid as usize], hit.voxel)?;
    let luminance = luminance(geometry.materials[material as usize].surface_emission());
    let toward = instance.grid_from_world.direction(ray.direction) * hit.t;
    density(odds, (luminance, nodes[end.node as usize].power[side as usize]), toward, side)
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
    /// Chooses a point of an emitter for `receiver` by `u`, each uniform in [0, 1): `u[0]` down the tree and among the sides, `u[1]` within the
    /// node, `u[2]` and `u[3]` on the face. `None` where no emitter can be seen, and sometimes otherwise.
    #[inline]
    pub fn sample(&self, receiver: &Receiver, u: [f32; 4]) -> Option<LightSample> {
        sample_emitter(self, receiver, u)
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
