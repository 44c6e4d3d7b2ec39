//! LAS 1.0 to 1.5 and its compressed kin LAZ: scans from the air and the ground (ASPRS, "LAS Specification 1.4 R15", 2019).
//! Read are positions, colours, intensities and classes; points that the file withholds are left out.

mod compressed;
mod frame;
mod header;
mod large;
mod records;
mod reference;
mod tiles;

use crate::import::reader::{Geometry, ImportOptions, Kind, LargeContent, Magic, Reader};
use crate::import::source::input::Input;
use crate::import::source::listing;
use header::Header;
use records::Records;
use tiles::{Tile, Tiles};
use voxtrace_voxelize::points::PointCloud;
use voxtrace_voxelize::{ImportError, ImportErrorKind, Limits};

/// What the table of readers has of this format.
pub(crate) const READER: Reader = Reader::new(
    "LAS",
    Kind::Points,
    EXTENSIONS,
    "laser scan, and .las: points with colours, intensities, classes; a folder of them is one",
    |source, options| {
        let path = source.path();
        let cloud = match source.tiles(EXTENSIONS, &options.limits)? {
            Some(files) => Tiles::open(path, &files, options)?.read(path, &options.limits)?,
            None => read(source.into_input()?.0, options)?,
        };
        Ok(Geometry::Points(cloud).into())
    },
)
.with_magic(&[Magic::first(MAGIC)])
.with_folders(|folder| Ok(!listing::files_with(folder.path, EXTENSIONS, folder.limits())?.is_empty()))
.with_tiles_and_filter()
.with_large(|source, _, options| {
    let path = source.path();
    let files = source.tiles(EXTENSIONS, &options.limits)?.unwrap_or_else(|| vec![path.into()]);
    let source = large::LasPoints::open(path, &files, options)?;
    let size = source.size_bytes();
    Ok(Some(LargeContent::of_points(source, size)))
});

/// Extensions, the one to name the format by first.
const EXTENSIONS: &[&str] = &["laz", "las"];
/// First bytes of every such file.
const MAGIC: &[u8] = b"LASF";
/// Points taken at once.
const BATCH: u64 = 1 << 16;

/// Reads the points of a LAS or LAZ file.
fn read(mut input: Input, options: &ImportOptions) -> Result<PointCloud, ImportError> {
    let (path, limits) = (input.path(), &options.limits);
    let tile = Tile::of(&mut input)?;
    if tile.header.points > limits.points {
        let (at, points) = (tile.header.points_at, tile.header.points);
        return Err(ImportError::limit(path, Some(at), "points", points, limits.points));
    }
    let mut all = Tiles::join(path, vec![tile], options)?;
    let Some(Tile { header, .. }) = all.tiles.first() else { return Ok(all.frame) };
    let mut records = Records::new(header, None, None);
    read_points(input, header, limits, &mut records)?;
    let left_out = records.left_out();
    if records.chosen() == 0 && left_out.not_chosen > 0 {
        return Err(all.none_left(path, &left_out));
    }
    let points = records.finish();
    all.frame.notes.extend(left_out.notes());
    Ok(in_frame(points, all.frame))
}

/// Reads the points of a file whose header was read.
fn read_points(mut input: Input, header: &Header, limits: &Limits, records: &mut Records) -> Result<(), ImportError> {
    let path = input.path();
    if header.is_compressed {
        return compressed::read(input, header, limits, records);
    }
    let size = u64::from(header.record_size);
    check_length(&input, header)?;
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
    Ok(())
}

/// Points with what is known of all of them.
fn in_frame(points: PointCloud, frame: PointCloud) -> PointCloud {
    let PointCloud { unit, crs, crs_from_cloud, notes, .. } = frame;
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
