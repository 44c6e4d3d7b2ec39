//! Rendering the frames of a turntable or of a flight through the bookmarks.

use super::{PathField, Quality, quality};
use crate::export::{Existing, ExportRequest, Job, frame_path};
use crate::render_command::{RenderCommand, Sequence, quoted};
use crate::session::Session;
use crate::tr;
use std::path::PathBuf;
use voxtrace::Camera;
use voxtrace::camera::Flight;

/// Most frames of one row.
pub const MOST_FRAMES: u32 = 100_000;

/// Where the camera goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// Around what is in the middle of the picture.
    AroundMiddle,
    /// Around the middle of the scene.
    AroundScene,
    /// Through the scene's bookmarks, in the order of their numbers.
    Flight,
}

impl Route {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::AroundMiddle, Self::AroundScene, Self::Flight];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::AroundMiddle => tr!("dialogs_frames.around_middle"),
            Self::AroundScene => tr!("dialogs_frames.around_scene"),
            Self::Flight => tr!("dialogs_frames.flight"),
        }
    }
}

/// What somebody has chosen.
#[derive(Clone, Debug)]
pub struct FramesDialog {
    /// Where the camera goes.
    pub route: Route,
    /// Where frames are written.
    pub folder: PathField,
    /// What they are called: NAME_0001.png and on.
    pub name: String,
    /// How long it takes.
    pub seconds: f32,
    /// Frames a second.
    pub rate: u32,
    /// Size, samples, background.
    pub quality: Quality,
    /// What happens to frames that are there.
    pub existing: Existing,
    /// The folder and name that `existing` was said of.
    existing_where: (String, String),
    /// The flight and the file of its bookmarks, or why there is none.
    flight: Result<(PathBuf, Flight), String>,
    /// Frames that are there, of how many, when they were counted.
    counted: Option<((String, String, u32), u32)>,
}

impl FramesDialog {
    /// What the dialog begins with: a turn of four seconds, or the flight where there are bookmarks.
    pub fn new(session: &Session) -> Self {
        let (stem, folder) = (session.stem(), session.usual_folder());
        let flight = session.flight();
        let has_flight = flight.is_ok();
        Self {
            route: if has_flight { Route::Flight } else { Route::AroundMiddle },
            folder: PathField::new(&folder.join(format!("{stem}-frames"))),
            name: stem,
            seconds: if has_flight { 10.0 } else { 4.0 },
            rate: 30,
            quality: Quality::of(session, quality::FRAMES, 64),
            existing: Existing::Refuse,
            existing_where: Default::default(),
            flight,
            counted: None,
        }
    }

    /// How many frames there are.
    pub fn frames(&self) -> u32 {
        let frames = (f64::from(self.seconds) * f64::from(self.rate)).round();
        if frames.is_finite() { frames.clamp(1.0, f64::from(MOST_FRAMES)) as u32 } else { 1 }
    }

    /// How many of the frames are there already; counted when the folder, the name or their number changes.
    pub fn there(&mut self) -> u32 {
        let named = (self.folder.text.clone(), self.name.clone());
        if self.existing_where != named {
            (self.existing, self.existing_where) = (Existing::Refuse, named);
        }
        let key = (self.folder.text.clone(), self.name.clone(), self.frames());
        if let Some((counted, number)) = &self.counted
            && *counted == key
        {
            return *number;
        }
        let folder = self.folder.path().unwrap_or_default();
        let number = match folder.is_dir() {
            true => (1..=key.2).filter(|&frame| frame_path(&folder, &self.name, frame).exists()).count() as u32,
            false => 0,
        };
        self.counted = Some((key, number));
        number
    }

    /// Reads the bookmarks again.
    pub fn refresh(&mut self, session: &Session) {
        self.flight = session.flight();
    }

    /// Where frames go, if nothing is missing.
    ///
    /// # Errors
    /// One line: what is missing yet.
    pub fn check(&mut self, session: &Session) -> Result<PathBuf, String> {
        let folder = self.folder.path().ok_or(tr!("dialogs.name_a_folder"))?;
        let folder = std::path::absolute(&folder).unwrap_or(folder);
        let is_name = |c: char| !matches!(c, '/' | '\\' | '#');
        if self.name.trim().is_empty() || !self.name.chars().all(is_name) {
            return Err(tr!("dialogs_frames.need_name").into());
        }
        if folder.exists() && !folder.is_dir() {
            return Err(tr!("dialogs.folder_is_file").into());
        }
        self.quality.check(session.navigator.camera())?;
        if self.route == Route::Flight {
            self.flight.as_ref().map_err(Clone::clone)?;
        }
        if self.there() > 0 && self.existing == Existing::Refuse {
            return Err(tr!("dialogs_frames.some_there").into());
        }
        Ok(folder)
    }

    /// What is to be rendered.
    ///
    /// # Errors
    /// One line: what is missing yet, or a size that `render` refuses too.
    pub fn request(&mut self, session: &Session) -> Result<ExportRequest, String> {
        self.refresh(session);
        let folder = self.check(session)?;
        let frames = self.frames();
        let cameras: Box<dyn Fn(u32) -> Camera> = match self.route {
            Route::Flight => {
                let (_, flight) = self.flight.clone()?;
                Box::new(move |frame| flight.frame(frame, frames))
            }
            route => {
                let first = session.turntable_camera(route);
                Box::new(move |frame| first.turned(frame, frames))
            }
        };
        let seed = session.view().seed;
        let job = |frame: u32| {
            // Each frame has noise of its own, as those of `render` have.
            let picture = self.quality.frame(session, cameras(frame))?.seed(seed.wrapping_add(frame - 1));
            Ok(Job { frame: picture, path: frame_path(&folder, &self.name, frame) })
        };
        Ok(ExportRequest {
            jobs: (1..=frames).map(job).collect::<Result<_, String>>()?,
            tone_map: session.render_settings.tone_map,
            sixteen_bits: false,
            existing: self.existing,
        })
    }

    /// Brings the bookmarks' file into the voxels of the scene before the command is copied, which reads them from there.
    ///
    /// # Errors
    /// One line: why the file cannot be read or written.
    pub fn settle(&self, session: &Session) -> Result<(), String> {
        match session.bookmarks().filter(|_| self.route == Route::Flight && self.flight.is_ok()) {
            Some(bookmarks) => {
                bookmarks.and_then(|mut bookmarks| bookmarks.settle()).map_err(|error| error.to_string())
            }
            None => Ok(()),
        }
    }

    /// The command that renders the same frames.
    pub fn command(&self, session: &Session) -> Option<RenderCommand> {
        let frames = self.frames();
        let (sequence, camera) = match self.route {
            Route::Flight => {
                let (file, _) = self.flight.clone().ok()?;
                (Sequence::Flight { file, frames }, session.navigator.camera().clone())
            }
            route => (Sequence::Turntable(frames), session.turntable_camera(route)),
        };
        let folder = self.folder.path()?;
        Some(RenderCommand {
            camera,
            size: self.quality.size.into(),
            samples: self.quality.samples,
            transparent: self.quality.transparent,
            sequence: Some(sequence),
            outputs: vec![folder.join(format!("{}_####.png", self.name))],
            ..session.render_command()?
        })
    }

    /// The command that makes a film of the frames.
    pub fn ffmpeg(&self) -> String {
        let folder = self.folder.path().unwrap_or_default();
        ffmpeg_line(&folder.join(&self.name), self.rate, self.quality.size)
    }
}

/// The command of ffmpeg for frames `NAME_0001.png` and on: H.264 that every player shows, which has even sides.
pub fn ffmpeg_line(name: &std::path::Path, rate: u32, size: [u32; 2]) -> String {
    // In a pattern, a percent sign is two.
    let name = name.display().to_string();
    let pattern = quoted(&format!("{}_%04d.png", name.replace('%', "%%")));
    let is_odd = size.iter().any(|side| side % 2 == 1);
    let pad = if is_odd { " -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2'" } else { "" };
    format!(
        "ffmpeg -framerate {rate} -i {pattern}{pad} -c:v libx264 -crf 16 -pix_fmt yuv420p {}",
        quoted(&format!("{name}.mp4"))
    )
}

impl Session {
    /// The flight through the scene's bookmarks, and their file.
    ///
    /// # Errors
    /// One line: why there is none.
    pub fn flight(&self) -> Result<(PathBuf, Flight), String> {
        let found = self.bookmark_path().zip(self.bookmarks());
        let (path, bookmarks) = found.ok_or(tr!("dialogs_frames.no_bookmarks"))?;
        let bookmarks = bookmarks.map_err(|error| error.to_string())?;
        let cameras: Vec<Camera> = bookmarks.iter().map(|(_, camera)| camera.clone()).collect();
        if cameras.len() < 2 {
            return Err(tr!("dialogs_frames.two_bookmarks").into());
        }
        Ok((path, Flight::through(&cameras)?))
    }

    /// The camera that a turntable begins with: the present one, with what is in the middle of the picture as its target, or turned to
    /// the middle of the scene.
    pub fn turntable_camera(&self, route: Route) -> Camera {
        let camera = self.render_camera();
        let (width, height) = self.size();
        let target = match route {
            Route::AroundScene => {
                let bounds = self.open.as_ref().and_then(|open| open.alone.bounds());
                bounds.map(|(min, max)| (min + max) * 0.5)
            }
            _ => {
                let middle = voxtrace::glam::Vec2::new(width as f32, height as f32) * 0.5;
                self.pick(middle).map(|picked| picked.point)
            }
        };
        // Around where it stands, a camera would only look around.
        match target.filter(|target| target.distance(camera.eye) > 1.0) {
            Some(target) => Camera { target, ..camera },
            None => camera,
        }
    }
}
