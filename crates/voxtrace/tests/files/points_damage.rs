//! Scans that are cut, changed, forged or noise. Also replays the corpus of the fuzz target.

#[path = "../../../../fuzz/check/points.rs"]
mod check;

use crate::corpus;
use crate::meshes::Random;
use crate::point_samples::{e57, laz, pcd, read, sample, samples, splats};
use voxtrace::import::{self, Geometry, ImportErrorKind, ImportOptions, Limits};
use voxtrace_test_support::{data, files_below};

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
    let others = [
        ("splats.ply", splats(&sample()[..40])),
        ("commas.txt", b"X;Y;Z;Intensity\n1,5;-2,25;3;7\n4;5,5;6;8\n".to_vec()),
        ("upper.pcd", String::from_utf8(pcd(&sample()[..9], "ascii")).unwrap().replace("x y z", "X Y Z").into_bytes()),
    ];
    corpus::replay("points", own.chain(&others), check::check_all);
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
