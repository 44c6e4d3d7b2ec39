//! Parts of a mesh that change their shape while they move, as what wears a bending skeleton does: the same triangles with other positions.

use glam::Vec3;
use std::fmt::Debug;
use std::sync::Arc;

/// A part that changes its shape in even steps: it has a shape from each step until the next, and the last one for ever.
#[derive(Clone, Debug)]
pub struct ChangingPart {
    /// Index into [`super::MovingParts::meshes`]; that mesh has the shape at rest.
    pub part: usize,
    /// Steps a second, above 0; the first is at 0 s.
    pub rate: f64,
    /// For each step which shape it is, less than [`PartShapes::count`].
    pub steps: Vec<u32>,
    /// The shapes.
    pub shapes: Arc<dyn PartShapes>,
}

/// The shapes that a part has, made when they are asked for, so that not all are in memory at once.
pub trait PartShapes: Debug + Send + Sync {
    /// How many there are.
    fn count(&self) -> usize;

    /// The positions of a shape, one for each of the part, without its offset.
    fn positions(&self, shape: usize) -> Vec<Vec3>;
}

/// Shapes are not compared number by number: those of two readings differ.
impl PartialEq for ChangingPart {
    fn eq(&self, other: &Self) -> bool {
        (self.part, self.rate, &self.steps) == (other.part, other.rate, &other.steps)
            && Arc::ptr_eq(&self.shapes, &other.shapes)
    }
}
