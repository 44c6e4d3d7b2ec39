//! Intel's Open Image Denoise, loaded at run time where it is installed: its C interface, version 2
//! (<https://www.openimagedenoise.org/documentation.html>), as far as a picture with albedos and normals needs it.

#![allow(unsafe_code, reason = "the library has a C interface; each block says why it is sound")]

mod places;

use glam::Vec3;
use libloading::Library;
use std::ffi::{CStr, c_char, c_int, c_void};
use std::path::{Path, PathBuf};

pub use places::VARIABLE;

/// Open Image Denoise cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum OidnError {
    /// The library is nowhere.
    #[error("Open Image Denoise was not found: {0}")]
    NotFound(String),
    /// What was found lacks a function of version 2.
    #[error("{}: this is not Open Image Denoise 2: {reason}", path.display())]
    Version {
        /// The library.
        path: PathBuf,
        /// What it lacks.
        reason: String,
    },
    /// The pictures have other sizes than was said.
    #[error("a picture has {found} pixels instead of {expected}")]
    Size {
        /// Width times height.
        expected: usize,
        /// Pixels of the picture.
        found: usize,
    },
    /// The library reports an error.
    #[error("Open Image Denoise: {0}")]
    Failed(String),
    /// Nobody waits for it any more: see [`Oidn::denoise_while`].
    #[error("the picture without noise is not wanted any more")]
    Stopped,
}

/// `OIDN_DEVICE_TYPE_CPU`.
const DEVICE_CPU: c_int = 1;
/// `OIDN_FORMAT_FLOAT3`.
const FORMAT_FLOAT3: c_int = 3;

type Device = *mut c_void;
type Filter = *mut c_void;
/// `OIDNProgressMonitorFunction`: is given what was set beside it and the share that is done, and returns whether to go on.
type Monitor = unsafe extern "C" fn(*mut c_void, f64) -> bool;

/// The functions that are called, as `oidn.h` declares them.
struct Functions {
    new_device: unsafe extern "C" fn(c_int) -> Device,
    set_device_bool: unsafe extern "C" fn(Device, *const c_char, bool),
    commit_device: unsafe extern "C" fn(Device),
    release_device: unsafe extern "C" fn(Device),
    device_error: unsafe extern "C" fn(Device, *mut *const c_char) -> c_int,
    new_filter: unsafe extern "C" fn(Device, *const c_char) -> Filter,
    set_image: unsafe extern "C" fn(Filter, *const c_char, *mut c_void, c_int, usize, usize, usize, usize, usize),
    set_filter_bool: unsafe extern "C" fn(Filter, *const c_char, bool),
    set_monitor: unsafe extern "C" fn(Filter, Monitor, *mut c_void),
    commit_filter: unsafe extern "C" fn(Filter),
    execute_filter: unsafe extern "C" fn(Filter),
    release_filter: unsafe extern "C" fn(Filter),
}

/// The library, loaded.
pub struct Oidn {
    functions: Functions,
    path: PathBuf,
    // Last: what the functions point into.
    _library: Library,
}

impl Oidn {
    /// Looks for the library and loads it.
    ///
    /// # Errors
    /// [`OidnError::NotFound`], [`OidnError::Version`].
    pub fn open() -> Result<Self, OidnError> {
        Self::open_of(&[])
    }

    /// As [`Self::open`], and looks first into `packages`, the `site-packages` of the Python that asks.
    ///
    /// # Errors
    /// As [`Self::open`].
    pub fn open_of(packages: &[PathBuf]) -> Result<Self, OidnError> {
        let named = places::is_named();
        first_of(&places::places(packages), named, |path| {
            // SAFETY: loading runs the library's initializers; it is the one that the user named or installed.
            let library = unsafe { Library::new(path) };
            let library = library.map_err(|error| OidnError::NotFound(format!("{}: {error}", path.display())))?;
            Self::of(library, path.to_owned())
        })
    }

    fn of(library: Library, path: PathBuf) -> Result<Self, OidnError> {
        let functions = Functions::of(&library)
            .map_err(|error| OidnError::Version { path: path.clone(), reason: error.to_string() })?;
        Ok(Self { functions, path, _library: library })
    }

    /// The library that was found.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Filters a picture of linear radiance. Each picture has `width` · `height` pixels, row by row; albedos are in [0, 1], normals unit
    /// vectors or 0.
    ///
    /// # Errors
    /// [`OidnError::Size`]; [`OidnError::Failed`] where the library reports an error.
    pub fn denoise(
        &self,
        width: usize,
        height: usize,
        color: &[Vec3],
        albedo: &[Vec3],
        normal: &[Vec3],
    ) -> Result<Vec<Vec3>, OidnError> {
        self.denoise_while((width, height), color, albedo, normal, &|| true)
    }

    /// As [`Self::denoise`], of a picture of this width and height, as long as it is `wanted`, which is asked now and then, on several threads, and which says no
    /// for good.
    ///
    /// # Errors
    /// As [`Self::denoise`]; [`OidnError::Stopped`] once it is not wanted any more.
    pub fn denoise_while(
        &self,
        (width, height): (usize, usize),
        color: &[Vec3],
        albedo: &[Vec3],
        normal: &[Vec3],
        wanted: &(dyn Fn() -> bool + Sync),
    ) -> Result<Vec<Vec3>, OidnError> {
        let expected = width.saturating_mul(height);
        if let Some(found) = [color, albedo, normal].map(<[Vec3]>::len).into_iter().find(|&found| found != expected) {
            return Err(OidnError::Size { expected, found });
        }
        let call = &self.functions;
        // SAFETY: a kind of device that the header lists.
        let device = Handle { raw: unsafe { (call.new_device)(DEVICE_CPU) }, release: call.release_device };
        if device.raw.is_null() {
            return Err(OidnError::Failed("no device for the processor".into()));
        }
        // SAFETY: `device` is one and not committed yet. The process's threads stay where the system puts them.
        unsafe { (call.set_device_bool)(device.raw, c"setAffinity".as_ptr(), false) };
        // SAFETY: as above.
        unsafe { (call.commit_device)(device.raw) };
        self.check(device.raw)?;
        // SAFETY: the device is committed; `RT` is the filter for path-traced pictures.
        let raw = unsafe { (call.new_filter)(device.raw, c"RT".as_ptr()) };
        let filter = Handle { raw, release: call.release_filter };
        self.check(device.raw)?;
        let mut output = vec![Vec3::ZERO; expected];
        let image = |name: &CStr, pixels: *mut c_void| {
            // SAFETY: `pixels` points to width · height triples of floats, which outlive the filter; the library
            // writes into the one called `output` alone, and that one was borrowed mutably.
            unsafe { (call.set_image)(filter.raw, name.as_ptr(), pixels, FORMAT_FLOAT3, width, height, 0, 0, 0) };
        };
        image(c"color", color.as_ptr().cast_mut().cast());
        image(c"albedo", albedo.as_ptr().cast_mut().cast());
        image(c"normal", normal.as_ptr().cast_mut().cast());
        image(c"output", output.as_mut_ptr().cast());
        // SAFETY: the filter is one of the device's, its images are set.
        unsafe { (call.set_filter_bool)(filter.raw, c"hdr".as_ptr(), true) };
        // SAFETY: the filter is one of the device's; `wanted` outlives it, and any thread may call it.
        unsafe { (call.set_monitor)(filter.raw, goes_on, (&raw const wanted).cast_mut().cast()) };
        // SAFETY: as above.
        unsafe { (call.commit_filter)(filter.raw) };
        self.check(device.raw)?;
        // SAFETY: as above; it returns when the output is written.
        unsafe { (call.execute_filter)(filter.raw) };
        let checked = self.check(device.raw);
        // Then the library reports that it was cancelled.
        if !wanted() {
            return Err(OidnError::Stopped);
        }
        checked?;
        drop(filter);
        Ok(output)
    }

    /// What the device has to complain about since the last call.
    fn check(&self, device: Device) -> Result<(), OidnError> {
        let mut message = std::ptr::null();
        // SAFETY: `device` is one; the message is null or a text that lives until the next call for this device.
        if unsafe { (self.functions.device_error)(device, &raw mut message) } == 0 {
            return Ok(());
        }
        if message.is_null() {
            return Err(OidnError::Failed("it does not say why".into()));
        }
        // SAFETY: as above, and not null.
        Err(OidnError::Failed(unsafe { CStr::from_ptr(message) }.to_string_lossy().into_owned()))
    }
}

/// Answers the library whether somebody waits for its picture: `wanted` is the address of what `denoise_while` was given.
unsafe extern "C" fn goes_on(wanted: *mut c_void, _done: f64) -> bool {
    // SAFETY: it points there, and that lives until the filter is done.
    let wanted = unsafe { &*wanted.cast::<&(dyn Fn() -> bool + Sync)>() };
    wanted()
}

/// The first library that is one, of those at some places: version 1, which systems still have, must not hide another that was installed.
fn first_of<T>(
    places: &[PathBuf],
    is_named: bool,
    open: impl Fn(&Path) -> Result<T, OidnError>,
) -> Result<T, OidnError> {
    let (mut reasons, mut unfit) = (Vec::new(), None);
    for path in places {
        match open(path) {
            Ok(library) => return Ok(library),
            Err(OidnError::NotFound(reason)) => reasons.push(reason),
            Err(error) => unfit = unfit.or(Some(error)),
        }
    }
    Err(unfit.unwrap_or_else(|| {
        OidnError::NotFound(if is_named {
            reasons.join("; ")
        } else {
            format!("it is not among the system's libraries, and {VARIABLE} does not say where it is")
        })
    }))
}

/// A device or a filter, released when it is dropped.
struct Handle {
    raw: *mut c_void,
    release: unsafe extern "C" fn(*mut c_void),
}

impl Drop for Handle {
    fn drop(&mut self) {
        if !self.raw.is_null() {
            // SAFETY: it came from the function that `release` belongs to and is released once.
            unsafe { (self.release)(self.raw) };
        }
    }
}

impl Functions {
    fn of(library: &Library) -> Result<Self, libloading::Error> {
        macro_rules! function {
            ($name:literal) => {
                // SAFETY: the type is that of the function in `oidn.h`, version 2; the library outlives it in `Oidn`.
                *unsafe { library.get($name) }?
            };
        }
        Ok(Self {
            new_device: function!(b"oidnNewDevice\0"),
            set_device_bool: function!(b"oidnSetDeviceBool\0"),
            commit_device: function!(b"oidnCommitDevice\0"),
            release_device: function!(b"oidnReleaseDevice\0"),
            device_error: function!(b"oidnGetDeviceError\0"),
            new_filter: function!(b"oidnNewFilter\0"),
            set_image: function!(b"oidnSetSharedFilterImage\0"),
            set_filter_bool: function!(b"oidnSetFilterBool\0"),
            set_monitor: function!(b"oidnSetFilterProgressMonitorFunction\0"),
            commit_filter: function!(b"oidnCommitFilter\0"),
            execute_filter: function!(b"oidnExecuteFilter\0"),
            release_filter: function!(b"oidnReleaseFilter\0"),
        })
    }
}

/// The example of the crate's page, compiled.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_older_library_does_not_hide_one_that_comes_later() {
        let places = ["gone", "old", "new", "newer"].map(PathBuf::from);
        let open = |path: &Path| match path.to_str() {
            Some("gone") => Err(OidnError::NotFound("gone: no such file".into())),
            Some("old") => Err(OidnError::Version { path: path.to_owned(), reason: "oidnNewDevice is missing".into() }),
            _ => Ok(path.to_owned()),
        };
        assert_eq!(first_of(&places, false, open).unwrap(), Path::new("new"));
        // Where there is no other it is said which one does not fit, and else why nothing was loaded.
        assert!(
            matches!(first_of(&places[..2], false, open), Err(OidnError::Version { path, .. }) if path == Path::new("old"))
        );
        let told = |is_named: bool| first_of(&places[..1], is_named, open).unwrap_err().to_string();
        assert!(told(true).contains("gone: no such file") && told(false).contains(VARIABLE));
    }
}
