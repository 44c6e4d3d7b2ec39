//! A part of a picture: some rows, some samples.

use crate::error_of;
use voxtrace_core::{Frame, PackedScene, Region};
use voxtrace_scene::{Camera, camera::Lens, glam::Vec3};
use wasm_bindgen::prelude::*;

/// Numbers of a camera for JavaScript: eye, target, up (three each) and the vertical field of view in degrees.
const CAMERA_NUMBERS: usize = 10;

/// What to render.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Part {
    pub(crate) camera: Vec<f32>,
    pub(crate) clip: Vec<f32>,
    /// Number of the scene's camera whose lens it has; a pinhole where there is none.
    pub lens_of: usize,
    /// Width of the whole picture, pixels.
    pub width: u32,
    /// Height of the whole picture, pixels.
    pub height: u32,
    /// First row.
    pub y0: u32,
    /// Row after the last.
    pub y1: u32,
    /// Samples that each pixel has afterwards.
    pub samples: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// Most surfaces that scatter one path.
    pub max_bounces: u32,
}

#[wasm_bindgen]
impl Part {
    /// All rows of a picture: one sample a pixel, seed 0, up to 8 bounces. `camera` has the numbers of `WebScene::camera`.
    #[wasm_bindgen(constructor)]
    pub fn new(camera: Vec<f32>, width: u32, height: u32) -> Self {
        Self {
            camera,
            clip: Vec::new(),
            lens_of: usize::MAX,
            width,
            height,
            y0: 0,
            y1: height,
            samples: 1,
            seed: 0,
            max_bounces: 8,
        }
    }

    /// Shows only what is within a box, world units: its lowest corner, then its highest one. Without numbers all is shown.
    pub fn set_clip(&mut self, corners: Vec<f32>) {
        self.clip = corners;
    }
}

impl Part {
    /// The frame of a scene that it is.
    ///
    /// # Errors
    /// Where there is no such part of a picture.
    pub(crate) fn frame(&self, scene: &PackedScene) -> Result<Frame, JsError> {
        let numbers = <&[f32; CAMERA_NUMBERS]>::try_from(self.camera.as_slice());
        let numbers = numbers.map_err(|_| JsError::new("a camera has ten numbers"))?;
        let vector = |at: usize| Vec3::from_slice(&numbers[at..]);
        let lens = scene.cameras.get(self.lens_of).map_or(Lens::Pinhole, |camera| camera.lens);
        let camera = Camera { up: vector(6), fov_y: numbers[9], lens, ..Camera::look_at(vector(0), vector(3)) };
        let frame = Frame::new(camera, self.width, self.height).samples(self.samples).seed(self.seed);
        let rows = Region { x0: 0, y0: self.y0, x1: self.width, y1: self.y1 };
        let frame = frame.max_bounces(self.max_bounces).region(rows);
        frame.check().map_err(error_of)?;
        Ok(frame)
    }
}
