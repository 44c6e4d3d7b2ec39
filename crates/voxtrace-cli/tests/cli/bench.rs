//! `voxtrace bench`: the numbers of the report are those of the frames, and a frame that is missing is noticed.

use crate::common::{Folder, stderr};
use serde_json::Value;
use voxtrace_test_support::{Need, skip, skip_without};

/// A benchmark of few small frames, into the folder `report`.
pub const SMALL: [&str; 8] = ["--size", "32x24", "--frames", "9", "--warm-up", "1", "-o", "report"];

/// Frames, and their mean, median and rays, recomputed from a CSV; an error where a frame is missing or was not proved.
fn recompute(csv: &str, cell: &Value) -> Result<(), String> {
    let mut lines = csv.lines();
    assert_eq!(lines.next(), Some("frame,gpu_ms,wall_ms,rays,sequence"));
    let is_gpu = cell["clock"] == "gpu";
    let (mut ms, mut rays, mut last) = (Vec::new(), 0.0, None);
    for (expected, line) in lines.enumerate() {
        let fields: Vec<&str> = line.split(',').collect();
        if fields[0].parse() != Ok(expected) {
            return Err(format!("frame {expected} is missing"));
        }
        let sequence: u32 = fields[4].parse().map_err(|_| "no sequence number".to_owned())?;
        if last.is_some_and(|last| sequence <= last) {
            return Err(format!("frame {expected} did not run"));
        }
        last = Some(sequence);
        ms.push(fields[if is_gpu { 1 } else { 2 }].parse::<f64>().unwrap());
        rays += fields[3].parse().unwrap_or(0.0);
    }
    let count = ms.len();
    if cell["frames"] != count {
        return Err(format!("{count} frames, but {} in the results", cell["frames"]));
    }
    ms.sort_by(f64::total_cmp);
    let mean = ms.iter().sum::<f64>() / count as f64;
    let pairs = [("mean", mean), ("median", (ms[(count - 1) / 2] + ms[count / 2]) / 2.0), ("fps", 1000.0 / mean)];
    let pairs = pairs.into_iter().chain(is_gpu.then_some(("rays_per_frame", rays / count as f64)));
    for (name, ours) in pairs {
        let theirs = cell["ms"][name].as_f64().ok_or(format!("no {name}"))?;
        if (theirs - ours).abs() > 1e-9 * ours.abs() {
            return Err(format!("{name} is {theirs}, recomputed {ours}"));
        }
    }
    Ok(())
}

/// Runs the benchmark and checks all that it wrote; returns the results and the CSV of the first cell.
pub fn run(folder: &Folder, options: &[&str]) -> (Value, String) {
    folder.succeed(&[&["bench", "room.vxt"], &SMALL[..], options].concat());
    let text = |name: &str| String::from_utf8(folder.bytes(&format!("report/{name}"))).unwrap();
    let results: Value = serde_json::from_str(&text("results.json")).unwrap();
    assert_eq!((&results["schema"], &results["complete"]), (&2.into(), &true.into()));
    let report = text("report.md");
    for part in ["## All cells", "Table 1", "Table 2", "Table 3", "## Verdict"] {
        assert!(report.contains(part), "{part}: {report}");
    }
    check_page(&text("report.html"), &results);
    let cells = results["cells"].as_array().unwrap();
    for cell in cells {
        assert_eq!((&cell["failure"], &cell["lost"], &cell["frames"]), (&Value::Null, &0.into(), &9.into()), "{cell}");
        assert_eq!(recompute(&text(cell["csv"].as_str().unwrap()), cell), Ok(()));
    }
    let first = text(cells[0]["csv"].as_str().unwrap());
    (results, first)
}

/// The page answers first, needs no other file and no script, and has the study's tables and figures.
fn check_page(page: &str, results: &Value) {
    let answer = results["verdict"]["sentence"].as_str().unwrap();
    let at = page.find(answer).unwrap_or_else(|| panic!("no {answer:?}"));
    assert!(at < page.find("<h2>").unwrap());
    for part in [
        "Table 1",
        "Table 2",
        "Table 3",
        "Figure 7",
        "Figure 8",
        "<svg class=\"plot\"",
        "data:image/png;base64,iVBOR",
        "data:image/jpeg;base64,/9j/",
    ] {
        assert!(page.contains(part), "{part}");
    }
    assert!(!page.contains("<script") && !page.contains("<link") && !page.contains("url("));
    let outside = page.replace("http://www.w3.org/2000/svg", "");
    assert!(!outside.contains("http://") && !outside.contains("https://"));
    assert!(page.len() < 1 << 20);
    for tag in ["div", "table", "tr", "td", "figure", "section", "ul", "li", "svg", "g", "p", "main"] {
        let opened = page.matches(&format!("<{tag}>")).count() + page.matches(&format!("<{tag} ")).count();
        assert_eq!(opened, page.matches(&format!("</{tag}>")).count(), "{tag}");
    }
}

#[test]
fn the_numbers_of_a_report_are_those_of_its_frames_and_a_skipped_frame_is_noticed() {
    let folder = Folder::new();
    let (results, csv) = run(&folder, &["--cells", "cpu"]);
    let cell = &results["cells"][0];
    assert!(cell["bytes_per_voxel"]["total"].as_f64() > Some(0.0));
    // A camera ray for each pixel, and bounces; each of them by a walk that is named.
    let rays = cell["ms"]["rays_per_frame"].as_f64().unwrap();
    assert!((768.0..768.0 * 4.0).contains(&rays) && cell["primary_ms"]["rays_per_frame"] == 768.0, "{cell}");
    let walks = ["packets", "streams", "scalar", "in_media"].map(|walk| cell["walk"][walk].as_u64().unwrap());
    assert_eq!(walks.iter().sum::<u64>(), (rays * 9.0).round() as u64, "{cell}");
    // Of the rays and the time beyond camera rays, unless something disturbed those and they took as long.
    let beyond = cell["ms"]["median"].as_f64().unwrap() - cell["primary_ms"]["median"].as_f64().unwrap();
    let of_bounces = cell["grays_per_second"]["bounce"].as_f64();
    assert_eq!(of_bounces.is_some(), beyond > 0.0, "{cell}");
    assert!(of_bounces.is_none_or(|speed| (speed * beyond * 1e6 / (rays - 768.0) - 1.0).abs() < 1e-6), "{cell}");
    assert_eq!(cell["processor"]["turns"], 1);
    let run = &results["runs"][0];
    assert!(run["command"].as_str().is_some_and(|command| command.starts_with("voxtrace bench room.vxt --size 32x24")));
    assert!(run["date"].as_str().is_some_and(|date| date.len() == 20 && date.ends_with('Z')), "{run}");

    // Planted: a frame left out, a frame that was not rendered, a time that is another.
    let lines: Vec<&str> = csv.lines().collect();
    let skipped = [&lines[..4], &lines[5..]].concat().join("\n");
    assert_eq!(recompute(&skipped, cell), Err("frame 3 is missing".into()));
    assert!(recompute(&lines[..9].join("\n"), cell).is_err_and(|error| error.starts_with("8 frames")));
    let (same, before) = (lines[4].rsplit_once(',').unwrap().0, lines[3].rsplit_once(',').unwrap().1);
    let stale = [&lines[..4], &[&format!("{same},{before}")], &lines[5..]].concat().join("\n");
    assert_eq!(recompute(&stale, cell), Err("frame 3 did not run".into()));
    let mut fields: Vec<&str> = lines[5].split(',').collect();
    fields[2] = "1e6";
    let slower = fields.join(",");
    let slower = [&lines[..5], &[&slower], &lines[6..]].concat().join("\n");
    assert!(recompute(&slower, cell).is_err_and(|error| error.starts_with("mean")));
}

#[test]
fn a_device_is_measured_with_its_clock_rays_and_memory() {
    let folder = Folder::new();
    let devices: Value = serde_json::from_str(&folder.succeed(&["devices", "--json"])).unwrap();
    if devices["devices"].as_array().unwrap().len() < 2 {
        skip_without(Need::Vulkan, "no Vulkan device");
        return;
    }
    let (results, csv) = run(&folder, &["--device", "0"]);
    let cells = results["cells"].as_array().unwrap();
    assert_eq!(cells.len(), 2);
    for cell in cells {
        assert!(cell["ms"]["rays_per_frame"].as_f64() >= Some(32.0 * 24.0), "{cell}");
        assert_eq!(cell["primary_ms"]["rays_per_frame"], 32.0 * 24.0);
        for name in ["acceleration_structures", "records", "scene"] {
            assert!(cell["bytes_per_voxel"][name].as_f64() > Some(0.0), "{name}");
        }
        assert_eq!(cell["shaders"], "fast");
    }
    assert_eq!(cells[0]["times_voxel_exact"], 1.0);
    let probes = results["doctor"]["probes"].as_array().unwrap();
    assert!(probes.iter().any(|probe| probe["id"] == "P13"));
    assert!(
        String::from_utf8(folder.bytes("report/report.html")).unwrap().contains("What the driver promises, probed")
    );
    assert!(csv.lines().nth(1).unwrap().split(',').all(|field| !field.is_empty()), "{csv}");

    // By path a frame also has rays towards lights, a run of camera rays has none.
    let [essay, path] = ["essay", "path"].map(|integrator| {
        std::fs::remove_dir_all(folder.path("report")).unwrap();
        let options = ["--device", "0", "--integrator", integrator, "--max-bounces", "1", "--cells", "walk"];
        let (results, _) = run(&folder, &options);
        assert_eq!(results["cells"][0]["primary_ms"]["rays_per_frame"], 32.0 * 24.0);
        results["cells"][0]["ms"]["rays_per_frame"].as_f64().unwrap()
    });
    assert!(path > 1.05 * essay && essay > 1.05 * 32.0 * 24.0, "{path} {essay}");
}

#[test]
fn a_cell_that_fails_is_a_row_with_the_reason_and_the_others_still_run() {
    let folder = Folder::new();
    let arguments = [&["bench", "room.vxt"], &SMALL[..], &["--cells", "pipeline,cpu"]].concat();
    let mut command = folder.command(&arguments);
    let output = command.env("VK_DRIVER_FILES", "/nowhere").env("VK_ICD_FILENAMES", "/nowhere").output().unwrap();
    assert!(output.status.success(), "{}", stderr(&output));
    let results: Value = serde_json::from_slice(&folder.bytes("report/results.json")).unwrap();
    assert!(results["cells"][0]["failure"].as_str().unwrap().starts_with("not supported"), "{results}");
    assert_eq!(results["cells"][1]["frames"], 9);
    assert!(folder.fail(&["bench", "room.vxt", "--cells", "gpu"], 2).contains("is no traversal"));
}

#[cfg(unix)]
#[test]
fn an_interrupted_benchmark_writes_the_frames_that_it_has_and_exits_with_130() {
    let folder = Folder::new();
    let options = ["bench", "room.vxt", "room.vox", "--cells", "cpu", "--size", "32x24", "--frames", "1000000"];
    let (mut child, mut lines) = folder.watch(&[&options[..], &["-o", "report", "--progress", "json"]].concat());
    let is_under_way = |line: &String| {
        let event: Value = serde_json::from_str(line).unwrap();
        event["event"] == "progress" && event["done"].as_u64() > Some(0)
    };
    lines.by_ref().find(is_under_way).expect("the benchmark ended before it began");
    let killed = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(killed.success());
    let last = lines.last().unwrap();
    assert_eq!(child.wait().unwrap().code(), Some(130), "{last}");
    assert!(last.starts_with("error: interrupted"), "{last}");
    let results: Value = serde_json::from_slice(&folder.bytes("report/results.json")).unwrap();
    let cells = results["cells"].as_array().unwrap();
    assert_eq!((&results["complete"], cells.len()), (&false.into(), 1));
    let cell = &cells[0];
    assert!(cell["interrupted"] == true && cell["frames"].as_u64() > Some(0), "{cell}");
    let csv = String::from_utf8(folder.bytes(&format!("report/{}", cell["csv"].as_str().unwrap()))).unwrap();
    assert_eq!(recompute(&csv, cell), Ok(()));
    assert!(String::from_utf8(folder.bytes("report/report.md")).unwrap().contains("Not complete"));
}

#[cfg(unix)]
#[test]
fn a_killed_benchmark_goes_on_with_the_cells_that_are_missing() {
    let folder = Folder::new();
    let options = [
        "bench",
        "room.vxt",
        "room.vox",
        "--cells",
        "cpu",
        "--size",
        "32x24",
        "--warm-up",
        "1",
        "--time-limit",
        "10s",
        "-o",
        "report",
    ];
    let with = |frames: &str, more: &[&'static str]| [&options[..], &["--frames", frames], more].concat().join(" ");
    let split = |line: &str| line.split(' ').map(str::to_owned).collect::<Vec<_>>();
    // Killed outright in the second cell, whose time limit is far away.
    let long = with("200000", &["--progress", "json", "--resume"]);
    let (mut child, mut lines) = folder.watch(&split(&long));
    let is_second = |line: &String| {
        let event: Value = serde_json::from_str(line).unwrap();
        event["event"] == "progress"
            && event["work"].as_str().unwrap().starts_with("2/2")
            && event["done"].as_u64() > Some(0)
    };
    lines.by_ref().find(is_second).expect("the benchmark ended before its second cell");
    child.kill().unwrap();
    child.wait().unwrap();
    let read = || -> Value { serde_json::from_slice(&folder.bytes("report/results.json")).unwrap() };
    let before = read();
    assert_eq!((&before["complete"], before["cells"].as_array().unwrap().len()), (&false.into(), 1));
    let csv = folder.bytes("report/1-room-cpu.csv");

    // Another plan is refused, and named.
    let refused = folder.fail(&split(&with("9", &["--resume"])), 5);
    assert!(refused.contains("frames (200000, now 9)"), "{refused}");
    let other = folder.fail(&split(&with("200000", &["--resume", "--max-bounces", "2"])), 5);
    assert!(other.contains("max_bounces (3, now 2)"), "{other}");
    // Another integrator is other work, although all else is the same.
    let other = folder.fail(&split(&with("200000", &["--resume", "--integrator", "path", "--max-bounces", "3"])), 5);
    assert!(other.contains("integrator (\"essay\", now \"path\") differ"), "{other}");
    assert_eq!(read(), before);

    // What was measured stays as it is, to the bit; the other cell is interrupted, which does not count as measured.
    let (mut child, mut lines) = folder.watch(&split(&long));
    lines.by_ref().find(is_second).expect("the second cell is measured");
    std::process::Command::new("kill").args(["-TERM", &child.id().to_string()]).status().unwrap();
    lines.for_each(drop);
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let after = read();
    assert_eq!(after["cells"][0], before["cells"][0]);
    assert_eq!((&after["complete"], &after["cells"][1]["interrupted"]), (&false.into(), &true.into()));
    assert_eq!(folder.bytes("report/1-room-cpu.csv"), csv);

    // A scene that changed is refused.
    let mut scene = crate::common::room();
    std::sync::Arc::make_mut(&mut scene.grids[0]).set(voxtrace::glam::IVec3::new(3, 3, 9), 1);
    voxtrace::export::vox::write(&folder.path("room.vox"), &scene).unwrap();
    let changed = folder.fail(&split(&with("200000", &["--resume"])), 5);
    assert!(changed.contains("another scene"), "{changed}");
}

#[test]
fn a_finished_benchmark_is_not_measured_again_and_damage_is_noticed() {
    let folder = Folder::new();
    run(&folder, &["--cells", "cpu"]);
    let csv = folder.bytes("report/1-room-cpu.csv");
    std::fs::remove_file(folder.path("report/report.md")).unwrap();
    let (results, _) = run(&folder, &["--cells", "cpu", "--resume"]);
    assert_eq!(results["complete"], true);
    assert_eq!(folder.bytes("report/1-room-cpu.csv"), csv);
    // With other threads it is another machine, as far as times of the CPU go.
    let threads = results["host"]["threads"].as_u64().unwrap();
    let other = (threads % 1024 + 1).to_string();
    let more = ["--cells", "cpu", "--resume", "--threads", &other];
    let refused = folder.fail(&[&["bench", "room.vxt"], &SMALL[..], &more].concat(), 5);
    assert!(refused.contains(&format!("threads ({threads}, now {other}) differ")), "{refused}");
    // So is a benchmark of another view, or in other light, although nothing is left to measure.
    for option in [["--eye", "1,2,30"], ["--sun", "10,20"], ["--hide", "0"]] {
        let more = [&["--cells", "cpu", "--resume"], &option[..]].concat();
        let refused = folder.fail(&[&["bench", "room.vxt"], &SMALL[..], &more].concat(), 5);
        assert!(refused.contains("another benchmark: options that say how scenes are read, seen or lit"), "{refused}");
    }
    // What is read with wider limits is the same scene.
    run(&folder, &["--cells", "cpu", "--resume", "--trusted"]);
    assert_eq!(folder.bytes("report/1-room-cpu.csv"), csv);
    // Planted: a line of the CSV is gone.
    let text = String::from_utf8(csv).unwrap();
    std::fs::write(folder.path("report/1-room-cpu.csv"), text.lines().take(5).collect::<Vec<_>>().join("\n")).unwrap();
    let arguments = [&["bench", "room.vxt"], &SMALL[..], &["--cells", "cpu", "--resume"]].concat();
    assert!(folder.fail(&arguments, 3).contains("damaged"));
}

#[test]
fn a_report_is_equal_to_itself_and_slower_than_one_with_planted_times() {
    let folder = Folder::new();
    folder.succeed(&["bench", "room.vxt", "--cells", "cpu", "--size", "32x24", "--frames", "40", "-o", "a"]);
    let mut results: Value = serde_json::from_slice(&folder.bytes("a/results.json")).unwrap();
    let write = |name: &str, results: &Value| std::fs::write(folder.path(name), results.to_string()).unwrap();
    // Whatever else happened on this machine.
    results["cells"][0]["disturbance"] = Value::Null;
    write("a.json", &results);
    let text = folder.succeed(&["compare", "a.json", "a.json"]);
    assert!(text.contains("Of one cell: 1 equal within noise."), "{text}");
    let ms = &mut results["cells"][0]["ms"];
    for value in ["/median", "/median_95/0", "/median_95/1"] {
        let value = ms.pointer_mut(value).unwrap();
        *value = (value.as_f64().unwrap() * 0.1).into();
    }
    write("b.json", &results);
    let json: Value = serde_json::from_str(&folder.succeed(&["compare", "a.json", "b.json", "--json"])).unwrap();
    assert_eq!(json["cells"][0]["outcome"], "B is faster", "{json}");
    assert!((json["cells"][0]["ratio"].as_f64().unwrap() - 0.1).abs() < 1e-9);
    results["cells"][0]["disturbance"] = "other programs had 50 % of the processors".into();
    write("loud.json", &results);
    let text = folder.succeed(&["compare", "a.json", "loud.json"]);
    let why = "no verdict: the machine was not quiet (B: other programs had 50 % of the processors)";
    assert!(text.contains(why) && text.contains("Of one cell: 1 no verdict."), "{text}");
    results["schema"] = 1.into();
    std::fs::write(folder.path("b.json"), results.to_string()).unwrap();
    assert!(folder.fail(&["compare", "a", "b.json"], 3).contains("schema 1"));
    assert!(folder.fail(&["compare", "a", "nowhere"], 3).contains("cannot read"));
}

#[test]
fn the_numbers_of_committed_reports_are_those_of_their_frames() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/results");
    let Ok(entries) = std::fs::read_dir(&folder) else {
        skip("no docs/results");
        return;
    };
    let (mut cells, mut is_lost) = (0, false);
    for entry in entries.map(|entry| entry.unwrap().path()).filter(|path| path.join("results.json").is_file()) {
        let results: Value = serde_json::from_slice(&std::fs::read(entry.join("results.json")).unwrap()).unwrap();
        for cell in results["cells"].as_array().unwrap() {
            let Some(csv) = cell["csv"].as_str() else { continue };
            let text = match std::fs::read_to_string(entry.join(csv)) {
                Ok(text) => text,
                Err(_) => {
                    let packed = std::fs::File::open(entry.join(format!("{csv}.gz"))).unwrap();
                    std::io::read_to_string(flate2::read::GzDecoder::new(packed)).unwrap()
                }
            };
            is_lost |= cell["lost"] != 0;
            assert!(cell["lost"] != 0 || recompute(&text, cell) == Ok(()), "{csv}: {:?}", recompute(&text, cell));
            cells += 1;
        }
    }
    println!("{cells} cells recomputed");
    assert!(!is_lost, "a committed report has lost frames");
}

#[test]
fn a_quick_benchmark_on_the_cpu_has_64_frames_of_each_cell_and_says_that_its_pictures_are_smaller() {
    let folder = Folder::new();
    let quick = ["bench", "room.vxt", "--quick", "--cells", "cpu:scalar,cpu:portable", "-o", "report"];
    let said = folder.succeed(&quick);
    let results: Value = serde_json::from_slice(&folder.bytes("report/results.json")).unwrap();
    let [width, height] = ["width", "height"].map(|edge| results["settings"][edge].as_u64().unwrap());
    assert_eq!(width * 1080, height * 1980);
    assert_eq!(said.contains("not the study's 1980 × 1080"), width != 1980, "{said}");
    for (cell, walk) in [(&results["cells"][0], "ray after ray"), (&results["cells"][1], "portable in streams")] {
        assert!(cell["frames"].as_u64() >= Some(64), "{cell}");
        assert_eq!(cell["processor"]["turns"], 8, "in turns: {cell}");
        assert!(said.contains(&format!("room {}: {walk}", cell["cell"].as_str().unwrap())), "{said}");
    }
    // It goes on with its size, and asks for nothing that is there; another size is another benchmark.
    folder.succeed(&[&quick[..], &["--resume"]].concat());
    let results: Value = serde_json::from_slice(&folder.bytes("report/results.json")).unwrap();
    assert_eq!((results["settings"]["width"].as_u64(), results["runs"].as_array().unwrap().len()), (Some(width), 2));
    assert!(folder.fail(&[&quick[..], &["--resume", "--size", "16x12"]].concat(), 5).contains("width"));
}
