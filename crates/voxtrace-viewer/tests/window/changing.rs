//! What is changed about a scene in the window: materials and parts, and the command that makes the same picture.

use crate::common::{SIZE, film, house, in_room, lit, said};
use std::sync::{Arc, Barrier, mpsc};
use std::time::Duration;
use voxtrace::PackedScene;
use voxtrace::changes::{MaterialChange, PartName, SceneChanges, show_parts};
use voxtrace::glam::{Vec2, Vec3};
use voxtrace::lines::{Line, Lines};
use voxtrace_viewer::keys::Action;
use voxtrace_viewer::load::Loading;
use voxtrace_viewer::render_settings::RenderSettings;
use voxtrace_viewer::session::{Command, Session};
use voxtrace_viewer::{Loader, Reading, Told, Wanted};
use voxtrace_vulkan::Traversal;

const MIDDLE: Vec2 = Vec2::new(320.0, 240.0);

fn packed_with(shown: &[PartName]) -> PackedScene {
    let mut scene = house();
    show_parts(&mut scene, shown).unwrap();
    PackedScene::pack(&scene).unwrap()
}

fn in_house() -> Session {
    let mut session = Session::new(Traversal::Cpu);
    session.resize(SIZE.0, SIZE.1);
    session.show("house.vox".into(), Arc::new(packed_with(&[])));
    session.take_commands();
    session
}

/// The options of the render command after this one, in their order.
fn values(session: &Session, option: &str) -> Vec<String> {
    let words = session.render_command().unwrap().words().unwrap();
    let pairs = words.windows(2).filter(|pair| pair[0] == option);
    pairs.map(|pair| pair[1].clone()).collect()
}

/// The scene that `render` makes of the command's words.
fn as_rendered(session: &Session) -> PackedScene {
    let parts = |option| values(session, option).iter().map(|text| text.parse().unwrap()).collect::<Vec<PartName>>();
    let materials = values(session, "--material").iter().map(|text| text.parse().unwrap()).collect();
    let changes = SceneChanges { materials, hidden: parts("--hide") };
    changes.apply(&packed_with(&parts("--show"))).unwrap()
}

#[test]
fn a_material_that_is_changed_is_traced_and_the_command_makes_the_same_film() {
    let mut session = in_house();
    let before = film(&lit(&session), &session);
    let change = MaterialChange { number: 1, base_color: Vec3::new(0.1, 0.7, 1.0 / 3.0), emission: Some(Vec3::ONE) };
    session.set_material(change);
    assert_eq!(session.take_commands(), [Command::SetScene]);
    assert_eq!(values(&session, "--material"), [change.to_string()]);
    let now = film(&lit(&session), &session);
    assert_eq!(now, film(&Arc::new(as_rendered(&session)), &session), "to the bit");
    assert_ne!(now, before, "the comparison sees a material");
    // Light and material do not undo each other.
    let mut settings = session.render_settings.clone();
    settings.light_intensity = Some(0.5);
    session.set_render_settings(settings);
    let scene = lit(&session);
    assert_eq!((scene.light_intensity, scene.materials()[1].base_color), (0.5, change.base_color));
    let original = session.open.as_ref().unwrap().original.materials()[1];
    session.set_material(MaterialChange { number: 1, base_color: original.base_color, emission: None });
    assert_eq!(values(&session, "--material"), Vec::<String>::new(), "what is the scene's own is no change");
    session.set_material(change);
    session.reset_material(1);
    assert_eq!(lit(&session).materials()[1], original);
    session.set_material(MaterialChange { number: 99, ..change });
    assert!(said(&mut session).iter().any(|line| line.contains("no material 99")), "{:?}", said(&mut session));
}

/// The house with what stands on the lattice as one grid, as files are opened.
fn in_merged_house() -> Session {
    let merged = PackedScene::pack_merged(&house()).unwrap();
    assert!(merged.is_merged() && merged.instance_count() == 2);
    let mut session = Session::new(Traversal::Cpu);
    session.resize(SIZE.0, SIZE.1);
    session.show("house.vox".into(), Arc::new(merged));
    session.take_commands();
    session
}

#[test]
fn instances_that_were_merged_are_picked_apart_and_come_apart_where_one_is_hidden() {
    let (mut session, mut kept) = (in_merged_house(), in_house());
    let (picked, expected) = (session.pick(MIDDLE).unwrap(), kept.pick(MIDDLE).unwrap());
    assert_eq!((picked.hit.instance, picked.hit.voxel), (expected.hit.instance, expected.hit.voxel));
    assert_eq!(picked.material, expected.material);
    assert_eq!(session.open.as_ref().unwrap().object_of(&picked.hit), Some(0));
    for session in [&mut session, &mut kept] {
        session.act(Action::HidePicked, Some(MIDDLE));
        assert_eq!(session.take_commands(), [Command::SetScene]);
        assert_eq!(values(session, "--hide"), ["object:kitchen"]);
    }
    assert!(!lit(&session).is_merged());
    assert_eq!(lit(&session).content_hash(), lit(&kept).content_hash());
    assert_eq!(film(&lit(&session), &session), film(&lit(&kept), &kept));
    // A material is changed whether they are merged or apart, and what is shown again is merged again.
    session.set_material("1=#102030".parse().unwrap());
    assert!(!lit(&session).is_merged());
    session.act(Action::ShowAll, None);
    assert!(lit(&session).is_merged());
    session.reset_material(1);
    assert_eq!(lit(&session).content_hash(), lit(&in_merged_house()).content_hash());
}

#[test]
fn instances_that_were_merged_come_apart_for_lines() {
    let mut session = in_merged_house();
    let with_lines = |session: &Session, lines| RenderSettings { lines, ..session.render_settings.clone() };
    let edges = Lines { edges: Some(Line { width: 0.4, color: Vec3::X }), grid: None };
    session.set_render_settings(with_lines(&session, edges));
    assert_eq!(session.take_commands(), [Command::SetScene, Command::SetView]);
    assert_eq!(lit(&session).content_hash(), packed_with(&[]).content_hash());
    let wider = Lines { edges: Some(Line { width: 0.5, color: Vec3::X }), grid: None };
    session.set_render_settings(with_lines(&session, wider));
    assert_eq!(session.take_commands(), [Command::SetView], "they are apart already");
    // A scene that is opened while there are lines comes apart at once.
    session.show("house.vox".into(), Arc::new(PackedScene::pack_merged(&house()).unwrap()));
    assert!(!lit(&session).is_merged());
    session.take_commands();
    session.set_render_settings(with_lines(&session, Lines::default()));
    assert_eq!(session.take_commands(), [Command::SetScene, Command::SetView]);
    assert!(lit(&session).is_merged());
}

#[test]
fn a_part_that_is_hidden_is_not_traced_and_the_command_says_it() {
    let mut session = in_house();
    session.act(Action::HidePicked, Some(MIDDLE));
    assert_eq!(session.take_commands(), [Command::SetScene]);
    assert_eq!(values(&session, "--hide"), ["object:kitchen"]);
    assert_eq!(lit(&session).instances().len(), 1);
    assert_eq!(film(&lit(&session), &session), film(&Arc::new(as_rendered(&session)), &session));
    session.set_visible(&[1], false);
    assert_eq!((values(&session, "--hide"), session.pick(MIDDLE)), (vec!["layer:rooms".to_owned()], None));
    session.take_commands();
    session.act(Action::ShowAll, None);
    assert_eq!((session.take_commands(), values(&session, "--hide")), (vec![Command::SetScene], vec![]));
    assert_eq!(lit(&session).instances().len(), 2, "what the file hides stays so");
    assert!(session.pick(MIDDLE).is_some());
}

/// Reads the house with the parts that are asked for, where it can.
struct House {
    has_hidden: bool,
}

impl Loader for House {
    fn load(&self, _: &str, reading: &Reading, _: Box<dyn Fn(Told) + Send>, _: &Wanted) -> Result<PackedScene, String> {
        if self.has_hidden { Ok(packed_with(&reading.shown)) } else { Err("it was not written".into()) }
    }

    fn save(&self, _: &PackedScene, path: &std::path::Path) -> Result<Vec<String>, String> {
        Err(format!("{} is not written here", path.display()))
    }

    fn built_in(&self) -> Vec<(String, String)> {
        Vec::new()
    }
}

fn read_again(session: &mut Session, house: House) {
    let (sender, receiver) = mpsc::channel();
    let (_, shown) = session.open.as_ref().unwrap().changes();
    let loader: Arc<dyn Loader> = Arc::new(house);
    let wake = Arc::new(move || sender.send(()).unwrap_or_default());
    session.loading = Some(Loading::start(&loader, "house.vox", Reading { shown, ..Reading::default() }, true, wake));
    while session.loading.is_some() {
        receiver.recv().expect("the loader ended without an answer");
        session.take_loaded();
    }
}

#[test]
fn what_cannot_be_read_stays_hidden_and_the_command_does_not_ask_for_it() {
    let mut session = in_house();
    session.set_visible(&[0], false);
    session.set_visible(&[2], true);
    assert_eq!((session.take_commands().last(), values(&session, "--show").len()), (Some(&Command::LoadAgain), 1));
    read_again(&mut session, House { has_hidden: false });
    assert_eq!(said(&mut session), ["it was not written"]);
    assert_eq!((values(&session, "--show"), values(&session, "--hide").len()), (vec![], 1));
    // And what is changed next does not ask for it once more.
    session.set_visible(&[0], true);
    assert_eq!((session.take_commands(), lit(&session).instances().len()), (vec![Command::SetScene], 2));
}

#[test]
fn what_the_file_hides_is_read_when_it_is_to_be_seen_and_all_else_stays() {
    let mut session = in_house();
    session.set_material("0=#102030".parse().unwrap());
    session.set_visible(&[0], false);
    session.act(Action::NextCamera, None);
    let camera = session.navigator.camera().clone();
    session.take_commands();
    session.set_visible(&[2], true);
    assert_eq!(session.take_commands(), [Command::LoadAgain]);
    assert_eq!(lit(&session).instances().len(), 1, "not yet");
    read_again(&mut session, House { has_hidden: true });
    assert_eq!(session.take_commands(), [Command::SetScene]);
    assert_eq!((session.navigator.camera(), values(&session, "--material").len()), (&camera, 1));
    assert_eq!(
        (values(&session, "--hide"), values(&session, "--show")),
        (vec!["object:kitchen".into()], vec!["layer:lamps".into()])
    );
    let seen: Vec<u32> = lit(&session).instances().iter().map(|instance| instance.scene_instance).collect();
    assert_eq!(seen, [1, 2]);
    assert_eq!(film(&lit(&session), &session), film(&Arc::new(as_rendered(&session)), &session));
    assert_eq!(lit(&session).content_hash(), as_rendered(&session).content_hash());
    session.set_visible(&[2], false);
    assert_eq!((values(&session, "--show"), lit(&session).instances().len()), (vec![], 1));
}

#[test]
fn another_scene_begins_without_changes() {
    let mut session = in_house();
    session.set_material("0=#102030".parse().unwrap());
    session.set_visible(&[0], false);
    session.show("house.vox".into(), Arc::new(packed_with(&[])));
    assert_eq!((values(&session, "--material"), values(&session, "--hide")), (vec![], vec![]));
    let mut room = in_room("room.vxt");
    room.act(Action::HidePicked, Some(Vec2::new(10.0, 4.0)));
    assert_eq!(room.take_commands(), [], "there is only sky");
    assert!(said(&mut room).iter().any(|line| line.contains("nothing is under the cursor")));
}

#[test]
fn changes_are_made_and_materials_found_while_the_threads_that_trace_are_busy() {
    let (mut session, scene) = (in_house(), packed_with(&[]));
    let (entered, busy) = mpsc::channel();
    let gate = Arc::new(Barrier::new(rayon::current_num_threads() + 1));
    let held = Arc::clone(&gate);
    rayon::spawn_broadcast(move |_| {
        entered.send(()).unwrap();
        held.wait();
    });
    (0..rayon::current_num_threads()).for_each(|_| busy.recv().unwrap());
    let changes = SceneChanges { materials: vec!["1=#ffffff,3".parse().unwrap()], hidden: Vec::new() };
    let (sender, among_them) = mpsc::channel();
    std::thread::spawn(move || sender.send(changes.apply(&scene).is_ok()));
    let (sender, aside) = mpsc::channel();
    std::thread::spawn(move || {
        session.set_material("1=#ffffff,3".parse().unwrap());
        while session.open.as_ref().unwrap().used_materials().is_none() {
            std::thread::yield_now();
        }
        sender.send((session.take_commands(), lit(&session).materials()[1].emission.max_element()))
    });
    let done = aside.recv_timeout(Duration::from_secs(300));
    let other = among_them.try_recv();
    gate.wait();
    assert_eq!(done, Ok((vec![Command::SetScene], 3.0)), "it waits for nobody");
    assert!(other.is_err(), "the comparison sees what waits for them");
    assert_eq!(among_them.recv(), Ok(true));
}
