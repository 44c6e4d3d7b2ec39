//! Nodes that move, as files with a tree of nodes have them (Khronos, "glTF 2.0 Specification", sections 3.11 and C): each has a translation, a
//! rotation and a scale, which follow keys. What hangs on them moves along.

use super::keyframes::whole_steps;
use super::turn::slerp;
use crate::scene::Scene;
use crate::transform::Transform;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// An animation that a scene brings along.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clip {
    /// Its name, empty where it has none.
    pub name: String,
    /// How long it lasts.
    pub seconds: f64,
    /// What moves; `None` where the scene stands still in this one.
    pub motion: Option<Arc<NodeMotion>>,
}

/// Nodes that move, and what hangs on them.
#[derive(Clone, Debug, PartialEq)]
pub struct NodeMotion {
    /// The nodes that move, parents before their children.
    pub nodes: Vec<MovingNode>,
    /// From the space of the file to the world.
    pub world_from_file: DAffine3,
    /// Instances of the scene.
    pub instances: Vec<Attached>,
    /// Cameras of the scene: they look along −z of their own space, with y up.
    pub cameras: Vec<Attached>,
    /// Which of the instances change their shape.
    pub shapes: Vec<ShapeSteps>,
}

/// What hangs on a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attached {
    /// Index into the instances or cameras.
    pub index: usize,
    /// Index into [`NodeMotion::nodes`].
    pub node: usize,
    /// From its own space, for instances that of the grid, to the space of the node.
    pub node_from_own: DAffine3,
}

/// An instance that changes its shape in even steps: it shows a grid from each step until the next, and the last one for ever.
#[derive(Clone, Debug, PartialEq)]
pub struct ShapeSteps {
    /// Index into the instances, one of those of [`NodeMotion::instances`].
    pub index: usize,
    /// Index into [`NodeMotion::nodes`].
    pub node: usize,
    /// Steps a second, above 0; the first is at 0 s.
    pub rate: f64,
    /// The shapes, each once.
    pub shapes: Vec<Shape>,
    /// For each step the index into `shapes`; `None` where nothing is seen.
    pub steps: Vec<Option<usize>>,
}

/// One of the shapes of an instance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Index into [`Scene::grids`].
    pub grid: usize,
    /// From the space of the grid to that of the node.
    pub node_from_grid: DAffine3,
}

/// A node that moves.
#[derive(Clone, Debug, PartialEq)]
pub struct MovingNode {
    /// The nearest node above it that moves, an index before its own.
    pub parent: Option<usize>,
    /// From the space of the nodes between them to that of this parent, or of the file.
    pub parent_from_outer: DAffine3,
    /// Where it is as far as no channel says it.
    pub rest: NodePose,
    /// What moves it, at most one of a kind.
    pub channels: Vec<Channel>,
}

/// Translation, rotation and scale, applied in the order scale, rotation, translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodePose {
    /// Translation.
    pub translation: DVec3,
    /// Rotation, a unit quaternion.
    pub rotation: DQuat,
    /// Scale along the axes of the node.
    pub scale: DVec3,
}

/// What moves a node.
#[derive(Clone, Debug, PartialEq)]
pub enum Channel {
    /// Its translation.
    Translation(KeyTrack<3>),
    /// Its rotation, quaternions (x, y, z, w).
    Rotation(KeyTrack<4>),
    /// Its scale.
    Scale(KeyTrack<3>),
}

/// Numbers at keys.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyTrack<const N: usize> {
    times: Vec<f32>,
    /// One for each key; with tangents three: the tangent that comes in, the value, the tangent that goes out.
    values: Vec<[f32; N]>,
    kind: KeyKind,
}

/// How numbers go from one key to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum KeyKind {
    /// They stay, and jump.
    Step,
    /// Straight; rotations on the shorter arc, at one speed.
    Linear,
    /// By cubic Hermite splines, whose tangents the keys have.
    Cubic,
}

/// How the clip of a scene is played.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Playback {
    /// Not at all: the scene stands as it is.
    #[default]
    Still,
    /// Once; its last pose holds.
    Once,
    /// Again and again.
    Repeated,
}

impl<const N: usize> KeyTrack<N> {
    /// Numbers at times that do not fall; `None` where there are none, or not as many as `kind` asks for, or where one is not finite.
    pub fn new(times: Vec<f32>, values: Vec<[f32; N]>, kind: KeyKind) -> Option<Self> {
        let wanted = if kind == KeyKind::Cubic { times.len().checked_mul(3)? } else { times.len() };
        let is_sound = !times.is_empty()
            && values.len() == wanted
            && times.is_sorted()
            && times.iter().chain(values.as_flattened()).all(|number| number.is_finite());
        is_sound.then_some(Self { times, values, kind })
    }

    /// When the last key comes, seconds.
    pub fn end(&self) -> f64 {
        self.times.last().map_or(0.0, |&time| time.into())
    }

    /// The times of the keys.
    pub fn times(&self) -> &[f32] {
        &self.times
    }

    /// Whether all keys say the same as `rest`, to a millionth, and nothing moves between them.
    pub fn is_at_rest(&self, rest: [f64; N]) -> bool {
        let near = |value: &[f32; N], rest: &[f64; N]| {
            value.iter().zip(rest).all(|(&value, rest)| (f64::from(value) - rest).abs() <= 1e-6 * rest.abs().max(1.0))
        };
        match self.kind {
            KeyKind::Cubic => {
                self.values.as_chunks().0.iter().all(|[before, value, after]| {
                    near(value, &rest) && near(before, &[0.0; N]) && near(after, &[0.0; N])
                })
            }
            _ => self.values.iter().all(|value| near(value, &rest)),
        }
    }

    /// The numbers at a time, in seconds, where each goes its own way. Before the first key and after the last they hold.
    #[doc(hidden)]
    pub fn evenly_at(&self, time: f64) -> [f64; N] {
        self.at(time, evenly)
    }

    fn value(&self, key: usize) -> [f64; N] {
        self.values[if self.kind == KeyKind::Cubic { 3 * key + 1 } else { key }].map(f64::from)
    }

    /// The numbers at a time; `straight` goes from one key to the next by a share where keys say no more. Before the first key and after the last they hold.
    fn at(&self, time: f64, straight: impl Fn([f64; N], [f64; N], f64) -> [f64; N]) -> [f64; N] {
        let key = self.times.partition_point(|&key| f64::from(key) <= time).saturating_sub(1);
        let start = f64::from(self.times[key]);
        let Some(&end) = self.times.get(key + 1).filter(|_| time > start) else { return self.value(key) };
        let length = f64::from(end) - start;
        let s = (time - start) / length;
        match self.kind {
            KeyKind::Step => self.value(key),
            KeyKind::Linear => straight(self.value(key), self.value(key + 1), s),
            KeyKind::Cubic => {
                let (from, to) = (self.value(key), self.value(key + 1));
                let (leaving, arriving) = (self.values[3 * key + 2], self.values[3 * key + 3]);
                let (s2, s3) = (s * s, s * s * s);
                std::array::from_fn(|n| {
                    (2.0 * s3 - 3.0 * s2 + 1.0) * from[n]
                        + (s3 - 2.0 * s2 + s) * length * f64::from(leaving[n])
                        + (3.0 * s2 - 2.0 * s3) * to[n]
                        + (s3 - s2) * length * f64::from(arriving[n])
                })
            }
        }
    }
}

fn evenly<const N: usize>(from: [f64; N], to: [f64; N], share: f64) -> [f64; N] {
    std::array::from_fn(|n| from[n] + (to[n] - from[n]) * share)
}

/// A unit quaternion of numbers that are near one.
fn unit(numbers: [f64; 4]) -> DQuat {
    let turn = DQuat::from_array(numbers);
    if turn.length_squared() > 0.0 { turn.normalize() } else { DQuat::IDENTITY }
}

impl NodePose {
    /// The map that it is.
    pub fn map(&self) -> DAffine3 {
        DAffine3::from_scale_rotation_translation(self.scale, self.rotation, self.translation)
    }
}

impl Channel {
    /// When its last key comes, seconds.
    pub fn end(&self) -> f64 {
        match self {
            Self::Translation(track) | Self::Scale(track) => track.end(),
            Self::Rotation(track) => track.end(),
        }
    }

    /// The times of its keys.
    pub fn times(&self) -> &[f32] {
        match self {
            Self::Translation(track) | Self::Scale(track) => track.times(),
            Self::Rotation(track) => track.times(),
        }
    }

    /// Whether it says nothing but what a node is anyway.
    pub fn is_at_rest(&self, rest: &NodePose) -> bool {
        match self {
            Self::Translation(track) => track.is_at_rest(rest.translation.to_array()),
            Self::Rotation(track) => {
                track.is_at_rest(rest.rotation.to_array()) || track.is_at_rest((-rest.rotation).to_array())
            }
            Self::Scale(track) => track.is_at_rest(rest.scale.to_array()),
        }
    }

    fn apply(&self, pose: &mut NodePose, time: f64) {
        match self {
            Self::Translation(track) => pose.translation = track.at(time, evenly).into(),
            Self::Scale(track) => pose.scale = track.at(time, evenly).into(),
            Self::Rotation(track) => {
                let arc = |from: [f64; 4], to: [f64; 4], share| slerp(unit(from), unit(to), share).to_array();
                pose.rotation = unit(track.at(time, arc));
            }
        }
    }
}

impl MovingNode {
    /// Its own pose at a time, in seconds, or at rest.
    #[doc(hidden)]
    pub fn pose_at(&self, time: Option<f64>) -> NodePose {
        let mut pose = self.rest;
        if let Some(time) = time {
            self.channels.iter().for_each(|channel| channel.apply(&mut pose, time));
        }
        pose
    }
}

impl ShapeSteps {
    /// The shape at a time, in seconds; `None` where nothing is seen.
    pub fn at(&self, time: f64) -> Option<&Shape> {
        let step = whole_steps(time * self.rate).floor().max(0.0) as usize;
        let last = self.steps.len().checked_sub(1)?;
        self.shapes.get(self.steps[step.min(last)]?)
    }
}

impl NodeMotion {
    /// Where the nodes are at a time, in seconds, or all at rest: from the space of each to that of the file.
    pub fn nodes_at(&self, time: Option<f64>) -> Vec<DAffine3> {
        let mut maps: Vec<DAffine3> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let outer = node.parent.map_or(node.parent_from_outer, |parent| maps[parent] * node.parent_from_outer);
            maps.push(outer * node.pose_at(time).map());
        }
        maps
    }

    /// Puts the instances of a scene where they are at a time; what has no size then is hidden. `original` says which are hidden anyway.
    pub fn apply(&self, original: &Scene, now: &mut Scene, time: f64) {
        self.place(original, now, time);
    }

    /// As [`Self::apply`]. Returns which instances have no size.
    pub(super) fn place(&self, original: &Scene, now: &mut Scene, time: f64) -> FxHashSet<usize> {
        let maps = self.nodes_at(Some(time));
        let mut flat = FxHashSet::default();
        let mut put = |index: usize, placed: Option<Transform>, grid: Option<usize>| {
            let (Some(instance), Some(original)) = (now.instances.get_mut(index), original.instances.get(index)) else {
                return;
            };
            instance.world_from_grid = placed.unwrap_or(original.world_from_grid);
            instance.hidden = original.hidden || placed.is_none();
            instance.grid = grid.unwrap_or(original.grid);
            if placed.is_none() {
                flat.insert(index);
            } else {
                flat.remove(&index);
            }
        };
        for own in &self.instances {
            put(own.index, self.placed(&maps[own.node], &own.node_from_own), None);
        }
        for own in &self.shapes {
            let shape = own.at(time);
            let placed = shape.and_then(|shape| self.placed(&maps[own.node], &shape.node_from_grid));
            put(own.index, placed, shape.map(|shape| shape.grid));
        }
        flat
    }

    /// Where something is in the world that hangs on a node; `None` where it has no size.
    fn placed(&self, file_from_node: &DAffine3, node_from_own: &DAffine3) -> Option<Transform> {
        similarity_of(&(self.world_from_file * *file_from_node * *node_from_own)).map(|(transform, _)| transform)
    }

    /// Every shape of the instances that change theirs, where it is when a step first shows it with a size, else at rest: the index of the instance, the
    /// grid and its place.
    #[doc(hidden)]
    pub fn all_shapes(&self) -> Vec<(usize, usize, Transform)> {
        let mut all = Vec::new();
        for own in &self.shapes {
            let mut places = vec![None; own.shapes.len()];
            for (step, shape) in own.steps.iter().enumerate() {
                let Some(shape) = shape.filter(|&shape| places.get(shape) == Some(&None)) else { continue };
                let file_from_node = self.node_at(own.node, Some(step as f64 / own.rate));
                places[shape] = self.placed(&file_from_node, &own.shapes[shape].node_from_grid);
            }
            for (shape, place) in own.shapes.iter().zip(places) {
                let at_rest = || self.placed(&self.node_at(own.node, None), &shape.node_from_grid);
                all.push((own.index, shape.grid, place.or_else(at_rest).unwrap_or(Transform::IDENTITY)));
            }
        }
        all
    }

    /// As [`Self::nodes_at`], of one node.
    fn node_at(&self, node: usize, time: Option<f64>) -> DAffine3 {
        let above = std::iter::successors(self.nodes.get(node), |node| self.nodes.get(node.parent?));
        above.fold(DAffine3::IDENTITY, |map, node| node.parent_from_outer * node.pose_at(time).map() * map)
    }

    /// From the own space of one of [`Self::cameras`] to the world.
    pub fn world_from_camera(&self, camera: &Attached, time: f64) -> DAffine3 {
        self.world_from_file * self.nodes_at(Some(time))[camera.node] * camera.node_from_own
    }
}

impl Playback {
    /// The time within a clip of so many seconds; `None` where it is not played.
    pub fn time(self, seconds: f64, length: f64) -> Option<f64> {
        match self {
            Self::Still => None,
            Self::Repeated if length > 0.0 => Some(seconds - (seconds / length).floor() * length),
            Self::Once | Self::Repeated => Some(seconds),
        }
    }
}

/// Steps of the iteration to the nearest rotation, which doubles its digits in each.
const STEPS: u32 = 24;
/// Share of its cube that the volume of what has a size takes at least.
const FLAT: f64 = 1e-9;

/// The similarity (a rotation or a mirrored one, a uniform scale) that is nearest to an affine map, and how far it is from it, as a share of
/// the scale: 0 where the map is one. `None` where the map is flat, or not finite.
pub fn similarity_of(map: &DAffine3) -> Option<(Transform, f64)> {
    let turn = turn_of(&map.matrix3).filter(|_| map.translation.is_finite())?;
    // The scale with the least sum of squares.
    let product = turn.transpose() * map.matrix3;
    let scale = (product.x_axis.x + product.y_axis.y + product.z_axis.z) / 3.0;
    let rest = product - DMat3::from_diagonal(DVec3::splat(scale));
    let linear = (turn * scale).as_mat3();
    let transform = Transform { linear, translation: map.translation.as_vec3() };
    transform.is_similarity().then_some((transform, largest(&rest) / scale))
}

/// The rotation, or the mirrored one, of a matrix: the orthogonal factor of its polar decomposition, by Newton's iteration (Higham, "Computing the
/// polar decomposition", 1986). `None` where the matrix is flat, or not finite.
pub fn turn_of(matrix: &DMat3) -> Option<DMat3> {
    let length = largest(matrix);
    if !(length.is_finite() && length > 1e-30) {
        return None;
    }
    let mut turn = *matrix * (1.0 / length);
    if turn.determinant().abs() < FLAT {
        return None;
    }
    for _ in 0..STEPS {
        turn = (turn + turn.inverse().transpose()) * 0.5;
    }
    Some(turn)
}

fn largest(matrix: &DMat3) -> f64 {
    // `max` would drop what is no number.
    matrix.to_cols_array().iter().fold(0.0, |most, number| if number.abs() <= most { most } else { number.abs() })
}
