//! GeoTIFF (OGC 19-008, "OGC GeoTIFF standard"): where the pixels of a picture lie on a map, by the size of a pixel and a tie
//! point, or by a matrix.

use crate::import::reader::geo_keys::of_keys;
use std::io::{Read, Seek};
use tiff::decoder::Decoder;
use tiff::tags::Tag;

/// Keys: the kind of coordinates, what a pixel stands for, and the unit of a plane.
const MODEL: u16 = 1024;
const RASTER: u16 = 1025;
const PLANE_UNIT: u16 = 3076;
/// Their values: degrees, points rather than areas, metres.
const IN_DEGREES: u16 = 2;
const POINTS: u16 = 2;
const METRES: u16 = 9001;

/// What a GeoTIFF says about its map.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct GeoTiff {
    /// The north-western corner of the first pixel.
    pub corner: [f64; 2],
    /// Size of a pixel eastwards and southwards, above 0.
    pub step: [f64; 2],
    /// The reference system as the file names it, or empty.
    pub crs: String,
    pub is_in_degrees: bool,
    pub is_in_metres: bool,
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
        is_good.then(|| Self {
            corner,
            step,
            crs: of_keys(&keys, &words),
            is_in_degrees: key(MODEL) == Some(IN_DEGREES),
            is_in_metres: key(PLANE_UNIT) == Some(METRES),
        })
    }
}

/// The value that marks holes, where the page names one (GDAL's tag).
pub(crate) fn hole<R: Read + Seek>(decoder: &mut Decoder<R>) -> Option<f32> {
    let text = decoder.get_tag_ascii_string(Tag::GdalNodata).ok()?;
    text.trim_matches([' ', '\0']).parse::<f64>().ok().map(|value| value as f32)
}
