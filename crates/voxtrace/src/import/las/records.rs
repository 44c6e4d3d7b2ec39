//! From the bytes of points, formats 0 to 10, to a cloud.

use super::header::{Header, array};
use crate::import::anchor::Anchor;
use crate::points::PointCloud;
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
    withheld: u64,
    infinite: u64,
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
        Self { header, color_at, anchor, cloud, colors: Vec::new(), withheld: 0, infinite: 0 }
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
            self.cloud.intensities.push(u16::from_le_bytes(array(record, 12)));
            self.cloud.classes.push(class);
            if let Some(at) = self.color_at {
                self.colors.push([0, 2, 4].map(|next| u16::from_le_bytes(array(record, at + next))));
            }
        }
    }

    /// The cloud. What is the same everywhere says nothing and is left out.
    pub fn finish(mut self) -> PointCloud {
        if self.withheld > 0 {
            self.cloud.notes.push(format!("{} points that the file withholds are left out", self.withheld));
        }
        if self.infinite > 0 {
            self.cloud.notes.push(format!("{} points that are not finite are left out", self.infinite));
        }
        let largest = self.colors.iter().flatten().copied().max().unwrap_or(0);
        if largest > 0 {
            // Many writers keep 8 bits where there are 16.
            let byte = |value: u16| if largest <= 255 { value as u8 } else { ((u32::from(value) + 128) / 257) as u8 };
            self.cloud.colors = self.colors.iter().map(|color| color.map(byte)).collect();
        }
        if self.cloud.intensities.iter().all(|&value| value == 0) {
            self.cloud.intensities = Vec::new();
        }
        if self.cloud.classes.iter().all(|&class| class == 0) {
            self.cloud.classes = Vec::new();
        }
        self.cloud.offset = self.anchor.offset();
        self.cloud
    }
}
