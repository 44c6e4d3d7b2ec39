//! The panel of lines on the faces of voxels. All of it is an option of `voxtrace render`, too.

use super::surroundings::pick_color;
use super::{section, slider};
use crate::session::Session;
use crate::tr;
use egui::Ui;
use voxtrace::Integrator;
use voxtrace::glam::Vec3;
use voxtrace::lines::{GridLines, Line};

/// What lines begin with, as those of `render`.
const EDGES: Line = Line { width: 0.2, color: Vec3::ZERO };
const GRID: GridLines = GridLines { line: Line { width: 0.05, color: Vec3::ZERO }, spacing: 1 };
/// The narrowest line, and the widest grid, of the sliders.
const NARROWEST: f32 = 0.01;
const MOST_SPACING: u32 = 64;

pub fn lines(ui: &mut Ui, session: &mut Session) {
    let mut settings = session.render_settings.clone();
    if session.open.is_none() || settings.integrator == Integrator::Essay {
        return;
    }
    let title = match (settings.lines.edges.is_some(), settings.lines.grid.is_some()) {
        (false, false) => tr!("lines.title"),
        (true, false) => tr!("lines.title_edges"),
        (false, true) => tr!("lines.title_grid"),
        (true, true) => tr!("lines.title_both"),
    };
    section(ui, title, "lines", |ui| {
        let edges = &mut settings.lines.edges;
        let mut has_edges = edges.is_some();
        if ui.checkbox(&mut has_edges, tr!("lines.along_the_edges_of_shapes")).changed() {
            *edges = has_edges.then_some(EDGES);
        }
        if let Some(Line { width, color }) = edges {
            ui.add(slider(width, NARROWEST..=1.0, tr!("lines.width_of_edges")).max_decimals(2));
            pick_color(ui, color, tr!("lines.edge_colour"));
        }
        let grid = &mut settings.lines.grid;
        let mut has_grid = grid.is_some();
        if ui.checkbox(&mut has_grid, tr!("lines.between_voxels")).changed() {
            *grid = has_grid.then_some(GRID);
        }
        if let Some(GridLines { line: Line { width, color }, spacing }) = grid {
            ui.add(slider(width, NARROWEST..=1.0, tr!("lines.width_of_the_grid")).max_decimals(2));
            pick_color(ui, color, tr!("lines.grid_colour"));
            ui.add(slider(spacing, 1..=MOST_SPACING, tr!("lines.voxels_apart")).logarithmic(true));
        }
    });
    session.set_render_settings(settings);
}
