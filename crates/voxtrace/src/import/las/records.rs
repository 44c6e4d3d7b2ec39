//! From the bytes of points, formats 0 to 10, to a cloud.

use super::header::{Header, array};
use crate::import::anchor::Anchor;
use crate::points::{Attributes, PointCloud};
use glam::{DVec3, IVec3};

/// Points so far.
pub(super) struct Records<'a> {
    header: &'a Header,
    /// Where a point has its colour.
    color_at: Option<usize>,
    anchor: Anchor,
    cloud: PointCloud,
    /// Colours as they are in the file.
    colors: Vec<[u16; 3]>,
    seen: Seen,
    withheld: u64,
    infinite: u64,
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
}

impl<'a> Records<'a> {
    pub fn new(header: &'a Header) -> Self {
        let color_at = match header.format {
            2 => Some(20),
            3 | 5 => Some(28),
            7 | 8 | 10 => Some(30),
            _ => None,
        };
        let (anchor, cloud) = (Anchor::default(), PointCloud::default());
        Self { header, color_at, anchor, cloud, colors: Vec::new(), seen: Seen::default(), withheld: 0, infinite: 0 }
    }

    /// Adds points, whose bytes are whole.
    pub fn add(&mut self, bytes: &[u8]) {
        let is_new = self.header.format >= 6;
        for record in bytes.chunks_exact(usize::from(self.header.record_size)) {
            let (is_withheld, class) =
                if is_new { (record[15] & 4 != 0, record[16]) } else { (record[15] & 0x80 != 0, record[15] & 0x1f) };
            if is_withheld {
                self.withheld += 1;
                continue;
            }
            let whole = IVec3::from_array([0, 4, 8].map(|at| i32::from_le_bytes(array(record, at))));
            let position: DVec3 = whole.as_dvec3() * self.header.scale + self.header.offset;
            let placed = self.anchor.place(position);
            if !placed.is_finite() {
                self.infinite += 1;
                continue;
            }
            self.cloud.positions.push(placed);
            let intensity = u16::from_le_bytes(array(record, 12));
            self.cloud.intensities.push(intensity);
            self.cloud.classes.push(class);
            self.seen.intensities |= intensity != 0;
            self.seen.classes |= class != 0;
            if let Some(at) = self.color_at {
                let color = [0, 2, 4].map(|next| u16::from_le_bytes(array(record, at + next)));
                self.seen.largest_color = self.seen.largest_color.max(color[0]).max(color[1]).max(color[2]);
                self.colors.push(color);
            }
        }
    }

    /// The cloud. What is the same everywhere says nothing and is left out.
    pub fn finish(mut self) -> PointCloud {
        self.settle(self.seen);
        self.cloud.notes = self.notes();
        self.cloud.offset = self.anchor.offset();
        self.cloud
    }

    /// What was left out.
    pub fn notes(&self) -> Vec<String> {
        let counts = [(self.withheld, "that the file withholds"), (self.infinite, "that are not finite")];
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
        self.settle(seen);
        &self.cloud
    }

    /// Forgets the points, but not what they have said.
    pub fn clear(&mut self) {
        self.cloud.clear();
        self.colors.clear();
    }

    fn settle(&mut self, seen: Seen) {
        if seen.largest_color > 0 {
            // Many writers keep 8 bits where there are 16.
            let is_byte = seen.largest_color <= 255;
            let byte = |value: u16| if is_byte { value as u8 } else { ((u32::from(value) + 128) / 257) as u8 };
            self.cloud.colors = self.colors.iter().map(|color| color.map(byte)).collect();
        }
        if !seen.intensities {
            self.cloud.intensities = Vec::new();
        }
        if !seen.classes {
            self.cloud.classes = Vec::new();
        }
    }
}
