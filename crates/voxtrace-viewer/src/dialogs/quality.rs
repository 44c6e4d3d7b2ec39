//! What all rendered pictures have: size, samples, background.

use crate::session::Session;
use crate::tr;
use voxtrace::{Camera, Frame};

/// Sizes to choose from.
pub const PRESETS: [(&str, [u32; 2]); 5] = [
    ("1280 × 720", [1280, 720]),
    ("1920 × 1080", [1920, 1080]),
    ("3840 × 2160", [3840, 2160]),
    ("7680 × 4320", [7680, 4320]),
    ("2048 × 2048", [2048, 2048]),
];
/// Largest edge of a picture.
pub const LARGEST_EDGE: u32 = 65_536;
/// Most samples of a pixel.
pub const MOST_SAMPLES: u32 = 1 << 20;
/// Most pixels of a film, as `render` has it.
const MOST_PIXELS: u64 = 1 << 28;
/// Samples that a dialog begins with.
const SAMPLES: u32 = 256;

/// Size, samples and background.
#[derive(Clone, Debug, PartialEq)]
pub struct Quality {
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// Samples of each pixel.
    pub samples: u32,
    /// Whether the background is left out.
    pub transparent: bool,
}

impl Quality {
    /// Of a picture as large as the window's.
    pub fn of(session: &Session) -> Self {
        Self { size: session.size().into(), samples: SAMPLES, transparent: false }
    }

    /// Checks size, samples and camera.
    ///
    /// # Errors
    /// One line: what `render` refuses too.
    pub fn check(&self, camera: &Camera) -> Result<(), String> {
        let [width, height] = self.size;
        if !self.size.iter().all(|side| (1..=LARGEST_EDGE).contains(side)) {
            return Err(tr!("dialogs.edge").into());
        }
        if u64::from(width) * u64::from(height) > MOST_PIXELS {
            return Err(tr!("dialogs.area").into());
        }
        if !(1..=MOST_SAMPLES).contains(&self.samples) {
            return Err(tr!("dialogs.samples_range").into());
        }
        Ok(camera.check()?)
    }

    /// The frame that a camera sees, by the integrator of the window.
    ///
    /// # Errors
    /// As [`Self::check`].
    pub fn frame(&self, session: &Session, camera: Camera) -> Result<Frame, String> {
        self.check(&camera)?;
        let [width, height] = self.size;
        let view = crate::engine::View { camera, width, height, samples: self.samples, ..session.view() };
        Ok(view.frame().transparent(self.transparent))
    }

    /// About how many seconds a number of such pictures take, from the milliseconds of a sample a pixel of the window's picture.
    pub fn estimate(&self, session: &Session, ms_a_sample: f32, pictures: usize) -> f64 {
        let [width, height] = self.size.map(f64::from);
        let of_window = f64::from(session.size().0) * f64::from(session.size().1);
        f64::from(ms_a_sample) / 1e3 * (width * height / of_window) * f64::from(self.samples) * pictures as f64
    }
}
