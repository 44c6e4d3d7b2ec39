//! The whole input of one render call. A picture depends on the `Frame` and the packed scene alone.

use crate::camera::Camera;

/// What to render: view, size, samples and how light is computed.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The view.
    pub camera: Camera,
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// The part to render.
    pub region: Region,
    /// Number of the first sample of each pixel.
    pub first_sample: u32,
    /// Samples of each pixel: the picture holds the samples `first_sample .. first_sample + samples`.
    pub samples: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Most surfaces that scatter one path, so that it has at most one ray more than that (the study: 3 and 4); 0 gives a
    /// picture of the sky and the lights alone.
    pub max_bounces: u32,
    /// How light is computed.
    pub integrator: Integrator,
    /// Whether a camera ray that meets no voxel leaves its sample black rather than the colour of the sky, so that the
    /// picture can be laid over another with [`crate::film::Pixel::alpha`].
    pub transparent: bool,
    /// Whether to fill the film's layers (albedo, normal, depth, instance and voxel) as well.
    pub layers: bool,
}

/// A rectangle of pixels: `x0 ≤ x < x1`, `y0 ≤ y < y1`, counted from the upper left corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// First column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// One past the last column.
    pub x1: u32,
    /// One past the last row.
    pub y1: u32,
}

impl Region {
    /// A whole picture.
    pub fn full(width: u32, height: u32) -> Self {
        Self { x0: 0, y0: 0, x1: width, y1: height }
    }

    /// Columns.
    pub fn width(&self) -> u32 {
        self.x1.saturating_sub(self.x0)
    }

    /// Rows.
    pub fn height(&self) -> u32 {
        self.y1.saturating_sub(self.y0)
    }

    /// Number of pixels.
    pub fn pixels(&self) -> usize {
        self.width() as usize * self.height() as usize
    }
}

/// How the light along a camera ray is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u32)]
pub enum Integrator {
    /// Algorithm 1 of the study: no light sampling, the first emitter or the sky ends the path, which is black after
    /// `max_bounces` surfaces. For measuring.
    Essay = 0,
    /// Next-event estimation over emitters and sky with multiple importance sampling and Russian roulette.
    #[default]
    Path = 1,
}

impl Integrator {
    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Essay => "essay",
            Self::Path => "path",
        }
    }
}
