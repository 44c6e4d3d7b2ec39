//! The pixels of pydicom's own samples, all of them, are what pydicom says.

use crate::written::Written;
use serde_json::Value;
use std::path::Path;
use voxtrace::Volume;
use voxtrace::glam::DVec3;
use voxtrace::import::{self, ImportOptions};

static WRITTEN: Written = Written::by("dicom.py", "pydicom, pydicom-data, pylibjpeg and pyjpegls");

/// How far two decoders of a lossy format may be apart, which round differently.
fn tolerance(syntax: &str) -> f32 {
    match syntax {
        // Two roundings, one of them before the colours are mixed.
        _ if syntax.starts_with("JPEG Baseline") || syntax.starts_with("JPEG Extended") => 2.0,
        "JPEG 2000 Image Compression" => 1.0,
        // The brightness of colours is summed in f32.
        _ => 0.0,
    }
}

/// The largest difference of each frame that is compared; a reader may have sorted them.
fn worst(volume: &Volume, wanted: &[f32]) -> f32 {
    let size = volume.size[0] * volume.size[1];
    let mut found: Vec<&[f32]> = volume.values.chunks_exact(size).collect();
    let apart = |a: &[f32], b: &[f32]| {
        let apart = a.iter().zip(b).map(|(a, b)| ((a - b).abs() - 1e-6 * b.abs()).max(0.0));
        apart.fold(0.0, |worst: f32, apart| if apart <= worst { worst } else { apart })
    };
    let mut all = 0.0f32;
    for wanted in wanted.chunks_exact(size) {
        let Some((place, least)) =
            found.iter().map(|frame| apart(frame, wanted)).enumerate().min_by(|a, b| a.1.total_cmp(&b.1))
        else {
            return f32::INFINITY;
        };
        found.swap_remove(place);
        all = all.max(least);
    }
    all
}

#[test]
fn the_samples_of_pydicom_have_the_pixels_that_it_reads() {
    let Some(folder) = WRITTEN.folder() else { return };
    let text = std::fs::read_to_string(folder.join("samples.json")).unwrap();
    let samples: Vec<Value> = serde_json::from_str(&text).unwrap();
    let (mut compared, mut wrong) = (0, Vec::new());
    for sample in samples.iter().filter(|sample| sample["error"].is_null()) {
        let [name, path, syntax] = ["name", "path", "syntax"].map(|key| sample[key].as_str().unwrap());
        let bytes = std::fs::read(path).unwrap();
        let wanted = floats(&folder.join(format!("{name}.f32")));
        let volume = match import::volume_from_bytes(&bytes, Path::new("sample.dcm"), &ImportOptions::default()) {
            Ok(volume) => volume,
            Err(error) => {
                wrong.push(format!("{name}: {error}"));
                continue;
            }
        };
        let size: Vec<usize> =
            sample["size"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap() as usize).collect();
        if name == "localizer.dcm" {
            // Of three directions one is read: see below.
            continue;
        }
        let step = sample["step"].as_f64().unwrap() as f32;
        let far = worst(&volume, &wanted);
        if volume.size[..] != size[..] || far > tolerance(syntax) * step {
            wrong.push(format!("{name} ({syntax}, {}): {:?} for {size:?}, {far} apart", sample["kind"], volume.size));
        }
        // One pixel of another value is told apart.
        let mut planted = wanted;
        let last = planted.len() - 1;
        planted[last] += 3.0 * step + 1e-3 * planted[last].abs();
        if worst(&volume, &planted) <= tolerance(syntax) * step {
            wrong.push(format!("{name}: a planted pixel is not noticed"));
        }
        compared += 1;
    }
    assert!(wrong.is_empty(), "{} of {compared}:\n{}", wrong.len(), wrong.join("\n"));
    assert!(compared > 170, "{compared}");
}

#[test]
fn of_frames_in_several_directions_the_largest_stack_is_read_or_the_one_that_is_asked_for() {
    let Some(folder) = WRITTEN.folder() else { return };
    let path = folder.join("own/localizer.dcm");
    let all: Vec<f32> = floats(&folder.join("localizer.dcm.f32"));
    let read = |series| import::read_volume(&path, &ImportOptions { series, ..ImportOptions::default() });
    for (series, frames) in [(None, 3..8), (Some(1), 0..3), (Some(2), 3..8), (Some(3), 8..10)] {
        let volume = read(series).unwrap();
        assert_eq!(volume.size, [8, 6, frames.len()], "{series:?}");
        assert_eq!(worst(&volume, &all[frames.start * 48..frames.end * 48]), 0.0, "{series:?}");
        let note = volume.notes.iter().find(|note| note.contains("3 directions")).expect("it is said");
        assert!(note.contains("1: 3 frames, 2: 5 frames, 3: 2 frames"), "{note}");
    }
    assert!(read(Some(4)).unwrap_err().to_string().contains("no stack 4"));
}

#[test]
fn mosaics_of_siemens_are_the_slices_of_nibabel_at_its_places() {
    let Some(folder) = WRITTEN.folder() else { return };
    let mosaics: Vec<Value> =
        serde_json::from_str(&std::fs::read_to_string(folder.join("mosaics.json")).unwrap()).unwrap();
    assert_eq!(mosaics.len(), 2);
    for mosaic in mosaics {
        let name = mosaic["name"].as_str().unwrap();
        let bytes = std::fs::read(folder.join(format!("own/{name}.dcm"))).unwrap();
        let volume = import::volume_from_bytes(&bytes, Path::new("a.dcm"), &ImportOptions::default()).unwrap();
        let size: [usize; 3] = serde_json::from_value(mosaic["size"].clone()).unwrap();
        let affine: [[f64; 4]; 4] = serde_json::from_value(mosaic["affine"].clone()).unwrap();
        let wanted = floats(&folder.join(format!("own/{name}.f32")));
        assert_eq!(volume.size, size, "{name}");
        let [columns, rows, _] = size;
        let column = |n: usize| DVec3::from_array([0, 1, 2].map(|row| affine[row][n]));
        // nibabel counts rows before columns.
        let place = |x: usize, y: usize, z: usize| {
            column(0) * y as f64 + column(1) * x as f64 + column(2) * z as f64 + column(3)
        };
        let index_from_world = volume.world_from_index.inverse();
        let at = |x: usize, y: usize, z: usize| x + columns * (y + rows * z);
        let differs = |shift: f64| {
            let mut count = 0;
            for (x, y, z) in (0..size[2])
                .flat_map(|z| (0..rows).step_by(3).map(move |y| (y, z)))
                .flat_map(|(y, z)| (0..columns).step_by(5).map(move |x| (x, y, z)))
            {
                let index = index_from_world.transform_point3(place(x, y, z) + DVec3::splat(shift));
                let near = index.round();
                let is_there = (index - near).abs().max_element() < 0.02 && near.min_element() >= 0.0;
                let [i, j, k] = near.to_array().map(|n| n as usize);
                count += u32::from(!is_there || volume.values.get(at(i, j, k)) != wanted.get(at(x, y, z)));
            }
            count
        };
        assert_eq!(differs(0.0), 0, "{name}");
        // A volume beside its place is told apart.
        assert!(differs(0.9) > 10_000, "{name}");
    }
}

#[test]
fn a_series_whose_directions_differ_in_their_last_digits_is_one_stack() {
    let Some(folder) = WRITTEN.folder() else { return };
    for path in ["tilted", "tilted/2.dcm"] {
        let volume = import::read_volume(&folder.join(path), &ImportOptions::default()).unwrap();
        assert_eq!((volume.size, volume.notes.len()), ([8, 6, 4], 0), "{path}: {:?}", volume.notes);
        assert!((0..4).all(|z| volume.values[48 * z] == z as f32), "{path}");
    }
}

#[test]
fn shares_of_one_segment_are_values_and_those_of_several_become_labels() {
    let Some(folder) = WRITTEN.folder() else { return };
    let shares = floats(&folder.join("shares.f32"));
    let read = |name: &str| import::read_volume(&folder.join(name), &ImportOptions::default()).unwrap();
    let (one, two) = (read("shares_1.dcm"), read("shares_2.dcm"));
    let (first, second) = shares.split_at(shares.len() / 2);
    assert_eq!((one.size, one.is_labels, one.values == first), ([8, 6, 3], false, true));
    let half = |share: f32| share >= 100.0;
    let label = |(&first, &second): (&f32, &f32)| if half(second) { 2.0 } else { f32::from(u8::from(half(first))) };
    let labels: Vec<f32> = first.iter().zip(second).map(label).collect();
    assert_eq!((two.size, two.is_labels, two.values == labels), ([8, 6, 3], true, true));
    assert!(two.notes.iter().any(|note| note.contains("belong to several segments")), "{:?}", two.notes);
}

fn floats(path: &Path) -> Vec<f32> {
    std::fs::read(path).unwrap().as_chunks().0.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect()
}
