//! Pictures for the window, which others hold for a while.

use std::sync::Arc;
use voxtrace::TraceError;
use voxtrace_vulkan::{Device, Picture};

/// Pictures that were made; those that nobody else holds are used again.
#[derive(Default)]
pub(super) struct Pictures(Vec<Arc<Picture>>);

impl Pictures {
    /// A picture that nobody holds, taken out of the pool. Pictures of other sizes go where nobody holds them.
    pub fn free(
        &mut self,
        device: &Arc<Device>,
        width: u32,
        height: u32,
        by_host: bool,
    ) -> Result<Arc<Picture>, TraceError> {
        let suits =
            |picture: &Arc<Picture>| picture.size() == (width, height) && picture.is_written_by_host() == by_host;
        self.0.retain(|picture| Arc::strong_count(picture) > 1 || suits(picture));
        match self.0.iter().position(|picture| Arc::strong_count(picture) == 1 && suits(picture)) {
            Some(index) => Ok(self.0.swap_remove(index)),
            None => Ok(Arc::new(Picture::new(device, width, height, by_host)?)),
        }
    }

    /// Puts a picture into the pool that others hold for a while.
    pub fn keep(&mut self, picture: &Arc<Picture>) {
        self.0.push(Arc::clone(picture));
    }
}
