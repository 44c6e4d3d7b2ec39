//! One table of everything that keys and gestures do ([`TABLE`]): the window asks it, and the list of F1 and the table of
//! `docs/viewer.md` are made of it.

mod chord;
mod editing;
mod pad;
mod page;
mod table;
#[cfg(test)]
mod tests;

pub use chord::{Chord, Gesture, Key, Modifiers};
pub use editing::{EDIT_TABLE, EditAction, EditAxis, edit_action_of, edit_action_of_gesture};
pub use pad::PadButton;
pub use page::{Row, markdown, rows};
pub use table::TABLE;

use crate::navigation::{AxisView, Mode, Movement};
use crate::tr;

/// Everything that the window does when asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Action {
    /// Opens the dialog that begins an empty scene.
    New,
    /// Shows the dialog that opens a scene.
    Open,
    /// Opens the dialog that opens a scene by its path.
    OpenByPath,
    /// Writes the picture to a file.
    Screenshot,
    /// Opens the dialog that renders a picture to a file.
    RenderPicture,
    /// Opens the dialog that renders a turntable or a flight.
    RenderFrames,
    /// Shows the timeline or hides it.
    Timeline,
    /// Dragging changes which values of a volume are shown, or moves the camera again.
    Values,
    /// Opens the dialog that plays a benchmark plan.
    Plan,
    /// Plays the timeline or stops.
    Play,
    /// Opens the dialog that records the timeline.
    Record,
    /// Opens the dialog that writes the scene to a file.
    SaveScene,
    /// Begins to edit, or ends it.
    ToggleEditing,
    /// What is done while the hand edits.
    Edit(EditAction),
    /// Saves edits to the file that they were saved to.
    SaveEdits,
    /// Ends the program.
    Quit,
    /// Closes the dialog, stops loading, closes the list of keys, takes away errors, drops what was picked, leaves full screen: the first of these that there is.
    Cancel,
    /// Moves as long as the key is held.
    Move(Movement),
    /// What a gesture does to the camera.
    Steer(Steer),
    /// Exchanges flight and orbit.
    ToggleMode,
    /// Walks on surfaces, or flies again.
    ToggleWalking,
    /// Walks to what is under the cursor.
    WalkHere,
    /// A step quicker.
    SpeedUp,
    /// A step slower.
    SpeedDown,
    /// Shows the whole scene.
    FrameAll,
    /// Shows what was picked, or what is under the cursor.
    FramePicked,
    /// Looks along an axis.
    View(AxisView),
    /// Takes z for up.
    Level,
    /// A smaller field of view.
    FieldOfViewDown,
    /// A larger one.
    FieldOfViewUp,
    /// Focuses on what is under the cursor.
    FocusHere,
    /// The camera before the last gesture.
    UndoCamera,
    /// The camera that was undone.
    RedoCamera,
    /// The scene's next camera.
    NextCamera,
    /// The one before.
    PreviousCamera,
    /// Goes to the bookmark of this number.
    GoToBookmark(u8),
    /// Keeps the camera under this number.
    StoreBookmark(u8),
    /// Copies the camera as TOML, and prints it.
    PrintCamera,
    /// Copies the command that renders this view.
    CopyCommand,
    /// Brighter by a step of exposure.
    ExposureUp,
    /// Darker by one.
    ExposureDown,
    /// More light from everything that glows.
    LightUp,
    /// Less.
    LightDown,
    /// A brighter sky.
    SkyUp,
    /// A darker one.
    SkyDown,
    /// Stops tracing, or goes on.
    Pause,
    /// The next traversal.
    NextTraversal,
    /// The next integrator.
    NextIntegrator,
    /// Compares with another tracer, or no more.
    Compare,
    /// The next of what is shown of two tracers.
    NextContrast,
    /// The next traversal of the tracer that is compared with.
    NextOtherTraversal,
    /// Moves the divider of two pictures to the left.
    DividerLeft,
    /// Moves it to the right.
    DividerRight,
    /// Measures the view, or stops measuring.
    Benchmark,
    /// Copies the command that measures the view.
    CopyBenchmark,
    /// Hides the object that was picked, or that is under the cursor.
    HidePicked,
    /// Shows the object that was picked alone, or what was seen before.
    IsolatePicked,
    /// Cuts the scene open by a box with handles, or closes it.
    ToggleClipBox,
    /// Shows all objects that were hidden.
    ShowAll,
    /// Picks the voxel under the cursor.
    Pick,
    /// Measures in the picture, or picks again.
    Measure,
    /// Measures something else.
    NextTool,
    /// Ends a path or an area.
    FinishMeasuring,
    /// Shows the panels or hides them.
    TogglePanels,
    /// Shows times, rays and memory over the picture, or hides them.
    ToggleTimes,
    /// Shows views that move in real-time light, or no more.
    ToggleRealTime,
    /// Shows the film of a view that stands at once, or when it is clean.
    ToggleBareFilm,
    /// Fills the screen, or not any more.
    ToggleFullScreen,
    /// Larger text and buttons.
    ScaleUp,
    /// Smaller ones.
    ScaleDown,
    /// Shows the list of keys.
    Help,
}

/// What a gesture does to the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Steer {
    /// Turns the view.
    Look,
    /// Goes around what is under the cursor.
    Orbit,
    /// Moves sideways.
    Pan,
    /// Moves to what is under the cursor, or away.
    Zoom,
    /// Changes the speed.
    Speed,
    /// Changes the field of view.
    FieldOfView,
}

/// What starts an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trigger {
    /// A key.
    Key(Chord),
    /// Each of the keys 1 to 9; the number in the action stands for all.
    Digits(Modifiers),
    /// A gesture, in one mode or in both.
    Gesture(Gesture, Modifiers, Option<Mode>),
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub struct Binding {
    /// What starts it, each by itself.
    pub triggers: &'static [Trigger],
    /// A stick of a gamepad or fingers on the screen, which act by themselves; the table tells people of them by the key of a text. Else empty.
    pub told: &'static str,
    /// The button of a gamepad that does it, too.
    pub pad: Option<PadButton>,
    /// What it does.
    pub action: Action,
    /// Where it stands in lists.
    pub group: Group,
    /// What it does, for people: the key of a text.
    pub about: &'static str,
}

/// Parts of the lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Moving the camera.
    Moving,
    /// Views that are taken at once.
    Views,
    /// Light and colours.
    Light,
    /// Tracing.
    Tracing,
    /// Measuring.
    Measuring,
    /// Files and what is copied.
    Files,
    /// What holds while the hand edits.
    Editing,
    /// The window itself.
    Window,
    /// Fingers and gamepads.
    Others,
}

impl Group {
    /// All of them, in the order of lists.
    pub const ALL: [Self; 9] = [
        Self::Moving,
        Self::Views,
        Self::Light,
        Self::Tracing,
        Self::Measuring,
        Self::Files,
        Self::Editing,
        Self::Window,
        Self::Others,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Moving => tr!("keys_group.moving"),
            Self::Views => tr!("keys_group.views"),
            Self::Light => tr!("keys_group.light"),
            Self::Tracing => tr!("keys_group.tracing"),
            Self::Measuring => tr!("keys_group.measuring"),
            Self::Files => tr!("keys_group.files"),
            Self::Editing => tr!("keys_group.editing"),
            Self::Window => tr!("keys_group.window"),
            Self::Others => tr!("keys_group.others"),
        }
    }
}

/// What a key does. In flight, that is while a key of movement is held or dragging turns the view, Shift and Ctrl mean the speed alone:
/// Ctrl+Q goes down slowly and does not quit.
pub fn action_of(chord: Chord, is_flying: bool) -> Option<Action> {
    // On many keyboards plus is written with Shift.
    let shift = chord.modifiers.shift && chord.key != Key::Plus;
    let chord = Chord { modifiers: Modifiers { shift, ..chord.modifiers }, ..chord };
    let Modifiers { alt, .. } = chord.modifiers;
    let plain = Chord { modifiers: Modifiers { alt, ..Modifiers::NONE }, ..chord };
    if is_flying {
        return bound(plain);
    }
    // Flight begins with Shift or Ctrl held too.
    bound(chord).or_else(|| bound(plain).filter(|action| matches!(action, Action::Move(_))))
}

/// What a gesture does in a mode.
pub fn action_of_gesture(gesture: Gesture, modifiers: Modifiers, mode: Mode) -> Option<Action> {
    let fits = |trigger: &Trigger| match *trigger {
        Trigger::Gesture(own, with, of_mode) => {
            own == gesture && with == modifiers && of_mode.is_none_or(|own| own == mode)
        }
        _ => false,
    };
    TABLE.iter().find(|binding| binding.triggers.iter().any(fits)).map(|binding| binding.action)
}

/// What a button of a gamepad does.
pub fn action_of_pad(button: PadButton) -> Option<Action> {
    TABLE.iter().find(|binding| binding.pad == Some(button)).map(|binding| binding.action)
}

/// The key of an action, for people.
pub fn key_of(action: Action) -> String {
    let binding = TABLE.iter().chain(EDIT_TABLE).find(|binding| binding.action == action);
    let key = binding.into_iter().flat_map(|binding| binding.triggers).find_map(|trigger| match trigger {
        Trigger::Key(chord) => Some(chord.to_string()),
        _ => None,
    });
    key.unwrap_or_default()
}

fn bound(chord: Chord) -> Option<Action> {
    let fits = |trigger: &Trigger| match *trigger {
        Trigger::Key(own) => own == chord,
        Trigger::Digits(modifiers) => modifiers == chord.modifiers && matches!(chord.key, Key::Digit(1..=9)),
        _ => false,
    };
    let binding = TABLE.iter().find(|binding| binding.triggers.iter().any(fits))?;
    Some(match (binding.action, chord.key) {
        (Action::GoToBookmark(_), Key::Digit(number)) => Action::GoToBookmark(number),
        (Action::StoreBookmark(_), Key::Digit(number)) => Action::StoreBookmark(number),
        (action, _) => action,
    })
}
