//! Carrying out what the state asks for and needs no window: what traces is told, and threads begin to read, to make and to write.

use super::{Command, Leaving, Session};
use crate::benchmark::Benchmark;
use crate::engine::{Engine, Pause};
use crate::export::{ExportRequest, Exporting, Source};
use crate::inspector::{Sampling, Values};
use crate::load::{Loader, Loading, Reading};
use crate::panels::Status;
use crate::running::{RunRequest, Running};
use crate::threads;
use crate::tr;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, TryRecvError, channel};
use std::thread::JoinHandle;
use voxtrace::{PackedScene, scenes};
use voxtrace_vulkan::Device;

/// Calls whoever waits for the state.
pub type Waker = Arc<dyn Fn() + Send + Sync>;

/// What a thread has to tell when it wakes the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum News {
    /// Of a scene that is read, of values, of a benchmark, of a command that runs beside the window.
    Loading,
    /// Of the scene that is edited.
    Edited,
    /// A sky was made.
    Sky,
    /// A scene was put on a ground, or into fog.
    Surroundings,
    /// Of pictures that are rendered to files.
    Exported,
    /// A scene was written.
    Written,
}

/// What commands are carried out with.
pub struct Means<'a> {
    /// What traces.
    pub engine: &'a Engine,
    /// What reads and writes scenes.
    pub loader: &'a Arc<dyn Loader>,
    /// What is shown of what traces.
    pub status: &'a mut Status,
    /// The device of the window.
    pub device: &'a Arc<Device>,
    /// Wakes the window from another thread.
    pub wake: &'a dyn Fn(News) -> Waker,
}

/// A thread that writes the scene to a file.
#[derive(Debug)]
pub(crate) struct Writing {
    path: PathBuf,
    thread: JoinHandle<()>,
    written: Receiver<Result<Vec<String>, String>>,
}

impl Writing {
    /// Begins to write a scene. `wake` is called when it is over.
    fn start(loader: &Arc<dyn Loader>, scene: Arc<PackedScene>, path: PathBuf, wake: Waker) -> Self {
        let (sender, written) = channel();
        let (loader, of_thread) = (Arc::clone(loader), path.clone());
        let thread = std::thread::spawn(move || {
            threads::yield_to_window();
            // Without an answer the window would wait for it, and not be closed.
            let saved = catch_unwind(AssertUnwindSafe(|| loader.save(&scene, &of_thread)));
            // The window may be closed.
            let _ = sender.send(saved.unwrap_or_else(|_| Err(tr!("said.writing_failed").into())));
            wake();
        });
        Self { path, thread, written }
    }
}

impl Session {
    /// Carries out a command. One that needs the window comes back.
    pub fn carry_out(&mut self, command: Command, means: &mut Means) -> Option<Command> {
        let engine = means.engine;
        match command {
            Command::Load(source) if self.may_leave(Leaving::Load(source.clone())) => self.load(&source, means),
            Command::New(size) if self.may_leave(Leaving::New(size)) => self.show_new(size),
            // Somebody is asked first.
            Command::Load(_) | Command::New(_) => {}
            Command::LoadAgain => self.load_again(means),
            Command::Reshape => self.reshape(means.loader, (means.wake)(News::Loading)),
            Command::Edit => self.start_editor((means.wake)(News::Edited)),
            Command::Follow(followed) => engine.follow(followed.0),
            Command::SetScene => {
                self.settle_edits();
                let lit = self.open.as_ref().map(|open| Arc::clone(&open.lit));
                match lit {
                    Some(lit) if self.has_motion() => engine.move_scene(lit),
                    lit => engine.set_scene(lit),
                }
                means.status.times.clear();
            }
            Command::SetBackend(backend) => {
                engine.set_backend(backend);
                means.status.times.clear();
            }
            Command::SetView => engine.set_view(self.view(), self.is_moving()),
            Command::SetLight(light) => engine.set_light(light),
            Command::Pause(pause) => engine.pause(pause),
            Command::CompareWith(other) => {
                engine.compare_with(other);
                (means.status.other, means.status.differences) = (None, None);
            }
            Command::SetContrast(contrast) => {
                engine.set_contrast(contrast);
                means.status.differences = None;
            }
            Command::MakeSky => self.make_sky((means.wake)(News::Sky)),
            Command::Surround => self.make_surroundings((means.wake)(News::Surroundings)),
            Command::ReadValues => self.read_values(means),
            Command::Benchmark => {
                if let Some(subject) = self.bench_subject(Some(means.device.info().name.clone())) {
                    self.benchmark = Some(Benchmark::start(subject, (means.wake)(News::Loading)));
                }
            }
            Command::Run(request) => self.run_beside(*request, means),
            Command::Export(request) => self.begin_export(*request, means),
            Command::SaveScene(path) => self.save_scene(path, means),
            of_window => return Some(of_window),
        }
        None
    }

    /// Begins to open a scene; the one that is shown stays until it is there.
    fn load(&mut self, source: &str, means: &Means) {
        let of_animation = crate::timeline::scene_to_open(Path::new(source));
        let whole = std::path::absolute(source).unwrap_or_else(|_| source.into());
        self.wanted_timeline = of_animation.as_ref().map(|_| whole);
        let of_animation = match of_animation.transpose() {
            Ok(scene) => scene,
            Err(error) => {
                self.stay_as_shown(false);
                return self.say(error.to_string(), true);
            }
        };
        let source = of_animation.as_deref().unwrap_or(source);
        let source = match scenes::NAMES.contains(&source) {
            true => source.to_owned(),
            // A folder whose name is no text leaves it as it was said.
            false => std::path::absolute(source)
                .ok()
                .and_then(|path| Some(path.to_str()?.to_owned()))
                .unwrap_or(source.to_owned()),
        };
        self.wants_motion = false;
        let reading = Reading { is_cut: self.given_cutting.is_cut(), ..self.motion_wanted(false) };
        self.loading = Some(Loading::start(means.loader, &source, reading, false, (means.wake)(News::Loading)));
    }

    /// Reads the scene again, with what its file hides, or what lies inside, and somebody wants to see.
    fn load_again(&mut self, means: &Means) {
        // One that was on its way is given up.
        self.stay_as_shown(false);
        let Some(open) = &self.open else { return };
        let is_cut = self.render_settings.cutting.is_cut();
        let (transfer, points) = (self.chosen_transfer(), self.chosen_points());
        let reading =
            Reading { shown: open.changes().1, is_cut, is_again: true, points, transfer, ..self.motion_wanted(true) };
        self.loading = Some(Loading::start(means.loader, &open.source, reading, true, (means.wake)(News::Loading)));
    }

    /// How what moves is read: where an animation was opened, or the timeline is shown of a scene whose file has something to play.
    fn motion_wanted(&self, is_again: bool) -> Reading {
        let shown = || self.timeline_that_moves().filter(|_| is_again);
        let animation = self.wanted_timeline.clone().or_else(shown);
        let moves = animation.is_some() || is_again && (self.wants_motion || self.has_motion());
        Reading { moves, animation, ..Reading::default() }
    }

    /// Begins to read the values of the volume that the scene was made of.
    fn read_values(&mut self, means: &Means) {
        let Some(open) = &self.open else { return };
        let (loader, source) = (Arc::clone(means.loader), open.source.clone());
        let world = open.original.georeference.as_ref().map(|of| of.coordinates_from_world);
        self.sampling = Sampling::start(move |wanted| {
            let Some(world) = world else { return Ok(None) };
            Ok(loader.volume(&source, wanted)?.map(|volume| Values::new(volume, world)))
        });
    }

    /// Begins to render pictures to files.
    fn begin_export(&mut self, request: ExportRequest, means: &Means) {
        let Some(open) = &self.open else { return };
        let source = Source {
            changed: Arc::clone(&open.changed),
            lit: Arc::clone(&open.lit),
            backend: self.backend(),
            device: Some(Arc::clone(means.device)),
        };
        let wake = (means.wake)(News::Exported);
        self.exporting = Some(Exporting::start(request, source, move || wake()));
    }

    /// Runs a command beside the window.
    fn run_beside(&mut self, request: RunRequest, means: &Means) {
        if request.measures {
            means.engine.pause(Pause::Everything);
        } else {
            self.say(tr!("said.recording_beside_the_window"), false);
        }
        self.running = Some(Running::start(means.loader, request, (means.wake)(News::Loading)));
    }

    /// Begins to write the scene to a file.
    fn save_scene(&mut self, path: PathBuf, means: &Means) {
        if self.writing.is_some() {
            self.say(tr!("said.another_scene_is_being_written_wait"), true);
            return;
        }
        self.begin_saving(&path);
        let Some(open) = &self.open else { return };
        let scene = Arc::clone(&open.pickable);
        let settings = &self.render_settings;
        if settings.cutting.is_cut() || !settings.surroundings.is_none() {
            self.say(tr!("said.the_file_holds_the_whole_scene"), false);
        }
        self.writing = Some(Writing::start(means.loader, scene, path, (means.wake)(News::Written)));
    }

    /// The file that the scene is being written to.
    pub fn written_file(&self) -> Option<&Path> {
        self.writing.as_ref().map(|writing| writing.path.as_path())
    }

    /// Says what came of writing the scene, once it is over.
    pub fn take_written(&mut self) {
        let Some(writing) = &self.writing else { return };
        let result = match writing.written.try_recv() {
            Err(TryRecvError::Empty) => return,
            Ok(result) => result,
            Err(TryRecvError::Disconnected) => Err(tr!("said.writing_failed").into()),
        };
        let path = self.writing.take().map(|writing| writing.path).unwrap_or_default();
        self.end_saving(result.is_ok());
        match result {
            Ok(notes) => {
                notes.into_iter().for_each(|note| self.say(note, false));
                self.say(tr!("said.written", name = path.display(), kept = ""), false);
            }
            Err(error) => self.say(error, true),
        }
    }

    /// Waits until the scene is written: a file is whole or not there.
    pub(crate) fn finish_writing(&mut self) {
        if let Some(writing) = self.writing.take() {
            // A panic was printed when it happened.
            let _ = writing.thread.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{Told, Wanted};
    use voxtrace::glam::IVec3;
    use voxtrace::{Material, Scene, VoxelGrid};
    use voxtrace_vulkan::Traversal;

    /// Has a fault.
    struct Faulty;

    impl Loader for Faulty {
        fn load(
            &self,
            source: &str,
            _: &Reading,
            _: Box<dyn Fn(Told) + Send>,
            _: &Wanted,
        ) -> Result<PackedScene, String> {
            Err(source.to_owned())
        }

        fn save(&self, _: &PackedScene, _: &Path) -> Result<Vec<String>, String> {
            panic!("the writer has a fault")
        }

        fn built_in(&self) -> Vec<(String, String)> {
            Vec::new()
        }
    }

    #[test]
    fn a_writer_with_a_fault_is_no_writing_without_an_end() {
        let mut grid = VoxelGrid::new();
        grid.set(IVec3::ZERO, 0);
        let scene = Scene::from_grid("voxel", grid, vec![Material::default()]);
        let scene = Arc::new(PackedScene::pack(&scene).unwrap());
        let mut session = Session::new(Traversal::Cpu);
        let loader: Arc<dyn Loader> = Arc::new(Faulty);
        let (sender, woken) = channel();
        let wake = Arc::new(move || sender.send(()).unwrap_or_default());
        session.writing = Some(Writing::start(&loader, scene, "a.vxt".into(), wake));
        woken.recv().expect("the writer ended without an answer");
        session.take_written();
        let said: Vec<String> = session.messages().map(|message| message.text.clone()).collect();
        assert!(session.written_file().is_none() && said[0].contains("could not be written"), "{said:?}");
    }
}
