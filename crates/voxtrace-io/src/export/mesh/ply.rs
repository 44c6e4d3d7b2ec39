//! Binary PLY (Turk, "The PLY Polygon File Format", 1994): quadrilaterals with a colour at each vertex, z up.

use super::{Surfaces, left_out, write_each};
use crate::export::flat_color::{lost_of, shown_srgb};
use crate::export::{ExportError, Wanted};
use std::io::{self, Write};
use std::path::Path;
use voxtrace_core::atomic_file::write_atomically_while;
use voxtrace_scene::scene::{Scene, Unit};

const FORMAT: &str = ".ply";

/// Writes the surface of a scene as a binary PLY file.
pub fn write(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let surfaces = Surfaces::of(scene, wanted)?;
    let faces: usize = surfaces.instances().map(|(_, rectangles)| rectangles.len()).sum();
    // Indices of vertices have 32 bits with a sign.
    if faces > i32::MAX as usize / 4 {
        return Err(ExportError::TooLarge { format: FORMAT, what: "the faces" });
    }
    write_atomically_while(path, wanted, |file| write_to(file, &surfaces, faces))
        .map_err(|error| ExportError::Io { path: path.into(), error })?;
    let mut lost = left_out(scene);
    lost.extend(lost_of(&scene.materials));
    Ok(lost)
}

fn write_to(file: &mut impl Write, surfaces: &Surfaces, faces: usize) -> io::Result<()> {
    let scene = surfaces.scene;
    let unit = match scene.unit {
        Unit::Voxel => "",
        Unit::Metre => ", metres",
        Unit::Millimetre => ", millimetres",
    };
    write!(
        file,
        "ply\nformat binary_little_endian 1.0\ncomment voxtrace, voxels of {}{unit}\nelement vertex {}\n\
         property float x\nproperty float y\nproperty float z\n\
         property uchar red\nproperty uchar green\nproperty uchar blue\n\
         element face {faces}\nproperty list uchar int vertex_indices\nend_header\n",
        scene.voxel_size,
        4 * faces
    )?;
    let colors: Vec<[u8; 3]> = scene.materials.iter().map(shown_srgb).collect();
    for (instance, rectangles) in surfaces.instances() {
        write_each(file, rectangles, |bytes, rectangle| {
            for corner in Surfaces::corners(instance, rectangle) {
                let place = Surfaces::place(instance, corner) * scene.voxel_size;
                bytes.extend(place.as_vec3().to_array().map(f32::to_le_bytes).as_flattened());
                bytes.extend(colors[usize::from(rectangle.material)]);
            }
            Ok(())
        })?;
    }
    for face in 0..faces as u32 {
        file.write_all(&[4])?;
        for corner in 0..4 {
            file.write_all(&(4 * face + corner).to_le_bytes())?;
        }
    }
    Ok(())
}
