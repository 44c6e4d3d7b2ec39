//! What each action of the table of keys does to the state.

use crate::benchmark::{FRAMES, WARM_UP};
use crate::camera_toml::camera_toml;
use crate::canvas::USUAL;
use crate::comparison::{Comparison, DIVIDER_STEP};
use crate::dialogs::{Dialog, FramesDialog, OpenDialog, PictureDialog, PlanDialog, RecordDialog, SaveDialog};
use crate::engine::Pause;
use crate::export::free_name;
use crate::keys::Action;
use crate::navigation::{Mode, Motion};
use crate::render_command::{CommandError, RenderCommand, SceneArgument};
use crate::render_settings::RenderSettings;
use crate::session::{Command, Open, Session, is_built_in};
use crate::tr;
use std::path::PathBuf;
use voxtrace::glam::Vec2;
use voxtrace::{Camera, Integrator, scenes};
use voxtrace_vulkan::{Primitive, Traversal};

/// Steps of the factors on light and sky: a third of a stop.
const LIGHT_STEP: f32 = 1.259_921;
/// The factor that is the first step up from none.
const LEAST_LIGHT: f32 = 0.01;
/// Steps of the field of view, degrees.
const FIELD_STEP: f32 = 5.0;
/// A voxel that is shown fills this many voxels around it.
const AROUND: f32 = 12.0;

/// A factor times another; from darkness upwards there is a first step.
fn scaled(now: f32, factor: f32) -> f32 {
    if now == 0.0 && factor > 1.0 { LEAST_LIGHT } else { now * factor }
}

/// Voxels along the sides of the box of a scene that was begun here.
fn new_size(open: &Open) -> Option<[u32; 3]> {
    open.canvas.map(|canvas| canvas.size().to_array().map(i32::unsigned_abs))
}

impl Session {
    /// Does what an action asks for, with the cursor at a place in the picture.
    pub fn act(&mut self, action: Action, cursor: Option<Vec2>) {
        match action {
            Action::Open => self.ask(Command::AskForFile),
            Action::OpenByPath => self.dialog = Some(Dialog::Open(OpenDialog::new(self))),
            Action::RenderPicture => self.open_dialog(|session| Dialog::Picture(PictureDialog::new(session))),
            Action::RenderFrames => self.open_dialog(|session| Dialog::Frames(Box::new(FramesDialog::new(session)))),
            Action::ToggleEditing => self.toggle_editing(),
            Action::Edit(action) => self.edit_act(action, cursor),
            Action::SaveEdits => self.save_edits(),
            Action::Timeline => self.toggle_timeline(),
            Action::Plan => self.dialog = Some(Dialog::Plan(Box::new(PlanDialog::new(self)))),
            Action::Values => self.toggle_value_drag(),
            Action::Play => self.toggle_play(),
            Action::Record => self.open_dialog(|session| Dialog::Record(Box::new(RecordDialog::new(session)))),
            Action::New => self.dialog = Some(Dialog::New(self.open.as_ref().and_then(new_size).unwrap_or(USUAL))),
            Action::SaveScene => self.open_dialog(|session| Dialog::Save(SaveDialog::new(session))),
            Action::Screenshot => self.screenshot(),
            Action::Quit => self.ask(Command::Quit),
            Action::Cancel => self.cancel(),
            Action::ToggleMode => {
                self.set_mode(if self.navigator.mode == Mode::Fly { Mode::Orbit } else { Mode::Fly });
            }
            Action::ToggleWalking => self.toggle_walking(),
            Action::WalkHere => self.walk_here(cursor),
            Action::SpeedUp => self.move_by(Motion::Speed(1.0)),
            Action::SpeedDown => self.move_by(Motion::Speed(-1.0)),
            Action::FrameAll => self.move_by(Motion::FrameAll),
            Action::FramePicked => self.frame_picked(cursor),
            Action::View(view) => self.move_by(Motion::View(view)),
            Action::Level => self.move_by(Motion::Level),
            Action::FieldOfViewUp => self.widen(FIELD_STEP),
            Action::FieldOfViewDown => self.widen(-FIELD_STEP),
            Action::FocusHere => self.focus_at(cursor),
            Action::UndoCamera => self.undo_camera(true),
            Action::RedoCamera => self.undo_camera(false),
            Action::NextCamera => self.step_camera(1),
            Action::PreviousCamera => self.step_camera(-1),
            Action::GoToBookmark(number) => self.go_to_bookmark(number),
            Action::StoreBookmark(number) => self.store_bookmark(number),
            Action::PrintCamera => {
                let text = camera_toml(self.navigator.camera());
                self.ask(Command::Print(text.clone()));
                self.copy(text, tr!("said.camera_toml"));
            }
            Action::CopyCommand => self.copy_command(),
            Action::ExposureUp => self.expose(self.exposure_step),
            Action::ExposureDown => self.expose(-self.exposure_step),
            Action::LightUp => self.scale_light(LIGHT_STEP),
            Action::LightDown => self.scale_light(1.0 / LIGHT_STEP),
            Action::SkyUp => self.scale_sky(LIGHT_STEP),
            Action::SkyDown => self.scale_sky(1.0 / LIGHT_STEP),
            Action::Pause => self.set_paused(!self.is_paused),
            Action::NextTraversal => self.next_traversal(),
            Action::NextIntegrator => self.next_integrator(),
            Action::Compare => self.toggle_comparison(),
            Action::NextContrast => self.next_contrast(),
            Action::NextOtherTraversal => self.next_other_traversal(),
            Action::DividerLeft => self.move_divider(-DIVIDER_STEP),
            Action::DividerRight if self.comparison.is_none() => self.add_time_key(),
            Action::DividerRight => self.move_divider(DIVIDER_STEP),
            Action::Benchmark => self.toggle_benchmark(),
            Action::CopyBenchmark => self.copy_bench_command(),
            Action::HidePicked if self.is_on_timeline() => self.delete_time_key(),
            Action::HidePicked => self.hide_picked(cursor),
            Action::ToggleClipBox => self.toggle_clip_box(),
            Action::IsolatePicked => self.isolate_picked(cursor),
            Action::ShowAll => self.show_all(),
            Action::Pick => self.picked = cursor.and_then(|cursor| self.pick(cursor)),
            Action::Measure => self.toggle_measuring(),
            Action::NextTool => self.next_tool(),
            Action::FinishMeasuring => self.finish_measuring(),
            Action::ToggleTimes => self.has_times = !self.has_times,
            Action::ToggleRealTime => self.toggle_real_time(),
            Action::ToggleBareFilm => self.toggle_bare_film(),
            Action::TogglePanels => self.has_panels = !self.has_panels,
            Action::ToggleFullScreen => self.ask(Command::ToggleFullscreen),
            Action::ScaleUp => self.ask(Command::Scale(1)),
            Action::ScaleDown => self.ask(Command::Scale(-1)),
            Action::Help => self.has_help = !self.has_help,
            // These last as long as a key or a button is held: see `input`.
            Action::Move(_) | Action::Steer(_) => {}
        }
    }

    fn change(&mut self, change: impl FnOnce(&mut RenderSettings)) {
        let mut settings = self.render_settings.clone();
        change(&mut settings);
        self.set_render_settings(settings);
    }

    /// Stops adding samples, or goes on.
    pub fn set_paused(&mut self, is_paused: bool) {
        self.is_paused = is_paused;
        // While something is measured nothing is traced.
        if self.pause() != Pause::Everything {
            self.ask(Command::Pause(self.pause()));
        }
    }

    /// What tracing leaves out.
    pub(crate) fn pause(&self) -> Pause {
        let plays_plan = self.running.as_ref().is_some_and(|running| running.request.measures);
        match self.is_paused {
            _ if self.benchmark.is_some() || plays_plan => Pause::Everything,
            true => Pause::Samples,
            false => Pause::Nothing,
        }
    }

    /// Opens a dialog about the scene.
    fn open_dialog(&mut self, make: impl FnOnce(&Self) -> Dialog) {
        match self.open {
            Some(_) => self.dialog = Some(make(self)),
            None => self.say(tr!("said.there_is_no_scene_yet"), false),
        }
    }

    fn cancel(&mut self) {
        if self.dialog.take().is_some() || self.leaving.is_some() {
            // The dialog goes first, and with it what waits for it.
            self.stay();
        } else if !self.left_behind.is_empty() {
            // Later: they are offered again when a window is opened.
            self.left_behind.clear();
        } else if self.stop_value_drag() {
            // Dragging moves the camera again.
        } else if let Some(loading) = self.loading.take() {
            self.stay_as_shown(loading.is_again);
            self.play_what_was_read();
            self.say(tr!("said.opening_was_stopped"), false);
        } else if self.has_help {
            self.has_help = false;
        } else if let Some(benchmark) = &self.benchmark {
            benchmark.cancel();
        } else if self.stop_making() {
            // One at a time, the quickest to make again first.
        } else if self.timeline.is_playing() {
            self.toggle_play();
        } else if self.cancel_measuring() || self.cancel_editing() {
            // Points first, then the tool.
        } else if self.dismiss_errors() {
            // That was it.
        } else if self.picked.take().is_none() {
            self.ask(Command::LeaveFullscreen);
        }
    }

    /// Stops what is made beside the window: voxels of a volume, a recording, a plan that is played, pictures that are rendered. Returns whether there
    /// was something.
    fn stop_making(&mut self) -> bool {
        if self.stop_shaping() {
            self.say(tr!("said.voxels_are_not_made"), false);
            return true;
        }
        if let Some(running) = self.running.as_mut().filter(|running| !running.is_stopping) {
            running.cancel();
            let what = running.request.name.clone();
            self.say(tr!("said.stopping", what = what), false);
            return true;
        }
        let exporting = self.exporting.as_ref();
        exporting.map(crate::export::Exporting::cancel).is_some()
    }

    fn frame_picked(&mut self, cursor: Option<Vec2>) {
        let picked = self.picked.clone().or_else(|| cursor.and_then(|cursor| self.pick(cursor)));
        match picked {
            Some(picked) => self.move_by(Motion::Frame { min: picked.point - AROUND, max: picked.point + AROUND }),
            None => self.move_by(Motion::FrameAll),
        }
    }

    fn step_camera(&mut self, step: isize) {
        let Some(open) = &self.open else { return };
        let cameras = &open.original.cameras;
        if cameras.is_empty() {
            self.say(tr!("said.the_scene_has_no_cameras_of"), false);
            return;
        }
        // Names may stand twice; a camera that moved keeps its name.
        let now = self.navigator.camera();
        let here = cameras.iter().position(|camera| camera == now);
        let here = here.or_else(|| cameras.iter().position(|camera| camera.name == now.name));
        let next = match (here, step) {
            (None, 1..) => 0,
            (here, _) => (here.unwrap_or(0) as isize + step).rem_euclid(cameras.len() as isize) as usize,
        };
        let camera = cameras[next].clone();
        self.say(tr!("said.camera", name = camera.name), false);
        self.move_by(Motion::GoTo(camera));
    }

    fn expose(&mut self, stops: f32) {
        self.change(|settings| settings.tone_map.exposure += stops);
    }

    fn scale_light(&mut self, factor: f32) {
        let Some(now) = self.open.as_ref().map(|open| open.lit.light_intensity) else { return };
        self.change(|settings| settings.light_intensity = Some(scaled(now, factor)));
    }

    fn scale_sky(&mut self, factor: f32) {
        let Some(now) = self.open.as_ref().map(|open| open.lit.sky.brightness()) else { return };
        self.change(|settings| settings.sky_brightness = Some(scaled(now, factor)));
    }

    fn next_traversal(&mut self) {
        let all = &self.traversals;
        let here = all.iter().position(|&traversal| traversal == self.render_settings.traversal).unwrap_or(0);
        let next = all[(here + 1) % all.len()];
        self.change(|settings| settings.traversal = next);
        self.say_unseen(tr!("said.traversal"), next.name());
    }

    fn next_integrator(&mut self) {
        let is_path = self.render_settings.integrator == Integrator::Path;
        let next = if is_path { Integrator::Essay } else { Integrator::Path };
        self.change(|settings| settings.take_integrator(next));
        self.say_unseen(tr!("said.integrator"), next.name());
    }

    /// Says what a key has chosen where no panel shows it.
    fn say_unseen(&mut self, what: &str, name: &str) {
        if !self.has_panels {
            self.say(tr!("said.chosen", what = what, name = name), false);
        }
    }

    /// Puts a text on the clipboard, and says so.
    pub fn copy(&mut self, text: String, what: &str) {
        self.ask(Command::Copy(text));
        self.say(tr!("said.copied", what = what), false);
    }

    fn copy_command(&mut self) {
        let command = if self.has_motion() { self.frame_command() } else { self.render_command() };
        self.copy_command_of(command, tr!("said.command_of_picture"));
    }

    /// Copies the command that renders the picture of the tracer that is compared with.
    pub fn copy_other_command(&mut self) {
        let Some(other) = self.comparison.clone() else { return };
        let settings = self.render_settings.clone();
        let Comparison { traversal, primitive, fast, .. } = other;
        let command = self.command_with(&RenderSettings { traversal, primitive, fast, ..settings });
        self.copy_command_of(command, tr!("said.command_of_other"));
    }

    /// Copies the command that measures the view.
    fn copy_bench_command(&mut self) {
        let cells = self.bench_cells();
        let line = self.render_command().map(|command| command.bench_line(&cells, FRAMES, WARM_UP));
        self.copy_line(line, tr!("said.command_of_bench"));
    }

    /// Copies a command, or says why there is none.
    pub fn copy_command_of(&mut self, command: Option<RenderCommand>, what: &str) {
        self.copy_line(command.map(|command| command.line()), what);
    }

    fn copy_line(&mut self, line: Option<Result<String, CommandError>>, what: &str) {
        match line {
            None => match self.edited_file() {
                Err(reason) => self.say(reason, true),
                Ok(_) => self.say(tr!("said.there_is_no_scene_to_render"), false),
            },
            Some(Ok(line)) => {
                self.ask(Command::Print(line.clone()));
                self.copy(line, what);
            }
            Some(Err(error)) => self.say(tr!("said.no_command", error = error), true),
        }
    }

    /// Hides the object that was picked, or that is under the cursor.
    fn hide_picked(&mut self, cursor: Option<Vec2>) {
        let picked = self.picked.take().or_else(|| cursor.and_then(|cursor| self.pick(cursor)));
        let object = picked.zip(self.open.as_ref()).and_then(|(picked, open)| open.object_of(&picked.hit));
        match object {
            Some(object) => {
                self.set_visible(&[object], false);
                self.say(tr!("said.object_is_hidden", object = object), false);
            }
            None => self.say(tr!("outliner.nothing_picked"), false),
        }
    }

    /// Shows what was hidden in this window, not what the file hides.
    fn show_all(&mut self) {
        let Some(open) = &self.open else { return };
        let hidden = open.outline.objects.iter().zip(&open.is_visible).enumerate();
        let hidden = hidden.filter(|(_, (object, is_visible))| !object.is_hidden && !**is_visible);
        let objects: Vec<usize> = hidden.map(|(index, _)| index).collect();
        if !objects.is_empty() {
            self.set_visible(&objects, true);
        }
    }

    /// The command that renders what is shown, with the samples that are asked for.
    pub fn render_command(&self) -> Option<RenderCommand> {
        self.command_with(&self.render_settings)
    }

    fn command_with(&self, settings: &RenderSettings) -> Option<RenderCommand> {
        let open = self.open.as_ref()?;
        let edited = self.edited_file().ok()?;
        let is_edited = edited.is_some();
        let scene = match is_built_in(&open.source) {
            _ if is_edited => SceneArgument::File(edited.unwrap_or_default()),
            true => SceneArgument::BuiltIn {
                name: open.source.clone(),
                voxels: self.built_in_voxels.filter(|_| scenes::default_voxels(&open.source).is_some()),
            },
            false => SceneArgument::File(PathBuf::from(&open.source)),
        };
        // What was edited has its materials, and lacks what was hidden, in its file.
        let (changes, shown) = if is_edited { Default::default() } else { open.changes() };
        let is_device = settings.traversal != Traversal::Cpu;
        let has_primitive = matches!(settings.traversal, Traversal::Query | Traversal::Pipeline);
        Some(RenderCommand {
            scene_options: if is_edited { Vec::new() } else { self.options_of_reading() },
            usual_camera: open.original.cameras.first().cloned(),
            size: self.size(),
            samples: settings.samples,
            integrator: settings.integrator,
            max_bounces: settings.max_bounces,
            bounce_limits: settings.bounce_limits,
            clamp_indirect: settings.clamp_indirect,
            clear_shadows: settings.clear_shadows,
            lines: settings.drawn_lines(),
            tone_map: settings.tone_map,
            traversal: Some(settings.traversal),
            primitive: has_primitive
                .then_some(settings.primitive)
                .filter(|&primitive| primitive != Primitive::default()),
            fast: settings.fast && is_device,
            sky_brightness: settings.sky_brightness,
            light_intensity: settings.light_intensity,
            sun: settings.sun,
            sun_disc: settings.sun_disc,
            sky: settings.sky.clone(),
            sky_rotation: settings.sky_rotation,
            cutting: settings.cutting.clone(),
            surroundings: settings.surroundings,
            materials: changes.materials,
            hidden: changes.hidden,
            shown,
            ..RenderCommand::new(scene, self.navigator.camera().clone())
        })
    }

    /// The options with which the scene is read, with what was chosen here.
    fn options_of_reading(&self) -> Vec<String> {
        let options = crate::transfer::with_transfer(&self.scene_options, self.chosen_transfer());
        self.chosen_points().map_or_else(|| options.clone(), |points| points.over(&options))
    }

    /// The camera as that command has it: options move the scene's first camera, and its name, which stands in files, stays.
    pub fn render_camera(&self) -> Camera {
        let first = self.open.as_ref().and_then(|open| open.original.cameras.first());
        let name = first.map_or("auto", |camera| camera.name.as_str()).to_owned();
        Camera { name, ..self.navigator.camera().clone() }
    }

    fn screenshot(&mut self) {
        if self.open.is_none() {
            return;
        }
        // The whole path tells where to look for it.
        let folder = std::env::current_dir().unwrap_or_default();
        let path = free_name(&folder, &self.stem());
        self.ask(Command::Save(path));
    }
}
