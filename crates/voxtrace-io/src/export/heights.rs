//! Heightmaps of scenes, as seen from above: the uppermost voxel of each column, north at the top. ESRI ASCII grids keep the size of
//! voxels, their place and columns without a voxel; PNG of 16 bits keeps voxels above the lowest one.

use super::{ExportError, Wanted, bake_failure, go_on};
#[cfg(feature = "pictures")]
use crate::output::png_error;
use glam::{DVec3, IVec3};
use std::io::{self, Write};
use std::path::Path;
use voxtrace_core::atomic_file::write_atomically_while;
use voxtrace_scene::grid::VoxelBox;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::bake::flattened_while;

const ASC: &str = ".asc";
#[cfg(feature = "pictures")]
const PNG: &str = ".png";
/// What grids say where there is no height, unless heights reach as low.
const HOLE: f64 = -9999.0;
/// Readers take smaller cells near the origin for degrees of a globe.
const LEAST_CELL: f64 = 0.2;
/// A place that is on no globe.
const OFF_THE_GLOBE: f64 = 1000.0;
/// Most columns: a side of a heightmap of a whole country at a metre.
const MOST_COLUMNS: i64 = 1 << 32;

/// The uppermost voxels of a scene.
struct Columns {
    /// In the world.
    bounds: VoxelBox,
    /// The z of the uppermost voxel of each column, row by row from the north.
    tops: Vec<Option<i32>>,
}

impl Columns {
    fn of(scene: &Scene, format: &'static str, wanted: Wanted) -> Result<Self, ExportError> {
        let (grid, corner) = flattened_while(scene, wanted).map_err(|error| bake_failure(format, error))?;
        let Some(bounds) = grid.bounds() else {
            return Err(ExportError::Empty { format });
        };
        let size = bounds.size().as_i64vec3();
        if size.x * size.y > MOST_COLUMNS {
            return Err(ExportError::TooLarge { format, what: "the columns" });
        }
        let tops = tops(grid.voxels().take_while(|_| wanted()), bounds);
        go_on(wanted)?;
        let tops = tops.into_iter().map(|top| top.map(|top| top + corner.z)).collect();
        Ok(Self { bounds: VoxelBox { min: bounds.min + corner, max: bounds.max + corner }, tops })
    }

    fn size(&self) -> IVec3 {
        self.bounds.size()
    }

    fn rows(&self) -> impl Iterator<Item = &[Option<i32>]> {
        self.tops.chunks(self.size().x as usize)
    }
}

fn tops(voxels: impl Iterator<Item = (IVec3, u16)>, bounds: VoxelBox) -> Vec<Option<i32>> {
    let size = bounds.size();
    let mut tops = vec![None; size.x as usize * size.y as usize];
    for (voxel, _) in voxels {
        let (column, row) = (voxel.x - bounds.min.x, bounds.max.y - 1 - voxel.y);
        let top: &mut Option<i32> = &mut tops[row as usize * size.x as usize + column as usize];
        *top = (*top).max(Some(voxel.z));
    }
    tops
}

/// What of a scene no heightmap holds.
fn left_out() -> Vec<String> {
    vec!["colours, and what is below the uppermost voxels".into()]
}

/// Writes the heights of a scene as an ESRI ASCII grid.
pub fn write_asc(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let columns = Columns::of(scene, ASC, wanted)?;
    write_atomically_while(path, wanted, |file| write_grid(file, scene, &columns))
        .map_err(|error| ExportError::Io { path: path.into(), error })?;
    Ok(left_out())
}

fn write_grid(file: &mut impl Write, scene: &Scene, columns: &Columns) -> io::Result<()> {
    let size = columns.size();
    let low = columns.bounds.min.as_dvec3();
    let map = scene.georeference.as_ref().map(|place| place.coordinates_from_world).filter(|place| {
        let axes = place.matrix3;
        let (edge, most) = (axes.x_axis.x, 1e-6 * axes.x_axis.x);
        // North must be up, and cells be squares.
        let expected = [[edge, 0.0, 0.0], [0.0, edge, 0.0], [0.0, 0.0, axes.z_axis.z]];
        edge > 0.0 && axes.z_axis.z > 0.0 && axes.abs_diff_eq(glam::DMat3::from_cols_array_2d(&expected), most)
    });
    let place = |voxel: DVec3| map.map_or(voxel * scene.voxel_size, |map| map.transform_point3(voxel));
    let cell = map.map_or(scene.voxel_size, |map| map.matrix3.x_axis.x);
    let (mut corner, height) = (place(low), |top: i32| place(DVec3::new(0.0, 0.0, f64::from(top) + 0.5)).z);
    if map.is_none() && cell < LEAST_CELL {
        corner += OFF_THE_GLOBE;
    }
    let lowest = columns.tops.iter().flatten().min().map_or(0.0, |&top| height(top));
    let hole = if lowest > HOLE + 1.0 { HOLE } else { (lowest - 1000.0).floor() };
    write!(
        file,
        "ncols {}\nnrows {}\nxllcorner {}\nyllcorner {}\ncellsize {cell}\nNODATA_value {hole}\n",
        size.x, size.y, corner.x, corner.y
    )?;
    for row in columns.rows() {
        let numbers: Vec<String> = row.iter().map(|top| top.map_or(hole, height).to_string()).collect();
        writeln!(file, "{}", numbers.join(" "))?;
    }
    Ok(())
}

/// Writes the heights of a scene as a PNG of 16 bits: voxels above the lowest voxel of the scene; 0 also where there is none.
#[cfg(feature = "pictures")]
pub fn write_png(path: &Path, scene: &Scene, wanted: Wanted) -> Result<Vec<String>, ExportError> {
    let columns = Columns::of(scene, PNG, wanted)?;
    let low = columns.bounds.min.z;
    let height = |top: Option<i32>| u16::try_from(top.map_or(0, |top| top - low));
    let heights: Result<Vec<u16>, _> = columns.tops.iter().map(|&top| height(top)).collect();
    let too_large = |_| ExportError::TooLarge { format: PNG, what: "heights of more than 65535 voxels" };
    let bytes: Vec<u8> = heights.map_err(too_large)?.into_iter().flat_map(u16::to_be_bytes).collect();
    let size = columns.size().as_uvec3();
    write_atomically_while(path, wanted, |file| {
        let mut encoder = png::Encoder::new(file, size.x, size.y);
        encoder.set_color(png::ColorType::Grayscale);
        encoder.set_depth(png::BitDepth::Sixteen);
        encoder.add_text_chunk("Software".into(), "voxtrace".into()).map_err(png_error)?;
        let mut writer = encoder.write_header().map_err(png_error)?;
        writer.write_image_data(&bytes).map_err(png_error)?;
        writer.finish().map_err(png_error)
    })
    .map_err(|error| ExportError::Io { path: path.into(), error })?;
    Ok(left_out())
}
