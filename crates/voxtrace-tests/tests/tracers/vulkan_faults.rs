//! Errors of the driver, planted at its calls: a run of 16 frames ends with the right picture or with an error that says what
//! happened, never with a panic.

use std::sync::Arc;
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Progress, Region, TraceError, Tracer};
use voxtrace_test_support::{Alone, in_own_process, skip};
use voxtrace_tests::{gpu, rooms};
use voxtrace_vulkan::{Device, Fault, Faults, Options, Primitive, Settings, Traversal, VulkanTracer, devices, missing};

const FRAMES: u32 = 16;

struct Run {
    scene: Arc<PackedScene>,
    frame: Frame,
    expected: Film,
    wanted: Alone<String>,
    settings: Settings,
}

/// What became of a run.
struct End {
    film: Result<Film, TraceError>,
    notes: Vec<String>,
    is_on_cpu: bool,
}

impl Run {
    /// `None` where there is no device.
    fn new(settings: Settings) -> Option<Self> {
        let wanted = gpu::wanted()?;
        let scene = rooms::lamp_room();
        let frame = rooms::frame(&scene, (9, 7), FRAMES, Integrator::Essay);
        let scene = Arc::new(PackedScene::pack(&scene).unwrap());
        let mut cpu = CpuTracer::new(None);
        cpu.set_scene(&scene).unwrap();
        cpu.render(&frame, &Progress::default()).unwrap();
        let mut expected = Film::new(1, 1, Region::full(1, 1), 0);
        cpu.read(&mut expected).unwrap();
        Some(Self { scene, frame, expected, wanted, settings })
    }

    /// Renders the frames one after the other.
    fn with(&self, faults: &Arc<Faults>) -> End {
        let failed = |error| End { film: Err(error), notes: Vec::new(), is_on_cpu: false };
        let options = Options { faults: Some(Arc::clone(faults)), validation: true, ..Options::default() };
        let opened =
            Device::open(options, Some(&self.wanted), None).and_then(|device| VulkanTracer::new(device, self.settings));
        let mut tracer = match opened {
            Ok(tracer) => tracer,
            Err(error) => return failed(error),
        };
        let film = self.frames(&mut tracer);
        let end = End { film, notes: tracer.take_notes(), is_on_cpu: tracer.is_on_cpu() };
        let vulkan = Arc::clone(tracer.device().vulkan());
        drop(tracer);
        let messages = vulkan.messages();
        assert_eq!(messages.count(), 0, "after {:?}: {:#?}", faults.fired(), messages.first());
        end
    }

    fn frames(&self, tracer: &mut VulkanTracer) -> Result<Film, TraceError> {
        tracer.set_scene(&self.scene)?;
        for samples in 1..=FRAMES {
            tracer.render(&self.frame.clone().samples(samples), &Progress::default())?;
        }
        let mut film = Film::new(1, 1, Region::full(1, 1), 0);
        tracer.read(&mut film)?;
        Ok(film)
    }

    /// The calls of a run without a fault. A run before it compiles, so that what is submitted at a time is that of the runs that follow.
    fn calls(&self) -> Vec<&'static str> {
        assert!(self.is_right(&self.with(&Faults::none())), "the run without a fault");
        let counting = Faults::none();
        assert!(self.is_right(&self.with(&counting)), "the run without a fault");
        counting.calls()
    }

    fn is_right(&self, end: &End) -> bool {
        end.film.as_ref().is_ok_and(|film| *film == self.expected)
    }
}

/// Plants every legal error at every call of the run, but of the frames, which are all alike, only at those of a few.
fn check_every_call(settings: Settings) {
    let Some(run) = Run::new(settings) else { return };
    let calls = run.calls();
    assert!(calls.len() > 100, "{} calls", calls.len());
    let first_of_frames = calls.iter().position(|call| call.starts_with("vkCreate") && call.contains("Pipeline"));
    let first_of_frames = first_of_frames.unwrap() + 20;
    let mut submits = 0;
    let mut is_chosen = |&call: &usize| {
        // Every seventeenth call of the frames, and every fourth submit, whatever calls lie between.
        submits += usize::from(calls[call] == "vkQueueSubmit");
        let is_sampled = call % 17 == 0 || calls[call] == "vkQueueSubmit" && submits % 4 == 0;
        call <= first_of_frames || call + 20 >= calls.len() || is_sampled
    };
    let recovered: usize = (0..calls.len()).filter(&mut is_chosen).map(|call| check_call(&run, &calls, call)).sum();
    assert!(recovered > 3, "{recovered} losses were mended");
}

/// Plants every legal error at one call. Returns how many losses were mended.
fn check_call(run: &Run, calls: &[&'static str], call: usize) -> usize {
    let mut recovered = 0;
    for fault in Fault::ALL.into_iter().filter(|&fault| Faults::is_legal(calls, call, fault)) {
        let faults = Faults::at(&[(call as u64, fault)]);
        let end = run.with(&faults);
        let at = format!("{fault:?} at call {call}, {}", calls[call]);
        // Where a wait is repeated the numbers of later calls shift: what is hit then is another call of the run.
        assert!(faults.fired().iter().all(|(_, fired)| *fired == fault), "{at}");
        match &end.film {
            Ok(film) => assert!(*film == run.expected, "{at}: a wrong picture"),
            Err(error) => assert!(!error.to_string().is_empty(), "{at}"),
        }
        if faults.fired() == [("vkQueueSubmit", Fault::DeviceLost)] {
            assert!(run.is_right(&end), "{at}: {:?}", end.film.err());
            assert!(end.notes.iter().any(|note| note.contains("lost")), "{at}: {:?}", end.notes);
            recovered += 1;
        }
    }
    recovered
}

#[test]
fn every_error_of_a_run_with_the_compute_walk_is_survived() {
    in_own_process(|| check_every_call(Settings::default()));
}

#[test]
fn every_error_of_a_run_with_a_pipeline_is_survived() {
    in_own_process(|| {
        let Some(wanted) = gpu::wanted() else { return };
        let list = devices(Options::default()).unwrap();
        let info = list.iter().find(|info| info.index.to_string() == *wanted || info.name.contains(&*wanted)).unwrap();
        if let Some(reason) = missing(info, Traversal::Pipeline) {
            skip(&format!("{}: {reason}", info.name));
            return;
        }
        check_every_call(Settings { traversal: Traversal::Pipeline, primitive: Primitive::Brick, is_exact: true });
    });
}

#[test]
fn a_device_that_is_lost_twice_leaves_the_work_to_the_cpu() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let calls = run.calls();
    let waits: Vec<u64> = (0..calls.len()).filter(|&i| calls[i] == "vkWaitSemaphores").map(|i| i as u64).collect();
    let first = waits[waits.len() / 2];
    let once = run.with(&Faults::at(&[(first, Fault::DeviceLost)]));
    assert!(run.is_right(&once) && !once.is_on_cpu, "{:?}", once.notes);
    // The second loss comes at some wait of the device that was opened anew.
    let plan: Vec<(u64, Fault)> =
        std::iter::once(first).chain(first + 150..first + 200).map(|at| (at, Fault::DeviceLost)).collect();
    let twice = run.with(&Faults::at(&plan));
    assert!(run.is_right(&twice) && twice.is_on_cpu, "{:?}", twice.notes);
}

#[test]
fn a_frame_that_never_ran_is_no_frame() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let end = run.with(&Faults::without_dispatch(u64::from(FRAMES) / 2));
    let error = end.film.unwrap_err().to_string();
    assert!(error.contains("did not do the work"), "{error}");
}

#[test]
fn missing_extensions_are_named() {
    let Some(run) = Run::new(Settings { traversal: Traversal::Query, ..Settings::default() }) else { return };
    let hidden = ["VK_KHR_ray_query", "VK_KHR_ray_tracing_pipeline", "VK_EXT_memory_budget"];
    let end = run.with(&Faults::without(&hidden));
    let error = end.film.unwrap_err().to_string();
    assert!(error.contains("VK_KHR_ray_query"), "{error}");
    // The walk needs none of them.
    let run = Run { settings: Settings::default(), ..run };
    assert!(run.is_right(&run.with(&Faults::without(&hidden))));
}

#[test]
fn a_budget_that_is_too_small_is_said_with_both_numbers() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let device = Device::open(Options::default(), Some(&run.wanted), Some(60_000)).unwrap();
    let mut tracer = VulkanTracer::new(device, run.settings).unwrap();
    match run.frames(&mut tracer) {
        Err(TraceError::OutOfMemory { needed, available }) => assert!(needed > available, "{needed} {available}"),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_film_that_the_cpu_did_not_end_says_how_many_samples_it_has() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let faults = Faults::none();
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let device = Device::open(options, Some(&run.wanted), None).unwrap();
    let mut tracer = VulkanTracer::new(device, run.settings).unwrap();
    tracer.set_scene(&run.scene).unwrap();
    faults.plant("vkQueueSubmit", Fault::DeviceLost);
    faults.plant("vkCreateDevice", Fault::OutOfHostMemory);
    tracer.render(&run.frame.clone().samples(2), &Progress::default()).unwrap();
    assert!(tracer.is_on_cpu() && tracer.samples() == 2);
    let stopped = Progress::default();
    stopped.cancel();
    tracer.render(&run.frame, &stopped).unwrap();
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film).unwrap();
    assert!(film.sample_range().0 < FRAMES);
    assert_eq!(tracer.samples(), film.sample_range().0);
    tracer.render(&run.frame, &Progress::default()).unwrap();
    assert_eq!(tracer.samples(), FRAMES);
}

/// Calls that wait however long it takes.
const WITHOUT_LIMIT: [&str; 2] = ["vkDeviceWaitIdle", "vkQueueWaitIdle"];

#[test]
fn work_that_does_not_end_is_given_up_and_nobody_waits_for_it() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let faults = Faults::none();
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let device = Device::open(options, Some(&run.wanted), None).unwrap();
    let name = device.info().name.clone();
    let mut tracer = VulkanTracer::new(device, run.settings).unwrap();
    tracer.set_scene(&run.scene).unwrap();
    tracer.render(&run.frame.clone().samples(2), &Progress::default()).unwrap();
    let before = faults.calls().len();
    faults.plant("vkWaitSemaphores", Fault::Hang);
    let progress = Progress::default();
    tracer.render(&run.frame, &progress).unwrap();
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film).unwrap();
    assert!(film == run.expected);
    assert_eq!(progress.samples_done(), 9 * 7 * u64::from(FRAMES - 2), "those before are not told again");
    assert!(!tracer.is_on_cpu(), "the first time it is opened anew");
    let calls = &faults.calls()[before..];
    let opened = calls.iter().position(|call| *call == "vkCreateDevice").unwrap();
    assert!(!calls[..opened].iter().any(|call| WITHOUT_LIMIT.contains(call)), "that would wait for ever");
    let notes = tracer.take_notes();
    assert!(notes.iter().any(|note| note.contains(&name) && note.contains("did not end within")), "{notes:?}");
    // Again, soon after that.
    faults.plant("vkWaitSemaphores", Fault::Hang);
    tracer.render(&run.frame.clone().seed(5), &Progress::default()).unwrap();
    assert!(tracer.is_on_cpu());
}

#[test]
fn another_tracer_of_a_device_that_hangs_is_told_at_once() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let faults = Faults::none();
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let device = Device::open(options, Some(&run.wanted), None).unwrap();
    let mut tracers = [0, 1].map(|_| VulkanTracer::new(Arc::clone(&device), run.settings).unwrap());
    for tracer in &mut tracers {
        tracer.set_scene(&run.scene).unwrap();
        tracer.render(&run.frame.clone().samples(2), &Progress::default()).unwrap();
    }
    faults.plant("vkWaitSemaphores", Fault::Hang);
    let [first, second] = &mut tracers;
    first.render(&run.frame, &Progress::default()).unwrap();
    assert!(device.is_given_up());
    let before = faults.calls().len();
    second.render(&run.frame, &Progress::default()).unwrap();
    let calls = &faults.calls()[before..];
    let opened = calls.iter().position(|call| *call == "vkCreateDevice").unwrap();
    let used = |call: &&&str| call.starts_with("vkWait") || **call == "vkQueueSubmit" || WITHOUT_LIMIT.contains(*call);
    assert_eq!(calls[..opened].iter().find(used), None, "it neither asks the device for more nor waits for it");
    let notes = second.take_notes();
    assert!(notes.iter().any(|note| note.contains("as other work did not end within")), "{notes:?}");
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    second.read(&mut film).unwrap();
    assert!(film == run.expected && !second.is_on_cpu());
}

#[test]
fn who_lets_go_of_a_device_that_hangs_does_not_wait_for_ever() {
    let Some(run) = Run::new(Settings::default()) else { return };
    let opened = |faults: &Arc<Faults>| {
        let options = Options { faults: Some(Arc::clone(faults)), ..Options::default() };
        Device::open(options, Some(&run.wanted), None).unwrap()
    };
    let never = |faults: &Arc<Faults>| !faults.calls().iter().any(|call| WITHOUT_LIMIT.contains(call));
    // After an error that is no loss, with work under way.
    let faults = Faults::none();
    let device = opened(&faults);
    let mut tracer = VulkanTracer::new(Arc::clone(&device), run.settings).unwrap();
    tracer.set_scene(&run.scene).unwrap();
    tracer.render(&run.frame.clone().samples(2), &Progress::default()).unwrap();
    faults.plant("vkQueueSubmit", Fault::OutOfDeviceMemory);
    faults.plant("vkWaitSemaphores", Fault::Hang);
    assert!(matches!(tracer.render(&run.frame, &Progress::default()), Err(TraceError::Device { .. })));
    assert!(device.is_given_up());
    drop((tracer, device));
    assert!(never(&faults), "{:?}", faults.calls());
    // A tracer that goes while its device hangs.
    let faults = Faults::none();
    let device = opened(&faults);
    let mut tracer = VulkanTracer::new(Arc::clone(&device), run.settings).unwrap();
    tracer.set_scene(&run.scene).unwrap();
    tracer.render(&run.frame.clone().samples(2), &Progress::default()).unwrap();
    faults.plant("vkWaitSemaphores", Fault::Hang);
    drop(tracer);
    assert!(device.is_given_up() && never(&faults), "{:?}", faults.calls());
    // Whoever waits for all of the device, or for what it shows.
    for wait in [|device: &Device| device.wait_idle(), |device: &Device| _ = device.wait_presented()] {
        let faults = Faults::none();
        let device = opened(&faults);
        faults.plant("vkWaitForFences", Fault::Hang);
        wait(&device);
        assert!(device.is_given_up() && never(&faults), "{:?}", faults.calls());
        assert!(!device.wait_presented(), "it may still use what is shown");
    }
    // A device that works is not given up.
    let device = opened(&Faults::none());
    device.wait_idle();
    assert!(device.wait_presented() && !device.is_given_up());
}

#[test]
fn a_driver_that_fails_when_it_is_asked_does_not_hide_the_others() {
    if gpu::wanted().is_none() {
        return;
    }
    let faults = Faults::none();
    faults.plant("vkEnumerateDeviceExtensionProperties", Fault::OutOfHostMemory);
    let options = Options { faults: Some(Arc::clone(&faults)), ..Options::default() };
    let (all, listed) = (devices(Options::default()).unwrap(), devices(options).unwrap());
    let lacks = listed[0].walk_missing.as_ref().unwrap();
    assert!(lacks.contains("listing extensions"), "{lacks}");
    let rest = |list: &[voxtrace_vulkan::DeviceInfo]| -> Vec<_> {
        list.iter().skip(1).map(|info| (info.name.clone(), info.walk_missing.clone())).collect()
    };
    assert_eq!(rest(&listed), rest(&all));
}
