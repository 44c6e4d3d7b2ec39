//! Meshes larger than memory: triangles that stay in their file and are read from it in pieces, once for each pass.

use super::Mesh;
use crate::import_error::ImportError;
use glam::Vec3;

/// Triangles that stay in their file.
pub trait TriangleSource: Send {
    /// The mesh without its triangles.
    fn frame(&mut self) -> &mut Mesh;
    /// Number of triangles or polygons, as the file counts them.
    fn count(&self) -> u64;
    /// The colours of the triangles' corners.
    fn colors(&self) -> SourceColors;
    /// Whether each corner has texture coordinates.
    fn has_uvs(&self) -> bool;
    /// Of each material whether a triangle uses it; `None` where all triangles have the first.
    fn materials(&self) -> Option<Vec<bool>> {
        None
    }
    /// Frees the memory that reading takes, until the next pass.
    fn release(&mut self);
    /// Makes a pass over all triangles in the order of the file. `each` gets them in pieces, as meshes with the frame's offset
    /// without indices (every three positions are a triangle), and returns whether to go on.
    ///
    /// # Errors
    /// If the file cannot be read or is not what it says.
    fn for_each(&mut self, each: &mut dyn FnMut(&Mesh) -> bool) -> Result<(), ImportError>;
}

/// How the corners of a source are coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SourceColors {
    /// There are none.
    None,
    /// Opaque 8-bit sRGB.
    Bytes,
    /// Linear light and alpha.
    Linear,
}

/// A systematic sample of a stream of points: every n-th one, n doubling whenever there are more than [`Sample::MOST`].
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

    /// Offers the next point of the stream.
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

    /// Adds a sample of other points.
    pub fn join(&mut self, other: &Self) {
        self.thin(other.stride);
        self.points.extend(other.points.iter().step_by((self.stride / other.stride) as usize));
        self.seen += other.seen;
        if self.points.len() > Self::MOST {
            self.thin(2 * self.stride);
        }
    }

    /// Leaves as many points as a stride of at least this, a power of two, has.
    pub fn thin(&mut self, stride: u64) {
        if stride > self.stride {
            self.points = self.points.iter().copied().step_by((stride / self.stride) as usize).collect();
            self.stride = stride;
        }
    }

    /// A sample that was taken apart. `None` where a stride is no power of two.
    pub(crate) fn of_parts(points: Vec<Vec3>, stride: u64, seen: u64) -> Option<Self> {
        stride.is_power_of_two().then_some(Self { points, stride, seen })
    }

    fn is_next(&self) -> bool {
        // The stride is a power of two.
        self.seen & (self.stride - 1) == 0
    }

    /// The sampled points.
    pub fn points(&self) -> &[Vec3] {
        &self.points
    }

    /// How many points each sampled one stands for.
    pub fn stride(&self) -> u64 {
        self.stride
    }

    /// Number of points offered.
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
        let mut few = Sample::default();
        (0..100).for_each(|at| few.add(|| Vec3::splat(at as f32)));
        sample.join(&few);
        assert_eq!((sample.stride(), sample.seen()), (8, count + 100));
        assert_eq!(sample.points().len() as u64, count.div_ceil(8) + 100u64.div_ceil(8));
    }
}
