//! Channels, time points and colours that other programs' libraries have written: each sample is chosen as they say, and colours are those
//! that their channels add up to.

use crate::written::Written;
use serde_json::Value;
use std::path::Path;
use voxtrace::Volume;
use voxtrace::glam::DVec3;
use voxtrace::import::{self, ImportOptions};
use voxtrace::scene::Unit;

static WRITTEN: Written = Written::by("hyperstacks.py", "tifffile, zarr, nibabel and pynrrd");

/// What the script wrote.
struct Truth<'a> {
    folder: &'a Path,
    json: Value,
    /// Time points, slices, channels, rows, columns: the last is the fastest.
    data: Vec<f32>,
}

impl<'a> Truth<'a> {
    fn of(folder: &'a Path) -> Self {
        let json = serde_json::from_str(&std::fs::read_to_string(folder.join("files.json")).unwrap()).unwrap();
        Self { folder, json, data: floats(&folder.join("data.f32")) }
    }

    fn number(&self, key: &str) -> usize {
        self.json[key].as_u64().unwrap() as usize
    }

    fn size(&self) -> [usize; 3] {
        std::array::from_fn(|axis| self.json["size"][axis].as_u64().unwrap() as usize)
    }

    /// The samples of a time point and a channel, both from 1 on.
    fn samples(&self, time: usize, channel: usize) -> Vec<f32> {
        let [x, y, z] = self.size();
        let plane = |slice: usize| ((time - 1) * z + slice) * self.number("channels") + channel - 1;
        (0..z).flat_map(|slice| &self.data[plane(slice) * x * y..(plane(slice) + 1) * x * y]).copied().collect()
    }

    fn read(&self, name: &str, time: Option<u32>, channel: Option<u32>) -> Volume {
        let options = ImportOptions { time, channel, ..ImportOptions::default() };
        import::read_volume(&self.folder.join(name), &options).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn refusal(&self, name: &str, time: Option<u32>, channel: Option<u32>) -> String {
        let options = ImportOptions { time, channel, ..ImportOptions::default() };
        import::read_volume(&self.folder.join(name), &options).unwrap_err().to_string()
    }
}

fn floats(path: &Path) -> Vec<f32> {
    std::fs::read(path).unwrap().as_chunks().0.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect()
}

#[test]
fn hyperstacks_give_the_channel_and_time_point_that_is_asked_for_and_else_all_colours() {
    let Some(folder) = WRITTEN.folder() else { return };
    let truth = Truth::of(folder);
    let files = truth.json["files"].as_object().unwrap();
    assert_eq!(files.len(), 8);
    for (name, about) in files {
        for (time, channel) in (1..=2).flat_map(|time| (1..=3).map(move |channel| (time, channel))) {
            let volume = truth.read(name, Some(time), Some(channel));
            assert_eq!((volume.size, volume.colors.len()), (truth.size(), 0), "{name}");
            assert!(volume.values == truth.samples(time as usize, channel as usize), "{name} {time} {channel}");
            // Another channel or time point is told apart.
            assert!(volume.values != truth.samples(3 - time as usize, channel as usize));
        }
        let volume = truth.read(name, None, None);
        let wanted = std::fs::read(folder.join(format!("{name}.rgb"))).unwrap();
        let apart = volume.colors.as_flattened().iter().zip(&wanted).map(|(a, b)| a.abs_diff(*b)).max();
        // Sums of f32 and of f64 may round to either side.
        assert!(volume.colors.as_flattened().len() == wanted.len() && apart <= Some(1), "{name}: {apart:?} apart");
        assert!(
            volume.notes.iter().any(|note| note.contains("the first of 2 time points")),
            "{name}: {:?}",
            volume.notes
        );
        assert!(volume.notes.iter().any(|note| note.contains("3 channels")), "{name}: {:?}", volume.notes);
        if let Some(spacing) = about["spacing"].as_array() {
            let spacing = DVec3::from_array(std::array::from_fn(|axis| spacing[axis].as_f64().unwrap()));
            assert!((volume.spacing() - spacing).abs().max_element() < 1e-9, "{name}: {}", volume.spacing());
            assert_eq!(volume.unit == Unit::Millimetre, name != "named.zarr", "{name}");
        }
        if let Some(origin) = about["origin"].as_array() {
            let origin = DVec3::from_array(std::array::from_fn(|axis| origin[axis].as_f64().unwrap()));
            assert!((volume.world_from_index.translation - origin).abs().max_element() < 1e-9, "{name}");
        }
        assert!(truth.refusal(name, Some(3), None).contains("no time point 3: there are 2"), "{name}");
        assert!(truth.refusal(name, None, Some(4)).contains("no channel 4: there are 3"), "{name}");
    }
}

#[test]
fn a_fourth_axis_is_time() {
    let Some(folder) = WRITTEN.folder() else { return };
    let truth = Truth::of(folder);
    for name in ["series.nii.gz", "series.npy", "series.nrrd", "series.mha"] {
        for time in [1, 2] {
            let volume = truth.read(name, Some(time), None);
            assert_eq!(volume.size, truth.size(), "{name}");
            assert!(volume.values == truth.samples(time as usize, 1), "{name} {time}");
        }
        let first = truth.read(name, None, None);
        assert!(first.values == truth.samples(1, 1) && first.notes[0].contains("--time chooses another"), "{name}");
        assert!(truth.refusal(name, Some(3), None).contains("no time point 3: there are 2"), "{name}");
    }
    // Nobody says what the axis of an array is: both options choose.
    assert!(truth.read("series.npy", None, Some(2)).values == truth.samples(2, 1));
}

#[test]
fn red_green_and_blue_are_colours_whatever_the_format() {
    let Some(folder) = WRITTEN.folder() else { return };
    let truth = Truth::of(folder);
    let wanted: Vec<[u8; 4]> = std::fs::read(folder.join("colors.rgba")).unwrap().as_chunks().0.to_vec();
    for ending in ["nii", "npy", "nrrd", "mha"] {
        for name in ["rgb", "rgba"] {
            let name = format!("{name}.{ending}");
            let volume = truth.read(&name, None, None);
            assert_eq!(volume.size, truth.size(), "{name}");
            assert!(volume.colors.iter().zip(&wanted).all(|(color, wanted)| color[..] == wanted[..3]), "{name}");
            let brightness = |[r, g, b, a]: [u8; 4]| {
                let opacity = if name.starts_with("rgba") { f32::from(a) / 255.0 } else { 1.0 };
                (0.299 * f32::from(r) + 0.587 * f32::from(g) + 0.114 * f32::from(b)) * opacity
            };
            assert!(volume.values.iter().zip(&wanted).all(|(value, color)| (value - brightness(*color)).abs() < 1e-3));
            let blue = truth.read(&name, None, Some(3));
            assert!(
                blue.colors.is_empty()
                    && blue.values.iter().zip(&wanted).all(|(value, color)| *value == f32::from(color[2])),
                "{name}"
            );
            assert!(truth.refusal(&name, None, Some(5)).contains("no channel 5"), "{name}");
        }
    }
}

#[test]
fn vectors_show_their_length_or_the_number_that_is_asked_for() {
    let Some(folder) = WRITTEN.folder() else { return };
    let truth = Truth::of(folder);
    let field: Vec<[f32; 3]> = floats(&folder.join("field.f32")).as_chunks().0.to_vec();
    for name in ["field.mha", "field.nrrd", "field.nii"] {
        for channel in 1..=3 {
            let volume = truth.read(name, None, Some(channel));
            assert!(
                volume.values.iter().zip(&field).all(|(value, vector)| *value == vector[channel as usize - 1]),
                "{name}"
            );
        }
        let volume = truth.read(name, None, None);
        assert!(volume.notes.iter().any(|note| note.contains("--channel chooses")), "{name}");
        if !name.ends_with("nii") {
            let length = |vector: [f32; 3]| DVec3::from_array(vector.map(f64::from)).length() as f32;
            assert!(volume.values.iter().zip(&field).all(|(value, vector)| *value == length(*vector)), "{name}");
        }
    }
}

#[test]
fn pages_of_one_bit_are_read_and_where_white_is_zero_they_are_turned_round() {
    let Some(folder) = WRITTEN.folder() else { return };
    let truth = Truth::of(folder);
    for (name, wanted, factor) in [
        ("bits.tif", "bits.f32", 1.0),
        ("bits_turned.tif", "bits.f32", 1.0),
        ("grey_turned.tif", "grey.f32", 1.0),
        ("deep_turned.tif", "grey.f32", 257.0),
    ] {
        let volume = truth.read(name, None, None);
        let wanted = floats(&folder.join(wanted));
        assert_eq!((volume.size, wanted.len()), ([11, 6, 5], 330), "{name}");
        assert!(volume.values.iter().zip(&wanted).all(|(found, wanted)| *found == wanted * factor), "{name}");
    }
}

#[test]
fn slices_alone_are_as_many_as_there_are_with_the_lengths_that_are_said() {
    let Some(folder) = WRITTEN.folder() else { return };
    let truth = Truth::of(folder);
    let wanted = floats(&folder.join("grey.f32"));
    for name in ["plain.tif", "short.tif"] {
        let volume = truth.read(name, Some(1), Some(1));
        assert_eq!((volume.size, volume.unit, volume.notes.len()), ([11, 6, 5], Unit::Millimetre, 0), "{name}");
        assert!(volume.values == wanted, "{name}");
        assert!((volume.spacing() - DVec3::new(0.0002, 0.0004, 0.0015)).abs().max_element() < 1e-9, "{name}");
        assert!(truth.refusal(name, Some(2), None).contains("no time point 2: there are 1"), "{name}");
    }
}
