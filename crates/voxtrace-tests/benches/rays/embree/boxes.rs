//! One axis-aligned box for each voxel, as a user geometry whose callback is a slab test (Kay and Kajiya 1986).

use super::cast::{Caster, Context, Found};
use super::ffi::{self, RayHits};
use super::structure::Structure;
use crate::contender::Contender;
use crate::ray_sets::RaySet;
use std::ffi::CStr;
use voxtrace::{VoxelGrid, glam::IVec3};

/// Embree with a box for each voxel.
pub struct Boxes {
    // Before `voxels`, so that it is dropped first.
    structure: Structure,
    voxels: Box<Voxels>,
    caster: Caster,
    table_bytes: u64,
}

/// The voxels: coordinates relative to `low`, and the material.
struct Voxels {
    low: IVec3,
    records: Vec<[u16; 4]>,
}

impl Voxels {
    #[inline(always)]
    fn voxel(&self, index: u32) -> IVec3 {
        let [x, y, z, _] = self.records[index as usize].map(i32::from);
        self.low + IVec3::new(x, y, z)
    }
}

impl Boxes {
    /// Builds the boxes of a grid whose extent is below 65,536. `table_bytes` is the size of the table of materials.
    pub fn build(grid: &VoxelGrid, table_bytes: u64, config: &CStr) -> Self {
        let bounds = grid.bounds().expect("the grid holds a voxel");
        assert!(bounds.size().max_element() <= 1 << 16, "coordinates fit 16 bits");
        let record = |(voxel, material): (IVec3, u16)| {
            let at = voxel - bounds.min;
            [at.x as u16, at.y as u16, at.z as u16, material]
        };
        let mut records = Vec::with_capacity(grid.count() as usize);
        records.extend(grid.voxels().map(record));
        let voxels = Box::new(Voxels { low: bounds.min, records });
        let user = (&raw const *voxels).cast_mut().cast();
        // SAFETY: the geometry lives; `voxels` is boxed and outlives it; the functions have the types that Embree calls.
        let structure = Structure::build(ffi::RTC_GEOMETRY_TYPE_USER, config, |geometry| unsafe {
            ffi::rtcSetGeometryUserData(geometry, user);
            ffi::rtcSetGeometryUserPrimitiveCount(geometry, voxels.records.len() as u32);
            ffi::rtcSetGeometryBoundsFunction(geometry, Some(bounds_of), std::ptr::null_mut());
            ffi::rtcSetGeometryIntersectFunction(geometry, Some(intersect));
        });
        Self { structure, voxels, caster: Caster::new(), table_bytes }
    }
}

impl Contender for Boxes {
    fn name(&self) -> String {
        format!("Embree {}, one box per voxel", self.structure.version())
    }

    fn tune(&mut self, rays: &RaySet) -> &'static str {
        self.caster.tune(&self.structure, rays)
    }

    fn cast(&mut self, rays: &RaySet) {
        self.caster.cast(&self.structure, rays);
    }

    fn found(&self, ray: usize) -> Option<(IVec3, f32)> {
        let found = self.caster.found[ray];
        (found.primitive != Found::NONE).then(|| (self.voxels.voxel(found.primitive), found.t))
    }

    fn memory(&self) -> Vec<(&'static str, u64)> {
        vec![
            ("Embree's hierarchy", self.structure.bytes()),
            ("voxels with material", size_of_val(&*self.voxels.records) as u64),
            ("materials", self.table_bytes),
        ]
    }

    fn build(&self) -> String {
        self.structure.build_report()
    }
}

unsafe extern "C" fn bounds_of(args: *const ffi::RTCBoundsFunctionArguments) {
    // SAFETY: Embree hands over valid arguments with the user pointer of the geometry, which is its `Voxels`.
    unsafe {
        let args = &*args;
        let voxels = &*args.geometry_user_ptr.cast::<Voxels>();
        let low = voxels.voxel(args.prim_id).as_vec3();
        let high = low + 1.0;
        *args.bounds = ffi::RTCBounds { lower: [low.x, low.y, low.z, 0.0], upper: [high.x, high.y, high.z, 0.0] };
    }
}

unsafe extern "C" fn intersect(args: *const ffi::RTCIntersectFunctionNArguments) {
    // SAFETY: Embree hands over valid arguments for packets of `n` rays; wide code runs where the processor has it.
    unsafe {
        let args = &*args;
        match args.n {
            1 => intersect_lanes::<1>(args),
            #[cfg(target_arch = "x86_64")]
            8 if is_x86_feature_detected!("avx2") => intersect_avx2(args),
            8 => intersect_lanes::<8>(args),
            #[cfg(target_arch = "x86_64")]
            16 if is_x86_feature_detected!("avx512f") => intersect_avx512(args),
            16 => intersect_lanes::<16>(args),
            lanes => unreachable!("Embree has no packets of {lanes} rays"),
        }
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn intersect_avx2(args: &ffi::RTCIntersectFunctionNArguments) {
    // SAFETY: as for `intersect`.
    unsafe { intersect_lanes::<8>(args) }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f")]
unsafe fn intersect_avx512(args: &ffi::RTCIntersectFunctionNArguments) {
    // SAFETY: as for `intersect`.
    unsafe { intersect_lanes::<16>(args) }
}

/// Tests a packet of N rays against one voxel and records entries that are nearer than the nearest hits so far.
#[inline(always)]
unsafe fn intersect_lanes<const N: usize>(args: &ffi::RTCIntersectFunctionNArguments) {
    // SAFETY: the pointers are those of `intersect`'s caller; every context that we cast with is a `Context`, and `lanes`
    // is its width.
    let (voxels, valid, rays, inverse) = unsafe {
        assert_eq!((*args.context.cast::<Context<0>>()).lanes, N as u32, "Embree hands on whole packets");
        let voxels = &*args.geometry_user_ptr.cast::<Voxels>();
        let valid = &*args.valid.cast::<[i32; N]>();
        (voxels, valid, &mut *args.rayhit.cast::<RayHits<N>>(), &(*args.context.cast::<Context<N>>()).inverse)
    };
    let low = voxels.voxel(args.prim_id).as_vec3();
    for lane in 0..N {
        let (mut enter, mut leave) = (rays.tnear[lane], rays.tfar[lane]);
        for axis in 0..3 {
            let near = (low[axis] - rays.origin[axis][lane]) * inverse[axis][lane];
            let far = (low[axis] + 1.0 - rays.origin[axis][lane]) * inverse[axis][lane];
            enter = larger(smaller(near, far), enter);
            leave = smaller(larger(near, far), leave);
        }
        let is_hit = (valid[lane] != 0) & (enter <= leave);
        rays.tfar[lane] = if is_hit { enter } else { rays.tfar[lane] };
        rays.prim_id[lane] = if is_hit { args.prim_id } else { rays.prim_id[lane] };
        rays.geom_id[lane] = if is_hit { args.geom_id } else { rays.geom_id[lane] };
    }
}

/// The smaller number, `b` where one is NaN: one machine instruction, unlike `f32::min`.
#[inline(always)]
fn smaller(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// The larger number, `b` where one is NaN.
#[inline(always)]
fn larger(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
