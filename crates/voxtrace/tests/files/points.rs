//! Clouds of points from every format, and their voxels: places, colours, thresholds.

use crate::compressed_points::compressed;
use crate::point_samples::{FAR, Point, gltf, las, options, pcd, read, sample, samples, scene_of, splats, voxels};
use std::path::Path;
use voxtrace::PackedScene;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::import::{self, Geometry, ImportOptions, Limits};
use voxtrace::material::{linear_color, srgb_from_linear};
use voxtrace::points::{ColorBy, PointCloud};
use voxtrace::voxelize::{PointOptions, Scale, VoxelizeError, VoxelizeProgress, voxelize_points_to_file};

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
            let has_color_alone = ["a.ply", "a.obj", "a.glb"].contains(&name);
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
fn splats_are_points_on_their_discs_in_the_colours_that_they_have_from_everywhere() {
    let points = sample();
    let cloud = read("splats.ply", &splats(&points), Limits::default()).unwrap();
    assert_eq!(cloud.notes, ["1 of 301 splats that are less than 0.2 opaque are left out"]);
    assert_eq!(cloud.positions.len(), 5 * points.len());
    let radius = (-5.0f32).exp();
    for (at, (place, color, ..)) in points.iter().enumerate() {
        let centre = IVec3::from_array(*place).as_vec3() * 0.25;
        let disc = &cloud.positions[5 * at..5 * at + 5];
        let mut distances: Vec<f32> = disc.iter().map(|point| (*point - centre).length() / radius).collect();
        distances.sort_by(f32::total_cmp);
        // The centre, and one point at each end of both longer axes, which are x and y.
        assert!(distances[0] < 1e-3 && distances[1..].iter().all(|distance| (distance - 1.0).abs() < 1e-2), "{at}");
        assert!(disc.iter().all(|point| (point.z - centre.z).abs() < 1e-4), "{at}");
        let differs = |found: &[u8; 3]| found.iter().zip(color).any(|(a, b)| a.abs_diff(*b) > 1);
        assert!(!cloud.colors[5 * at..5 * at + 5].iter().any(differs), "{at}");
    }
    // They are measured by all of them, so they do not stay in their file.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("splats.ply");
    std::fs::write(&path, splats(&points)).unwrap();
    assert!(import::open_large(&path, &ImportOptions::default(), 1).unwrap().is_none());
    let packed = b"ply\nformat ascii 1.0\nelement vertex 1\nproperty uint packed_position\nend_header\n1\n";
    assert!(read("packed.ply", packed, Limits::default()).unwrap_err().to_string().contains("SuperSplat"));
}

#[test]
fn lines_of_gltf_without_triangles_are_points_along_them_in_the_colour_of_their_material() {
    let corners = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    let binary: Vec<u8> =
        corners.iter().flat_map(|place| [*place, [1.0; 3]].concat()).flat_map(f32::to_le_bytes).collect();
    // Segments, a closed loop, a strip.
    for (mode, length) in [(1, 1.0), (2, 2.0 + 2f32.sqrt()), (3, 2.0)] {
        let primitive = serde_json::json!({ "mode": mode, "material": 0, "attributes": { "POSITION": 0 } });
        let cloud = read("a.glb", &gltf(&binary, 3, primitive, [0.0; 3]), Limits::default()).unwrap();
        let found = cloud.positions.len() as f32;
        assert!((found / 1024.0 - length).abs() < 0.01, "{mode}: {found}");
        // Up is z, and half of linear red.
        assert!(
            cloud.positions.iter().all(|point| point.y == 0.0) && cloud.colors.iter().all(|c| *c == [188, 255, 255])
        );
    }
    let wrong = serde_json::json!({ "mode": 0, "attributes": {} });
    let error = read("a.glb", &gltf(&binary, 3, wrong, [0.0; 3]), Limits::default()).unwrap_err();
    assert!(error.to_string().contains("without a triangle, a line or a point"), "{error}");
}

#[test]
fn the_first_version_of_gltf_is_named_as_such() {
    let text = |text: &str| import::read_bytes(text.as_bytes(), Path::new("a.gltf"), &ImportOptions::default());
    let lists = r#""meshes": { "m": { "primitives": [] } }, "nodes": {} }"#;
    for head in [r#"{ "asset": { "version": "1.0" }, "#, r#"{ "asset": { "version": 1.1 }, "#, "{ "] {
        let error = text(&format!("{head}{lists}")).unwrap_err().to_string();
        assert!(error.contains("glTF of version 1.") && error.contains("convert it"), "{error}");
    }
    let binary = [&b"glTF"[..], &1u32.to_le_bytes(), &20u32.to_le_bytes(), &[0; 8]].concat();
    let error = import::read_bytes(&binary, Path::new("a.glb"), &ImportOptions::default()).unwrap_err().to_string();
    assert!(error.contains("glTF of version 1;"), "{error}");
    // What is broken and of version 2 is told as before.
    assert!(text(r#"{ "asset": { "version": "2.0" }, "meshes": {} }"#).unwrap_err().to_string().contains("JSON"));
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
