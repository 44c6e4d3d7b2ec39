//! Labels and a second scan over a volume, on lattices of their own.

use super::*;
use crate::limits::Limits;
use crate::volume::{Ramp, VolumeOptions, voxelize};
use glam::{DMat3, Vec3};
use voxtrace_scene::VoxelGrid;

const SIZE: [usize; 3] = [13, 9, 7];
const RED: Vec3 = Vec3::X;

/// A scan whose lower half is seen, 2 mm between its samples, somewhere.
fn scan() -> Volume {
    let values = (0..13 * 9 * 7).map(|n| if n / (13 * 9) < 3 { 5.0 } else { -1.0 }).collect();
    let world_from_index =
        DAffine3 { matrix3: DMat3::from_diagonal(DVec3::splat(2.0)), translation: DVec3::new(40.0, -7.0, 3.0) };
    Volume { name: "scan".into(), world_from_index, unit: Unit::Millimetre, ..Volume::new(SIZE, values) }
}

/// Labels 1 and 2 in a diagonal pattern of large cells, on the lattice of the scan.
fn label_at(at: IVec3) -> i32 {
    ((at.x + at.y) / 4 + at.z / 3) % 3
}

fn labels() -> Volume {
    let at = |n: usize| IVec3::new((n % 13) as i32, (n / 13 % 9) as i32, (n / (13 * 9)) as i32);
    let values = (0..13 * 9 * 7).map(|n| label_at(at(n)) as f32).collect();
    Volume { name: "labels".into(), values, ..scan() }
}

fn shown(overlays: Vec<Overlay>, shell: bool) -> Result<(VoxelGrid, Vec<Material>), VolumeError> {
    let ramp = Ramp::Absolute { low: 0.0, high: 9.0, stops: vec![(0.0, Vec3::ONE)] };
    let transfer = Some(Transfer::new("scan", ramp));
    let options = VolumeOptions { transfer, shell, overlays, ..VolumeOptions::default() };
    let scene = voxelize(&scan(), &options, &Limits::default())?;
    Ok(((*scene.grids[0]).clone(), scene.materials))
}

fn over(volume: Volume, opacity: f32) -> Overlay {
    let look = |color| LabelColor { color, opacity };
    let ramp = Ramp::Labels([(1, look(RED)), (2, Vec3::Z.into())].into());
    Overlay { volume: volume.into(), transfer: Transfer::new("labels", ramp) }
}

/// The colour and opacity that each voxel has to have, white where only the scan is seen.
fn wanted(at: IVec3, opacity: f32) -> Option<Material> {
    let below = (at.z < 3).then_some(LabelColor::from(Vec3::ONE));
    let look = match label_at(at) {
        1 => Some(LabelColor { color: RED, opacity }),
        2 => Some(Vec3::Z.into()),
        _ => None,
    };
    let both = match (look, below) {
        (Some(look), Some(below)) => Some(look.over(below)),
        (look, below) => look.or(below),
    };
    both.map(LabelColor::material)
}

fn voxels() -> impl Iterator<Item = IVec3> {
    (0..7).flat_map(|z| (0..9).flat_map(move |y| (0..13).map(move |x| IVec3::new(x, y, z))))
}

fn differences(found: &(VoxelGrid, Vec<Material>), wanted: impl Fn(IVec3) -> Option<Material>) -> usize {
    let differs = |at: &IVec3| found.0.get(*at).map(|place| found.1[usize::from(place)]) != wanted(*at);
    voxels().filter(differs).count()
}

#[test]
fn labels_are_seen_over_the_scan_and_where_it_is_transparent() {
    for opacity in [1.0, 0.25] {
        let found = shown(vec![over(labels(), opacity)], false).unwrap();
        assert_eq!(differences(&found, |at| wanted(at, opacity)), 0, "{opacity}");
        assert!(differences(&found, |at| wanted(at - IVec3::X, opacity)) > 20, "a shift by a sample is noticed");
        assert!(differences(&found, |at| wanted(at, 0.75)) > 20, "another opacity is noticed");
    }
}

#[test]
fn a_label_map_finds_its_place_whatever_its_lattice() {
    // Half as many samples, turned about, reaching beyond the scan; the place is the same.
    let turn = DMat3::from_cols(DVec3::NEG_Y, DVec3::X, DVec3::Z);
    let coarse = |at: DVec3| at.floor().as_ivec3();
    let size = [20, 20, 20];
    let own = DAffine3 { matrix3: turn * 1.0, translation: DVec3::new(38.4, 16.0, 2.4) };
    let scan_from_own = scan().world_from_index.inverse() * own;
    let at = |n: usize| DVec3::new((n % 20) as f64, (n / 20 % 20) as f64, (n / 400) as f64);
    let value = |n| {
        let place = coarse(scan_from_own.transform_point3(at(n)) + 0.5);
        if place.cmpge(IVec3::ZERO).all() { label_at(place) as f32 } else { 0.0 }
    };
    let values = (0..8000).map(value).collect();
    for (unit, factor) in [(Unit::Millimetre, 1.0), (Unit::Metre, 1e-3)] {
        let world_from_index = DAffine3::from_scale(DVec3::splat(factor)) * own;
        let volume = Volume { world_from_index, unit, name: "fine".into(), ..Volume::new(size, Vec::clone(&values)) };
        let found = shown(vec![over(volume, 1.0)], false).unwrap();
        let inside = |at: IVec3| {
            let index = own.inverse().transform_point3(scan().world_from_index.transform_point3(at.as_dvec3()));
            index.cmpge(DVec3::splat(-0.5)).all() && index.cmplt(DVec3::splat(19.5)).all()
        };
        let below = |at: IVec3| (at.z < 3).then(|| LabelColor::from(Vec3::ONE).material());
        let all = |at: IVec3| if inside(at) { wanted(at, 1.0) } else { below(at) };
        assert_eq!(differences(&found, all), 0, "{unit:?}");
        assert!(differences(&found, below) > 50);
    }
}

#[test]
fn what_lies_elsewhere_or_says_no_place_or_shows_nothing_is_refused_by_name() {
    let said = |volume: Volume| shown(vec![over(volume, 1.0)], true).unwrap_err().to_string();
    let mut away = labels();
    away.world_from_index.translation.x += 26.0;
    assert_eq!(said(away.clone()), "labels lies beside scan: from 65,-8,2 to 91,10,16, not from 39,-8,2 to 65,10,16");
    away.world_from_index.translation.x -= 1.5;
    assert!(shown(vec![over(away, 1.0)], true).is_ok(), "one sample over the edge is enough");
    let no_place = Volume { unit: Unit::Voxel, ..Volume::new([5, 9, 7], vec![1.0; 5 * 9 * 7]) };
    let text = said(Volume { name: "bare".into(), ..no_place });
    assert_eq!(text, "bare does not say where it lies, and its 5 x 9 x 7 samples are not the 13 x 9 x 7 of scan");
    let same = Volume { unit: Unit::Voxel, world_from_index: DAffine3::IDENTITY, ..labels() };
    assert_eq!(differences(&shown(vec![over(same, 1.0)], false).unwrap(), |at| wanted(at, 1.0)), 0);
    let empty = Volume { values: vec![3.0; 13 * 9 * 7], ..labels() };
    assert_eq!(said(empty), "nothing of labels is to be seen within scan: labels shows 2 labels");
}

#[test]
fn a_second_scan_is_interpolated_and_what_is_transparent_keeps_its_inside() {
    // A slope along x, every second sample: between two samples lies their mean.
    let values = (0..7 * 9 * 7).map(|n| (n % 7) as f32 * 2.0).collect();
    let scale = DMat3::from_diagonal(DVec3::new(4.0, 2.0, 2.0));
    let place = DAffine3 { matrix3: scale, ..scan().world_from_index };
    let second = Volume { world_from_index: place, size: [7, 9, 7], values, ..scan() };
    let layer = |low: f32, opacity: f32| {
        let ramp = Ramp::Absolute { low, high: f32::MAX, stops: vec![(0.0, RED)] };
        let transfer = Transfer { opacity, ..Transfer::new("second", ramp) };
        vec![Overlay { volume: second.clone().into(), transfer }]
    };
    let all = |low: i32, opacity: f32| {
        move |at: IVec3| {
            let below = (at.z < 3).then_some(LabelColor::from(Vec3::ONE));
            let own = (at.x >= low).then_some(LabelColor { color: RED, opacity });
            own.map(|own| below.map_or(own, |below| own.over(below))).or(below).map(LabelColor::material)
        }
    };
    let found = shown(layer(5.0, 0.5), true).unwrap();
    assert_eq!(differences(&found, all(5, 0.5)), 0);
    assert!(differences(&found, all(6, 0.5)) > 0 && differences(&found, all(4, 0.5)) > 0);
    // Opaque ones lose what no ray reaches.
    let found = shown(layer(-1.0, 1.0), true).unwrap();
    assert_eq!(differences(&found, all(-1, 1.0)), 11 * 7 * 5);
}
