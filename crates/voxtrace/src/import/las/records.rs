//! From the bytes of points, formats 0 to 10, to a cloud, on all threads: each run of points has its places in the arrays.

use super::header::{Header, array};
use crate::import::anchor::Anchor;
use crate::points::{Attributes, PointCloud};
use glam::{DVec3, IVec3, Vec3};
use rayon::prelude::*;

/// Points converted by one task.
const TASK: usize = 1 << 14;

/// Points so far.
pub(super) struct Records<'a> {
    header: &'a Header,
    /// Where a point has its colour.
    color_at: Option<usize>,
    anchor: Anchor,
    /// Arrays with room for more than the points that are kept.
    positions: Vec<Vec3>,
    intensities: Vec<u16>,
    classes: Vec<u8>,
    /// Colours as they are in the file.
    colors: Vec<[u16; 3]>,
    kept: usize,
    seen: Seen,
    left_out: LeftOut,
    /// What [`Self::piece`] gave.
    piece: PointCloud,
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

    fn join(&mut self, other: Self) {
        self.largest_color = self.largest_color.max(other.largest_color);
        self.intensities |= other.intensities;
        self.classes |= other.classes;
    }

    /// Colours of 8 bits: many writers keep those where there are 16.
    fn colors(self, colors: &[[u16; 3]]) -> Vec<[u8; 3]> {
        let is_byte = self.largest_color <= 255;
        let byte = |value: u16| if is_byte { value as u8 } else { ((u32::from(value) + 128) / 257) as u8 };
        colors.par_iter().map(|color| color.map(byte)).collect()
    }
}

/// Points that were not kept.
#[derive(Clone, Copy, Default)]
struct LeftOut {
    withheld: u64,
    infinite: u64,
}

/// Places for a run of points.
struct Part<'a> {
    header: &'a Header,
    color_at: Option<usize>,
    offset: DVec3,
    positions: &'a mut [Vec3],
    intensities: &'a mut [u16],
    classes: &'a mut [u8],
    colors: &'a mut [[u16; 3]],
}

/// What was found in a run of points.
#[derive(Clone, Copy, Default)]
struct Found {
    points: usize,
    /// Those of them that are kept, from the front of their places on.
    kept: usize,
    seen: Seen,
    left_out: LeftOut,
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

impl<'a> Records<'a> {
    pub fn new(header: &'a Header) -> Self {
        let color_at = match header.format {
            2 => Some(20),
            3 | 5 => Some(28),
            7 | 8 | 10 => Some(30),
            _ => None,
        };
        Self {
            header,
            color_at,
            anchor: Anchor::default(),
            positions: Vec::new(),
            intensities: Vec::new(),
            classes: Vec::new(),
            colors: Vec::new(),
            kept: 0,
            seen: Seen::default(),
            left_out: LeftOut::default(),
            piece: PointCloud::default(),
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
        self.positions = bytemuck::allocation::try_zeroed_vec(count).map_err(none)?;
        self.intensities = bytemuck::allocation::try_zeroed_vec(count).map_err(none)?;
        self.classes = bytemuck::allocation::try_zeroed_vec(count).map_err(none)?;
        self.colors = bytemuck::allocation::try_zeroed_vec(colored).map_err(none)?;
        Ok(())
    }

    /// Adds points, whose bytes are whole.
    pub fn add(&mut self, bytes: &[u8]) {
        let size = usize::from(self.header.record_size);
        let first = bytes.chunks_exact(size).find(|record| !self.header.class(record).0);
        if let Some(first) = first {
            // The first point of all that is kept decides.
            self.anchor.place(self.header.position(first));
        }
        let parts = self.parts(bytes.len() / size);
        let runs = bytes.par_chunks(TASK * size);
        let found: Vec<Found> = runs.zip(parts).map(|(run, part)| part.fill(run)).collect();
        self.close_gaps(&found);
    }

    /// Places for runs of points, behind those that are kept.
    fn parts(&mut self, count: usize) -> Vec<Part<'_>> {
        let (start, end) = (self.kept, self.kept + count);
        if self.positions.len() < end {
            self.positions.resize(end, Vec3::ZERO);
            self.intensities.resize(end, 0);
            self.classes.resize(end, 0);
            self.colors.resize(if self.color_at.is_some() { end } else { 0 }, [0; 3]);
        }
        let (header, color_at, offset) = (self.header, self.color_at, self.anchor.as_it_is());
        let positions = self.positions[start..end].chunks_mut(TASK);
        let intensities = self.intensities[start..end].chunks_mut(TASK);
        let classes = self.classes[start..end].chunks_mut(TASK);
        let mut colors = self.colors.get_mut(start..end).unwrap_or_default().chunks_mut(TASK);
        let parts = positions.zip(intensities).zip(classes);
        let part = |((positions, intensities), classes)| {
            let colors = colors.next().unwrap_or_default();
            Part { header, color_at, offset, positions, intensities, classes, colors }
        };
        parts.map(part).collect()
    }

    /// Counts what was found, and closes the gaps behind runs of which not every point is kept.
    fn close_gaps(&mut self, found: &[Found]) {
        let mut from = self.kept;
        for run in found {
            let (to, kept) = (self.kept, from..from + run.kept);
            if from != to {
                self.positions.copy_within(kept.clone(), to);
                self.intensities.copy_within(kept.clone(), to);
                self.classes.copy_within(kept.clone(), to);
                if self.color_at.is_some() {
                    self.colors.copy_within(kept, to);
                }
            }
            from += run.points;
            self.kept += run.kept;
            self.seen.join(run.seen);
            self.left_out.withheld += run.left_out.withheld;
            self.left_out.infinite += run.left_out.infinite;
        }
    }

    /// The cloud. What is the same everywhere says nothing and is left out.
    pub fn finish(mut self) -> PointCloud {
        self.positions.truncate(self.kept);
        self.intensities.truncate(if self.seen.intensities { self.kept } else { 0 });
        self.classes.truncate(if self.seen.classes { self.kept } else { 0 });
        self.colors.truncate(if self.seen.largest_color > 0 { self.kept } else { 0 });
        PointCloud {
            offset: self.offset(),
            notes: self.notes(),
            colors: self.seen.colors(&self.colors),
            positions: self.positions,
            intensities: self.intensities,
            classes: self.classes,
            ..PointCloud::default()
        }
    }

    /// What was left out.
    pub fn notes(&self) -> Vec<String> {
        let LeftOut { withheld, infinite } = self.left_out;
        let counts = [(withheld, "that the file withholds"), (infinite, "that are not finite")];
        let counts = counts.iter().filter(|(count, _)| *count > 0);
        counts.map(|(count, which)| format!("{count} points {which} are left out")).collect()
    }

    /// What says something in all points so far.
    pub fn seen(&self) -> Seen {
        self.seen
    }

    /// What positions are relative to.
    pub fn offset(&self) -> DVec3 {
        self.anchor.offset()
    }

    /// The points since the last [`Self::clear`], with what says something in all points.
    pub fn piece(&mut self, seen: Seen) -> &PointCloud {
        self.piece.clear();
        self.piece.positions.extend_from_slice(&self.positions[..self.kept]);
        if seen.largest_color > 0 && self.color_at.is_some() {
            self.piece.colors = seen.colors(&self.colors[..self.kept]);
        }
        if seen.intensities {
            self.piece.intensities.extend_from_slice(&self.intensities[..self.kept]);
        }
        if seen.classes {
            self.piece.classes.extend_from_slice(&self.classes[..self.kept]);
        }
        &self.piece
    }

    /// Forgets the points, but not what they have said.
    pub fn clear(&mut self) {
        self.kept = 0;
    }
}

impl Part<'_> {
    /// Fills the places from the front with the points of these bytes that are kept.
    fn fill(self, bytes: &[u8]) -> Found {
        let mut found = Found::default();
        for record in bytes.chunks_exact(usize::from(self.header.record_size)) {
            found.points += 1;
            let (is_withheld, class) = self.header.class(record);
            if is_withheld {
                found.left_out.withheld += 1;
                continue;
            }
            let placed = (self.header.position(record) - self.offset).as_vec3();
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
                let color = [0, 2, 4].map(|next| u16::from_le_bytes(array(record, color_at + next)));
                self.colors[at] = color;
                found.seen.largest_color = color.into_iter().fold(found.seen.largest_color, u16::max);
            }
        }
        found
    }
}
