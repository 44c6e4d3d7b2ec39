//! Tells the program the commit that it is built from, for reports of `bench`: VOXTRACE_COMMIT where it is set, else what git or the packed crate
//! says; nothing where nobody knows.

use std::path::Path;
use std::process::Command;

fn main() {
    println!("cargo:rerun-if-env-changed=VOXTRACE_COMMIT");
    println!("cargo:rerun-if-changed=build.rs");
    if std::env::var_os("VOXTRACE_COMMIT").is_some() {
        return;
    }
    if let Some(commit) = packed().or_else(of_git) {
        println!("cargo:rustc-env=VOXTRACE_COMMIT={commit}");
    }
}

/// What `cargo package` wrote into the crate.
fn packed() -> Option<String> {
    let text = std::fs::read_to_string(".cargo_vcs_info.json").ok()?;
    let at = text.split("\"sha1\"").nth(1)?.split('"').nth(1)?;
    Some(at.chars().take(12).collect())
}

/// The commit that is checked out.
fn of_git() -> Option<String> {
    let git = |arguments: &[&str]| {
        let output = Command::new("git").args(arguments).output().ok().filter(|output| output.status.success())?;
        Some(String::from_utf8(output.stdout).ok()?.trim().to_owned())
    };
    // Each commit and each checkout adds a line here.
    let log = git(&["rev-parse", "--git-path", "logs/HEAD"]).filter(|path| Path::new(path).exists());
    if let Some(log) = log {
        println!("cargo:rerun-if-changed={log}");
    }
    git(&["rev-parse", "--short=12", "HEAD"])
}
