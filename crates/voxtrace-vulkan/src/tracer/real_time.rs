//! Real-time light by the tracer.

use super::{Backend, VulkanTracer};
use crate::picture::Picture;
use crate::real_time::{Rate, RealTimeFrame};
use voxtrace_core::{Frame, TraceError};
use voxtrace_realtime::Parts;

impl VulkanTracer {
    /// Traces the next frame of real-time light (`voxtrace-realtime`) and writes it to a picture of the frame's size on the tracer's device. Of `frame` the camera,
    /// size, seed and the settings of light count. The film and its samples stay as they are. What it knows of the view it keeps, through
    /// [`voxtrace_core::Tracer::patch`] and [`voxtrace_core::Tracer::set_placement`] as well, until another scene is set. `None` where the processor traces in
    /// place of a lost device.
    ///
    /// # Errors
    /// [`TraceError::NoScene`] before a scene is set; [`TraceError::BadFrame`] where the frame or the picture does not suit;
    /// [`TraceError::Unsupported`] where the scene lies on the device in pages, or the picture has more pixels than the device's launches take;
    /// [`TraceError::OutOfMemory`];
    /// [`TraceError::DeviceLost`] after a loss: the tracer goes on, on the device opened anew or on the CPU, and the picture lies on the lost one.
    pub fn show_real_time(
        &mut self,
        frame: &Frame,
        rate: Rate,
        picture: &Picture,
    ) -> Result<Option<RealTimeFrame>, TraceError> {
        let result = match &mut self.backend {
            Backend::Device(worker) => worker.show_real_time(frame, rate, picture).map(Some),
            _ => Ok(None),
        };
        if let Err(TraceError::DeviceLost { last_pass }) = &result {
            self.recover(last_pass)?;
        }
        result
    }

    /// Gives back the memory that real-time light took, and forgets what it knows.
    pub fn forget_real_time(&mut self) {
        if let Backend::Device(worker) = &mut self.backend {
            worker.forget_real_time();
        }
    }

    /// Which parts of real-time light are used from now on, and whether its rays are traced exactly; at first all parts, and not exactly. For tests.
    #[doc(hidden)]
    pub fn set_real_time(&mut self, parts: Parts, is_exact: bool) {
        self.real_time_settings = (parts, is_exact);
        if let Backend::Device(worker) = &mut self.backend {
            worker.set_real_time(parts, is_exact);
        }
    }

    /// The words of the buffers of real-time light, for tests: what is known of pixels, what the last frame worked with, keys and rows of cells.
    ///
    /// # Errors
    /// [`TraceError::NoFilm`] before the first frame.
    #[doc(hidden)]
    pub fn real_time_words(&mut self) -> Result<[Vec<u32>; 4], TraceError> {
        match &mut self.backend {
            Backend::Device(worker) => worker.real_time_words(),
            _ => Err(TraceError::NoFilm),
        }
    }
}
