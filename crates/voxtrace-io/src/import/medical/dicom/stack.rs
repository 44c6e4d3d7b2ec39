//! Slices become a lattice: sorted along their normal; leaning ones (a tilted gantry) are shifted upright, and where
//! distances differ, slices are mixed at even ones.

use super::{checked_size, unsupported};
use crate::import::reader::ImportOptions;
use crate::import::samples::channels::chosen;
use glam::{DAffine3, DMat3, DVec2, DVec3};
use std::path::Path;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, Limits};

/// One picture.
pub(super) struct Slice {
    /// The middle of the first pixel in the patient: left, posterior, superior, in millimetres.
    pub position: Option<DVec3>,
    /// In which columns and rows are counted.
    pub directions: (DVec3, DVec3),
    /// Number of the file in its series, and of the frame in the file.
    pub number: f64,
    pub frame: usize,
    /// Row by row.
    pub values: Vec<f32>,
}

/// What all slices have in common.
pub(super) struct Plane {
    pub columns: usize,
    pub rows: usize,
    /// In which columns and rows are counted.
    pub directions: (DVec3, DVec3),
    /// Between columns, and between rows.
    pub spacing: [f64; 2],
    /// Between slices, as the file says.
    pub distance: Option<f64>,
    /// Whether samples are labels, which nothing mixes.
    pub are_labels: bool,
}

/// Distances that differ by no more than this part of them are even.
const EVEN: f64 = 0.05;
/// Millimetres that pictures at one place may be apart.
const ONE_PLACE: f64 = 1e-4;
/// Pixels by which slices may lean without being shifted.
const UPRIGHT: f64 = 0.05;

/// A volume of the slices.
pub(super) fn volume(
    path: &Path,
    at: u64,
    plane: &Plane,
    mut slices: Vec<Slice>,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    let limits = &options.limits;
    let (x, y) = plane.directions;
    let normal = x.cross(y);
    let mut notes = Vec::new();
    let has_positions = slices.iter().all(|slice| slice.position.is_some());
    let depth = |slice: &Slice| slice.position.unwrap_or_default().dot(normal);
    slices.sort_by(|a, b| {
        let by_place = if has_positions { depth(a).total_cmp(&depth(b)) } else { std::cmp::Ordering::Equal };
        by_place.then(a.number.total_cmp(&b.number)).then(a.frame.cmp(&b.frame))
    });
    let count = slices.len();
    let mut places: Vec<Vec<Slice>> = Vec::new();
    for slice in slices {
        match places.last_mut().filter(|place| has_positions && depth(&slice) - depth(&place[0]) < ONE_PLACE) {
            Some(place) => place.push(slice),
            None => places.push(vec![slice]),
        }
    }
    // The last digits of positions do not say which of them came first.
    for place in &mut places {
        place.sort_by(|a, b| a.number.total_cmp(&b.number).then(a.frame.cmp(&b.frame)));
    }
    if !has_positions && count > 1 {
        notes.push("the pictures do not say where they lie: they are stacked by their numbers".into());
    }
    let most = if plane.are_labels { 1 } else { places.iter().map(Vec::len).max().unwrap_or(1) };
    let time = chosen(options.time, most, "time point").map_err(|what| unsupported(path, at, what))?;
    slices = if plane.are_labels {
        joined(places, &mut notes)
    } else {
        // Of several time points or echoes at one place one is kept.
        places.into_iter().filter_map(|place| place.into_iter().nth(time.unwrap_or(0))).collect()
    };
    if slices.len() < count && !plane.are_labels {
        let left_out = count - slices.len();
        let advice = if time.is_none() { format!("; --time 1 to {most} chooses") } else { String::new() };
        notes.push(format!("{left_out} pictures at the places of others are left out{advice}"));
    }
    let mut distance = plane.distance.unwrap_or(plane.spacing[0]);
    let mut origin = slices[0].position.unwrap_or_default();
    if has_positions && slices.len() > 1 {
        let depths: Vec<f64> = slices.iter().map(depth).collect();
        upright(&mut slices, plane, normal);
        let (values, found) = even(slices, &depths, plane, path, at, limits, &mut notes)?;
        slices = values;
        distance = found;
    }
    if !origin.is_finite() {
        origin = DVec3::ZERO;
    }
    let size = [plane.columns, plane.rows, slices.len()];
    checked_size(path, at, size.map(|size| size as u64), limits)?;
    let mut values = Vec::with_capacity(size.iter().product());
    for slice in slices {
        values.extend_from_slice(&slice.values);
    }
    let mut volume = Volume::new(size, values);
    let axes = DMat3::from_cols(x * plane.spacing[0], y * plane.spacing[1], normal * distance);
    volume.notes = notes;
    let spacing = DVec3::new(plane.spacing[0], plane.spacing[1], distance);
    crate::import::samples::place(&mut volume, DAffine3 { matrix3: axes, translation: origin }, spacing);
    Ok(volume)
}

/// Segments at one place become one picture, of numbers of segments.
fn joined(places: Vec<Vec<Slice>>, notes: &mut Vec<String>) -> Vec<Slice> {
    let mut shared = 0u64;
    let mut join = |mut below: Slice, above: Slice| {
        for (own, over) in below.values.iter_mut().zip(above.values).filter(|(_, over)| *over != 0.0) {
            shared += u64::from(*own != 0.0 && *own != over);
            *own = over;
        }
        below
    };
    let slices = places.into_iter().filter_map(|place| place.into_iter().reduce(&mut join)).collect();
    if shared > 0 {
        notes.push(format!("{shared} samples belong to several segments: the last of them is shown"));
    }
    slices
}

/// Shifts pictures in their plane so that each lies straight above the first.
fn upright(slices: &mut [Slice], plane: &Plane, normal: DVec3) {
    let (x, y) = plane.directions;
    let first = slices[0].position.unwrap_or_default();
    for slice in slices {
        let away = slice.position.unwrap_or_default() - first;
        let beside = away - normal * away.dot(normal);
        let shift = DVec2::new(beside.dot(x) / plane.spacing[0], beside.dot(y) / plane.spacing[1]);
        if shift.abs().max_element() > UPRIGHT && shift.is_finite() {
            slice.values = shifted(&slice.values, plane, shift);
        }
    }
}

/// A picture whose first pixel lies at `shift`, sampled where the pixels of one at 0 lie. What was not seen is as dark as
/// the darkest.
fn shifted(values: &[f32], plane: &Plane, shift: DVec2) -> Vec<f32> {
    let outside = values.iter().copied().fold(f32::INFINITY, f32::min);
    let (whole, part) = (shift.floor(), (shift - shift.floor()).as_vec2());
    let pixel = |column: f64, row: f64| {
        let is_inside = column >= 0.0 && row >= 0.0 && column < plane.columns as f64 && row < plane.rows as f64;
        if is_inside { values[row as usize * plane.columns + column as usize] } else { outside }
    };
    let mut result = Vec::with_capacity(values.len());
    for row in 0..plane.rows {
        for column in 0..plane.columns {
            let (column, row) = (column as f64 - whole.x, row as f64 - whole.y);
            let mix = |row: f64| {
                let (a, b) = (pixel(column - 1.0, row), pixel(column, row));
                b + (a - b) * part.x
            };
            let (a, b) = (mix(row - 1.0), mix(row));
            result.push(b + (a - b) * part.y);
        }
    }
    result
}

/// Slices at even distances, and the distance.
fn even(
    slices: Vec<Slice>,
    depths: &[f64],
    plane: &Plane,
    path: &Path,
    at: u64,
    limits: &Limits,
    notes: &mut Vec<String>,
) -> Result<(Vec<Slice>, f64), ImportError> {
    let mut steps: Vec<f64> = depths.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    let (least, most, middle) = (steps[0], steps[steps.len() - 1], steps[steps.len() / 2]);
    let whole = depths[depths.len() - 1] - depths[0];
    if most - least <= EVEN * middle {
        return Ok((slices, whole / steps.len() as f64));
    }
    // Segmentations leave out the slices in which nothing lies, wherever those are.
    let near = &steps[..steps.partition_point(|&step| step < 1.5 * least)];
    let middle = if plane.are_labels { near.iter().sum::<f64>() / near.len() as f64 } else { middle };
    let becomes = if plane.are_labels { "what lies between is empty" } else { "they are mixed" };
    notes.push(format!("slices lie {} to {} mm apart: {becomes} at {} mm", least as f32, most as f32, middle as f32));
    let count = (whole / middle).round() + 1.0;
    let count = if count.is_finite() && count < 1e9 { count as u64 } else { u64::MAX };
    checked_size(path, at, [plane.columns as u64, plane.rows as u64, count], limits)?;
    let mut result = Vec::with_capacity(count as usize);
    let mut below = 0;
    for n in 0..count {
        let depth = depths[0] + n as f64 * middle;
        while below + 2 < depths.len() && depths[below + 1] <= depth {
            below += 1;
        }
        let part = ((depth - depths[below]) / (depths[below + 1] - depths[below])).clamp(0.0, 1.0) as f32;
        let pairs = slices[below].values.iter().zip(&slices[below + 1].values);
        let values = if plane.are_labels {
            let nearest = if part < 0.5 { below } else { below + 1 };
            let is_near = (depths[nearest] - depth).abs() <= middle * 0.75;
            if is_near { slices[nearest].values.clone() } else { vec![0.0; slices[nearest].values.len()] }
        } else {
            pairs.map(|(&a, &b)| a + (b - a) * part).collect()
        };
        result.push(Slice { position: None, directions: plane.directions, number: 0.0, frame: n as usize, values });
    }
    Ok((result, middle))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLANE: Plane = Plane {
        columns: 4,
        rows: 3,
        directions: (DVec3::X, DVec3::Y),
        spacing: [0.5, 2.0],
        distance: None,
        are_labels: false,
    };

    fn slice(number: f64, position: Option<DVec3>, value: f32) -> Slice {
        Slice { position, directions: PLANE.directions, number, frame: 0, values: vec![value; 12] }
    }

    fn stacked(slices: Vec<Slice>) -> Volume {
        volume(Path::new("a.dcm"), 0, &PLANE, slices, &ImportOptions::default()).unwrap()
    }

    #[test]
    fn slices_are_sorted_along_their_normal_whatever_their_numbers() {
        let at = |z: f64| Some(DVec3::new(1.0, 2.0, z));
        let volume = stacked(vec![slice(1.0, at(7.0), 7.0), slice(2.0, at(1.0), 1.0), slice(3.0, at(4.0), 4.0)]);
        assert_eq!((volume.size, volume.spacing()), ([4, 3, 3], DVec3::new(0.5, 2.0, 3.0)));
        assert_eq!([volume.values[0], volume.values[12], volume.values[24]], [1.0, 4.0, 7.0]);
        assert_eq!(volume.world_from_index.translation, DVec3::new(1.0, 2.0, 1.0));
        assert!(volume.notes.is_empty());
    }

    #[test]
    fn a_missing_slice_is_mixed_from_its_neighbours_and_said() {
        let at = |z: f64| Some(DVec3::Z * z);
        let volume = stacked([0.0, 1.0, 2.0, 4.0, 5.0].map(|z| slice(z, at(z), z as f32)).into());
        assert_eq!(volume.size[2], 6);
        assert!((0..6).all(|z| volume.values[12 * z] == z as f32) && volume.notes[0].contains("1 to 2 mm"));
    }

    #[test]
    fn slices_at_one_place_or_without_one_are_told() {
        let twice = stacked(vec![
            slice(2.0, Some(DVec3::ZERO), 2.0),
            slice(1.0, Some(DVec3::ZERO), 1.0),
            slice(3.0, Some(DVec3::Z), 3.0),
        ]);
        assert_eq!((twice.size[2], twice.values[0], twice.notes.len()), (2, 1.0, 1));
        let still = stacked(vec![slice(1.0, Some(DVec3::ZERO), 1.0), slice(2.0, Some(DVec3::ZERO), 2.0)]);
        assert_eq!((still.size[2], still.values[0], still.notes.len()), (1, 1.0, 1));
        let nowhere = stacked(vec![slice(2.0, None, 2.0), slice(1.0, None, 1.0)]);
        assert_eq!((nowhere.size[2], nowhere.values[0], nowhere.notes.len()), (2, 1.0, 1));
    }

    #[test]
    fn of_several_pictures_at_one_place_the_time_point_that_is_asked_for_is_kept() {
        let slices = || {
            let all = [(0.0, 1.0), (1.0, 2.0), (0.0, 3.0), (1.0, 4.0)];
            all.map(|(z, number)| slice(number, Some(DVec3::Z * z), number as f32)).into()
        };
        let read = |time| {
            let options = ImportOptions { time, ..ImportOptions::default() };
            volume(Path::new("a.dcm"), 0, &PLANE, slices(), &options)
        };
        let values = |time| [0, 12].map(|at| read(time).unwrap().values[at]);
        assert_eq!([values(None), values(Some(1)), values(Some(2))], [[1.0, 2.0], [1.0, 2.0], [3.0, 4.0]]);
        assert!(read(None).unwrap().notes[0].contains("--time 1 to 2"));
        assert!(read(Some(3)).unwrap_err().to_string().contains("no time point 3: there are 2"));
    }

    #[test]
    fn segments_at_one_place_are_joined_and_what_lies_between_their_slices_is_empty() {
        let plane = Plane { are_labels: true, ..PLANE };
        let of_segment = |z: f64, segment: f32, at: usize| {
            let mut slice = slice(0.0, Some(DVec3::Z * z), 0.0);
            slice.values[at] = segment;
            slice
        };
        let slices = vec![
            of_segment(0.0, 1.0, 0),
            of_segment(20.0, 1.0, 0),
            of_segment(25.0, 1.0, 0),
            of_segment(20.0, 3.0, 5),
            of_segment(25.0, 3.0, 0),
        ];
        let volume = volume(Path::new("a.dcm"), 0, &plane, slices, &ImportOptions::default()).unwrap();
        assert_eq!((volume.size, volume.spacing().z), ([4, 3, 6], 5.0));
        let labels: Vec<f32> = (0..6).map(|z| volume.values[12 * z]).collect();
        assert_eq!((labels, volume.values[12 * 4 + 5]), (vec![1.0, 0.0, 0.0, 0.0, 1.0, 3.0], 3.0));
        assert!(volume.notes[0].contains("1 samples belong to several segments"), "{:?}", volume.notes);
    }

    #[test]
    fn a_tilted_gantry_is_set_upright() {
        // A column of light that stands straight in the patient.
        let slices = (0..3).map(|n| {
            let mut values = vec![0.0; 12];
            values[6 - n] = 1.0;
            let position = Some(DVec3::new(n as f64 * 0.5, 0.0, n as f64));
            Slice { position, directions: PLANE.directions, number: n as f64, frame: 0, values }
        });
        let volume = stacked(slices.collect());
        assert!((0..3).all(|z| volume.values[12 * z + 6] == 1.0), "{:?}", volume.values);
        assert_eq!(volume.values.iter().sum::<f32>(), 3.0);
        assert_eq!(volume.world_from_index.matrix3.z_axis, DVec3::Z);
    }
}
