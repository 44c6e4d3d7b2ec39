//! Rays on their way through the instances of a scene, nearest boxes first: up to sixteen boxes of the wide tree are met together.

use super::kernel::Met;
use super::of_scene::GROUPS;
use super::{Lanes, RAY};
use crate::packed::{InstanceNode, LEAF, PackedGrid, PackedInstance, PackedScene, WideNode, WideTree};
use crate::walk::instances::{cast_whole, entry};
use crate::walk::simd::{Bits, LANES, Simd, lanes_of, prefetch};
use glam::{Vec3, Vec4};
use voxtrace_scene::ray::{Hit, Ray};

/// Rays that are under way: those in lanes, and as many as are prepared at a time.
const JOURNEYS: usize = LANES * GROUPS + super::arrivals::CHUNK;

/// Speeds, along the axis on which a ray is fastest, and distances of its origin at which the wide tree is met. Others go the way of one ray.
const SPEEDS: std::ops::RangeInclusive<f32> = 1e-6..=1e6;
const FARTHEST: f32 = 1e8;
/// Largest inverse of a direction: with boxes within [`WideTree`]'s bounds nothing overflows.
const INVERSE_MAX: f32 = 1e28;
/// How much larger boxes are, of the coordinates in them and of the distance from the ray's origin: sixteen roundings.
const MARGIN: f32 = 8.0 * f32::EPSILON;

/// One ray, and how far it has come.
#[derive(Clone, Copy)]
pub struct Journey {
    /// The ray, up to the nearest hit so far.
    pub ray: Ray,
    inverse: Vec3,
    /// The origin, and the inverse direction kept within bounds.
    origin: Vec4,
    inverse_bound: Vec4,
    is_negative: [bool; 3],
    /// The instance that it was taken to last.
    pub instance: u32,
    /// Which of the rays.
    index: usize,
    /// Children that wait on its stack.
    depth: usize,
    nearest: Hit,
}

/// Rays to trace, those that are under way, and where hits go.
pub struct Journeys<'a> {
    scene: &'a PackedScene,
    tree: &'a WideTree,
    leaves: &'a [InstanceNode],
    pub instances: &'a [PackedInstance],
    pub grids: &'a [PackedGrid],
    rays: &'a [Ray],
    hits: &'a mut [Hit],
    /// The next ray.
    next: usize,
    /// Whether any hit will do.
    any: bool,
    all: Vec<Journey>,
    /// Children of each, the nearest one last: when they are entered, as the bits of t, above what they are.
    stacks: Vec<u64>,
    /// Those that are done with an instance.
    waiting: Vec<usize>,
}

impl Journey {
    #[inline(always)]
    fn new(ray: Ray, index: usize) -> Self {
        let inverse = Vec3::ONE / ray.direction;
        Self {
            ray,
            inverse,
            origin: ray.origin.extend(0.0),
            inverse_bound: inverse.clamp(Vec3::splat(-INVERSE_MAX), Vec3::splat(INVERSE_MAX)).extend(0.0),
            is_negative: [inverse.x < 0.0, inverse.y < 0.0, inverse.z < 0.0],
            instance: 0,
            index,
            depth: 1,
            nearest: Hit::MISS,
        }
    }
}

impl<'a> Journeys<'a> {
    pub fn new(
        (scene, tree): (&'a PackedScene, &'a WideTree),
        rays: &'a [Ray],
        any: bool,
        hits: &'a mut [Hit],
    ) -> Self {
        let mut journeys = Self {
            scene,
            tree,
            leaves: &scene.placement.instance_nodes,
            instances: &scene.placement.instances,
            grids: &scene.geometry.grids,
            rays,
            hits,
            next: 0,
            any,
            all: Vec::with_capacity(JOURNEYS),
            stacks: vec![0; JOURNEYS * tree.most_waiting],
            waiting: Vec::with_capacity(JOURNEYS),
        };
        while journeys.all.len() < JOURNEYS
            && let Some(first) = journeys.next_ray()
        {
            journeys.waiting.push(journeys.all.len());
            journeys.all.push(first);
            journeys.stacks[(journeys.all.len() - 1) * tree.most_waiting] = 0;
        }
        journeys
    }

    pub fn of(&self, number: usize) -> &Journey {
        &self.all[number]
    }

    /// Takes back one that is done with its instance.
    #[inline(always)]
    pub fn wait(&mut self, number: usize) {
        self.waiting.push(number);
    }

    /// Whether some wait.
    #[inline(always)]
    pub fn are_waiting(&self) -> bool {
        !self.waiting.is_empty()
    }

    /// Takes up to sixteen that wait, or the rays after them where they are done, to the next instances whose boxes they meet. Returns how
    /// many those are, and which.
    #[inline(always)]
    pub fn advance<S: Simd>(&mut self, s: S) -> (usize, [u32; LANES]) {
        let mut found = ([0; LANES], 0);
        // Those that look for an instance, and the nodes whose children they are about to meet.
        let mut looking = [(0u32, 0u32); LANES];
        let mut count = 0;
        while count < LANES
            && let Some(number) = self.waiting.pop()
        {
            looking[count].0 = number as u32;
            count += 1;
        }
        while count > 0 {
            let mut left = 0;
            for at in 0..count {
                let number = looking[at].0;
                match self.pop(number as usize) {
                    Next::Instance => {
                        found.0[found.1] = number;
                        found.1 += 1;
                    }
                    Next::Node(node) => {
                        looking[left] = (number, node);
                        left += 1;
                    }
                    Next::Nothing => {}
                }
            }
            count = left;
            for &(number, node) in &looking[..count] {
                self.descend(s, number as usize, node);
            }
        }
        (found.1, found.0)
    }

    /// The next ray, before the root of the tree.
    #[inline(always)]
    fn next_ray(&mut self) -> Option<Journey> {
        while let Some(ray) = self.rays.get(self.next) {
            let index = self.next;
            self.next += 1;
            let is_plain = SPEEDS.contains(&ray.direction.abs().max_element())
                && ray.origin.abs().max_element() <= FARTHEST
                && ray.t_min >= 0.0
                && ray.t_min <= ray.t_max;
            if is_plain && !(ray.direction.is_nan() || ray.origin.is_nan()) {
                return Some(Journey::new(*ray, index));
            }
            self.hits[index] = cast_whole(self.scene, ray);
        }
        None
    }

    /// The nearest of what waits on the stack of one; where nothing does, on that of the ray after it.
    #[inline(always)]
    fn pop(&mut self, number: usize) -> Next {
        loop {
            let journey = &mut self.all[number];
            let stack = &self.stacks[number * self.tree.most_waiting..][..self.tree.most_waiting];
            while let Some(top) = journey.depth.checked_sub(1) {
                journey.depth = top;
                let (t, child) = (f32::from_bits((stack[top] >> 32) as u32), stack[top] as u32);
                if t > journey.ray.t_max {
                    continue;
                }
                if child & LEAF == 0 {
                    return Next::Node(child);
                }
                let leaf = &self.leaves[(child & !LEAF) as usize];
                if entry(leaf, &journey.ray, journey.inverse).is_some() {
                    journey.instance = leaf.index;
                    prefetch_instance(&self.instances[leaf.index as usize]);
                    return Next::Instance;
                }
            }
            self.hits[journey.index] = journey.nearest;
            let Some(next) = self.next_ray() else { return Next::Nothing };
            self.all[number] = next;
            self.stacks[number * self.tree.most_waiting] = 0;
        }
    }

    /// Puts those children of a node whose boxes a ray meets onto its stack, the nearest one last.
    #[inline(always)]
    fn descend<S: Simd>(&mut self, s: S, number: usize, node: u32) {
        let journey = &mut self.all[number];
        let stack = &mut self.stacks[number * self.tree.most_waiting..][..self.tree.most_waiting];
        let node = &self.tree.nodes[node as usize];
        let (met, times) = meet(s, node, journey);
        let (bottom, mut depth) = (journey.depth, journey.depth);
        for lane in lanes_of(met) {
            let child = node.children[lane];
            // What is looked at next is fetched meanwhile.
            match child & LEAF {
                0 => prefetch_node(&self.tree.nodes, child),
                _ => prefetch(self.leaves.as_ptr().wrapping_add((child & !LEAF) as usize)),
            }
            let key = u64::from(times[lane].to_bits()) << 32 | u64::from(child);
            let mut at = depth;
            while at > bottom && stack[at - 1] < key {
                stack[at] = stack[at - 1];
                at -= 1;
            }
            stack[at] = key;
            depth += 1;
        }
        journey.depth = depth;
    }

    /// Keeps the hit of a lane where it is the nearest of its ray.
    #[inline(always)]
    pub fn take_hit(&mut self, met: &Met, lanes: &Lanes, lane: usize) {
        let journey = &mut self.all[lanes.integers[RAY][lane] as usize];
        let voxel = lanes.voxel_of(lane) + lanes.grids.origin_of(lane);
        let hit = met.hit(lanes, lane, voxel, journey.ray.t_min, journey.instance);
        let is_nearer =
            hit.t < journey.nearest.t || (hit.t == journey.nearest.t && hit.instance < journey.nearest.instance);
        if hit.t <= journey.ray.t_max && is_nearer {
            journey.nearest = hit;
            journey.ray.t_max = hit.t;
            if self.any {
                journey.depth = 0;
            }
        }
    }
}

/// What a ray comes to next.
enum Next {
    /// A node of the wide tree.
    Node(u32),
    /// The box of an instance.
    Instance,
    /// Nothing: there are no more rays.
    Nothing,
}

/// Lets the processor fetch a node.
#[inline(always)]
fn prefetch_node(nodes: &[WideNode], index: u32) {
    let lines: *const [u8; 64] = nodes.as_ptr().wrapping_add(index as usize).cast();
    for line in 0..4 {
        prefetch(lines.wrapping_add(line));
    }
}

/// Lets the processor fetch what a ray needs of an instance.
#[inline(always)]
fn prefetch_instance(instance: &PackedInstance) {
    prefetch(&raw const instance.grid_from_world);
    prefetch(&raw const instance.grid);
}

/// Which children's boxes a ray's segment meets, and about where it enters them. Whoever is in a box by [`entry`], whose f32 is rounded three times,
/// is in those around it here: they are larger by more than all roundings together.
#[inline(always)]
fn meet<S: Simd>(s: S, node: &WideNode, journey: &Journey) -> (Bits, [f32; LANES]) {
    let (base, step) = (Vec4::from_array(node.base), Vec4::from_array(node.step));
    let from = base - journey.origin;
    let margin = (from.abs() + step * 1024.0) * journey.inverse_bound.abs() * MARGIN;
    let (scale, start) = (step * journey.inverse_bound, from * journey.inverse_bound);
    let (near, far) = ((start - margin).to_array(), (start + margin).to_array());
    let scale = scale.to_array();
    let (mut enter, mut leave) = (s.floats(journey.ray.t_min), s.floats(journey.ray.t_max));
    for axis in 0..3 {
        let [first, last] = match journey.is_negative[axis] {
            false => [&node.low, &node.high],
            true => [&node.high, &node.low],
        };
        let scale = s.floats(scale[axis]);
        let steps = steps_of(s, first, axis);
        enter = s.max(s.multiply_add(steps, scale, s.floats(near[axis])), enter);
        let steps = steps_of(s, last, axis);
        leave = s.min(s.multiply_add(steps, scale, s.floats(far[axis])), leave);
    }
    let mut times = [0; LANES];
    s.store(&mut times, s.bits_of(enter));
    let all = ((1u32 << node.count) - 1) as Bits;
    (s.bits(s.le_floats(enter, leave)) & all, bytemuck::cast(times))
}

/// Steps along an axis.
#[inline(always)]
fn steps_of<S: Simd>(s: S, corners: &[u32; LANES], axis: usize) -> S::Floats {
    s.to_floats(s.and(s.shr(s.load(bytemuck::cast_ref(corners)), 10 * axis as u32), s.ints(1023)))
}
