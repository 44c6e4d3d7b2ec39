//! Clouds of points in little memory: threads, budgets, and points that stay in their file change nothing.

use crate::meshes::Random;
use crate::point_samples::{FAR, Point, float_ply, las, laz, options, ply, scene_of, voxels};
use voxtrace::PackedScene;
use voxtrace::glam::Vec3;
use voxtrace::import::{self, Geometry, ImportOptions, Limits};
use voxtrace::points::{ColorBy, PointCloud};
use voxtrace::voxelize::{
    PointOptions, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, voxelize_points_to_file,
};

#[test]
fn threads_and_memory_budgets_change_nothing() {
    let mut random = Random(5);
    let positions: Vec<Vec3> = (0..40_000).map(|_| random.point(300.0)).collect();
    let colors = (0..40_000).map(|_| [random.below(256) as u8, random.below(4) as u8, 9]).collect();
    let cloud = PointCloud { positions, colors, ..PointCloud::default() };
    let plain = options(Scale::Resolution(200), PointOptions::default());
    let scene = scene_of(&cloud, &plain).unwrap();
    let pool = rayon::ThreadPoolBuilder::new().num_threads(7).build().unwrap();
    assert_eq!(voxels(&pool.install(|| scene_of(&cloud, &plain)).unwrap()), voxels(&scene));
    let folder = tempfile::tempdir().unwrap();
    let packed = PackedScene::pack(&scene).unwrap();
    for memory_budget in [None, Some(1)] {
        let path = folder.path().join("out.vxt");
        let options = VoxelizeOptions { memory_budget, ..plain };
        let progress = VoxelizeProgress::default();
        let written = voxelize_points_to_file(cloud.clone(), &options, &Limits::default(), &path, &progress).unwrap();
        assert_eq!(written.voxels, voxels(&scene).len() as u64);
        assert_eq!(PackedScene::open(&path).unwrap().content_hash(), packed.content_hash(), "{memory_budget:?}");
        assert_eq!((progress.done(), progress.total()), (40_000, 40_000));
    }
}

#[test]
fn points_that_stay_in_their_file_give_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(11);
    // More than are read at once, some of them with one more point in the same voxel.
    let points: Vec<Point> = (0..80_000)
        .map(|at| {
            let mut below = |end: usize| random.below(end);
            let place = [below(700) as i32, below(500) as i32, below(90) as i32];
            (place, [below(256) as u8, (at / 320) as u8, 7], below(3000) as u16, 1 + below(9) as u8)
        })
        .collect();
    let bare: Vec<Point> = points.iter().map(|&(place, ..)| (place, [0; 3], 0, 0)).collect();
    for (name, bytes, colors) in [
        (
            "a.las",
            las(&points, (2, 3)),
            &[ColorBy::Auto, ColorBy::Height, ColorBy::Intensity, ColorBy::Classification][..],
        ),
        ("a.laz", laz(&points, (4, 7)), &[ColorBy::Auto, ColorBy::Intensity]),
        ("bare.las", las(&bare, (2, 2)), &[ColorBy::Auto, ColorBy::Rgb]),
        ("a.ply", ply(&points), &[ColorBy::Auto]),
        ("floats.ply", float_ply(&points), &[ColorBy::Auto]),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        for (&color_by, (scale, up, min_points)) in colors.iter().zip(
            [(Scale::Resolution(300), None, 1), (Scale::VoxelSize(0.75), Some(voxtrace::mesh::UpAxis::MinusY), 2)]
                .into_iter()
                .cycle(),
        ) {
            let import_options = ImportOptions { up, ..ImportOptions::default() };
            let plain = options(scale, PointOptions { color_by, min_points });
            let (expected, out) = (folder.path().join("expected.vxt"), folder.path().join("out.vxt"));
            let Geometry::Points(cloud) = import::read_geometry(&path, &import_options).unwrap() else { panic!() };
            let notes = cloud.notes.clone();
            let whole =
                voxelize_points_to_file(cloud, &plain, &Limits::default(), &expected, &VoxelizeProgress::default());
            for memory_budget in [Some(1), Some(1 << 20), None] {
                let plain = VoxelizeOptions { memory_budget, ..plain };
                let mut large = import::open_large(&path, &import_options, 1).unwrap().unwrap();
                let progress = VoxelizeProgress::default();
                let written = large.voxelize_to_file(&plain, &Limits::default(), &out, &progress);
                match (&whole, written) {
                    (Ok(whole), Ok(written)) => {
                        assert_eq!(*whole, written);
                        assert!(std::fs::read(&out).unwrap() == std::fs::read(&expected).unwrap(), "{name} {plain:?}");
                        assert_eq!((progress.done(), progress.total()), (160_000, 160_000));
                        assert_eq!(large.notes(), notes);
                        let estimate = large.estimate(&plain).unwrap();
                        let ratio = estimate.voxels as f64 / written.voxels as f64;
                        assert!(estimate.is_bound && ratio >= 0.95 || (0.9..1.1).contains(&ratio), "{name} {ratio}");
                    }
                    (Err(VoxelizeError::Missing(a)), Err(VoxelizeError::Missing(b))) => assert_eq!(*a, b),
                    (a, b) => panic!("{name}: {a:?}, but from the file {b:?}"),
                }
            }
        }
    }
}

#[test]
fn a_cloud_in_its_file_is_on_the_same_grid_as_in_memory_whatever_bounds_the_file_announces() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(5);
    let points: Vec<Point> =
        (0..30_000).map(|_| ([random.below(4000) as i32, random.below(2000) as i32, 7], [9, 9, 9], 1, 1)).collect();
    let (low, high) = points.iter().fold(([i32::MAX; 3], [i32::MIN; 3]), |(low, high), (at, ..)| {
        (std::array::from_fn(|axis| low[axis].min(at[axis])), std::array::from_fn(|axis| high[axis].max(at[axis])))
    });
    let bounded = |stretch: f64| {
        let mut bytes = las(&points, (2, 2));
        for axis in 0..3 {
            let [low, high] = [low, high].map(|end| f64::from(end[axis]) * 0.25 * stretch + FAR[axis]);
            bytes[179 + 16 * axis..][..16].copy_from_slice([high, low].map(f64::to_le_bytes).as_flattened());
        }
        bytes
    };
    let files = [
        ("true.las", bounded(1.0)),
        ("larger.las", bounded(3.0)),
        ("smaller.las", bounded(0.1)),
        ("a.ply", ply(&points)),
    ];
    for (name, bytes) in files {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        for up in [None, Some(voxtrace::mesh::UpAxis::MinusY)] {
            let import_options = ImportOptions { up, ..ImportOptions::default() };
            let plain = options(Scale::Automatic, PointOptions::default());
            let Geometry::Points(cloud) = import::read_geometry(&path, &import_options).unwrap() else { panic!() };
            let suited = cloud.suited_resolution() as i32;
            assert!((50..200).contains(&suited), "{suited}");
            let mut large = import::open_large(&path, &import_options, 1).unwrap().unwrap();
            assert_eq!(large.estimate(&plain).unwrap().placement.size.max_element(), suited, "{name} {up:?}");
            let (expected, out) = (folder.path().join("expected.vxt"), folder.path().join("out.vxt"));
            let (limits, progress) = (Limits::default(), VoxelizeProgress::default());
            voxelize_points_to_file(cloud, &plain, &limits, &expected, &progress).unwrap();
            large.voxelize_to_file(&plain, &limits, &out, &progress).unwrap();
            assert!(std::fs::read(&out).unwrap() == std::fs::read(&expected).unwrap(), "{name} {up:?}");
        }
    }
}
