//! Editing with a hand: scripts of events, and what becomes of the scene.

use crate::common::{house, in_room, lit, rendered, said, words};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::time::Duration;
use voxtrace::glam::{IVec3, Vec2, Vec3};
use voxtrace::grid::VoxelBox;
use voxtrace::normals::Normals;
use voxtrace::{PackedScene, VoxelGrid};
use voxtrace_viewer::editing::{Act, Tool};
use voxtrace_viewer::input::{Button, Input};
use voxtrace_viewer::keys::{Action, EditAction, EditAxis, Key, Modifiers};
use voxtrace_viewer::projection::Projection;
use voxtrace_viewer::session::{Command, Leaving, Session};

/// A session with a hand that edits, and what the thread that owns the scene wakes.
pub struct Hand {
    pub session: Session,
    pub input: Input,
    woken: Receiver<()>,
    wake: Arc<dyn Fn() + Send + Sync>,
    /// What was asked for, but for patches.
    pub asked: Vec<Command>,
    pub patches: Vec<Arc<voxtrace::Patch>>,
}

impl Hand {
    /// Begins to edit.
    pub fn on(mut session: Session) -> Self {
        session.take_commands();
        let (sender, woken) = channel();
        let wake: Arc<dyn Fn() + Send + Sync> = Arc::new(move || sender.send(()).unwrap_or_default());
        let (asked, patches) = (Vec::new(), Vec::new());
        let mut hand = Self { session, input: Input::default(), woken, wake, asked, patches };
        hand.session.act(Action::ToggleEditing, None);
        hand.carry_out();
        hand.until("editing", |session| session.editing.as_ref().is_none_or(|editing| editing.is_ready));
        hand
    }

    fn carry_out(&mut self) {
        for command in self.session.take_commands() {
            match command {
                Command::Edit => self.session.start_editor(Arc::clone(&self.wake)),
                Command::Follow(followed) => self.patches.push(followed.0),
                command => self.asked.push(command),
            }
        }
    }

    /// Waits until something is so.
    pub fn until(&mut self, what: &str, is_so: impl Fn(&Session) -> bool) {
        loop {
            self.session.take_edited();
            self.carry_out();
            if is_so(&self.session) {
                return;
            }
            self.woken.recv_timeout(Duration::from_secs(60)).unwrap_or_else(|_| panic!("{what} did not come"));
        }
    }

    /// Waits until there are so many steps, and so many that were undone.
    pub fn steps(&mut self, done: usize, undone: usize) {
        self.until("a step", |session| {
            let steps = &session.editing.as_ref().unwrap().steps;
            (steps.done.len(), steps.undone.len()) == (done, undone)
        });
    }

    /// Waits until all that was asked for so far is done: jobs are done in their order.
    pub fn settle(&mut self) {
        let region = VoxelBox { min: IVec3::ZERO, max: IVec3::ONE };
        let editing = self.session.editing.as_mut().unwrap();
        let (selection, clip) = (editing.selection, editing.clip.take());
        editing.selection = Some(voxtrace_viewer::editing::Selection {
            instance: 0,
            grid: 0,
            world_from_grid: voxtrace::Transform::IDENTITY,
            region,
        });
        self.session.copy_selection(false);
        self.until("a copy", |session| session.editing.as_ref().unwrap().clip.is_some());
        let editing = self.session.editing.as_mut().unwrap();
        (editing.selection, editing.clip) = (selection, clip);
    }

    pub fn key(&mut self, modifiers: Modifiers, key: Key) {
        self.input.set_modifiers(modifiers, &mut self.session);
        self.input.key(key, true, false, &mut self.session);
        self.input.key(key, false, false, &mut self.session);
        self.input.set_modifiers(Modifiers::NONE, &mut self.session);
        self.carry_out();
    }

    pub fn letter(&mut self, letter: char) {
        self.key(Modifiers::NONE, Key::Letter(letter));
    }

    pub fn ctrl(&mut self, letter: char) {
        self.key(Modifiers::CTRL, Key::Letter(letter));
    }

    /// Where the picture shows a point.
    pub fn place(&self, point: Vec3) -> Vec2 {
        Projection::new(self.session.navigator.camera(), self.session.size()).place(point).unwrap()
    }

    /// Drags over the points of the scene.
    pub fn drag(&mut self, points: &[Vec3]) {
        let places: Vec<Vec2> = points.iter().map(|&point| self.place(point)).collect();
        self.input.move_to(places[0], &mut self.session);
        self.input.press(Button::Left, &mut self.session);
        places[1..].iter().for_each(|&place| self.input.move_to(place, &mut self.session));
        self.input.release(Button::Left, &mut self.session);
        self.carry_out();
    }

    pub fn click(&mut self, point: Vec3) {
        self.drag(&[point]);
    }

    pub fn material_at(&self, voxel: IVec3) -> Option<u32> {
        let scene = &self.session.open.as_ref().unwrap().original;
        scene.geometry().material_at(&scene.grids()[0], voxel)
    }

    pub fn take_material(&mut self, material: u16) {
        self.session.editing.as_mut().unwrap().take_material(material);
    }

    /// Voxels of the first grid.
    pub fn voxels(&self) -> VoxelGrid {
        let scene = self.session.open.as_ref().unwrap().original.to_scene();
        (*scene.grids[0]).clone()
    }
}

fn in_the_room() -> Hand {
    Hand::on(in_room("room.vxt"))
}

/// The middle of the upper face of a voxel of the floor.
fn floor(x: i32, y: i32) -> Vec3 {
    Vec3::new(x as f32 + 0.5, y as f32 + 0.5, 1.0)
}

/// Voxels that differ.
fn differing(before: &VoxelGrid, after: &VoxelGrid) -> Vec<IVec3> {
    let mut all: Vec<IVec3> = before.voxels().chain(after.voxels()).map(|(voxel, _)| voxel).collect();
    all.sort_unstable_by_key(|voxel| voxel.to_array());
    all.dedup();
    all.retain(|&voxel| before.get(voxel) != after.get(voxel));
    all
}

#[test]
fn a_click_places_a_voxel_on_the_face_under_the_cursor_and_undo_takes_it_back() {
    let mut hand = in_the_room();
    assert!(hand.asked.is_empty(), "the scene as it was is the one that is edited: {:?}", hand.asked);
    let before = hand.voxels();
    hand.take_material(1);
    hand.click(floor(3, 4));
    hand.steps(1, 0);
    assert_eq!(differing(&before, &hand.voxels()), [IVec3::new(3, 4, 1)]);
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), Some(1));
    assert_eq!((hand.patches.len(), hand.session.has_unsaved_edits()), (1, true));
    hand.ctrl('Z');
    hand.steps(0, 1);
    assert_eq!(differing(&before, &hand.voxels()), []);
    assert!(!hand.session.has_unsaved_edits(), "it is as it was");
    hand.key(Modifiers::CTRL_SHIFT, Key::Letter('Z'));
    hand.steps(1, 0);
    assert_eq!(hand.material_at(IVec3::new(3, 4, 1)), Some(1));
    // The camera's undo is its own.
    let camera = hand.session.navigator.camera().clone();
    hand.key(Modifiers::ALT, Key::Left);
    assert_eq!(hand.session.navigator.camera(), &camera);
    assert!(hand.session.editing.as_ref().unwrap().steps.done.len() == 1);
}

#[test]
fn a_stroke_follows_the_surface_that_there_was_and_is_one_step() {
    let mut hand = in_the_room();
    let before = hand.voxels();
    hand.drag(&[floor(2, 3), floor(6, 3), floor(20, 3)]);
    hand.steps(1, 0);
    hand.settle();
    let expected: Vec<IVec3> = (2..=20).map(|x| IVec3::new(x, 3, 1)).collect();
    assert_eq!(differing(&before, &hand.voxels()), expected, "no gap, and nothing grows towards the eye");
    assert_eq!(hand.session.editing.as_ref().unwrap().steps.done[0].voxels, 19);
    // Erasing does not dig deeper either.
    hand.key(Modifiers::NONE, Key::Digit(2));
    hand.drag(&[floor(2, 6), floor(20, 6)]);
    hand.steps(2, 0);
    hand.settle();
    let gone = differing(&before, &hand.voxels()).into_iter().filter(|voxel| voxel.z == 0).count();
    assert_eq!(gone, 19);
    hand.ctrl('Z');
    hand.ctrl('Z');
    hand.steps(0, 2);
    assert_eq!(differing(&before, &hand.voxels()), []);
}

#[test]
fn each_tool_does_what_it_says() {
    let mut hand = in_the_room();
    let before = hand.voxels();
    // Paint with a ball, which leaves empty voxels empty.
    hand.take_material(1);
    hand.key(Modifiers::NONE, Key::Digit(3));
    (0..4).for_each(|_| hand.key(Modifiers::NONE, Key::Plus));
    assert_eq!(hand.session.editing.as_ref().unwrap().brush.size, 5);
    hand.click(floor(4, 4));
    hand.steps(1, 0);
    let painted = differing(&before, &hand.voxels());
    assert!(painted.len() == 21 && painted.iter().all(|voxel| voxel.z == 0), "{painted:?}");
    // A box, made deeper by the wheel.
    hand.key(Modifiers::NONE, Key::Digit(1));
    hand.key(Modifiers::NONE, Key::Digit(6));
    let before = hand.voxels();
    let places = [hand.place(floor(1, 18)), hand.place(floor(4, 20))];
    hand.input.move_to(places[0], &mut hand.session);
    hand.input.press(Button::Left, &mut hand.session);
    hand.input.move_to(places[1], &mut hand.session);
    hand.input.wheel(1.0, &mut hand.session);
    hand.input.wheel(1.0, &mut hand.session);
    hand.input.release(Button::Left, &mut hand.session);
    hand.steps(2, 0);
    let block = differing(&before, &hand.voxels());
    assert_eq!(block.len(), 4 * 3 * 3);
    assert!(
        block.iter().all(|voxel| VoxelBox { min: IVec3::new(1, 18, 1), max: IVec3::new(5, 21, 4) }.contains(*voxel))
    );
    // Pull the upper face of the red block by the mouse, then push it back.
    let before = hand.voxels();
    hand.key(Modifiers::NONE, Key::Digit(7));
    let top = Vec3::new(12.2, 12.2, 7.0);
    hand.drag(&[top, top + Vec3::Z * 2.0, top + Vec3::Z * 4.0]);
    hand.steps(3, 0);
    assert_eq!(differing(&before, &hand.voxels()).len(), 36 * 4);
    let top = top + Vec3::Z * 4.0;
    hand.drag(&[top, top - Vec3::Z * 4.0]);
    hand.steps(4, 0);
    assert_eq!(differing(&before, &hand.voxels()), []);
    // Fill what is connected: the floor but for the painted disc.
    hand.take_material(1);
    hand.key(Modifiers::NONE, Key::Digit(8));
    hand.click(floor(20, 2));
    hand.steps(5, 0);
    assert!(hand.voxels().voxels().filter(|(voxel, _)| voxel.z == 0).all(|(_, material)| material == 1));
    hand.ctrl('Z');
    hand.steps(4, 1);
    // Replace one material everywhere, and erase one.
    hand.take_material(0);
    hand.key(Modifiers::NONE, Key::Digit(9));
    hand.click(floor(4, 4));
    hand.steps(5, 0);
    assert!(hand.voxels().voxels().all(|(_, material)| material == 0));
    hand.session.editing.as_mut().unwrap().act = Act::Erase;
    hand.click(floor(4, 4));
    hand.steps(6, 0);
    assert_eq!(hand.voxels().voxels().count(), 0);
    hand.ctrl('Z');
    hand.steps(5, 1);
    // A line of one voxel between two places.
    let before = hand.voxels();
    hand.session.editing.as_mut().unwrap().brush.size = 1;
    hand.key(Modifiers::NONE, Key::Digit(1));
    hand.key(Modifiers::NONE, Key::Digit(5));
    hand.drag(&[floor(14, 2), floor(22, 6)]);
    hand.steps(6, 0);
    let line = differing(&before, &hand.voxels());
    assert_eq!((line.len(), line[0], line[8]), (9, IVec3::new(14, 2, 1), IVec3::new(22, 6, 1)));
    // What is under the cursor is the material from now on.
    hand.input.set_modifiers(Modifiers::ALT, &mut hand.session);
    hand.take_material(1);
    hand.click(floor(20, 2));
    assert_eq!(hand.session.editing.as_ref().unwrap().material, 0);
    assert_eq!(said(&mut hand.session).iter().filter(|line| line.contains("error")).count(), 0);
}

#[test]
fn both_sides_of_the_planes_are_edited_in_one_step() {
    let mut hand = in_the_room();
    let before = hand.voxels();
    hand.session.editing.as_mut().unwrap().symmetry.axes = [true, true, false];
    hand.drag(&[floor(3, 2), floor(5, 2)]);
    hand.steps(1, 0);
    hand.settle();
    let placed = differing(&before, &hand.voxels());
    assert_eq!(placed.len(), 12, "through the middle of the model: {placed:?}");
    for voxel in &placed {
        assert!(
            placed.contains(&IVec3::new(23 - voxel.x, voxel.y, 1))
                && placed.contains(&IVec3::new(voxel.x, 23 - voxel.y, 1))
        );
    }
    hand.ctrl('Z');
    hand.steps(0, 1);
    // Through a voxel that was picked.
    hand.session.editing.as_mut().unwrap().symmetry.axes = [true, false, false];
    hand.session.editing.as_mut().unwrap().picks_middle = true;
    hand.click(floor(6, 2));
    hand.steps(0, 1);
    hand.click(floor(8, 2));
    hand.steps(1, 0);
    assert_eq!(differing(&before, &hand.voxels()), [IVec3::new(4, 2, 1), IVec3::new(8, 2, 1)]);
}

#[test]
fn what_is_selected_is_copied_turned_pasted_moved_and_cleared() {
    let mut hand = in_the_room();
    hand.key(Modifiers::NONE, Key::Digit(6));
    hand.take_material(1);
    hand.drag(&[floor(2, 2), floor(4, 2)]);
    hand.steps(1, 0);
    let before = hand.voxels();
    hand.key(Modifiers::NONE, Key::Digit(0));
    let row = |x: i32| Vec3::new(x as f32 + 0.5, 2.5, 2.0);
    hand.drag(&[row(2), row(4)]);
    let selection = hand.session.editing.as_ref().unwrap().selection.unwrap();
    assert_eq!(selection.region, VoxelBox { min: IVec3::new(2, 2, 1), max: IVec3::new(5, 3, 2) });
    hand.ctrl('C');
    hand.until("a copy", |session| session.editing.as_ref().unwrap().clip.is_some());
    hand.ctrl('V');
    hand.key(Modifiers::NONE, Key::Letter('R'));
    hand.until("a turn", |session| {
        session.editing.as_ref().unwrap().clip.as_ref().unwrap().size() == IVec3::new(1, 3, 1)
    });
    hand.click(floor(8, 5));
    hand.steps(2, 0);
    let pasted: Vec<IVec3> = (4..7).map(|y| IVec3::new(8, y, 1)).collect();
    assert_eq!(differing(&before, &hand.voxels()), pasted);
    hand.click(floor(20, 5));
    hand.steps(3, 0);
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(hand.session.editing.as_ref().unwrap().pasting.is_none() && hand.session.is_editing());
    // Moved: gone there, and here, as one step.
    let before = hand.voxels();
    hand.letter('G');
    hand.until("a move", |session| session.editing.as_ref().unwrap().pasting.is_some());
    hand.click(floor(18, 20));
    hand.steps(4, 0);
    let moved: Vec<IVec3> = (2..5).map(|x| IVec3::new(x, 2, 1)).chain((17..20).map(|x| IVec3::new(x, 20, 1))).collect();
    assert_eq!(differing(&before, &hand.voxels()), moved);
    hand.ctrl('Z');
    hand.steps(3, 1);
    assert_eq!(differing(&before, &hand.voxels()), []);
    hand.session.editing.as_mut().unwrap().selection = Some(selection);
    hand.key(Modifiers::NONE, Key::Delete);
    hand.steps(4, 0);
    assert_eq!(differing(&before, &hand.voxels()).len(), 3);
}

#[test]
fn in_the_sky_the_hand_moves_the_camera_and_the_right_button_always_does() {
    let mut hand = in_the_room();
    hand.letter('O');
    let mut camera = hand.session.navigator.camera().clone();
    for (button, from) in [(Button::Left, Vec2::new(10.0, 4.0)), (Button::Right, Vec2::new(320.0, 240.0))] {
        hand.input.move_to(from, &mut hand.session);
        hand.input.press(button, &mut hand.session);
        hand.input.move_to(from + Vec2::new(60.0, 20.0), &mut hand.session);
        hand.input.release(button, &mut hand.session);
        let now = hand.session.navigator.camera().clone();
        assert_ne!(now, camera);
        camera = now;
    }
    hand.settle();
    assert_eq!(hand.session.editing.as_ref().unwrap().steps.done.len(), 0);
    hand.key(Modifiers::NONE, Key::Escape);
    assert!(!hand.session.is_editing());
    assert_eq!(said(&mut hand.session).last().unwrap(), "editing ended; Ctrl+E edits again");
    // Outside of editing a click picks, and Ctrl+Z is the camera's.
    hand.click(floor(3, 4));
    assert!(hand.session.picked.is_some());
    hand.ctrl('Z');
    assert_ne!(hand.session.navigator.camera(), &camera);
}

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
    assert_eq!(lit(&hand.session).materials()[2].emission.max_element() > 2.0, true);
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
fn esc_gives_up_a_box_and_the_tool_keys_choose() {
    let mut hand = in_the_room();
    let tools =
        [(4, Tool::Brush), (5, Tool::Line), (6, Tool::Box), (7, Tool::Extrude), (8, Tool::Fill), (9, Tool::Replace)];
    for (digit, tool) in tools {
        hand.key(Modifiers::NONE, Key::Digit(digit));
        assert_eq!(hand.session.editing.as_ref().unwrap().tool, tool);
    }
    hand.key(Modifiers::NONE, Key::Digit(6));
    let places = [hand.place(floor(1, 18)), hand.place(floor(4, 20))];
    hand.input.move_to(places[0], &mut hand.session);
    hand.input.press(Button::Left, &mut hand.session);
    hand.input.move_to(places[1], &mut hand.session);
    hand.key(Modifiers::NONE, Key::Escape);
    hand.input.release(Button::Left, &mut hand.session);
    hand.settle();
    assert_eq!((hand.session.editing.as_ref().unwrap().steps.done.len(), hand.session.is_editing()), (0, true));
    // Turning what is not there says so.
    hand.session.act(Action::Edit(EditAction::Turn(EditAxis::Z)), None);
    assert!(said(&mut hand.session).last().unwrap().contains("nothing is being pasted"));
}
