//! The table of keys and gestures.

use super::Trigger::{Digits, Gesture as By};
use super::{Action, Binding, Chord, Gesture, Group, Key, Modifiers, PadButton, Steer, Trigger};
use crate::navigation::{AxisView, Mode, Movement};
use crate::text_key;

const NONE: Modifiers = Modifiers::NONE;
const CTRL: Modifiers = Modifiers::CTRL;
const SHIFT: Modifiers = Modifiers::SHIFT;
const ALT: Modifiers = Modifiers::ALT;
const FLY: Option<Mode> = Some(Mode::Fly);
const ORBIT: Option<Mode> = Some(Mode::Orbit);
const WALK: Option<Mode> = Some(Mode::Walk);

const fn key(key: Key) -> Trigger {
    with(NONE, key)
}

const fn with(modifiers: Modifiers, key: Key) -> Trigger {
    Trigger::Key(Chord { key, modifiers })
}

const fn letter(letter: char) -> Trigger {
    key(Key::Letter(letter))
}

const fn function(number: u8) -> Trigger {
    key(Key::Function(number))
}

const fn row(triggers: &'static [Trigger], action: Action, group: Group, about: &'static str) -> Binding {
    Binding { triggers, told: "", pad: None, action, group, about }
}

/// What acts by itself, for people.
const fn told(trigger: &'static str, action: Action, about: &'static str) -> Binding {
    Binding { triggers: &[], told: trigger, pad: None, action, group: Group::Others, about }
}

const fn on_pad(button: PadButton, action: Action, about: &'static str) -> Binding {
    Binding { pad: Some(button), ..told("", action, about) }
}

const fn steer(triggers: &'static [Trigger], what: Steer, about: &'static str) -> Binding {
    row(triggers, Action::Steer(what), Group::Moving, about)
}

const fn moving(triggers: &'static [Trigger], movement: Movement, about: &'static str) -> Binding {
    row(triggers, Action::Move(movement), Group::Moving, about)
}

const fn view(triggers: &'static [Trigger], view: AxisView, about: &'static str) -> Binding {
    row(triggers, Action::View(view), Group::Views, about)
}

const fn steer_view(triggers: &'static [Trigger], about: &'static str) -> Binding {
    row(triggers, Action::Steer(Steer::FieldOfView), Group::Views, about)
}

/// Everything that keys and gestures do. No trigger stands twice.
pub const TABLE: &[Binding] = &[
    moving(&[letter('W')], Movement::Forward, text_key!("keys.fly_forward_with_shift")),
    moving(&[letter('S')], Movement::Back, text_key!("keys.back")),
    moving(&[letter('A')], Movement::Left, text_key!("keys.to_the_left")),
    moving(&[letter('D')], Movement::Right, text_key!("keys.to_the_right")),
    moving(&[letter('E')], Movement::Up, text_key!("keys.up")),
    moving(&[letter('Q')], Movement::Down, text_key!("keys.down")),
    moving(&[key(Key::Left)], Movement::TurnLeft, text_key!("keys.turn_to_the_left")),
    moving(&[key(Key::Right)], Movement::TurnRight, text_key!("keys.turn_to_the_right")),
    moving(&[key(Key::Up)], Movement::TurnUp, text_key!("keys.look_up")),
    moving(&[key(Key::Down)], Movement::TurnDown, text_key!("keys.look_down")),
    row(&[letter('O')], Action::ToggleMode, Group::Moving, text_key!("keys.orbit_or_fly_what")),
    row(&[with(SHIFT, Key::Letter('O'))], Action::ToggleWalking, Group::Moving, text_key!("keys.walk_on_surfaces_up")),
    row(&[By(Gesture::DoubleClick, NONE, WALK)], Action::WalkHere, Group::Moving, text_key!("keys.walk_there")),
    steer(
        &[By(Gesture::LeftDrag, NONE, ORBIT), By(Gesture::TrackpadScroll, NONE, ORBIT)],
        Steer::Orbit,
        text_key!("keys.orbit_go_around_what"),
    ),
    steer(
        &[
            By(Gesture::LeftDrag, NONE, FLY),
            By(Gesture::LeftDrag, NONE, WALK),
            By(Gesture::RightDrag, NONE, None),
            By(Gesture::TrackpadScroll, NONE, FLY),
            By(Gesture::TrackpadScroll, NONE, WALK),
        ],
        Steer::Look,
        text_key!("keys.look_around_the_right"),
    ),
    steer(
        &[
            By(Gesture::MiddleDrag, NONE, None),
            By(Gesture::LeftDrag, SHIFT, None),
            By(Gesture::TrackpadScroll, SHIFT, None),
        ],
        Steer::Pan,
        text_key!("keys.move_sideways_what_is"),
    ),
    steer(
        &[By(Gesture::Wheel, NONE, ORBIT), By(Gesture::Wheel, CTRL, None), By(Gesture::Pinch, NONE, None)],
        Steer::Zoom,
        text_key!("keys.towards_what_is_under"),
    ),
    steer(
        &[By(Gesture::Wheel, NONE, FLY), By(Gesture::Wheel, NONE, WALK), By(Gesture::RightWheel, NONE, None)],
        Steer::Speed,
        text_key!("keys.fly_or_walk_quicker"),
    ),
    row(&[key(Key::Plus)], Action::SpeedUp, Group::Moving, text_key!("keys.fly_quicker")),
    row(&[key(Key::Minus)], Action::SpeedDown, Group::Moving, text_key!("keys.fly_slower")),
    row(&[key(Key::Home)], Action::FrameAll, Group::Views, text_key!("keys.show_the_whole_scene")),
    row(
        &[letter('F'), By(Gesture::DoubleClick, NONE, FLY), By(Gesture::DoubleClick, NONE, ORBIT)],
        Action::FramePicked,
        Group::Views,
        text_key!("keys.show_what_was_picked"),
    ),
    view(&[function(5)], AxisView::Front, text_key!("keys.from_the_front_along")),
    view(&[with(SHIFT, Key::Function(5))], AxisView::Back, text_key!("keys.from_behind")),
    view(&[function(6)], AxisView::Right, text_key!("keys.from_the_right_along")),
    view(&[with(SHIFT, Key::Function(6))], AxisView::Left, text_key!("keys.from_the_left")),
    view(&[function(7)], AxisView::Top, text_key!("keys.from_above_plus_y_upwards")),
    view(&[with(SHIFT, Key::Function(7))], AxisView::Bottom, text_key!("keys.from_below")),
    row(&[letter('L')], Action::Level, Group::Views, text_key!("keys.level_the_horizon_z")),
    steer_view(&[By(Gesture::Wheel, ALT, None)], text_key!("keys.field_of_view")),
    row(&[letter('Z')], Action::FieldOfViewDown, Group::Views, text_key!("keys.smaller_field_of_view")),
    row(&[letter('X')], Action::FieldOfViewUp, Group::Views, text_key!("keys.larger_field_of_view")),
    row(&[letter('G')], Action::FocusHere, Group::Views, text_key!("keys.focus_on_what_is")),
    row(
        &[with(CTRL, Key::Letter('Z')), with(ALT, Key::Left)],
        Action::UndoCamera,
        Group::Views,
        text_key!("keys.back_to_the_camera"),
    ),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('Z')), with(CTRL, Key::Letter('Y')), with(ALT, Key::Right)],
        Action::RedoCamera,
        Group::Views,
        text_key!("keys.forward_again_while_editing"),
    ),
    row(&[letter('N')], Action::NextCamera, Group::Views, text_key!("keys.the_scene_s_next")),
    row(&[with(SHIFT, Key::Letter('N'))], Action::PreviousCamera, Group::Views, text_key!("keys.the_scene_s_camera")),
    row(&[Digits(NONE)], Action::GoToBookmark(1), Group::Views, text_key!("keys.go_to_a_bookmark")),
    row(&[Digits(SHIFT)], Action::StoreBookmark(1), Group::Views, text_key!("keys.keep_the_camera_as")),
    row(&[function(8)], Action::Timeline, Group::Views, text_key!("keys.show_or_hide_the")),
    row(&[key(Key::Space)], Action::Play, Group::Views, text_key!("keys.play_the_timeline_or")),
    row(&[letter('C')], Action::PrintCamera, Group::Views, text_key!("keys.copy_the_camera_as")),
    row(&[key(Key::Delete)], Action::HidePicked, Group::Views, text_key!("keys.hide_the_object_that")),
    row(&[with(CTRL, Key::Delete)], Action::IsolatePicked, Group::Views, text_key!("keys.show_the_object_that")),
    row(&[with(SHIFT, Key::Letter('B'))], Action::ToggleClipBox, Group::Views, text_key!("keys.cut_open_by_a")),
    row(&[with(SHIFT, Key::Delete)], Action::ShowAll, Group::Views, text_key!("keys.show_all_objects_that")),
    row(&[function(9)], Action::Values, Group::Light, text_key!("keys.of_a_volume_dragging")),
    row(&[key(Key::PageUp)], Action::ExposureUp, Group::Light, text_key!("keys.more_exposure")),
    row(&[key(Key::PageDown)], Action::ExposureDown, Group::Light, text_key!("keys.less_exposure")),
    row(&[with(SHIFT, Key::PageUp)], Action::LightUp, Group::Light, text_key!("keys.more_light_from_what")),
    row(&[with(SHIFT, Key::PageDown)], Action::LightDown, Group::Light, text_key!("keys.less_light_from_what")),
    row(&[with(CTRL, Key::PageUp)], Action::SkyUp, Group::Light, text_key!("keys.brighter_sky")),
    row(&[with(CTRL, Key::PageDown)], Action::SkyDown, Group::Light, text_key!("keys.darker_sky")),
    row(&[letter('P')], Action::Pause, Group::Tracing, text_key!("keys.stop_tracing_or_go")),
    row(&[letter('T')], Action::NextTraversal, Group::Tracing, text_key!("keys.next_traversal")),
    row(&[letter('I')], Action::NextIntegrator, Group::Tracing, text_key!("keys.next_integrator")),
    row(&[letter('R')], Action::ToggleRealTime, Group::Tracing, text_key!("keys.real_time_light")),
    row(&[with(SHIFT, Key::Letter('R'))], Action::ToggleBareFilm, Group::Tracing, text_key!("keys.bare_film")),
    row(&[letter('B')], Action::Compare, Group::Tracing, text_key!("keys.compare_with_another_tracer")),
    row(&[letter('V')], Action::NextContrast, Group::Tracing, text_key!("keys.of_two_tracers_both")),
    row(&[letter('U')], Action::NextOtherTraversal, Group::Tracing, text_key!("keys.next_traversal_of_the")),
    row(&[letter('J')], Action::DividerLeft, Group::Tracing, text_key!("keys.the_divider_to_the")),
    row(&[letter('K')], Action::DividerRight, Group::Tracing, text_key!("keys.the_divider_to_the_right")),
    row(&[with(CTRL, Key::Letter('B'))], Action::Benchmark, Group::Tracing, text_key!("keys.measure_this_view_or")),
    row(&[function(10)], Action::Plan, Group::Tracing, text_key!("keys.play_a_benchmark_plan")),
    row(&[By(Gesture::Click, NONE, None)], Action::Pick, Group::Tracing, text_key!("keys.pick_the_voxel_what")),
    row(&[letter('M')], Action::Measure, Group::Measuring, text_key!("keys.measure_in_the_picture")),
    row(
        &[with(SHIFT, Key::Letter('M'))],
        Action::NextTool,
        Group::Measuring,
        text_key!("keys.what_is_measured_distance"),
    ),
    row(&[key(Key::Enter)], Action::FinishMeasuring, Group::Measuring, text_key!("keys.end_a_path_or")),
    row(&[with(CTRL, Key::Letter('N'))], Action::New, Group::Files, text_key!("keys.begin_an_empty_scene")),
    row(&[with(CTRL, Key::Letter('O'))], Action::Open, Group::Files, text_key!("keys.open_a_scene")),
    row(&[with(CTRL, Key::Letter('L'))], Action::OpenByPath, Group::Files, text_key!("keys.open_a_scene_by")),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('S'))],
        Action::SaveScene,
        Group::Files,
        text_key!("keys.write_the_scene_to"),
    ),
    row(&[with(CTRL, Key::Letter('S'))], Action::SaveEdits, Group::Files, text_key!("keys.save_the_edits_to")),
    row(&[with(CTRL, Key::Letter('E'))], Action::ToggleEditing, Group::Files, text_key!("keys.edit_the_voxels_or")),
    row(&[function(12)], Action::Screenshot, Group::Files, text_key!("keys.write_the_picture_to")),
    row(&[with(SHIFT, Key::Function(12))], Action::RenderPicture, Group::Files, text_key!("keys.render_a_picture_to")),
    row(&[with(CTRL, Key::Function(12))], Action::RenderFrames, Group::Files, text_key!("keys.render_a_turntable_or")),
    row(&[with(SHIFT, Key::Function(8))], Action::Record, Group::Files, text_key!("keys.record_the_timeline_to")),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('C'))],
        Action::CopyCommand,
        Group::Files,
        text_key!("keys.copy_the_command_that"),
    ),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('B'))],
        Action::CopyBenchmark,
        Group::Files,
        text_key!("keys.copy_the_command_that_measures"),
    ),
    row(&[function(1), letter('H')], Action::Help, Group::Window, text_key!("keys.this_list")),
    row(&[key(Key::Tab)], Action::TogglePanels, Group::Window, text_key!("keys.show_or_hide_the_panels")),
    row(&[function(3)], Action::ToggleTimes, Group::Window, text_key!("keys.times_of_passes")),
    row(&[function(11)], Action::ToggleFullScreen, Group::Window, text_key!("keys.full_screen")),
    row(&[with(CTRL, Key::Plus)], Action::ScaleUp, Group::Window, text_key!("keys.larger_text_and_buttons")),
    row(&[with(CTRL, Key::Minus)], Action::ScaleDown, Group::Window, text_key!("keys.smaller_text_and_buttons")),
    row(&[key(Key::Escape)], Action::Cancel, Group::Window, text_key!("keys.close_a_dialog_or")),
    row(&[with(CTRL, Key::Letter('Q'))], Action::Quit, Group::Window, text_key!("keys.quit_in_flight_ctrl_q")),
    told(text_key!("keys.one_finger_on_the"), Action::Steer(Steer::Orbit), text_key!("keys.as_the_left_button")),
    told(text_key!("keys.two_fingers_on_the"), Action::Steer(Steer::Pan), text_key!("keys.move_sideways_parting_them")),
    told(text_key!("keys.turning_two_fingers_on"), Action::Steer(Steer::Orbit), text_key!("keys.go_around_what_is")),
    told(text_key!("keys.gamepad_left_stick"), Action::Move(Movement::Forward), text_key!("keys.fly")),
    told(text_key!("keys.gamepad_right_stick"), Action::Steer(Steer::Look), text_key!("keys.look_around")),
    told(text_key!("keys.gamepad_right_trigger"), Action::Move(Movement::Up), text_key!("keys.up")),
    told(text_key!("keys.gamepad_left_trigger"), Action::Move(Movement::Down), text_key!("keys.down")),
    on_pad(PadButton::South, Action::FramePicked, text_key!("keys.show_what_is_in")),
    on_pad(PadButton::East, Action::UndoCamera, text_key!("keys.back_to_the_camera_before")),
    on_pad(PadButton::West, Action::ToggleMode, text_key!("keys.orbit_or_fly")),
    on_pad(PadButton::North, Action::FrameAll, text_key!("keys.show_the_whole_scene")),
    on_pad(PadButton::RightShoulder, Action::SpeedUp, text_key!("keys.fly_quicker")),
    on_pad(PadButton::LeftShoulder, Action::SpeedDown, text_key!("keys.fly_slower")),
    on_pad(PadButton::Right, Action::NextCamera, text_key!("keys.the_scene_s_next")),
    on_pad(PadButton::Left, Action::PreviousCamera, text_key!("keys.the_scene_s_camera")),
    on_pad(PadButton::Up, Action::ExposureUp, text_key!("keys.more_exposure")),
    on_pad(PadButton::Down, Action::ExposureDown, text_key!("keys.less_exposure")),
    on_pad(PadButton::Start, Action::TogglePanels, text_key!("keys.show_or_hide_the_panels")),
    on_pad(PadButton::Select, Action::Help, text_key!("keys.this_list")),
];
