//! Which lines a .vox file shows on the faces of its voxels, from its rOBJ chunks: `_edge` and `_grid` say how they look, and `_setting`, in older files
//! they themselves, whether they are there. The format text names the keys alone. What voxtrace takes them to be, approximately: `_width` is in
//! voxels, `_color` sRGB, `_spacing` a number of voxels; edges are those of shapes, as only the grid has a spacing.

use super::ignored::Settings;
use voxtrace_core::lines::{GridLines, LARGEST_SPACING, Line, Lines};
use voxtrace_scene::scene::Scene;

/// Widths where a file does not say them.
const EDGE_WIDTH: f64 = 0.2;
const GRID_WIDTH: f64 = 0.05;

/// The lines that the .vox file that a scene came from shows; none for other scenes.
pub fn lines(scene: &Scene) -> Lines {
    Settings::with(scene, |settings| {
        let line = |kind: &str, usual: f64, most: u32| {
            let width = settings.value(kind, "_width").map_or(usual, |_| settings.number(kind, "_width"));
            let width = width.min(most.into()) as f32;
            (width > 0.0).then(|| Line { width, color: settings.color(kind, "_color").unwrap_or_default() })
        };
        let spacing = settings.number("_grid", "_spacing").round().clamp(1.0, LARGEST_SPACING.into()) as u32;
        let grid = line("_grid", GRID_WIDTH, spacing).map(|line| GridLines { line, spacing });
        Lines {
            edges: line("_edge", EDGE_WIDTH, 1).filter(|_| settings.has_edges()),
            grid: grid.filter(|_| settings.has_grid()),
        }
    })
    .unwrap_or_default()
}
