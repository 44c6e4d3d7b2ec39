//! `voxelize --memory-budget` of volumes larger than it: how much memory it takes, and how it goes on where it was interrupted.

#![cfg(unix)]

use crate::common::{Folder, stderr};
use crate::interrupt::interrupted;
use std::io::{Seek, SeekFrom, Write};

/// A file of `layers` layers of 1,024 × 1,024 bytes, all 0 but for a block in every eighth one. Most of it is a hole that takes no disk.
fn write_sparse(folder: &Folder, layers: u64) {
    const LAYER: u64 = 1 << 20;
    let mut file = std::fs::File::create(folder.path("large.raw")).unwrap();
    file.set_len(layers * LAYER).unwrap();
    for layer in (0..layers).step_by(8) {
        file.seek(SeekFrom::Start(layer * LAYER + 500 * 1024)).unwrap();
        let rows: Vec<u8> =
            (0..16 * 1024u32).map(|at| if at % 1024 < 300 { 60 + (at % 90) as u8 } else { 0 }).collect();
        file.write_all(&rows).unwrap();
    }
}

#[cfg(target_os = "linux")]
fn arguments(budget: &'static str, out: &'static str) -> [&'static str; 9] {
    arguments_of("1024x1024x128:u8", budget, out)
}

fn arguments_of(shape: &'static str, budget: &'static str, out: &'static str) -> [&'static str; 9] {
    ["voxelize", "large.raw", "--raw-shape", shape, "-o", out, "--memory-budget", budget, "--transfer=mri"]
}

/// The most memory that a process was seen to have, in bytes, once it has ended well; nothing where the system does not tell.
#[cfg(target_os = "linux")]
fn peak(mut child: std::process::Child) -> Option<u64> {
    let mut most: Option<u64> = None;
    loop {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.trim().trim_end_matches(" kB").parse::<u64>().ok());
        most = most.max(kilobytes.map(|kilobytes| kilobytes * 1024));
        if let Some(status) = child.try_wait().unwrap() {
            assert!(status.success());
            return most;
        }
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_volume_beyond_its_budget_takes_little_memory_and_becomes_the_scene_of_the_same_volume_in_memory() {
    if !std::fs::read_to_string("/proc/self/status").is_ok_and(|status| status.contains("VmHWM")) {
        return voxtrace_test_support::skip("this system does not tell the memory of a process");
    }
    let folder = Folder::new();
    write_sparse(&folder, 128);
    let started = |budget, out| {
        let mut command = folder.command(&arguments(budget, out));
        let quiet = std::process::Stdio::null;
        peak(command.stderr(quiet()).stdout(quiet()).spawn().unwrap())
    };
    // 134 million samples take 537 MB as numbers.
    let (small, mut large) = (started("64MB", "small.vxt"), started("64GB", "large.vxt"));
    // What this thread sees of a process while others have the processors may be its beginning.
    for _ in 0..20 {
        if large.is_none_or(|large| large <= 500_000_000) {
            std::fs::remove_file(folder.path("large.vxt")).unwrap();
            large = large.max(started("64GB", "large.vxt"));
        }
    }
    let (small, large) = (small.unwrap(), large.unwrap());
    assert!(small < 200_000_000 && large > 500_000_000, "{small} and {large} bytes");
    let info = |name: &str| folder.succeed(&["info", name]).replace(name, "");
    assert_eq!(info("small.vxt"), info("large.vxt"));
    let bytes = |name: &str| {
        let scene = voxtrace::PackedScene::read(&folder.path(name)).unwrap();
        scene.save(&folder.path(name)).unwrap();
        folder.bytes(name)
    };
    assert!(bytes("small.vxt") == bytes("large.vxt"));
}

#[test]
fn voxelizing_a_volume_that_is_interrupted_or_killed_goes_on_and_ends_with_the_same_file() {
    let folder = Folder::new();
    // As many as take a second.
    write_sparse(&folder, 1024);
    let arguments = |out| arguments_of("1024x1024x1024:u8", "64MB", out);
    folder.succeed(&arguments("whole.vxt"));
    for name in ["-KILL", "-INT", "-TERM"] {
        let output = interrupted(&folder, &arguments("a.vxt"), ("a.vxt.part", 20_000), "a.vxt", name);
        assert_eq!(output.status.code(), if name == "-KILL" { None } else { Some(130) }, "{}", stderr(&output));
        assert!(!folder.exists("a.vxt") && folder.exists("a.vxt.part"));
        // With another threshold it is other work.
        if name == "-INT" {
            let other = folder.run(&[&arguments("a.vxt")[..], &["--threshold", "99"]].concat());
            assert!(
                other.status.success() && stderr(&other).contains("left over from other work"),
                "{}",
                stderr(&other)
            );
            assert!(folder.bytes("a.vxt") != folder.bytes("whole.vxt"));
            std::fs::remove_file(folder.path("a.vxt")).unwrap();
            continue;
        }
        let output = folder.run(&arguments("a.vxt"));
        assert!(output.status.success() && stderr(&output).contains("going on from"), "{}", stderr(&output));
        assert!(folder.bytes("a.vxt") == folder.bytes("whole.vxt"), "{name}");
        std::fs::remove_file(folder.path("a.vxt")).unwrap();
    }
}

#[test]
fn coarse_voxels_are_shown_from_the_threshold_that_they_have_in_memory() {
    let folder = Folder::new();
    let samples: Vec<u8> = (0..32 * 32 * 32u32).map(|n| if n % 211 == 17 { 250 } else { (n * 7 % 50) as u8 }).collect();
    std::fs::write(folder.path("sparks.raw"), samples).unwrap();
    let voxelize = |out: &str, more: &[&str]| {
        let plain = ["voxelize", "sparks.raw", "--raw-shape", "32x32x32:u8", "--resolution", "6", "-o", out];
        let output = folder.run(&[&plain[..], more].concat());
        (output.status.success(), stderr(&output))
    };
    let (memory, large) = (voxelize("memory.vxt", &[]), voxelize("large.vxt", &["--memory-budget", "1kB"]));
    assert!(memory.0 && large.0, "{} {}", memory.1, large.1);
    let line = |said: &str| said.lines().find(|line| line.contains("no voxel of that size")).map(str::to_owned);
    assert!(line(&memory.1).is_some() && line(&memory.1) == line(&large.1), "{} {}", memory.1, large.1);
    let info = |name: &str| folder.succeed(&["info", name]).replace(name, "").replace("large", "memory");
    assert_eq!(info("memory.vxt"), info("large.vxt"));
    // Whoever chose is told that nothing is to be seen.
    let (succeeded, said) = voxelize("chosen.vxt", &["--memory-budget", "1kB", "--transfer", "mri"]);
    assert!(!succeeded && said.contains("choose another --transfer or --threshold"), "{said}");
}
