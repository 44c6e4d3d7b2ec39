//! TIFF in Zstandard and JPEG 2000, which tifffile has written: tiles with a predictor, a BigTIFF in big endian, strips. All three hold the
//! same samples; none of their bytes can be damaged so that more than an error comes of it.

use crate::check_volume::check;
use crate::meshes::Random;
use std::path::Path;
use voxtrace::import::{self, ImportErrorKind, ImportOptions, Limits};

const FILES: [(&str, &[u8]); 3] = [
    ("zstd.tif", include_bytes!("../../../../fuzz/corpus/volume/zstd.tif")),
    ("zstd_big.tif", include_bytes!("../../../../fuzz/corpus/volume/zstd_big.tif")),
    ("jpeg_2000.tif", include_bytes!("../../../../fuzz/corpus/volume/jpeg_2000.tif")),
];
/// Samples along x, y and z.
const SIZE: [usize; 3] = [12, 10, 3];

fn wanted() -> Vec<f32> {
    (0..360).map(|n| (n % 12 + 20 * (n / 12 % 10) + 300 * (n / 120)) as f32).collect()
}

#[test]
fn strips_and_tiles_in_zstandard_and_jpeg_2000_hold_the_samples_that_were_written() {
    for (name, bytes) in FILES {
        let volume = import::volume_from_bytes(bytes, Path::new(name), &ImportOptions::default()).unwrap();
        assert_eq!((volume.size, volume.values), (SIZE, wanted()), "{name}");
        let limits = Limits { points: 359, ..Limits::default() };
        let few = ImportOptions { limits, ..ImportOptions::default() };
        let error = import::volume_from_bytes(bytes, Path::new(name), &few).unwrap_err();
        assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{name}: {error}");
    }
}

/// Where the packed bytes of a segment begin, by what they begin with.
fn segment(bytes: &[u8]) -> usize {
    let starts = [&b"\x28\xb5\x2f\xfd"[..], b"\xff\x4f\xff\x51"];
    (0..bytes.len()).find(|&at| starts.iter().any(|start| bytes[at..].starts_with(start))).unwrap()
}

#[test]
fn a_damaged_segment_is_named_in_one_line_at_once_and_layer_by_layer() {
    let folder = tempfile::tempdir().unwrap();
    for (name, bytes) in FILES {
        let mut damaged = bytes.to_vec();
        damaged[segment(bytes)] ^= 0x55;
        let error = import::volume_from_bytes(&damaged, Path::new(name), &ImportOptions::default()).unwrap_err();
        let packing = if name.starts_with("zstd") { "Zstandard" } else { "JPEG 2000" };
        let text = error.to_string();
        assert!(text.contains(&format!("page 0: segment 0: {packing}: ")) && !text.contains('\n'), "{text}");
        let path = folder.path().join(name);
        std::fs::write(&path, &damaged).unwrap();
        // Opening looks at all values.
        let text = import::open_large_volume(&path, &ImportOptions::default(), 1).map(|_| ()).unwrap_err().to_string();
        assert!(text.contains(&format!("page 0: segment 0: {packing}: ")) && !text.contains('\n'), "{text}");
    }
}

#[test]
fn no_damage_is_more_than_an_error() {
    let mut random = Random(21);
    let mut refused = 0;
    for (name, bytes) in FILES {
        for _ in 0..1_500 {
            let mut damaged = bytes.to_vec();
            for _ in 0..=random.below(3) {
                let at = random.below(damaged.len());
                damaged[at] = random.below(256) as u8;
            }
            check(name, &damaged);
            let read = import::volume_from_bytes(&damaged, Path::new(name), &ImportOptions::default());
            refused += usize::from(read.is_err());
        }
        for length in 0..bytes.len() {
            check(name, &bytes[..length]);
            let cut = import::volume_from_bytes(&bytes[..length], Path::new(name), &ImportOptions::default());
            assert!(cut.is_err(), "{name} cut to {length} bytes");
        }
    }
    assert!(refused > 1_000, "{refused} of 4500");
}
