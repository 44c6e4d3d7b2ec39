//! Hyperstacks: the pages of a TIFF that are channels, slices and time points. One time point is read, with all channels in their colours
//! or one alone.

use crate::import::images::hyperstack::Hyperstack;
use crate::import::images::planes::{Choice, Planes};
use crate::import::samples::channels::{composite, entry};
use crate::import::samples::{checked_size, place};
use glam::{DAffine3, DMat3, DVec3};
use std::path::Path;
use voxtrace_scene::scene::Unit;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, Limits};

/// A volume of the pages that were chosen.
pub(super) fn volume(path: &Path, found: Planes, choice: Choice, limits: &Limits) -> Result<Volume, ImportError> {
    let malformed = |what: String| ImportError::malformed(path, 0, what);
    let stack = found.stack.unwrap_or_default();
    let [channels, slices, times] = stack.sizes;
    if channels > found.planes.len() && choice.channel.is_none() {
        return Err(malformed(format!("{} pages of a hyperstack of {channels} channels", found.planes.len())));
    }
    let wanted: Vec<usize> = match choice.channel {
        Some(channel) => vec![channel as usize - 1],
        None => (0..channels).collect(),
    };
    let Some([width, height]) = found.planes.first().map(|plane| [plane.width, plane.height]) else {
        return Err(malformed("a hyperstack without the pages of its time point".into()));
    };
    let size = checked_size(path, 0, [width, height, slices].map(|size| size as u64), limits)?;
    // Each channel is asked for as pages come, not as a description claims.
    let mut pages: Vec<_> = found.places.iter().zip(found.planes).collect();
    pages.sort_by_key(|(place, _)| (place[0], place[1]));
    let all = wanted.len().saturating_mul(slices);
    let is_whole = pages.len() == all
        && pages.iter().enumerate().all(|(n, (place, _))| place[..2] == [wanted[n / slices], n % slices]);
    if !is_whole {
        let there = pages.len();
        return Err(malformed(format!("{there} pages of a hyperstack whose time point has {all}")));
    }
    let mut values: Vec<Vec<f32>> = Vec::new();
    for (n, (_, plane)) in pages.into_iter().enumerate() {
        if n % slices == 0 {
            values.push(Vec::new());
        }
        values.last_mut().into_iter().for_each(|channel| channel.extend_from_slice(&plane.values));
    }
    let mut volume = match &mut values[..] {
        [one] => Volume::new(size, std::mem::take(one)),
        all => composite(size, all, &stack.channels),
    };
    volume.notes.extend(entry(choice.time, times, "time point", "--time").map_err(malformed)?.1);
    if found.left_out > 0 {
        volume.notes.push(format!("{} pages of another size than the first are left out", found.left_out));
    }
    place_of(&mut volume, &stack);
    Ok(volume)
}

/// Puts a volume of a stack's slices where it says.
pub(super) fn place_of(volume: &mut Volume, stack: &Hyperstack) {
    let [x, y, z] = stack.spacing;
    if let (Some(x), Some(y)) = (x, y) {
        if z.is_none() && stack.sizes[1] > 1 {
            volume.notes.push("the distance of slices is not said: it is taken for that of pixels".into());
        }
        let spacing = DVec3::new(x, y, z.unwrap_or(x));
        place(volume, DAffine3::from_mat3(DMat3::from_diagonal(spacing)), spacing);
        volume.unit = if stack.has_unit { Unit::Millimetre } else { Unit::Voxel };
    }
}
