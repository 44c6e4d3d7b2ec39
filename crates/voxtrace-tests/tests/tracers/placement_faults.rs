//! Errors of the driver while things move: the right picture, or an error that says what happened; and a device that is opened
//! anew has things where they were last.

use std::sync::Arc;
use voxtrace::{CpuTracer, Film, Frame, Integrator, PackedScene, Placement, Progress, Region, TraceError, Tracer};
use voxtrace_test_support::{in_own_process, skip};
use voxtrace_tests::gpu::wanted;
use voxtrace_tests::moving::moving;
use voxtrace_tests::rooms;
use voxtrace_vulkan::{Device, Fault, Faults, Options, Primitive, Settings, Traversal, VulkanTracer, devices, missing};

/// Sets a scene, moves it, and renders it with more samples a few times.
fn run(
    tracer: &mut dyn Tracer,
    scene: &Arc<PackedScene>,
    moved: &Placement,
    frame: &Frame,
) -> Result<Film, TraceError> {
    tracer.set_scene(scene)?;
    tracer.render(frame, &Progress::default())?;
    tracer.set_placement(moved)?;
    for samples in 1..=3 {
        tracer.render(&frame.clone().samples(samples), &Progress::default())?;
    }
    let mut film = Film::new(1, 1, Region::full(1, 1), 0);
    tracer.read(&mut film)?;
    Ok(film)
}

/// Plants errors at calls of a run by one traversal and integrator.
fn check_calls(traversal: Traversal, integrator: Integrator) {
    let Some(wanted) = wanted() else { return };
    let list = devices(Options::default()).unwrap();
    let info = list.iter().find(|info| info.index.to_string() == *wanted || info.name.contains(&*wanted)).unwrap();
    if let Some(reason) = missing(info, traversal) {
        skip(&format!("{}: {reason}", info.name));
        return;
    }
    let (first, second) = (moving(12, 0), moving(12, 4));
    let packed = Arc::new(PackedScene::pack(&first).unwrap());
    let moved = Placement::of_scene(packed.geometry(), &second).unwrap();
    let frame = rooms::frame(&first, (9, 7), 1, integrator);
    let mut cpu = CpuTracer::new(None);
    let expected = run(&mut cpu, &packed, &moved, &frame).unwrap();
    let unmoved = run(&mut cpu, &packed, packed.placement(), &frame).unwrap();
    assert!(unmoved != expected, "the comparison sees things that did not move");

    let settings = Settings { traversal, primitive: Primitive::Brick, is_exact: true };
    let with = |faults: &Arc<Faults>| {
        let options = Options { faults: Some(Arc::clone(faults)), validation: true, ..Options::default() };
        let device = Device::open(options, Some(&wanted), None)?;
        let mut tracer = VulkanTracer::new(device, settings)?;
        let film = run(&mut tracer, &packed, &moved, &frame);
        let messages = tracer.device().vulkan().messages();
        assert_eq!(messages.count(), 0, "after {:?}: {:#?}", faults.fired(), messages.first());
        Ok::<_, TraceError>((film?, tracer.take_notes()))
    };
    // The first run compiles, so that what the second submits at a time is that of the runs that follow.
    assert!(with(&Faults::none()).unwrap().0 == expected, "the run without a fault");
    let counting = Faults::none();
    assert!(with(&counting).unwrap().0 == expected, "the run without a fault");
    let calls = counting.calls();
    let mut recovered = 0;
    // The scene is set in the first part of the calls; `vulkan_faults` looks at those.
    for call in calls.len() / 2..calls.len() {
        if calls[call] != "vkQueueSubmit" && call % 17 != 0 {
            continue;
        }
        for fault in Fault::ALL.into_iter().filter(|&fault| Faults::is_legal(&calls, call, fault)) {
            let faults = Faults::at(&[(call as u64, fault)]);
            let at = format!("{traversal:?}, {fault:?} at call {call}, {}", calls[call]);
            match with(&faults) {
                Ok((film, notes)) => {
                    assert!(film == expected, "{at}: a wrong picture");
                    recovered += usize::from(notes.iter().any(|note| note.contains("lost")));
                }
                Err(error) => assert!(!error.to_string().is_empty(), "{at}"),
            }
        }
    }
    assert!(recovered > 5, "{recovered} losses were mended");
}

#[test]
fn a_device_that_is_lost_comes_back_with_things_where_they_were_last() {
    in_own_process(|| check_calls(Traversal::Walk, Integrator::Path));
}

#[test]
fn a_device_with_ray_queries_comes_back_with_things_where_they_were_last() {
    // Lights are put back by the same code; the driver compiles its shaders anew for each fault, and those of paths take three times as long.
    in_own_process(|| check_calls(Traversal::Query, Integrator::Essay));
}
