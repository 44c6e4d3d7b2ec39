//! The part of Embree 3's C interface that the benchmark calls, declared from its manual and headers (version 3.13).

#![allow(non_camel_case_types, clippy::upper_case_acronyms)]

use std::ffi::{c_char, c_void};

/// A device, a scene, a geometry: Embree's own.
pub type RTCDevice = *mut c_void;
pub type RTCScene = *mut c_void;
pub type RTCGeometry = *mut c_void;

pub const RTC_DEVICE_PROPERTY_VERSION: i32 = 0;
pub const RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED: i32 = 33;
pub const RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED: i32 = 34;
pub const RTC_GEOMETRY_TYPE_QUAD: i32 = 1;
pub const RTC_GEOMETRY_TYPE_USER: i32 = 120;
pub const RTC_BUFFER_TYPE_INDEX: i32 = 0;
pub const RTC_BUFFER_TYPE_VERTEX: i32 = 1;
pub const RTC_FORMAT_UINT4: i32 = 0x5004;
pub const RTC_FORMAT_FLOAT3: i32 = 0x9003;
pub const RTC_BUILD_QUALITY_HIGH: i32 = 2;
pub const RTC_INTERSECT_CONTEXT_FLAG_COHERENT: i32 = 1;
pub const RTC_INVALID_GEOMETRY_ID: u32 = u32::MAX;

#[repr(C)]
pub struct RTCIntersectContext {
    pub flags: i32,
    pub filter: Option<unsafe extern "C" fn(*const c_void)>,
    pub inst_stack_size: u32,
    pub inst_id: [u32; 1],
    pub min_width_distance_factor: f32,
}

#[repr(C, align(16))]
pub struct RTCBounds {
    pub lower: [f32; 4],
    pub upper: [f32; 4],
}

#[repr(C)]
pub struct RTCBoundsFunctionArguments {
    pub geometry_user_ptr: *mut c_void,
    pub prim_id: u32,
    pub time_step: u32,
    pub bounds: *mut RTCBounds,
}

#[repr(C)]
pub struct RTCIntersectFunctionNArguments {
    pub valid: *mut i32,
    pub geometry_user_ptr: *mut c_void,
    pub prim_id: u32,
    pub context: *mut RTCIntersectContext,
    pub rayhit: *mut c_void,
    pub n: u32,
    pub geom_id: u32,
}

/// A packet of N rays and what they meet: RTCRayHit for N = 1, RTCRayHit8, RTCRayHit16. What is handed to Embree lies in
/// an [`Aligned`].
#[repr(C)]
#[derive(Clone, Copy)]
pub struct RayHits<const N: usize> {
    pub origin: [[f32; N]; 3],
    pub tnear: [f32; N],
    pub direction: [[f32; N]; 3],
    pub time: [f32; N],
    pub tfar: [f32; N],
    pub mask: [u32; N],
    pub id: [u32; N],
    pub flags: [u32; N],
    pub normal: [[f32; N]; 3],
    pub u: [f32; N],
    pub v: [f32; N],
    pub prim_id: [u32; N],
    pub geom_id: [u32; N],
    pub inst_id: [u32; N],
}

/// The alignment that Embree asks of its largest packets.
#[repr(C, align(64))]
#[derive(Clone, Copy)]
pub struct Aligned<T>(pub T);

pub type RTCBoundsFunction = unsafe extern "C" fn(*const RTCBoundsFunctionArguments);
pub type RTCIntersectFunctionN = unsafe extern "C" fn(*const RTCIntersectFunctionNArguments);
pub type RTCMemoryMonitorFunction = unsafe extern "C" fn(*mut c_void, isize, bool) -> bool;

#[link(name = "embree3")]
unsafe extern "C" {
    pub fn rtcNewDevice(config: *const c_char) -> RTCDevice;
    pub fn rtcReleaseDevice(device: RTCDevice);
    pub fn rtcGetDeviceError(device: RTCDevice) -> i32;
    pub fn rtcGetDeviceProperty(device: RTCDevice, property: i32) -> isize;
    pub fn rtcSetDeviceMemoryMonitorFunction(
        device: RTCDevice,
        monitor: Option<RTCMemoryMonitorFunction>,
        user: *mut c_void,
    );
    pub fn rtcNewScene(device: RTCDevice) -> RTCScene;
    pub fn rtcReleaseScene(scene: RTCScene);
    pub fn rtcSetSceneBuildQuality(scene: RTCScene, quality: i32);
    pub fn rtcCommitScene(scene: RTCScene);
    pub fn rtcAttachGeometry(scene: RTCScene, geometry: RTCGeometry) -> u32;
    pub fn rtcNewGeometry(device: RTCDevice, kind: i32) -> RTCGeometry;
    pub fn rtcReleaseGeometry(geometry: RTCGeometry);
    pub fn rtcSetGeometryBuildQuality(geometry: RTCGeometry, quality: i32);
    pub fn rtcCommitGeometry(geometry: RTCGeometry);
    pub fn rtcSetSharedGeometryBuffer(
        geometry: RTCGeometry,
        kind: i32,
        slot: u32,
        format: i32,
        data: *const c_void,
        offset_bytes: usize,
        stride_bytes: usize,
        count: usize,
    );
    pub fn rtcSetGeometryUserData(geometry: RTCGeometry, user: *mut c_void);
    pub fn rtcSetGeometryUserPrimitiveCount(geometry: RTCGeometry, count: u32);
    pub fn rtcSetGeometryBoundsFunction(geometry: RTCGeometry, bounds: Option<RTCBoundsFunction>, user: *mut c_void);
    pub fn rtcSetGeometryIntersectFunction(geometry: RTCGeometry, intersect: Option<RTCIntersectFunctionN>);
    pub fn rtcIntersect1(scene: RTCScene, context: *mut RTCIntersectContext, rayhit: *mut RayHits<1>);
    pub fn rtcIntersect8(
        valid: *const i32,
        scene: RTCScene,
        context: *mut RTCIntersectContext,
        rayhit: *mut RayHits<8>,
    );
    pub fn rtcIntersect16(
        valid: *const i32,
        scene: RTCScene,
        context: *mut RTCIntersectContext,
        rayhit: *mut RayHits<16>,
    );
}
