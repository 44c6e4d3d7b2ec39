//! OpenVDB, `.vdb` (Museth, "VDB: High-resolution sparse volumes with dynamic topology", 2013; the library's source, files of version
//! 222 and later): trees of three levels, 32³, 16³ and 8³, of numbers. The box around what is active becomes a volume. y is up,
//! as in the programs that write such files.

mod cursor;
mod grid;
mod header;
mod place;
mod tree;
mod values;

use crate::import::reader::{Kind, Magic, Reader};
use crate::import::samples::place as placed;
use crate::import::source::input::Input;
use cursor::Cursor;
use glam::{DAffine3, DVec3};
use grid::{Class, Grid};
use voxtrace_voxelize::mesh::UpAxis;
use voxtrace_voxelize::volume::Preset;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("OpenVDB", Kind::Volume, &["vdb"], "OpenVDB: a level set or densities", |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read(input, &options.limits)?.into())
    })
    .with_magic(&[Magic::first(MAGIC)])
    .with_up_axis(Some(UpAxis::Y))
    .with_several(&[]);

/// First bytes of a file.
const MAGIC: &[u8] = b" BDV\0\0\0\0";

/// Reads the first grid of a file that is a level set, else one called `density`, else the first of numbers.
fn read(input: Input, limits: &Limits) -> Result<Volume, ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    let mut cursor = Cursor::new(&bytes, path);
    let (grids, foreign) = header::read(&mut cursor, limits)?;
    let rank = |grid: &Grid| match (grid.class, grid.name.as_str()) {
        (Class::LevelSet, _) => 0,
        (_, "density") => 1,
        _ => 2,
    };
    let Some(grid) = grids.iter().min_by_key(|grid| rank(grid)) else {
        let what = if foreign.is_empty() { "a file without grids".into() } else { format!("grids of {foreign:?}") };
        return Err(ImportError::at(path, 0, ImportErrorKind::Unsupported(what)));
    };
    let (low, size, mut values) = tree::read(&bytes, path, grid, limits)?;
    let is_surface = grid.class == Class::LevelSet;
    if is_surface {
        // Depths below the surface, so that what is to be seen is more than 0.
        values.iter_mut().for_each(|value| *value = -*value);
    }
    let mut volume = Volume::new(size, values);
    let first = DAffine3::from_translation(low.as_dvec3());
    let place = grid.world_from_index * first;
    let axes = place.matrix3;
    let lengths = DVec3::new(axes.x_axis.length(), axes.y_axis.length(), axes.z_axis.length());
    placed(&mut volume, place, lengths);
    volume.make_z_up(UpAxis::Y);
    volume.suited = match grid.class {
        Class::LevelSet => Some(Preset::Surface),
        Class::Fog => Some(Preset::Fog),
        Class::Other => None,
    };
    let others: Vec<&str> = grids.iter().filter(|other| other.start != grid.start).map(|other| &*other.name).collect();
    if !others.is_empty() || !foreign.is_empty() {
        let others = [others, foreign.iter().map(|name| &**name).collect()].concat().join(", ");
        volume.notes.push(format!("of its grids {:?} is read, not {others}", grid.name));
    }
    Ok(volume)
}
