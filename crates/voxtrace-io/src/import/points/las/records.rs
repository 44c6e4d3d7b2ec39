//! From the bytes of points, formats 0 to 10, to a cloud, on all threads: each run of points has its places in the arrays.

use super::header::{Header, array};
use crate::import::reader::ClassSet;
use crate::import::reader::NotShown;
use crate::import::reader::local_origin::LocalOrigin;
use glam::{DVec3, IVec3, Vec3};
use rayon::prelude::*;
use std::ops::Range;
use voxtrace_voxelize::points::source::TileFacts;
use voxtrace_voxelize::points::{Attributes, PointCloud};

/// Points converted by one task.
const TASK: usize = 1 << 14;

/// Points so far.
pub(super) struct Records<'a> {
    header: &'a Header,
    /// Where a point has its colour.
    color_at: Option<usize>,
    /// What all points have that says something, if they were read before.
    known: Option<Seen>,
    local_origin: LocalOrigin,
    /// Points, and behind those that are kept room for more.
    cloud: PointCloud,
    kept: usize,
    seen: Seen,
    left_out: LeftOut,
    /// Points that were kept, those included that were forgotten.
    chosen: u64,
    /// Points whose colours were taken for bytes, since none of their run is larger.
    byte_colors: Vec<Range<usize>>,
}

/// What there is that says something, in all points so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Seen {
    largest_color: u16,
    intensities: bool,
    classes: bool,
}

impl Seen {
    pub fn attributes(self) -> Attributes {
        Attributes { colors: self.largest_color > 0, intensities: self.intensities, classes: self.classes }
    }

    /// All that there may be.
    const ALL: Self = Self { largest_color: u16::MAX, intensities: true, classes: true };

    fn join(&mut self, other: Self) {
        self.largest_color = self.largest_color.max(other.largest_color);
        self.intensities |= other.intensities;
        self.classes |= other.classes;
    }

    /// Whether colours are bytes: many writers keep those where there are 16 bits.
    fn has_byte_colors(self) -> bool {
        self.largest_color <= 255
    }
}

/// The byte of a colour of 16 bits.
fn byte_of(value: u16) -> u8 {
    ((u32::from(value) + 128) / 257) as u8
}

/// Points that were not kept.
#[derive(Clone, Copy, Default)]
pub(super) struct LeftOut {
    withheld: u64,
    infinite: u64,
    /// Those that nobody asked for, and the classes of them.
    pub not_chosen: u64,
    pub classes: ClassSet,
    /// Whether each point has a packet of a waveform.
    has_waveforms: bool,
}

impl LeftOut {
    pub fn join(&mut self, other: Self) {
        self.withheld += other.withheld;
        self.infinite += other.infinite;
        self.not_chosen += other.not_chosen;
        self.classes.join(other.classes);
        self.has_waveforms |= other.has_waveforms;
    }

    /// What was left out that somebody may have wanted.
    pub fn notes(self) -> Vec<String> {
        let counts = [(self.withheld, "that the file withholds"), (self.infinite, "that are not finite")];
        let counts = counts.iter().filter(|(count, _)| *count > 0);
        let mut notes: Vec<String> =
            counts.map(|(count, which)| format!("{count} points {which} are left out")).collect();
        let mut parts = NotShown::default();
        if self.has_waveforms {
            parts.name("waveforms");
        }
        notes.extend(parts.note());
        notes
    }
}

/// What was found in a file, for whoever has not read it.
pub(super) fn facts_of(seen: Seen, left_out: LeftOut, chosen: u64) -> TileFacts {
    TileFacts {
        chosen,
        withheld: left_out.withheld,
        infinite: left_out.infinite,
        not_chosen: left_out.not_chosen,
        classes_not_chosen: left_out.classes.words(),
        largest_color: seen.largest_color,
        has_intensities: seen.intensities.into(),
        has_classes: seen.classes.into(),
        has_waveforms: left_out.has_waveforms.into(),
        unused: [0; 3],
    }
}

/// What was found in a file that somebody else has read.
pub(super) fn found_by(facts: &TileFacts) -> (Seen, LeftOut) {
    let seen = Seen {
        largest_color: facts.largest_color,
        intensities: facts.has_intensities > 0,
        classes: facts.has_classes > 0,
    };
    let left_out = LeftOut {
        withheld: facts.withheld,
        infinite: facts.infinite,
        not_chosen: facts.not_chosen,
        classes: ClassSet::of_words(facts.classes_not_chosen),
        has_waveforms: facts.has_waveforms > 0,
    };
    (seen, left_out)
}

/// Places for a run of points.
pub(super) struct Part<'a> {
    header: &'a Header,
    color_at: Option<usize>,
    known: Option<Seen>,
    offset: DVec3,
    positions: &'a mut [Vec3],
    intensities: &'a mut [u16],
    classes: &'a mut [u8],
    colors: &'a mut [[u8; 3]],
}

/// What was found in a run of points.
#[derive(Clone, Copy, Default)]
pub(super) struct Found {
    points: usize,
    /// Those of them that are kept, from the front of their places on.
    kept: usize,
    seen: Seen,
    left_out: LeftOut,
    has_byte_colors: bool,
}

impl Header {
    /// Whether the file withholds a point, and its class.
    fn class(&self, record: &[u8]) -> (bool, u8) {
        let is_new = self.format >= 6;
        if is_new { (record[15] & 4 != 0, record[16]) } else { (record[15] & 0x80 != 0, record[15] & 0x1f) }
    }

    fn position(&self, record: &[u8]) -> DVec3 {
        IVec3::from_array([0, 4, 8].map(|at| i32::from_le_bytes(array(record, at)))).as_dvec3() * self.scale
            + self.offset
    }
}

impl Header {
    /// Whether a point is among those that are asked for.
    fn is_chosen(&self, class: u8, position: DVec3) -> bool {
        self.filter.classes.is_none_or(|classes| classes.contains(class))
            && self.filter.bounds.is_none_or(|bounds| bounds.contains(position))
    }
}

impl<'a> Records<'a> {
    /// For the points of a file. `origin` is what positions are relative to, where other files have decided.
    pub fn new(header: &'a Header, known: Option<Seen>, origin: Option<DVec3>) -> Self {
        let color_at = match header.format {
            2 => Some(20),
            3 | 5 => Some(28),
            7 | 8 | 10 => Some(30),
            _ => None,
        };
        Self {
            header,
            color_at,
            known,
            local_origin: LocalOrigin::at(origin),
            cloud: PointCloud::default(),
            kept: 0,
            seen: Seen::default(),
            left_out: LeftOut::default(),
            chosen: 0,
            byte_colors: Vec::new(),
        }
    }

    /// Makes room for the first points, so many.
    ///
    /// # Errors
    /// If there is no memory for them.
    pub fn make_room(&mut self, count: u64) -> Result<(), String> {
        let none = |()| "no memory for so many points".to_owned();
        let count = usize::try_from(count).map_err(|_| none(()))?;
        let colored = if self.color_at.is_some() { count } else { 0 };
        // Pages come from the system when they are written, on whichever thread does so.
        self.cloud.positions = bytemuck::allocation::try_zeroed_vec(count).map_err(none)?;
        self.cloud.intensities = bytemuck::allocation::try_zeroed_vec(count).map_err(none)?;
        self.cloud.classes = bytemuck::allocation::try_zeroed_vec(count).map_err(none)?;
        self.cloud.colors = bytemuck::allocation::try_zeroed_vec(colored).map_err(none)?;
        Ok(())
    }

    /// Adds points, whose bytes are whole.
    pub fn add(&mut self, bytes: &[u8]) {
        let size = usize::from(self.header.record_size);
        self.look_for_offset(bytes);
        let count = bytes.len() / size;
        let parts = self.places((0..count).step_by(TASK).map(|start| TASK.min(count - start)));
        let found: Vec<Found> = bytes.par_chunks(TASK * size).zip(parts).map(|(run, part)| part.fill(run)).collect();
        self.settle(&found);
    }

    /// Whether it is known what positions are relative to: the first point of all that is kept decides.
    pub fn has_offset(&self) -> bool {
        self.local_origin.is_set()
    }

    /// Looks among points for the first one that is kept: what is nowhere is not.
    pub fn look_for_offset(&mut self, bytes: &[u8]) {
        let mut records = bytes.chunks_exact(usize::from(self.header.record_size));
        if !self.has_offset()
            && let Some(first) = records.find(|record| {
                let ((is_withheld, class), position) = (self.header.class(record), self.header.position(record));
                !is_withheld && position.is_finite() && self.header.is_chosen(class, position)
            })
        {
            self.local_origin.localized(self.header.position(first));
        }
    }

    /// Places for runs of so many points, behind those that are kept. What is found in them wants to be settled.
    pub fn places(&mut self, counts: impl Iterator<Item = usize> + Clone) -> Vec<Part<'_>> {
        fn run<'a, T>(rest: &mut &'a mut [T], count: usize) -> &'a mut [T] {
            rest.split_off_mut(..count.min(rest.len())).unwrap_or_default()
        }
        let (start, end) = (self.kept, self.kept + counts.clone().sum::<usize>());
        let cloud = &mut self.cloud;
        cloud.positions.resize(end.max(cloud.positions.len()), Vec3::ZERO);
        cloud.intensities.resize(end.max(cloud.intensities.len()), 0);
        cloud.classes.resize(end.max(cloud.classes.len()), 0);
        if self.color_at.is_some() {
            cloud.colors.resize(end.max(cloud.colors.len()), [0; 3]);
        }
        let (header, color_at, known, offset) =
            (self.header, self.color_at, self.known, self.local_origin.raw_offset());
        let (mut positions, mut intensities) = (&mut cloud.positions[start..], &mut cloud.intensities[start..]);
        let (mut classes, mut colors) =
            (&mut cloud.classes[start..], cloud.colors.get_mut(start..).unwrap_or_default());
        let part = |count| Part {
            header,
            color_at,
            known,
            offset,
            positions: run(&mut positions, count),
            intensities: run(&mut intensities, count),
            classes: run(&mut classes, count),
            colors: run(&mut colors, count),
        };
        counts.map(part).collect()
    }

    /// Counts what was found in the last places, and closes the gaps behind runs of which not every point is kept.
    pub fn settle(&mut self, found: &[Found]) {
        let mut from = self.kept;
        for run in found {
            let (to, kept) = (self.kept, from..from + run.kept);
            if from != to {
                self.cloud.positions.copy_within(kept.clone(), to);
                self.cloud.intensities.copy_within(kept.clone(), to);
                self.cloud.classes.copy_within(kept.clone(), to);
                if self.color_at.is_some() {
                    self.cloud.colors.copy_within(kept, to);
                }
            }
            from += run.points;
            self.kept += run.kept;
            self.seen.join(run.seen);
            self.left_out.join(run.left_out);
            self.chosen += run.kept as u64;
            if run.has_byte_colors {
                self.byte_colors.push(to..self.kept);
            }
        }
    }

    /// The cloud. What is the same everywhere says nothing and is left out.
    pub fn finish(mut self) -> PointCloud {
        if !self.seen.has_byte_colors() {
            // The darkest runs of points with 16 bits looked like bytes.
            for run in std::mem::take(&mut self.byte_colors) {
                let colors = self.cloud.colors[run].as_flattened_mut();
                colors.iter_mut().for_each(|value| *value = byte_of((*value).into()));
            }
        }
        self.trim(self.seen);
        self.cloud
    }

    /// Cuts off the room behind the points, and all of what says nothing.
    fn trim(&mut self, seen: Seen) {
        let Attributes { colors, intensities, classes } = seen.attributes();
        self.cloud.positions.truncate(self.kept);
        self.cloud.intensities.truncate(if intensities { self.kept } else { 0 });
        self.cloud.classes.truncate(if classes { self.kept } else { 0 });
        self.cloud.colors.truncate(if colors { self.kept } else { 0 });
        self.cloud.offset = self.local_origin.offset();
    }

    /// What was left out.
    pub fn left_out(&self) -> LeftOut {
        // Formats of points with a packet of a waveform each.
        LeftOut { has_waveforms: matches!(self.header.format, 4 | 5 | 9 | 10), ..self.left_out }
    }

    /// How many points were kept so far.
    pub fn chosen(&self) -> u64 {
        self.chosen
    }

    /// What says something in all points so far.
    pub fn seen(&self) -> Seen {
        self.seen
    }

    /// What positions are relative to, once a point has decided.
    pub fn origin(&self) -> Option<DVec3> {
        self.local_origin.decided()
    }

    /// The points since the last [`Self::clear`], with what says something in all points; with all that may say something where
    /// that is not known yet.
    pub fn piece(&mut self) -> &mut PointCloud {
        self.trim(self.known.unwrap_or(Seen::ALL));
        &mut self.cloud
    }

    /// Forgets the points, but not what they have said.
    pub fn clear(&mut self) {
        self.kept = 0;
        self.byte_colors.clear();
    }
}

impl Part<'_> {
    /// Fills the places from the front with the points of these bytes that are kept.
    pub fn fill(self, bytes: &[u8]) -> Found {
        let mut found = Found::default();
        let records = || bytes.chunks_exact(usize::from(self.header.record_size));
        let color_of = |record: &[u8], at: usize| [0, 2, 4].map(|next| u16::from_le_bytes(array(record, at + next)));
        if let Some(color_at) = self.color_at {
            let shown = records().filter(|record| !self.header.class(record).0);
            let largest = shown.flat_map(|record| color_of(record, color_at)).max();
            found.seen.largest_color = largest.unwrap_or(0);
            found.has_byte_colors = self.known.unwrap_or(found.seen).has_byte_colors();
        }
        for record in records() {
            found.points += 1;
            let (is_withheld, class) = self.header.class(record);
            if is_withheld {
                found.left_out.withheld += 1;
                continue;
            }
            let position = self.header.position(record);
            if !self.header.is_chosen(class, position) {
                found.left_out.not_chosen += 1;
                found.left_out.classes.insert(class);
                continue;
            }
            let placed = (position - self.offset).as_vec3();
            if !placed.is_finite() {
                found.left_out.infinite += 1;
                continue;
            }
            let (at, intensity) = (found.kept, u16::from_le_bytes(array(record, 12)));
            found.kept += 1;
            self.positions[at] = placed;
            self.intensities[at] = intensity;
            self.classes[at] = class;
            found.seen.intensities |= intensity != 0;
            found.seen.classes |= class != 0;
            if let Some(color_at) = self.color_at {
                let color = color_of(record, color_at);
                self.colors[at] = color.map(|value| if found.has_byte_colors { value as u8 } else { byte_of(value) });
            }
        }
        found
    }
}
