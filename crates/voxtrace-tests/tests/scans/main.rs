//! Scans that other programs' libraries have written, read by the importers: laspy with lazrs, nibabel, pynrrd, pydicom,
//! tifffile and zarr, and a map that piqueserver has written; skipped where no Python has them.

mod dicom;
mod hyperstacks;
mod units;
mod volumes;
mod voxlap;
#[path = "../written/mod.rs"]
mod written;

use std::path::Path;
use voxtrace::Volume;
use voxtrace::glam::DVec3;
use voxtrace::import::{self, Geometry, ImportOptions};
use voxtrace::points::PointCloud;
use voxtrace::scene::Unit;
use voxtrace::volume::{self, Preset, VolumeOptions};
use voxtrace::voxelize::{Scale, VoxelizeOptions, VoxelizeProgress, voxelize_points};
use written::Written;

static WRITTEN: Written = Written::by("scans.py", "the libraries of scans");

fn read(path: &Path) -> Volume {
    import::read_volume(path, &ImportOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The volume that the script makes, x fastest.
fn values() -> Vec<f32> {
    let mut values = Vec::new();
    for (z, y) in (0..9).flat_map(|z| (0..12).map(move |y| (z, y))) {
        values.extend((0..15).map(|x| {
            let is_lump = x >= 2 && (1..9).contains(&y) && z < 7 && x + y + z < 22;
            if is_lump { (400 + 100 * z + 10 * x + y) as f32 } else { -1000.0 }
        }));
    }
    values
}

#[test]
fn one_volume_of_nibabel_pynrrd_and_pydicom_has_the_same_voxels_at_the_same_place() {
    let Some(folder) = WRITTEN.folder() else { return };
    let mut first = None;
    for name in [
        "volume.nii.gz",
        "second.nii",
        "volume.nrrd",
        "dicom",
        "dicom_rle",
        "dicom_j2k",
        "dicom_j2k_signed",
        "dicom_jls",
        "dicom_jls_signed",
        "dicom/3.dcm",
    ] {
        let volume = read(&folder.join(name));
        assert_eq!((volume.size, volume.unit), ([15, 12, 9], Unit::Millimetre), "{name}");
        assert!((volume.spacing() - DVec3::new(0.5, 0.75, 1.25)).abs().max_element() < 1e-6, "{name}");
        let last = volume.world_from_index.transform_point3(DVec3::new(14.0, 11.0, 8.0));
        assert!((last - DVec3::new(-3.0, 28.25, 40.0)).abs().max_element() < 1e-5, "{name}: {last}");
        let scene = |volume: &Volume| {
            let options = VolumeOptions { transfer: Some(Preset::CtBone.transfer()), ..VolumeOptions::default() };
            volume::voxelize(volume, &options, &ImportOptions::default().limits).unwrap()
        };
        let found: Vec<_> = scene(&volume).grids[0].voxels().collect();
        assert!(found.len() > 300, "{name}");
        assert!(*first.get_or_insert_with(|| found.clone()) == found, "{name} differs");
        assert!(volume.values == values(), "{name}");
        // One sample more is told apart.
        let mut other = volume.clone();
        other.values[0] = 500.0;
        assert!(scene(&other).grids[0].voxels().collect::<Vec<_>>() != found);
    }
}

#[test]
fn jpeg_ls_that_may_be_two_beside_the_truth_is_at_most_that() {
    let Some(folder) = WRITTEN.folder() else { return };
    let found = read(&folder.join("dicom_jls_near")).values;
    let worst = found.iter().zip(values()).map(|(found, wanted)| (found - wanted).abs()).fold(0.0, f32::max);
    assert!(found != values() && worst <= 2.0, "{worst}");
}

#[test]
fn pages_of_tifffile_and_arrays_of_zarr_hold_the_samples_that_were_written() {
    let Some(folder) = WRITTEN.folder() else { return };
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if !(name.ends_with("tif") || name.ends_with("zarr")) {
            continue;
        }
        // Of a picture of two channels that are alike each is asked for.
        let channels = if name == "picture.zarr" { 1..=2 } else { 1..=1 };
        for channel in channels {
            let options = ImportOptions { channel: Some(channel), ..ImportOptions::default() };
            let volume = import::read_volume(&path, &options).unwrap();
            assert_eq!(volume.size, [15, 12, 9], "{name}");
            assert!(volume.values == values(), "{name}");
        }
        count += 1;
    }
    assert_eq!(count, 19);
}

#[test]
fn a_geotiff_is_true_to_scale_and_keeps_its_place_on_the_map() {
    let Some(folder) = WRITTEN.folder() else { return };
    let scene = import::open(&folder.join("map.tiff"), &ImportOptions::default()).unwrap();
    assert_eq!((scene.unit, scene.voxel_size), (Unit::Metre, 2.0));
    // From 300 m to 350 m in steps of 2 m.
    assert_eq!(scene.grids[0].bounds().unwrap().max.to_array(), [4, 3, 26]);
    assert_eq!((0..26).filter(|&z| scene.grids[0].get([1, 1, z].into()).is_some()).count(), 0, "the hole");
    let place = scene.georeference.unwrap();
    assert_eq!(place.crs, "EPSG:25832");
    // The middle of the highest voxel, in the south-eastern corner.
    let top = place.coordinates_from_world.transform_point3(DVec3::new(3.5, 0.5, 25.5));
    assert!((top - DVec3::new(691_007.0, 5_334_995.0, 350.0)).length() < 1e-6, "{top}");
}

#[test]
fn the_level_of_a_picture_follows_the_resolution() {
    let Some(folder) = WRITTEN.folder() else { return };
    let mut options = ImportOptions::default();
    options.volume.scale = Some(Scale::Resolution(8));
    let coarse = import::read_volume(&folder.join("picture.zarr"), &options).unwrap();
    assert_eq!((coarse.size, coarse.unit), ([8, 6, 5], Unit::Millimetre));
    assert_eq!(coarse.spacing(), DVec3::new(1.0, 1.5, 2.5));
    assert_eq!(read(&folder.join("picture.zarr")).spacing(), DVec3::new(0.5, 0.75, 1.25));
}

fn cloud(path: &Path) -> PointCloud {
    match import::read_geometry(path, &ImportOptions::default()).unwrap() {
        Geometry::Points(cloud) => cloud,
        Geometry::Mesh(_) => panic!("{} is a cloud of points", path.display()),
    }
}

#[test]
fn the_points_of_laspy_have_the_same_voxels_as_las_and_laz_and_keep_their_place_on_earth() {
    let Some(folder) = WRITTEN.folder() else { return };
    let mut first = None;
    let names = [
        "points_1_2.las",
        "points_1_2.laz",
        "points_1_4.las",
        "points_1_4.laz",
        "points_behind.las",
        "points_behind.laz",
    ];
    for name in names {
        let cloud = cloud(&folder.join(name));
        assert_eq!((cloud.positions.len(), cloud.colors.len(), cloud.classes.len()), (2000, 2000, 2000), "{name}");
        let options = VoxelizeOptions { scale: Scale::VoxelSize(0.5), ..VoxelizeOptions::default() };
        let limits = ImportOptions::default().limits;
        let scene = voxelize_points(&cloud, &options, &limits, &VoxelizeProgress::default()).unwrap();
        let found: Vec<_> = scene.grids[0].voxels().collect();
        let first = first.get_or_insert_with(|| (found.clone(), scene.materials.clone()));
        assert!(found.len() > 1500 && *first == (found, scene.materials.clone()), "{name} differs");
        let place = scene.georeference.unwrap();
        let origin = place.coordinates_from_world.translation;
        assert_eq!(origin, DVec3::new(691_000.0, 5_335_000.0, 500.0), "{name}");
        // GeoTIFF keys in the older version, WKT in the newer, also behind the points.
        let expected = if name.contains("1_2") { "EPSG:32632" } else { "WGS 84 / UTM zone 32N" };
        assert_eq!(place.crs_name(), expected, "{name}: {}", place.crs);
    }
}
