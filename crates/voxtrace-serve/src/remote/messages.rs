//! What clients of pictures say, and how pictures travel. `docs/serve.md` has the protocol.

use crate::picture::Shown;
use serde::{Deserialize, Serialize};
use std::io;
use voxtrace::camera::Lens;
use voxtrace::glam::Vec3;
use voxtrace::{Camera, Frame, PackedScene, TraceError};

/// Most pixels of a picture.
pub const MOST_PIXELS: u32 = 1920 * 1200;
/// Most samples that a client may ask for.
const MOST_SAMPLES: u32 = 4096;

/// A message of a client, JSON.
#[derive(Debug, Deserialize)]
#[serde(tag = "type", rename_all = "lowercase", deny_unknown_fields)]
pub enum Said {
    /// Another view.
    View(View),
    /// A picture was shown: the client can take another one.
    Ack {
        #[allow(dead_code, reason = "it is for people who read messages")]
        frame: u32,
    },
}

/// What a client wants to see.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub struct View {
    /// A number of the client's, which comes back with pictures of this view.
    pub id: u32,
    /// Eye, target and up in world units, and the vertical field of view in degrees.
    pub camera: [f32; 10],
    pub width: u32,
    pub height: u32,
    /// Of each pixel, where the view stands still.
    pub samples: Option<u32>,
}

impl View {
    /// The frame that a tracer renders of it, with all samples.
    pub fn frame(&self, scene: &PackedScene, samples: u32) -> Result<Frame, TraceError> {
        let bad = |line: String| Err(TraceError::BadFrame(line));
        if u64::from(self.width) * u64::from(self.height) > u64::from(MOST_PIXELS) {
            return bad(format!("it has more than {MOST_PIXELS} pixels"));
        }
        let samples = self.samples.unwrap_or(samples);
        if !(1..=MOST_SAMPLES).contains(&samples) {
            return bad(format!("1 to {MOST_SAMPLES} samples of a pixel are rendered"));
        }
        let vector = |at: usize| Vec3::from_slice(&self.camera[at..at + 3]);
        let lens = scene.cameras.first().map_or(Lens::Pinhole, |camera| camera.lens);
        let camera = Camera { up: vector(6), fov_y: self.camera[9], lens, ..Camera::look_at(vector(0), vector(3)) };
        let frame = Frame::new(camera, self.width, self.height).samples(samples);
        frame.check()?;
        frame.check_in(scene)?;
        Ok(frame)
    }
}

/// The first message of the server, JSON.
#[derive(Debug, Serialize)]
#[serde(tag = "type", rename = "scene")]
pub struct Greeting {
    pub name: String,
    pub voxels: u64,
    /// The least and the largest corner of the box around all voxels.
    pub bounds: [[f32; 3]; 2],
    /// The scene's first camera, or one that shows all of it in a picture of 3 : 2.
    pub camera: [f32; 10],
    /// What traces, and why.
    pub tracer: String,
    pub samples: u32,
}

impl Greeting {
    pub fn new(scene: &PackedScene, tracer: String, samples: u32) -> Self {
        let camera = scene.cameras.first().cloned().unwrap_or_else(|| scene.portrait(1.5));
        let vectors = [camera.eye, camera.target, camera.up].map(|vector| vector.to_array());
        let mut numbers = [camera.fov_y; 10];
        numbers[..9].copy_from_slice(vectors.as_flattened());
        let (least, most) = scene.bounds().unwrap_or((Vec3::ZERO, Vec3::ONE));
        Self {
            name: scene.name.clone(),
            voxels: scene.statistics().voxels,
            bounds: [least.to_array(), most.to_array()],
            camera: numbers,
            tracer,
            samples,
        }
    }
}

/// How a picture is packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Packing {
    /// JPEG of that quality.
    Lossy(u8),
    /// PNG.
    Lossless,
}

/// What stands before a picture in its message: little-endian numbers of 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Head {
    /// Number of the picture, from 1.
    pub frame: u32,
    /// That of its view.
    pub view: u32,
    /// Samples of each pixel.
    pub samples: u32,
    /// Of which many there will be.
    pub of: u32,
}

/// A message with a picture: the head, 0 for JPEG or 1 for PNG, and its bytes.
pub fn packed(head: Head, shown: &Shown, packing: Packing) -> io::Result<Vec<u8>> {
    let kind = u32::from(packing == Packing::Lossless);
    let mut bytes = Vec::with_capacity(shown.samples.len() / 4);
    for number in [head.frame, head.view, head.samples, head.of, kind] {
        bytes.extend(number.to_le_bytes());
    }
    match packing {
        Packing::Lossy(quality) => shown.append_jpeg(&mut bytes, quality)?,
        Packing::Lossless => shown.append_png(&mut bytes)?,
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_of_clients_are_read_and_others_are_not() {
        let view = r#"{"type":"view","id":3,"camera":[0,-9,0,0,0,0,0,0,1,45],"width":64,"height":48}"#;
        let Said::View(view) = serde_json::from_str(view).unwrap() else { panic!("a view") };
        let scene = PackedScene::empty();
        assert_eq!(view.frame(&scene, 16).unwrap().samples, 16);
        assert!(matches!(serde_json::from_str(r#"{"type":"ack","frame":1}"#), Ok(Said::Ack { frame: 1 })));
        for text in
            ["", "{}", r#"{"type":"run"}"#, r#"{"type":"ack","frame":-1}"#, r#"{"type":"view","id":1}"#, "[1e999]"]
        {
            assert!(serde_json::from_str::<Said>(text).is_err(), "{text}");
        }
        let wrong = [
            View { width: 0, ..view.clone() },
            View { width: 1 << 20, height: 1 << 20, ..view.clone() },
            View { camera: [f32::NAN; 10], ..view.clone() },
            View { samples: Some(0), ..view.clone() },
            View { samples: Some(u32::MAX), ..view.clone() },
        ];
        assert!(wrong.iter().all(|view| view.frame(&scene, 16).is_err()));
    }
}
