//! From places in a grid to edits: brushes, lines and boxes, with what they do to the voxels that they touch.

use crate::tr;
use voxtrace::Shape;
use voxtrace::dynamic::Edit;
use voxtrace::glam::IVec3;
use voxtrace::grid::VoxelBox;
use voxtrace::ray::Face;

/// Largest brush, voxels across.
pub const MOST_SIZE: u32 = 256;

/// What is done to voxels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Act {
    /// Empty ones become of the material.
    #[default]
    Place,
    /// They become empty.
    Erase,
    /// Those that are there become of the material.
    Paint,
}

impl Act {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Place, Self::Erase, Self::Paint];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Place => tr!("edit.act_place"),
            Self::Erase => tr!("edit.act_erase"),
            Self::Paint => tr!("edit.act_paint"),
        }
    }

    /// The edit of a shape.
    pub fn edit(self, shape: Shape, material: u16) -> Edit {
        match self {
            Self::Place => Edit::Add { shape, material },
            Self::Erase => Edit::Fill { shape, material: None },
            Self::Paint => Edit::Paint { shape, material },
        }
    }

    /// The voxel that it begins at, where a face of `voxel` is under the cursor.
    pub fn cell(self, voxel: IVec3, face: Face) -> IVec3 {
        if self == Self::Place { voxel + face.normal() } else { voxel }
    }
}

/// A brush.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Brush {
    /// Voxels across, at least 1.
    pub size: u32,
    /// Whether it is a ball; else a cube.
    pub is_round: bool,
}

impl Default for Brush {
    fn default() -> Self {
        Self { size: 1, is_round: true }
    }
}

impl Brush {
    /// The same brush of another size.
    #[must_use]
    pub fn resized(self, size: u32) -> Self {
        Self { size: size.clamp(1, MOST_SIZE), ..self }
    }

    /// The next size in a direction: by single voxels at first, later by an eighth.
    #[must_use]
    pub fn stepped(self, steps: i32) -> Self {
        let step = (self.size / 8).max(1) as i32 * steps;
        self.resized((self.size as i32 + step).max(1) as u32)
    }

    /// The box of the brush at a voxel.
    pub fn region(self, cell: IVec3) -> VoxelBox {
        let min = cell - (self.size as i32 - 1) / 2;
        VoxelBox { min, max: min + self.size as i32 }
    }

    /// Its voxels at a voxel.
    pub fn shape(self, cell: IVec3) -> Shape {
        let region = self.region(cell);
        match self.is_round && self.size > 1 {
            true => {
                Shape::Sphere { center: (region.min + region.max).as_dvec3() / 2.0, radius: f64::from(self.size) / 2.0 }
            }
            false => Shape::Box(region),
        }
    }

    /// Its voxels on the way from one voxel to another, without the first. Short ways of a ball are one shape.
    pub fn shapes_to(self, from: IVec3, to: IVec3) -> Vec<Shape> {
        if from == to {
            return Vec::new();
        }
        if self.is_round && self.size > 1 {
            let middle = |cell| {
                let region = self.region(cell);
                (region.min + region.max).as_dvec3() / 2.0
            };
            return vec![Shape::Capsule { from: middle(from), to: middle(to), radius: f64::from(self.size) / 2.0 }];
        }
        let cells = line(from, to);
        match self.size {
            1 => runs(&cells[1..]).into_iter().map(Shape::Box).collect(),
            // A cube overlaps itself by all but the last layer.
            _ => cells[1..].iter().map(|&cell| self.shape(cell)).collect(),
        }
    }

    /// Its voxels on a line, with both ends.
    pub fn line(self, from: IVec3, to: IVec3) -> Vec<Shape> {
        match self.size {
            1 => runs(&line(from, to)).into_iter().map(Shape::Box).collect(),
            _ => [self.shape(from)].into_iter().chain(self.shapes_to(from, to)).collect(),
        }
    }
}

/// The voxels of a line, from one to the other, each beside the one before: by a face, an edge or a corner.
pub fn line(from: IVec3, to: IVec3) -> Vec<IVec3> {
    let delta = (to - from).as_dvec3();
    let steps = (to - from).abs().max_element();
    let at = |step: i32| from + (delta * (f64::from(step) / f64::from(steps.max(1)))).round().as_ivec3();
    (0..=steps).map(at).collect()
}

/// The boxes of voxels in a row: neighbours along one axis are one box.
pub fn runs(cells: &[IVec3]) -> Vec<VoxelBox> {
    let mut boxes: Vec<VoxelBox> = Vec::new();
    for &cell in cells {
        if let Some(last) = boxes.last_mut() {
            let (low, high) = (last.min.min(cell), last.max.max(cell + 1));
            let size = high - low;
            let grows = (last.max - last.min).element_product() + 1 == size.element_product();
            if grows && size.cmpgt(IVec3::ONE).bitmask().count_ones() == 1 {
                *last = VoxelBox { min: low, max: high };
                continue;
            }
        }
        boxes.push(VoxelBox { min: cell, max: cell + 1 });
    }
    boxes
}

/// The box between two voxels, with both.
pub fn box_between(a: IVec3, b: IVec3) -> VoxelBox {
    VoxelBox { min: a.min(b), max: a.max(b) + 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn volume(boxes: &[VoxelBox]) -> i32 {
        boxes.iter().map(|own| own.size().element_product()).sum()
    }

    #[test]
    fn a_line_joins_its_ends_and_few_boxes_hold_it() {
        for (from, to) in [([0, 0, 0], [40, 3, -2]), ([5, 5, 5], [5, 5, 5]), ([1, 2, 3], [-9, 30, 17])] {
            let (from, to) = (IVec3::from_array(from), IVec3::from_array(to));
            let cells = line(from, to);
            assert_eq!((cells[0], cells[cells.len() - 1]), (from, to));
            assert!(cells.windows(2).all(|pair| (pair[1] - pair[0]).abs().max_element() == 1));
            let boxes = runs(&cells);
            assert_eq!(volume(&boxes), cells.len() as i32);
            assert!(cells.iter().all(|&cell| boxes.iter().any(|own| own.contains(cell))));
        }
        assert_eq!(runs(&line(IVec3::ZERO, IVec3::new(40, 3, -2))).len(), 6, "a row for each step aside");
    }

    #[test]
    fn a_brush_is_as_wide_as_it_says_and_lies_around_its_voxel() {
        for size in 1..9 {
            for is_round in [false, true] {
                let brush = Brush { size, is_round };
                let cell = IVec3::new(3, -4, 5);
                let bounds = brush.shape(cell).bounds().unwrap();
                let size = size as i32;
                let inside = |axis: usize| {
                    let along = (bounds.min[axis]..bounds.max[axis]).filter(|&at| {
                        let mut voxel = cell;
                        voxel[axis] = at;
                        brush.shape(cell).contains(voxel)
                    });
                    along.count() as i32
                };
                assert_eq!([inside(0), inside(1), inside(2)], [size; 3], "{brush:?}");
                assert!(brush.shape(cell).contains(cell));
            }
        }
    }

    #[test]
    fn sizes_step_by_voxels_and_then_by_shares() {
        let brush = Brush::default();
        assert_eq!((brush.stepped(1).size, brush.stepped(-1).size), (2, 1));
        assert_eq!(brush.resized(80).stepped(1).size, 90);
        assert_eq!(brush.resized(9999).size, MOST_SIZE);
    }
}
