//! The command that renders what the window shows: `voxtrace render …` as one line for a POSIX shell. Options that are the defaults of
//! `render` are left out, numbers are read as the same bits (`docs/command-line.md` has the options).

mod check;
mod parts;
mod words;

pub use parts::{SceneArgument, Sequence, SkySetting};

use crate::cutting::{Cutting, Slice};
use crate::surroundings::Surroundings;
use crate::tr;
use std::path::{Path, PathBuf};
use voxtrace::camera::Lens;
pub use voxtrace::changes::SunSetting;
use voxtrace::changes::{MaterialChange, PartName};
use voxtrace::glam::Vec3;
use voxtrace::lines::Lines;
use voxtrace::output::ToneMap;
use voxtrace::surroundings::{Fog, Ground};
use voxtrace::{BounceLimits, Camera, Integrator, scenes};
pub(crate) use voxtrace_bench::shell::quoted;
use voxtrace_vulkan::{Primitive, Traversal};
use words::{Words, number, say_lens, say_lines, vector};

/// Size of a picture where none is said.
const SIZE: (u32, u32) = (1280, 720);
/// Samples where none are said, and the most.
const SAMPLES: (u32, u32) = (64, 1 << 20);
/// Strength of a sun that says none.
const SUN_STRENGTH: f32 = 3.0;

/// Why a view has no command.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CommandError {
    /// A path that is no Unicode cannot stand in a text.
    #[error("the path {} is no Unicode text", .0.display())]
    NotUnicode(PathBuf),
    /// A value that `render` refuses.
    #[error("{0}")]
    Refused(&'static str),
}

/// What a view is made of. What is `None` is as the scene or the device has it.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderCommand {
    /// The scene.
    pub scene: SceneArgument,
    /// Options of reading and editing the scene as they were given, each word by itself: `--resolution`, `700`.
    pub scene_options: Vec<String>,
    /// The camera.
    pub camera: Camera,
    /// What `render` would take by itself, the scene's first camera or else its overview: parts that are the same are left out.
    pub usual_camera: Option<Camera>,
    /// Width and height, pixels.
    pub size: (u32, u32),
    /// Samples of each pixel.
    pub samples: u32,
    /// Seed of the random numbers.
    pub seed: u32,
    /// How light is computed.
    pub integrator: Integrator,
    /// Most surfaces that scatter one path.
    pub max_bounces: u32,
    /// Most of them by kind.
    pub bounce_limits: BounceLimits,
    /// Most radiance that a bounce adds of indirect light.
    pub clamp_indirect: Option<f32>,
    /// Whether light passes clear glass straight.
    pub clear_shadows: bool,
    /// Lines on the faces of voxels.
    pub lines: Lines,
    /// Whether the background is left out.
    pub transparent: bool,
    /// Whether albedo, normal, depth, instance and voxel are written too.
    pub aovs: bool,
    /// Whether channels have 16 bits in place of 8 (PNG) or 32 (EXR).
    pub sixteen_bits: bool,
    /// The frames, where it is not one picture.
    pub sequence: Option<Sequence>,
    /// Exposure and operator.
    pub tone_map: ToneMap,
    /// How rays find voxels.
    pub traversal: Option<Traversal>,
    /// What ray tracing hardware sees.
    pub primitive: Option<Primitive>,
    /// The device, by number or name.
    pub device: Option<String>,
    /// Whether the driver may round as it likes.
    pub fast: bool,
    /// Factor on the sky.
    pub sky_brightness: Option<f32>,
    /// The sky.
    pub sky: Option<SkySetting>,
    /// How far a panorama is turned, degrees clockwise seen from above.
    pub sky_rotation: Option<f32>,
    /// The sun.
    pub sun: Option<SunSetting>,
    /// Whether the camera sees its disc.
    pub sun_disc: Option<bool>,
    /// Factor on everything that glows.
    pub light_intensity: Option<f32>,
    /// What is kept of the scene.
    pub cutting: Cutting,
    /// What is around it.
    pub surroundings: Surroundings,
    /// Materials that are changed.
    pub materials: Vec<MaterialChange>,
    /// Parts that are left out.
    pub hidden: Vec<PartName>,
    /// Parts that are shown although the file hides them.
    pub shown: Vec<PartName>,
    /// Files to write; none is `SCENE.png`.
    pub outputs: Vec<PathBuf>,
}

impl RenderCommand {
    /// A view with the defaults of `render`.
    pub fn new(scene: SceneArgument, camera: Camera) -> Self {
        Self {
            scene,
            scene_options: Vec::new(),
            camera,
            usual_camera: None,
            size: SIZE,
            samples: SAMPLES.0,
            seed: 0,
            integrator: Integrator::default(),
            max_bounces: usual_bounces(Integrator::default()),
            bounce_limits: BounceLimits::default(),
            clamp_indirect: None,
            clear_shadows: false,
            lines: Lines::default(),
            transparent: false,
            aovs: false,
            sixteen_bits: false,
            sequence: None,
            tone_map: ToneMap::default(),
            traversal: None,
            primitive: None,
            device: None,
            fast: false,
            sky_brightness: None,
            sky: None,
            sky_rotation: None,
            sun: None,
            sun_disc: None,
            light_intensity: None,
            cutting: Cutting::default(),
            surroundings: Surroundings::default(),
            materials: Vec::new(),
            hidden: Vec::new(),
            shown: Vec::new(),
            outputs: Vec::new(),
        }
    }

    /// The command as one line, quoted for a POSIX shell.
    ///
    /// # Errors
    /// [`CommandError`], where no command makes this picture.
    pub fn line(&self) -> Result<String, CommandError> {
        Ok(Words(self.words()?).line())
    }

    /// The command's words, `voxtrace` and `render` first.
    ///
    /// # Errors
    /// As [`Self::line`].
    pub fn words(&self) -> Result<Vec<String>, CommandError> {
        self.check()?;
        let mut words = match &self.sequence {
            Some(Sequence::Animation { file, .. } | Sequence::Frame { file, .. }) => {
                self.begin("animate", &SceneArgument::File(file.clone()))?
            }
            _ => self.begin("render", &self.scene)?,
        };
        for output in &self.outputs {
            words.value("--output", Some(unicode(output)?.to_owned()));
        }
        match &self.sequence {
            Some(Sequence::Flight { file, frames }) => {
                words.value("--flight", Some(unicode(file)?.to_owned()));
                words.value("--flight-frames", Some(frames.to_string()));
            }
            Some(Sequence::Turntable(frames)) => {
                self.say_view(&mut words);
                words.0.push(format!("--turntable={frames}"));
            }
            Some(Sequence::Frame { frame, .. }) => {
                words.value("--frames", Some(format!("{frame}..{frame}")));
                self.say_view(&mut words);
            }
            Some(Sequence::Animation { keeps, .. }) => words.flag("--skip-existing", *keeps),
            None => self.say_view(&mut words),
        }
        self.say_quality(&mut words);
        self.say_light(&mut words)?;
        self.say_surroundings(&mut words);
        say_lines(&self.lines, &mut words);
        self.say_cuts(&mut words);
        self.say_changes(&mut words);
        words.value("--traversal", self.traversal.map(|traversal| traversal.name().to_owned()));
        words.value("--primitive", self.primitive.map(|primitive| primitive.name().to_owned()));
        words.value("--device", self.device.clone());
        words.flag("--fast", self.fast);
        Ok(words.0)
    }

    /// The verb, the scene or the file that names it, and how it is read.
    fn begin(&self, verb: &str, named: &SceneArgument) -> Result<Words, CommandError> {
        let mut words = Words(vec!["voxtrace".into(), verb.into(), scene_word(named)?]);
        if let SceneArgument::BuiltIn { voxels, .. } = &self.scene {
            words.value("--voxels", voxels.map(|voxels| voxels.to_string()));
        }
        words.0.extend(self.scene_options.iter().cloned());
        Ok(words)
    }

    /// The command that measures the view, quoted for a POSIX shell: `cells` as `--cells` has them, so many frames after so many.
    ///
    /// # Errors
    /// As [`Self::line`]; [`CommandError::Refused`] where the scene is cut open, or stands on a ground or in fog.
    pub fn bench_line(&self, cells: &[String], frames: u32, warm_up: u32) -> Result<String, CommandError> {
        self.check()?;
        if self.cutting.is_cut() {
            return Err(CommandError::Refused(tr!("command.bench_cut")));
        }
        if !self.surroundings.is_none() {
            return Err(CommandError::Refused(tr!("command.bench_alone")));
        }
        let mut words = self.begin("bench", &self.scene)?;
        self.say_view(&mut words);
        self.say_light(&mut words)?;
        self.say_changes(&mut words);
        let (width, height) = self.size;
        let values = [
            ("--size", format!("{width}x{height}")),
            ("--max-bounces", self.max_bounces.to_string()),
            ("--integrator", self.integrator.name().into()),
            ("--cells", cells.join(",")),
            ("--frames", frames.to_string()),
            ("--warm-up", warm_up.to_string()),
            ("--sweep", "none".into()),
        ];
        values.into_iter().for_each(|(option, value)| words.value(option, Some(value)));
        words.value("--device", self.device.clone());
        words.flag("--precise", !self.fast);
        Ok(words.line())
    }

    fn say_view(&self, words: &mut Words) {
        let (camera, usual) = (&self.camera, self.usual_camera.as_ref());
        let differs = |value: Vec3, of: fn(&Camera) -> Vec3| {
            let bits = |vector: Vec3| vector.to_array().map(f32::to_bits);
            (usual.map(of).map(bits) != Some(bits(value))).then(|| vector(value))
        };
        words.value("--eye", differs(camera.eye, |camera| camera.eye));
        words.value("--target", differs(camera.target, |camera| camera.target));
        words.value("--up", differs(camera.up, |camera| camera.up));
        let is_usual = usual.is_some_and(|usual| usual.fov_y.to_bits() == camera.fov_y.to_bits());
        words.value("--fov", (!is_usual).then(|| number(camera.fov_y)));
        if usual.map(|usual| usual.lens) != Some(camera.lens) {
            say_lens(camera.lens, usual.is_none_or(|usual| usual.lens == Lens::Pinhole), words);
        }
    }

    fn say_quality(&self, words: &mut Words) {
        let unless = |is_default: bool, value: String| (!is_default).then_some(value);
        let (width, height) = self.size;
        words.value("--size", unless(self.size == SIZE, format!("{width}x{height}")));
        words.value("--spp", unless(self.samples == SAMPLES.0, self.samples.to_string()));
        words.value("--seed", unless(self.seed == 0, self.seed.to_string()));
        let is_default = self.integrator == Integrator::default();
        words.value("--integrator", unless(is_default, self.integrator.name().into()));
        let is_default = self.max_bounces == usual_bounces(self.integrator);
        words.value("--max-bounces", unless(is_default, self.max_bounces.to_string()));
        let BounceLimits { diffuse, glossy, transmitted, volume } = self.bounce_limits;
        let limits = [("diffuse", diffuse), ("glossy", glossy), ("transmitted", transmitted), ("volume", volume)];
        for (kind, limit) in limits {
            words.value(&format!("--{kind}-bounces"), unless(limit == BounceLimits::UNLIMITED, limit.to_string()));
        }
        words.value("--clamp-indirect", self.clamp_indirect.map(number));
        words.flag("--clear-shadows", self.clear_shadows);
        words.flag("--transparent", self.transparent);
        words.flag("--aovs", self.aovs);
        words.value("--bit-depth", self.sixteen_bits.then(|| "16".to_owned()));
        let (tone_map, default) = (self.tone_map, ToneMap::default());
        words.value("--exposure", unless(tone_map.exposure == default.exposure, number(tone_map.exposure)));
        words.value("--tone-map", unless(tone_map.operator == default.operator, tone_map.operator.name().into()));
    }

    fn say_light(&self, words: &mut Words) -> Result<(), CommandError> {
        words.value("--sky-brightness", self.sky_brightness.map(number));
        match &self.sky {
            Some(SkySetting::Color(color)) => words.value("--sky-color", Some(vector(*color))),
            Some(SkySetting::Physical) => words.value("--sky", Some("physical".into())),
            Some(SkySetting::Panorama(path)) => {
                // The word alone means another sky.
                let path = unicode(path)?;
                words.value("--sky", Some(if path == "physical" { format!("./{path}") } else { path.to_owned() }));
            }
            None => {}
        }
        words.value("--sky-rotation", self.sky_rotation.map(number));
        words.value(
            "--sun",
            self.sun.map(|sun| match sun.strength.to_bits() == SUN_STRENGTH.to_bits() {
                true => format!("{},{}", number(sun.bearing), number(sun.height)),
                false => format!("{},{},{}", number(sun.bearing), number(sun.height), number(sun.strength)),
            }),
        );
        words.value("--sun-disc", self.sun_disc.map(|is_seen| if is_seen { "visible" } else { "hidden" }.into()));
        words.value("--light-intensity", self.light_intensity.map(number));
        Ok(())
    }

    fn say_surroundings(&self, words: &mut Words) {
        if let Some(Ground { height, color }) = self.surroundings.ground {
            let at = height.map(|height| format!("={}", number(height)));
            words.0.push(format!("--ground{}", at.unwrap_or_default()));
            words.value("--ground-color", Some(vector(color)));
        }
        if let Some(Fog { density, color, anisotropy }) = self.surroundings.fog {
            words.value("--fog", Some(format!("{},{},{}", number(density), vector(color), number(anisotropy))));
        }
    }

    fn say_cuts(&self, words: &mut Words) {
        let Cutting { clip_box, slice, planes, shadows } = &self.cutting;
        words.value("--clip-box", clip_box.map(|[min, max]| format!("{},{}", vector(min), vector(max))));
        let across = |Slice { axis, from, thickness }: Slice| {
            format!("{}={},{}", ["x", "y", "z"][axis.min(2)], number(from), number(thickness))
        };
        words.value("--slice", slice.map(across));
        for (normal, offset) in planes {
            words.value("--clip-plane", Some(format!("{},{}", vector(*normal), number(*offset))));
        }
        words.flag("--clip-shadows", *shadows && self.cutting.is_cut());
    }

    fn say_changes(&self, words: &mut Words) {
        self.materials.iter().for_each(|change| words.value("--material", Some(change.to_string())));
        self.hidden.iter().for_each(|part| words.value("--hide", Some(part.to_string())));
        self.shown.iter().for_each(|part| words.value("--show", Some(part.to_string())));
    }
}

/// Bounces where none are said.
pub(crate) fn usual_bounces(integrator: Integrator) -> u32 {
    if integrator == Integrator::Essay { 3 } else { 8 }
}

fn scene_word(scene: &SceneArgument) -> Result<String, CommandError> {
    let path = match scene {
        SceneArgument::BuiltIn { name, .. } => return Ok(name.clone()),
        SceneArgument::File(path) => unicode(path)?,
    };
    // A name that means something else names a file with its folder.
    let is_ambiguous = path.starts_with('-') || scenes::NAMES.contains(&path);
    Ok(if is_ambiguous { format!("./{path}") } else { path.to_owned() })
}

fn unicode(path: &Path) -> Result<&str, CommandError> {
    path.to_str().ok_or_else(|| CommandError::NotUnicode(path.to_path_buf()))
}

#[cfg(test)]
mod tests;
