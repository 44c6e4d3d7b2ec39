//! Tiles of a scan as one cloud, by classes and boxes: nothing depends on how many files there are, in memory or out of core.

use crate::point_samples::{FAR, Point, las, laz, options, ply, sample, scene_of, text, voxels};
use std::path::{Path, PathBuf};
use voxtrace::glam::DVec3;
use voxtrace::import::{self, Geometry, ImportErrorKind, ImportOptions, Limits, PointFilter, READERS};
use voxtrace::points::{ColorBy, PointCloud};
use voxtrace::voxelize::{PointOptions, Scale, VoxelizeOptions, VoxelizeProgress, voxelize_points_to_file};

/// The points of the sample in the files of a folder: west as LAS, east as LAZ with another format of points.
fn tiles(folder: &Path) -> Vec<PathBuf> {
    let (west, east): (Vec<Point>, Vec<Point>) = sample().into_iter().partition(|(place, ..)| place[0] < 32);
    let files = [("west.las", las(&west, (2, 3))), ("east.LAZ", laz(&east, (4, 7)))];
    std::fs::write(folder.join("readme.txt"), "no tile").unwrap();
    files
        .map(|(name, bytes)| (folder.join(name), bytes))
        .map(|(path, bytes)| {
            std::fs::write(&path, with_bounds(bytes)).unwrap();
            path
        })
        .into()
}

/// A LAS or LAZ file whose header has the bounds of its points.
pub fn with_bounds(mut bytes: Vec<u8>) -> Vec<u8> {
    let cloud = cloud_of(import::geometry_from_bytes(&bytes, Path::new("a.las"), &ImportOptions::default()).unwrap());
    let (low, high) = cloud.bounds().unwrap();
    for axis in 0..3 {
        bytes[179 + 16 * axis..][..16].copy_from_slice([high[axis], low[axis]].map(f64::to_le_bytes).as_flattened());
    }
    bytes
}

fn cloud_of(geometry: Geometry) -> PointCloud {
    match geometry {
        Geometry::Points(cloud) => cloud,
        Geometry::Mesh(_) => panic!("a cloud"),
    }
}

/// Positions with everything that belongs to them, in any order.
fn sorted(cloud: &PointCloud) -> Vec<([i64; 3], [u8; 3], u16, u8)> {
    let steps = |place: DVec3| (place * 4.0).to_array().map(|value| value.round() as i64);
    let points = cloud.positions.iter().enumerate().map(|(at, position)| {
        let color = cloud.colors.get(at).copied().unwrap_or_default();
        let class = cloud.classes.get(at).copied().unwrap_or_default();
        (
            steps(position.as_dvec3() + cloud.offset),
            color,
            cloud.intensities.get(at).copied().unwrap_or_default(),
            class,
        )
    });
    let mut points: Vec<_> = points.collect();
    points.sort_unstable();
    points
}

fn expected(is_kept: impl Fn(&Point) -> bool) -> Vec<([i64; 3], [u8; 3], u16, u8)> {
    let place = |steps: [i32; 3]| [0, 1, 2].map(|axis| (FAR[axis] * 4.0) as i64 + i64::from(steps[axis]));
    let points = sample().into_iter().filter(|point| is_kept(point));
    let mut points: Vec<_> =
        points.map(|(steps, color, intensity, class)| (place(steps), color, intensity, class)).collect();
    points.sort_unstable();
    points
}

fn filter(classes: &str, bounds: &str) -> ImportOptions {
    let points = PointFilter {
        classes: (!classes.is_empty()).then(|| classes.parse().unwrap()),
        bounds: (!bounds.is_empty()).then(|| bounds.parse().unwrap()),
    };
    ImportOptions { points, ..ImportOptions::default() }
}

#[test]
fn the_files_of_a_folder_and_those_that_are_named_are_one_cloud() {
    let folder = tempfile::tempdir().unwrap();
    let files = tiles(folder.path());
    let all = expected(|_| true);
    let plain = ImportOptions::default();
    let by_folder = cloud_of(import::read_geometry(folder.path(), &plain).unwrap());
    assert_eq!(sorted(&by_folder), all);
    let reversed: Vec<PathBuf> = files.iter().rev().cloned().collect();
    for names in [&files, &reversed, &vec![folder.path().into()]] {
        let import::Data::Geometry(geometry) = READERS.open_all(names, &plain).unwrap().read().unwrap() else {
            panic!()
        };
        assert_eq!(sorted(&cloud_of(geometry)), all);
    }
    // A point that is missing is seen.
    assert_ne!(sorted(&cloud_of(import::read_geometry(&files[0], &plain).unwrap())), all);
}

#[test]
fn classes_and_boxes_choose_the_same_points_in_every_format_and_in_tiles() {
    let folder = tempfile::tempdir().unwrap();
    tiles(folder.path());
    let file = |name: &str, bytes: Vec<u8>| {
        let path = folder.path().join("one").join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, bytes).unwrap();
        path
    };
    let points = sample();
    let bounds = format!("{},{},{},{}", FAR[0] + 3.0, FAR[1], FAR[0] + 9.5, FAR[1] + 7.25);
    let paths = [
        folder.path().to_path_buf(),
        file("a.las", with_bounds(las(&points, (2, 3)))),
        file("a.laz", laz(&points, (4, 7))),
        file("a.csv", text(&points)),
    ];
    let in_box = |(place, ..): &Point| (12..=38).contains(&place[0]) && (0..=29).contains(&place[1]);
    for path in &paths {
        let read = |options: &ImportOptions| sorted(&cloud_of(import::read_geometry(path, options).unwrap()));
        assert_eq!(read(&filter("2,building", "")), expected(|point| [2, 6].contains(&point.3)), "{}", path.display());
        assert_eq!(read(&filter("", &bounds)), expected(in_box), "{}", path.display());
        let both = expected(|point| in_box(point) && (3..=5).contains(&point.3));
        assert_eq!(read(&filter("vegetation", &bounds)), both, "{}", path.display());
        assert!(both.len() > 10 && both != expected(in_box));
    }
    // What has no classes cannot be chosen by them, and what nobody asked for leaves nothing.
    for (path, options, wanted) in [
        (file("a.ply", ply(&points)), filter("2", ""), "no classes"),
        (paths[1].clone(), filter("", "0,0,1,1"), "691000"),
        (paths[0].clone(), filter("", "0,0,1,1"), "691000"),
        (paths[0].clone(), filter("40", ""), "are of the classes 1, 2, 3"),
    ] {
        let error = import::read(&path, &options).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::NothingChosen(_)), "{error}");
        assert!(error.to_string().contains(wanted), "{error}");
    }
}

#[test]
fn tiles_that_stay_in_their_files_give_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    tiles(folder.path());
    // One whose points have no colours and no classes.
    let bare: Vec<Point> =
        sample().iter().map(|&([x, y, z], _, intensity, _)| ([x + 64, y, z], [0; 3], intensity, 0)).collect();
    std::fs::write(folder.path().join("bare.las"), with_bounds(las(&bare, (2, 2)))).unwrap();
    let ply_path = folder.path().join("a.ply");
    std::fs::write(&ply_path, ply(&sample())).unwrap();
    let bounds = format!("{},{},{},{}", FAR[0] + 3.0, FAR[1], FAR[0] + 19.5, FAR[1] + 9.25);
    for (path, import_options, color_by) in [
        (folder.path(), filter("", ""), ColorBy::Auto),
        (folder.path(), filter("", ""), ColorBy::Intensity),
        (folder.path(), filter("0,1,2,3", &bounds), ColorBy::Classification),
        (&ply_path, filter("", &bounds), ColorBy::Auto),
    ] {
        for scale in [Scale::VoxelSize(0.5), Scale::Automatic] {
            let plain = options(scale, PointOptions { color_by, min_points: 1 });
            let cloud = cloud_of(import::read_geometry(path, &import_options).unwrap());
            let notes = cloud.notes.clone();
            let (expected, out) = (folder.path().join("expected.vxt"), folder.path().join("out.vxt"));
            let (limits, progress) = (Limits::default(), VoxelizeProgress::default());
            voxelize_points_to_file(cloud, &plain, &limits, &expected, &progress).unwrap();
            let mut large = import::open_large(path, &import_options, 1).unwrap().expect("a folder stays on the disk");
            let how = VoxelizeOptions { memory_budget: Some(1), ..plain };
            large.voxelize_to_file(&how, &limits, &out, &progress).unwrap();
            assert!(std::fs::read(&out).unwrap() == std::fs::read(&expected).unwrap(), "{} {plain:?}", path.display());
            assert_eq!(large.notes(), notes);
        }
    }
    let note = "300 points of tiles without colours are grey";
    assert_eq!(cloud_of(import::read_geometry(folder.path(), &filter("", "")).unwrap()).notes, [note]);
    // A filter that leaves nothing says so there, too.
    let mut large = import::open_large(folder.path(), &filter("40", ""), 1).unwrap().unwrap();
    assert!(large.survey(&VoxelizeOptions::default(), &VoxelizeProgress::default()).is_err());
}

/// A LAS file with a reference system by the keys of GeoTIFF.
fn in_system(points: &[Point], code: u16) -> Vec<u8> {
    let mut bytes = las(points, (2, 2));
    let mut record = vec![0; 54];
    record[2..17].copy_from_slice(b"LASF_Projection");
    record[18..20].copy_from_slice(&34_735u16.to_le_bytes());
    record[20..22].copy_from_slice(&16u16.to_le_bytes());
    record.extend([1, 1, 0, 1, 3072, 0, 1, code].iter().flat_map(|word: &u16| word.to_le_bytes()));
    bytes[96..100].copy_from_slice(&(227 + record.len() as u32).to_le_bytes());
    bytes[100..104].copy_from_slice(&1u32.to_le_bytes());
    bytes.splice(227..227, record);
    bytes
}

#[test]
fn tiles_of_other_units_or_reference_systems_are_refused_and_silent_ones_are_taken_with_a_note() {
    let folder = tempfile::tempdir().unwrap();
    let points = sample();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("a.las", &in_system(&points, 32_632));
    let read = |options: &ImportOptions| import::read_geometry(folder.path(), options).map(cloud_of);
    let plain = ImportOptions::default();
    for (code, wanted) in [(32_633, "reference system EPSG:32633"), (2227, "is in us-ft")] {
        write("b.las", &in_system(&points, code));
        let error = read(&plain).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::OtherTiles(_)), "{error}");
        assert!(error.path.ends_with("b.las") && error.to_string().contains(wanted), "{error}");
    }
    write("b.las", &in_system(&points, 32_632));
    assert!(read(&plain).unwrap().notes.is_empty());
    write("b.las", &las(&points, (2, 2)));
    let cloud = read(&plain).unwrap();
    assert_eq!(cloud.notes, ["1 of 2 tiles say no reference system: that of the others is taken"]);
    assert_eq!((cloud.positions.len(), &*cloud.crs), (600, "EPSG:32632"));
    assert!(!voxels(&scene_of(&cloud, &VoxelizeOptions::default()).unwrap()).is_empty());
    // Files of other kinds are not one.
    let mixed = [folder.path().join("a.las"), folder.path().join("a.csv")];
    write("a.csv", &text(&points));
    assert!(matches!(READERS.open_all(&mixed, &plain).map(drop).unwrap_err().kind, ImportErrorKind::OtherTiles(_)));
}
