//! Skies that take their time, panoramas from files and the sky of air: made one at a time on a thread, while the one before stays.

use crate::render_command::{SkySetting, SunSetting};
use crate::session::{Command, Picked, Session};
use crate::threads;
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use voxtrace::Sky;
use voxtrace::import::{Limits, read_environment};
use voxtrace::sky::EnvironmentMap;

/// What a sky is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum SkySource {
    /// The panorama in a file.
    Panorama(PathBuf),
    /// Air in the light of a sun.
    Air(SunSetting),
}

/// A sky that was made, with what it was made of.
#[derive(Clone, Debug)]
pub enum MadeSky {
    /// A panorama.
    Panorama(PathBuf, Arc<EnvironmentMap>),
    /// A sky of air, of brightness one.
    Air(SunSetting, Sky),
}

impl MadeSky {
    /// Makes a sky, which may take a second or more.
    ///
    /// # Errors
    /// One line: why there is none.
    pub fn of(source: SkySource) -> Result<Self, String> {
        match source {
            SkySource::Panorama(path) => {
                let map = read_environment(&path, &Limits::default()).map_err(|error| error.to_string())?;
                Ok(Self::Panorama(path, map.into()))
            }
            SkySource::Air(sun) => sun.physical_sky().map(|sky| Self::Air(sun, sky)).ok_or(tr!("sky.needs_sun").into()),
        }
    }

    fn is_of(&self, source: &SkySource) -> bool {
        match (self, source) {
            (Self::Panorama(own, _), SkySource::Panorama(path)) => own == path,
            (Self::Air(own, _), SkySource::Air(sun)) => own == sun,
            _ => false,
        }
    }
}

/// The sky that was made last, and the one that is being made.
#[derive(Default)]
pub struct Skies {
    made: Option<MadeSky>,
    making: Option<(SkySource, Receiver<Result<MadeSky, String>>)>,
}

impl Skies {
    /// The sky that was made last.
    pub fn made(&self) -> Option<&MadeSky> {
        self.made.as_ref()
    }

    /// Whether one is being made.
    pub fn is_making(&self) -> bool {
        self.making.is_some()
    }
}

/// Whether a file is a panorama by its name.
pub fn is_panorama(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    ["hdr", "exr"].iter().any(|own| ending.eq_ignore_ascii_case(own))
}

impl Session {
    /// The scene in the light of the settings, once the sky is there.
    pub(crate) fn change_light(&mut self) {
        self.place_moving();
        let source = self.sky_source();
        let Some(open) = &mut self.open else { return };
        match source {
            Some(source) if !self.skies.made.as_ref().is_some_and(|made| made.is_of(&source)) => {
                self.ask(Command::MakeSky);
            }
            _ => {
                // With other objects in the scene, hits have other numbers.
                let object = self.picked.as_ref().and_then(|picked| open.object_of(&picked.hit));
                open.set_light(&self.render_settings, self.skies.made.as_ref());
                self.picked = self.picked.take().and_then(|picked| {
                    let hit = open.hit_of_object(&picked.hit, object?)?;
                    Some(Picked { hit, ..picked })
                });
                self.ask(Command::SetScene);
            }
        }
    }

    /// What the sky of the settings is made of, where that takes its time.
    fn sky_source(&self) -> Option<SkySource> {
        match self.render_settings.sky.as_ref()? {
            SkySetting::Color(_) => None,
            SkySetting::Physical => Some(SkySource::Air(self.sun())),
            SkySetting::Panorama(path) => Some(SkySource::Panorama(path.clone())),
        }
    }

    /// Begins to make the sky of the settings, unless another is being made: then it is its turn when that is done. `wake` is called then.
    pub fn make_sky(&mut self, wake: Arc<dyn Fn() + Send + Sync>) {
        let Some(source) = self.sky_source().filter(|_| !self.skies.is_making()) else { return };
        let (sender, making) = channel();
        self.skies.making = Some((source.clone(), making));
        std::thread::spawn(move || {
            threads::yield_to_window();
            let made = catch_unwind(AssertUnwindSafe(|| MadeSky::of(source)));
            // The window may be closed.
            let _ = sender.send(made.unwrap_or_else(|_| Err(tr!("sky.not_made").into())));
            wake();
        });
    }

    /// Takes a sky that was made. Where another is asked for by now, that is made next; where there is none, the scene's own comes back.
    pub fn take_sky(&mut self) {
        let Some((source, making)) = &self.skies.making else { return };
        let is_wanted = self.sky_source().as_ref() == Some(source);
        let result = match making.try_recv() {
            Err(TryRecvError::Empty) => return,
            Err(TryRecvError::Disconnected) => Err(tr!("sky.not_made").into()),
            Ok(result) => result,
        };
        self.skies.making = None;
        match result {
            Ok(made) => self.skies.made = Some(made),
            Err(error) => {
                self.say(error, true);
                if is_wanted {
                    (self.render_settings.sky, self.render_settings.sky_rotation) = (None, None);
                }
            }
        }
        self.change_light();
    }

    /// Takes a file that was dropped on the window: a panorama is the sky of the scene that is shown, all else is opened.
    pub fn take_dropped(&mut self, path: &Path) {
        if self.open.is_some() && is_panorama(path) {
            self.set_panorama(path);
        } else {
            self.open_file(path);
        }
    }

    /// Puts the scene under the panorama of a file.
    pub fn set_panorama(&mut self, path: &Path) {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let mut settings = self.render_settings.clone();
        (settings.sky, settings.sky_rotation) = (Some(SkySetting::Panorama(path)), None);
        // The panel's field names this one from now on.
        self.panorama = None;
        self.set_render_settings(settings);
    }
}
