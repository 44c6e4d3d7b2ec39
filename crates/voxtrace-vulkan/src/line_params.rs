//! What devices are told of the lines on the faces of voxels.

use crate::records::FrameParams;
use glam::Vec3;
use voxtrace_core::lines::{GridLines, Line, Lines};

impl FrameParams {
    /// The same input with these lines.
    pub(crate) fn with_lines(self, lines: &Lines) -> Self {
        const NONE: Line = Line { width: 0.0, color: Vec3::ZERO };
        let edges = lines.edges.unwrap_or(NONE);
        let grid = lines.grid.unwrap_or(GridLines { line: NONE, spacing: 1 });
        Self {
            edge_color: edges.color,
            edge_width: edges.width,
            grid_color: grid.line.color,
            grid_width: grid.line.width,
            grid_spacing: grid.spacing,
            ..self
        }
    }
}
