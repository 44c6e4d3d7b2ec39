//! What the state asks for: things to be done outside of it.

use super::editing::Followed;
use crate::engine::{Backend, Contrast, Light, Pause};
use crate::export::ExportRequest;
use crate::running::RunRequest;
use std::path::PathBuf;

/// Something to be done outside of the state.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Open a scene.
    Load(String),
    /// Show an empty scene of so many voxels along each side.
    New([u32; 3]),
    /// Trace this scene.
    SetScene,
    /// Make the sky that is asked for.
    MakeSky,
    /// Make the ground and the fog that are asked for.
    Surround,
    /// Trace with this.
    SetBackend(Backend),
    /// Trace this view.
    SetView,
    /// Trace the view by other means as well, or by one alone.
    CompareWith(Option<Backend>),
    /// Show this of two tracers.
    SetContrast(Contrast),
    /// Show views in this light.
    SetLight(Light),
    /// Make other voxels of the volume that is open.
    Reshape,
    /// Open the scene once more: with parts that its file hides, or with what is inside, where it is cut open.
    LoadAgain,
    /// Measure the view.
    Benchmark,
    /// Read the values of the volume that the scene was made of.
    ReadValues,
    /// Put a text on the clipboard.
    Copy(String),
    /// Print a line on the terminal.
    Print(String),
    /// Write the picture to a file.
    Save(PathBuf),
    /// Ask for a file to open.
    AskForFile,
    /// Ask for the path of the dialog that is open.
    AskForPath,
    /// Render pictures to files.
    Export(Box<ExportRequest>),
    /// Run a command of the program beside the window.
    Run(Box<RunRequest>),
    /// Write the scene to a file.
    SaveScene(PathBuf),
    /// Trace and draw with another device: its number, or its name.
    SetDevice(String),
    /// Leave out samples, or all tracing, or nothing any more.
    Pause(Pause),
    /// Fill the screen, or no more.
    ToggleFullscreen,
    /// Fill the screen no more.
    LeaveFullscreen,
    /// Larger or smaller text and buttons, by a step.
    Scale(i8),
    /// Begin to edit the scene.
    Edit,
    /// Follow an edit of the scene.
    Follow(Followed),
    /// Close the window.
    Quit,
}

impl Command {
    /// Whether nothing is left of an earlier command once this one is carried out.
    pub(super) fn replaces(&self, earlier: &Self) -> bool {
        let sets = matches!(
            self,
            Self::Load(_)
                | Self::New(_)
                | Self::LoadAgain
                | Self::Reshape
                | Self::CompareWith(_)
                | Self::SetContrast(_)
                | Self::SetLight(_)
                | Self::SetScene
                | Self::Edit
                | Self::MakeSky
                | Self::Surround
                | Self::SetBackend(_)
                | Self::SetView
                | Self::ReadValues
                | Self::Copy(_)
                | Self::Pause(_)
        );
        let is_same = std::mem::discriminant(self) == std::mem::discriminant(earlier);
        is_same && (sets || (self == earlier && !matches!(self, Self::ToggleFullscreen | Self::Scale(_))))
    }
}
