//! What is alike for all formats once a reader is done: data is checked, named, and gets the unit and the axis that are asked
//! for.

use super::reader::{Data, Geometry, ImportOptions, Kind, Reader, Voxels};
use glam::{DAffine3, DVec3};
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Finishes what a reader has made of a file.
pub(super) fn finish(data: Data, reader: &Reader, path: &Path, options: &ImportOptions) -> Result<Data, ImportError> {
    // A turn from the axis that the reader has brought up to the one that is asked for.
    let turn = reader.up_axis.zip(options.up);
    Ok(match data {
        Data::Geometry(found) => geometry(found, turn, reader, path, options)?.into(),
        Data::Volume(found) => volume(found, turn, reader, path, options)?.into(),
        Data::Voxels(found) if reader.kind != Kind::Scene => voxels(found, turn, path, options).into(),
        Data::Voxels(_) | Data::Packed(_) => data,
    })
}

fn geometry(
    mut geometry: Geometry,
    turn: Option<(UpAxis, UpAxis)>,
    reader: &Reader,
    path: &Path,
    options: &ImportOptions,
) -> Result<Geometry, ImportError> {
    let name = stem(path);
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
    if let Geometry::Points(cloud) = &mut geometry
        && !reader.filters_points
    {
        let none = |what| ImportError::of_file(path, ImportErrorKind::NothingChosen(what));
        options.points.apply(cloud).map_err(none)?;
    }
    geometry.set_unit(options.unit.unwrap_or(geometry.unit()));
    if let Some((from, to)) = turn {
        geometry.make_z_up(from.inverse());
        geometry.make_z_up(to);
    }
    Ok(geometry)
}

fn volume(
    volume: Volume,
    turn: Option<(UpAxis, UpAxis)>,
    reader: &Reader,
    path: &Path,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    volume.validate().map_err(|fault| ImportError::malformed(path, 0, fault))?;
    volume_frame(volume, turn, reader, path, options)
}

/// Finishes a volume, whether its samples are here or not.
pub(super) fn volume_frame(
    mut volume: Volume,
    turn: Option<(UpAxis, UpAxis)>,
    reader: &Reader,
    path: &Path,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    let checked = |volume: &Volume| volume.validate_lattice().map_err(|fault| ImportError::malformed(path, 0, fault));
    checked(&volume)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    // `head.nii.gz` is `head`.
    let extension = reader.extension_of(path).map_or(0, |extension| extension.len() + 1);
    volume.name = name.get(..name.len().saturating_sub(extension)).unwrap_or(&name).to_owned();
    if let Some(spacing) = options.spacing {
        volume.set_spacing(spacing);
        volume.unit = if volume.unit == Unit::Voxel { Unit::Millimetre } else { volume.unit };
        checked(&volume)?;
    }
    if let Some(unit) = options.unit {
        volume.unit = unit.of_scene();
        if unit.in_scene() != 1.0 {
            volume.world_from_index = DAffine3::from_scale(DVec3::splat(unit.in_scene())) * volume.world_from_index;
        }
    }
    if let Some((from, to)) = turn {
        if from != UpAxis::Z {
            volume.make_z_up(from.inverse());
        }
        volume.make_z_up(to);
    }
    Ok(volume)
}

fn voxels(mut voxels: Voxels, turn: Option<(UpAxis, UpAxis)>, path: &Path, options: &ImportOptions) -> Voxels {
    voxels.scene.name = stem(path);
    if let Some(unit) = options.unit {
        (voxels.scene.unit, voxels.scene.voxel_size) = (unit.of_scene(), voxels.scene.voxel_size * unit.in_scene());
    }
    if let Some((from, to)) = turn {
        voxels.change_up_axis(from, to);
    }
    voxels
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
