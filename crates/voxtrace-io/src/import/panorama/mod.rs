//! Panoramas that become skies: Radiance pictures (`.hdr`) and OpenEXR, told by their first bytes.

#[cfg(feature = "pictures")]
mod exr;
mod radiance;

use super::source::guard::guarded;
use super::source::input::Input;
use std::path::Path;
use voxtrace_scene::glam::Vec3;
use voxtrace_scene::sky::EnvironmentMap;
use voxtrace_voxelize::{ImportError, Limits};

/// Most pixels along one edge.
const MAX_EDGE: usize = 32_768;
/// Pictures beyond this many bytes may not unpack to more than [`Limits::ratio`] times their file.
const FREE_BYTES: u64 = 64 << 20;

/// A picture of linear radiance, row by row from the top.
struct Picture {
    width: usize,
    height: usize,
    pixels: Vec<Vec3>,
}

/// Reads a picture of all directions, by longitude and latitude: `.hdr` or `.exr`.
///
/// # Errors
/// If the file cannot be read, is no such picture, or is too large.
pub fn read_environment(path: &Path, limits: &Limits) -> Result<EnvironmentMap, ImportError> {
    environment_from_bytes(&Input::open(path, limits)?.rest()?, path, limits)
}

/// As [`read_environment`], from the bytes of a file; `path` names it in errors.
///
/// # Errors
/// If they are no such picture, or it is too large.
pub fn environment_from_bytes(bytes: &[u8], path: &Path, limits: &Limits) -> Result<EnvironmentMap, ImportError> {
    let picture = guarded(|| decode(bytes, limits)).map_err(|what| ImportError::malformed(path, 0, what))?;
    EnvironmentMap::from_panorama(picture.width as u32, picture.height as u32, &picture.pixels)
        .map_err(|fault| ImportError::malformed(path, 0, String::from(fault)))
}

fn decode(bytes: &[u8], limits: &Limits) -> Result<Picture, String> {
    if bytes.starts_with(b"#?") {
        return radiance::decode(bytes, limits);
    }
    #[cfg(feature = "pictures")]
    if bytes.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
        return exr::decode(bytes, limits);
    }
    Err("a sky is a Radiance picture (.hdr) or an OpenEXR (.exr), and this is neither".into())
}

/// Most bytes of floats that Deflate makes of one, of floats of 16 bits.
const MOST_OF_DEFLATE: u64 = 2 * 1032;

/// Checks that so many pixels may be unpacked from so many bytes.
fn check_size(width: usize, height: usize, packed: usize, limits: &Limits) -> Result<(), String> {
    if width == 0 || height == 0 {
        return Err("the picture is empty".into());
    }
    let size = (width as u64).saturating_mul(height as u64).saturating_mul(size_of::<Vec3>() as u64);
    let is_bomb = size > FREE_BYTES && size / limits.ratio.max(MOST_OF_DEFLATE) > packed as u64;
    if width > MAX_EDGE || height > MAX_EDGE || size > limits.bytes || is_bomb {
        return Err(format!("a picture of {width} x {height} pixels is more than allowed"));
    }
    Ok(())
}
