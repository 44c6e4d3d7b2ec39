//! Lights chosen for many receivers at once, by the vector instructions that the processor has. Each gets what [`Lights::sample`] gives it, to
//! the bit: the ways down the trees of emitters are taken sixteen at a time, which also lets their loads wait together.

#![expect(unsafe_code, reason = "calls of functions for certain processors, and gathers")]

mod descent;
mod fall;
mod kernel;
#[cfg(test)]
mod tests;
mod ways;

use super::emitters::{Chosen, Odds, emitter_sample, in_grid};
use super::{LightSample, Lights, Receiver, Technique};
use crate::packed::{Emitter, LightNode, PackedScene};
use crate::walk::Instructions;
#[cfg(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128")))]
use crate::walk::simd::Portable;
use crate::walk::simd::Simd;
use voxtrace_scene::ray::FACES;
pub use ways::CAPACITY;
use ways::{CHOICE, COUNT, EMITTER, INDEX, NODE, POWER, SHARE, SIDE, TOTAL, WEIGHT, WITHIN, Ways};

/// A receiver that a light is chosen for, and the random numbers that choose.
#[derive(Clone, Copy, Default)]
pub struct Asked {
    /// The receiver.
    pub receiver: Receiver,
    /// As for [`Lights::sample`].
    pub u: [f32; 4],
}

/// Room for the choice of many lights, kept from one to the next.
pub struct Room {
    ways: Box<Ways>,
    /// Which of the asked ones each way belongs to, and the instance it led to.
    places: [u32; CAPACITY],
    instances: [u32; CAPACITY],
}

impl Default for Room {
    fn default() -> Self {
        Self { ways: Ways::none(), places: [0; CAPACITY], instances: [0; CAPACITY] }
    }
}

/// Chooses a light for each of the asked ones, as [`Lights::sample`] does, by instructions that the processor has.
pub fn sample_all(
    instructions: Instructions,
    lights: &Lights,
    asked: &[Asked],
    room: &mut Room,
    found: &mut [Option<LightSample>],
) {
    let scene = lights.emitters.scene;
    if instructions == Instructions::Scalar || !instructions.is_available() || !is_within_reach(scene) {
        for (Asked { receiver, u }, found) in asked.iter().zip(found) {
            *found = lights.sample(receiver, *u);
        }
        return;
    }
    for (asked, found) in asked.chunks(CAPACITY).zip(found.chunks_mut(CAPACITY)) {
        let task = Task { lights, scene, asked };
        // SAFETY: the processor has the instructions; packing and opening give valid scenes only.
        unsafe {
            match instructions {
                #[cfg(target_arch = "x86_64")]
                Instructions::Avx512 => by_avx512(&task, room, found),
                #[cfg(target_arch = "x86_64")]
                Instructions::Avx2 => by_avx2(&task, room, found),
                #[cfg(target_arch = "aarch64")]
                Instructions::Neon => task.run(crate::walk::simd::Neon, room, found),
                #[cfg(target_feature = "simd128")]
                Instructions::Simd128 => task.run(crate::walk::simd::Simd128, room, found),
                // Modules for pages have no second copy; there arrays are not available.
                #[cfg(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128"))]
                _ => return,
                #[cfg(not(all(target_arch = "wasm32", target_os = "unknown", target_feature = "simd128")))]
                _ => task.run(Portable, room, found),
            }
        }
    }
}

/// Whether words of nodes and emitters have numbers that lanes hold.
fn is_within_reach(scene: &PackedScene) -> bool {
    let (geometry, placement) = (&scene.geometry, &scene.placement);
    let has_most = |count: usize, bytes: usize| count <= i32::MAX as usize / (bytes / size_of::<u32>());
    has_most(geometry.light_nodes.len().max(placement.light_nodes.len()), size_of::<LightNode>())
        && has_most(geometry.emitters.len(), size_of::<Emitter>())
}

/// # Safety
/// As for [`Task::run`].
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,popcnt,bmi1,bmi2,lzcnt")]
unsafe fn by_avx2(task: &Task, room: &mut Room, found: &mut [Option<LightSample>]) {
    // SAFETY: the caller's duty.
    unsafe { task.run(crate::walk::simd::Avx2::assume(), room, found) };
}

/// # Safety
/// As for [`Task::run`].
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,popcnt,bmi1,bmi2,lzcnt,avx2")]
unsafe fn by_avx512(task: &Task, room: &mut Room, found: &mut [Option<LightSample>]) {
    // SAFETY: the caller's duty.
    unsafe { task.run(crate::walk::simd::Avx512::assume(), room, found) };
}

/// At most [`CAPACITY`] receivers.
struct Task<'a> {
    lights: &'a Lights<'a>,
    scene: &'a PackedScene,
    asked: &'a [Asked],
}

impl Task<'_> {
    /// # Safety
    /// The processor must have the instructions, and the scene must be valid.
    #[inline(always)]
    unsafe fn run<S: Simd>(&self, s: S, room: &mut Room, found: &mut [Option<LightSample>]) {
        let (geometry, placement) = (&*self.scene.geometry, &self.scene.placement);
        let (top, nodes) = (&*placement.light_nodes, &*geometry.light_nodes);
        self.begin(top, room, found);
        if top.first().is_some_and(|root| root.count == 0) {
            // SAFETY: the caller's duty; ways only stand at nodes.
            unsafe { descent::descend(s, top, false, &mut room.ways) };
        }
        self.enter_grids(top, nodes, room);
        // SAFETY: as above.
        unsafe { descent::descend(s, nodes, true, &mut room.ways) };
        // SAFETY: as above; leaves hold emitters.
        unsafe {
            fall::choose_sides(s, nodes, &mut room.ways);
            fall::to_leaves(s, nodes, &mut room.ways);
            fall::to_emitters(s, &geometry.emitters, &mut room.ways);
        }
        for way in 0..room.ways.count {
            found[room.places[way] as usize] = self.finish(room, way);
        }
    }

    /// Chooses among the techniques; those that take an emitter begin at the top of the tree over instances.
    #[inline(always)]
    fn begin(&self, top: &[LightNode], room: &mut Room, found: &mut [Option<LightSample>]) {
        let Room { ways, places, .. } = room;
        ways.count = 0;
        for (place, (Asked { receiver, u }, found)) in self.asked.iter().zip(found).enumerate() {
            *found = None;
            let (choice, pdf) = match self.lights.technique(receiver, u[0]) {
                Technique::Emitters { choice, pdf } => (choice, pdf),
                other => {
                    *found = self.lights.sample_by(other, receiver, *u);
                    continue;
                }
            };
            let Some(root) = top.first() else { continue };
            let way = ways.count;
            ways.count += 1;
            places[way] = place as u32;
            ways.set_receiver(way, receiver);
            ways.floats[WEIGHT][way] = 1.0;
            ways.floats[TOTAL][way] = 1.0;
            ways.floats[CHOICE][way] = choice;
            ways.floats[WITHIN][way] = u[1];
            ways.floats[SHARE][way] = pdf;
            ways.integers[NODE][way] = 0;
            ways.integers[INDEX][way] = root.index as i32;
            ways.integers[COUNT][way] = root.count as i32;
        }
    }

    /// Lets the ways that came to an instance go on at the top of the tree of its grid, and forgets the others.
    #[inline(always)]
    fn enter_grids(&self, top: &[LightNode], nodes: &[LightNode], room: &mut Room) {
        let Room { ways, places, instances, .. } = room;
        let all = std::mem::take(&mut ways.count);
        for from in 0..all {
            if ways.integers[COUNT][from] == 0 {
                continue;
            }
            let way = ways.count;
            let instance = ways.integers[INDEX][from] as u32;
            let root = top[ways.integers[NODE][from] as usize].root;
            let LightNode { index, count, .. } = nodes[root as usize];
            for place in [WEIGHT, TOTAL, CHOICE, WITHIN, SHARE] {
                ways.floats[place][way] = ways.floats[place][from];
            }
            let local = in_grid(&self.scene.placement.instances[instance as usize], &ways.receiver(from));
            ways.set_receiver(way, &local);
            places[way] = places[from];
            instances[way] = instance;
            ways.integers[NODE][way] = root as i32;
            ways.integers[INDEX][way] = index as i32;
            ways.integers[COUNT][way] = count as i32;
            ways.count += 1;
        }
    }

    /// The light of a way, if it came to an emitter.
    #[inline(always)]
    fn finish(&self, room: &Room, way: usize) -> Option<LightSample> {
        let Room { ways, places, instances } = room;
        let emitter = u32::try_from(ways.integers[EMITTER][way]).ok()?;
        let odds = Odds { weight: ways.floats[WEIGHT][way], total: ways.floats[TOTAL][way] };
        let side = FACES[ways.integers[SIDE][way] as usize];
        let chosen = Chosen { emitter, side, power: ways.floats[POWER][way] };
        let Asked { receiver, u } = &self.asked[places[way] as usize];
        let place = (instances[way], ways.receiver(way).point);
        let sample = emitter_sample(&self.lights.emitters, receiver, place, odds, chosen, *u)?;
        Some(LightSample { pdf: sample.pdf * ways.floats[SHARE][way], ..sample })
    }
}
