//! GeoTIFF (OGC 19-008, "OGC GeoTIFF standard"): where the pixels of a picture lie on a map, by the size of a pixel and a tie
//! point, or by a matrix.

use crate::import::reader::geo_keys::of_keys;
use crate::import::reader::map_units::{Horizontal, MapUnits};
use std::io::{Read, Seek};
use tiff::decoder::Decoder;
use tiff::tags::Tag;
use voxtrace_scene::scene::LengthUnit;

/// The key of what a pixel stands for, and its value for points rather than areas.
const RASTER: u16 = 1025;
const POINTS: u16 = 2;

/// What a GeoTIFF says about its map.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct GeoTiff {
    /// The north-western corner of the first pixel.
    pub corner: [f64; 2],
    /// Size of a pixel eastwards and southwards, above 0.
    pub step: [f64; 2],
    /// The reference system as the file names it, or empty.
    pub crs: String,
    pub units: MapUnits,
}

impl GeoTiff {
    /// `None` where the page says nothing, or lies otherwise than with north at its top.
    pub fn of<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<Self> {
        let mut numbers = |tag| decoder.get_tag_f64_vec(tag).ok();
        let (at, place, step) = match (numbers(Tag::ModelPixelScaleTag), numbers(Tag::ModelTiepointTag)) {
            (Some(scale), Some(tie)) => match (&scale[..], &tie[..]) {
                ([width, height, ..], [column, row, _, x, y, ..]) => ([*column, *row], [*x, *y], [*width, *height]),
                _ => return None,
            },
            _ => match &numbers(Tag::ModelTransformationTag)?[..] {
                &[width, 0.0, _, x, 0.0, height, _, y, ..] => ([0.0; 2], [x, y], [width, -height]),
                _ => return None,
            },
        };
        let keys = decoder.get_tag_u16_vec(Tag::GeoKeyDirectoryTag).unwrap_or_default();
        let words = decoder.get_tag_ascii_string(Tag::GeoAsciiParamsTag).unwrap_or_default();
        let key = |wanted: u16| {
            let keys = keys.as_chunks::<4>().0.iter().skip(1);
            keys.filter(|key| key[1] == 0).find(|key| key[0] == wanted).map(|key| key[3])
        };
        // Of points the tie point is the middle of the pixel.
        let half = if key(RASTER) == Some(POINTS) { 0.5 } else { 0.0 };
        let corner = [place[0] - (at[0] + half) * step[0], place[1] + (at[1] + half) * step[1]];
        let is_good =
            corner.iter().all(|place| place.is_finite()) && step.iter().all(|step| (1e-12..1e9).contains(step));
        is_good.then(|| Self { corner, step, crs: of_keys(&keys, &words), units: MapUnits::of_keys(&keys) })
    }
}

impl GeoTiff {
    /// How many degrees the unit of places is, if it is an angle.
    pub fn degrees(&self) -> Option<f64> {
        if let Horizontal::Angle(degrees) = self.units.horizontal { Some(degrees) } else { None }
    }

    /// The unit of places, unknown where it is an angle.
    pub fn plane(&self) -> LengthUnit {
        if let Horizontal::Length(unit) = self.units.horizontal { unit } else { LengthUnit::UNKNOWN }
    }
}

/// The value that marks holes, where the page names one (GDAL's tag).
pub(crate) fn hole<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<f32> {
    let text = decoder.get_tag_ascii_string(Tag::GdalNodata).ok()?;
    text.trim_matches([' ', '\0']).parse::<f64>().ok().map(|value| value as f32)
}
