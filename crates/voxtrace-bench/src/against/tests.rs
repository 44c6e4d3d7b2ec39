//! Programs that write reports which are known beforehand: planted differences are seen, and what is no voxtrace of this version is refused.

use super::*;
use crate::compare::tests::report;
use std::io::Write;

struct Silent;
impl Monitor for Silent {}

/// A program that answers as voxtrace does, and for a benchmark does what `body` says: `$out` is the folder, `$round` counts its runs.
fn program(folder: &Path, name: &str, body: &str) -> PathBuf {
    let path = folder.join(name);
    let text = format!(
        "#!/bin/sh\nif [ \"$1\" = --version ]; then echo voxtrace 9.9; exit; fi\necho \"$@\" >> \"$0.calls\"\n\
         while [ $# -gt 0 ]; do if [ \"$1\" = -o ]; then out=$2; fi; shift; done\n\
         mkdir -p \"$out\"; round=$(wc -l < \"$0.calls\")\n{body}\n"
    );
    // Written by another process: one that is forked meanwhile would keep it open, and it could not be run.
    let mut writer = Command::new("sh");
    writer.args(["-c", "cat > \"$0\" && chmod +x \"$0\""]).arg(&path).stdin(Stdio::piped());
    let mut child = writer.spawn().unwrap();
    child.stdin.take().unwrap().write_all(text.as_bytes()).unwrap();
    assert!(child.wait().unwrap().success());
    path
}

/// A program whose first cell takes so many milliseconds, more in every further round.
fn measuring(folder: &Path, name: &str, ms: f64) -> PathBuf {
    for round in 1..=4 {
        let text = report([ms * (1.0 + 0.2 * f64::from(round)), 20.0]).to_string();
        std::fs::write(folder.join(format!("{name}.{round}.json")), text).unwrap();
    }
    program(folder, name, "cp \"$0.$round.json\" \"$out/results.json\"")
}

fn against(folder: &Path, programs: [PathBuf; 2]) -> Result<Duel, AgainstError> {
    let words = [vec!["bench".into()], vec!["city".into()]];
    let output = folder.join("out");
    let against = Against { programs, rounds: 4, words, output, frames: 7, limit_ms: 800, has_size: false };
    against.run(&Request::default(), &mut Silent)
}

#[test]
fn a_program_against_itself_is_equal_and_a_slower_one_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    for (ms, ratio, outcome) in
        [(10.0, 1.0, "equal within noise"), (12.0, 1.2, "B is slower"), (8.0, 0.8, "B is faster")]
    {
        let programs = [measuring(folder, "a", 10.0), measuring(folder, "b", ms)];
        let json = against(folder, programs).unwrap().json();
        let cell = &json["cells"][0];
        assert_eq!(
            (&cell["outcome"], &json["rounds"], &cell["quiet_rounds"]),
            (&outcome.into(), &4.into(), &4.into()),
            "{json}"
        );
        assert!((cell["ratio"].as_f64().unwrap() - ratio).abs() < 1e-9, "{json}");
        let text = std::fs::read_to_string(folder.join("out/against.json")).unwrap();
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap()["summary"], json["summary"]);
        ["a.calls", "b.calls"].iter().for_each(|name| std::fs::remove_file(folder.join(name)).unwrap());
    }
}

#[test]
fn both_are_told_the_same_in_turns_and_the_size_that_the_first_one_chose() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    against(folder, [measuring(folder, "a", 10.0), measuring(folder, "b", 10.0)]).unwrap();
    let calls =
        |name: &str| std::fs::read_to_string(folder.join(name)).unwrap().replace(&folder.display().to_string(), "");
    let (a, b) = (calls("a.calls"), calls("b.calls"));
    let told = |round: u32, side: &str, size: &str| {
        format!("bench -o /out/round-{round}-{side} --quiet --sweep none --frames 7 --time-limit 800ms {size}city")
    };
    let size = "--size 10x10 ";
    assert_eq!(a.lines().next(), Some(told(1, "a", "").as_str()));
    assert_eq!(a.lines().nth(3), Some(told(4, "a", size).as_str()));
    assert_eq!(b.lines().collect::<Vec<_>>(), (1..=4).map(|round| told(round, "b", size)).collect::<Vec<_>>());
}

#[test]
fn what_is_no_voxtrace_of_this_version_is_refused_by_name_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let refused = |b: PathBuf| {
        let error = against(folder, [measuring(folder, "a", 10.0), b]).map(|duel| duel.text()).unwrap_err().to_string();
        let _ = std::fs::remove_file(folder.join("a.calls"));
        assert_eq!(error.lines().count(), 1, "{error}");
        error
    };
    let older = program(folder, "older", "echo 'error: unexpected argument --sweep found' >&2; exit 2");
    assert!(refused(older).ends_with("older did not measure: unexpected argument --sweep found"));
    let silent = program(folder, "silent", "exit 3");
    assert!(refused(silent).contains("silent did not measure: it ended with exit status: 3"));
    let idle = program(folder, "idle", "true");
    assert!(refused(idle).contains("idle wrote no results that can be read"));
    let schema = program(folder, "schema", "echo '{\"schema\": 1, \"cells\": []}' > \"$out/results.json\"");
    assert!(refused(schema).contains("schema 1, but 2 can be read"));
    let other = program(folder, "other", "echo '{\"schema\": 2}' > \"$out/results.json\"");
    assert!(refused(other).contains("this is no report"));
    let noise = program(folder, "noise", "echo noise > \"$out/results.json\"");
    assert!(refused(noise).contains("noise wrote no results that can be read"));
    assert!(refused(folder.join("nowhere")).contains("nowhere cannot be run: no such file or directory"));
    assert!(refused("/bin/echo".into()).contains("/bin/echo is no voxtrace: asked for its version, it"));
    assert!(!folder.join("a.calls").exists());
}

#[test]
fn interrupted_work_ends_with_the_rounds_that_are_whole_and_leaves_no_child() {
    struct Impatient(std::sync::atomic::AtomicU32);
    impl Monitor for Impatient {
        fn update(&mut self, done: u64) {
            self.0.store(done as u32, std::sync::atomic::Ordering::SeqCst);
        }

        fn is_interrupted(&self) -> bool {
            self.0.load(std::sync::atomic::Ordering::SeqCst) >= 3
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    let programs = [measuring(folder, "a", 10.0), measuring(folder, "b", 10.0)];
    let words = [vec!["bench".into()], Vec::new()];
    let output = folder.join("out");
    let against = Against { programs, rounds: 4, words, output, frames: 7, limit_ms: 800, has_size: true };
    let duel = against.run(&Request::default(), &mut Impatient(0.into())).unwrap();
    assert_eq!(
        (&duel.json()["rounds"], &duel.json()["cells"][0]["outcome"]),
        (&1.into(), &"too few frames to tell".into())
    );
}
