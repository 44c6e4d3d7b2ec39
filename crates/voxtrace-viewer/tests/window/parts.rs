//! The tree of parts in the window: isolating, searching, finding the picked one, and ten thousand objects.

use crate::common::panel::{choose, click, panels};
use crate::common::{SIZE, house, in_room, said};
use egui_kittest::kittest::{NodeT, Queryable};
use std::sync::Arc;
use std::time::{Duration, Instant};
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::scene::Layer;
use voxtrace::{Material, PackedScene, Scene, Transform, VoxelGrid};
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::outliner::{Order, Part};
use voxtrace_viewer::panels::Status;
use voxtrace_viewer::session::Session;

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);

fn in_house() -> Session {
    let mut session = in_room("room.vxt");
    session.show("house.vox".into(), Arc::new(PackedScene::pack_merged(&house()).unwrap()));
    session.take_commands();
    session
}

fn seen(session: &Session) -> Vec<bool> {
    session.open.as_ref().unwrap().is_visible.clone()
}

#[test]
fn a_part_is_shown_alone_and_the_same_again_brings_the_rest_back() {
    let mut session = in_house();
    let before = seen(&session);
    assert_eq!(before, [true, true, false], "the file hides the lamp");
    session.isolate(Part::Object(1));
    assert_eq!((seen(&session), session.is_isolated()), (vec![false, true, false], true));
    session.isolate(Part::Object(0));
    assert_eq!(seen(&session), [true, false, false], "another in its place");
    session.isolate(Part::Object(0));
    assert_eq!((seen(&session), session.is_isolated()), (before.clone(), false), "what was seen at first");
    session.act(Action::IsolatePicked, Some(MIDDLE));
    assert_eq!(seen(&session), [true, false, false], "what is under the cursor: {:?}", said(&mut session));
    session.act(Action::IsolatePicked, None);
    assert_eq!(seen(&session), before);
    session.isolate(Part::Layer(0));
    assert_eq!(seen(&session), [true, true, false]);
}

#[test]
fn the_panel_searches_opens_isolates_and_finds_the_picked_one() {
    let mut harness = panels(in_house(), Status::default());
    click(&mut harness, "Parts (1 hidden)");
    assert!(harness.query_by_label("object 2").is_some());
    harness.get_by_label("search names and numbers").focus();
    harness.run_steps(2);
    harness.get_by_label("search names and numbers").type_text("kitchen");
    harness.run_steps(3);
    assert!(harness.query_by_label("object 2").is_none(), "it is not called so");
    click(&mut harness, "select object 0: kitchen");
    click(&mut harness, "show it alone");
    assert_eq!(seen(harness.state()), [true, false, false]);
    click(&mut harness, "bring the rest back");
    assert_eq!(seen(harness.state()), [true, true, false]);
    let before = harness.state().navigator.camera().clone();
    click(&mut harness, "fly there");
    assert_ne!(harness.state().navigator.camera(), &before);
    choose(&mut harness, "in the list", "models");
    assert_eq!(harness.state().outliner.order, Order::Models);
    harness.state_mut().act(Action::Pick, Some(MIDDLE));
    assert!(harness.state().picked.is_some());
    harness.run_steps(3);
    click(&mut harness, "find the picked one");
    assert_eq!(
        (harness.state().outliner.selected, harness.state().outliner.search.as_str()),
        (Some(Part::Object(0)), "")
    );
    assert!(harness.query_by_label("object 0: kitchen").is_some(), "its model is open");
}

/// Ten thousand objects of four models in a hundred layers.
fn crowd() -> PackedScene {
    let cube = |edge: i32| {
        let mut grid = VoxelGrid::new();
        (0..edge * edge).for_each(|i| _ = grid.set(IVec3::new(i % edge, i / edge, 0), 0));
        grid
    };
    let mut scene = Scene::from_grid("crowd", cube(2), vec![Material::diffuse(Vec3::ONE)]);
    scene.grids.extend((3..6).map(|edge| Arc::new(cube(edge))));
    let first = scene.instances[0].clone();
    scene.instances = (0..10_000)
        .map(|i| {
            let mut instance = first.clone();
            (instance.grid, instance.layer, instance.name) = (i % 4, Some(i / 100), format!("no. {i}"));
            instance.world_from_grid =
                Transform::from_translation(Vec3::new((i % 100) as f32, (i / 100) as f32, 0.3) * 8.5);
            instance
        })
        .collect();
    scene.layers = (0..100).map(|i| Layer { name: format!("row {i}"), ..Layer::default() }).collect();
    PackedScene::pack(&scene).unwrap()
}

#[test]
fn of_ten_thousand_objects_those_in_sight_are_made() {
    let mut session = Session::new(voxtrace_vulkan::Traversal::Cpu);
    session.resize(SIZE.0, SIZE.1);
    session.show("crowd.vxt".into(), Arc::new(crowd()));
    let mut harness = panels(session, Status::default());
    click(&mut harness, "Parts");
    assert!(harness.query_by_label("layer 0: row 0").is_some());
    assert!(harness.query_by_label("object 9999: no. 9999").is_none(), "what is in sight is made alone");
    // Counted, as times are the machine's: what is made for a frame is what one sees, also where all that is found is listed.
    let made = |harness: &egui_kittest::Harness<'_, Session>| harness.root().children_recursive().count();
    // Nor does a frame take long: one of them is quick, whatever else the machine does. All objects would take minutes here.
    let frame = |harness: &mut egui_kittest::Harness<'_, Session>| {
        let start = Instant::now();
        harness.run_steps(1);
        start.elapsed()
    };
    let patience = Instant::now() + Duration::from_secs(120);
    while frame(&mut harness) >= Duration::from_millis(800) {
        assert!(Instant::now() < patience, "no frame is quick");
    }
    assert!((50..600).contains(&made(&harness)), "{} nodes a frame", made(&harness));
    harness.state_mut().outliner.search = "no.".into();
    harness.run_steps(3);
    assert!((50..600).contains(&made(&harness)), "{} nodes a frame", made(&harness));
    let mut search = || {
        harness.state_mut().outliner.search = String::new();
        harness.run_steps(1);
        harness.state_mut().outliner.search = "no. 777".into();
        (0..3).map(|_| frame(&mut harness)).sum::<Duration>()
    };
    let patience = Instant::now() + Duration::from_secs(120);
    while search() >= Duration::from_secs(2) {
        assert!(Instant::now() < patience, "no search is quick");
    }
    assert!(harness.query_by_label("object 7770: no. 7770").is_some());
    let tree = harness.state_mut().outline_rows().unwrap();
    assert_eq!(tree.rows.iter().filter(|row| matches!(row.part, Part::Object(_))).count(), 11, "each once");
}

#[test]
fn a_picked_voxel_stays_that_of_its_object_when_others_come_and_go() {
    let mut session = in_house();
    session.picked = session.pick(session.projection().place(Vec3::new(40.0, 5.0, 1.0)).unwrap());
    let picked = session.picked.clone().unwrap();
    let object = |session: &Session| {
        let open = session.open.as_ref().unwrap();
        session.picked.as_ref().and_then(|picked| open.object_of(&picked.hit))
    };
    assert_eq!((object(&session), picked.hit.instance), (Some(1), 1));
    session.set_visible(&[0], false);
    assert_eq!(object(&session), Some(1), "it is the first one now");
    assert_eq!(session.picked.as_ref().unwrap().hit.instance, 0);
    let harness = panels(session, Status::default());
    assert!(harness.query_by_label("Picked voxel").is_some());
    let mut session = in_house();
    session.picked = Some(picked);
    session.set_visible(&[1], false);
    assert_eq!(session.picked, None, "what is hidden is not picked");
}
