//! The panel of editing, its questions, and what is drawn over the picture.

use crate::common::hand::{Hand, floor};
use crate::common::panel::{click, panels, set};
use crate::common::{in_room, room};
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::{Material, PackedScene};
use voxtrace_viewer::editing::outline::{Look, outlines};
use voxtrace_viewer::editing::{Act, Tool};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::projection::Projection;
use voxtrace_viewer::session::{Command, Leaving, Session};

/// The panels of a session with two steps.
fn with_two_steps<'a>() -> Harness<'a, Session> {
    let mut hand = Hand::on(in_room("room.vxt"));
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    hand.click(floor(6, 4));
    hand.steps(2, 0);
    panels(hand.session, Status::default())
}

/// Waits until there are so many steps, and so many that were undone.
fn steps(harness: &mut Harness<Session>, done: usize, undone: usize) {
    let since = Instant::now();
    loop {
        harness.state_mut().take_edited();
        let steps = &harness.state().editing.as_ref().unwrap().steps;
        if (steps.done.len(), steps.undone.len()) == (done, undone) {
            return harness.run_steps(3);
        }
        assert!(since.elapsed() < Duration::from_secs(300), "{steps:?}");
        std::thread::sleep(Duration::from_millis(5));
    }
}

#[test]
fn tools_brush_palette_and_symmetry_are_chosen_in_the_panel() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    click(&mut harness, "Edit the voxels");
    assert_eq!(harness.state_mut().take_commands(), [Command::Edit]);
    assert!(harness.query_by_label_contains("ready for edits").is_some(), "not yet");
    let editing = |harness: &Harness<Session>| {
        let editing = harness.state().editing.as_ref().unwrap();
        (editing.act, editing.tool, editing.brush.size, editing.material, editing.symmetry.axes)
    };
    click(&mut harness, "erase");
    set(&mut harness, "size of the brush", 9.0);
    click(&mut harness, "cube");
    harness.get_by_label_contains("material 1, #").click();
    harness.run_steps(3);
    harness.get_by_role_and_label(Role::CheckBox, "y").click();
    harness.run_steps(3);
    assert_eq!(editing(&harness), (Act::Erase, Tool::Brush, 9, 1, [false, true, false]));
    assert!(!harness.state().editing.as_ref().unwrap().brush.is_round);
    click(&mut harness, "box");
    assert_eq!(editing(&harness).1, Tool::Box);
    click(&mut harness, "a voxel");
    assert!(harness.state().editing.as_ref().unwrap().picks_middle);
    click(&mut harness, "End editing");
    assert!(!harness.state().is_editing());
    assert!(harness.query_by_label("erase").is_none());
}

#[test]
fn the_list_of_steps_goes_where_it_is_clicked() {
    let mut harness = with_two_steps();
    assert!(harness.query_by_label_contains(" MB of 256.0 MB").is_some());
    click(&mut harness, "as it was opened");
    steps(&mut harness, 0, 2);
    click(&mut harness, "2. place +1 voxel");
    steps(&mut harness, 2, 0);
    click(&mut harness, "1. place +1 voxel");
    steps(&mut harness, 1, 1);
    click(&mut harness, "redo");
    steps(&mut harness, 2, 0);
    click(&mut harness, "undo");
    steps(&mut harness, 1, 1);
    assert!(harness.query_by_label("not saved yet").is_some());
    click(&mut harness, "as it was opened");
    steps(&mut harness, 0, 2);
    assert!(harness.query_by_label("not saved yet").is_none(), "nothing is to be saved");
}

#[test]
fn the_question_about_unsaved_edits_saves_loses_them_or_stays() {
    let mut harness = with_two_steps();
    let ask = |harness: &mut Harness<Session>| {
        harness.state_mut().take_commands();
        assert!(!harness.state_mut().may_leave(Leaving::Load("city".into())));
        harness.run_steps(3);
    };
    ask(&mut harness);
    click(&mut harness, "Cancel");
    assert_eq!((harness.state().leaving.clone(), harness.state_mut().take_commands()), (None, vec![]));
    ask(&mut harness);
    click(&mut harness, "Save");
    let session = harness.state_mut();
    assert!(session.dialog.is_some(), "where to, is asked first");
    assert_eq!(session.leaving, Some(Leaving::Load("city".into())), "and then it is opened");
    session.act(voxtrace_viewer::keys::Action::Cancel, None);
    assert_eq!((session.dialog.is_none(), session.leaving.clone()), (true, None));
    ask(&mut harness);
    click(&mut harness, "Open without saving");
    assert_eq!(harness.state_mut().take_commands(), [Command::Load("city".into())]);
}

/// The lines that the panels drew, in points.
fn drawn(harness: &Harness<Session>) -> Vec<[egui::Pos2; 2]> {
    let shapes = harness.output().shapes.iter();
    shapes
        .filter_map(|clipped| match &clipped.shape {
            egui::Shape::LineSegment { points, .. } => Some(*points),
            _ => None,
        })
        .collect()
}

#[test]
fn the_preview_lies_where_the_picture_shows_the_voxel_whatever_the_scale_of_the_screen() {
    for scale in [1.0, 2.0] {
        let mut hand = Hand::on(in_room("room.vxt"));
        hand.session.editing.as_mut().unwrap().symmetry.axes = [true, false, false];
        let cursor = hand.place(floor(3, 4));
        hand.session.hover = Some(cursor);
        let show = |ui: &mut egui::Ui, session: &mut Session| {
            session.has_panels = false;
            voxtrace_viewer::panels::show(ui, session, &Status::default());
        };
        let size = hand.session.size();
        let mut harness = Harness::builder()
            .with_size([size.0 as f32 / scale, size.1 as f32 / scale])
            .with_pixels_per_point(scale)
            .build_ui_state(show, hand.session);
        harness.run_steps(2);
        let session = harness.state();
        let projection = Projection::new(session.navigator.camera(), session.size());
        let corner = |voxel: IVec3| projection.place(voxel.as_vec3()).unwrap() / scale;
        let is_drawn = |from: Vec2, to: Vec2| {
            drawn(&harness).iter().any(|[a, b]| {
                let near = |a: &egui::Pos2, b: Vec2| (a.x - b.x).abs() < 0.05 && (a.y - b.y).abs() < 0.05;
                near(a, from) && near(b, to) || near(a, to) && near(b, from)
            })
        };
        for voxel in [IVec3::new(3, 4, 1), IVec3::new(20, 4, 1)] {
            for (from, to) in [([0, 0, 0], [0, 0, 1]), ([0, 0, 1], [1, 0, 1]), ([1, 1, 0], [1, 1, 1])] {
                let (from, to) = (voxel + IVec3::from_array(from), voxel + IVec3::from_array(to));
                assert!(is_drawn(corner(from), corner(to)), "{voxel} at {scale}");
                assert!(!is_drawn(corner(from) + 1.0, corner(to) + 1.0), "the comparison sees a point");
            }
        }
        assert!(outlines(session).iter().any(|outline| outline.look == Look::Plane(0)));
        assert!(outlines(session).iter().any(|outline| outline.look == Look::Face));
    }
}

#[test]
fn each_colour_of_the_palette_is_taken_by_a_click_also_beside_the_bar_that_scrolls() {
    let mut scene = room();
    scene.materials.extend((0..200).map(|grey| Material::diffuse(Vec3::splat(grey as f32 / 255.0))));
    let mut session = in_room("room.vxt");
    session.show("room.vxt".into(), Arc::new(PackedScene::pack(&scene).unwrap()));
    let mut harness = panels(Hand::on(session).session, Status::default());
    // More than a row.
    for number in 1..=13 {
        harness.get_by_label_contains(&format!("material {number}, #")).click();
        harness.run_steps(3);
        assert_eq!(harness.state().editing.as_ref().unwrap().material, number);
    }
}
