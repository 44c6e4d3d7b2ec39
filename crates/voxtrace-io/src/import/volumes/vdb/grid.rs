//! What stands in front of a grid's tree: how it is compressed, facts about it, and its place in the world.

use super::cursor::Cursor;
use super::header::for_each_fact;
use super::place;
use super::values::Number;
use glam::DAffine3;
use voxtrace_voxelize::{ImportError, Limits};

/// What a grid is meant to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Class {
    /// Distances from a surface, less than 0 inside.
    LevelSet,
    /// Densities.
    Fog,
    Other,
}

/// How the numbers of a node are compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Packing {
    pub zip: bool,
    /// Only active numbers are there.
    pub active: bool,
    pub blosc: bool,
}

/// A grid of numbers.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    pub name: String,
    pub number: Number,
    pub class: Class,
    pub packing: Packing,
    pub world_from_index: DAffine3,
    /// Where the tree begins, and where the numbers of its leaves do.
    pub start: usize,
    pub blocks: i64,
}

impl Grid {
    /// Reads the head of a grid; `None` if its place in the world is no affine one.
    pub fn read(
        cursor: &mut Cursor,
        name: String,
        number: Number,
        blocks: i64,
        limits: &Limits,
    ) -> Result<Option<Self>, ImportError> {
        let offset = cursor.at;
        let flags = cursor.u32("the head of a grid")?;
        if flags > 7 {
            return Err(ImportError::malformed(cursor.path, offset as u64, format!("a compression {flags}")));
        }
        let packing = Packing { zip: flags & 1 != 0, active: flags & 2 != 0, blosc: flags & 4 != 0 };
        let mut class = Class::Other;
        for_each_fact(cursor, limits, |name, _, value| {
            if name == "class" {
                class = match value {
                    b"level set" => Class::LevelSet,
                    b"fog volume" => Class::Fog,
                    _ => Class::Other,
                };
            }
        })?;
        let Ok(world_from_index) = place::read(cursor)? else { return Ok(None) };
        Ok(Some(Self { name, number, class, packing, world_from_index, start: cursor.at, blocks }))
    }
}
