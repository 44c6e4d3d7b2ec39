//! The light of .vox files: which of their skies holds, pictures beside them, and what is said not to be shown.

use std::borrow::Cow;
use std::path::Path;
use voxtrace::glam::Vec3;
use voxtrace::import::vox::{self, Body, Chunk, Dict, VoxFile};
use voxtrace::import::{self, ImportOptions, Limits};
use voxtrace::lines::{GridLines, Line, Lines};
use voxtrace::material::linear_color;
use voxtrace::sky::Background;
use voxtrace::{Scene, Sky, export};

fn dict(kind: &'static str, pairs: &[(&'static str, &str)]) -> Body<'static> {
    let mut dict = Dict::default();
    dict.push("_type", kind);
    pairs.iter().for_each(|(key, value)| dict.push(key, value.to_string()));
    Body::RenderObject(dict)
}

/// A file of one voxel with a sky of each kind, the one of `mode` in use, and other settings.
fn file(mode: &str, more: Vec<Body<'static>>) -> Vec<u8> {
    let mut bodies = vec![Body::Size([1; 3]), Body::Voxels(Cow::Owned(vec![[0, 0, 0, 1]]))];
    bodies.push(dict("_env", &[("_mode", mode)]));
    bodies.push(dict(
        "_inf",
        &[("_i", "0.7"), ("_k", "255 255 255"), ("_angle", "30 50"), ("_area", "0.07"), ("_disk", "0")],
    ));
    bodies.push(dict("_uni", &[("_i", "0.5"), ("_k", "255 255 255")]));
    bodies.push(dict("_ibl", &[("_path", "sky.hdr"), ("_i", "0.5"), ("_rot", "90")]));
    bodies.push(dict("_atm", &[("_ray_d", "0.4"), ("_ray_k", "45 104 255"), ("_mie_d", "0.4")]));
    bodies.extend(more);
    let chunks = bodies.into_iter().map(Chunk::new).collect();
    VoxFile { version: 150, chunks, ..VoxFile::default() }.to_bytes().unwrap()
}

/// A panorama of 16 × 8 pixels, white in its right half.
fn picture() -> Vec<u8> {
    let mut bytes = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n".to_vec();
    for pixel in 0..16 * 8 {
        bytes.extend(if pixel % 16 < 8 { [0; 4] } else { [128, 128, 128, 129] });
    }
    bytes
}

fn load(folder: &Path, bytes: &[u8]) -> (Scene, Vec<String>) {
    let path = folder.join("a.vox");
    std::fs::write(&path, bytes).unwrap();
    let loaded = import::load(&path, &ImportOptions::default()).unwrap();
    (loaded.content.into_scene(), loaded.notes)
}

#[test]
fn the_mode_says_which_sky_there_is() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sky.hdr"), picture()).unwrap();
    let sky_of = |mode: &str| load(folder.path(), &file(mode, Vec::new())).0.sky;
    assert_eq!(sky_of("0").radiance(Vec3::X), Vec3::splat(0.5));
    assert!(["0", "1", "2"].iter().all(|mode| !sky_of(mode).is_sun_disc_visible()), "each says _disk 0");
    assert!(sky_of("0").sun().is_some() && sky_of("0").background().environment().is_none());
    // Half as bright, and turned: what was to the right is behind.
    let of_picture = sky_of("1");
    assert!(of_picture.radiance(Vec3::NEG_Y).abs_diff_eq(Vec3::splat(0.5), 1e-3));
    assert_eq!(of_picture.radiance(Vec3::Y), Vec3::ZERO);
    assert_eq!(of_picture.sun(), sky_of("0").sun());
    let of_air = sky_of("2");
    assert!(of_air.radiance(Vec3::Z).z > 1.5 * of_air.radiance(Vec3::Z).x, "blue: {}", of_air.radiance(Vec3::Z));
    assert!(of_air.sun().unwrap().irradiance.z < 0.9 * sky_of("0").sun().unwrap().irradiance.z, "the sun is dimmed");
}

#[test]
fn a_picture_that_is_not_there_is_told_and_the_colour_stands_in() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, notes) = load(folder.path(), &file("1", Vec::new()));
    assert_eq!(scene.sky.radiance(Vec3::X), Vec3::splat(0.5));
    assert!(notes.len() == 1 && notes[0].contains("sky.hdr"), "{notes:?}");
    // A name that leads out of the folder, and a file that is no picture.
    let outside = file("1", vec![dict("_ibl", &[("_path", "../sky.hdr")])]);
    assert!(load(folder.path(), &outside).1[0].contains("leads out"));
    std::fs::write(folder.path().join("sky.hdr"), b"#?RADIANCE\nno end").unwrap();
    assert!(load(folder.path(), &file("1", Vec::new())).1[0].contains("header"));
    std::fs::write(folder.path().join("sky.hdr"), picture()).unwrap();
    assert!(load(folder.path(), &file("1", Vec::new())).1.is_empty());
}

#[test]
fn a_sky_goes_back_into_its_chunks_and_another_is_written_anew() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("sky.hdr"), picture()).unwrap();
    for mode in ["0", "1", "2"] {
        let bytes = file(mode, Vec::new());
        let (mut scene, _) = load(folder.path(), &bytes);
        let out = folder.path().join("b.vox");
        assert_eq!(export::vox::write(&out, &scene).unwrap(), Vec::<String>::new(), "mode {mode}");
        let written = std::fs::read(&out).unwrap();
        let kinds = |bytes: &[u8]| {
            let file = VoxFile::parse(bytes, Path::new("a.vox"), &Limits::default()).unwrap();
            let of = |chunk: &Chunk| {
                if let Body::RenderObject(dict) = &chunk.body { Some(format!("{dict:?}")) } else { None }
            };
            file.chunks.iter().filter_map(of).collect::<Vec<String>>()
        };
        assert_eq!(kinds(&written), kinds(&bytes), "mode {mode}");
        // The disc can be said either way.
        scene.sky.set_sun_disc_visible(true);
        // A brighter map cannot be said: its mean is.
        scene.sky.set_brightness(2.0);
        let lost = export::vox::write(&out, &scene).unwrap();
        assert_eq!(lost.len(), usize::from(mode != "0"), "{lost:?}");
        let again = vox::read_bytes(&std::fs::read(&out).unwrap(), &out, &Limits::default()).unwrap();
        let gradient = matches!(again.sky.background(), Background::Gradient(_));
        assert!(again.sky.is_sun_disc_visible());
        assert!(gradient && again.sky.mean_radiance().abs_diff_eq(scene.sky.mean_radiance(), 0.01));
    }
    let plain = Scene { sky: Sky::study(1.0), ..Scene::new("plain") };
    assert_eq!(vox::ignored(&plain), Vec::<String>::new());
    assert_eq!(vox::on_request(&plain), Vec::<String>::new());
}

#[test]
fn what_is_not_shown_is_named_and_what_is_off_is_not() {
    let scene =
        |more: Vec<Body<'static>>| vox::read_bytes(&file("0", more), Path::new("a.vox"), &Limits::default()).unwrap();
    let ignored = |more: Vec<Body<'static>>| vox::ignored(&scene(more));
    assert_eq!(ignored(vec![]), Vec::<String>::new());
    let off = vec![
        dict("_fog_uni", &[("_d", "0")]),
        dict("_bloom", &[("_mix", "0.5"), ("_scale", "0")]),
        dict("_film", &[("_expo", "1"), ("_vig", "0"), ("_aces", "0")]),
        dict("_setting", &[("_ground", "0"), ("_edge", "0"), ("_grid", "0")]),
        dict("_ground", &[("_color", "80 80 80")]),
    ];
    assert_eq!(vox::on_request(&scene(off.clone())), Vec::<String>::new());
    assert_eq!(ignored(off), Vec::<String>::new());
    let on = vec![
        dict("_fog_uni", &[("_d", "0.2")]),
        dict("_film", &[("_expo", "2"), ("_vig", "0.3"), ("_aces", "1")]),
        dict("_setting", &[("_ground", "1"), ("_edge", "1"), ("_grid", "1")]),
        dict("_ground", &[("_color", "80 80 80"), ("_hor", "0.1")]),
        dict("_of_tomorrow", &[]),
    ];
    let around = ["ground (--ground, with a sharp horizon)", "fog (--fog file)"];
    let style = ["edges (--edges=file)", "grid (--grid=file)", "exposure (--exposure 1.00)"];
    assert_eq!(vox::on_request(&scene(on.clone())), [&around[..], &style].concat());
    assert_eq!(ignored(on), ["vignette", "film curve", "_of_tomorrow"]);
}

#[test]
fn lines_are_as_wide_and_far_apart_as_the_file_says() {
    let lines = |more: Vec<Body<'static>>| {
        vox::lines(&vox::read_bytes(&file("0", more), Path::new("a.vox"), &Limits::default()).unwrap())
    };
    let line = |width: f32, byte: u8| Line { width, color: linear_color([byte, 255, 0]) };
    let on = || dict("_setting", &[("_edge", "1"), ("_grid", "1")]);
    let edge = || dict("_edge", &[("_color", "138 255 0"), ("_width", "0.3")]);
    let grid = |spacing: &'static str, width: &'static str| {
        dict("_grid", &[("_color", "9 255 0"), ("_spacing", spacing), ("_width", width), ("_display", "0")])
    };
    let of_grid = |width: f32, spacing: u32| Some(GridLines { line: line(width, 9), spacing });
    let both = lines(vec![edge(), grid("8", "0.5"), on()]);
    assert_eq!(both, Lines { edges: Some(line(0.3, 138)), grid: of_grid(0.5, 8) });
    // What makes no line is none, and what is too wide as wide as it can be.
    assert_eq!(lines(vec![grid("0", "7"), on()]).grid, of_grid(1.0, 1));
    assert_eq!(lines(vec![grid("-3", "nan"), on()]).grid, None);
    assert!(lines(vec![grid("1e30", "1e30"), on()]).check().is_ok());
    // What says nothing of itself looks as MagicaVoxel begins with.
    let black = |width: f32| Line { width, color: Vec3::ZERO };
    let usual = Lines { edges: Some(black(0.2)), grid: Some(GridLines { line: black(0.05), spacing: 1 }) };
    assert_eq!(lines(vec![on()]), usual);
    assert_eq!(lines(vec![edge(), grid("8", "0.5")]), Lines::default(), "nobody shows them");
}

#[test]
fn older_files_say_the_same_in_other_chunks() {
    // As MagicaVoxel wrote them before it had `_env`, `_setting` and `_disk`.
    let file = |on: &'static str, fog: &'static str| {
        let bodies = vec![
            Body::Size([1; 3]),
            Body::Voxels(Cow::Owned(vec![[0, 0, 0, 1]])),
            dict("_inf", &[("_i", "0.6"), ("_k", "255 255 255"), ("_angle", "50 50"), ("_area", "0.07")]),
            dict("_uni", &[("_i", "0.7"), ("_k", "255 255 255")]),
            dict("_rayleigh", &[("_d", "0.4"), ("_k", "77 153 255")]),
            dict("_mie", &[("_d", "0.4"), ("_k", "255 255 255"), ("_g", "0.78")]),
            dict("_fog", &[("_d", "0.2"), ("_k", "255 255 0"), ("_enable", fog)]),
            dict("_len", &[("_fov", "45"), ("_dof", on), ("_exp", on), ("_vig", on)]),
            dict("_ground", &[("_color", "80 80 80"), ("_enable", on)]),
            dict("_bg", &[("_color", "0 255 0"), ("_enable", on)]),
            dict("_edge", &[("_color", "0 0 0"), ("_enable", on)]),
        ];
        let chunks = bodies.into_iter().map(Chunk::new).collect();
        let bytes = VoxFile { version: 150, chunks, ..VoxFile::default() }.to_bytes().unwrap();
        vox::read_bytes(&bytes, Path::new("a.vox"), &Limits::default()).unwrap()
    };
    let off = file("0", "0");
    assert_eq!((vox::ignored(&off), vox::on_request(&off)), (vec![], vec![]));
    assert_eq!(vox::surroundings(&off).fog, None);
    let on = file("1", "1");
    assert_eq!(vox::ignored(&on), ["vignette"]);
    let black = Line { width: 0.2, color: Vec3::ZERO };
    assert_eq!(vox::lines(&on), Lines { edges: Some(black), grid: None });
    assert_eq!(vox::lines(&off), Lines::default());
    let asked = ["ground (--ground)", "background colour (--background file)", "fog (--fog file)"];
    let of_camera = ["edges (--edges=file)", "aperture (--aperture, in voxels)", "exposure (--exposure 1.00)"];
    assert_eq!(vox::on_request(&on), [&asked[..], &of_camera].concat());
    let fog = vox::surroundings(&on).fog.unwrap();
    assert_eq!((fog.density, fog.color), (0.2, Vec3::new(1.0, 1.0, 0.0)));
    assert_eq!(on.sky.radiance(Vec3::X), off.sky.radiance(Vec3::X));
    assert!(on.sky.sun().is_some() && on.sky.is_sun_disc_visible());
}

#[test]
fn what_a_file_says_about_ground_fog_and_background_can_be_asked_for() {
    let said = |more: Vec<Body<'static>>| {
        vox::surroundings(&vox::read_bytes(&file("0", more), Path::new("a.vox"), &Limits::default()).unwrap())
    };
    assert_eq!(said(vec![]), vox::Surroundings::default());
    let all = said(vec![
        dict("_ground", &[("_color", "255 0 255")]),
        dict("_bg", &[("_color", "0 255 0")]),
        dict("_fog_uni", &[("_d", "0.25"), ("_k", "255 255 0"), ("_g", "-0.5")]),
    ]);
    assert_eq!((all.ground, all.background), (Some(Vec3::new(1.0, 0.0, 1.0)), Some(Vec3::Y)));
    let fog = all.fog.unwrap();
    assert_eq!((fog.density, fog.color, fog.anisotropy), (0.25, Vec3::new(1.0, 1.0, 0.0), -0.5));
    let damaged = said(vec![
        dict("_ground", &[("_color", "256 0 0")]),
        dict("_bg", &[("_color", "1 2")]),
        dict("_fog_uni", &[("_d", "inf")]),
    ]);
    assert_eq!(damaged, vox::Surroundings::default(), "what is no colour and no number says nothing");
    assert_eq!(vox::surroundings(&Scene::new("plain")), vox::Surroundings::default());
}
