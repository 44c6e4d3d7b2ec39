//! `voxtrace doctor` and `voxtrace doctor --rt`.

use crate::common::{Folder, stderr, stdout};
use serde_json::Value;
use std::path::PathBuf;
use std::process::Command;
use voxtrace_test_support::{Need, skip_without};

/// The program with a cache of its own.
fn doctor(folder: &Folder, arguments: &[&str]) -> Command {
    let mut command = folder.command(&[&["doctor"], arguments].concat());
    command.env("VOXTRACE_CACHE", folder.path("cache"));
    command
}

fn succeed(mut command: Command) -> String {
    let output = command.output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    stdout(&output)
}

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// Options that name a device with ray tracing, `None` where there is none.
fn device(folder: &Folder) -> Option<[String; 2]> {
    let examined = json(&succeed(doctor(folder, &["--json"])));
    let has_rays =
        |device: &&Value| ["query", "pipeline"].iter().any(|name| device["traversals"][name]["available"] == true);
    let found = examined["devices"].as_array().unwrap().iter().find(has_rays).map(|device| device["index"].to_string());
    if found.is_none() {
        skip_without(Need::Vulkan, "no device with ray tracing");
    }
    Some(["--device".into(), found?])
}

fn cached(folder: &Folder) -> Vec<PathBuf> {
    let files = std::fs::read_dir(folder.path("cache")).into_iter().flatten().flatten();
    files.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|e| e == "json")).collect()
}

#[test]
fn the_doctor_says_what_traces_and_what_is_missing() {
    let folder = Folder::new();
    let text = succeed(doctor(&folder, &[]));
    assert!(text.starts_with("voxtrace ") && text.contains(" traces on "), "{text}");
    assert!(text.contains("cpu      ") && text.contains("vulkan   "), "{text}");
    // Without probes there is no device to choose, and a variable that is for all runs is none to talk about.
    let mut told = doctor(&folder, &["--device", "9"]);
    let said = stderr(&told.env_remove("VOXTRACE_DEVICE").output().unwrap());
    assert!(said.contains("warning: --device changes nothing: without --rt all devices are examined"), "{said}");
    let said = stderr(&doctor(&folder, &[]).env("VOXTRACE_DEVICE", "9").output().unwrap());
    assert!(!said.contains("changes nothing"), "{said}");
    let examined = json(&succeed(doctor(&folder, &["--json"])));
    assert!(examined["host"]["threads"].as_u64().unwrap() > 0);
    if cfg!(target_os = "linux") {
        assert!(examined["host"]["memory_bytes"].as_u64().unwrap() > 1 << 28);
    }
    for device in examined["devices"].as_array().unwrap() {
        let pipeline = &device["traversals"]["pipeline"];
        let offered = pipeline["extensions"]["VK_KHR_ray_tracing_pipeline"].as_bool().unwrap();
        assert_eq!(offered, pipeline["available"], "an extension is what decides: {device}");
        assert!(device["probes"]["says"].as_str().unwrap().contains("doctor --rt"));
    }
}

#[test]
fn without_a_driver_the_doctor_says_what_to_install_and_the_cpu_traces() {
    let folder = Folder::new();
    std::fs::write(folder.path("broken.json"), r#"{"ICD": {"library_path": "./gone.so"}}"#).unwrap();
    let mut command = doctor(&folder, &[]);
    command.env("VK_DRIVER_FILES", folder.path("broken.json")).env("VK_ICD_FILENAMES", folder.path("broken.json"));
    let text = succeed(command);
    assert!(text.contains("traces on the CPU"), "{text}");
    // What to install on this system, and nothing of others.
    let systems = ["apt install", "dnf install", "pacman -S", "zypper install", "brew install", "Windows"];
    let named = systems.iter().filter(|system| text.contains(**system)).count();
    assert!(named == 1 || (named == 0 && text.contains("drivers")), "{text}");
    // The loader is there: it is the driver that is missing.
    assert!(!text.contains("libvulkan1") || !text.contains("Driver"), "{text}");
    assert!(text.contains("./gone.so is not there"), "{text}");
    let mut command = doctor(&folder, &["--rt"]);
    command.env("VK_DRIVER_FILES", folder.path("broken.json")).env("VK_ICD_FILENAMES", folder.path("broken.json"));
    command.env_remove("VOXTRACE_DEVICE");
    assert!(succeed(command).contains("Nothing to probe"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_variable_that_hides_the_drivers_and_manifests_that_are_none_are_told() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new();
    let told = |files: &std::ffi::OsStr, arguments: &[&str]| {
        let mut command = doctor(&folder, arguments);
        // Older loaders know the second name alone.
        command.env("VK_DRIVER_FILES", files).env("VK_ICD_FILENAMES", files).env_remove("VK_ADD_DRIVER_FILES");
        succeed(command)
    };
    let nothing = told("".as_ref(), &[]);
    assert!(nothing.contains("- VK_DRIVER_FILES is set: ") && !nothing.contains("\ndriver "), "{nothing}");
    let gone = told("/nowhere/driver".as_ref(), &[]);
    assert!(gone.contains("driver   /nowhere/driver: ?, but no such file or directory"), "{gone}");
    std::fs::write(folder.path("cut.json"), "{").unwrap();
    let cut = told(folder.path("cut.json").as_os_str(), &[]);
    assert!(cut.contains("cut.json cannot be used: it is no JSON"), "{cut}");
    // A name that is no Unicode.
    let odd = json(&told(std::ffi::OsStr::from_bytes(b"/nowhere/\xff.json"), &["--json"]));
    assert!(odd["vulkan"]["drivers"][0]["manifest"].as_str().unwrap().starts_with("/nowhere/"), "{odd}");
}

#[test]
fn the_probes_print_a_table_write_files_and_are_remembered() {
    let folder = Folder::new();
    let Some(device) = device(&folder) else { return };
    let device = device.each_ref().map(String::as_str);
    let text = succeed(doctor(&folder, &[&["--rt", "-o", "out"], &device[..]].concat()));
    for id in (1..=19).map(|number| format!("P{number} ")) {
        assert!(text.lines().any(|line| line.starts_with(&id)), "{id}: {text}");
    }
    assert!(text.contains("Verdict: "), "{text}");
    let written: Vec<&str> = text.lines().filter(|line| line.starts_with("out")).collect();
    assert_eq!(written.len(), 2, "{text}");
    let report = json(&String::from_utf8(folder.bytes(written[0])).unwrap());
    assert_eq!(report["probes"].as_array().unwrap().len(), 19);
    assert_eq!((&report["schema"], &report["effort"]), (&1.into(), &"quick".into()));
    for probe in report["probes"].as_array().unwrap() {
        for key in ["id", "name", "outcome", "says"] {
            assert!(!probe[key].as_str().unwrap().is_empty(), "{key}: {probe}");
        }
    }
    let page = String::from_utf8(folder.bytes(written[1])).unwrap();
    assert_eq!(page.lines().filter(|line| line.starts_with("| P")).count(), 19, "{page}");

    assert_eq!(cached(&folder).len(), 1);
    let text = succeed(doctor(&folder, &[]));
    assert!(text.contains("(quick)") && !text.contains("not probed yet"), "{text}");
    std::fs::write(&cached(&folder)[0], "rubbish").unwrap();
    let text = succeed(doctor(&folder, &[]));
    assert!(text.contains("is ignored: it is no report"), "{text}");
    // What is printed is the object alone, also where files are written.
    let again = json(&succeed(doctor(&folder, &[&["--rt", "--json", "-o", "again"], &device[..]].concat())));
    assert_eq!(std::fs::read_dir(folder.path("again")).unwrap().count(), 2);
    assert_eq!(again["probes"].as_array().unwrap().len(), 19);
    assert!(again["verdict"].as_str().unwrap().len() > 10);
}

#[test]
fn a_render_heeds_what_is_remembered_but_does_not_probe() {
    let folder = Folder::new();
    let Some(device) = device(&folder) else { return };
    let device = device.each_ref().map(String::as_str);
    let traced = || {
        let mut arguments =
            vec!["render", "room.vox", "-o", "a.png", "--size", "8x6", "--spp", "1", "--traversal", "pipeline"];
        arguments.extend(device);
        let mut command = folder.command(&arguments);
        let output = command.env("VOXTRACE_CACHE", folder.path("cache")).output().unwrap();
        assert!(output.status.success(), "{}", stderr(&output));
        stderr(&output)
    };
    assert!(traced().contains("primitive brick"));
    assert_eq!(cached(&folder).len(), 0, "nothing was probed");
    succeed(doctor(&folder, &[&["--rt"], &device[..]].concat()));
    let file = &cached(&folder)[0];
    let mut report = json(&std::fs::read_to_string(file).unwrap());
    for finding in report["probes"][1]["findings"].as_array_mut().unwrap() {
        finding["outcome"] = "fails".into();
        finding["says"] = "merged".into();
    }
    std::fs::write(file, report.to_string()).unwrap();
    let told = traced();
    assert!(told.contains("primitive grid") && told.contains("grid instead of") && told.contains("merged"), "{told}");
}

#[test]
fn options_of_the_probes_need_the_probes() {
    let folder = Folder::new();
    for arguments in [&["doctor", "--full"][..], &["doctor", "-o", "out"]] {
        assert!(folder.fail(arguments, 2).contains("--rt"));
    }
    folder.fail(&["doctor", "--rt", "--device", "no such device"], 1);
}
