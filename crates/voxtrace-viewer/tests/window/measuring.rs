//! Measuring in the window: what clicks find, what is kept, and what is drawn over the picture.

use crate::common::panel::{click as press, panels};
use crate::common::{in_room, said};
use egui_kittest::kittest::Queryable;
use std::time::{Duration, Instant};
use voxtrace::glam::{DVec3, Vec2, Vec3};
use voxtrace_viewer::cutting::{Cutting, Slice};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, Key};
use voxtrace_viewer::measuring::{Kind, Measure, Snap};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::Session;

/// The pixel at which the picture shows a point.
fn pixel(session: &Session, point: [f32; 3]) -> Vec2 {
    session.projection().place(Vec3::from(point)).unwrap()
}

fn click(input: &mut Input, session: &mut Session, at: Vec2) {
    input.move_to(at, session);
    input.press(Button::Left, session);
    input.release(Button::Left, session);
}

fn tap(input: &mut Input, session: &mut Session, key: Key) {
    input.key(key, true, false, session);
    input.key(key, false, false, session);
}

fn first(session: &Session, number: u32) -> f64 {
    session.measuring.list[&number].values()[0].number
}

/// A session in the room, in a folder of its own, that measures.
fn measuring(kind: Kind) -> (tempfile::TempDir, Session, Input) {
    let folder = tempfile::tempdir().unwrap();
    let mut session = in_room(&folder.path().join("room.vxt").display().to_string());
    session.choose_tool(Some(kind));
    (folder, session, Input::default())
}

#[test]
fn a_click_near_a_corner_takes_the_corner_and_two_are_a_distance_that_is_kept() {
    let (folder, mut session, mut input) = measuring(Kind::Distance);
    // Upper corners of the block's front, which is at y = 9.
    let (left, right) = (pixel(&session, [9.0, 9.0, 7.0]), pixel(&session, [15.0, 9.0, 7.0]));
    click(&mut input, &mut session, left + Vec2::new(3.0, 3.0));
    assert_eq!(session.measuring.points, [DVec3::new(9.0, 9.0, 7.0)]);
    click(&mut input, &mut session, right + Vec2::new(-3.0, 3.0));
    assert_eq!((session.measuring.points.len(), first(&session, 1)), (0, 6.0));
    assert_eq!(session.picked, None, "while one measures nothing is picked");
    assert!(folder.path().join("room.measurements.toml").exists(), "{:?}", said(&mut session));
    let other = in_room(&folder.path().join("room.vxt").display().to_string());
    assert_eq!(other.measuring.list, session.measuring.list, "another window finds it");
    session.delete_measure(1);
    assert!(in_room(&folder.path().join("room.vxt").display().to_string()).measuring.list.is_empty());
}

#[test]
fn points_snap_to_what_was_chosen() {
    let (_folder, session, _) = measuring(Kind::Distance);
    // A little beside the lower left corner of the voxel 9, 9, 6 in the block's front.
    let cursor = pixel(&session, [9.3, 9.0, 6.4]);
    let session = std::cell::RefCell::new(session);
    let at = |snap: Snap| {
        session.borrow_mut().measuring.snap = snap;
        session.borrow().point_under(cursor).unwrap().point
    };
    assert_eq!(at(Snap::Corner), DVec3::new(9.0, 9.0, 6.0));
    assert!(at(Snap::Edge).distance(DVec3::new(9.0, 9.0, 6.4)) < 1e-2, "{}", at(Snap::Edge));
    assert_eq!(at(Snap::FaceCentre), DVec3::new(9.5, 9.0, 6.5));
    assert_eq!(at(Snap::VoxelCentre), DVec3::new(9.5, 9.5, 6.5));
    assert!(at(Snap::Face).distance(DVec3::new(9.3, 9.0, 6.4)) < 1e-2);
    assert_ne!(at(Snap::Face), at(Snap::FaceCentre));
}

#[test]
fn on_the_face_of_a_cut_points_snap_to_where_the_plane_meets_the_voxel() {
    let (_folder, mut session, _) = measuring(Kind::Distance);
    let slice = Some(Slice { axis: 1, from: 11.5, thickness: 2.0 });
    session.set_cutting(Cutting { slice, ..Cutting::default() });
    session.measuring.snap = Snap::Corner;
    let point = session.point_under(pixel(&session, [10.2, 11.5, 4.3])).unwrap().point;
    assert!(point.distance(DVec3::new(10.0, 11.5, 4.0)) < 1e-4, "{point}");
    session.measuring.snap = Snap::FaceCentre;
    let point = session.point_under(pixel(&session, [10.2, 11.5, 4.3])).unwrap().point;
    assert!(point.distance(DVec3::new(10.5, 11.5, 4.5)) < 1e-4, "{point}");
}

#[test]
fn what_is_counted_comes_while_the_panels_are_hidden_too() {
    let (_folder, mut session, mut input) = measuring(Kind::Component);
    let at = pixel(&session, [12.5, 9.0, 4.5]);
    click(&mut input, &mut session, at);
    session.has_panels = false;
    let mut harness = panels(session, Status::default());
    let start = Instant::now();
    while harness.state().measuring.flood.is_some() {
        assert!(start.elapsed() < Duration::from_secs(300));
        std::thread::sleep(Duration::from_millis(1));
        harness.run_steps(1);
    }
    // The block stands on the floor.
    assert_eq!(first(harness.state(), 1), f64::from(6 * 6 * 6 + 24 * 24));
}

#[test]
fn a_path_ends_with_a_double_click_an_area_at_its_first_corner_or_by_a_key() {
    let (_folder, mut session, mut input) = measuring(Kind::Path);
    let pixels = [[9.2, 9.0, 6.8], [14.8, 9.0, 6.8]].map(|point| pixel(&session, point));
    pixels.into_iter().for_each(|at| click(&mut input, &mut session, at));
    let far = pixel(&session, [14.6, 14.6, 7.0]);
    click(&mut input, &mut session, far);
    assert_eq!(session.measuring.points.len(), 3);
    input.press(Button::Left, &mut session);
    input.double_click(&mut session);
    input.release(Button::Left, &mut session);
    assert_eq!((session.measuring.points.len(), first(&session, 1)), (0, 12.0), "{:?}", session.measuring.list);

    session.choose_tool(Some(Kind::Area));
    session.measuring.snap = Snap::Corner;
    let inside = [[9.2, 9.2, 7.0], [14.8, 9.2, 7.0], [14.8, 14.8, 7.0]].map(|point| pixel(&session, point));
    for at in inside.into_iter().chain([inside[0]]) {
        click(&mut input, &mut session, at);
    }
    assert_eq!((session.measuring.points.len(), first(&session, 2)), (0, 18.0), "half of the top");
    for at in inside {
        click(&mut input, &mut session, at);
    }
    tap(&mut input, &mut session, Key::Enter);
    assert_eq!(first(&session, 3), 18.0);
    click(&mut input, &mut session, inside[0]);
    tap(&mut input, &mut session, Key::Enter);
    assert_eq!(session.measuring.points.len(), 1, "one corner is no area");
    tap(&mut input, &mut session, Key::Escape);
    assert_eq!((session.measuring.points.len(), session.measuring.tool), (0, Some(Kind::Area)), "points first");
    tap(&mut input, &mut session, Key::Escape);
    assert_eq!(session.measuring.tool, None);
    click(&mut input, &mut session, inside[0]);
    assert!(session.picked.is_some(), "and clicks pick again");
}

#[test]
fn the_volume_of_what_was_clicked_comes_from_a_thread_also_where_the_scene_is_cut_open() {
    let (_folder, mut session, mut input) = measuring(Kind::Component);
    session.measuring.by_material = true;
    let mut count = |session: &mut Session, number: u32, at: [f32; 3]| {
        let at = pixel(session, at);
        click(&mut input, session, at);
        let start = Instant::now();
        while !session.measuring.list.contains_key(&number) {
            assert!(start.elapsed().as_secs() < 300, "nothing was counted: {:?}", said(session));
            session.take_component();
        }
        let component = session.measuring.list[&number].component.clone().unwrap();
        (component.voxels, component.exposed)
    };
    assert_eq!(count(&mut session, 1, [12.0, 9.0, 4.0]), (216, 36.0 * 5.0), "the block on its floor");
    session.measuring.by_material = false;
    assert_eq!(count(&mut session, 2, [12.0, 9.0, 4.0]).0, 216 + 576, "with the floor");
    session.measuring.by_material = true;
    let slice = Some(Slice { axis: 1, from: 11.0, thickness: 2.0 });
    session.set_cutting(Cutting { slice, ..Cutting::default() });
    assert_eq!(count(&mut session, 3, [12.0, 11.0, 4.0]), (6 * 2 * 6, (6 * 6 * 2 + 2 * 6 * 3) as f64), "of the slice");
}

#[test]
fn the_list_shows_hides_renames_exports_and_deletes() {
    let (folder, mut session, mut input) = measuring(Kind::Height);
    let ends = [pixel(&session, [9.0, 9.0, 7.0]), pixel(&session, [9.0, 9.0, 1.0])].map(|at| at + Vec2::new(3.0, 2.0));
    ends.into_iter().for_each(|at| click(&mut input, &mut session, at));
    let mut harness = panels(session, Status::default());
    assert!(harness.query_by_label("Height 1: −6 vx").is_some());
    press(&mut harness, "show Height 1");
    assert!(harness.state().measuring.list[&1].is_hidden);
    press(&mut harness, "Export as CSV");
    let csv = std::fs::read_to_string(folder.path().join("room.measurements.csv")).unwrap();
    assert!(csv.lines().nth(1).unwrap().starts_with("Height 1,height,,,,,0,-6,"), "{csv}");
    press(&mut harness, "Export as CSV");
    assert!(folder.path().join("room.measurements-2.csv").exists(), "no file is written over");
    harness.get_by_label("name of the measurement").focus();
    harness.run_steps(2);
    harness.get_by_label("name of the measurement").type_text(" of the block");
    harness.run_steps(2);
    harness.key_press(egui::Key::Enter);
    harness.run_steps(2);
    assert_eq!(harness.state().measuring.list[&1].name, "Height 1 of the block");
    let before = harness.state().navigator.camera().clone();
    press(&mut harness, "Show");
    assert_ne!(harness.state().navigator.camera(), &before);
    press(&mut harness, "Delete");
    assert!(harness.state().measuring.list.is_empty());
    harness.state_mut().act(Action::Measure, None);
    assert_eq!(harness.state().measuring.tool, None, "it was on");
    harness.state_mut().act(Action::NextTool, None);
    assert_eq!(harness.state().measuring.tool, Some(Kind::Angle));
}

#[test]
fn a_name_that_was_typed_is_kept_where_another_measurement_is_clicked() {
    let (folder, mut session, _) = measuring(Kind::Distance);
    for (number, name) in [(1, "one"), (2, "two")] {
        let points = vec![DVec3::ZERO, DVec3::X * f64::from(number)];
        let measure = Measure { name: name.into(), is_hidden: false, kind: Kind::Distance, points, component: None };
        session.measuring.list.insert(number, measure);
    }
    session.measuring.selected = Some(1);
    let mut harness = panels(session, Status::default());
    harness.get_by_label("name of the measurement").focus();
    harness.run_steps(2);
    harness.get_by_label("name of the measurement").type_text(" more");
    harness.run_steps(2);
    press(&mut harness, "two: 2 vx");
    let names: Vec<String> = harness.state().measuring.list.values().map(|measure| measure.name.clone()).collect();
    assert_eq!((harness.state().measuring.selected, names), (Some(2), vec!["one more".to_owned(), "two".to_owned()]));
    let kept = std::fs::read_to_string(folder.path().join("room.measurements.toml")).unwrap();
    assert!(kept.contains("one more"), "{kept}");
}
