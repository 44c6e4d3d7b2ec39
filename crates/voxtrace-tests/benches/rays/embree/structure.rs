//! A built Embree scene with one geometry, and the bytes that Embree says it holds.

use super::ffi;
use std::ffi::{CStr, c_void};
use std::ptr;
use std::sync::atomic::{AtomicI64, Ordering};
use std::time::{Duration, Instant};

/// A device with one committed scene. What the geometry refers to must outlive it.
pub struct Structure {
    /// The scene, for casting.
    pub scene: ffi::RTCScene,
    device: ffi::RTCDevice,
    memory: Box<Memory>,
    build_time: Duration,
}

/// Bytes that Embree holds.
#[derive(Default)]
struct Memory {
    now: AtomicI64,
    most: AtomicI64,
}

unsafe extern "C" fn watch(user: *mut c_void, bytes: isize, _post: bool) -> bool {
    // SAFETY: the user pointer is the `Memory` that lives as long as the device.
    let memory = unsafe { &*user.cast::<Memory>() };
    let now = memory.now.fetch_add(bytes as i64, Ordering::Relaxed) + bytes as i64;
    memory.most.fetch_max(now, Ordering::Relaxed);
    true
}

impl Structure {
    /// Builds the scene of one geometry of type `kind` at Embree's highest quality, on a device with Embree's `config`; `describe` sets its buffers or
    /// callbacks.
    pub fn build(kind: i32, config: &CStr, describe: impl FnOnce(ffi::RTCGeometry)) -> Self {
        let start = Instant::now();
        let memory = Box::<Memory>::default();
        // SAFETY: every handle is used while it lives, and `memory` is boxed and outlives the device.
        let (device, scene) = unsafe {
            let device = ffi::rtcNewDevice(config.as_ptr());
            assert!(!device.is_null(), "Embree finds no device: error {}", ffi::rtcGetDeviceError(ptr::null_mut()));
            let user = (&raw const *memory).cast_mut().cast();
            ffi::rtcSetDeviceMemoryMonitorFunction(device, Some(watch), user);
            let scene = ffi::rtcNewScene(device);
            ffi::rtcSetSceneBuildQuality(scene, ffi::RTC_BUILD_QUALITY_HIGH);
            let geometry = ffi::rtcNewGeometry(device, kind);
            ffi::rtcSetGeometryBuildQuality(geometry, ffi::RTC_BUILD_QUALITY_HIGH);
            describe(geometry);
            ffi::rtcCommitGeometry(geometry);
            ffi::rtcAttachGeometry(scene, geometry);
            ffi::rtcReleaseGeometry(geometry);
            ffi::rtcCommitScene(scene);
            assert_eq!(ffi::rtcGetDeviceError(device), 0, "Embree builds the scene");
            (device, scene)
        };
        Self { scene, device, memory, build_time: start.elapsed() }
    }

    /// Bytes that Embree holds now.
    pub fn bytes(&self) -> u64 {
        self.memory.now.load(Ordering::Relaxed) as u64
    }

    /// Time and memory of the build, for people.
    pub fn build_report(&self) -> String {
        let most = self.memory.most.load(Ordering::Relaxed) as f64;
        format!("built in {:.1} s on all cores, at most {:.2} GB at a time", self.build_time.as_secs_f64(), most * 1e-9)
    }

    /// A property of the device.
    pub fn property(&self, property: i32) -> isize {
        // SAFETY: the device lives.
        unsafe { ffi::rtcGetDeviceProperty(self.device, property) }
    }

    /// Embree's version, for people.
    pub fn version(&self) -> String {
        let version = self.property(ffi::RTC_DEVICE_PROPERTY_VERSION);
        format!("{}.{}.{}", version / 10_000, version / 100 % 100, version % 100)
    }
}

impl Drop for Structure {
    fn drop(&mut self) {
        // SAFETY: both live and are released once.
        unsafe {
            ffi::rtcReleaseScene(self.scene);
            ffi::rtcReleaseDevice(self.device);
        }
    }
}
