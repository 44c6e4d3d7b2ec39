//! Files of OpenVDB: values, places, damage of every kind. Nothing panics. Also replays the corpus of the fuzz target.

use crate::check_volume as check;
use crate::corpus;
use crate::damage::damaged;
use crate::meshes::Random;
use crate::vdb_samples::{BAND, TILE, ball, samples, slope};
use std::path::Path;
use voxtrace::Volume;
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::import::{self, ImportError, ImportErrorKind, ImportOptions, Limits, READERS};
use voxtrace::mesh::UpAxis;
use voxtrace::volume::Preset;
use voxtrace_test_support::data;

/// First bytes of a file.
pub const MAGIC: &[u8] = b" BDV\0\0\0\0";

fn read(name: &str, bytes: &[u8], options: &ImportOptions) -> Result<Volume, ImportError> {
    import::volume_from_bytes(bytes, Path::new(name), options)
}

fn sample(wanted: &str) -> Vec<u8> {
    samples().into_iter().find(|(name, _)| *name == wanted).unwrap().1
}

/// The value of a volume at a place of the file, whose lowest one is `low`.
fn value(volume: &Volume, low: IVec3, at: IVec3) -> f32 {
    let [x, y, z] = (at - low).to_array().map(|c| c as usize);
    volume.values[(z * volume.size[1] + y) * volume.size[0] + x]
}

fn places(low: IVec3, size: [usize; 3]) -> impl Iterator<Item = IVec3> {
    let [width, height, depth] = size.map(|edge| edge as i32);
    (0..depth).flat_map(move |z| (0..height).flat_map(move |y| (0..width).map(move |x| low + IVec3::new(x, y, z))))
}

#[test]
fn a_level_set_is_read_as_depths_below_its_surface() {
    let volume = read("ball.vdb", &sample("ball.vdb"), &ImportOptions::default()).unwrap();
    // The band is 2 wide around a ball of 3.5.
    let low = IVec3::new(1, 0, 2);
    assert_eq!((volume.size, volume.suited), ([11, 11, 11], Some(Preset::Surface)));
    for at in places(low, volume.size) {
        assert_eq!(value(&volume, low, at), -ball(at).0, "{at}");
    }
    assert!(volume.values.contains(&BAND) && volume.values.contains(&-BAND));
    assert!(volume.notes.len() == 1 && volume.notes[0].contains("wind"), "{:?}", volume.notes);
}

#[test]
fn densities_and_tiles_are_where_the_file_says() {
    for name in ["zip.vdb", "blosc.vdb"] {
        let volume = read(name, &sample(name), &ImportOptions::default()).unwrap();
        let low = IVec3::new(1, 0, 0);
        assert_eq!(volume.size, [15, 8, 8], "{name}");
        for at in places(low, volume.size) {
            let wanted = if at.cmpge(TILE.0).all() { TILE.1 } else { slope(at).0 };
            assert_eq!(value(&volume, low, at), wanted, "{name} {at}");
        }
        assert_eq!(volume.suited, (name == "zip.vdb").then_some(Preset::Fog));
    }
}

#[test]
fn the_world_is_that_of_the_file_with_y_up() {
    let world = |name: &str, up: Option<UpAxis>, at: DVec3| {
        let volume = read(name, &sample(name), &ImportOptions { up, ..ImportOptions::default() }).unwrap();
        volume.world_from_index.transform_point3(at)
    };
    // The file's (x, y, z) is our (x, −z, y).
    assert_eq!(world("zip.vdb", None, DVec3::ZERO), DVec3::new(1.25, -3.0, 2.0));
    assert_eq!(world("zip.vdb", None, DVec3::Y), DVec3::new(1.25, -3.0, 2.25));
    assert_eq!(world("zip.vdb", Some(UpAxis::Y), DVec3::Y), DVec3::new(1.25, -3.0, 2.25));
    assert_eq!(world("zip.vdb", Some(UpAxis::Z), DVec3::Y), DVec3::new(1.25, 2.25, 3.0));
    // x along z, y along x and z along y.
    assert_eq!(world("blosc.vdb", Some(UpAxis::Z), DVec3::ZERO), DVec3::new(10.0, 20.0, 32.0));
    assert_eq!(world("blosc.vdb", Some(UpAxis::Z), DVec3::new(1.0, 2.0, 4.0)), DVec3::new(11.0, 24.0, 34.0));
}

#[test]
fn a_file_cut_at_any_byte_gives_an_error_that_says_where() {
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            let error = read(name, &bytes[..length], &ImportOptions::default()).unwrap_err();
            assert!(error.offset.is_some_and(|at| at <= length as u64), "{name} {length}: {error}");
        }
    }
}

#[test]
fn a_file_with_changed_bytes_is_read_or_gives_an_error() {
    let numbers = [0, 1, 6, 255, 4096, 65_535, 0x7fff_ffff, 0x8000_0000, u32::MAX];
    let mut random = Random(5);
    for (name, bytes) in samples() {
        for _ in 0..1_000 {
            check::check(name, &damaged(&bytes, &numbers, &["\0\0\0\0", "Tree_float_5_4_3"], |end| random.below(end)));
        }
        // Most of the file is masks; its numbers are in front of and behind them.
        for _ in 0..3_000 {
            let (mut copy, start) = (bytes.clone(), if random.below(2) == 0 { 0 } else { bytes.len() - 600 });
            let part = damaged(&bytes[start..start + 600], &numbers, &["\u{7f}"], |end| random.below(end));
            copy[start..start + 600].copy_from_slice(&part);
            check::check(name, &copy);
        }
    }
}

#[test]
fn each_limit_holds_and_noise_is_refused() {
    for (name, bytes) in samples() {
        for limits in [
            Limits { bytes: 500, ..Limits::default() },
            Limits { points: 900, ..Limits::default() },
            Limits { items: 1, ..Limits::default() },
        ] {
            let error = read(name, &bytes, &ImportOptions { limits, ..ImportOptions::default() }).unwrap_err();
            assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{name} {limits:?}: {error}");
        }
    }
    let mut random = Random(6);
    let mut noise: Vec<u8> = (0..16 << 20).map(|_| random.below(256) as u8).collect();
    for length in [0, 8, 70, 400, 9_000] {
        noise[..length].copy_from_slice(&sample("zip.vdb")[..length]);
        assert!(read("a.vdb", &noise, &ImportOptions::default()).is_err(), "{length}");
    }
}

#[test]
fn nodes_that_lie_on_each_other_are_refused() {
    let mut bytes = sample("ball.vdb");
    let root = [&2.0f32.to_le_bytes()[..], &[0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0]].concat();
    let at = bytes.windows(root.len()).position(|window| window == root).unwrap() + 8;
    bytes[at] = 2;
    // A second one, cut off where it would begin again.
    let error = read("a.vdb", &bytes, &ImportOptions::default()).unwrap_err();
    assert!(error.offset.is_some(), "{error}");
    bytes[at] = 1;
    bytes[at + 4] = 1;
    let error = read("a.vdb", &bytes, &ImportOptions::default()).unwrap_err().to_string();
    assert!(error.contains("a node at [1, 0, 0]"), "{error}");
}

#[test]
fn what_is_not_read_is_named() {
    let fails = |from: &str, to: &str| {
        let text = sample("ball.vdb");
        let at = text.windows(from.len()).position(|window| window == from.as_bytes()).unwrap();
        let bytes = [&text[..at], to.as_bytes(), &text[at + to.len()..]].concat();
        read("a.vdb", &bytes, &ImportOptions::default()).unwrap_err().to_string()
    };
    assert!(fails("Tree_float_5", "Tree_bool__5").contains("bool__5_4_3"));
    assert!(fails("UniformScaleMap", "NonlinearFrust_").contains("lump"));
    let mut old = sample("ball.vdb");
    old[8] = 221;
    assert!(read("a.vdb", &old, &ImportOptions::default()).unwrap_err().to_string().contains("version 221"));
    let options = ImportOptions::default();
    let opened = READERS.open_bytes(&old, Path::new("a"), &options).unwrap();
    assert_eq!(opened.reader().name, "OpenVDB");
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_and_is_clean() {
    corpus::replay("volume", &samples(), check::check_all);
}

#[test]
fn a_shared_level_set_is_the_ball_that_its_manifest_says() {
    let Some(data) = data() else { return };
    let path = data.join("vdb/sphere.vdb");
    let volume = import::read_volume(&path, &ImportOptions::default()).unwrap();
    assert_eq!((volume.size, volume.suited), ([125, 125, 125], Some(Preset::Surface)));
    let scene = import::open(&path, &ImportOptions::default()).unwrap();
    let grid = &scene.grids[0];
    let bounds = grid.bounds().unwrap();
    let middle = (bounds.min + bounds.max).as_vec3() * 0.5;
    let radius = 0.5 * bounds.size().x as f32;
    assert!(bounds.size().cmpeq(IVec3::splat(bounds.size().x)).all() && (110..=125).contains(&bounds.size().x));
    // The shell of a ball, nothing inside and nothing missing.
    let off = |at: IVec3| (at.as_vec3() + 0.5 - middle).length() - radius;
    assert!(grid.voxels().all(|(at, _)| off(at).abs() < 2.0));
    let mut options = ImportOptions::default();
    options.volume.shell = false;
    let solid = import::open(&path, &options).unwrap().grids[0].count() as f32;
    // Voxels count whose middles are inside.
    let wanted = 4.0 / 3.0 * std::f32::consts::PI * (radius - 0.5).powi(3);
    assert!((solid / wanted - 1.0).abs() < 0.003, "{solid} {wanted}");
    let error = import::open(&data.join("malformed/made/vdb_truncated.vdb"), &ImportOptions::default()).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{error}");
}
