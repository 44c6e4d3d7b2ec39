//! The pictures of the documentation: the built-in scenes by the program, and what the examples of the library render.

use std::path::Path;
use std::process::Command;

/// Pictures of built-in scenes: name of the scene and of the file in `docs/pictures`, and further options of `render`.
const SCENES: [(&str, &[&str]); 4] = [
    ("church", &["--size", "880x548", "--spp", "400"]),
    ("operating-room", &["--size", "800x500", "--spp", "256"]),
    ("city", &["--size", "800x500", "--spp", "256"]),
    ("forest", &["--size", "800x500", "--spp", "256"]),
];
/// The scenes of the window's welcome, `crates/voxtrace-viewer/thumbnails/SCENE.png`, and how large they are.
const THUMBNAILS: [(&str, [&str; 2]); 4] = [
    ("church", ["--voxels", "2M"]),
    ("operating-room", ["--voxels", "2M"]),
    ("city", ["--voxels", "2M"]),
    ("forest", ["--instances", "10000"]),
];
/// Options of the small pictures.
const THUMBNAIL: [&str; 4] = ["--size", "112x70", "--spp", "512"];
/// Examples of the library that write one picture, `docs/pictures/library/NAME.png`.
const EXAMPLES: [&str; 8] =
    ["procedural_grid", "instances", "picking", "editing", "import", "many_lights", "materials", "gpu_or_cpu"];
/// The clip of the README: options of `render`, and those of ImageMagick's `convert`.
const FLIGHT: [&str; 6] = ["--frames", "1..40", "--size", "320x200", "--spp", "20"];
const FLIGHT_WEBP: [&str; 8] = ["-delay", "8", "-loop", "0", "-quality", "50", "-define", "webp:method=6"];
/// The clip of `docs/animation.md`, `growing.gif`, of `growing.toml`: options of `animate`.
const GROWING: [&str; 5] = ["--size", "320x180", "--spp", "8", "--denoise"];
/// The pictures of materials, `docs/pictures/materials/NAME.webp`: their name here, and options of `convert`.
const MATERIALS: &str = "material-gallery";
const MATERIALS_WEBP: [&str; 4] = ["-quality", "88", "-define", "webp:method=6"];
/// Examples that write several pictures to a folder, and those that are shown: their file there, and what is added to the example's name here.
const FOLDERS: [(&str, [(&str, &str); 3]); 2] = [
    ("turntable", [("frame_0000", "0"), ("frame_0004", "4"), ("frame_0008", "8")]),
    ("live_editing", [("before", "before"), ("edited", "edited"), ("undone", "undone")]),
];

/// Renders all pictures, or those of the scenes and examples that are named.
pub fn render(names: &[&str]) -> Result<(), String> {
    let known = || {
        SCENES.iter().map(|(scene, _)| *scene).chain(EXAMPLES).chain(FOLDERS.map(|(example, _)| example)).chain([
            "thumbnails",
            "flight",
            "growing",
            MATERIALS,
        ])
    };
    if let Some(unknown) = names.iter().find(|name| !known().any(|known| known == **name)) {
        return Err(format!("there is no picture {unknown}; there are {}", known().collect::<Vec<_>>().join(", ")));
    }
    let is_wanted = |name: &str| names.is_empty() || names.contains(&name);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/pictures");
    for (scene, options) in SCENES.iter().filter(|(scene, _)| is_wanted(scene)) {
        render_scene(scene, options, &folder.join(scene).with_extension("png"))?;
    }
    if is_wanted("thumbnails") {
        let thumbnails = Path::new(env!("CARGO_MANIFEST_DIR")).join("../voxtrace-viewer/thumbnails");
        for (scene, size) in THUMBNAILS {
            let options = [&size[..], &THUMBNAIL[..]].concat();
            render_scene(scene, &options, &thumbnails.join(scene).with_extension("png"))?;
        }
    }
    if is_wanted("flight") {
        flight(&folder)?;
    }
    if is_wanted("growing") {
        let program = ["run", "--release", "--package", "voxtrace-cli", "--", "animate", "growing.toml"];
        run(Command::new(env!("CARGO")).current_dir(&folder).args(program).args(GROWING).args(["-o", "growing.gif"]))?;
    }
    if is_wanted(MATERIALS) {
        materials(&folder.join("materials"))?;
    }
    let folder = folder.join("library");
    for example in EXAMPLES.iter().filter(|example| is_wanted(example)) {
        run_example(example, &folder, &[])?;
    }
    for (example, shown) in FOLDERS.iter().filter(|(example, _)| is_wanted(example)) {
        let frames = tempfile::tempdir().map_err(|error| error.to_string())?;
        run_example(example, &folder, &[frames.path()])?;
        for (from, to) in shown {
            let (from, to) = (format!("{from}.png"), folder.join(format!("{example}_{to}.png")));
            std::fs::copy(frames.path().join(from), &to).map_err(|error| format!("{}: {error}", to.display()))?;
        }
    }
    Ok(())
}

/// Renders a built-in scene by the program.
fn render_scene(scene: &str, options: &[&str], output: &Path) -> Result<(), String> {
    let program = ["run", "--release", "--package", "voxtrace-cli", "--", "render", scene];
    run(Command::new(env!("CARGO")).args(program).args(options).arg("-o").arg(output))
}

/// The clip of the README, `flight.webp`: a flight into the city, rendered, and made into one file by ImageMagick.
fn flight(folder: &Path) -> Result<(), String> {
    let frames = tempfile::tempdir().map_err(|error| error.to_string())?;
    let cameras = folder.join("flight.cameras.toml");
    let cameras = cameras.to_str().ok_or("the folder's name is no Unicode")?;
    let options = [&["--flight", cameras], &FLIGHT[..]].concat();
    render_scene("city", &options, &frames.path().join("frame_####.png"))?;
    run(Command::new("convert")
        .args(FLIGHT_WEBP)
        .arg(frames.path().join("frame_*.png"))
        .arg(folder.join("flight.webp")))
}

/// The pictures of materials, rendered, and made small by ImageMagick.
fn materials(folder: &Path) -> Result<(), String> {
    let large = tempfile::tempdir().map_err(|error| error.to_string())?;
    let example = ["run", "--release", "--package", "voxtrace-tests", "--example", "material_gallery", "--"];
    run(Command::new(env!("CARGO")).args(example).arg(large.path()))?;
    let files = std::fs::read_dir(large.path()).map_err(|error| error.to_string())?;
    for path in files.flatten().map(|file| file.path()) {
        let small = folder.join(path.file_stem().unwrap_or_default()).with_extension("webp");
        run(Command::new("convert").arg(&path).args(MATERIALS_WEBP).arg(small))?;
    }
    Ok(())
}

/// Runs an example of the library in a folder, where it writes its picture unless it is given another place.
fn run_example(example: &str, folder: &Path, arguments: &[&Path]) -> Result<(), String> {
    let build = ["run", "--release", "--package", "voxtrace", "--example", example, "--"];
    run(Command::new(env!("CARGO")).current_dir(folder).args(build).args(arguments))
}

fn run(command: &mut Command) -> Result<(), String> {
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        _ => Err(format!("this failed: {command:?}")),
    }
}
