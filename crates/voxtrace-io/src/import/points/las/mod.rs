//! LAS 1.0 to 1.5 and its compressed kin LAZ: scans from the air and the ground (ASPRS, "LAS Specification 1.4 R15", 2019).
//! Read are positions, colours, intensities and classes; points that the file withholds are left out.

mod compressed;
mod frame;
mod header;
mod large;
mod records;
mod reference;

use crate::import::reader::{Geometry, Kind, LargeContent, Magic, Reader};
use crate::import::source::input::Input;
use header::Header;
use records::Records;
use voxtrace_scene::scene::LengthUnit;
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "LAS",
    Kind::Points,
    &["laz", "las"],
    "laser scan, and .las: points with colours, intensities, classes",
    |source, options| {
        let (input, _) = source.into_input()?;
        Ok(Geometry::Points(read(input, options.unit, &options.limits)?).into())
    },
)
.with_magic(&[Magic::first(MAGIC)])
.with_large(|path, _, options| {
    let source = large::LasPoints::open(path, options)?;
    let size = source.size_bytes();
    Ok(Some(LargeContent::of_points(source, size)))
});

/// First bytes of every such file.
const MAGIC: &[u8] = b"LASF";
/// Points taken at once.
const BATCH: u64 = 1 << 16;

/// Reads the points of a LAS or LAZ file.
fn read(mut input: Input, unit: Option<LengthUnit>, limits: &Limits) -> Result<PointCloud, ImportError> {
    let path = input.path();
    let mut header = Header::read(&mut input)?;
    if header.points > limits.points {
        return Err(ImportError::limit(path, Some(header.points_at), "points", header.points, limits.points));
    }
    let (crs, units) = reference::read(&mut input, &header)?;
    let frame = frame::settle(&mut header, crs, units, unit);
    let mut records = Records::new(&header, None);
    if header.is_compressed {
        compressed::read(input, &header, limits, &mut records)?;
        return Ok(in_frame(records.finish(), frame));
    }
    let size = u64::from(header.record_size);
    check_length(&input, &header)?;
    input.skip(header.data, "what stands before the points")?;
    if input.remaining().is_some() {
        records.make_room(header.points).map_err(|what| ImportError::malformed(path, header.data, what))?;
    }
    let mut left = header.points;
    while left > 0 {
        let now = left.min(BATCH);
        records.add(input.take((now * size) as usize, "the points")?);
        left -= now;
    }
    Ok(in_frame(records.finish(), frame))
}

/// Points with what is known of all of them.
fn in_frame(points: PointCloud, frame: PointCloud) -> PointCloud {
    let PointCloud { unit, crs, crs_from_cloud, mut notes, .. } = frame;
    notes.extend(points.notes);
    PointCloud { unit, crs, crs_from_cloud, notes, ..points }
}

/// Checks that the points, which are not compressed, can be in the file.
fn check_length(input: &Input, header: &Header) -> Result<(), ImportError> {
    let size = header.points.saturating_mul(header.record_size.into());
    // A length is not known of a pipe; then the end shows itself.
    match input.remaining() {
        Some(length) if size > length.saturating_sub(header.data) => {
            Err(ImportError::truncated(input.path(), length, format!("the {} points", header.points)))
        }
        _ => Ok(()),
    }
}

fn unsupported(path: &std::path::Path, at: u64, what: String) -> ImportError {
    ImportError::at(path, at, ImportErrorKind::Unsupported(what))
}
