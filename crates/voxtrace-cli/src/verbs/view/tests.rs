//! Tests of what the window is given: options, scenes, values.

use super::*;
use voxtrace::Ray;
use voxtrace::glam::{Vec2, Vec3};
use voxtrace_viewer::inspector::Values;

#[test]
fn the_options_that_read_a_scene_are_kept_word_for_word() {
    let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
    let kept = |text: &str, scene| reading_options(&words(text), scene).join(" ");
    assert_eq!(kept("a.ply --resolution 700 --device 1 -q", Some("a.ply")), "--resolution 700");
    assert_eq!(kept("--voxels=5k --threads 2 church", Some("church")), "");
    let cut = "a.nii --slice z=4 --clip-plane 0,0,1,4 --clip-box=0,0,0,9,9,9 --clip-shadows";
    assert_eq!(kept(cut, Some("a.nii")), "", "the window has settings of its own for them");
    assert_eq!(kept("a.laz --voxel-size 1m b.laz", Some("a.laz")), "--voxel-size 1m b.laz", "one scene");
    assert_eq!(kept("--resolution=9 a.stl --up-axis y", Some("a.stl")), "--resolution=9 --up-axis y");
}

#[cfg(unix)]
#[test]
fn a_word_that_is_no_text_is_refused_with_a_line() {
    use std::os::unix::ffi::OsStringExt;
    let words = |last: &[u8]| {
        let all = [&b"voxtrace"[..], b"-q", b"view", b"a.nii", b"--labels", last];
        words_of_view(all.into_iter().map(|word| OsString::from_vec(word.to_vec())))
    };
    assert_eq!(words(b"b.nii").ok(), Some(["a.nii", "--labels", "b.nii"].map(str::to_owned).to_vec()));
    assert!(words(b"b\xff.nii").unwrap_err().line().contains("is no UTF-8"));
}

#[derive(clap::Parser)]
struct Words {
    #[command(flatten)]
    view: ViewerArgs,
}

#[test]
fn several_tiles_are_the_scene_of_the_first_and_what_is_dropped_is_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let paths = [("west.las", [100, 50]), ("east.las", [108, 50])].map(|(name, place)| {
        std::fs::write(folder.path().join(name), voxtrace_test_support::las_tile(place)).unwrap();
        folder.path().join(name).to_string_lossy().into_owned()
    });
    let words = ["view", &paths[0], &paths[1], "--voxel-size", "1m"];
    let loader = <Words as clap::Parser>::parse_from(words).view.into_loader();
    let voxels = |path: &str| {
        let scene = loader.load(path, &Reading::default(), Box::new(|_| {}), &Wanted::default());
        scene.unwrap().statistics().voxels
    };
    assert_eq!(paths.each_ref().map(|path| voxels(path)), [128, 64]);
}

#[test]
fn a_scene_of_the_window_is_written_as_convert_writes_it() {
    let view = <Words as clap::Parser>::parse_from(["view", "--voxels", "2000"]).view;
    let loader = view.into_loader();
    let scene = loader.load("city", &Reading::default(), Box::new(|_| {}), &Wanted::default()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    assert_eq!(loader.save(&scene, &at("a.vxt")), Ok(Vec::new()));
    scene.save(&at("b.vxt")).unwrap();
    let bytes = |name: &str| std::fs::read(at(name)).unwrap();
    assert!(bytes("a.vxt") == bytes("b.vxt"));
    loader.save(&scene, &at("a.vox")).unwrap();
    voxtrace::export::vox::write(&at("b.vox"), &scene.to_scene()).unwrap();
    assert!(bytes("a.vox") == bytes("b.vox"));
    assert_ne!(bytes("a.vox"), bytes("a.vxt"));
    let lost = loader.save(&scene, &at("a.ply")).unwrap();
    assert!(lost.iter().any(|line| line.contains("cameras")), "{lost:?}");
    let writer = voxtrace::export::writer_of(&at("b.ply")).unwrap();
    writer.write(&at("b.ply"), &scene.to_scene()).unwrap();
    assert!(bytes("a.ply") == bytes("b.ply"));
    assert!(loader.save(&scene, &at("a.stl")).unwrap_err().contains("unknown kind"));
    assert!(loader.save(&scene, &at("none/a.vxt")).is_err());
    // What was read is never written over.
    voxtrace::import::opened::record();
    let read = loader
        .load(&at("a.vox").display().to_string(), &Reading::default(), Box::new(|_| {}), &Wanted::default())
        .unwrap();
    let before = bytes("a.vox");
    assert!(loader.save(&read, &at("a.vox")).is_err());
    assert!(bytes("a.vox") == before);
}

#[test]
fn the_value_of_a_voxel_is_that_of_its_sample_in_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("scan.nrrd");
    let value = |[x, y, z]: [usize; 3]| 1000.0 + (x + 10 * y + 100 * z) as f32;
    let head = "NRRD0004\ntype: float\ndimension: 3\nsizes: 4 5 6\nspace: left-posterior-superior\n\
                space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (10,20,-30)\nendian: little\nencoding: raw\n\n";
    let samples = (0..120).flat_map(|i| value([i % 4, i / 4 % 5, i / 20]).to_le_bytes());
    std::fs::write(&path, [head.as_bytes(), &samples.collect::<Vec<_>>()].concat()).unwrap();
    let source = path.to_string_lossy().into_owned();
    let words = ["view", &source, "--threshold", "1"];
    let loader = <Words as clap::Parser>::parse_from(words).view.into_loader();
    let scene = loader.load(&source, &Reading::default(), Box::new(|_| {}), &Wanted::default()).unwrap();
    let volume = loader.volume(&source, &Wanted::default()).unwrap().expect("it is a volume");
    let world = scene.georeference.as_ref().unwrap().coordinates_from_world;
    let values = Values::new(volume, world);
    let (min, max) = scene.bounds().unwrap();
    assert_eq!((max - min).to_array(), [4.0, 5.0, 6.0]);
    for number in 0..20 {
        let place = min.truncate() + Vec2::new((number % 4) as f32, (number / 4) as f32) + 0.5;
        let ray = Ray::new(place.extend(max.z + 9.0), Vec3::NEG_Z);
        let hit = scene.cast(&ray).expect("every column has voxels");
        let middle = scene.instance(&hit).world_from_grid.point(hit.voxel.as_vec3() + 0.5);
        let sample = values.at(middle.as_dvec3()).unwrap();
        let index = [number % 4, number / 4, 5];
        assert_eq!((sample.index, sample.value), (index, value(index)));
        assert_ne!(sample.value, value([number % 4, number / 4, 4]), "the comparison sees a sample");
    }
    assert!(loader.volume("city", &Wanted::default()).unwrap().is_none());
    std::fs::write(&path, "NRRD0004\ntype: float\n").unwrap();
    let error = loader.volume(&source, &Wanted::default()).unwrap_err();
    assert!(!error.contains('\n') && !error.is_empty(), "{error}");
}
