//! Which entry of the axes beyond space is read: a time point, and a channel or all of them in their colours.

use super::Store;
use super::chunks;
use super::multiscale::Level;
use crate::import::reader::ImportOptions;
use crate::import::samples::channels::{self, chosen, composite};
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::volume::Volume;

/// Most channels that are shown together.
const MOST_CHANNELS: u64 = 32;

/// Reads a level as the options say.
pub(super) fn read(store: &Store, level: &Level, options: &ImportOptions) -> Result<Volume, ImportError> {
    let array = &level.array;
    let unsupported = |what| store.unsupported(&array.folder, what);
    let length = |axis: usize| usize::try_from(array.shape[axis]).unwrap_or(usize::MAX);
    let (mut entry, mut notes) = (vec![0; array.shape.len()], Vec::new());
    // An axis that nobody names is one of which either option chooses.
    let is_space = |axis: &usize| level.axes.contains(&Some(*axis));
    let is_known = |axis: &usize| is_space(axis) || level.time == Some(*axis) || level.channel == Some(*axis);
    let mut unknown = (0..array.shape.len()).filter(|axis| !is_known(axis));
    let time = level.time.or_else(|| unknown.next());
    let is_named = level.time.is_some() || time.is_none();
    let number =
        if is_named { options.time } else { options.time.or(options.channel.filter(|_| level.channel.is_none())) };
    let count = time.map_or(1, length);
    let (place, note) = channels::entry(number, count, "time point", "--time").map_err(unsupported)?;
    if let Some(axis) = time {
        entry[axis] = place as u64;
        notes.extend(note);
    }
    let others: u64 = unknown.map(|axis| array.shape[axis]).fold(1, u64::saturating_mul);
    if others > 1 {
        notes.push(format!("the first of {others} entries of other axes is read"));
    }
    let mut read = |channel: Option<usize>| {
        if let (Some(axis), Some(channel)) = (level.channel, channel) {
            entry[axis] = channel as u64;
        }
        chunks::read(store, level, &entry, &options.limits)
    };
    let size = level.size().map(|size| size as usize);
    let count = level.channel.map_or(1, length);
    let number = if level.channel.is_some() || is_named { options.channel } else { None };
    let mut volume = match chosen(number, count, "channel").map_err(unsupported)? {
        None if (2..=MOST_CHANNELS).contains(&(count as u64)) => {
            let all: Result<Vec<_>, _> = (0..count).map(|channel| read(Some(channel))).collect();
            composite(size, &all?, &level.channels)
        }
        chosen => {
            if chosen.is_none() && count > 1 {
                notes.push(format!("the first of {count} channels is read; --channel chooses another"));
            }
            Volume::new(size, read(chosen)?)
        }
    };
    volume.notes.splice(0..0, notes);
    Ok(volume)
}
