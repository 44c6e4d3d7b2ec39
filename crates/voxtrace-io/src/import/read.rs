//! Functions for whoever has a path or bytes and wants the readers of this build.

use super::load::Loaded;
use super::reader::{Data, Geometry, ImportOptions, LargeGeometry, LargeVolume, Reader, Voxels};
use super::readers::READERS;
use std::path::Path;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::mesh::Mesh;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// The reader of a file or folder.
///
/// # Errors
/// If it cannot be opened or has no known format.
pub fn detect(path: &Path, options: &ImportOptions) -> Result<&'static Reader, ImportError> {
    Ok(READERS.open(path, options)?.reader())
}

/// As [`super::Opened::open_large`], for a file.
///
/// # Errors
/// As [`super::Opened::open_large`]; also if the file cannot be opened or has no known format.
pub fn open_large(path: &Path, options: &ImportOptions, budget: u64) -> Result<Option<LargeGeometry>, ImportError> {
    READERS.open(path, options)?.open_large(budget)
}

/// As [`super::Opened::open_large_volume`], for a file or a folder.
///
/// # Errors
/// As [`super::Opened::open_large_volume`]; also if it cannot be opened or has no known format.
pub fn open_large_volume(
    path: &Path,
    options: &ImportOptions,
    budget: u64,
) -> Result<Option<LargeVolume>, ImportError> {
    READERS.open(path, options)?.open_large_volume(budget)
}

/// Loads a scene from a file or a folder whose format is told by its first bytes, or where they say nothing by its extension.
///
/// # Errors
/// If it cannot be read, has no known format, is not what its format says, or there is nothing to be seen.
pub fn load(path: &Path, options: &ImportOptions) -> Result<Loaded, ImportError> {
    READERS.open(path, options)?.load()
}

/// As [`load`], from bytes in memory; `path` names them in errors and tells their format by its extension where the first bytes
/// do not. Files that they refer to are not looked for.
///
/// # Errors
/// As [`load`].
pub fn load_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Loaded, ImportError> {
    READERS.open_bytes(bytes, path, options)?.load()
}

/// As [`load`], for whoever wants the scene alone.
///
/// # Errors
/// As [`load`].
pub fn open(path: &Path, options: &ImportOptions) -> Result<Scene, ImportError> {
    // Not mapped: what is unpacked takes more memory anyway.
    Ok(load(path, &ImportOptions { in_memory: true, ..options.clone() })?.content.into_scene())
}

/// Reads a file or a folder without making voxels of it.
///
/// # Errors
/// As [`load`].
pub fn read(path: &Path, options: &ImportOptions) -> Result<Data, ImportError> {
    READERS.open(path, options)?.read()
}

/// As [`read`], from bytes in memory, which are named as those of [`load_bytes`].
///
/// # Errors
/// As [`read`].
pub fn read_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Data, ImportError> {
    READERS.open_bytes(bytes, path, options)?.read()
}

/// As [`read`], for a file of a mesh or points.
///
/// # Errors
/// As [`read`]; also if the file holds something else.
pub fn read_geometry(path: &Path, options: &ImportOptions) -> Result<Geometry, ImportError> {
    geometry_of(read(path, options)?, path)
}

/// As [`read_bytes`], for a mesh or points.
///
/// # Errors
/// As [`read_geometry`].
pub fn geometry_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Geometry, ImportError> {
    geometry_of(read_bytes(bytes, path, options)?, path)
}

/// As [`read`], for a file of a mesh.
///
/// # Errors
/// As [`read`]; also if the file holds something else.
pub fn read_mesh(path: &Path, options: &ImportOptions) -> Result<Mesh, ImportError> {
    mesh_of(read(path, options)?, path)
}

/// As [`read_bytes`], for a mesh.
///
/// # Errors
/// As [`read_mesh`].
pub fn mesh_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Mesh, ImportError> {
    mesh_of(read_bytes(bytes, path, options)?, path)
}

/// As [`read`], for a file of a volume.
///
/// # Errors
/// As [`read`]; also if the file holds something else.
pub fn read_volume(path: &Path, options: &ImportOptions) -> Result<Volume, ImportError> {
    volume_of(read(path, options)?, path)
}

/// As [`read_bytes`], for a volume.
///
/// # Errors
/// As [`read_volume`].
pub fn volume_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Volume, ImportError> {
    volume_of(read_bytes(bytes, path, options)?, path)
}

/// As [`read`], for a file of voxels.
///
/// # Errors
/// As [`read`]; also if the file holds something else.
pub fn read_voxels(path: &Path, options: &ImportOptions) -> Result<Voxels, ImportError> {
    voxels_of(read(path, options)?, path)
}

/// As [`read_bytes`], for voxels.
///
/// # Errors
/// As [`read_voxels`].
pub fn voxels_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Voxels, ImportError> {
    voxels_of(read_bytes(bytes, path, options)?, path)
}

fn geometry_of(data: Data, path: &Path) -> Result<Geometry, ImportError> {
    match data {
        Data::Geometry(geometry) => Ok(geometry),
        _ => Err(other(path, "the file holds neither a mesh nor points")),
    }
}

fn mesh_of(data: Data, path: &Path) -> Result<Mesh, ImportError> {
    match geometry_of(data, path)? {
        Geometry::Mesh(mesh) => Ok(mesh),
        Geometry::Points(_) => Err(other(path, "the file holds points, but no mesh")),
    }
}

fn volume_of(data: Data, path: &Path) -> Result<Volume, ImportError> {
    match data {
        Data::Volume(volume) => Ok(volume),
        _ => Err(other(path, "the file holds no volume")),
    }
}

fn voxels_of(data: Data, path: &Path) -> Result<Voxels, ImportError> {
    match data {
        Data::Voxels(voxels) => Ok(voxels),
        _ => Err(other(path, "the file holds no voxels of this kind")),
    }
}

fn other(path: &Path, what: &str) -> ImportError {
    ImportError::at(path, 0, ImportErrorKind::Unsupported(what.into()))
}
