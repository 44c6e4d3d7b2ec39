//! The parts of a gamepad that the table names, whatever system tells of them.

use crate::tr;
use std::fmt;

/// A button, named by its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PadButton {
    /// The lowest of the four: A, or a cross.
    South,
    /// The right one: B, or a circle.
    East,
    /// The highest: Y, or a triangle.
    North,
    /// The left one: X, or a square.
    West,
    /// Above the left trigger.
    LeftShoulder,
    /// Above the right trigger.
    RightShoulder,
    /// To the right of the middle.
    Start,
    /// To the left of the middle.
    Select,
    /// Of the cross.
    Up,
    /// Of the cross.
    Down,
    /// Of the cross.
    Left,
    /// Of the cross.
    Right,
}

impl fmt::Display for PadButton {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Self::South => "A",
            Self::East => "B",
            Self::North => "Y",
            Self::West => "X",
            Self::LeftShoulder => tr!("keys_pad.left_shoulder"),
            Self::RightShoulder => tr!("keys_pad.right_shoulder"),
            Self::Start => tr!("keys_pad.start"),
            Self::Select => tr!("keys_pad.select"),
            Self::Up => tr!("keys_pad.up"),
            Self::Down => tr!("keys_pad.down"),
            Self::Left => tr!("keys_pad.left"),
            Self::Right => tr!("keys_pad.right"),
        })
    }
}
