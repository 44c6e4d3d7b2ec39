//! The volume that the window shows, kept in memory: another transfer function makes other voxels of it without reading the file again.

use crate::load::SceneArgs;
use crate::report::Report;
use crate::failure::Failure;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::SystemTime;
use voxtrace::Volume;
use voxtrace::import::Content;
use voxtrace::volume::ValueStatistics;
use voxtrace_viewer::{Told, ValuesSeen};

/// Largest volume that is kept, bytes of its samples; larger ones are read again.
const MOST_BYTES: usize = 4 << 30;

/// A file as it was when it was read: its size, and when it was changed.
type Stamp = Option<(u64, Option<SystemTime>)>;

struct Kept {
    path: PathBuf,
    stamp: Stamp,
    volume: Arc<Volume>,
    values: Arc<ValueStatistics>,
}

/// The volume that was read last.
#[derive(Default)]
pub struct KeptVolume(Mutex<Option<Kept>>);

fn stamp_of(path: &Path) -> Stamp {
    path.metadata().ok().map(|metadata| (metadata.len(), metadata.modified().ok()))
}

impl KeptVolume {
    /// Loads a scene; a volume is taken from memory where it is `again` the one that was read last, and else kept and told.
    pub fn load(
        &self,
        scene: &SceneArgs,
        again: bool,
        tell: &dyn Fn(Told),
        report: &mut Report,
    ) -> Result<Content, Failure> {
        let path = PathBuf::from(scene.scene());
        if again && let Some((volume, values)) = self.of(&path) {
            let content = scene.import.content_of(&volume, &values, &path, report)?;
            return scene.import.edit(content, report);
        }
        *self.locked() = None;
        let mut keep = |volume: Arc<Volume>, values: Arc<ValueStatistics>| {
            let histogram = volume.histogram(values.lowest, values.highest);
            tell(Told::Values(Arc::new(ValuesSeen { statistics: (*values).clone(), histogram })));
            if volume.values.len() * 4 <= MOST_BYTES {
                *self.locked() = Some(Kept { path: path.clone(), stamp: stamp_of(&path), volume, values });
            }
        };
        scene.load_keeping(&mut keep, report)
    }

    fn of(&self, path: &Path) -> Option<(Arc<Volume>, Arc<ValueStatistics>)> {
        let kept = self.locked();
        let kept = kept.as_ref().filter(|kept| kept.path == path && kept.stamp == stamp_of(path))?;
        Some((Arc::clone(&kept.volume), Arc::clone(&kept.values)))
    }

    fn locked(&self) -> std::sync::MutexGuard<'_, Option<Kept>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
