//! Random events for the window, on a device of software with the validation layer: nothing is said by the layer, nothing hangs, and
//! memory does not grow. `VOXTRACE_SOAK_MINUTES` sets how long, `VOXTRACE_SOAK_SEED` which events; `VOXTRACE_SOAK_LIGHT=1`
//! keeps real-time light on; `VOXTRACE_SOAK_CURVE` names a file for the curve of memory.

#[path = "../window/common/mod.rs"]
mod common;

mod app;
mod events;
mod files;
mod meter;
mod turn;

use app::App;
use events::Hands;
use meter::Memory;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::{Duration, Instant};
use turn::Longest;

/// Looks at the turns, each of which comes this long after the one before: what is counted in them does not grow where all of the machine stands still.
const LOOK: Duration = Duration::from_millis(250);
/// A turn that is under way for so many looks hangs for good: two minutes, or four where looking at the memory waits for the turn,
/// as others may have the processors. The planted one is waited for less long.
const HANG: u32 = 480;
const PLANTED_HANG: u32 = HANG / 6;
/// A turn of the window's thread that takes longer by itself is felt as one that hangs.
const FELT: Duration = Duration::from_millis(250);
/// Runs of seconds that may have such a turn, or end with more memory, one after the other, until that is the program's and not chance. Other threads of
/// the window, which a turn waits for, wait for a processor where other programs have them all, and the kernel does not say of which wait that was; and in
/// seconds one large scene may be all that the last quarter has. What hangs or leaks does so again.
const RUNS: usize = 5;
const GROWS: &str = "memory grows";

/// Time between two looks at the memory, at least.
const BETWEEN_LOOKS: Duration = Duration::from_secs(1);
/// Looks at the memory, and events, that a run has at least, however slow the machine is.
const LEAST_LOOKS: usize = 16;
const LEAST_EVENTS: u64 = 11;

/// A fault of the program, for the test of the test.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Plant {
    Nothing,
    /// Bytes that are lost between two looks at the memory: a slow machine makes few events, and loses as much.
    Leak(usize),
    Hang,
}

fn median(values: &[u64]) -> u64 {
    let mut values = values.to_vec();
    values.sort_unstable();
    values.get(values.len() / 2).copied().unwrap_or(0)
}

/// What came of a run.
#[derive(Debug, Default)]
struct Counts {
    events: u64,
    frames: u64,
    moves: u64,
    saved: u64,
    /// Pictures in real-time light.
    lit: u64,
    devices: usize,
    /// The turn of the window's thread that took longest by itself.
    longest: Longest,
}

/// Runs for some time; `Err` says what went wrong. `slack` bytes of growth are nothing.
fn soak(seed: u64, time: Duration, slack: u64, lights: bool, plant: Plant) -> Option<Result<Counts, String>> {
    let (beats, frames) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicU64::new(0)));
    let stops = Arc::new(AtomicBool::new(false));
    let (beat, frame, stop) = (Arc::clone(&beats), Arc::clone(&frames), Arc::clone(&stops));
    let _pulse = turn::Pulse::feel();
    let run = std::thread::spawn(move || {
        let folder = tempfile::tempdir().unwrap();
        // Where files go that nobody named: hands click and type what they like.
        std::env::set_current_dir(folder.path()).unwrap();
        let mut app = App::open(folder.path(), lights)?;
        let mut hands = Hands::new(seed, lights);
        let start = Instant::now();
        let mut counts = Counts::default();
        let mut messages = Vec::new();
        while !stop.load(Ordering::Relaxed) {
            hands.act(&mut app, start.elapsed());
            counts.events += 1;
            app.turn();
            messages.extend(app.window.forget_instances());
            if plant == Plant::Hang && counts.events > 5 {
                std::thread::sleep(4 * PLANTED_HANG * LOOK);
            }
            frame.store(app.window.shown, Ordering::Relaxed);
            beat.fetch_add(1, Ordering::Relaxed);
        }
        (counts.frames, counts.moves, counts.saved) = (app.window.shown, app.window.moves, app.saved);
        counts.lit = app.lit;
        (counts.devices, counts.longest) = (app.window.devices(), app.longest.clone());
        messages.dedup();
        Some((counts, without_lost_textures(messages)))
    });
    let hang = if plant == Plant::Hang { PLANTED_HANG } else { HANG };
    let (mut start, mut look_again) = (Instant::now(), Instant::now());
    let (mut last, mut looks) = (0, 0);
    let mut curve = Vec::new();
    // What a planted leak loses needs no events and no frames, and is not to fill the memory of a slow machine.
    let is_idle = |events: u64| events < LEAST_EVENTS || frames.load(Ordering::Relaxed) < 2;
    let is_short =
        |looks: usize, events: u64| looks < LEAST_LOOKS || (!matches!(plant, Plant::Leak(_)) && is_idle(events));
    // A slow machine has more time, until there is something to judge.
    while !run.is_finished() && (start.elapsed() < time || (start.elapsed() < 10 * time && is_short(curve.len(), last)))
    {
        std::thread::sleep(LOOK);
        let now = beats.load(Ordering::Relaxed);
        if now == 0 {
            // The window is being opened.
            start = Instant::now();
        } else if Instant::now() >= look_again {
            // Not where a turn hangs.
            if let Some(memory) = turn::between(Memory::now) {
                curve.push(memory);
                if let Plant::Leak(bytes) = plant {
                    std::mem::forget(vec![1u8; bytes]);
                }
            }
            look_again = Instant::now() + BETWEEN_LOOKS;
        }
        looks = if now == last { looks + 1 } else { 0 };
        last = now;
        if looks > hang {
            stops.store(true, Ordering::Relaxed);
            return Some(Err(format!("seed {seed}: hangs after {last} events")));
        }
    }
    stops.store(true, Ordering::Relaxed);
    let (counts, messages) = match run.join() {
        Ok(ended) => ended?,
        Err(_) => return Some(Err(format!("seed {seed}: it panicked"))),
    };
    if !messages.is_empty() {
        return Some(Err(format!("seed {seed}: {messages:#?}")));
    }
    if plant == Plant::Nothing {
        report(seed, &counts, &curve);
    }
    // The first half warms up. Scenes come and go: of the third and the last quarter what is needed at least is compared.
    let quarter = curve.len() / 4;
    let floor = |part: &[Memory]| part.iter().map(|memory| memory.needed).min().unwrap_or(0);
    let (early, late) = (floor(&curve[2 * quarter..3 * quarter]), floor(&curve[3 * quarter..]));
    if late > early + early / 20 + slack {
        return Some(Err(format!("seed {seed}: {GROWS} from {early} to {late} bytes")));
    }
    Some(Ok(counts))
}

/// Says what happened and what memory there was, also where that is found to grow.
fn report(seed: u64, counts: &Counts, curve: &[Memory]) {
    println!("seed {seed}: {counts:?}; memory, MiB, in ten steps:");
    for (name, of) in Memory::KINDS {
        let values: Vec<u64> = curve.iter().map(of).collect();
        let steps: Vec<u64> = values.chunks(values.len().div_ceil(10).max(1)).map(|step| median(step) >> 20).collect();
        println!("  {name:<22} {steps:?}");
    }
    if let Ok(path) = std::env::var("VOXTRACE_SOAK_CURVE") {
        let lines: Vec<String> = curve.iter().enumerate().map(|(i, memory)| format!("{i} {memory}")).collect();
        std::fs::write(path, lines.join("\n")).unwrap();
    }
}

/// Leaves out what is about textures that `egui-ash-renderer` lets go of where their upload fails: a view and a sampler each, which it drops
/// without destroying them. Their images and memory are ours to destroy; and samplers are its alone, so that views without one are ours.
fn without_lost_textures(mut messages: Vec<String>) -> Vec<String> {
    let is_left = |message: &str, kind: &str| {
        message.contains("VUID-vkDestroyDevice-device-00378") && message.contains(&format!("OBJECT_TYPE_{kind};"))
    };
    if messages.iter().any(|message| is_left(message, "SAMPLER")) {
        messages.retain(|message| !is_left(message, "SAMPLER") && !is_left(message, "IMAGE_VIEW"));
    }
    messages
}

fn setting(name: &str) -> Option<f64> {
    std::env::var(name).ok()?.parse().ok()
}

#[test]
fn random_events_find_no_fault_and_planted_faults_are_found() {
    let seed = setting("VOXTRACE_SOAK_SEED").map_or(7, |seed| seed as u64);
    let minutes = setting("VOXTRACE_SOAK_MINUTES");
    let time = Duration::from_secs_f64(minutes.map_or(20.0, |minutes| 60.0 * minutes));
    // Within seconds caches of the driver still fill, and a quarter of them may have one large scene.
    let slack = if minutes.is_some() { 24 << 20 } else { 128 << 20 };
    let lights = setting("VOXTRACE_SOAK_LIGHT").is_some_and(|on| on > 0.0);
    for run in 1.. {
        let Some(result) = soak(seed, time, slack, lights, Plant::Nothing) else { return };
        // Who measures for minutes has a quiet machine, and scenes enough.
        let is_last = run == RUNS || minutes.is_some();
        if !is_last && result.as_ref().is_err_and(|error| error.contains(GROWS)) {
            continue;
        }
        let counts = result.unwrap();
        assert!(counts.events >= LEAST_EVENTS && counts.frames > 1, "{counts:?}");
        assert!(!lights || counts.lit > 1, "no picture in real-time light: {counts:?}");
        let longest = &counts.longest;
        if longest.took <= FELT {
            break;
        }
        let Longest { took, what, at } = longest;
        assert!(
            !is_last,
            "seed {seed}: in each of {run} runs a turn that is felt; at {at:?} one takes {took:?}: {what}"
        );
    }

    let found = soak(seed, Duration::from_secs(20), slack, false, Plant::Leak(128_000_000)).unwrap();
    assert!(found.as_ref().is_err_and(|error| error.contains(GROWS)), "{found:?}");
    let found = soak(seed, 3 * PLANTED_HANG * LOOK, slack, false, Plant::Hang).unwrap();
    assert!(found.as_ref().is_err_and(|error| error.contains("hangs")), "{found:?}");
}
