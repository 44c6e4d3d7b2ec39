//! Keys and gestures by themselves, whatever window system tells of them.

use crate::tr;
use std::fmt;

/// A key. Letters and digits are those that the key writes without modifiers on the user's layout, where it writes none of these those
/// at its place on a US keyboard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Key {
    /// `A` to `Z`.
    Letter(char),
    /// 0 to 9, also those of the number pad.
    Digit(u8),
    /// F1 to F12.
    Function(u8),
    /// Escape.
    Escape,
    /// Enter, also that of the number pad.
    Enter,
    /// Tabulator.
    Tab,
    /// Delete.
    Delete,
    /// Home.
    Home,
    /// Page up.
    PageUp,
    /// Page down.
    PageDown,
    /// Arrow to the left.
    Left,
    /// Arrow to the right.
    Right,
    /// Arrow up.
    Up,
    /// Arrow down.
    Down,
    /// Plus, with `=` on one key or on the number pad.
    Plus,
    /// Minus.
    Minus,
    /// The space bar.
    Space,
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Letter(letter) => write!(f, "{letter}"),
            Self::Digit(digit) => write!(f, "{digit}"),
            Self::Function(number) => write!(f, "F{number}"),
            Self::Escape => f.write_str("Esc"),
            Self::Enter => f.write_str("Enter"),
            Self::Tab => f.write_str("Tab"),
            Self::Delete => f.write_str("Del"),
            Self::Home => f.write_str("Home"),
            Self::PageUp => f.write_str("Page Up"),
            Self::PageDown => f.write_str("Page Down"),
            Self::Left => f.write_str("←"),
            Self::Right => f.write_str("→"),
            Self::Up => f.write_str("↑"),
            Self::Down => f.write_str("↓"),
            Self::Plus => f.write_str("+"),
            Self::Minus => f.write_str("−"),
            Self::Space => f.write_str("Space"),
        }
    }
}

/// What is held beside a key or a gesture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Modifiers {
    /// Ctrl, and Command on a Mac.
    pub ctrl: bool,
    /// Shift.
    pub shift: bool,
    /// Alt.
    pub alt: bool,
}

impl Modifiers {
    /// None of them.
    pub const NONE: Self = Self { ctrl: false, shift: false, alt: false };
    /// Ctrl alone.
    pub const CTRL: Self = Self { ctrl: true, ..Self::NONE };
    /// Shift alone.
    pub const SHIFT: Self = Self { shift: true, ..Self::NONE };
    /// Alt alone.
    pub const ALT: Self = Self { alt: true, ..Self::NONE };
    /// Ctrl and Shift.
    pub const CTRL_SHIFT: Self = Self { ctrl: true, shift: true, ..Self::NONE };
}

impl fmt::Display for Modifiers {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let names = [(self.ctrl, "Ctrl+"), (self.alt, "Alt+"), (self.shift, "Shift+")];
        names.iter().filter(|(is_held, _)| *is_held).try_for_each(|(_, name)| f.write_str(name))
    }
}

/// A key with what is held beside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Chord {
    /// The key.
    pub key: Key,
    /// What is held beside it.
    pub modifiers: Modifiers,
}

impl fmt::Display for Chord {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}{}", self.modifiers, self.key)
    }
}

/// What mouse and trackpad do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Gesture {
    /// The left button, pressed and let go in one place.
    Click,
    /// Two clicks.
    DoubleClick,
    /// Moving with the left button held.
    LeftDrag,
    /// Moving with the middle button held.
    MiddleDrag,
    /// Moving with the right button held.
    RightDrag,
    /// Turning the wheel.
    Wheel,
    /// Turning the wheel with the right button held.
    RightWheel,
    /// Two fingers that move on the trackpad.
    TrackpadScroll,
    /// Two fingers that part or meet on the trackpad.
    Pinch,
}

impl fmt::Display for Gesture {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::Click => tr!("keys_gesture.click"),
            Self::DoubleClick => tr!("keys_gesture.double_click"),
            Self::LeftDrag => tr!("keys_gesture.left_drag"),
            Self::MiddleDrag => tr!("keys_gesture.middle_drag"),
            Self::RightDrag => tr!("keys_gesture.right_drag"),
            Self::Wheel => tr!("keys_gesture.wheel"),
            Self::RightWheel => tr!("keys_gesture.right_wheel"),
            Self::TrackpadScroll => tr!("keys_gesture.trackpad_scroll"),
            Self::Pinch => tr!("keys_gesture.pinch"),
        })
    }
}
