//! Lines on the faces of voxels: the panel sets them, the frame has them, and the command says them.

use crate::common::panel::{click, panels, set};
use crate::common::{film, house, in_room, packed, rendered, words};
use crate::drawing::{device, engine, view};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use std::sync::Arc;
use std::time::Duration;
use voxtrace::glam::Vec3;
use voxtrace::lines::{GridLines, Line, Lines};
use voxtrace::{Film, Integrator, PackedScene};
use voxtrace_viewer::engine::{Backend, View};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::{Command, Session};

fn black(width: f32) -> Line {
    Line { width, color: Vec3::ZERO }
}

/// What `render` makes of the view with these lines.
fn drawn(session: &Session, lines: Lines) -> Film {
    rendered(&packed(), &session.view().frame().size(40, 30).samples(2).lines(lines))
}

#[test]
fn lines_are_set_by_the_panel_and_the_film_is_that_of_render() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let without = drawn(harness.state(), Lines::default());
    assert!(film(&packed(), harness.state()) == without && !words(harness.state()).contains("--edges"));
    click(&mut harness, "Lines");
    assert!(harness.query_by_role_and_label(Role::Slider, "width of edges").is_none());
    click(&mut harness, "along the edges of shapes");
    assert_eq!(harness.state_mut().take_commands(), [Command::SetView]);
    set(&mut harness, "width of edges", 0.4);
    click(&mut harness, "between voxels");
    set(&mut harness, "width of the grid", 0.3);
    set(&mut harness, "voxels apart", 2.0);
    let line = words(harness.state());
    assert!(line.contains(" --edges=0.4,0,0,0 --grid=0.3,0,0,0,2"), "{line}");
    let lines = |spacing| Lines { edges: Some(black(0.4)), grid: Some(GridLines { line: black(0.3), spacing }) };
    let found = film(&packed(), harness.state());
    assert!(found == drawn(harness.state(), lines(2)), "to the bit");
    assert!(found != without && found != drawn(harness.state(), lines(3)), "the comparison sees lines and spacing");

    // `essay` draws none, and `path` then those of before.
    let mut settings = harness.state().render_settings.clone();
    settings.take_integrator(Integrator::Essay);
    harness.state_mut().set_render_settings(settings.clone());
    let frame = harness.state().view().frame();
    assert!(frame.lines.is_none() && frame.check().is_ok() && !words(harness.state()).contains("--edges"));
    settings.take_integrator(Integrator::Path);
    harness.state_mut().set_render_settings(settings);
    assert!(film(&packed(), harness.state()) == found);
    harness.run();
    click(&mut harness, "along the edges of shapes");
    click(&mut harness, "between voxels");
    assert!(film(&packed(), harness.state()) == without && !words(harness.state()).contains("--grid"));
}

#[test]
fn lines_wait_until_instances_that_were_merged_are_apart() {
    let Some(device) = device() else { return };
    let merged = Arc::new(PackedScene::pack_merged(&house()).unwrap());
    let apart = Arc::new(merged.split());
    let line = Line { width: 0.4, color: Vec3::X };
    let view = View { lines: Lines { edges: Some(line), grid: None }, ..view(2) };
    let (engine, events) = engine(&device, Backend::Cpu);
    for (scene, lines) in [(&merged, Lines::default()), (&apart, view.lines), (&merged, Lines::default())] {
        engine.set_scene(Some(Arc::clone(scene)));
        engine.set_view(view.clone(), false);
        // What is shown, and what was told, may still be of the scene before: a film that is asked for now is of this one.
        let (frame, film) = loop {
            match engine.film().recv().unwrap().filter(|(frame, _)| frame.samples == 2) {
                Some(whole) => break whole,
                None => drop(events.recv_timeout(Duration::from_secs(1))),
            }
        };
        assert_eq!(frame, view.frame().lines(lines));
        assert_eq!(film, rendered(scene, &frame));
    }
}
