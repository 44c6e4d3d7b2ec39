//! Damaged MagicaVoxel files: cut at every byte, with bytes changed, numbers blown up and text replaced. Nothing panics, and
//! every error says where. Also replays the corpus of the fuzz target.

#[path = "../../../../fuzz/check/vox.rs"]
mod check;

use crate::corpus;
use crate::damage::damaged;
use crate::vox_samples;
use crate::vox_samples::samples;
use std::path::Path;
use voxtrace::import::{ImportErrorKind, Limits, vox};

/// Random numbers that are the same on every run.
struct Random(u64);

impl Random {
    /// A number below `end`.
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(self.0 >> 11) * end as u128) >> 53) as usize
    }
}

#[test]
fn a_file_cut_at_any_byte_gives_an_error_that_says_where() {
    for (name, bytes) in samples() {
        // What follows MAIN may be cut off.
        let main_end = 20 + u32::from_le_bytes(bytes[16..20].try_into().unwrap()) as usize;
        for length in 0..main_end {
            let error = vox::read_bytes(&bytes[..length], Path::new(name), &Limits::default()).unwrap_err();
            assert!(error.offset.is_some_and(|offset| offset <= length as u64), "{name} cut at {length}: {error}");
            assert!(matches!(error.kind, ImportErrorKind::Truncated(_)), "{name} cut at {length}: {error}");
        }
    }
}

#[test]
fn a_file_with_changed_bytes_is_read_or_gives_an_error_that_says_where() {
    let numbers = [0, 1, 2, 3, 4, 255, 256, 257, 0x7fff_ffff, 0x8000_0000, u32::MAX, u32::MAX - 11];
    let texts = ["nan", "inf", "-1", "1e400", "255", "4 4 4", "2147483648 0 0", "", "\u{0}", "99999999999999999999"];
    let mut random = Random(1);
    for (_, bytes) in samples() {
        for _ in 0..1_500 {
            check::check(&damaged(&bytes, &numbers, &texts, |end| random.below(end)));
        }
    }
}

#[test]
fn each_number_in_the_text_of_a_file_may_be_anything() {
    // Values are replaced within their length, so that the structure stays and the meaning breaks.
    let digits = b"0123456789.- ne";
    let mut random = Random(2);
    for (_, bytes) in samples() {
        let places: Vec<usize> = (0..bytes.len()).filter(|&at| bytes[at].is_ascii_digit()).collect();
        for &at in &places {
            let mut damaged = bytes.clone();
            damaged[at] = digits[random.below(digits.len())];
            check::check(&damaged);
        }
    }
}

#[test]
fn the_corpus_of_the_fuzz_target_holds_the_samples_and_is_clean() {
    corpus::replay("vox", &samples(), check::check);
}

#[test]
fn each_sample_is_read() {
    for (name, bytes) in samples() {
        let scene = vox::read_bytes(&bytes, Path::new(name), &Limits::default()).unwrap();
        assert_eq!(scene.instances.is_empty(), name == "empty.vox", "{name}");
    }
}

#[test]
fn a_graph_that_shows_one_node_many_times_over_stops_at_the_limit() {
    let error = vox::read_bytes(&vox_samples::doubling_graph(40), Path::new("bomb"), &Limits::default()).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
    assert!(error.offset.is_some());
}

#[test]
fn a_deep_graph_stops_at_the_limit() {
    let read = |depth| vox::read_bytes(&vox_samples::deep_graph(depth), Path::new("deep"), &Limits::default());
    assert!(read(60).is_ok());
    assert!(matches!(read(70).unwrap_err().kind, ImportErrorKind::Limit { .. }));
    let unlimited = Limits { depth: u32::MAX, ..Limits::default() };
    let error = vox::read_bytes(&vox_samples::deep_graph(100_000), Path::new("deep"), &unlimited).unwrap_err();
    assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "the stack is not the limit");
}

#[test]
fn each_limit_holds() {
    let (_, bytes) = samples().remove(0);
    let path = Path::new("limited");
    let default = Limits::default();
    for (what, limits) in [
        ("bytes", Limits { bytes: bytes.len() as u64 - 1, ..default }),
        ("voxels", Limits { voxels: 3, ..default }),
        ("chunks", Limits { items: 5, ..default }),
        ("depth", Limits { depth: 2, ..default }),
    ] {
        let error = vox::read_bytes(&bytes, path, &limits).unwrap_err();
        assert!(matches!(&error.kind, ImportErrorKind::Limit { what: w, .. } if w.contains(what)), "{what}: {error}");
    }
    assert!(vox::read_bytes(&bytes, path, &Limits { bytes: bytes.len() as u64, ..default }).is_ok());
}
