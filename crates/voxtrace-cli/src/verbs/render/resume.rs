//! Films to continue: one of a still, or one for each frame of an animation, where frames without a film begin anew.

use crate::failure::Failure;
use crate::picture::path_of_view;
use crate::verbs::merge::open_film;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use voxtrace::output::{FilmFile, SceneStamp};
use voxtrace::{Film, PackedScene, Region};

/// What a render goes on with.
pub struct Resumed {
    /// The settings of the film, or of the first one of an animation, with the seed of the whole and without pixels.
    pub settings: FilmFile,
    /// The film of a still, until it is taken.
    still: Option<FilmFile>,
    pattern: PathBuf,
}

impl Resumed {
    /// Reads the film, or the first one that there is of an animation's frames.
    pub fn open(pattern: &Path, frames: Option<RangeInclusive<u32>>) -> Result<Self, Failure> {
        let mut path = pattern.to_owned();
        let mut number = 1;
        if let Some(frames) = &frames {
            let path_of = |frame| path_of_view(pattern, None, Some(frame));
            let first = frames.clone().map(|frame| (frame, path_of(frame))).find(|(_, path)| path.exists());
            (number, path) = first.ok_or_else(|| {
                let wanted = path_of(*frames.start());
                let failure = Failure::input(format!("no frame has a film to continue: no {}", wanted.display()));
                failure.hint("name films as --checkpoint does, with #### for the number of the frame")
            })?;
        }
        let file = open_film(&path)?;
        let mut settings = FilmFile {
            frame: file.frame.clone(),
            scene: file.scene.clone(),
            film: Film::new(0, 0, Region::full(0, 0), 0),
        };
        // Each frame adds its number to the seed.
        settings.frame.seed = settings.frame.seed.wrapping_sub(number - 1);
        let still = frames.is_none().then_some(file);
        Ok(Self { settings, still, pattern: pattern.to_owned() })
    }

    /// The name of the film of a frame, or of the still.
    pub fn path(&self, frame: Option<u32>) -> PathBuf {
        frame.map_or_else(|| self.pattern.clone(), |_| path_of_view(&self.pattern, None, frame))
    }

    /// The film of a frame, or of the still; `None` where there is none yet.
    pub fn film(&mut self, frame: Option<u32>) -> Result<Option<FilmFile>, Failure> {
        if frame.is_none() {
            return Ok(self.still.take());
        }
        let path = self.path(frame);
        if path.exists() { open_film(&path).map(Some) } else { Ok(None) }
    }
}

/// The stamp of films of a scene. The hash has its name, too: one whose file was renamed since keeps the name that the film to continue knows.
pub fn stamp_of(scene: &PackedScene, resumed: Option<&FilmFile>) -> SceneStamp {
    let stamp = SceneStamp::of(scene);
    let Some(film) = resumed.map(|file| &file.scene) else { return stamp };
    if film.content_hash == stamp.content_hash || film.name == stamp.name {
        return stamp;
    }
    let mut named = scene.clone();
    named.name.clone_from(&film.name);
    Some(SceneStamp::of(&named)).filter(|named| named.content_hash == film.content_hash).unwrap_or(stamp)
}
