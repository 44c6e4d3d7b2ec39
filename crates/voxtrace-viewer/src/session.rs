//! The state of the window without the window: what happens goes in, what is to be done comes out.

mod carrying;
mod command;
mod editing;
mod keeping;
mod messages;
mod opening;

pub use carrying::{Means, News, Waker};
pub use command::Command;
pub(crate) use keeping::is_built_in;
pub use messages::Message;

use crate::benchmark::Benchmark;
use crate::comparison::{Comparison, backend};
use crate::cutting::Cutting;
use crate::dialogs::{Dialog, LastQuality};
use crate::engine::{Backend, Light, RealTimeChoice, View};
use crate::export::Exporting;
use crate::load::Loading;
use crate::navigation::{Motion, Navigator};
pub use crate::open::Open;
use crate::render_command::{SkySetting, SunSetting};
use crate::render_settings::RenderSettings;
use crate::running::Running;
use crate::settings::Settings;
use crate::skies::Skies;
use crate::surroundings::Making;
use crate::timeline::Timeline;
use crate::transfer::Values;
pub use editing::{Followed, Leaving, extent};
use std::collections::{HashMap, VecDeque};
use voxtrace::glam::Vec2;
use voxtrace::{Camera, Hit};
use voxtrace_bench::Measurement;
use voxtrace_vulkan::Traversal;

/// Seconds without a motion after which the camera is at rest: events of a mouse come with gaps.
const REST: f32 = 0.1;

/// What a voxel under the cursor is.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// What the ray met.
    pub hit: Hit,
    /// Number of its material.
    pub material: u32,
    /// Where the ray met it, world space, voxels.
    pub point: voxtrace::glam::Vec3,
}

/// The state.
pub struct Session {
    /// Where the camera is.
    pub navigator: Navigator,
    /// How the picture is made.
    pub render_settings: RenderSettings,
    /// The scene, once there is one.
    pub open: Option<Open>,
    /// Skies that take their time to make.
    pub skies: Skies,
    /// The path of a panorama while it is typed.
    pub panorama: Option<crate::dialogs::PathField>,
    /// The scene that is being opened.
    pub loading: Option<Loading>,
    /// The pictures that are being rendered to files.
    pub exporting: Option<Exporting>,
    /// A thread that writes the scene to a file.
    pub(crate) writing: Option<carrying::Writing>,
    /// The command that runs beside the window.
    pub running: Option<Running>,
    /// The values of the volume that is open, and what of them is shown.
    pub values: Option<Values>,
    /// What of the scene moves.
    pub(crate) moving: Option<crate::motion::Moving>,
    /// Whether what moves is to be read.
    pub(crate) wants_motion: bool,
    /// The points of the scene that is open.
    pub points: Option<crate::cloud::Points>,
    /// The camera over time.
    pub timeline: Timeline,
    /// An animation whose scene is being opened.
    pub(crate) wanted_timeline: Option<std::path::PathBuf>,
    /// Points that panels take below the picture.
    pub below: f32,
    /// The dialog that is open.
    pub dialog: Option<Dialog>,
    /// What was chosen last, by the names of dialogs.
    pub(crate) last_qualities: HashMap<&'static str, LastQuality>,
    /// Whether the panels are shown.
    pub has_panels: bool,
    /// Whether the list of keys is shown.
    pub has_help: bool,
    /// Whether times, rays and memory are shown over the picture.
    pub has_times: bool,
    /// The light that views are shown in.
    pub light: Light,
    /// Whether the device of the window is no software.
    pub has_hardware: bool,
    /// Whether no samples are added.
    pub is_paused: bool,
    /// Stops of exposure that a key changes.
    pub exposure_step: f32,
    /// What was picked.
    pub picked: Option<Picked>,
    /// Where the cursor is in the picture, while no button is held.
    pub hover: Option<Vec2>,
    /// What the picture is compared with.
    pub comparison: Option<Comparison>,
    /// The comparison before.
    pub last_comparison: Option<Comparison>,
    /// A benchmark on its way.
    pub benchmark: Option<Benchmark>,
    /// What the last one gave.
    pub measured: Option<Vec<Measurement>>,
    /// The traversals that there are on this machine.
    pub traversals: Vec<Traversal>,
    /// Options with which scenes are read, as words of a command.
    pub scene_options: Vec<String>,
    /// How scenes are cut open that are opened.
    pub given_cutting: Cutting,
    /// How large built-in scenes are made, where that was chosen.
    pub built_in_voxels: Option<u64>,
    /// Editing of the scene that is shown, since it began.
    pub editing: Option<crate::editing::Editing>,
    /// What waits until somebody has said what becomes of edits that no file holds.
    pub leaving: Option<Leaving>,
    /// Whether it follows as soon as they are saved.
    pub(crate) is_leaving_saved: bool,
    /// Whether edits that no file holds may be lost: somebody said so.
    pub(crate) is_discarding: bool,
    /// Edits that windows left behind, to be offered.
    pub left_behind: Vec<crate::editing::recovery::Left>,
    /// Those that are being opened.
    pub(crate) recovering: Option<crate::editing::recovery::Left>,
    /// Those that were opened, until the files of this window take their place.
    pub(crate) recovered: Option<crate::editing::recovery::Left>,
    /// Where settings are kept.
    pub settings_folder: Option<std::path::PathBuf>,
    /// What lenses were set to, by the names of the settings, for when they are chosen again.
    pub(crate) lens_settings: HashMap<&'static str, f32>,
    /// What is measured.
    pub measuring: crate::measuring::Measuring,
    /// The values of the volume that the scene was made of.
    pub sampling: crate::inspector::Sampling,
    /// The tree of parts.
    pub outliner: crate::outliner::Outliner,
    /// Whether the height of the eye was chosen for the scene.
    pub(crate) has_eye_height: bool,
    /// Handles of clip box and slice.
    pub clipping: crate::clipping::Clipping,
    /// Dark panels or light ones.
    pub theme: crate::panels::Theme,
    /// The language that was chosen, where one was.
    pub language: Option<String>,
    /// What is known of lines over the picture.
    pub(crate) sight: crate::sight::Sight,
    /// A scene whose surroundings are being made.
    pub(crate) surrounding: Option<Making>,
    messages: VecDeque<Message>,
    commands: Vec<Command>,
    size: (u32, u32),
    is_moving: bool,
    /// Seconds since the camera moved.
    still: f32,
}

impl Session {
    /// The state of a window without a scene.
    pub fn new(traversal: Traversal) -> Self {
        let camera = Camera::look_at(voxtrace::glam::Vec3::new(2.0, -3.0, 2.0), voxtrace::glam::Vec3::ZERO);
        Self {
            navigator: Navigator::new(camera, None),
            render_settings: RenderSettings::new(traversal),
            open: None,
            skies: Skies::default(),
            panorama: None,
            loading: None,
            exporting: None,
            writing: None,
            running: None,
            values: None,
            points: None,
            moving: None,
            wants_motion: false,
            timeline: Timeline::default(),
            wanted_timeline: None,
            below: 0.0,
            dialog: None,
            last_qualities: HashMap::new(),
            has_panels: true,
            has_help: false,
            has_times: false,
            light: Light { real_time: RealTimeChoice::Auto, is_bare: false },
            has_hardware: true,
            is_paused: false,
            exposure_step: Settings::default().exposure_step,
            picked: None,
            hover: None,
            comparison: None,
            last_comparison: None,
            benchmark: None,
            measured: None,
            traversals: vec![traversal],
            scene_options: Vec::new(),
            given_cutting: Cutting::default(),
            built_in_voxels: None,
            editing: None,
            leaving: None,
            is_leaving_saved: false,
            is_discarding: false,
            left_behind: Vec::new(),
            recovering: None,
            recovered: None,
            settings_folder: None,
            lens_settings: HashMap::new(),
            measuring: crate::measuring::Measuring::default(),
            sampling: crate::inspector::Sampling::default(),
            outliner: crate::outliner::Outliner::default(),
            has_eye_height: false,
            clipping: crate::clipping::Clipping::default(),
            theme: crate::panels::Theme::default(),
            language: None,
            sight: crate::sight::Sight::default(),
            surrounding: None,
            messages: VecDeque::new(),
            commands: Vec::new(),
            size: (1280, 720),
            is_moving: false,
            still: 0.0,
        }
    }

    /// What is to be done since this was asked last.
    pub fn take_commands(&mut self) -> Vec<Command> {
        std::mem::take(&mut self.commands)
    }

    /// Whether something is to be done.
    pub fn has_commands(&self) -> bool {
        !self.commands.is_empty()
    }

    /// Asks for something to be done. Of commands that set one and the same thing the last one counts; steps are all done.
    pub fn ask(&mut self, command: Command) {
        self.commands.retain(|earlier| !command.replaces(earlier));
        // A scene that is to be traced is the one with all edits.
        if matches!(command, Command::Follow(_)) && self.commands.contains(&Command::SetScene) {
            return;
        }
        if command == Command::SetScene {
            self.commands.retain(|earlier| !matches!(earlier, Command::Follow(_)));
        }
        self.commands.push(command);
    }

    /// The size of the picture, pixels.
    pub fn size(&self) -> (u32, u32) {
        self.size
    }

    /// The picture has another size.
    pub fn resize(&mut self, width: u32, height: u32) {
        let size = (width.max(1), height.max(1));
        if size != self.size {
            self.size = size;
            self.navigator.set_viewport(size.0, size.1);
            self.ask(Command::SetView);
        }
    }

    /// The view that is to be traced.
    pub fn view(&self) -> View {
        View {
            camera: self.navigator.camera().clone(),
            width: self.size.0,
            height: self.size.1,
            samples: self.render_settings.samples,
            integrator: self.render_settings.integrator,
            max_bounces: self.render_settings.max_bounces,
            bounce_limits: self.render_settings.bounce_limits,
            clamp_indirect: self.render_settings.clamp_indirect.unwrap_or(f32::INFINITY),
            clear_shadows: self.render_settings.clear_shadows,
            lines: self.render_settings.drawn_lines(),
            seed: 0,
        }
    }

    /// Whether the camera moved within the last moments.
    pub fn is_moving(&self) -> bool {
        self.is_moving
    }

    /// What traces.
    pub fn backend(&self) -> Backend {
        let settings = &self.render_settings;
        backend(settings.traversal, settings.primitive, settings.fast)
    }

    /// Moves the camera.
    pub fn move_by(&mut self, motion: Motion) {
        if self.navigator.apply(motion) {
            self.moved();
        }
    }

    /// Goes back to where the camera was, or forth.
    pub fn undo_camera(&mut self, is_back: bool) {
        let has_moved = if is_back { self.navigator.undo() } else { self.navigator.redo() };
        if has_moved {
            self.moved();
        }
    }

    /// The camera moves on soon.
    pub(crate) fn keep_moving(&mut self) {
        (self.is_moving, self.still) = (true, 0.0);
    }

    /// The camera moved.
    pub(crate) fn moved(&mut self) {
        (self.is_moving, self.still) = (true, 0.0);
        self.ask(Command::SetView);
    }

    /// Lets time go by: what is held moves the camera. Returns whether it goes on moving.
    pub fn advance(&mut self, seconds: f32) -> bool {
        self.advance_timeline(seconds);
        if self.advance_camera(seconds) {
            self.moved();
        } else if self.is_moving && !self.timeline.is_playing() {
            self.still += seconds;
            if self.still >= REST {
                // The last view once more, as one that stays.
                self.is_moving = false;
                self.ask(Command::SetView);
            }
        }
        self.is_moving
    }

    /// Takes other render settings.
    pub fn set_render_settings(&mut self, settings: RenderSettings) {
        let old = std::mem::replace(&mut self.render_settings, settings);
        self.keep_apart_for_lines(!old.drawn_lines().is_none());
        if !self.render_settings.has_light_of(&old) {
            self.change_light();
        }
        if self.render_settings.surroundings != old.surroundings {
            self.change_surroundings();
        }
        let by = |settings: &RenderSettings| (settings.traversal, settings.primitive, settings.fast);
        if by(&self.render_settings) != by(&old) {
            self.ask(Command::SetBackend(self.backend()));
        }
        let of = |settings: &RenderSettings| (settings.integrator, settings.max_bounces, settings.samples);
        let limits = |of: &RenderSettings| (of.bounce_limits, of.clamp_indirect, of.clear_shadows, of.lines);
        if of(&self.render_settings) != of(&old) || limits(&self.render_settings) != limits(&old) {
            self.ask(Command::SetView);
        }
    }

    /// The setting of the sun, the scene's own where none was chosen.
    pub fn sun(&self) -> SunSetting {
        let settings = &self.render_settings;
        let of_scene = || self.open.as_ref().and_then(|open| SunSetting::of(&open.original.sky));
        match (&settings.sky, settings.sun) {
            (_, Some(sun)) => sun,
            (Some(SkySetting::Physical), None) => of_scene().unwrap_or(SunSetting::OF_PHYSICAL_SKY),
            (Some(SkySetting::Panorama(_)), None) => SunSetting { strength: 0.0, ..SunSetting::OF_PHYSICAL_SKY },
            _ => of_scene().unwrap_or(SunSetting { strength: 0.0, ..SunSetting::OF_PHYSICAL_SKY }),
        }
    }

    /// What of the scene lies under a place in the picture, also behind fog. A ground without end is nothing to be picked.
    pub fn pick(&self, cursor: Vec2) -> Option<Picked> {
        let scene = &self.open.as_ref()?.pickable;
        let ray = self.navigator.ray(cursor);
        let hit = scene.cast(&ray)?;
        Some(Picked { hit, material: scene.material_index(&hit), point: ray.origin + ray.direction * hit.t })
    }
}
