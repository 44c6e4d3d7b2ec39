//! The driver probes: they pass on the device of the tests, and each kind of driver fault, when injected, is found by the probe that
//! looks for it.

use std::path::Path;
use std::sync::Arc;
use std::time::Instant;
use voxtrace_test_support::skip;
use voxtrace_tests::gpu;
use voxtrace_vulkan::probe::{self, Cache, Cached, Effort, Outcome, PROBE_VERSION, Plant, ProbeReport};
use voxtrace_vulkan::{
    Device, DeviceInfo, Fault, Faults, Options, Primitive, Request, Traversal, choose, devices, missing,
};

/// The probes on the device of the tests, `None` where there is none or it has no ray tracing.
fn probed(effort: Effort, plant: Option<Plant>) -> Option<ProbeReport> {
    let device = gpu::device()?;
    if let (Some(why), Some(_)) =
        (missing(device.info(), Traversal::Pipeline), missing(device.info(), Traversal::Query))
    {
        skip(&format!("{} has no ray tracing: {why}", device.info().name));
        return None;
    }
    let vulkan = device.vulkan().clone();
    let report = probe::run_on(Arc::clone(&device), effort, plant, &mut |_, _| true, Instant::now()).unwrap();
    assert_eq!(vulkan.messages().count(), 0, "validation messages: {:#?}", vulkan.messages().first());
    Some(report)
}

fn outcome(report: &ProbeReport, id: &str) -> Outcome {
    report.probe(id).unwrap().outcome
}

/// Probes that a sound driver passes.
const PROMISED: [&str; 14] =
    ["P1", "P2", "P3", "P4", "P5", "P7", "P9", "P10", "P11", "P12", "P14", "P15", "P18", "P19"];

#[test]
fn all_probes_run_and_the_promises_that_tracers_need_hold() {
    let Some(report) = probed(Effort::Quick, None) else { return };
    let ids: Vec<String> = (1..=19).map(|number| format!("P{number}")).collect();
    assert_eq!(report.probes.iter().map(|row| row.id.clone()).collect::<Vec<_>>(), ids);
    for id in PROMISED {
        let row = report.probe(id).unwrap();
        assert_eq!(row.outcome, Outcome::Holds, "{id}: {}", row.says);
        assert!(row.rays > 0, "{id} looked at something");
    }
    assert!(report.probes.iter().all(|row| row.says.len() > 10 && row.milliseconds > 0.0));
    for traversal in [Traversal::Pipeline, Traversal::Query] {
        assert_eq!(report.trusted(traversal), Some(Primitive::Brick), "{}", report.verdict());
    }
}

#[test]
fn lavapipe_hands_over_the_attribute_of_another_hit_and_loses_boxes_beside_inactive_ones() {
    let Some(report) = probed(Effort::Quick, None) else { return };
    if !report.driver.contains("Mesa 25.0.7") {
        skip(&format!("{} is another driver", report.driver));
        return;
    }
    let finding = report.finding("P13", Traversal::Pipeline).unwrap();
    assert_eq!(finding.outcome, Outcome::Fails, "{}", finding.says);
    let share = finding.counts["wrong when trusted"] as f64 / finding.rays as f64;
    assert!((0.15..0.3).contains(&share), "{share} of the rays");
    assert_eq!((finding.counts["wrong when put back"], finding.counts["wrong when kept by any-hit shaders"]), (0, 0));
    assert_eq!(report.finding("P13", Traversal::Query).unwrap().outcome, Outcome::NotApplicable);
    assert_eq!(outcome(&report, "P6"), Outcome::Fails);
}

/// A driver with a fault: probes that must fail, and probes that must not.
fn check_plant(plant: Plant, failing: &[&str], holding: &[&str], word: &str) {
    let Some(report) = probed(Effort::Quick, Some(plant)) else { return };
    for id in failing {
        let row = report.probe(id).unwrap();
        assert_eq!(row.outcome, Outcome::Fails, "{plant:?} {id}: {}", row.says);
        assert!(row.wrong > 0, "{plant:?} {id}");
        for finding in row.findings.iter().filter(|finding| finding.outcome != Outcome::NotApplicable) {
            assert_eq!(finding.outcome, Outcome::Fails, "{plant:?} {id} {:?}", finding.traversal);
        }
    }
    assert!(report.probe(failing[0]).unwrap().says.contains(word), "{}", report.probe(failing[0]).unwrap().says);
    for id in holding {
        assert_eq!(outcome(&report, id), Outcome::Holds, "{plant:?} {id}: {}", report.probe(id).unwrap().says);
    }
}

#[test]
fn a_driver_that_merges_boxes_is_found_and_loses_the_trust_in_numbers() {
    check_plant(Plant::MergedBoxes, &["P2", "P1"], &["P7", "P14", "P19"], "merged: ");
    let Some(report) = probed(Effort::Quick, Some(Plant::MergedBoxes)) else { return };
    let finding = &report.probe("P2").unwrap().findings[0];
    assert!(finding.counts["missing candidates"] > 0 && finding.counts["approximate hits wrong"] > 0, "{finding:?}");
    assert!(finding.says.contains("all do where boxes do not touch"), "{}", finding.says);
    // A device may have only one of them.
    let had = |traversal: &Traversal| report.finding("P2", *traversal).unwrap().outcome != Outcome::NotApplicable;
    for traversal in [Traversal::Pipeline, Traversal::Query].into_iter().filter(had) {
        assert!(report.distrusts(traversal, Primitive::Brick).unwrap().contains("merged"));
        assert_eq!(report.trusted(traversal), Some(Primitive::Grid), "identity from position is safe");
    }
    assert!(report.verdict().contains("falls back to grid"), "{}", report.verdict());
}

#[test]
fn a_driver_that_loses_boxes_is_found_and_not_called_merging() {
    check_plant(Plant::LostBoxes, &["P2", "P1", "P3", "P12", "P14", "P15"], &[], "lost: ");
}

#[test]
fn a_driver_that_hands_over_the_last_attribute_is_found() {
    check_plant(Plant::LastAttribute, &["P13"], &["P1", "P2", "P7"], "another box");
}

#[test]
fn a_driver_that_misplaces_instances_is_found_and_loses_all_trust() {
    check_plant(Plant::ShiftedInstances, &["P7", "P4"], &["P19"], "come out wrong");
    let Some(report) = probed(Effort::Quick, Some(Plant::ShiftedInstances)) else { return };
    assert_eq!(report.trusted(Traversal::Pipeline), None);
    assert!(report.verdict().contains("falls back to the compute walk"), "{}", report.verdict());
}

#[test]
fn the_loss_of_the_device_is_an_outcome_and_the_other_probes_go_on() {
    let Some(wanted) = gpu::wanted() else { return };
    let run = |faults| {
        let options = Options { faults: Some(faults), validation: true, ..Options::default() };
        probe::run(options, Some(&wanted), Effort::Quick, None, &mut |_, _| true).unwrap()
    };
    let counting = Faults::none();
    run(counting.clone());
    let calls = counting.calls();
    let waits: Vec<u64> = (0..calls.len()).filter(|&i| calls[i] == "vkWaitSemaphores").map(|i| i as u64).collect();
    let (third, half) = (waits[waits.len() / 3], waits[waits.len() / 2]);
    let once = run(Faults::at(&[(third, Fault::DeviceLost)]));
    let failed = |report: &ProbeReport| {
        let failed = report.probes.iter().filter(|row| row.outcome == Outcome::Fails && row.rays == 0);
        failed.map(|row| row.says.clone()).collect::<Vec<_>>()
    };
    assert_eq!(failed(&once).len(), 1, "{:?}", failed(&once));
    assert!(failed(&once)[0].contains("lost"), "{:?}", failed(&once));
    assert_eq!(once.probes.len(), 19);
    assert!(outcome(&once, "P19") == Outcome::Holds, "{}", once.probe("P19").unwrap().says);
    let plan: Vec<(u64, Fault)> =
        std::iter::once(third).chain(half..half + 50).map(|at| (at, Fault::DeviceLost)).collect();
    let twice = run(Faults::at(&plan));
    assert_eq!(failed(&twice).len(), 2, "{:?}", failed(&twice));
    let rest = twice.probe("P19").unwrap();
    assert_eq!((rest.outcome, rest.says.contains("twice")), (Outcome::NotApplicable, true), "{}", rest.says);
}

#[test]
fn errors_of_the_driver_at_any_call_are_outcomes() {
    let Some(wanted) = gpu::wanted() else { return };
    let options = |faults| Options { faults: Some(faults), validation: true, ..Options::default() };
    let counting = Faults::none();
    let run = |device| probe::run_on(device, Effort::Quick, None, &mut |_, _| true, Instant::now()).unwrap();
    let device = Device::open(options(counting.clone()), Some(&wanted), None).unwrap();
    let before = counting.calls().len();
    run(device);
    let calls = counting.calls();
    for step in 0..8 {
        let call = before + (calls.len() - before) * (2 * step + 1) / 16;
        for fault in Fault::ALL.into_iter().filter(|&fault| Faults::is_legal(&calls, call, fault)) {
            let faults = Faults::at(&[(call as u64, fault)]);
            let device = Device::open(options(faults.clone()), Some(&wanted), None).unwrap();
            let vulkan = device.vulkan().clone();
            let report = run(device);
            let at = format!("{fault:?} at call {call}, {}: {:?}", calls[call], faults.fired());
            assert_eq!(report.probes.len(), 19, "{at}");
            let stopped = report.probes.iter().filter(|row| row.findings.iter().all(|finding| finding.rays == 0));
            assert!(stopped.count() <= 1, "{at}: only one probe pays for it");
            assert_eq!(vulkan.messages().count(), 0, "{at}: {:#?}", vulkan.messages().first());
        }
    }
}

fn info() -> Option<DeviceInfo> {
    let wanted = gpu::wanted()?;
    let list = devices(Options::default()).unwrap();
    list.into_iter().find(|info| info.index.to_string() == *wanted || info.name.contains(&*wanted))
}

/// A report that trusts nothing but what `failing` does not touch.
fn report_of(info: &DeviceInfo, failing: &[&str]) -> ProbeReport {
    let finding = |id: &str| {
        let outcome = if failing.contains(&id) { "fails" } else { "holds" };
        format!(
            r#"{{"id":"{id}","name":"n","expects":"e","outcome":"{outcome}","rays":1,"wrong":0,"says":"s","milliseconds":1.0,
            "findings":[{{"traversal":null,"outcome":"{outcome}","rays":1,"wrong":0,"counts":{{}},"says":"planted"}}]}}"#
        )
    };
    let rows: Vec<String> = (1..=19).map(|number| finding(&format!("P{number}"))).collect();
    let text = format!(
        r#"{{"schema":1,"probe_version":{PROBE_VERSION},"voxtrace":"0","device":{:?},"kind":"k","driver":{:?},"vulkan":{:?},
        "effort":"quick","traversals":["pipeline","query"],"seconds":1.0,"probes":[{}]}}"#,
        info.name,
        info.driver,
        info.api_version,
        rows.join(",")
    );
    serde_json::from_str(&text).unwrap()
}

#[test]
fn the_cache_keeps_a_report_for_its_device_driver_and_version_alone() {
    let Some(info) = info() else { return };
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::new(&folder.path().join("deep/voxtrace"));
    assert_eq!(cache.load(&info), Cached::Nothing);
    let report = report_of(&info, &[]);
    cache.store(&info, &report).unwrap();
    assert_eq!(cache.load(&info).report(), Some(report.clone()));

    let mut newer = info.clone();
    newer.driver += "1";
    assert_eq!(cache.load(&newer), Cached::Nothing, "a new driver is probed anew");
    let mut other = info.clone();
    other.name = "another".into();
    assert_eq!(cache.load(&other), Cached::Nothing);
    // The same file with another version inside.
    let place = |text: &str| std::fs::write(cache.path(&info), text).unwrap();
    let text = std::fs::read_to_string(cache.path(&info)).unwrap();
    let version = format!("\"probe_version\": {PROBE_VERSION}");
    assert!(text.contains(&version));
    place(&text.replace(&version, "\"probe_version\": 0"));
    assert!(matches!(cache.load(&info), Cached::Unusable(why) if why.contains("version")));
    for damaged in ["", "{", "[1, 2]", "{\"schema\": 1}", &text[..text.len() / 2], "\u{0}\u{1}"] {
        place(damaged);
        assert!(matches!(cache.load(&info), Cached::Unusable(_)), "{damaged:?}");
    }
    cache.store(&info, &report).unwrap();
    assert_eq!(cache.load(&info).report(), Some(report.clone()), "a damaged file is replaced");

    // A quick run does not forget a full one that found the same, but does one that found something else.
    let full = ProbeReport { effort: "full".into(), ..report.clone() };
    cache.store(&info, &full).unwrap();
    cache.store(&info, &report).unwrap();
    assert_eq!(cache.load(&info).report().unwrap().effort, "full");
    cache.store(&info, &report_of(&info, &["P1"])).unwrap();
    assert_eq!(cache.load(&info).report().unwrap().effort, "quick");
}

#[test]
fn what_the_probes_found_decides_the_order_of_primitives() {
    let Some(info) = info() else { return };
    let folder = tempfile::tempdir().unwrap();
    let cache = Cache::new(Path::new(folder.path()));
    let chosen = |failing: Option<&[&str]>, traversal, primitive| {
        if let Some(failing) = failing {
            let report = report_of(&info, failing);
            let _ = std::fs::remove_file(cache.path(&info));
            cache.store(&info, &report).unwrap();
        }
        let request = Request {
            traversal,
            primitive,
            device: Some(info.index.to_string()),
            probes: Some(cache.clone()),
            ..Request::default()
        };
        let choice = choose(&request).unwrap();
        (choice.traversal, choice.reason)
    };
    let Some(traversal) = [Traversal::Pipeline, Traversal::Query].into_iter().find(|&t| missing(&info, t).is_none())
    else {
        skip(&format!("{} has no ray tracing", info.name));
        return;
    };
    let is = |failing, primitive: &str| {
        let (by, reason) = chosen(failing, Some(traversal), None);
        assert_eq!(by, traversal, "{reason}");
        assert!(reason.contains(&format!("primitive {primitive}")), "{reason}");
        reason
    };
    is(None, "brick");
    is(Some(&[]), "brick");
    is(Some(&["P13", "P6"]), "brick");
    assert!(is(Some(&["P2"]), "grid").contains("grid instead of"), "and the reason says so");
    is(Some(&["P2", "P4"]), "triangle");
    let (by, reason) = chosen(Some(&["P7"]), Some(traversal), None);
    assert_eq!(by, Traversal::Walk, "{reason}");
    assert!(reason.contains("the compute walk instead of") && reason.contains("P7"), "{reason}");
    // What is asked for stays, with a word.
    let (by, reason) = chosen(Some(&["P1"]), Some(traversal), Some(Primitive::VoxelExact));
    assert_eq!(by, traversal);
    assert!(reason.contains("primitive voxel-exact") && reason.contains("not to be trusted"), "{reason}");
    // The walk needs none of this.
    let (by, reason) = chosen(Some(&["P1", "P7"]), None, None);
    assert!(by == Traversal::Walk && !reason.contains("instead"), "{reason}");
    std::fs::write(cache.path(&info), "rubbish").unwrap();
    assert!(is(None, "brick").contains("is ignored"));
}

#[test]
fn a_device_without_ray_tracing_has_nothing_to_probe() {
    let Some(wanted) = gpu::wanted() else { return };
    let hidden = Faults::without(&["VK_KHR_ray_query", "VK_KHR_ray_tracing_pipeline"]);
    let options = Options { faults: Some(hidden), validation: true, ..Options::default() };
    let device = Device::open(options, Some(&wanted), None).unwrap();
    let report = probe::run_on(device, Effort::Quick, None, &mut |_, _| true, Instant::now()).unwrap();
    assert!(report.probes.iter().all(|row| row.outcome == Outcome::NotApplicable), "{report:?}");
    assert!(report.probes[0].says.contains("VK_KHR_ray_query"), "{}", report.probes[0].says);
    assert!(report.verdict().contains("compute walk"));
}

#[test]
fn reports_are_named_after_the_device_and_the_version_of_its_driver() {
    let Some(info) = info() else { return };
    let named = |device: &str, driver: &str| {
        let report = ProbeReport { device: device.into(), driver: driver.into(), ..report_of(&info, &[]) };
        report.file_stem()
    };
    assert_eq!(named("llvmpipe (LLVM 19.1.7, 256 bits)", "llvmpipe Mesa 25.0.7-2 (LLVM 19.1.7)"), "lavapipe-25.0.7");
    assert_eq!(named("NVIDIA H200", "NVIDIA 580.159.04"), "nvidia-h200-580.159.04");
    assert_eq!(named("AMD Radeon RX 6600 XT (RADV NAVI23)", "radv Mesa 25.2.1"), "amd-radeon-rx-6600-xt-25.2.1");
    assert_eq!(named("../x", "no version"), "x-unknown");
}
