//! `voxtrace bench --against PROGRAM`: two programs measured in turns, from arguments to the table.

use crate::common::{Folder, stderr};
use serde_json::Value;

/// A benchmark of few small frames in three rounds.
const SMALL: [&str; 12] =
    ["bench", "room.vxt", "--cells", "cpu", "--size", "48x32", "--frames", "90", "--warm-up", "1", "--rounds", "3"];

/// The only cell's times are those in the files of three rounds, A's and B's, and its ratio lies among theirs, whatever else the machine does.
fn is_of_its_files(folder: &Folder, json: &Value) {
    let cell = &json["cells"][0];
    let median = |round: usize, side: char| {
        let file = folder.bytes(&format!("out/round-{round}-{side}/results.json"));
        serde_json::from_slice::<Value>(&file).unwrap()["cells"][0]["ms"]["median"].as_f64().unwrap()
    };
    let rounds = [1, 2, 3].map(|round| [median(round, 'a'), median(round, 'b')]);
    assert_eq!(cell["median_ms"], serde_json::json!(rounds), "{json}");
    let ratios = rounds.map(|[a, b]| b / a);
    let [low, high] = [f64::min, f64::max].map(|least| ratios.into_iter().reduce(least).unwrap());
    let ratio = cell["ratio"].as_f64().unwrap();
    assert!(ratio > low * (1.0 - 1e-9) && ratio < high * (1.0 + 1e-9), "{ratio} of {ratios:?}: {json}");
}

/// Benchmarks of which one has to have such a ratio: what meets one program and not the other, on a machine that is never quiet, does not do so each time.
const ATTEMPTS: usize = 10;

#[test]
fn a_program_against_itself_has_the_times_of_its_files_and_says_of_each_round_how_quiet_it_was() {
    let folder = Folder::new();
    let this = env!("CARGO_BIN_EXE_voxtrace");
    let measure = || {
        let json = folder.succeed(&[&SMALL[..], &["--against", this, "--json", "-o", "out"]].concat());
        let json: Value = serde_json::from_str(&json).unwrap();
        is_of_its_files(&folder, &json);
        json
    };
    // The planted program below takes ten times as long.
    let is_as_long = |json: &Value| (0.33..3.0).contains(&json["cells"][0]["ratio"].as_f64().unwrap());
    let json = (1..ATTEMPTS).map(|_| measure()).find(is_as_long).unwrap_or_else(measure);
    assert!(is_as_long(&json), "{json}");
    assert_eq!((&json["rounds"], json["cells"].as_array().map(Vec::len)), (&3.into(), Some(1)), "{json}");
    let cell = &json["cells"][0];
    assert!(cell["ratio_95"].is_array(), "{json}");
    assert!(cell["quiet_rounds"].as_u64().is_some_and(|quiet| quiet <= 3));
    for round in ["round-1-a", "round-2-b", "round-3-a"] {
        let results: Value = serde_json::from_slice(&folder.bytes(&format!("out/{round}/results.json"))).unwrap();
        assert_eq!((&results["complete"], &results["settings"]["frames"]), (&true.into(), &30.into()), "{results}");
    }
    // The folder is ours: the next benchmark may have it.
    let text = folder.succeed(&[&SMALL[..], &["--against", this, "-o", "out"]].concat());
    assert!(text.contains("3 rounds in turns") && text.contains("B / A"), "{text}");
}

#[cfg(unix)]
#[test]
fn a_program_that_takes_ten_times_as_long_is_seen() {
    let folder = Folder::new();
    folder.succeed(&[&SMALL[..10], &["-o", "once"]].concat());
    let mut results: Value = serde_json::from_slice(&folder.bytes("once/results.json")).unwrap();
    let ms = &mut results["cells"][0]["ms"];
    // Rounded as files have it: ten times 0.368 are 3.6799999999999997.
    ms["median"] = ((ms["median"].as_f64().unwrap() * 1e4).round() / 1e3).into();
    results["cells"][0]["disturbance"] = Value::Null;
    std::fs::write(folder.path("slow.json"), results.to_string()).unwrap();
    let script = "#!/bin/sh\nif [ \"$1\" = --version ]; then echo voxtrace 0; exit; fi\n\
        while [ $# -gt 0 ]; do if [ \"$1\" = -o ]; then out=$2; fi; shift; done\n\
        mkdir -p \"$out\" && cp slow.json \"$out/results.json\"\n";
    // Written by another process: one that is forked meanwhile would keep it open, and it could not be run.
    std::fs::write(folder.path("slow.txt"), script).unwrap();
    let mut writer = std::process::Command::new("sh");
    writer.args(["-c", "cat slow.txt > slow && chmod +x slow"]).current_dir(folder.path(""));
    assert!(writer.status().unwrap().success());
    let measure = || {
        let json = folder.succeed(&[&SMALL[..], &["--against", "./slow", "--json", "-o", "out"]].concat());
        let json: Value = serde_json::from_str(&json).unwrap();
        is_of_its_files(&folder, &json);
        for round in 0..3 {
            assert_eq!(json["cells"][0]["median_ms"][round][1], results["cells"][0]["ms"]["median"], "{json}");
        }
        json
    };
    let is_seen = |json: &Value| {
        let cell = &json["cells"][0];
        (3.0..30.0).contains(&cell["ratio"].as_f64().unwrap())
            && ["B is slower", "no verdict"].contains(&cell["outcome"].as_str().unwrap())
    };
    let json = (1..ATTEMPTS).map(|_| measure()).find(is_seen).unwrap_or_else(measure);
    assert!(is_seen(&json), "{json}");
}

#[test]
fn what_cannot_measure_is_told_in_one_line_before_anything_is_measured() {
    let folder = Folder::new();
    let line = folder.fail(&[&SMALL[..], &["--against", "./nowhere"]].concat(), 3);
    assert!(line.contains("nowhere cannot be run") && line.contains("hint: --against names a program"), "{line}");
    assert!(!folder.exists("voxtrace-bench"));
    for wrong in [&["--resume"][..], &["--sweep", "500k"], &["--rounds", "2"]] {
        let this = env!("CARGO_BIN_EXE_voxtrace");
        folder.fail(&[&["bench", "room.vxt", "--against", this], wrong].concat(), 2);
    }
    let output = folder.run(&["bench", "room.vxt", "--rounds", "4"]);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    let this = env!("CARGO_BIN_EXE_voxtrace");
    let line = folder.fail(&["bench", "room.vxt", "--cells", "gpu", "--against", this], 2);
    assert!(line.contains("gpu") && !line.contains("did not measure"), "{line}");
}
