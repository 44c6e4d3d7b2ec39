//! The programs in `examples/` run, write what they say, and nothing else. `cargo test` builds them beside the tests; a run of this test
//! alone takes those of the last build.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Fewest colours of a picture, and least standard deviation of its bytes: below either it shows nothing.
const FEWEST_COLORS: usize = 256;
const LEAST_DEVIATION: f64 = 5.0;

/// The program of an example, two folders up from this test's own and down again.
fn program(example: &str) -> PathBuf {
    let test = std::env::current_exe().unwrap();
    let build = test.parent().and_then(Path::parent).unwrap();
    let program = build.join("examples").join(format!("{example}{}", std::env::consts::EXE_SUFFIX));
    assert!(
        program.exists(),
        "{} is not built: cargo build --release --package voxtrace --examples",
        program.display()
    );
    program
}

/// Runs an example in a folder, which is also the folder of temporary files, and gives what it printed.
fn run(example: &str, arguments: &[&str], folder: &Path) -> String {
    let mut command = Command::new(program(example));
    command.args(arguments).current_dir(folder).envs(["TMPDIR", "TMP", "TEMP"].map(|name| (name, folder)));
    let output = command.output().unwrap();
    let printed = String::from_utf8_lossy(&output.stdout).replace('\\', "/");
    assert!(output.status.success(), "{example}: {printed}{}", String::from_utf8_lossy(&output.stderr));
    printed
}

/// The files below a folder, by their paths in it.
fn files(folder: &Path) -> BTreeSet<String> {
    let (mut found, mut open) = (BTreeSet::new(), vec![folder.to_owned()]);
    while let Some(next) = open.pop() {
        for path in std::fs::read_dir(next).unwrap().map(|entry| entry.unwrap().path()) {
            match path.is_dir() {
                true => open.push(path),
                false => _ = found.insert(path.strip_prefix(folder).unwrap().to_string_lossy().replace('\\', "/")),
            }
        }
    }
    found
}

/// What is wrong with a picture: its size, or that it shows nothing.
fn fault(size: (u32, u32), rgb: &[u8], wanted: (u32, u32)) -> Option<String> {
    if size != wanted || rgb.len() != (size.0 * size.1 * 3) as usize {
        return Some(format!("{size:?} pixels, not {wanted:?}"));
    }
    let colors = rgb.chunks_exact(3).collect::<BTreeSet<_>>().len();
    let mean = rgb.iter().map(|byte| f64::from(*byte)).sum::<f64>() / rgb.len() as f64;
    let variance = rgb.iter().map(|byte| (f64::from(*byte) - mean).powi(2)).sum::<f64>() / rgb.len() as f64;
    let shows_something = colors >= FEWEST_COLORS && variance.sqrt() >= LEAST_DEVIATION;
    (!shows_something).then(|| format!("{colors} colours, deviation {:.1}", variance.sqrt()))
}

fn check_picture(path: &Path, wanted: (u32, u32)) {
    let decoder = png::Decoder::new(std::io::BufReader::new(std::fs::File::open(path).unwrap()));
    let mut reader = decoder.read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    assert_eq!(info.color_type, png::ColorType::Rgb, "{}", path.display());
    assert_eq!(fault((info.width, info.height), &bytes, wanted), None, "{}", path.display());
}

/// Runs an example without arguments: it writes the pictures `names` and nothing else, and prints the name of each. Gives what it printed.
fn check_example(example: &str, names: &[String], size: (u32, u32)) -> String {
    let folder = tempfile::tempdir().unwrap();
    let printed = run(example, &[], folder.path());
    assert_eq!(files(folder.path()), names.iter().cloned().collect(), "{example}");
    for name in names {
        assert!(printed.contains(name.as_str()), "{example} does not say that it wrote {name}: {printed}");
        check_picture(&folder.path().join(name), size);
    }
    printed
}

fn check_example_of_one_picture(example: &str, size: (u32, u32)) {
    check_example(example, &[format!("{example}.png")], size);
}

#[test]
fn a_grid_from_a_formula_is_rendered() {
    check_example_of_one_picture("procedural_grid", (400, 300));
}

#[test]
fn a_forest_of_instances_is_rendered() {
    check_example_of_one_picture("instances", (400, 225));
}

#[test]
fn a_picked_place_is_rendered() {
    check_example_of_one_picture("picking", (400, 225));
}

#[test]
fn a_bridge_of_edits_is_rendered() {
    check_example_of_one_picture("editing", (400, 225));
}

#[test]
fn an_imported_mesh_is_rendered_and_its_file_removed() {
    check_example_of_one_picture("import", (400, 300));
}

#[test]
fn a_turntable_writes_its_frames_to_a_folder() {
    let frames: Vec<String> = (0..12).map(|frame| format!("turntable/frame_{frame:04}.png")).collect();
    check_example("turntable", &frames, (320, 180));
}

#[test]
fn an_edited_scene_is_rendered_before_and_after_and_once_more_when_it_is_undone() {
    let names = ["before", "edited", "undone"].map(|name| format!("live_editing/{name}.png"));
    let printed = check_example("live_editing", &names, (320, 180));
    assert!(printed.contains("undone, it is the picture from before; edited, it is another one"), "{printed}");
}

#[test]
fn many_lights_are_rendered() {
    check_example_of_one_picture("many_lights", (400, 225));
}

#[test]
fn all_materials_are_rendered() {
    check_example_of_one_picture("materials", (400, 300));
}

#[test]
fn gpu_or_cpu_renders_on_whatever_there_is() {
    check_example_of_one_picture("gpu_or_cpu", (400, 225));
}

#[test]
fn an_example_reads_the_file_and_writes_the_picture_that_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
    std::fs::write(folder.path().join("tetrahedron.obj"), tetrahedron).unwrap();
    let printed = run("import", &["tetrahedron.obj", "seen.png"], folder.path());
    assert!(printed.starts_with("seen.png: "), "{printed}");
    check_picture(&folder.path().join("seen.png"), (400, 300));
    assert_eq!(files(folder.path()), ["seen.png", "tetrahedron.obj"].map(str::to_owned).into());
}

/// Lines of Rust in the section of `page` on an example that its source does not have. Spaces and line breaks do not count.
fn foreign_lines(page: &str, example: &str, source: &str) -> Vec<String> {
    let tight = |text: &str| text.split_whitespace().collect::<String>();
    let section = page.split("\n## ").find(|section| section.starts_with(&format!("`{example}`"))).unwrap_or_default();
    let code = section.split("```rust\n").skip(1).filter_map(|rest| rest.split("```").next());
    let lines = code.flat_map(str::lines).filter(|line| !line.starts_with("//"));
    lines.filter(|line| !tight(source).contains(&tight(line))).map(str::to_owned).collect()
}

#[test]
fn every_example_has_a_test_here_and_the_documentation_shows_its_picture_and_its_lines() {
    let crate_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let tests = include_str!("examples.rs");
    // A package of the crate alone has no pages.
    let Ok(page) = std::fs::read_to_string(crate_folder.join("../../docs/library.md")) else { return };
    let names = files(&crate_folder.join("examples"));
    assert!(names.contains("import.rs"), "{names:?}");
    for file in &names {
        let name = file.strip_suffix(".rs").unwrap();
        assert!(tests.contains(&format!("(\"{name}\", ")), "no test runs {name}");
        assert!(page.contains(&format!("pictures/library/{name}")), "no picture of {name}");
        let source = std::fs::read_to_string(crate_folder.join("examples").join(file)).unwrap();
        assert!(page.contains(&format!("\n## `{name}`")), "no section on {name}");
        assert_eq!(foreign_lines(&page, name, &source), Vec::<String>::new(), "{name}");
    }
    let planted = "\n## `import`: files\n```rust\nlet a = 1;\nlet b = 2;\n```\n";
    assert_eq!(foreign_lines(planted, "import", "let a =\n    1;"), ["let b = 2;"]);
}

#[test]
fn a_picture_that_shows_nothing_is_noticed() {
    let size = (40, 30);
    let pixels = || (0..size.0 * size.1).map(|pixel| pixel as u8);
    let good: Vec<u8> = pixels().zip(0..).flat_map(|(shade, pixel)| [shade, (pixel >> 8) as u8 * 40, 90]).collect();
    assert_eq!(fault(size, &good, size), None);
    assert!(fault(size, &vec![0; good.len()], size).is_some(), "black");
    assert!(fault(size, &vec![200; good.len()], size).is_some(), "one colour");
    let faint: Vec<u8> = good.iter().map(|byte| 120 + byte / 32).collect();
    assert!(fault(size, &faint, size).is_some(), "nearly one colour");
    assert!(fault(size, &good, (30, 40)).is_some(), "another size");
    assert!(fault(size, &good[..30], size).is_some(), "cut short");
}
