//! Plans in TOML: our own, and those of the study's program FastVoxels, whose `config.toml` names a scene, a shader and a
//! number of frames, with `SCENE.vox` and `SCENE.toml` (camera and light) beside it.

use crate::quantity::{self, QuantityError, Size};
use crate::reason::reason;
use std::io;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::time::Duration;
use toml::{Table, Value};
use voxtrace::{Integrator, scenes};

/// What a plan asks for; what it leaves out, options or defaults decide.
#[derive(Debug, Default, PartialEq)]
pub struct PlanFile {
    /// Scenes to measure.
    pub scenes: Vec<SceneEntry>,
    /// Cells as they are written with `--cells`.
    pub cells: Vec<String>,
    /// Frames of each cell.
    pub frames: Option<u32>,
    /// Frames before the first that counts.
    pub warm_up: Option<u32>,
    /// Most time of each cell's frames.
    pub time_limit: Option<Duration>,
    /// Size of the picture.
    pub size: Option<Size>,
    /// Most surfaces that scatter one path.
    pub max_bounces: Option<u32>,
    /// How the light along a camera ray is computed.
    pub integrator: Option<Integrator>,
    /// Voxels of the built-in scenes.
    pub voxels: Option<u64>,
    /// Trees, rocks and lamps of the built-in scene `forest`.
    pub instances: Option<u32>,
    /// Sizes of the sweep, voxels.
    pub sweep: Option<Vec<u64>>,
    /// Whether shaders give the CPU's bits.
    pub precise: bool,
    /// Device by its number or a part of its name.
    pub device: Option<String>,
}

/// A scene of a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneEntry {
    /// A file or the name of a built-in scene.
    pub name: String,
    /// A file with camera and light.
    pub camera: Option<PathBuf>,
    /// As `convert` writes it to a `.vox` file and reads it again: models of at most 256³ voxels, and 255 colours.
    pub is_vox: bool,
}

impl SceneEntry {
    /// A scene with its own camera and light.
    pub fn named(name: &str) -> Self {
        Self { name: name.to_owned(), camera: None, is_vox: false }
    }

    /// The scene as settings and messages name it.
    pub(crate) fn title(&self) -> String {
        if self.is_vox { format!("{} as vox", self.name) } else { self.name.clone() }
    }
}

/// How many frames a cell may have.
const FRAMES: RangeInclusive<u32> = 1..=1_000_000;
const KEYS: [&str; 13] = [
    "scenes",
    "cells",
    "frames",
    "warm_up",
    "time_limit",
    "size",
    "max_bounces",
    "integrator",
    "voxels",
    "instances",
    "sweep",
    "precise",
    "device",
];

/// A plan that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{}", self.text())]
#[non_exhaustive]
pub struct PlanError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    pub kind: PlanErrorKind,
}

/// What is wrong with a plan.
#[derive(Debug)]
#[non_exhaustive]
pub enum PlanErrorKind {
    /// It cannot be read.
    Io(io::Error),
    /// It is no TOML, or says something that no plan says; in words.
    Malformed(String),
}

impl PlanError {
    fn text(&self) -> String {
        let path = self.path.display();
        match &self.kind {
            PlanErrorKind::Io(error) => format!("cannot read the plan {path}: {}", reason(error)),
            PlanErrorKind::Malformed(what) => format!("plan {path}: {what}"),
        }
    }
}

impl PlanFile {
    /// Reads a plan; files that it names lie relative to it.
    ///
    /// # Errors
    /// Where the file cannot be read, is no TOML or no plan.
    pub fn open(path: &Path) -> Result<Self, PlanError> {
        let failed = |kind| PlanError { path: path.to_owned(), kind };
        voxtrace::import::opened::note(path);
        let text = std::fs::read_to_string(path).map_err(|error| failed(PlanErrorKind::Io(error)))?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        parse_plan(&text, folder, &stem).map_err(|what| failed(PlanErrorKind::Malformed(what)))
    }
}

fn parse_plan(text: &str, folder: &Path, stem: &str) -> Result<PlanFile, String> {
    let table: Table = text.parse().map_err(|error: toml::de::Error| {
        let line = |at: usize| 1 + text.bytes().take(at).filter(|&byte| byte == b'\n').count();
        let place = error.span().map_or(String::new(), |span| format!("line {}: ", line(span.start)));
        format!("{place}{}", error.message())
    })?;
    if table.contains_key("shader_file") || table.contains_key("benchmark_frames") {
        return fast_voxels(&table, folder);
    }
    if table.contains_key("Camera") || table.contains_key("camera") {
        // A scene of FastVoxels by itself.
        return Ok(PlanFile { scenes: vec![fast_voxels_scene(stem, folder)], ..PlanFile::default() });
    }
    if let Some(unknown) = table.keys().find(|key| !KEYS.contains(&key.as_str())) {
        return Err(format!("`{unknown}` is no key of a plan: {}", KEYS.join(", ")));
    }
    let of_voxels = |key: &str, value: &Value| voxels(value).map_err(|error| format!("`{key}`: {error}"));
    let sweep = match table.get("sweep") {
        None => None,
        Some(Value::Array(sizes)) => Some(sizes.iter().map(|size| of_voxels("sweep", size)).collect::<Result<_, _>>()?),
        Some(_) => return Err("`sweep` is no list".into()),
    };
    let scenes = list(&table, "scenes")?.iter().map(|entry| scene(entry, folder)).collect::<Result<_, _>>()?;
    let cells = list(&table, "cells")?.iter().map(|cell| string(cell, "cells")).collect::<Result<Vec<_>, _>>()?;
    Ok(PlanFile {
        scenes,
        cells,
        frames: whole(&table, "frames", FRAMES)?,
        warm_up: whole(&table, "warm_up", 0..=100_000)?,
        time_limit: quantity_of(&table, "time_limit", quantity::duration)?,
        size: quantity_of(&table, "size", quantity::size)?,
        max_bounces: whole(&table, "max_bounces", 0..=1024)?,
        integrator: text_of(&table, "integrator")?.map(|name| integrator(&name)).transpose()?,
        voxels: table.get("voxels").map(|value| of_voxels("voxels", value)).transpose()?,
        instances: whole(&table, "instances", 1..=scenes::MAX_INSTANCES)?,
        sweep,
        precise: match table.get("precise") {
            None => false,
            Some(value) => value.as_bool().ok_or("`precise` is neither true nor false")?,
        },
        device: text_of(&table, "device")?,
    })
}

/// A whole number in a range, which is that of the option of this name.
fn whole(table: &Table, key: &str, range: RangeInclusive<u32>) -> Result<Option<u32>, String> {
    let number = |value: &Value| u32::try_from(value.as_integer()?).ok().filter(|number| range.contains(number));
    let wrong = || format!("`{key}` is no whole number from {} to {}", range.start(), range.end());
    table.get(key).map(|value| number(value).ok_or_else(wrong)).transpose()
}

/// A quantity that stands in a text.
fn quantity_of<T>(
    table: &Table,
    key: &str,
    read: impl Fn(&str) -> Result<T, QuantityError>,
) -> Result<Option<T>, String> {
    let text = text_of(table, key)?;
    text.map(|text| read(&text).map_err(|error| format!("`{key}`: {error}"))).transpose()
}

fn list<'a>(table: &'a Table, key: &str) -> Result<&'a [Value], String> {
    match table.get(key) {
        None => Ok(&[]),
        Some(value) => value.as_array().map(Vec::as_slice).ok_or_else(|| format!("`{key}` is no list")),
    }
}

fn string(value: &Value, key: &str) -> Result<String, String> {
    value.as_str().map(str::to_owned).ok_or_else(|| format!("`{key}` holds something that is no text"))
}

fn text_of(table: &Table, key: &str) -> Result<Option<String>, String> {
    table.get(key).map(|value| string(value, key)).transpose()
}

fn integrator(name: &str) -> Result<Integrator, String> {
    let known = [Integrator::Essay, Integrator::Path].into_iter().find(|integrator| integrator.name() == name);
    known.ok_or_else(|| format!("`integrator` is {name:?}, neither essay nor path"))
}

/// A number of voxels, or a text like "500k".
fn voxels(value: &Value) -> Result<u64, String> {
    let number = || value.as_integer().map(|number| number.to_string());
    let text = value.as_str().map(str::to_owned).or_else(number);
    let text = text.ok_or("a number of voxels is neither a whole number nor a text like \"500k\"")?;
    quantity::voxels(&text).map_err(|error| error.to_string())
}

/// A name, or a table with `file` and optionally `camera` and `as`.
fn scene(entry: &Value, folder: &Path) -> Result<SceneEntry, String> {
    let place = |name: String| match scenes::NAMES.contains(&name.as_str()) {
        true => name,
        false => folder.join(name).to_string_lossy().into_owned(),
    };
    let Some(table) = entry.as_table() else {
        return Ok(SceneEntry::named(&place(string(entry, "scenes")?)));
    };
    if let Some(unknown) = table.keys().find(|key| !["file", "camera", "as"].contains(&key.as_str())) {
        return Err(format!("`{unknown}` is no key of a scene: file, camera, as"));
    }
    let is_vox = match text_of(table, "as")?.as_deref() {
        None => false,
        Some("vox") => true,
        Some(other) => return Err(format!("a scene is measured `as = \"vox\"` or as it is, not as {other:?}")),
    };
    let name = text_of(table, "file")?.ok_or("a scene has no `file`")?;
    let camera = text_of(table, "camera")?.map(|camera| folder.join(camera));
    Ok(SceneEntry { name: place(name), camera, is_vox })
}

/// `config.toml` of FastVoxels: `shader_file` is the exact method (NotOptimized) or the approximate one (Optimized).
fn fast_voxels(table: &Table, folder: &Path) -> Result<PlanFile, String> {
    let scene = text_of(table, "scene")?.ok_or("`scene` is missing")?;
    if scene.contains(['/', '\\']) || scene.contains("..") {
        return Err(format!("`scene` is {scene:?}, not the name of a file beside the plan"));
    }
    let cell = match text_of(table, "shader_file")?.as_deref() {
        None => Vec::new(),
        Some("NotOptimized") => vec!["pipeline:voxel-exact".to_owned()],
        Some("Optimized") => vec!["pipeline:voxel-approx".to_owned()],
        Some(other) => return Err(format!("`shader_file` is {other:?}, neither \"NotOptimized\" nor \"Optimized\"")),
    };
    let frames = whole(table, "benchmark_frames", FRAMES)?;
    let sweep = Some(Vec::new());
    Ok(PlanFile { scenes: vec![fast_voxels_scene(&scene, folder)], cells: cell, frames, sweep, ..PlanFile::default() })
}

fn fast_voxels_scene(name: &str, folder: &Path) -> SceneEntry {
    let file = |extension: &str| folder.join(format!("{name}.{extension}"));
    SceneEntry { name: file("vox").to_string_lossy().into_owned(), camera: Some(file("toml")), is_vox: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<PlanFile, String> {
        parse_plan(text, Path::new("plans"), "nyc")
    }

    #[test]
    fn our_own_plan_is_read() {
        let plan = read(
            "scenes = [\"church\", \"mine.vox\", { file = \"a.vxt\", camera = \"a.toml\" }, { file = \"city\", as = \"vox\" }]\ncells = [\"walk\", \"query:all\"]\n\
             frames = 100\nwarm_up = 3\ntime_limit = \"1m\"\nsize = \"640x360\"\nmax_bounces = 2\nvoxels = \"4M\"\n\
             integrator = \"path\"\ninstances = 50\n\
             sweep = [\"500k\", 1000000]\nprecise = true\ndevice = \"0\"",
        )
        .unwrap();
        let names: Vec<&str> = plan.scenes.iter().map(|scene| scene.name.as_str()).collect();
        assert_eq!(names, ["church", "plans/mine.vox", "plans/a.vxt", "city"]);
        let titles = plan.scenes.iter().map(SceneEntry::title).collect::<Vec<_>>();
        assert_eq!(titles[2..], ["plans/a.vxt", "city as vox"]);
        assert_eq!(plan.scenes[2].camera, Some("plans/a.toml".into()));
        assert_eq!((plan.frames, plan.warm_up, plan.max_bounces), (Some(100), Some(3), Some(2)));
        assert_eq!((plan.size, plan.voxels), (Some((640, 360)), Some(4_000_000)));
        assert_eq!((plan.sweep, plan.precise), (Some(vec![500_000, 1_000_000]), true));
        assert_eq!((plan.integrator, plan.instances), (Some(Integrator::Path), Some(50)));
        assert_eq!(plan.cells, ["walk", "query:all"]);
        assert_eq!(read("").unwrap(), PlanFile::default());
    }

    #[test]
    fn the_plan_of_what_people_do_is_read_and_its_cells_and_scenes_exist() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/plans/work.toml");
        let plan = PlanFile::open(&path).unwrap();
        let is_there =
            |scene: &SceneEntry| scenes::NAMES.contains(&scene.name.as_str()) || Path::new(&scene.name).is_file();
        assert!(plan.scenes.len() > 5 && plan.scenes.iter().all(is_there), "{:?}", plan.scenes);
        assert!(plan.cells.iter().all(|cell| crate::plan::parse(cell).is_ok()), "{:?}", plan.cells);
        assert_eq!(plan.integrator, Some(Integrator::Path));
    }

    #[test]
    fn the_study_s_plan_means_its_two_methods() {
        let plan = read("scene = \"Church\"\nbenchmark_frames = 4096\nshader_file = \"Optimized\"\n").unwrap();
        let church =
            SceneEntry { name: "plans/Church.vox".into(), camera: Some("plans/Church.toml".into()), is_vox: false };
        assert_eq!((plan.scenes, plan.frames), (vec![church], Some(4096)));
        assert_eq!(plan.cells, ["pipeline:voxel-approx"]);
        let exact = read("scene = \"Church\"\nshader_file = \"NotOptimized\"").unwrap();
        assert_eq!(exact.cells, ["pipeline:voxel-exact"]);
        let alone = read("[Scene]\nsky_brightness = 0.0\n[Camera]\nx = 1\ny = 2\nz = 3").unwrap();
        assert_eq!(alone.scenes[0].name, "plans/nyc.vox");
    }

    #[test]
    fn what_is_unknown_or_of_another_kind_is_named() {
        let fails = |text: &str| read(text).unwrap_err();
        assert!(fails("frame = 3").contains("`frame`"));
        assert!(fails("frames = -3").contains("`frames`"));
        assert!(fails("frames = \"many\"").contains("`frames`"));
        assert!(fails("scenes = \"church\"").contains("`scenes`"));
        assert!(fails("scenes = [{ camera = \"a\" }]").contains("`file`"));
        assert!(fails("scenes = [{ file = \"a\", light = 3 }]").contains("`light`"));
        assert!(fails("scenes = [{ file = \"a\", as = \"vxt\" }]").contains("not as \"vxt\""));
        assert!(fails("sweep = [\"x\"]").starts_with("`sweep`: \"x\" is not"));
        assert!(fails("voxels = true").starts_with("`voxels`: "));
        assert!(fails("size = \"8\"").starts_with("`size`: \"8\" is not"));
        assert!(fails("time_limit = \"soon\"").starts_with("`time_limit`: \"soon\" is not"));
        // As the options have it: nothing would be measured, or for ever.
        assert!(fails("frames = 0").contains("`frames` is no whole number from 1 to 1000000"));
        assert!(
            fails("warm_up = 1000000").contains("`warm_up`") && fails("max_bounces = 2000").contains("`max_bounces`")
        );
        assert!(fails("precise = 1").contains("`precise`"));
        assert!(fails("integrator = \"fast\"").contains("neither essay nor path"));
        assert!(fails("instances = 0").contains("`instances`"));
        assert!(fails("scene = \"Church\"\nshader_file = \"Fancy\"").contains("Fancy"));
        assert!(fails("scene = \"../Church\"\nbenchmark_frames = 4").contains("beside"));
        assert!(fails("scene = \"Church\"\nbenchmark_frames = 0").contains("benchmark_frames"));
        assert!(fails("frames = 3\nscenes = [\"a\"\n").starts_with("line "));
        assert!(fails("frames = 3\nscenes\n").starts_with("line 2: "));
    }
}
