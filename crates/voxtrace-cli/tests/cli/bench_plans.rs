//! What `voxtrace bench` is told to measure: integrators, scenes, instructions and shaders, by options and by plans.

use crate::bench::{SMALL, run};
use crate::common::{Folder, stderr};
use serde_json::Value;
use voxtrace_test_support::{Need, skip_without};

#[test]
fn the_integrator_path_is_measured_by_option_and_plan_and_not_compared_with_the_study_s() {
    let folder = Folder::new();
    let (results, _) = run(&folder, &["--cells", "cpu"]);
    assert_eq!((&results["settings"]["integrator"], &results["settings"]["max_bounces"]), (&"essay".into(), &3.into()));
    assert!(
        String::from_utf8(folder.bytes("report/report.md")).unwrap().contains("integrator essay, at most 3 bounces")
    );
    std::fs::rename(folder.path("report"), folder.path("essay")).unwrap();
    let (results, _) = run(&folder, &["--cells", "cpu", "--integrator", "path"]);
    assert_eq!((&results["settings"]["integrator"], &results["settings"]["max_bounces"]), (&"path".into(), &8.into()));
    let text = |name: &str| String::from_utf8(folder.bytes(name)).unwrap();
    assert!(text("report/report.md").contains("integrator path, at most 8 bounces"));
    assert!(text("report/report.md").contains("The integrator is path, not the study's essay"));
    assert!(text("report/frame-time-1-room.svg").contains("frame time over frames, path"));
    assert!(text("essay/report.html").contains("here of up to 4 rays; frames"));
    assert!(text("report/report.html").contains("here of up to 9 rays, those towards lights aside; frames"));
    let compared = folder.succeed(&["compare", "essay", "report"]);
    assert!(compared.contains("integrator (\"essay\", \"path\")"), "{compared}");
    assert!(compared.contains(", integrator essay, ") && compared.contains(", integrator path, "), "{compared}");

    // A plan says it too, and what light towards lamps and sky costs is in what was rendered: another picture.
    std::fs::write(folder.path("plan.toml"), "scenes = [\"room.vxt\"]\ncells = [\"cpu\"]\nintegrator = \"path\"")
        .unwrap();
    folder.succeed(&[&["bench", "--plan", "plan.toml"], &SMALL[..6], &["-o", "planned"]].concat());
    let planned: Value = serde_json::from_slice(&folder.bytes("planned/results.json")).unwrap();
    assert_eq!(planned["settings"]["integrator"], "path");
    let picture = |name: &str| folder.bytes(&format!("{name}/1-room-cpu.jpg"));
    assert_eq!(picture("planned"), picture("report"));
    assert_ne!(picture("essay"), picture("report"));
}

#[test]
fn a_forest_is_measured_with_as_many_instances_as_are_asked_for() {
    let folder = Folder::new();
    let small = [&["bench", "forest", "--cells", "cpu"], &SMALL[..2], &["--frames", "1", "--warm-up", "0"]].concat();
    folder.succeed(&[&small[..], &["--instances", "40", "-o", "report"]].concat());
    let results: Value = serde_json::from_slice(&folder.bytes("report/results.json")).unwrap();
    assert_eq!((&results["settings"]["instances"], &results["complete"]), (&40.into(), &true.into()));
    let hash = results["scenes"][0]["content_hash"].as_str().unwrap();
    assert!(folder.succeed(&["info", "forest", "--instances", "40"]).contains(hash));
    assert!(!folder.succeed(&["info", "forest", "--instances", "41"]).contains(hash));
    let other = folder.fail(&[&small[..], &["--instances", "41", "-o", "report", "--resume"]].concat(), 5);
    assert!(other.contains("instances (40, now 41)"), "{other}");
    // What it is not for.
    assert!(folder.fail(&["bench", "room.vxt", "--cells", "cpu", "--instances", "40"], 2).contains("forest"));
    assert!(folder.fail(&["bench", "--cells", "cpu", "--instances", "40"], 2).contains("forest"));
    assert!(folder.fail(&[&small[..], &["--instances", "0"]].concat(), 2).contains("--instances"));
}

#[test]
fn a_plan_measures_a_built_in_scene_as_its_vox_file_and_each_instruction_set_of_the_cpu() {
    let folder = Folder::new();
    folder.succeed(&["convert", "city", "city.vox", "--voxels", "20k"]);
    let plan = "scenes = [{ file = \"city\", as = \"vox\" }, \"city.vox\", \"city\"]\ncells = [\"cpu:all\"]\nvoxels = \"20k\"\nsweep = []";
    std::fs::write(folder.path("plan.toml"), plan).unwrap();
    folder.succeed(&[&["bench", "--plan", "plan.toml"], &SMALL[..]].concat());
    let results: Value = serde_json::from_slice(&folder.bytes("report/results.json")).unwrap();
    assert_eq!(results["settings"]["scenes"], serde_json::json!(["city as vox", "city.vox", "city"]));
    let hash = |scene: usize| results["scenes"][scene]["content_hash"].as_str().unwrap();
    assert!(hash(0) == hash(1) && hash(0) != hash(2), "{}", results["scenes"]);
    assert_eq!((&results["scenes"][0]["name"], &results["scenes"][2]["name"]), (&"city-vox".into(), &"city".into()));

    // Every set gives the same picture, in a row of its own that says which one.
    let names: Vec<String> = results["cells"].as_array().unwrap().iter().map(|cell| cell["cell"].to_string()).collect();
    let sets = names.len() / 3;
    assert!(sets >= 2 && names.len() == 3 * sets && names[..sets] == names[sets..2 * sets], "{names:?}");
    assert_eq!(names[sets - 2..sets], ["\"cpu:portable\"", "\"cpu:scalar\""]);
    let picture = |set: &str| folder.bytes(&format!("report/1-city-vox-{set}.jpg"));
    assert_eq!(picture("cpu-portable"), picture("cpu-scalar"));
    let resumed = folder.succeed(&[&["bench", "--plan", "plan.toml", "--resume", "--json"], &SMALL[..]].concat());
    assert_eq!(serde_json::from_str::<Value>(&resumed).unwrap()["cells"], results["cells"]);
    assert!(folder.fail(&["bench", "city", "--cells", "cpu:sse9"], 2).contains("instructions of a CPU"));
}

#[test]
fn one_benchmark_measures_quick_and_exact_shaders() {
    let folder = Folder::new();
    let devices: Value = serde_json::from_str(&folder.succeed(&["devices", "--json"])).unwrap();
    if devices["devices"].as_array().unwrap().len() < 2 {
        skip_without(Need::Vulkan, "no Vulkan device");
        return;
    }
    let (results, _) =
        run(&folder, &["--device", "0", "--cells", "walk:fast,walk:precise,cpu", "--integrator", "path"]);
    let shaders: Vec<&Value> = results["cells"].as_array().unwrap().iter().map(|cell| &cell["shaders"]).collect();
    assert_eq!(shaders, ["fast", "precise", "precise"]);
    // The exact ones give the picture of the CPU.
    let picture = |cell: &str| folder.bytes(&format!("report/1-room-{cell}.jpg"));
    assert_eq!(picture("walk-precise"), picture("cpu"));
}

#[test]
fn a_plan_of_the_study_s_program_measures_its_scene_with_its_camera_and_light() {
    let folder = Folder::new();
    let write = |name: &str, text: &str| std::fs::write(folder.path(name), text).unwrap();
    write("config.toml", "scene = \"room\"\nbenchmark_frames = 5\nshader_file = \"NotOptimized\"\n");
    write(
        "room.toml",
        "[Scene]\nsky_brightness = 0.5\nlight_intensity = 2.0\n[Camera]\nx = 1\ny = 9\nz = 30\nyaw = 10\n",
    );
    let options = ["--size", "32x24", "--warm-up", "1", "--cells", "cpu"];
    folder.succeed(&[&["bench", "--plan", "config.toml", "-o", "a"], &options[..]].concat());
    folder.succeed(&[&["bench", "room.vox", "--frames", "5", "--sweep", "none", "-o", "b"], &options[..]].concat());
    let read = |name: &str| -> Value { serde_json::from_slice(&folder.bytes(name)).unwrap() };
    let (a, b) = (read("a/results.json"), read("b/results.json"));
    assert_eq!((&a["settings"]["frames"], &a["scenes"][0]["camera"]), (&5.into(), &"room".into()));
    assert_ne!(a["scenes"][0]["content_hash"], b["scenes"][0]["content_hash"]);
    // Without a GPU its method cannot run: a row with the reason.
    let mut command = folder.command(&["bench", "--plan", "config.toml", "-o", "c"]);
    let output = command.env("VK_DRIVER_FILES", "/nowhere").env("VK_ICD_FILENAMES", "/nowhere").output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(read("c/results.json")["cells"][0]["cell"], "pipeline:voxel-exact");
    write("wrong.toml", "frame = 5");
    assert!(folder.fail(&["bench", "--plan", "wrong.toml"], 3).contains("`frame`"));
}

#[test]
fn what_cannot_be_measured_is_refused_before_anything_is() {
    let folder = Folder::new();
    let write = |name: &str, text: &str| std::fs::write(folder.path(name), text).unwrap();
    write("plan.toml", "scenes = [\"room.vxt\", { file = \"room.vox\", camera = \"gone.toml\" }]");
    write("sweep.toml", "scenes = [\"room.vxt\", \"city\"]\nsweep = [10]");
    for (arguments, code, said) in [
        (&["city", "--voxels", "20k", "--sweep", "2k,10"][..], 2, "a scene of 10 voxels: from 1000 to"),
        (&["room.vxt", "city", "--voxels", "10"], 2, "a scene of 10 voxels"),
        (&["room.vxt", "gone.vxt"], 3, "cannot read gone.vxt: "),
        (&["room.vxt", "--camera-file", "gone.toml"], 3, "gone.toml"),
        (&["--plan", "plan.toml"], 3, "gone.toml"),
        (&["--plan", "sweep.toml"], 2, "a scene of 10 voxels"),
    ] {
        let line = folder.fail(&[&["bench", "--cells", "cpu"], arguments, &SMALL[..]].concat(), code);
        assert!(line.contains(said), "{line}");
        assert!(!folder.exists("report"), "something was measured: {arguments:?}");
    }
}

#[test]
fn a_camera_is_framed_for_the_size_that_the_plan_says() {
    let folder = Folder::new();
    let mut scene = crate::common::room();
    scene.cameras.clear();
    voxtrace::export::vox::write(&folder.path("bare.vox"), &scene).unwrap();
    std::fs::write(folder.path("plan.toml"), "size = \"24x32\"").unwrap();
    let hash = |size: [&str; 2], name: &str| {
        let options = ["--cells", "cpu", "--frames", "1", "--warm-up", "0", "--fov", "40", "-o", name];
        folder.succeed(&[&["bench", "bare.vox"], &size[..], &options].concat());
        let results: Value = serde_json::from_slice(&folder.bytes(&format!("{name}/results.json"))).unwrap();
        results["scenes"][0]["content_hash"].clone()
    };
    assert_eq!(hash(["--plan", "plan.toml"], "planned"), hash(["--size", "24x32"], "asked"));
}

#[test]
fn a_time_limit_of_ages_is_one_that_is_never_reached() {
    let folder = Folder::new();
    let (results, _) = run(&folder, &["--cells", "cpu", "--time-limit", "5000000000000000h"]);
    assert_eq!(results["cells"][0]["frames"], 9);
}
