//! The page's scripts, in Node where the machine has it. In a browser they are tested in `web/test`.

use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use std::process::Command;

/// Runs a test of `tests/page` on a copy of the page.
fn run(test: &str) {
    let (source, folder) = (Path::new(env!("CARGO_MANIFEST_DIR")), tempfile::tempdir().unwrap());
    for entry in fs::read_dir(source.join("page")).unwrap() {
        let entry = entry.unwrap();
        fs::copy(entry.path(), folder.path().join(entry.file_name())).unwrap();
    }
    // Pages say that a script is a module, packages do here.
    fs::write(folder.path().join("package.json"), r#"{ "type": "module" }"#).unwrap();
    let output = match Command::new("node").arg(source.join("tests/page").join(test)).arg(folder.path()).output() {
        Err(error) if error.kind() == ErrorKind::NotFound => return eprintln!("{test} is left out: there is no Node"),
        output => output.unwrap(),
    };
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn files_of_two_drops_are_asked_about_one_after_the_other() {
    run("uploads.mjs");
}

#[test]
fn a_picture_that_is_read_late_is_not_shown_over_a_newer_one() {
    run("pictures.mjs");
}
