//! Clouds of points from every format, and their voxels: places, colours, thresholds, and damage of every kind. Also
//! replays the corpus of the fuzz target.

#[path = "../../../fuzz/check/points.rs"]
mod check;
mod compressed_points;
mod corpus;
mod meshes;

use compressed_points::compressed;
use meshes::Random;
use std::io::Cursor;
use std::path::Path;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::import::{self, Geometry, ImportError, ImportErrorKind, ImportOptions, Limits};
use voxtrace::material::{linear_color, srgb_from_linear};
use voxtrace::points::{ColorBy, PointCloud};
use voxtrace::voxelize::{
    PointOptions, Scale, VoxelizeError, VoxelizeOptions, VoxelizeProgress, voxelize_points, voxelize_points_to_file,
};
use voxtrace::{PackedScene, Scene};
use voxtrace_test_support::{data, files_below};

/// Points on quarters of a metre, far from the origin: position, colour, intensity, class.
type Point = ([i32; 3], [u8; 3], u16, u8);
const FAR: [f64; 3] = [691_000.0, 5_335_000.0, 500.0];

fn sample() -> Vec<Point> {
    let mut random = Random(7);
    let mut byte = move |end: usize| random.below(end);
    (0..300)
        .map(|_| {
            let place = [byte(64) as i32, byte(48) as i32, byte(20) as i32];
            (place, [byte(256) as u8, byte(256) as u8, 1 + byte(255) as u8], byte(4000) as u16, 1 + byte(9) as u8)
        })
        .collect()
}

/// A LAS file; `kind` is the version's minor number and the format of its points.
fn las(points: &[Point], (minor, format): (u8, u8)) -> Vec<u8> {
    let size: u16 = if minor >= 4 { 375 } else { 227 };
    let record: u16 = [20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67][usize::from(format)];
    let mut bytes = vec![0; usize::from(size)];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, b"LASF");
    put(24, &[1, minor]);
    put(94, &size.to_le_bytes());
    put(96, &u32::from(size).to_le_bytes());
    put(104, &[format]);
    put(105, &record.to_le_bytes());
    put(if minor >= 4 { 247 } else { 107 }, &(points.len() as u32).to_le_bytes());
    for (axis, far) in FAR.iter().enumerate() {
        put(131 + 8 * axis, &0.25f64.to_le_bytes());
        put(155 + 8 * axis, &far.to_le_bytes());
    }
    for (place, color, intensity, class) in points {
        let start = bytes.len();
        bytes.resize(start + usize::from(record), 0);
        let mut put = |at: usize, value: &[u8]| bytes[start + at..][..value.len()].copy_from_slice(value);
        put(0, place.map(i32::to_le_bytes).as_flattened());
        put(12, &intensity.to_le_bytes());
        put(if format >= 6 { 16 } else { 15 }, &[*class]);
        let color_at = match format {
            2 => 20,
            3 | 5 => 28,
            _ => 30,
        };
        put(color_at, color.map(|byte| (u16::from(byte) * 257).to_le_bytes()).as_flattened());
    }
    bytes
}

/// The same points compressed, by the crate that others write LAZ with.
fn laz(points: &[Point], (minor, format): (u8, u8)) -> Vec<u8> {
    compressed(&las(points, (minor, format)), format, 100)
}

fn text(points: &[Point]) -> Vec<u8> {
    let mut text = String::from("x,y,z,red,green,blue,intensity,class\n");
    for (place, [r, g, b], intensity, class) in points {
        let [x, y, z] = [0, 1, 2].map(|axis| FAR[axis] + f64::from(place[axis]) * 0.25);
        text += &format!("{x},{y},{z},{r},{g},{b},{intensity},{class}\n");
    }
    text.into_bytes()
}

fn ply(points: &[Point]) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
        property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
        points.len()
    )
    .into_bytes();
    for (place, color, ..) in points {
        for (far, steps) in FAR.iter().zip(place) {
            bytes.extend((far + f64::from(*steps) * 0.25).to_le_bytes());
        }
        bytes.extend(color);
    }
    bytes
}

/// Vertices with colours, and no faces; y is up.
fn obj(points: &[Point]) -> Vec<u8> {
    let mut text = String::from("# a scan\nvn 0 0 1\n");
    for (place, color, ..) in points {
        let [x, y, z] = [0, 1, 2].map(|axis| FAR[axis] + f64::from(place[axis]) * 0.25);
        let [r, g, b] = color.map(|byte| f64::from(byte) / 255.0);
        text += &format!("v {x} {z} {} {r:.4} {g:.4} {b:.4}\n", -y);
    }
    text.into_bytes()
}

fn pcd(points: &[Point], data: &str) -> Vec<u8> {
    let count = points.len();
    let mut bytes = format!(
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z _ rgb intensity label\nSIZE 8 8 8 1 4 2 1\n\
        TYPE F F F U U U U\nCOUNT 1 1 1 3 1 1 1\nWIDTH {count}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {count}\n\
        DATA {data}\n"
    )
    .into_bytes();
    // Bytes of each field; compressed files keep each field together.
    let mut fields: [Vec<Vec<u8>>; 7] = Default::default();
    for (place, [r, g, b], intensity, class) in points {
        let position = [0, 1, 2].map(|axis| FAR[axis] + f64::from(place[axis]) * 0.25);
        let color = u32::from_be_bytes([0, *r, *g, *b]);
        if data == "ascii" {
            let [x, y, z] = position;
            bytes.extend(format!("{x} {y} {z} 0 0 0 {color} {intensity} {class}\n").into_bytes());
        }
        (0..3).for_each(|axis| fields[axis].push(position[axis].to_le_bytes().into()));
        fields[3].push(vec![7; 3]);
        fields[4].push(color.to_le_bytes().into());
        fields[5].push(intensity.to_le_bytes().into());
        fields[6].push(vec![*class]);
    }
    match data {
        "binary" => (0..count).for_each(|n| fields.iter().for_each(|field| bytes.extend(&field[n]))),
        "binary_compressed" => {
            let plain: Vec<u8> = fields.iter().flatten().flatten().copied().collect();
            let packed: Vec<u8> = plain.chunks(32).flat_map(|run| [&[run.len() as u8 - 1], run].concat()).collect();
            bytes.extend((packed.len() as u32).to_le_bytes());
            bytes.extend((plain.len() as u32).to_le_bytes());
            bytes.extend(packed);
        }
        _ => {}
    }
    bytes
}

/// Written by the crate, at a pose that adds [`FAR`].
fn e57(points: &[Point]) -> Vec<u8> {
    use e57::{E57Writer, Record, RecordDataType, RecordName, RecordValue, Transform};
    let mut out = Cursor::new(Vec::new());
    let mut writer = E57Writer::new(&mut out, "file").unwrap();
    let steps = RecordDataType::ScaledInteger { min: 0, max: 63, scale: 0.25, offset: 0.0 };
    let place = [RecordName::CartesianX, RecordName::CartesianY, RecordName::CartesianZ];
    let mut prototype: Vec<Record> = place.into_iter().map(|name| Record { name, data_type: steps.clone() }).collect();
    prototype.extend([Record::COLOR_RED_U8, Record::COLOR_GREEN_U8, Record::COLOR_BLUE_U8, Record::INTENSITY_U16]);
    let mut scan = writer.add_pointcloud("scan", prototype).unwrap();
    let mut pose = Transform::default();
    (pose.translation.x, pose.translation.y, pose.translation.z) = (FAR[0], FAR[1], FAR[2]);
    scan.set_transform(Some(pose));
    for (place, color, intensity, _) in points {
        let mut values: Vec<RecordValue> =
            place.iter().map(|&steps| RecordValue::ScaledInteger(steps.into())).collect();
        values.extend(color.iter().map(|&byte| RecordValue::Integer(byte.into())));
        values.push(RecordValue::Integer((*intensity).into()));
        scan.add_point(values).unwrap();
    }
    scan.finalize().unwrap();
    writer.finalize().unwrap();
    drop(writer);
    out.into_inner()
}

fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let points = sample();
    vec![
        ("a.las", las(&points, (2, 2))),
        ("b.las", las(&points, (2, 3))),
        ("c.las", las(&points, (4, 7))),
        ("a.laz", laz(&points, (2, 2))),
        ("b.laz", laz(&points, (2, 3))),
        ("c.laz", laz(&points, (4, 7))),
        ("a.csv", text(&points)),
        ("a.ply", ply(&points)),
        ("a.obj", obj(&points)),
        ("text.pcd", pcd(&points, "ascii")),
        ("plain.pcd", pcd(&points, "binary")),
        ("packed.pcd", pcd(&points, "binary_compressed")),
        ("a.e57", e57(&points)),
    ]
}

fn read(name: &str, bytes: &[u8], limits: Limits) -> Result<PointCloud, ImportError> {
    let options = ImportOptions { limits, ..ImportOptions::default() };
    match import::geometry_from_bytes(bytes, Path::new(name), &options)? {
        Geometry::Points(cloud) => Ok(cloud),
        Geometry::Mesh(_) => panic!("{name} is a cloud of points"),
    }
}

fn options(scale: Scale, points: PointOptions) -> VoxelizeOptions {
    VoxelizeOptions { scale, points, ..VoxelizeOptions::default() }
}

fn scene_of(cloud: &PointCloud, options: &VoxelizeOptions) -> Result<Scene, VoxelizeError> {
    voxelize_points(cloud, options, &Limits::default(), &VoxelizeProgress::default())
}

fn voxels(scene: &Scene) -> Vec<(IVec3, [u8; 3])> {
    let color = |material: u16| scene.materials[usize::from(material)].base_color.to_array().map(srgb_from_linear);
    scene.grids[0].voxels().map(|(voxel, material)| (voxel, color(material))).collect()
}

#[test]
fn the_viewpoint_of_a_pcd_file_moves_no_point_and_is_told() {
    let cloud = |viewpoint: &str| {
        let text = String::from_utf8(pcd(&sample(), "ascii")).unwrap();
        let text = text.replace("VIEWPOINT 0 0 0 1 0 0 0", viewpoint);
        let read = import::geometry_from_bytes(text.as_bytes(), Path::new("a.pcd"), &ImportOptions::default());
        let Geometry::Points(cloud) = read.unwrap() else { panic!("points") };
        cloud
    };
    let usual = cloud("VIEWPOINT 0.0 0 0 1 0 0 0");
    let moved = cloud("VIEWPOINT 1 2 3 0.5 0.5 0.5 0.5");
    assert!(usual.notes.is_empty() && usual == cloud("VERSION 0.7"));
    assert_eq!(moved.positions, usual.positions);
    assert!(moved.notes.len() == 1 && moved.notes[0].contains("1 2 3 0.5"), "{:?}", moved.notes);
    // What is not a viewpoint harms nobody.
    assert_eq!(cloud("VIEWPOINT nowhere").positions, usual.positions);
}

#[test]
fn every_format_gives_the_points_their_places_colours_and_classes() {
    let points = sample();
    for (name, bytes) in samples() {
        let cloud = read(name, &bytes, Limits::default()).unwrap();
        assert_eq!(cloud.positions.len(), points.len(), "{name}");
        for (at, (place, color, intensity, class)) in points.iter().enumerate() {
            let truth = DVec3::from_array(FAR) + IVec3::from_array(*place).as_dvec3() * 0.25;
            assert_eq!(cloud.positions[at].as_dvec3() + cloud.offset, truth, "{name} {at}");
            assert_eq!(cloud.colors[at], *color, "{name} {at}");
            let has_color_alone = name == "a.ply" || name == "a.obj";
            if !has_color_alone {
                assert_eq!(cloud.intensities[at], *intensity, "{name} {at}");
            }
            if !has_color_alone && name != "a.e57" {
                assert_eq!(cloud.classes[at], *class, "{name} {at}");
            }
        }
    }
}

#[test]
fn chunks_that_are_withheld_or_dark_come_from_laz_as_from_las() {
    let mut points: Vec<Point> = sample().into_iter().cycle().take(400).collect();
    points[..150].iter_mut().for_each(|point| point.3 |= 0x80);
    let mut plain = las(&points, (2, 2));
    // The colours of a whole chunk would be bytes, if there were no others.
    for record in plain[227..].chunks_exact_mut(26).skip(200).take(100) {
        record[20..].copy_from_slice([200u16, 3, 129].map(u16::to_le_bytes).as_flattened());
    }
    let cloud = |bytes: &[u8]| read("a.las", bytes, Limits::default()).unwrap();
    let (packed, plain) = (cloud(&compressed(&plain, 2, 100)), cloud(&plain));
    assert_eq!((plain.positions.len(), &plain.colors[50..150]), (250, &[[1, 0, 1]; 100][..]));
    assert!(plain.colors[150..].iter().flatten().any(|&value| value > 1));
    assert!(plain.offset.x != 0.0 && packed == plain);
}

#[test]
fn the_same_points_from_every_format_have_the_same_voxels() {
    for scale in [Scale::Resolution(40), Scale::VoxelSize(0.75)] {
        let mut first = None;
        for (name, bytes) in samples() {
            let cloud = read(name, &bytes, Limits::default()).unwrap();
            let found = voxels(&scene_of(&cloud, &options(scale, PointOptions::default())).unwrap());
            assert!(*first.get_or_insert_with(|| found.clone()) == found, "{name}");
        }
    }
}

#[test]
fn a_voxel_has_the_mean_of_its_points_in_linear_light() {
    let cloud = PointCloud {
        positions: vec![Vec3::splat(0.5), Vec3::splat(0.75), Vec3::new(9.5, 0.5, 0.5)],
        colors: vec![[0, 0, 0], [255, 255, 255], [10, 20, 30]],
        ..PointCloud::default()
    };
    let scale = Scale::VoxelSize(1.0);
    let found = voxels(&scene_of(&cloud, &options(scale, PointOptions::default())).unwrap());
    // Half the light is 188, where half the signal would be 128.
    let expected = [(IVec3::ZERO, [188; 3]), (IVec3::new(9, 0, 0), [10, 20, 30])];
    assert_eq!(srgb_from_linear(linear_color([255; 3]).x / 2.0), 188);
    assert_eq!(found, expected);
    let dense = |min_points| options(scale, PointOptions { min_points, ..PointOptions::default() });
    assert_eq!(voxels(&scene_of(&cloud, &dense(2)).unwrap()), expected[..1]);
    assert!(matches!(scene_of(&cloud, &dense(3)), Err(VoxelizeError::TooThin(3))));
}

#[test]
fn the_highest_points_are_inside_a_resolution_and_on_the_next_voxel_of_a_size() {
    let positions = vec![Vec3::ZERO, Vec3::new(4.0, 2.0, 1.0)];
    let cloud = PointCloud { positions, ..PointCloud::default() };
    let last = |scale| voxels(&scene_of(&cloud, &options(scale, PointOptions::default())).unwrap())[1].0;
    assert_eq!(last(Scale::Resolution(4)), IVec3::new(3, 1, 0));
    assert_eq!(last(Scale::VoxelSize(1.0)), IVec3::new(4, 2, 1));
}

#[test]
fn classes_and_heights_and_intensities_give_colours() {
    let cloud = read("a.las", &las(&sample(), (2, 2)), Limits::default()).unwrap();
    let by = |color_by| {
        let points = PointOptions { color_by, min_points: 1 };
        voxels(&scene_of(&cloud, &options(Scale::VoxelSize(0.25), points)).unwrap())
    };
    let [rgb, class, height, intensity] =
        [ColorBy::Rgb, ColorBy::Classification, ColorBy::Height, ColorBy::Intensity].map(by);
    assert_eq!(by(ColorBy::Auto), rgb);
    assert!(class != rgb && height != class && intensity != height);
    let places = |voxels: &[(IVec3, [u8; 3])]| voxels.iter().map(|voxel| voxel.0).collect::<Vec<_>>();
    assert_eq!(places(&rgb), places(&class));
    for (a, color) in &height {
        assert!(height.iter().all(|(b, other)| a.z != b.z || color == other), "one height has one colour");
    }
    let bare = PointCloud { colors: Vec::new(), ..cloud.clone() };
    let points = PointOptions { color_by: ColorBy::Rgb, min_points: 1 };
    let error = scene_of(&bare, &options(Scale::Resolution(9), points)).unwrap_err();
    assert!(matches!(error, VoxelizeError::Missing("colours")), "{error}");
}

#[test]
fn a_scene_of_points_knows_where_they_were_and_a_file_keeps_it() {
    let points = sample();
    let scale = Scale::VoxelSize(0.75);
    let cloud =
        PointCloud { crs: "EPSG:25832".into(), ..read("a.las", &las(&points, (2, 2)), Limits::default()).unwrap() };
    let scene = scene_of(&cloud, &options(scale, PointOptions::default())).unwrap();
    let place = scene.georeference.clone().unwrap();
    let voxels = voxels(&scene);
    for (steps, ..) in &points {
        let truth = DVec3::from_array(FAR) + IVec3::from_array(*steps).as_dvec3() * 0.25;
        let voxel = place.coordinates_from_world.inverse().transform_point3(truth + 1e-6).floor().as_ivec3();
        assert!(voxels.iter().any(|other| other.0 == voxel), "{voxel}");
    }
    let folder = tempfile::tempdir().unwrap();
    let (path, streamed) = (folder.path().join("a.vxt"), folder.path().join("b.vxt"));
    let packed = PackedScene::pack(&scene).unwrap();
    packed.save(&path).unwrap();
    let (limits, progress) = (Limits::default(), VoxelizeProgress::default());
    voxelize_points_to_file(cloud, &options(scale, PointOptions::default()), &limits, &streamed, &progress).unwrap();
    for path in [&path, &streamed] {
        let opened = PackedScene::open(path).unwrap();
        assert_eq!(opened.georeference, Some(place.clone()));
        assert_eq!(
            (opened.to_scene().georeference, opened.content_hash()),
            (Some(place.clone()), packed.content_hash())
        );
    }
    // A file without the sections is one without a place.
    let mut bare = scene;
    bare.georeference = None;
    PackedScene::pack(&bare).unwrap().save(&path).unwrap();
    assert_eq!(PackedScene::open(&path).unwrap().georeference, None);
}

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

#[test]
fn a_file_cut_at_any_byte_is_read_or_gives_an_error_that_says_where() {
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            match read(name, &bytes[..length], Limits::default()) {
                Ok(_) => assert!(["a.csv", "a.obj", "text.pcd"].contains(&name), "{name} {length}"),
                Err(error) => assert!(error.offset.is_some_and(|at| at <= length as u64), "{name} {length}: {error}"),
            }
        }
    }
}

#[test]
fn a_file_with_changed_bytes_is_read_or_gives_an_error() {
    let mut random = Random(9);
    for (name, bytes) in samples() {
        for round in 0..500 {
            let mut damaged = bytes.clone();
            for _ in 0..=random.below(3) {
                // Half of it hits the header.
                let end = if round % 2 == 0 { 500 } else { damaged.len() - 4 };
                let at = random.below(end);
                match random.below(3) {
                    0 => damaged[at] ^= 1 << random.below(8),
                    1 => damaged[at] = random.below(256) as u8,
                    _ => damaged[at..at + 4].copy_from_slice(&[255; 4]),
                }
            }
            check::check(name, &damaged);
        }
    }
}

#[test]
fn counts_that_the_file_cannot_hold_are_refused_before_any_memory_is_taken() {
    for (name, mut bytes) in samples().into_iter().filter(|sample| sample.0.contains(".la")) {
        let at = if name.starts_with('c') { 247 } else { 107 };
        bytes[at..at + 4].copy_from_slice(&200_000_000u32.to_le_bytes());
        let error = read(name, &bytes, Limits::default()).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::Truncated(_) | ImportErrorKind::Limit { .. }), "{name}: {error}");
        let few = Limits { points: 299, ..Limits::default() };
        let (_, whole) = samples().into_iter().find(|sample| sample.0 == name).unwrap();
        assert!(matches!(read(name, &whole, few).unwrap_err().kind, ImportErrorKind::Limit { .. }), "{name}");
    }
}

#[test]
fn sixteen_megabytes_of_noise_are_refused() {
    let mut random = Random(4);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for name in ["a.las", "a.xyz"] {
        assert!(read(name, &noise, Limits::default()).is_err(), "{name}");
    }
    let head = laz(&sample(), (4, 7));
    noise[..600].copy_from_slice(&head[..600]);
    assert!(read("a.laz", &noise, Limits::default()).is_err());
    for (name, bytes) in samples().into_iter().filter(|(name, _)| name.ends_with("pcd") || name.ends_with("e57")) {
        noise[..200].copy_from_slice(&bytes[..200]);
        assert!(read(name, &noise, Limits::default()).is_err(), "{name}");
    }
}

#[test]
fn a_scan_that_promises_more_points_than_there_are_bits_is_refused() {
    // The description stands in the file as text, and its page has a checksum: make both anew.
    let bytes = e57(&sample());
    let text = b"recordCount=\"300\"";
    let at = bytes.windows(text.len()).position(|window| window == text).unwrap();
    let mut damaged = bytes.clone();
    damaged[at + 13..at + 16].copy_from_slice(b"999");
    let page = at / 1024 * 1024;
    let sum = crc32c(&damaged[page..page + 1020]).to_be_bytes();
    damaged[page + 1020..page + 1024].copy_from_slice(&sum);
    assert_eq!(crc32c(&bytes[..1020]).to_be_bytes(), bytes[1020..1024]);
    let error = read("a.e57", &damaged, Limits::default()).unwrap_err().to_string();
    assert!(error.contains("999") || error.contains("point"), "{error}");
    let few = Limits { points: 299, ..Limits::default() };
    assert!(matches!(read("a.e57", &bytes, few).unwrap_err().kind, ImportErrorKind::Limit { .. }));
}

/// The checksum of E57's pages (Castagnoli).
fn crc32c(bytes: &[u8]) -> u32 {
    let step = |sum: u32, _| if sum & 1 == 1 { sum >> 1 ^ 0x82f6_3b78 } else { sum >> 1 };
    !bytes.iter().fold(u32::MAX, |sum, byte| (0..8).fold(sum ^ u32::from(*byte), step))
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_and_is_clean() {
    // What the encoder of E57 writes has the time in it.
    let samples = samples();
    let own = samples.iter().filter(|(name, _)| !name.ends_with("ply") && !name.ends_with("e57"));
    corpus::replay("points", own, check::check_all);
}

const EXTENSIONS: [&str; 6] = ["las", "laz", "xyz", "pts", "pcd", "e57"];

#[test]
fn scans_of_the_shared_data_have_the_points_that_their_manifest_says() {
    let Some(data) = data() else { return };
    let counts = [
        ("laspy_autzen_trim.laz", 110_000),
        ("laspy_simple.copc.laz", 1_065),
        ("laspy_simple1_1.las", 1_065),
        ("laspy_simple1_3.las", 999),
        ("laspy_simple1_4.las", 22_600),
        ("lidR_Topography.laz", 73_403),
        // 483 of its 1,024 points are withheld.
        ("loadersgl_pdrf10-1.5.las", 541),
        ("loadersgl_Zaghetto.pcd", 59_750),
        ("e57_bunnyDouble.e57", 30_571),
        ("e57_bunnyInt19.e57", 30_571),
        ("e57_bunnyInt32.e57", 30_571),
        ("e57_ColouredCubeFloat.e57", 7_680),
        ("e57_las2e57_no_images_tag.e57", 153),
        ("e57_tinyCartesianFloatRgb.e57", 2_090),
        ("e57_tiny_pc_and_images.e57", 2),
        // Of half of its points it knows the direction alone.
        ("e57_tiny_spherical.e57", 180),
    ];
    for path in files_below(&data.join("pointcloud"), &EXTENSIONS) {
        let geometry = import::read_geometry(&path, &ImportOptions::default());
        let name = path.file_name().unwrap().to_str().unwrap();
        if let Some((_, count)) = counts.iter().find(|known| known.0 == name) {
            let Geometry::Points(cloud) = geometry.unwrap() else { panic!("{name}") };
            assert_eq!(cloud.positions.len(), *count, "{name}");
        }
    }
}

#[test]
fn malformed_scans_of_the_shared_data_are_decided_one_by_one() {
    /// What is cut off, contradicts itself or asks for too much; everything else can in truth be read.
    const REFUSED: [&str; 7] = [
        "las_count_4g.las",
        "las_nan_scale.las",
        "las_offset_outside.las",
        "las_truncated.las",
        "laz_bitflips.laz",
        "laz_truncated.laz",
        "pdal_garbage_nVariableLength.las",
    ];
    let Some(data) = data() else { return };
    let mut refused = Vec::new();
    for path in files_below(&data.join("malformed"), &EXTENSIONS) {
        if let Err(error) = import::read_geometry(&path, &ImportOptions::default()) {
            println!("{error}");
            refused.push(path.file_name().unwrap().to_string_lossy().into_owned());
        }
    }
    assert_eq!(refused, REFUSED);
}
