//! Reading scenes from files: [`open`] is the one entry. Voxel files become scenes as they are, meshes are voxelized.

mod anchor;
mod error;
mod folder;
mod format;
mod gltf;
mod guard;
mod input;
mod limits;
mod obj;
mod picture;
mod ply;
mod stl;
pub mod vox;

pub use error::{ImportError, ImportErrorKind};
pub use format::Format;
pub use limits::Limits;

use crate::mesh::{Mesh, UpAxis};
use crate::packed::{FileErrorKind, PackedScene};
use crate::scene::{Scene, Unit};
use crate::voxelize::{self, VoxelizeOptions};
use folder::Folder;
use guard::guarded;
use input::Input;
use std::path::Path;

/// How files are read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ImportOptions {
    /// What a file may at most ask for.
    pub limits: Limits,
    /// The axis that points up in the file; `None` takes what its format says, or z.
    pub up: Option<UpAxis>,
    /// The unit of the file's coordinates; `None` takes what its format says.
    pub unit: Option<Unit>,
    /// How meshes become voxels.
    pub voxelize: VoxelizeOptions,
}

/// Reads a scene from a file whose format is told by its first bytes, or where they say nothing by its extension.
///
/// # Errors
/// If the file cannot be read, has no known format, or is not what its format says.
pub fn open(path: &Path, options: &ImportOptions) -> Result<Scene, ImportError> {
    match detect(path, &options.limits)? {
        Format::Vox => vox::read(path, &options.limits),
        Format::Native => open_native(path),
        _ => voxelize::voxelize(&read_mesh(path, options)?, &options.voxelize, &options.limits)
            .map_err(|error| error.into_import_error(path)),
    }
}

/// The format of a file.
///
/// # Errors
/// If the file cannot be read or has no known format.
pub fn detect(path: &Path, limits: &Limits) -> Result<Format, ImportError> {
    let mut input = Input::open(path, limits)?;
    Format::detect(input.peek(format::HEAD)?, path).ok_or_else(|| unknown(path))
}

/// Reads the mesh of a file without voxelizing it. Its notes say what was left out.
///
/// # Errors
/// As [`open`]; also if the file holds no mesh.
pub fn read_mesh(path: &Path, options: &ImportOptions) -> Result<Mesh, ImportError> {
    let folder = Folder::of(path, &options.limits);
    mesh_of(Input::open(path, &options.limits)?, &folder, options)
}

/// Reads a mesh from memory; `path` names it in errors and tells its format by its extension where the first bytes do not.
/// Files that it refers to are not looked for.
///
/// # Errors
/// As [`read_mesh`].
pub fn mesh_from_bytes(bytes: &[u8], path: &Path, options: &ImportOptions) -> Result<Mesh, ImportError> {
    mesh_of(Input::of_bytes(bytes, path, &options.limits)?, &Folder::none(), options)
}

fn mesh_of(mut input: Input, folder: &Folder, options: &ImportOptions) -> Result<Mesh, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let format = Format::detect(input.peek(format::HEAD)?, path).ok_or_else(|| unknown(path))?;
    let read = || match format {
        Format::Gltf => gltf::read(input, folder, limits),
        Format::Obj => obj::read(input, folder, limits),
        Format::Ply => ply::read(input, folder, limits),
        Format::Stl => stl::read(input, limits),
        _ => Err(ImportError::at(path, 0, ImportErrorKind::Unsupported("the file holds no mesh".into()))),
    };
    let mut mesh = guarded(|| Ok(read())).unwrap_or_else(|panic| Err(ImportError::malformed(path, 0, panic)))?;
    mesh.validate().map_err(|fault| ImportError::malformed(path, 0, fault))?;
    mesh.name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    mesh.unit = options.unit.unwrap_or(mesh.unit);
    if let Some(up) = options.up {
        if format == Format::Gltf {
            // Undo the turn from y up, which the reader has made.
            mesh.turn_up(UpAxis::MinusY);
        }
        mesh.turn_up(up);
    }
    Ok(mesh)
}

fn open_native(path: &Path) -> Result<Scene, ImportError> {
    let packed = PackedScene::open(path).map_err(|error| match error.kind {
        FileErrorKind::Io(error) => ImportError::io(path, error),
        kind => ImportError { path: path.into(), offset: None, kind: ImportErrorKind::Malformed(kind.to_string()) },
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
