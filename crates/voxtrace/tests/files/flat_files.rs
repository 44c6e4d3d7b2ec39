//! Files that are alike almost all over, as label maps and flat worlds are: compressed a thousand times, and read.

use crate::zipped::gzip;
use flate2::{Compression, write::ZlibEncoder};
use std::io::Write;
use std::path::Path;
use voxtrace::export::writer_of;
use voxtrace::glam::IVec3;
use voxtrace::grid::VoxelBox;
use voxtrace::import::{self, ImportErrorKind, ImportOptions, Limits};
use voxtrace::{Material, Scene, VoxelGrid};

/// Samples along each axis of a mask, 27 million in all.
const SIZE: [usize; 3] = [300, 300, 300];

/// A cube of 8000 voxels of label 3 in nothing.
fn mask() -> Vec<u8> {
    let mut values = vec![0; SIZE.iter().product()];
    for i in 0..8000 {
        let (x, y, z) = (100 + i % 20, 120 + i / 20 % 20, 140 + i / 400);
        values[(z * SIZE[1] + y) * SIZE[0] + x] = 3;
    }
    values
}

fn count(path: &Path, limits: Limits) -> Result<u64, import::ImportError> {
    let scene = import::open(path, &ImportOptions { limits, ..ImportOptions::default() })?;
    Ok(scene.instances.iter().map(|instance| scene.grids[instance.grid].count()).sum())
}

/// Reads a file, which is compressed more than 500 times, with the usual limits, and refuses it with too few bytes.
fn assert_read(path: &Path, whole: usize, wanted: u64) {
    let packed = std::fs::metadata(path).unwrap().len();
    assert!(whole as u64 / packed > 500, "{}: {packed} bytes", path.display());
    assert_eq!(count(path, Limits::default()).unwrap(), wanted, "{}", path.display());
    let few = Limits { bytes: whole as u64 / 2, ..Limits::default() };
    let error = count(path, few).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
}

#[test]
fn masks_are_read_from_nrrd_nifti_and_metaimage() {
    let folder = tempfile::tempdir().unwrap();
    let (values, [x, y, z]) = (mask(), SIZE);
    let path = folder.path().join("mask.nrrd");
    let head = format!("NRRD0004\ntype: uint8\ndimension: 3\nsizes: {x} {y} {z}\nencoding: gzip\n\n");
    std::fs::write(&path, [head.as_bytes(), &gzip(&values)].concat()).unwrap();
    // Opaque labels are shown as a shell.
    let shell = 8000 - 18 * 18 * 18;
    assert_read(&path, values.len(), shell);

    let path = folder.path().join("mask.mha");
    let mut zlib = ZlibEncoder::new(Vec::new(), Compression::default());
    zlib.write_all(&values).unwrap();
    let head = format!(
        "ObjectType = Image\nNDims = 3\nDimSize = {x} {y} {z}\nElementType = MET_UCHAR\nCompressedData = True\nElementDataFile = LOCAL\n"
    );
    std::fs::write(&path, [head.as_bytes(), &zlib.finish().unwrap()].concat()).unwrap();
    assert_read(&path, values.len(), shell);

    let path = folder.path().join("mask.nii.gz");
    let mut nifti = vec![0u8; 352];
    nifti[..4].copy_from_slice(&348i32.to_le_bytes());
    for (at, number) in [(40, 3), (42, 300), (44, 300), (46, 300), (48, 1), (50, 1), (52, 1), (54, 1), (70, 2), (72, 8)]
    {
        nifti[at..at + 2].copy_from_slice(&(number as i16).to_le_bytes());
    }
    for at in [76, 80, 84, 88, 112] {
        nifti[at..at + 4].copy_from_slice(&1f32.to_le_bytes());
    }
    nifti[108..112].copy_from_slice(&352f32.to_le_bytes());
    nifti[344..348].copy_from_slice(b"n+1\0");
    nifti.extend(&values);
    std::fs::write(&path, gzip(&nifti)).unwrap();
    assert_read(&path, nifti.len(), shell);
}

#[test]
fn a_flat_world_is_read_from_the_schematic_that_it_is_written_to() {
    let folder = tempfile::tempdir().unwrap();
    let mut grid = VoxelGrid::new();
    grid.fill_box(VoxelBox { min: IVec3::ZERO, max: IVec3::new(1200, 1200, 2) }, 0);
    grid.fill_box(VoxelBox { min: IVec3::splat(600), max: IVec3::splat(603) }, 0);
    grid.fill_box(VoxelBox { min: IVec3::new(5, 5, 2), max: IVec3::new(6, 6, 25) }, 0);
    // The lone cube would make the box 600 blocks high.
    grid.clear_box(VoxelBox { min: IVec3::splat(600), max: IVec3::splat(603) });
    let scene = Scene::from_grid("flat", grid, vec![Material::from_srgb([0x7d; 3])]);
    let path = folder.path().join("flat.schem");
    writer_of(&path).unwrap().write(&path, &scene).unwrap();
    assert_read(&path, 1200 * 1200 * 25, 1200 * 1200 * 2 + 23);
}

/// A grey TIFF of 8 bits in one strip, packed by Deflate.
fn tiff(width: u32, height: u32) -> Vec<u8> {
    let mut zlib = ZlibEncoder::new(Vec::new(), Compression::default());
    let mut pixels = vec![40u8; width as usize * height as usize];
    pixels[7] = 90;
    zlib.write_all(&pixels).unwrap();
    let strip = zlib.finish().unwrap();
    let entries: [(u16, u16, u32); 9] = [
        (256, 4, width),
        (257, 4, height),
        (258, 3, 8),
        (259, 3, 8),
        (262, 3, 1),
        (273, 4, 8 + 2 + 9 * 12 + 4),
        (277, 3, 1),
        (278, 4, height),
        (279, 4, strip.len() as u32),
    ];
    let mut bytes = b"II*\0\x08\0\0\0\x09\0".to_vec();
    for (tag, kind, value) in entries {
        bytes.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
        bytes.extend([1u32.to_le_bytes(), value.to_le_bytes()].concat());
    }
    bytes.extend([0; 4]);
    bytes.extend(strip);
    bytes
}

#[test]
fn flat_pictures_are_heightmaps_and_what_is_too_large_is_not_called_damaged() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("flat.tif");
    std::fs::write(&path, tiff(5000, 5000)).unwrap();
    assert!(5000 * 5000 / std::fs::metadata(&path).unwrap().len() > 500);
    assert!(count(&path, Limits::default()).unwrap() >= 25_000_000);
    // A header that announces more than Deflate and LZW could make of what is there.
    let mut lying = tiff(5000, 5000);
    lying[8 + 2 + 8..][..4].copy_from_slice(&60_000u32.to_le_bytes());
    lying[8 + 2 + 12 + 8..][..4].copy_from_slice(&4000u32.to_le_bytes());
    std::fs::write(&path, lying).unwrap();
    let error = count(&path, Limits::default()).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
    // Trusted, it is what it is: damaged.
    let trusted = Limits { ratio: u64::MAX, points: u64::MAX, ..Limits::default() };
    let error = count(&path, trusted).unwrap_err();
    assert!(!matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
}
