//! What a picture says about its own making, enough to make it again. PNG carries it as text chunks, EXR as attributes.

use super::film_file::{cuts_text, kinds_text, lines_text};
use super::{SceneStamp, ToneMap};
use voxtrace_core::BounceLimits;
use voxtrace_core::Film;
use voxtrace_core::Frame;
use voxtrace_core::Region;
use voxtrace_scene::Lens;

/// Texts about a picture, by name. Names and order are fixed, there is no time stamp: the same picture has the same
/// bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Metadata {
    entries: Vec<(&'static str, String)>,
}

impl Metadata {
    /// The texts about `film`, which `frame` asked for, of the scene `scene`.
    pub fn new(frame: &Frame, scene: &SceneStamp, film: &Film) -> Self {
        let camera = &frame.camera;
        let vector = |v: glam::Vec3| format!("{},{},{}", v.x, v.y, v.z);
        let samples = match film.sample_range() {
            (least, most) if least == most => most.to_string(),
            (least, most) => format!("{least}..{most}"),
        };
        let Region { x0, y0, x1, y1 } = film.region;
        let mut entries = vec![
            ("Software", format!("voxtrace {}", env!("CARGO_PKG_VERSION"))),
            ("voxtrace.scene", scene.name.clone()),
            ("voxtrace.scene_hash", format!("{:016x}", scene.content_hash)),
            ("voxtrace.integrator", frame.integrator.name().into()),
            ("voxtrace.max_bounces", frame.max_bounces.to_string()),
            ("voxtrace.seed", frame.seed.to_string()),
            ("voxtrace.first_sample", film.first_sample.to_string()),
            ("voxtrace.samples", samples),
            ("voxtrace.size", format!("{}x{}", film.width, film.height)),
            ("voxtrace.crop", format!("{x0},{x1},{y0},{y1}")),
            ("voxtrace.transparent", frame.transparent.to_string()),
            ("voxtrace.camera", camera.name.clone()),
            ("voxtrace.camera.eye", vector(camera.eye)),
            ("voxtrace.camera.target", vector(camera.target)),
            ("voxtrace.camera.up", vector(camera.up)),
            ("voxtrace.camera.fov_y", camera.fov_y.to_string()),
            ("voxtrace.sky_brightness", scene.sky.brightness().to_string()),
            ("voxtrace.light_intensity", scene.light_intensity.to_string()),
        ];
        if frame.bounce_limits != BounceLimits::default() {
            entries.push(("voxtrace.bounces_by_kind", kinds_text(frame)));
        }
        if frame.clamp_indirect < f32::INFINITY {
            entries.push(("voxtrace.clamp_indirect", frame.clamp_indirect.to_string()));
        }
        if frame.clear_shadows {
            entries.push(("voxtrace.clear_shadows", true.to_string()));
        }
        if frame.shadow_catcher {
            entries.push(("voxtrace.shadow_catcher", true.to_string()));
        }
        if !frame.lines.is_none() {
            entries.push(("voxtrace.lines", lines_text(&frame.lines)));
        }
        if camera.lens != Lens::Pinhole {
            let settings = camera.lens.settings().into_iter().map(|(name, value)| format!(" {name}={value}"));
            entries.push(("voxtrace.camera.lens", camera.lens.name().to_owned() + &settings.collect::<String>()));
        }
        if !scene.cuts.is_none() {
            entries.push(("voxtrace.cuts", cuts_text(&scene.cuts)));
        }
        Self { entries }
    }

    /// The same texts, and how the film was made visible.
    pub fn with_tone_map(&self, tone_map: &ToneMap) -> Self {
        let mut entries = self.entries.clone();
        entries.push(("voxtrace.tone_map", tone_map.operator.name().into()));
        entries.push(("voxtrace.exposure", tone_map.exposure.to_string()));
        Self { entries }
    }

    /// The same texts, and the filter that removed the noise.
    pub fn with_filter(mut self, filter: &str) -> Self {
        self.entries.push(("voxtrace.denoise", filter.into()));
        self
    }

    /// Names and texts.
    pub fn entries(&self) -> &[(&'static str, String)] {
        &self.entries
    }
}
