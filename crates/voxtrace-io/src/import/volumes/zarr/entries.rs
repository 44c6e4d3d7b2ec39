//! Which entry of the axes beyond space is read: a time point, and a channel or all of them in their colours.

use super::Store;
use super::chunks::{self, Lattice};
use super::multiscale::Level;
use crate::import::reader::ImportOptions;
use crate::import::samples::channels::{self, chosen, composite};
use voxtrace_voxelize::ImportError;
use voxtrace_voxelize::volume::Volume;

/// Most channels that are shown together.
const MOST_CHANNELS: u64 = 32;

/// Which entry is read, and what there is to say about it.
struct Entry {
    /// A place along all axes, of which those of space do not matter.
    at: Vec<u64>,
    notes: Vec<String>,
    /// How many channels there are, and the one that is asked for, from 0 on.
    channels: usize,
    channel: Option<usize>,
}

impl Entry {
    fn of(store: &Store, level: &Level, options: &ImportOptions) -> Result<Self, ImportError> {
        let array = &level.array;
        let unsupported = |what| store.unsupported(&array.folder, what);
        let length = |axis: usize| usize::try_from(array.shape[axis]).unwrap_or(usize::MAX);
        let (mut at, mut notes) = (vec![0; array.shape.len()], Vec::new());
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
            at[axis] = place as u64;
            notes.extend(note);
        }
        let others: u64 = unknown.map(|axis| array.shape[axis]).fold(1, u64::saturating_mul);
        if others > 1 {
            notes.push(format!("the first of {others} entries of other axes is read"));
        }
        let channels = level.channel.map_or(1, length);
        let number = if level.channel.is_some() || is_named { options.channel } else { None };
        let channel = chosen(number, channels, "channel").map_err(unsupported)?;
        Ok(Self { at, notes, channels, channel })
    }

    /// Whether all channels are shown, in their colours.
    fn is_composite(&self) -> bool {
        self.channel.is_none() && (2..=MOST_CHANNELS).contains(&(self.channels as u64))
    }

    /// Chooses one channel, and says which.
    fn settle(&mut self, level: &Level) {
        if self.channel.is_none() && self.channels > 1 {
            self.notes.push(format!("the first of {} channels is read; --channel chooses another", self.channels));
        }
        self.choose(level, self.channel.unwrap_or(0));
    }

    fn choose(&mut self, level: &Level, channel: usize) {
        if let Some(axis) = level.channel {
            self.at[axis] = channel as u64;
        }
    }
}

/// Reads a level as the options say.
pub(super) fn read(store: &Store, level: &Level, options: &ImportOptions) -> Result<Volume, ImportError> {
    let mut entry = Entry::of(store, level, options)?;
    let size = level.size().map(|size| size as usize);
    let mut volume = if entry.is_composite() {
        let mut all = Vec::new();
        for channel in 0..entry.channels {
            entry.choose(level, channel);
            all.push(chunks::read(store, level, &entry.at, &options.limits)?);
        }
        composite(size, &all, &level.channels)
    } else {
        entry.settle(level);
        Volume::new(size, chunks::read(store, level, &entry.at, &options.limits)?)
    };
    volume.notes.splice(0..0, entry.notes);
    Ok(volume)
}

/// Where the samples of a level lie that are read layer by layer, and what there is to say; `None` where several channels are shown.
pub(super) fn large(
    store: &Store,
    level: &Level,
    options: &ImportOptions,
) -> Result<Option<(Lattice, Vec<String>)>, ImportError> {
    let mut entry = Entry::of(store, level, options)?;
    if entry.is_composite() {
        return Ok(None);
    }
    entry.settle(level);
    Ok(Some((Lattice::of(store, level, &entry.at, &options.limits)?, entry.notes)))
}
