//! What is shown while samples are left out, and while nothing is traced.

use crate::common::rendered;
use crate::drawing::{device, engine, finished, scene, view};
use std::sync::Arc;
use std::sync::mpsc::channel;
use std::time::Duration;
use voxtrace::Camera;
use voxtrace::glam::Vec3;
use voxtrace_viewer::engine::{Backend, Engine, Event, Pause, View};
use voxtrace_vulkan::Settings;

#[test]
fn a_view_that_changes_while_samples_are_left_out_is_shown_by_its_first() {
    let Some(device) = device() else { return };
    for backend in [Backend::Cpu, Backend::Device(Settings::default())] {
        let (engine, events) = engine(&device, backend);
        engine.set_view(view(3), false);
        finished(&engine, &events, 3);
        engine.pause(Pause::Samples);
        let (_, whole) = engine.film().recv().unwrap().expect("what is there stays");
        assert_eq!(whole, rendered(&scene(), &view(3).frame()));
        // Elsewhere, in another size, as where a panel comes.
        let camera = Camera::look_at(Vec3::new(70.0, -38.0, 40.0), Vec3::new(18.0, 20.0, 6.0));
        let aside = View { camera, width: 40, height: 24, ..view(3) };
        engine.set_view(aside.clone(), false);
        finished(&engine, &events, 1);
        let (frame, first) = engine.film().recv().unwrap().expect("its first sample is whole");
        assert_eq!((frame.samples, first), (1, rendered(&scene(), &aside.frame().samples(1))));
        engine.pause(Pause::Everything);
        engine.set_view(view(2), false);
        assert!(engine.film().recv().unwrap().is_none(), "nothing is traced");
        engine.pause(Pause::Nothing);
        finished(&engine, &events, 2);
    }
}

#[test]
fn a_fault_of_the_thread_that_traces_is_told() {
    let Some(device) = device() else { return };
    let (sender, events) = channel();
    let engine = Engine::start(Arc::clone(&device), Backend::Cpu, move |event| match event {
        Event::Picture => panic!("a fault that is planted"),
        event => drop(sender.send(event)),
    });
    engine.set_scene(Some(scene()));
    engine.set_view(view(1), false);
    while !matches!(
        events.recv_timeout(Duration::from_secs(300)).expect("the picture stands still without a word"),
        Event::Failed(_)
    ) {}
    assert!(engine.film().recv().is_err(), "nobody answers any more");
}
