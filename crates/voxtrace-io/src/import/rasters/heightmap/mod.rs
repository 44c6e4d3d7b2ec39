//! Heightmaps: a picture or a grid of heights becomes columns of voxels, a pixel each, north at +y.

mod asc;
mod columns;
mod dem;
mod map;

use crate::import::grids::paints::Paints;
use crate::import::images::geotiff::GeoTiff;
use crate::import::images::planes::{self, Planes};
use crate::import::images::texture;
use crate::import::reader::Voxels;
use crate::import::reader::{Height, HeightOptions, ImportOptions, Kind, Reader, Recognition};
use crate::import::source::input::Input;
use columns::Columns;
use glam::{Vec2, Vec3};
use map::Map;
use std::path::Path;
use voxtrace_scene::scene::{LengthUnit, Scene};
use voxtrace_voxelize::mesh::{Texture, Wrap};
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

use columns::MOST_HEIGHT;

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "heightmap",
    Kind::Voxels,
    &["asc", "dem", "png"],
    "heightmap: ESRI grid, .dem of the USGS, one picture (PNG of 8 or 16 bits, TIFF of one page)",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(read(input, options)?.into())
    },
)
.with_recognition(|clues| {
    // Whatever it is called: texts of points have the same extensions.
    if asc::is_grid(clues.head) { Recognition::Sure } else { Recognition::Unknown }
});

/// Heights, row by row from the north; NaN where there is none.
struct Heights {
    pub width: usize,
    pub depth: usize,
    pub values: Vec<f32>,
    /// How far points are apart, in the unit of the values.
    pub cell: Option<f64>,
    /// That unit.
    pub unit: LengthUnit,
    pub map: Option<Map>,
    pub notes: Vec<String>,
}

/// Metres of a degree of latitude.
const DEGREE: f64 = 111_320.0;

impl Heights {
    /// Puts the heights on the map of a GeoTIFF, whose units hold unless a person says others.
    fn place(&mut self, map: GeoTiff, asked: Option<LengthUnit>) {
        let [east, south] = map.step;
        let mut cell = (east * south).sqrt();
        if (east - south).abs() > 0.01 * cell {
            self.notes.push(format!("pixels of {east} by {south} are taken for squares"));
        }
        let (plane, vertical) = (map.plane(), map.units.vertical);
        if let Some(degrees) = map.degrees() {
            let length = cell * degrees * DEGREE;
            self.notes.push(format!("pixels of {} degrees are taken for {} m", cell * degrees, length as f32));
            (cell, self.unit) = (length, LengthUnit::METRE);
        } else if asked.is_none() {
            self.unit = plane;
        }
        // Heights may have a unit of their own.
        if let (Some(own), Some(metres), None) = (vertical.metres(), self.unit.metres(), asked)
            && vertical != self.unit
        {
            (cell, self.unit) = (cell * metres / own, vertical);
        }
        self.cell = Some(cell);
        let south_west = [map.corner[0], map.corner[1] - self.depth as f64 * south];
        self.map = Some(Map { south_west, step: map.step, crs: map.crs });
    }
}

/// Colours from the lowest to the highest point, where there is no picture: meadows, earth, rock, snow.
const RAMP: [(f32, [u8; 3]); 5] = [
    (0.0, [0x4f, 0x7a, 0x3a]),
    (0.3, [0x8f, 0x99, 0x55]),
    (0.6, [0x8a, 0x6a, 0x48]),
    (0.85, [0x90, 0x8b, 0x86]),
    (1.0, [0xf8, 0xfa, 0xfc]),
];
/// Shades of the ramp.
const SHADES: f32 = 96.0;

/// Reads a heightmap.
fn read(mut input: Input, options: &ImportOptions) -> Result<Voxels, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let head = input.peek(8)?;
    let is_dem = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("dem"));
    let heights = if head.starts_with(b"\x89PNG") || planes::is_tiff(head) {
        return of_picture(path, planes::read(&input.rest()?, path, planes::Choice::default(), limits)?, options);
    } else if is_dem {
        dem::read(input, limits)?
    } else {
        asc::read(input, limits)?
    };
    voxels(path, heights, &options.heights, &options.limits)
}

/// Makes voxels of the first plane of a picture.
pub(super) fn of_picture(path: &Path, mut found: Planes, options: &ImportOptions) -> Result<Voxels, ImportError> {
    let Some(plane) = (!found.planes.is_empty()).then(|| found.planes.swap_remove(0)) else {
        return Err(ImportError::malformed(path, 0, "a picture without pixels"));
    };
    let (width, depth, mut values) = (plane.width, plane.height, plane.values);
    // Programs mark holes by numbers that no height has.
    values.iter_mut().filter(|value| value.abs() > 1e30 || **value <= -32_767.0).for_each(|value| *value = f32::NAN);
    if let Some(hole) = found.hole {
        values.iter_mut().filter(|value| **value == hole).for_each(|value| *value = f32::NAN);
    }
    let mut heights =
        Heights { width, depth, values, cell: None, unit: LengthUnit::UNKNOWN, map: None, notes: Vec::new() };
    if let Some(map) = found.map {
        heights.place(map, options.unit);
    }
    voxels(path, heights, &options.heights, &options.limits)
}

fn image(path: &Path, limits: &Limits) -> Result<Texture, ImportError> {
    let bytes = Input::open(path, limits)?.rest()?;
    texture::decode(&bytes, limits).map_err(|refused| refused.into_import_error(path))
}

fn voxels(path: &Path, heights: Heights, options: &HeightOptions, limits: &Limits) -> Result<Voxels, ImportError> {
    let image = options.color_image.as_deref().map(|path| image(path, limits)).transpose()?;
    let Heights { width, depth, mut values, cell, unit, map, notes } = heights;
    values.iter_mut().filter(|value| !value.is_finite()).for_each(|value| *value = f32::NAN);
    let known = || values.iter().copied().filter(|value| !value.is_nan());
    let (low, high) = known().fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return Err(ImportError::malformed(path, 0, "no point has a height"));
    }
    let range = f64::from(high) - f64::from(low);
    let scale = match (options.height, cell) {
        (Height::Scale(scale), _) => scale,
        (Height::Voxels(voxels), _) => f64::from(voxels.saturating_sub(1)) / range,
        (Height::Automatic, Some(cell)) => cell.recip(),
        (Height::Automatic, None) => width.max(depth) as f64 / 4.0 / range,
    };
    let scale = if range > 0.0 { scale } else { 0.0 };
    let top = range * scale;
    if !(0.0..f64::from(MOST_HEIGHT)).contains(&top) {
        let kind = ImportErrorKind::Unsupported(format!("heights of {top} voxels: choose another scale"));
        return Err(ImportError::at(path, 0, kind));
    }
    let level = |value: f32| if value.is_nan() { -1 } else { ((f64::from(value - low)) * scale).round() as i32 };
    let tops: Vec<i32> = values.iter().map(|&value| level(value)).collect();
    let mut paints = Paints::default();
    let share = |value: f32| if range > 0.0 { ((f64::from(value - low)) / range) as f32 } else { 0.0 };
    let materials: Vec<u16> = values
        .iter()
        .enumerate()
        .map(|(place, &value)| {
            paints.material(match &image {
                _ if value.is_nan() => return 0,
                Some(image) => texel(image, place % width, place / width, width, depth),
                None => shade(share(value)),
            })
        })
        .collect();
    let columns = Columns { width, depth, tops, materials, shell: options.shell };
    let mut scene = Scene::from_grid("", columns.grid(path, limits)?, paints.finish());
    if let (Some(cell), Height::Automatic) = (cell, options.height) {
        scene.voxel_size = cell * unit.in_scene();
    }
    if let Some(map) = map {
        let height = if scale > 0.0 { scale.recip() } else { cell.unwrap_or(1.0) };
        scene.georeference = Some(map.georeference(low.into(), height));
        if options.height == Height::Automatic {
            scene.unit = unit.of_scene();
        }
    }
    Ok(Voxels { scene, notes })
}

/// The colour of a picture where a point lies.
fn texel(image: &Texture, column: usize, row: usize, width: usize, depth: usize) -> [u8; 3] {
    let uv = Vec2::new((column as f32 + 0.5) / width as f32, (row as f32 + 0.5) / depth as f32);
    let [w, h] = image.size().map(|edge| edge as f32);
    let footprint = w * h / (width as f32 * depth as f32);
    let color = image.sample(uv, [Wrap::Clamp; 2], footprint <= 1.0, footprint);
    [color.x, color.y, color.z].map(voxtrace_scene::material::srgb_from_linear)
}

/// The colour of a height, from 0 to 1.
fn shade(share: f32) -> [u8; 3] {
    let share = (share * SHADES).round() / SHADES;
    let above = RAMP.iter().position(|(stop, _)| *stop >= share).unwrap_or(RAMP.len() - 1).max(1);
    let ((a, from), (b, to)) = (RAMP[above - 1], RAMP[above]);
    let mix = Vec3::from(from.map(f32::from)).lerp(Vec3::from(to.map(f32::from)), (share - a) / (b - a));
    mix.to_array().map(|channel| channel.round().clamp(0.0, 255.0) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_go_through_the_stops_of_the_ramp() {
        for (share, wanted) in [(0.0, RAMP[0].1), (1.0, RAMP[4].1)] {
            assert_eq!(shade(share), wanted);
        }
        let greens: Vec<u8> = (0..=10).map(|n| shade(n as f32 / 10.0)[1]).collect();
        assert!(greens[10] > 240 && greens[0] < 130 && greens[6] < greens[3], "{greens:?}");
    }
}
