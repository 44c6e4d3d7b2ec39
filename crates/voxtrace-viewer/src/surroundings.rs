//! What is around the scene in the window: a ground without end, and fog. Both are further objects, for which the arrays of the scene are copied
//! (`docs/decisions/0053-surroundings.md`): a thread makes them, one after the other, while what was there before stays. All of it is also an
//! option of `voxtrace render`.

use crate::scale::Scale;
use crate::session::{Command, Session};
use crate::threads;
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use voxtrace::PackedScene;
use voxtrace::glam::{DAffine3, DVec3};
use voxtrace::surroundings::{Fog, Ground};

/// What is around a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surroundings {
    /// `--ground` and `--ground-color`.
    pub ground: Option<Ground>,
    /// `--fog`.
    pub fog: Option<Fog>,
}

impl Surroundings {
    /// Whether there is nothing around the scene.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Brings them into a world with voxels of another size, or of another place.
    pub(crate) fn transform(&mut self, new_from_old: &DAffine3) {
        if let Some(height) = self.ground.as_mut().and_then(|ground| ground.height.as_mut()) {
            *height = new_from_old.transform_point3(DVec3::new(0.0, 0.0, f64::from(*height))).z as f32;
        }
        if let Some(fog) = &mut self.fog {
            // On a way as long as before light is scattered as often.
            fog.density /= Scale::times_as_long(new_from_old);
        }
    }

    /// The scene with them.
    ///
    /// # Errors
    /// One line: why there is none.
    pub fn around(&self, scene: &PackedScene) -> Result<PackedScene, String> {
        scene.with_surroundings(self.ground.as_ref(), self.fog.as_ref()).map_err(|error| error.to_string())
    }
}

/// A scene that is being made.
pub(crate) struct Making {
    /// What it is made of.
    alone: Arc<PackedScene>,
    surroundings: Surroundings,
    result: Receiver<Result<PackedScene, String>>,
}

impl Session {
    /// Whether surroundings are being made.
    pub fn is_surrounding(&self) -> bool {
        self.surrounding.is_some()
    }

    /// Puts the scene into the surroundings of the settings, at once where there are none.
    pub(crate) fn change_surroundings(&mut self) {
        let wanted = self.render_settings.surroundings;
        let Some(open) = &mut self.open else { return };
        if wanted.is_none() {
            open.changed = Arc::clone(&open.alone);
            self.change_light();
        } else {
            self.ask(Command::Surround);
        }
    }

    /// Begins to make the surroundings of the settings, unless others are being made: then it is their turn when that is done. `wake` is called
    /// then.
    pub fn make_surroundings(&mut self, wake: Arc<dyn Fn() + Send + Sync>) {
        let surroundings = self.render_settings.surroundings;
        let Some(open) = self.open.as_ref().filter(|_| !surroundings.is_none() && self.surrounding.is_none()) else {
            return;
        };
        let (alone, (sender, result)) = (Arc::clone(&open.alone), channel());
        self.surrounding = Some(Making { alone: Arc::clone(&alone), surroundings, result });
        std::thread::spawn(move || {
            threads::yield_to_window();
            let made = catch_unwind(AssertUnwindSafe(|| threads::aside(|| surroundings.around(&alone))));
            // The window may be closed.
            let _ = sender.send(made.unwrap_or_else(|_| Err(tr!("surroundings.not_made").into())));
            wake();
        });
    }

    /// Takes a scene whose surroundings were made. Where others are asked for by now, those are made next; where they cannot be made, there are
    /// none.
    pub fn take_surroundings(&mut self) {
        let Some(making) = &self.surrounding else { return };
        let result = match making.result.try_recv() {
            Err(TryRecvError::Empty) => return,
            Err(TryRecvError::Disconnected) => Err(tr!("surroundings.not_made").into()),
            Ok(result) => result,
        };
        let Some(Making { alone, surroundings, .. }) = self.surrounding.take() else { return };
        let wanted = self.render_settings.surroundings;
        let Some(open) = &mut self.open else { return };
        match result {
            // Nothing is around the scene any more.
            _ if wanted.is_none() => {}
            Ok(scene) => {
                let is_of_scene = Arc::ptr_eq(&open.alone, &alone);
                if is_of_scene {
                    open.changed = Arc::new(scene);
                    self.change_light();
                }
                if !is_of_scene || wanted != surroundings {
                    self.ask(Command::Surround);
                }
            }
            Err(error) => {
                self.say(error, true);
                self.render_settings.surroundings = Surroundings::default();
                self.change_surroundings();
            }
        }
    }
}
