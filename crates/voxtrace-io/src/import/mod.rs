//! Reading scenes from files: [`open`] is the one entry. Voxel files become scenes as they are, meshes, clouds of points
//! and volumes are voxelized.

mod anchor;
mod e57;
mod folder;
mod format;
mod geometry;
mod geotiff;
mod gltf;
mod guard;
mod input;
mod large;
mod las;
mod listing;
mod obj;
pub mod opened;
mod pcd;
mod picture;
mod ply;
mod stl;
mod turned;
mod volume;
pub mod vox;
mod voxels;
mod xyz;

pub use format::Format;
pub use geometry::Geometry;
pub use large::{LargeGeometry, open_large};
pub use volume::RawShape;
pub use voxels::{Height, HeightOptions, Voxels};
pub use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

use folder::Folder;
use glam::DVec3;
use guard::guarded;
use input::Input;
use std::path::Path;
use voxtrace_core::packed::{FileErrorKind, PackedScene};
use voxtrace_scene::scene::{Scene, Unit};
use voxtrace_voxelize::mesh::{Mesh, UpAxis};
use voxtrace_voxelize::volume::{self as volumes, Volume, VolumeOptions};
use voxtrace_voxelize::voxelize::{VoxelizeOptions, VoxelizeProgress};

/// How files are read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportOptions {
    /// What a file may at most ask for.
    pub limits: Limits,
    /// The axis that points up in the file; `None` takes what its format says, y for OBJ, else z.
    pub up: Option<UpAxis>,
    /// The unit of the file's coordinates; `None` takes what its format says.
    pub unit: Option<Unit>,
    /// How meshes and points become voxels.
    pub voxelize: VoxelizeOptions,
    /// How heightmaps become voxels.
    pub heights: HeightOptions,
    /// How volumes become voxels.
    pub volume: VolumeOptions,
    /// Number of the DICOM series that is read where a folder holds several; `None` takes the one with the most pictures.
    pub series: Option<i64>,
    /// Distance between a volume's samples along its three axes in place of what the file says, in `unit`s, or where
    /// neither says which, in millimetres.
    pub spacing: Option<DVec3>,
    /// What a file without a header holds.
    pub raw: Option<RawShape>,
}

/// Reads a scene from a file whose format is told by its first bytes, or where they say nothing by its extension.
///
/// # Errors
/// If the file cannot be read, has no known format, or is not what its format says.
pub fn open(path: &Path, options: &ImportOptions) -> Result<Scene, ImportError> {
    match detect(path, options)? {
        Format::Vox => open_vox(path, options),
        Format::Native => open_native(path),
        format if format.is_voxels() => read_voxels(path, options).map(|voxels| voxels.scene),
        format if format.is_volume() => {
            volumes::voxelize(&read_volume(path, options)?, &options.volume, &options.limits)
                .map_err(|error| error.into_import_error(path))
        }
        _ => read_geometry(path, options)?
            .voxelize(&options.voxelize, &options.limits, &VoxelizeProgress::default())
            .map_err(|error| error.into_import_error(path)),
    }
}

/// The format of a file or folder. What has a shape is [`Format::Raw`].
///
/// # Errors
/// If the file cannot be read or has no known format.
pub fn detect(path: &Path, options: &ImportOptions) -> Result<Format, ImportError> {
    if path.is_dir() {
        return format_of_folder(path, &options.limits);
    }
    if options.raw.is_some() {
        return Ok(Format::Raw);
    }
    // What is read is its head, whatever its length.
    let mut input = Input::open(path, &Limits { bytes: u64::MAX, ..options.limits })?;
    let format = Format::detect(input.peek(format::HEAD)?, path).ok_or_else(|| unknown(path))?;
    // One page is a heightmap, several are slices.
    let is_heightmap = format == Format::Slices && volume::pictures::has_one_page(path);
    Ok(if is_heightmap { Format::Heightmap } else { format })
}

/// The format of a folder, which the first of its files tells that has one.
fn format_of_folder(path: &Path, limits: &Limits) -> Result<Format, ImportError> {
    if voxels::holds_regions(path) {
        return Ok(Format::Region);
    }
    if volume::zarr::MARKS.iter().any(|mark| path.join(mark).is_file()) {
        return Ok(Format::Zarr);
    }
    let files = listing::files(path, limits)?;
    if volume::slices::has_pictures(&files) {
        return Ok(Format::Slices);
    }
    for file in files {
        let mut input = Input::open(&file, limits)?;
        if Format::detect(input.peek(format::HEAD)?, &file) == Some(Format::Dicom) {
            return Ok(Format::Dicom);
        }
    }
    Err(ImportError::of_file(
        path,
        ImportErrorKind::UnknownFormat("no file in the folder is a slice or a region of a world".into()),
    ))
}

/// Reads the mesh or the points of a file without voxelizing them. Their notes say what was left out.
///
/// # Errors
/// As [`open`]; also if the file holds voxels.
pub fn read_geometry(path: &Path, options: &ImportOptions) -> Result<Geometry, ImportError> {
    let folder = Folder::of(path, &options.limits);
    geometry_of(Input::open(path, &options.limits)?, &folder, options)
}

/// Reads a mesh or points from memory; `path` names them in errors and tells their format by its extension where the first
/// bytes do not. Files that they refer to are not looked for.
///
/// # Errors
/// As [`read_geometry`].
pub fn geometry_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Geometry, ImportError> {
    geometry_of(Input::of_bytes(bytes, path, &options.limits)?, &Folder::none(), options)
}

/// As [`read_geometry`], for a file that holds a mesh.
///
/// # Errors
/// As [`read_geometry`]; also if the file holds no mesh.
pub fn read_mesh(path: &Path, options: &ImportOptions) -> Result<Mesh, ImportError> {
    only_mesh(read_geometry(path, options)?, path)
}

/// As [`geometry_from_bytes`], for a file that holds a mesh.
///
/// # Errors
/// As [`read_mesh`].
pub fn mesh_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Mesh, ImportError> {
    only_mesh(geometry_from_bytes(bytes, path, options)?, path)
}

fn only_mesh(geometry: Geometry, path: &Path) -> Result<Mesh, ImportError> {
    match geometry {
        Geometry::Mesh(mesh) => Ok(mesh),
        Geometry::Points(_) => Err(no_geometry(path, "the file holds points, but no mesh")),
    }
}

fn no_geometry(path: &Path, what: &str) -> ImportError {
    ImportError::at(path, 0, ImportErrorKind::Unsupported(what.into()))
}

fn geometry_of(mut input: Input, folder: &Folder, options: &ImportOptions) -> Result<Geometry, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let format = Format::detect(input.peek(format::HEAD)?, path).ok_or_else(|| unknown(path))?;
    let read = || match format {
        Format::Gltf => gltf::read(input, folder, limits).map(Geometry::Mesh),
        Format::Obj => obj::read(input, folder, limits),
        Format::Ply => ply::read(input, folder, limits),
        Format::Stl => stl::read(input, limits).map(Geometry::Mesh),
        Format::Las => las::read(input, limits).map(Geometry::Points),
        Format::Xyz => xyz::read(input, limits).map(Geometry::Points),
        Format::Pcd => pcd::read(input, limits).map(Geometry::Points),
        Format::E57 => e57::read(input, limits).map(Geometry::Points),
        _ => Err(no_geometry(path, "the file holds neither a mesh nor points")),
    };
    let mut geometry = guarded(|| Ok(read())).unwrap_or_else(|panic| Err(ImportError::malformed(path, 0, panic)))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let sound = match &mut geometry {
        Geometry::Mesh(mesh) => {
            mesh.name = name;
            mesh.validate()
        }
        Geometry::Points(cloud) => {
            cloud.name = name;
            cloud.validate()
        }
    };
    sound.map_err(|fault| ImportError::malformed(path, 0, fault))?;
    geometry.set_unit(options.unit.unwrap_or(geometry.unit()));
    match options.up {
        Some(up) => {
            if format == Format::Gltf {
                // Undo the turn from y up, which the reader has made.
                geometry.turn_up(UpAxis::MinusY);
            }
            geometry.turn_up(up);
        }
        // The format does not say it, but most programs that write it do so.
        None if format == Format::Obj => geometry.turn_up(UpAxis::Y),
        None => {}
    }
    Ok(geometry)
}

/// Reads the volume of a file without making voxels. Its notes say what was left out.
///
/// # Errors
/// As [`open`]; also if the file holds no volume.
pub fn read_volume(path: &Path, options: &ImportOptions) -> Result<Volume, ImportError> {
    let (format, limits) = (detect(path, options)?, &options.limits);
    match format {
        Format::Dicom => {
            return finished(path, format, options, || volume::dicom::read_series(path, options.series, limits));
        }
        Format::Zarr if path.is_dir() => {
            return finished(path, format, options, || volume::zarr::read(path, options.volume.scale, limits));
        }
        Format::Slices if path.is_dir() => {
            return finished(path, format, options, || volume::slices::read_folder(path, limits));
        }
        _ => {}
    }
    let folder = Folder::of(path, &options.limits);
    volume_of(Input::open(path, &options.limits)?, &folder, options)
}

/// Reads a volume from memory; `path` names it in errors and tells its format by its extension where the first bytes do not.
/// Files that it refers to are not looked for.
///
/// # Errors
/// As [`read_volume`].
pub fn volume_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Volume, ImportError> {
    volume_of(Input::of_bytes(bytes, path, &options.limits)?, &Folder::none(), options)
}

fn volume_of(mut input: Input, folder: &Folder, options: &ImportOptions) -> Result<Volume, ImportError> {
    let path = input.path();
    let format = match options.raw {
        Some(_) => Format::Raw,
        None => Format::detect(input.peek(format::HEAD)?, path).ok_or_else(|| unknown(path))?,
    };
    finished(path, format, options, || volume::read(format, input, folder, options))
}

/// What a reader makes, checked, named and turned.
fn finished(
    path: &Path,
    format: Format,
    options: &ImportOptions,
    read: impl FnOnce() -> Result<Volume, ImportError>,
) -> Result<Volume, ImportError> {
    let mut volume = guarded(|| Ok(read())).unwrap_or_else(|panic| Err(ImportError::malformed(path, 0, panic)))?;
    volume.validate().map_err(|fault| ImportError::malformed(path, 0, fault))?;
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let lower = name.to_ascii_lowercase();
    let extension =
        format.extensions().iter().filter(|extension| lower.ends_with(*extension)).map(|e| e.len() + 1).max();
    volume.name = name.get(..name.len().saturating_sub(extension.unwrap_or(0))).unwrap_or(&name).to_owned();
    if let Some(spacing) = options.spacing {
        volume.set_spacing(spacing);
        volume.unit = if volume.unit == Unit::Voxel { Unit::Millimetre } else { volume.unit };
        volume.validate().map_err(|fault| ImportError::malformed(path, 0, fault))?;
    }
    volume.unit = options.unit.unwrap_or(volume.unit);
    if let Some(up) = options.up {
        if format == Format::Vdb {
            // Undo the turn from y up, which the reader has made.
            volume.turn_up(UpAxis::MinusY);
        }
        volume.turn_up(up);
    }
    Ok(volume)
}

/// Reads a file of voxels that are taken as they are: builds and worlds of Minecraft,
/// models of Qubicle, binvox, heightmaps. A world is named by its folder.
///
/// # Errors
/// As [`open`]; also if the file holds no such voxels.
pub fn read_voxels(path: &Path, options: &ImportOptions) -> Result<Voxels, ImportError> {
    if path.is_dir() {
        let read = || voxels::read_world(path, &options.limits);
        let voxels = guarded(|| Ok(read())).unwrap_or_else(|panic| Err(ImportError::malformed(path, 0, panic)))?;
        return Ok(named(voxels, path, options));
    }
    let folder = Folder::of(path, &options.limits);
    voxels_of(Input::open(path, &options.limits)?, &folder, options)
}

/// Reads voxels from memory; `path` names them in errors and tells their format by its extension where the first bytes do
/// not. Files that they refer to are not looked for.
///
/// # Errors
/// As [`read_voxels`].
pub fn voxels_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Voxels, ImportError> {
    voxels_of(Input::of_bytes(bytes, path, &options.limits)?, &Folder::none(), options)
}

fn voxels_of(mut input: Input, folder: &Folder, options: &ImportOptions) -> Result<Voxels, ImportError> {
    let path = input.path();
    let format = match Format::detect(input.peek(format::HEAD)?, path).ok_or_else(|| unknown(path))? {
        // The first page of a picture, by whoever wants heights.
        Format::Slices => Format::Heightmap,
        format => format,
    };
    let read = || voxels::read(format, input, folder, options);
    let voxels = guarded(|| Ok(read())).unwrap_or_else(|panic| Err(ImportError::malformed(path, 0, panic)))?;
    Ok(named(voxels, path, options))
}

fn named(mut voxels: Voxels, path: &Path, options: &ImportOptions) -> Voxels {
    voxels.scene.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    voxels.scene.unit = options.unit.unwrap_or(voxels.scene.unit);
    if let Some(up) = options.up {
        voxels.turn_up(up);
    }
    voxels
}

/// The sRGB texels, with opacity, of a picture (PNG or JPEG), row by row from the top.
///
/// # Errors
/// If the file cannot be read, is no such picture, or is too large.
pub fn read_picture(path: &Path, limits: &Limits) -> Result<Vec<[u8; 4]>, ImportError> {
    let bytes = Input::open(path, limits)?.rest()?;
    let texture = picture::decode(&bytes, limits).map_err(|what| ImportError::malformed(path, 0, what))?;
    Ok(texture.texels().to_vec())
}

/// Two formats share the extension `.vox`.
fn open_vox(path: &Path, options: &ImportOptions) -> Result<Scene, ImportError> {
    let bytes = read_bytes(path, &options.limits)?;
    if voxels::slab6::is_slab6(&bytes) {
        return voxels_from_bytes(&bytes, path, options).map(|voxels| voxels.scene);
    }
    vox::read_bytes(&bytes, path, &options.limits)
}

fn open_native(path: &Path) -> Result<Scene, ImportError> {
    opened::note(path);
    // Not mapped: what is unpacked takes more memory anyway.
    let packed = PackedScene::read(path).map_err(|error| match error.kind {
        FileErrorKind::Io(error) => ImportError::io(path, error),
        kind => ImportError::of_file(path, ImportErrorKind::Malformed(kind.to_string())),
    })?;
    Ok(packed.to_scene())
}

fn unknown(path: &Path) -> ImportError {
    let extensions: Vec<String> =
        Format::ALL.iter().flat_map(|format| format.extensions()).map(|extension| format!(".{extension}")).collect();
    ImportError::at(path, 0, ImportErrorKind::UnknownFormat(format!("{} are read", extensions.join(", "))))
}

/// The whole content of a file, as long as it is within the limit.
fn read_bytes(path: &Path, limits: &Limits) -> Result<Vec<u8>, ImportError> {
    Input::open(path, limits)?.rest()
}
