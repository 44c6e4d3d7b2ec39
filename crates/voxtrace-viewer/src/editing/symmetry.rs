//! What is done on one side of a plane is done on the other sides, too: planes across the axes of a grid.

use voxtrace::Shape;
use voxtrace::dynamic::Edit;
use voxtrace::glam::{DVec3, IVec3};
use voxtrace::grid::VoxelBox;
use voxtrace::ray::{FACES, Face};

/// Planes across the axes of a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Symmetry {
    /// For each axis whether there is one.
    pub axes: [bool; 3],
    /// Twice the coordinates of the planes: even between voxels, odd through the middle of one.
    pub twice: IVec3,
}

/// A mirror along some of the axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image {
    axes: [bool; 3],
    twice: IVec3,
}

impl Symmetry {
    /// Through the middle of a box of voxels.
    pub fn middle_of(region: VoxelBox) -> IVec3 {
        region.min + region.max
    }

    /// Through the middle of a voxel.
    pub fn middle_of_voxel(voxel: IVec3) -> IVec3 {
        voxel * 2 + 1
    }

    /// Whether there is no plane.
    pub fn is_none(&self) -> bool {
        self.axes == [false; 3]
    }

    /// All images, the thing itself first.
    pub fn images(&self) -> impl Iterator<Item = Image> + use<> {
        let (axes, twice) = (self.axes, self.twice);
        (0..8u32).filter_map(move |bits| {
            let own = [0, 1, 2].map(|axis| bits >> axis & 1 == 1);
            let is_there = (0..3).all(|axis| !own[axis] || axes[axis]);
            is_there.then_some(Image { axes: own, twice })
        })
    }

    /// The edits of all images, each once.
    pub fn edits(&self, edits: &[Edit]) -> Vec<Edit> {
        let mut all: Vec<Edit> = Vec::with_capacity(edits.len());
        for image in self.images() {
            for edit in edits {
                let edit = image.edit(edit);
                // What lies on a plane is its own image. Long strokes have too many edits to look at all of them.
                if !all.iter().rev().take(8).any(|own| *own == edit) {
                    all.push(edit);
                }
            }
        }
        all
    }
}

impl Image {
    /// Whether it is the thing itself.
    pub fn is_itself(&self) -> bool {
        self.axes == [false; 3]
    }

    /// Where a voxel comes to lie.
    pub fn voxel(&self, voxel: IVec3) -> IVec3 {
        self.map(voxel, self.twice - 1 - voxel)
    }

    /// Where a point comes to lie.
    pub fn point(&self, point: DVec3) -> DVec3 {
        let mirrored = self.twice.as_dvec3() - point;
        DVec3::from_array([0, 1, 2].map(|axis| if self.axes[axis] { mirrored[axis] } else { point[axis] }))
    }

    /// Where a box comes to lie.
    pub fn region(&self, region: VoxelBox) -> VoxelBox {
        let (min, max) = (self.twice - region.max, self.twice - region.min);
        VoxelBox { min: self.map(region.min, min), max: self.map(region.max, max) }
    }

    /// Where a face looks.
    pub fn face(&self, face: Face) -> Face {
        let number = face as usize;
        FACES[if self.axes[face.axis()] { number ^ 1 } else { number }]
    }

    /// The shape on the other side.
    pub fn shape(&self, shape: &Shape) -> Shape {
        match *shape {
            Shape::Box(region) => Shape::Box(self.region(region)),
            Shape::Sphere { center, radius } => Shape::Sphere { center: self.point(center), radius },
            Shape::Capsule { from, to, radius } => {
                Shape::Capsule { from: self.point(from), to: self.point(to), radius }
            }
            shape => shape,
        }
    }

    fn map(&self, own: IVec3, mirrored: IVec3) -> IVec3 {
        IVec3::from_array([0, 1, 2].map(|axis| if self.axes[axis] { mirrored[axis] } else { own[axis] }))
    }

    /// The edit on the other side.
    fn edit(&self, edit: &Edit) -> Edit {
        if self.is_itself() {
            return edit.clone();
        }
        match edit {
            Edit::Fill { shape, material } => Edit::Fill { shape: self.shape(shape), material: *material },
            Edit::Add { shape, material } => Edit::Add { shape: self.shape(shape), material: *material },
            Edit::Paint { shape, material } => Edit::Paint { shape: self.shape(shape), material: *material },
            Edit::Extrude { layer, face, distance } => {
                Edit::Extrude { layer: self.region(*layer), face: self.face(*face), distance: *distance }
            }
            Edit::Flood { start, material, within, most } => {
                Edit::Flood { start: self.voxel(*start), material: *material, within: *within, most: *most }
            }
            // Everywhere, or where somebody put it.
            other => other.clone(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn voxels(shape: &Shape) -> Vec<IVec3> {
        let bounds = shape.bounds().unwrap();
        let size = bounds.size();
        let all = (0..size.element_product())
            .map(|i| bounds.min + IVec3::new(i % size.x, i / size.x % size.y, i / (size.x * size.y)));
        all.filter(|&voxel| shape.contains(voxel)).collect()
    }

    #[test]
    fn the_voxels_of_the_image_of_a_shape_are_the_images_of_its_voxels() {
        let (from, to) = (DVec3::new(1.5, 2.5, 3.5), DVec3::new(9.0, 4.0, -6.5));
        let shapes = [
            Shape::Box(VoxelBox { min: IVec3::new(-3, 2, 5), max: IVec3::new(4, 3, 9) }),
            Shape::Sphere { center: from, radius: 3.5 },
            Shape::Sphere { center: to, radius: 4.0 },
            Shape::Capsule { from, to, radius: 2.0 },
        ];
        for twice in [IVec3::new(7, -4, 1), IVec3::new(0, 3, 10)] {
            let symmetry = Symmetry { axes: [true, false, true], twice };
            let images: Vec<Image> = symmetry.images().collect();
            assert_eq!((images.len(), images[0].is_itself(), images[1].is_itself()), (4, true, false));
            for image in &images {
                for shape in &shapes {
                    let mut expected: Vec<[i32; 3]> =
                        voxels(shape).into_iter().map(|voxel| image.voxel(voxel).to_array()).collect();
                    let mut found: Vec<[i32; 3]> =
                        voxels(&image.shape(shape)).into_iter().map(|voxel| voxel.to_array()).collect();
                    expected.sort_unstable();
                    found.sort_unstable();
                    assert_eq!(found, expected, "{image:?} {shape:?}");
                    let moved = Image { twice: image.twice + 2, ..*image };
                    let mut other: Vec<[i32; 3]> =
                        voxels(&moved.shape(shape)).into_iter().map(|voxel| voxel.to_array()).collect();
                    other.sort_unstable();
                    assert!(image.is_itself() || other != expected, "the comparison sees a voxel");
                }
                // Twice mirrored is as it was, and a face looks at the other side.
                assert_eq!(image.voxel(image.voxel(IVec3::new(3, 4, 5))), IVec3::new(3, 4, 5));
                for face in FACES {
                    assert_eq!(image.voxel(IVec3::ZERO) - image.voxel(-face.normal()), image.face(face).normal());
                }
            }
        }
    }

    #[test]
    fn what_lies_on_the_plane_is_edited_once() {
        let symmetry = Symmetry { axes: [true, true, false], twice: Symmetry::middle_of_voxel(IVec3::new(4, 5, 6)) };
        let at = |min: IVec3| Edit::Fill { shape: Shape::Box(VoxelBox { min, max: min + 1 }), material: None };
        assert_eq!(symmetry.edits(&[at(IVec3::new(4, 5, 9))]).len(), 1);
        assert_eq!(symmetry.edits(&[at(IVec3::new(4, 6, 9))]), [at(IVec3::new(4, 6, 9)), at(IVec3::new(4, 4, 9))]);
        assert_eq!(symmetry.edits(&[at(IVec3::new(0, 0, 0))]).len(), 4);
    }
}
