//! Slices become a lattice: sorted along their normal; leaning ones (a tilted gantry) are shifted upright, and where
//! distances differ, slices are mixed at even ones.

use super::checked_size;
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
}

/// Distances that differ by no more than this part of them are even.
const EVEN: f64 = 0.05;
/// Pixels by which slices may lean without being shifted.
const UPRIGHT: f64 = 0.05;

/// A volume of the slices.
pub(super) fn volume(
    path: &Path,
    at: u64,
    plane: &Plane,
    mut slices: Vec<Slice>,
    limits: &Limits,
) -> Result<Volume, ImportError> {
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
    if has_positions {
        // Of several time points or echoes at one place the first is kept.
        slices.dedup_by(|b, a| depth(b) - depth(a) < 1e-4);
        if slices.len() < count {
            notes.push(format!("{} pictures at the places of others are left out", count - slices.len()));
        }
    } else if count > 1 {
        notes.push("the pictures do not say where they lie: they are stacked by their numbers".into());
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
    notes.push(format!(
        "slices lie {} to {} mm apart: they are mixed at {} mm",
        least as f32, most as f32, middle as f32
    ));
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
        let values = pairs.map(|(&a, &b)| a + (b - a) * part).collect();
        result.push(Slice { position: None, directions: plane.directions, number: 0.0, frame: n as usize, values });
    }
    Ok((result, middle))
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLANE: Plane =
        Plane { columns: 4, rows: 3, directions: (DVec3::X, DVec3::Y), spacing: [0.5, 2.0], distance: None };

    fn slice(number: f64, position: Option<DVec3>, value: f32) -> Slice {
        Slice { position, directions: PLANE.directions, number, frame: 0, values: vec![value; 12] }
    }

    fn stacked(slices: Vec<Slice>) -> Volume {
        volume(Path::new("a.dcm"), 0, &PLANE, slices, &Limits::default()).unwrap()
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
