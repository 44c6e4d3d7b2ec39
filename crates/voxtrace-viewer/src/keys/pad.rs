//! The parts of a gamepad that the table names, whatever system tells of them.

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
            Self::LeftShoulder => "left shoulder",
            Self::RightShoulder => "right shoulder",
            Self::Start => "start",
            Self::Select => "select",
            Self::Up => "cross up",
            Self::Down => "cross down",
            Self::Left => "cross left",
            Self::Right => "cross right",
        })
    }
}
