//! The volume that the window shows, kept in memory: another transfer function makes other voxels of it without reading the file again.

use crate::failure::Failure;
use crate::import::Held;
use crate::load::SceneArgs;
use crate::report::Report;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::SystemTime;
use voxtrace::Volume;
use voxtrace::import::Content;
use voxtrace::points::Attributes;
use voxtrace::volume::ValueStatistics;
use voxtrace_viewer::{PointsSeen, Told, ValuesSeen};

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
        let mut keep = |held: Held| match held {
            Held::Volume(volume, values) => {
                let histogram = volume.histogram(values.lowest, values.highest);
                tell(Told::Values(Arc::new(ValuesSeen { statistics: (*values).clone(), histogram })));
                if volume.values.len() * 4 <= MOST_BYTES {
                    *self.locked() = Some(Kept { path: path.clone(), stamp: stamp_of(&path), volume, values });
                }
            }
            Held::Points(cloud) => {
                let mut counts = [0u64; 256];
                cloud.classes.iter().for_each(|&class| counts[usize::from(class)] += 1);
                let classes = (0..=255).zip(counts).filter(|&(_, count)| count > 0).collect();
                let (count, attributes) = (cloud.positions.len() as u64, Attributes::of(cloud));
                tell(Told::Points(Arc::new(PointsSeen { count, attributes, classes })));
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

#[cfg(test)]
mod tests {
    use crate::verbs::view::ViewerArgs;
    use clap::Parser;
    use std::sync::{Arc, Mutex};
    use voxtrace::PackedScene;
    use voxtrace_viewer::{Loader, PointsChoice, Reading, Told, Wanted};

    #[derive(Parser)]
    struct Words {
        #[command(flatten)]
        view: ViewerArgs,
    }

    /// A ball of values in a NumPy file, 0 at its edge and 24 in its middle.
    fn ball(path: &std::path::Path) {
        let header = "{'descr': '<f4', 'fortran_order': False, 'shape': (48, 48, 48), }";
        let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
        bytes.extend(format!("{header:<117}\n").bytes());
        for i in 0..48 * 48 * 48 {
            let at = [i / 2304, i / 48 % 48, i % 48].map(|at| at as f32 - 23.5);
            bytes.extend((24.0 - at.iter().map(|x| x * x).sum::<f32>().sqrt()).to_le_bytes());
        }
        std::fs::write(path, bytes).unwrap();
    }

    fn loaded(loader: &dyn Loader, path: &str, reading: &Reading) -> (PackedScene, Vec<Told>) {
        let told = Arc::new(Mutex::new(Vec::new()));
        let kept = Arc::clone(&told);
        let tell = Box::new(move |what| kept.lock().unwrap().push(what));
        let scene = loader.load(path, reading, tell, &Wanted::default()).unwrap();
        (scene, std::mem::take(&mut *told.lock().unwrap()))
    }

    fn loader(options: &str) -> impl Loader + use<> {
        let words = ["view"].into_iter().chain(options.split(' ').filter(|word| !word.is_empty()));
        Words::parse_from(words).view.into_loader()
    }

    #[test]
    fn another_transfer_function_of_a_kept_volume_makes_what_the_command_line_makes() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("ball.npy");
        ball(&path);
        let name = path.display().to_string();
        let own = loader("--transfer mri");
        let (first, told) = loaded(&own, &name, &Reading::default());
        let Some(Told::Values(seen)) = told.iter().find(|told| matches!(told, Told::Values(_))) else {
            panic!("{told:?}")
        };
        assert_eq!(seen.histogram.iter().sum::<u64>(), 48 * 48 * 48);
        // What stays in memory is not read again.
        let stamp = std::fs::metadata(&path).unwrap().modified().unwrap();
        let mut bytes = std::fs::read(&path).unwrap();
        bytes[128..].fill(0);
        std::fs::write(&path, &bytes).unwrap();
        std::fs::File::options().write(true).open(&path).unwrap().set_modified(stamp).unwrap();
        let word = "stops:10=#ff8040,20=#ffffff,threshold=12";
        let reading = Reading { is_again: true, transfer: Some(word.into()), ..Reading::default() };
        let (again, told) = loaded(&own, &name, &reading);
        assert!(!told.iter().any(|told| matches!(told, Told::Values(_))));
        let (coarse, _) = loaded(&own, &name, &Reading { coarse: Some(12), ..reading.clone() });
        assert!(coarse.statistics().voxels * 8 < again.statistics().voxels);
        let (min, max) = coarse.bounds().unwrap();
        let (least, most) = again.bounds().unwrap();
        assert!((min - least).abs().max_element() <= 4.0 && (max - most).abs().max_element() <= 4.0, "{min} {max}");
        // A file that was changed is read again.
        ball(&path);
        std::fs::File::options()
            .write(true)
            .open(&path)
            .unwrap()
            .set_modified(stamp + std::time::Duration::from_secs(9))
            .unwrap();
        let (fresh, _) = loaded(&loader(&format!("--transfer {word}")), &name, &Reading::default());
        assert_eq!(again.content_hash(), fresh.content_hash());
        assert_ne!(again.content_hash(), first.content_hash(), "the comparison sees another transfer function");
        let (read, told) = loaded(&own, &name, &reading);
        assert!(told.iter().any(|told| matches!(told, Told::Values(_))) && read.content_hash() == fresh.content_hash());
    }

    #[test]
    fn points_are_read_again_by_class_as_the_command_line_reads_them() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("west.las");
        std::fs::write(&path, voxtrace_test_support::las_tile([100, 50])).unwrap();
        let name = path.display().to_string();
        let own = loader("--voxel-size 1m");
        let (first, told) = loaded(&own, &name, &Reading::default());
        let Some(Told::Points(seen)) = told.iter().find(|told| matches!(told, Told::Points(_))) else {
            panic!("{told:?}")
        };
        assert_eq!(seen.classes.iter().map(|(_, count)| count).sum::<u64>(), seen.count);
        let class = seen.classes[0].0;
        let choice = PointsChoice {
            color_by: Some("height"),
            classes: Some(vec![class]),
            min_points: Some(1),
            ..PointsChoice::default()
        };
        let reading = Reading { is_again: true, points: Some(choice), ..Reading::default() };
        let (again, _) = loaded(&own, &name, &reading);
        let options = format!("--voxel-size 1m --color-by height --classes {class} --min-points 1");
        let (fresh, _) = loaded(&loader(&options), &name, &Reading::default());
        assert_eq!(again.content_hash(), fresh.content_hash());
        assert_ne!(again.content_hash(), first.content_hash(), "the comparison sees another colour");
    }
}
