//! E57 (ASTM E2807; Huber, "The ASTM E57 file format for 3D imaging data exchange", 2011), by the crate `e57`, after what
//! it would believe has been held against the file. All scans of a file are read, each at its pose.

use crate::import::reader::local_origin::LocalOrigin;
use crate::import::reader::{Geometry, Kind, Magic, NotShown, Reader};
use crate::import::source::guard::guarded;
use crate::import::source::input::Input;
use ::e57::{CartesianCoordinate, E57Reader, PointCloud as Scan, RecordDataType};
use glam::DVec3;
use std::io::Cursor;
use std::path::Path;
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader =
    Reader::new("E57", Kind::Points, &["e57"], "points of laser scanners", |source, options| {
        let (input, _) = source.into_input()?;
        Ok(Geometry::Points(read(input, &options.limits)?).into())
    })
    .with_magic(&[Magic::first(MAGIC)]);

/// First bytes of every such file.
const MAGIC: &[u8] = b"ASTM-E57";
/// Points without a colour among others that have one.
const GREY: [u8; 3] = [128; 3];

/// Reads the points of an E57 file.
fn read(input: Input, limits: &Limits) -> Result<PointCloud, ImportError> {
    let path = input.path();
    let bytes = input.rest()?;
    let length = bytes.len() as u64;
    check_header(path, &bytes)?;
    let fault = |what: String| ImportError::malformed(path, 0, what);
    let mut reader =
        guarded(|| E57Reader::new(Cursor::new(bytes)).map_err(|error| error.to_string())).map_err(fault)?;
    let scans = reader.pointclouds();
    let crs = reader.coordinate_metadata().unwrap_or_default().trim().to_owned();
    let count = scans.iter().try_fold(0u64, |sum, scan| sum.checked_add(scan.records)).unwrap_or(u64::MAX);
    if count > limits.points {
        return Err(ImportError::limit(path, None, "points", count, limits.points));
    }
    let mut points = Points { has_colors: scans.iter().any(Scan::has_color), ..Points::default() };
    for scan in &scans {
        check_scan(path, scan, length)?;
        let added = guarded(|| {
            let mut records = reader.pointcloud_simple(scan).map_err(|error| error.to_string())?;
            records.intensity_to_color(false);
            records.try_for_each(|point| {
                points.add(&point.map_err(|error| error.to_string())?);
                Ok(())
            })
        });
        added.map_err(fault)?;
    }
    if scans.is_empty() {
        return Err(ImportError::at(path, 0, ImportErrorKind::Unsupported("the file holds no scan".into())));
    }
    let mut cloud = points.finish();
    let mut parts = NotShown::default();
    parts.count("picture", reader.images().len() as u64);
    cloud.notes.extend(parts.note());
    Ok(PointCloud { crs, ..cloud })
}

/// Pages must be whole and the description inside the file.
fn check_header(path: &Path, bytes: &[u8]) -> Result<(), ImportError> {
    let word =
        |at: usize| bytes.get(at..at + 8).and_then(|word| word.first_chunk()).map(|word| u64::from_le_bytes(*word));
    let (Some(whole), Some(start), Some(size)) = (word(16), word(24), word(32)) else {
        return Err(ImportError::truncated(path, bytes.len() as u64, "the header"));
    };
    let length = bytes.len() as u64;
    if whole > length {
        return Err(ImportError::truncated(path, length, format!("its {whole} bytes")));
    }
    if start.checked_add(size).is_none_or(|end| end > length) {
        return Err(ImportError::malformed(path, 24, "the description lies outside of the file"));
    }
    Ok(())
}

/// Each point takes bits: there cannot be more points than the file has room for.
fn check_scan(path: &Path, scan: &Scan, length: u64) -> Result<(), ImportError> {
    let bits = |kind: &RecordDataType| match kind {
        RecordDataType::Single { .. } => 32,
        RecordDataType::Double { .. } => 64,
        RecordDataType::ScaledInteger { min, max, .. } | RecordDataType::Integer { min, max } => {
            u64::from(128 - (i128::from(*max) - i128::from(*min)).max(0).leading_zeros())
        }
    };
    let size: u64 = scan.prototype.iter().map(|record| bits(&record.data_type)).sum();
    if scan.records > 0 && (size == 0 || scan.records > length.saturating_mul(8) / size) {
        let what = format!("a scan of {} points, for which the file has no room", scan.records);
        return Err(ImportError::malformed(path, 0, what));
    }
    Ok(())
}

/// Points so far.
#[derive(Default)]
struct Points {
    has_colors: bool,
    local_origin: LocalOrigin,
    cloud: PointCloud,
    left_out: u64,
}

impl Points {
    fn add(&mut self, point: &::e57::Point) {
        let CartesianCoordinate::Valid { x, y, z } = point.cartesian else {
            self.left_out += 1;
            return;
        };
        let placed = self.local_origin.localized(DVec3::new(x, y, z));
        if !placed.is_finite() {
            self.left_out += 1;
            return;
        }
        self.cloud.positions.push(placed);
        if self.has_colors {
            let byte = |value: f32| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
            let color = point.color.as_ref().map(|color| [color.red, color.green, color.blue].map(byte));
            self.cloud.colors.push(color.unwrap_or(GREY));
        }
        self.cloud.intensities.push((point.intensity.unwrap_or(0.0).clamp(0.0, 1.0) * 65_535.0).round() as u16);
    }

    fn finish(mut self) -> PointCloud {
        if self.left_out > 0 {
            self.cloud.notes.push(format!("{} points without a place are left out", self.left_out));
        }
        if self.cloud.intensities.iter().all(|&value| value == 0) {
            self.cloud.intensities = Vec::new();
        }
        self.cloud.offset = self.local_origin.offset();
        self.cloud.unit = voxtrace_scene::scene::LengthUnit::METRE;
        self.cloud
    }
}
