//! Volumes in the formats of other programs have the values and the places that their own libraries say, read at once and layer by layer:
//! nibabel, NumPy, pynrrd, Zarr, TensorStore (N5), tifffile and pydicom.

use crate::written::Written;
use serde_json::Value;
use std::path::Path;
use voxtrace::glam::{DMat4, DVec3};
use voxtrace::import::{self, ImportOptions, Limits};
use voxtrace::volume::VolumeOptions;
use voxtrace::voxelize::VoxelizeProgress;
use voxtrace::{PackedScene, Volume};

static WRITTEN: Written =
    Written::by("volumes.py", "nibabel, numpy, pynrrd, zarr, tensorstore, tifffile, imagecodecs and pydicom");

fn samples(folder: &Path) -> Vec<Value> {
    let text = std::fs::read_to_string(folder.join("volumes.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn options(sample: &Value) -> ImportOptions {
    let time = sample["time"].as_u64().map(|time| time as u32);
    ImportOptions { time, series: sample["series"].as_i64(), ..ImportOptions::default() }
}

fn floats(path: &Path) -> Vec<f32> {
    std::fs::read(path).unwrap().as_chunks().0.iter().map(|&bytes| f32::from_le_bytes(bytes)).collect()
}

/// What is wrong with a volume, none where nothing is.
fn fault(volume: &Volume, sample: &Value, wanted: &[f32]) -> Option<String> {
    let size: Vec<u64> = volume.size.iter().map(|&size| size as u64).collect();
    if sample["size"].as_array().unwrap().iter().map(|size| size.as_u64().unwrap()).ne(size.iter().copied()) {
        return Some(format!("size {size:?}"));
    }
    let tolerance = sample["tolerance"].as_f64().unwrap_or(0.0) as f32;
    let worst = volume.values.iter().zip(wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    if worst > tolerance {
        return Some(format!("values are {worst} apart"));
    }
    let rows = sample["affine"].as_array()?;
    let number = |row: usize, column: usize| rows[row][column].as_f64().unwrap();
    let affine = DMat4::from_cols_array_2d(&[0, 1, 2, 3].map(|column| [0, 1, 2, 3].map(|row| number(row, column))));
    let last = DVec3::from_array(volume.size.map(|size| size as f64 - 1.0));
    [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, last].into_iter().find_map(|at| {
        let (found, wanted) = (volume.world_from_index.transform_point3(at), affine.transform_point3(at));
        (found.distance(wanted) > 1e-3).then(|| format!("{at} is at {found}, not at {wanted}"))
    })
}

#[test]
fn volumes_of_other_programs_have_the_values_and_places_that_these_read() {
    let Some(folder) = WRITTEN.folder() else { return };
    let (mut wrong, mut count) = (Vec::new(), 0);
    for sample in samples(folder) {
        let [path, name] = ["path", "name"].map(|key| sample[key].as_str().unwrap());
        let wanted = floats(&folder.join(format!("{name}.f32")));
        match import::read_volume(&folder.join(path), &options(&sample)) {
            Ok(mut volume) => {
                wrong.extend(fault(&volume, &sample, &wanted).map(|fault| format!("{path}: {fault}")));
                count += 1;
                // One value or place that is another is told.
                volume.values[5] += 1.0 + 2.0 * sample["tolerance"].as_f64().unwrap_or(0.0) as f32;
                assert!(fault(&volume, &sample, &wanted).is_some(), "{path}");
            }
            Err(error) => wrong.push(format!("{path}: {error}")),
        }
    }
    assert!(wrong.is_empty() && count >= 100, "{count}: {}", wrong.join("\n"));
}

#[test]
fn volumes_of_other_programs_become_the_same_scenes_layer_by_layer() {
    let Some(folder) = WRITTEN.folder() else { return };
    let (out, again) = (folder.join("large.vxt"), folder.join("memory.vxt"));
    let whole = ["medium", "medium/DICOMDIR", "headless.dcm", "arrays.npz", "packed.npz"];
    // Of several data files, which are joined in memory.
    let joined = ["list.nhdr", "numbered.nhdr", "packed.nhdr"];
    let mut count = 0;
    for sample in samples(folder).iter().filter(|sample| sample["whole"] != true) {
        let path = sample["path"].as_str().unwrap();
        let options = options(sample);
        let large = import::open_large_volume(&folder.join(path), &options, 1).unwrap();
        let Some(mut large) = large else {
            let is_apart = ["par_", "colors", "aperio_"].iter().any(|start| path.starts_with(start));
            assert!(is_apart || whole.contains(&path) || joined.contains(&path), "{path} is not read layer by layer");
            continue;
        };
        let of_volume = VolumeOptions::default();
        large.voxelize_to_file(&of_volume, &Limits::default(), &out, &VoxelizeProgress::default()).unwrap();
        PackedScene::read(&out).unwrap().save(&out).unwrap();
        let volume = import::read_volume(&folder.join(path), &options).unwrap();
        let scene = voxtrace::volume::voxelize(&volume, &of_volume, &Limits::default()).unwrap();
        PackedScene::pack(&scene).unwrap().save(&again).unwrap();
        let bytes = std::fs::read(&out).unwrap();
        assert!(bytes == std::fs::read(&again).unwrap(), "{path}");
        // A volume with another value is another scene.
        let mut other = volume.clone();
        let middle = other.values.len() / 2;
        other.values[middle..].iter_mut().for_each(|value| *value = volume.statistics().lowest - 1.0);
        let scene = voxtrace::volume::voxelize(&other, &of_volume, &Limits::default()).unwrap();
        PackedScene::pack(&scene).unwrap().save(&again).unwrap();
        assert!(bytes != std::fs::read(&again).unwrap(), "{path}");
        count += 1;
    }
    assert!(count >= 25, "{count}");
}

#[test]
fn pages_of_colours_are_colours() {
    let Some(folder) = WRITTEN.folder() else { return };
    let names = [
        "colors",
        "colors_zstd",
        "colors_apart",
        "colors_plain_apart",
        "colors_tiles_apart",
        "colors_jpeg_2000",
        "aperio_rgb",
        "aperio_ycbcr",
    ];
    for name in names {
        // Luma and chroma were rounded before they were packed.
        let tolerance = if name == "aperio_ycbcr" { 2 } else { 0 };
        let name = format!("{name}.tif");
        let volume = import::read_volume(&folder.join(&name), &ImportOptions::default()).unwrap();
        let wanted = std::fs::read(folder.join(format!("{name}.colors"))).unwrap();
        let found = volume.colors.as_flattened();
        let worst = found.iter().zip(&wanted).map(|(found, wanted)| found.abs_diff(*wanted)).max().unwrap();
        assert!(found.len() == wanted.len() && worst <= tolerance, "{name}: {worst}");
    }
}
