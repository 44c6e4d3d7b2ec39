//! Cuts in the window: what the panel sets, what is read again for them, and the command that renders the same.

use crate::common::panel::{click, panels, set};
use crate::common::{film, in_room, lit, packed, room, said, words};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::PackedScene;
use voxtrace::cuts::Cuts;
use voxtrace::georeference::Georeference;
use voxtrace::glam::{DVec3, Vec2, Vec3};
use voxtrace::surroundings::{Fog, Ground};
use voxtrace_viewer::cutting::{Cutting, Slice};
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::load::Loading;
use voxtrace_viewer::navigation::Motion;
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::Command;
use voxtrace_viewer::surroundings::Surroundings;
use voxtrace_viewer::{Loader, Reading, Told, Wanted};

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);

/// The room, cut as `render` cuts it.
fn cut(cuts: Cuts) -> Arc<PackedScene> {
    let mut scene = (*packed()).clone();
    scene.cuts = cuts;
    Arc::new(scene)
}

#[test]
fn a_box_and_a_slice_are_set_by_sliders_and_the_film_is_that_of_render() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let whole = film(&packed(), harness.state());
    click(&mut harness, "Cuts");
    click(&mut harness, "box");
    assert_eq!(harness.state_mut().take_commands(), [Command::SetScene]);
    assert!(words(harness.state()).contains("--clip-box 0,0,0,24,24,7"), "{}", words(harness.state()));
    set(&mut harness, "z to", 4.5);
    set(&mut harness, "y from", 12.5);
    let boxed = Cuts::default().clip_box(Vec3::new(0.0, 12.5, 0.0), Vec3::new(24.0, 24.0, 4.5)).unwrap();
    let expected = film(&cut(boxed.clone()), harness.state());
    assert!(film(&lit(harness.state()), harness.state()) == expected, "to the bit");
    assert!(expected != whole, "the comparison sees the cut");
    assert!(words(harness.state()).contains("--clip-box 0,12.5,0,24,24,4.5"), "{}", words(harness.state()));

    click(&mut harness, "slice");
    click(&mut harness, "x");
    set(&mut harness, "slice at", 6.0);
    set(&mut harness, "thickness", 2.5);
    click(&mut harness, "light of the whole scene");
    let both = boxed.slice(0, 6.0, 8.5).unwrap().shadows(true);
    assert_eq!(lit(harness.state()).cuts, both);
    let now = film(&lit(harness.state()), harness.state());
    assert!(now == film(&cut(both.clone()), harness.state()), "to the bit");
    let bright = film(&cut(both.shadows(false)), harness.state());
    assert!(now != bright, "the comparison sees whose light it is");
    let line = words(harness.state());
    assert!(line.contains("--clip-box 0,12.5,0,24,24,4.5 --slice x=6,2.5 --clip-shadows"), "{line}");
    click(&mut harness, "show all of it");
    assert!(!words(harness.state()).contains("--clip") && !words(harness.state()).contains("--slice"));
    assert!(film(&lit(harness.state()), harness.state()) == whole);
    assert!(harness.query_by_role_and_label(Role::Slider, "z to").is_none());
}

#[test]
fn planes_in_any_direction_are_set_by_sliders_and_the_film_is_that_of_render() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    let whole = film(&packed(), harness.state());
    click(&mut harness, "Cuts");
    click(&mut harness, "cut by a plane");
    // The half that is nearer to the camera, which looks along +y.
    assert!(words(harness.state()).contains("--clip-plane 0,-1,0,-12"), "{}", words(harness.state()));
    let near = Cuts::default().plane(Vec3::NEG_Y, -12.0).unwrap();
    let expected = film(&cut(near), harness.state());
    assert!(film(&lit(harness.state()), harness.state()) == expected, "to the bit");
    assert!(expected != whole, "the comparison sees the cut");
    set(&mut harness, "bearing 1 °", 90.0);
    set(&mut harness, "height 1 °", 30.0);
    set(&mut harness, "plane 1 at", 14.5);
    click(&mut harness, "cut by a plane");
    let planes = harness.state().render_settings.cutting.planes.clone();
    let [(turned, offset), (second, _)] = planes[..] else { panic!("{planes:?}") };
    assert!(turned.distance(Vec3::new(0.75f32.sqrt(), 0.0, 0.5)) < 1e-6 && offset == 14.5, "{turned} {offset}");
    assert_eq!(second, Vec3::NEG_Y);
    let both = Cuts::default().plane(turned, offset).unwrap().plane(second, -12.0).unwrap();
    let now = film(&lit(harness.state()), harness.state());
    assert!(now == film(&cut(both), harness.state()), "to the bit");
    let moved = Cuts::default().plane(turned, 13.5).unwrap().plane(second, -12.0).unwrap();
    assert!(now != film(&cut(moved), harness.state()), "the comparison sees a voxel");
    let line = words(harness.state());
    assert!(line.contains("--clip-plane 0,-1,0,-12") && line.contains(",0,0.5,14.5 "), "{line}");
    click(&mut harness, "without plane 1");
    click(&mut harness, "without plane 1");
    assert!(!words(harness.state()).contains("--clip"));
    assert!(film(&lit(harness.state()), harness.state()) == whole);
    for _ in 0..6 {
        click(&mut harness, "cut by a plane");
    }
    assert!(harness.query_by_label("cut by a plane").is_none(), "`render` takes six");
}

#[test]
fn a_side_pushes_the_other_so_that_something_is_always_left() {
    let mut harness = panels(in_room("room.vxt"), Status::default());
    click(&mut harness, "Cuts");
    click(&mut harness, "box");
    set(&mut harness, "z to", 3.0);
    set(&mut harness, "z from", 5.0);
    let Some([from, to]) = harness.state().render_settings.cutting.clip_box else { panic!("a box") };
    assert!(from.z == 5.0 && to.z > 5.0 && to.z < 5.2, "{from} {to}");
    set(&mut harness, "z to", 2.0);
    let Some([from, to]) = harness.state().render_settings.cutting.clip_box else { panic!("a box") };
    assert!(to.z == 2.0 && from.z < 2.0 && from.z > 1.8, "{from} {to}");
    assert_eq!(said(harness.state_mut()), Vec::<String>::new());
}

#[test]
fn what_is_picked_is_what_is_seen_of_a_cut_scene() {
    let mut session = in_room("room.vxt");
    let before = session.pick(MIDDLE).unwrap().point;
    let slice = Some(Slice { axis: 1, from: 11.0, thickness: 2.0 });
    session.set_cutting(Cutting { slice, ..Cutting::default() });
    let after = session.pick(MIDDLE).unwrap().point;
    assert!(before.y < 9.5 && (10.9..11.1).contains(&after.y), "{before} {after}");
}

#[test]
fn a_file_without_its_inside_is_read_again_when_it_is_cut_and_closed() {
    let mut session = in_room("scan.nii");
    session.open.as_mut().unwrap().depends_on_cuts = true;
    let slice = |from| Cutting { slice: Some(Slice { axis: 2, from, thickness: 1.0 }), ..Cutting::default() };
    session.set_cutting(slice(1.0));
    assert_eq!(session.take_commands(), [Command::SetScene, Command::LoadAgain]);
    session.show_again(packed());
    assert_eq!((session.take_commands(), lit(&session).cuts.planes().len()), (vec![Command::SetScene], 2));
    session.set_cutting(slice(2.0));
    assert_eq!(session.take_commands(), [Command::SetScene], "what is inside is there by now");
    session.set_cutting(Cutting::default());
    assert_eq!(session.take_commands(), [Command::SetScene, Command::LoadAgain], "as `render` reads what is not cut");
    let mut other = in_room("room.vxt");
    other.set_cutting(slice(1.0));
    assert_eq!(other.take_commands(), [Command::SetScene], "most files are whole");
}

#[test]
fn cuts_that_were_given_hold_for_every_scene_and_those_that_cannot_be_made_are_told_of() {
    let mut session = in_room("room.vxt");
    session.given_cutting.slice = Some(Slice { axis: 2, from: 0.0, thickness: 2.0 });
    session.show("other.vxt".into(), packed());
    assert_eq!(lit(&session).cuts, Cuts::default().slice(2, 0.0, 2.0).unwrap());
    let empty = Some(Slice { axis: 2, from: 0.0, thickness: -1.0 });
    session.set_cutting(Cutting { slice: empty, ..Cutting::default() });
    assert_eq!(lit(&session).cuts, Cuts::default().slice(2, 0.0, 2.0).unwrap(), "it stays as it was");
    assert!(said(&mut session).iter().any(|line| line.contains("lowest corner")), "{:?}", said(&mut session));
    session.set_cutting(Cutting { planes: vec![(Vec3::ZERO, 1.0)], ..Cutting::default() });
    assert_eq!(lit(&session).cuts, Cuts::default().slice(2, 0.0, 2.0).unwrap(), "a plane without a normal is none");
    session.given_cutting.slice = Some(Slice { axis: 2, from: 90.0, thickness: 2.0 });
    session.show("other.vxt".into(), packed());
    assert!(said(&mut session).iter().any(|line| line.contains("nothing is left")), "{:?}", said(&mut session));
}

/// Gives the room in voxels half as large, somewhere else.
struct Finer;

impl Loader for Finer {
    fn load(&self, _: &str, _: &Reading, _: Box<dyn Fn(Told) + Send>, _: &Wanted) -> Result<PackedScene, String> {
        Ok((*on_the_map(90.0, 0.25)).clone())
    }

    fn save(&self, _: &PackedScene, path: &Path) -> Result<Vec<String>, String> {
        Err(path.display().to_string())
    }

    fn built_in(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

/// The room with its lowest corner at a place of the map, in voxels of a size.
fn on_the_map(at: f64, size: f64) -> Arc<PackedScene> {
    let mut scene = room();
    scene.voxel_size = size;
    scene.georeference = Some(Georeference::of_grid(DVec3::splat(at), size, ""));
    Arc::new(PackedScene::pack(&scene).unwrap())
}

#[test]
fn cuts_surroundings_bookmarks_and_the_timeline_stay_in_their_place_where_the_voxels_have_another_size() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("a.laz").display().to_string();
    let mut session = in_room(&source);
    session.show(source.clone(), on_the_map(100.0, 0.5));
    let clip_box = Some([Vec3::ONE, Vec3::splat(5.0)]);
    session.set_cutting(Cutting { clip_box, ..Cutting::default() });
    let surroundings = &mut session.render_settings.surroundings;
    surroundings.ground = Some(Ground { height: Some(1.0), color: Vec3::ONE });
    surroundings.fog = Some(Fog { density: 0.5, color: Vec3::ONE, anisotropy: 0.0 });
    session.act(Action::Timeline, None);
    session.add_time_key();
    session.act(Action::StoreBookmark(1), None);
    let camera = session.timeline.course.keys[0].camera.clone();
    let loader: Arc<dyn Loader> = Arc::new(Finer);
    session.loading = Some(Loading::start(&loader, &source, Reading::default(), true, Arc::new(|| {})));
    let start = Instant::now();
    while session.loading.is_some() {
        assert!(start.elapsed() < Duration::from_secs(300));
        std::thread::sleep(Duration::from_millis(1));
        session.take_loaded();
    }
    assert_eq!(session.render_settings.cutting.clip_box, Some([Vec3::splat(42.0), Vec3::splat(50.0)]));
    assert!(words(&session).contains("--clip-box 42,42,42,50,50,50"), "{}", words(&session));
    let Surroundings { ground, fog } = session.render_settings.surroundings;
    assert_eq!(ground.unwrap().height, Some(42.0));
    assert!((fog.unwrap().density - 0.25).abs() < 1e-6, "{fog:?}");
    let moved = &session.timeline.course.keys[0].camera;
    assert_eq!(moved.eye, camera.eye * 2.0 + Vec3::splat(40.0));
    assert_eq!(moved.eye, session.navigator.camera().eye, "as the camera of the picture");
    let eye = moved.eye;
    session.move_by(Motion::Orbit { delta: (60.0, 10.0).into(), pivot: None });
    assert_ne!(session.navigator.camera().eye, eye);
    session.act(Action::GoToBookmark(1), None);
    assert_eq!(session.navigator.camera().eye, eye);
}
