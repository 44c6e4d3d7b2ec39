//! Planted differences are found, and nothing else is.

use super::*;

/// A report of two cells with these medians, each known to half a percent.
pub(crate) fn report(medians: [f64; 2]) -> Value {
    let cell = |name: &str, median: f64| {
        json!({
            "scene": "city", "scene_index": 0, "cell": name, "shaders": "fast", "clock": "gpu", "failure": null,
            "interrupted": false, "stable": true, "lost": 0,
            "ms": { "median": median, "median_95": [median * 0.995, median * 1.005] },
            "bytes_per_voxel": { "total": 1.5 },
            "conformance": { "wrong": 1, "invented": 2, "missed": 3 },
        })
    };
    json!({
        "schema": 2, "voxtrace": "1", "complete": true, "device": { "name": "GPU", "driver": "7" },
        "settings": { "width": 10, "height": 10, "max_bounces": 3, "integrator": "essay", "seed": 1 },
        "scenes": [{ "name": "city", "content_hash": "abc" }],
        "cells": [cell("walk", medians[0]), cell("cpu", medians[1])],
    })
}

fn outcomes(a: &Value, b: &Value) -> Vec<Outcome> {
    Comparison::of(a, b).pairs.iter().map(|pair| pair.outcome).collect()
}

#[test]
fn planted_differences_are_found_and_noise_is_not() {
    let a = report([10.0, 20.0]);
    assert_eq!(outcomes(&a, &a), [Outcome::Equal, Outcome::Equal]);
    // 1.9 % is within the band although the intervals do not meet.
    assert_eq!(outcomes(&a, &report([10.19, 19.62])), [Outcome::Equal, Outcome::Equal]);
    assert_eq!(outcomes(&a, &report([10.5, 19.0])), [Outcome::Slower, Outcome::Faster]);
    let comparison = Comparison::of(&a, &report([10.5, 19.0]));
    let pair = &comparison.pairs[0];
    assert_eq!((pair.ratio, pair.wrong), (Some(1.05), [Some(6), Some(6)]));
    let [low, high] = pair.interval.unwrap();
    assert!(low > 1.03 && low < 1.05 && high > 1.05 && high < 1.07, "{low} {high}");
    assert_eq!(comparison.summary(), "Of 2 cells: 1 B is faster, 1 B is slower.");
}

#[test]
fn a_wide_interval_makes_a_difference_noise_and_few_frames_make_it_unknown() {
    let (a, mut b) = (report([10.0, 20.0]), report([11.0, 22.0]));
    b["cells"][0]["ms"]["median_95"] = json!([9.0, 13.0]);
    b["cells"][1]["ms"]["median_95"] = Value::Null;
    assert_eq!(outcomes(&a, &b), [Outcome::Equal, Outcome::Unknown]);
}

#[test]
fn where_the_machine_was_not_quiet_there_is_no_verdict_and_the_reason_is_said() {
    let (a, mut b) = (report([10.0, 20.0]), report([4.7, 20.0]));
    b["cells"][0]["disturbance"] = "threads waited 41 % of the time for a processor".into();
    let comparison = Comparison::of(&a, &b);
    assert_eq!(outcomes(&a, &b), [Outcome::Disturbed, Outcome::Equal]);
    assert_eq!(outcomes(&b, &a), [Outcome::Disturbed, Outcome::Equal]);
    let ratio = comparison.pairs[0].ratio.unwrap();
    assert!((ratio - 0.47).abs() < 1e-9, "what was measured is shown: {ratio}");
    assert_eq!(comparison.summary(), "Of 2 cells: 1 equal within noise, 1 no verdict.");
    let why = "no verdict: the machine was not quiet (B: threads waited 41 % of the time for a processor)";
    assert!(comparison.text().contains(why) && comparison.text().ends_with(ADVICE));
    assert!(!Comparison::of(&a, &a).text().contains("quiet"));
    b["cells"][0]["disturbance"] = Value::Null;
    assert_eq!(outcomes(&a, &b), [Outcome::Faster, Outcome::Equal]);
}

#[test]
fn other_scenes_settings_and_what_is_not_proved_are_not_compared() {
    let a = report([10.0, 20.0]);
    let spoiled = |spoil: &dyn Fn(&mut Value)| {
        let mut b = report([20.0, 20.0]);
        spoil(&mut b);
        let pairs = Comparison::of(&a, &b).pairs;
        assert_eq!(pairs[0].outcome, Outcome::Incomparable);
        assert_eq!((pairs[0].ratio, pairs[0].interval), (None, None));
        pairs[0].why.clone().unwrap()
    };
    assert!(spoiled(&|b| b["scenes"][0]["content_hash"] = "abd".into()).contains("other scenes"));
    assert!(spoiled(&|b| b["settings"]["width"] = 11.into()).contains("width (10, 11)"));
    let other = spoiled(&|b| b["settings"]["integrator"] = "path".into());
    assert!(other.contains("integrator (\"essay\", \"path\")"), "{other}");
    assert!(spoiled(&|b| b["cells"][0]["shaders"] = "precise".into()).contains("shaders"));
    assert!(spoiled(&|b| b["cells"][0]["failure"] = "device lost".into()).contains("device lost"));
    assert!(spoiled(&|b| b["cells"][0]["stable"] = false.into()).contains("not stable"));
    assert!(spoiled(&|b| b["cells"][0]["interrupted"] = true.into()).contains("to its end"));
}

#[test]
fn what_is_in_one_report_alone_is_named() {
    let (a, mut b) = (report([10.0, 20.0]), report([10.0, 20.0]));
    b["cells"][1]["cell"] = "query:brick".into();
    let comparison = Comparison::of(&a, &b);
    assert_eq!(comparison.alone, ["only in A: city cpu", "only in B: city query:brick"]);
    assert!(comparison.text().contains("only in B: city query:brick"));
    b["cells"] = json!([]);
    assert!(Comparison::of(&a, &b).summary().contains("no cell in common"));
}

#[test]
fn builds_of_one_version_are_told_apart_by_their_commits() {
    let mut a = report([10.0, 20.0]);
    assert!(name(&a).ends_with("voxtrace 1"), "{}", name(&a));
    a["runs"] = json!([{ "commit": "000" }, { "commit": "0123456789abcdef" }]);
    assert!(name(&a).ends_with("voxtrace 1 (0123456789)"), "{}", name(&a));
}
