//! What the window opens: small built-in scenes, files, some of them damaged, and what stands for a volume and for points.

use super::common::room;
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;
use voxtrace::import::{Content, ImportOptions, load};
use voxtrace::points::Attributes;
use voxtrace::{PackedScene, Volume, scenes};
use voxtrace_viewer::{Loader, PointsSeen, Reading, Told, ValuesSeen, Wanted};

/// A scene that comes with values, and one that comes with points; both are the room.
const VOLUME: &str = "scan.vxt";
const POINTS: &str = "points.vxt";

/// Reads files and small built-in scenes.
pub struct Files;

/// Values of a volume of 16³ voxels: a ball that is denser in its middle.
fn volume() -> Volume {
    let at = |index: usize| (index as f32 - 7.5).powi(2);
    let value = |i: usize| 1000.0 - 8.0 * (at(i % 16) + at(i / 16 % 16) + at(i / 256));
    Volume::new([16; 3], (0..16 * 16 * 16).map(value).collect())
}

fn values() -> ValuesSeen {
    let volume = volume();
    let statistics = volume.statistics();
    ValuesSeen { histogram: volume.histogram(statistics.lowest, statistics.highest), statistics }
}

impl Loader for Files {
    fn load(
        &self,
        source: &str,
        reading: &Reading,
        tell: Box<dyn Fn(Told) + Send>,
        _: &Wanted,
    ) -> Result<PackedScene, String> {
        tell(Told::Note(format!("reading {source}")));
        if source.ends_with(VOLUME) {
            tell(Told::Values(Arc::new(values())));
            // Making all voxels takes longer.
            std::thread::sleep(Duration::from_millis(if reading.coarse.is_some() { 10 } else { 60 }));
        }
        if source.ends_with(POINTS) {
            let attributes = Attributes { classes: true, ..Attributes::default() };
            tell(Told::Points(Arc::new(PointsSeen { count: 90, attributes, classes: vec![(2, 60), (6, 30)] })));
        }
        if scenes::NAMES.contains(&source) {
            let scene = scenes::generate(source, Some(20_000)).map_err(|error| error.to_string())?;
            return PackedScene::pack(&scene).map_err(|error| error.to_string());
        }
        let loaded = load(Path::new(source), &ImportOptions::default()).map_err(|error| error.to_string())?;
        match loaded.content {
            Content::Packed(packed) => Ok(*packed),
            Content::Scene(scene) => PackedScene::pack(&scene).map_err(|error| error.to_string()),
        }
    }

    /// Stands for a recording: it goes on until nobody wants it, or a second is over.
    fn run(&self, _: &[String], tell: Box<dyn Fn(Told) + Send>, wanted: &Wanted) -> Result<(), String> {
        for step in 0..20 {
            tell(Told::Progress {
                work: "recording".into(),
                share: Some(step as f32 / 20.0),
                seconds_left: Some(f64::from(20 - step) / 20.0),
            });
            std::thread::sleep(Duration::from_millis(50));
            if wanted.is_over() {
                return Err("stopped".into());
            }
        }
        Ok(())
    }

    fn save(&self, scene: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
        scene.save(path).map(|()| Vec::new()).map_err(|error| error.to_string())
    }

    fn volume(&self, source: &str, _: &Wanted) -> Result<Option<Volume>, String> {
        Ok(source.ends_with(VOLUME).then(volume))
    }

    fn built_in(&self) -> Vec<(String, String)> {
        scenes::NAMES.iter().map(|&name| (name.to_owned(), "a scene".to_owned())).collect()
    }
}

/// Files to open, some of them damaged.
pub fn files(folder: &Path) -> Vec<String> {
    let path = |name: &str| folder.join(name);
    let packed = PackedScene::pack(&room()).unwrap();
    for name in ["room.vxt", VOLUME, POINTS] {
        packed.save(&path(name)).unwrap();
    }
    let whole = std::fs::read(path("room.vxt")).unwrap();
    std::fs::write(path("short.vxt"), &whole[..whole.len() / 2]).unwrap();
    let mut changed = whole;
    let middle = changed.len() / 2;
    changed[middle] ^= 0x55;
    std::fs::write(path("changed.vxt"), &changed).unwrap();
    std::fs::write(path("noise.vox"), b"VOX \x96\0\0\0MAIN nothing of the kind").unwrap();
    let names = [
        "room.vxt",
        "room.vxt",
        VOLUME,
        VOLUME,
        POINTS,
        POINTS,
        "short.vxt",
        "changed.vxt",
        "noise.vox",
        "nowhere.ply",
    ];
    let files = names.iter().map(|name| path(name).display().to_string());
    files.chain(["church", "city", "glass", "forest"].map(str::to_owned)).collect()
}
