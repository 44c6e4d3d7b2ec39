//! Samples of several numbers each, and the time points of a file, one behind the other: read as a reader's options say.

use super::channels::{entry, of_components};
use super::{Layout, checked_size};
use crate::import::reader::{ImportOptions, Sample};
use crate::import::source::input::Input;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Reads samples of several numbers each, as a reader's options say: numbers that lie side by side, or in so many volumes one behind the other.
pub(crate) fn read(
    input: &mut Input,
    (layout, planes): (Layout, usize),
    is_text: bool,
    options: &ImportOptions,
) -> Result<Volume, ImportError> {
    let (path, at) = (input.path(), input.offset());
    let [x, y, z] = layout.size.map(|size| size as u64);
    let across = x.saturating_mul(layout.components as u64);
    let high = z.saturating_mul(planes as u64);
    let all = Layout { components: 1, size: checked_size(path, at, [across, y, high], &options.limits)?, ..layout };
    let numbers = if is_text { all.read_text(input)? } else { all.read(input)? };
    let (numbers, components) =
        if planes > 1 { (side_by_side(&numbers, planes), planes) } else { (numbers, layout.components) };
    let full = match layout.sample {
        Sample::U8 => Some(255.0),
        Sample::U16 => Some(65_535.0),
        _ => None,
    };
    of_components(layout.size, numbers, components, full, options.channel)
        .map_err(|what| ImportError::at(path, at, ImportErrorKind::Unsupported(what)))
}

/// The numbers of each place one after the other, from planes of them.
fn side_by_side(numbers: &[f32], planes: usize) -> Vec<f32> {
    let count = numbers.len() / planes;
    (0..count).flat_map(|place| (0..planes).map(move |plane| numbers[plane * count + place])).collect()
}

/// Goes over the volumes before the time point that is asked for, of `count`. Returns what there is to say about it.
pub(crate) fn skip_to_time(
    input: &mut Input,
    layout: &Layout,
    count: u64,
    is_text: bool,
    options: &ImportOptions,
) -> Result<Option<String>, ImportError> {
    let (path, at) = (input.path(), input.offset());
    let unsupported = |what: String| ImportError::at(path, at, ImportErrorKind::Unsupported(what));
    let count = usize::try_from(count).unwrap_or(usize::MAX);
    let (place, note) = entry(options.time, count, "time point", "--time").map_err(unsupported)?;
    if place > 0 && is_text {
        return Err(unsupported("time points of samples that are text".into()));
    }
    skip_volumes(input, layout, place as u64)?;
    Ok(note)
}

/// Goes over so many volumes.
pub(crate) fn skip_volumes(input: &mut Input, layout: &Layout, count: u64) -> Result<(), ImportError> {
    input.skip(layout.bytes().saturating_mul(count), "the volumes before")
}
