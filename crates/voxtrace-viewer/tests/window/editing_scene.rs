//! What becomes of a scene that is edited: its copies, its light, its materials, and what would lose its edits.

use crate::common::hand::{Hand, differing, floor, in_the_room};
use crate::common::{film, house, in_room, lit, rendered, said, words};
use std::sync::Arc;
use voxtrace::glam::{DVec3, IVec3, Vec3};
use voxtrace::normals::Normals;
use voxtrace::surroundings::Ground;
use voxtrace::{PackedScene, VoxelGrid};
use voxtrace_viewer::editing::recovery::{Left, Note};
use voxtrace_viewer::keys::{Action, Key, Modifiers};
use voxtrace_viewer::measuring::{Kind, Measure};
use voxtrace_viewer::render_settings::RenderSettings;
use voxtrace_viewer::session::{Command, Leaving, Session};
use voxtrace_viewer::surroundings::Surroundings;

/// A hand on the house, whose second room is the first one's model where they are `shared`.
fn in_the_house(is_shared: bool) -> Hand {
    let mut session = in_room("house.vox");
    let mut scene = house();
    if is_shared {
        scene.instances[1].grid = 0;
    }
    session.show("house.vox".into(), Arc::new(PackedScene::pack_merged(&scene).unwrap()));
    Hand::on(session)
}

#[test]
fn merged_instances_come_apart_before_they_are_edited() {
    let mut hand = in_the_house(false);
    assert!(hand.asked.contains(&Command::SetScene) && !lit(&hand.session).is_merged());
    let before = hand.voxels();
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    assert_eq!(differing(&before, &hand.voxels()), [IVec3::new(3, 4, 1)]);
    assert_eq!(hand.session.copies_of(0), 1, "the second room is a model of its own");
}

#[test]
fn all_copies_of_a_model_change_and_what_is_hidden_stays_so() {
    let mut hand = in_the_house(true);
    assert_eq!(hand.session.copies_of(0), 2);
    // The second room is hidden: what traces gets patches without it, also where bounds change.
    hand.session.set_visible(&[1], false);
    hand.session.editing.as_mut().unwrap().brush.size = 9;
    hand.click(Vec3::new(12.0, 12.0, 7.0));
    hand.steps(1, 0);
    let open = hand.session.open.as_ref().unwrap();
    assert_eq!((open.lit.instances().len(), open.original.instances().len()), (1, 2));
    let placement = hand.patches.last().unwrap().placement.as_ref().expect("the bounds have grown");
    assert_eq!(placement.instances().len(), 1);
    hand.session.set_visible(&[1], true);
    assert_eq!(lit(&hand.session).instances().len(), 2, "and it has the edit, too");
    assert_eq!(lit(&hand.session).content_hash(), hand.session.open.as_ref().unwrap().original.content_hash());
}

#[test]
fn a_scene_with_smooth_normals_says_in_one_line_why_it_is_not_edited() {
    let mut session = in_room("room.vxt");
    let smooth = PackedScene::pack(&crate::common::room()).unwrap().with_normals(Normals::Smooth).unwrap();
    session.show("room.vxt".into(), Arc::new(smooth));
    let mut hand = Hand::on(session);
    assert!(hand.session.editing.is_none());
    let lines = said(&mut hand.session);
    assert_eq!(
        lines,
        ["the scene cannot be edited: edits do not follow smooth normals: open it with --normals faces to edit it"]
    );
}

#[test]
fn the_film_of_an_edited_scene_is_that_of_the_scene_from_scratch_also_in_another_light() {
    let mut hand = in_the_room();
    hand.take_material(1);
    hand.session.editing.as_mut().unwrap().brush.size = 7;
    hand.drag(&[floor(3, 3), floor(10, 5), floor(20, 20)]);
    hand.steps(1, 0);
    hand.settle();
    let mut settings = hand.session.render_settings.clone();
    settings.sky_brightness = Some(0.5);
    hand.session.set_render_settings(settings);
    let frame = hand.session.view().frame().size(40, 30).samples(2);
    let edited = lit(&hand.session);
    let mut scratch = (*edited).to_scene();
    let of = |scene: &voxtrace::Scene| rendered(&Arc::new(PackedScene::pack(scene).unwrap()), &frame);
    let film = rendered(&edited, &frame);
    assert_eq!(film, of(&scratch));
    Arc::make_mut(&mut scratch.grids[0]).set(IVec3::new(1, 1, 3), 0);
    assert_ne!(film, of(&scratch), "the comparison sees a voxel");
}

#[test]
fn a_colour_that_is_changed_among_edits_keeps_undo_and_what_glows_begins_it_anew() {
    let mut hand = in_the_room();
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    let state = hand.session.editing.as_ref().unwrap().state();
    let original = |session: &Session| session.open.as_ref().unwrap().original.materials().to_vec();
    for color in ["#203040", "#405060", "#ff8000"] {
        hand.session.set_material(format!("0={color}").parse().unwrap());
    }
    let wanted: voxtrace::changes::MaterialChange = "0=#ff8000".parse().unwrap();
    assert_eq!(hand.session.material(0).unwrap().base_color, wanted.base_color, "at once");
    hand.until("the colour", |session| original(session)[0].base_color == wanted.base_color);
    assert_ne!(hand.session.editing.as_ref().unwrap().state(), state, "it is an edit");
    assert!(!hand.asked.contains(&Command::SetScene), "what traces takes a patch");
    hand.ctrl('Z');
    hand.steps(0, 1);
    hand.session.set_material("1=#ff0000,5".parse().unwrap());
    hand.until("the lamp", |session| original(session)[1].emission.max_element() == 5.0);
    assert!(hand.asked.contains(&Command::SetScene));
    hand.steps(0, 0);
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), None);
    hand.click(floor(5, 5));
    hand.steps(1, 0);
    assert!(hand.session.has_unsaved_edits());
    let edited = lit(&hand.session);
    let scratch = Arc::new(PackedScene::pack(&edited.to_scene()).unwrap());
    let frame = hand.session.view().frame().size(40, 30).samples(2);
    assert_eq!(rendered(&edited, &frame), rendered(&scratch, &frame), "with the light of the lamp");
}

#[test]
fn a_new_material_is_the_current_one_and_what_is_placed_is_of_it() {
    let mut hand = in_the_room();
    hand.session.add_material(voxtrace::Material::from_srgb([1, 200, 30]).glowing(3.0));
    hand.until("the material", |session| session.editing.as_ref().unwrap().material == 2);
    assert!(!hand.session.has_unsaved_edits(), "nothing is of it yet");
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), Some(2));
    assert!(lit(&hand.session).materials()[2].emission.max_element() > 1.5);
    hand.ctrl('Z');
    hand.steps(0, 1);
}

#[test]
fn what_has_unsaved_edits_is_left_only_after_a_question_and_no_command_renders_it() {
    let mut hand = in_the_room();
    assert!(hand.session.may_leave(Leaving::Quit));
    assert!(words(&hand.session).contains("room.vxt"));
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    assert!(!hand.session.may_leave(Leaving::Load("city".into())));
    assert_eq!(hand.session.leaving, Some(Leaving::Load("city".into())));
    hand.key(Modifiers::NONE, Key::Escape);
    assert_eq!((hand.session.leaving.clone(), hand.session.is_editing()), (None, true), "Esc stays");
    assert!(hand.session.render_command().is_none());
    hand.session.act(Action::CopyCommand, None);
    assert!(said(&mut hand.session).last().unwrap().contains("save it first"));
    assert!(!hand.session.may_leave(Leaving::Quit));
    hand.session.discard_and_leave();
    assert_eq!(hand.session.take_commands(), [Command::Quit]);
    assert!(hand.session.may_leave(Leaving::Quit), "once is enough");
}

#[test]
fn what_a_vox_file_does_not_keep_is_said_when_it_is_written() {
    let mut hand = in_the_room();
    let path = std::path::Path::new("/x/room-2.vox");
    hand.session.begin_saving(path);
    assert_eq!(said(&mut hand.session), Vec::<String>::new());
    let mut scene = crate::common::room();
    Arc::make_mut(&mut scene.grids[0]).set(IVec3::new(300, 0, 0), 0);
    scene.materials.resize(300, voxtrace::Material::default());
    hand.session.show("room.vxt".into(), Arc::new(PackedScene::pack(&scene).unwrap()));
    hand.session.begin_saving(path);
    assert_eq!(
        said(&mut hand.session),
        [
            "a .vox file has 255 colours: 300 materials become as many",
            "models of a .vox file have at most 256 voxels across: 1 model will be in parts"
        ]
    );
}

#[test]
fn edits_that_were_saved_are_told_from_later_ones_and_ctrl_s_writes_them_there_again() {
    let mut hand = in_the_room();
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    hand.ctrl('S');
    assert!(hand.session.dialog.is_some(), "the first time it asks");
    hand.session.act(Action::Cancel, None);
    let path = std::path::PathBuf::from("/x/room-2.vxt");
    hand.session.begin_saving(&path);
    // Meanwhile somebody goes on.
    hand.click(floor(6, 4));
    hand.steps(2, 0);
    hand.session.end_saving(true);
    assert!(hand.session.has_unsaved_edits(), "the second edit is not in the file");
    assert!(hand.session.render_command().is_none());
    hand.ctrl('Z');
    hand.steps(1, 1);
    assert!(!hand.session.has_unsaved_edits());
    assert!(words(&hand.session).contains("/x/room-2.vxt"), "{}", words(&hand.session));
    hand.key(Modifiers::CTRL_SHIFT, Key::Letter('Z'));
    hand.steps(2, 0);
    hand.asked.clear();
    hand.ctrl('S');
    assert_eq!(hand.asked, [Command::SaveScene(path)]);
    hand.session.begin_saving(std::path::Path::new("/y/none.vxt"));
    hand.session.end_saving(false);
    assert!(hand.session.has_unsaved_edits(), "what could not be written is not saved");
}

#[test]
fn a_recovery_file_is_due_a_minute_after_an_edit_and_not_for_what_is_saved() {
    use std::time::{Duration, Instant};
    let mut hand = in_the_room();
    let start = Instant::now();
    let minutes = |count: f64| start + Duration::from_secs_f64(count * 60.0);
    assert!(hand.session.recovery_due(start).is_none() && hand.session.recovery_due(minutes(2.0)).is_none());
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    assert!(hand.session.recovery_due(minutes(3.0)).is_none(), "not at once");
    let (scene, note) = hand.session.recovery_due(minutes(4.1)).expect("after a minute");
    assert_eq!((scene.content_hash(), note.source.as_str()), (lit(&hand.session).content_hash(), "room.vxt"));
    assert!(hand.session.recovery_due(minutes(9.0)).is_none(), "nothing was edited since");
    hand.click(floor(6, 4));
    hand.steps(2, 0);
    assert!(hand.session.recovery_due(minutes(9.1)).is_some());
    hand.session.begin_saving(std::path::Path::new("/x/room-2.vxt"));
    hand.session.end_saving(true);
    assert!(hand.session.recovery_due(minutes(20.0)).is_none());
}

#[test]
fn a_ground_around_an_edited_scene_is_made_anew_when_a_stroke_ends() {
    let mut hand = in_the_room();
    let surroundings =
        Surroundings { ground: Some(Ground { height: None, color: Vec3::splat(0.2) }), ..Surroundings::default() };
    let settings = RenderSettings { surroundings, ..hand.session.render_settings.clone() };
    hand.session.set_render_settings(settings);
    hand.carry_out();
    let is_made = |session: &Session| !session.is_surrounding() && lit(session).grids().len() > 1;
    hand.until("the ground", is_made);
    hand.patches.clear();
    let before = film(&lit(&hand.session), &hand.session);
    hand.session.editing.as_mut().unwrap().brush.size = 9;
    hand.drag(&[floor(3, 4), floor(12, 3)]);
    hand.steps(1, 0);
    hand.settle();
    hand.until("the ground", is_made);
    let open = hand.session.open.as_ref().unwrap();
    let expected = Arc::new(surroundings.around(&open.pickable).unwrap());
    let now = film(&lit(&hand.session), &hand.session);
    assert_eq!(now, film(&expected, &hand.session));
    assert_ne!(now, before, "the comparison sees the stroke");
    assert!(hand.patches.is_empty(), "a patch of the scene alone is none of the scene on its ground");
}

#[test]
fn a_new_scene_takes_its_first_voxels_on_the_walls_of_its_box_and_has_a_file_once_it_is_saved() {
    let mut session = in_room("room.vxt");
    session.show_new([16, 12, 8]);
    let mut hand = Hand::at(session);
    let open = hand.session.open.as_ref().unwrap();
    assert_eq!((open.voxels, open.original.materials().len()), (0, 255));
    assert!(hand.session.is_editing() && !hand.session.has_unsaved_edits());
    let blank = film(&lit(&hand.session), &hand.session);
    // On the floor, on the wall behind, and on what is there.
    let (one, behind, above) = (IVec3::new(7, 6, 0), IVec3::new(3, 11, 4), IVec3::new(7, 6, 1));
    hand.click(Vec3::new(7.5, 6.5, 0.0));
    hand.steps(1, 0);
    hand.click(Vec3::new(3.5, 12.0, 4.5));
    hand.click(Vec3::new(7.5, 6.5, 1.0));
    hand.steps(3, 0);
    assert_eq!(differing(&VoxelGrid::new(), &hand.voxels()).len(), 3);
    assert!([one, behind, above].into_iter().all(|voxel| hand.material_at(voxel) == Some(16)));
    let packed = Arc::new(PackedScene::pack(&lit(&hand.session).to_scene()).unwrap());
    let built = film(&lit(&hand.session), &hand.session);
    assert!(built != blank && built == film(&packed, &hand.session), "it is the scene as it is packed from scratch");
    // Taken back, nothing is there, and it goes on from there.
    hand.session.travel(3, true);
    hand.steps(0, 3);
    assert_eq!(hand.session.open.as_ref().unwrap().voxels, 0);
    assert!(film(&lit(&hand.session), &hand.session) == blank);
    hand.session.travel(1, false);
    hand.steps(1, 2);
    assert_eq!(hand.material_at(one), Some(16));
    // No file holds it: there is no command, and no place for bookmarks.
    assert!(hand.session.bookmark_path().is_none() && hand.session.has_unsaved_edits());
    hand.session.act(Action::CopyCommand, None);
    assert!(said(&mut hand.session).join(" ").contains("save it first"));
    let path = std::env::temp_dir().join("built.vxt");
    hand.session.begin_saving(&path);
    hand.session.end_saving(true);
    assert!(hand.session.bookmark_path().unwrap().starts_with(std::env::temp_dir()));
    assert!(words(&hand.session).contains("built.vxt"), "{}", words(&hand.session));
}

/// A hand on edits that a window left behind of a scene.
fn recovered(source: &str, scene: &voxtrace::Scene) -> Hand {
    let mut session = in_room("room.vxt");
    let path = std::env::temp_dir().join("recovery").join("1.vxt");
    let note = Note { name: scene.name.clone(), source: source.into(), saved_to: None };
    session.recover(Left { note, scene: path.clone(), written: None });
    session.take_commands();
    session.show(path.display().to_string(), Arc::new(PackedScene::pack(scene).unwrap()));
    assert_eq!(session.open.as_ref().unwrap().source, source);
    Hand::at(session)
}

#[test]
fn recovered_edits_are_not_lost_to_the_file_that_they_were_made_of() {
    let mut hand = recovered("/x/house.vox", &house());
    assert!(hand.session.has_unsaved_edits());
    hand.asked.clear();
    // The lamp is hidden in the file, and only there.
    hand.session.set_visible(&[2], true);
    hand.carry_out();
    assert!(!hand.asked.contains(&Command::LoadAgain), "{:?}", hand.asked);
    assert!(said(&mut hand.session).last().unwrap().contains("show it before the first edit"));
}

#[test]
fn a_recovered_scene_without_a_file_has_no_place_until_it_is_saved() {
    let mut hand = recovered("untitled", &crate::common::room());
    assert!(hand.session.bookmark_path().is_none());
    hand.session.act(Action::CopyCommand, None);
    assert!(said(&mut hand.session).join(" ").contains("save it first"));
    let path = std::env::temp_dir().join("recovered.vxt");
    hand.session.begin_saving(&path);
    hand.session.end_saving(true);
    assert_eq!(hand.session.open.as_ref().unwrap().source, path.display().to_string());
}

#[test]
fn what_was_measured_in_a_new_scene_is_kept_once_it_is_saved() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = in_room("room.vxt");
    session.show_new([16, 12, 8]);
    let mut hand = Hand::at(session);
    hand.click(Vec3::new(7.5, 6.5, 0.0));
    hand.steps(1, 0);
    let points = vec![DVec3::ZERO, DVec3::X];
    let measure = Measure { name: "edge".into(), is_hidden: false, kind: Kind::Distance, points, component: None };
    hand.session.measuring.list.insert(1, measure.clone());
    hand.session.begin_saving(&folder.path().join("built.vxt"));
    hand.session.end_saving(true);
    assert_eq!(hand.session.measuring.list[&1], measure);
    let kept = std::fs::read_to_string(folder.path().join("built.measurements.toml")).unwrap();
    assert!(kept.contains("edge"), "{kept}");
}
