//! What the window asks of the thread that owns the scene while it is edited, and what that tells.

use std::sync::Arc;
use voxtrace::changes::MaterialChange;
use voxtrace::dynamic::{Clip, Edit, Patch};
use voxtrace::grid::VoxelBox;
use voxtrace::{Axis, Material, PackedScene};

/// What is to be done to the scene.
#[derive(Clone, Debug, PartialEq)]
pub enum Job {
    /// Edits of a grid, in their order.
    Edit {
        /// The grid.
        grid: u32,
        /// What is done.
        edits: Vec<Edit>,
        /// What the step is called.
        name: &'static str,
        /// Whether it goes on with the step before: the stroke of a brush.
        joins: bool,
    },
    /// Takes back so many steps.
    Undo(usize),
    /// Does so many steps again.
    Redo(usize),
    /// Copies a box of a grid.
    Copy {
        /// The grid.
        grid: u32,
        /// The box.
        region: VoxelBox,
        /// Whether it is to be moved.
        is_move: bool,
    },
    /// Turns the last copy by a quarter about an axis, or mirrors it along the axis.
    Turn {
        /// The axis.
        axis: Axis,
        /// Whether it is mirrored.
        is_mirror: bool,
    },
    /// Other materials. Where more than colours change, what was edited before cannot be undone any more.
    Materials(Vec<MaterialChange>),
    /// One more material.
    AddMaterial(Material),
}

/// A step of undo.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// What was done.
    pub name: &'static str,
    /// Voxels that there are more, or fewer.
    pub voxels: i64,
    /// Its number, which no other step has.
    pub serial: u64,
}

/// What can be undone and redone.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Steps {
    /// The oldest first.
    pub done: Vec<Step>,
    /// The one that was undone last, last.
    pub undone: Vec<Step>,
    /// Bytes that they take.
    pub bytes: u64,
    /// Whether something was edited that cannot be undone any more.
    pub has_forgotten: bool,
}

impl Steps {
    /// Which state of the scene it is: 0 as it was, else the number of the last step that is not undone.
    pub fn state(&self) -> u64 {
        self.done.last().map_or(0, |step| step.serial)
    }
}

/// What the thread tells.
pub enum Told {
    /// The scene can be edited.
    Ready {
        /// What is edited: the scene that was given, with its instances apart and its materials as they were changed.
        base: Arc<PackedScene>,
        /// Whether it is the very scene that was given.
        is_same: bool,
    },
    /// It cannot.
    Failed(String),
    /// Something was done.
    Done(Box<Done>),
    /// Something was copied.
    Copied {
        /// What.
        clip: Arc<Clip>,
        /// Its voxels.
        count: u64,
        /// From which grid.
        grid: u32,
        /// From where.
        region: VoxelBox,
        /// Whether it is to be moved.
        is_move: bool,
    },
    /// A copy was turned.
    Turned(Arc<Clip>),
}

/// What was done.
#[derive(Default)]
pub struct Done {
    /// With the first edit, and where materials changed: the scene before the patch, whose arrays nobody else holds.
    pub base: Option<Arc<PackedScene>>,
    /// Whether materials have other colours.
    pub is_recolored: bool,
    /// The material that was added.
    pub added: Option<u16>,
    /// Whether that is another scene than the one before, so that it has to be traced anew.
    pub is_other: bool,
    /// What changed.
    pub patch: Option<Arc<Patch>>,
    /// What can be undone now.
    pub steps: Steps,
    /// Why something could not be done.
    pub error: Option<String>,
}
