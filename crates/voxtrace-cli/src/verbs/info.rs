//! `voxtrace info`: what a scene holds and what it costs.

use super::film_info::{self, Found};
use crate::cuts::span_text;
use crate::failure::Failure;
use crate::load::{SceneArgs, into_packed, is_native};
use crate::report::Report;
use serde_json::{Map, Value, json};
use std::path::Path;
use voxtrace::animation::{Clip, keyframe_count};
use voxtrace::import::{Content, vox};
use voxtrace::packed::{LevelSummary, Levels, Outline, Statistics};
use voxtrace::scene::Unit;
use voxtrace::sky::{Background, Sky};
use voxtrace::{PackedScene, Scene};

/// Most names on a line.
const MOST_NAMES: usize = 16;

/// Show what a scene holds and how much memory it takes, or of a film (.vxf) its samples and how noisy it is
#[derive(clap::Args, Clone, Debug)]
pub struct InfoArgs {
    #[command(flatten)]
    scene: SceneArgs,
    /// Print JSON instead of text
    #[arg(long)]
    json: bool,
}

impl InfoArgs {
    pub fn run(mut self, report: &mut Report) -> Result<(), Failure> {
        let has_level = self.scene.memory.level.is_some();
        // A level is read from a file.
        let path = self.scene.file().filter(|path| self.scene.scenes.len() == 1 && (!has_level || path.is_file()));
        match path.map_or(Ok(Found::Other), film_info::look_at)? {
            Found::Film(film) => {
                film_info::print(&film, self.json);
                return Ok(());
            }
            Found::Pipe(begun) => self.scene.import.begun = begun,
            Found::Other => {}
        }
        let loaded = self.scene.load(report)?;
        let of_file = |told: fn(&Scene) -> Vec<String>| match &loaded {
            Content::Scene(scene) => told(scene),
            Content::Packed(_) => Vec::new(),
        };
        let left_out = LeftOut { on_request: of_file(vox::on_request), ignored: report.left_out() };
        let scene = if let Content::Scene(scene) = &loaded { Some(scene.clone()) } else { None };
        let packed = into_packed(loaded, self.scene.memory)?;
        let statistics = match &scene {
            Some(scene) => packed.statistics().with_counts_of(scene),
            None => packed.statistics(),
        };
        let levels = self.levels()?;
        let frames = scene.as_ref().map_or(0, |scene| keyframe_count(scene));
        let clips = scene.as_ref().map_or_else(Vec::new, |scene| scene.clips.clone());
        if self.json {
            let mut value = as_json(&packed, &statistics, &left_out);
            value["warnings"] = report.warnings().into();
            value["frames"] = frames.into();
            value["levels"] =
                levels.iter().map(|level| json!({ "voxels": level.voxels, "bytes": level.bytes })).collect();
            let animation = |clip: &Clip| json!({ "name": clip.name, "seconds": clip.seconds });
            value["animations"] = clips.iter().map(animation).collect();
            crate::stdout::print(&format!("{value:#}\n"));
        } else {
            let hidden = scene.map_or(0, |scene| scene.instances.len() - packed.instance_count());
            let times = times_of(frames, &clips);
            crate::stdout::print(&(as_text(&packed, &statistics, (hidden, &times), &left_out) + &levels_text(&levels)));
        }
        Ok(())
    }
}

impl InfoArgs {
    /// What the levels of detail of a native file hold, which is asked for whole.
    fn levels(&self) -> Result<Vec<LevelSummary>, Failure> {
        // A pipe has been read to its end.
        let is_file = |path: &&Path| is_native(path) && path.is_file() && self.scene.memory.level.is_none();
        let path = self.scene.file().filter(is_file);
        let Some(path) = path else { return Ok(Vec::new()) };
        let levels = Levels::open(path).map_err(Failure::input)?;
        let summary = |level| levels.summary(level);
        (1..=levels.count())
            .map(summary)
            .collect::<Result<_, _>>()
            .map_err(|error| Failure::input(format!("{}: {error}", path.display())))
    }
}

/// A line for each level of detail.
fn levels_text(levels: &[LevelSummary]) -> String {
    let line = |(number, level): (usize, &LevelSummary)| {
        let name = format!("level {}", number + 1);
        format!("{name:<18}{} voxels in {} bytes\n", grouped(level.voxels), grouped(level.bytes))
    };
    levels.iter().enumerate().map(line).collect()
}

/// What a file asks for and pictures do not show: by themselves, and at all.
struct LeftOut {
    on_request: Vec<String>,
    ignored: Vec<String>,
}

fn as_json(packed: &PackedScene, statistics: &Statistics, left_out: &LeftOut) -> Value {
    let [x, y, z] = statistics.size;
    let mut bytes: Map<String, Value> =
        statistics.bytes.iter().map(|&(kind, bytes)| (kind.to_owned(), bytes.into())).collect();
    bytes.insert("total".into(), statistics.total_bytes().into());
    let georeference = packed.georeference.as_ref().map(|georeference| {
        let numbers = georeference.to_array();
        let rows: Vec<[f64; 4]> = (0..3).map(|row| [0, 3, 6, 9].map(|column| numbers[column + row])).collect();
        json!({ "coordinates_from_world": rows, "crs": georeference.crs })
    });
    let outline = &packed.outline;
    let objects: Vec<Value> = (outline.objects.iter())
        .map(|object| json!({ "name": object.name, "layer": object.layer, "group": object.group, "hidden": object.is_hidden }))
        .collect();
    let groups: Vec<Value> =
        outline.groups.iter().map(|group| json!({ "name": group.name, "parent": group.parent })).collect();
    let cameras: Vec<Value> = (packed.cameras.iter())
        .map(|camera| {
            let [eye, target, up] = [camera.eye, camera.target, camera.up].map(|vector| vector.to_array());
            json!({ "name": camera.name, "eye": eye, "target": target, "up": up, "fov_y": camera.fov_y })
        })
        .collect();
    let unit = match packed.unit {
        Unit::Voxel => None,
        Unit::Metre => Some("m"),
        Unit::Millimetre => Some("mm"),
    };
    json!({
        "name": packed.name,
        "unit": unit,
        "voxel_size": packed.voxel_size,
        "content_hash": format!("{:016x}", packed.content_hash()),
        "cameras": cameras,
        "objects": objects,
        "layers": outline.layers,
        "groups": groups,
        "georeference": georeference,
        "sky": sky_text(&packed.sky),
        "on_request": left_out.on_request,
        "ignored": left_out.ignored,
        "size": { "x": x, "y": y, "z": z },
        "bounds": packed.bounds().map(|(min, max)| json!({ "min": min.to_array(), "max": max.to_array() })),
        "voxels": statistics.voxels,
        "voxels_placed": statistics.voxels_placed,
        "models": statistics.models,
        "instances": statistics.instances,
        "merged_instances": statistics.merged_instances,
        "materials": statistics.materials,
        "emissive_voxels": statistics.emissive_voxels,
        "bytes": bytes,
        "bytes_per_voxel": statistics.bytes_per_voxel,
    })
}

fn as_text(
    packed: &PackedScene,
    statistics: &Statistics,
    (hidden, times): (usize, &[(&str, String)]),
    left_out: &LeftOut,
) -> String {
    let mut text = String::new();
    let mut line = |name: &str, value: String| text += &format!("{name:<18}{value}\n");
    line("scene", packed.name.clone());
    line("size", size_text(packed, statistics.size));
    if let Some(bounds) = packed.bounds() {
        line("spans", span_text(bounds));
    }
    if let Some(georeference) = &packed.georeference {
        let origin = georeference.coordinates_from_world.translation;
        line("origin at", format!("{}, {}, {}", rounded(origin.x), rounded(origin.y), rounded(origin.z)));
        if !georeference.crs.is_empty() {
            line("reference system", georeference.crs_name().into());
        }
    }
    line("voxels", grouped(statistics.voxels));
    line("voxels placed", grouped(statistics.voxels_placed));
    line("models", grouped(statistics.models));
    let hidden = if hidden > 0 { format!(" ({hidden} hidden or empty)") } else { String::new() };
    let merged = match statistics.merged_instances {
        0 => String::new(),
        merged => format!(" ({} merged into one grid)", grouped(merged)),
    };
    line("instances", grouped(statistics.instances) + &hidden + &merged);
    for (what, names) in parts_of(&packed.outline) {
        line(what, names);
    }
    times.iter().for_each(|(name, value)| line(name, value.clone()));
    line("materials", grouped(statistics.materials));
    line("emissive voxels", grouped(statistics.emissive_voxels));
    let cameras: Vec<&str> = packed.cameras.iter().map(|camera| camera.name.as_str()).collect();
    line("cameras", if cameras.is_empty() { "none".into() } else { cameras.join(", ") });
    line("sky", sky_text(&packed.sky));
    for (what, phrases) in [("on request", &left_out.on_request), ("not shown", &left_out.ignored)] {
        if !phrases.is_empty() {
            line(what, phrases.join(", "));
        }
    }
    line("content hash", format!("{:016x}", packed.content_hash()));
    line("memory", format!("{} bytes, of which", grouped(statistics.total_bytes())));
    for (kind, bytes) in statistics.bytes.into_iter().filter(|&(kind, bytes)| bytes > 0 || kind != "normals") {
        line(&format!("  {}", kind.replace('_', " ")), grouped(bytes));
    }
    line("bytes per voxel", format!("{:.3} (all but the lights)", statistics.bytes_per_voxel));
    text
}

/// The lines about keyframes and animations that `animate` plays.
fn times_of(frames: u32, clips: &[Clip]) -> Vec<(&'static str, String)> {
    let mut lines = Vec::new();
    if frames > 0 {
        lines.push(("frames", format!("{} of keyframes, which `voxtrace animate` plays", grouped(frames.into()))));
    }
    let text = |(index, clip): (usize, &Clip)| {
        let name = if clip.name.is_empty() { String::new() } else { format!(" {}", clip.name) };
        format!("{}{name} ({} s)", index + 1, (clip.seconds * 1000.0).round() / 1000.0)
    };
    if !clips.is_empty() {
        let mut texts: Vec<String> = clips.iter().enumerate().take(MOST_NAMES).map(text).collect();
        if clips.len() > MOST_NAMES {
            texts.push(format!("and {} more (--json lists them)", clips.len() - MOST_NAMES));
        }
        lines.push(("animations", format!("{}, which `voxtrace animate` plays", texts.join(", "))));
    }
    lines
}

/// What shines from outside.
fn sky_text(sky: &Sky) -> String {
    let background = match sky.background() {
        Background::Gradient(gradient) if gradient.nadir == gradient.zenith => "one colour".to_owned(),
        Background::Gradient(_) => "gradient".to_owned(),
        Background::Environment(environment) => {
            let (edge, rotation) = (environment.map().edge(), environment.rotation());
            let turned = if rotation == 0.0 { String::new() } else { format!(", turned by {rotation} degrees") };
            format!("environment map of {edge} x {edge} texels{turned}")
        }
    };
    let sun = sky.sun().map_or(String::new(), |sun| {
        let (bearing, height, _) = sun.setting();
        let disc = if sky.is_sun_disc_visible() { "" } else { " (disc hidden)" };
        format!(", sun at {bearing:.1},{height:.1}{disc}")
    });
    let brightness = if sky.brightness() == 1.0 { String::new() } else { format!(", brightness {}", sky.brightness()) };
    background + &sun + &brightness
}

/// Layers, groups and objects by name, as far as they have names.
fn parts_of(outline: &Outline) -> Vec<(&'static str, String)> {
    let hidden_layer = |layer: usize| {
        let mut objects = outline.objects.iter().filter(|object| object.layer == Some(layer)).peekable();
        objects.peek().is_some() && objects.all(|object| object.is_hidden)
    };
    let layers = outline.layers.iter().enumerate().map(|(index, name)| (name, hidden_layer(index)));
    let groups = outline.groups.iter().map(|group| (&group.name, false));
    let objects = outline.objects.iter().map(|object| (&object.name, object.is_hidden));
    let all = [("layers", list(layers)), ("groups", list(groups)), ("objects", list(objects))];
    all.into_iter().filter(|(_, names)| !names.is_empty()).collect()
}

/// The first names with their numbers; parts without a name are left out.
fn list<'a>(parts: impl Iterator<Item = (&'a String, bool)>) -> String {
    let text = |(number, (name, is_hidden)): (usize, (&String, bool))| {
        format!("{number} {name}{}", if is_hidden { " (hidden)" } else { "" })
    };
    let mut named: Vec<String> = parts.enumerate().filter(|(_, (name, _))| !name.is_empty()).map(text).collect();
    let more = named.len().saturating_sub(MOST_NAMES);
    named.truncate(MOST_NAMES);
    if more > 0 {
        named.push(format!("and {more} more (--json lists them)"));
    }
    named.join(", ")
}

fn size_text(packed: &PackedScene, size: [u64; 3]) -> String {
    let [x, y, z] = size;
    let unit = match packed.unit {
        Unit::Voxel => return format!("{x} x {y} x {z} voxels"),
        Unit::Metre => "m",
        Unit::Millimetre => "mm",
    };
    let [a, b, c] = size.map(|voxels| voxels as f64 * packed.voxel_size);
    let voxel_size = packed.voxel_size as f32;
    format!("{x} x {y} x {z} voxels of {voxel_size} {unit}: {a:.1} x {b:.1} x {c:.1} {unit}")
}

/// A coordinate to a millionth.
fn rounded(coordinate: f64) -> f64 {
    // Not −0.
    (coordinate * 1e6).round() / 1e6 + 0.0
}

/// A number with its thousands apart.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::grouped;

    #[test]
    fn thousands_stand_apart() {
        assert_eq!([0, 7, 999, 1000, 13_600_000].map(grouped), ["0", "7", "999", "1,000", "13,600,000"]);
    }
}
