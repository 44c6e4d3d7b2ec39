//! Damaged panoramas: cut at every byte, with bytes changed, numbers blown up and text replaced. Nothing panics. Also replays the corpus of the
//! fuzz target.

#![cfg(feature = "pictures")]

#[path = "../../../../fuzz/check/panorama.rs"]
mod check;

use crate::corpus;
use crate::damage::damaged;
use exr::prelude::*;
use std::path::Path;
use voxtrace::import::{Limits, environment_from_bytes};

/// Random numbers that are the same on every run.
struct Numbers(u64);

impl Numbers {
    /// A number below `end`.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(self.0 >> 11) * end as u128) >> 53) as usize
    }
}

/// A Radiance picture of plain pixels and repeated ones, one of encoded scanlines, and OpenEXR pictures as they are and packed.
fn samples() -> Vec<(&'static str, Vec<u8>)> {
    let mut plain = b"#?RADIANCE\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n".to_vec();
    plain.extend(
        [[128, 64, 0, 129], [1, 1, 1, 2], [9, 8, 7, 140], [0, 0, 0, 0], [255, 255, 255, 128], [1, 2, 3, 100]].concat(),
    );
    plain.extend([5, 6, 7, 128]);
    let mut encoded = b"#?RGBE\n\n-Y 1 +X 8\n".to_vec();
    encoded.extend([2, 2, 0, 8, 136, 200, 3, 1, 2, 3, 5, 4, 5, 6, 7, 8, 132, 10, 132, 20, 133, 129, 131, 130]);
    let exr = |compression| {
        let encoding = Encoding { compression, ..Encoding::UNCOMPRESSED };
        let pixel = |at: Vec2<usize>| (at.x() as f32, 0.25 * at.y() as f32, 3.5);
        let layer = Layer::new((8, 4), LayerAttributes::default(), encoding, SpecificChannels::rgb(pixel));
        let mut bytes = std::io::Cursor::new(Vec::new());
        Image::from_layer(layer).write().to_buffered(&mut bytes).unwrap();
        bytes.into_inner()
    };
    vec![
        ("plain.hdr", plain),
        ("encoded.hdr", encoded),
        ("plain.exr", exr(Compression::Uncompressed)),
        ("runs.exr", exr(Compression::RLE)),
    ]
}

#[test]
fn the_corpus_of_panoramas_is_read_or_refused() {
    corpus::replay("panorama", &samples(), check::check);
    for (name, bytes) in samples() {
        let map = environment_from_bytes(&bytes, Path::new(name), &Limits::default()).unwrap();
        assert!(map.mean_radiance().max_element() > 0.0, "{name}");
    }
}

#[test]
fn a_panorama_cut_at_any_byte_is_refused() {
    for (name, bytes) in samples() {
        for length in 0..bytes.len() {
            let cut = environment_from_bytes(&bytes[..length], Path::new(name), &Limits::default());
            let error = cut.map(|_| ()).unwrap_err().to_string();
            assert!(error.contains(name), "{name} cut at {length}: {error}");
            check::check(&bytes[..length]);
        }
    }
}

#[test]
fn a_panorama_with_changed_bytes_is_read_or_refused() {
    let numbers = [0, 1, 2, 4, 8, 255, 256, 0x7fff_ffff, 0x8000_0000, u32::MAX, 0x7f80_0000, 0x7fc0_0000];
    let texts = ["nan", "inf", "-1", "1e400", "-Y 4 +X 2", "99999999999999999999", "", "\u{0}"];
    let mut random = Numbers(1);
    for (_, bytes) in samples() {
        for _ in 0..400 {
            check::check(&damaged(&bytes, &numbers, &texts, |end| random.below(end)));
        }
    }
}
