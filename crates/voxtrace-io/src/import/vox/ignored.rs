//! What a .vox file asks for about the picture and voxtrace does not show, or on request alone, in words: settings that are off, or as they do nothing, do
//! not count.

use super::document::{Body, Dict, VoxFile};
use super::{ATTACHMENT, light};
use glam::Vec3;
use std::path::Path;
use voxtrace_scene::material::linear_color;
use voxtrace_scene::scene::Scene;
use voxtrace_voxelize::Limits;

/// What the .vox file that a scene came from asks for and is not shown, one phrase each; nothing for other scenes.
pub fn ignored(scene: &Scene) -> Vec<String> {
    Settings::with(scene, |settings| settings.ignored()).unwrap_or_default()
}

/// What that file asks for and options of `render` show, one phrase with them each; nothing for other scenes.
pub fn on_request(scene: &Scene) -> Vec<String> {
    Settings::with(scene, |settings| settings.on_request()).unwrap_or_default()
}

/// The rOBJ chunks of a file.
pub(super) struct Settings<'a>(Vec<&'a Dict<'a>>);

/// Kinds that [`Settings::ignored`] and [`Settings::on_request`] look into. Files of before `_env` and `_setting` have `_len` for `_lens` and `_film`,
/// `_fog` for `_fog_uni`, and say `_enable` in the chunk that is on or off.
const KNOWN: [&str; 12] =
    ["_setting", "_fog_uni", "_ground", "_bg", "_edge", "_grid", "_lens", "_film", "_bloom", "_bounce", "_fog", "_len"];

impl Settings<'_> {
    /// What `told` makes of the chunks of the .vox file that a scene came from; `None` for other scenes.
    pub fn with<T>(scene: &Scene, told: impl FnOnce(&Settings) -> T) -> Option<T> {
        let attachment = scene.attachments.iter().find(|attachment| attachment.format == ATTACHMENT)?;
        let file = VoxFile::parse(&attachment.bytes, Path::new(&scene.name), &Limits::default()).ok()?;
        let chunks = file.chunks.iter().filter_map(|chunk| match &chunk.body {
            Body::RenderObject(properties) => Some(properties),
            _ => None,
        });
        Some(told(&Settings(chunks.collect())))
    }

    /// The text of a key in the last chunk of a kind.
    pub fn value(&self, kind: &str, key: &str) -> Option<&str> {
        let is_kind = |dict: &&&Dict| dict.get("_type") == Some(kind.as_bytes());
        let value = self.0.iter().rev().find(is_kind)?.get(key)?;
        str::from_utf8(value).ok()
    }

    /// The same as a finite number, 0 where it is none.
    pub fn number(&self, kind: &str, key: &str) -> f64 {
        self.value(kind, key)
            .and_then(|value| value.trim().parse().ok())
            .filter(|value: &f64| value.is_finite())
            .unwrap_or(0.0)
    }

    /// The same as a colour of sRGB bytes, linear.
    pub fn color(&self, kind: &str, key: &str) -> Option<Vec3> {
        let words = self.value(kind, key)?.split_ascii_whitespace().map(|word| word.parse().ok());
        let bytes: [u8; 3] = words.collect::<Option<Vec<u8>>>()?.try_into().ok()?;
        Some(linear_color(bytes))
    }

    /// The file's numbers of bounces, as the options of `render` that ask for them: MagicaVoxel counts reflection and refraction together.
    fn bounces(&self) -> String {
        let options = [
            ("_diffuse", "--diffuse-bounces"),
            ("_specular", "--glossy-bounces"),
            ("_specular", "--transmitted-bounces"),
            ("_scatter", "--volume-bounces"),
        ];
        let said = |(key, option): &(&str, &str)| {
            let value = self.value("_bounce", key)?.trim().parse::<u8>().ok()?;
            Some(format!(" {option} {value}"))
        };
        format!("numbers of bounces ({})", options.iter().filter_map(said).collect::<String>().trim_start())
    }

    /// Whether a number is given and not 0.
    fn is_on(&self, kind: &str, key: &str) -> bool {
        self.number(kind, key) != 0.0
    }

    fn has(&self, kind: &str) -> bool {
        self.0.iter().any(|dict| dict.get("_type") == Some(kind.as_bytes()))
    }

    /// Whether lines along edges are shown.
    pub fn has_edges(&self) -> bool {
        self.is_on("_setting", "_edge") || self.is_on("_edge", "_enable")
    }

    /// Whether lines of a grid are shown.
    pub fn has_grid(&self) -> bool {
        self.is_on("_setting", "_grid") || self.is_on("_grid", "_enable")
    }

    /// Density of the fog, 0 where there is none, and the kind of the chunk that says it.
    pub fn fog(&self) -> (f64, &'static str) {
        if self.is_on("_fog", "_enable") {
            return (self.number("_fog", "_d"), "_fog");
        }
        (self.number("_fog_uni", "_d"), "_fog_uni")
    }

    fn on_request(&self) -> Vec<String> {
        let exposure = self.number("_film", "_expo");
        let stops = (exposure > 0.0 && exposure != 1.0).then(|| exposure.log2());
        // Older files say it in stops.
        let stops = stops.or_else(|| self.is_on("_len", "_exp").then(|| self.number("_len", "_exp")));
        let has_ground = self.has("_ground") && (self.is_on("_setting", "_ground") || self.is_on("_ground", "_enable"));
        let ground = match self.is_on("_ground", "_hor") {
            true => "ground (--ground, with a sharp horizon)",
            false => "ground (--ground)",
        };
        let has_aperture = self.is_on("_lens", "_aperture") || self.is_on("_len", "_dof");
        let asked = [
            has_ground.then(|| ground.to_owned()),
            (self.is_on("_setting", "_bg_c") || self.is_on("_bg", "_enable"))
                .then(|| "background colour (--background file)".to_owned()),
            (self.fog().0 != 0.0).then(|| "fog (--fog file)".to_owned()),
            self.has_edges().then(|| "edges (--edges=file)".to_owned()),
            self.has_grid().then(|| "grid (--grid=file)".to_owned()),
            has_aperture.then(|| "aperture (--aperture, in voxels)".to_owned()),
            stops.map(|stops| format!("exposure (--exposure {stops:.2})")),
            self.has("_bounce").then(|| self.bounces()),
        ];
        asked.into_iter().flatten().collect()
    }

    fn ignored(&self) -> Vec<String> {
        let is_picture = self.number("_env", "_mode") == 1.0;
        let asked = [
            ("a sky without its picture", is_picture && self.value("_ibl", "_path").is_none_or(str::is_empty)),
            ("bloom", self.is_on("_bloom", "_mix") && self.is_on("_bloom", "_scale")),
            ("vignette", self.is_on("_film", "_vig") || self.is_on("_len", "_vig")),
            ("film curve", self.is_on("_film", "_aces")),
        ];
        let mut phrases: Vec<String> =
            asked.iter().filter(|(_, is_asked)| *is_asked).map(|(phrase, _)| (*phrase).to_owned()).collect();
        let is_other = |dict: &&&Dict| {
            let kind = dict.get("_type").unwrap_or_default();
            !light::is_understood(dict) && !KNOWN.iter().any(|known| known.as_bytes() == kind)
        };
        let others = self.0.iter().filter(is_other).filter_map(|dict| dict.get("_type"));
        phrases.extend(others.map(|kind| String::from_utf8_lossy(kind).into_owned()));
        phrases
    }
}
