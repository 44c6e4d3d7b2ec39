//! What all rendered pictures have: size, samples, background.

use super::Dialog;
use crate::session::Session;
use crate::tr;
use voxtrace::frame::MAX_PIXELS;
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
/// Names of the dialogs that choose it.
pub(super) const PICTURE: &str = "picture";
pub(super) const FRAMES: &str = "frames";
pub(super) const RECORD: &str = "record";

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

/// What was chosen when a dialog was last used, for when it opens again.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LastQuality {
    /// Where it was not the window's, which may be another one then.
    size: Option<[u32; 2]>,
    samples: u32,
    transparent: bool,
}

impl Quality {
    /// What the dialog of a name begins with: what was chosen in it last, else a picture as large as the window's with so many samples.
    pub fn of(session: &Session, dialog: &'static str, samples: u32) -> Self {
        let window = session.size().into();
        match session.last_qualities.get(dialog) {
            Some(last) => {
                Self { size: last.size.unwrap_or(window), samples: last.samples, transparent: last.transparent }
            }
            None => Self { size: window, samples, transparent: false },
        }
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
        if u64::from(width) * u64::from(height) > MAX_PIXELS {
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

impl Session {
    /// Keeps what was chosen in a dialog that is used, for when it opens again.
    pub fn remember_quality(&mut self, dialog: &Dialog) {
        let (name, quality) = match dialog {
            Dialog::Picture(dialog) => (PICTURE, &dialog.quality),
            Dialog::Frames(dialog) => (FRAMES, &dialog.quality),
            Dialog::Record(dialog) => (RECORD, &dialog.quality),
            _ => return,
        };
        let Quality { size, samples, transparent } = *quality;
        let size = (size != <[u32; 2]>::from(self.size())).then_some(size);
        self.last_qualities.insert(name, LastQuality { size, samples, transparent });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dialogs::RecordDialog;
    use voxtrace_vulkan::Traversal;

    #[test]
    fn a_dialog_begins_with_what_was_chosen_in_it_last_and_with_the_size_of_the_window_as_it_is() {
        let mut session = Session::new(Traversal::Cpu);
        let mut dialog = RecordDialog::new(&session);
        assert_eq!(dialog.quality, Quality { size: session.size().into(), samples: 64, transparent: false });
        dialog.quality.samples = 16;
        session.remember_quality(&Dialog::Record(Box::new(dialog.clone())));
        session.resize(640, 360);
        assert_eq!(RecordDialog::new(&session).quality, Quality { size: [640, 360], samples: 16, transparent: false });
        dialog.quality = Quality { size: [1920, 1080], samples: 8, transparent: true };
        session.remember_quality(&Dialog::Record(Box::new(dialog.clone())));
        session.resize(800, 600);
        assert_eq!(RecordDialog::new(&session).quality, dialog.quality);
        assert_eq!(Quality::of(&session, PICTURE, 256).samples, 256, "each dialog has its own");
    }
}
