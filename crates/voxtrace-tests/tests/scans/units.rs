//! Clouds in feet and degrees, written by laspy with the systems of pyproj, become metres and keep their place on the map.

use crate::written::Written;
use serde_json::Value;
use std::path::Path;
use voxtrace::Scene;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::import::{self, Geometry, ImportOptions, MapBounds, PointFilter};
use voxtrace::points::PointCloud;
use voxtrace::scene::{LengthUnit, Unit};
use voxtrace::voxelize::{Scale, VoxelizeOptions, VoxelizeProgress, voxelize_points};

static WRITTEN: Written = Written::by("units.py", "laspy, pyproj and tifffile");

fn cloud(path: &Path, options: &ImportOptions) -> PointCloud {
    match import::read_geometry(path, options).unwrap() {
        Geometry::Points(cloud) => cloud,
        Geometry::Mesh(_) => panic!("{} is a cloud of points", path.display()),
    }
}

fn numbers(value: &Value) -> DVec3 {
    DVec3::from_slice(&value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect::<Vec<_>>())
}

/// The scene of a cloud on voxels of so many of its units.
fn scene_of(cloud: &PointCloud, size: f64) -> Scene {
    let options = VoxelizeOptions { scale: Scale::VoxelSize(size), ..VoxelizeOptions::default() };
    voxelize_points(cloud, &options, &ImportOptions::default().limits, &VoxelizeProgress::default()).unwrap()
}

/// Whether a scene of a cloud has the size that pyproj says, and its first point the coordinates that laspy wrote; what differs.
fn difference(cloud: &PointCloud, wanted: &Value) -> Result<(), String> {
    let metres = cloud.unit.metres().unwrap_or(1.0);
    let (low, high) = cloud.bounds().unwrap();
    let (size, truth) = ((high - low) * metres, numbers(&wanted["metres"]));
    let tolerance = wanted["tolerance"].as_f64().unwrap();
    // Positions are f32, to a thousandth of a unit.
    if (size - truth).abs().max_element() > tolerance + 1e-3 {
        return Err(format!("{size} m where {truth} m are right"));
    }
    let first = cloud.positions[0].as_dvec3() + cloud.offset;
    let found = cloud.crs_from_cloud.transform_point3(first);
    let wanted = numbers(&wanted["first"]);
    // A millimetre: in degrees of an arc, or in feet.
    let close = if wanted.x.abs() < 360.0 { DVec3::new(1e-8, 1e-8, 1e-3) } else { DVec3::splat(2e-3) };
    if (found - wanted).abs().cmpgt(close).any() {
        return Err(format!("the first point is at {found}, not {wanted}"));
    }
    Ok(())
}

fn expected(folder: &Path) -> serde_json::Map<String, Value> {
    let text = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    serde_json::from_str::<Value>(&text).unwrap().as_object().unwrap().clone()
}

#[test]
fn las_in_feet_and_degrees_is_as_many_metres_as_its_reference_system_says() {
    let Some(folder) = WRITTEN.folder() else { return };
    let expected = expected(folder);
    assert_eq!(expected.len(), 15);
    for (name, wanted) in &expected {
        let mut cloud = cloud(&folder.join(name), &ImportOptions::default());
        difference(&cloud, wanted).unwrap_or_else(|what| panic!("{name}: {what}"));
        assert_eq!(cloud.unit == LengthUnit::UNKNOWN, name == "unknown.las", "{name}");
        assert_eq!(cloud.notes.len(), usize::from(name.contains("and_metres") || name.contains("degrees")), "{name}");
        // A foot that is taken for a metre, or a degree for a unit, is told apart.
        if !name.contains("metres.las") || name.contains("and") {
            cloud.unit = LengthUnit::of_metres(cloud.unit.metres().unwrap_or(1.0) * 1.001);
            assert!(name == "unknown.las" || difference(&cloud, wanted).is_err(), "{name}");
        }
    }
}

#[test]
fn the_scene_of_a_cloud_in_feet_is_in_metres_and_its_place_on_the_map_in_feet() {
    let Some(folder) = WRITTEN.folder() else { return };
    let cloud = cloud(&folder.join("us_feet_1_4.laz"), &ImportOptions::default());
    let scene = scene_of(&cloud, 2.0);
    assert_eq!((scene.unit, scene.voxel_size), (Unit::Metre, 2.0 * 1200.0 / 3937.0));
    let size = scene.grids[0].bounds().unwrap().size();
    assert!((size - IVec3::new(500, 300, 45)).abs().max_element() <= 1, "{size}");
    let place = scene.georeference.unwrap().coordinates_from_world;
    assert_eq!((place.matrix3.x_axis, place.translation), (DVec3::X * 2.0, DVec3::new(6e6, 2e6, 100.0)));
    assert_eq!(cloud.crs.split('"').nth(1), Some("NAD83 / California zone 3 (ftUS)"));
}

#[test]
fn a_unit_that_is_asked_for_goes_before_that_of_the_file() {
    let Some(folder) = WRITTEN.folder() else { return };
    let read = |name: &str, unit| cloud(&folder.join(name), &ImportOptions { unit, ..ImportOptions::default() });
    for (name, unit) in [
        ("unknown.las", LengthUnit::FOOT),
        ("feet_1_2.las", LengthUnit::METRE),
        ("feet_and_metres.las", LengthUnit::KILOMETRE),
        ("degrees_a.las", LengthUnit::METRE),
    ] {
        let asked = read(name, Some(unit));
        assert_eq!((asked.unit, asked.notes.len()), (unit, 0), "{name}");
        assert_eq!(asked.crs_from_cloud, Default::default(), "{name}");
    }
    let expected = expected(folder);
    let feet = read("unknown.las", Some(LengthUnit::FOOT));
    assert_eq!(difference(&feet, &expected["own_feet.las"]), Ok(()));
}

#[test]
fn degrees_that_stay_in_their_file_are_the_voxels_of_those_in_memory() {
    let Some(folder) = WRITTEN.folder() else { return };
    for name in ["degrees_a.las", "degrees_b.laz", "us_feet_1_4.laz", "feet_and_metres.las"] {
        let (path, options) = (folder.join(name), ImportOptions::default());
        let mut large = import::open_large(&path, &options, 1000).unwrap().expect("larger than a kilobyte");
        let cloud = cloud(&path, &options);
        assert_eq!(large.unit(), cloud.unit);
        let how = VoxelizeOptions {
            scale: Scale::VoxelSize(3.0),
            memory_budget: Some(1 << 24),
            ..VoxelizeOptions::default()
        };
        let out = folder.join(format!("{name}.vxt"));
        large.voxelize_to_file(&how, &options.limits, &out, &VoxelizeProgress::default()).unwrap();
        let (found, wanted) = (import::open(&out, &options).unwrap(), scene_of(&cloud, 3.0));
        assert_eq!((found.unit, found.voxel_size), (wanted.unit, wanted.voxel_size), "{name}");
        assert_eq!(found.georeference, wanted.georeference, "{name}");
        assert!(found.grids[0].voxels().eq(wanted.grids[0].voxels()), "{name}");
    }
}

#[test]
fn a_box_is_in_the_coordinates_of_the_file_whatever_its_points_are_changed_to() {
    let Some(folder) = WRITTEN.folder() else { return };
    for name in ["degrees_a.las", "degrees_b.laz", "feet_and_metres.las", "us_feet_1_4.laz"] {
        let all = cloud(&folder.join(name), &ImportOptions::default());
        let on_map = |cloud: &PointCloud| -> Vec<DVec3> {
            let place = |position: &Vec3| position.as_dvec3() + cloud.offset;
            cloud.positions.iter().map(|at| cloud.crs_from_cloud.transform_point3(place(at))).collect()
        };
        let places = on_map(&all);
        let (low, high) = places.iter().fold((DVec3::MAX, DVec3::MIN), |(low, high), &at| (low.min(at), high.max(at)));
        let bounds = MapBounds { low: low.lerp(high, 0.25), high: low.lerp(high, 0.75) };
        let points = PointFilter { bounds: Some(bounds), classes: None };
        let chosen = cloud(&folder.join(name), &ImportOptions { points, ..ImportOptions::default() });
        let wanted = places.iter().filter(|&&at| bounds.contains(at)).count();
        // On the faces of the box a rounded place may be on the other side.
        assert!(wanted > 100 && chosen.positions.len().abs_diff(wanted) <= 2, "{name}: {wanted}");
        let room = (high - low) * 1e-5;
        let wide = MapBounds { low: bounds.low - room, high: bounds.high + room };
        assert!(on_map(&chosen).iter().all(|&at| wide.contains(at)), "{name}");
    }
}

#[test]
fn every_projected_system_of_epsg_has_the_unit_of_pyproj() {
    let Some(folder) = WRITTEN.folder() else { return };
    let text = std::fs::read_to_string(folder.join("epsg.json")).unwrap();
    let systems: std::collections::BTreeMap<u16, f64> = serde_json::from_str(&text).unwrap();
    let (mut feet, mut others) = (0, 0);
    for (&code, &metres) in &systems {
        let unit = unit_of_system(code);
        // Yards, chains, links and a metre of Germany's colonies: old systems that no LAS file is in.
        let is_old = ![1.0, 0.3048, 1200.0 / 3937.0].iter().any(|known: &f64| (metres / known - 1.0).abs() < 1e-9);
        others += u32::from(is_old);
        feet += u32::from(unit != LengthUnit::METRE);
        assert!(is_old || unit == LengthUnit::of_metres(metres), "EPSG:{code}: {unit:?}, not {metres}");
    }
    assert!(
        systems.len() > 5000 && feet > 900 && others < 40,
        "{} systems, {feet} in feet, {others} others",
        systems.len()
    );
}

/// The unit of a point in a file that names a system by its number alone.
fn unit_of_system(code: u16) -> LengthUnit {
    let mut bytes = vec![0; 227];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF\0\0\0\0");
    put(24, &[1, 2]);
    put(94, &227u16.to_le_bytes());
    put(96, &(227u32 + 54 + 16).to_le_bytes());
    put(100, &1u32.to_le_bytes());
    put(105, &20u16.to_le_bytes());
    put(107, &1u32.to_le_bytes());
    (0..3).for_each(|axis| put(131 + 8 * axis, &1f64.to_le_bytes()));
    let mut record = [0; 54];
    record[2..17].copy_from_slice(b"LASF_Projection");
    record[18..20].copy_from_slice(&34_735u16.to_le_bytes());
    record[20..22].copy_from_slice(&16u16.to_le_bytes());
    bytes.extend(record);
    bytes.extend([1, 1, 0, 1, 3072, 0, 1, code].iter().flat_map(|word: &u16| word.to_le_bytes()));
    bytes.extend([0; 20]);
    match import::geometry_from_bytes(&bytes, Path::new("a.las"), &ImportOptions::default()).unwrap() {
        Geometry::Points(cloud) => cloud.unit,
        Geometry::Mesh(_) => panic!("a cloud"),
    }
}

#[test]
fn heights_on_a_map_in_feet_are_true_to_scale() {
    let Some(folder) = WRITTEN.folder() else { return };
    for (name, levels) in [("feet.tif", 7), ("feet_and_metres.tif", 19)] {
        let scene = import::open(&folder.join(name), &ImportOptions::default()).unwrap();
        // 10 feet a pixel; 55 feet of heights are 5.5 pixels, 55 metres are 18.04.
        assert_eq!(scene.unit, Unit::Metre, "{name}");
        assert!((scene.voxel_size - 3.048).abs() < 1e-9, "{name}: {}", scene.voxel_size);
        assert_eq!(scene.grids[0].bounds().unwrap().size(), IVec3::new(4, 3, levels), "{name}");
        let place = scene.georeference.unwrap().coordinates_from_world;
        assert_eq!(place.matrix3.x_axis, DVec3::X * 10.0, "{name}");
        // The middle of the lowest voxel is 0 feet or metres high.
        assert!(place.transform_point3(DVec3::new(0.0, 0.0, 0.5)).z.abs() < 1e-9, "{name}");
    }
}
