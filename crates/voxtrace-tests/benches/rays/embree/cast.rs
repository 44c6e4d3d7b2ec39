//! Embree's functions for casting rays (single rays, packets, streams), and the choice of the fastest.

use super::ffi::{self, Aligned, RTCIntersectContext, RTCScene, RayHits};
use super::structure::Structure;
use crate::clock;
use crate::ray_sets::RaySet;
use std::array::from_fn;
use std::ptr;
use std::time::Duration;
use voxtrace::Ray;

/// What a ray met.
#[derive(Clone, Copy)]
pub struct Found {
    /// Number of the primitive, [`Found::NONE`] for a miss.
    pub primitive: u32,
    /// Where the ray meets it.
    pub t: f32,
}

impl Found {
    /// The primitive of a miss.
    pub const NONE: u32 = u32::MAX;
    const MISS: Self = Self { primitive: Self::NONE, t: f32::INFINITY };
}

/// Embree's context, extended by the reciprocal directions of the rays, so that the callback does not divide for every box.
#[repr(C)]
pub struct Context<const N: usize> {
    /// The part that Embree knows.
    pub embree: RTCIntersectContext,
    /// Rays of the packet, N.
    pub lanes: u32,
    /// 1 / direction of each ray.
    pub inverse: [[f32; N]; 3],
}

impl<const N: usize> Context<N> {
    fn new(is_coherent: bool) -> Self {
        let embree = RTCIntersectContext {
            flags: if is_coherent { ffi::RTC_INTERSECT_CONTEXT_FLAG_COHERENT } else { 0 },
            filter: None,
            inst_stack_size: 0,
            inst_id: [ffi::RTC_INVALID_GEOMETRY_ID],
            min_width_distance_factor: 0.0,
        };
        Self { embree, lanes: N as u32, inverse: [[0.0; N]; 3] }
    }

    fn set_inverse(&mut self, rays: &RayHits<N>) {
        for axis in 0..3 {
            self.inverse[axis] = rays.direction[axis].map(|direction| 1.0 / direction);
        }
    }

    /// The pointer for Embree. Its provenance covers the whole record, because the callback reads past Embree's part.
    fn pointer(&mut self) -> *mut RTCIntersectContext {
        ptr::from_mut(self).cast()
    }
}

/// One of Embree's functions for casting rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Way {
    Single,
    Packet8,
    Packet16,
}

impl Way {
    fn name(self) -> &'static str {
        match self {
            Self::Single => "rtcIntersect1",
            Self::Packet8 => "rtcIntersect8",
            Self::Packet16 => "rtcIntersect16",
        }
    }

    fn is_there(self, structure: &Structure) -> bool {
        match self {
            Self::Single => true,
            Self::Packet8 => structure.property(ffi::RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0,
            Self::Packet16 => structure.property(ffi::RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0,
        }
    }
}

/// Casts rays through a scene.
pub struct Caster {
    way: Way,
    /// What the rays of the last cast met.
    pub found: Vec<Found>,
}

impl Caster {
    /// A caster of rays one by one.
    pub fn new() -> Self {
        Self { way: Way::Single, found: Vec::new() }
    }

    /// Selects the function that is fastest for these rays, by the better of two runs of each. Returns its name.
    pub fn tune(&mut self, structure: &Structure, rays: &RaySet) -> &'static str {
        self.found.clear();
        self.found.resize(rays.rays.len(), Found::MISS);
        let mut fastest = (Duration::MAX, Way::Single);
        let ways = [Way::Single, Way::Packet8, Way::Packet16];
        for way in ways.into_iter().filter(|way| way.is_there(structure)) {
            self.way = way;
            let time = (0..2).map(|_| clock::time(|| self.cast(structure, rays))).min().unwrap_or_default();
            if time < fastest.0 {
                fastest = (time, way);
            }
        }
        self.way = fastest.1;
        self.way.name()
    }

    /// Casts all rays.
    pub fn cast(&mut self, structure: &Structure, rays: &RaySet) {
        let (scene, is_coherent) = (structure.scene, rays.is_coherent);
        match self.way {
            Way::Single => cast_single(scene, is_coherent, &rays.rays, &mut self.found),
            Way::Packet8 => cast_packets(ffi::rtcIntersect8, scene, is_coherent, &rays.rays, &mut self.found),
            Way::Packet16 => cast_packets(ffi::rtcIntersect16, scene, is_coherent, &rays.rays, &mut self.found),
        }
    }
}

impl<const N: usize> RayHits<N> {
    /// The packet of up to N rays; the last one fills what is left.
    fn of(rays: &[Ray]) -> Self {
        let ray = |lane: usize| &rays[lane.min(rays.len() - 1)];
        Self {
            origin: from_fn(|axis| from_fn(|lane| ray(lane).origin[axis])),
            tnear: from_fn(|lane| ray(lane).t_min),
            direction: from_fn(|axis| from_fn(|lane| ray(lane).direction[axis])),
            time: [0.0; N],
            tfar: from_fn(|lane| ray(lane).t_max),
            mask: [u32::MAX; N],
            id: [0; N],
            flags: [0; N],
            normal: [[0.0; N]; 3],
            u: [0.0; N],
            v: [0.0; N],
            prim_id: [Found::NONE; N],
            geom_id: [ffi::RTC_INVALID_GEOMETRY_ID; N],
            inst_id: [ffi::RTC_INVALID_GEOMETRY_ID; N],
        }
    }

    fn found(&self, lane: usize) -> Found {
        Found { primitive: self.prim_id[lane], t: self.tfar[lane] }
    }
}

fn cast_single(scene: RTCScene, is_coherent: bool, rays: &[Ray], found: &mut [Found]) {
    let mut context = Context::<1>::new(is_coherent);
    for (ray, found) in rays.iter().zip(found) {
        let mut packet = Aligned(RayHits::<1>::of(std::slice::from_ref(ray)));
        context.set_inverse(&packet.0);
        // SAFETY: the scene is committed; context and packet have Embree's layout and alignment.
        unsafe { ffi::rtcIntersect1(scene, context.pointer(), &raw mut packet.0) };
        *found = packet.0.found(0);
    }
}

type Intersect<const N: usize> = unsafe extern "C" fn(*const i32, RTCScene, *mut RTCIntersectContext, *mut RayHits<N>);

fn cast_packets<const N: usize>(
    intersect: Intersect<N>,
    scene: RTCScene,
    is_coherent: bool,
    rays: &[Ray],
    found: &mut [Found],
) {
    let mut context = Context::<N>::new(is_coherent);
    for (rays, found) in rays.chunks(N).zip(found.chunks_mut(N)) {
        let mut packet = Aligned(RayHits::<N>::of(rays));
        let valid: Aligned<[i32; N]> = Aligned(from_fn(|lane| if lane < rays.len() { -1 } else { 0 }));
        context.set_inverse(&packet.0);
        // SAFETY: the scene is committed; mask, context and packet have Embree's layout and alignment.
        unsafe { intersect(valid.0.as_ptr(), scene, context.pointer(), &raw mut packet.0) };
        for (lane, found) in found.iter_mut().enumerate() {
            *found = packet.0.found(lane);
        }
    }
}
