//! The table of keys and gestures.

use super::Trigger::{Digits, Gesture as By};
use super::{Action, Binding, Chord, Gesture, Group, Key, Modifiers, PadButton, Steer, Trigger};
use crate::navigation::{AxisView, Mode, Movement};

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
    moving(&[letter('W')], Movement::Forward, "fly forward; with Shift four times as quick, with Ctrl a quarter"),
    moving(&[letter('S')], Movement::Back, "back"),
    moving(&[letter('A')], Movement::Left, "to the left"),
    moving(&[letter('D')], Movement::Right, "to the right"),
    moving(&[letter('E')], Movement::Up, "up"),
    moving(&[letter('Q')], Movement::Down, "down"),
    moving(&[key(Key::Left)], Movement::TurnLeft, "turn to the left"),
    moving(&[key(Key::Right)], Movement::TurnRight, "turn to the right"),
    moving(&[key(Key::Up)], Movement::TurnUp, "look up"),
    moving(&[key(Key::Down)], Movement::TurnDown, "look down"),
    row(&[letter('O')], Action::ToggleMode, Group::Moving, "orbit or fly: what dragging and the wheel do"),
    row(
        &[with(SHIFT, Key::Letter('O'))],
        Action::ToggleWalking,
        Group::Moving,
        "walk on surfaces, up steps and along walls, E jumps; or fly again",
    ),
    row(&[By(Gesture::DoubleClick, NONE, WALK)], Action::WalkHere, Group::Moving, "walk there"),
    steer(
        &[By(Gesture::LeftDrag, NONE, ORBIT), By(Gesture::TrackpadScroll, NONE, ORBIT)],
        Steer::Orbit,
        "orbit: go around what is under the cursor",
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
        "look around; the right button in orbit too",
    ),
    steer(
        &[
            By(Gesture::MiddleDrag, NONE, None),
            By(Gesture::LeftDrag, SHIFT, None),
            By(Gesture::TrackpadScroll, SHIFT, None),
        ],
        Steer::Pan,
        "move sideways: what is under the cursor stays there",
    ),
    steer(
        &[By(Gesture::Wheel, NONE, ORBIT), By(Gesture::Wheel, CTRL, None), By(Gesture::Pinch, NONE, None)],
        Steer::Zoom,
        "towards what is under the cursor, or away from it",
    ),
    steer(
        &[By(Gesture::Wheel, NONE, FLY), By(Gesture::Wheel, NONE, WALK), By(Gesture::RightWheel, NONE, None)],
        Steer::Speed,
        "fly or walk quicker or slower",
    ),
    row(&[key(Key::Plus)], Action::SpeedUp, Group::Moving, "fly quicker"),
    row(&[key(Key::Minus)], Action::SpeedDown, Group::Moving, "fly slower"),
    row(&[key(Key::Home)], Action::FrameAll, Group::Views, "show the whole scene"),
    row(
        &[letter('F'), By(Gesture::DoubleClick, NONE, FLY), By(Gesture::DoubleClick, NONE, ORBIT)],
        Action::FramePicked,
        Group::Views,
        "show what was picked, or what is under the cursor",
    ),
    view(&[function(5)], AxisView::Front, "from the front (along +y)"),
    view(&[with(SHIFT, Key::Function(5))], AxisView::Back, "from behind"),
    view(&[function(6)], AxisView::Right, "from the right (along −x)"),
    view(&[with(SHIFT, Key::Function(6))], AxisView::Left, "from the left"),
    view(&[function(7)], AxisView::Top, "from above, +y upwards"),
    view(&[with(SHIFT, Key::Function(7))], AxisView::Bottom, "from below"),
    row(&[letter('L')], Action::Level, Group::Views, "level the horizon: z is up"),
    steer_view(&[By(Gesture::Wheel, ALT, None)], "field of view"),
    row(&[letter('Z')], Action::FieldOfViewDown, Group::Views, "smaller field of view"),
    row(&[letter('X')], Action::FieldOfViewUp, Group::Views, "larger field of view"),
    row(
        &[letter('G')],
        Action::FocusHere,
        Group::Views,
        "focus on what is under the cursor; a pinhole becomes a thin lens",
    ),
    row(
        &[with(CTRL, Key::Letter('Z')), with(ALT, Key::Left)],
        Action::UndoCamera,
        Group::Views,
        "back to the camera before the last movement (while editing Alt+← alone)",
    ),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('Z')), with(CTRL, Key::Letter('Y')), with(ALT, Key::Right)],
        Action::RedoCamera,
        Group::Views,
        "forward again (while editing Alt+→ alone)",
    ),
    row(&[letter('N')], Action::NextCamera, Group::Views, "the scene's next camera"),
    row(&[with(SHIFT, Key::Letter('N'))], Action::PreviousCamera, Group::Views, "the scene's camera before"),
    row(&[Digits(NONE)], Action::GoToBookmark(1), Group::Views, "go to a bookmark"),
    row(&[Digits(SHIFT)], Action::StoreBookmark(1), Group::Views, "keep the camera as a bookmark, beside the scene"),
    row(&[function(8)], Action::Timeline, Group::Views, "show or hide the timeline: the camera over time"),
    row(&[key(Key::Space)], Action::Play, Group::Views, "play the timeline, or stop"),
    row(&[letter('C')], Action::PrintCamera, Group::Views, "copy the camera as TOML, and print it"),
    row(
        &[key(Key::Delete)],
        Action::HidePicked,
        Group::Views,
        "hide the object that was picked, or is under the cursor",
    ),
    row(
        &[with(CTRL, Key::Delete)],
        Action::IsolatePicked,
        Group::Views,
        "show the object that was picked, or is under the cursor, alone; again, the rest too",
    ),
    row(
        &[with(SHIFT, Key::Letter('B'))],
        Action::ToggleClipBox,
        Group::Views,
        "cut open by a box whose knobs are dragged, or close it",
    ),
    row(&[with(SHIFT, Key::Delete)], Action::ShowAll, Group::Views, "show all objects that were hidden here"),
    row(
        &[function(9)],
        Action::Values,
        Group::Light,
        "of a volume: dragging to the sides is the window of values that is shown, up and down its level, or no more",
    ),
    row(&[key(Key::PageUp)], Action::ExposureUp, Group::Light, "more exposure"),
    row(&[key(Key::PageDown)], Action::ExposureDown, Group::Light, "less exposure"),
    row(&[with(SHIFT, Key::PageUp)], Action::LightUp, Group::Light, "more light from what glows"),
    row(&[with(SHIFT, Key::PageDown)], Action::LightDown, Group::Light, "less light from what glows"),
    row(&[with(CTRL, Key::PageUp)], Action::SkyUp, Group::Light, "brighter sky"),
    row(&[with(CTRL, Key::PageDown)], Action::SkyDown, Group::Light, "darker sky"),
    row(&[letter('P')], Action::Pause, Group::Tracing, "stop tracing, or go on"),
    row(&[letter('T')], Action::NextTraversal, Group::Tracing, "next traversal"),
    row(&[letter('I')], Action::NextIntegrator, Group::Tracing, "next integrator"),
    row(&[letter('B')], Action::Compare, Group::Tracing, "compare with another tracer, or no more"),
    row(
        &[letter('V')],
        Action::NextContrast,
        Group::Tracing,
        "of two tracers: both beside each other, the films or the voxels that differ",
    ),
    row(&[letter('U')], Action::NextOtherTraversal, Group::Tracing, "next traversal of the other tracer"),
    row(&[letter('J')], Action::DividerLeft, Group::Tracing, "the divider to the left; dragging moves it too"),
    row(
        &[letter('K')],
        Action::DividerRight,
        Group::Tracing,
        "the divider to the right; without a comparison: a key of the camera at the playhead of the timeline",
    ),
    row(&[with(CTRL, Key::Letter('B'))], Action::Benchmark, Group::Tracing, "measure this view, or stop measuring"),
    row(&[function(10)], Action::Plan, Group::Tracing, "play a benchmark plan, and write its report"),
    row(&[By(Gesture::Click, NONE, None)], Action::Pick, Group::Tracing, "pick the voxel: what it is, and where"),
    row(&[letter('M')], Action::Measure, Group::Measuring, "measure in the picture by clicks, or pick again"),
    row(
        &[with(SHIFT, Key::Letter('M'))],
        Action::NextTool,
        Group::Measuring,
        "what is measured: distance, height, angle, path, area, volume",
    ),
    row(
        &[key(Key::Enter)],
        Action::FinishMeasuring,
        Group::Measuring,
        "end a path or an area; a double click does, too",
    ),
    row(&[with(CTRL, Key::Letter('N'))], Action::New, Group::Files, "begin an empty scene, to build in it"),
    row(&[with(CTRL, Key::Letter('O'))], Action::Open, Group::Files, "open a scene"),
    row(&[with(CTRL, Key::Letter('L'))], Action::OpenByPath, Group::Files, "open a scene by its path"),
    row(&[with(Modifiers::CTRL_SHIFT, Key::Letter('S'))], Action::SaveScene, Group::Files, "write the scene to a file"),
    row(&[with(CTRL, Key::Letter('S'))], Action::SaveEdits, Group::Files, "save the edits to their file"),
    row(&[with(CTRL, Key::Letter('E'))], Action::ToggleEditing, Group::Files, "edit the voxels, or end it"),
    row(&[function(12)], Action::Screenshot, Group::Files, "write the picture to a file, as it is"),
    row(
        &[with(SHIFT, Key::Function(12))],
        Action::RenderPicture,
        Group::Files,
        "render a picture to a file, of any size and quality",
    ),
    row(
        &[with(CTRL, Key::Function(12))],
        Action::RenderFrames,
        Group::Files,
        "render a turntable, or a flight through the bookmarks",
    ),
    row(&[with(SHIFT, Key::Function(8))], Action::Record, Group::Files, "record the timeline to a clip or to frames"),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('C'))],
        Action::CopyCommand,
        Group::Files,
        "copy the command that renders this view",
    ),
    row(
        &[with(Modifiers::CTRL_SHIFT, Key::Letter('B'))],
        Action::CopyBenchmark,
        Group::Files,
        "copy the command that measures this view",
    ),
    row(&[function(1), letter('H')], Action::Help, Group::Window, "this list"),
    row(&[key(Key::Tab)], Action::TogglePanels, Group::Window, "show or hide the panels"),
    row(&[function(11)], Action::ToggleFullScreen, Group::Window, "full screen"),
    row(&[with(CTRL, Key::Plus)], Action::ScaleUp, Group::Window, "larger text and buttons"),
    row(&[with(CTRL, Key::Minus)], Action::ScaleDown, Group::Window, "smaller text and buttons"),
    row(
        &[key(Key::Escape)],
        Action::Cancel,
        Group::Window,
        "close a dialog or this list, stop what is opened, measured, made, recorded or played, take away errors, leave full screen",
    ),
    row(&[with(CTRL, Key::Letter('Q'))], Action::Quit, Group::Window, "quit (in flight, Ctrl+Q goes down slowly)"),
    told("one finger on the screen", Action::Steer(Steer::Orbit), "as the left button: drag, tap, tap twice"),
    told("two fingers on the screen", Action::Steer(Steer::Pan), "move sideways; parting them leads nearer"),
    told("turning two fingers on the trackpad", Action::Steer(Steer::Orbit), "go around what is under the cursor"),
    told("gamepad left stick", Action::Move(Movement::Forward), "fly"),
    told("gamepad right stick", Action::Steer(Steer::Look), "look around"),
    told("gamepad right trigger", Action::Move(Movement::Up), "up"),
    told("gamepad left trigger", Action::Move(Movement::Down), "down"),
    on_pad(PadButton::South, Action::FramePicked, "show what is in the middle"),
    on_pad(PadButton::East, Action::UndoCamera, "back to the camera before the last movement"),
    on_pad(PadButton::West, Action::ToggleMode, "orbit or fly"),
    on_pad(PadButton::North, Action::FrameAll, "show the whole scene"),
    on_pad(PadButton::RightShoulder, Action::SpeedUp, "fly quicker"),
    on_pad(PadButton::LeftShoulder, Action::SpeedDown, "fly slower"),
    on_pad(PadButton::Right, Action::NextCamera, "the scene's next camera"),
    on_pad(PadButton::Left, Action::PreviousCamera, "the scene's camera before"),
    on_pad(PadButton::Up, Action::ExposureUp, "more exposure"),
    on_pad(PadButton::Down, Action::ExposureDown, "less exposure"),
    on_pad(PadButton::Start, Action::TogglePanels, "show or hide the panels"),
    on_pad(PadButton::Select, Action::Help, "this list"),
];
