//! Wavefront OBJ, and its materials as MTL beside it: an object for each instance, quadrilaterals, y up.

use super::vertices::Vertices;
use super::{Surfaces, left_out, write_each};
use crate::export::{ExportError, MTL_HEAD, Wanted};
use crate::output::write_atomically;
use glam::{DVec3, Vec3};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use voxtrace_core::atomic_file::{TemporaryFile, WriteWhile, check_replaceable, write_atomically_while};
use voxtrace_scene::faces::FaceRectangle;
use voxtrace_scene::material::{Material, encode_srgb};
use voxtrace_scene::scene::Scene;

/// Least opacity: readers take 0 for a mistake.
const LEAST_OPACITY: f32 = 0.01;

/// The files that are written besides.
pub fn companions(path: &Path) -> Vec<PathBuf> {
    vec![path.with_extension("mtl")]
}

/// Writes the surface of a scene as an OBJ file, with its materials beside it.
pub fn write(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let surfaces = Surfaces::of(scene, wanted)?;
    let library = path.with_extension("mtl");
    let failure = |path: &Path| {
        let path = path.to_owned();
        move |error| ExportError::Io { path, error }
    };
    // New materials beside an old mesh would be the wrong ones: they take their place when the mesh has taken its own.
    let materials = written_aside(&library, |file| write_materials(file, &surfaces)).map_err(failure(&library))?;
    let name = library.file_name().unwrap_or_default().to_string_lossy().into_owned();
    write_atomically_while(path, wanted, |file| write_to(file, &surfaces, &name, wanted)).map_err(failure(path))?;
    materials.map_or(Ok(()), |materials| materials.replace(&library)).map_err(failure(&library))?;
    let media =
        scene.materials.iter().filter(|material| material.absorption != Vec3::ZERO || material.scattering > 0.0);
    let mut lost = left_out(scene);
    let media = media.count();
    lost.extend((media > 0).then(|| format!("what is within media ({media})")));
    Ok(lost)
}

/// Writes a file under another name, whole and on the disk, so that little can go wrong when it replaces what is at `path`. `None` where that is no
/// regular file: then it is written at once.
fn written_aside(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> io::Result<Option<TemporaryFile>> {
    match check_replaceable(path) {
        Err(error) if error.kind() == io::ErrorKind::Unsupported => {
            return write_atomically(path, write).map(|()| None);
        }
        checked => checked?,
    }
    let mut temporary = TemporaryFile::beside(path)?;
    let mut writer = BufWriter::new(temporary.try_clone()?);
    write(&mut writer)?;
    writer.flush()?;
    temporary.file().sync_all()?;
    Ok(Some(temporary))
}

fn write_to(file: &mut WriteWhile, surfaces: &Surfaces, library: &str, wanted: Wanted) -> io::Result<()> {
    let edge = surfaces.scene.voxel_size;
    writeln!(file, "# voxtrace, voxels of {edge}\nmtllib {library}")?;
    // Vertices are numbered from 1 on.
    let mut first = 1;
    for (number, (instance, rectangles)) in surfaces.instances().enumerate() {
        // Names end where the line does, and some programs end them at a space.
        let word: String = instance.name.split_whitespace().collect::<Vec<_>>().join("_");
        let name = if word.is_empty() { format!("instance_{number}") } else { word };
        writeln!(file, "o {name}")?;
        let vertices = Vertices::of(rectangles.iter().take_while(|_| wanted()).flat_map(FaceRectangle::corners));
        // Else some are missing that faces name.
        file.check()?;
        write_each(file, vertices.bricks(), |text, brick| {
            for corner in brick.corners() {
                let DVec3 { x, y, z } = Surfaces::place(instance, corner) * edge;
                // Zeros have no sign.
                writeln!(text, "v {} {} {}", x + 0.0, z + 0.0, 0.0 - y)?;
            }
            Ok(())
        })?;
        let mut by_material = rectangles.to_vec();
        by_material.par_sort_by_key(|rectangle| rectangle.material);
        for alike in by_material.chunk_by(|one, next| one.material == next.material) {
            writeln!(file, "usemtl material_{}", alike[0].material)?;
            write_each(file, alike, |text, rectangle| {
                let [a, b, c, d] = Surfaces::corners(instance, rectangle).map(|corner| first + vertices.number(corner));
                writeln!(text, "f {a} {b} {c} {d}")
            })?;
        }
        first += vertices.count();
    }
    Ok(())
}

/// The materials of all surfaces that are written.
fn write_materials(file: &mut impl Write, surfaces: &Surfaces) -> io::Result<()> {
    writeln!(file, "{MTL_HEAD}")?;
    let used: BTreeSet<u16> =
        surfaces.rectangles.par_iter().flatten_iter().map(|rectangle| rectangle.material).collect();
    for index in used {
        let material = &surfaces.scene.materials[usize::from(index)];
        writeln!(file, "\nnewmtl material_{index}\nKd {}", signals(material.base_color))?;
        if material.is_emissive() {
            writeln!(file, "Ke {}", signals(material.emission * surfaces.scene.light_intensity))?;
        }
        let Material { roughness, metallic, transmission, ior, .. } = *material;
        writeln!(file, "Pr {roughness}\nPm {metallic}")?;
        if transmission > 0.0 {
            writeln!(file, "Ni {ior}\nd {}", (1.0 - transmission).max(LEAST_OPACITY))?;
        }
    }
    Ok(())
}

/// A colour as the reader takes it: sRGB signals, and above 1 linear factors.
fn signals(color: Vec3) -> String {
    let signal = |value: f32| if value > 1.0 { value } else { encode_srgb(value.into()) as f32 };
    let [red, green, blue] = color.to_array().map(signal);
    format!("{red} {green} {blue}")
}
