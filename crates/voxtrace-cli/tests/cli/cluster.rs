//! The program that has the cluster, played by a shell: with real workers it is tested from Python.

#![cfg(unix)]

use crate::common::Folder;
use crate::interrupt::signal;
use std::fs;
use std::io::Read;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// What runs in place of Python: it says how far it is without a pause, and fails when it is begun a second time.
const PROGRAM: &str = "#!/bin/sh\nif [ -e begun ]; then echo 'no more' >&2; exit 1; fi\n: > begun\nwhile :; do echo 0.1; sleep 0.01; done\n";

#[test]
fn an_interrupt_ends_a_program_that_never_pauses() {
    let folder = Folder::new();
    let program = folder.path("program");
    // Written by another process: one that is forked meanwhile would keep it open, and it could not be run.
    fs::write(folder.path("program.txt"), PROGRAM).unwrap();
    let mut writer = Command::new("sh");
    writer.args(["-c", "cat program.txt > program && chmod +x program"]).current_dir(folder.path(""));
    assert!(writer.status().unwrap().success());
    let address = "tcp://127.0.0.1:1";
    let arguments =
        ["render", "room.vox", "-o", "a.png", "--size", "16x12", "--spp", "9", "--cluster", address, "--quiet"];
    let mut command = folder.command(&arguments);
    let mut child = command.env("VOXTRACE_PYTHON", &program).stderr(Stdio::piped()).spawn().unwrap();
    let start = Instant::now();
    while !folder.exists("begun") {
        if start.elapsed() > Duration::from_secs(300) {
            child.kill().unwrap();
            panic!("it was not begun");
        }
        sleep(Duration::from_millis(10));
    }
    sleep(Duration::from_millis(300));
    signal(&child, "-INT");
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().unwrap() {
            break status;
        }
        if start.elapsed() > Duration::from_secs(300) {
            child.kill().unwrap();
            panic!("it goes on");
        }
        sleep(Duration::from_millis(10));
    };
    let mut said = String::new();
    child.stderr.take().unwrap().read_to_string(&mut said).unwrap();
    // The first sample of each pixel was asked for then.
    assert!(status.code() == Some(1) && said.contains("no more"), "{status}: {said}");
}
