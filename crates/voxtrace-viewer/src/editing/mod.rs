//! Editing in the window, as state: the tool, the brush, the palette, the planes of symmetry, what is selected, what can be undone. The
//! thread that owns the scene meanwhile is an [`Editor`]; [`crate::session`] turns the hand's gestures into its jobs.

pub mod brush;
mod editor;
pub mod face_region;
mod job;
pub mod outline;
pub mod recovery;
mod scene;
pub mod symmetry;

pub use brush::{Act, Brush};
pub use editor::{Editor, UNDO_BYTES};
pub use job::{Done, Job, Step, Steps, Told};
pub use symmetry::Symmetry;

use crate::tr;
use face_region::FaceRegion;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use voxtrace::changes::MaterialChange;
use voxtrace::dynamic::{Clip, DynamicScene, Patch};
use voxtrace::glam::{DVec3, IVec3, Vec2};
use voxtrace::grid::VoxelBox;
use voxtrace::ray::Face;
use voxtrace::{PackedScene, Transform};

/// Materials that were used last.
const MOST_RECENT: usize = 10;
/// Most voxels that a fill reaches.
pub const MOST_FILLED: u64 = 1 << 24;

/// What the hand does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Tool {
    /// Paints along the drag.
    #[default]
    Brush,
    /// From where the button is pressed to where it is let go.
    Line,
    /// The box between both.
    Box,
    /// Pulls a face out, or pushes it in.
    Extrude,
    /// All voxels of one material that are connected.
    Fill,
    /// All voxels of one material.
    Replace,
    /// Chooses a box, to be copied or moved.
    Select,
}

impl Tool {
    /// All of them, in the order of the panel.
    pub const ALL: [Self; 7] =
        [Self::Brush, Self::Line, Self::Box, Self::Extrude, Self::Fill, Self::Replace, Self::Select];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Brush => tr!("edit.brush"),
            Self::Line => tr!("edit.line"),
            Self::Box => tr!("edit.box"),
            Self::Extrude => tr!("edit.extrude"),
            Self::Fill => tr!("edit.fill"),
            Self::Replace => tr!("edit.replace"),
            Self::Select => tr!("edit.select"),
        }
    }

    /// What it does, for people.
    pub fn about(self) -> &'static str {
        match self {
            Self::Brush => tr!("edit.brush_about"),
            Self::Line => tr!("edit.line_about"),
            Self::Box => tr!("edit.box_about"),
            Self::Extrude => tr!("edit.extrude_about"),
            Self::Fill => tr!("edit.fill_about"),
            Self::Replace => tr!("edit.replace_about"),
            Self::Select => tr!("edit.select_about"),
        }
    }

    /// Whether it places, erases or paints.
    pub fn has_act(self) -> bool {
        matches!(self, Self::Brush | Self::Line | Self::Box)
    }
}

/// A voxel under the cursor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The instance.
    pub instance: u32,
    /// Its grid.
    pub grid: u32,
    /// Where the grid stands.
    pub world_from_grid: Transform,
    /// The voxel.
    pub voxel: IVec3,
    /// The face through which it is seen.
    pub face: Face,
    /// Its material.
    pub material: u16,
    /// Where the ray met it, in voxels of the grid.
    pub point: DVec3,
}

impl Spot {
    /// Where the lowest corner of a box of voxels comes to lie that stands on the face, its middle over the voxel.
    pub fn paste_corner(&self, size: IVec3) -> IVec3 {
        let (axis, cell) = (self.face.axis(), self.voxel + self.face.normal());
        let mut min = cell - (size - 1) / 2;
        min[axis] = if self.face.normal()[axis] > 0 { cell[axis] } else { cell[axis] - size[axis] + 1 };
        min
    }

    /// Whether another one is on the same thing.
    pub fn is_with(&self, other: &Self) -> bool {
        (self.instance, self.grid) == (other.instance, other.grid)
    }
}

/// A drag under way.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// Of a brush: what it was at last.
    Brush {
        /// What is done.
        act: Act,
        /// Where it began.
        spot: Spot,
        /// The last voxel.
        last: IVec3,
        /// The last place of the cursor.
        cursor: Vec2,
    },
    /// Of a tool that has two ends.
    Span {
        /// The tool: line, box or select.
        tool: Tool,
        /// What is done.
        act: Act,
        /// Where it began.
        spot: Spot,
        /// One end.
        from: IVec3,
        /// The other end.
        to: IVec3,
        /// How many voxels a box is deeper along its first face.
        depth: i32,
    },
    /// Of a face.
    Extrude {
        /// Where it began.
        spot: Spot,
        /// What is drawn out.
        region: Arc<FaceRegion>,
        /// How far.
        distance: i32,
    },
    /// Something was done when the button was pressed.
    Nothing,
}

impl Stroke {
    /// Where it began.
    pub fn spot(&self) -> Option<&Spot> {
        match self {
            Self::Brush { spot, .. } | Self::Span { spot, .. } | Self::Extrude { spot, .. } => Some(spot),
            Self::Nothing => None,
        }
    }

    /// The box of a tool with two ends.
    pub fn region(&self) -> Option<VoxelBox> {
        let Self::Span { spot, from, to, depth, .. } = self else { return None };
        let VoxelBox { min, max } = brush::box_between(*from, *to);
        let along = spot.face.normal() * *depth;
        Some(VoxelBox { min: min.min(min + along), max: max.max(max + along) })
    }
}

/// A box of voxels of a thing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Selection {
    /// The instance that is seen.
    pub instance: u32,
    /// Its grid.
    pub grid: u32,
    /// Where the grid stands.
    pub world_from_grid: Transform,
    /// The box.
    pub region: VoxelBox,
}

/// What was copied, under the cursor until it is put down.
#[derive(Clone, Debug, PartialEq)]
pub struct Pasting {
    /// What.
    pub clip: Arc<Clip>,
    /// The grid and the box that it is taken from, where it is moved.
    pub from: Option<(u32, VoxelBox)>,
}

/// What edits were saved to, and which.
#[derive(Clone, Debug, PartialEq)]
pub struct Saved {
    /// The file.
    pub path: PathBuf,
    /// [`Steps::state`] of what it holds, with how often materials had changed.
    pub state: (u64, u64),
    /// Which objects were seen, and so written.
    pub is_visible: Vec<bool>,
}

/// Editing of the scene that is shown.
pub struct Editing {
    /// Whether the hand edits; else it moves the camera, and what was edited stays.
    pub is_on: bool,
    /// Whether the scene can be edited by now.
    pub is_ready: bool,
    /// Whether the thread that owned the scene failed: what was edited can be saved, and no more.
    pub(crate) has_failed: bool,
    /// The tool.
    pub tool: Tool,
    /// What brush, line and box do.
    pub act: Act,
    /// The brush.
    pub brush: Brush,
    /// The current material.
    pub material: u16,
    /// Materials that were used last, the newest first.
    pub recent: Vec<u16>,
    /// Planes of symmetry.
    pub symmetry: Symmetry,
    /// The grid whose planes they are.
    pub symmetry_of: Option<u32>,
    /// Whether the next click says through which voxel the planes go.
    pub picks_middle: bool,
    /// What is selected.
    pub selection: Option<Selection>,
    /// What was copied last.
    pub clip: Option<Arc<Clip>>,
    /// What is under the cursor to be put down.
    pub pasting: Option<Pasting>,
    /// What can be undone and redone.
    pub steps: Steps,
    /// Where edits were saved.
    pub saved: Option<Saved>,
    /// Whether the scene came with edits that were not saved: from a recovery file.
    pub is_recovered: bool,
    /// Where a tool was used last: what planes of symmetry are drawn for when nothing is under the cursor.
    pub(crate) last_spot: Option<Spot>,
    /// A scene that was begun here, until the thread takes it.
    pub(crate) begun: Option<Box<DynamicScene>>,
    pub(crate) editor: Option<Editor>,
    pub(crate) stroke: Option<Stroke>,
    /// The scene before the stroke, where that is not what is picked in anyway.
    pub(crate) before: Option<Arc<PackedScene>>,
    /// Patches of the stroke that what is picked has not followed yet: a stroke follows the surface that there was.
    pub(crate) pending: Vec<Arc<Patch>>,
    /// How often materials were changed among edits.
    pub(crate) rebased: u64,
    /// Materials that were changed since, and those of them that are on their way to the thread.
    pub(crate) materials: BTreeMap<usize, MaterialChange>,
    pub(crate) materials_sent: BTreeMap<usize, MaterialChange>,
    /// What is being written now.
    pub(crate) saving: Option<Saved>,
    /// When the recovery file was written last, and what it holds.
    pub(crate) recovered: Option<(std::time::Instant, (u64, u64))>,
}

impl Default for Editing {
    fn default() -> Self {
        Self {
            is_on: true,
            is_ready: false,
            has_failed: false,
            tool: Tool::default(),
            act: Act::default(),
            brush: Brush::default(),
            material: 0,
            recent: Vec::new(),
            symmetry: Symmetry::default(),
            symmetry_of: None,
            picks_middle: false,
            selection: None,
            clip: None,
            pasting: None,
            steps: Steps::default(),
            saved: None,
            is_recovered: false,
            last_spot: None,
            begun: None,
            editor: None,
            stroke: None,
            before: None,
            pending: Vec::new(),
            rebased: 0,
            materials: BTreeMap::new(),
            materials_sent: BTreeMap::new(),
            saving: None,
            recovered: None,
        }
    }
}

impl Editing {
    /// Chooses a material.
    pub fn take_material(&mut self, material: u16) {
        self.material = material;
        self.recent.retain(|&recent| recent != material);
        self.recent.insert(0, material);
        self.recent.truncate(MOST_RECENT);
    }

    /// Which edits the scene has: two states are the same where nothing differs.
    pub fn state(&self) -> (u64, u64) {
        (self.steps.state(), self.rebased)
    }

    /// Whether the scene has edits that no file holds.
    pub fn is_unsaved(&self) -> bool {
        match &self.saved {
            Some(saved) => saved.state != self.state(),
            None => self.is_recovered || self.has_edits(),
        }
    }

    /// Whether the scene is another one than the one that was opened.
    pub fn has_edits(&self) -> bool {
        self.state() != (0, 0) || self.steps.has_forgotten
    }

    /// Whether the scene would lose edits if its file were read again, also those that are under way or came from a recovery file.
    pub(crate) fn has_edits_beside_file(&self) -> bool {
        self.has_edits() || self.stroke.is_some() || self.is_recovered || !self.materials_sent.is_empty()
    }

    /// The drag under way.
    pub fn stroke(&self) -> Option<&Stroke> {
        self.stroke.as_ref()
    }
}
