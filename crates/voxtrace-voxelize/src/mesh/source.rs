//! Meshes larger than memory: triangles that are read from their file as often as they are needed, some at a time.

use super::Mesh;
use crate::import_error::ImportError;
use glam::Vec3;

/// Triangles in a file.
pub trait TriangleSource: Send {
    /// The mesh without its triangles.
    fn frame(&mut self) -> &mut Mesh;
    /// Triangles or polygons, as the file counts them.
    fn count(&self) -> u64;
    /// Whether each corner has a colour, and whether these are more than sRGB bytes.
    fn colors(&self) -> SourceColors;
    /// Whether each corner has texture coordinates.
    fn has_uvs(&self) -> bool;
    /// Which materials triangles have; `None` where pieces do not say it and all have the first.
    fn materials(&self) -> Option<Vec<bool>> {
        None
    }
    /// Gives back the memory that reading takes.
    fn release(&mut self);
    /// Reads all triangles in the order of the file. `each` gets some of them, as a mesh with the frame's offset in which
    /// every three positions are a triangle, and says whether to go on.
    ///
    /// # Errors
    /// If the file cannot be read or is not what it says.
    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError>;
}

/// What is known of the colours of corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SourceColors {
    /// There are none.
    None,
    /// Opaque, and each channel a byte of sRGB.
    Bytes,
    /// Linear light and alpha.
    Linear,
}

/// Every so many points of something large, at most [`Sample::MOST`].
#[derive(Clone, Debug)]
pub struct Sample {
    points: Vec<Vec3>,
    stride: u64,
    seen: u64,
}

impl Default for Sample {
    fn default() -> Self {
        Self { points: Vec::new(), stride: 1, seen: 0 }
    }
}

impl Sample {
    /// Most points of a sample.
    pub const MOST: usize = 1 << 19;

    /// Shows the next point.
    #[inline]
    pub fn add(&mut self, point: impl FnOnce() -> Vec3) {
        if self.is_next() {
            if self.points.len() == Self::MOST {
                let mut at = 0;
                self.points.retain(|_| {
                    at += 1;
                    at % 2 == 1
                });
                self.stride *= 2;
            }
            if self.is_next() {
                self.points.push(point());
            }
        }
        self.seen += 1;
    }

    fn is_next(&self) -> bool {
        // The stride is a power of two.
        self.seen & (self.stride - 1) == 0
    }

    /// The points that were kept.
    pub fn points(&self) -> &[Vec3] {
        &self.points
    }

    /// How many points each of them stands for.
    pub fn stride(&self) -> u64 {
        self.stride
    }

    /// How many points there were.
    pub fn seen(&self) -> u64 {
        self.seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_takes_points_at_one_distance_from_each_other() {
        let mut sample = Sample::default();
        let count = 5 * Sample::MOST as u64 + 3;
        (0..count).for_each(|at| sample.add(|| Vec3::splat(at as f32)));
        assert_eq!((sample.stride(), sample.seen()), (8, count));
        assert_eq!(sample.points().len() as u64, count.div_ceil(8));
        assert!(sample.points().iter().enumerate().all(|(at, point)| point.x == 8.0 * at as f32));
    }
}
