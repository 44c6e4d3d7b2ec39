//! The header of a LAS file: what points look like and where they are. Only what is needed of it is believed.

use super::{MAGIC, unsupported};
use crate::import::reader::PointFilter;
use crate::import::source::input::Input;
use glam::DVec3;
use voxtrace_voxelize::ImportError;

/// Bytes of the header up to LAS 1.2.
const SHORT: usize = 227;
/// Bytes of the header of LAS 1.4.
const LONG: usize = 375;
/// Bytes of a point of each format.
const SIZES: [u16; 11] = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67];

/// What is known of the points.
pub(super) struct Header {
    /// Kind of points, 0 to 10.
    pub format: u8,
    pub is_compressed: bool,
    /// Bytes of a point.
    pub record_size: u16,
    pub points: u64,
    /// Where the file says how many.
    pub points_at: u64,
    /// Bytes of the header.
    pub size: u64,
    /// Number of variable length records after it.
    pub records: u32,
    /// Number of extended records behind the points, and where the first begins.
    pub extended: (u32, u64),
    /// Where the points begin.
    pub data: u64,
    pub scale: DVec3,
    pub offset: DVec3,
    /// The box around all points, which nobody need believe.
    pub bounds: (DVec3, DVec3),
    /// Which points are read; the box is in the coordinates of the points.
    pub filter: PointFilter,
}

impl Header {
    /// Measures points from another origin, and then in other steps.
    pub fn change(&mut self, origin: DVec3, scale: DVec3) {
        self.scale *= scale;
        self.offset = (self.offset - origin) * scale;
        self.bounds = ((self.bounds.0 - origin) * scale, (self.bounds.1 - origin) * scale);
        if let Some(wanted) = &mut self.filter.bounds {
            (wanted.low, wanted.high) = ((wanted.low - origin) * scale, (wanted.high - origin) * scale);
        }
    }

    /// The box around all points, if it is one.
    pub fn span(&self) -> Option<(DVec3, DVec3)> {
        let (low, high) = self.bounds;
        let is_box = low.is_finite() && high.is_finite() && low.cmple(high).all();
        // Some writers leave it empty.
        (is_box && (low, high) != (DVec3::ZERO, DVec3::ZERO)).then_some((low, high))
    }

    /// Looks at the header without taking it.
    pub fn read(input: &mut Input) -> Result<Self, ImportError> {
        let path = input.path();
        let bytes = input.peek(LONG)?;
        if bytes.len() < SHORT {
            return Err(ImportError::truncated(path, bytes.len() as u64, "the header"));
        }
        if !bytes.starts_with(MAGIC) {
            return Err(ImportError::malformed(path, 0, "a LAS file does not begin with LASF"));
        }
        let (major, minor) = (bytes[24], bytes[25]);
        if major != 1 || minor > 5 {
            return Err(unsupported(path, 24, format!("LAS {major}.{minor}")));
        }
        let has_long_records = minor >= 4;
        let needed = if has_long_records { LONG } else { SHORT };
        let size = u64::from(u16::from_le_bytes(array(bytes, 94)));
        if bytes.len() < needed || size < needed as u64 {
            return Err(ImportError::truncated(path, bytes.len() as u64, "the header"));
        }
        let format = bytes[104] & 0x3f;
        let record_size = u16::from_le_bytes(array(bytes, 105));
        let Some(&least) = SIZES.get(usize::from(format)) else {
            return Err(unsupported(path, 104, format!("points of format {format}")));
        };
        if record_size < least {
            let what = format!("points of {record_size} bytes, but format {format} has {least}");
            return Err(ImportError::malformed(path, 105, what));
        }
        let short_count = u64::from(u32::from_le_bytes(array(bytes, 107)));
        let long_count = if has_long_records { u64::from_le_bytes(array(bytes, 247)) } else { 0 };
        let (points, points_at) = if long_count > 0 { (long_count, 247) } else { (short_count, 107) };
        let extended = if has_long_records {
            (u32::from_le_bytes(array(bytes, 243)), u64::from_le_bytes(array(bytes, 235)))
        } else {
            (0, 0)
        };
        let data = u64::from(u32::from_le_bytes(array(bytes, 96)));
        if data < size {
            return Err(ImportError::malformed(path, 96, "the points begin inside the header"));
        }
        let vector = |at: usize| DVec3::from_array([0, 8, 16].map(|next| f64::from_le_bytes(array(bytes, at + next))));
        let (scale, offset) = (vector(131), vector(155));
        if !scale.is_finite() || !offset.is_finite() {
            return Err(ImportError::malformed(path, 131, "a scale or offset that is not finite"));
        }
        // Largest and least of x, of y and of z.
        let ends = [0, 8, 16, 24, 32, 40].map(|next| f64::from_le_bytes(array(bytes, 179 + next)));
        let bounds = (DVec3::new(ends[1], ends[3], ends[5]), DVec3::new(ends[0], ends[2], ends[4]));
        let records = u32::from_le_bytes(array(bytes, 100));
        let is_compressed = bytes[104] & 0x80 != 0;
        let filter = PointFilter::default();
        Ok(Self {
            format,
            is_compressed,
            record_size,
            points,
            points_at,
            size,
            records,
            extended,
            data,
            scale,
            offset,
            bounds,
            filter,
        })
    }
}

/// Bytes at a place that is known to be there.
pub(super) fn array<const N: usize>(bytes: &[u8], at: usize) -> [u8; N] {
    let mut array = [0; N];
    array.copy_from_slice(&bytes[at..at + N]);
    array
}
