//! Grids that OpenVDB's own library has written, read by the importer; skipped where no Python has it.

mod written;

use std::path::Path;
use voxtrace::Volume;
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::import::{self, ImportOptions};
use voxtrace::mesh::UpAxis;
use voxtrace::volume::Preset;
use written::Written;

static WRITTEN: Written = Written::if_possible_by("openvdb.py", "pyopenvdb");

fn read(path: &Path) -> Volume {
    let options = ImportOptions { up: Some(UpAxis::Z), ..ImportOptions::default() };
    import::read_volume(path, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// What the script writes: a lump with a slope inside it, and a box.
fn wanted(at: IVec3) -> f32 {
    let is_box = at.cmpge(IVec3::new(16, -24, 8)).all() && at.cmple(IVec3::new(39, -9, 15)).all();
    let IVec3 { x, y, z } = at - IVec3::new(-7, 3, 5);
    let is_lump = (x - 20).pow(2) + (y - 16).pow(2) + (z - 9).pow(2) < 60;
    match (is_box, is_lump) {
        (true, _) => 2.5,
        (false, true) => 1.0 + z as f32 / 4.0 + y as f32 / 64.0,
        (false, false) => 0.0,
    }
}

fn places(low: IVec3, size: [usize; 3]) -> impl Iterator<Item = IVec3> {
    let [width, height, depth] = size.map(|edge| edge as i32);
    (0..depth).flat_map(move |z| (0..height).flat_map(move |y| (0..width).map(move |x| low + IVec3::new(x, y, z))))
}

#[test]
fn densities_of_the_library_have_their_values_and_places() {
    let Some(folder) = WRITTEN.folder() else { return };
    for name in ["density.vdb", "half.vdb"] {
        let volume = read(&folder.join(name));
        let low = IVec3::new(6, -24, 7);
        assert_eq!((volume.size, volume.suited), ([34, 51, 15], Some(Preset::Fog)), "{name}");
        for (at, value) in places(low, volume.size).zip(&volume.values) {
            // A half has eleven bits.
            let tolerance = if name == "half.vdb" { wanted(at) / 2048.0 } else { 0.0 };
            assert!((value - wanted(at)).abs() <= tolerance, "{name} {at}: {value}");
        }
        let place = volume.world_from_index.transform_point3(DVec3::new(1.0, 2.0, 3.0));
        let at = low.as_dvec3() + DVec3::new(1.0, 2.0, 3.0);
        let truth =
            if name == "half.vdb" { DVec3::new(10.0 + 0.5 * at.y, 20.0 + at.z, 30.0 + 2.0 * at.x) } else { 0.25 * at };
        assert!(place.distance(truth) < 1e-9, "{name}: {place} {truth}");
    }
}

#[test]
fn a_level_set_of_the_library_is_a_ball_and_preferred_to_other_grids() {
    let Some(folder) = WRITTEN.folder() else { return };
    let volume = read(&folder.join("ball.vdb"));
    assert_eq!(volume.suited, Some(Preset::Surface));
    assert!(
        volume.notes.iter().any(|note| note.contains("density") && note.contains("velocity")),
        "{:?}",
        volume.notes
    );
    for (at, value) in places(IVec3::ZERO, volume.size).zip(&volume.values) {
        let place = volume.world_from_index.transform_point3(at.as_dvec3());
        let depth = 12.0 - place.distance(DVec3::new(1.0, 2.0, 3.0));
        // The band is three voxels of half a unit wide.
        assert!((f64::from(*value) - depth.clamp(-1.5, 1.5)).abs() < 1e-4, "{place}: {value} {depth}");
    }
}

#[test]
fn truths_of_the_library_are_ones() {
    let Some(folder) = WRITTEN.folder() else { return };
    let volume = read(&folder.join("bool.vdb"));
    assert_eq!(volume.size, [34, 51, 15]);
    let mut count = 0;
    for (at, value) in places(IVec3::new(6, -24, 7), volume.size).zip(&volume.values) {
        assert_eq!(*value, if wanted(at) > 0.0 { 1.0 } else { 0.0 }, "{at}");
        count += usize::from(*value > 0.0);
    }
    assert!(count > 2000 && count < volume.values.len() / 2, "{count}");
}

#[test]
fn a_full_leaf_of_the_library_has_its_numbers_in_order() {
    let Some(folder) = WRITTEN.folder() else { return };
    let volume = read(&folder.join("leaf.vdb"));
    // The array has 0 at its first place, which is what is where nothing is.
    for (at, value) in places(IVec3::ZERO, volume.size).zip(&volume.values) {
        assert_eq!(*value, (at.x * 64 + at.y * 8 + at.z) as f32, "{at}");
    }
    assert_eq!(volume.size, [8, 8, 8]);
}
